"""Whether a picture is a photograph or was drawn, by a network that has learnt from photographs alone.

The trunk is that of `worn_heads`; a sum on what it makes of all of the picture tells
(`scripts/train_photograph_head_torch.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.arrays import Pixels
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.picture_reader.view import Square
from swifttailor.picture_reader.worn_heads import features_of

SHIPPED = Path(__file__).with_name("photograph_head.onnx")
INPUT, OUTPUT = "whole", "photograph"
KIND = ModelKind(
    "network that tells photographs from drawings",
    "swifttailor photograph head 1",
    1 << 20,
    ({GRAPH: ((INPUT,), (OUTPUT,))},),
)
LEAST_LOGIT = 2.0
"""What is less surely a photograph may be drawn: one in a hundred drawn people has more."""


@dataclass(frozen=True, eq=False)
class PhotographHead:
    """Tells photographs from drawings."""

    trunk: Any
    """Of onnxruntime: that of `worn_heads.WornHeads`."""
    session: Any
    """Of onnxruntime."""

    @staticmethod
    def load(trunk: Any, weights: Path | str | None = None, *, threads: int = 1) -> PhotographHead:
        """Opens a model file.

        Args:
            trunk: Of onnxruntime.
            weights: File; the one that comes with the package when None.
            threads: CPU cores for the sum.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        model.require({"what it says": (model.shape_made(GRAPH, OUTPUT), [1, 1])})
        return PhotographHead(trunk, model.sessions[GRAPH])

    def logit(self, pixels: Pixels, whole: Square) -> float:
        """How surely a picture is a photograph.

        Args:
            pixels: (h, w, 3) sRGB.
            whole: The square around all of it.
        """
        features = features_of(self.trunk, pixels, whole)[None]
        return float(self.session.run([OUTPUT], {INPUT: features})[0][0, 0])
