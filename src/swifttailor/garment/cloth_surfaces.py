"""The cloth of a garment as the renderer draws it: one surface, or one for each look of its parts."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.cloth_print import cloth_at
from swifttailor.garment.collar_lines import is_of_collar, seams_within_collars
from swifttailor.garment.double_breasted import seams_under_a_front
from swifttailor.garment.needless_seams import darts_in_yokes, seams_of_knits
from swifttailor.garment.princess_lines import seams_in_princess_seams
from swifttailor.garment.trim_colors import DARKEST, is_dark
from swifttailor.pattern.centre_seams import needless_centre_seams
from swifttailor.render.color import GREY, Color, to_linear
from swifttailor.render.surface import LineSet, Surface

if TYPE_CHECKING:
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.garment import Garment
    from swifttailor.garment.part_looks import PanelLook
    from swifttailor.render.prints import KnownPrint

_SHEEN = {
    "silk": 0.2,
    "satin": 0.28,
    "denim": 0.06,
    "twill": 0.08,
    "leather": 0.16,
    "polyester": 0.13,
    "swimwear": 0.16,
}
_GLOSS = {"silk": 0.06, "satin": 0.13, "leather": 0.25, "polyester": 0.02, "swimwear": 0.05}
"""Of cloths that shine otherwise than cotton does."""
_METALS = frozenset({"#c9a227", "#c0c0c0", "#8c5a3c", "#b76e79", "#b08d57", "#b87333"})
"""Gold, silver, bronze, rose gold, brass and copper: who names them wants cloth that shines like them."""
_METAL_SHEEN, _METAL_GLOSS = 0.30, 0.22
_MATT = frozenset(
    {"cotton", "linen", "wool", "denim", "jersey", "fleece", "twill", "knit", "corduroy", "tweed"}
)
_UNDER_PLEATS, _ALIKE = "skirt_under_", 0.86
"""What is folded away under pleats, and how light its wrong side is beside the right one."""
_WOVEN, _REPEATS_CM = ("stripes", "checks", "plaid"), 48.0
"""Prints that go through to the wrong side, and a width over which they repeat."""
ON_DARK = -0.8
"""How much lighter seams are than dark cloth, in previews."""
_COLLAR_STRENGTH, _COLLAR_WIDTH = 0.6, 1.5
"""Of the edges of collars there: what a collar is like is told by them, in small pictures as well."""


@dataclass(frozen=True, eq=False)
class SeenCloth:
    """Panels of one print and one opacity."""

    surface: Surface
    opacity: float = 1.0
    """Share of what lies beneath that it hides; of lace what its net hides."""
    figures: KnownPrint | None = None
    """The same of lace at each place, as a print of greys; None of other cloth."""
    figures_at: Array | None = None
    """(m, 3, 2) where on the cloth the corners of the faces lie, cm; goes with `figures`."""


def cloth_surface(
    garment: Garment,
    color: Color | None = None,
    *,
    tint_panels: bool = True,
    lines: bool = True,
    seen_on_dark: bool = False,
) -> Surface:
    """The garment as the renderer draws it, all in one cloth.

    Args:
        garment: Any garment.
        color: Right side of the cloth; the inside is a little darker and greyer, as that of dyed cloth is.
            None: the garment's own (`cloth_color`).
        tint_panels: Whether neighbouring panels differ a little in lightness.
        lines: Whether seams and hems are drawn.
        seen_on_dark: Whether they are lighter than dark cloth, on which darker ones would not be seen.
    """
    base = np.maximum(
        to_linear(garment.color or cloth_color(garment.pattern) if color is None else color), DARKEST
    )
    right = np.broadcast_to(base, (len(garment.faces), 3))
    if tint_panels:
        right = base * _tints(garment)[garment.mesh.face_panel][:, None]
    printed = garment.print if color is None else None
    inside, is_black = inside_of(base, printed, alike=_is_pleated(garment))
    dark = np.full(len(garment.pattern.panels), is_black)
    drawn = _lines(garment, dark, seen_on_dark) if lines else ()
    return _surface(garment, garment.faces, right, inside, drawn, printed, None)


def cloth_surfaces(garment: Garment, color: Color | None = None) -> list[SeenCloth]:
    """The garment as previews draw it: one surface, or several where parts of it look otherwise.

    Args:
        garment: Any garment.
        color: Right side of all of the cloth; None: each part has its own.
    """
    if color is not None or not garment.looks:
        whole = SeenCloth(cloth_surface(garment, color, seen_on_dark=True))
        return _both_sides(whole, garment.print if color is None else None)
    from swifttailor.garment.part_looks import looks_of_panels

    looks = looks_of_panels(garment)
    own = garment.color or cloth_color(garment.pattern)
    base = np.array([np.maximum(to_linear(look.color or own), DARKEST) for look in looks])
    prints = [print_of(garment, look, look.color or own) for look in looks]
    kinds = [(printed, look.opacity, look.lace) for printed, look in zip(prints, looks, strict=True)]
    alike_inside = _is_pleated(garment)
    insides = [inside_of(*pair, alike=alike_inside) for pair in zip(base, prints, strict=True)]
    wrong, dark = np.array([inside for inside, _ in insides]), np.array([is_black for _, is_black in insides])
    right = base * _tints(garment)[:, None]
    order = [k for k, kind in enumerate(kinds) if kinds.index(kind) == k]
    found = []
    for k in order:
        alike = np.array([kind == kinds[k] for kind in kinds])
        shown = alike[garment.mesh.face_panel]
        if not shown.any():
            continue
        panel = garment.mesh.face_panel[shown]
        faces = garment.faces[shown]
        drawn = _lines(garment, dark, True, shown)
        printed, opacity, lace = kinds[k]
        surface = _surface(garment, faces, right[panel], wrong[panel], drawn, printed, shown)
        if lace and opacity < 1.0:
            from swifttailor.garment.lace import lace_opacity

            places = cloth_at(garment, as_worn=False)[shown]
            found.append(SeenCloth(surface, opacity, lace_opacity(opacity), places))
        else:
            found += _both_sides(SeenCloth(surface, opacity), printed)
    return found


def _both_sides(seen: SeenCloth, printed: ClothPrint | None) -> list[SeenCloth]:
    """Cloth, and its wrong side where what is woven into it is seen there, too: under the folds of a kilt."""
    front = seen.surface
    if printed is None or printed.kind not in _WOVEN or front.print_at is None:
        return [seen]
    behind = replace(
        front,
        faces=np.ascontiguousarray(front.faces[:, ::-1]),
        print_at=np.ascontiguousarray(front.print_at[:, ::-1]),
        back_color=None,
        lines=(),
    )
    return [replace(seen, surface=replace(front, back_color=None)), replace(seen, surface=behind)]


def print_of(garment: Garment, look: PanelLook, color: str) -> ClothPrint | None:
    """What is printed on a panel: what is on the garment, unless it has a colour or cloth of its own."""
    if look.lace:
        from swifttailor.garment.lace import lined_lace

        return None if look.is_sheer else lined_lace(color)
    return garment.print if look.color is None else None


def _tints(garment: Garment) -> Array:
    """(panels,) how light each panel is beside the others: a little, so that they can be told apart."""
    # Golden-ratio steps keep consecutive panels apart whatever their number.
    return 0.97 + 0.06 * ((np.arange(len(garment.pattern.panels)) * 0.618034) % 1.0)


def _is_pleated(garment: Garment) -> bool:
    """Whether cloth is folded away under strips: the strip that a fold shows is the right side of cloth."""
    return any(panel.name.startswith(_UNDER_PLEATS) for panel in garment.pattern.panels)


def inside_of(base: Array, printed: ClothPrint | None, *, alike: bool = False) -> tuple[Array, bool]:
    """The wrong side (3,) of cloth of a colour (3,) or print, linear light; and whether seams are lighter.

    With `alike` it is nearly as the right side.
    """
    if printed is not None:
        base = np.maximum(_wrong_side(printed), DARKEST)
    if alike:
        return _ALIKE * base, is_dark(base)
    grey = float(base @ GREY)
    return 0.78 * (0.75 * base + 0.25 * grey) + 0.002, is_dark(base)


def _lines(
    garment: Garment, dark: Array, seen_on_dark: bool, shown: Array | None = None
) -> tuple[LineSet, ...]:
    """Seams and hems.

    Args:
        garment: Any garment.
        dark: (panels,) bool: whose cloth is too dark for darker lines.
        seen_on_dark: Whether lines on dark cloth are lighter than it.
        shown: (f,) bool: the faces whose lines are wanted; None: all of them.
    """
    seams, borders = _seam_edges(garment, seen_on_dark), border_edges(garment.faces)
    if shown is not None:
        reached = _reached(garment, shown)
        seams, borders = (edges[reached[edges].all(axis=1)] for edges in (seams, borders))
    seam = LineSet(seams, strength=0.42, width=1.1)
    if not seen_on_dark:
        return seam, LineSet(borders, strength=0.30, width=1.2)
    of_collar = is_of_collar(garment)[borders].all(axis=1)
    hems = LineSet(borders[~of_collar], strength=0.30, width=1.2)
    collar = LineSet(borders[of_collar], strength=_COLLAR_STRENGTH, width=_COLLAR_WIDTH)
    on_light = _reached(garment, ~dark[garment.mesh.face_panel])
    return (*_on_cloth(seam, on_light), *_on_cloth(collar, on_light), hems)


def _on_cloth(line: LineSet, on_light: Array) -> tuple[LineSet, ...]:
    """A line as it is seen: darker than light cloth (v,) bool, and lighter than dark cloth."""
    light = on_light[line.edges].all(axis=1)
    parts = (
        replace(line, edges=line.edges[light]),
        replace(line, edges=line.edges[~light], strength=ON_DARK),
    )
    return tuple([part for part in parts if len(part.edges)])


def _reached(garment: Garment, faces: Array) -> Array:
    """(v,) bool: the vertices of some faces (f,) bool."""
    reached = np.zeros(len(garment.vertices), bool)
    reached[garment.faces[faces]] = True
    return reached


def _surface(
    garment: Garment,
    faces: Array,
    right: Array,
    inside: Array,
    lines: tuple[LineSet, ...],
    printed: ClothPrint | None,
    shown: Array | None,
) -> Surface:
    """The surface of some faces (m, 3); `shown` (f,) tells them among the garment's, None: all of them."""
    at = None if printed is None else cloth_at(garment, as_worn=printed is garment.print)
    sheen, gloss = shine_of(garment, printed)
    return Surface(
        garment.vertices,
        faces,
        np.clip(right, 0, 1),
        inside,
        lines=lines,
        lift=0.35,
        sheen=sheen,
        gloss=gloss,
        print=None if printed is None else printed.drawn(),
        print_at=at if at is None or shown is None else at[shown],
    )


