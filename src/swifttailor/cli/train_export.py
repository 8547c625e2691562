"""``swifttailor train export``: from the folder of a training to the file that is used without torch."""

from __future__ import annotations

import hashlib
import json
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from swifttailor.atomic_files import require_free, write_bytes, write_text
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place
from swifttailor.errors import InputError

MOST_APART_CM = 0.01
MOST_APART_INT8 = 0.1
"""With products of 8 bits, of the largest prediction."""
MOST_APART = 1e-3
"""Of the values of a PatternMaker's layers, relative to the largest."""
MOST_APART_LOGITS = 0.01
"""Of a reader."""
_MODELS = {
    "GarmentSewer": ".onnx",
    "PatternMaker": ".zip",
    "WishReader": ".onnx",
    "SpokenReader": ".onnx",
    "PictureReader": ".onnx",
}


@dataclass(frozen=True, kw_only=True)
class TrainExport:
    """Write a trained network as one file: .zip of a PatternMaker, .onnx of any other.

    Needs the extra 'train'. The file holds the weights and the card, which is also written beside it as JSON,
    with the file's checksum; it is compared with the network it was made of before it is kept.
    """

    source: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="RUN")]
    """Folder of a training."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """File to write, ending in .onnx or .zip. Default: a new one in the current folder, named after RUN."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the file, and its card, where there are any."""
    half: tyro.conf.FlagCreatePairsOff[bool] = False
    """Round the weights to 16 bits, which halves the file; it computes with 32 all the same."""
    int8: tyro.conf.FlagCreatePairsOff[bool] = False
    """Compute the matrix products of a GarmentSewer or a reader of people's own words with 8-bit integers,
    which takes half the time on a CPU, and round the other weights to 16 bits; of a picture reader store the
    matrices in 8 bits, a quarter of the file, and compute with 32. Evaluate it beside --half before use."""
    data: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """What to measure certainties with, part of the file: the data set with renders that a PatternMaker was
    trained on, or a split of garments that a picture reader was not trained on."""
    close_ups: tuple[str, ...] = ()
    """Of a picture reader: what it is to look at from near, of neck, waist, sleeve and leg; without this all
    that it has learnt from."""

    def run(self) -> int:
        """Exports, prints how far both are apart, and returns the exit code.

        Raises:
            SwiftTailorError: The folder holds no trained network, or something is not installed.
        """
        from swifttailor.picture_reader.seen_design import IN_CARD
        from swifttailor.training.extra import require_training_packages

        if self.out is not None and self.out.suffix not in _MODELS.values():
            raise InputError(f"'{self.out}' does not end in .onnx or .zip; choose another --out.")
        require_training_packages("Writing a model file")
        model = _model_of(self.source)
        out = self.out if self.out is not None else new_place(self.source.resolve().name, _MODELS[model])
        if out.suffix != _MODELS[model]:
            raise InputError(f"The file of a {model} ends in {_MODELS[model]}; choose another --out.")
        if self.data is not None and model not in ("PatternMaker", "PictureReader"):
            raise InputError(
                f"--data is for a PatternMaker or a PictureReader; a {model} is shown no pictures."
            )
        if self.int8 and model not in ("GarmentSewer", "PictureReader", "SpokenReader"):
            raise InputError(
                "--int8 is for a GarmentSewer, a PictureReader or a SpokenReader; "
                f"choose --half for a {model}."
            )
        if self.close_ups and model != "PictureReader":
            raise InputError(f"--close-ups is for a PictureReader; a {model} looks at nothing from near.")
        beside = out.with_suffix(".json")
        for path in (out, beside):
            require_free(path, overwrite=self.overwrite)
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder) / out.name
            said = self._export(model, made)
            written = made.read_bytes()
        card = json.loads((self.source / "card.json").read_text(encoding="utf-8"))
        card.pop(IN_CARD, None)  # the file has them
        card["file"] = {"bytes": len(written), "sha256": hashlib.sha256(written).hexdigest()}
        write_bytes(out, written, overwrite=self.overwrite)
        write_text(beside, json.dumps(card, indent=1, allow_nan=False) + "\n", overwrite=self.overwrite)
        print(f"Wrote {out}, {len(written) / 1e6:.1f} MB; {said}.")  # noqa: T201
        return 0

    def _export(self, model: str, out: Path) -> str:
        """Writes the model file and says how far it is from the network."""
        if model == "GarmentSewer":
            return _export_sewer(self.source, out, self.half, self.int8)
        if model in ("WishReader", "SpokenReader"):
            return _export_reader(self.source, out, self.half, self.int8)
        if model == "PictureReader":
            return _export_eyes(
                self.source, out, half=self.half, int8=self.int8, data=self.data, close_ups=self.close_ups
            )
        said = _export_maker(self.source, out, self.half)
        return f"{said}; {_calibrate(out, self.data)}"


def _model_of(run: Path) -> str:
    try:
        model = json.loads((run / "card.json").read_text(encoding="utf-8"))["model"]
        if model not in _MODELS:
            raise ValueError(f"the model is {model!r}")
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(f"'{run}' holds no card.json of a trained network: {error}.") from error
    return model


