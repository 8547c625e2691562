"""Hair for the default body: a shell over the skull, and what falls from it."""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Array, read_only
from swifttailor.body.body import Body
from swifttailor.body.mannequin import mannequin
from swifttailor.errors import InputError

CROWN = np.array([0.0, 160.0, 0.8])
"""From where the skull is seen, cm."""
AROUND, ALONG = 48, 26
"""Strands around the head, and points along each."""
_FALLS_AT = np.deg2rad(88.0)
"""Below this angle from straight up a strand no longer follows the skull."""
BEHIND_CM = 155.0, 144.0
"""Between these levels long hair goes behind the shoulders."""
_BEFORE_CM = 8.0
"""In front of the middle of the head: where hair that falls on the chest starts to lie."""
_SPREAD_CM = 4.5, 13.0
"""From and to where it lies beside the middle."""
_OFF_BODY_CM = 1.8
"""What falls on the shoulders stays this far from the skin, so that a garment fits beneath."""


@dataclass(frozen=True)
class HairStyle:
    """How hair is worn."""

    thickness: float
    """On the skull, cm."""
    ends: float | None = None
    """Level to which it falls, cm above the floor; None: it ends at the hairline."""
    opening: float = 62.0
    """Half the angle around the head that falling hair leaves to the face, degrees."""
    before: float = 0.0
    """Hair that starts within this angle from the face falls before the shoulders, degrees."""
    knot: tuple[tuple[float, float, float], ...] = ()
    """Where hair that is tied goes, from the head to its end: height, depth and radius, cm."""
    waves: float = 0.0
    """How far falling hair swings to and fro, cm."""
    wavelength: float = 8.0
    """Along it, cm."""
    uneven: float = 0.0
    """By what share its thickness varies around the head."""


HAIR_STYLES = {
    "cropped": HairStyle(0.5),
    "short": HairStyle(1.5),
    "bob": HairStyle(2.2, 149.0),
    "shoulder_length": HairStyle(2.0, 140.0, 66.0),
    "long": HairStyle(1.9, 124.0, 70.0),
    "loose": HairStyle(2.3, 131.0, 62.0, before=108.0),
    "long_loose": HairStyle(2.1, 118.0, 64.0, before=112.0),
    "wavy": HairStyle(2.6, 128.0, 58.0, before=100.0, waves=1.2, wavelength=9.0, uneven=0.15),
    "curly": HairStyle(5.0, 143.0, 58.0, waves=1.0, wavelength=4.0, uneven=0.25),
    "afro": HairStyle(7.0, uneven=0.1),
    "bun": HairStyle(
        0.8,
        knot=(
            *((166.0, -7.0, 1.5), (166.2, -8.0, 3.2), (166.4, -9.5, 4.2), (166.5, -11.5, 4.2)),
            *((166.5, -13.0, 3.0), (166.5, -13.8, 0.8)),
        ),
    ),
    "ponytail": HairStyle(
        0.8,
        knot=(
            *((163.5, -7.5, 1.6), (163.5, -9.5, 1.7), (162.0, -11.8, 2.4), (157.5, -13.4, 3.0)),
            *((151.5, -14.2, 2.8), (146.0, -14.8, 2.0), (141.5, -15.2, 0.4)),
        ),
    ),
}


VARIANTS = 8
"""Of each style, beside the style itself."""


def hair_by_lot(chance: np.random.Generator) -> str:
    """A style, or one of its variants: ``wavy~3`` is longer, fuller or falls otherwise than ``wavy``."""
    style, variant = str(chance.choice(list(HAIR_STYLES))), int(chance.integers(VARIANTS + 1))
    return f"{style}~{variant}" if variant else style


def hair(style: str) -> tuple[Array, Array]:
    """The hair of the standing default body, to be carried along with it.

    Args:
        style: One of `HAIR_STYLES`, or a variant of one (`hair_by_lot`).

    Returns:
        Vertices (P, 3) in cm and faces (M, 3), anticlockwise seen from outside; the surface is open, so it
        has an inside to draw.

    Raises:
        InputError: There is no such style.
    """
    return _hair(style)


def strand_shades(style: str, strength: float, chance: np.random.Generator) -> Array:
    """How light each face of some hair is, strand by strand: what tells hair from cloth.

    Args:
        style: See `hair`.
        strength: 0 makes all faces alike.
        chance: Decides.

    Returns:
        (M,) factors on the colour of its faces.

    Raises:
        InputError: There is no such style.
    """
    count = len(hair(style)[1])
    of_strand = chance.normal(0.0, strength, AROUND)
    along = np.cumsum(chance.normal(0.0, 0.3 * strength, (AROUND, ALONG - 1)), axis=1)
    shades = np.exp(np.clip(of_strand[:, None] + along, -1.5, 1.0)).ravel()
    rest = count - 2 * len(shades)  # of a knot or a tail
    return np.concatenate([shades, shades, np.exp(chance.normal(0.0, strength, rest))])


