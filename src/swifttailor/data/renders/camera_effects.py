"""What cameras and the web do to a picture: exposure, colour cast, blur, noise, few pixels, JPEG."""

from __future__ import annotations

import io
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.ndimage import uniform_filter1d

from swifttailor.arrays import Array, Pixels

_NOISE_SIDE = 512
_KNEE = 0.8
"""Level above which highlights are compressed."""


@dataclass(frozen=True)
class CameraEffects:
    """What is done to a picture, in this order; the defaults do nothing."""

    pixels: float = 1.0
    """Share of the pixels along each side that are left before it is scaled up again."""
    blur: int = 0
    """Pixels over which light is spread, twice over."""
    shake: int = 0
    """Pixels over which the camera moved, across."""
    exposure: float = 0.0
    """Stops."""
    warmth: float = 0.0
    """Relative gain of red, and loss of blue."""
    contrast: float = 1.0
    vignette: float = 0.0
    """Share of light that corners lose."""
    noise: float = 0.0
    """Deviation in grey levels."""
    noise_at: tuple[int, int] = (0, 0)
    """Where in the fixed noise it begins."""
    jpeg: int = 0
    """Quality, 1 to 100; 0 for none."""

    def apply(self, picture: Pixels) -> Pixels:
        """A picture (h, w, 3) uint8 sRGB as the camera gives it."""
        from PIL import Image

        height, width = picture.shape[:2]
        if self.pixels < 1.0:
            few = max(8, int(width * self.pixels)), max(8, int(height * self.pixels))
            image = Image.fromarray(picture).resize(few, Image.Resampling.BILINEAR)
            picture = np.asarray(image.resize((width, height), Image.Resampling.BICUBIC))
        for axis, spread in ((0, self.blur), (1, self.blur), (1, self.shake)):
            if spread > 1:
                picture = uniform_filter1d(picture, spread, axis)
        if self.exposure or self.warmth or self.contrast != 1.0:
            picture = _through(picture, _curves(self.exposure, self.warmth, self.contrast))
        if self.vignette or self.noise:
            levels = picture.astype(np.int16)
            if self.vignette:
                y, x = (np.linspace(-1, 1, n, dtype=np.float32) for n in (height, width))
                dark = np.float32(self.vignette * 0.5) * (y[:, None] ** 2 + x[None] ** 2)
                levels -= (levels * dark[:, :, None]).astype(np.int16)
            if self.noise:
                a, b = self.noise_at
                part = _noise()[a : a + height, b : b + width]
                part = part if part.shape == levels.shape else np.resize(_noise(), levels.shape)
                levels += (part * np.float32(self.noise)).astype(np.int16)
            picture = np.clip(levels, 0, 255).astype(np.uint8)
        if self.jpeg:
            file = io.BytesIO()
            Image.fromarray(picture).save(file, "JPEG", quality=self.jpeg)
            with Image.open(file, formats=["JPEG"]) as image:
                picture = np.array(image)
        return picture


def random_effects(chance: np.random.Generator) -> CameraEffects:
    """Effects drawn by lot; most are slight, and most pictures have few."""
    seldom = chance.random(6)
    return CameraEffects(
        pixels=float(chance.uniform(0.35, 0.8)) if seldom[0] < 0.22 else 1.0,
        blur=int(chance.integers(2, 5)) if seldom[1] < 0.18 else 0,
        shake=int(chance.integers(2, 6)) if seldom[2] < 0.06 else 0,
        exposure=float(chance.normal(0.0, 0.3)),
        warmth=float(chance.normal(0.0, 0.07)),
        contrast=float(chance.normal(1.0, 0.10)),
        vignette=float(chance.uniform(0.05, 0.45)) if seldom[3] < 0.25 else 0.0,
        noise=float(chance.gamma(1.5, 2.0)) if seldom[4] < 0.4 else 0.0,
        noise_at=(int(chance.integers(200)), int(chance.integers(200))),
        jpeg=int(chance.integers(30, 92)) if seldom[5] < 0.4 else 0,
    )


def _curves(exposure: float, warmth: float, contrast: float) -> Array:
    """(3, 256) uint8: the new level of each level of red, green and blue."""
    level = np.arange(256) / 255.0
    gains = 2.0**exposure * np.array([[1 + warmth], [1.0], [1 - warmth]])
    bright = np.clip(level[None] * np.maximum(gains, 0.05) ** (1 / 2.2), 0, None)
    over = np.clip(bright - _KNEE, 0, None)
    bright = np.minimum(bright, _KNEE) + (1 - _KNEE) * np.tanh(over / (1 - _KNEE))  # highlights roll off
    return np.clip(((bright - 0.5) * contrast + 0.5) * 255 + 0.5, 0, 255).astype(np.uint8)


def _through(picture: Pixels, curves: Array) -> Pixels:
    return np.stack([np.take(curves[k], picture[:, :, k]) for k in range(3)], axis=2)


@cache
def _noise() -> Array:
    """(side, side, 3) float32 of deviation 1, mostly the same in all channels, a little soft."""
    chance = np.random.default_rng(7)
    grey = chance.normal(size=(_NOISE_SIDE, _NOISE_SIDE, 1))
    noise = grey + 0.5 * chance.normal(size=(_NOISE_SIDE, _NOISE_SIDE, 3))
    noise = noise + 0.7 * np.roll(noise, 1, axis=1) + 0.5 * np.roll(noise, 1, axis=0)
    return (noise / noise.std()).astype(np.float32)
