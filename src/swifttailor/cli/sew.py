"""``swifttailor sew``: sewing patterns to stitched 3D garments, by a network instead of physics."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.fabric_option import FabricOption
from swifttailor.cli.findings_shown import REPORT_HAS_ALL, first_of
from swifttailor.cli.option_checks import require_edge_length, require_threads, require_writable_folder
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import GarmentResults, new_place
from swifttailor.cli.wearer_options import WearerOptions, worn_by
from swifttailor.errors import DiskFullError, InputError, SwiftTailorError

if TYPE_CHECKING:
    from swifttailor.output_folder import OutputFolder
    from swifttailor.tailor import Tailored

SOMETHING_TO_LOOK_AT = 1
UNUSABLE = 2
SEW_AGAIN = (
    "Garments that were sewn before are whole. Make room, and start the same command again: it sews them all."
)


@dataclass(frozen=True, kw_only=True)
class Sew(GarmentResults, WearerOptions, FabricOption):
    """Turn sewing patterns into stitched garments on a body, in a fraction of a second each.

    Writes pattern.json, pattern.svg, garment.glb, garment.obj, preview.png and report.json into a folder; of
    several patterns each gets a folder of its own in DIR, named after its file. A pattern with errors
    (swifttailor check) is refused before anything is loaded; with warnings it is sewn, and they are printed.

    Exit code 0: made; 1: made, but read what it says, or some failed; 2: nothing was made.
    """

    patterns: Annotated[tyro.conf.Positional[tuple[Path, ...]], tyro.conf.arg(metavar="PATTERN...")]
    """GarmentCode JSON files."""
    weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a trained GarmentSewer. Default: the one in the package."""
    resolution: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Pixels along each side of the images. Default: what the network was trained at."""
    edge_length: float = 2.0
    """Edge length of the mesh in cm, 0.5 to 10."""
    finish: tyro.conf.FlagCreatePairsOff[bool] = False
    """Finish with physics: let the garment hang to rest. Adds wrinkles and a report of its quality."""
    relax: bool = True
    """Let the cloth fall for a moment: smooths seams, and gives wide skirts their folds."""
    repair: tyro.conf.FlagCreatePairsOff[bool] = False
    """Repair the patterns first, as swifttailor check --repair does."""
    rotation: Literal["intrinsic", "extrinsic"] = "intrinsic"
    """How to read the placement angles: as GarmentCode's generator writes them (intrinsic), or as its
    simulator and older files do (extrinsic)."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """CPU cores for the network."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the reports as JSON."""

    def run(self) -> int:
        """Sews, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: An option or the weights cannot be used.
        """
        folders = self._folders()
        from swifttailor.output_folder import OutputFolder

        with OutputFolder(self.folder, overwrite=self.overwrite, sources=self.patterns) as output:
            outputs = [(path, output.inside(name) if name else output) for path, name in folders]
            return self._sew(outputs)

    def _sew(self, outputs: list[tuple[Path, OutputFolder]]) -> int:
        from swifttailor.garment.folder import GLB, PREVIEW, names_written
        from swifttailor.tailor import Tailor
        from swifttailor.tailor.sewing import SewingOptions

        for _, output in outputs:
            output.require_own(names_written(preview=self.preview))
        tailor = Tailor.load(
            garment_sewer=self.weights,
            body=self.wearer(),
            fabric=self.fabric or "cotton",
            fit=self.refits,
            threads=self.threads,
        )
        if self.fabric is not None and not self.json:
            from swifttailor.tailor.heard_notes import fabric_line

            print(fabric_line(self.fabric, finish=self.finish))  # noqa: T201
        options = SewingOptions(self.edge_length, self.resolution, self.repair, self.finish, self.relax)
        outcomes = tailor.sew_all(
            [path for path, _ in outputs],
            options,
            rotation=self.rotation,
            progress=_say_compiling,
            note=lambda text: print(text, file=sys.stderr, flush=True),  # noqa: T201
        )
        reports = [
            self._keep(path, output, one) for (path, output), one in zip(outputs, outcomes, strict=True)
        ]
        if self.json:
            from swifttailor.garment.folder import plain

            sys.stdout.write(json.dumps(plain(reports), indent=2, allow_nan=False) + "\n")
        made = [r for r in reports if "error" not in r]
        if not made:
            return UNUSABLE
        self.show(PREVIEW, GLB)
        flawed = len(made) < len(reports) or any(_is_flawed(r) for r in made)
        return SOMETHING_TO_LOOK_AT if flawed else 0

    def usual_place(self) -> Path:
        """Named after the pattern."""
        return new_place(f"{self.patterns[0].stem}-sewn" if len(self.patterns) == 1 else "sewn")

    def _folders(self) -> list[tuple[Path, str]]:
        """Each pattern and its folder in DIR; refuses what cannot work before anything is loaded."""
        if not self.patterns:
            raise InputError("No pattern was given. Give one or more: swifttailor sew PATTERN --out DIR")
        require_edge_length(self.edge_length)
        require_threads(self.threads)
        self.require_fabric()
        require_writable_folder(self.folder)
        if len(self.patterns) == 1:
            return [(self.patterns[0], "")]
        folders: dict[str, Path] = {}
        for path in self.patterns:
            if path.stem in folders:
                raise InputError(
                    f"'{folders[path.stem]}' and '{path}' would both be written to "
                    f"'{self.folder / path.stem}'. Rename one, or sew them in two calls."
                )
            folders[path.stem] = path
        return [(path, name) for name, path in folders.items()]

    def _keep(self, path: Path, output: OutputFolder, outcome: Tailored | SwiftTailorError) -> dict[str, Any]:
        """Writes a garment, says what came of its pattern, and returns the report."""
        names = {"pattern": str(path), "folder": str(output.folder)}
        try:
            if isinstance(outcome, SwiftTailorError):
                raise outcome
            garment, body = self.posed(outcome.garment, outcome.body)
            outcome = replace(outcome, garment=garment, body=body)
            if output.folder == self.folder:  # which is locked
                outcome.save_in(output, preview=self.preview, images=False)
            else:
                with output:
                    outcome.save_in(output, preview=self.preview, images=False)
        except DiskFullError as error:
            raise DiskFullError(f"{error} {SEW_AGAIN}") from error
        except SwiftTailorError as error:
            if not self.json:
                named = str(error).startswith(f"'{path}'")
                print(f"Not sewn: {error}" if named else f"{path}: not sewn. {error}")  # noqa: T201
            return {"error": str(error)} | names
        if not self.json:
            _say(path, output.folder, outcome)
        return outcome.report | names


