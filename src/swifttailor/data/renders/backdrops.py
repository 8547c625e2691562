"""Rooms and streets behind the figure, and things before it: made of textures and shapes.

A process makes each backdrop of a bank once, when it is first asked for; pictures show parts of them, turned
round and tinted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.ndimage import gaussian_filter

from swifttailor.arrays import Array
from swifttailor.render.motifs import smooth_noise

SIDE = 160
"""Pixels along each side of a backdrop of the bank."""
BANK = 320
"""How many there are."""
Rgb = tuple[float, float, float]
_Chance = np.random.Generator


@dataclass(frozen=True)
class Scenery:
    """A part of a backdrop of the bank."""

    number: int
    corner: tuple[float, float] = (0.0, 0.0)
    """Upper left, as shares of what the part leaves free."""
    part: float = 1.0
    """Share of the backdrop's side that is seen."""
    flip: bool = False
    tint: Rgb = (1.0, 1.0, 1.0)

    def light(self, size: int) -> Array:
        """(size, size, 3) float32 linear light."""
        whole = backdrop(self.number % BANK)
        if self.flip:
            whole = whole[:, ::-1]
        reach = self.part * (SIDE - 1)
        start = np.asarray(self.corner) * (SIDE - 1 - reach)
        at = np.linspace(0, reach, size, dtype=np.float32)
        picture = _between(_between(whole, at + np.float32(start[0]), 0), at + np.float32(start[1]), 1)
        picture *= np.asarray(self.tint, np.float32)
        return picture


@dataclass(frozen=True)
class Before:
    """A rod with round ends before the figure: a limb, a bag, the edge of a table."""

    start: tuple[float, float]
    """Of its middle line: across and down, as shares of the picture."""
    end: tuple[float, float]
    radius: float
    """As a share of the picture."""
    color: Rgb
    soft: float = 0.01
    """Over which share of the picture its border is out of focus."""

    def put(self, picture: Array, cover: Array) -> None:
        """Puts it over linear light (h, w, 3) float32, and lowers what it leaves to see, `cover` (h, w)."""
        height, width = cover.shape
        reach = self.radius + self.soft
        columns, rows = (
            slice(
                max(int((min(self.start[k], self.end[k]) - reach) * n), 0),
                max(int((max(self.start[k], self.end[k]) + reach) * n) + 1, 0),
            )
            for k, n in ((0, width), (1, height))
        )
        if rows.start >= height or columns.start >= width:
            return
        x = ((np.arange(width, dtype=np.float32)[columns] + 0.5) / width)[None]
        y = ((np.arange(height, dtype=np.float32)[rows] + 0.5) / height)[:, None]
        (x0, y0), (x1, y1) = self.start, self.end
        length = max((x1 - x0) ** 2 + (y1 - y0) ** 2, 1e-9)
        along = np.clip(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length, 0, 1)
        dx, dy = x - x0 - along * (x1 - x0), y - y0 - along * (y1 - y0)
        away = np.sqrt(dx * dx + dy * dy)
        alpha = np.clip((self.radius - away) / max(self.soft, 2e-3) + 0.5, 0, 1)
        round_ = 0.55 + 0.45 * np.sqrt(np.clip(1 - (away / self.radius) ** 2, 0, 1))
        round_ *= 1 + 0.25 * np.clip(-(dx + dy) / self.radius, -1, 1)
        for k in range(3):
            part = picture[rows, columns, k]
            part += alpha * (np.float32(self.color[k]) * round_ - part)
        cover[rows, columns] *= 1 - alpha


def random_scenery(chance: _Chance) -> Scenery:
    """A part of a backdrop drawn by lot."""
    warmth, shade = chance.normal(0, 0.05), float(np.clip(chance.normal(1.0, 0.18), 0.5, 1.5))
    x, y = chance.random(2)
    return Scenery(
        number=int(chance.integers(BANK)),
        corner=(float(1.0 - 0.5 * y), float(x)),
        part=float(chance.uniform(0.55, 1.0)),
        flip=bool(chance.random() < 0.5),
        tint=(shade * (1 + warmth), shade, shade * (1 - warmth)),
    )


