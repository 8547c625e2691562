"""Draws design parameters of garments that shops sell, from the tables in ``scripts/archetypes``.

A folder of YAML files. ``shared.yaml`` has parts, named groups of parameters that several garments share
("crew neck", "long sleeves"); each other file is a family: a list of archetypes with

name    what a shop calls it
also    other names that captions may use; not even one is needed
share   how often it comes compared to others; 1 without it
take    parts, later ones winning; {part: weight, part: weight} takes one of them
design  parameters of its own, over those of its parts

A parameter ("sleeve.length") is one value, or [low, high], or [low, most often, high], or {value: weight}.
What is not named keeps GarmentCode's default, so that inert parameters stay the same. Both sides are alike,
unless a garment says ``left.enable_asym: true``: then the left has the right's values but for what is named.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

SHARED = "shared.yaml"
SIDE = "left."
KEYS = {"name", "also", "share", "take", "design"}

Values = dict[str, Any]


@dataclass(frozen=True)
class Archetype:
    """A garment that shops sell, and the spread of its design parameters.

    Attributes:
        name: What it is called, in words that captions may use.
        family: The file it stands in ("dresses").
        also: Other names of the same garment.
        share: How often it is drawn compared to others.
        take: One entry a part: a dict of the parts to choose from, each with its own values, and weights.
        design: Parameters of its own, over those of its parts.
    """

    name: str
    family: str
    also: tuple[str, ...]
    share: float
    take: tuple[tuple[tuple[Values, ...], tuple[float, ...]], ...]
    design: Values

    def draw(self) -> Values:
        """Flat parameters of one garment, by the state of Python's ``random``."""
        values: Values = {}
        for parts, weights in self.take:
            values |= random.choices(parts, weights)[0]
        return {path: draw_value(value) for path, value in (values | self.design).items()}

    def spreads(self) -> list[tuple[str, Any]]:
        """Every parameter it may set and the spread it may have, once a part that names it."""
        of_parts = [pair for parts, _ in self.take for part in parts for pair in part.items()]
        return [*of_parts, *self.design.items()]


def read_archetypes(folder: Path) -> list[Archetype]:
    """The archetypes of a folder, families by name, each in the order of its file.

    Raises:
        ValueError: If a part is not in shared.yaml, a name comes twice, or an entry is not understood.
    """
    parts = yaml.safe_load((folder / SHARED).read_text(encoding="utf-8"))
    archetypes = [
        _archetype(entry, file.stem, parts)
        for file in sorted(folder.glob("*.yaml"))
        if file.name != SHARED
        for entry in yaml.safe_load(file.read_text(encoding="utf-8"))
    ]
    names = [archetype.name.casefold() for archetype in archetypes]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise ValueError(f"{folder}: names that come twice: {', '.join(twice)}")
    return archetypes


def _archetype(entry: dict[str, Any], family: str, parts: dict[str, Values]) -> Archetype:
    where = f"{family}.yaml: {entry.get('name', entry)}"
    if "name" not in entry:
        raise ValueError(f"{where}: an archetype needs a name")
    if strange := entry.keys() - KEYS:
        raise ValueError(f"{where}: has {sorted(strange)}; an archetype may have {sorted(KEYS)}")
    take = []
    for choice in entry.get("take", ()):
        weights = choice if isinstance(choice, dict) else {choice: 1}
        if unknown := weights.keys() - parts.keys():
            raise ValueError(f"{where}: {SHARED} has no part named {', '.join(sorted(unknown))}")
        take.append((tuple(parts[part] for part in weights), tuple(weights.values())))
    return Archetype(
        entry["name"],
        family,
        tuple(entry.get("also", ())),
        entry.get("share", 1),
        tuple(take),
        entry.get("design", {}),
    )


def draw_value(spread: Any) -> Any:
    """One value of a spread: fixed, between bounds, most often somewhere between them, or one of some."""
    if isinstance(spread, dict):
        return random.choices([*spread], [*spread.values()])[0]
    if not isinstance(spread, list):
        return spread
    low, high = spread[0], spread[-1]
    value = random.triangular(low, high, spread[1]) if len(spread) == 3 else random.uniform(low, high)
    return round(value) if all(isinstance(bound, int) for bound in spread) else round(value, 3)


def complete(values: Values, defaults: Values) -> Values:
    """All of GarmentCode's flat parameters: those drawn, the left side like the right, defaults for the rest.

    Raises:
        KeyError: If GarmentCode has no such parameter.
    """
    if unknown := values.keys() - defaults.keys():
        raise KeyError(f"GarmentCode has no design parameter {', '.join(sorted(unknown))}")
    design = defaults | values
    if design["left.enable_asym"]:
        for path in defaults:
            right = path.removeprefix(SIDE)
            if path.startswith(SIDE) and right in defaults and path not in values:
                design[path] = design[right]
    return design
