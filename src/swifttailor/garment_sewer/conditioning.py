"""What the network is shown of a pattern: image channels, by configuration.

`SEMANTIC` is the paper's conditioning, the colours of the panel types and nothing else. `PLACED` adds what
the pattern knows besides: where a geometric prior puts each pixel in space, where it lies on its panel,
what it is sewn to, and where the body is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.garment_sewer.pixels.pixel_table import PixelTable
from swifttailor.ggi.panel_cells import LAYOUT_KINDS, LayoutKind

PriorKind = Literal["none", "placed", "sewn", "hung"]
PRIORS: tuple[PriorKind, ...] = ("none", "placed", "sewn", "hung")

POSITION_CM = 50.0
"""Positions and offsets are divided by this for the network, so that they are of the order of one."""
CENTRE_Y_CM = 100.0
"""Subtracted from heights before."""
DISTANCE_CM = 10.0
FAR_CM = 30.0
"""Distances from the body are shown up to this, and inside it up to `DISTANCE_CM`."""

Columns = tuple[Any, ...]


def _color(t: PixelTable) -> Columns:
    rgb = t.panel_color[t.panel]
    return rgb[:, 0], rgb[:, 1], rgb[:, 2]


def _occupancy(t: PixelTable) -> Columns:
    return (_ones(t),)


def _position(points: Any) -> Columns:
    x, y, z = points[:, 0], points[:, 1], points[:, 2]
    return x / POSITION_CM, (y - CENTRE_Y_CM) / POSITION_CM, z / POSITION_CM


def _local(t: PixelTable) -> Columns:
    local = t.local()
    return local[:, 0] / POSITION_CM, local[:, 1] / POSITION_CM


def _normal(t: PixelTable) -> Columns:
    normal = t.panel_normal[t.panel]
    return normal[:, 0], normal[:, 1], normal[:, 2]


def _scale(t: PixelTable) -> Columns:
    logs = t.panel_log_cm[t.panel]
    return ((logs[:, 0] + logs[:, 1]) / 2,)


def _aspect(t: PixelTable) -> Columns:
    logs = t.panel_log_cm[t.panel]
    return ((logs[:, 0] - logs[:, 1]) / 2,)


def _stitched(t: PixelTable) -> Columns:
    return (_ones(t) * (t.partner >= 0),)


def _contour(t: PixelTable) -> Columns:
    return (_ones(t) * t.contour,)


def _partner(t: PixelTable) -> Columns:
    sewn = t.partner >= 0
    placed = t.placed()
    offset = (placed[t.partner * sewn] - placed) * sewn[:, None]
    return offset[:, 0] / POSITION_CM, offset[:, 1] / POSITION_CM, offset[:, 2] / POSITION_CM


def _partner_pixel(t: PixelTable) -> Columns:
    sewn = t.partner >= 0
    offset = (t.point[t.partner * sewn] - t.point) * sewn[:, None] / t.resolution
    return offset[:, 0], offset[:, 1]


def _body_distance(t: PixelTable) -> Columns:
    return (t.distance.clip(-DISTANCE_CM, FAR_CM) / DISTANCE_CM,)


def _body_direction(t: PixelTable) -> Columns:
    return t.direction[:, 0], t.direction[:, 1], t.direction[:, 2]


def _slope(t: PixelTable) -> Columns:
    """How the prior runs along the image's rows and columns: steps in space over steps on the panel.

    A length of one is unstretched. In the positions themselves, of the order of one, it is a difference of
    some thousandths.
    """
    local, columns = t.local(), []
    for step in (1, t.resolution):
        after, before = _neighbor(t, step), _neighbor(t, -step)
        along = t.prior[after] - t.prior[before]
        length = ((local[after] - local[before]) ** 2).sum(-1) ** 0.5
        columns += [along[:, k] / length.clip(1e-3) for k in range(3)]
    return tuple(columns)


def _neighbor(t: PixelTable, step: int) -> Any:
    """(n,) index of the pixel so many further on the same panel; its own where there is none."""
    size, own = t.resolution**2, _ones(t).cumsum(0) - 1
    own = own.astype(np.int64) if isinstance(own, np.ndarray) else own.long()
    places = np.zeros(size, np.int64) if isinstance(own, np.ndarray) else own.new_zeros(size)
    places[t.pixels] = own
    wanted = (t.pixels + step).clip(0, size - 1)
    found = places[wanted]
    there = (t.pixels[found] == wanted) & (t.panel[found] == t.panel)
    return own + (found - own) * there


def _ones(t: PixelTable) -> Any:
    return t.distance * 0.0 + 1.0


@dataclass(frozen=True)
class Channel:
    """Some channels of the input that belong together."""

    count: int
    columns: Callable[[PixelTable], Columns]
    """Of numpy arrays or torch tensors alike, (n,) each."""


CHANNELS: dict[str, Channel] = {
    "color": Channel(3, _color),  # the paper's: sRGB of the panel's type, -1 to 1
    "occupancy": Channel(1, _occupancy),
    "prior": Channel(3, lambda t: _position(t.prior)),
    "placed": Channel(3, lambda t: _position(t.placed())),
    "local": Channel(2, _local),  # panel-local position
    "normal": Channel(3, _normal),  # of the placed panel, outward
    "scale": Channel(1, _scale),  # log of cm per pixel; of the mean of columns and rows
    "stitched": Channel(1, _stitched),
    "contour": Channel(1, _contour),  # whether the pixel stands for a point of the outline
    "partner": Channel(3, _partner),  # from the placed pixel to the one it is sewn to
    "partner_pixel": Channel(2, _partner_pixel),  # the same in the image, in image widths
    "body_distance": Channel(1, _body_distance),  # at the prior
    "body_direction": Channel(3, _body_direction),
    "slope": Channel(6, _slope),  # of the prior, along rows and columns
    "aspect": Channel(1, _aspect),  # half the log of a pixel's width over its height; 0 in packed images
}
"""All there is, by name. Everything is 0 where there is no panel."""

SEMANTIC = ("color",)
PLACED = tuple(name for name in CHANNELS if name != "aspect")
PER_PANEL = tuple(CHANNELS)
"""What the network of images per panel is shown: to what its panel was stretched is not seen in the image."""


@dataclass(frozen=True)
class Conditioning:
    """Which channels, which prior they come from, and how the panels lie in the image."""

    prior: PriorKind = "hung"
    """``placed``: the flat panels where the pattern places them; ``sewn``: these sewn together around the
    body (`sewn_prior`); ``hung``: sewn and hung for a second on a coarse mesh (`drape_coarsely`); ``none``:
    no prior, for the paper's conditioning."""
    channels: tuple[str, ...] = PLACED
    layout: LayoutKind = "packed"
    """``packed``: all panels in one square at one scale; ``per_panel``: each panel's box stretched to a cell
    of its own, the cells in a grid (`lay_out_in_cells`)."""

    def __post_init__(self) -> None:
        unknown = [c for c in self.channels if c not in CHANNELS]
        if unknown or not self.channels or len(set(self.channels)) != len(self.channels):
            raise InputError(
                f"The channels are {', '.join(self.channels) or 'none'}; at least one of "
                f"{', '.join(CHANNELS)} is accepted, none of them twice."
            )
        if self.prior not in PRIORS:
            raise InputError(f"There is no prior '{self.prior}'. Known ones: {', '.join(PRIORS)}.")
        if self.layout not in LAYOUT_KINDS:
            raise InputError(f"There is no layout '{self.layout}'. Known ones: {', '.join(LAYOUT_KINDS)}.")
        needing = {"prior", "body_distance", "body_direction", "slope"} & set(self.channels)
        if self.prior == "none" and needing:
            raise InputError(
                f"The channel '{min(needing)}' needs a prior: choose placed or sewn, or leave it out."
            )

    @staticmethod
    def of_card(card: Mapping[str, Any]) -> Conditioning:
        """That of a trained network, from its card; cards without a layout are of packed images.

        Raises:
            InputError: The card names what is not known here.
            KeyError: It lacks what it must say.
        """
        shown = card["config"]["conditioning"]
        return Conditioning(shown["prior"], tuple(shown["channels"]), shown.get("layout", "packed"))

    @property
    def count(self) -> int:
        """Number of channels of the input image."""
        return sum(CHANNELS[c].count for c in self.channels)


def channel_columns(table: PixelTable, channels: Sequence[str]) -> list[Any]:
    """The values of all channels at the occupied pixels, (n,) each, of the kind the table is made of."""
    return [column for name in channels for column in CHANNELS[name].columns(table)]


def conditioning_image(table: PixelTable, conditioning: Conditioning) -> NDArray[np.float32]:
    """The network's input (C, N, N) of a table of numpy arrays, row 0 at the bottom."""
    size = table.resolution
    image = np.zeros((conditioning.count, size * size), np.float32)
    image[:, table.pixels] = channel_columns(table, conditioning.channels)
    return image.reshape(-1, size, size)
