"""Measuring a body mesh: girths by horizontal slices, levels, arms."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.measurements import BodyMeasurements
from swifttailor.body.parts import BodyPart, face_parts
from swifttailor.errors import InputError

# Heights as fractions of the body's own, between which the fullest or narrowest slice is looked for.
_BUST_WINDOW = (0.695, 0.76)
_WAIST_WINDOW = (0.59, 0.67)
_HIPS_WINDOW = (0.45, 0.54)
_UNDERBUST_DROP = 0.047  # from the bust, as a fraction of the height
_STEP = 0.5  # between slices, cm
# GarmentCode measures the depth of the armscye from the tip of the shoulder, which a mesh does not mark. So
# what can be measured, how far the arm's joint reaches below the neck, is scaled by this, its value on the
# default body, cm.
_JOINT_BELOW_NECK = 17.453


def slice_points(vertices: Array, faces: Array, normal: Array, offset: float) -> Array:
    """Where the edges of a surface cross the plane ``normal . x = offset``.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices.
        normal: (3,) normal of the plane.
        offset: Position of the plane along `normal`.

    Returns:
        (K, 3) points, cm; K is 0 when the plane misses the surface.
    """
    side = vertices @ np.asarray(normal, np.float64) - offset
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    s, t = side[edges[:, 0]], side[edges[:, 1]]
    crossing = (s > 0) != (t > 0)
    start, end = edges[crossing].T
    w = (s[crossing] / (s[crossing] - t[crossing]))[:, None]
    return vertices[start] * (1 - w) + vertices[end] * w


def girth(vertices: Array, faces: Array, level: float) -> float:
    """Length of a tape measure held level around a surface: the perimeter of the slice's convex hull.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices of the parts the tape goes around.
        level: Height of the slice, cm.

    Returns:
        Girth in cm, 0 when the slice is empty.
    """
    outline = _hull(slice_points(vertices, faces, np.array([0.0, 1.0, 0.0]), level)[:, [0, 2]])
    return _perimeter(outline)


def measure_body(
    vertices: Array, faces: Array, vertex_part: Array, known: Mapping[str, float] | None = None
) -> BodyMeasurements:
    """Measures what can be measured on a mesh; the rest is the mean body's, scaled by the height.

    Girths are those of a level tape (see `girth`), arms left out. The bust is where the chest reaches
    furthest forward, the hips are the fullest slice and the waist is the narrowest above them, each within a
    window of heights that fits adults. Not measured but scaled: head length, neck width, slope of the
    shoulders, the lines over the bust, bust and bum points, the slope of the hips, and the share of the back
    in each girth.

    Args:
        vertices: (N, 3) positions, cm, standing on the floor, facing +Z.
        faces: (M, 3) vertex indices.
        vertex_part: (N,) uint8 `BodyPart` labels.
        known: Measurements already known by GarmentCode's names; they are kept, and girths
            are taken at the levels they give.
    """
    vertices = np.asarray(vertices, np.float64)
    given = dict(known or {})
    height = float(vertices[:, 1].max() - vertices[:, 1].min())
    scale = given.get("height", height) / MEAN_BODY["height"]
    values = {name: value if name in _ANGLES else value * scale for name, value in MEAN_BODY.items()} | {
        "height": height
    }
    values.update(_torso(vertices, faces, vertex_part, values | given, given))
    values.update(_legs(vertices, faces, vertex_part, values | given))
    for part in (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM):
        values.update(_arm(vertices, faces, vertex_part, part, height))
    return BodyMeasurements.from_mapping(values | given)


def _torso(
    vertices: Array,
    faces: Array,
    vertex_part: Array,
    values: Mapping[str, float],
    given: Mapping[str, float],
) -> dict[str, float]:
    """Levels and girths of the torso and shoulders."""
    height = float(vertices[:, 1].max())
    arms = np.isin(face_parts(faces, vertex_part), [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    trunk = faces[~arms]
    neck = height - values["head_l"]
    bust = neck - given["vert_bust_line"] if "vert_bust_line" in given else None
    bust = _foremost_level(vertices, trunk, height) if bust is None else bust
    waist = neck - given["waist_line"] if "waist_line" in given else None
    waist = _extreme_level(vertices, trunk, height, _WAIST_WINDOW, largest=False) if waist is None else waist
    hips = waist - given["hips_line"] if "hips_line" in given else None
    hips = _extreme_level(vertices, trunk, height, _HIPS_WINDOW, largest=True) if hips is None else hips
    found = {"waist_line": neck - waist, "hips_line": waist - hips, "vert_bust_line": neck - bust}
    for name, level in (("bust", bust), ("waist", waist), ("hips", hips)):
        found[name] = girth(vertices, trunk, level)
        found[_BACK_OF[name]] = found[name] * MEAN_BODY[_BACK_OF[name]] / MEAN_BODY[name]
    found["underbust"] = min(girth(vertices, trunk, bust - _UNDERBUST_DROP * height), found["bust"])
    left = _joint(vertices, faces, vertex_part, BodyPart.LEFT_ARM)
    right = _joint(vertices, faces, vertex_part, BodyPart.RIGHT_ARM)
    if left is not None and right is not None:
        below_neck = neck - float(left[:, 1].min() + right[:, 1].min()) / 2
        found["armscye_depth"] = below_neck * MEAN_BODY["armscye_depth"] / _JOINT_BELOW_NECK
        found["shoulder_w"] = float(left[left[:, 1].argmax(), 0] - right[right[:, 1].argmax(), 0])
    return {name: value for name, value in found.items() if value > 0}


def _legs(vertices: Array, faces: Array, vertex_part: Array, values: Mapping[str, float]) -> dict[str, float]:
    """Crotch and thigh."""
    height = float(vertices[:, 1].max())
    arms = np.isin(face_parts(faces, vertex_part), [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    midline = slice_points(vertices, faces[~arms], np.array([1.0, 0.0, 0.0]), 0.0)
    hips_level = height - values["head_l"] - values["waist_line"] - values["hips_line"]
    found: dict[str, float] = {}
    crotch = hips_level - values["crotch_hip_diff"]
    if len(midline) and 0.40 * height < midline[:, 1].min() < 0.53 * height:
        crotch = float(midline[:, 1].min())
        found["crotch_hip_diff"] = max(hips_level - crotch, 0.01 * height)
    girths = []
    for sign in (1.0, -1.0):
        points = slice_points(vertices, faces[~arms], np.array([0.0, 1.0, 0.0]), crotch - 0.01 * height)
        girths.append(_perimeter(_hull(points[sign * points[:, 0] > 0][:, [0, 2]])))
    if min(girths) > 0:
        found["leg_circ"] = sum(girths) / 2
    return found


def _arm(
    vertices: Array, faces: Array, vertex_part: Array, part: BodyPart, height: float
) -> dict[str, float]:
    """Length, slope and wrist of one arm; nothing when the mesh has no such arm."""
    joint = _joint(vertices, faces, vertex_part, part)
    if joint is None:
        return {}
    own = faces[face_parts(faces, vertex_part) == part]
    shoulder = joint.mean(axis=0)
    points = vertices[np.unique(own)]
    along = points - shoulder
    reach = np.linalg.norm(along, axis=1)
    tip = points[reach.argmax()]
    axis = (tip - shoulder) / reach.max()
    # The hand is about a ninth of the height; the wrist is the narrowest slice around its beginning.
    expected = reach.max() - 0.105 * height
    places = np.arange(expected - 0.025 * height, expected + 0.025 * height, _STEP)
    sizes = [slice_girth(vertices, own, axis, float(shoulder @ axis + place)) for place in places]
    if min(sizes) <= 0:
        return {}
    narrowest = int(np.argmin(sizes))
    wrist = slice_points(vertices, own, axis, float(shoulder @ axis + places[narrowest])).mean(axis=0)
    top = joint[joint[:, 1].argmax()]
    fall = wrist - shoulder
    return {
        "arm_length": float(np.linalg.norm(wrist - top)),
        "arm_pose_angle": float(np.degrees(np.arctan2(-fall[1], abs(fall[0])))),
        "wrist": sizes[narrowest],
    }


def arm_axis(vertices: Array, faces: Array, vertex_part: Array, part: BodyPart) -> tuple[Array, Array]:
    """Middle (3,) of the joint of an arm, cm, and the direction (3,) from there to the tip of the hand.

    Raises:
        InputError: The body has no such arm.
    """
    joint = _joint(vertices, faces, vertex_part, part)
    if joint is None:
        raise InputError("The body has no arms where an A-pose has them; sleeves cannot be measured on it.")
    shoulder = joint.mean(axis=0)
    points = vertices[np.asarray(vertex_part) == part]
    tip = points[np.linalg.norm(points - shoulder, axis=1).argmax()]
    return shoulder, (tip - shoulder) / np.linalg.norm(tip - shoulder)


def _joint(vertices: Array, faces: Array, vertex_part: Array, part: BodyPart) -> Array | None:
    """Vertices (K, 3) of a part that touch faces of another, or None when there are none."""
    labels = np.asarray(vertex_part)[faces]
    mixed = (labels == part).any(axis=1) & (labels != part).any(axis=1)
    touching = np.unique(faces[mixed][labels[mixed] == part])
    return vertices[touching] if len(touching) else None


def _extreme_level(
    vertices: Array, faces: Array, height: float, window: tuple[float, float], largest: bool
) -> float:
    """Height of the slice with the largest or smallest girth in a window of relative heights, cm."""
    levels = np.arange(window[0] * height, window[1] * height, _STEP)
    sizes = np.array([girth(vertices, faces, float(level)) for level in levels])
    return float(levels[sizes.argmax() if largest else sizes.argmin()])


def _foremost_level(vertices: Array, faces: Array, height: float) -> float:
    """Height of the foremost point of the chest, cm."""
    points = vertices[np.unique(faces)]
    low, high = _BUST_WINDOW
    chest = points[(points[:, 1] > low * height) & (points[:, 1] < high * height)]
    return float(chest[chest[:, 2].argmax(), 1]) if len(chest) else (low + high) / 2 * height


def slice_girth(vertices: Array, faces: Array, axis: Array, offset: float) -> float:
    """Length of a tape measure around a slice across `axis`: the perimeter of its convex hull, cm.

    Args:
        vertices: (N, 3) positions, cm.
        faces: (M, 3) vertex indices of the parts the tape goes around.
        axis: (3,) unit normal of the slice.
        offset: Position of the slice along `axis`, cm.
    """
    points = slice_points(vertices, faces, axis, offset)
    helper = np.eye(3)[np.abs(axis).argmin()]
    u = np.cross(axis, helper)
    u /= np.linalg.norm(u)
    return _perimeter(_hull(points @ np.stack([u, np.cross(axis, u)], axis=1)))


def _hull(points: Array) -> Array:
    """Corners (K, 2) of the convex hull, in order; empty when the points span no area."""
    from scipy.spatial import ConvexHull, QhullError

    if len(points) < 3:
        return np.zeros((0, 2))
    try:
        return points[ConvexHull(points).vertices]
    except QhullError:
        return np.zeros((0, 2))


def _perimeter(outline: Array) -> float:
    """Length of a closed polygon (K, 2)."""
    return (
        float(np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1).sum()) if len(outline) else 0.0
    )


def split_girth(outline: Array, side: float) -> tuple[float, float]:
    """Parts of a tape measure around a slice that lie in front of its sides and behind them, cm.

    Args:
        outline: (K, 2) x and z of the points of the slice, cm.
        side: z of the sides.
    """
    hull = _hull(outline)
    if not len(hull):
        return 0.0, 0.0
    closed = np.concatenate([hull, hull[:1]])
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    z = np.interp((np.arange(_TAPE) + 0.5) / _TAPE * length[-1], length, closed[:, 1])
    ahead = float((z > side).mean())
    return ahead * float(length[-1]), (1 - ahead) * float(length[-1])


def side_depth(outline: Array) -> float:
    """Depth of the sides of a slice: the middle of where it is nearly at its widest.

    Args:
        outline: (K, 2) x and z of the points of a slice, cm.
    """
    wide = np.abs(outline[:, 0]) > _NEARLY_WIDEST * np.abs(outline[:, 0]).max()
    return float(outline[wide, 1].min() + outline[wide, 1].max()) / 2


_NEARLY_WIDEST = 0.85
_TAPE = 2000
"""Places on a tape that are asked on which side they lie."""
_BACK_OF = {"bust": "back_width", "waist": "waist_back_width", "hips": "hip_back_width"}
_ANGLES = frozenset({"shoulder_incl", "arm_pose_angle", "hip_inclination"})

MEAN_BODY = {
    "height": 171.99,
    "head_l": 26.3262,
    "neck_w": 18.9328,
    "shoulder_w": 36.4568,
    "shoulder_incl": 21.6777,
    "bust": 99.8407,
    "underbust": 86.2455,
    "waist": 84.3338,
    "hips": 103.478,
    "bust_line": 25.6947,
    "waist_line": 36.8913,
    "hips_line": 23.4837,
    "arm_length": 53.9697,
    "arm_pose_angle": 45.483,
    "armscye_depth": 12.8679,
    "wrist": 16.5945,
    "leg_circ": 60.2039,
    "crotch_hip_diff": 8.81363,
    "back_width": 47.6761,
    "waist_back_width": 39.1358,
    "hip_back_width": 54.8237,
    "bum_points": 18.2342,
    "bust_points": 16.9463,
    "waist_over_bust_line": 40.5603,
    "vert_bust_line": 21.1388,
    "hip_inclination": 9.86489,
}
"""Measurements of GarmentCode's mean body, from which missing ones are scaled; cm and degrees."""
