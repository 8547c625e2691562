"""What stands behind people: rooms, streets and parks, made of textures and shapes.

Each maker returns (SIDE, SIDE, 3) levels from 0 to 1, as the eye sees them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.ndimage import gaussian_filter

from swifttailor.arrays import Array
from swifttailor.data.renders.backdrop_colors import Chance, Rgb, as_rgb, mixed_color, random_tint
from swifttailor.data.renders.foreground import Before
from swifttailor.render.motifs import smooth_noise

SIDE = 160
"""Pixels along each side of a backdrop of the bank."""


def _blank(color: Rgb) -> Array:
    return np.broadcast_to(np.asarray(color), (SIDE, SIDE, 3)).copy()


def _grain(chance: Chance, picture: Array, strength: float, slope: float = 1.2) -> Array:
    return picture * (1 + strength * smooth_noise(chance, SIDE, slope))[:, :, None]


def _box(picture: Array, x0: float, y0: float, x1: float, y1: float, color: Rgb) -> None:
    """Fills from the upper left to the lower right, shares of the picture."""
    a, b, c, d = (round(min(max(v, 0.0), 1.0) * SIDE) for v in (y0, y1, x0, x1))
    picture[a:b, c:d] = color


def _floor(chance: Chance, picture: Array, horizon: float) -> None:
    """A floor from below the wall to the picture's lower border: boards, tiles, carpet or plain."""
    rows = np.arange(round(horizon * SIDE), SIDE)
    if not len(rows):
        return
    eye = horizon - chance.uniform(0.25, 0.6)  # where lines of the floor meet
    depth = 1.0 / np.maximum(rows / SIDE - eye, 0.05)
    x = np.arange(SIDE) / SIDE - chance.uniform(0.2, 0.8)
    across, away = x[None] * depth[:, None], np.repeat(depth[:, None], SIDE, axis=1)
    color = np.asarray(random_tint(chance, 0.2, 0.85, 0.1) if chance.random() < 0.5 else _wood(chance))
    kind, scale = chance.random(), chance.uniform(2.0, 6.0)
    shade = np.ones_like(across)
    if kind < 0.45:  # boards
        board = np.floor(across * scale)
        shade = 0.9 + 0.2 * (np.sin(board * 12.9898) * 43758.5453 % 1)
        shade = np.where((across * scale) % 1 < 0.05, shade * 0.7, shade)
    elif kind < 0.7:  # tiles
        joint = ((across * scale) % 1 < 0.06) | ((away * scale * 1.5) % 1 < 0.06)
        shade = np.where(joint, chance.uniform(0.7, 1.2), 1.0)
        if chance.random() < 0.3:
            shade = np.where((np.floor(across * scale) + np.floor(away * scale * 1.5)) % 2 < 1, shade, 0.5)
    elif kind < 0.85:
        shade = 1 + 0.12 * chance.normal(size=across.shape)
    near = np.linspace(0.85, 1.05, len(rows))[:, None]
    picture[rows] = color * (shade * near)[:, :, None]


def _wood(chance: Chance) -> Rgb:
    return mixed_color((0.75, 0.58, 0.40), (0.30, 0.19, 0.12), chance.random())


def _walled(chance: Chance) -> tuple[Array, float]:
    """A wall with a floor and, mostly, skirting; and where they meet."""
    pale = chance.random() < 0.65
    wall = random_tint(chance, 0.7, 0.97, 0.04) if pale else random_tint(chance, 0.2, 0.8, 0.15)
    picture = _grain(chance, _blank(wall), float(chance.choice([0.0, 0.01, 0.03])))
    horizon = float(chance.uniform(0.72, 0.97))
    _floor(chance, picture, horizon)
    if chance.random() < 0.7:
        tall, color = chance.uniform(0.012, 0.04), random_tint(chance, 0.75, 0.98, 0.02)
        _box(picture, 0, horizon - tall, 1, horizon, color)
        _box(picture, 0, horizon - 0.006, 1, horizon + 0.004, as_rgb(np.asarray(color) * 0.6))
    return picture, horizon


