"""The sewing steps of strips that run along edges: frills, ribs, fringe, ribbons."""

from __future__ import annotations

import math
from collections.abc import Mapping

from swifttailor.pattern.trims import Frill

_FULLNESS = 1.8
"""How many times as long as its edge a strip is that is gathered."""
_RIB_SHARE = 0.85
"""Length of a ribbed band over that of its edge."""
_STRIPS = {
    "edging": "ribbon or braid",
    "piping": "piping cord in bias binding",
    "bands": "strips of the other cloth",
    "fur trim": "fur",
    "neck fur": "fur",
    "sleeve fur": "fur",
    "narrow bands": "ribbing of the other colour",
    "hem border": "ribbon or strips of the other cloth",
}
"""What is sewn along edges."""
_TITLES: Mapping[str, str] = {
    "neck rib": "Ribbed band at the neck",
    "armhole ribs": "Ribbed bands at the armholes",
    "hem rib": "Ribbed band at the hem",
    "knit bands": "Ribbed band",
    "hem border": "Border along the hem",
    "folded band": "Band that is folded over",
    "neck frill": "Frill around the neck",
    "sleeve frills": "Frills at the sleeves",
    "sleeve turn-ups": "Turned-up ends of the sleeves",
    "hem frill": "Frill along the hem",
    "hem fringe": "Fringe",
    "frayed hem": "Frayed hems",
    "edging": "Edging",
    "piping": "Piping",
    "bands": "Bands along the edges",
    "narrow bands": "Bands around neck and sleeves",
    "lace trim": "Lace",
    "fur trim": "Fur along the edges",
    "neck fur": "Fur at the neck or hood",
    "sleeve fur": "Fur at the ends of the sleeves",
    "side stripes": "Stripes down the sides",
    "satin stripes": "Satin stripes",
    "sleeve stripes": "Stripes down the sleeves",
}


def frill_step(frill: Frill) -> tuple[str, str]:
    """Title and text: what to cut for a strip, and how it is sewn on."""
    return _TITLES[frill.trim], _text(frill)


def _text(frill: Frill) -> str:
    length = frill.length
    if frill.trim == "frayed hem":
        return (
            f"Leave {length:.0f} cm of edges without a hem, sew a line {frill.depth:.1f} cm from each, and "
            "draw out the threads below it."
        )
    if frill.kind == "gathered":
        strip = 10 * math.ceil(_FULLNESS * length / 10)
        return (
            f"Cut strips {frill.depth + 2:.0f} cm wide, {strip} cm in all. Hem one long edge, gather the "
            f"other to {length:.0f} cm, and sew it to the edge, right sides together."
        )
    if frill.trim in ("neck rib", "armhole ribs", "hem rib"):
        return (
            f"Cut strips of ribbed knit {2 * frill.depth + 2:.0f} cm wide, {_RIB_SHARE * length:.0f} cm "
            f"in all. Close them to rings, fold them lengthwise, stretch them to {length:.0f} cm, and sew "
            "them to the edge."
        )
    if frill.trim == "knit bands":
        return (
            f"Cut a strip of ribbed knit {2 * frill.depth + 2:.0f} cm wide and {_RIB_SHARE * length:.0f} cm "
            f"long, fold it lengthwise, stretch it to {length:.0f} cm, and sew it over the edge."
        )
    if frill.trim == "folded band":
        return (
            f"Cut the waistband {2 * frill.depth:.0f} cm higher, close it to a ring, and fold its upper "
            f"{frill.depth:.0f} cm down to the outside when it is worn."
        )
    if frill.trim == "sleeve turn-ups":
        return (
            f"Cut the sleeves {2 * frill.depth:.0f} cm longer. Fold {frill.depth:.0f} cm of each end up "
            "twice to the outside, press, and catch the fold at the seam."
        )
    if frill.trim in ("side stripes", "satin stripes", "sleeve stripes"):
        return (
            f"Sew ribbon {2 * frill.depth:.1f} cm wide over the seams, {length:.0f} cm in all, along both of "
            "its edges, before what lies across its ends is sewn."
        )
    what = "fringe" if frill.kind == "threads" else _STRIPS.get(frill.trim, "lace")
    return f"Sew {length:.0f} cm of {what}, {frill.depth:.1f} cm wide, along the finished edges."
