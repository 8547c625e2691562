"""A whole garment: upper part, waistband and lower part, one below the other, as one pattern."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from swifttailor.pattern import Pattern
from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import BaseBottoms
from swifttailor.programs.circle_skirt import AsymmSkirtCircle, SkirtCircle
from swifttailor.programs.component import BaseComponent, Component
from swifttailor.programs.design import Design
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.design_reader import complete_design
from swifttailor.programs.godet import GodetSkirt
from swifttailor.programs.panel_order import in_garmentcode_order
from swifttailor.programs.pants import Pants
from swifttailor.programs.refusals import refuse_combinations
from swifttailor.programs.skirt_levels import SkirtLevels
from swifttailor.programs.skirt_paneled import PencilSkirt, Skirt2, SkirtManyPanels
from swifttailor.programs.uppers import UPPERS
from swifttailor.programs.waistbands import FittedWB, StraightWB

WAISTBANDS = {"StraightWB": StraightWB, "FittedWB": FittedWB}
BOTTOMS: dict[str, type[BaseBottoms]] = {
    "SkirtCircle": SkirtCircle,
    "AsymmSkirtCircle": AsymmSkirtCircle,
    "GodetSkirt": GodetSkirt,
    "Pants": Pants,
    "Skirt2": Skirt2,
    "SkirtManyPanels": SkirtManyPanels,
    "PencilSkirt": PencilSkirt,
    "SkirtLevels": SkirtLevels,
}
FLOOR_CM = 1.0
"""A garment may be longer than from the neck to the floor by this."""


class MetaGarment(Component):
    """A garment of up to three parts."""

    def __init__(self, body: BodyParameters, design: Design) -> None:
        """Drafts the parts, places each below the one before and sews it on."""
        super().__init__("garment")
        upper, belt, lower = design["meta.upper"], design["meta.wb"], design["meta.bottom"]
        if upper:
            self._add(UPPERS[upper](body, design), "body")
        bottom = None
        if lower:
            # A fitted upper part ends at the waist, wherever the lower one would begin alone.
            bottom = BOTTOMS[lower](body, design, rise=1.0 if upper == "FittedShirt" else None)
        if belt:
            band = WAISTBANDS[belt](body, design, bottom.get_rise() if bottom else 1.0)
            self._add(band, "body", waist=True)
        if bottom:
            self._add(bottom, "leg", waist=not belt)

    def _add(self, part: BaseComponent, label: str, waist: bool = False) -> None:
        if self.subs:
            above, top = self.subs[-1].interfaces["bottom"], part.interfaces["top"]
            part.place_by_interface(top, above, gap=5.0)
            self.stitching_rules.append((above, top))
        if waist:
            part.interfaces["top"].edges.propagate_label("lower_interface")
        part.set_panel_label(label, overwrite=False)
        self.subs.append(part)


def make_pattern(design: Mapping[str, Any], body: BodyParameters | None = None) -> Pattern:
    """Drafts the pattern of a garment from design parameters.

    Args:
        design: Values of `DESIGN_PARAMETERS` by flat name, such as ``{"meta.upper": "Shirt"}``; what is
            missing has its default.
        body: Whom it should fit; GarmentCode's mean body by default.

    Raises:
        DesignError: There is no such parameter, a value is not accepted, or the parameters make no garment
            that can be worn.
    """
    values = complete_design(design)
    refuse_combinations(values)
    body = body or BodyParameters.default()
    garment = MetaGarment(body, values)
    length, floor = garment.length(), body["height"] - body["head_l"]
    if length > floor + FLOOR_CM:
        raise DesignError(
            f"The garment would be {length:.1f} cm long, and it is {floor:.1f} cm from the neck to the "
            f"floor. Make it shorter: {_lengths(values)}."
        )
    panels = in_garmentcode_order([panel.assembly() for panel in garment.panels()])
    return Pattern(panels, tuple(garment.all_stitches()))


def _lengths(design: Design) -> str:
    """The parameters that the length follows from, with their values."""
    names = {
        "Shirt": ["shirt.length"],
        "StraightWB": ["waistband.width"],
        "FittedWB": ["waistband.width"],
        "SkirtCircle": ["flare-skirt.length"],
        "AsymmSkirtCircle": ["flare-skirt.length"],
        "SkirtManyPanels": ["flare-skirt.length"],
        "Pants": ["pants.length", "pants.cuff.cuff_len"],
        "Skirt2": ["skirt.length"],
        "PencilSkirt": ["pencil-skirt.length"],
        "SkirtLevels": ["levels-skirt.length"],
        "GodetSkirt": ["skirt.length", "pencil-skirt.length"],
    }
    parts = [design[name] for name in ("meta.upper", "meta.wb", "meta.bottom")]
    used = [name for part in parts for name in names.get(part, [])]
    return ", ".join(f"{name} is {design[name]:.3g}" for name in used)