def studio(chance: Chance) -> Array:
    """Paper, even or going over into another shade."""
    top = (
        random_tint(chance, 0.55, 1.0, 0.05) if chance.random() < 0.7 else random_tint(chance, 0.1, 0.8, 0.3)
    )
    bottom = as_rgb(np.clip(np.asarray(top) * chance.uniform(0.75, 1.1), 0, 1))
    down = np.linspace(0, 1, SIDE)[:, None, None]
    return np.broadcast_to((1 - down) * np.asarray(top) + down * np.asarray(bottom), (SIDE, SIDE, 3)).copy()


def _room(chance: Chance) -> Array:
    """Wall and floor with some pictures, a door, a mirror, a plant, a lamp."""
    picture, horizon = _walled(chance)
    for _ in range(int(chance.integers(0, 4))):
        kind, x = chance.random(), chance.uniform(-0.05, 0.95)
        if kind < 0.3:
            wide, y = chance.uniform(0.08, 0.25), chance.uniform(0.05, 0.4)
            tall = wide * chance.uniform(0.7, 1.5)
            _box(picture, x - 0.012, y - 0.012, x + wide + 0.012, y + tall + 0.012, random_tint(chance))
            _box(picture, x, y, x + wide, y + tall, random_tint(chance, 0.3, 0.95, 0.3))
            for _ in range(3):
                u, v = x + wide * chance.uniform(0.1, 0.6), y + tall * chance.uniform(0.1, 0.6)
                _box(picture, u, v, u + wide * 0.3, v + tall * 0.3, random_tint(chance, vivid=0.5))
        elif kind < 0.55:
            _door(chance, picture, x, horizon)
        elif kind < 0.75:
            _plant(chance, picture, x, horizon)
        else:
            wide, tall = chance.uniform(0.15, 0.4), chance.uniform(0.12, 0.35)
            color = random_tint(chance, 0.15, 0.8, 0.25)
            _box(picture, x, horizon - tall, x + wide, horizon + 0.05, color)
            _box(picture, x, horizon - tall, x + wide, horizon - tall * 0.9, as_rgb(np.asarray(color) * 1.2))
            for k in range(1, int(chance.integers(1, 4))):
                y = horizon - tall * k / 4
                _box(picture, x, y, x + wide, y + 0.007, as_rgb(np.asarray(color) * 0.6))
    return picture


def _door(chance: Chance, picture: Array, x: float, horizon: float) -> None:
    wide, top = chance.uniform(0.2, 0.34), chance.uniform(0.0, 0.12)
    frame = random_tint(chance, 0.6, 0.98, 0.04)
    leaf = frame if chance.random() < 0.5 else _wood(chance)
    _box(picture, x, top, x + wide, horizon, as_rgb(np.asarray(frame) * 0.85))
    _box(picture, x + 0.02, top + 0.02, x + wide - 0.02, horizon, leaf)
    for y0, y1 in ((0.1, 0.42), (0.5, 0.92)):
        a, b = top + y0 * (horizon - top), top + y1 * (horizon - top)
        _box(picture, x + 0.05, a, x + wide - 0.05, b, as_rgb(np.asarray(leaf) * 0.8))
        _box(picture, x + 0.056, a + 0.006, x + wide - 0.05, b, as_rgb(np.asarray(leaf) * 0.97))


def _plant(chance: Chance, picture: Array, x: float, horizon: float) -> None:
    wide, tall = chance.uniform(0.06, 0.1), chance.uniform(0.08, 0.14)
    _box(picture, x, horizon - tall, x + wide, horizon + 0.03, random_tint(chance, 0.2, 0.9, 0.2))
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    for _ in range(24):
        turn, length = chance.uniform(-1.3, 1.3), chance.uniform(0.08, 0.3)
        dx, dy = xx - x - wide / 2, horizon - tall - yy
        along, across = dx * np.sin(turn) + dy * np.cos(turn), dx * np.cos(turn) - dy * np.sin(turn)
        blade = (along > 0) & (along < length) & (np.abs(across) < 0.012 + 0.05 * length * (along / length))
        picture[blade] = (
            np.array([0.15, 0.35, 0.15]) * chance.uniform(0.5, 1.7) * chance.uniform(0.85, 1.15, 3)
        )


