"""Designs drafted for a body: GarmentCode's programs with the measurements that are taken on its mesh."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.body import Body
from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.check import panel_regions
from swifttailor.programs import BodyParameters, make_pattern, read_design
from swifttailor.refitting.body_profile import profile_of


def draft_design(design: Mapping[str, Any] | Path | str, body: Body | None = None) -> Pattern:
    """Drafts the pattern of a garment from GarmentCode's design parameters, for a body's own measurements.

    Args:
        design: Values of `programs.DESIGN_PARAMETERS` by flat name, such as ``{"meta.upper": "Shirt"}``, or
            one of GarmentCode's design files, YAML or JSON; what is missing has its default.
        body: Whom it is for, such as ``body_for("44")``; GarmentCode's mean body, the default, when None.

    Raises:
        DesignError: There is no such parameter, a value is not accepted, or the parameters make no garment
            that this body can wear.
        InputError: The file cannot be read or holds no design.
    """
    values = design if isinstance(design, Mapping) else read_design(design)
    if body is None:
        return make_pattern(values)
    pattern = make_pattern(values, BodyParameters(body.measurements))
    return replace(_clear_of(body, pattern), drafted_for=body.made_for)


def _clear_of(body: Body, pattern: Pattern) -> Pattern:
    """Moves panels of the trunk and legs forward or backward by what a body reaches further than the default.

    The programs place them at fixed distances from the middle, where a stout body is.
    """
    if body is Body.default():
        return pattern
    usual, own = profile_of(Body.default()), profile_of(body)
    ahead = np.maximum(own.side + own.ahead - usual.side - usual.ahead, 0.0)
    behind = np.maximum(own.behind - own.side - usual.behind + usual.side, 0.0)
    regions = panel_regions(pattern)

    def moved(panel: Panel) -> Panel:
        points = panel.to_world(panel.outline())
        if regions[panel.name] == "arm":
            return panel
        reached = (own.heights >= points[:, 1].min()) & (own.heights <= points[:, 1].max())
        further = ahead if points[:, 2].mean() > 0 else -behind
        x, y, z = panel.placement.translation
        shift = max(further[reached], key=abs, default=0.0)
        return replace(panel, placement=replace(panel.placement, translation=(x, y, z + float(shift))))

    return replace(pattern, panels=tuple(map(moved, pattern.panels)))
