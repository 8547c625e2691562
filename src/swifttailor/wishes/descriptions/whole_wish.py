"""What a description asks for as a whole, by the network for people's own words, beside what words say.

The lexicon knows what garments are called; of a story it knows the words that happen to be in it. The
network has learnt from thousands of wishes in people's own words ("just shows her boots, nothing of the leg")
and says how likely each statement is meant.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import SURENESS, exclude

MEANT = 0.6
"""Certainty that is enough to ask for what words do not say."""
LIKELY = 0.5
"""Enough for what is made where it costs nothing."""
SURE_OF_KIND = 0.95
"""Enough against the name of a garment, which may be said in passing: "loose cotton top, kimono arms"."""
_MADE_GLADLY = frozenset({"skirt_hem", "top_hem", "leg_hem", "waistband", "skirt", "hips"})
"""Lengths, bands and shapes of skirts: who reads them in a word is seldom wrong, and they take nothing else
away."""
DOUBTED = 0.1
"""Less than this speaks against what was read elsewhere than in a word of a detail."""
_EXACT = frozenset(["micro", "mini", "midi"])
"""Lengths of skirts that are just so long where words name them."""


def described_as_a_whole(
    found: Sequence[Wish],
    whole: Mapping[Change, float],
    *,
    stated: Collection[Change] = (),
    named: Collection[Change] = (),
    said: Collection[Change] = (),
    outdone: Collection[Change] = (),
    never: Collection[Claim] = (),
    subjects: Collection[str] | None = None,
) -> tuple[Wish, ...]:
    """What is heard word by word and what is meant as a whole, together, surest first.

    Args:
        found: Word by word.
        whole: How likely each wish is meant, by the network; empty where there is none.
        stated: Wishes that are said in figures and the like, which stand.
        named: Wishes that names of garments stand for. They stay where the network reads nothing else
            instead; a name that it does not know, as its reading of the kind shows, is left to them.
        said: Wishes that words of details stand for.
        outdone: What names of garments usually stand for where a detail says otherwise: the hip of a
            cropped hoodie. No reading of the network puts it in the place of that detail.
        never: What the text refuses.
        subjects: Names of the claims that its details are about, where it is so short that all its words are
            known for what they say: the network adds no more than what is likely. None where it is not.
    """
    found = _of_its_kind(found, whole, stated, never)
    kinds = [w.change for w in found if _is_kind(w.change)]
    known = not kinds or whole.get(kinds[0], 0.0) >= LIKELY

    def stands(wish: Wish) -> bool:
        if not known or any(wish.change in sure for sure in (stated, named, said)):
            return True
        return whole.get(wish.change, 1.0) >= DOUBTED

    kept = [wish for wish in found if stands(wish)]
    likely = [(change, chance) for change, chance in whole.items() if chance >= LIKELY]
    for change, chance in sorted(likely, key=lambda both: -both[1]):
        if not isinstance(change, Gain) or change.claim in never or not _fits(change.claim, kept):
            continue
        if _is_other_length(change, stated):
            continue
        against = [w for w in kept if isinstance(w.change, Gain) and exclude(change.claim, w.change.claim)]
        if any(
            not known
            or w.change in stated
            or (w.change in named and chance < MEANT)
            or (w.change in said and change in outdone)
            or whole.get(w.change, w.certainty) >= chance
            for w in against
        ):
            continue
        added = subjects is not None and not (change in named or change.claim.name in (*subjects, "kind"))
        if added and against:
            continue
        certainty = SURENESS["certain"] if chance >= MEANT and not added else SURENESS["likely"]
        kept = [w for w in kept if w not in against]
        places = [k for k, w in enumerate(kept) if w.change == change]
        for k in places:
            kept[k] = Wish(change, max(certainty, kept[k].certainty))
        if not places:
            kept.append(Wish(change, certainty))
    kept += _doubted_alone(found, kept, said)
    return tuple(sorted(kept, key=lambda wish: -wish.certainty))


def _is_other_length(change: Gain, stated: Collection[Change]) -> bool:
    """Whether words name another length of the skirt, if only the next one: a midi is not to the floor."""
    if change.claim.name != "skirt_hem":
        return False
    told = [c.claim for c in stated if isinstance(c, Gain) and c.claim.name == "skirt_hem"]
    return change.claim not in told and any(claim.value in _EXACT for claim in told)


def _doubted_alone(found: Sequence[Wish], kept: Sequence[Wish], said: Collection[Change]) -> list[Wish]:
    """Of `_MADE_GLADLY` what a word says and the network doubts, where nothing else is heard of it.

    They may be meant: they are made where that costs nothing.
    """
    told = [w.change.claim for w in kept if isinstance(w.change, Gain)]
    names = {claim.name for claim in told}
    return [
        Wish(w.change, SURENESS["likely"])
        for w in found
        if isinstance(w.change, Gain)
        and w.change in said
        and w.change.claim.name in _MADE_GLADLY - names
        and not any(exclude(w.change.claim, claim) for claim in told)
        and _fits(w.change.claim, kept)
    ]


def _fits(claim: Claim, kept: Sequence[Wish]) -> bool:
    """Whether the kind of garment that is asked for, where one is, can have what a claim is about."""
    kinds = [w.change.claim.value for w in kept if isinstance(w.change, Gain) and _is_kind(w.change)]
    return claim.name == "kind" or not kinds or fits_kind(claim.name, str(kinds[0]))


def _of_its_kind(
    found: Sequence[Wish],
    whole: Mapping[Change, float],
    stated: Collection[Change],
    never: Collection[Claim],
) -> list[Wish]:
    """Wishes with the kind of garment that the network is all but certain of in place of another.

    It takes no note of refusals: of "anything but trousers" it reads trousers.
    """
    if any(_is_kind(w.change) and w.change in stated for w in found):
        return list(found)
    refused = {Gain(claim) for claim in never}
    sure = [(c, chance) for c, chance in whole.items() if chance >= SURE_OF_KIND and c not in refused]
    kind, _ = max(((c, p) for c, p in sure if _is_kind(c)), key=lambda both: both[1], default=(None, 0.0))
    if kind is None:
        return list(found)
    others = [w for w in found if not _is_kind(w.change)]
    certainty = max((w.certainty for w in found if _is_kind(w.change)), default=0.0)
    return others if certainty == 0.0 else [Wish(kind, certainty), *others]


def _is_kind(change: Change) -> bool:
    return isinstance(change, Gain) and change.claim.name == "kind"
