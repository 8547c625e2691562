"""What a reader or a check has to say about a sewing pattern."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import StrEnum


class Severity(StrEnum):
    """How bad a finding is."""

    ERROR = "error"
    """The pattern cannot be sewn as it stands."""
    WARNING = "warning"
    """It can be sewn, but the result is probably not what was meant."""
    INFO = "info"
    """Worth knowing; nothing is wrong."""


@dataclass(frozen=True)
class Finding:
    """One observation about a pattern."""

    code: str
    """Stable kebab-case name, such as ``open-loop``; listed in docs/checks.md."""
    severity: Severity
    message: str
    """What was found, with the value."""
    panel: str = ""
    edge: int | None = None
    stitch: int | None = None
    value: float | str | None = None
    why: str = ""
    """Why it matters."""
    repair: str = ""
    """What mends it."""

    def where(self) -> str:
        """The place in words, such as ``skirt_front, edge 3``."""
        parts = [self.panel] if self.panel else []
        parts += [f"edge {self.edge}"] if self.edge is not None else []
        parts += [f"stitch {self.stitch}"] if self.stitch is not None else []
        return ", ".join(parts)

    def line(self) -> str:
        """The finding on one line, such as ``warning: no-area (cuff): ...``."""
        place = f" ({self.where()})" if self.where() else ""
        return f"{self.severity.value}: {self.code}{place}: {self.message}"

    def entry(self) -> dict[str, str]:
        """The finding for a report: JSON values."""
        severity, where = self.severity.value, self.where()
        return {"code": self.code, "severity": severity, "where": where, "message": self.message}

    def to_json(self) -> dict[str, object]:
        """The finding as plain JSON values."""
        return asdict(self)
