"""What a network reads in clauses that words leave open, and whether that can be meant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from swifttailor.describing.differences import Change, Gain, subject_of
from swifttailor.wishes.corrections.sureness import sure_wishes
from swifttailor.wishes.instructions.change_parts import subjects_of
from swifttailor.wishes.instructions.change_words import find_adjectives, find_changes, find_parts
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause
from swifttailor.wishes.instructions.whole_instruction import MEANT
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.text.text_as_read import ENGLISH
from swifttailor.wishes.text.unread import not_understood
from swifttailor.wishes.trims.trims_spoken_of import speaks_of_trims_alone
from swifttailor.wording.lexicon import WordReading


def is_read_otherwise(gain: Change, whole: Mapping[Change, float]) -> bool:
    """Whether a network reads the same of a thing with another value: below the knee for "at the knee"."""
    return isinstance(gain, Gain) and any(
        chance >= MEANT
        for other, chance in whole.items()
        if isinstance(other, Gain)
        and other.claim.name == gain.claim.name
        and other.claim.value not in ("none", gain.claim.value)
    )


def is_chatter(text: str, clause: SpokenClause, words: WordReading) -> bool:
    """Whether a clause speaks of nothing that garments have: what the network reads in it is chance."""
    part = text[clause.start : clause.end].lower()
    if any(lack.said and clause.start <= lack.mark.start < clause.end for lack in words.lacks):
        return not any(p.part != "all" for p in find_parts(part))  # how its pockets are to be
    if find_changes(part) or find_adjectives(part) or any(p.part != "all" for p in find_parts(part)):
        return False
    return not any(
        clause.start <= mark.start < clause.end and any(e.implied or e.part for e in mark.entries)
        for mark in words.marks
    )


def by_network(
    text: str, clause: SpokenClause, reader: WishReader, words: WordReading, alone: bool
) -> tuple[Wish, ...]:
    """What the network of the wish reader reads in a clause, or in a text of one clause."""
    if words.language != ENGLISH or speaks_of_trims_alone(words):
        return ()
    return reader.read(text if alone else text[clause.start : clause.end], instruction=True)


def is_named(change: Change, part: str) -> bool:
    """Whether a clause speaks of what a change is about, or names no part at all."""
    named = {found.part for found in find_parts(part.lower())} - {"all"}
    return not named or any(subject_of(change) in subjects_of(each) for each in named)


def still_unread(
    part: str, clause: SpokenClause, wishes: Sequence[Wish], reader: WishReader
) -> tuple[str, ...]:
    """Of the words that nothing accounts for, those that the network made nothing of either."""
    if not wishes:
        return clause.left_over
    changes = [wish.change for wish in wishes]

    def read(other: str) -> list[Change]:
        return [w.change for w in sure_wishes(reader.read(other, instruction=True))]

    missed = " ".join(not_understood(part, changes, read)).lower().split()
    return tuple([words for words in clause.left_over if set(words.split()) & set(missed)])


def is_strange(clause: SpokenClause, words: WordReading) -> bool:
    """Whether words that nobody knows stand in it: its number may be of these ("20 cm glorpier")."""
    return any(clause.start <= mark.start < clause.end for mark in words.marks if not mark.entries)
