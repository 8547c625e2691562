"""The print that a text asks for: its kind, its colours in their places, its sizes and its direction."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.garment.cloth_print import KINDS, ClothPrint
from swifttailor.wishes.looks.joined_colors import joined_colors
from swifttailor.wishes.looks.print_inks import (
    DARK,
    FIGURES,
    LIGHT,
    brightness,
    contrast,
    mixed,
    motif_inks,
    seen_on,
    tartan_inks,
    tonal_check,
    usual_inks,
)
from swifttailor.wishes.looks.printed_parts import ON_ALL, PrintedParts
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.lexicon import WordMark, WordReading, read_words
from swifttailor.wording.lexicon.entries import NamedPrint
from swifttailor.wording.lexicon.said_blocks import blocks_named

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
    "shirt shirt-dress blazer waistcoat trousers pull-on-trousers jeans flares coat dungarees apron "
    "robe".split()
)
"""Drafts of garments whose stripes run down, where no more is said of them; knitted ones are hooped."""
_WOVEN = frozenset({("collar", "revers"), ("collar", "shirt")})
"""Options of what is buttoned like a shirt, as pyjamas and nightshirts are: its cloth is no knit."""
_SHIRTING_CM = 1.2
"""So wide are stripes of shirts and trousers, where no more is said of them."""
_TARTANS = re.compile(
    r"tartan|clan|scot|royal|black ?watch|burberry|glen|prince|pow|window|tattersall|grid|graph|madras", re.I
)
"""Names of checks that are of three colours or more; others of two colours have these alone."""
_FIGURED = re.compile(
    r"[\s-]*(?:patterns?|patterning|motifs?|designs?|ornaments?|Mustern?|brocade pattern)(?!\w)",
    re.IGNORECASE,
)
_FIGURED_BEFORE = re.compile(
    r"(?<!\w)(?:motifs?|dessins?|motivos?|estampados?|dibujos?|disegni|motivi|fantasia|padrão|padrões|patroon)\s+$",
    re.IGNORECASE,
)
_FIGURES_OF_COLOR = "medallions"
_OF_CLOTH = re.compile(r"(?:check|checks|checked|checky|chequered|checkered|check pattern)", re.IGNORECASE)
"""Names of checks that, on cloth for suits and coats, are shades of one colour."""
_TAILORED = frozenset("blazer waistcoat trousers coat".split())
_SUITING_CM = 6.0
_LEAST_APART = 45.0
"""Difference in brightness of two colours from which one is seen on the other, 0 to 255."""
_BUFFALO_CM = 4.5
"""So wide are the squares of checks of two colours on lumberjack shirts and the like."""
_LUMBERJACK, _GREY = ("#a3262c", "#1d1c20"), "#777a82"
"""Colours of checks on such, and on cloth for suits, where none are named."""
_SIZED = re.compile(r"(?<!\w)(?P<size>tiny|little|small|big|large)\s+$", re.IGNORECASE)
_JOINED = re.compile(r"(?:\s|,|&|(?<!\w)and(?!\w))+$", re.IGNORECASE)
"""What may stand between a size, colours and the figures that have both."""
_PERSONS = "persons.txt"
_BEHIND = 24
"""Characters behind the name of a print in which its size may stand."""
_STRIPES_OF_ALL = "rainbow"
"""The motif of stripes in more than two colours, six of them in a repeat."""
_PANES = re.compile(r"window|pane|tattersall|grid|graph|overcheck", re.IGNORECASE)
"""Checks that are nothing but thin lines."""
_BLOCKS, _HUNG_CM = 3, 180.0
_BORDER = "hem_border"
_BANDS_OF = {2: "two_blocks", 3: "blocks", 4: "four_blocks"}
_BARE_ARMS = Claim("sleeves", "none")
_WHITE, _COLORED, _PALEST = "#fdfcf8", 24, 226.0
"""Difference of red, green and blue from which a pale colour is no white, and its most brightness."""
_NEAR = 2
"""Characters between a colour and the print that it is of."""
_VAGUE = frozenset("print prints printed patterned patterning mixed".split()) | {"a print", "all over print"}
_SIZE = {"stripes": ("width", "gap"), "checks": ("width",), "plaid": ("spacing",), "motif": ("repeat",)}


_PLAIN_STRIPES = {"width": 2.5, "gap": 2.5}
"""Sizes of stripes of which a text says no more."""
_OF_NAMES = 2
"""How vague a print is that the name of a garment means."""


def heard_print(
    text: str, words: WordReading, parts: PrintedParts = ON_ALL, kind: str | None = None
) -> ClothPrint | None:
    """The print that a text asks for; None where it asks for none, or for plain cloth.

    Args:
        text: That the lexicon has read.
        words: By the lexicon.
        parts: What prints are said of, where that is not the whole: there they keep their own colours.
        kind: Of the garment.
    """
    marks = [m for m in words.marks if not m.denied and _kind(m) in KINDS and m not in parts.unused]
    if not marks and parts:
        return None
    if not marks:
        return _in_color(text, words) or _of_blocks(text, words, kind)
    # What is said of the print itself goes before what names of garments mean, "leopard" before "print".
    mark = min(marks, key=_vagueness)
    if _vagueness(mark) == _OF_NAMES and asks_for_plain(words):
        return None
    named = next(entry.print for entry in mark.entries if entry.print is not None)
    apart = _sized(text, words, mark)
    named = named if apart is None else apart
    sizes = dict(named.sizes) | _usual_stripes(marks, named) | _stated_sizes(text, mark, named.kind)
    if named.kind == "stripes" and "angle" not in sizes and _is_striped_down(words):
        sizes = dict.fromkeys(("width", "gap"), _SHIRTING_CM) | _unlike(sizes, "stripes") | {"angle": 90.0}
    turned = next((angle for words_, angle in _DIRECTIONS if words_.search(text)), None)
    if turned is not None and named.kind in ("stripes", "checks", "plaid"):
        sizes["angle"] = turned
    colors = _named_colors(text, words, mark, named.kind)
    if parts.parts:
        colors = _of_part(words, mark, colors, named)
    if named.kind == "stripes" and len(colors) > 2:
        repeat = 6 * sizes.get("width", ClothPrint("stripes", ()).size("width"))
        angle = {"angle": sizes["angle"]} if "angle" in sizes else {}
        return ClothPrint("motif", tuple(colors[:6]), {"repeat": repeat, **angle}, _STRIPES_OF_ALL)
    if named.kind == "plaid" and _PANES.search(mark.word) and colors:
        colors = _named_colors(text, words, mark, "dots")  # "green on cream": the ground first
        line = colors[1] if len(colors) > 1 else tartan_inks(colors)[-1]
        return ClothPrint("plaid", (colors[0], colors[0], line), sizes)
    if apart is not None and len(words.colors) == 1 and named.kind in ("dots", "motif"):
        colors = [contrast(colors[-1]), colors[-1]]  # "little blue flowers"
    if named.kind == "plaid" and len(colors) == 2 and not _TARTANS.search(mark.word):
        width = sizes.get("spacing", _BUFFALO_CM * 2) / 2
        return ClothPrint("checks", tuple(colors), _without(sizes, "spacing") | {"width": width})
    if named.kind == "checks" and len(colors) == 1 and _OF_CLOTH.fullmatch(mark.word) and _is_tailored(words):
        spacing = 2.0 * sizes["width"] if sizes["width"] != dict(named.sizes)["width"] else _SUITING_CM
        return ClothPrint("plaid", tonal_check(colors[0]), _without(sizes, "width") | {"spacing": spacing})
    if named.kind == "checks" and not colors and not named.inks and _OF_CLOTH.fullmatch(mark.word):
        if any(_kind(m) == "plaid" for m in marks):
            return ClothPrint("checks", _LUMBERJACK, _without(sizes, "spacing") | {"width": _BUFFALO_CM})
        if _is_tailored(words):
            return ClothPrint(
                "plaid", tonal_check(_GREY), _without(sizes, "width") | {"spacing": _SUITING_CM}
            )
    if named.kind == "checks" and any(_kind(m) == "plaid" for m in marks):
        sizes["width"] = max(sizes["width"], _BUFFALO_CM)
    inks = tuple([f"#{ink}" for ink in named.inks or _inks_of_others(marks, named.kind)])
    return ClothPrint(
        named.kind, _colors(named.kind, named.motif, colors, inks), sizes, named.motif or "shapes"
    )


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
    name = found.motif.replace("_", " ") if found.kind == "motif" else found.kind
    shown = f"{name}{way if found.kind == 'stripes' else ''}"
    return f"{shown}, {sizes}, {' and '.join(found.colors)}"


def _kind(mark: WordMark) -> str:
    return next((entry.print.kind for entry in mark.entries if entry.print is not None), "")


def _sized(text: str, words: WordReading, mark: WordMark) -> NamedPrint | None:
    """The print that figures have with a size that stands before their colours: "tiny white flowers"."""
    first = mark.start
    while True:
        joined = len(_JOINED.sub("", text[:first]))
        before = [m for m in words.color_marks if m.start < first and m.end == joined]
        if not before:
            break
        first = before[0].start
    size = _SIZED.search(text[:first])
    if size is None or first == mark.start or not mark.word.endswith("s"):
        return None
    name = f"{size['size']} {mark.word}"
    return next(
        (
            entry.print
            for found in read_words(name).marks
            if found.start == 0 and found.end == len(name)
            for entry in found.entries
            if entry.print is not None
        ),
        None,
    )


def _inks_of_others(marks: Sequence[WordMark], kind: str) -> tuple[str, ...]:
    """The colours that what is named beside a print has it in: a plaid "like in Clueless" is yellow."""
    known = [entry.print for m in marks for entry in m.entries if entry.place[0] == _PERSONS and entry.print]
    return next((one.inks for one in known if one.kind == kind), ())


def _is_striped_down(words: WordReading) -> bool:
    """Whether the first garment that is named is one whose stripes run down."""
    marks = [m for m in words.marks if m.role == "garment" and not m.denied]
    drafts = [draft for entry in marks[0].entries for draft in entry.drafts] if marks else []
    return bool(drafts) and (drafts[0].name in _STRIPED_DOWN or not _WOVEN.isdisjoint(drafts[0].options))


def _unlike(sizes: Mapping[str, float], kind: str) -> dict[str, float]:
    """Sizes that are not merely what is usual of a print."""
    usual = ClothPrint(kind, ())
    return {name: value for name, value in sizes.items() if value != usual.size(name)}


def _in_color(text: str, words: WordReading) -> ClothPrint | None:
    """Figures of a colour on cloth of another, of which no more is said: "red with gold pattern"."""
    named = [f"#{color.rgb}" for color in words.colors]
    for color, m in zip(named, words.color_marks, strict=True):
        behind, before = text[m.end :], text[: m.start]
        if not m.denied and (_FIGURED.match(behind) or _FIGURED_BEFORE.search(before)):
            others = [one for one in named if one != color]
            ground = others[0] if others else contrast(color)
            return ClothPrint("motif", motif_inks(_FIGURES_OF_COLOR, [ground, color]), {}, _FIGURES_OF_COLOR)
    return None


def _vagueness(mark: WordMark) -> int:
    """0 of what names a print, 1 of "printed", 2 of garments that usually have one."""
    if not any(entry.category == "prints" for entry in mark.entries):
        return _OF_NAMES
    vague = any(entry.english in _VAGUE for entry in mark.entries)  # "estampado"
    return int(vague or mark.word.lower() in _VAGUE or mark.word.lower().startswith("with "))


def _of_blocks(text: str, words: WordReading, kind: str | None) -> ClothPrint | None:
    """Broad bands, where a text names three colours or more for blocks of colour, or side by side.

    Two are bands on what has no parts to be in the second: a skirt, a top without sleeves.
    """
    colors = joined_colors(text, words)
    if blocks_named(words.marks) is not None and len(words.colors) >= _BLOCKS:
        colors = words.colors
    bordered = any(lack.what == _BORDER for lack in words.lacks)  # which is in the second
    bare = (kind == "skirt" and not bordered) or (kind == "top" and words.certainty(_BARE_ARMS) is not None)
    if asks_for_plain(words) or len(colors) < (2 if bare else _BLOCKS):
        return None
    inks = tuple([f"#{color.rgb}" for color in colors[: max(_BANDS_OF)]])
    return ClothPrint("motif", inks, {"repeat": _HUNG_CM}, _BANDS_OF[len(inks)])


def _of_part(words: WordReading, mark: WordMark, colors: list[str], named: NamedPrint) -> list[str]:
    """The colours of a print on parts: those said beside it; else of figures and checks their own."""
    beside = [
        f"#{look.color.rgb}"
        for look in words.looks
        if look.color is not None and any(abs(m.end - mark.start) <= _NEAR for m in look.marks)
    ]
    if beside:
        return [*colors[:1], beside[0]] if named.kind in ("stripes", "dots") else beside
    return colors if named.kind in ("stripes", "dots", "checks") else []


def _without(sizes: Mapping[str, float], name: str) -> dict[str, float]:
    return {one: value for one, value in sizes.items() if one != name}


def _is_tailored(words: WordReading) -> bool:
    """Whether a text names cloth of wool, or first a garment that is made of such."""
    marks = [m for m in words.marks if m.role == "garment" and not m.denied]
    drafts = {draft.name for entry in marks[0].entries for draft in entry.drafts} if marks else set()
    return "wool" in words.cloths or not _TAILORED.isdisjoint(drafts)


def _usual_stripes(marks: Sequence[WordMark], named: NamedPrint) -> dict[str, float]:
    """The sizes of the stripes that the name of a garment means, where a text calls them stripes alone."""
    plain = {name: size for name, size in dict(named.sizes).items() if (name, size) != ("angle", 0.0)}
    if named.kind != "stripes" or plain != _PLAIN_STRIPES:
        return {}
    own = [entry.print for m in marks for entry in m.entries if entry.category == "garments" and entry.print]
    return next((dict(one.sizes) for one in own if one.kind == "stripes"), {})


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


def _named_colors(text: str, words: WordReading, mark: WordMark, kind: str) -> list[str]:
    """The colours that a text names, the ground of dots and motifs first, that of others last."""
    marks = words.color_marks
    named = [f"#{color.rgb}" for color in words.colors]
    on = [c for c, m in zip(named, marks, strict=True) if _ON.search(text[: _start(text, m)])]
    figured = kind in ("dots", "motif")
    if on:
        others = [color for color in named if color != on[0]]
        return [on[0], *others] if figured else [*others, on[0]]
    if len(named) == 1 and figured and _is_of_figures(text, marks[0], mark):
        return [LIGHT, named[0]]
    return named


def _colors(kind: str, motif: str | None, named: list[str], inks: tuple[str, ...]) -> tuple[str, ...]:
    usual = usual_inks((motif or "") if kind == "motif" else kind)
    if not named and not inks and usual:
        return usual
    if not named and len(inks) > 1:
        return inks if kind == "motif" else inks[: 3 if kind == "plaid" else 2]
    if kind == "motif" and motif is not None:
        named = named or [*inks, LIGHT, DARK]
        if motif not in FIGURES:
            return motif_inks(motif, named)
        figures = usual[1:] if len(named) == 1 else (named[1], *usual[2:])
        return (named[0], *seen_on(named[0], figures))
    if kind == "plaid":
        return tartan_inks(named or [LIGHT, DARK])
    named = named or [LIGHT, DARK]
    if len(named) == 1 and len(inks) > 1:  # a red hi-vis vest has silver bands
        near = abs(brightness(inks[1]) - brightness(named[0])) < _LEAST_APART
        named.append(mixed(LIGHT, named[0], 0.6) if near else inks[1])
    return (*named, _beside(named[0]))[:2]


def _beside(color: str) -> str:
    """White beside a pale colour, as gingham and stripes have it; navy beside white and cream."""
    parts = [int(color[k : k + 2], 16) for k in (1, 3, 5)]
    pale = max(parts) - min(parts) >= _COLORED and brightness(color) <= _PALEST
    return _WHITE if pale and contrast(color) == DARK else contrast(color)


def _start(text: str, mark: WordMark) -> int:
    """Where a colour begins, a shade before it taken in: "on a dark blue"."""
    before = re.search(r"(?:dark|light|pale|deep|bright)\s*$", text[: mark.start], re.IGNORECASE)
    return before.start() if before else mark.start


def _is_of_figures(text: str, color: WordMark, mark: WordMark) -> bool:
    """Whether a colour is that of the dots: "with red dots", and not "a red dotted dress"."""
    beside = color.end <= mark.start and not text[color.end : mark.start].strip()
    return beside and _WITH.search(text[: _start(text, color)]) is not None
