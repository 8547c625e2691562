"""``swifttailor fit``: a pattern refitted to another body, or to all sizes of a run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from swifttailor.cli.patterns_for_bodies import PatternsForBodies
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.pattern import Pattern


@dataclass(frozen=True, kw_only=True)
class Fit(PatternsForBodies):
    """Refit a pattern to another body: by a size, by measures, or by a file of either.

    Ease, style lines and proportions are kept; seams that were equally long stay so, and what is symmetric
    stays symmetric. The file says for which body it is, so that it can be refitted again.

    With --sizes, refits to every size from one to another, and writes a file each into a folder.

    Exit code 0: done; 1: done, but a check finds something in a refitted pattern; 2: not done.
    """

    pattern: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="PATTERN")]
    """GarmentCode JSON file."""
    drafted_for: Annotated[str | None, tyro.conf.arg(metavar="SIZE")] = None
    """Size that the pattern was drafted for. Default: the body that its file names, else the default body."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""

    def run(self) -> int:
        """Refits, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: An option or the pattern cannot be used.
        """
        if self.sizes is None and not self.names_body:
            raise InputError(
                "No body was given. Give one with --size 44, --measure bust=96 height=172, or --body FILE."
            )
        return self.make_all(self.pattern, f"{self.pattern.stem}-fitted", self._refitting, slow=True)

    def _refitting(self) -> Callable[[Body], Pattern]:
        from swifttailor.body.wearer import Wearer
        from swifttailor.pattern import check_pattern, read_pattern_file
        from swifttailor.pattern.check import require_no_errors
        from swifttailor.refitting.refitted import Refitted, refit

        reading = read_pattern_file(self.pattern, rotation=self.rotation)
        require_no_errors(
            check_pattern(reading.pattern, reader_findings=reading.findings), f"'{self.pattern}'"
        )
        first = None if self.drafted_for is None else Wearer(size=self.drafted_for).body()
        last: Refitted | None = None

        def refitted(body: Body) -> Pattern:
            nonlocal last
            sewn = None if last is None else last.sewn
            last = refit(reading.pattern, body, drafted_for=first, sewn=sewn)
            return last.pattern

        return refitted
