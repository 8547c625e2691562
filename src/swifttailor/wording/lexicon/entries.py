"""What a row of the lexicon says: an entry, with the claims that its words imply and how surely."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from swifttailor.describing.claims import Claim
from swifttailor.garment.part_looks import OPACITIES, PANEL_PARTS, PARTS
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern.trims.names import TRIMS
from swifttailor.wording.claim_marks import claims_in
from swifttailor.wording.word_tables import Dialect, Row

Certainty = Literal["certain", "usual", "likely"]
"""certain: by definition. usual: of nearly all that are sold under the name. likely: of more than half."""
Category = Literal[
    "garments",
    "accessories",
    "generic",
    "parts",
    "styles",
    "fits",
    "lengths",
    "occasions",
    "colors",
    "shades",
    "prints",
    "fabrics",
    "sizes",
    "negations",
    "function",
    "polite",
    "degrees",
    "comparisons",
    "numbers",
]
"""Sections of the tables.

accessories: worn, but never made here. generic: "piece". shades: "dark" before a colour.
"""
CATEGORIES: tuple[str, ...] = get_args(Category)
PRINTS: Mapping[str, tuple[str, ...]] = {
    "plain": (),
    "stripes": ("width", "gap", "angle"),
    "checks": ("width", "angle"),
    "plaid": ("spacing", "angle"),
    "dots": ("spacing", "radius"),
    "motif": ("repeat",),
}
"""Kinds of prints and their sizes, as `swifttailor.render` names them."""
MOTIFS = (
    *("flowers", "blotches", "shapes", "bands"),
    *(
        "hearts",
        "stars",
        "moons",
        "bolts",
        "cherries",
        "strawberries",
        "lemons",
        "mushrooms",
        "foxes",
        "cats",
    ),
    *(
        "bears",
        "rabbits",
        "birds",
        "butterflies",
        "bees",
        "fishes",
        "dinosaurs",
        "anchors",
        "boats",
        "splatters",
    ),
    *("cranes", "elephants", "dogs", "horses", "flamingos", "owls", "turtles", "pineapples", "skulls"),
    *("snowflakes", "crosses"),
    *("leopard", "zebra", "tiger", "giraffe", "cowhide", "dalmatian", "scales", "crocodile"),
    *("tie_dye", "batik", "marble", "clouds", "bleach", "ikat"),
    *("palms", "paisley", "lozenges", "argyle", "patchwork", "serape", "medallions", "waves", "triangles"),
    "sequins",
    "sprigs",
    *("penguins", "pandas", "sharks", "whales", "unicorns", "parrots", "tigers", "rockets", "cacti"),
    *("daisies", "sunflowers"),
    *("galaxy", "camouflage", "zigzag", "herringbone", "rainbow", "ombre", "aztec", "wax_print"),
    *("houndstooth", "granny_squares", "palm_trees"),
)
_SIZES = ("width", "gap", "angle", "spacing", "radius", "repeat")
_PRINT_MARKS = (*_SIZES, "motif", "inks")
_ONE_VALUE = ("part", "cloth", "rgb", "shade", "print", "motif", "negates", *_SIZES)
_MARKS = (
    "usual",
    "likely",
    "against",
    "without",
    "cannot",
    "of",
    "inks",
    "draft",
    "trim",
    "look",
    "worn",
    *_ONE_VALUE,
)
_WORDS = ("ambiguous", "plural")
LONGEST_GLOSS = 120
"""Characters."""
_HEX = frozenset("0123456789abcdef")
_OF_ALL_TROUSERS = frozenset({"zip", "pockets"})
"""What all trousers have and no panels make, so that it says nothing of which they are."""
_KIND_AND_LENGTH = frozenset({"kind", "skirt_hem", "leg_hem", "top_hem"})
_CERTAINTIES: tuple[Certainty, ...] = ("usual", "likely")


@dataclass(frozen=True, slots=True)
class Implied:
    """A claim that a word implies."""

    claim: Claim
    certainty: Certainty


@dataclass(frozen=True, slots=True)
class NamedPrint:
    """A print that a word names."""

    kind: str
    """A key of `PRINTS`."""
    sizes: tuple[tuple[str, float], ...] = ()
    """Those that the word says, by name: cm, degrees for the angle."""
    motif: str | None = None
    """One of `MOTIFS`."""
    inks: tuple[str, ...] = ()
    """Colours that the word itself names, sRGB as ``rrggbb``."""


@dataclass(frozen=True, slots=True, eq=False)
class Entry:
    """One meaning, and the words for it."""

    words: tuple[str, ...]
    """As the table has them, at least one; the first is its name."""
    category: Category
    place: tuple[str, int]
    """File and line."""
    implied: tuple[Implied, ...] = ()
    against: tuple[Claim, ...] = ()
    """What contradicts it."""
    without: tuple[Claim, ...] = ()
    """What is asked for where the word is denied: ``sleeves=none`` for "no sleeves"."""
    cannot: tuple[str, ...] = ()
    """What of it cannot be made, as keys of `cannot_texts`."""
    of: frozenset[str] = frozenset()
    """Kinds of garments and parts that it is said of, or ``color``; empty where it stands for itself."""
    part: str | None = None
    """The part of a garment that it names."""
    cloth: str | None = None
    """The fabric of `swifttailor.draping` that comes nearest."""
    color: str | None = None
    """sRGB as ``rrggbb``."""
    shade: str | None = None
    """How it changes the colour behind it: lighter, darker, ..."""
    print: NamedPrint | None = None
    negates: Literal["after", "before"] | None = None
    """On which side of it stands what it denies."""
    ambiguous: bool = False
    """Whether no rule tells this meaning from others of its words."""
    gloss: str = ""
    """What it means, in a line."""
    english: str | None = None
    """For words of other languages: the English entry that they stand for."""
    only: tuple[tuple[str, Dialect], ...] = ()
    """Words that are used, or used in this meaning, in British or American English only."""
    drafts: tuple[NamedDraft, ...] = ()
    """Drafts of `swifttailor.pattern.drafts` that show it, one for each kind of garment."""
    worn: str | None = None
    """The name of the garment that is made for it where none is named: of the beach, a sundress."""
    trims: tuple[str, ...] = ()
    """Which trims of `swifttailor.pattern.trims` are meant by what it says cannot be made of panels."""
    worn_as: tuple[str, ...] = ()
    """What is made for it where nothing but a kind of garment is named: "a top for Christmas"."""
    looks: tuple[tuple[str, str | None], ...] = ()
    """Sheer cloths, ``contrast`` or a colour, ``rrggbb``, and the part of a garment that has them; None:
    what is spoken of."""

    @property
    def name(self) -> str:
        """Its first word."""
        return self.words[0]

    @property
    def is_mere_kind(self) -> bool:
        """Whether it names a kind of garment and at most its length: trousers, a midi skirt."""
        told = self.cannot and set(self.cannot) != _OF_ALL_TROUSERS
        if self.category != "garments" or self.against or told or self.cloth:
            return False
        return all(i.claim.name in _KIND_AND_LENGTH or i.certainty == "usual" for i in self.implied)

    def claims(self, *certainties: Certainty) -> tuple[Claim, ...]:
        """The implied claims of some certainties; all when none is given."""
        return tuple([i.claim for i in self.implied if not certainties or i.certainty in certainties])

    @property
    def kinds(self) -> frozenset[str]:
        """Kinds of garments that it can be, where it names one."""
        if self.category != "garments":
            return frozenset()
        return frozenset([str(i.claim.value) for i in self.implied if i.claim.name == "kind"])


def entry_of(row: Row, cannot: Mapping[str, str], known_of: frozenset[str]) -> Entry:
    """The entry of a row.

    Args:
        row: Of a table.
        cannot: What cannot be made, by key.
        known_of: What words can be said of.

    Raises:
        InputError: The row is wrong; the message names it.
    """
    if row.section not in CATEGORIES:
        row.wrong(f"there is no section '{row.section}'. Known: {', '.join(CATEGORIES)}.")
    if row.numbers or row.number is not None:
        row.wrong("a number stands in no row of the lexicon but behind a mark, as in 'width:2'.")
    for word in row.words:
        if word not in _WORDS:
            row.wrong(f"'{word}' is no mark; {' and '.join(_WORDS)} are, and all that hold '=' or ':'.")
    implied = tuple([Implied(claim, "certain") for claim in claims_in(row, row.claims)])
    options = row.options
    words, gloss = _with_gloss(row)
    only: tuple[tuple[str, Dialect], ...] = ()
    if "@" in "".join(words):
        words, only = _dialects(words)
    row.check_options(*_MARKS)
    for certainty in _CERTAINTIES:
        marks = options.get(certainty)
        if marks:
            implied = (*implied, *[Implied(claim, certainty) for claim in claims_in(row, marks)])
    one = {name: _single(row, name) for name in _ONE_VALUE if name in options} if len(options) else {}
    lacking = options.get("cannot", ())
    for key in lacking:
        if key not in cannot:
            row.wrong(f"cannot:{key} is not in cannot.txt.")
    of = frozenset(options["of"]) if "of" in options else frozenset()
    if not of <= known_of:
        row.wrong(
            f"of:{','.join(sorted(of - known_of))} is neither a kind nor a part. "
            f"Known: {', '.join(sorted(known_of))}."
        )
    worn = [name.replace("_", " ") for name in options.get("worn", ())]
    return Entry(
        words,
        row.section,  # ty: ignore[invalid-argument-type]
        row.place,
        implied,
        claims_in(row, options["against"]) if "against" in options else (),
        claims_in(row, options["without"]) if "without" in options else (),
        lacking,
        of,
        one.get("part"),
        one.get("cloth"),
        _hex(row, one["rgb"]) if "rgb" in one else None,
        one.get("shade"),
        _print(row, one) if "print" in one or not options.keys().isdisjoint(_PRINT_MARKS) else None,
        _side(row, one["negates"]) if "negates" in one else None,
        "ambiguous" in row.words,
        gloss,
        None,
        only,
        _drafts(row) if "draft" in options else (),
        next(iter(worn), None),
        _trims(row) if "trim" in options else (),
        tuple(worn[1:]),
        _looks(row) if "look" in options else (),
    )


def _looks(row: Row) -> tuple[tuple[str, str | None], ...]:
    found = []
    for text in row.options["look"]:
        cloth, _, part = text.partition("(")
        part = part.removesuffix(")")
        colored = len(cloth) == 6 and set(cloth) <= _HEX
        if not colored and cloth.removeprefix("lined_") not in (*OPACITIES, "contrast"):
            row.wrong(
                f"look:{cloth} is none of {', '.join(OPACITIES)}, contrast, and no colour as in 1f2a44."
            )
        parts = PARTS if colored else PANEL_PARTS
        if part not in (parts if colored else ("", *parts)):
            row.wrong(f"look:{text}: '{part}' is none of {', '.join(parts)}.")
        found.append((cloth, part or None))
    return tuple(found)


def _trims(row: Row) -> tuple[str, ...]:
    names = tuple([name.replace("_", " ") for name in row.options["trim"]])
    for name in names:
        if name not in TRIMS:
            row.wrong(f"trim:{name.replace(' ', '_')} is none of {', '.join(TRIMS)}, with _ for a space.")
    return names


def _drafts(row: Row) -> tuple[NamedDraft, ...]:
    try:
        return tuple([NamedDraft.parse(text) for text in row.options["draft"]])
    except ValueError as error:
        row.wrong(str(error))


def _with_gloss(row: Row) -> tuple[tuple[str, ...], str]:
    """The words of a row, and the gloss behind them in quotation marks."""
    *words, last = row.texts
    if not words or len(last) < 3 or last[0] != '"' or last[-1] != '"' or any('"' in word for word in words):
        row.wrong(
            'a row ends with what it means in quotation marks, as in: kilt | "a pleated, wrapped skirt".'
        )
    if len(last) > LONGEST_GLOSS + 2:
        row.wrong(f"what it means takes {len(last) - 2} characters; at most {LONGEST_GLOSS} are accepted.")
    return tuple(words), last[1:-1]


def _dialects(texts: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[tuple[str, Dialect], ...]]:
    parted = [text.partition(" @") for text in texts]
    only = tuple([(bare, mark) for bare, _, mark in parted if mark in ("uk", "us")])
    return tuple([bare for bare, _, _ in parted]), only  # ty: ignore[invalid-explicit-return]


def _single(row: Row, name: str) -> str:
    values = row.options[name]
    if len(values) != 1:
        row.wrong(f"'{name}:' takes one value, received {', '.join(values)}.")
    return values[0]


def _hex(row: Row, value: str) -> str:
    if len(value) != 6 or not _HEX.issuperset(value):
        row.wrong(f"'{value}' is no colour; it takes six digits 0-9 and a-f, as in 1f2a44.")
    return value


def _side(row: Row, value: str) -> Literal["after", "before"]:
    if value == "after" or value == "before":
        return value
    row.wrong(f"negates:{value} is neither negates:after nor negates:before.")


def _print(row: Row, one: Mapping[str, str]) -> NamedPrint:
    kind = one.get("print", "")
    if kind not in PRINTS:
        row.wrong(f"print:{kind} is none of {', '.join(PRINTS)}.")
    motif = one.get("motif")
    if (kind == "motif") != (motif is not None) or (motif is not None and motif not in MOTIFS):
        row.wrong(f"print:motif takes one of motif:{', motif:'.join(MOTIFS)}, and no other print does.")
    sizes = []
    for name in _SIZES:
        if name not in one:
            continue
        if name not in PRINTS[kind]:
            row.wrong(f"{kind} have no {name}. They have: {', '.join(PRINTS[kind]) or 'no sizes'}.")
        sizes.append((name, _number(row, name, one[name])))
    inks = tuple([_hex(row, ink) for ink in row.options.get("inks", ())])
    return NamedPrint(kind, tuple(sizes), motif, inks)


def _number(row: Row, name: str, value: str) -> float:
    try:
        number = float(value)
    except ValueError:
        row.wrong(f"{name}:{value} is no number.")
    if not 0.0 <= number <= 180.0:
        row.wrong(f"{name}:{value} is out of range: 0 to 180.")
    return number
