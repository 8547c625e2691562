"""What a repair did to a pattern, one thing at a time."""

from __future__ import annotations

from dataclasses import asdict, dataclass

from swifttailor.pattern.finding import Finding, Severity


@dataclass(frozen=True)
class Change:
    """One thing that a repair changed."""

    code: str
    """Code of the finding that it mends."""
    message: str
    """What was done, in words."""
    panel: str = ""
    edge: int | None = None
    """Edge number before the repair."""
    stitch: int | None = None
    """Stitch number before the repair."""

    def where(self) -> str:
        """The place in words, such as ``skirt_front, edge 3``."""
        return Finding(self.code, Severity.INFO, "", self.panel, self.edge, self.stitch).where()

    def to_json(self) -> dict[str, object]:
        """The change as plain JSON values."""
        return asdict(self)
