"""What people wear less often in pictures than garments that are drawn by lot have it.

A reader learns how often things are from what it is shown, and says that where it cannot see. GarmentCode's
hoods are all worn over the head; in pictures of people hoods lie on the back, and what is around the head is
hair.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.hoods import hood_signs
from swifttailor.programs.read_parameter import ReadParameter

DRAWN, WORN = 0.08, 0.01
"""Share of upper garments whose hood is over the head: of those drawn of people to validate with; and, by our
estimate, in photographs of people."""


def as_people_wear(
    answers: Mapping[str, NDArray[Any]], parameters: Sequence[ReadParameter] = ()
) -> dict[str, NDArray[Any]]:
    """What is read of a picture of people, with the odds of hoods as they are there.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`, (parts, M) of `has`, (parts, P)
            of `panels`, (parts, parameters, values) of `designs` where there are `parameters`.
        parameters: Whose designs are said.

    Returns:
        The same, with the odds of hoods multiplied by the ratio of those of `WORN` and `DRAWN`.
    """
    more = np.log(WORN / (1 - WORN)) - np.log(DRAWN / (1 - DRAWN))
    signs = hood_signs(answers, parameters)
    return dict(answers) | {name: answers[name] + more * sign for name, sign in signs.items()}