def random_before(chance: _Chance) -> tuple[Before, ...]:
    """Things before the figure, drawn by lot: most often none, and then near the picture's borders."""
    if chance.random() > 0.2:
        return ()
    things = []
    for _ in range(1 + int(chance.random() < 0.3)):
        kind, side = chance.random(), float(chance.choice([-1, 1]))
        skin = _mixed((0.55, 0.36, 0.27), (0.10, 0.06, 0.04), chance.random())
        any_color = _color(chance)
        if kind < 0.35:  # somebody beside
            x = 0.5 + side * chance.uniform(0.38, 0.52)
            wide = chance.uniform(0.06, 0.12)
            things.append(Before((x, chance.uniform(0.25, 0.4)), (x, 1.2), wide, any_color, _soft(chance)))
            arm = x - side * wide * 0.9
            things.append(Before((arm, 0.38), (arm, 0.65), wide * 0.3, skin, _soft(chance)))
        elif kind < 0.6:  # an arm that reaches in
            y = chance.uniform(0.3, 0.9)
            end = 0.5 + side * chance.uniform(0.12, 0.35)
            radius = float(chance.uniform(0.012, 0.03))
            start = (0.5 + side * 0.6, y + chance.uniform(-0.2, 0.2))
            things.append(Before(start, (end, y), radius, skin, _soft(chance)))
        elif kind < 0.85:  # an edge of furniture
            y = chance.uniform(0.82, 1.0)
            slant, radius = chance.uniform(-0.08, 0.08), float(chance.uniform(0.05, 0.14))
            things.append(Before((-0.2, y + 0.1), (1.2, y + 0.1 + slant), radius, any_color, _soft(chance)))
        else:  # a bag
            x, y = 0.5 + side * chance.uniform(0.12, 0.2), chance.uniform(0.5, 0.62)
            wide = float(chance.uniform(0.02, 0.05))
            things.append(Before((x - wide, y), (x + wide, y), wide * 1.3, any_color, 0.006))
            things.append(Before((x, y - wide), (0.5 + 0.03 * side, 0.22), 0.005, any_color, 0.005))
    return tuple(
        Before(
            (float(b.start[0]), float(b.start[1])),
            (float(b.end[0]), float(b.end[1])),
            float(b.radius),
            b.color,
            b.soft,
        )
        for b in things
    )


@cache
def backdrop(number: int) -> Array:
    """(SIDE, SIDE, 3) float32 linear light of one of the bank, the same in every process."""
    chance = np.random.default_rng([91, number])
    maker = _MAKERS[number % len(_MAKERS)]
    picture = np.clip(maker(chance), 0.0, 1.0).astype(np.float32)
    picture = picture**2.2  # makers think in what the eye sees
    if maker is not _studio:
        picture *= np.asarray(_light(chance), np.float32)
        blur = float(chance.choice([0.0, chance.uniform(0.4, 1.5), chance.uniform(1.5, 6.0)]))
        if blur:
            picture = gaussian_filter(picture, (blur, blur, 0), mode="nearest")
    return np.ascontiguousarray(picture, np.float32)


def _between(picture: Array, at: Array, axis: int) -> Array:
    """Rows or columns of a picture at places between them."""
    first = np.minimum(at.astype(np.int64), picture.shape[axis] - 2)
    share = (at - first).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
    low, high = np.take(picture, first, axis), np.take(picture, first + 1, axis)
    high -= low
    high *= share
    high += low
    return high


def _light(chance: _Chance) -> Array:
    """(SIDE, SIDE, 1) uneven light, from one side or a lamp."""
    y, x = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    slope = chance.uniform(-0.5, 0.5, 2)
    glow = np.exp(-((x - chance.random()) ** 2 + (y - chance.random() * 0.6) ** 2) / 0.15)
    lit = 1 + slope[0] * (x - 0.5) + slope[1] * (y - 0.5) + chance.uniform(-0.2, 0.5) * glow
    return np.clip(lit, 0.3, 1.7)[:, :, None]


def _soft(chance: _Chance) -> float:
    return float(chance.choice([0.005, 0.02, 0.06]))


def _color(chance: _Chance, low: float = 0.05, high: float = 0.8, vivid: float = 0.25) -> Rgb:
    """Grey from low to high, coloured as paint is: warm or cool far more often than green or purple."""
    grey, warm, green = (
        chance.uniform(low, high),
        vivid * chance.normal(0.35, 1),
        0.3 * vivid * chance.normal(),
    )
    return _triple(np.clip(grey * (1 + np.array([warm, 0.15 * warm + green, -warm])), 0.0, 1.0))


