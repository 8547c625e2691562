"""Which corners of the panels the stitches bring together, and what would change if one ran the other way.

Sewn rightly, a garment never joins two corners of one panel except at the mouth of a dart (measured on
2,472 real patterns without exception; tubes made of a single panel do join theirs). A seam that runs the
wrong way joins extra ones: it would glue the two ends of some edge together. So the number of corners that
lose their own place on their panel, here called *collapses*, tells twisted seams from sound ones without
looking at the placement.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from swifttailor.pattern.pattern import EdgeRef, Pattern

Pair = tuple[int, int]

_MAX_LOCAL_PAIRS = 80


class SeamTopology:
    """Corners of a pattern, numbered through, and the classes in which the stitches join them.

    Attributes:
        panel_of: Panel index of every corner.
        reverse: For each stitch whether it is looked at the other way round than the pattern has it;
            change it with `flip`.
    """

    def __init__(self, pattern: Pattern, stitches: Sequence[int] | None = None) -> None:
        """Joins the corners of `pattern` by its stitches.

        Args:
            pattern: Any pattern.
            stitches: Those to use; all when None. They must name edges that exist.
        """
        self.pattern = pattern
        self._offset: dict[str, tuple[int, int]] = {}
        self.panel_of: list[int] = []
        for k, panel in enumerate(pattern.panels):
            self._offset[panel.name] = (len(self.panel_of), len(panel.edges))
            self.panel_of += [k] * len(panel.edges)
        chosen = range(len(pattern.stitches)) if stitches is None else stitches
        self.stitches = tuple(chosen)
        self.reverse = dict.fromkeys(self.stitches, False)
        self.class_of = list(range(len(self.panel_of)))
        self._corners_of_class: dict[int, list[int]] = {}
        self._pairs_of_class: dict[int, list[tuple[int, Pair]]] = {}
        self._join(self.class_of, [(s, pair) for s in self.stitches for pair in self.pairs(s)])

    def corners(self, ref: EdgeRef) -> Pair:
        """Numbers of the start and end corner of an edge."""
        first, count = self._offset[ref.panel]
        return first + ref.edge % count, first + (ref.edge + 1) % count

    def pairs(self, stitch: int, *, flipped: bool = False) -> tuple[Pair, Pair]:
        """The two pairs of corners that a stitch joins, or would join if it ran the other way."""
        s = self.pattern.stitches[stitch]
        (a0, a1), (b0, b1) = self.corners(s.first), self.corners(s.second)
        together = self.start_to_start(stitch) ^ flipped
        return ((a0, b0), (a1, b1)) if together else ((a0, b1), (a1, b0))

    def start_to_start(self, stitch: int) -> bool:
        """Whether a stitch, as it is looked at now, joins start to start."""
        return self.pattern.stitches[stitch].right_wrong ^ self.reverse[stitch]

    def collapses(self) -> int:
        """How many corners have lost their own place on their panel."""
        return len(self.panel_of) - len(set(zip(self.panel_of, self.class_of, strict=True)))

    def dart_count(self) -> int:
        """How many stitches join two edges of one panel; each accounts for one collapse."""
        chosen = (self.pattern.stitches[s] for s in self.stitches)
        return sum(s.first.panel == s.second.panel for s in chosen)

    def flip(self, stitches: Iterable[int]) -> None:
        """Runs some stitches the other way from now on; joins only the classes they touch anew."""
        turned = list(stitches)
        touched = {self.class_of[v] for s in turned for pair in self.pairs(s) for v in pair}
        corners = [v for c in touched for v in self._corners_of_class.pop(c)]
        affected = {s for c in touched for s, _ in self._pairs_of_class.pop(c, [])}
        for s in turned:
            self.reverse[s] = not self.reverse[s]
        inside = set(corners)
        self._join(corners, [(s, p) for s in affected for p in self.pairs(s) if p[0] in inside])

    def collapses_saved(self, stitches: Sequence[int]) -> int | None:
        """How many collapses fewer there would be if all of `stitches` ran the other way.

        Only the classes that these stitches touch are joined anew, so the cost does not grow with the
        pattern.

        Returns:
            Positive when the pattern would be sounder, negative when it would be less sound, None when the
            stitches join so many corners that the question has no sensible answer.
        """
        turned = set(stitches)
        touched = {self.class_of[v] for s in stitches for pair in self.pairs(s) for v in pair}
        if sum(len(self._pairs_of_class.get(c, ())) for c in touched) + 2 * len(stitches) > _MAX_LOCAL_PAIRS:
            return None
        kept = [(s, pair) for c in touched for s, pair in self._pairs_of_class.get(c, ())]
        before = self._collapses([pair for _, pair in kept])
        after = [pair for s, pair in kept if s not in turned]
        for s in stitches:
            after += self.pairs(s, flipped=True)
        return before - self._collapses(after)

    def touching(self, stitches: Iterable[int]) -> set[int]:
        """Stitches that share a class of corners with any of `stitches`; classes beyond sense left out."""
        classes = {self.class_of[v] for s in stitches for pair in self.pairs(s) for v in pair}
        members = (self._pairs_of_class.get(c, ()) for c in classes)
        return {s for pairs in members if len(pairs) <= _MAX_LOCAL_PAIRS for s, _ in pairs}

    def collapsed_edges(self) -> list[EdgeRef]:
        """Edges whose two ends the stitches join into one point."""
        found = []
        for panel in self.pattern.panels:
            for k in range(len(panel.edges)):
                a, b = self.corners(EdgeRef(panel.name, k))
                if self.class_of[a] == self.class_of[b]:
                    found.append(EdgeRef(panel.name, k))
        return found

    def _join(self, corners: Sequence[int], pairs: Sequence[tuple[int, Pair]]) -> None:
        """Finds the classes of `corners`, which `pairs` (with their stitches) join among themselves."""
        corners = list(corners)
        for v, c in zip(corners, _classes(corners, [pair for _, pair in pairs]), strict=True):
            self.class_of[v] = c
            self._corners_of_class.setdefault(c, []).append(v)
        for s, pair in pairs:
            self._pairs_of_class.setdefault(self.class_of[pair[0]], []).append((s, pair))

    def _collapses(self, pairs: Sequence[Pair]) -> int:
        """Corners that share both their panel and their class with an earlier one, over `pairs` alone."""
        corners = sorted({v for pair in pairs for v in pair})
        classes = _classes(corners, pairs)
        return len(corners) - len({(self.panel_of[v], c) for v, c in zip(corners, classes, strict=True)})


def _classes(corners: Sequence[int], pairs: Iterable[Pair]) -> list[int]:
    """One corner to stand for the class of each of `corners` after joining the pairs."""
    parent = {v: v for v in corners}

    def find(v: int) -> int:
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b in pairs:
        parent[find(a)] = find(b)
    return [find(v) for v in corners]
