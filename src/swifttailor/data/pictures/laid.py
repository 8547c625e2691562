"""Garments that nobody wears: laid on a floor or a bed, or hung before a wall, and seen straight on."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, shift

from swifttailor.arrays import Array, Floats
from swifttailor.body.carrying import carry_all
from swifttailor.body.limbs import arm, leg, other_side
from swifttailor.body.pose import Pose
from swifttailor.body.rig import HANGING, Rig, Weights, mirrored_name
from swifttailor.data.pictures.bank import WornGarment
from swifttailor.data.pictures.linear_light import linear_light
from swifttailor.data.pictures.panel_cells import panel_cells
from swifttailor.data.pictures.scenes import Chance, Scene, View, Wardrobe, cloth_surface
from swifttailor.data.pictures.worn_places import worn_places
from swifttailor.data.renders.backdrop_colors import mixed_color, random_tint
from swifttailor.data.renders.camera_effects import random_effects
from swifttailor.data.renders.foreground import Before
from swifttailor.data.renders.grounds import random_ground
from swifttailor.looks.look import random_lighting
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS
from swifttailor.picture_reader.view import view_of
from swifttailor.render import Camera
from swifttailor.render.color import encode_srgb
from swifttailor.render.view import render_seen

_LIMBS: dict[str, tuple[str, ...]] = {
    "left_arm": ("left_arm", "left_arm_twist", "left_forearm", "left_hand"),
    "left_thigh": ("left_thigh", "left_shin", "left_foot", "left_toes"),
}
"""First joint of a limb of the left side, and all that hang on it."""
_ENDS = {"left_arm": "left_hand", "left_thigh": "left_foot"}
_FRONTS = 0.88
_HUNG = 0.45
"""Share that hangs: arms down, a hook above; the others lie."""
_TRUNK_WIDER, _LIMBS_WIDER = (1.05, 1.35), (1.15, 1.55)
"""A tube of cloth laid flat is half as wide as its girth: a round one 1.57 times as wide as it was."""
_DEPTH = (0.03, 0.14)
"""Share of their depth that garments keep."""
_WAVES = 5
_WAVE_CM, _WAVE_DEEP_CM = (4.0, 26.0), 0.45
_TURNED, _LEANT = 4.0, 7.0
"""Deviations of how garments are turned in the picture and of the camera's elevation, degrees."""
_MARGIN = (-0.03, 0.35)
_EFFECTS = 0.85
_HOOK_CM = 9.0


def draw_laid(
    wardrobe: Wardrobe,
    number: int,
    view: View,
    chance: Chance,
    size: int,
    *,
    ground: NDArray[np.float32] | None = None,
) -> Scene:
    """Draws a garment without a wearer.

    Args:
        wardrobe: What there is.
        number: Of the garment in the bank.
        view: Which side is up; ``free`` takes the front most of the time, as people do.
        chance: Decides everything else.
        size: Pixels along each side.
        ground: (size, size, 3) linear light of what it lies on, drawn over; one by lot when None.
    """
    worn = wardrobe.bank[number]
    if view == "free":
        view = "front" if chance.random() < _FRONTS else "back"
    hangs = bool(chance.random() < _HUNG)
    vertices = laid_flat(worn, chance, hangs=hangs)
    camera = _camera(vertices, 0.0 if view == "front" else 180.0, chance)
    if ground is None:
        ground = random_ground(chance, size)
    if hangs and chance.random() < 0.6:
        _put_hook(ground, camera, vertices, chance)
    grey = np.full(3, float(ground.mean()))
    surface = cloth_surface(worn, vertices, chance, grey, 0.35, held_out=False)
    seen = render_seen(
        [surface],
        camera,
        (size, size),
        background=ground,
        lighting=random_lighting(chance),
        shadows=True,
        floor=False,
        samples=2,
    )
    share = seen.shares[:, :, 0]
    pixels = encode_srgb(_with_shadow(linear_light(seen.pixels), share, chance))
    if chance.random() < _EFFECTS:
        pixels = random_effects(chance).apply(pixels)
    cells = size // MASK_STRIDE
    masks = np.zeros((cells, cells, len(PARTS)), np.uint8)
    coarse = share.reshape(cells, MASK_STRIDE, cells, MASK_STRIDE).mean(axis=(1, 3))
    masks[:, :, worn.truth.part] = np.round(255 * coarse)
    garments = np.full(len(PARTS), -1)
    garments[worn.truth.part] = number
    places = worn_places(seen.face, [(worn.vertices, worn.faces)])
    panels = panel_cells(seen.face, 0, [worn])
    return Scene(pixels, masks, places, panels, view_of(camera, size), garments)


