"""Scenes to learn to read from: people of all shapes and poses, in two garments or one, anywhere."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache, lru_cache
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Ints, Pixels
from swifttailor.body import Body
from swifttailor.body.body_shape import random_shape
from swifttailor.body.carrying import carry_all
from swifttailor.body.footwear import FOOTWEAR, footwear
from swifttailor.body.hair import hair, hair_by_lot, strand_shades
from swifttailor.body.mannequin import mannequin
from swifttailor.body.pose import Pose
from swifttailor.body.posing import random_pose
from swifttailor.body.rig import Rig, Weights
from swifttailor.body.skin_regions import SkinRegion, skin_regions
from swifttailor.data.pictures.bank import PictureBank, WornGarment
from swifttailor.data.pictures.closer import close_up_by_lot, coarsened
from swifttailor.data.pictures.linear_light import linear_light
from swifttailor.data.pictures.on_white import on_white
from swifttailor.data.pictures.panel_cells import panel_cells
from swifttailor.data.pictures.worn_places import worn_places
from swifttailor.data.renders.backdrops import MAKER_NAMES, random_scenery
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.data.renders.cloths import DrawnCloth, Place, random_cloth, random_color
from swifttailor.data.renders.foreground import random_before
from swifttailor.looks.look import random_lighting
from swifttailor.picture_reader.close_ups import ALL_PARTS, WHOLE
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS, statement_labels
from swifttailor.picture_reader.truth import TRUE
from swifttailor.picture_reader.view import view_of
from swifttailor.render import Camera, LineSet, Surface, to_linear
from swifttailor.render.color import encode_srgb
from swifttailor.render.view import render_seen

Chance = np.random.Generator
View = Literal["front", "back", "free"]
VIEWS: tuple[View, ...] = ("front", "back", "free")
HELD_OUT_BACKDROPS = frozenset({"stairs", "bricks"})
HELD_OUT_WEAVES = frozenset({"quilt", "cord", "cable"})
"""A family of looks that training never draws: these backdrops and these cloths, always in a pose."""
UNTOLD = -2
"""For the number of a garment: whether there is one is not known."""
_SKINS = ("#f3d9c6", "#e8c0a4", "#d6a184", "#b57f5c", "#8f5c3e", "#5f3b28", "#3b251a")
_FIGURES = ("#c9bfb6", "#e9e6e1", "#8d8b89", "#2b2b2d")
_HAIRS = ("#17120f", "#2e211a", "#4a3222", "#6f4a2c", "#9a7346", "#c9a468", "#7c3a22", "#8d8a88")
_SHOES = ("#141414", "#f0efec", "#5b3a26", "#232a40", "#b59a77", "#8b1f2a")
_NOBODY, _STANDING, _USUAL_SHAPE, _MANNEQUIN = 0.08, 0.15, 0.2, 0.08
_TWO_GARMENTS, _SEAMS, _STUDIO = 0.8, 0.3, 0.15
_LOW_SHOES = ("flats", "shoes", "sneakers")
_ATTEMPTS, _POSES = 30, 1024
_COVERED = 0.5


class Scene(NamedTuple):
    """A picture and what is true of it."""

    pixels: Pixels
    """(size, size, 3)."""
    masks: NDArray[np.uint8]
    """(size / 4, size / 4, 2) share of each cell where the garment of each part is seen, of 255."""
    places: NDArray[np.float16]
    """(size / 4, size / 4, 3), see `worn_places`."""
    cells: NDArray[np.uint8]
    """(size / 4, size / 4), see `panel_cells`."""
    views: NDArray[np.float32]
    """(6,) `labels.VIEW`."""
    garments: NDArray[np.int64]
    """(2,) number of the garment of each part in the bank; -1 for none, `UNTOLD` where that is not known."""
    figures: int = FIGURES.index("one")
    """Number of `FIGURES`."""
    close_up: int = WHOLE
    """Number of `CLOSE_UPS`, or `WHOLE`; a close-up tells of one garment alone."""
    placed: bool = True
    """Whether it is known where in the picture the garment is; where not, `views` are likely ones."""


class Wardrobe:
    """A bank's garments by what they can be worn with."""

    def __init__(self, bank: PictureBank) -> None:
        found = bank.truths(range(len(bank)))
        labels = statement_labels()
        tops = [labels.index(("kind", word)) for word in ("top", "tunic")]
        is_top = (found["statements"][:, tops] == 1).any(axis=1)
        is_lower = found["part"] == PARTS.index("lower")
        self.bank = bank
        self.tops, self.lowers = np.flatnonzero(is_top & ~is_lower), np.flatnonzero(is_lower)
        self._is_top = is_top

    def companion(self, number: int, chance: Chance) -> int:
        """What is worn with a garment; -1 for nothing."""
        lower = self.bank.part(number) == PARTS.index("lower")
        others = self.tops if lower else self.lowers if self._is_top[number] else ()
        if not len(others) or chance.random() > _TWO_GARMENTS:
            return -1
        return int(others[int(chance.integers(len(others)))])


