"""What joints, bare skin and a network of photographs tell of what somebody in one wears.

The network that reads photographs has learnt from people before white, most of them drawn. In a street it
takes long sleeves for none and trousers for a skirt. Where skin is seen at a wrist is another witness, and so
is a network that has seen nothing but photographs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.laid_heads import LaidHeads
from swifttailor.picture_reader.person_finder import Person
from swifttailor.picture_reader.person_halves import LOWER, UPPER, Answers, View
from swifttailor.picture_reader.reweighing import reweighed
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.worn_heads import COLLARED, WornHeads, views_of
from swifttailor.picture_reader.worn_names import worn_name

FOREARMS: Mapping[str, float] = MappingProxyType(
    {"none": 1, "cap": 1, "short": 1, "elbow": 1, "three-quarter": 0.5, "long": 0}
)
UPPER_ARMS: Mapping[str, float] = MappingProxyType({"none": 1, "cap": 1})
SHINS: Mapping[str, float] = MappingProxyType({"trousers": 0, "shorts": 1, "skirt": 1})
"""How bare limbs are with sleeves or kinds of these words; covered (0) with others."""
SLEEVES_USUAL: Mapping[str, float] = MappingProxyType({"three-quarter": -1.0})
COLLARS_USUAL: Mapping[str, float] = MappingProxyType({"stand": 0.0, "turtleneck": -1.0, "lapel": 2.0})
LEGS_USUAL: Mapping[str, float] = MappingProxyType({"straight": 3.0})
FITS_USUAL: Mapping[int, Mapping[str, float]] = MappingProxyType({UPPER: {"easy": 2.0}, LOWER: {"easy": 1.0}})
"""Logarithm of how much oftener something is worn than the network thinks; all but sleeves in a street."""
FOREARM_SHARE, UPPER_ARM_SHARE, SHIN_SHARE = 0.8, 0.7, 0.8
"""How much counts what limbs tell: of each the pieces that are looked at are no independent witnesses."""
TOLD_SHARE: Mapping[str, float] = MappingProxyType(
    {"sleeves": 0.5, "collar": 2.0, "kind": 1.0, "leg_hem": 0.8}
)
"""How much counts what the network of photographs tells, which knows the goods of two shops."""
_BELOW = -2.0
"""Added to the signs that anything apart is worn on the legs, of which each counts as much: the logits of a
look from near, of seen knees and hips, and of no dress."""
_LEGS_UNSEEN, _STEEPEST, _SCALE = -3.0, 6.0, 3.0
"""What a look from near says where there is none; logits are cut, and told in this unit."""
_CUT = 1e-3
"""Nothing is surer than all but this."""
_DRESSES = frozenset({"dress", "jumpsuit", "playsuit"})


@dataclass(frozen=True)
class WornSigns:
    """What is told of somebody beside what the network says that reads photographs."""

    limbs: BareLimbs = field(default_factory=BareLimbs)
    told: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    """Of claims the logarithm of the share of each word (`WornHeads.told`)."""
    called: str = ""
    """What is worn on the shoulders is called (`worn_name`); empty where that is not sure."""

    @staticmethod
    def of(
        pixels: Pixels,
        person: Person,
        cut_out: View,
        heads: WornHeads | None,
        names: LaidHeads | None = None,
    ) -> WornSigns:
        """Looks at somebody.

        Args:
            pixels: (h, w, 3) sRGB, all of the picture.
            person: Somebody in it.
            cut_out: What their `cut_out` gives of it.
            heads: What has seen nothing but photographs; None: limbs alone tell.
            names: Tells on the same trunk what clothes are called; nothing is called so without it.
        """
        limbs = person.limbs(pixels)
        if heads is None:
            return WornSigns(limbs)
        features = heads.features(views_of(pixels, cut_out, person.joints))
        called = "" if names is None else worn_name(names, features)
        return WornSigns(limbs, heads.told_of(features), called)


def with_signs(answers: Answers, signs: WornSigns, part: int, *, street: bool) -> Answers:
    """What is said of somebody, with sleeves, collars, kinds and hems that agree with these signs.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`.
        signs: Of the same person.
        part: Number of the part of the body whose answers count.
        street: Whether there is no plain ground behind them.
    """
    limbs, told = signs.limbs, signs.told
    if street:
        answers = _as_usual(answers, part, "fit", FITS_USUAL[part])
        answers = _as_usual(answers, part, "legs", LEGS_USUAL)
    if part == UPPER:
        sleeves = {
            word: FOREARM_SHARE * bare * limbs.forearms
            + UPPER_ARM_SHARE * UPPER_ARMS.get(word, 0) * limbs.upper_arms
            + SLEEVES_USUAL.get(word, 0)
            + _told(told, "sleeves", word)
            for word, bare in FOREARMS.items()
        }
        answers = reweighed(answers, UPPER, "sleeves", sleeves)
        if "collar" in told:
            # It tells whether there is any; of which the network that reads says more.
            collars = {
                word: (COLLARS_USUAL[word] if street else 0) + _told(told, "collar", COLLARED)
                for word in COLLARS_USUAL
            }
            answers = reweighed(answers, UPPER, "collar", collars | {"none": _told(told, "collar", "none")})
        return answers
    kinds = {
        word: SHIN_SHARE * bare * limbs.shins + _told(told, "kind", word) for word, bare in SHINS.items()
    }
    answers = reweighed(answers, LOWER, "kind", kinds)
    if "leg_hem" in told:
        hems = {word: _told(told, "leg_hem", word) for word in told["leg_hem"]}
        answers = reweighed(answers, LOWER, "leg_hem", hems, certain=False)
    return answers


def _as_usual(answers: Answers, part: int, claim: str, usual: Mapping[str, float]) -> Answers:
    words = [word for name, word in statement_labels() if name == claim]
    more = {word: usual.get(word, 0.0) for word in words}
    return reweighed(answers, part, claim, more, certain=False)


def _told(told: Mapping[str, Mapping[str, float]], claim: str, word: str) -> float:
    shares = told.get(claim, {})
    return TOLD_SHARE[claim] * shares.get(word, min(shares.values())) if shares else 0.0


def worn_below(answers: Answers, nearer: Answers | None, limbs: BareLimbs) -> float:
    """Logit of whether somebody in a street wears anything on the legs that is no part of what is above.

    Args:
        answers: Of somebody whole.
        nearer: Of the legs; None where they are not looked at.
        limbs: Of the same person.
    """
    kinds = share_of(answers["statements"][UPPER])
    dress = sum(
        float(kinds[k])
        for k, (claim, word) in enumerate(statement_labels())
        if claim == "kind" and word in _DRESSES
    )
    near = _LEGS_UNSEEN if nearer is None else float(np.clip(nearer["present"][LOWER], -_STEEPEST, _STEEPEST))
    seen = _logit(limbs.knees_seen) + _logit(limbs.hips_seen)
    return (near + seen - _logit(dress)) / _SCALE + _BELOW


def _logit(share: float) -> float:
    share = min(max(share, _CUT), 1 - _CUT)
    return float(np.log(share) - np.log1p(-share))
