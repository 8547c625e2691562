"""Skirts of panels: pencil skirt, skirt of two panels, skirt of many."""

from __future__ import annotations

import math

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import BaseBottoms, StackableSkirt
from swifttailor.programs.design import Design
from swifttailor.programs.distributing import distribute_y
from swifttailor.programs.interface import Interface
from swifttailor.programs.ornaments import ORNAMENTS
from swifttailor.programs.panel import Panel
from swifttailor.programs.rotation import Rotation
from swifttailor.programs.skirt_panels import FittedSkirtPanel, SkirtPanel, ThinSkirtPanel
from swifttailor.programs.stitching import Stitches


class PencilSkirt(StackableSkirt):
    """A fitted skirt of a front and a back."""

    def __init__(
        self,
        body: BodyParameters,
        design: Design,
        tag: str = "",
        length: float | None = None,
        rise: float | None = None,
        slit: bool = True,
        top_ruffles: bool = True,
    ) -> None:
        """Drafts it; length from the top and rise may be given in place of the design's."""
        super().__init__(body, design, tag)
        design = design.section("pencil-skirt")
        self.low_angle = design["low_angle"]
        self.rise = design["rise"] if rise is None else rise
        waist, hips_depth, back_waist = self.eval_rise(self.rise)
        length = design["length"] * body["_leg_length"] if length is None else length - hips_depth
        ornament = None
        if design["style_side_cut"]:
            depth = 0.7 * (body["hips"] / 4 - body["bust_points"] / 2)
            ornament = ORNAMENTS[design["style_side_cut"]](depth * 1.5, depth)
        slits = [design[f"{side}_slit"] if slit else 0.0 for side in ("front", "back", "left", "right")]

        self.front = FittedSkirtPanel(
            "skirt_front",
            body,
            design,
            waist=(waist - back_waist) / 2,
            hips=(body["hips"] - body["hip_back_width"]) / 2,
            hips_depth=hips_depth,
            length=length,
            dart_position=body["bust_points"] / 2,
            dart_frac=0.8,
            match_top_int_to=body["waist"] - body["waist_back_width"],
            slit=slits[0],
            left_slit=slits[2],
            right_slit=slits[3],
            side_cut=ornament,
        ).translate_to([0.0, body["_waist_level"], 25.0])
        self.back = FittedSkirtPanel(
            "skirt_back",
            body,
            design,
            waist=back_waist / 2,
            hips=body["hip_back_width"] / 2,
            hips_depth=hips_depth,
            length=length,
            hipline_ext=1.05,
            dart_position=body["bum_points"] / 2,
            dart_frac=0.85,
            double_dart=True,
            match_top_int_to=body["waist_back_width"],
            slit=slits[1],
            left_slit=slits[2],
            right_slit=slits[3],
            side_cut=ornament,
        ).translate_to([0.0, body["_waist_level"], -20.0])

        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules = Stitches((front["right"], back["right"]), (front["left"], back["left"]))
        self.interfaces = {
            "top_f": front["top"],
            "top_b": back["top"],
            "top": Interface.from_multiple(
                front["top"].flip_edges(), back["top"].reverse(with_edge_dir_reverse=True)
            ),
            "bottom_f": front["bottom"],
            "bottom_b": back["bottom"],
            "bottom": Interface.from_multiple(front["bottom"], back["bottom"]),
        }

    def length(self) -> float:
        """Length of its front, cm."""
        return self.front.length()


class Skirt2(StackableSkirt):
    """A skirt of two trapezia."""

    def __init__(
        self,
        body: BodyParameters,
        design: Design,
        tag: str = "",
        length: float | None = None,
        rise: float | None = None,
        slit: bool = True,
        top_ruffles: bool = True,
        min_len: float = 5.0,
    ) -> None:
        """Drafts it; length from the top and rise may be given in place of the design's."""
        super().__init__(body, design, tag)
        design = design.section("skirt")
        self.rise = design["rise"] if rise is None else rise
        waist, hip_line, back_waist = self.eval_rise(self.rise)
        if length is None:
            length = hip_line + design["length"] * body["_leg_length"]
        length = max(length, min_len)

        def panel(side: str, width: float, sewn_to: float) -> Panel:
            return SkirtPanel(
                f"skirt_{side}_{tag}" if tag else f"skirt_{side}",
                waist_length=width,
                length=length,
                ruffles=design["ruffle"] if top_ruffles else 1.0,
                flare=design["flare"],
                bottom_cut=design["bottom_cut"] * design["length"] if slit else 0.0,
                match_top_int_to=sewn_to,
            )

        self.front = panel("front", waist - back_waist, body["waist"] - body["waist_back_width"])
        self.back = panel("back", back_waist, body["waist_back_width"])
        self.front.translate_to([0.0, body["_waist_level"], 25.0])
        self.back.translate_to([0.0, body["_waist_level"], -20.0])

        front, back = self.front.interfaces, self.back.interfaces
        self.stitching_rules = Stitches((front["right"], back["right"]), (front["left"], back["left"]))
        self.interfaces = {
            "top_f": front["top"],
            "top_b": back["top"],
            "top": Interface.from_multiple(front["top"], back["top"]),
            "bottom_f": front["bottom"],
            "bottom_b": back["bottom"],
            "bottom": Interface.from_multiple(front["bottom"], back["bottom"]),
        }

    def length(self) -> float:
        """Length of its front, cm."""
        return self.front.length()


class SkirtManyPanels(BaseBottoms):
    """A flared skirt of equal gores."""

    def __init__(
        self, body: BodyParameters, design: Design, rise: float | None = None, min_len: float = 5.0
    ) -> None:
        """Drafts one gore and places copies of it around the body."""
        design = design.section("flare-skirt")
        n_panels = design["skirt-many-panels.n_panels"]
        super().__init__(body, design, tag=str(n_panels))
        self.rise = design["rise"] if rise is None else rise
        waist, hip_line, _ = self.eval_rise(self.rise)
        length = max(hip_line + design["length"] * body["_leg_length"], min_len)
        widening = 1 + design["suns"] * length * 2 * math.pi / waist
        width = waist / n_panels
        self.front = ThinSkirtPanel(
            "front", width, width * widening, length, design["skirt-many-panels.panel_curve"]
        )

        # Far enough away that the hems of all gores fit on the circle.
        away = self.front.interfaces["bottom"].edges.length() / (2 * math.tan(math.pi / n_panels))
        self.front.translate_to([-away, body["_waist_level"], 0.0])
        self.front.rotate_by(Rotation.from_euler(0.0, -90.0, 0.0))
        self.front.rotate_align([-away, 0.0, width / 2])
        self.front.interfaces["top"].reverse(True)
        gores = distribute_y(self.front, n_panels, name_tag="skirt_panel")
        self.subs = [*gores]
        for one, two in zip(gores, [*gores[1:], gores[0]], strict=True):
            self.stitching_rules.append((one.interfaces["left"], two.interfaces["right"]))
        self.interfaces = {"top": Interface.from_multiple(*(g.interfaces["top"] for g in gores))}

    def length(self) -> float:
        """Length of a gore, cm."""
        return self.front.length()