def draw_scene(
    wardrobe: Wardrobe,
    number: int,
    view: View,
    chance: Chance,
    size: int,
    *,
    held_out: bool = False,
    behind: NDArray[np.float32] | None = None,
    aside: tuple[float, float] | None = None,
    close: bool = False,
    parts: Sequence[str] = ALL_PARTS,
    cut_out: float = 0.0,
) -> Scene:
    """Draws somebody who wears a garment.

    Args:
        wardrobe: What there is.
        number: Of the garment in the bank.
        view: From where.
        chance: Decides everything else.
        size: Pixels along each side.
        held_out: Whether the look is of the family that is kept for judging; else of all others.
        behind: (size, size, 3) linear light behind the figure; a place by lot when None.
        aside: How far from the middle the figure stands, in sides of the picture, and how many centimetres
            the picture is high there; the garment fills the picture when None.
        close: Whether one of `CLOSE_UPS` of the garment fills it instead.
        parts: Of these, see `CloseUp.part`.
        cut_out: How likely nothing is left of what is behind, see `on_white`.
    """
    worn = [(number, wardrobe.bank[number])]
    nobody = not held_out and chance.random() < _NOBODY
    other = -1 if nobody else wardrobe.companion(number, chance)
    if other >= 0:
        worn.append((other, wardrobe.bank[other]))
    pose = _pose(int(chance.integers(_POSES)))
    if not held_out and chance.random() < _STANDING:
        pose = Pose()
    shape = None if chance.random() < _USUAL_SHAPE else random_shape(chance)
    skin = _linear(chance, _FIGURES if chance.random() < _MANNEQUIN else _SKINS)
    rig = Rig.default()
    figure, accessories, sole = _figure(skin, [garment for _, garment in worn], chance)
    things = [(figure.vertices, figure.weights), *((a.vertices, a.weights) for a in accessories)]
    things += [(g.vertices, g.weights) for _, g in worn]
    carried = carry_all(things, rig, pose, shape, sole=sole)
    surfaces, at_rest = [], []
    if not nobody:
        for thing, vertices in zip([figure, *accessories], carried, strict=False):
            surfaces.append(_surface(vertices, thing))
            at_rest.append((thing.vertices, thing.faces))
    bodies = len(surfaces)
    tucked = chance.random() < 0.4
    for k, ((_, garment), vertices) in enumerate(zip(worn, carried[1 + len(accessories) :], strict=True)):
        is_lower = garment.truth.part == PARTS.index("lower")
        outside = len(worn) == 1 or is_lower == tucked
        surfaces.append(
            cloth_surface(
                garment, vertices, chance, skin, 1.6 if outside else 0.35, held_out=held_out and k == 0
            )
        )
        at_rest.append((garment.vertices, garment.faces))
    shown = carried[1 + len(accessories)]
    camera = _camera(shown, carried[0], view, chance)
    if aside is not None:
        camera = _aside(camera, *aside)
    close_up = WHOLE
    if close:
        camera, close_up = close_up_by_lot(worn[0][1], shown, camera, chance, parts)
    lighting = random_lighting(chance)
    seen = render_seen(
        surfaces,
        camera,
        (size, size),
        background=_background(chance, size, held_out) if behind is None else behind,
        lighting=lighting,
        shadows=True,
        floor=not nobody and behind is None and chance.random() < 0.7,
        samples=2,
    )
    drawn = seen.pixels if close_up == WHOLE else coarsened(seen.pixels, chance)
    pixels, cover = _in_front(drawn, chance, size)
    if chance.random() < 0.85:
        pixels = random_effects(chance).apply(pixels)
    if cut_out and chance.random() < cut_out:
        pixels = on_white(pixels, seen.shares.sum(axis=2) * cover, chance)
    cells = size // MASK_STRIDE
    masks = np.zeros((cells, cells, len(PARTS)), np.uint8)
    garments = np.full(len(PARTS), -1)
    for k, (which, garment) in enumerate(worn):
        share = (seen.shares[:, :, bodies + k] * cover).reshape(cells, MASK_STRIDE, cells, MASK_STRIDE)
        masks[:, :, garment.truth.part] = np.round(255 * share.mean(axis=(1, 3)))
        if close_up == WHOLE or which == number:
            garments[garment.truth.part] = which
    face = np.where(cover > _COVERED, seen.face, -1)
    places = worn_places(face, at_rest)
    bare = sum(len(faces) for _, faces in at_rest[:bodies])
    panels = panel_cells(face, bare, [garment for _, garment in worn])
    return Scene(pixels, masks, places, panels, view_of(camera, size), garments, close_up=close_up)