def _mixed(a: Rgb, b: Rgb, share: float) -> Rgb:
    return _triple(np.asarray(a) + share * (np.asarray(b) - np.asarray(a)))


def _triple(values: Array) -> Rgb:
    r, g, b = (float(v) for v in values)
    return r, g, b


def _blank(color: Rgb) -> Array:
    return np.broadcast_to(np.asarray(color), (SIDE, SIDE, 3)).copy()


def _grain(chance: _Chance, picture: Array, strength: float, slope: float = 1.2) -> Array:
    return picture * (1 + strength * smooth_noise(chance, SIDE, slope))[:, :, None]


def _box(picture: Array, x0: float, y0: float, x1: float, y1: float, color: Rgb) -> None:
    """Fills from the upper left to the lower right, shares of the picture."""
    a, b, c, d = (round(min(max(v, 0.0), 1.0) * SIDE) for v in (y0, y1, x0, x1))
    picture[a:b, c:d] = color


def _floor(chance: _Chance, picture: Array, horizon: float) -> None:
    """A floor from below the wall to the picture's lower border: boards, tiles, carpet or plain."""
    rows = np.arange(round(horizon * SIDE), SIDE)
    if not len(rows):
        return
    eye = horizon - chance.uniform(0.25, 0.6)  # where lines of the floor meet
    depth = 1.0 / np.maximum(rows / SIDE - eye, 0.05)
    x = np.arange(SIDE) / SIDE - chance.uniform(0.2, 0.8)
    across, away = x[None] * depth[:, None], np.repeat(depth[:, None], SIDE, axis=1)
    color = np.asarray(_color(chance, 0.2, 0.85, 0.1) if chance.random() < 0.5 else _wood(chance))
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


def _wood(chance: _Chance) -> Rgb:
    return _mixed((0.75, 0.58, 0.40), (0.30, 0.19, 0.12), chance.random())


def _walled(chance: _Chance) -> tuple[Array, float]:
    """A wall with a floor and, mostly, skirting; and where they meet."""
    pale = chance.random() < 0.65
    wall = _color(chance, 0.7, 0.97, 0.04) if pale else _color(chance, 0.2, 0.8, 0.15)
    picture = _grain(chance, _blank(wall), float(chance.choice([0.0, 0.01, 0.03])))
    horizon = float(chance.uniform(0.72, 0.97))
    _floor(chance, picture, horizon)
    if chance.random() < 0.7:
        tall, color = chance.uniform(0.012, 0.04), _color(chance, 0.75, 0.98, 0.02)
        _box(picture, 0, horizon - tall, 1, horizon, color)
        _box(picture, 0, horizon - 0.006, 1, horizon + 0.004, _triple(np.asarray(color) * 0.6))
    return picture, horizon


def _studio(chance: _Chance) -> Array:
    """Paper, even or going over into another shade."""
    top = _color(chance, 0.55, 1.0, 0.05) if chance.random() < 0.7 else _color(chance, 0.1, 0.8, 0.3)
    bottom = _triple(np.clip(np.asarray(top) * chance.uniform(0.75, 1.1), 0, 1))
    down = np.linspace(0, 1, SIDE)[:, None, None]
    return np.broadcast_to((1 - down) * np.asarray(top) + down * np.asarray(bottom), (SIDE, SIDE, 3)).copy()


def _room(chance: _Chance) -> Array:
    """Wall and floor with some pictures, a door, a mirror, a plant, a lamp."""
    picture, horizon = _walled(chance)
    for _ in range(int(chance.integers(0, 4))):
        kind, x = chance.random(), chance.uniform(-0.05, 0.95)
        if kind < 0.3:
            wide, y = chance.uniform(0.08, 0.25), chance.uniform(0.05, 0.4)
            tall = wide * chance.uniform(0.7, 1.5)
            _box(picture, x - 0.012, y - 0.012, x + wide + 0.012, y + tall + 0.012, _color(chance))
            _box(picture, x, y, x + wide, y + tall, _color(chance, 0.3, 0.95, 0.3))
            for _ in range(3):
                u, v = x + wide * chance.uniform(0.1, 0.6), y + tall * chance.uniform(0.1, 0.6)
                _box(picture, u, v, u + wide * 0.3, v + tall * 0.3, _color(chance, vivid=0.5))
        elif kind < 0.55:
            _door(chance, picture, x, horizon)
        elif kind < 0.75:
            _plant(chance, picture, x, horizon)
        else:
            wide, tall = chance.uniform(0.15, 0.4), chance.uniform(0.12, 0.35)
            color = _color(chance, 0.15, 0.8, 0.25)
            _box(picture, x, horizon - tall, x + wide, horizon + 0.05, color)
            _box(picture, x, horizon - tall, x + wide, horizon - tall * 0.9, _triple(np.asarray(color) * 1.2))
            for k in range(1, int(chance.integers(1, 4))):
                y = horizon - tall * k / 4
                _box(picture, x, y, x + wide, y + 0.007, _triple(np.asarray(color) * 0.6))
    return picture


