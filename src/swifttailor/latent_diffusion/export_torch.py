"""Writes the model file of a latent diffusion. It loads torch."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import torch

from swifttailor.latent_diffusion.designer import DECODER, DECODES, DENOISER, DENOISES, KIND
from swifttailor.latent_diffusion.network_torch import LATENTS, WIDE, Denoiser, WholeDecoder
from swifttailor.networks.model_file import write_archive
from swifttailor.networks.onnx_export_torch import export_graph
from swifttailor.picture_reader.labels import labels_checksum


def export(denoiser: Denoiser, decoder: WholeDecoder, card: dict[str, Any], path: Path) -> Path:
    """Writes the model file, which `LatentDesigner.load` opens.

    Args:
        denoiser: Trained.
        decoder: For what it draws.
        card: What they were trained on, and how good they are.
        path: File to write, ``.zip``; another of that name is replaced.

    Raises:
        InputError: The file cannot be written.
        MissingExtraError: onnx or onnxscript is not installed.
    """
    with torch.no_grad():  # rounded to what half as many bytes hold
        for module in (denoiser, decoder):
            for weight in module.parameters():
                weight.copy_(weight.half().float())
    noisy, latents = torch.zeros(2, LATENTS, WIDE), torch.zeros(1, LATENTS, WIDE)
    example = noisy, torch.zeros(2), torch.zeros(2, denoiser.features)
    graphs = {
        DENOISER: export_graph(denoiser.eval(), example, ({}, {}, {}), *DENOISES),
        DECODER: export_graph(decoder.eval(), (latents,), ({},), *DECODES),
    }
    card = card | {"labels_sha256": labels_checksum()}
    members = {f"{name}.onnx": graph for name, graph in graphs.items()}
    return write_archive(path, KIND, members, card, overwrite=True)
