"""What one clause of an instruction asks for by its words alone."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.wishes.instructions.change_parts import Property, changes_of, part_of
from swifttailor.wishes.instructions.change_words import (
    ChangeWord,
    PartWord,
    find_adjectives,
)
from swifttailor.wishes.instructions.parts_of_shapes import part_of_shape
from swifttailor.wishes.instructions.spoken_amounts import (
    SIGNED,
    counts,
    is_bare_cm,
    is_more_by,
    is_target,
    more_of_them,
    to_target,
)
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause
from swifttailor.wishes.instructions.spoken_of import is_lacking
from swifttailor.wishes.instructions.spoken_places import hem_shape, slit, slit_step
from swifttailor.wishes.instructions.spoken_wholes import lacking, of_wholes
from swifttailor.wishes.instructions.words_left_over import left_over
from swifttailor.wishes.text.mentions import Mention
from swifttailor.wishes.text.unread import is_function_word
from swifttailor.wording.lexicon import Implication, WordMark, WordReading

_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
_LESS_BY = re.compile(
    r"(?<!\w)(?:off|minus|less|weniger|weg|take|shorten|remove|meno|minder|accorcia|encurta)(?!\w)|(?<!\d)-\s*\d"
)
_PLACES = re.compile(r"(?:(?:front|back|side|sides|left|right|centre|center|top|bottom|hem)(?:\s|$))+")
_GRIP = re.compile(r"(?<!\w)(?:tight|loose|snug|eng|weit|locker|serr|ajust)")
"""Of a cuff or a band these speak of its girth, where "wider" speaks of its height."""
_BITES = re.compile(r"(?<!\w)(?:dig|digs|digging|pinch\w*|cuts?|squeez\w*|constrict\w*|bites?)(?!\w)")
_EACH = re.compile(r"(?<!\w)(?:(?:on )?(?:each|either|both) sides?|per side)(?!\w)")
_VERY = re.compile(r"(?<!\w)(?:super|very|really|extra|much|way|even|muy|très|sehr)(?!\w)")
"""Of what is so already there is to be more: "super wide legs" of wide ones."""
_WITH_LEGS = frozenset(["trousers", "shorts", "jumpsuit", "playsuit"])
_NAMED = {
    **dict.fromkeys(["pants", "trousers", "hose", "pantalon", "pantalón", "shorts"], _WITH_LEGS),
    **dict.fromkeys(["dress", "kleid", "robe", "vestido"], frozenset(["dress", "tunic", "jumpsuit"])),
    **dict.fromkeys(
        ["top", "shirt", "blouse", "jumper", "sweater", "hoodie"], frozenset(["top", "tunic", "dress"])
    ),
}
"""Kinds that a name of a garment can mean where one is there already."""
_OF_HEMS = frozenset(
    "sweep flare swing vuelo poofy puffy full fuller flared flarey swishy swishier billowy voluminous frilly "
    "ruffly flouncy poofier puffier floatier flowy a-line gathered".split()
)
"""What is said of a skirt, where no part is named."""
_PRONOUNS = frozenset({"it", "them", "es", "ihn"})
_EVERYWHERE = frozenset({"all", "waist", "hips", "chest", "hem", "back", "lower"})
"""Where something is said of a garment; straps that are to be longer lengthen no dress."""
_DEEP = frozenset({"hood", "collar", "cuffs", "band", "armholes", "back", "back_neck"})
"""What "too shallow" is said of where it was spoken of just before, and not of the neckline."""
_GIRTHS = frozenset({"chest", "waist", "hips", "thigh", "armholes", "shoulders", "leg_end", "sleeve_end"})
_AROUND = re.compile(r"flare|(?<!\w)(?:sweep|circumference|girth)(?!\w)")
_TAKEN_OUT = re.compile(r"(?<!\w)(?:take|get|pull|taking)(?!\w)[^.]*(?<!\w)out(?!\w)")
_EVERYTHING = re.compile(
    r"(?<!\w)(?:everything|everywhere|all over|throughout|the whole thing|every part"
    r"|alles|überall|tout|partout|todo|tutto|overal|tudo)(?!\w)"
)
_LACKED = frozenset({"waistband height", "waistband width", "sleeve width", "sleeve length"})
_LOWERS = frozenset({"skirt", "trousers", "shorts"})
_SKIRTED = frozenset({"dress", "skirt"})
_FROM_THERE = re.compile(
    r"(?<!\w)(?:(?:below|above) (?:the )?(?:knees?|elbows?|waist|hips?|thighs?|ankles?)"
    r" (?:down|downwards|up|upwards)"
    r"|from (?:the )?(?:knees?|elbows?|waist|hips?|thighs?|ankles?)(?: (?:down|downwards|up|upwards))?)(?!\w)"
)
"""Where along a part it is to change, and no length: "in from the knee down"."""
_NARROWED_AT = re.compile(
    r"(?<!\w)(?:below|above|at|around|round|near|over|across|through|on|in) (?:the |my |her )"
    r"(?:knees?|elbows?|thighs?|calf|calves|ankles?|shins?|wrists?)(?!\w)"
)
"""The same where something is to be wider or narrower there: "narrow the legs below the knee"."""
_AT_A_PLACE = re.compile(
    r"(?:on|at|round|around|over|across|in) (?:the |my |her )?(?:hips?|waist|bust|chest|knees?|thighs?)(?!\w)"
)
"""Where something is to be wider or longer, and not where the garment is to sit: "bigger on the hips"."""
_OPENED = re.compile(r"(?<!\w)(?:open|opened|opening)(?!\w)")
_DRAGS = re.compile(
    r"(?<!\w)(?:drag|drags|dragging|trip|tripping|sweeps|sweeping|trails|trailing)(?!\w)[^.;]*(?<!\w)(?:floor|ground)(?!\w)"
)
"""What reaches the floor and is not to."""
_RUFFLES = re.compile(r"(?<!\w)(?:ruffles?|ruffled|ruffels?|flounces?|flounced|frills?|frilly|frilled)(?!\w)")
_UPPER = frozenset(
    {"sleeves", "sleeve_end", "cuffs", "neck", "collar", "shoulders", "hood", "straps", "armholes"}
)
_TO_BE = re.compile(
    r"(?<!\w)(?:make|made|be|become|want|wants|need|prefer|should|mach|rends|haz|rendi|maak|vorrei|faz|faça|deixa|deixe)(?!\w)"
)
_HUGE = re.compile(r"(?<!\w)(?:huge|enormous|massive|gigantic|giant|big|large)(?!\w)")
_BALLOON = Claim("sleeve_shape", "balloon")
"""What "huge sleeves" are called; on an edit they are to be wider than they are."""
_STEPS_DOWN = re.compile(r"(?<!\w)(?:off|away|remove|take|lose|without|weniger|weg)(?!\w)")


def read_clause(
    text: str,
    bounds: tuple[int, int],
    seen: tuple[Sequence[ChangeWord], Sequence[PartWord], Sequence[Mention]],
    implied: Sequence[Implication],
    words: WordReading,
    kind: str,
    last: str | None,
    is_so: Callable[[Claim], bool],
    *,
    them: bool,
) -> SpokenClause:
    """Reads one clause.

    Args:
        text: All of the instruction, in lower case.
        bounds: From where to where in it the clause goes.
        seen: Words of change that count, parts named in the clause, numbers of the text.
        implied: What the lexicon reads in the text.
        words: By the lexicon.
        kind: Of the garment to change.
        last: The part spoken of before.
        is_so: Whether a claim is true of the garment.
        them: Whether the clause speaks of several things that were named before.
    """
    start, end = bounds
    said = text[start:end]
    grown = [c for c in seen[0] if start <= c.start < end]
    parts = list(seen[1])
    numbers = [m for m in seen[2] if start <= m.start < end]
    claims = [i for i in implied if start <= i.mark.start < end and not _within(i.mark, grown)]
    claims = [i for i in claims if not is_of_lack(text, i.mark, words)]
    if _TAKEN_OUT.search(said):
        claims = []
    places = [m.span() for m in _FROM_THERE.finditer(text, start, end)]
    if any(c.what == "width" for c in grown) or (kind in _SKIRTED and _OPENED.search(said)):
        places += [m.span() for m in _NARROWED_AT.finditer(text, start, end)]
    claims = [i for i in claims if not any(a <= i.mark.start < b for a, b in places)]
    grown = [c for c in grown if not any(a <= c.start < b for a, b in places)]
    if (drags := _DRAGS.search(said)) is not None:
        claims = [i for i in claims if i.claim.name not in ("skirt_hem", "leg_hem")]
        places.append((start + drags.start(), start + drags.end()))
    claims, ruffled = of_their_parts(said, claims, parts)
    details = [i for i in claims if i.mark.entries[0].category != "parts"]
    spans = [(i.mark.start, i.mark.end) for i in details if not _is_bare(i.mark, parts)]
    if not _DRAGS.search(said):
        shapes = [m for m in words.marks if start <= m.start < end and _is_of_shape(m)]
        spans += [(m.start, m.end) for m in shapes if not _within(m, grown)]
    # What is said of a detail is no change: "a low neckline" is not lowered by being called so.
    grown = [c for c in grown if not any(a <= c.start < b for a, b in spans)]
    if grown:
        if any(c.what != "height" for c in grown):
            claims = [i for i in claims if not _AT_A_PLACE.match(i.mark.word.lower())]
        details = [i for i in details if i in claims]
        # "a deeper V" of a V neck and "smaller puffed sleeves" of puffed ones name what is there.
        so = [i for i in details if is_so(i.claim)]
        claims = [i for i in claims if i not in so]
        told = [(i.mark, part) for i in details if (part := part_of(i.claim.name)) is not None]
        details = [i for i in details if i not in so]
        if not any(p.part != "all" for p in parts):
            parts += [PartWord(mark.start, mark.end, part, mark.word) for mark, part in told]
            spans = [(a, b) for a, b in spans if not any(p.start == a for p in parts)]
    if not grown and claims and _VERY.search(said) and all(is_so(i.claim) for i in claims):
        grown, claims, details = [c for c in find_adjectives(text) if start <= c.start < end], [], []
        parts = [p for p in parts if p.part != "slit"]
    bare = not grown and not claims and not any(p.part == "slit" for p in parts)
    denied = any(m.denied and start <= m.start < end for m in words.marks)
    if bare and (_TO_BE.search(said) or (not denied and _is_plain(text, bounds, parts))):
        lengths = {m.end for m in numbers if m.is_length}  # "60 cm long" is a measure and no change
        grown = [c for c in find_adjectives(text) if start <= c.start < end]
        grown = [c for c in grown if len(text[: c.start].rstrip(" -")) not in lengths]
        grown = [c for c in grown if not any(a <= c.start < b for a, b in spans)]
    if not parts and last in ("sleeves", "legs") and not grown:
        # "The arms are cold, make it long": what was spoken of before is meant.
        plain = find_adjectives(text)
        meant = [i for i in claims if any(c.start == i.mark.start and c.end == i.mark.end for c in plain)]
        if meant and len(meant) == len(claims):
            grown = [c for c in plain if start <= c.start < end]
            claims, details, bare = [], [], True
    signed = next((m.value for m in numbers if SIGNED.search(text[: m.start]) or is_bare_cm(text, m)), None)
    length = next((m.value for m in numbers if m.is_length), signed)
    changes: list[Change] = []
    used: list[tuple[int, int]] = list(places)
    missed: list[str] = []
    for word in grown:
        named = part_said_of(word, parts, spans)
        target = next((m for m in numbers if is_target(text, m)), None)
        amount = None if target is not None else length
        if amount is not None and _EACH.search(said) and word.what == "width":
            amount *= 2
        made: tuple[Change, ...] = () if bare else hem_shape(said, named, word, kind, amount)
        if named in (None, "all") and not them:
            named = part_of_shape(text[word.start : word.end], kind, is_so) or named
        if named in (None, "all") and kind in _SKIRTED and not (them or (bare and last)):
            if set(text[word.start : word.end].split()) & _OF_HEMS:
                named = "hem"
        spoken_of = last if named in (None, "all") and all(p.word in _PRONOUNS for p in parts) else named
        if spoken_of == "slit" and not made:
            made = slit_step(word, is_so, amount)
        others = (last, None) if named in (None, *_EVERYWHERE) and not is_lacking(named, kind) else ()
        of_last = bare or them or (word.what == "depth" and last in _DEEP)
        for part in (named or (last if of_last else None), *others):
            made = made or changes_of(part, word.what, word.sign, kind, amount)
        if (
            named in (None, "all")
            and word.what == "length"
            and _EVERYTHING.search(said)
            and kind not in _LOWERS
        ):
            if not is_so(Claim("sleeves", "none")):
                made += changes_of("sleeves", "length", word.sign, kind, amount)
        if named == "cuffs" and _GRIP.search(text[word.start : word.end]):
            made = (Step("cuff opening", word.sign, amount),)
        if named == "band" and (_GRIP.search(said[word.start - start :]) or _BITES.search(said)):
            made = changes_of("waist", "width", word.sign, kind, amount)
        made = made if target is None else to_target(made, target)
        changes += made
        others_said = [i for i in details if not _is_bare(i.mark, parts)]
        if made or others_said or (claims and named is None):
            used.append((word.start, word.end))
            if word.verb is not None:
                used.append(word.verb)
        else:
            missed.append(text[word.start : word.end])
    if missed and not changes:
        claims = others_said  # nothing becomes of "longer straps", and straps are there
    if len(grown) == 1 and "&" in said and changes:
        for part in {p.part for p in parts if p.part != "all"}:
            changes += changes_of(part, grown[0].what, grown[0].sign, kind, length)
    sign = -1 if _LESS_BY.search(said) else 1 if is_more_by(text, numbers) else 0
    if not grown and length is not None and sign:
        for part in dict.fromkeys(
            [p.part for p in parts if p.part != "all"] or [p.part for p in parts] or [last]
        ):
            what: Property = "width" if part in _GIRTHS or _is_around(parts, said) else "length"
            each = 2 if what == "width" and _EACH.search(said) else 1
            changes += changes_of(part, what, sign, kind, each * length)
            if part in (None, "all") and what == "length" and _EVERYTHING.search(said):
                changes += changes_of("sleeves", what, sign, kind, length)
    counted = more_of_them(said)
    whole = of_wholes(said, grown, kind, is_so) or ruffled
    others = [i for i in claims if i.claim.name not in ("waistband", "sleeves") or _is_length_of_sleeves(i)]
    if not others and all(isinstance(c, Step) and c.quantity in _LACKED for c in changes):
        whole = whole or lacking(said, is_so)  # the "narrow" of a band to be added narrows nothing
    if counted or whole:
        # What is said of all of it is said of none of its parts: "drop the waist" of a skirt.
        changes, claims, details = [*counted, *whole], [], []
        used += [(m.start(), m.end()) for m in _WORD.finditer(text, start, end) if whole or counts(m[0])]
    if (
        any(p.part == "tiers" and not p.word.endswith("s") for p in parts)
        and _STEPS_DOWN.search(said)
        and not changes
    ):
        changes.append(Step("tiers", -1, 1.0))
    if any(p.part == "slit" for p in parts) and not claims and not changes:
        changes += slit(said, any(m.denied and start <= m.start < end for m in words.marks))
    if _HUGE.search(said) and any(i.claim == _BALLOON for i in claims):
        changes.append(Step("sleeve width", 1))
        used += [(i.mark.start, i.mark.end) for i in claims]
        claims, details = (
            [i for i in claims if i.claim != _BALLOON],
            [i for i in details if i.claim != _BALLOON],
        )
    stepped = any(isinstance(c, Step) for c in changes)
    changes += [Gain(i.claim) for i in (details if stepped else claims)]
    used += [(p.start, p.end) for p in parts if changes or (p.part == "all" and _is_it(p.word, kind))]
    used += [(i.mark.start, i.mark.end) for i in claims]
    used += [(m.start, m.end) for m in numbers if not m.is_length or any(_has(c, m.value) for c in changes)]
    left = left_over(text, bounds, used, words)
    if changes or any(lack.said and start <= lack.mark.start < end for lack in words.lacks):
        left = tuple([phrase for phrase in left if not _PLACES.fullmatch(phrase)])
    slits = any(isinstance(c, Gain) and c.claim.name == "slit" and c.claim.value != "none" for c in changes)
    if slits and length is not None:
        changes.append(Gain(Claim("slit_cm", round(length, 2))))
    if not changes and not any(word in phrase for word in missed for phrase in left):
        left = (*left, *missed)
    return SpokenClause(start, end, tuple(dict.fromkeys(changes)), left)


def of_their_parts(
    said: str, claims: list[Implication], parts: Sequence[PartWord]
) -> tuple[list[Implication], tuple[Change, ...]]:
    """What a clause says of the skirt, where it names none and another part: "ruffles at the sleeves"."""
    named = {p.part for p in parts} - {"all", "hem"}
    if not named or not named <= _UPPER:
        return claims, ()
    kept = [i for i in claims if i.claim.name != "skirt"]
    denied = _STEPS_DOWN.search(said) or re.search(r"(?<!\w)(?:no|not|fewer|instead)(?!\w)", said)
    ruffled = _RUFFLES.search(said) and named <= {"sleeves", "sleeve_end", "cuffs"} and not denied
    return kept, (Gain(Claim("cuffs", "flounce")),) if ruffled else ()


def is_of_parts(text: str, bounds: tuple[int, int], parts: Sequence[PartWord]) -> bool:
    """Whether a clause is nothing but names of parts: "and the hem" behind "shorten the sleeves"."""
    named = [p for p in parts if p.part != "all"]
    spans = [(p.start, p.end) for p in named]
    return bool(named) and all(
        is_function_word(m[0]) or any(a <= m.start() < b for a, b in spans)
        for m in _WORD.finditer(text, *bounds)
    )


def _is_plain(text: str, bounds: tuple[int, int], parts: Sequence[PartWord]) -> bool:
    """Whether a clause is nothing but parts and adjectives: "tight on the bottom"."""
    spans = [(p.start, p.end) for p in parts] + [(c.start, c.end) for c in find_adjectives(text)]
    others = [
        m[0]
        for m in _WORD.finditer(text, *bounds)
        if not is_function_word(m[0]) and not any(a <= m.start() < b for a, b in spans)
    ]
    return not others


def _is_around(parts: Sequence[PartWord], said: str) -> bool:
    """Whether a number is of the girth of a part."""
    return any(p.word.startswith(("bicep", "upper arm")) for p in parts) or bool(_AROUND.search(said))


def is_of_lack(text: str, mark: WordMark, words: WordReading) -> bool:
    """Whether a word says what something is to be like that cannot be made: the "big" of big pockets."""
    behind = [lack.mark for lack in words.lacks if lack.said and lack.mark.start >= mark.end]
    return any(not text[mark.end : other.start].strip() for other in behind)


def _is_of_shape(mark: WordMark) -> bool:
    """Whether several words name a shape together: the "dropped" of a dropped waist drops nothing."""
    return " " in mark.word and any(e.claims("certain") for e in mark.entries)


def _is_it(word: str, kind: str) -> bool:
    """Whether a word can mean the garment that is there."""
    return kind in _NAMED.get(word, {kind})


def _within(mark: WordMark, grown: Sequence[ChangeWord]) -> bool:
    """Whether a word is compared, with or without its part: the "tight sleeves" of less tight ones."""
    return any(word.start <= mark.start and mark.end <= word.end for word in grown) or _begins_within(
        mark, grown
    )


def _is_length_of_sleeves(implied: Implication) -> bool:
    """Whether it says how long sleeves are to be, and not only that there are some."""
    return implied.claim.name == "sleeves" and implied.mark.entries[0].category != "parts"


def _is_bare(mark: WordMark, parts: Sequence[PartWord]) -> bool:
    """Whether a word is nothing but the name of a part."""
    return any(part.start == mark.start and part.end == mark.end for part in parts)


def _begins_within(mark: WordMark, grown: Sequence[ChangeWord]) -> bool:
    return any(word.start < mark.start < word.end for word in grown)


def _has(change: Change, value: float) -> bool:
    number = change.amount if isinstance(change, Step) else change.claim.value
    return isinstance(number, float | int) and abs(number - value) < 0.05


def part_said_of(word: ChangeWord, parts: Sequence[PartWord], spans: Sequence[tuple[int, int]]) -> str | None:
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
