"""``swifttailor edit``: a sewing pattern, changed as words say, and its garment."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from swifttailor.cli.making import Making
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place
from swifttailor.errors import InputError

PATTERN, REPORT = "pattern.json", "report.json"
_MAX_REPORT_BYTES = 64 * 2**20


@dataclass(frozen=True, kw_only=True)
class Edit(Making):
    """Change a sewing pattern as instructed, and make its garment.

    Writes the same files as swifttailor generate. Where nothing is understood of the instruction, the pattern
    stays as it is. The garment keeps its colours and its fabric.

    Exit code 0: made, and all that was understood holds; 1: made, but read what it says, or some samples
    failed; 2: nothing was made.
    """

    asks_for = "Say which pattern to change, and how, in quotes."
    example = 'dress "make it 10 cm longer" --out longer'

    pattern: Annotated[tyro.conf.Positional[Path], tyro.conf.arg(metavar="PATTERN")]
    """GarmentCode JSON file, or the folder of a garment."""
    instruction: Annotated[tyro.conf.Positional[str], tyro.conf.arg(metavar="INSTRUCTION")]
    """What to change, in English: "make the sleeves longer"."""
    repair: tyro.conf.FlagCreatePairsOff[bool] = False
    """Repair the pattern first, as swifttailor check --repair does."""
    rotation: Literal["intrinsic", "extrinsic"] | None = None
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic). Default: what a garment's folder says, else intrinsic."""

    def run(self) -> int:
        """Makes what is asked for, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Nothing could be made.
        """
        if not self.instruction.strip():
            raise InputError(
                "The instruction is empty. Say what to change: "
                'swifttailor edit PATTERN "make it shorter" --out DIR'
            )
        source = self.pattern / PATTERN if self.pattern.is_dir() else self.pattern
        for folder in () if self.overwrite else self.folders():
            edited = self.folder / folder / PATTERN
            if edited.exists() and source.exists() and source.samefile(edited):
                raise InputError(
                    f"The edited pattern would replace the one that is edited, '{source}'. "
                    "Choose another --out, or say --overwrite."
                )
        self.require_options()
        from swifttailor.garment.cloth_color import stated_color
        from swifttailor.garment.cloth_print import stated_print
        from swifttailor.garment.part_looks import stated_looks
        from swifttailor.pattern import check_pattern, read_pattern_file, repair_pattern
        from swifttailor.pattern.check import require_no_errors

        report = _read_report(source.with_name(REPORT)) if source.name == PATTERN else None
        reading = read_pattern_file(source, rotation=self._rotation(report))
        findings, pattern = reading.findings, reading.pattern
        if self.repair:
            from swifttailor.body.probe import probe_body
            from swifttailor.body.wearer import body_of

            repaired = repair_pattern(pattern, findings, body=probe_body(body_of(pattern.drafted_for)))
            findings, pattern = (), repaired.pattern
        findings = check_pattern(pattern, reader_findings=findings)
        require_no_errors(findings, f"'{source}'", repaired=self.repair, option=True)
        said = report or {}
        cloth = {"color": stated_color(said), "print": stated_print(said), "looks": stated_looks(said)}
        return self.make(self.order(self.instruction, edit=pattern, **cloth))

    def usual_place(self) -> Path:
        """Named after the pattern."""
        return new_place(f"{self.pattern.stem}-edited")

    def sources(self) -> tuple[Path, ...]:
        """The pattern."""
        return (self.pattern,)

    def usual_fabric(self) -> str:
        """What the garment is made of now."""
        from swifttailor.draping.known_fabrics import FABRICS

        source = self.pattern / PATTERN if self.pattern.is_dir() else self.pattern
        report = _read_report(source.with_name(REPORT)) if source.name == PATTERN else None
        found = (report or {}).get("fabric")
        return found if isinstance(found, str) and found in FABRICS else super().usual_fabric()

    def _rotation(self, report: dict[str, Any] | None) -> Literal["intrinsic", "extrinsic"]:
        if self.rotation is not None:
            return self.rotation
        found = report is not None and self.pattern.is_dir() and report.get("rotation") == "extrinsic"
        return "extrinsic" if found else "intrinsic"


def _read_report(path: Path) -> dict[str, Any] | None:
    """The report of a garment's folder; None where the file is none, or missing."""
    try:
        if path.stat().st_size > _MAX_REPORT_BYTES:
            return None
        report: Any = json.loads(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return None
    return report if isinstance(report, dict) else None
