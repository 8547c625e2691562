"""Loops for a belt, and the stitches and seams that denim is told by, which no word asks for."""

from __future__ import annotations

from collections.abc import Iterator

_DENIM = "denim"
_LOWER = ("trousers", "shorts", "skirt")
_LOOPED = frozenset({"trousers", "jeans", "flares"})
"""Drafts whose waistbands lie flat, so that a belt may be drawn through loops."""
_JACKET = "denim-jacket"


def loops_and_stitches(
    kind: str, draft: str, *, cloth: str | None, own: tuple[str, ...]
) -> Iterator[tuple[str, tuple[str, ...]]]:
    """What stands for each, a key of `TRIMS_OF`, and the trims that it is, best first.

    Args:
        kind: Of the garment.
        draft: That it is cut from; empty where it is cut from none.
        cloth: Of the garment, as it was heard.
        own: Trims that the text or the name of the garment has besides.
    """
    is_denim = cloth == _DENIM
    elastic = not {"elastic waist", "back elastic", "drawstring"}.isdisjoint(own)
    flat = draft in _LOOPED and "fly" in own
    if (
        kind in _LOWER
        and not elastic
        and (flat or (is_denim and draft in (*_LOOPED, "", "circle-skirt", "fitted-skirt")))
    ):
        yield "belt_loops", ("belt loops",)
    if is_denim:
        yield "topstitching", ("topstitching",)
    if is_denim and draft == _JACKET:
        yield "denim_seams", ("denim seams",)
