"""What a picture reader's network says of a claim, together with what another witness says."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.person_halves import Answers
from swifttailor.picture_reader.said import LEAST_CERTAINTY, share_of

_CUT, _ODD = 1e-3, 0.01
"""Nothing is surer than all but the first; and how sure a word is that the network says nothing of."""


def reweighed(
    answers: Answers, part: int, claim: str, more: Mapping[str, float], *, certain: bool = True
) -> Answers:
    """The answers with other logits of one claim of a part.

    Words that nothing more is known of ("left only", of sleeves) keep theirs, the others have what is left.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`.
        part: Number of the part of the body.
        claim: Whose words are told apart otherwise.
        more: Of its words, what is added to the logarithms of their shares.
        certain: Whether one of the words is true of whatever is worn there, as of sleeves; hems of legs are
            said of a skirt no more surely than before.
    """
    words = {word: k for k, (name, word) in enumerate(statement_labels()) if name == claim}
    which = {word: k for word, k in words.items() if word in more}
    statements: NDArray[np.float64] = np.array(answers["statements"], np.float64)
    said = share_of(statements[part, list(which.values())])
    left = 1 - share_of(statements[part, [k for word, k in words.items() if word not in more]]).sum()
    if not certain:
        if said.max() < LEAST_CERTAINTY:
            return answers
        left = min(left, float(said.sum()))
    said = np.where(said >= LEAST_CERTAINTY, said, _ODD)
    odds = np.log(said / said.sum()) + np.array([more[word] for word in which])
    share = np.exp(odds - odds.max())
    share = np.clip(share / share.sum() * left, _CUT, 1 - _CUT)
    statements[part, list(which.values())] = np.log(share) - np.log1p(-share)
    return dict(answers) | {"statements": statements}
