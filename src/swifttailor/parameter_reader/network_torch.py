"""The network that reads design parameters, and its model file. It loads torch."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional as F

from swifttailor.networks.model_file import write_graph
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.parameter_reader.reader import INPUTS, KIND, OUTPUTS
from swifttailor.picture_reader.labels import labels_checksum
from swifttailor.programs.read_parameter import ReadParameter


class ParameterNetwork(nn.Module):
    """From what is known to the logits of all values of all parameters."""

    def __init__(self, features: int, values: int, *, width: int, blocks: int, dropout: float) -> None:
        """With random weights.

        Args:
            features: Numbers that it is told.
            values: Of all parameters together.
            width: Of what is between.
            blocks: Residual ones.
            dropout: Share of what is between that is left out in training.
        """
        super().__init__()
        self.first = nn.Linear(features, width)
        self.blocks = nn.ModuleList(
            nn.Sequential(
                nn.LayerNorm(width),
                nn.Linear(width, width),
                nn.GELU(),
                nn.Dropout(dropout),
                nn.Linear(width, width),
            )
            for _ in range(blocks)
        )
        self.last = nn.Sequential(nn.LayerNorm(width), nn.Linear(width, values))

    def forward(self, features: Tensor) -> Tensor:
        """(B, features) to (B, values)."""
        state = F.gelu(self.first(features))
        for block in self.blocks:
            state = state + block(state)
        return self.last(state)


def export(
    network: ParameterNetwork, parameters: tuple[ReadParameter, ...], card: dict[str, Any], path: Path
) -> Path:
    """Writes the model file, which `ParameterReader.load` opens.

    Args:
        network: Trained.
        parameters: What its outputs stand for.
        card: What it was trained on, and how good it is.
        path: File to write, ``.onnx``.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    with torch.no_grad():  # rounded to what half as many bytes hold
        for weight in network.parameters():
            weight.copy_(weight.half().float())
    example = torch.zeros(1, network.first.in_features)
    graph = export_graph(network.eval(), (example,), ({},), INPUTS, OUTPUTS)
    says = {"labels_sha256": labels_checksum(), "parameters": [one.to_json() for one in parameters]}
    return write_graph(path, KIND, graph, card, **says)
