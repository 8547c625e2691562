"""The print that a garment has in a photograph: whether it gets that, and what is told of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.garment.cloth_print import SETT, ClothPrint
from swifttailor.picture_reader.seen_print import DOWN

if TYPE_CHECKING:
    from swifttailor.picture_reader.seen_print import SeenPrint
    from swifttailor.tailor.looking import SeenPicture
    from swifttailor.wishes.heard import Heard

_FEW, _MANY, _STRIPES_OF_ALL = "shapes", "blotches", "rainbow"
"""Motifs: of figures, of which nobody knows which, with ground between them or all over; and of stripes in
more than two colours."""
_GROUND = 0.55
"""Share of the cloth from which its main colour is the ground of figures."""
_BANDS = 6
"""In a repeat of that."""
_REPEATS = {"across": 5.0, "down": 2.4, "checks": 4.0, "dots": 3.0, "figures": 15.0}
"""What is usual, cm, where it is not seen after how much a print comes again."""
_LEAST, _MOST = {"stripes": 0.6, "checks": 0.8, "dots": 0.8}, {"across": 25.0, "down": 12.0, "checks": 12.0}
"""What is less or more is no repeat of a print, but of threads or of folds; cm."""
_MOST_OF_DOTS = 12.0
_NARROWEST = 0.2
_DOT = (0.12, 0.45)
"""Radius of dots, in their distance."""
_WAYS = {0.0: "stripes around the body", DOWN: "stripes down the body"}


def print_seen(picture: SeenPicture, part: str) -> SeenPrint | None:
    """The print that a garment has in a picture; None of plain cloth, and where that is not sure.

    Args:
        picture: That was read.
        part: Where the garment is worn.
    """
    return next((one.print for one in picture.reading.parts if one.part == part), None)


def print_taken(picture: SeenPicture, part: str, heard: Heard) -> SeenPrint | None:
    """The same, where words say neither a colour nor a print, nor ask for plain cloth."""
    seen = None if heard.says_color or heard.plain else print_seen(picture, part)
    return None if seen is None or any(map(heard.refuses_color, seen.colors)) else seen


def cloth_of(seen: SeenPrint) -> ClothPrint:
    """The print as one that is asked for in words."""
    colors, repeat = seen.colors, _repeat(seen)
    first, second = seen.shares[:2]
    if seen.kind == "stripes" and len(colors) > 2:
        sizes = {"repeat": round(_BANDS * repeat / len(colors), 1), "angle": seen.angle}
        return ClothPrint("motif", colors, sizes, _STRIPES_OF_ALL)
    if seen.kind == "stripes":
        width = np.clip(repeat * first / (first + second), _NARROWEST, repeat - _NARROWEST)
        sizes = {"width": round(float(width), 1), "gap": round(float(repeat - width), 1), "angle": seen.angle}
        return ClothPrint("stripes", colors, sizes)
    if seen.kind == "checks" and len(colors) > 2:
        return ClothPrint("plaid", colors[:3], {"spacing": round(repeat / SETT, 1)})
    if seen.kind == "checks":
        return ClothPrint("checks", colors, {"width": round(repeat / 2, 1)})
    if seen.kind == "dots":
        radius = repeat * np.clip(np.sqrt(second / np.pi), *_DOT)
        return ClothPrint(
            "dots", colors[:2], {"spacing": round(repeat, 1), "radius": round(float(radius), 2)}
        )
    return ClothPrint("motif", colors, {"repeat": _REPEATS["figures"]}, _FEW if first >= _GROUND else _MANY)


def _way(seen: SeenPrint) -> str:
    return ("down" if seen.angle == DOWN else "across") if seen.kind == "stripes" else seen.kind


def _repeat(seen: SeenPrint) -> float:
    """After how many cm it comes again; what is usual where that is not seen."""
    way, told = _way(seen), seen.repeat
    known = told is not None and _LEAST.get(seen.kind, 0.0) <= told <= _MOST.get(way, _MOST_OF_DOTS)
    return told if known and told is not None else _REPEATS[way]


def print_line(seen: SeenPrint) -> str:
    """For a person: "navy and white stripes around the body, again after 5.0 cm"."""
    from swifttailor.wording.lexicon.color_names import color_name

    names = list(dict.fromkeys(map(color_name, seen.colors)))
    if len(names) == 1:
        names = [f"two shades of {names[0]}"]
    what = _WAYS.get(seen.angle, "stripes") if seen.kind == "stripes" else seen.kind
    if seen.kind in ("dots", "figures"):
        others = " and ".join(names[1:]) or names[0]
        told = f"{others} {what} on {names[0]}" if len(names) > 1 else f"{what} in {names[0]}"
    else:
        told = f"{' and '.join(names)} {what}"
    again = "" if seen.kind == "figures" else f", again after {_repeat(seen):.1f} cm"
    return f"{told}{again} ({seen.certainty:.0%})"


def print_report(seen: SeenPrint) -> dict[str, Any]:
    """For a report: JSON values."""
    return {
        "words": print_line(seen),
        "certainty": round(seen.certainty, 3),
        "shares": [round(share, 2) for share in seen.shares],
        "repeat_cm": None if seen.repeat is None else round(seen.repeat, 1),
        **cloth_of(seen).to_json(),
    }
