"""Whether the cloth of a garment in a photograph is printed or woven in colours, and how, by a network.

The trunk is that of `worn_heads`, which tells textures well; a few sums on what it makes of a square of
nothing but cloth tell, and where that is not surely plain, of the whole garment as well
(`scripts/train_print_head_torch.py`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.view import Square
from swifttailor.picture_reader.worn_heads import SIZE, features_of

SHIPPED = Path(__file__).with_name("print_head.onnx")
INPUTS, OUTPUTS = ("cloth", "garment"), ("near", "both")
"""What is looked at; what the first tells, and what both tell together."""
PLAIN = "plain"
PRINTS = (PLAIN, "across", "down", "checks", "dots", "figures")
"""What is told apart: no print, stripes around the body and down it, checks, dots, anything else."""
KIND = ModelKind(
    "network for prints",
    "swifttailor print head 1",
    1 << 20,
    ({GRAPH: (INPUTS, OUTPUTS)},),
)
SURELY_PLAIN = 0.97
"""Of cloth that is so from near nobody asks more."""
_WELL_WITHIN = 0.6
_FINEST = 256
"""Cells along the longer side of a mask in which the square is sought."""
_LEAST_SIDE = 24
"""Pixels; in less no print is seen."""


@dataclass(frozen=True, eq=False)
class PrintHead:
    """Tells prints apart."""

    trunk: Any
    """Of onnxruntime: that of `worn_heads.WornHeads`."""
    session: Any
    """Of onnxruntime."""

    @staticmethod
    def load(trunk: Any, weights: Path | str | None = None, *, threads: int = 1) -> PrintHead:
        """Opens a model file.

        Args:
            trunk: Of onnxruntime.
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the sums.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        shape = [1, len(PRINTS)]
        model.require({f"what it says of {name}": (model.shape_made(GRAPH, name), shape) for name in OUTPUTS})
        return PrintHead(trunk, model.sessions[GRAPH])

    def told(self, pixels: Pixels, mask: NDArray[np.float32]) -> Mapping[str, float]:
        """How likely each of `PRINTS` is, 0 to 1; nothing where too little cloth is seen.

        Args:
            pixels: (h, w, 3) sRGB.
            mask: (h, w) 0 to 1: where the garment is.
        """
        square = square_of_cloth(mask)
        if square is None:
            return {}
        cloth = features_of(self.trunk, pixels, square, mirrored=False)[None]
        (near,) = self.session.run(list(OUTPUTS[:1]), dict.fromkeys(INPUTS, cloth))
        logits = near[0].astype(np.float64)
        if _shares(logits)[PRINTS.index(PLAIN)] < SURELY_PLAIN:
            shown = alone(pixels, mask)
            garment = features_of(self.trunk, shown, (0, 0, SIZE), mirrored=False)[None]
            (both,) = self.session.run(list(OUTPUTS[1:]), dict(zip(INPUTS, (cloth, garment), strict=True)))
            # The mean of what one look tells and of what two do is righter than either.
            logits = (np.log(_shares(logits)) + np.log(_shares(both[0].astype(np.float64)))) / 2
        return dict(zip(PRINTS, _shares(logits).tolist(), strict=True))


def _shares(logits: Array) -> Array:
    return np.exp(logits - np.logaddexp.reduce(logits))


def alone(pixels: Pixels, mask: NDArray[np.float32]) -> Pixels:
    """(SIZE, SIZE, 3) the square around a garment, with its mean colour where it is not.

    Args:
        pixels: (h, w, 3) sRGB.
        mask: (h, w) 0 to 1: where it is, somewhere surely.
    """
    rows, columns = (np.flatnonzero((mask > _WELL_WITHIN).any(axis=k)) for k in (1, 0))
    high, wide = int(np.ptp(rows)) + 1, int(np.ptp(columns)) + 1
    side = max(high, wide)
    square = int(columns[0]) - (side - wide) // 2, int(rows[0]) - (side - high) // 2, side
    grey = np.repeat((255 * mask).astype(np.uint8)[..., None], 3, axis=2)
    shown, share = cut_square(pixels, square, SIZE), cut_square(grey, square, SIZE) / 255
    inside = share[..., 0] > _WELL_WITHIN
    mean = shown[inside].mean(axis=0) if inside.any() else shown.mean(axis=(0, 1))
    return (shown * share + mean * (1 - share)).astype(np.uint8)


def square_of_cloth(mask: NDArray[np.float32]) -> Square | None:
    """The largest square of a picture that shows nothing but a garment; None where there is hardly any.

    Args:
        mask: (h, w) 0 to 1: where the garment is.
    """
    from scipy.ndimage import distance_transform_cdt

    step = max(-(-max(mask.shape) // _FINEST), 1)
    depth = distance_transform_cdt(np.pad(mask[::step, ::step] > _WELL_WITHIN, 1), "chessboard")[1:-1, 1:-1]
    row, column = (int(k) for k in np.unravel_index(int(depth.argmax()), depth.shape))
    reach = int(depth[row, column]) - 1
    side = (2 * reach + 1) * step
    return ((column - reach) * step, (row - reach) * step, side) if side >= _LEAST_SIDE else None