def _door(chance: _Chance, picture: Array, x: float, horizon: float) -> None:
    wide, top = chance.uniform(0.2, 0.34), chance.uniform(0.0, 0.12)
    frame = _color(chance, 0.6, 0.98, 0.04)
    leaf = frame if chance.random() < 0.5 else _wood(chance)
    _box(picture, x, top, x + wide, horizon, _triple(np.asarray(frame) * 0.85))
    _box(picture, x + 0.02, top + 0.02, x + wide - 0.02, horizon, leaf)
    for y0, y1 in ((0.1, 0.42), (0.5, 0.92)):
        a, b = top + y0 * (horizon - top), top + y1 * (horizon - top)
        _box(picture, x + 0.05, a, x + wide - 0.05, b, _triple(np.asarray(leaf) * 0.8))
        _box(picture, x + 0.056, a + 0.006, x + wide - 0.05, b, _triple(np.asarray(leaf) * 0.97))


def _plant(chance: _Chance, picture: Array, x: float, horizon: float) -> None:
    wide, tall = chance.uniform(0.06, 0.1), chance.uniform(0.08, 0.14)
    _box(picture, x, horizon - tall, x + wide, horizon + 0.03, _color(chance, 0.2, 0.9, 0.2))
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    for _ in range(24):
        turn, length = chance.uniform(-1.3, 1.3), chance.uniform(0.08, 0.3)
        dx, dy = xx - x - wide / 2, horizon - tall - yy
        along, across = dx * np.sin(turn) + dy * np.cos(turn), dx * np.cos(turn) - dy * np.sin(turn)
        blade = (along > 0) & (along < length) & (np.abs(across) < 0.012 + 0.05 * length * (along / length))
        picture[blade] = (
            np.array([0.15, 0.35, 0.15]) * chance.uniform(0.5, 1.7) * chance.uniform(0.85, 1.15, 3)
        )


def _bricks(chance: _Chance) -> Array:
    """Bricks or large tiles on a wall."""
    joint, base = _color(chance, 0.45, 0.9, 0.03), np.asarray(_brick_color(chance))
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


def _brick_color(chance: _Chance) -> Rgb:
    if chance.random() < 0.4:
        return _color(chance, 0.7, 0.95, 0.03)
    return _mixed((0.65, 0.36, 0.27), (0.45, 0.40, 0.36), chance.random())


def _curtain(chance: _Chance) -> Array:
    """A curtain in folds, wholly or beside a bright window."""
    x = np.linspace(0, 1, SIDE)
    wave = sum(
        chance.uniform(0.3, 1) * np.sin(2 * np.pi * chance.uniform(4, 22) * x + chance.uniform(0, 7))
        for _ in range(4)
    )
    picture = _blank(_color(chance, 0.3, 0.95, 0.15)) * (1 + 0.10 * wave)[None, :, None]
    if chance.random() < 0.5:
        left, right = sorted(chance.uniform(0.1, 0.9, 2))
        bright = _color(chance, 0.85, 1.0, 0.02)
        _box(picture, left, 0.0, right, chance.uniform(0.5, 0.9), bright)
        _box(
            picture,
            (left + right) / 2 - 0.01,
            0.0,
            (left + right) / 2 + 0.01,
            0.6,
            _color(chance, 0.5, 0.9, 0.02),
        )
    _floor(chance, picture, float(chance.uniform(0.85, 1.0)))
    return picture


