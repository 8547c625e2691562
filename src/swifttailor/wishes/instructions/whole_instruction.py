"""What an instruction asks for as a whole, by the network, beside what words are heard to say one by one.

Tables know the phrases that somebody has thought of. The network has learnt from thousands of instructions
in people's own words ("she wants leg, leg, leg") and says how likely each wish is meant. Where tables leave
words over it is believed sooner; what it all but excludes is let go, if it reads something else instead.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence, Set
from functools import cached_property

from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.recutting.unasked import part_of
from swifttailor.wishes.labels import label_of
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import exclude

MEANT = 0.5
"""Certainty that is enough where words are left over."""
MEANT_BESIDE = 0.9
"""Enough beside what accounts for all words."""
DOUBTED, DOUBTED_BESIDE = 0.15, 0.02
"""Less than this speaks against what was heard, where something else is read: words left over or not."""
AT_ODDS = 0.05
"""Less than this, where something else is read, counts against what was heard like a word left over."""
FEW_WORDS, DECIDED, AHEAD = 9, 0.8, 0.1
"""Of more words, what is so certain and so far ahead of its opposite decides what seems a contradiction."""
KNOWN = 0.7
"""What the network alone reads with less is meant in every second text: done, and said to be unsure."""
GUESS = 0.4
"""Enough where nothing else is heard or read: the likeliest wish, said to be what is taken to be meant."""

_OF_SEVERAL = frozenset({"slit", "sleeve_shape"})
"""Claims of which several may be true and asked for."""


def with_the_whole(
    heard: Sequence[Wish],
    whole: Mapping[Change, float],
    *,
    left_over: bool,
    accepts: Callable[[Change, Sequence[Change]], bool],
    holds: Callable[[Change], bool] = lambda change: False,
    firm: Collection[Change] = (),
    clear: Collection[Change] = (),
) -> tuple[list[Wish], list[Wish]]:
    """What is heard word by word and what is meant as a whole, together.

    Args:
        heard: Word by word.
        whole: How likely each wish is meant, by the network.
        left_over: Whether words are left that nothing accounts for.
        accepts: Whether a change may stand beside others that are asked for.
        holds: Whether a change is so already. Who asks for that is answered with nothing.
        firm: What vague words are taken to mean, which the network does not overrule.
        clear: What a letter asks for in clauses of which all words are accounted for.

    Returns:
        What is asked for, and what of it the network alone has read.
    """
    likely = _Chances(whole)
    if not left_over:
        told = [w.change for w in heard if w.change in firm or likely.of(w.change) >= AT_ODDS]
        others = [c for c, chance in whole.items() if chance >= MEANT and accepts(c, told)]
        left_over = len(told) < len(heard) and bool(others)
    enough, doubted = (MEANT, DOUBTED) if left_over else (MEANT_BESIDE, DOUBTED_BESIDE)
    read = [change for change, chance in whole.items() if chance >= enough]
    believed = [
        wish
        for wish in heard
        if wish.change in firm
        or likely.of(wish.change) >= (min(doubted, AT_ODDS) if wish.change in clear else doubted)
        or likely.of_another_like(wish.change) >= MEANT
    ]
    if not heard and not read and whole:
        best = max(whole, key=lambda change: whole[change])
        read = [best] if whole[best] >= GUESS else []
    read = [change for change in read if not _is_why(change, read)]
    for kept in (believed, list(heard)):
        found: list[Wish] = []
        for change in sorted(read, key=lambda one: -whole[one]):
            told = [wish.change for wish in (*kept, *found)]
            if not any(_same(change, other) for other in told) and accepts(change, told):
                found.append(Wish(change, whole[change]))
        if kept or found or any(holds(change) for change in read):
            break
    return [*kept, *found], found


def without_guesses(
    heard: Sequence[Wish], whole: Mapping[Change, float], is_said: Callable[[Change], bool]
) -> tuple[list[Wish], list[Wish]]:
    """What is heard, and apart from it what one network guesses that the other all but excludes.

    The network of the wish reader knows captions alone and reads something in any name: in "raglan" shorter
    sleeves, in "bustle" a gathered skirt. Where no words say so and the network for people's own words does
    not either, it is told and not done.

    Args:
        heard: What words say and the network of the wish reader reads.
        whole: How likely each wish is meant, by the network for people's own words.
        is_said: Whether words say so.
    """
    likely = _Chances(whole)
    apart = [w for w in heard if not is_said(w.change) and likely.of(w.change) < AT_ODDS]
    return [wish for wish in heard if wish not in apart], apart


def uncertain(
    heard: Sequence[Wish],
    read: Sequence[Wish],
    whole: Mapping[Change, float],
    accepts: Callable[[Change, Sequence[Change]], bool],
    firm: Collection[Change] = (),
) -> tuple[tuple[Change, ...], tuple[Change, ...]]:
    """What is asked for and may not be meant, and what may be meant and is not asked for.

    Where tables and network disagree one of them is wrong: of 139 instructions of which all was heard 7 are
    doubted so, of 96 that were misheard without a word left over 54.

    Args:
        heard: What is asked for.
        read: What of it the network alone has read.
        whole: How likely each wish is meant, by the network.
        accepts: Whether a change may stand beside others that are asked for.
        firm: What vague words are taken to mean.
    """
    likely = _Chances(whole)
    told = [wish.change for wish in heard]
    doubted = [c for c in told if c not in firm and likely.of(c) < AT_ODDS]
    guessed = [wish.change for wish in read if wish.certainty < KNOWN]
    parts = {part_of(subject_of(change)) for change in told}
    perhaps = [
        change
        for change, chance in whole.items()
        if chance >= MEANT and part_of(subject_of(change)) not in parts and accepts(change, told)
    ]
    return tuple([c for c in told if c in doubted or c in guessed]), tuple(perhaps)


def is_disputed(change: Change, disputed: Set[str], whole: Mapping[Change, float], words: int) -> bool:
    """Whether a change is about what a text asks opposite things of, which nobody can decide for it.

    In a few words people mean what they say: "longer and shorter". In many, what seems the opposite is often
    why they ask, and the network may tell which of both is asked for.

    Args:
        change: What is read.
        disputed: Claims and quantities that opposite things are asked of.
        whole: How likely each wish is meant.
        words: How many the text has.
    """
    parts = {part for subject in disputed if (part := part_of(subject)) is not None}
    subject = subject_of(change)
    if subject not in disputed and part_of(subject) not in parts:
        return False
    rivals = [chance for other, chance in whole.items() if subject_of(other) == subject and other != change]
    chance = whole.get(change, 0.0)
    return words <= FEW_WORDS or chance < DECIDED or max(rivals, default=0.0) > chance - AHEAD


def undisputed(told: Sequence[Change], disputed: Set[str], words: int) -> list[Change]:
    """Without what a few words ask of a part that they contradict themselves about: "tight and loose"."""
    parts = {part for subject in disputed if (part := part_of(subject)) is not None}
    return [c for c in told if words > FEW_WORDS or part_of(subject_of(c)) not in parts]


def _same(one: Change, other: Change) -> bool:
    """Whether both are about the same thing and one of them is enough."""
    if subject_of(one) == subject_of(other):
        return not go_together(one, other)
    return isinstance(one, Gain) and isinstance(other, Gain) and exclude(one.claim, other.claim)


def _is_why(change: Change, read: Sequence[Change]) -> bool:
    """Whether it says what is wrong: sleeves "way past my fingertips" are to be shorter, not so long."""
    if not isinstance(change, Gain):
        return False
    ends = _TOO_FAR.get((change.claim.name, str(change.claim.value)))
    return ends is not None and any(isinstance(c, Step) and (c.quantity, c.direction) == ends for c in read)


_TOO_FAR = {
    ("sleeves", "extra-long"): ("sleeve length", -1),
    ("skirt_hem", "floor"): ("length", -1),
    ("skirt_hem", "maxi"): ("length", -1),
    ("skirt_hem", "micro"): ("length", 1),
    ("skirt_hem", "mini"): ("length", 1),
    ("top_hem", "long"): ("length", -1),
    ("top_hem", "cropped"): ("length", 1),
    ("top_hem", "bra"): ("length", 1),
    ("leg_hem", "full"): ("leg length", -1),
    ("leg_hem", "very short"): ("leg length", 1),
    ("neck_depth", "plunging"): ("neck depth", -1),
    ("neck_depth", "high"): ("neck depth", 1),
    ("fit", "oversized"): ("chest", -1),
    ("fit", "close"): ("chest", 1),
}
"""Ends of scales, and the steps that lead away from them."""


def go_together(one: Change, other: Change) -> bool:
    """Whether both may be asked of one thing: slits left and right, sleeves puffed and tapered."""
    if not isinstance(one, Gain) or not isinstance(other, Gain) or one == other:
        return False
    named = one.claim.name == other.claim.name and one.claim.name in _OF_SEVERAL
    return named and not exclude(one.claim, other.claim)


class _Chances:
    """How likely wishes are meant, whatever their amounts; what the network does not know is not doubted."""

    def __init__(self, whole: Mapping[Change, float]) -> None:
        self._whole = whole

    @cached_property
    def _by_label(self) -> dict[str, float]:
        """By their names, which say no amounts; of several amounts the likeliest."""
        found: dict[str, float] = {}
        for change, chance in self._whole.items():
            if isinstance(change, Step) or not isinstance(change.claim.value, str):
                label = label_of(change)
                found[label] = max(chance, found.get(label, 0.0))
        return found

    def of(self, change: Change) -> float:
        """The likelihood of a wish, of several amounts that of the likeliest."""
        if isinstance(change, Gain) and isinstance(change.claim.value, str):
            return self._whole.get(change, 1.0)
        return self._by_label.get(label_of(change), 1.0)

    def of_another_like(self, change: Change) -> float:
        """How likely any other value of its claim is, where no single one is: of a full skirt a circle."""
        if not isinstance(change, Gain) or change.claim.value == "none":
            return 0.0
        others = [
            chance
            for other, chance in self._whole.items()
            if isinstance(other, Gain)
            and other.claim.name == change.claim.name
            and other.claim.value != "none"
        ]
        return sum(others) if max(others, default=0.0) < MEANT else 0.0
