"""Half of an upper garment: front and back with sleeve and collar, or cut off above the bust."""

from __future__ import annotations

import math
from dataclasses import dataclass

from swifttailor.programs.bodice_panels import (
    BaseBodicePanel,
    BodiceBackHalf,
    BodiceFrontHalf,
    TorsoBackHalfPanel,
    TorsoFrontHalfPanel,
)
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.collars import Collar, NoPanelsCollar, SimpleLapel, Turtle
from swifttailor.programs.component import Component, lin_interpolation
from swifttailor.programs.cutting import cut_corner
from swifttailor.programs.design import Design
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.hood import Hood2Panels
from swifttailor.programs.interface import Interface
from swifttailor.programs.panel import Panel
from swifttailor.programs.sleeves import Sleeve

COLLARS: dict[str | None, type[NoPanelsCollar | Turtle | SimpleLapel | Hood2Panels]] = {
    None: NoPanelsCollar,
    "Turtle": Turtle,
    "SimpleLapel": SimpleLapel,
    "Hood2Panels": Hood2Panels,
}
"""By the names that ``collar.component.style`` accepts."""

_LEFT_CM = 1.0
"""What sleeve and collar leave of an edge at least."""


@dataclass(frozen=True)
class _Cuts:
    """How far sleeve and collar cut into the panels, cm."""

    armhole: float
    collar_width: float
    front: float
    """Depth of the neckline, from the neck's side of the shoulder."""
    back: float
    front_rise: float
    """What the shoulder climbs from the panel's side to the neck's side."""
    back_rise: float

    def of(self, design: Design) -> Design:
        """The design with these depths in cm."""
        return design.replaced(
            {
                "sleeve.connecting_width": self.armhole,
                "collar.width": self.collar_width,
                "collar.fc_depth": self.front + self.front_rise,
                "collar.bc_depth": self.back + self.back_rise,
            }
        )


