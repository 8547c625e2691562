"""The table of all design parameters: kind, what is accepted, default. It is that of GarmentCode.

Ranges are those that GarmentCode draws from; a few more values are possible, and some combinations are not.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

Kind = Literal["float", "int", "bool", "select"]


@dataclass(frozen=True)
class DesignParameter:
    """One parameter."""

    name: str
    kind: Kind
    default: Any
    range: tuple[float, float] = (0.0, 0.0)
    """Least and largest number; of no meaning for the other kinds."""
    choices: tuple[Any, ...] = ()
    """What a parameter of kind ``select`` may be."""


def _number(name: str, kind: Kind, low: float, high: float, default: float) -> DesignParameter:
    return DesignParameter(name, kind, default, (low, high))


def _flag(name: str, default: bool) -> DesignParameter:
    return DesignParameter(name, "bool", default, choices=(False, True))


def _select(name: str, choices: tuple[Any, ...], default: Any) -> DesignParameter:
    return DesignParameter(name, "select", default, choices=choices)


_NECKS = (
    "CircleNeckHalf",
    "CurvyNeckHalf",
    "VNeckHalf",
    "SquareNeckHalf",
    "TrapezoidNeckHalf",
    "CircleArcNeckHalf",
    "Bezier2NeckHalf",
)
_ARMHOLES = ("ArmholeSquare", "ArmholeAngle", "ArmholeCurve")
_CUFFS = ("CuffBand", "CuffSkirt", "CuffBandSkirt", None)

_TABLE = (
    _select("meta.upper", ("FittedShirt", "Shirt", None), None),
    _select("meta.wb", ("StraightWB", "FittedWB", None), None),
    _select(
        "meta.bottom",
        (
            "SkirtCircle",
            "AsymmSkirtCircle",
            "GodetSkirt",
            "Pants",
            "Skirt2",
            "SkirtManyPanels",
            "PencilSkirt",
            "SkirtLevels",
            None,
        ),
        None,
    ),
    _number("waistband.waist", "float", 1.0, 2, 1.0),
    _number("waistband.width", "float", 0.1, 1.0, 0.2),
    _flag("shirt.strapless", False),
    _number("shirt.length", "float", 0.5, 3.5, 1.2),
    _number("shirt.width", "float", 1.0, 1.3, 1.05),
    _number("shirt.flare", "float", 0.7, 1.6, 1.0),
    _select("collar.f_collar", _NECKS, "CircleNeckHalf"),
    _select("collar.b_collar", _NECKS, "CircleNeckHalf"),
    _number("collar.width", "float", -0.5, 1, 0.2),
    _number("collar.fc_depth", "float", 0.0, 2, 0.4),  # drawn from 0.3 upwards; shallower ones are worn
    _number("collar.bc_depth", "float", 0, 2, 0),
    _number("collar.fc_angle", "int", 70, 110, 95),
    _number("collar.bc_angle", "int", 70, 110, 95),
    _number("collar.f_bezier_x", "float", 0.05, 0.95, 0.3),
    _number("collar.f_bezier_y", "float", 0.05, 0.95, 0.55),
    _number("collar.b_bezier_x", "float", 0.05, 0.95, 0.15),
    _number("collar.b_bezier_y", "float", 0.05, 0.95, 0.1),
    _flag("collar.f_flip_curve", False),
    _flag("collar.b_flip_curve", False),
    _select("collar.component.style", ("Turtle", "SimpleLapel", "Hood2Panels", None), None),
    _number("collar.component.depth", "int", 2, 8, 7),
    _flag("collar.component.lapel_standing", False),
    _number("collar.component.hood_depth", "float", 1, 2, 1),
    _number("collar.component.hood_length", "float", 1, 1.5, 1),
    _flag("sleeve.sleeveless", True),
    _select("sleeve.armhole_shape", _ARMHOLES, "ArmholeCurve"),
    _number("sleeve.length", "float", 0.1, 1.15, 0.3),
    _number("sleeve.connecting_width", "float", 0, 2, 0.2),
    _number("sleeve.end_width", "float", 0.2, 2, 1.0),
    _number("sleeve.sleeve_angle", "int", 10, 50, 10),
    _number("sleeve.opening_dir_mix", "float", -0.9, 0.8, 0.1),
    _flag("sleeve.standing_shoulder", False),
    _number("sleeve.standing_shoulder_len", "float", 4, 10, 5.0),
    _number("sleeve.connect_ruffle", "float", 1, 2, 1),
    _number("sleeve.smoothing_coeff", "float", 0.1, 0.4, 0.25),
    _select("sleeve.cuff.type", _CUFFS, None),
    _number("sleeve.cuff.top_ruffle", "float", 1, 3, 1),
    _number("sleeve.cuff.cuff_len", "float", 0.05, 0.9, 0.1),
    _number("sleeve.cuff.skirt_fraction", "float", 0.1, 0.9, 0.5),
    _number("sleeve.cuff.skirt_flare", "float", 1, 2, 1.2),
    _number("sleeve.cuff.skirt_ruffle", "float", 1, 1.5, 1.0),
    _flag("left.enable_asym", False),
    _flag("left.shirt.strapless", False),
    _number("left.shirt.width", "float", 1.0, 1.3, 1.0),
    _number("left.shirt.flare", "float", 0.7, 1.6, 1.0),
    _select("left.collar.f_collar", _NECKS, "CircleNeckHalf"),
    _select("left.collar.b_collar", _NECKS, "CircleNeckHalf"),
    _number("left.collar.width", "float", 0, 1, 0.5),
    _number("left.collar.fc_angle", "int", 70, 110, 95),
    _number("left.collar.bc_angle", "int", 70, 110, 95),
    _number("left.collar.f_bezier_x", "float", 0.05, 0.95, 0.5),
    _number("left.collar.f_bezier_y", "float", 0.05, 0.95, 0.3),
    _number("left.collar.b_bezier_x", "float", 0.05, 0.95, 0.5),
    _number("left.collar.b_bezier_y", "float", 0.05, 0.95, 0.3),
    _flag("left.collar.f_flip_curve", False),
    _flag("left.collar.b_flip_curve", False),
    _flag("left.sleeve.sleeveless", True),
    _select("left.sleeve.armhole_shape", _ARMHOLES, "ArmholeCurve"),
    _number("left.sleeve.length", "float", 0.1, 1.15, 0.3),
    _number("left.sleeve.connecting_width", "float", 0, 2, 0.2),
    _number("left.sleeve.end_width", "float", 0.2, 2, 1.0),
    _number("left.sleeve.sleeve_angle", "int", 10, 50, 10),
    _number("left.sleeve.opening_dir_mix", "float", -0.9, 0.8, 0.2),
    _flag("left.sleeve.standing_shoulder", False),
    _number("left.sleeve.standing_shoulder_len", "float", 4, 10, 5.0),
    _number("left.sleeve.connect_ruffle", "float", 1, 2, 1),
    _number("left.sleeve.smoothing_coeff", "float", 0.1, 0.4, 0.25),
    _select("left.sleeve.cuff.type", _CUFFS, None),
    _number("left.sleeve.cuff.top_ruffle", "float", 1, 2, 1),
    _number("left.sleeve.cuff.cuff_len", "float", 0.05, 0.9, 0.1),
    _number("left.sleeve.cuff.skirt_fraction", "float", 0.1, 0.9, 0.5),
    _number("left.sleeve.cuff.skirt_flare", "float", 1, 2, 1.2),
    _number("left.sleeve.cuff.skirt_ruffle", "float", 1, 1.5, 1.0),
    _number("skirt.length", "float", -0.2, 0.95, 0.2),
    _number("skirt.rise", "float", 0.5, 1, 1),
    _number("skirt.ruffle", "float", 1, 2, 1.3),
    _number("skirt.bottom_cut", "float", 0, 0.9, 0),
    _number("skirt.flare", "int", 0, 20, 0),
    _number("flare-skirt.length", "float", -0.2, 0.95, 0.2),
    _number("flare-skirt.rise", "float", 0.5, 1, 1),
    _number("flare-skirt.suns", "float", 0.1, 1.95, 0.75),
    _number("flare-skirt.skirt-many-panels.n_panels", "int", 4, 15, 4),
    _select("flare-skirt.skirt-many-panels.panel_curve", (-0.35, -0.25, -0.15, 0, 0.15, 0.25, 0.35, 0.45), 0),
    _number("flare-skirt.asymm.front_length", "float", 0.1, 0.9, 0.5),
    _flag("flare-skirt.cut.add", False),
    _number("flare-skirt.cut.depth", "float", 0.05, 0.95, 0.5),
    _number("flare-skirt.cut.width", "float", 0.05, 0.4, 0.1),
    _number("flare-skirt.cut.place", "float", -1, 1, -0.5),
    _select("godet-skirt.base", ("Skirt2", "PencilSkirt"), "PencilSkirt"),
    _number("godet-skirt.insert_w", "int", 10, 50, 15),
    _number("godet-skirt.insert_depth", "int", 10, 50, 20),
    _select("godet-skirt.num_inserts", (4, 6, 8, 10, 12), 4),
    _number("godet-skirt.cuts_distance", "int", 0, 10, 5),
    _number("pencil-skirt.length", "float", 0.2, 0.95, 0.4),
    _number("pencil-skirt.rise", "float", 0.5, 1, 1),
    _number("pencil-skirt.flare", "float", 0.6, 1.5, 1.0),
    _number("pencil-skirt.low_angle", "int", -30, 30, 0),
    _number("pencil-skirt.front_slit", "float", 0, 0.9, 0),
    _number("pencil-skirt.back_slit", "float", 0, 0.9, 0),
    _number("pencil-skirt.left_slit", "float", 0, 0.9, 0),
    _number("pencil-skirt.right_slit", "float", 0, 0.9, 0),
    _select("pencil-skirt.style_side_cut", ("Sun", None), None),
    _select("levels-skirt.base", ("Skirt2", "PencilSkirt", "SkirtCircle", "AsymmSkirtCircle"), "PencilSkirt"),
    _select("levels-skirt.level", ("Skirt2", "SkirtCircle", "AsymmSkirtCircle"), "Skirt2"),
    _number("levels-skirt.num_levels", "int", 1, 5, 1),
    _number("levels-skirt.level_ruffle", "float", 1, 1.7, 1.0),
    _number("levels-skirt.length", "float", 0.2, 0.95, 0.5),
    _number("levels-skirt.rise", "float", 0.5, 1, 1),
    _number("levels-skirt.base_length_frac", "float", 0.2, 0.8, 0.5),
    _number("pants.length", "float", 0.2, 0.9, 0.3),
    _number("pants.width", "float", 1.0, 1.5, 1.0),
    _number("pants.flare", "float", 0.5, 1.2, 1.0),
    _number("pants.rise", "float", 0.5, 1, 1.0),
    _select("pants.cuff.type", _CUFFS, None),
    _number("pants.cuff.top_ruffle", "float", 1, 2, 1.0),
    _number("pants.cuff.cuff_len", "float", 0.05, 0.9, 0.1),
    _number("pants.cuff.skirt_fraction", "float", 0.1, 0.9, 0.5),
    _number("pants.cuff.skirt_flare", "float", 1, 2, 1.2),
    _number("pants.cuff.skirt_ruffle", "float", 1, 1.5, 1.0),
)

DESIGN_PARAMETERS: dict[str, DesignParameter] = {p.name: p for p in _TABLE}
"""All parameters by flat name, in GarmentCode's order."""