class _Thing(NamedTuple):
    """Something of a figure that is carried along with it."""

    vertices: Floats
    faces: Ints
    color: NDArray[np.float64]
    """(3,) or (f, 3)."""
    weights: Weights
    has_inside: bool = False


def _figure(
    skin: NDArray[np.float64], worn: list[WornGarment], chance: Chance
) -> tuple[_Thing, list[_Thing], float]:
    """Skin, hair and shoes, and how high the soles are; hoods and trousers leave little room for either."""
    base = _bare()
    color = np.broadcast_to(skin, (len(base.faces), 3)).copy()
    regions = _face_regions()
    hair_color = _linear(chance, _HAIRS)
    is_person = bool(chance.random() < 0.9)
    if is_person:
        color[regions == SkinRegion.SCALP] = 0.7 * hair_color + 0.3 * skin
        color[regions == SkinRegion.BROWS] = hair_color
        color[regions == SkinRegion.EYES] = 0.03
        color[regions == SkinRegion.LIPS] = skin * (1.0, 0.55, 0.5)
        if chance.random() < 0.15:  # tights
            tights = np.array(random_color(chance)) if chance.random() < 0.4 else np.full(3, 0.02)
            for region in (SkinRegion.THIGHS, SkinRegion.SHINS, SkinRegion.FEET):
                color[regions == region] = tights
    accessories, sole = [], 0.0
    if is_person and chance.random() < 0.93:
        style = hair_by_lot(chance) if not _any(worn, "hood", "hood") else "cropped"
        worn_hair = _hair(style)
        shades = strand_shades(style, chance.uniform(0.0, 0.45), chance)
        accessories.append(worn_hair._replace(color=np.clip(hair_color * shades[:, None], 0.002, 0.95)))
    if chance.random() < 0.75:
        legs = any(_any(worn, "kind", word) for word in ("trousers", "jumpsuit"))
        kind = str(chance.choice(_LOW_SHOES if legs else list(FOOTWEAR)))
        shoes, sole = _shoes(kind)
        accessories.append(shoes._replace(color=_linear(chance, _SHOES)))
    return base._replace(color=color), accessories, sole


def _any(worn: list[WornGarment], claim: str, word: str) -> bool:
    label = statement_labels().index((claim, word))
    return any(garment.truth.statements[label] == TRUE for garment in worn)


def _surface(vertices: Floats, thing: _Thing) -> Surface:
    color = np.asarray(thing.color, np.float64)
    back = color * 0.6 if thing.has_inside else None
    return Surface(vertices, thing.faces, color, back, gloss=0.04, trusted=True)


def cloth_surface(
    garment: WornGarment, vertices: Floats, chance: Chance, skin: Floats, lift: float, *, held_out: bool
) -> Surface:
    """A garment in a cloth drawn by lot.

    Args:
        garment: Which.
        vertices: (v, 3) where it is in the picture, cm.
        chance: Decides on cloth and seams.
        skin: (3,) linear light that is seen through holes of the cloth.
        lift: By how much it is drawn nearer than it is, cm, so that what lies on it stays below.
        held_out: Whether the cloth is of the family that is kept for judging.
    """
    drawn = _random_cloth(garment, chance, skin, held_out)
    lines: tuple[LineSet, ...] = ()
    if chance.random() < _SEAMS:
        strength = float(chance.uniform(0.08, 0.4))
        lines = LineSet(garment.seams, strength, 0.8), LineSet(garment.borders, 0.7 * strength, 0.8)
    return Surface(
        vertices,
        garment.faces,
        np.ones(3),
        np.asarray(drawn.inside, np.float64),
        lines=lines,
        lift=lift,
        sheen=drawn.sheen,
        gloss=drawn.gloss,
        print=drawn.cloth,
        print_at=garment.cloth_at,
        rest=garment.vertices,
        trusted=True,
    )


