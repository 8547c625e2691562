"""One output of a released system, as it was read."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.garment.garment import Garment
from swifttailor.pattern import Pattern
from swifttailor.pattern.check import Change


@dataclass(frozen=True)
class Output:
    """A garment that a system has written for one of its inputs, or why there is none."""

    id: str
    """No other output of the folder has it: the input's name, and the part where an answer has several."""
    pattern: Pattern | None
    """Mended as far as it is safe, in this package's conventions; None where there is none."""
    garment: Garment | None
    """Its 3D shape, where it is read: of no system so far, since patterns are sewn here."""
    error: str
    """Why it cannot be sewn; empty where it can. With a pattern: what could not be mended."""
    changes: tuple[Change, ...]
    """What was mended."""
    layout: str
    """Of which system's folder it is: one of `LAYOUTS`."""
    input: str = ""
    """Name of the input that it answers, as the system's folders have it. Several outputs may share one."""
