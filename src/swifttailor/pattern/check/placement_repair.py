"""Brings the panels of a pattern to where it is worn."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.change import Change
from swifttailor.pattern.check.judgements import place_of
from swifttailor.pattern.check.placement_checks import motion_in_words
from swifttailor.pattern.json_values import MAX_ABSOLUTE
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import Pattern

Step = tuple[Pattern, list[Change]]


def reread_angles(pattern: Pattern, levels: BodyLevels) -> Step:
    """Writes the angles of a pattern that fits better read the other way for the reading it has."""
    misread = place_of(pattern, levels).misread
    if misread is None:
        return pattern, []
    now = pattern.panels[0].placement.reading
    meant = pattern.with_rotation_reading(misread.reading)
    panels = tuple(
        old
        if np.allclose(old.placement.matrix(), new.placement.matrix(), atol=1e-9)
        else replace(new, placement=new.placement.read_as(now))
        for old, new in zip(pattern.panels, meant.panels, strict=True)
    )
    turned = [new.name for old, new in zip(pattern.panels, panels, strict=True) if new is not old]
    text = (
        f"wrote the {misread.reading} angles of {', '.join(turned)} as {now} ones: seams are "
        f"{misread.other_gap:.0f} cm apart on average instead of {misread.gap:.0f}"
    )
    return replace(pattern, panels=panels), [Change("misread-angles", text)]


def move_to_body(pattern: Pattern, levels: BodyLevels) -> Step:
    """Moves a garment as a whole to where it is worn."""
    offset = place_of(pattern, levels).offset
    if offset is None:
        return pattern, []
    still, shift = np.eye(3), np.array(offset.shift)
    panels = tuple(replace(p, placement=p.placement.moved(still, shift)) for p in pattern.panels)
    if not _can_be_written(panels):
        return pattern, []
    text = f"moved the whole pattern {motion_in_words(offset.shift)}, to where it is worn"
    return replace(pattern, panels=panels), [Change("misplaced-panel", text)]


def turn_limbs(pattern: Pattern, levels: BodyLevels) -> Step:
    """Turns sleeves and trouser legs for another pose about shoulders and hips, down to the limbs."""
    place = place_of(pattern, levels)
    if not place.limbs or place.offset is not None:
        return pattern, []
    changes = []
    panels = {p.name: p for p in pattern.panels}
    for pose in place.limbs:
        angle = np.deg2rad(pose.turn)
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        shift = pose.pivot - turn @ pose.pivot
        code, body = ("high-sleeve", "arm") if pose.limb == "sleeve" else ("spread-leg", "leg")
        text = f"turned the panel by {abs(pose.turn):.0f} degrees, down to the {body}"
        for name in pose.panels:
            panels[name] = replace(panels[name], placement=panels[name].placement.moved(turn, shift))
            changes.append(Change(code, text, name))
    turned = tuple(panels.values())
    return (replace(pattern, panels=turned), changes) if _can_be_written(turned) else (pattern, [])


def _can_be_written(panels: Iterable[Panel]) -> bool:
    """Whether no panel was moved to where files cannot say that it is: thousands of kilometres away."""
    return all(abs(x) <= MAX_ABSOLUTE for panel in panels for x in panel.placement.translation)
