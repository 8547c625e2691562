"""Draws patterns for what is sought, by latent diffusion."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.latent_diffusion.sampling import drawn_latents
from swifttailor.latent_diffusion.tensor_layout import SHAPE
from swifttailor.latent_diffusion.tensor_pattern import pattern_of
from swifttailor.networks.model_file import ModelKind, open_model
from swifttailor.parameter_reader.features import features_of
from swifttailor.pattern import Pattern
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import labels_checksum

DENOISER, DECODER = "denoiser", "decoder"
DENOISES = ("noisy", "time", "features"), ("velocity",)
DECODES = ("latents",), ("tensor",)
KIND = ModelKind(
    "latent diffusion of patterns",
    "swifttailor latent-diffusion 1",
    2**26,
    ({DENOISER: DENOISES, DECODER: DECODES},),
    archive=True,
)


@dataclass(frozen=True, eq=False)
class LatentDesigner:
    """A latent diffusion, ready to draw."""

    sessions: dict[str, Any]
    """Of onnxruntime."""
    shape: tuple[int, int]
    """Of the latents."""
    guidance: float
    """Of what is drawn (`drawn_latents`)."""
    card: dict[str, Any]
    """What it was trained on, and how good it is."""

    @staticmethod
    def load(weights: Path | str, *, threads: int = 1) -> LatentDesigner:
        """Opens a model file.

        Args:
            weights: The file.
            threads: CPU cores for the networks.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(weights, KIND, threads=threads)
        with model.says("what it was told of garments"):
            card = model.about["card"]
            told, guidance = str(card["labels_sha256"]), float(card["config"]["sampler"]["guidance"])
        _, count, wide = model.shape_given(DECODER, "latents")
        model.require(
            {
                "what it is told": (told, labels_checksum()),
                "how much it is told": (
                    model.shape_given(DENOISER, "features")[1],
                    len(features_of(Sought.nothing())),
                ),
                "the shape of latents": (model.shape_given(DENOISER, "noisy")[1:], [count, wide]),
                "the shape of panel tensors": (model.shape_made(DECODER, "tensor")[1:], list(SHAPE)),
            }
        )
        return LatentDesigner(model.sessions, (count, wide), guidance, card)

    def draw(self, sought: Sought, *, seed: int, name: str = "pattern") -> Pattern:
        """Draws a pattern; what is wrong with it stays.

        Args:
            sought: What is known of a garment.
            seed: Of what is drawn.
            name: Of the pattern.

        Raises:
            InputError: The networks' numbers are not finite: the weights are damaged.
            PatternError: What was drawn is no pattern.
        """
        features = features_of(sought)
        latents = drawn_latents(self._velocity, features, self.shape, seed=seed, guidance=self.guidance)
        if not np.isfinite(latents).all():
            raise InputError("What the latent diffusion drew are no finite numbers: its weights are damaged.")
        fed = {"latents": latents[None].astype(np.float32)}
        return pattern_of(self.sessions[DECODER].run(None, fed)[0][0].astype(float), name=name)

    def _velocity(
        self, noisy: NDArray[np.float32], time: NDArray[np.float32], features: NDArray[np.float32]
    ) -> NDArray[np.float32]:
        return self.sessions[DENOISER].run(None, {"noisy": noisy, "time": time, "features": features})[0]
