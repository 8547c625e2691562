"""Pictures to learn to read from, drawn by the block; each block is fixed by its number."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from swifttailor.body import Body
from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.closer import close_up_by_lot, coarsened, has_any
from swifttailor.data.pictures.laid import draw_laid
from swifttailor.data.pictures.odd_scenes import draw_group, draw_nothing, unread
from swifttailor.data.pictures.panel_cells import panel_cells
from swifttailor.data.pictures.photographs import Photographs
from swifttailor.data.pictures.scenes import VIEWS, Chance, Scene, View, Wardrobe, draw_scene
from swifttailor.data.pictures.worn_places import worn_places
from swifttailor.looks.draw import draw_seen, look_camera
from swifttailor.looks.look import View as LookView
from swifttailor.looks.look import random_look
from swifttailor.looks.plain_look import plain_camera, plain_look
from swifttailor.picture_reader.close_ups import ALL_PARTS, WHOLE
from swifttailor.picture_reader.labels import MASK_STRIDE, PARTS
from swifttailor.picture_reader.view import view_of
from swifttailor.render import Plain

Family = Literal[
    "plain",
    "seamless",
    "studio",
    "people",
    "held out",
    "laid",
    "photograph",
    "nothing",
    "several",
    "unlike",
    "worn",
]
"""How a picture looks: like those of GarmentCodeData; the same in one colour and without seams, of which
nothing is learnt; a garment in a studio; people; people in looks that training never draws; a garment that
nobody wears; a photograph of clothes; no garment at all; several people; any of seamless, studio and people
of which a reader of plain pictures is to learn that it is not for it; and people, or a garment on a body as
GarmentCodeData shows it, of which a reader of laid garments is to learn the same."""
_UNLIKE: tuple[Family, ...] = "seamless", "studio", "people"
_WORN: tuple[Family, ...] = "people", "people", "people", "people", "plain", "seamless"
_ON_PHOTOGRAPHS, _PEOPLE_ON_PHOTOGRAPHS = 0.3, 0.6
"""Shares of laid garments and of people that are drawn before a part of a photograph, where there are any:
that something in a picture is no drawing does not tell that nobody wears a garment."""
_VIEW_SHARES = 0.4, 0.3, 0.3
_ONE_TONE = 3
"""Of the colours of plain panels the one that seamless pictures have: not white on white."""
_STRIDE, _TRIES = 7, 40
"""How far away in the order, and how often, another garment is taken that has the parts to look at."""
_NEAR_MARGIN, _NEAR_SHIFT = (0.08, 0.45), 0.06
"""Of plain pictures that the garment fills: the space around it, and by how much it is off the middle, in
heights of the picture."""


@dataclass(frozen=True, eq=False)
class Block:
    """Some pictures of some garments."""

    pixels: NDArray[np.uint8]
    """(n, size, size, 3)."""
    figures: NDArray[np.int64]
    """(n,) number of `FIGURES`."""
    masks: NDArray[np.uint8]
    """(n, size / 4, size / 4, 2), see `scenes.Scene`."""
    places: NDArray[np.float16]
    """(n, size / 4, size / 4, 3), see `worn_places`."""
    cells: NDArray[np.uint8]
    """(n, size / 4, size / 4), see `panel_cells`."""
    views: NDArray[np.float32]
    """(n, 6)."""
    garments: NDArray[np.int64]
    """(n, 2) number of the garment of each part in the bank, of one of `Photographs.kinds` behind its last
    one; -1 for none, and of groups; `UNTOLD` where that is not known."""
    close_up: NDArray[np.int64]
    """(n,) number of `CLOSE_UPS`, or `WHOLE`."""
    placed: NDArray[np.bool_]
    """(n,) whether it is known where in the picture the garment is."""


class Blocks:
    """The blocks of a training."""

    def __init__(
        self,
        bank: PictureBank,
        *,
        seed: int,
        size: int,
        count: int,
        shares: Mapping[Family, float],
        close: float = 0.0,
        near: float = 0.65,
        parts: Sequence[str] = ALL_PARTS,
        photographs: Photographs | None = None,
        cut_out: float = 0.0,
    ) -> None:
        """Prepares to draw.

        Args:
            bank: Garments.
            seed: Of everything.
            size: Pixels along each side of a picture.
            count: Pictures in a block.
            shares: Of families; the others show people.
            close: Share of close-ups.
            near: Share of other plain pictures that the garment fills, as the second look at one does.
            parts: Of close-ups, see `CloseUp.part`. Where these are not all, garments without them are passed
                over.
            photographs: What the share of photographs is taken from.
            cut_out: Share of people, drawn ones and photographs on white, that are shown as if cut out.
        """
        self.photographs, self.cut_out = photographs, cut_out
        self.wardrobe, self.seed, self.size, self.count = Wardrobe(bank), seed, size, count
        self.shares, self.close, self.near = dict(shares), close, near
        self.parts = tuple(parts)

    def __getitem__(self, number: int) -> Block:
        chance = np.random.default_rng([self.seed, number])
        made = [self._one(number * self.count + k, chance) for k in range(self.count)]
        return Block(**{name: np.stack([getattr(scene, name) for scene in made]) for name in _COLUMNS})

    def _one(self, place: int, chance: Chance) -> Scene:
        epoch, k = divmod(place, len(self.wardrobe.bank))
        order = _order(self.seed, epoch, len(self.wardrobe.bank))
        family, view = self._family(chance), VIEWS[int(chance.choice(3, p=_VIEW_SHARES))]
        if family == "laid":
            view = "free"
        garment = int(order[k])
        if self.photographs is not None and family in ("photograph", "laid", "worn"):
            scene = self._photographed(self.photographs, garment, family, view, chance)
            if scene is not None:
                return scene
        close = chance.random() < self.close
        if close and set(self.parts) < set(ALL_PARTS):
            others = (int(order[(k + n * _STRIDE) % len(order)]) for n in range(_TRIES))
            garment = next((g for g in others if has_any(self.wardrobe.bank[g], self.parts)), garment)
        near = family == "plain" and not close and chance.random() < self.near
        return draw(
            self.wardrobe,
            garment,
            family,
            view,
            chance,
            self.size,
            near=near,
            close=close,
            parts=self.parts,
            cut_out=self.cut_out,
        )

    def _photographed(
        self, photographs: Photographs, garment: int, family: Family, view: View, chance: Chance
    ) -> Scene | None:
        """A photograph, or a drawing before a part of one; None for a drawing with nothing of any."""
        if family == "photograph":
            return photographs.shown(chance, self.size, len(self.wardrobe.bank), self.cut_out)
        if chance.random() > (_ON_PHOTOGRAPHS if family == "laid" else _PEOPLE_ON_PHOTOGRAPHS):
            return None
        ground = photographs.ground(chance, self.size)
        if family == "laid":
            return draw_laid(self.wardrobe, garment, view, chance, self.size, ground=ground)
        return unread(
            draw_scene(self.wardrobe, garment, view, chance, self.size, behind=ground).pixels, "none"
        )

    def _family(self, chance: Chance) -> Family:
        lot = chance.random()
        for family, share in self.shares.items():
            if lot < share:
                return family
            lot -= share
        return "people"


def draw(
    wardrobe: Wardrobe,
    number: int,
    family: Family,
    view: View,
    chance: Chance,
    size: int,
    *,
    near: bool = False,
    close: bool = False,
    parts: Sequence[str] = ALL_PARTS,
    cut_out: float = 0.0,
) -> Scene:
    """A picture of a garment.

    Args:
        wardrobe: What there is.
        number: Of the garment.
        family: How it looks.
        view: From where; plain and seamless ones show fronts and backs alone, and ``free`` means either.
        chance: Decides everything else.
        size: Pixels along each side.
        near: Whether a garment that is shown plainly fills the picture.
        close: Whether one of `CLOSE_UPS` fills it, where there is a garment that has any.
        parts: Of close-ups, see `CloseUp.part`.
        cut_out: How likely people, but those held out, are shown as if cut out.
    """
    if family == "nothing":
        return draw_nothing(chance, size)
    if family == "several":
        return draw_group(wardrobe, number, chance, size)
    if family == "laid":
        return draw_laid(wardrobe, number, view, chance, size)
    if family in ("unlike", "worn"):
        others = _UNLIKE if family == "unlike" else _WORN
        other = others[int(chance.integers(len(others)))]
        return unread(draw(wardrobe, number, other, view, chance, size).pixels, "none")
    if family in ("people", "held out"):
        held_out = family == "held out"
        cut_out = 0.0 if held_out else cut_out
        return draw_scene(
            wardrobe, number, view, chance, size, held_out=held_out, close=close, parts=parts, cut_out=cut_out
        )
    worn = wardrobe.bank[number]
    if family in ("plain", "seamless"):
        side = view if view != "free" else VIEWS[int(chance.integers(2))]
        look = plain_look(side)
        if family == "seamless":
            look = replace(look, print=Plain(look.panel_colors[_ONE_TONE], 0.0), panel_colors=(), seams=0.0)
        if near:
            look = replace(look, view=_nearer(chance, side))
    else:
        look = random_look(chance, view)
    close_up = WHOLE
    if close:
        camera = look_camera(worn.vertices, _body(), look)
        camera, close_up = close_up_by_lot(worn, worn.vertices, camera, chance, parts)
        look = replace(look, view=LookView(camera=camera))
    drawn = draw_seen(worn, _body(), look, size)
    pixels = drawn.pixels if close_up == WHOLE else coarsened(drawn.pixels, chance)
    cells = size // MASK_STRIDE
    share = drawn.shares[:, :, -1].reshape(cells, MASK_STRIDE, cells, MASK_STRIDE).mean(axis=(1, 3))
    masks = np.zeros((cells, cells, len(PARTS)), np.uint8)
    masks[:, :, worn.truth.part] = np.round(255 * share)
    garments = np.full(len(PARTS), -1)
    garments[worn.truth.part] = number
    places = worn_places(drawn.face, [(s.vertices, s.faces) for s in drawn.surfaces])
    bare = sum(len(s.faces) for s in drawn.surfaces[:-1])
    panels = panel_cells(drawn.face, bare, [worn])
    view_seen = view_of(drawn.camera, size)
    return Scene(pixels, masks, places, panels, view_seen, garments, close_up=close_up)


def _nearer(chance: Chance, side: str) -> LookView:
    """From where a plain picture is seen, but of the garment alone."""
    camera = plain_camera(side)
    right, up = (float(v) for v in chance.normal(0, _NEAR_SHIFT, 2))
    margin = float(chance.uniform(*_NEAR_MARGIN))
    # A smaller picture of the same camera opens as much less.
    opened = camera.field_of_view * float(chance.uniform(0.3, 0.8))
    return LookView(camera.azimuth, camera.elevation, opened, False, margin, (right, up))


_COLUMNS = ("pixels", "masks", "places", "cells", "views", "garments", "figures", "close_up", "placed")


@lru_cache(maxsize=2)
def _order(seed: int, epoch: int, count: int) -> NDArray[np.int64]:
    return np.random.default_rng([seed, 4, epoch]).permutation(count)


@cache
def _body() -> Body:
    return Body.default()
