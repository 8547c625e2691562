"""The square by which a printed page is measured: 10 x 5 cm, and 4 x 2 inches around it."""

from __future__ import annotations

import numpy as np

from swifttailor.inches import CM_PER_INCH
from swifttailor.making.drawing import CUT, FRAME, Drawing, Stroke, Text

SIZE_CM = 10.0, 5.0
SIZE_INCH = 4.0, 2.0
OUTER_CM = SIZE_INCH[0] * CM_PER_INCH, SIZE_INCH[1] * CM_PER_INCH


def draw_test_square(x: float, y: float) -> Drawing:
    """The square with its lower left corner (of the 10 x 5 cm) at a place, cm."""
    edge = np.array([OUTER_CM[0] - SIZE_CM[0], OUTER_CM[1] - SIZE_CM[1]]) / 2
    middle = x + SIZE_CM[0] / 2
    return Drawing(
        (
            Stroke(_box(x, y, *SIZE_CM), CUT._replace(width=0.2), closed=True),
            Stroke(_box(x - edge[0], y - edge[1], *OUTER_CM), FRAME, closed=True),
        ),
        (
            Text("Test square", middle, y + 3.2, 0.6, bold=True),
            Text("The black box is 10 cm wide and 5 cm high,", middle, y + 2.1, 0.38),
            Text("the grey box around it 4 by 2 inches.", middle, y + 1.5, 0.38),
            Text("If not: print at 100 %, \u201cactual size\u201d.", middle, y + 0.8, 0.38),
        ),
    )


def _box(x: float, y: float, width: float, height: float) -> np.ndarray:
    return np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
