"""The print of a garment's cloth: stripes, checks, dots, motifs; in previews, and a texture in .glb files."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.hung_prints import height_planes, is_hung, worn_heights
from swifttailor.panel_mesh.cloth_places import shifts_across

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.render.prints import KnownPrint, LinearColor

PRINT = "print"
"""What a report calls it."""
KINDS = ("stripes", "checks", "plaid", "dots", "motif")
NAPS = ("curls", "cables", "sequins", "pile", "foil", "channels", "fur", "marl", "linen")
"""Motifs that are the face of cloth of one colour, their second: hollows darker, what stands out lighter."""
CUSHIONS = "channels"
"""That of puffed cloth, which has the lines of quilting."""
MOTIFS = (
    *("flowers", "leaves", "blotches", "spots", "shapes", "bands"),
    *(
        "hearts",
        "stars",
        "moons",
        "bolts",
        "cherries",
        "strawberries",
        "lemons",
        "mushrooms",
        "foxes",
        "cats",
    ),
    *(
        "bears",
        "rabbits",
        "birds",
        "butterflies",
        "bees",
        "fishes",
        "dinosaurs",
        "anchors",
        "boats",
        "splatters",
    ),
    *("cranes", "elephants", "dogs", "horses", "flamingos", "owls", "turtles", "pineapples", "skulls"),
    *("snowflakes", "crosses"),
    *("leopard", "zebra", "tiger", "giraffe", "cowhide", "dalmatian", "scales", "crocodile"),
    *("tie_dye", "batik", "marble", "clouds", "bleach", "ikat"),
    *("palms", "paisley", "lozenges", "argyle", "patchwork", "serape", "medallions", "waves", "triangles"),
    *NAPS,
    "sprigs",
    *("penguins", "pandas", "sharks", "whales", "unicorns", "parrots", "tigers", "rockets", "cacti"),
    *("daisies", "sunflowers"),
    *("galaxy", "camouflage", "zigzag", "herringbone", "rainbow", "ombre", "blocks", "aztec", "wax_print"),
    *("two_blocks", "four_blocks"),
    *("houndstooth", "granny_squares", "palm_trees"),
)
TEXTURE_SIDE = 2048
"""Pixels: a millimetre or two of cloth each."""
_SMALLEST_CM, _LARGEST_CM = 0.05, 200.0
_USUAL: Mapping[str, float] = {
    "width": 2.5,
    "gap": 2.5,
    "spacing": 4.0,
    "radius": 0.8,
    "repeat": 20.0,
    "angle": 0.0,
}
_FEWEST, _MOST = 2, 6
_GRAIN = 0.03
_TARTAN, SETT = "tartan", 2.5
"""The picture of plaids, and after how many of their bands it repeats."""
_HEX = re.compile("#[0-9a-f]{6}")


@dataclass(frozen=True)
class ClothPrint:
    """What is printed on or woven into a cloth, in centimetres and degrees."""

    kind: str
    """One of `KINDS`."""
    colors: tuple[str, ...]
    """Two to six, ``#rrggbb``: of stripes the first is the band's and the second the gap's; of dots and
    motifs the first is the ground's."""
    sizes: Mapping[str, float] = field(default_factory=dict)
    """``width`` and ``gap`` of stripes, ``width`` of checks, ``spacing`` of plaid and dots, ``radius`` of
    dots, ``repeat`` of motifs, ``angle``: 0 runs around the body, 90 down it."""
    motif: str = "shapes"
    """One of `MOTIFS`."""

    @property
    def ground(self) -> str:
        """The colour that the cloth itself has, ``#rrggbb``."""
        return self.colors[int(self.kind == "motif" and self.motif in NAPS)]

    @property
    def is_tartan(self) -> bool:
        """Whether it is a plaid of three colours: those of two are thin lines alone, panes and nets."""
        return self.kind == "plaid" and len(set(self.colors[:3])) > _FEWEST

    def size(self, name: str) -> float:
        """A size, or what is usual."""
        return float(self.sizes.get(name, _USUAL[name]))

    def drawn(self, grain: float = _GRAIN) -> KnownPrint:
        """The print as the renderer takes it.

        Args:
            grain: Unevenness of the yarn, relative.
        """
        from swifttailor.render.color import to_linear
        from swifttailor.render.motifs import BANDS
        from swifttailor.render.named_pictures import NAMED, number_of
        from swifttailor.render.prints import Checks, Dots, Motif, Plaid, Stripes

        red_green_blue: list[LinearColor] = []
        for color in self.colors:
            red, green, blue = (float(part) for part in to_linear(color))
            red_green_blue.append((red, green, blue))
        first, second = red_green_blue[0], red_green_blue[1]
        angle = self.size("angle")
        if self.kind == "stripes":
            return Stripes(first, second, self.size("width"), self.size("gap"), angle, grain)
        if self.kind == "checks":
            return Checks(first, second, self.size("width"), angle, grain)
        if self.kind == "plaid" and self.is_tartan:
            mixed = [_between(first, second), _between(second, red_green_blue[2])]
            threads = (first, mixed[0], second, mixed[1], red_green_blue[2])
            return Motif(threads, number_of(_TARTAN), SETT * self.size("spacing"), angle, grain)
        if self.kind == "plaid":
            return Plaid(first, second, red_green_blue[-1], self.size("spacing"), angle=angle, grain=grain)
        if self.kind == "dots":
            return Dots(first, second, self.size("spacing"), self.size("radius"), angle, grain)
        number = number_of(self.motif) if self.motif in NAMED else MOTIFS.index(self.motif)
        number = BANDS if self.motif == "bands" else number
        return Motif(tuple(red_green_blue), number, self.size("repeat"), angle, grain)

    def to_json(self) -> dict[str, Any]:
        """As plain JSON values."""
        motif = {"motif": self.motif} if self.kind == "motif" else {}
        return {"kind": self.kind, "colors": list(self.colors), **motif, "sizes": dict(self.sizes)}


