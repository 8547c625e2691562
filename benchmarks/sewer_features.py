"""Whether a trained GarmentSewer listens to its transformer: what becomes of predictions without it.

``python benchmarks/sewer_features.py RUN DATA [--garments 12]``

RUN is the folder of a training. Garments of DATA's validation split are predicted as they are, with the
transformer's features set to 0, and with those of another garment: mean change of the pixels' positions, and
mean error, in cm. Where the features of another garment change nothing, the network has learnt from its
convolutions alone. A hybrid's transformer hands on its coarsest convolutions' features as well: they count as
its own here. Needs the extra `train`.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from machine import describe
from swifttailor.data.reader import SplitReader
from swifttailor.training.config_file import changed_config
from swifttailor.training.sewer_config import SewerConfig
from swifttailor.training.sewer_samples import SewerSamples

Change = Callable[[Any], Any]
Predict = Callable[[], Any]


def main() -> None:
    import torch

    from swifttailor.garment_sewer.export_torch import load_weights
    from swifttailor.training.sewer_batch_torch import assemble, to_tensors

    torch.set_grad_enabled(False)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("run", type=Path)
    parser.add_argument("data", type=Path)
    parser.add_argument("--garments", type=int, default=12)
    options = parser.parse_args()
    card = json.loads((options.run / "card.json").read_text())
    config = changed_config(SewerConfig(), card["config"])
    reader = SplitReader(options.data / "validation")
    size, prior = config.network.resolution, config.conditioning.prior
    samples = SewerSamples(reader, options.data / "cache", size, prior, 1)
    for _ in samples.prepare(workers=1):
        pass
    step = max(1, len(reader) // options.garments)
    chosen = [to_tensors(samples.get(k, 0), torch.device("cpu")) for k in range(0, len(reader), step)]
    batch = assemble(chosen, config.conditioning)
    network = load_weights(options.run / "weights.safetensors", card)
    occupied = batch.truth.occupancy[:, 0] > 0

    def mean(vectors: torch.Tensor) -> float:
        return float(vectors.norm(dim=1)[occupied].mean())

    def predict() -> torch.Tensor:
        return network(batch.conditioning, batch.truth.occupancy, batch.prior)

    changed = features_of(network)
    whole = predict()
    without = changed(torch.zeros_like, predict)
    exchanged = changed(lambda features: features.roll(1, 0), predict)
    target = batch.truth.target
    print(describe())
    print(f"validation, every {step}: n = {len(chosen)}; cm")
    print(f"prior: error {mean(batch.prior - target):.3f}")
    print(f"as it is: error {mean(whole - target):.3f}")
    for name, found in (("features 0", without), ("of another garment", exchanged)):
        print(f"{name}: error {mean(found - target):.3f}, predictions moved by {mean(found - whole):.4f}")


def features_of(network: Any) -> Callable[[Change, Predict], Any]:
    """A function that predicts with features that are changed on their way."""
    reader = network.neck if hasattr(network, "neck") else network.encoder
    read = reader.forward

    def changed(change: Change, predict: Predict) -> Any:
        def forward(*given: Any) -> Any:
            found = read(*given)
            if isinstance(found, list):
                return [change(features) for features in found]
            found.last_hidden_state = change(found.last_hidden_state)
            return found

        reader.forward = forward
        try:
            return predict()
        finally:
            reader.forward = read

    return changed


if __name__ == "__main__":
    main()
