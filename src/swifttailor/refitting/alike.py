"""Panels that were alike stay alike: both sides of the body, both halves of a panel, and copies of one."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from swifttailor.pattern import Panel, Pattern
from swifttailor.pattern.panel import Edge
from swifttailor.pattern.tidying.symmetry import between, distance, reflected, same_kinds, self_reflection

ALIKE_CM = 0.05
_MOST_COMPARED = 80


@dataclass(frozen=True)
class Likeness:
    """Which panels of a pattern are alike."""

    pairs: tuple[tuple[int, int], ...]
    """Panels that are each other's mirror image, as `symmetry.reflected` numbers their edges."""
    own: tuple[tuple[int, int], ...]
    """Panels that are their own mirror image, and the shift of the reflection."""


def find_likeness(pattern: Pattern) -> Likeness:
    """Finds the panels that are mirror images of others, or of themselves."""
    panels = pattern.panels[:_MOST_COMPARED]
    pairs, used = [], set()
    for i, one in enumerate(panels):
        if i in used:
            continue
        for j in range(i + 1, len(panels)):
            if j in used or len(panels[j].edges) != len(one.edges):
                continue
            other = reflected(panels[j], one.name)
            if not np.allclose(one.placement.translation, other.placement.translation, atol=ALIKE_CM * 10):
                continue
            apart = distance(one, other)
            if apart is not None and apart < ALIKE_CM:
                pairs.append((i, j))
                used |= {i, j}
                break
    own = []
    for i, panel in enumerate(panels):
        reflection = None if i in used else self_reflection(panel)
        if reflection is not None and reflection.deviation < ALIKE_CM:
            own.append((i, reflection.shift))
    return Likeness(tuple(pairs), tuple(own))


def made_alike(pattern: Pattern, likeness: Likeness) -> Pattern:
    """Gives panels that were alike their mean.

    Args:
        pattern: With the panels and edges of the pattern that was looked at.
        likeness: Of that pattern.
    """
    panels = list(pattern.panels)
    for i, j in likeness.pairs:
        image = reflected(panels[j], panels[i].name)
        if not same_kinds(panels[i], image):  # one side's curve was fitted by a line
            continue
        mean = between(panels[i], image)
        x, y, z = (
            (a + b) / 2
            for a, b in zip(
                panels[i].placement.translation,
                image.placement.translation,
                strict=True,
            )
        )
        mean = replace(mean, placement=replace(panels[i].placement, translation=(x, y, z)))
        panels[i] = mean
        other = reflected(mean, panels[j].name)
        panels[j] = replace(other, label=panels[j].label, edges=_labelled(other, panels[j]))
    for i, shift in likeness.own:
        panels[i] = _even(panels[i], shift)
    return replace(pattern, panels=tuple(panels))


def _labelled(panel: Panel, like: Panel) -> tuple[Edge, ...]:
    """The edges of a panel with the labels of another's."""
    return tuple(
        new if new.label == old.label else replace(new, label=old.label)
        for new, old in zip(panel.edges, like.edges, strict=True)
    )


def _even(panel: Panel, shift: int) -> Panel:
    """A panel and its own mirror image in equal parts, for a known reflection."""
    from swifttailor.pattern.tidying.symmetry import Reflection

    count = len(panel.edges)
    others = panel.vertices[[(shift - k) % count for k in range(count)]]
    axis = float((panel.vertices[:, 0] + others[:, 0]).mean() / 2)
    image = Reflection(shift, axis, 0.0).image(panel)
    if not same_kinds(panel, image):
        return panel
    mean = between(panel, image)
    return replace(mean, edges=_labelled(mean, panel))
