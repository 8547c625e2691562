"""Which trims are meant by what a text asks for and no panel can be cut for: pockets, buttons, a belt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from swifttailor.pattern.trims.names import LIKE_EACH_OTHER, TRIMS

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_POCKETS = tuple(name for name in TRIMS if "pocket" in name)
_BUTTONS = tuple(name for name in LIKE_EACH_OTHER[0] if "zip" not in name)
_ZIPS = ("zip", "half zip", "back zip", "side zip", "fly")
_BELTS = ("tie belt", "buckle belt")
TRIMS_OF: Mapping[str, tuple[str, ...]] = {
    "pockets": _POCKETS,
    "buttons": (*_BUTTONS, "fly"),
    "zip": _ZIPS,
    "belt": _BELTS,
    "belt_accessory": _BELTS,
    "drawstring": ("drawstring",),
    "turn_ups": ("turn-ups",),
    "padding": ("quilting",),
    "ties": ("tie belt",),
}
"""By key of what cannot be made of panels, which trims can stand for it."""
_JACKETS = frozenset(
    {
        "blazer",
        "coat",
        "hooded-coat",
        "waistcoat",
        "cardigan",
        "bomber-jacket",
        "denim-jacket",
        "turtleneck",
        "robe",
    }
)
"""Drafts that are buttoned without a band."""
_WRAPS = frozenset({"wrap-dress", "wrap-top", "robe"})
_LOWER = ("trousers", "shorts")
_DENIM = "denim"


@dataclass(frozen=True)
class TrimWish:
    """A trim, or several that go together, and what they stand for."""

    what: str
    """A key of `cannot_texts`."""
    said: bool
    """Whether the text asks for it; otherwise the name of a garment means it."""
    choices: tuple[tuple[str, ...], ...]
    """Names of `TRIMS`; the first of which all find a place is taken."""


def trims_wanted(heard: Heard, draft: str = "") -> tuple[TrimWish, ...]:
    """What may be put on a garment, in the order of the text.

    Args:
        heard: What the text asks for.
        draft: Name of the draft that the garment is cut from; empty where it is cut from none.
    """
    named = _named(heard)
    found = []
    for lack in heard.lacks:
        can = TRIMS_OF.get(lack.what, ())
        own = tuple([name for name in _of_garment(heard) if name in can])
        said = tuple([name for name in named if name in can])
        choices = _usual(lack.what, heard, draft)
        if said or own:
            choices = (said or own, *[(name,) for name in said or own], *choices)
        if choices:
            found.append(TrimWish(lack.what, lack.said, choices))
    return tuple(found)


def refused_trims(heard: Heard) -> frozenset[str]:
    """Trims that a text does not want: "without pockets"."""
    if heard.words is None:
        return frozenset()
    denied = [entry for mark in heard.words.marks if mark.denied for entry in mark.entries]
    keys = {what for entry in denied for what in entry.cannot}
    named = {name for entry in denied for name in entry.trims}
    return frozenset(named or {name for key in keys for name in TRIMS_OF.get(key, ())})


def _named(heard: Heard) -> tuple[str, ...]:
    """Trims that words about details name: cargo pockets, double-breasted."""
    marks = () if heard.words is None else heard.words.marks
    entries = [entry for mark in marks if not mark.denied for entry in mark.entries]
    return tuple(dict.fromkeys([name for e in entries if e.category == "styles" for name in e.trims]))


def _of_garment(heard: Heard) -> tuple[str, ...]:
    """Trims that names of garments mean: those of cargo trousers."""
    marks = () if heard.words is None else heard.words.marks
    entries = [entry for mark in marks if not mark.denied for entry in mark.entries]
    return tuple(dict.fromkeys([name for e in entries if e.category != "styles" for name in e.trims]))


def _usual(what: str, heard: Heard, draft: str) -> tuple[tuple[str, ...], ...]:
    """What it is on garments of the kind, best first."""
    kind = heard.kind or ""
    if what == "pockets":
        return _usual_pockets(kind, heard.cloth, draft)
    if what == "buttons":
        if kind in _LOWER:
            return (("fly",),)
        return (("buttons",) if draft in _JACKETS else ("button placket",), ("buttons",))
    if what == "zip":
        if kind in _LOWER:
            return (("fly",), ("side zip",))
        in_front = not kind or kind == "top" or draft in _JACKETS
        return (("zip",), ("side zip",)) if in_front else (("side zip",), ("back zip",))
    if what in ("belt", "belt_accessory"):
        return (("buckle belt",),) if kind in _LOWER else (("tie belt",), ("buckle belt",))
    if what == "ties":
        return (("tie belt",),) if draft in _WRAPS else ()
    if what == "padding":
        return ()
    return tuple([(name,) for name in TRIMS_OF.get(what, ())])


def _usual_pockets(kind: str, cloth: str | None, draft: str) -> tuple[tuple[str, ...], ...]:
    if draft == "dungarees":
        return (("bib pocket", "slant pockets"), ("slant pockets",))
    if draft == "hoodie":
        return (("kangaroo pocket",), ("patch pockets",))
    if draft in ("shirt", "polo-shirt", "t-shirt"):
        return (("chest pocket",),)
    if draft == "denim-jacket":
        return (("chest pockets",),)
    if kind in _LOWER:
        return (("slant pockets", "back pockets"), ("slant pockets",))
    if kind in ("jumpsuit", "playsuit"):
        return (("slant pockets",), ("chest pockets",))
    if kind in ("skirt", "dress"):
        return (("patch pockets",),) if cloth == _DENIM else (("slant pockets",), ("side pockets",))
    return (("patch pockets",), ("chest pockets",), ("chest pocket",))
