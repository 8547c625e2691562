"""Cutting shapes into edges and corners of panels."""

from __future__ import annotations

import math
from collections.abc import Sequence

from scipy.optimize import minimize

from swifttailor.arrays import Floats
from swifttailor.programs.curved_edges import vector_angle
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edges import Edge, to_complex, to_vertex
from swifttailor.programs.interface import Interface
from swifttailor.programs.planar_curves import ArcCurve, LineCurve, PlanarCurve

TOLERANCE = 1e-2
_EXACT_CM = 1e-9
_MOST_STEPS = 50


def cut_into_edge(
    target_shape: EdgeSequence | Sequence[EdgeSequence],
    base_edge: Edge,
    offset: float = 0.0,
    right: bool = True,
    flip_target: bool = False,
    tol: float = TOLERANCE,
) -> tuple[EdgeSequence, EdgeSequence, EdgeSequence]:
    """Cuts a shape, or several with their openings one above the other, into an edge.

    Args:
        target_shape: A chain of edges, or several.
        base_edge: The edge; it stays as it is.
        offset: Length along the edge to the middle of the shape, cm.
        right: Whether the cut lies to the right of travel.
        flip_target: Mirror several shapes across the horizontal line through their middle.
        tol: Parameters of the edge that are closer to its ends count as the end.

    Returns:
        All new edges, those of the shape, and what is left of the edge.
    """
    if isinstance(target_shape, EdgeSequence):
        return _cut_one(target_shape, base_edge, offset, right, tol)
    heights = [v[1] for shape in target_shape for v in shape.shortcut()]
    median_y = (max(heights) + min(heights)) / 2
    shapes = list(target_shape)
    if flip_target:
        shapes = [s.copy().reflect([0.0, median_y], [1.0, median_y]).reverse() for s in shapes]
    offsets = [offset + (s.shortcut()[0][1] + s.shortcut()[1][1]) / 2 - median_y for s in shapes]
    edge = base_edge
    all_new, shape_edges, left_over = EdgeSequence(base_edge), EdgeSequence(), EdgeSequence(base_edge)
    for at, shape in sorted(zip(offsets, shapes, strict=True), key=lambda pair: -pair[0]):
        new, inside, rest = _cut_one(shape, edge, at, right, tol)
        all_new.substitute(edge, new)
        left_over.substitute(edge, rest)
        shape_edges.append(inside)
        edge = new[0]
    return all_new, shape_edges, left_over


def _cut_one(
    target_shape: EdgeSequence, base_edge: Edge, offset: float, right: bool, tol: float
) -> tuple[EdgeSequence, EdgeSequence, EdgeSequence]:
    new_edges = target_shape.copy().snap_to([0.0, 0.0])
    opening = to_complex(new_edges[-1].end) - to_complex(new_edges[0].start)
    width, length = abs(opening), base_edge.length()
    if offset < width / 2 - tol or offset > length - width / 2 + tol:
        raise DesignError(
            f"A cut {width:.4g} cm wide does not fit {offset:.4g} cm along an edge of {length:.4g} cm. "
            "Change the parameters of the cut or of the width there."
        )
    curve = base_edge.as_curve()
    middle = curve.at_length(offset)
    before, after = _symmetric(curve, middle, width)
    if after > 1 + tol or before < -tol:
        raise DesignError(
            f"A cut {width:.4g} cm wide goes over the end of its edge of {length:.4g} cm. "
            "Change the parameters of the cut or of the width there."
        )
    at_start, at_end = before <= tol, after >= 1 - tol
    first = to_complex(base_edge.start) if at_start else curve.point(before)
    last = to_complex(base_edge.end) if at_end else curve.point(after)
    new_edges.rotate(vector_angle(to_vertex(opening), to_vertex(last - first)))
    new_edges.snap_to(to_vertex(first))

    verts = new_edges.verts()
    inner = sum(to_complex(v) for v in verts) / len(verts) - to_complex(new_edges[0].start)
    is_right = ((last - first).conjugate() * inner).imag < 0
    if is_right != right:
        new_edges.reflect(new_edges[0].start, new_edges[-1].end)

    shape, left_over = EdgeSequence(new_edges), EdgeSequence()
    if at_start:
        new_edges[0].start = base_edge.start
    else:
        part = base_edge.subdivide_param([before, 1 - before])[0]
        part.end = new_edges[0].start
        new_edges.insert(0, part)
        left_over.append(part)
    if at_end:
        new_edges[-1].end = base_edge.end
    else:
        part = base_edge.subdivide_param([after, 1 - after])[-1]
        part.start = new_edges[-1].end
        new_edges.append(part)
        left_over.append(part)
    return new_edges, shape, left_over


