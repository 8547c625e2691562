"""A skirt in tiers: each is sewn to the hem of the one above."""

from __future__ import annotations

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.bottoms import BaseBottoms, StackableSkirt
from swifttailor.programs.circle_skirt import AsymmSkirtCircle, SkirtCircle
from swifttailor.programs.design import Design
from swifttailor.programs.rotation import Rotation
from swifttailor.programs.skirt_paneled import PencilSkirt, Skirt2

TIERS = {
    "Skirt2": Skirt2,
    "PencilSkirt": PencilSkirt,
    "SkirtCircle": SkirtCircle,
    "AsymmSkirtCircle": AsymmSkirtCircle,
}


class SkirtLevels(BaseBottoms):
    """A base skirt and one to five tiers below it."""

    def __init__(self, body: BodyParameters, design: Design, rise: float | None = None) -> None:
        """Drafts the base, then tier after tier."""
        super().__init__(body, design, rise=rise)
        own = design.section("levels-skirt")
        count = own["num_levels"]
        total = own["length"] * body["_leg_length"]
        base_length = total * own["base_length_frac"]
        level_length = (total - base_length) / count
        self.rise = own["rise"] if rise is None else rise
        base = TIERS[own["base"]](
            body,
            design,
            length=body["hips_line"] * own["rise"] + base_length,
            rise=self.rise,
            slit=False,
        )
        tiers: list[StackableSkirt] = [base]
        for i in range(count):
            above = tiers[-1].interfaces
            # A skirt fits its body: it gets one with the waist that it shall have.
            waist = own["level_ruffle"] * above["bottom"].edges.length()
            back = own["level_ruffle"] * above["bottom_b"].edges.length()
            level = TIERS[own["level"]](
                body.with_measures(waist=waist, waist_back_width=back),
                design,
                tag=str(i),
                length=level_length,
                slit=False,
                top_ruffles=False,
            )
            level.rotate_by(Rotation.from_euler(0.0, 0.0, -base.low_angle))
            level.place_by_interface(level.interfaces["top"], above["bottom"], gap=5.0)
            self.stitching_rules.append((above["bottom"], level.interfaces["top"]))
            tiers.append(level)
        self.subs = [*tiers]
        self.interfaces = {"top": base.interfaces["top"]}
