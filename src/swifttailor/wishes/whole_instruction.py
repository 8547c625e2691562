"""What an instruction asks for as a whole, by the network, beside what words are heard to say one by one.

Tables know the phrases that somebody has thought of. The network has learnt from thousands of instructions
in people's own words ("she wants leg, leg, leg") and says how likely each wish is meant. Where tables leave
words over it is believed sooner; what it all but excludes is let go, if it reads something else instead.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.labels import label_of
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import exclude

MEANT = 0.5
"""Certainty that is enough where words are left over."""
MEANT_BESIDE = 0.9
"""Enough beside what accounts for all words."""
DOUBTED, DOUBTED_BESIDE = 0.15, 0.02
"""Less than this speaks against what was heard, where something else is read: words left over or not."""
GUESS = 0.4
"""Enough where nothing else is heard or read: the likeliest wish, said to be what is taken to be meant."""


def with_the_whole(
    heard: Sequence[Wish],
    whole: Mapping[Change, float],
    *,
    left_over: bool,
    accepts: Callable[[Change, Sequence[Change]], bool],
    holds: Callable[[Change], bool] = lambda change: False,
) -> tuple[list[Wish], list[Wish]]:
    """What is heard word by word and what is meant as a whole, together.

    Args:
        heard: Word by word.
        whole: How likely each wish is meant, by the network.
        left_over: Whether words are left that nothing accounts for.
        accepts: Whether a change may stand beside others that are asked for.
        holds: Whether a change is so already. Who asks for that is answered with nothing.

    Returns:
        What is asked for, and what of it the network alone has read.
    """
    enough, doubted = (MEANT, DOUBTED) if left_over else (MEANT_BESIDE, DOUBTED_BESIDE)
    likely = {_name(change): chance for change, chance in whole.items()}
    read = [change for change, chance in whole.items() if chance >= enough]
    believed = [w for w in heard if likely.get(_name(w.change), 1.0) >= doubted]
    if not heard and not read and whole:
        best = max(whole, key=lambda change: whole[change])
        read = [best] if whole[best] >= GUESS else []
    for kept in (believed, list(heard)):
        found: list[Wish] = []
        for change in sorted(read, key=lambda one: -whole[one]):
            told = [wish.change for wish in (*kept, *found)]
            if not any(_same(change, other) for other in told) and accepts(change, told):
                found.append(Wish(change, whole[change]))
        if kept or found or any(holds(change) for change in read):
            break
    return [*kept, *found], found


def _same(one: Change, other: Change) -> bool:
    """Whether both are about the same thing and one of them is enough."""
    if subject_of(one) == subject_of(other):
        return True
    return isinstance(one, Gain) and isinstance(other, Gain) and exclude(one.claim, other.claim)


def _name(change: Change) -> str:
    """Its label; a stated amount makes no difference."""
    return label_of(Step(change.quantity, change.direction) if isinstance(change, Step) else change)
