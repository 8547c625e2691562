"""Where the joints of somebody in a photograph are, by the network that cuts people out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.view import Square

NOSE, EYES, MOUTH = (0,), (2, 5), (9, 10)
SHOULDERS, ELBOWS, WRISTS = (11, 12), (13, 14), (15, 16)
HIPS, KNEES, ANKLES = (23, 24), (25, 26), (27, 28)
"""Of the places that BlazePose tells of somebody's body: left and right."""
PLACES, SAID = 39, 5
"""How many places are told, and how many numbers of each."""
LEAST_SEEN = 0.5
"""How sure a place has to be in the picture."""


@dataclass(frozen=True, eq=False)
class BodyJoints:
    """Places on somebody's body."""

    places: NDArray[np.float64]
    """(39, 2) x and y, pixels; guesses where they are beyond the picture."""
    seen: NDArray[np.float64]
    """(39,) how sure each is in the picture, 0 to 1."""

    @staticmethod
    def of(said: NDArray[Any], square: Square, size: int) -> BodyJoints:
        """What the network says.

        Args:
            said: (39, 5) of each place x, y and z, pixels of what it is shown, and logits that it is in the
                picture and that it is there.
            square: Of the picture, which it is shown.
            size: Pixels along each side of what it is shown.
        """
        places = np.array(square[:2], np.float64) + said[:, :2].astype(np.float64) * square[2] / size
        return BodyJoints(places, share_of(said[:, 3]).astype(np.float64))

    def middle(self, which: tuple[int, ...]) -> NDArray[np.float64]:
        """(2,) x and y of the middle of some places."""
        return np.asarray(self.places[list(which)].mean(axis=0))

    def surest(self, which: tuple[int, ...]) -> float:
        """How sure the surest of some places is in the picture, 0 to 1."""
        return float(self.seen[list(which)].max())

    def least_sure(self, which: tuple[int, ...]) -> float:
        """How sure the least sure of some places is in the picture, 0 to 1."""
        return float(self.seen[list(which)].min())
