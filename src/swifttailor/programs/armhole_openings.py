"""Sleeve openings of front and back made equally wide, so that both halves of a sleeve are."""

from __future__ import annotations

import math

from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edges import close_enough, to_complex


def even_armhole_openings(
    front_opening: EdgeSequence, back_opening: EdgeSequence, tol: float = 1e-2
) -> tuple[EdgeSequence, EdgeSequence]:
    """Moves the end of the front opening to the back one until both are equally high.

    Args:
        front_opening: The longer one; changed in place.
        back_opening: Changed in place.
        tol: A division this close to an end of an edge counts as the end.

    Returns:
        Both openings, turned upright.
    """
    front, back = front_opening.copy(), back_opening.copy()
    back.reflect([0.0, 0.0], [1.0, 0.0]).reverse().snap_to(front[-1].end)
    low = to_complex(front[0].start)
    slope = to_complex(back[-1].end) - low
    middle, across = low + slope / 2, 1j * slope
    found = front[-1].as_curve().crossings(middle - 20 * across, middle + 20 * across)
    if found and not close_enough(found[0], 0.0, tol) and not close_enough(found[0], 1.0, tol):
        kept, moved = front_opening[-1].subdivide_param([found[0], 1 - found[0]])
        front_opening.substitute(-1, kept)
        moved.start, moved.end = list(moved.start), list(moved.end)
        EdgeSequence(moved).reflect([0.0, 0.0], [1.0, 0.0]).reverse().snap_to(back_opening[-1].end)
        moved.start = back_opening[-1].end
        back_opening.append(moved)
    angle = math.atan(-slope.real / slope.imag)
    front_opening.rotate(-angle)
    back_opening.rotate(angle)
    return front_opening, back_opening
