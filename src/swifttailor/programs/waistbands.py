"""Waistbands: straight, or following the body as a yoke does."""

from __future__ import annotations

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.circle_skirt import CircleArcPanel
from swifttailor.programs.component import Component, lin_interpolation
from swifttailor.programs.design import Design
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.stitching import Stitches


class StraightBandPanel(Panel):
    """A rectangle."""

    def __init__(
        self, name: str, width: float, depth: float, match_int_proportion: float | None = None
    ) -> None:
        """Drafts it; `match_int_proportion`: what top and bottom are gathered or stretched to, cm."""
        super().__init__(name)
        self.edges = from_verts([0.0, 0.0], [0.0, depth], [width, depth], [width, 0.0], loop=True)
        ruffle = 1.0 if match_int_proportion is None else width / match_int_proportion
        self.interfaces = {
            "right": Interface(self, self.edges[0]),
            "top": Interface(self, self.edges[1], ruffle).reverse(True),
            "left": Interface(self, self.edges[2]),
            "bottom": Interface(self, self.edges[3], ruffle),
        }
        self.top_center_pivot()
        self.center_x()


class StraightWB(Component):
    """A waistband of two rectangles."""

    front: Panel
    back: Panel

    def __init__(self, body: BodyParameters, design: Design, rise: float = 1.0) -> None:
        """Drafts it to sit on top of a lower garment of the given rise."""
        super().__init__(self.__class__.__name__)
        self.body = body
        ease, width = design["waistband.waist"], design["waistband.width"]
        waist, hips = ease * body["waist"], ease * body["hips"]
        waist_back, hips_back = (
            body["waist_back_width"] / body["waist"],
            body["hip_back_width"] / body["hips"],
        )
        rise = 1 - width if rise + width > 1 else rise

        def girths(at: float) -> tuple[float, float]:  # of front and back
            girth, back = lin_interpolation(hips, waist, at), lin_interpolation(hips_back, waist_back, at)
            return girth * (1 - back), girth * back

        self.front, self.back = self._panels(girths(rise + width), girths(rise), width * body["hips_line"])
        self.front.translate_by([0.0, body["_waist_level"], 20.0])
        self.back.translate_by([0.0, body["_waist_level"], -15.0])

        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules = Stitches((front["right"], back["right"]), (front["left"], back["left"]))
        self.interfaces = {
            "bottom_f": front["bottom"],
            "bottom_b": back["bottom"],
            "top_f": front["top"],
            "top_b": back["top"],
            "bottom": Interface.from_multiple(front["bottom"], back["bottom"]),
            "top": Interface.from_multiple(front["top"], back["top"]),
        }

    def length(self) -> float:
        """Length of one of its panels, cm."""
        return self.front.length()

    def _panels(
        self, top: tuple[float, float], bottom: tuple[float, float], width: float
    ) -> tuple[Panel, Panel]:
        waists = (self.body["waist"] - self.body["waist_back_width"], self.body["waist_back_width"])
        return (
            StraightBandPanel("wb_front", top[0], width, waists[0]),
            StraightBandPanel("wb_back", top[1], width, waists[1]),
        )


class FittedWB(StraightWB):
    """A waistband of two sectors of rings, which sits close to the body (a yoke)."""

    def _panels(
        self, top: tuple[float, float], bottom: tuple[float, float], width: float
    ) -> tuple[Panel, Panel]:
        waists = (self.body["waist"] - self.body["waist_back_width"], self.body["waist_back_width"])
        make = CircleArcPanel.from_all_length
        return (
            make("wb_front", width, top[0], bottom[0], waists[0], waists[0]),
            make("wb_back", width, top[1], bottom[1], waists[1], waists[1]),
        )