class BodiceHalf(Component):
    """The right half of an upper garment; mirrored, the left one."""

    def __init__(self, name: str, body: BodyParameters, design: Design, fitted: bool) -> None:
        """Drafts it.

        Args:
            name: Begins the names of the panels.
            body: The body.
            design: Parameters ``shirt.*``, ``collar.*`` and ``sleeve.*`` are used.
            fitted: Darts to the waist; only then can it be strapless.
        """
        super().__init__(name)
        front, back = (
            (BodiceFrontHalf, BodiceBackHalf) if fitted else (TorsoFrontHalfPanel, TorsoBackHalfPanel)
        )
        self.ftorso: BaseBodicePanel = front(f"{name}_ftorso", body, design).translate_by([0.0, 0.0, 30.0])
        self.btorso: BaseBodicePanel = back(f"{name}_btorso", body, design).translate_by([0.0, 0.0, -25.0])
        ahead, behind = self.ftorso.interfaces, self.btorso.interfaces
        self.interfaces = {
            "f_bottom": ahead["bottom"],
            "b_bottom": behind["bottom"],
            "front_in": ahead["inside"],
            "back_in": behind["inside"],
        }
        cuts = self._cuts(body, design)
        if design["shirt.strapless"] and fitted:
            self._make_strapless(body, cuts)
        else:
            self._add_sleeves(body, cuts.of(design).section("sleeve"))
            self._add_collars(body, cuts.of(design))
            self.stitching_rules.append((ahead["shoulder"], behind["shoulder"]))
        self.stitching_rules.append((ahead["outside"], behind["outside"]))

    def _cuts(self, body: BodyParameters, design: Design) -> _Cuts:
        """The depths that the parameters, which are fractions, mean for these panels."""
        front, back = self.ftorso, self.btorso
        armscye = body["_armscye_depth"]
        side = front.interfaces["shoulder_corner"].edges[0].length()
        armhole = min(armscye + armscye * design["sleeve.connecting_width"], side - _LEFT_CM)

        wide, neck = design["collar.width"], body["neck_w"]
        if wide >= 0:
            width = lin_interpolation(neck, body["_base_sleeve_balance"] - 2, wide)
        else:
            width = lin_interpolation(0.0, neck, 1 + wide)

        slope = math.tan(math.radians(body["_shoulder_incl"]))
        depths, rises = [], []
        for panel, parameter in ((front, "collar.fc_depth"), (back, "collar.bc_depth")):
            panel_width = panel.get_width(0.0)
            middle = panel.interfaces["collar_corner"].edges[1].length()
            depths.append(
                min(design[parameter] * body["_bust_line"], middle - slope * panel_width - _LEFT_CM)
            )
            rises.append(slope * (panel_width - width / 2))
        return _Cuts(armhole, width, *depths, *rises)

    def _add_sleeves(self, body: BodyParameters, design: Design) -> None:
        level = design["connecting_width"]
        self.sleeve = Sleeve(
            self.name, body, design, self.ftorso.get_width(level), self.btorso.get_width(level)
        )
        front = _cut_out(self.sleeve.front_shape, self.ftorso, "shoulder_corner")
        back = _cut_out(self.sleeve.back_shape, self.btorso, "shoulder_corner")
        if not design["sleeveless"]:
            armhole = Interface.from_multiple(front.reverse(with_edge_dir_reverse=True), back.reverse())
            sewn_in = self.sleeve.interfaces["in"]
            self.stitching_rules.append((sewn_in, armhole))
            gap = -1 - body["arm_pose_angle"] / 10  # the steeper the arm, the further it reaches in
            self.sleeve.place_by_interface(sewn_in, armhole, gap=gap, alignment="top")
        for cut in (front, back):
            cut.edges.propagate_label(f"{self.name}_armhole")

    def _add_collars(self, body: BodyParameters, design: Design) -> None:
        self.collar: Collar = COLLARS[design["collar.component.style"]](self.name, body, design)
        front = _cut_out(self.collar.front_shape, self.ftorso, "collar_corner")
        back = _cut_out(self.collar.back_shape, self.btorso, "collar_corner")
        own = self.collar.interfaces
        if "bottom" in own:
            self.stitching_rules.append((Interface.from_multiple(front, back), own["bottom"]))
        if "front" in own:
            self.interfaces["front_in"] = Interface.from_multiple(
                self.ftorso.interfaces["inside"], own["front"]
            )
        if "back" in own:
            self.interfaces["back_in"] = Interface.from_multiple(
                self.btorso.interfaces["inside"], own["back"]
            )
        for cut in (front, back):
            cut.edges.propagate_label(f"{self.name}_collar")

    def _make_strapless(self, body: BodyParameters, cuts: _Cuts) -> None:
        slope = math.tan(math.radians(body["_shoulder_incl"]))
        side = cuts.armhole - slope * (self.btorso.get_width(0.0) - body["_base_sleeve_balance"] / 2)
        _cut_top(self.btorso, side, cuts.back)
        longer = _side_length(self.ftorso) - _side_length(self.btorso)
        _cut_top(self.ftorso, side, cuts.front, remove=longer)
        for panel in (self.ftorso, self.btorso):
            panel.interfaces["shoulder"].edges.propagate_label("strapless_top")

    def length(self) -> float:
        """Length of the back, cm."""
        return self.btorso.length()


_DEPTHS = {
    "shoulder_corner": ("an armhole", "sleeve.connecting_width"),
    "collar_corner": ("a neckline", "collar.width, collar.fc_depth or collar.bc_depth"),
}


def _cut_out(shape: EdgeSequence, panel: Panel, corner: str) -> Interface:
    """Cuts a shape out of a corner of a panel; returns the new interface."""
    try:
        return cut_corner(shape, panel.interfaces[corner])[1]
    except DesignError:
        (x, y), (to_x, to_y) = shape.shortcut()
        what, parameters = _DEPTHS[corner]
        raise DesignError(
            f"Panel '{panel.name}' has no room for {what} of {abs(to_x - x):.3g} by {abs(to_y - y):.3g} cm: "
            f"nothing would be left of one of its edges. Make {parameters} smaller."
        ) from None


def _side_length(panel: Panel) -> float:
    return panel.interfaces["outside"].edges.length()


def _cut_top(panel: Panel, side: float, middle: float, remove: float | None = None) -> None:
    """Cuts a panel off below the shoulder.

    Args:
        panel: A fitted panel.
        side: How far below the lower end of the shoulder the cut is at the side, cm.
        middle: The same in the middle.
        remove: Length to take off the side instead, cm.
    """
    shoulder = panel.interfaces["shoulder"].edges[0]
    inner, outer = shoulder.start, shoulder.end
    if inner[1] < outer[1]:
        inner, outer = outer, inner
    level = outer[1]
    inner[1] = level - middle
    edge = panel.interfaces["outside"].edges[-1]
    low = edge.end if edge.start is outer else edge.start
    if remove is not None:
        side = remove * abs(outer[1] - low[1]) / edge.length()
    outer[0] -= side * abs(outer[0] - low[0]) / abs(outer[1] - low[1])
    outer[1] = level - side