def _random_cloth(garment: WornGarment, chance: Chance, skin: Floats, held_out: bool) -> DrawnCloth:
    """A cloth of the family that is asked for."""
    place = Place.of(garment.vertices)
    r, g, b = (float(v) for v in skin)
    for _ in range(_ATTEMPTS):
        drawn = random_cloth(chance, place, behind=(r, g, b))
        weave = drawn.cloth.weave
        if held_out == (weave is not None and weave.kind in HELD_OUT_WEAVES):
            return drawn
    return drawn


def _background(chance: Chance, size: int, held_out: bool) -> NDArray[np.float32]:
    if not held_out and chance.random() < _STUDIO:
        shade = float(chance.choice([1.0, chance.uniform(0.5, 0.95)]))
        return np.full((size, size, 3), shade, np.float32)
    for _ in range(_ATTEMPTS):
        scenery = random_scenery(chance)
        kind = MAKER_NAMES[scenery.number % len(MAKER_NAMES)]
        if held_out == (kind in HELD_OUT_BACKDROPS):
            break
    return scenery.light(size)


def _in_front(pixels: Pixels, chance: Chance, size: int) -> tuple[Pixels, NDArray[np.float32]]:
    """The picture with what is before the figure, and how much is left to see of it."""
    cover = np.ones((size, size), np.float32)
    before = random_before(chance)
    if before:
        light = linear_light(pixels)
        for thing in before:
            thing.put(light, cover)
        pixels = encode_srgb(light)
    return pixels, cover


def _camera(shown: Floats, figure: Floats, view: View, chance: Chance) -> Camera:
    """Looks at a garment, at the whole figure, or at something between; cuts off a little now and then."""
    turned = {"front": chance.normal(0, 14), "back": 180 + chance.normal(0, 14)}.get(
        view, chance.uniform(0, 360)
    )
    low, high = shown.min(axis=0), shown.max(axis=0)
    share = float(chance.choice([0.0, 1.0, chance.random()]))
    whole_low, whole_high = figure.min(axis=0), figure.max(axis=0)
    bottom, top = (1 - share) * low[1] + share * whole_low[1], (1 - share) * high[1] + share * whole_high[1]
    right = np.array([np.cos(np.deg2rad(turned)), 0.0, -np.sin(np.deg2rad(turned))])
    across = shown @ right
    wide = float(across.max() - across.min())
    margin = float(chance.uniform(-0.04, 0.22))
    seen = max(float(top - bottom), wide) * (1 + 2 * margin)
    middle = right * float((across.max() + across.min()) / 2) + (0.0, float(top + bottom) / 2, 0.0)
    shift = chance.normal(0, 0.03, 2) * seen
    x, y, z = (float(v) for v in middle + right * shift[0] + (0.0, shift[1], 0.0))
    elevation = float(np.clip(chance.normal(4, 6), -14, 30))
    return Camera((x, y, z), seen, float(turned), elevation, float(chance.uniform(6, 40)))


def _aside(camera: Camera, right: float, height: float) -> Camera:
    """A view of the whole figure from the same side, off the middle by so many sides of the picture."""
    x, y, z = (float(v) for v in np.array([0.0, 90.0, 0.0]) - camera.axes[0] * right * height)
    return replace(camera, target=(x, y, z), height=height)


def _linear(chance: Chance, colors: tuple[str, ...]) -> NDArray[np.float64]:
    base = np.asarray(to_linear(colors[int(chance.integers(len(colors)))]), np.float64)
    return np.clip(base * chance.uniform(0.85, 1.15), 0.004, 0.95)


@lru_cache(maxsize=_POSES)
def _pose(number: int) -> Pose:
    return random_pose(np.random.default_rng([17, number]))


@cache
def _bare() -> _Thing:
    vertices, faces = mannequin(Body.default())
    return _Thing(vertices, faces.astype(np.int32), np.zeros(3), Rig.default().weights_at(vertices))


@cache
def _face_regions() -> NDArray[np.uint8]:
    base = _bare()
    return skin_regions(base.vertices[base.faces].mean(axis=1))


@lru_cache(maxsize=128)
def _hair(style: str) -> _Thing:
    vertices, faces = hair(style)
    return _Thing(vertices, faces, np.zeros(3), Rig.default().weights_at(vertices), has_inside=True)


@lru_cache(maxsize=16)
def _shoes(kind: str) -> tuple[_Thing, float]:
    vertices, faces, sole = footwear(kind)
    return _Thing(vertices, faces, np.zeros(3), Rig.default().weights_at(vertices)), sole
