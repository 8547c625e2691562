"""The same pattern in several sizes, its pieces laid over each other as printed patterns have them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import InputError
from swifttailor.making.piece import Piece
from swifttailor.making.pieces import CuttingPlan
from swifttailor.pattern import Pattern
from swifttailor.pattern.trims import trims_that_fit

MOST_SIZES = 12
Alike = set[frozenset[str]]
"""Sets of panels that may be cut as one piece."""


@dataclass(frozen=True, eq=False)
class NestedPiece:
    """A piece in all sizes."""

    pieces: tuple[Piece, ...]
    """In the order of the sizes."""
    shifts: tuple[Floats, ...]
    """(2,) each: what is added to a size's points so that they lie over the others'."""

    def middle(self, number: int) -> tuple[Piece, Floats]:
        """The piece of the size of that number, and its shift."""
        return self.pieces[number], self.shifts[number]


@dataclass(frozen=True, eq=False)
class SizeRun:
    """Cutting plans of one pattern in several sizes."""

    sizes: tuple[str, ...]
    """Their names, the smallest first."""
    plans: tuple[CuttingPlan, ...]
    nested: tuple[NestedPiece, ...]

    @property
    def base(self) -> int:
        """Number of the size in the middle, whose names, numbers and steps are printed."""
        return len(self.sizes) // 2

    @property
    def name(self) -> str:
        """Of the pattern."""
        return self.plans[self.base].name


def size_run(
    patterns: Sequence[tuple[str, Pattern]], cut: Callable[[Pattern, Alike | None], CuttingPlan]
) -> SizeRun:
    """Lays sizes over each other.

    Args:
        patterns: Name of each size and its pattern. They have the same panels, as `refitting` leaves them.
        cut: Makes the pieces of a pattern, with the sets of panels that may be one piece.

    Raises:
        InputError: There are too few or too many, two have one name, or they are not the same pattern.
    """
    if not 2 <= len(patterns) <= MOST_SIZES:
        raise InputError(
            f"{len(patterns)} sizes were given; 2 to {MOST_SIZES} go into one file. Make a run of sizes: "
            "swifttailor fit PATTERN --sizes 36-46 --out DIR"
        )
    sizes = [size for size, _ in patterns]
    if len(set(sizes)) < len(sizes):
        raise InputError(f"Two sizes have the same name. Names were: {', '.join(sizes)}.")
    panels = [{panel.name for panel in pattern.panels} for _, pattern in patterns]
    if any(own != panels[0] for own in panels):
        raise InputError(
            "These are not sizes of one pattern: their panels have other names. Make a run of sizes: "
            "swifttailor fit PATTERN --sizes 36-46 --out DIR"
        )
    # A pocket that one size has no room for is on none, so that all have the same pieces.
    fit = [set(trims_that_fit(pattern, pattern.trims)) for _, pattern in patterns]
    shared = tuple([name for name in patterns[0][1].trims if all(name in own for own in fit)])
    patterns = [(size, replace(pattern, trims=shared)) for size, pattern in patterns]
    # What is cut as one piece in some sizes alone is cut apart in all.
    alike = _common([cut(pattern, None) for _, pattern in patterns])
    plans = [(size, cut(pattern, alike)) for size, pattern in patterns]
    base = plans[len(plans) // 2][1]
    nested = []
    for piece in base.pieces:
        own = [_same_piece(piece, size, plan) for size, plan in plans]
        if len({one.on_fold for one in own}) > 1:  # on the fold in all sizes or in none
            own = [replace(one, symmetric=False) for one in own]
        nested.append(NestedPiece(tuple(own), tuple(_shift(piece, one) for one in own)))
    return SizeRun(tuple(sizes), tuple(plan for _, plan in plans), tuple(nested))


def size_names(titles: Sequence[str]) -> list[str]:
    """Short names of sizes: ``36`` for ``women EU 36``, where that is enough to tell them apart."""
    words = [title.replace("-", " ").replace("_", " ").split() or [title] for title in titles]
    short = [" ".join(w for w in own if not all(w in other for other in words)) or own[-1] for own in words]
    return short if len(set(short)) == len(short) else [" ".join(own) for own in words]


def size_order(title: str) -> tuple[float, str]:
    """Sorts sizes: letters from XXS to XXL, else by their number."""
    letters = {"XXS": -3, "XS": -2, "S": -1, "M": 0, "L": 1, "XL": 2, "XXL": 3, "3XL": 4}
    last = re.split(r"[\s_-]+", title.strip())[-1].upper()
    if last in letters:
        return float(letters[last]), title
    number = re.search(r"\d+(?:\.\d+)?", last)
    return (float(number.group()) if number else 0.0), title


def _common(plans: Sequence[CuttingPlan]) -> Alike:
    """Sets of panels that are one piece in all plans."""
    found: Alike = {frozenset(_panels(piece)) for piece in plans[0].pieces}
    for plan in plans[1:]:
        own = [_panels(piece) for piece in plan.pieces]
        found = {part for known in found for one in own if (part := known & one)}
    return found


def _panels(piece: Piece) -> frozenset[str]:
    return frozenset((*piece.panels, *piece.mirrored))


def _same_piece(piece: Piece, size: str, plan: CuttingPlan) -> Piece:
    found = next((own for own in plan.pieces if _panels(own) == _panels(piece)), None)
    panels = ", ".join((*piece.panels, *piece.mirrored))
    if found is None:
        raise InputError(
            f"Size {size} is not cut like the others: it has no piece of the panels {panels}. "
            "Convert it by itself."
        )
    if len(found.runs) != len(piece.runs) and not piece.trim:
        raise InputError(
            f"Size {size} is not cut like the others: its piece of the panels {panels} has {len(found.runs)} "
            f"edges and that of the middle size {len(piece.runs)}, as where a dart comes or goes. Convert it "
            "by itself, or make the sizes from one pattern: swifttailor fit PATTERN --sizes 36-46 --out DIR"
        )
    return replace(found, size=size, panels=piece.panels, mirrored=piece.mirrored)


def _shift(piece: Piece, other: Piece) -> Floats:
    """Puts the corners over each other, and the fold on the fold; of what is put on, the middles."""
    if piece.trim:
        return piece.box.mean(axis=0) - other.box.mean(axis=0)
    corners, own = (np.array([run.points[0] for run in p.runs]) for p in (piece, other))
    shift = corners.mean(axis=0) - own.mean(axis=0)
    if piece.on_fold and other.on_fold:
        shift[0] = piece.middle - other.middle
    return shift
