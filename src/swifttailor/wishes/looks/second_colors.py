"""Where the second of two colours goes that a text names side by side and says of no part.

On what the garment has in another colour anyway: an apron, braid, stripes, the collar of a sailor.
Else on blocks: the skirt of a dress, the sleeves and collar of a top; of trousers on stripes down the sides.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from swifttailor.garment.part_looks import BLOCKS
from swifttailor.wishes.looks.heard_looks import HeardLooks, with_look
from swifttailor.wording.lexicon import NamedColor
from swifttailor.wording.lexicon.look_words import PUT_ON

_PUT_ON_ALIKE = ("apron", "side_panels", "side_stripes", "edging", "frills")
"""What is put on and has a colour of its own, what is seen most first."""
_LEGS = ("trousers", "shorts")
_METALS = re.compile(r"(?:gold|golden|silver|bronze|copper)(?!\w)", re.IGNORECASE)
"""Colours that edges have rather than whole parts: "a red and gold dress"."""
_STRIPES, EDGING = "side_stripes", "edging"
_EDGED = ("dress", "top", "tunic")
_OTHERS_IN = ("bodice", "skirt", "lower_half", "left_half", "right_half", BLOCKS)
"""Parts that a text may give another colour to, so that it has told where colours go."""


def with_second_color(
    looks: HeardLooks, colors: Sequence[NamedColor], kind: str | None, lacking: Sequence[str]
) -> HeardLooks:
    """The looks, and the second colour where it is seen.

    Args:
        looks: That the text and names of garments tell.
        colors: Two, of one garment.
        kind: Of it.
        lacking: Keys of what cannot be cut of panels, for which trims may be put on.
    """
    first, second = (f"#{color.rgb}" for color in colors[:2])
    if looks.said.intersection(_OTHERS_IN) or any(look.color == second for look in looks.looks):
        return looks
    over = [part for part in _PUT_ON_ALIKE if part in {PUT_ON.get(what) for what in lacking}]
    own = [look.part for look in looks.looks if look.color not in (None, first)]
    own = [part for part in own if part not in looks.said]
    usual = EDGING if _METALS.search(colors[1].words) and kind in _EDGED else BLOCKS
    part = next(iter([*over, *own]), _STRIPES if kind in _LEGS else usual)
    if part in looks.said:
        return looks
    kept = [replace(look, color=None) if look.part == part else look for look in looks.looks]
    line = f"{part.replace('_', ' ')} in {colors[1].words.lower()}"
    assumed = [one for one in looks.assumed if not one.startswith(f"{part.replace('_', ' ')} in ")]
    return replace(
        looks,
        looks=tuple(with_look(kept, part, second)),
        assumed=(*assumed, line),
        names=(*looks.names, (second, colors[1].words.lower())),
        second=part,
    )


def second_where_it_fits(looks: HeardLooks, has_part: Callable[[str], bool]) -> HeardLooks:
    """The looks, with the second colour on another part where the garment has not that which it was put on.

    Args:
        looks: Of a text.
        has_part: Whether the garment has a part.
    """
    part = looks.second
    if not part or has_part(part):
        return looks
    said = next((look for look in looks.looks if look.part == part), None)
    other = next((one for one in (*_PUT_ON_ALIKE, BLOCKS) if one not in looks.said and has_part(one)), None)
    if said is None or said.color is None or other is None:
        return looks
    before, after = (f"{one.replace('_', ' ')} in " for one in (part, other))
    return replace(
        looks,
        looks=tuple(with_look([look for look in looks.looks if look is not said], other, said.color)),
        assumed=tuple([line.replace(before, after) for line in looks.assumed]),
        second=other,
    )