def _shelves(chance: _Chance) -> Array:
    """Books, boxes and clothes on shelves or rails."""
    picture, horizon = _walled(chance)
    back = _color(chance, 0.2, 0.8, 0.1)
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
                _box(picture, x, low - tall, min(x + wide, right), low, _color(chance, vivid=vivid))
            x += wide + chance.uniform(0, 0.012)
        _box(picture, left, low - 0.012, right, low + 0.008, board)
    return picture


def _window(chance: _Chance) -> Array:
    """A window with the day outside."""
    picture, horizon = _walled(chance)
    x, wide = chance.uniform(0.0, 0.5), chance.uniform(0.3, 0.6)
    y, low = chance.uniform(0.0, 0.1), chance.uniform(0.45, max(0.5, horizon - 0.03))
    frame = _color(chance, 0.75, 1.0, 0.02)
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


def _stairs(chance: _Chance) -> Array:
    """Steps that rise to the back, or aside."""
    wall = _color(chance, 0.35, 0.9, 0.08)
    picture = _grain(chance, _blank(wall), 0.03)
    count, top = int(chance.integers(4, 11)), chance.uniform(0.1, 0.5)
    color, slant = np.asarray(_color(chance, 0.4, 0.85, 0.06)), chance.uniform(-0.12, 0.12)
    for k in range(count):
        y = top + (1 - top) * (k / count) ** 1.3
        x = slant * k
        _box(picture, x, y, 1 + x if slant < 0 else 1, 1, _triple(color * (1.05 - 0.02 * (count - k))))
        _box(picture, x, y, 1, y + 0.4 * (1 - top) / count, _triple(np.clip(color * 1.15, 0, 1)))
    return picture


def _sky(chance: _Chance) -> Array:
    blue = _mixed((0.55, 0.72, 0.92), (0.85, 0.88, 0.92), chance.random())
    down = np.linspace(0, 1, SIDE)[:, None, None]
    picture = (1 - down) * np.asarray(blue) + down * np.clip(np.asarray(blue) * 1.15 + 0.08, 0, 1)
    cloud = np.clip(smooth_noise(chance, SIDE, 1.8, 0.5) - chance.uniform(0, 1.5), 0, 1)[:, :, None]
    return picture + 0.5 * cloud * (1 - picture)


def _street(chance: _Chance) -> Array:
    """Houses on both sides, a road between, that run together."""
    picture = _sky(chance)
    vx, vy = chance.uniform(0.25, 0.75), chance.uniform(0.3, 0.55)
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    dx, dy = xx - vx, yy - vy
    ground = _color(chance, 0.3, 0.65, 0.05)
    open_ = chance.uniform(0.5, 2.0)
    road = (dy > 0) & (np.abs(dx) < dy * (open_ + 1.2))
    picture[dy > 0] = np.asarray(_color(chance, 0.5, 0.8, 0.05))
    picture[road] = np.asarray(ground)
    for side in (-1, 1):
        base, tall = np.asarray(_color(chance, 0.35, 0.85, 0.12)), chance.uniform(0.6, 1.6)
        out = side * dx
        wall = (out > 0.03) & (dy < out * chance.uniform(0.5, 1.0)) & (-dy < out * tall * 1.2)
        depth = 1.0 / np.maximum(out, 0.03)
        shade = 0.9 + 0.15 * np.sin(np.floor(depth * 1.2) * 91.7)
        picture[wall] = (base * shade[:, :, None])[wall]
        height = dy * depth
        window = wall & (depth * 3 % 1 > 0.35) & (height * 4.5 % 1 > 0.45) & (height < 0.15)
        picture[window] = np.asarray(_color(chance, 0.1, 0.5, 0.1))
    return _grain(chance, picture, 0.05)


