"""How a picture is to look: cloth, body, light, backdrop and camera, fixed or drawn by lot."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass

import numpy as np

from swifttailor.render import Camera, Checks, Dots, Light, Lighting, Plain, Print, Stripes, to_linear
from swifttailor.render.lighting import STUDIO

VIEWS = ("front", "back", "free")
"""Around 0 degrees, around 180, and from anywhere."""

Rgb = tuple[float, float, float]
"""Linear light."""

_NEUTRALS = (
    "#f4f2ee",
    "#d9d6cf",
    "#a7a5a0",
    "#5b5b5d",
    "#26262a",
    "#e6d8bf",
    "#b59a77",
    "#20304f",
    "#6f5b4b",
)
_SKINS = ("#f0d2bc", "#d9a98a", "#a9754f", "#6d472f", "#3f2a20")
_VISIBLE = 0.15
"""Least difference between the colours of cloth and body, in the square roots of linear light."""
_MANNEQUINS = ("#c9bfb6", "#e9e6e1", "#8d8b89", "#1b1b1d")


@dataclass(frozen=True)
class View:
    """Where the camera stands and how much of the figure it shows."""

    azimuth: float = 0.0
    """Degrees; see `render.Camera`."""
    elevation: float = 5.0
    field_of_view: float = 16.0
    whole_body: bool = True
    """Whether the picture shows the stature of the body, else the garment alone fills it."""
    margin: float = 0.06
    """Free space around that, as a share of its height."""
    shift: tuple[float, float] = (0.0, 0.0)
    """By how much the middle is off, as a share of the picture's height."""
    camera: Camera | None = None
    """A fixed camera instead of all of this."""


@dataclass(frozen=True)
class Backdrop:
    """What is behind the figure."""

    top: Rgb = (1.0, 1.0, 1.0)
    bottom: Rgb = (1.0, 1.0, 1.0)
    cloudy: float = 0.0
    """Strength of blotches, 0 to 1."""
    seed: int = 0


@dataclass(frozen=True)
class Look:
    """All that makes two pictures of one garment different."""

    print: Print
    inside: Rgb
    """The wrong side of the cloth."""
    view: View = View()
    body: Rgb | None = (0.58, 0.52, 0.47)
    """None: the garment alone."""
    backdrop: Backdrop = Backdrop()
    lighting: Lighting = STUDIO
    seams: float = 0.3
    """How dark seams and hems are drawn, 0 to 1."""
    shadows: bool = True
    panel_colors: tuple[Rgb, ...] = ()
    """Colours of consecutive panels instead of the print, repeated as needed."""


def random_look(chance: np.random.Generator, view: str) -> Look:
    """A look drawn by lot.

    Args:
        chance: Where the lots come from; the same state gives the same look.
        view: One of `VIEWS`.
    """
    cloth = _random_print(chance)
    base = cloth.colors(np.zeros((1, 2), np.float32))[0].astype(np.float64)
    grey = float(base @ (0.2126, 0.7152, 0.0722))
    inside = 0.75 * (0.6 * base + 0.4 * grey) + 0.03
    return Look(
        print=cloth,
        inside=_rgb(inside),
        view=_random_view(chance, view),
        body=_random_body(chance, base),
        backdrop=_random_backdrop(chance),
        lighting=random_lighting(chance),
        seams=float(chance.uniform(0.1, 0.45)) if chance.random() < 0.6 else 0.0,
    )


def _random_color(chance: np.random.Generator) -> Rgb:
    """Cloth is often white, black, grey, beige or navy, else any hue that dyers make."""
    if chance.random() < 0.35:
        base = to_linear(_NEUTRALS[chance.integers(len(_NEUTRALS))])
        return _rgb(np.clip(base * chance.uniform(0.85, 1.15, 3), 0.004, 0.92))
    hue, saturation, value = chance.random(), chance.uniform(0.2, 0.85), chance.uniform(0.25, 0.95)
    return _rgb(to_linear(colorsys.hsv_to_rgb(hue, saturation, value)))


