"""What clauses of an instruction say so plainly that no network is asked whether it is meant."""

from __future__ import annotations

import re
from collections.abc import Mapping

from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.wishes.instructions.change_words import ChangeWord, find_changes, find_parts
from swifttailor.wishes.instructions.spoken_changes import SpokenChanges
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause
from swifttailor.wishes.instructions.spoken_targets import away
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.unread import is_function_word

_COMPARISON = re.compile(
    r"(?:.*\s)?(?:more|less|too|so|as|that|not|never|hardly|barely|far|overly|how|\w+n['’]?t)(?:\s.*)?|\w{3,}er"
)
"""Words of change that compare, and do not say what is done: "looser", "too tight", "not long enough"."""
_FELT = frozenset(
    {"feel", "feels", "look", "looks", "seem", "seems", "fits", "fit", "hate", "dislike", "find", "fix"}
)
"""What says that something is too wide, and nothing else."""
_PARTICLES = frozenset({"in", "out", "up", "down"})
_WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")


def clear_changes(spoken: SpokenChanges) -> list[Change]:
    """What clauses ask for of which all words are accounted for."""
    return [change for clause in spoken.clauses if not clause.left_over for change in clause.changes]


def is_all_plain(text: str, spoken: SpokenChanges) -> bool:
    """Whether an instruction is nothing but comparisons, all of whose words are accounted for."""
    steps = compared_plainly(text, spoken)
    said = [clause for clause in spoken.clauses if clause.changes or clause.left_over]
    return bool(steps) and all(
        not clause.left_over and all(change in steps for change in clause.changes) for clause in said
    )


def compared_plainly(text: str, spoken: SpokenChanges) -> list[Step]:
    """What a comparison asks for whose clause is all accounted for, and names one part or nothing at all.

    Args:
        text: That the clauses were read in.
        spoken: What its words say.
    """
    alone = len(spoken.clauses) == 1
    return [
        step
        for clause, said, words in _comparisons(text, spoken)
        if len(words) == 1 and _is_of_one(said, words[0], alone=alone)
        for step in _steps(clause)
    ]


def turned_round(text: str, spoken: SpokenChanges, whole: Mapping[Change, float]) -> list[Change]:
    """What a network reads the other way round than words say it, which know it better.

    It takes "less tight" for tighter, "not long enough" for what is to be shorter, and a collar that is asked
    for in place of a hood for one that is to go.

    Args:
        text: That the clauses were read in.
        spoken: What its words say.
        whole: How likely each wish is meant, by the network.
    """
    found: list[Change] = []
    for clause, _, _ in _comparisons(text, spoken):
        for step in _steps(clause):
            same = [(p, c) for c, p in whole.items() if isinstance(c, Step) and c.quantity == step.quantity]
            likeliest = max(same, key=lambda pair: pair[0], default=None)
            if likeliest is not None and likeliest[1].direction != step.direction:
                found.append(step)
    swapped = bool(away(text.lower()))  # it takes what goes for what is to come
    for change in clear_changes(spoken):
        if not isinstance(change, Gain):
            continue
        name = change.claim.name
        likely = {
            c.claim.value
            for c, p in whole.items()
            if isinstance(c, Gain) and c.claim.name == name and p > 0.5
        }
        asked = rf"(?<!\w)(?:an?|some|add|with) (?:[\w-]+ ){{0,2}}{name}"
        gone = change.claim.value == "none"
        if (likely and gone != swapped and (swapped or "none" not in likely)) or (
            "none" in likely and re.search(asked, text.lower())
        ):
            found.append(change)
    return found


def _steps(clause: SpokenClause) -> list[Step]:
    return [change for change in clause.changes if isinstance(change, Step)]


def _comparisons(text: str, spoken: SpokenChanges) -> list[tuple[SpokenClause, str, list[ChangeWord]]]:
    """Clauses that are all accounted for and say nothing but comparisons, with their text and its words."""
    found = []
    for clause in spoken.clauses:
        said = text[clause.start : clause.end].lower()
        words = find_changes(said)
        compares = words and all(_compares(said, word) for word in words)
        if compares and not clause.left_over:
            found.append((clause, said, words))
    return found


def _compares(said: str, word: ChangeWord) -> bool:
    """Whether a word of change compares, or is a verb with its particle: "take the waist in"."""
    changed = said[word.start : word.end]
    apart = word.verb is not None and changed in _PARTICLES
    return apart or _COMPARISON.fullmatch(changed) is not None


def _is_of_one(said: str, word: ChangeWord, *, alone: bool) -> bool:
    """Whether a comparison names one part, or is all that is said."""
    parts = {part.part for part in find_parts(said)} - {"all"}
    if parts:
        return len(parts) == 1
    return alone and all(
        is_function_word(m[0]) or m[0] in _FELT or word.start <= m.start() < word.end
        for m in _WORD.finditer(said)
    )


def says_how_much(text: str, change: Change) -> bool:
    """Whether a text has the number by which something is to change, and not only that it is to."""
    amount = change.amount if isinstance(change, Step) else None
    return amount is not None and any(abs(amount - m.value) < 0.1 for m in find_mentions(text))
