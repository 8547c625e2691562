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
from swifttailor.wishes.change_parts import changes_of, subjects_of
from swifttailor.wishes.change_words import (
    PartWord,
    find_changes,
    find_parts,
    kept_words,
)
from swifttailor.wishes.mentions import Mention, find_mentions
from swifttailor.wishes.spoken_amounts import (
    by_little,
    joined_amount,
)
from swifttailor.wishes.spoken_clause_words import part_said_of, read_clause
from swifttailor.wishes.spoken_clauses import SpokenClause, clashes_of, without_what_is_so
from swifttailor.wishes.spoken_places import at_the_neck
from swifttailor.wishes.spoken_scenes import SpokenScene, spoken_scene
from swifttailor.wishes.spoken_targets import clauses_of, given_away, meant
from swifttailor.wishes.spoken_wholes import of_wholes
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import WordReading, read_words

_THEM = re.compile(r"(?<!\w)(?:them|they|sie|les|las|los)(?!\w)")
_UNDENIED = re.compile(r"(?:in|out|so|too|as|that|overly)(?!\w)")
"""Words of change that are no less so for a "not": what is "not so tight" is to be wider."""
_DENIED = re.compile(r"(?<!\w)(?:don['’]?t|do not|not|never|without|nicht|pas)(?:\s+\w+){0,2}\s+$")
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
    implied = meant(small, words, kind)
    gone = given_away(small, implied)
    implied = [each for each in implied if each not in gone]
    bounds = clauses_of(small)
    found: list[SpokenClause] = []
    kept: set[str] = set()
    last: str | None = None
    taken: list[tuple[str, tuple[Change, ...]]] = []
    vague: tuple[int, SpokenScene] | None = None
    for start, end in bounds:
        inside = [p for p in parts if start <= p.start < end]
        whole = of_wholes(small[start:end], (), kind, is_so)
        if not whole and kept_words().search(small, start, end):
            for part in inside:
                kept |= subjects_of(part.part)
                if part.word.endswith(("length", "länge", "longueur", "largo")):
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
        clause = read_clause(
            small, (start, end), (said, inside, mentions), implied, words, kind, last, is_so, them=them
        )
        clause = _read_alone(text, clause, kind)
        if denied and not clause.changes:
            clause = replace(clause, left_over=())
        if vague is None and all(isinstance(c, Gain) and is_so(c.claim) for c in clause.changes):
            scene = spoken_scene(small, (start, end), [p.part for p in inside], kind, is_so)
            vague = None if scene is None else (len(found), scene)
        found.append(clause)
        named = [p.part for p in inside if p.part not in ("all", "waist")]
        last = named[-1] if named else last
    if vague is not None and all(isinstance(c, Gain) and is_so(c.claim) for f in found for c in f.changes):
        at, scene = vague  # where nothing else is asked for: "for a summer wedding" asks for no other hem
        found[at] = replace(found[at], changes=scene.changes, left_over=())
        taken.append((text[scene.start : scene.end], scene.changes))
    found = _joined(small, found, mentions, parts)
    found = without_what_is_so([at_the_neck(small, c, is_so) for c in found], is_so)
    clashes = clashes_of(found, words, is_so)
    wanted = [change for clause in found for change in clause.changes]
    dropped = {subject for *_, subject in clashes}
    careful = any(claim.name in ("skirt_hem", "top_hem", "leg_hem", "fit") for claim in words.never)
    kept_clauses = tuple(
        [
            SpokenClause(
                c.start,
                c.end,
                tuple(
                    [by_little(x) if careful else x for x in c.changes if subject_of(x) not in dropped | kept]
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
        tuple([(a, b) for a, b, _ in clashes]),
        tuple(taken),
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


def _joined(
    text: str, found: Sequence[SpokenClause], mentions: Sequence[Mention], parts: Sequence[PartWord]
) -> list[SpokenClause]:
    """Clauses that go together: "sleeves: minus 4 cm", "a bit shorter, like 4 cm", "bigger. No, bigger"."""
    joined: list[SpokenClause] = []
    for k, clause in enumerate(found):
        length = next(
            (m.value for m in mentions if clause.start <= m.start < clause.end and m.is_length), None
        )
        if not clause.changes and length is not None and joined:
            before = joined[-1]
            if any(isinstance(c, Step) and c.amount is None for c in before.changes):
                joined[-1] = joined_amount(before, length)
                joined.append(replace(clause, left_over=()))
                continue
        named = " ".join(p.word for p in parts if clause.start <= p.start < clause.end)
        if not clause.changes and k + 1 < len(found) and " ".join(clause.left_over) == named:
            clause = replace(clause, left_over=())
        whole = text[clause.start : clause.end].split()
        repeated = [c for c in clause.changes if isinstance(c, Step) and c.quantity in ("chest", "length")]
        if joined and len(whole) == 1 and repeated and len(clause.changes) == 1:
            earlier = [c for one in joined for c in one.changes if isinstance(c, Step)]
            if any(
                c.direction == repeated[0].direction and c.quantity != repeated[0].quantity for c in earlier
            ):
                clause = replace(clause, changes=())
        joined.append(clause)
    return joined
