"""The print that a text asks for: its kind, its colours in their places, its sizes and its direction."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from swifttailor.garment.cloth_print import KINDS, ClothPrint
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.lexicon import WordMark, WordReading

_LIGHT, _DARK, _INK = "#f4f1e8", "#1f2a44", "#a8443c"
_USUAL_COLORS = {
    "flowers": ("#f4f1e8", "#b0485a", "#d9a0a8", "#5f8a5a"),
    "leaves": ("#f4f1e8", "#3f6b46", "#7fa070", "#c2a25c"),
    "spots": ("#cfa56b", "#35261a", "#8a6238", "#5b4127"),
    "blotches": ("#6f7758", "#3c4530", "#a89e76", "#2b2b23"),
    "hearts": ("#f6f1ea", "#c8354a"),
    "stars": ("#1f2a44", "#e9c85c"),
    "moons": ("#1f2a44", "#e9dfb4", "#e9c85c"),
    "bolts": ("#f4f1e8", "#e2b32c"),
    "cherries": ("#f6f1e6", "#b3202c", "#3f7a3c"),
    "strawberries": ("#f6f1e6", "#c92f38", "#3f7a3c", "#f3dfa0"),
    "lemons": ("#f4f1e8", "#f0cf3a", "#4f8a48", "#fbeea0"),
    "mushrooms": ("#dfe5d0", "#b8332c", "#f6efe0"),
    "foxes": ("#dfe6e2", "#d0702c", "#f8f2e6", "#33261f"),
    "cats": ("#f1e6dc", "#3a3a42", "#e9d27a", "#d98a94"),
    "bears": ("#dbe6ee", "#9a6b45", "#e6c9a4", "#33261f"),
    "rabbits": ("#cfdfe6", "#f8f4ee", "#e6a8ae", "#4a3d3a"),
    "birds": ("#f2eee2", "#3d6f96", "#a9c8d8", "#d38a34"),
    "butterflies": ("#f4f0e8", "#d8763a", "#f0b85a", "#33261f"),
    "bees": ("#eef2ea", "#efc03a", "#c9d8e2", "#2b2622"),
    "fishes": ("#e4eef0", "#3f86a8", "#e79a5a"),
    "dinosaurs": ("#f1ede0", "#5f9a5c", "#e2b64a"),
    "anchors": ("#f4f1e8", "#1f2a44"),
    "boats": ("#e6eef2", "#1f2a44", "#ffffff", "#c8354a"),
    "splatters": ("#f4f1e8", "#2f6fae", "#d8453a", "#efc03a"),
    "plaid": ("#a3262e", "#20402f", "#e2c860"),
}
"""What such a print has where no colour is named."""
_PICTURED = frozenset(_USUAL_COLORS) - {"flowers", "leaves", "spots", "blotches", "plaid"}
"""Figures that keep their own colours on whatever ground: foxes are red on blue."""
_LIGHT_FROM = 190.0
"""Brightness from which a colour counts as light, 0 to 255."""
_ON = re.compile(r"(?<!\w)(?:on|against|auf|sur|sobre|su|op|em)(?:\s+(?:a|an|the))?\s*$", re.IGNORECASE)
_WITH = re.compile(r"(?<!\w)(?:with|mit|avec|à|con|in|met|com)\s*$", re.IGNORECASE)
_ACROSS = re.compile(
    r"(?<!\w)(?:horizontal\w*|orizzontal\w*|horizontais|dwars\w*|across|around|quer\w*|crosswise|waagerecht\w*|hoop\w*)(?!\w)",
    re.IGNORECASE,
)
_DOWN = re.compile(
    r"(?<!\w)(?:vertical\w*|verticais|lengthwise|longitudinal|längs\w*|senkrecht\w*|up and down)(?!\w)",
    re.IGNORECASE,
)
_SLANTED = re.compile(
    r"(?<!\w)(?:diagonal\w*|slanted|bias|schräg\w*|diagonales?|diagonais|schuin\w*)(?!\w)", re.IGNORECASE
)
_DIRECTIONS = ((_SLANTED, 45.0), (_DOWN, 90.0), (_ACROSS, 0.0))
_STRIPED_DOWN = frozenset(
    "shirt shirt-dress blazer waistcoat trousers pull-on-trousers jeans flares coat dungarees".split()
)
"""Drafts of garments whose stripes run down, where no more is said of them; knitted ones are hooped."""
_SHIRTING_CM = 1.2
"""So wide are stripes of shirts and trousers, where no more is said of them."""
_SEQUINS, _GLINT = "embroidery", 0.4
"""What sequins are in `cannot.txt`, and how much of white is in their glints."""
_BEHIND = 24
"""Characters behind the name of a print in which its size may stand."""
_SIZE = {"stripes": ("width", "gap"), "checks": ("width",), "plaid": ("spacing",), "motif": ("repeat",)}


def heard_print(text: str, words: WordReading) -> ClothPrint | None:
    """The print that a text asks for; None where it asks for none, or for plain cloth.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
    """
    mark = next((m for m in words.marks if not m.denied and _kind(m) in KINDS), None)
    if mark is None:
        return None
    named = next(entry.print for entry in mark.entries if entry.print is not None)
    sizes = dict(named.sizes) | _stated_sizes(text, mark, named.kind)
    if named.kind == "stripes" and "angle" not in sizes and _is_striped_down(words):
        sizes = dict.fromkeys(("width", "gap"), _SHIRTING_CM) | _unlike(sizes, "stripes") | {"angle": 90.0}
    turned = next((angle for words_, angle in _DIRECTIONS if words_.search(text)), None)
    if turned is not None and named.kind in ("stripes", "checks", "plaid"):
        sizes["angle"] = turned
    colors = _colors(text, words, mark, named.kind, tuple(f"#{ink}" for ink in named.inks))
    return ClothPrint(named.kind, colors, sizes, named.motif or "shapes")


def asks_for_plain(words: WordReading) -> bool:
    """Whether a text asks for cloth without print, or denies one."""
    return any(_kind(m) == "plain" or (m.denied and _kind(m) in KINDS) for m in words.marks)


def print_line(found: ClothPrint) -> str:
    """A print in words: "stripes around the body, 2.5 and 2.5 cm, #1f2a44 and #f4f1e8"."""
    angle = found.size("angle") % 180
    way = {0.0: " around the body", 90.0: " down the body"}.get(angle, " at a slant")
    sizes = {
        "stripes": f"{found.size('width'):g} and {found.size('gap'):g} cm",
        "checks": f"{found.size('width'):g} cm",
        "plaid": f"every {found.size('spacing'):g} cm",
        "dots": f"{2 * found.size('radius'):g} cm wide, {found.size('spacing'):g} cm apart",
        "motif": f"repeated after {found.size('repeat'):g} cm",
    }[found.kind]
    name = found.motif if found.kind == "motif" else found.kind
    shown = f"{name}{way if found.kind == 'stripes' else ''}"
    return f"{shown}, {sizes}, {' and '.join(found.colors)}"


def _kind(mark: WordMark) -> str:
    return next((entry.print.kind for entry in mark.entries if entry.print is not None), "")


def _is_striped_down(words: WordReading) -> bool:
    """Whether the first garment that is named is one whose stripes run down."""
    marks = [m for m in words.marks if m.role == "garment" and not m.denied]
    drafts = [draft.name for entry in marks[0].entries for draft in entry.drafts] if marks else []
    return bool(drafts) and drafts[0] in _STRIPED_DOWN


def _unlike(sizes: Mapping[str, float], kind: str) -> dict[str, float]:
    """Sizes that are not merely what is usual of a print."""
    usual = ClothPrint(kind, ())
    return {name: value for name, value in sizes.items() if value != usual.size(name)}


def _motif(mark: WordMark) -> str:
    return next((e.print.motif or "" for e in mark.entries if e.print is not None), "")


def _stated_sizes(text: str, mark: WordMark, kind: str) -> dict[str, float]:
    """What a number says that stands beside the name of the print: "2 cm stripes", "stripes 5 cm wide"."""
    for mention in find_mentions(text):
        before = mention.end <= mark.start and not text[mention.end : mark.start].strip(" -").count(" ")
        after = mark.end <= mention.start <= mark.end + _BEHIND and "," not in text[mark.end : mention.start]
        if mention.is_length and 0.1 <= mention.value <= 60 and (before or after):
            if kind == "dots":
                return {"radius": mention.value / 2, "spacing": max(2.5 * mention.value, 1.0)}
            return dict.fromkeys(_SIZE[kind], mention.value)
    return {}


def _colors(
    text: str, words: WordReading, mark: WordMark, kind: str, inks: tuple[str, ...]
) -> tuple[str, ...]:
    marks = words.color_marks
    named = [f"#{color.rgb}" for color in words.colors]
    ground = next((c for c, m in zip(named, marks, strict=True) if _ON.search(text[: _start(text, m)])), None)
    usual = _USUAL_COLORS.get(_motif(mark) if kind == "motif" else kind, ())
    if not named and not inks and usual:
        return usual
    if not named:
        named = list(inks) if len(inks) > 1 else [_LIGHT, _DARK]
    elif ground is not None:
        others = [color for color in named if color != ground]
        named = [ground, *others] if kind in ("dots", "motif") else [*others, ground]
    elif len(named) == 1 and kind in ("dots", "motif") and _is_of_figures(text, marks[0], mark):
        named = [_LIGHT, named[0]]
    if len(named) == 1 and len(inks) > 1:  # a blue huipil has pale bands
        named.append(_mixed("#ffffff", named[0], _GLINT) if _glints(mark) else inks[1])
    if len(named) == 1:
        named.append(_LIGHT if _brightness(named[0]) < _LIGHT_FROM else _DARK)
    if kind == "plaid" and len(named) == 2:
        named.append(_LIGHT if _brightness(named[0]) < _LIGHT_FROM else _INK)
    if _motif(mark) in _PICTURED and kind == "motif":
        figures = usual[1:] if len(marks) == 1 and named[0] != _LIGHT else (named[1], *usual[2:])
        return (named[0], *figures)
    if kind == "motif":
        while len(named) < 4:
            named.append(_mixed(named[0], named[1], 0.35 * (len(named) - 1)))
    return tuple(named[:4] if kind == "motif" else named[:3] if kind == "plaid" else named[:2])


def _glints(mark: WordMark) -> bool:
    """Whether it names sequins, which glint in the colour that they have."""
    return any(_SEQUINS in entry.cannot for entry in mark.entries)


def _start(text: str, mark: WordMark) -> int:
    """Where a colour begins, a shade before it taken in: "on a dark blue"."""
    before = re.search(r"(?:dark|light|pale|deep|bright)\s*$", text[: mark.start], re.IGNORECASE)
    return before.start() if before else mark.start


def _is_of_figures(text: str, color: WordMark, mark: WordMark) -> bool:
    """Whether a colour is that of the dots: "with red dots", and not "a red dotted dress"."""
    beside = color.end <= mark.start and not text[color.end : mark.start].strip()
    return beside and _WITH.search(text[: _start(text, color)]) is not None


def _brightness(color: str) -> float:
    red, green, blue = (int(color[k : k + 2], 16) for k in (1, 3, 5))
    return 0.3 * red + 0.59 * green + 0.11 * blue


def _mixed(one: str, other: str, share: float) -> str:
    parts: Sequence[float] = [
        (1 - share) * int(other[k : k + 2], 16) + share * int(one[k : k + 2], 16) for k in (1, 3, 5)
    ]
    return "#" + "".join([f"{round(part):02x}" for part in parts])