def _say(path: Path, folder: Path, made: Tailored) -> None:
    lines = [f"mended {change}" for change in made.report.get("mended", ())]
    shown, more = first_of([*lines, *(f.line() for f in made.findings)], "findings", REPORT_HAS_ALL)
    for line in (*shown, *filter(None, [more])):
        print(f"{path}: {line}")  # noqa: T201
    for note in made.notes:
        print(f"{path}: {note}")  # noqa: T201
    report = made.report
    if "quality" in report and not report["quality"]["accepted"]:
        from swifttailor.draping.quality import not_accepted_line

        print(f"{path}: {not_accepted_line(report['quality'])}")  # noqa: T201
    print(  # noqa: T201
        f"{path}: {report['panels']} panels, {report['vertices']} vertices{worn_by(report)}; seams were "
        f"{report['sewing']['seam_gap_before_median_cm']:.2f} cm apart and are closed; "
        f"{sum(made.seconds.values()):.2f} s. Wrote {folder}"
    )


def _is_flawed(report: dict[str, Any]) -> bool:
    """Whether a person should look: something is wrong with the pattern, or the drape is not accepted."""
    wrong = any(f["severity"] != "info" for f in report["findings"])
    return wrong or "mended" in report or not report.get("quality", {"accepted": True})["accepted"]


def _say_compiling(stage: str, share: float) -> None:
    """Says what the first garment that is relaxed waits for; other stages are short."""
    from swifttailor.draping.compiled_code import COMPILE_NOTE

    if stage == COMPILE_NOTE:
        print(COMPILE_NOTE, file=sys.stderr, flush=True)  # noqa: T201