def shine_of(garment: Garment, printed: ClothPrint | None) -> tuple[float, float]:
    """Sheen and gloss of a garment's cloth."""
    if printed is None and garment.color in _METALS and garment.cloth not in _MATT:
        return _METAL_SHEEN, _METAL_GLOSS
    return _SHEEN.get(garment.cloth or "", 0.10), _GLOSS.get(garment.cloth or "", 0.0)


def _wrong_side(printed: ClothPrint) -> Array:
    """(3,) linear light: of what is printed the ground, of what is woven the mean of all."""
    if printed.kind not in _WOVEN:
        return to_linear(printed.ground)
    across = np.linspace(0.0, _REPEATS_CM, 64)
    return printed.drawn().colors(np.stack(np.meshgrid(across, across), axis=-1).reshape(-1, 2)).mean(axis=0)


def _seam_edges(garment: Garment, as_worn: bool) -> Array:
    """(n, 2) vertex indices of seams; `as_worn` without those that vanish where cloth is cut on the fold."""
    needless = needless_centre_seams(garment.pattern, aslant=True) if as_worn else frozenset[int]()
    if needless and garment.looks:
        from swifttailor.garment.part_looks import looks_of_panels

        names = [panel.name for panel in garment.pattern.panels]
        looks = dict(zip(names, looks_of_panels(garment), strict=True))
        stitches = garment.pattern.stitches
        needless = {k for k in needless if len({looks[side.panel] for side in stitches[k].sides}) == 1}
    if as_worn:
        needless = frozenset(needless) | seams_within_collars(garment.pattern)
        needless |= seams_under_a_front(garment.pattern)
        needless |= seams_in_princess_seams(garment.pattern)
        needless |= seams_of_knits(garment.pattern) | darts_in_yokes(garment.pattern)
    parts = [
        np.stack([s.vertices[:-1], s.vertices[1:]], axis=1)
        for s in garment.seams
        if len(s.vertices) > 1 and s.stitch not in needless
    ]
    return np.concatenate(parts) if parts else np.zeros((0, 2), np.int32)


def border_edges(faces: Array) -> Array:
    """(n, 2) vertex indices of the edges that only one of the faces (m, 3) has."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    key = edges[:, 0] * (int(faces.max(initial=0)) + 1) + edges[:, 1]
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    return edges[first[count == 1]].astype(np.int32)
