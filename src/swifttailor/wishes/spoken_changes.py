"""What an instruction asks for by its words alone: comparisons, details, removals, what is to stay.

Rules and tables, no network. Each clause is read by itself; what of it nothing accounts for is named, and left
to the network that hears how words hang together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.change_parts import Property, changes_of, subjects_of
from swifttailor.wishes.change_words import (
    ChangeWord,
    PartWord,
    find_adjectives,
    find_changes,
    find_parts,
    kept_words,
    target_words,
)
from swifttailor.wishes.mentions import Mention, find_mentions
from swifttailor.wishes.unread import is_function_word
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import Implication, WordMark, WordReading, exclude, read_words

_JOINT = re.compile(
    r"[.;:!?\n]+(?=\s|$)|,(?=\s)|\s[-+]\s|\s(?:and|but|then|und|aber|et|mais|y|pero)\s|\sso\s(?=it|that|can|could|i\b|she|he|they)", re.IGNORECASE
)
_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
_THEM = re.compile(r"(?<!\w)(?:them|they|sie|les|las|los)(?!\w)")
_LESS_BY = re.compile(r"(?<!\w)(?:off|minus|less|weniger|weg|take|shorten|remove)(?!\w)|^\s*-\s*\d")
_TO = re.compile(r"(?<!\w)(?:to|auf|à|a)\s*$")
_SILENT = frozenset(["function", "polite", "degrees", "numbers", "negations", "generic"])
_BASES = {"tunic": "top", "shorts": "trousers", "playsuit": "jumpsuit"}
_PARTS_OF = {"dress": ("skirt", "top"), "jumpsuit": ("trousers", "top"), "playsuit": ("shorts", "top")}
_WITH_LEGS = frozenset(["trousers", "shorts", "jumpsuit", "playsuit"])
_NAMED = {
    **dict.fromkeys(["pants", "trousers", "hose", "pantalon", "pantalón", "shorts"], _WITH_LEGS),
    **dict.fromkeys(["dress", "kleid", "robe", "vestido"], frozenset(["dress", "tunic", "jumpsuit"])),
    **dict.fromkeys(["top", "shirt", "blouse", "jumper", "sweater", "hoodie"], frozenset(["top", "tunic", "dress"])),
}
"""Kinds that a name of a garment can mean where one is there already."""
_CAREFUL_CM = 6.0
"""A step of no stated size where something beyond it is refused: "shorter, but not mini"."""
_TAKEN_OUT = re.compile(r"(?<!\w)(?:take|get|pull|taking)(?!\w)[^.]*(?<!\w)out(?!\w)")
_TO_BE = re.compile(r"(?<!\w)(?:make|made|be|become|want|wants|need|prefer|should|mach|rends|haz)(?!\w)")
_TOO_CLOSE = re.compile(
    r"(?<!\w)(?:remove|off|away|lose|strangl\w*|chok\w*|scratch\w*|itch\w*|suffocat\w*|weg|würgt|étrangle)(?!\w)"
)
_YEAR = re.compile(r"(?<!\w)(?:1[5-9]\d\d|\d0)s(?!\w)|(?<!\w)1[5-9]\d\d(?!\w)")
_CLOSED = re.compile(r"(?<!\w)(?:close|closed|shut|sew up|sewn up|zu|fermer|cerrar)(?!\w)")
_SIDE = re.compile(
    r"(?<!\w)(?:(?P<left>left|links|gauche|izquierda)|(?P<right>right|rechts|droite|derecha)"
    r"|(?P<back>back|behind|hinten|derrière|detrás)|(?P<front>front|vorne|devant|delante))(?!\w)"
)
_PLACES = {
    "front": "front|vorne|devant|delante",
    "back": "back|behind|hinten|derrière|detrás",
    "right": "right|rechts|droite|derecha",
    "left": "side|left|leg|links|seite|seitlich|côté|gauche|lado|izquierda|add|put|cut|open|a slit",
}
"""Where a slit is, by words; "at the side" is at the left."""
_STEPS_DOWN = re.compile(r"(?<!\w)(?:off|away|remove|take|lose|without|weniger|weg)(?!\w)")


@dataclass(frozen=True)
class SpokenClause:
    """A clause of an instruction, and what it asks for."""

    start: int
    end: int
    changes: tuple[Change, ...]
    left_over: tuple[str, ...]
    """Words that nothing accounts for."""


@dataclass(frozen=True)
class SpokenChanges:
    """What an instruction asks for by its words."""

    clauses: tuple[SpokenClause, ...]
    kept: frozenset[str]
    """Claims and quantities that are to stay as they are."""
    clashes: tuple[tuple[str, str], ...]
    """What asks for opposite things, in words; none of it counts."""

    @property
    def changes(self) -> tuple[Change, ...]:
        """Of all clauses, each once."""
        return tuple(dict.fromkeys([change for clause in self.clauses for change in clause.changes]))


def spoken_changes(
    text: str, words: WordReading, kind: str, is_so: Callable[[Claim], bool] = lambda claim: False
) -> SpokenChanges:
    """Reads an instruction.

    Args:
        text: As the lexicon has read it.
        words: By the lexicon.
        kind: Of the garment to change.
        is_so: Whether a claim is true of it: who says so describes it and asks for nothing.
    """
    small = text.lower()
    them = False
    changes, parts, mentions = find_changes(small), find_parts(small), find_mentions(text)
    implied = _meant(small, words, kind)
    bounds = _clauses(small)
    found: list[SpokenClause] = []
    kept: set[str] = set()
    last: str | None = None
    for start, end in bounds:
        inside = [p for p in parts if start <= p.start < end]
        if kept_words().search(small, start, end):
            for part in inside:
                kept |= subjects_of(part.part)
            if not any(start <= c.start < end for c in changes):
                kept_gains = [i.claim.name for i in implied if start <= i.mark.start < end]
                kept.update(kept_gains)
                found.append(SpokenClause(start, end, (), ()))
                continue
        them = bool(_THEM.search(small, start, end)) or (them and len(small[start:end].split()) <= 3)
        clause = _clause(
            small, (start, end), (changes, inside, mentions), implied, words, kind, last, them=them
        )
        found.append(_read_alone(text, clause, kind))
        named = [p.part for p in inside if p.part not in ("all", "waist")]
        last = named[-1] if named else last
    found = _joined(small, found, mentions, parts)
    found = _without_what_is_so([_at_the_neck(small, c, is_so) for c in found], is_so)
    clashes = _clashes(found, words, is_so)
    wanted = [change for clause in found for change in clause.changes]
    dropped = {subject for *_, subject in clashes}
    careful = any(claim.name in ("skirt_hem", "top_hem", "leg_hem", "fit") for claim in words.never)
    kept_clauses = tuple(
        [
            SpokenClause(
                c.start,
                c.end,
                tuple([_careful(x, careful) for x in c.changes if subject_of(x) not in dropped | kept]),
                c.left_over,
            )
            for c in found
        ]
    )
    said = {subject_of(change) for change in wanted}
    return SpokenChanges(
        kept_clauses, frozenset(kept - said | (kept & dropped)), tuple([(a, b) for a, b, _ in clashes])
    )


def _read_alone(text: str, clause: SpokenClause, kind: str) -> SpokenClause:
    """A clause whose words something said before outdoes: "it is square; I'd have it boat-shaped"."""
    if clause.changes or not clause.left_over:
        return clause
    words = read_words(text[clause.start : clause.end], kind=kind)
    details = [i for i in words.implications if i.said and i.certainty != "likely" and i.claim.name != "kind"]
    gains = [Gain(i.claim) for i in details if fits_kind(i.claim.name, kind)]
    said = {word for i in details for word in i.mark.word.lower().split()}
    left = tuple([words for words in clause.left_over if not set(re.split(r"[\s-]+", words)) & said])
    return replace(clause, changes=tuple(gains), left_over=left if gains else clause.left_over)


def _at_the_neck(text: str, clause: SpokenClause, is_so: Callable[[Claim], bool]) -> SpokenClause:
    """A collar that is not named: "remove what is around the neck", "the neck is strangling me"."""
    said = text[clause.start : clause.end]
    if clause.changes or not any(p.part == "neck" for p in find_parts(said)) or not _TOO_CLOSE.search(said):
        return clause
    collars = [Claim("collar", kind) for kind in ("stand", "turtleneck", "lapel")]
    if not any(is_so(collar) for collar in collars):
        return clause
    return replace(clause, changes=(Gain(Claim("collar", "none")),), left_over=())


def _joined(
    text: str, found: Sequence[SpokenClause], mentions: Sequence[Mention], parts: Sequence[PartWord]
) -> list[SpokenClause]:
    """Clauses that go together: "sleeves: minus 4 cm", "a bit shorter, like 4 cm", "bigger. No, bigger"."""
    joined: list[SpokenClause] = []
    for k, clause in enumerate(found):
        length = next((m.value for m in mentions if clause.start <= m.start < clause.end and m.is_length), None)
        if not clause.changes and length is not None and joined:
            before = joined[-1]
            if any(isinstance(c, Step) and c.amount is None for c in before.changes):
                steps = [replace(c, amount=length) if isinstance(c, Step) else c for c in before.changes]
                joined[-1] = replace(before, changes=tuple(steps))
                joined.append(replace(clause, left_over=()))
                continue
        named = " ".join(p.word for p in parts if clause.start <= p.start < clause.end)
        if not clause.changes and k + 1 < len(found) and " ".join(clause.left_over) == named:
            clause = replace(clause, left_over=())
        whole = text[clause.start : clause.end].split()
        repeated = [c for c in clause.changes if isinstance(c, Step) and c.quantity in ("chest", "length")]
        if joined and len(whole) == 1 and repeated and len(clause.changes) == 1:
            earlier = [c for one in joined for c in one.changes if isinstance(c, Step)]
            if any(c.direction == repeated[0].direction and c.quantity != repeated[0].quantity for c in earlier):
                clause = replace(clause, changes=())
        joined.append(clause)
    return joined


def _careful(change: Change, careful: bool) -> Change:
    if careful and isinstance(change, Step) and change.amount is None:
        return Step(change.quantity, change.direction, _CAREFUL_CM)
    return change


def _clauses(text: str) -> list[tuple[int, int]]:
    found, start = [], 0
    for joint in _JOINT.finditer(text):
        found.append((start, joint.start()))
        start = joint.end()
    found.append((start, len(text)))
    return [(a, b) for a, b in found if _WORD.search(text, a, b) or any(c.isdigit() for c in text[a:b])]


def _meant(text: str, words: WordReading, kind: str) -> list[Implication]:
    """What the lexicon reads that an instruction can mean: details, and another kind of garment."""
    found = []
    for each in words.implications:
        certain = each.certainty == "certain"
        if each.said and each.certainty != "likely":
            peplum = each.claim.value == "peplum" and kind in ("top", "tunic")
            if fits_kind(each.claim.name, kind) or each.claim.name == "kind" or peplum:
                found.append(each)
        elif certain and not each.said and not _is_pointed_at(text, each.mark):
            found.append(each)
    kinds = [i for i in found if i.claim.name != "kind" or _is_target(text, i.mark, str(i.claim.value), kind)]
    if any(i.claim.name == "kind" for i in kinds):
        return kinds
    return [*kinds, *_after_arrow(text, words, kind)]


def _after_arrow(text: str, words: WordReading, kind: str) -> list[Implication]:
    """What a garment is to become, where its name could be a part of the one that is there: "dress -> top"."""
    for mark in words.marks:
        if mark.role in ("part", "second") and _leads_to(text, mark):
            for entry in mark.entries:
                for each in entry.implied:
                    if each.claim.name == "kind" and each.claim.value != kind:
                        return [Implication(each.claim, "certain", False, mark)]
    return []


def _is_pointed_at(text: str, mark: WordMark) -> bool:
    """Whether a garment is named that is there: "the dress"."""
    return re.search(r"(?<!\w)(?:the|this|that|my|its|these|her|his)\s+(?:(?!(?:in)?to\b|as\b)\w+\s+)?$", text[: mark.start]) is not None


def _is_target(text: str, mark: WordMark, value: str, kind: str) -> bool:
    """Whether the garment is to become another: "into a skirt", "as trousers", or nothing but its name."""
    if value == kind or (value in _PARTS_OF.get(kind, ()) and not _leads_to(text, mark)):
        return False
    return _leads_to(text, mark) or len(_WORD.findall(text)) <= 1


def _leads_to(text: str, mark: WordMark) -> bool:
    return re.search(rf"{target_words()}\s+(?:an?\s+|some\s+|\w+\s+)?$", text[: mark.start]) is not None


def _clause(
    text: str,
    bounds: tuple[int, int],
    seen: tuple[Sequence[ChangeWord], Sequence[PartWord], Sequence[Mention]],
    implied: Sequence[Implication],
    words: WordReading,
    kind: str,
    last: str | None,
    *,
    them: bool,
) -> SpokenClause:
    start, end = bounds
    said = text[start:end]
    grown = [c for c in seen[0] if start <= c.start < end]
    parts = seen[1]
    numbers = [m for m in seen[2] if start <= m.start < end]
    claims = [i for i in implied if start <= i.mark.start < end and not _within(i.mark, grown)]
    if _TAKEN_OUT.search(said):
        claims = []
    details = [i for i in claims if i.mark.entries[0].category != "parts"]
    spans = [(i.mark.start, i.mark.end) for i in details]
    # What is said of a detail is no change: "a low neckline" is not lowered by being called so.
    grown = [c for c in grown if not any(a <= c.start < b for a, b in spans)]
    bare = not grown and not claims and not any(p.part == "slit" for p in parts)
    if bare and (_TO_BE.search(said) or len(said.split()) == 1):
        grown = [c for c in find_adjectives(text) if start <= c.start < end]
    length = next((m.value for m in numbers if m.is_length), None)
    changes: list[Change] = []
    used: list[tuple[int, int]] = []
    for word in grown:
        named = _part_of(word, parts, spans)
        amount = None if numbers and _TO.search(text[: numbers[0].start]) else length
        made: tuple[Change, ...] = () if bare else _hem_shape(said, named, word, kind)
        for part in (named or (last if bare or them else None), last, None):
            made = made or changes_of(part, word.what, word.sign, kind, amount)
        changes += made
        if made or claims:
            used.append((word.start, word.end))
    if not grown and length is not None and _LESS_BY.search(said):
        part = next((p.part for p in parts), last)
        what: Property = "width" if part in ("chest", "waist", "hips", "thigh") else "length"
        changes += changes_of(part, what, -1, kind, length)
    if any(p.part == "tiers" for p in parts) and _STEPS_DOWN.search(said) and not changes:
        changes.append(Step("tiers", -1, 1.0))
    if any(p.part == "slit" for p in parts) and not claims and not changes:
        changes += _slit(said, any(m.denied and start <= m.start < end for m in words.marks))
    stepped = any(isinstance(c, Step) for c in changes)
    changes += [Gain(i.claim) for i in (details if stepped else claims)]
    used += [(p.start, p.end) for p in parts if changes or (p.part == "all" and _is_it(p.word, kind))]
    used += [(i.mark.start, i.mark.end) for i in claims]
    used += [(m.start, m.end) for m in numbers if not m.is_length or any(_has(c, m.value) for c in changes)]
    return SpokenClause(start, end, tuple(dict.fromkeys(changes)), _left_over(text, bounds, used, words))


def _is_it(word: str, kind: str) -> bool:
    """Whether a word can mean the garment that is there."""
    return kind in _NAMED.get(word, {kind})


def _within(mark: WordMark, grown: Sequence[ChangeWord]) -> bool:
    return any(word.start <= mark.start and mark.end <= word.end for word in grown)


def _hem_shape(said: str, part: str | None, word: ChangeWord, kind: str) -> tuple[Change, ...]:
    """A hem that is to be longer on one side alone."""
    if word.what == "width" or part not in (None, "all", "hem", "skirt") or kind in ("trousers", "shorts"):
        return ()
    side = _SIDE.search(said)
    if side is None:
        return ()
    longer = word.sign > 0 if word.what == "length" else word.sign < 0
    if side["left"] or side["right"]:
        return (Gain(Claim("hem_shape", f"lower {'left' if bool(side['left']) == longer else 'right'}")),)
    return (Gain(Claim("hem_shape", "high-low")),) if bool(side["back"]) == longer else ()


def _slit(said: str, denied: bool) -> list[Change]:
    """Where a slit is to be cut, or that it is to be closed."""
    if denied or _CLOSED.search(said):
        return [Gain(Claim("slit", "none"))]
    place = next((name for name, words in _PLACES.items() if re.search(rf"(?<!\w)(?:{words})(?!\w)", said)), None)
    return [] if place is None else [Gain(Claim("slit", place))]


def _has(change: Change, value: float) -> bool:
    number = change.amount if isinstance(change, Step) else change.claim.value
    return isinstance(number, float | int) and abs(number - value) < 0.05


def _part_of(word: ChangeWord, parts: Sequence[PartWord], spans: Sequence[tuple[int, int]]) -> str | None:
    """The part that a word of change is said of: the nearest that is named in its clause."""
    free = [
        p
        for p in parts
        if not any(a <= p.start < b for a, b in spans) and not word.start <= p.start < word.end
    ]
    named = [p for p in free if p.part != "all"]
    if not named:
        return "all" if free else None
    ends = [p.part for p in named if p.part in ("sleeve_end", "leg_end")]
    if ends and word.what == "width":
        return ends[0]
    fitting = sorted(named, key=lambda p: min(abs(p.start - word.end), abs(word.start - p.end)))
    return fitting[0].part


def _left_over(
    text: str, bounds: tuple[int, int], used: Iterable[tuple[int, int]], words: WordReading
) -> tuple[str, ...]:
    """Words of a clause that nothing accounts for, those that stand side by side together."""
    start, end = bounds
    taken = list(used)
    answered = [(lack.mark.start, lack.mark.end) for lack in words.lacks if lack.said]
    taken += answered
    free = []
    for mark in words.marks:
        silent = bool(mark.entries) and mark.entries[0].category in _SILENT
        clothed = any(e.color or e.cloth or e.print or e.shade for e in mark.entries)
        if silent or clothed or mark.denied:
            free.append((mark.start, mark.end))
    taken += free
    missed = []
    for match in _WORD.finditer(text, start, end):
        if is_function_word(match[0]) or any(a <= match.start() < b for a, b in taken):
            continue
        missed.append(match)
    joined: list[list[re.Match[str]]] = []
    for match in missed:
        if joined and text[joined[-1][-1].end() : match.start()].strip(" -") == "":
            joined[-1].append(match)
        else:
            joined.append([match])
    years = [match[0] for match in _YEAR.finditer(text, start, end)]
    return tuple([*[text[group[0].start() : group[-1].end()] for group in joined], *years])


def _without_what_is_so(found: Sequence[SpokenClause], is_so: Callable[[Claim], bool]) -> list[SpokenClause]:
    """Leaves out what is so already where something else is asked of the same thing."""
    changes = [change for clause in found for change in clause.changes]

    hooded = Gain(Claim("hood", "hood")) in changes

    def outdone(change: Change) -> bool:
        if hooded and change == Gain(Claim("collar", "none")):
            return True  # where there is a hood there is no collar to be seen
        return (
            isinstance(change, Gain)
            and any(_oppose(change, other) for other in changes)
            and is_so(change.claim)
        )

    return [replace(c, changes=tuple([x for x in c.changes if not outdone(x)])) for c in found]


def _clashes(
    found: Sequence[SpokenClause], words: WordReading, is_so: Callable[[Claim], bool]
) -> list[tuple[str, str, str]]:
    """Pairs of wishes that exclude each other, in words, with the subject of each."""
    changes = list(dict.fromkeys([change for clause in found for change in clause.changes]))
    clashes = []
    for k, one in enumerate(changes):
        for other in changes[k + 1 :]:
            if _oppose(one, other):
                pair = _in_words(one), _in_words(other)
                clashes += [(*pair, subject_of(one)), (*pair, subject_of(other))]
    for pair in words.contradictions:
        if pair.first.word.lower() == pair.second.word.lower():
            continue  # one that is there, and what becomes of it
        said = [i.claim for i in words.implications if i.mark in (pair.first, pair.second)]
        if any(is_so(claim) for claim in said):
            continue
        for mark in (pair.first, pair.second):
            for name in {i.claim.name for i in words.implications if i.mark is mark}:
                clashes.append((pair.first.word, pair.second.word, name))
    return clashes


_GONE = {"sleeves": ("sleeve length", "sleeve width", "sleeve end"), "hood": ("hood depth", "hood height")}


def _oppose(one: Change, other: Change) -> bool:
    if isinstance(one, Step) and isinstance(other, Step):
        return one.quantity == other.quantity and one.direction != other.direction
    if isinstance(one, Gain) and isinstance(other, Gain):
        return one.claim.name == other.claim.name and exclude(one.claim, other.claim)
    gain, step = (one, other) if isinstance(one, Gain) else (other, one)
    assert isinstance(gain, Gain) and isinstance(step, Step)
    return gain.claim.value == "none" and step.quantity in _GONE.get(gain.claim.name, ())


def _in_words(change: Change) -> str:
    if isinstance(change, Step):
        return f"{'more' if change.direction > 0 else 'less'} {change.quantity}"
    return f"{change.claim.name.replace('_', ' ')}: {change.claim.value}"


def other_than(never: Sequence[Claim], holds: Sequence[Claim], spoken: Iterable[str]) -> tuple[Gain, ...]:
    """What to make instead of what is refused and is so: no slit, no collar, plain sleeves.

    Args:
        never: What a text refuses.
        holds: Of these, what is true of the garment.
        spoken: Names of claims that something else is asked of.
    """
    told = set(spoken)
    found = []
    for claim in holds:
        if claim.name in told or claim not in never:
            continue
        instead = _INSTEAD.get(claim.name, {}).get(str(claim.value))
        if instead is not None:
            found.append(Gain(Claim(claim.name, instead)))
            told.add(claim.name)
    return tuple(found)


_INSTEAD = {
    "sleeve_shape": {v: "slim" for v in ("balloon", "puffed", "bell", "wide")},
    "collar": {v: "none" for v in ("turtleneck", "stand", "lapel")},
    "hood": {"hood": "none"},
    "slit": {v: "none" for v in ("left", "right", "front", "back")},
    "hem_shape": {v: "level" for v in ("scalloped", "pointed", "high-low", "lower left", "lower right")},
    "neckline": {v: "round" for v in ("v", "square", "boat", "trapezoid")},
    "fit": {"oversized": "easy", "loose": "easy", "close": "easy"},
    "shoulders": {"strapless": "both"},
    "skirt_hem": {"micro": "knee", "mini": "knee", "maxi": "midi", "floor": "midi"},
}
"""What is made where only the opposite is said."""
