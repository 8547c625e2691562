"""Sewing a pattern without saying who sews: the package's own networks, loaded once."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from swifttailor.pattern import Pattern
from swifttailor.tailor.tailor import Tailor
from swifttailor.tailor.tailored import Tailored


def sew(
    pattern: Pattern | Path | str,
    *,
    edge_length: float = 2.0,
    finish: bool = False,
    relax: bool = True,
    repair: bool = False,
) -> Tailored:
    """Makes the garment of a pattern with the package's own network, on the default body.

    ``Tailor(...).sew`` does the same with other weights, another body or another network.

    Args:
        pattern: A pattern, or a GarmentCode JSON file.
        edge_length: Of the mesh, cm.
        finish: Whether it hangs to rest by physics in the end.
        relax: Whether the cloth falls for a moment.
        repair: Whether it is mended first.

    Raises:
        InputError: An argument, the file or the weights cannot be used.
        PatternError: The pattern cannot be sewn.
    """
    return _tailor().sew(pattern, edge_length=edge_length, finish=finish, relax=relax, repair=repair)


@cache
def _tailor() -> Tailor:
    return Tailor.load()
