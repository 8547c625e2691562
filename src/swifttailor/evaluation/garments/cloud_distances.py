"""Distances between two point clouds: Chamfer and earth mover's. Definitions: docs/evaluation.md."""

from __future__ import annotations

from swifttailor.arrays import Floats
from swifttailor.errors import GeometryError
from swifttailor.evaluation.garments.point_cloud import PointCloud

_FIRST_PART = 250
_GROWTH = 3


def chamfer(a: PointCloud, b: PointCloud) -> float:
    """Chamfer distance: mean squared distance to the nearest point of the other cloud, both ways added up.

    In the squared unit of the points. This is the sum of both means, without a root, as point cloud
    generation has it (Luo and Hu 2021, code; Achlioptas et al. 2018).
    """
    return float((_nearest(a, b) ** 2).mean() + (_nearest(b, a) ** 2).mean())


def surface_distance(a: PointCloud, b: PointCloud) -> float:
    """Mean distance to the nearest point of the other cloud, the mean of both ways."""
    return float(_nearest(a, b).mean() + _nearest(b, a).mean()) / 2


def earth_mover(a: PointCloud, b: PointCloud) -> float:
    """Earth mover's distance: mean length of the moves that turn one cloud into the other, at the least.

    Exact, by an optimal assignment (Crouse 2016): 2,048 points take about half a second. In the unit of the
    points, not squared.

    Raises:
        GeometryError: The clouds differ in size.
    """
    from scipy.optimize import linear_sum_assignment
    from scipy.spatial.distance import cdist

    if len(a.points) != len(b.points):
        raise GeometryError(
            f"The earth mover's distance is between clouds of one size, got {len(a.points)} and "
            f"{len(b.points)} points."
        )
    lengths = cdist(a.points, b.points)
    return float(lengths[linear_sum_assignment(lengths)].mean())


def chamfer_below(a: PointCloud, b: PointCloud, limit: float) -> tuple[float, bool]:
    """The Chamfer distance where it is below a limit.

    Points are gone through part by part. What the first of them add is the least that the distance can be, so
    that clouds far apart are told from a few points.

    Returns:
        The distance and True; or something from `limit` up to the distance, and False.
    """
    least = 0.0
    ways = [(a, b), (b, a)]
    done, step = 0, _FIRST_PART
    longest = max(len(a.points), len(b.points))
    while done < longest:
        for one, other in ways:
            part = one.points[done : done + step]
            if len(part):
                least += float((other.tree.query(part)[0] ** 2).sum()) / len(one.points)
        done += step
        step = done * (_GROWTH - 1)
        if least >= limit:
            return least, False
    return least, True


def _nearest(a: PointCloud, b: PointCloud) -> Floats:
    """(n,) distance of each point of `a` to the nearest of `b`."""
    return b.tree.query(a.points)[0]
