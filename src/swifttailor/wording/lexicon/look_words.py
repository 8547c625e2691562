"""What single words are where looks are told: colours, cloths, what is put on, names of parts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.wording.lexicon.colors import NamedColor, named_colors
from swifttailor.wording.lexicon.vocabulary import vocabulary

if TYPE_CHECKING:
    from collections.abc import Sequence

    from swifttailor.wording.lexicon.entries import Entry
    from swifttailor.wording.lexicon.reading import WordMark

_KNITS = frozenset({"jersey", "rib-knit", "sweatshirt", "ponte", "fleece"})
"""Cloths that collars, cuffs and bands usually are of."""
SIDE_PANELS = "side_panels"
STRIPES, MOTIF = "side_stripes", "motif"
"""Named by the parts that they run down, whose colour is not meant: "white stripes down the sleeves"."""
PUT_ON = {
    "buttons": "buttons",
    "zip": "zip",
    "belt": "belt",
    "belt_accessory": "belt",
    "pockets": "pockets",
    "drawstring": "drawstring",
    "frills": "frills",
    "fringe": "fringe",
    "lacing": "lacing",
    "apron": "apron",
    "braid": "edging",
    "lace": "edging",
    "hem_border": "edging",
    "side_stripes": STRIPES,
    "side_panels": SIDE_PANELS,
    "ties": "bow",
    "lettering": MOTIF,
}
"""By key of what cannot be made of panels, what is put on for it."""
_PARTS_OF_WHOLE = {"skirt": "skirt", "trousers": "legs", "shorts": "legs", "top": "bodice", "tunic": "bodice"}
"""Kinds that are named as a part of another: "a dress with a tulle skirt"."""

_LOWER = frozenset({"trousers", "shorts", "skirt"})


def category_of(mark: WordMark) -> str:
    """The section of the tables that a word is from; empty of other words."""
    return mark.entries[0].category if mark.entries else ""


def is_look(mark: WordMark) -> bool:
    """Whether a word says nothing but how something looks."""
    return any(
        (entry.category == "colors" and entry.color is not None)
        or (entry.category in ("fabrics", "shades") and entry.looks)
        for entry in mark.entries
    )


def is_cloth(mark: WordMark) -> bool:
    """Whether it names a cloth that is not sheer."""
    return any(
        e.category == "fabrics" and e.cloth is not None and e.cloth not in _KNITS and not e.looks
        for e in mark.entries
    )


def is_outfit(mark: WordMark) -> bool:
    """Whether it names several garments at once, of which one is asked for: of a white suit the trousers."""
    return mark.role == "second" and any(
        e.category == "accessories" and "separate_pieces" in e.cannot for e in mark.entries
    )


def own_looks(mark: WordMark) -> bool:
    """Whether it tells or implies looks of its own, as names of sheer garments do."""
    return any(entry.looks for entry in mark.entries)


def part_of_garment(mark: WordMark) -> str | None:
    """The part that a garment is named as, where it is one of another: the skirt of a dress."""
    if mark.role != "part":
        return None
    kinds = [kind for entry in mark.entries for kind in entry.kinds]
    return next((_PARTS_OF_WHOLE[kind] for kind in kinds if kind in _PARTS_OF_WHOLE), None)


def put_on(mark: WordMark) -> str | None:
    """What is put on a garment for it, where it is something that is."""
    return next((PUT_ON[what] for e in mark.entries for what in e.cannot if what in PUT_ON), None)


def contrasting(mark: WordMark) -> str | None:
    """What is put on for a word that says that it is of another colour: "contrast piping"."""
    return put_on(mark) if mark.word.lower().startswith("contrast") else None


def is_way_of_cutting(mark: WordMark) -> bool:
    """Whether it says how a part is cut, and names nothing that is put on: a crew neck, puff sleeves."""
    return category_of(mark) == "styles" and put_on(mark) is None


def is_detail(mark: WordMark) -> bool:
    """Whether it is a thing of its own on a garment that cannot be made: piping, a bow."""
    return any(entry.cannot for entry in mark.entries)


def holds_up(mark: WordMark, marks: Sequence[WordMark]) -> bool:
    """Whether it is the braces of trousers or of a skirt, which have no other bodice.

    Args:
        mark: A noun.
        marks: Of the text.
    """
    kinds = {kind for own in marks if own.role == "garment" for entry in own.entries for kind in entry.kinds}
    braces = mark.role != "garment" and any("suspenders" in entry.cannot for entry in mark.entries)
    return braces and bool(kinds) and kinds <= _LOWER


def part_in_english(mark: WordMark) -> str | None:
    """The part that a detail of another language ends with in English: "manga larga", long sleeves."""
    english = mark.entries[0].english if category_of(mark) == "styles" else None
    return vocabulary("en").part(english.split()[-1]) if english else None


def color_of_word(marks: Sequence[WordMark], k: int) -> NamedColor | None:
    """The colour that the word k names, with the shade before it."""
    pairs: list[tuple[str, Sequence[Entry]]] = [(m.word, m.entries) for m in marks[max(0, k - 1) : k + 1]]
    if k and any(e.category == "colors" and e.color for e in marks[k - 1].entries):
        pairs = pairs[1:]
    found = named_colors(pairs)
    return found[0] if found else None
