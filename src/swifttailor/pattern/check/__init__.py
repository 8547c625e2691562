"""A linter for sewing patterns: what would go wrong when a pattern is sewn, and mending what is safe."""

from __future__ import annotations

from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.change import Change
from swifttailor.pattern.check.checker import check_pattern
from swifttailor.pattern.check.covering import hangs_from_shoulders, panel_regions
from swifttailor.pattern.check.placement_checks import BodyProbe, SignedDistance
from swifttailor.pattern.check.repair import Repair, repair_pattern
from swifttailor.pattern.check.sewable import errors_of, require_no_errors
from swifttailor.pattern.check.stitch_checks import SeamFit, judge_lengths

__all__ = [
    "BodyLevels",
    "BodyProbe",
    "Change",
    "Repair",
    "SeamFit",
    "SignedDistance",
    "check_pattern",
    "errors_of",
    "hangs_from_shoulders",
    "judge_lengths",
    "panel_regions",
    "repair_pattern",
    "require_no_errors",
]
