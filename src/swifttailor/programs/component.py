"""What garments are put together from: things with interfaces and stitches that can be placed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Self

from swifttailor.programs.design_error import DesignError
from swifttailor.programs.interface import Interface
from swifttailor.programs.rotation import Rotation
from swifttailor.programs.stitching import Stitches

if TYPE_CHECKING:
    from swifttailor.pattern import Stitch
    from swifttailor.programs.panel import Panel

Box = tuple[list[float], list[float]]
"""Least and largest x, y and z."""


class BaseComponent:
    """A panel or a group of them."""

    def __init__(self, name: str) -> None:
        """Names it; its interfaces and stitching rules are filled by whoever drafts it."""
        self.name = name
        self.interfaces: dict[str, Interface] = {}
        self.stitching_rules = Stitches()

    def panels(self) -> Iterator[Panel]:
        """All panels in it, each once."""
        raise NotImplementedError

    def pivot_3d(self) -> list[float]:
        """The point that `translate_to` brings to a place."""
        raise NotImplementedError

    def bbox_3d(self) -> Box:
        """Least and largest x, y and z of it, cm."""
        raise NotImplementedError

    def length(self) -> float:
        """Its vertical length, cm."""
        raise NotImplementedError

    def set_panel_label(self, label: str, overwrite: bool = True) -> None:
        """Says to which part of the body its panels belong."""
        raise NotImplementedError

    def translate_by(self, delta: Sequence[float]) -> Self:
        """Moves it."""
        raise NotImplementedError

    def translate_to(self, place: Sequence[float]) -> Self:
        """Moves it until its pivot is at a place."""
        raise NotImplementedError

    def rotate_by(self, rotation: Rotation) -> Self:
        """Turns it about its pivot."""
        raise NotImplementedError

    def mirror(self) -> Self:
        """Mirrors it across the plane x = 0."""
        raise NotImplementedError

    def all_stitches(self) -> list[Stitch]:
        """Its stitches and those of its parts."""
        raise NotImplementedError

    def place_below(self, other: BaseComponent, gap: float = 2.0) -> Self:
        """Moves it until its top is a gap in cm below the lowest point of another."""
        return self.translate_by([0.0, other.bbox_3d()[0][1] - self.bbox_3d()[1][1] - gap, 0.0])

    def place_by_interface(
        self,
        self_interface: Interface,
        out_interface: Interface,
        gap: float = 2.0,
        alignment: str = "center",
        gap_dir: Sequence[float] | None = None,
    ) -> Self:
        """Moves it until its interface is a gap in cm away from the interface of another.

        Args:
            self_interface: One of its interfaces.
            out_interface: The interface to meet.
            gap: Distance, cm.
            alignment: What of the two boxes is brought together: ``center``, ``top`` and ``bottom`` in y,
                ``right`` and ``left`` in x (the right hand of the wearer is at the least x).
            gap_dir: Direction of the gap; from its centre to its interface by default.
        """
        mine, theirs = self_interface.bbox_3d(), out_interface.bbox_3d()
        point_self, point_out = _middle(mine), _middle(theirs)
        if alignment != "center":
            axis, side = _ALIGNMENTS[alignment]
            point_self[axis], point_out[axis] = mine[side][axis], theirs[side][axis]
        if gap_dir is None:
            gap_dir = [a - b for a, b in zip(_middle(mine), _middle(self.bbox_3d()), strict=True)]
        size = math.sqrt(sum(g * g for g in gap_dir))
        return self.translate_by(
            [o - (s + gap * g / size) for o, s, g in zip(point_out, point_self, gap_dir, strict=True)]
        )


class Component(BaseComponent):
    """A group of panels and components: those in `subs` and those that are attributes of it."""

    def __init__(self, name: str) -> None:
        """Makes an empty group."""
        super().__init__(name)
        self.subs: list[BaseComponent] = []

    def subcomponents(self) -> list[BaseComponent]:
        """Its parts, each once."""
        parts = [p for _, p in sorted(vars(self).items()) if isinstance(p, BaseComponent)]
        return list({id(part): part for part in [*parts, *self.subs]}.values())

    def panels(self) -> Iterator[Panel]:
        """All panels in it, each once."""
        for part in self.subcomponents():
            yield from part.panels()

    def pivot_3d(self) -> list[float]:
        """The middle of the top of its box."""
        low, high = self.bbox_3d()
        return [(low[0] + high[0]) / 2, high[1], (low[2] + high[2]) / 2]

    def bbox_3d(self) -> Box:
        """Least and largest x, y and z of it, cm."""
        boxes = [part.bbox_3d() for part in self.subcomponents()]
        if not boxes:
            return [math.inf] * 3, [-math.inf] * 3
        low = [min(c) for c in zip(*(b[0] for b in boxes), strict=True)]
        return low, [max(c) for c in zip(*(b[1] for b in boxes), strict=True)]

    def length(self) -> float:
        """Sum of the lengths of its parts, cm."""
        return sum(part.length() for part in self.subcomponents())

    def set_panel_label(self, label: str, overwrite: bool = True) -> None:
        """Says to which part of the body its panels belong."""
        for part in self.subcomponents():
            part.set_panel_label(label, overwrite)

    def translate_by(self, delta: Sequence[float]) -> Self:
        """Moves all parts."""
        for part in self.subcomponents():
            part.translate_by(delta)
        return self

    def translate_to(self, place: Sequence[float]) -> Self:
        """Moves all parts until the pivot is at a place."""
        pivot = self.pivot_3d()
        for part in self.subcomponents():
            own = part.pivot_3d()
            part.translate_to([p + (o - c) for p, o, c in zip(place, own, pivot, strict=True)])
        return self

    def rotate_by(self, rotation: Rotation) -> Self:
        """Turns all parts about the pivot."""
        pivot = self.pivot_3d()
        for part in self.subcomponents():
            arm = [a - b for a, b in zip(part.pivot_3d(), pivot, strict=True)]
            part.rotate_by(rotation)
            part.translate_by([a - b for a, b in zip(rotation.apply(arm), arm, strict=True)])
        return self

    def mirror(self) -> Self:
        """Mirrors all parts across the plane x = 0."""
        for part in self.subcomponents():
            part.mirror()
        return self

    def all_stitches(self) -> list[Stitch]:
        """The stitches of its parts and its own."""
        inner = [stitch for part in self.subcomponents() for stitch in part.all_stitches()]
        return [*inner, *self.stitching_rules.assembly()]


def lin_interpolation(first: float, second: float, factor: float) -> float:
    """The value between two, `first` at factor 0 and `second` at factor 1."""
    if not 0 <= factor <= 1:
        raise DesignError(
            f"A measurement would be taken {factor:.4g} of the way from hips ({first:.4g} cm) to waist "
            f"({second:.4g} cm); between 0 and 1 is accepted. Change the rise or the width of the waistband."
        )
    return (1 - factor) * first + factor * second


_ALIGNMENTS = {"top": (1, 1), "bottom": (1, 0), "right": (0, 0), "left": (0, 1)}


def _middle(box: Box) -> list[float]:
    return [(a + b) / 2 for a, b in zip(*box, strict=True)]