def _export_sewer(run: Path, out: Path, half: bool, int8: bool) -> str:
    from swifttailor.garment_sewer.export_torch import compare, export, read_card, torch_model
    from swifttailor.garment_sewer.model_file import load_model
    from swifttailor.training.run_record import WEIGHTS

    card = read_card(run)
    weights = run / WEIGHTS
    half = half or int8
    export(weights, card, out, half=half, int8=int8)
    found = compare(load_model(out), torch_model(weights, card, half=half))
    limit = MOST_APART_INT8 * found.reach_cm if int8 else MOST_APART_CM
    if not found.apart_cm < limit:
        raise InputError(
            f"The exported network predicts {found.apart_cm:.3g} cm from torch; less than {limit:.3g} cm "
            "is accepted. Try other versions of torch and onnxruntime."
        )
    return f"at most {found.apart_cm:.2g} cm from torch's predictions"


def _export_maker(run: Path, out: Path, half: bool) -> str:
    from swifttailor.pattern_maker.network.export_torch import compare, export, load_weights
    from swifttailor.pattern_maker.network.model_file import load_model
    from swifttailor.pattern_maker.network.runtime_torch import TorchRuntime
    from swifttailor.training.run_record import CARD, WEIGHTS

    card = json.loads((run / CARD).read_text(encoding="utf-8"))
    export(run / WEIGHTS, card, out, half=half)
    model = load_model(out)
    network = TorchRuntime(load_weights(run / WEIGHTS, card, model.text.size, half=half))
    apart = compare(model.runtime, network, model.text.size, image_size=model.image_size)
    if not apart < MOST_APART:
        raise InputError(
            f"The exported network differs from torch by {apart:.3g} of its values; at most {MOST_APART} "
            "is accepted. Try other versions of torch and onnxruntime."
        )
    return f"at most {apart:.2g} of a value from torch"


def _export_reader(run: Path, out: Path, half: bool, int8: bool) -> str:
    from swifttailor.training.run_record import CARD, WEIGHTS
    from swifttailor.wishes.export_torch import compare, export, load_weights
    from swifttailor.wishes.reader import WishReader

    card = json.loads((run / CARD).read_text(encoding="utf-8"))
    network = load_weights(run / WEIGHTS, card, half=half or int8, int8=int8)
    load = WishReader.load_spoken if card["model"] == "SpokenReader" else WishReader.load
    apart, reach = compare(load(export(network, card, out, int8=int8)), network)
    return _near_logits(apart, MOST_APART_INT8 * reach if int8 else MOST_APART_LOGITS)


def _export_eyes(
    run: Path, out: Path, *, half: bool, int8: bool, data: Path | None, close_ups: tuple[str, ...]
) -> str:
    from swifttailor.picture_reader.export_torch import compare, export, load_weights
    from swifttailor.picture_reader.reader import PictureReader
    from swifttailor.training.run_record import CARD, WEIGHTS

    card = json.loads((run / CARD).read_text(encoding="utf-8"))
    network = load_weights(run / WEIGHTS, card, half=half or int8, eight_bits=int8)
    scales, said = None, "how sure it is was not measured (--data)"
    if data is not None:
        found = _calibrated(network, card, data)
        scales = found.scales
        said = f"its certainties are off by {found.after:.3f} on average, before {found.before:.3f}"
    written = export(network, card, out, scales, close_ups or None)
    apart = compare(PictureReader.load(written), network)
    return f"{_near_logits(apart, MOST_APART_LOGITS)}; {said}"


def _calibrated(network: Any, card: dict[str, Any], data: Path) -> Any:
    import torch

    from swifttailor.cli.progress import print_line
    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.training.config_file import changed_config
    from swifttailor.training.picture_config import PictureConfig
    from swifttailor.training.picture_validation_torch import ValidationPictures, calibrate

    bank = PictureBank([data])
    bank.prepare(report=print_line)
    config = changed_config(PictureConfig(), card["config"])
    return calibrate(network, ValidationPictures(bank, config), torch.device("cpu"))


def _near_logits(apart: float, limit: float) -> str:
    if not apart < limit:
        raise InputError(
            f"The exported network differs from torch by {apart:.3g}; less than {limit:.3g} is "
            "accepted. Try other versions of torch and onnxruntime."
        )
    return f"at most {apart:.2g} from torch's logits"


def _calibrate(path: Path, data: Path | None) -> str:
    """Adds to a PatternMaker's file how sure it is of pictures, where there are any to measure it with."""
    if data is None:
        return "how sure it is of pictures was not measured (--data)"
    from swifttailor.cli.progress import print_line
    from swifttailor.pattern_maker.asking.confidence import DOUBT
    from swifttailor.pattern_maker.maker import PatternMaker
    from swifttailor.pattern_maker.network.model_file import add_calibration
    from swifttailor.training.maker_calibration import calibrate_by_renders

    found = calibrate_by_renders(PatternMaker.load(path), data, report=print_line)
    add_calibration(path, found)
    doubted = ", ".join(f"{share:.0%} of {kind}" for kind, share in found.doubted.items())
    return f"by {found.measure} it doubts {DOUBT:.0%} of {found.pictures} pictures of garments, {doubted}"
