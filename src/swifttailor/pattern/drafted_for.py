"""Which body a pattern was drafted for, as its file says it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from swifttailor.errors import PatternError
from swifttailor.pattern.json_values import as_number

_LONGEST_NAME = 200
_MOST_MEASURES = 100
_MESH = re.compile(r"[0-9a-f]{32}")


@dataclass(frozen=True)
class DraftedFor:
    """A body by what it was made from: a figure and measures."""

    name: str
    """For people: ``women EU 44``, or the name of a file."""
    figure: str | None = None
    """``women``, ``men`` or ``children``; None for the adult about the default body."""
    measures: tuple[tuple[str, float], ...] = ()
    """Names and cm."""
    mesh: str | None = None
    """Hash of the body's mesh, where the studio keeps one; elsewhere the measures count."""

    def to_json(self) -> dict[str, Any]:
        """For the properties of a pattern file."""
        of_mesh = {} if self.mesh is None else {"mesh": self.mesh}
        return {"name": self.name, "figure": self.figure, "measures": dict(self.measures), **of_mesh}

    @classmethod
    def from_json(cls, raw: Any) -> DraftedFor | None:
        """Reads what `to_json` has written; None where there is nothing.

        Raises:
            PatternError: It is something else.
        """
        if raw is None:
            return None
        good = isinstance(raw, Mapping) and isinstance(raw.get("name"), str)
        figure = raw.get("figure") if good else None
        measures = raw.get("measures", {}) if good else None
        mesh = raw.get("mesh") if good else None
        if (
            not good
            or not isinstance(figure, str | None)
            or not isinstance(measures, Mapping)
            or len(measures) > _MOST_MEASURES
            or not (mesh is None or (isinstance(mesh, str) and _MESH.fullmatch(mesh)))
            or not all(isinstance(k, str) and _is_length(v) for k, v in measures.items())
        ):
            raise PatternError(
                "properties.drafted_for: an object with a name, a figure and measures in cm was expected. "
                "Remove it, and the pattern counts as drafted for the default body."
            )
        return cls(
            raw["name"][:_LONGEST_NAME], figure, tuple((k, float(v)) for k, v in measures.items()), mesh
        )


def _is_length(value: Any) -> bool:
    try:
        as_number(value, "a measure")
    except PatternError:
        return False
    return True