def _style(name: str) -> HairStyle:
    """A style by its name, or the variant that its number decides."""
    base, tilde, number = name.partition("~")
    known = base in HAIR_STYLES
    if not known or (tilde and not (number.isdecimal() and 1 <= int(number) <= VARIANTS)):
        raise InputError(
            f"There is no hair style {name!r}; there are {', '.join(HAIR_STYLES)}, and variants of each from "
            f"~1 to ~{VARIANTS}."
        )
    style = HAIR_STYLES[base]
    if not tilde:
        return style
    chance = np.random.default_rng([int(number), list(HAIR_STYLES).index(base)])
    falls = style.ends is not None
    opening = style.opening + chance.uniform(-9.0, 9.0) * falls
    return replace(
        style,
        thickness=style.thickness * chance.uniform(0.75, 1.7),
        ends=None if style.ends is None else style.ends + chance.uniform(-9.0, 9.0),
        opening=opening,
        before=max(style.before + chance.uniform(-12.0, 12.0), opening + 20.0) if style.before else 0.0,
        waves=max(style.waves, chance.uniform(-1.0, 1.6)) if falls else 0.0,
        wavelength=chance.uniform(5.0, 13.0),
        uneven=max(style.uneven, chance.uniform(0.0, 0.3)),
    )


@functools.lru_cache(maxsize=128)
def _hair(name: str) -> tuple[Array, Array]:
    style = _style(name)
    turn = np.linspace(0.0, 2 * np.pi, AROUND, endpoint=False)  # 0 is the back
    fuller = _rises(np.random.default_rng(AROUND), style.uneven)
    strands = np.stack(
        [
            _strand(replace(style, thickness=style.thickness * full), angle)
            for angle, full in zip(turn, fuller, strict=True)
        ]
    )
    if style.ends is not None:
        strands = _off_the_body(_waved(strands, style))
    rows, columns = np.arange(ALONG - 1), np.arange(AROUND)
    a = columns[:, None] * ALONG + rows
    b = (columns[:, None] + 1) % AROUND * ALONG + rows
    quads = np.stack([a, b, b + 1, a + 1], axis=-1).reshape(-1, 4)
    vertices, faces = [strands.reshape(-1, 3)], [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
    if style.knot:
        tail, sides = _tail(np.array(style.knot))
        faces.append(sides + len(vertices[0]))
        vertices.append(tail)
    return read_only(np.concatenate(vertices)), read_only(np.concatenate(faces).astype(np.int32))


def _rises(chance: np.random.Generator, strength: float) -> Array:
    """(AROUND,) factors around the head that rise and fall by locks of about four strands."""
    turn = np.linspace(0.0, 2 * np.pi, AROUND, endpoint=False)
    orders = np.arange(2, 13)
    phases, sizes = chance.uniform(0, 2 * np.pi, len(orders)), chance.normal(0, 1, len(orders))
    wave = (sizes * np.cos(turn[:, None] * orders + phases)).sum(axis=1)
    return 1.0 + strength * wave / np.abs(wave).max()


def _waved(strands: Array, style: HairStyle) -> Array:
    """Strands (AROUND, ALONG, 3) whose falling part swings out and in, lock by lock, more the lower it is."""
    if not style.waves:
        return strands
    middle = strands - (0.0, 0.0, CROWN[2])
    out = middle * (1.0, 0.0, 1.0)
    out /= np.maximum(np.linalg.norm(out, axis=-1, keepdims=True), 1e-6)
    aside = np.stack([out[..., 2], np.zeros(out.shape[:2]), -out[..., 0]], axis=-1)
    fallen = np.clip(CROWN[1] - strands[..., 1], 0.0, None)
    phase = 3.0 * (_rises(np.random.default_rng(ALONG), 1.0) - 1.0)[:, None]
    angle = 2 * np.pi * fallen / style.wavelength + phase
    reach = style.waves * np.clip(fallen / 12.0, 0.0, 1.0)
    swung = np.cos(angle)[..., None] * out + 0.6 * np.sin(angle)[..., None] * aside
    return strands + reach[..., None] * swung


def _strand(style: HairStyle, turn: float) -> Array:
    """(ALONG, 3) from the top of the head to the end of the hair."""
    around = np.array([np.sin(turn), 0.0, -np.cos(turn)])
    steps = np.linspace(0.0, np.pi, 90)
    line = CROWN + _radius(around, steps, style.thickness)[:, None] * (
        np.sin(steps)[:, None] * around + np.cos(steps)[:, None] * (0.0, 1.0, 0.0)
    )
    over_hairline = line[:, 1] > 157.0 + 0.95 * line[:, 2]
    last = int(np.argmin(over_hairline)) if not over_hairline.all() else len(line)
    # Seen from the front the face is open; beside it the hair falls.
    to_face = np.pi - abs((turn + np.pi) % (2 * np.pi) - np.pi)
    if style.ends is not None and to_face > np.deg2rad(style.opening):
        leaves = int(np.searchsorted(steps, _FALLS_AT))
        start = line[leaves]
        down = np.arange(start[1], style.ends, -0.5)[1:]
        # Below the ears it goes behind the shoulders, and what does not come so far a little inward.
        behind = np.clip((BEHIND_CM[0] - down) / (BEHIND_CM[0] - BEHIND_CM[1]), 0.0, 1.0)
        behind = behind * behind * (3 - 2 * behind) if style.ends < BEHIND_CM[1] else 0.25 * behind
        aside, depth = start[0] * (1.0 - 0.12 * behind), min(-9.0 - 0.25 * abs(start[2]) - start[2], 0.0)
        if to_face < np.deg2rad(style.before):
            # Those next to the face come farthest to the middle of the chest.
            share = (np.rad2deg(to_face) - style.opening) / (style.before - style.opening)
            fallen = np.sign(start[0]) * (_SPREAD_CM[0] + share * (_SPREAD_CM[1] - _SPREAD_CM[0]))
            aside, depth = start[0] + behind * (fallen - start[0]), max(_BEFORE_CM - start[2], 0.0)
        flat = np.stack([aside, start[2] + behind * depth], axis=1)
        line = np.concatenate([line[: leaves + 1], np.stack([flat[:, 0], down, flat[:, 1]], axis=1)])
    else:
        line = line[:last]
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    even = np.linspace(0.0, along[-1], ALONG)
    return np.stack([np.interp(even, along, line[:, k]) for k in range(3)], axis=1)


def _radius(around: Array, steps: Array, thickness: float) -> Array:
    """Distance (n,) of the hair from the middle of the head, at angles (n,) from straight up."""
    directions = np.sin(steps)[:, None] * around + np.cos(steps)[:, None] * (0.0, 1.0, 0.0)
    tree, radii = _skull()
    away, nearest = tree.query(directions, k=8)
    near = np.exp(-((away / 0.12) ** 2))
    skull = (near * radii[nearest]).sum(axis=1) / near.sum(axis=1)
    height = skull * directions[:, 1] + CROWN[1]
    depth = skull * directions[:, 2] + CROWN[2]
    # Thin at the hairline, full above it.
    above = np.clip((height - 157.0 - 0.95 * depth) / 6.0, 0.0, 1.0)
    return skull + 0.25 + thickness * above * (2 - above)


@functools.cache
def _skull():
    from scipy.spatial import KDTree

    vertices, _ = mannequin(Body.default())
    head = vertices[vertices[:, 1] > 146.0] - CROWN
    radii = np.linalg.norm(head, axis=1)
    return KDTree(head / radii[:, None]), radii


def _off_the_body(strands: Array) -> Array:
    """Strands (n, ALONG, 3) pushed out of the neck, the shoulders and the chest."""
    body, points = Body.default(), strands.reshape(-1, 3).copy()
    low = np.flatnonzero(points[:, 1] < BEHIND_CM[0])
    outward = (points[low] - (0.0, 0.0, -2.0)) * (0.3, 0.0, 1.0)
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    for _ in range(12):
        distance, _ = body.signed_distance(points[low])
        points[low] += np.maximum(_OFF_BODY_CM - distance, 0.0)[:, None] * outward
    smooth = points.reshape(strands.shape)
    for _ in range(6):
        around = 0.5 * (np.roll(smooth, 1, axis=0) + np.roll(smooth, -1, axis=0))
        is_free = (np.linalg.norm(around - smooth, axis=-1) < 3.0)[..., None]
        smooth = np.where(is_free, 0.5 * (smooth + around), smooth)
    return smooth


def _tail(knot: Array) -> tuple[Array, Array]:
    """A tube in the middle plane around points (n, 3) of height, depth and radius."""
    columns = 14
    ahead = np.gradient(knot[:, :2], axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    turn = np.linspace(0.0, 2 * np.pi, columns, endpoint=False)
    x = knot[:, 2:] * np.sin(turn)
    across = knot[:, 2:] * np.cos(turn)
    points = np.stack([x, knot[:, :1] + ahead[:, 1:] * across, knot[:, 1:2] - ahead[:, :1] * across], axis=-1)
    k = np.arange(len(knot) - 1)[:, None] * columns
    a, b = k + np.arange(columns), k + (np.arange(columns) + 1) % columns
    quads = np.stack([a, b, b + columns, a + columns], axis=-1).reshape(-1, 4)
    return points.reshape(-1, 3), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