def _bricks(chance: Chance) -> Array:
    """Bricks or large tiles on a wall."""
    joint, base = random_tint(chance, 0.45, 0.9, 0.03), np.asarray(_brick_color(chance))
    tall = chance.uniform(0.02, 0.07)
    wide = tall * chance.uniform(1.0, 3.2)
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    row = np.floor(yy / tall)
    column = np.floor(xx / wide + 0.5 * (row % 2))
    shade = 1 + chance.uniform(0.03, 0.25) * (
        (np.sin(row * 12.9898 + column * 78.233) * 43758.5453 % 1) - 0.5
    )
    gap = 0.10
    picture = base * shade[:, :, None]
    picture[(yy / tall % 1 < gap) | ((xx / wide + 0.5 * (row % 2)) % 1 < gap * tall / wide)] = joint
    picture = _grain(chance, picture, 0.05)
    _floor(chance, picture, float(chance.uniform(0.8, 1.0)))
    return picture


def _brick_color(chance: Chance) -> Rgb:
    if chance.random() < 0.4:
        return random_tint(chance, 0.7, 0.95, 0.03)
    return mixed_color((0.65, 0.36, 0.27), (0.45, 0.40, 0.36), chance.random())


def _curtain(chance: Chance) -> Array:
    """A curtain in folds, wholly or beside a bright window."""
    x = np.linspace(0, 1, SIDE)
    wave = sum(
        chance.uniform(0.3, 1) * np.sin(2 * np.pi * chance.uniform(4, 22) * x + chance.uniform(0, 7))
        for _ in range(4)
    )
    picture = _blank(random_tint(chance, 0.3, 0.95, 0.15)) * (1 + 0.10 * wave)[None, :, None]
    if chance.random() < 0.5:
        left, right = sorted(chance.uniform(0.1, 0.9, 2))
        bright = random_tint(chance, 0.85, 1.0, 0.02)
        _box(picture, left, 0.0, right, chance.uniform(0.5, 0.9), bright)
        _box(
            picture,
            (left + right) / 2 - 0.01,
            0.0,
            (left + right) / 2 + 0.01,
            0.6,
            random_tint(chance, 0.5, 0.9, 0.02),
        )
    _floor(chance, picture, float(chance.uniform(0.85, 1.0)))
    return picture


def _shelves(chance: Chance) -> Array:
    """Books, boxes and clothes on shelves or rails."""
    picture, horizon = _walled(chance)
    back = random_tint(chance, 0.2, 0.8, 0.1)
    left, right = chance.uniform(-0.1, 0.3), chance.uniform(0.6, 1.1)
    _box(picture, left, 0.0, right, horizon, back)
    board, count = _wood(chance), int(chance.integers(2, 6))
    vivid = chance.uniform(0.1, 0.5)
    for row in range(count):
        low = horizon * (row + 1) / count
        x = left
        while x < right:
            wide, tall = chance.uniform(0.012, 0.07), chance.uniform(0.3, 0.9) * horizon / count
            if chance.random() < 0.85:
                _box(picture, x, low - tall, min(x + wide, right), low, random_tint(chance, vivid=vivid))
            x += wide + chance.uniform(0, 0.012)
        _box(picture, left, low - 0.012, right, low + 0.008, board)
    return picture


def _window(chance: Chance) -> Array:
    """A window with the day outside."""
    picture, horizon = _walled(chance)
    x, wide = chance.uniform(0.0, 0.5), chance.uniform(0.3, 0.6)
    y, low = chance.uniform(0.0, 0.1), chance.uniform(0.45, max(0.5, horizon - 0.03))
    frame = random_tint(chance, 0.75, 1.0, 0.02)
    _box(picture, x - 0.02, y - 0.02, x + wide + 0.02, low + 0.02, frame)
    outside = gaussian_filter(_park(chance) if chance.random() < 0.6 else _street(chance), (3, 3, 0))
    rows, columns = (
        slice(round(y * SIDE), round(low * SIDE)),
        slice(round(x * SIDE), round(min(x + wide, 1) * SIDE)),
    )
    picture[rows, columns] = np.clip(outside[rows, columns] * 1.15 + 0.15, 0, 1)
    for k in range(1, int(chance.integers(2, 4))):
        bar = x + wide * k / 3
        _box(picture, bar, y, bar + 0.012, low, frame)
    _box(picture, x, (y + low) / 2, x + wide, (y + low) / 2 + 0.012, frame)
    return picture


