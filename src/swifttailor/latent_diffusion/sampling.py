"""Drawing latents: the implicit sampler of diffusion models (DDIM), with classifier-free guidance."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats

Velocity = Callable[[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]], NDArray[np.float32]]
"""Of (2, LATENTS, WIDE) noisy latents at (2,) times for (2, features)."""
STEPS = 20
_FARTHEST = 4.0
"""Latents are no farther than this from their mean, in their spread."""


def drawn_latents(
    velocity: Velocity,
    features: NDArray[np.float32],
    shape: tuple[int, int],
    *,
    seed: int,
    guidance: float,
    steps: int = STEPS,
) -> Floats:
    """Latents (LATENTS, WIDE) in units of their spread, drawn for what is known of a garment.

    Args:
        velocity: The denoiser.
        features: (features,) of `parameter_reader.features`.
        shape: Of the latents.
        seed: Of the noise that it begins with; nothing else is drawn.
        guidance: How far the answer goes from that to nothing towards that to what is known, and beyond: 1 is
            the answer as it is.
        steps: Of the sampler.
    """
    both = np.stack([features, np.zeros_like(features)])
    now = np.random.default_rng(seed).standard_normal(shape)
    angles = np.linspace(1.0, 0.0, steps + 1) * np.pi / 2
    for k, angle in enumerate(angles[:-1]):
        noisy = np.stack([now, now]).astype(np.float32)
        time = np.full(2, angle * 2 / np.pi, np.float32)
        told, untold = velocity(noisy, time, both).astype(float)
        speed = untold + guidance * (told - untold)
        clean = np.clip(np.cos(angle) * now - np.sin(angle) * speed, -_FARTHEST, _FARTHEST)
        # The noise that, added to what was clipped, gives what there is now; at the start all is noise.
        noise = (now - np.cos(angle) * clean) / np.sin(angle)
        now = np.cos(angles[k + 1]) * clean + np.sin(angles[k + 1]) * noise
    return now
