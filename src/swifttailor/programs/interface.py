"""An interface: the edges of panels at which something else may be sewn on, as one unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edges import Edge, Vertex, close_enough

if TYPE_CHECKING:
    from swifttailor.programs.panel import Panel


@dataclass
class Ruffle:
    """How much longer than its partner a stretch of an interface is: edges `first` to `last` - 1."""

    coeff: float
    first: int
    last: int

    @property
    def gathers(self) -> bool:
        """Whether the stretch is not sewn on as long as it is."""
        return not close_enough(self.coeff, 1.0, 1e-3)


class Interface:
    """Edges of one or several panels, their order and direction, and how they are gathered."""

    def __init__(
        self,
        panel: Panel,
        edges: Edge | EdgeSequence,
        ruffle: float | Sequence[float] = 1.0,
        right_wrong: bool = False,
    ) -> None:
        """Makes the interface of one panel; `ruffle` may be given edge by edge.

        ``right_wrong``: the right side of the cloth lies on the wrong side of the partner.
        """
        self.edges = edges if isinstance(edges, EdgeSequence) else EdgeSequence(edges)
        count = len(self.edges)
        self.panel = [panel] * count
        self.right_wrong = [right_wrong] * count
        self.edges_flipping = [False] * count
        self.ruffle: list[Ruffle] = []
        for i, coeff in enumerate([ruffle] * count if isinstance(ruffle, int | float) else ruffle):
            if self.ruffle and self.ruffle[-1].coeff == coeff:
                self.ruffle[-1].last = i + 1
            else:
                self.ruffle.append(Ruffle(coeff, i, i + 1))

    @classmethod
    def from_multiple(cls, *interfaces: Interface) -> Interface:
        """One interface of several, in the given order."""
        new = cls.__new__(cls)
        new.edges = EdgeSequence()
        new.panel, new.right_wrong, new.edges_flipping, new.ruffle = [], [], [], []
        for each in interfaces:
            shift = len(new.edges)
            new.ruffle += [replace(r, first=r.first + shift, last=r.last + shift) for r in each.ruffle]
            new.edges.append(each.edges)
            new.panel += each.panel
            new.right_wrong += each.right_wrong
            new.edges_flipping += each.edges_flipping
        return new

    def __len__(self) -> int:
        return len(self.edges)

    # lengths and shapes that a partner should have

    def projecting_lengths(self) -> list[float]:
        """The length that each edge takes of its partner, cm."""
        lengths: list[float] = []
        for r in self.ruffle:
            by = r.coeff if r.gathers else 1.0
            lengths += [e.length() / by for e in self.edges[r.first : r.last]]
        return lengths

    def projecting_fractions(self) -> list[float]:
        """The part of the whole seam that each edge takes."""
        lengths = self.projecting_lengths()
        total = sum(lengths)
        return [length / total for length in lengths]

    def projecting_edges(self, on_oriented: bool = False) -> EdgeSequence:
        """Copies of the edges, shortened to what they take of a partner."""
        projected = self.oriented_edges() if on_oriented else self.edges.copy()
        for r in self.ruffle:
            if not r.gathers:
                continue
            stretch = projected[r.first : r.last]
            if r.last >= len(projected) or not projected[r.last - 1 : r.last + 1].is_chained():
                stretch.extend(1 / r.coeff)
            else:
                _extend_before(stretch, projected[r.last :], 1 / r.coeff)
        return projected

    def oriented_edges(self) -> EdgeSequence:
        """Copies of the edges, all in the direction of the interface."""
        oriented = self.edges.copy()
        for edge, flip in zip(oriented, self.edges_flipping, strict=True):
            edge.flipped = flip
            if flip:
                edge.reverse()
        return oriented

    def needs_flipping(self, i: int) -> bool:
        """Whether the i-th edge runs against the interface."""
        return self.edges_flipping[i]

    def bbox_3d(self) -> tuple[list[float], list[float]]:
        """Least and largest x, y and z of the placed edges, cm."""
        points: list[list[float]] = []
        for edge, panel in zip(self.edges, self.panel, strict=True):
            points += [panel.point_to_3d(v) for v in _points_of(edge)]
        return [min(c) for c in zip(*points, strict=True)], [max(c) for c in zip(*points, strict=True)]

    # changes; all return the interface

    def reverse(self, with_edge_dir_reverse: bool = False) -> Interface:
        """Lists the edges the other way round and, on request, turns their direction too."""
        self.edges.edges.reverse()
        self.panel.reverse()
        self.edges_flipping.reverse()
        if with_edge_dir_reverse:
            self.flip_edges()
        count = len(self.edges)
        for r in self.ruffle:
            r.first, r.last = count - r.last, count - r.first
        return self

    def flip_edges(self) -> Interface:
        """Turns the direction of all edges."""
        self.edges_flipping = [not flip for flip in self.edges_flipping]
        return self

    def reorder(self, curr_edge_ids: Sequence[int], projected_edge_ids: Sequence[int]) -> Interface:
        """Puts edges in other places of the same stretches: place `curr[k]` gets edge `projected[k]`."""
        ids = list(range(len(self.edges)))
        for place, source in zip(curr_edge_ids, projected_edge_ids, strict=True):
            ids[place] = source
        self.edges = EdgeSequence([self.edges[i] for i in ids])
        self.panel = [self.panel[i] for i in ids]
        self.edges_flipping = [self.edges_flipping[i] for i in ids]
        self.right_wrong = [self.right_wrong[i] for i in ids]
        return self

    def substitute(
        self, orig: int | Edge, new_edges: Edge | EdgeSequence | Sequence[Edge], new_panels: Sequence[Panel]
    ) -> Interface:
        """Puts edges in the place of one, with the panel of each; they are gathered like the one."""
        i = self.edges.index(orig) if isinstance(orig, Edge) else orig % len(self.edges)
        self.edges.substitute(i, new_edges)
        count = len(new_panels)
        self.panel[i : i + 1] = list(new_panels)
        self.edges_flipping[i : i + 1] = [self.edges_flipping[i]] * count
        self.right_wrong[i : i + 1] = [self.right_wrong[i]] * count
        more = (1 if isinstance(new_edges, Edge) else len(new_edges)) - 1
        for r in self.ruffle:
            r.first += more if r.first > i else 0
            r.last += more if r.last > i else 0
        return self

    def set_right_wrong(self, right_wrong: bool) -> Interface:
        """Says of all edges whether the right side of the cloth lies on the wrong side of the partner."""
        self.right_wrong = [right_wrong] * len(self.edges)
        return self


def _points_of(edge: Edge) -> list[Vertex]:
    return [edge.start, *edge.points_inside(), edge.end]


def _extend_before(stretch: EdgeSequence, rest: EdgeSequence, factor: float) -> None:
    """Stretches edges and moves those that follow in the chain along, undistorted."""
    last, following = stretch[-1], rest[0]
    at_end = last.end is following.end or last.end is following.start
    common = last.end if at_end else last.start
    own = list(common)
    to_its_end = common is following.end
    if to_its_end:
        following.end = own
    else:
        following.start = own
    stretch.extend(factor)
    rest.translate_by((common[0] - own[0], common[1] - own[1]))
    if to_its_end:
        following.end = common
    else:
        following.start = common