def _stairs(chance: Chance) -> Array:
    """Steps that rise to the back, or aside."""
    wall = random_tint(chance, 0.35, 0.9, 0.08)
    picture = _grain(chance, _blank(wall), 0.03)
    count, top = int(chance.integers(4, 11)), chance.uniform(0.1, 0.5)
    color, slant = np.asarray(random_tint(chance, 0.4, 0.85, 0.06)), chance.uniform(-0.12, 0.12)
    for k in range(count):
        y = top + (1 - top) * (k / count) ** 1.3
        x = slant * k
        _box(picture, x, y, 1 + x if slant < 0 else 1, 1, as_rgb(color * (1.05 - 0.02 * (count - k))))
        _box(picture, x, y, 1, y + 0.4 * (1 - top) / count, as_rgb(np.clip(color * 1.15, 0, 1)))
    return picture


def _sky(chance: Chance) -> Array:
    blue = mixed_color((0.55, 0.72, 0.92), (0.85, 0.88, 0.92), chance.random())
    down = np.linspace(0, 1, SIDE)[:, None, None]
    picture = (1 - down) * np.asarray(blue) + down * np.clip(np.asarray(blue) * 1.15 + 0.08, 0, 1)
    cloud = np.clip(smooth_noise(chance, SIDE, 1.8, 0.5) - chance.uniform(0, 1.5), 0, 1)[:, :, None]
    return picture + 0.5 * cloud * (1 - picture)


def _street(chance: Chance) -> Array:
    """Houses on both sides, a road between, that run together."""
    picture = _sky(chance)
    vx, vy = chance.uniform(0.25, 0.75), chance.uniform(0.3, 0.55)
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    dx, dy = xx - vx, yy - vy
    ground = random_tint(chance, 0.3, 0.65, 0.05)
    open_ = chance.uniform(0.5, 2.0)
    road = (dy > 0) & (np.abs(dx) < dy * (open_ + 1.2))
    picture[dy > 0] = np.asarray(random_tint(chance, 0.5, 0.8, 0.05))
    picture[road] = np.asarray(ground)
    for side in (-1, 1):
        base, tall = np.asarray(random_tint(chance, 0.35, 0.85, 0.12)), chance.uniform(0.6, 1.6)
        out = side * dx
        wall = (out > 0.03) & (dy < out * chance.uniform(0.5, 1.0)) & (-dy < out * tall * 1.2)
        depth = 1.0 / np.maximum(out, 0.03)
        shade = 0.9 + 0.15 * np.sin(np.floor(depth * 1.2) * 91.7)
        picture[wall] = (base * shade[:, :, None])[wall]
        height = dy * depth
        window = wall & (depth * 3 % 1 > 0.35) & (height * 4.5 % 1 > 0.45) & (height < 0.15)
        picture[window] = np.asarray(random_tint(chance, 0.1, 0.5, 0.1))
    return _grain(chance, picture, 0.05)


def _park(chance: Chance) -> Array:
    """Grass or sand, trees or the sea, and sky."""
    picture = _sky(chance)
    horizon = float(chance.uniform(0.35, 0.75))
    rows = slice(round(horizon * SIDE), SIDE)
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    if chance.random() < 0.2:  # the sea
        sea = slice(round((horizon - 0.15) * SIDE), SIDE)
        picture[sea] = (
            np.array([0.3, 0.52, 0.62]) * (1 + 0.08 * smooth_noise(chance, SIDE, 1.0, 0.1))[sea, :, None]
        )
        picture[rows] = np.array([0.85, 0.77, 0.62])
        return _grain(chance, picture, 0.04, 0.8)
    leaf = np.asarray(mixed_color((0.20, 0.33, 0.13), (0.42, 0.48, 0.22), chance.random()))
    if chance.random() < 0.15:
        leaf = np.array([0.62, 0.38, 0.16])  # autumn
    for _ in range(int(chance.integers(3, 14))):
        x, y, size = (
            chance.uniform(-0.1, 1.1),
            horizon - chance.uniform(0.05, 0.35),
            chance.uniform(0.08, 0.3),
        )
        trunk = np.array([0.25, 0.19, 0.14]) * chance.uniform(0.7, 1.4)
        _box(picture, x - 0.04 * size, y, x + 0.04 * size, horizon + 0.03, as_rgb(trunk))
        bumpy = smooth_noise(chance, SIDE, 1.3)
        crown = (xx - x) ** 2 + ((yy - y) * 0.85) ** 2 < (size * (1 + 0.2 * bumpy)) ** 2
        shade = chance.uniform(0.6, 1.3) * (1 + 0.22 * bumpy)
        picture[crown] = (leaf * np.clip(shade, 0.3, 2)[:, :, None])[crown]
    grass = (
        leaf * chance.uniform(1.0, 1.6)
        if chance.random() < 0.7
        else np.asarray(random_tint(chance, 0.4, 0.75, 0.08))
    )
    picture[rows] = grass * (1 + 0.16 * smooth_noise(chance, SIDE, 0.7, 0.5))[rows, :, None]
    if chance.random() < 0.4:
        path = (yy > horizon) & (np.abs(xx - 0.5) < (yy - horizon) * chance.uniform(0.5, 1.4) + 0.03)
        picture[path] = np.asarray(random_tint(chance, 0.55, 0.8, 0.05))
    return picture


