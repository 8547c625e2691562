"""What a prediction is punished for, and how much: the weights of the losses."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from swifttailor.errors import InputError


@dataclass(frozen=True)
class LossWeights:
    """Weights of all losses; a loss of weight 0 is not computed.

    The first block is the paper's (Sec. 4.3), which leaves units and reductions open. Here lengths are in
    units of `unit_cm`, and every loss is a mean over what its text names, over the whole batch.
    """

    unit_cm: float = 100.0
    """One unit of length: metres by default."""

    regression: float = 1.0
    """Sum over x, y and z of the absolute error; mean over the occupied pixels."""
    edge: float = 1.0
    """The paper's alpha, times `regression`: the same over the pixels within `edge_band` of an outline."""
    edge_band: int = 5
    """Pixels."""
    stitching: float = 0.0
    """Chamfer distance between the two sides of a stitch: from every pixel of either side the squared
    distance to the nearest of the other, mean over each side, both added; mean over the stitches."""
    normals: float = 0.0
    """Total variation of the unit normals of the cloth, as in DN-Splatter: sum over their three components of
    the absolute difference; mean over neighbouring pixels in a row and in a column of one panel."""

    seam_pairs: float = 0.5
    """Ours, as all that follow. For pixels sewn to each other, the error of the vector between them: sum over
    x, y and z of its absolute value; mean over the pairs. What the image itself cannot close is no error."""
    gradient: float = 0.0
    """Error of the vectors between neighbouring pixels of one panel, per pixel apart: sum over x, y and z of
    its absolute value; mean over the pairs."""
    strain: float = 0.0
    """Stretch beyond `strain_tolerance` against the flat panel: sum over neighbouring pixels of one panel of
    the length that is too long, over the sum of their flat distances. Without unit. Cloth may buckle:
    shortening is free."""
    strain_tolerance: float = 0.03
    penetration: float = 0.0
    """Depth below `clearance_cm` over the body, mean over the occupied pixels."""
    clearance_cm: float = 0.2

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
                raise InputError(f"losses.{field.name} is {value!r}; a number is expected.")
            if value < 0:
                raise InputError(f"losses.{field.name} is {value!r}; 0 or more is accepted.")
        if self.unit_cm == 0:
            raise InputError("losses.unit_cm is 0; a length above 0 is accepted, 100 for metres.")
        if self.regression == 0:
            raise InputError("losses.regression is 0; without it nothing says where the cloth should be.")


PAPER_LOSSES = LossWeights(
    regression=1.0, edge=100.0, edge_band=10, stitching=1000.0, normals=0.01, seam_pairs=0.0
)
"""The paper's weights."""
