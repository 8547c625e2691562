"""A whole sewing pattern: panels and the stitches between their edges (paper, Sec. 3.1)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from swifttailor.errors import PatternError
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.names import canonical_key
from swifttailor.pattern.panel import Panel, RotationReading


class EdgeRef(NamedTuple):
    """Names one edge of one panel."""

    panel: str
    edge: int


@dataclass(frozen=True)
class Stitch:
    """A pairing of two edges.

    A plain stitch joins start to end and end to start (right side to right side of the cloth);
    a ``right_wrong`` stitch joins start to start and end to end.
    """

    first: EdgeRef
    second: EdgeRef
    right_wrong: bool = False

    @property
    def sides(self) -> tuple[EdgeRef, EdgeRef]:
        """Both edges."""
        return self.first, self.second


@dataclass(frozen=True)
class Pattern:
    """Panels and stitches of one garment, in cm."""

    panels: tuple[Panel, ...]
    stitches: tuple[Stitch, ...] = ()
    name: str = field(default="pattern", compare=False)
    drafted_for: DraftedFor | None = field(default=None, compare=False)
    """The body that it was drafted for; the default body when None."""
    cloth_stretch: float = field(default=0.0, compare=False)
    """Share by which the cloth has to give all around, since it is cut smaller than the body; 0 for any."""
    trims: tuple[str, ...] = field(default=(), compare=False)
    """Pockets, buttons, belts and the like that are put on it, by the names of `trims.TRIMS`."""
    button_count: int = field(default=0, compare=False)
    """How many buttons close its front, 1 to 20; 0 for as many as its length needs."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "panels", tuple(self.panels))
        object.__setattr__(self, "stitches", tuple(self.stitches))
        names = [p.name for p in self.panels]
        if len(set(names)) != len(names):
            twice = sorted({n for n in names if names.count(n) > 1})
            raise PatternError(f"Panel names must be unique, got {twice[0]!r} more than once. Rename one.")

    @cached_property
    def _index(self) -> dict[str, int]:
        return {p.name: k for k, p in enumerate(self.panels)}

    def panel_index(self, name: str) -> int:
        """Position of a panel in `panels`.

        Raises:
            PatternError: There is no such panel.
        """
        if name not in self._index:
            known = ", ".join(self._index) or "none"
            raise PatternError(f"There is no panel named '{name}'. The panels are: {known}.")
        return self._index[name]

    def panel(self, name: str) -> Panel:
        """The panel of that name (raises `PatternError` when there is none)."""
        return self.panels[self.panel_index(name)]

    def has_edge(self, ref: EdgeRef) -> bool:
        """Whether `ref` names an edge of this pattern."""
        return ref.panel in self._index and 0 <= ref.edge < len(self.panel(ref.panel).edges)

    def edge_length(self, ref: EdgeRef) -> float:
        """Arc length of an edge, cm."""
        return self.panel(ref.panel).edge_length(ref.edge)

    def canonical(self) -> Pattern:
        """The same pattern in canonical order.

        Panels follow `names.PANEL_NAMES`, unknown names after them in natural order; each stitch starts
        with its earlier edge and stitches are sorted, so that equal patterns compare and hash equal
        whatever order their file had. Edge ids and vertices stay as they are.
        """
        panels = tuple(sorted(self.panels, key=lambda p: canonical_key(p.name)))
        rank = {p.name: k for k, p in enumerate(panels)}

        def key(ref: EdgeRef) -> tuple[int, str, int]:
            return rank.get(ref.panel, len(rank)), ref.panel, ref.edge

        stitches = []
        for s in self.stitches:
            first, second = sorted(s.sides, key=key)
            stitches.append(Stitch(first, second, s.right_wrong))
        stitches.sort(key=lambda s: (key(s.first), key(s.second), s.right_wrong))
        return replace(self, panels=panels, stitches=tuple(stitches))

    def components(self) -> list[tuple[str, ...]]:
        """Groups of panel names that stitches hold together, each in pattern order."""
        parent = {p.name: p.name for p in self.panels}

        def find(name: str) -> str:
            while parent[name] != name:
                parent[name] = parent[parent[name]]
                name = parent[name]
            return name

        for s in self.stitches:
            if s.first.panel in parent and s.second.panel in parent:
                parent[find(s.first.panel)] = find(s.second.panel)
        groups: dict[str, list[str]] = {}
        for p in self.panels:
            groups.setdefault(find(p.name), []).append(p.name)
        return [tuple(g) for g in groups.values()]

    def with_rotation_reading(self, reading: RotationReading) -> Pattern:
        """The same numbers, with the placement angles read the given way (see `Placement.reading`)."""
        panels = tuple(replace(p, placement=replace(p.placement, reading=reading)) for p in self.panels)
        return replace(self, panels=panels)

    def save(self, path: Path | str, *, overwrite: bool = False) -> Path:
        """Writes the pattern as GarmentCode JSON and returns the path.

        Raises:
            InputError: It cannot be written, or there is another file of that name and not `overwrite`.
        """
        from swifttailor.pattern.garmentcode_writer import write_pattern

        return write_pattern(self, path, overwrite=overwrite)