def laid_flat(worn: WornGarment, chance: Chance, *, hangs: bool = False) -> Floats:
    """(v, 3) vertices of a garment without anybody in it, still upright and facing forward, cm.

    Arms are spread, or hang; all depth but a little is pressed out, and trunk, sleeves and legs get wider
    around their middles, each by a lot; soft folds run across.

    Args:
        worn: The garment on the default body.
        chance: Decides.
        hangs: Whether sleeves hang down.
    """
    rig = Rig.default()
    out = chance.uniform(6.0, 18.0) if hangs else chance.uniform(14.0, 75.0)
    bend = float(chance.choice([0.0, chance.uniform(0.0, 25.0)]))
    arms = arm(rig, out=out, inward=90.0, bend=bend)
    legs = leg(out=chance.uniform(-1.0, 5.0))
    pose = Pose(arms | other_side(arms) | legs | other_side(legs))
    joints = [(rig.joints, rig.weights_at(rig.joints))]
    carried, at = carry_all([(worn.vertices, worn.weights), *joints], rig, pose)
    trunk, limbs = chance.uniform(*_TRUNK_WIDER), chance.uniform(*_LIMBS_WIDER)
    flat = carried[:, :2]
    wider = np.zeros_like(flat)
    shares = _limb_shares(worn.weights)
    for share, (start, end) in zip(shares, _limb_ends(), strict=True):
        first, along = at[start, :2], at[end, :2] - at[start, :2]
        along = along / np.linalg.norm(along)
        aside = flat - first - ((flat - first) @ along)[:, None] * along
        wider += (limbs - 1) * share[:, None] * aside
    wider[:, 0] += (trunk - 1) * (1 - shares.sum(axis=0)) * flat[:, 0]
    depth = (carried[:, 2] - carried[:, 2].mean()) * chance.uniform(*_DEPTH)
    flat = flat + wider
    for _ in range(_WAVES):
        length, turned = chance.uniform(*_WAVE_CM), chance.uniform(0, np.pi)
        along = flat @ (np.cos(turned), np.sin(turned))
        deep = chance.uniform(0, _WAVE_DEEP_CM) * length / _WAVE_CM[1]
        depth = depth + deep * np.sin(2 * np.pi * along / length + chance.uniform(0, 7))
    tilt = np.deg2rad(chance.normal(0, _TURNED))
    middle = flat.mean(axis=0)
    turn = np.array([[np.cos(tilt), -np.sin(tilt)], [np.sin(tilt), np.cos(tilt)]])
    return np.column_stack([(flat - middle) @ turn.T + middle, depth])


@cache
def _limb_ends() -> tuple[tuple[int, int], ...]:
    """Joints at the beginning and the end of arms and legs, left and right."""
    rig = Rig.default()
    pairs = [(side(a), side(b)) for a, b in _ENDS.items() for side in (str, mirrored_name)]
    return tuple((rig.index(a), rig.index(b)) for a, b in pairs)


@cache
def _limb_carriers() -> NDArray[np.int64]:
    """Which limb each carrier of `Weights` belongs to, in the order of `_limb_ends`; -1 for the trunk."""
    rig = Rig.default()
    limb = np.full(rig.joint_count, -1)
    groups = [tuple(map(side, names)) for names in _LIMBS.values() for side in (str, mirrored_name)]
    for k, names in enumerate(groups):
        limb[[rig.index(name) for name in names]] = k
    # Skirts hang from their carriers as from a trunk.
    return np.concatenate([limb, limb[rig.softened], np.full(len(HANGING), -1)])


def _limb_shares(weights: Weights) -> Floats:
    """(4, v) how much of each vertex arms and legs carry."""
    limb = _limb_carriers()[weights.carrier]
    return np.stack([(weights.share * (limb == k)).sum(axis=1) for k in range(len(_limb_ends()))])


def _camera(vertices: Floats, azimuth: float, chance: Chance) -> Camera:
    """Looks at a garment straight on, or nearly so."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    seen = float((high - low)[:2].max()) * (1 + 2 * float(chance.uniform(*_MARGIN)))
    x, y, z = (low + high) / 2 + np.array([*chance.normal(0, 0.04, 2), 0.0]) * seen
    elevation = float(np.clip(chance.normal(0, _LEANT), -20, 20))
    turned = azimuth + float(chance.normal(0, _LEANT / 2))
    return Camera((float(x), float(y), float(z)), seen, turned, elevation, float(chance.uniform(6, 45)))


def _put_hook(ground: Array, camera: Camera, vertices: Floats, chance: Chance) -> None:
    """A hanger's hook above the garment, and its shoulders, which the cloth will cover but for its neck."""
    size = len(ground)
    middle = vertices[:, 0].mean()
    near = np.abs(vertices[:, 0] - middle) < 6.0
    if not near.any():
        return
    top = float(vertices[near, 1].max())
    deep = float(chance.uniform(0, 6))
    points = [
        (middle, top - deep, 0.0),
        (middle, top + _HOOK_CM - deep, 0.0),
        (middle + 2.5, top + _HOOK_CM + 2.5 - deep, 0.0),
        (middle - 19.0, top - deep - 8.0, 0.0),
        (middle + 19.0, top - deep - 8.0, 0.0),
    ]
    at = [(float(x), float(y)) for x, y in camera.project(np.array(points), (size, size))[:, :2] / size]
    metal = mixed_color((0.6, 0.6, 0.6), (0.05, 0.05, 0.05), chance.random())
    wood = mixed_color((0.5, 0.32, 0.18), (0.02, 0.02, 0.02), chance.random())
    if chance.random() < 0.25:
        wood = random_tint(chance, vivid=0.6)
    cover = np.ones((size, size), np.float32)
    thin, thick = (float(width / camera.height) for width in (0.25, chance.uniform(0.3, 1.3)))
    for start, end in ((0, 1), (1, 2)):
        Before(at[start], at[end], thin, metal, 0.002).put(ground, cover)
    for end in (3, 4):
        Before(at[0], at[end], thick, wood, 0.002).put(ground, cover)


def _with_shadow(light: Array, share: Array, chance: Chance) -> Array:
    """Linear light (h, w, 3) with the shadow of the garment on what it lies on or hangs before."""
    size = len(light)
    soft = gaussian_filter(share, size * float(chance.uniform(0.004, 0.03)))
    aside = size * chance.normal(0, 0.012, 2)
    fallen = shift(soft, (abs(float(aside[0])), float(aside[1])), order=1, mode="nearest")
    dark = float(chance.uniform(0.0, 0.65)) * np.clip(fallen, 0, 1) * (1 - share)
    return light * (1 - dark)[:, :, None].astype(np.float32)
