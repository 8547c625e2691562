"""A reader of DXF of cutting rooms, made from the format's description alone."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Entity:
    """Groups by their code, the first of each."""

    kind: str
    groups: dict[int, str] = field(default_factory=dict)
    points: list[tuple[float, float]] = field(default_factory=list)
    """Of the vertices of a polyline."""

    @property
    def layer(self) -> int:
        """Its number."""
        return int(self.groups[8])

    @property
    def at(self) -> tuple[float, float]:
        """Its first point."""
        return float(self.groups[10]), float(self.groups[20])

    @property
    def text(self) -> str:
        """What it says."""
        return self.groups[1]


@dataclass
class Block:
    """A name and what stands in it."""

    name: str
    entities: list[Entity] = field(default_factory=list)

    def on(self, layer: int, kind: str) -> list[Entity]:
        """Entities of a kind on a layer."""
        return [e for e in self.entities if e.layer == layer and e.kind == kind]

    def outline(self, layer: int) -> np.ndarray:
        """The only, closed polyline (n, 2) on a layer."""
        (line,) = self.on(layer, "POLYLINE")
        assert line.groups[70] == "1", "the outline is open"
        return np.array(line.points)

    def texts(self, layer: int) -> dict[str, str]:
        """What stands before and after the first colon."""
        return dict(e.text.split(":", 1) for e in self.on(layer, "TEXT") if ":" in e.text)


def read_dxf(content: str) -> tuple[dict[str, Block], Block]:
    """Blocks by name, and what stands outside of them."""
    lines = content.split("\r\n")
    assert lines[-1] == "" and len(lines) % 2 == 1
    pairs = [(int(code), value) for code, value in zip(lines[:-1:2], lines[1::2], strict=True)]
    assert pairs[-1] == (0, "EOF")
    blocks: dict[str, Block] = {}
    free = Block("")
    current, entity, polyline = free, Entity(""), None
    for code, value in pairs:
        if code != 0:
            entity.groups.setdefault(code, value)
            if entity.kind == "BLOCK" and code == 2:
                assert value not in blocks, "a block is there twice"
                current = blocks[value] = Block(value)
            continue
        if entity.kind == "VERTEX" and polyline is not None:
            polyline.points.append(entity.at)
        entity = Entity(value)
        if value == "ENDBLK":
            current = free
        elif value == "SEQEND":
            polyline = None
        elif value not in ("VERTEX", "SECTION", "ENDSEC", "BLOCK", "EOF"):
            current.entities.append(entity)
            polyline = entity if value == "POLYLINE" else polyline
    return blocks, free
