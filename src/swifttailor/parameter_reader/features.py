"""What is sought as one row of numbers, as the network is told it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.pattern_library.sought import Sought

BOX_UNIT_CM = 50.0


def features_of(sought: Sought) -> NDArray[np.float32]:
    """Every value weighed by whether it is known, and whether it is.

    Args:
        sought: What is known of a garment.

    Returns:
        (F,) of statements, measures, names and boxes of panels; zeros where nothing is known.
    """
    said, measured, named, placed = (
        np.minimum(counts, 1.0) for counts in (sought.said, sought.measures, sought.named, sought.placed)
    )
    return np.concatenate(
        [
            said * (2 * sought.statements - 1),
            said,
            measured * (2 * sought.has - 1),
            measured,
            measured * sought.has * sought.measured[:, 0],
            named * (2 * sought.panels - 1),
            named,
            (placed[:, None] * sought.boxes / BOX_UNIT_CM).ravel(),
        ],
        dtype=np.float32,
    )