def _between(one: LinearColor, other: LinearColor) -> LinearColor:
    """What threads of two colours look like where they cross."""
    red, green, blue = ((a + b) / 2.0 for a, b in zip(one, other, strict=True))
    return red, green, blue


def stated_print(report: Mapping[str, Any]) -> ClothPrint | None:
    """The print that a report states; None where it states none, or one that cannot be drawn."""
    said = report.get(PRINT)
    if (
        not isinstance(said, dict)
        or said.get("kind") not in KINDS
        or said.get("motif", "shapes") not in MOTIFS
    ):
        return None
    colors, sizes = said.get("colors"), said.get("sizes", {})
    known = isinstance(colors, list) and _FEWEST <= len(colors) <= _MOST
    if not known or not all(isinstance(color, str) and _HEX.fullmatch(color) for color in colors):
        return None
    if not isinstance(sizes, dict) or not all(_is_size(name, value) for name, value in sizes.items()):
        return None
    return ClothPrint(said["kind"], tuple(colors), sizes, said.get("motif", "shapes"))


def _is_size(name: object, value: object) -> bool:
    if name not in _USUAL or isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return -360.0 <= value <= 360.0 if name == "angle" else _SMALLEST_CM <= value <= _LARGEST_CM


def cloth_at(garment: Garment, *, as_worn: bool = True) -> Array:
    """(f, 3, 2) where on the cloth the corners of the faces lie, cm, seen from its right side.

    Every panel is cut from the same height of the print: stripes meet at seams between halves. Its middle
    lies at the middle of the print (`panel_mesh.cloth_places`).

    Args:
        garment: Any.
        as_worn: Whether a print of its own that is hung lies as it is worn (`hung_prints`).
    """
    return flat_places(garment, as_worn=as_worn)[garment.mesh.flat_faces]


def flat_places(garment: Garment, *, as_worn: bool = True) -> Array:
    """(m, 2) where on the cloth the flat vertices lie, cm; see `cloth_at`."""
    low, _ = _boxes(garment)
    places: Array = (garment.uv - low[garment.mesh.flat_panel]) * garment.uv_scale
    places[:, 0] += shifts_across(garment.mesh, places)[garment.mesh.flat_panel]
    if as_worn and is_hung(garment):
        places[:, 1] = worn_heights(garment)
    return places


def texture(garment: Garment, side: int = TEXTURE_SIDE) -> Array:
    """The print over all of the unit square of texture coordinates.

    Args:
        garment: With a print.
        side: Pixels of the picture.

    Returns:
        (side, side, 3) uint8 sRGB, row 0 at the top.
    """
    from swifttailor.render.color import encode_srgb

    assert garment.print is not None
    places = texture_places(garment, side, as_worn=True)
    return encode_srgb(garment.print.drawn().colors(places).reshape(side, side, 3))


def texture_places(garment: Garment, side: int, *, as_worn: bool = False) -> Array:
    """(side², 2) where on the cloth the pixels of a texture lie, cm; row by row from the top."""
    from swifttailor.panel_mesh.uv_layout import GUTTER

    across = (np.arange(side) + 0.5) / side
    points: Array = np.stack(np.meshgrid(across, across[::-1]), axis=2).astype(np.float64)
    boxes = _boxes(garment)
    own = (garment.uv - boxes[0][garment.mesh.flat_panel]) * garment.uv_scale
    shifts = shifts_across(garment.mesh, own) / garment.uv_scale
    planes, top = None, 0.0
    if as_worn and is_hung(garment):
        planes = height_planes(garment) / garment.uv_scale
        top = worn_heights(garment).max() / garment.uv_scale
    for k, (low, high, shift) in enumerate(zip(*boxes, shifts, strict=True)):
        left, right = np.searchsorted(across, [low[0] - GUTTER / 2, high[0] + GUTTER / 2])
        lower, upper = np.searchsorted(across, [low[1] - GUTTER / 2, high[1] + GUTTER / 2])
        block = points[side - upper : side - lower, left:right]
        heights = None if planes is None else block @ planes[k, :2] + planes[k, 2]
        block -= low - (shift, 0.0)
        if heights is not None:
            # Beyond its ends it would begin anew.
            block[..., 1] = np.clip(heights, 0.0, top)
    return (points * garment.uv_scale).reshape(-1, 2)


def _boxes(garment: Garment) -> tuple[Array, Array]:
    """Lower left and upper right corners (n, 2) of the panels among the texture coordinates."""
    count = len(garment.pattern.panels)
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, garment.mesh.flat_panel, garment.uv)
    np.maximum.at(high, garment.mesh.flat_panel, garment.uv)
    empty = ~np.isfinite(low).all(axis=1)
    low[empty] = high[empty] = 0.0
    return low, high