def _symmetric(curve: PlanarCurve, middle: float, width: float) -> tuple[float, float]:
    """Parameters on both sides of the middle, whose points are a width apart and equally far from it."""
    if isinstance(curve, LineCurve):
        shift = width / 2 / curve.length()
        return middle - shift, middle + shift
    if isinstance(curve, ArcCurve):
        _, radius, _, sweep = curve.circle()
        if width <= 2 * radius:
            shift = math.asin(width / 2 / radius) / abs(sweep)
            return middle - shift, middle + shift
    at = curve.point(middle)
    first = second = width / 2 / abs(curve.derivative(middle))
    for _ in range(_MOST_STEPS):  # Newton's, for the width and for the difference of both distances
        one, two = curve.point(middle + first), curve.point(middle - second)
        across, ahead, behind = one - two, one - at, two - at
        wide, uneven = abs(across) - width, abs(ahead) - abs(behind)
        if abs(wide) + abs(uneven) < _EXACT_CM:
            return middle - second, middle + first
        by_first, by_second = curve.derivative(middle + first), curve.derivative(middle - second)
        a, b = _along(across, by_first), _along(across, by_second)
        c, d = _along(ahead, by_first), _along(behind, by_second)
        area = a * d - b * c
        if area == 0.0:
            break
        first -= (wide * d - uneven * b) / area
        second -= (uneven * a - wide * c) / area
    raise DesignError(
        f"No place was found for a cut {width:.4g} cm wide in an edge of {curve.length():.4g} cm. "
        "Change the parameters of the cut or of the width there."
    )


def _along(way: complex, step: complex) -> float:
    return (way.conjugate() * step).real / abs(way)


def cut_corner(target_shape: EdgeSequence, target_interface: Interface) -> tuple[EdgeSequence, Interface]:
    """Cuts a shape out of a corner of a panel; the panel and its interfaces follow.

    Args:
        target_shape: A chain of edges.
        target_interface: The two chained edges that form the corner.

    Returns:
        The new edges, and the new interface of the panel that they make.
    """
    corner_shape = target_shape.copy()
    panel, target_edges = target_interface.panel[0], target_interface.edges
    if target_edges[0].start is target_edges[-1].end:
        target_edges.edges.reverse()
    if corner_shape[0].start is corner_shape[-1].end:
        corner_shape.edges.reverse()
    if corner_shape[0].start[1] > corner_shape[-1].end[1]:
        corner_shape.reverse().snap_to([0.0, 0.0])
    first, second = target_edges[0], target_edges[1]
    swapped = first.start[1] > target_edges[-1].end[1]
    lower, upper = first.as_curve(), second.as_curve()
    if swapped:
        lower, upper = upper, lower
    opening = to_complex(corner_shape[-1].end) - to_complex(corner_shape[0].start)
    on_lower, on_upper = _across_corner(lower, upper, opening)
    corner_shape.snap_to(to_vertex(lower.point(on_lower)))
    if swapped:
        corner_shape.reverse()
        on_lower, on_upper = on_upper, on_lower

    begin = first.subdivide_param([on_lower, 1 - on_lower])[0]
    finish = second.subdivide_param([on_upper, 1 - on_upper])[1]
    begin.end, finish.start = corner_shape[0].start, corner_shape[-1].end
    cut = EdgeSequence(corner_shape)
    whole = EdgeSequence(begin, cut, finish)
    panel.edges.pop(first)
    panel.edges.substitute(second, whole)
    for interface in panel.interfaces.values():
        for old, new in ((first, begin), (second, finish)):
            if old in interface.edges:
                interface.edges.substitute(old, new)
    made = Interface(panel, cut)
    panel.interfaces[f"int_{len(panel.interfaces)}"] = made
    return EdgeSequence(cut), made


def _across_corner(lower: PlanarCurve, upper: PlanarCurve, opening: complex) -> tuple[float, float]:
    """Parameters on two curves whose points are as far from each other as the opening says."""

    def misfit(at: Floats) -> float:
        return abs(upper.point(at[1]) - lower.point(at[0]) - opening) ** 2

    if isinstance(lower, LineCurve) and isinstance(upper, LineCurve):
        # lower.start + a u + opening = upper.start + b v, for a and b
        u, v, gap = lower.end - lower.start, upper.end - upper.start, upper.start - lower.start - opening
        area = (u.conjugate() * v).imag
        if abs(area) > 1e-9:
            a, b = (gap.conjugate() * v).imag / area, (gap.conjugate() * u).imag / area
            if 0 <= a <= 1 and 0 <= b <= 1:
                return a, b
    found = minimize(misfit, [0.5, 0.5], bounds=[(0, 1), (0, 1)])
    return float(found.x[0]), float(found.x[1])
