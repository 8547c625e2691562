"""``swifttailor train export``: from the folder of a training to the file that is used without torch."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from swifttailor.errors import InputError

MOST_APART_CM = 0.01


@dataclass(frozen=True, kw_only=True)
class TrainExport:
    """Write a trained GarmentSewer as one .onnx file, for swifttailor sew --weights FILE.

    Needs the extra 'train'. The file holds the weights and the card; it is compared with the network it was
    made of before it is kept.
    """

    source: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="RUN")]
    """Folder of a training."""
    out: Annotated[Path, tyro.conf.arg(metavar="FILE")]
    """File to write, ending in .onnx."""

    def run(self) -> int:
        """Exports, prints how far both are apart, and returns the exit code.

        Raises:
            SwiftTailorError: The folder holds no trained network, or something is not installed.
        """
        from swifttailor.training.extra import require_training_packages

        if self.out.suffix != ".onnx":
            raise InputError(f"'{self.out}' does not end in .onnx; choose another --out.")
        require_training_packages("Writing a model file")
        from swifttailor.garment_sewer.export_torch import compare, export, read_card, torch_model
        from swifttailor.garment_sewer.model_file import load_model
        from swifttailor.training.run_record import WEIGHTS

        card = read_card(self.source)
        weights = self.source / WEIGHTS
        export(weights, card, self.out)
        apart = compare(load_model(self.out), torch_model(weights, card))
        if not apart < MOST_APART_CM:
            self.out.unlink()
            raise InputError(
                f"The exported network predicts {apart:.3g} cm from torch; at most {MOST_APART_CM} cm "
                "is accepted. Try other versions of torch and onnxruntime."
            )
        size = self.out.stat().st_size / 1e6
        print(f"Wrote {self.out}, {size:.1f} MB; at most {apart:.2g} cm from torch's predictions.")  # noqa: T201
        return 0
