"""Pictures to learn to read from, drawn by the block in processes of their own; each block is fixed by its number."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.body import Body
from swifttailor.data.renders.draw import _camera, draw_look
from swifttailor.data.renders.look import VIEWS, random_look
from swifttailor.data.renders.plain_look import plain_look
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS
from swifttailor.picture_reader.view import view_of
from swifttailor.training.picture_bank import PictureBank, WornGarment


@dataclass(frozen=True, eq=False)
class Block:
    """Some pictures of some garments."""

    pictures: NDArray[np.uint8]
    """(n, size, size, 3)."""
    masks: NDArray[np.uint8]
    """(n, size / 4, size / 4, 2) share of each cell where a garment of that part is seen, of 255."""
    views: NDArray[np.float32]
    """(n, 6)."""
    garments: NDArray[np.int64]
    """(n, 2) number of the garment of each part in the bank; -1 for none."""


class Blocks:
    """The blocks of a training."""

    def __init__(self, bank: PictureBank, *, seed: int, size: int, count: int, plain: float = 0.15) -> None:
        self.bank, self.seed, self.size, self.count, self.plain = bank, seed, size, count, plain
        self._parts: Any = None

    def __len__(self) -> int:
        return 1 << 40

    def __getitem__(self, number: int) -> Block:
        chance = np.random.default_rng([self.seed, number])
        made = [self._one(int(self._garment(number * self.count + k)), chance) for k in range(self.count)]
        pictures, masks, views, garments = (np.stack(column) for column in zip(*made, strict=True))
        return Block(pictures, masks, views, garments)

    def _garment(self, place: int) -> int:
        """Every garment once, then again in another order."""
        epoch, k = divmod(place, len(self.bank))
        return _order(self.seed, epoch, len(self.bank))[k]

    def _one(self, number: int, chance: np.random.Generator) -> tuple[Any, ...]:
        worn = self.bank[number]
        view = VIEWS[int(chance.choice(3, p=(0.4, 0.3, 0.3)))]
        drawn = draw(worn, view, chance, self.size, plain=chance.random() < self.plain and view != "free")
        garments = np.full(len(PARTS), -1)
        garments[worn.truth.part] = number
        return (*drawn, garments)


@cache
def _order(seed: int, epoch: int, count: int) -> NDArray[np.int64]:
    return np.random.default_rng([seed, 4, epoch]).permutation(count)


def draw(
    worn: WornGarment, view: str, chance: np.random.Generator, size: int, *, plain: bool = False
) -> tuple[NDArray[np.uint8], NDArray[np.uint8], NDArray[np.float32]]:
    """A picture of a garment, its mask and view: see `Block`."""
    look = plain_look(view) if plain else random_look(chance, view)
    garment: Any = as_garment(worn)
    body = _body()
    picture = draw_look(garment, body, look, size)
    camera = _camera(garment.vertices, body, look)
    return picture, _mask(worn, body if look.body is not None else None, camera, size), view_of(camera, size)


def as_garment(worn: WornGarment) -> Any:
    mesh = SimpleNamespace(
        face_panel=worn.face_panel,
        flat_vertices=worn.cloth_at.reshape(-1, 2),
        flat_faces=np.arange(3 * len(worn.faces)).reshape(-1, 3),
    )
    seams = [SimpleNamespace(vertices=edge) for edge in worn.seams]
    return SimpleNamespace(vertices=worn.vertices, faces=worn.faces, mesh=mesh, seams=seams)


def _mask(worn: WornGarment, body: Body | None, camera: Any, size: int) -> NDArray[np.uint8]:
    from swifttailor.render.rasterize import rasterize
    from swifttailor.render.scene import Projection, Scene
    from swifttailor.render.surface import Surface

    cells, grey = size // MASK_STRIDE, np.full(3, 0.5)
    surfaces = [Surface(worn.vertices, worn.faces, grey, grey, lift=0.35)]
    if body is not None:
        surfaces.append(Surface(body.vertices, body.faces, grey))
    projection = Projection(Scene(surfaces), camera, (2 * cells, 2 * cells))
    face = rasterize(projection.corners, projection.size)
    seen = (face >= 0) & (projection.surface[face] == 0)
    share = seen.reshape(cells, 2, cells, 2).mean(axis=(1, 3))
    mask = np.zeros((cells, cells, len(PARTS)), np.uint8)
    mask[:, :, worn.truth.part] = np.round(255 * share)
    return mask


@cache
def _body() -> Body:
    return Body.default()