def _bokeh(chance: Chance) -> Array:
    """Lights and colours far out of focus."""
    picture = _blank(random_tint(chance, 0.05, 0.5, 0.3))
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    hue = np.asarray(random_tint(chance, 0.5, 0.9, 0.3))
    for _ in range(int(chance.integers(10, 40))):
        x, y, size = *chance.uniform(0, 1, 2), chance.uniform(0.015, 0.09)
        disc = (xx - x) ** 2 + (yy - y) ** 2 < size**2
        light = np.clip(hue * chance.uniform(0.7, 1.5) * chance.uniform(0.7, 1.3, 3), 0, 1)
        picture[disc] += chance.uniform(0.1, 0.6) * (light - picture[disc])
    return picture


def _texture(chance: Chance) -> Array:
    """Concrete, plaster, a hedge, rock: noise of two colours."""
    a, b = random_tint(chance, 0.2, 0.9, 0.1), random_tint(chance, 0.2, 0.9, 0.1)
    stretch = float(chance.choice([1.0, 0.3, 3.0]))
    share = np.clip(0.5 + 0.3 * smooth_noise(chance, SIDE, chance.uniform(0.8, 1.8), stretch), 0, 1)
    picture = np.asarray(a) + share[:, :, None] * (np.asarray(b) - np.asarray(a))
    _floor(chance, picture, float(chance.uniform(0.75, 1.1)))
    return picture


def _people(chance: Chance) -> Array:
    """A crowd some way off."""
    picture = _street(chance) if chance.random() < 0.5 else _room(chance)
    cover = np.ones((SIDE, SIDE), np.float32)
    light = picture.astype(np.float32)
    for _ in range(int(chance.integers(1, 6))):
        x, tall, low = chance.uniform(0, 1), chance.uniform(0.3, 0.6), chance.uniform(0.8, 1.0)
        skin = mixed_color((0.8, 0.62, 0.52), (0.35, 0.24, 0.18), chance.random())
        top = low - tall
        for dx in (-0.04, 0.04):
            foot = x + dx * tall * 1.5
            Before(
                (x + dx * tall, top + 0.5 * tall), (foot, low), 0.05 * tall, random_tint(chance), 0.01
            ).put(light, cover)
        shirt = random_tint(chance, vivid=0.4)
        Before((x, top + 0.24 * tall), (x, top + 0.48 * tall), 0.1 * tall, shirt, 0.01).put(light, cover)
        Before((x, top + 0.06 * tall), (x, top + 0.07 * tall), 0.055 * tall, skin, 0.01).put(light, cover)
    return gaussian_filter(light, (chance.uniform(0.8, 3), chance.uniform(0.8, 3), 0))


MAKERS: tuple[tuple[str, Callable[[Chance], Array]], ...] = (
    ("room", _room),
    ("studio", studio),
    ("street", _street),
    ("bricks", _bricks),
    ("park", _park),
    ("room", _room),
    ("curtain", _curtain),
    ("shelves", _shelves),
    ("texture", _texture),
    ("window", _window),
    ("studio", studio),
    ("room", _room),
    ("stairs", _stairs),
    ("bokeh", _bokeh),
    ("park", _park),
    ("people", _people),
)
