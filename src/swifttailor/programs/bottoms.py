"""What all lower garments share: how far up they reach (rise) and how they end."""

from __future__ import annotations

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.component import Component, lin_interpolation
from swifttailor.programs.design import Design


class BaseBottoms(Component):
    """A lower garment, sewn on at its interface ``top``."""

    def __init__(
        self, body: BodyParameters, design: Design, tag: str = "", rise: float | None = None
    ) -> None:
        """Names it; a rise of 1 reaches the waist, 0 the hips."""
        super().__init__(f"{self.__class__.__name__}_{tag}" if tag else self.__class__.__name__)
        self.body = body
        self.design = design
        self.rise = 1.0 if rise is None else rise

    def get_rise(self) -> float:
        """How far up it reaches."""
        return self.rise

    def eval_rise(self, rise: float) -> tuple[float, float, float]:
        """Girth at the top, depth from there to the hips, and back half of the girth, cm."""
        body = self.body
        girth = lin_interpolation(body["hips"], body["waist"], rise)
        back = lin_interpolation(body["hip_back_width"], body["waist_back_width"], rise)
        return girth, rise * body["hips_line"], back


class StackableSkirt(BaseBottoms):
    """A skirt with interfaces ``bottom``, ``bottom_f`` and ``bottom_b`` too: another one may hang on it."""

    low_angle: float = 0.0
    """How much its hem slopes, degrees."""