def _random_print(chance: np.random.Generator) -> Print:
    first, second = _random_color(chance), _random_color(chance)
    if np.abs(np.subtract(first, second)).max() < 0.15:  # prints show
        second = (0.8, 0.8, 0.78) if max(first) < 0.4 else (0.02, 0.02, 0.03)
    grain, seed = float(chance.uniform(0.0, 0.08)), int(chance.integers(1 << 20))
    kind, angle = chance.random(), float(chance.choice([0.0, 90.0, 45.0, chance.uniform(0, 180)]))
    width = float(chance.uniform(1.2, 6.0))
    if kind < 0.6:
        return Plain(first, grain, seed)
    if kind < 0.78:
        return Stripes(first, second, width, width * float(chance.uniform(0.6, 2.5)), angle, grain, seed)
    if kind < 0.9:
        return Checks(first, second, width, angle if angle in (0.0, 45.0) else 0.0, grain, seed)
    spacing = float(chance.uniform(2.5, 9.0))
    return Dots(first, second, spacing, spacing * float(chance.uniform(0.15, 0.38)), angle, grain, seed)


def _random_view(chance: np.random.Generator, view: str) -> View:
    """A camera drawn by lot, for one of `VIEWS`."""
    around = {"front": chance.normal(0, 9), "back": 180 + chance.normal(0, 9), "free": chance.uniform(0, 360)}
    return View(
        azimuth=float(around[view]),
        elevation=float(np.clip(chance.normal(6, 6), -12, 30)),
        field_of_view=float(chance.uniform(0, 36)) if chance.random() < 0.85 else 0.0,
        whole_body=bool(chance.random() < 0.5),
        margin=float(chance.uniform(0.03, 0.2)),
        shift=(float(chance.normal(0, 0.02)), float(chance.normal(0, 0.02))),
    )


def _random_body(chance: np.random.Generator, cloth: np.ndarray) -> Rgb | None:
    """A skin or a mannequin that can be told from the cloth, or nobody."""
    kind = chance.random()
    if kind < 0.25:
        return None
    colors = [to_linear(c) * chance.uniform(0.9, 1.1) for c in (_SKINS if kind < 0.65 else _MANNEQUINS)]
    differs = [c for c in colors if np.abs(np.sqrt(c) - np.sqrt(cloth)).max() > _VISIBLE]
    return _rgb(differs[chance.integers(len(differs))])


def _random_backdrop(chance: np.random.Generator) -> Backdrop:
    kind, seed = chance.random(), int(chance.integers(1 << 20))
    if kind < 0.3:
        return Backdrop(seed=seed)
    shade = float(chance.beta(3, 1.2))
    tint = np.clip(shade * chance.uniform(0.85, 1.15, 3), 0.0, 1.0)
    if kind < 0.55:
        return Backdrop(_rgb(tint), _rgb(tint), seed=seed)
    other = np.clip(tint * chance.uniform(0.4, 1.3), 0.0, 1.0)
    return Backdrop(_rgb(tint), _rgb(other), float(chance.uniform(0, 0.5)) if kind > 0.8 else 0.0, seed)


def random_lighting(chance: np.random.Generator) -> Lighting:
    """Light drawn by lot."""
    azimuth, height = np.deg2rad(chance.uniform(-75, 75)), np.deg2rad(chance.uniform(15, 70))
    key = np.array([np.sin(azimuth) * np.cos(height), np.sin(height), np.cos(azimuth) * np.cos(height)])
    warmth = chance.normal(0, 0.06)
    tint = np.array([1 + warmth, 1.0, 1 - warmth])
    strength, room = chance.uniform(0.55, 1.15), chance.uniform(0.7, 1.4)
    return Lighting(
        key=Light(_rgb(key), _rgb(strength * tint), wrap=float(chance.uniform(0, 0.35))),
        fill=Light(_rgb(key * (-1, 0.3, 1)), _rgb(np.full(3, chance.uniform(0.05, 0.3))), wrap=0.3),
        rim=Light(_rgb(key * (-1, 1, -1)), _rgb(np.full(3, chance.uniform(0.0, 0.35)))),
        sky=_rgb(0.38 * room * tint[::-1]),
        ground=_rgb(np.full(3, 0.17 * room)),
    )


def _rgb(values: np.ndarray) -> Rgb:
    r, g, b = (float(v) for v in values)
    return r, g, b
