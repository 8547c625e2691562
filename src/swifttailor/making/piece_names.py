"""Names of pieces in plain words, from what their panels are."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from swifttailor.describing.measuring.parts import Part, PlacedPart

_NUMBER = re.compile(r"(\d+)(?!.*\d)")
_WORDS = {
    Part.TORSO: "Bodice",
    Part.SLEEVE: "Sleeve",
    Part.CUFF: "Cuff",
    Part.HOOD: "Hood",
    Part.COLLAR: "Collar",
    Part.WAISTBAND: "Waistband",
    Part.SKIRT: "Skirt",
    Part.GODET: "Godet",
    Part.TROUSER: "Trousers",
    Part.LEG_CUFF: "Leg cuff",
}
_NO_FACE = frozenset({Part.HOOD, Part.GODET})


def piece_names(groups: Sequence[Sequence[PlacedPart]]) -> list[str]:
    """A name for each piece, no two alike.

    Args:
        groups: The panels that are cut from each piece.
    """
    names = [_name(group) for group in groups]
    counts = Counter(names)
    taken: Counter[str] = Counter()
    unique = []
    for name in names:
        taken[name] += 1
        unique.append(f"{name} {taken[name]}" if counts[name] > 1 else name)
    return unique


def _name(group: Sequence[PlacedPart]) -> str:
    first = group[0]
    sides, faces = {p.side for p in group}, {p.face for p in group}
    name = _WORDS[first.part]
    if re.search(r"cuff_skirt", first.panel.name):
        name += " flounce"
    number = _NUMBER.search(first.panel.name)
    tiered = first.part is Part.SKIRT and number and re.search(r"_(front|back)_\d+$", first.panel.name)
    if tiered:
        name += f" tier {int(number[1]) + 2}"
    if len(faces) == 1 and first.part not in _NO_FACE and "skirt_panel" not in first.panel.name:
        name += f" {first.face}"
    elif "skirt_panel" in first.panel.name:
        name += " panel"
    if len(sides) == 1 and first.side != "middle" and first.part not in (Part.GODET, Part.SKIRT):
        name += f", {first.side}"
    return name
