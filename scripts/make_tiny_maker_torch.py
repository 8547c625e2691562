"""Makes tests/pattern_maker/tiny_maker.zip: an untrained network for tests where torch is not installed.

Needs the extra `train`: ``python scripts/make_tiny_maker_torch.py``
"""

from __future__ import annotations

from pathlib import Path

import torch

from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern_maker.network.building_torch import build_network
from swifttailor.pattern_maker.network.export_torch import make_graphs
from swifttailor.pattern_maker.network.model_file import write_model
from swifttailor.training.config_file import config_values
from swifttailor.training.maker_config import read_config

FILE = Path(__file__).parents[1] / "tests/pattern_maker/tiny_maker.zip"
SHAPE = [
    "network.hidden_size=16",
    "network.layers=1",
    "network.heads=2",
    "network.key_value_heads=1",
    "network.intermediate_size=16",
    "network.vision_hidden_size=16",
    "network.vision_layers=1",
    "network.vision_heads=2",
    "network.image_size=32",
    "network.longest_text=32",
]


def main() -> None:
    config = read_config("small", SHAPE)
    text = TextTokenizer.shipped()
    torch.manual_seed(0)
    network = build_network(config.network, text.size)
    for weight in (network.counterpart_in.weight, network.counterpart_head[2].weight):
        torch.nn.init.normal_(weight, std=0.5)  # else it would repeat nothing
    write_model(FILE, make_graphs(network), text, {"model": "PatternMaker", "config": config_values(config)})
    print(f"Wrote {FILE}, {FILE.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
