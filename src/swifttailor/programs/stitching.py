"""Stitches between interfaces: edges are split until both sides have the same number of matching ones."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from swifttailor.pattern import EdgeRef, Stitch
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edges import close_enough
from swifttailor.programs.interface import Interface

MATCHING = 0.05
"""Fractions of a seam that differ by less are sewn to each other as they are."""


class StitchingRule:
    """Two interfaces that are sewn together, edge by edge in their order."""

    def __init__(self, int1: Interface, int2: Interface) -> None:
        """Connects two interfaces; splits edges of their panels where the sides do not match."""
        self.int1 = int1
        self.int2 = int2
        if not self.is_matching():
            self.match_interfaces()

    def is_matching(self) -> bool:
        """Whether both sides have as many edges, with about the same fractions."""
        first, second = self.int1.projecting_fractions(), self.int2.projecting_fractions()
        # numpy.allclose, as GarmentCode asks it, also allows for 1e-5 of the second value.
        return len(first) == len(second) and all(
            abs(a - b) <= MATCHING + 1e-5 * abs(b) for a, b in zip(first, second, strict=True)
        )

    def match_interfaces(self) -> None:
        """Splits edges on both sides at the vertices of the other."""
        first, second = self.int1.projecting_fractions(), self.int2.projecting_fractions()
        tolerance = min(1e-2, min(*first, *second) / 2)
        _match_to_fractions(self.int1, second, tolerance)
        _match_to_fractions(self.int2, first, tolerance)

    def assembly(self) -> list[Stitch]:
        """The stitches by panel and edge."""
        one, two = self.int1, self.int2
        return [
            Stitch(
                EdgeRef(one.panel[k].name, one.edges[k].geometric_id),
                EdgeRef(two.panel[k].name, two.edges[k].geometric_id),
                one.right_wrong[k] or two.right_wrong[k],
            )
            for k in range(min(len(one), len(two)))
        ]


class Stitches:
    """All rules of a component."""

    def __init__(self, *pairs: tuple[Interface, Interface]) -> None:
        """Connects each pair of interfaces, in order."""
        self.rules = [StitchingRule(*pair) for pair in pairs]

    def append(self, pair: tuple[Interface, Interface]) -> None:
        """Connects two more interfaces."""
        self.rules.append(StitchingRule(*pair))

    def __getitem__(self, i: int) -> StitchingRule:
        return self.rules[i]

    def assembly(self) -> Iterable[Stitch]:
        """The stitches by panel and edge."""
        return [stitch for rule in self.rules for stitch in rule.assembly()]


def _match_to_fractions(inter: Interface, to_add: Sequence[float], tolerance: float) -> None:
    """Splits edges of an interface so that it has vertices after the given fractions of the seam.

    Args:
        inter: The interface; its panels change too.
        to_add: Fractions of the other side, edge by edge.
        tolerance: Vertices closer than this are the same one.
    """
    add_id = in_id = 0
    covered_init = covered_added = 0.0
    fractions = inter.projecting_fractions()
    while in_id < len(inter.edges) and add_id < len(to_add):
        next_init = min(covered_init + fractions[in_id], 1.0)
        next_added = min(covered_added + to_add[add_id], 1.0)
        if close_enough(next_init, next_added, tolerance):
            in_id, add_id = in_id + 1, add_id + 1
            covered_init, covered_added = next_init, next_added
        elif next_init < next_added:
            in_id += 1
            covered_init = next_init
        else:
            whole = fractions[in_id]
            _split(inter, in_id, (whole - (next_init - next_added)) / whole)
            fractions = inter.projecting_fractions()
            covered_init += fractions[in_id]
            covered_added = next_added
            in_id, add_id = in_id + 1, add_id + 1
    if add_id != len(to_add):
        names = ", ".join(dict.fromkeys(panel.name for panel in inter.panel))
        raise DesignError(
            f"The seam at {names} cannot be divided like its partner ({len(to_add)} edges). "
            "Change the parameters of the parts that meet there."
        )


def _split(inter: Interface, i: int, fraction: float) -> None:
    """Splits the i-th edge of an interface, in its panel too, after a fraction of its length."""
    edge, panel = inter.edges[i], inter.panel[i]
    flip = inter.needs_flipping(i)
    if flip:
        fraction = 1 - fraction
    parts = edge.subdivide_len([fraction, 1 - fraction])
    panel.edges.substitute(edge, parts)
    inter.substitute(edge, parts[::-1] if flip else parts, [panel] * len(parts))
