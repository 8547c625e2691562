"""The panel tensor of a pattern, as SewingLDM learns it: `tensor_layout` says what stands where."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.latent_diffusion import tensor_layout as at
from swifttailor.latent_diffusion.stitch_tags import tags_of
from swifttailor.pattern import Arc, Cubic, EdgeRef, Panel, Pattern, Quadratic

_SLOT = {name: number for number, name in enumerate(at.SLOTS)}


def tensor_of(pattern: Pattern) -> Floats:
    """The panel tensor, `tensor_layout.SHAPE`; bits are 0 or 1.

    What it does not hold: the labels of panels, which their names say, where the origins of panels lie, and
    what is stitched to what, except by tags that are alike.

    Args:
        pattern: With names of GarmentCode and stitches of one edge with one other.

    Raises:
        PatternError: It has another panel, too many edges, or an edge that is stitched twice.
    """
    tensor = np.zeros(at.SHAPE)
    tags = tags_of(pattern)
    turned = {side for stitch in pattern.stitches if stitch.right_wrong for side in stitch.sides}
    for panel in pattern.panels:
        rows = _rows_of(panel)
        for edge, row in enumerate(rows):
            side = EdgeRef(panel.name, edge)
            row[at.FREE] = side not in tags
            row[at.TAG] = tags.get(side, 0.0)
            row[at.REVERSED] = side in turned
        tensor[_SLOT[panel.name], : len(rows)] = rows
    return tensor


def _rows_of(panel: Panel) -> Floats:
    """(edges, numbers) of a panel, without its stitches."""
    if panel.name not in _SLOT:
        raise PatternError(
            f"There is no slot for a panel '{panel.name}': a panel tensor holds those of GarmentCode "
            f"({at.SLOTS[0]}, {at.SLOTS[1]}, ...). Rename it."
        )
    if len(panel.edges) > at.EDGES:
        raise PatternError(
            f"Panel '{panel.name}' has {len(panel.edges)} edges; a panel tensor holds at most {at.EDGES}."
        )
    rows = np.zeros((len(panel.edges), at.NUMBERS))
    rows[:, at.THERE] = 1.0
    rows[:, at.STEP] = np.roll(panel.vertices, -1, axis=0) - panel.vertices
    turn = Rotation.from_matrix(panel.placement.matrix()).as_quat()
    rows[:, at.TURN] = turn if turn[3] >= 0 else -turn
    rows[:, at.PLACE] = panel.to_world(panel.vertices.mean(0)[None])[0]
    for row, edge in zip(rows, panel.edges, strict=True):
        curve = edge.curve
        row[at.KIND] = _bits(at.KINDS.index(type(curve)), 2)
        if isinstance(curve, Quadratic):
            row[at.QUADRATIC] = curve.control
        elif isinstance(curve, Cubic):
            row[at.CUBIC] = *curve.control_1, *curve.control_2
        elif isinstance(curve, Arc):
            # A radius below half the chord is read as that, as everywhere.
            chord = float(np.hypot(*row[at.STEP]))
            row[at.BEND] = min(1.0, chord / (2 * curve.radius)) if curve.radius > 0 else 1.0
            row[at.LARGE], row[at.RIGHT] = curve.large, curve.right
        if edge.label not in at.LABELS:
            raise PatternError(
                f"An edge of panel '{panel.name}' is labelled '{edge.label}'; a panel tensor holds "
                f"{', '.join(at.LABELS[1:])}. Remove the label."
            )
        row[at.LABEL] = _bits(at.LABELS.index(edge.label), 3)
    return rows


def _bits(number: int, count: int) -> list[int]:
    return [number >> k & 1 for k in range(count)]
