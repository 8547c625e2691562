"""A linter for sewing patterns: what would go wrong when a pattern is sewn, and mending what is safe."""

from __future__ import annotations

from swifttailor.pattern.check.checker import check_pattern
from swifttailor.pattern.check.placement_checks import BodyProbe, SignedDistance
from swifttailor.pattern.check.repair import Change, Repair, repair_pattern
from swifttailor.pattern.check.stitch_checks import SeamFit, judge_lengths

__all__ = [
    "BodyProbe",
    "Change",
    "Repair",
    "SeamFit",
    "SignedDistance",
    "check_pattern",
    "judge_lengths",
    "repair_pattern",
]
