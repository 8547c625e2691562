"""What bare arms and legs tell of what somebody in a photograph wears, beside what a network says.

The network has learnt from people before white. In a street it takes long sleeves for none and trousers for
a skirt; where skin is seen at the wrist, and where it is not, is another witness.
`scripts/fit_bare_limbs.py` writes the numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array
from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.person_halves import LOWER, UPPER, Answers
from swifttailor.picture_reader.said import LEAST_CERTAINTY, share_of

FOREARMS: Mapping[str, float] = MappingProxyType(
    {"none": 1, "cap": 1, "short": 1, "elbow": 1, "three-quarter": 0.5, "long": 0}
)
UPPER_ARMS: Mapping[str, float] = MappingProxyType({"none": 1, "cap": 1})
SHINS: Mapping[str, float] = MappingProxyType({"trousers": 0, "shorts": 1, "skirt": 1})
"""How bare limbs are with sleeves or kinds of these words; covered (0) with others."""
SLEEVES_USUAL: Mapping[str, float] = MappingProxyType({"three-quarter": -1.0})
LEGS_USUAL: Mapping[str, float] = MappingProxyType({"trousers": 1.0})
"""Logarithm of how much oftener something is worn in a street than the network thinks."""
FOREARM_SHARE, UPPER_ARM_SHARE, SHIN_SHARE = 0.8, 0.7, 1.6
"""How much counts what limbs tell: of each the pieces that are looked at are no independent witnesses."""
LEGS_READ = 0.65
"""How much counts what the network says of kinds on the legs in a street, where it is too sure."""
BELOW = (1.280, 1.584, 0.832, -0.812, -1.977)
"""Whether anything apart is worn on the legs: of the logits of a look from near, of seen knees and hips, and
of a dress; and a summand."""
_LEGS_UNSEEN, _STEEPEST, _SCALE = -3.0, 6.0, 3.0
"""What a look from near says where there is none; logits are cut, and told in this unit."""
_CUT = 1e-3
_ODD = 0.01
"""How sure a word is that the network says nothing of."""
_DRESSES = frozenset({"dress", "jumpsuit", "playsuit"})


def with_limbs(answers: Answers, limbs: BareLimbs, part: int, *, street: bool) -> Answers:
    """What is said of somebody, with sleeves and kinds that agree with what is bare of arms and legs.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`.
        limbs: Of the same person.
        part: Number of the part of the body whose answers count.
        street: Whether there is no plain ground behind them, before which the network sees legs better.
    """
    if part == UPPER:
        more = {
            word: FOREARM_SHARE * bare * limbs.forearms
            + UPPER_ARM_SHARE * UPPER_ARMS.get(word, 0) * limbs.upper_arms
            + SLEEVES_USUAL.get(word, 0)
            for word, bare in FOREARMS.items()
        }
        return _reweighed(answers, UPPER, "sleeves", more)
    if not street:
        return answers
    more = {word: SHIN_SHARE * bare * limbs.shins + LEGS_USUAL.get(word, 0) for word, bare in SHINS.items()}
    return _reweighed(answers, LOWER, "kind", more, LEGS_READ)


def worn_below(answers: Answers, nearer: Answers | None, limbs: BareLimbs) -> float:
    """Logit of whether somebody in a street wears anything on the legs that is no part of what is above.

    Args:
        answers: Of somebody whole.
        nearer: Of the legs; None where they are not looked at.
        limbs: Of the same person.
    """
    return float(below_signs(answers, nearer, limbs) @ BELOW[:-1] + BELOW[-1])


def below_signs(answers: Answers, nearer: Answers | None, limbs: BareLimbs) -> Array:
    """(4,) what `BELOW` is multiplied with."""
    kinds = share_of(answers["statements"][UPPER])
    dress = sum(
        float(kinds[k])
        for k, (claim, word) in enumerate(statement_labels())
        if claim == "kind" and word in _DRESSES
    )
    near = _LEGS_UNSEEN if nearer is None else float(np.clip(nearer["present"][LOWER], -_STEEPEST, _STEEPEST))
    signs = near, *(_logit(share) for share in (limbs.knees_seen, limbs.hips_seen, dress))
    return np.array(signs) / _SCALE


def _logit(share: float) -> float:
    share = min(max(share, _CUT), 1 - _CUT)
    return float(np.log(share) - np.log1p(-share))


def _reweighed(
    answers: Answers, part: int, claim: str, more: Mapping[str, float], read: float = 1.0
) -> dict[str, Any]:
    """The answers with other logits of one claim of a part; its words have a sum of one."""
    which = {word: k for k, (name, word) in enumerate(statement_labels()) if name == claim and word in more}
    statements: NDArray[np.float64] = np.array(answers["statements"], np.float64)
    said = share_of(statements[part, list(which.values())])
    said = np.where(said >= LEAST_CERTAINTY, said, _ODD)
    odds = read * np.log(said / said.sum()) + np.array([more[word] for word in which])
    share = np.exp(odds - odds.max())
    share = np.clip(share / share.sum(), _CUT, 1 - _CUT)
    statements[part, list(which.values())] = np.log(share) - np.log1p(-share)
    return dict(answers) | {"statements": statements}
