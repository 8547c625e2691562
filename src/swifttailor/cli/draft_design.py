"""``swifttailor draft --design``: GarmentCode's garment programs, for a body or for all sizes of a run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from swifttailor.cli.patterns_for_bodies import PatternsForBodies
from swifttailor.cli.postponed_imports import tyro

if TYPE_CHECKING:
    from swifttailor.body import Body
    from swifttailor.pattern import Pattern


@dataclass(frozen=True, kw_only=True)
class DraftDesign(PatternsForBodies):
    """Draft a pattern from GarmentCode's design parameters, for the measurements of a body.

    The file says for which body it is, so that it can be refitted. With --sizes, drafts for every size from
    one to another, and writes a file each into a folder.

    Exit code 0: done; 1: done, but a check finds something in a pattern; 2: not done.
    """

    design: Annotated[Path, tyro.conf.arg(metavar="FILE")]
    """GarmentCode's design file, YAML or JSON, nested or with flat names (sleeve.length: 0.5). What is not in
    it has its default."""

    @property
    def source_is(self) -> str:
        """What the file is that patterns are made from."""
        return "the design"

    def run(self) -> int:
        """Drafts, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: An option or the design cannot be used.
        """
        return self.make_all(self.design, self.design.stem, self._drafting, slow=False)

    def _drafting(self) -> Callable[[Body], Pattern]:
        from swifttailor.programs import read_design
        from swifttailor.refitting import draft_design

        values = read_design(self.design)
        return lambda body: draft_design(values, body)
