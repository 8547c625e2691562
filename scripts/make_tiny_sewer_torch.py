"""Makes tests/garment_sewer/tiny_sewer.onnx: an untrained network for tests where torch is not installed.

Its last layer is zero, so it predicts its prior exactly. Needs the extra `train`:
``python scripts/make_tiny_sewer_torch.py``
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import torch
from safetensors.torch import save_file

from swifttailor.garment_sewer.export_torch import export
from swifttailor.garment_sewer.network_torch import build_network
from swifttailor.training.config_file import config_values
from swifttailor.training.sewer_config import read_config

FILE = Path(__file__).parents[1] / "tests/garment_sewer/tiny_sewer.onnx"
SHAPE = [
    "network.resolution=64",
    "network.patch_size=8",
    "network.hidden_size=16",
    "network.layers=4",
    "network.heads=2",
    "network.decoder_sizes=[8, 8, 8, 8]",
    "network.fusion_size=8",
    "network.input_skip=4",
    'conditioning.channels=["occupancy", "prior", "body_distance"]',
]


def main() -> None:
    config = read_config("small", SHAPE)
    torch.manual_seed(0)
    network = build_network(config.network, config.conditioning.count)
    with tempfile.TemporaryDirectory() as folder:
        weights = Path(folder) / "weights.safetensors"
        save_file({k: v.contiguous() for k, v in network.state_dict().items()}, weights)
        export(weights, {"model": "GarmentSewer", "config": config_values(config)}, FILE)
    print(f"Wrote {FILE}, {FILE.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
