"""What a text says of one side alone: "left sleeve long, right sleeve short", "one strap, on the left"."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from swifttailor.describing.claims import Claim
from swifttailor.wording.lexicon import WordReading

_LENGTHS = {
    "cap": "cap",
    "short": "short",
    "elbow": "elbow",
    "elbow length": "elbow",
    "three quarter": "three-quarter",
    "three-quarter": "three-quarter",
    "3/4": "three-quarter",
    "long": "long",
    "full length": "long",
}
_SCALE = ("cap", "short", "elbow", "three-quarter", "long", "extra-long")
_OTHER = {"left": "right", "right": "left"}
_LENGTH = "|".join(sorted(map(re.escape, _LENGTHS), key=len, reverse=True))
_ARM = r"(?:sleeve|arm)(?!\w)"
_BEHIND = re.compile(
    rf"(?<!\w)(?P<side>left|right) {_ARM}(?: is| to be| should be| being|:|,)? (?:really |very )?"
    rf"(?P<length>{_LENGTH})(?![\w]| (?:left|right)(?!\w))"
)
_BEFORE = re.compile(rf"(?<!\w)(?P<length>{_LENGTH})(?:[- ]length)? (?P<side>left|right) {_ARM}")
_EACH = re.compile(
    rf"(?<!\w)one (?P<length>{_LENGTH})(?:[- ]length)?(?: {_ARM})?,?(?: and)? (?:one|the other)"
    rf"(?: {_ARM})?(?: one)? (?P<other>{_LENGTH})(?!\w)(?: {_ARM})?"
)
_EACH_BEHIND = re.compile(
    rf"(?<!\w)(?:with )?one {_ARM}(?: is)?(?: that is)? (?P<length>{_LENGTH}),?(?: and)?"
    rf" (?:one|the other)(?: {_ARM})?(?: one)?(?: is)? (?P<other>{_LENGTH})(?!\w)"
)
_STRAP = re.compile(
    r"(?<!\w)(?:(?:one|a single|single|only one) (?:shoulder )?strap"
    r"(?: only)?,? (?:on|over|at) (?:the |my )?(?P<side>left|right)(?: side| shoulder)?(?!\w))"
)
_HOW = r"(?:is |being |left |kept |completely |totally |entirely |fully |quite |all ){0,3}"
_COVERED = re.compile(rf"(?<!\w)(?P<side>left|right) shoulder {_HOW}(?:covered|draped|clothed)(?!\w)")
_UNCOVERED = re.compile(
    rf"(?<!\w)(?P<side>left|right) (?:shoulder|one) {_HOW}(?:bare|bared|uncovered|naked|exposed)(?!\w)"
    r"|(?<!\w)(?:bare|naked|exposed|uncovered) (?P<said>left|right) shoulder(?!\w)"
)
_BARE_ARM = re.compile(
    rf"(?<!\w)(?P<side>left|right) (?:{_ARM} )?{_HOW}(?:bare|bared|uncovered|naked|exposed|sleeveless)(?!\w)"
    rf"|(?<!\w)(?:bare|naked|exposed|uncovered|no) (?P<said>left|right) {_ARM}"
    rf"|(?<!\w)no sleeve on (?:the |my )?(?P<named>left|right)(?: side| arm)?(?!\w)"
)
_BARE = "(?:bare|bared|naked|uncovered|exposed|sleeveless)"
_ONE_BARE = re.compile(
    rf"(?<!\w)(?:one|the other|other) {_BARE} {_ARM}"
    rf"|(?<!\w)(?:one|the other|other) {_ARM} {_HOW}{_BARE}(?!\w)"
    rf"|(?<!\w){_ARM},?(?: and)? the other (?:one )?{_HOW}{_BARE}(?!\w)"
)
_ONE_SLEEVE = re.compile(
    rf"(?<!\w)(?:one|a single|just one|only one) (?P<length>{_LENGTH})(?:[- ]length)?"
    rf" (?:[\w-]+ )?sleeve(?!\w)"
    rf"|(?<!\w)(?:one|other) (?:sleeve|{_ARM}) (?:is )?(?P<behind>{_LENGTH})(?!\w)"
    rf"|(?<!\w)(?:the )?other (?:one )?(?:in|with|has) an? (?P<worn>{_LENGTH}) sleeve(?!\w)"
)
"""One arm alone is bare, and nothing tells which: it is the right one then."""
_SIDE_ARM = re.compile(rf"(?<!\w)(?P<side>left|right) {_ARM}")


@dataclass(frozen=True)
class SpokenSides:
    """Claims about one side, and where in the text they stand."""

    claims: tuple[Claim, ...] = ()
    spans: tuple[tuple[int, int], ...] = ()
    """Of each claim; two may stand in one."""

    def beside(self, other: SpokenSides) -> SpokenSides:
        """Both."""
        return SpokenSides((*self.claims, *other.claims), (*self.spans, *other.spans))


def spoken_sides(text: str) -> SpokenSides:
    """What a text says of the left and of the right; nothing where it speaks of both alike.

    Args:
        text: In any case.
    """
    found = list(_found(text.lower()))
    if len({claim.name for claim, _ in found}) < len(found):
        return SpokenSides()
    return SpokenSides(tuple([claim for claim, _ in found]), tuple([span for _, span in found]))


def blanked(text: str, spans: Sequence[tuple[int, int]]) -> str:
    """A text with blanks in some places, as long as it was."""
    for start, end in spans:
        text = text[:start] + " " * (end - start) + text[end:]
    return text


def _found(text: str) -> Iterator[tuple[Claim, tuple[int, int]]]:
    for pattern in (_BEHIND, _BEFORE):
        for match in pattern.finditer(text):
            yield Claim(f"{match['side']}_sleeve", _LENGTHS[match["length"]]), match.span()
    for match in (*_EACH.finditer(text), *_EACH_BEHIND.finditer(text)):
        if not re.search(rf"(?:sleeves?|arms?|{_ARM})(?!\w)", text):
            continue
        for side, said in (("left", match["length"]), ("right", match["other"])):
            yield Claim(f"{side}_sleeve", _LENGTHS[said]), match.span()
    for match in _STRAP.finditer(text):
        yield Claim("shoulders", f"bare {_OTHER[match['side']]}"), match.span()
    yield from _uncovered(text)


def _uncovered(text: str) -> Iterator[tuple[Claim, tuple[int, int]]]:
    """Which shoulder or arm is bare: "right shoulder covered, left one bare", "right arm completely bare"."""
    sides: dict[str, list[tuple[int, int]]] = {}
    for match in _COVERED.finditer(text):
        sides.setdefault(_OTHER[match["side"]], []).append(match.span())
    for match in _UNCOVERED.finditer(text):
        if "shoulder" in text:
            sides.setdefault(match["side"] or match["said"], []).append(match.span())
    if len(sides) == 1:
        (side, spans), *_ = sides.items()
        yield Claim("shoulders", f"bare {side}"), (min(spans)[0], max(spans)[1])
    arms = {m["side"] or m["said"] or m["named"]: m.span() for m in _BARE_ARM.finditer(text)}
    if len(arms) == 1 and not sides and re.search(rf"(?<!\w)(?:sleeves?|arms?|{_ARM})(?!\w)", text):
        ((side, span),) = arms.items()
        yield Claim("sleeves", f"{_OTHER[side]} only"), span
    elif not arms and not sides and (bare := _ONE_BARE.search(text)):
        yield Claim("sleeves", "left only"), bare.span()
        if length := _ONE_SLEEVE.search(text):
            said = length["length"] or length["behind"] or length["worn"]
            yield Claim("left_sleeve", _LENGTHS[said]), length.span()


def without_spans(words: WordReading, spans: Sequence[tuple[int, int]]) -> WordReading:
    """A reading of the lexicon without what stands in some places: there it is said of one side."""

    def inside(start: int) -> bool:
        return any(a <= start < b for a, b in spans)

    if not spans:
        return words
    return replace(
        words,
        implications=tuple([i for i in words.implications if not inside(i.mark.start)]),
        contradictions=tuple(
            [c for c in words.contradictions if not (inside(c.first.start) and inside(c.second.start))]
        ),
    )


def one_sleeve(said: str, sign: int, is_so: Callable[[Claim], bool]) -> Claim | None:
    """One sleeve a step longer or shorter; None where a clause does not speak of one, or there is no step.

    Args:
        said: The clause, in lower case.
        sign: 1 for longer.
        is_so: Whether a claim is true of the garment.
    """
    match = _SIDE_ARM.search(said)
    if match is None:
        return None
    name = f"{match['side']}_sleeve"
    now = next((k for k, value in enumerate(_SCALE) if is_so(Claim(name, value))), None)
    if now is None or not 0 <= now + sign < len(_SCALE):
        return None
    return Claim(name, _SCALE[now + sign])
