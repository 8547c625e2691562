"""The body that a pattern was drafted for, and the garment that the pattern makes on it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

from swifttailor.body import Body
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.garment_sewer.to_scale import sewer_for
from swifttailor.pattern import Pattern


def sewn_on(body: Body, edge_length: float) -> Callable[[Pattern], Garment]:
    """What sews patterns on a body: the package's own network.

    Args:
        body: Who wears them.
        edge_length: Of the mesh, cm.
    """
    sewer = _sewer() if body is Body.default() else sewer_for(_sewer(), body)
    return lambda pattern: sewer.sew(pattern, edge_length=edge_length)


@cache
def _sewer() -> GarmentSewer:
    return GarmentSewer.load()
