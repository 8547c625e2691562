"""What an instruction asks for by its words alone: comparisons, details, removals, what is to stay.

Rules and tables, no network. Each clause is read by itself; what of it nothing accounts for is named, and
left to the network that hears how words hang together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.instructions.change_parts import changes_of, is_unsaid, part_of, subjects_of
from swifttailor.wishes.instructions.change_words import (
    ChangeWord,
    find_changes,
    find_parts,
    kept_words,
)
from swifttailor.wishes.instructions.joined_clauses import (
    JOINED,
    is_amount_of,
    is_so_again,
    is_told_by_how_much,
    joined_together,
    said_again,
    with_amount,
)
from swifttailor.wishes.instructions.one_meaning import still_in
from swifttailor.wishes.instructions.spoken_amounts import (
    by_little,
    joined_amount,
)
from swifttailor.wishes.instructions.spoken_clause_words import (
    is_of_lack,
    is_of_parts,
    of_their_parts,
    part_said_of,
    read_clause,
)
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause, clashes_of, without_what_is_so
from swifttailor.wishes.instructions.spoken_places import at_the_neck
from swifttailor.wishes.instructions.spoken_scenes import SpokenScene, spoken_scene
from swifttailor.wishes.instructions.spoken_targets import (
    away,
    beside_no_numbers,
    clauses_of,
    given_away,
    meant,
)
from swifttailor.wishes.instructions.spoken_wholes import of_wholes
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.spoken_sides import blanked, spoken_sides, without_spans
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import Implication, WordReading, read_words
from swifttailor.wording.lexicon.inflection import Language

_THEM = re.compile(r"(?<!\w)(?:them|they|they're|these|those|sie|les|las|los)(?!\w)")
_UNDENIED = re.compile(
    r"(?:(?:in|out|so|too|as|that|overly)(?!\w)"
    r"|(?:dig|pinch|cut|flap|drag|trip|gap|sag|bag|squeez|squash|constrict|ride|bit|fall|show|hang)\w*(?!\w))"
)
"""Words of change that are no less so for a "not": what is "not so tight" is to be wider, and what is not to
flap about narrower."""
_DENIED = re.compile(
    r"(?<!\w)(?:don['’]?t|do not|not|never|without|nicht|pas|non|niet|não)"
    r"(?:\s+\w+){0,2}\s+(?:(?:any|much|even) )?$"
)
_EXCEPT = re.compile(
    r"\s*(?:except(?: for)?|apart from|other than|save for|but not|außer|bis auf|sauf|salvo|excepto"
    r"|tranne|behalve|exceto)(?!\w)"
)
_ALL_STAYS = re.compile(
    r"(?<!\w)(?:(?:everything|all(?: of it)?|the (?:rest|lot)) (?:else )?"
    r"(?:stays?|should stay|can stay|is (?:fine|good|perfect|great))"
    r"|(?:keep|leave) (?:everything|it all|all of it|the rest|the lot)"
    r"|(?:(?:i|we) (?:do |really |quite )?|she |he )(?:like|love|adore)s? "
    r"(?:everything|it all|all of it|the rest|the lot|the whole thing)"
    r"|alles (?:bleibt|so lassen)|tout garder)(?!\w)"
)
"""What is excepted from it is to change: "everything stays apart from the skirt"."""
_BY_ITS_OWN = re.compile(
    r"(?<=, )(?:the |my |her |his |both )?\w+ by (?=\S*\d|an? |one |two |three |four |five )"
)
"""A part with its own number behind another: "lengthen the body by 4 cm, the sleeves by 5 cm"."""
_OWN = re.compile(r"(?<!\w)(?:take|off|remove|lose|add|minus|cut|without|no|give|put|an?)(?!\w)")
"""What a clause itself asks for, which does not go on then: "longer sleeves, and 5 cm off the hem"."""
_GOING_ON = frozenset({"sleeves", "legs"})
"""Parts that a clause without one goes on about, even where they were not compared with what they were."""
_ONES = frozenset({"skirt", "collar", "hood", "band"})
"""Parts that "it" can mean where they were changed just before: "lengthen the skirt and taper it"."""
_PRONOUNS = frozenset({"it", "them", "es"})
_OF_SCENES = frozenset({"shoulders", "sleeves", "neck", "collar"})


@dataclass(frozen=True)
class SpokenChanges:
    """What an instruction asks for by its words."""

    clauses: tuple[SpokenClause, ...]
    kept: frozenset[str]
    """Claims and quantities that are to stay as they are."""
    clashes: tuple[tuple[str, str], ...]
    """What asks for opposite things, in words; none of it counts."""
    taken: tuple[tuple[str, tuple[Change, ...]], ...] = ()
    """Vague words, and what they are taken to mean."""
    disputed: frozenset[str] = frozenset()
    """Claims and quantities that opposite things are asked of."""

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
    sides = spoken_sides(text)
    small, words = blanked(text.lower(), sides.spans), without_spans(words, sides.spans)
    them = False
    changes, parts, mentions = find_changes(small), find_parts(small), find_mentions(small)
    implied = meant(small, words, kind)
    gone = given_away(small, implied)
    implied = [each for each in implied if each not in gone]
    given_up: list[SpokenClause] = []
    if gone:
        implied, given_up = _in_their_place(small, words, kind, implied, gone)
    bounds = clauses_of(small, words.language)
    found = given_up + [
        SpokenClause(a, b, (Gain(claim),), ())
        for claim, (a, b) in zip(sides.claims, sides.spans, strict=True)
    ]
    kept: set[str] = set()
    last: str | None = None
    spoken_of: str | None = None
    taken: list[tuple[str, tuple[Change, ...]]] = []
    vague: tuple[int, SpokenScene] | None = None
    stays = excepted = compared = False
    grown: list[ChangeWord] = []
    for start, end in bounds:
        inside = [p for p in parts if start <= p.start < end]
        whole = of_wholes(small[start:end], (), kind, is_so)
        if stays and inside and _EXCEPT.match(small, start, end):
            named = [p.part for p in inside if p.part != "all"]
            last = spoken_of = named[-1] if named else last
            stays, excepted = False, True
            if not any(start <= c.start < end for c in changes):
                continue
        stays = bool(_ALL_STAYS.search(small, start, end))
        if not whole and not excepted and kept_words().search(small, start, end):
            for part in inside:
                kept |= subjects_of(part.part)
                if part.word.endswith(
                    ("length", "länge", "longueur", "largo", "lunghezza", "lengte", "comprimento")
                ):
                    kept |= {"length", "leg length"}
            if not any(start <= c.start < end for c in changes):
                kept_gains = [i.claim.name for i in implied if start <= i.mark.start < end]
                kept.update(kept_gains)
                found.append(SpokenClause(start, end, (), ()))
                continue
        them = bool(_THEM.search(small, start, end)) or (them and len(small[start:end].split()) <= 3)
        denied = [c for c in changes if start <= c.start < end and _DENIED.search(small[start : c.start])]
        denied = [c for c in denied if not _UNDENIED.match(small, c.start)]
        for word in denied:
            near = part_said_of(word, inside, ())
            kept |= {subject_of(c) for c in changes_of(near or last, word.what, word.sign, kind, None)}
        said = [c for c in changes if c not in denied]
        scene = spoken_scene(small, (start, end), [p.part for p in inside], kind, is_so, of_parts=True)
        if scene is not None and not any(p.part in _OF_SCENES for p in inside):
            scene = None
        if scene is not None and not said:
            taken.append((text[scene.start : scene.end], scene.changes))
            found.append(SpokenClause(start, end, scene.changes, ()))
            last = next(p.part for p in inside if p.part in _OF_SCENES)
            continue
        joined = bool(JOINED.search(small, 0, start)) or _BY_ITS_OWN.search(small, start, end) is not None
        if (
            joined
            and grown
            and not _OWN.search(small, start, end)
            and not any(start <= c.start < end for c in said)
            and is_of_parts(small, (start, end), inside)
        ):
            length = next((m.value for m in mentions if start <= m.start < end and m.is_length), None)
            own = length if found and not any(map(is_unsaid, found[-1].changes)) else None
            if length is not None and found:
                found[-1] = joined_amount(found[-1], length)
            more = said_again(inside, grown, found, kind, own)
            if more:
                found.append(SpokenClause(start, end, more, ()))
                continue
        goes_on = last is not None and last == spoken_of and (joined or excepted)
        grown = [c for c in said if start <= c.start < end]
        # "Elbow sleeves and 10 cm longer": their length is said already, so the garment is meant.
        goes_on = goes_on and (compared or excepted or all(c.what == "width" for c in grown))
        excepted = False
        if last == "slit" and Gain(Claim("slit", "none")) in [c for f in found for c in f.changes]:
            # "No slit, and a bit longer" makes the garment longer.
            last = None if all(c.what == "length" for c in grown) else last
        if goes_on and last in _ONES and inside and all(p.word == "it" for p in inside):
            inside = []
        clause = read_clause(
            small,
            (start, end),
            (said, inside, mentions),
            implied,
            words,
            kind,
            last,
            is_so,
            them=them or (goes_on and not inside),
        )
        clause = _read_alone(text, clause, kind, still_in(words.language))
        by = next((m for m in mentions if start <= m.start < end and m.is_length), None)
        of_it = bool(inside) and all(p.word in _PRONOUNS for p in inside)
        if of_it and found and grown and is_so_again(grown, clause, found[-1]):
            # "The waist pinches, let it out": the waist, and no hem besides.
            found[-1] = found[-1] if by is None else with_amount(small, found[-1], by)
            clause = replace(clause, changes=(), left_over=())
        if by is not None and not inside and found and is_amount_of(small[start:end], clause, found[-1]):
            found[-1] = with_amount(small, found[-1], by)
            clause = replace(clause, changes=(), left_over=())
        if denied and not clause.changes:
            clause = replace(clause, left_over=())
        if vague is None and all(isinstance(c, Gain) and is_so(c.claim) for c in clause.changes):
            scene = spoken_scene(small, (start, end), [p.part for p in inside], kind, is_so)
            vague = None if scene is None else (len(found), scene)
        found.append(clause)
        named = [p.part for p in inside if p.part not in ("all", "waist")]
        last = named[-1] if named else last
        if named:
            # Behind "a V neck and" and "a stand collar and" all of the garment is to be longer.
            made = {part_of(subject_of(c)) for c in clause.changes if isinstance(c, Gain)} & _GOING_ON
            stepped = any(isinstance(change, Step) for change in clause.changes)
            spoken_of, compared = (last if stepped or last in made else None), stepped
    if vague is not None and all(isinstance(c, Gain) and is_so(c.claim) for f in found for c in f.changes):
        at, scene = vague  # where nothing else is asked for: "for a summer wedding" asks for no other hem
        found[at] = replace(found[at], changes=scene.changes, left_over=())
        taken.append((text[scene.start : scene.end], scene.changes))
    found = joined_together(small, found, mentions, parts, kind)
    found = without_what_is_so([at_the_neck(small, c, is_so) for c in found], is_so)
    clashes = clashes_of(found, words, is_so, [*[(c.start, c.end) for c in changes], *away(small)])
    wanted = [change for clause in found for change in clause.changes]
    dropped = {subject for *_, subject in clashes}
    careful = any(
        claim.name in ("skirt_hem", "top_hem", "leg_hem", "fit") and not is_so(claim) for claim in words.never
    )
    kept_clauses = tuple(
        [
            SpokenClause(
                c.start,
                c.end,
                tuple(
                    [
                        by_little(x) if careful and not is_told_by_how_much(x, wanted) else x
                        for x in c.changes
                        if subject_of(x) not in dropped | kept
                    ]
                ),
                c.left_over,
            )
            for c in found
        ]
    )
    said = {subject_of(change) for change in wanted}
    return SpokenChanges(
        kept_clauses,
        frozenset(kept - said | (kept & dropped)),
        tuple(dict.fromkeys([(a, b) for a, b, _ in clashes])),
        tuple(taken),
        frozenset(dropped),
    )


def _in_their_place(
    text: str, words: WordReading, kind: str, implied: list[Implication], gone: Sequence[Implication]
) -> tuple[list[Implication], list[SpokenClause]]:
    """What is to take the place of something else, where that outdid it: "turn the hood into a turtleneck".

    Returns:
        What the lexicon reads without what goes, and the clauses of what is taken off for it.
    """
    if not implied:
        rest = read_words(blanked(text, away(text)), kind=kind, language=words.language)
        implied = meant(text, rest, kind)
    names = {each.claim.name for each in implied}
    off = [
        SpokenClause(each.mark.start, each.mark.end, (Gain(Claim(each.claim.name, "none")),), ())
        for each in gone
        if implied and each.claim.name in ("hood", "collar", "cuffs") and each.claim.name not in names
    ]
    return implied, off


def _read_alone(text: str, clause: SpokenClause, kind: str, language: Language | None) -> SpokenClause:
    """A clause whose words something said before outdoes: "it is square; I'd have it boat-shaped"."""
    if clause.changes or not clause.left_over:
        return clause
    words = read_words(text[clause.start : clause.end], kind=kind, language=language)
    implied = beside_no_numbers(text[clause.start : clause.end].lower(), words.implications)
    details = [i for i in implied if i.said and i.certainty != "likely" and i.claim.name != "kind"]
    details = [i for i in details if not is_of_lack(text[clause.start : clause.end].lower(), i.mark, words)]
    said_of = find_parts(text[clause.start : clause.end].lower())
    if find_changes(text[clause.start : clause.end].lower()):  # nothing becomes of "longer straps"
        named = {(clause.start + p.start, clause.start + p.end) for p in said_of}
        details = [
            i for i in details if (clause.start + i.mark.start, clause.start + i.mark.end) not in named
        ]
    details, _ = of_their_parts(text[clause.start : clause.end].lower(), details, said_of)
    gains = [Gain(i.claim) for i in details if fits_kind(i.claim.name, kind)]
    said = {word for i in details for word in i.mark.word.lower().split()}
    left = tuple([words for words in clause.left_over if not set(re.split(r"[\s-]+", words)) & said])
    return replace(clause, changes=tuple(gains), left_over=left if gains else clause.left_over)