def _park(chance: _Chance) -> Array:
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
    leaf = np.asarray(_mixed((0.20, 0.33, 0.13), (0.42, 0.48, 0.22), chance.random()))
    if chance.random() < 0.15:
        leaf = np.array([0.62, 0.38, 0.16])  # autumn
    for _ in range(int(chance.integers(3, 14))):
        x, y, size = (
            chance.uniform(-0.1, 1.1),
            horizon - chance.uniform(0.05, 0.35),
            chance.uniform(0.08, 0.3),
        )
        trunk = np.array([0.25, 0.19, 0.14]) * chance.uniform(0.7, 1.4)
        _box(picture, x - 0.04 * size, y, x + 0.04 * size, horizon + 0.03, _triple(trunk))
        bumpy = smooth_noise(chance, SIDE, 1.3)
        crown = (xx - x) ** 2 + ((yy - y) * 0.85) ** 2 < (size * (1 + 0.2 * bumpy)) ** 2
        shade = chance.uniform(0.6, 1.3) * (1 + 0.22 * bumpy)
        picture[crown] = (leaf * np.clip(shade, 0.3, 2)[:, :, None])[crown]
    grass = (
        leaf * chance.uniform(1.0, 1.6)
        if chance.random() < 0.7
        else np.asarray(_color(chance, 0.4, 0.75, 0.08))
    )
    picture[rows] = grass * (1 + 0.16 * smooth_noise(chance, SIDE, 0.7, 0.5))[rows, :, None]
    if chance.random() < 0.4:
        path = (yy > horizon) & (np.abs(xx - 0.5) < (yy - horizon) * chance.uniform(0.5, 1.4) + 0.03)
        picture[path] = np.asarray(_color(chance, 0.55, 0.8, 0.05))
    return picture


def _bokeh(chance: _Chance) -> Array:
    """Lights and colours far out of focus."""
    picture = _blank(_color(chance, 0.05, 0.5, 0.3))
    yy, xx = np.mgrid[0 : 1 : SIDE * 1j, 0 : 1 : SIDE * 1j]
    hue = np.asarray(_color(chance, 0.5, 0.9, 0.3))
    for _ in range(int(chance.integers(10, 40))):
        x, y, size = *chance.uniform(0, 1, 2), chance.uniform(0.015, 0.09)
        disc = (xx - x) ** 2 + (yy - y) ** 2 < size**2
        light = np.clip(hue * chance.uniform(0.7, 1.5) * chance.uniform(0.7, 1.3, 3), 0, 1)
        picture[disc] += chance.uniform(0.1, 0.6) * (light - picture[disc])
    return picture


def _texture(chance: _Chance) -> Array:
    """Concrete, plaster, a hedge, rock: noise of two colours."""
    a, b = _color(chance, 0.2, 0.9, 0.1), _color(chance, 0.2, 0.9, 0.1)
    stretch = float(chance.choice([1.0, 0.3, 3.0]))
    share = np.clip(0.5 + 0.3 * smooth_noise(chance, SIDE, chance.uniform(0.8, 1.8), stretch), 0, 1)
    picture = np.asarray(a) + share[:, :, None] * (np.asarray(b) - np.asarray(a))
    _floor(chance, picture, float(chance.uniform(0.75, 1.1)))
    return picture


def _people(chance: _Chance) -> Array:
    """A crowd some way off."""
    picture = _street(chance) if chance.random() < 0.5 else _room(chance)
    cover = np.ones((SIDE, SIDE), np.float32)
    light = picture.astype(np.float32)
    for _ in range(int(chance.integers(1, 6))):
        x, tall, low = chance.uniform(0, 1), chance.uniform(0.3, 0.6), chance.uniform(0.8, 1.0)
        skin = _mixed((0.8, 0.62, 0.52), (0.35, 0.24, 0.18), chance.random())
        top = low - tall
        for dx in (-0.04, 0.04):
            foot = x + dx * tall * 1.5
            Before((x + dx * tall, top + 0.5 * tall), (foot, low), 0.05 * tall, _color(chance), 0.01).put(
                light, cover
            )
        shirt = _color(chance, vivid=0.4)
        Before((x, top + 0.24 * tall), (x, top + 0.48 * tall), 0.1 * tall, shirt, 0.01).put(light, cover)
        Before((x, top + 0.06 * tall), (x, top + 0.07 * tall), 0.055 * tall, skin, 0.01).put(light, cover)
    return gaussian_filter(light, (chance.uniform(0.8, 3), chance.uniform(0.8, 3), 0))


_MAKERS: tuple[Callable[[_Chance], Array], ...] = (
    _room,
    _studio,
    _street,
    _bricks,
    _park,
    _room,
    _curtain,
    _shelves,
    _texture,
    _window,
    _studio,
    _room,
    _stairs,
    _bokeh,
    _park,
    _people,
)
MAKER_NAMES = tuple(maker.__name__.strip("_") for maker in _MAKERS)
"""What the backdrops of the bank show, by their number modulo as many."""
