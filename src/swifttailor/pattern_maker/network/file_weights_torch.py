"""The weights of a PatternMaker out of its model file. Import this where it is needed: it loads torch."""

from __future__ import annotations

from pathlib import Path

import torch
from torch import Tensor

from swifttailor.errors import InputError
from swifttailor.networks.graph_weights_torch import GraphTensors, graph_tensors, state_of
from swifttailor.networks.model_file import read_archive
from swifttailor.pattern_maker.network.model_file import KIND
from swifttailor.pattern_maker.network.network_torch import PatternMakerNetwork

_PREFIXES = {"plan": "foresight_head.", "panels": "panel_in."}
"""What stands before the names of a graph's weights in the network."""
_WITHOUT_BIAS = {"counterpart": "counterpart_in.weight", "planned": "planned_in.weight"}
"""The weight of the last product of a graph."""
_LAYER = 4
"""Products with weights in a layer of the decoder: keys with values and queries, out, gate with up, down."""


def file_weights(path: Path, network: PatternMakerNetwork) -> dict[str, Tensor]:
    """Reads weights for a network from the model file of one of its shape.

    Args:
        path: The .zip file.
        network: Tells names and shapes; not changed.

    Returns:
        A state for the network with which it computes what the file does; see `state_of`.

    Raises:
        InputError: The file is missing or damaged, or of a network of another shape.
        MissingExtraError: onnx is not installed.
    """
    _, members = read_archive(path, KIND)
    values: dict[str, Tensor] = {}
    for member, data in members.items():
        graph = member.removesuffix(".onnx")
        if graph == member:
            continue
        tensors = graph_tensors(data, f"{path}, {member}")
        if graph == "decoder":
            values |= _decoder_weights(tensors, network, path)
            continue
        prefix = _PREFIXES.get(graph, "")
        for name, value in tensors.named.items():
            place = name.removeprefix("network.")
            if prefix:
                place = prefix + place.removeprefix("head.")
            if "." in name:  # others are no weights, but constants of the graph
                values[place] = value
        if graph in _WITHOUT_BIAS:
            values[_WITHOUT_BIAS[graph]] = tensors.matrices[-1]
    return state_of(values, network, path)


def _decoder_weights(tensors: GraphTensors, network: PatternMakerNetwork, path: Path) -> dict[str, Tensor]:
    """By their names in the network: `CachedDecoder` has joined some of them."""
    own = network.state_dict()
    layers = len(network.vlm.language_model.layers)
    if len(tensors.matrices) != _LAYER * layers + 1:
        raise InputError(
            f"The model file '{path}' is of another network: it has {len(tensors.matrices) // _LAYER} "
            f"layers, not {layers}. Set network.* as its card says."
        )
    model = "vlm.language_model"
    found = {f"{model}.norm.weight": tensors.named["norm"], "token_head.weight": tensors.matrices[-1]}
    for number in range(layers):
        joined, out, gate_up, down = tensors.matrices[_LAYER * number : _LAYER * (number + 1)]
        layer, attention = f"{model}.layers.{number}", f"{model}.layers.{number}.self_attn"
        parts = [f"{attention}.{name}_proj" for name in "qkv"]
        heights = [own[f"{part}.weight"].shape[0] for part in parts]
        if sum(heights) != len(joined):
            raise InputError(
                f"The model file '{path}' is of another network. Set network.* as its card says."
            )
        bias = torch.split(tensors.named[f"layers.{number}.qkv_bias"], heights)
        for part, matrix, of_part in zip(parts, torch.split(joined, heights), bias, strict=True):
            found |= {f"{part}.weight": matrix, f"{part}.bias": of_part}
        gate, up = gate_up.chunk(2)
        found |= {
            f"{attention}.o_proj.weight": out,
            f"{layer}.mlp.gate_proj.weight": gate,
            f"{layer}.mlp.up_proj.weight": up,
            f"{layer}.mlp.down_proj.weight": down,
            f"{layer}.input_layernorm.weight": tensors.named[f"layers.{number}.attention_norm"],
            f"{layer}.post_attention_layernorm.weight": tensors.named[f"layers.{number}.mlp_norm"],
        }
    return found
