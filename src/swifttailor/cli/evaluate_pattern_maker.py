"""``swifttailor evaluate pattern-maker``: generated and edited patterns against true ones."""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.option_checks import (
    in_range,
    require_limit,
    require_threads,
    require_writable_folder,
)
from swifttailor.cli.picture_reader_files import chosen_reader
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError
from swifttailor.output_folder import OutputFolder

if TYPE_CHECKING:
    from swifttailor.evaluation.maker.run import Evaluation, Plan
    from swifttailor.garment_sewer.sewer import GarmentSewer

MAX_SAMPLES = 1000
FILES = "scores.jsonl", "summary.json", "tables.txt"


@dataclass(frozen=True, kw_only=True)
class EvaluatePatternMaker:
    """Ask for patterns that are known, by text, by picture, by both and by edits, as generate and edit do.

    Prints tables beside the paper's rows, and writes into --out: tables.txt, summary.json, scores.jsonl (a
    line for each answer), answers.jsonl and samples.jsonl (patterns), sheet-text-01.png and so on (answers
    beside the truth). Answers are kept as they are given: stopped and started again, it resumes.

    Exit code 0: done; 1: done, but some patterns could not be asked for or were not answered; 2: not done.
    """

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to ask for: .jsonl, .jsonl.gz, folders of .json files, or data sets."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("pattern-maker-evaluation")
    """Folder for answers and results; created when missing."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.zip) of a trained PatternMaker. Default: the one in the package."""
    data: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Data set, or a split of one, with drapes of these patterns: its renders are the pictures, or pictures
    are drawn of its drapes where it has none."""
    look: Literal["plain", "seamless", "studio", "people", "held out", "laid"] | None = None
    """Draw the pictures of --data in this look: plain as GarmentCodeData's, the same in one colour without
    seams, a studio, people anywhere, people in looks that no picture reader was trained on, or laid or hung
    without anybody in it."""
    view: Literal["front", "back", "free", "both"] = "front"
    """From where they are seen, with --look; both: two pictures of the same person, front and back."""
    edits: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Edited versions of these patterns, each with the id of its base."""
    tasks: tuple[Literal["text", "image", "text+image", "edit"], ...] = ()
    """What to ask by. Default: everything that the given data allow."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only N patterns and N edits, chosen by --seed. A larger N later goes on with the same ones."""
    seed: int = 0
    """Decides which patterns, the words of captions and instructions, the pictures, and what is drawn."""
    network_alone: tyro.conf.FlagCreatePairsOff[bool] = False
    """Measure the network alone: one pattern for each question, at temperature 0, as it is written, and
    pictures as they are."""
    decoding: Literal["own", "grammar", "free"] = "own"
    """Of the network alone: grammar lets patterns alone be written; free takes the likeliest token, whatever
    it is, so that an answer may be no pattern; own is what the card of the network says, or else grammar."""
    temperature: Annotated[float | None, tyro.conf.arg(metavar="T")] = None
    """Of the answers that are measured; as swifttailor generate has it (0.2) without it, or 0 with
    --network-alone."""
    attempts: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Patterns to write at most until one is as asked for; 4 without it, or 1 at temperature 0."""
    source: Literal["both", "drafts", "designs", "library", "writer"] = "both"
    """Where patterns come from, as swifttailor generate has it."""
    refine: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Known patterns that are compared with a picture, as swifttailor generate has it."""
    alter: bool = True
    """Recut the patterns until what the texts ask for holds, as far as that can be cut."""
    crop: bool = True
    """Crop pictures to what stands before their background, where that is plain."""
    samples: Annotated[int, tyro.conf.arg(metavar="N")] = 20
    """Most attempts of #Sampling, which are drawn at temperature 1; 0 leaves it out."""
    garments: tyro.conf.FlagCreatePairsOff[bool] = False
    """Sew the answers and compare them, as a set, with the drapes of --data."""
    sewer_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """GarmentSewer's model file; the one of the package without it. It says which patterns can be sewn."""
    picture_reader_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a picture reader; the one of the package without it."""
    close_up_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files (.onnx) of networks that look at details from near, each at what it has learnt from, beside
    --picture-reader-weights; that one looks itself without them, if it was trained to."""
    plain_reader_weights: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")] = ()
    """Model files (.onnx) of a network that reads pictures like GarmentCodeData's, and of those that look
    at their details, beside --picture-reader-weights. Without them that one reads all pictures."""
    pattern_library: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Library (.zip) of known patterns; the one of the package without it, unless --weights are given."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """CPU cores for the network."""
    pictures: Annotated[int, tyro.conf.arg(metavar="N")] = 12
    """How many answers of each task to draw, from the nearest to the truth to the farthest."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the numbers as JSON instead of tables."""

    def run(self) -> int:
        """Asks, measures, prints, writes and returns the exit code.

        Raises:
            SwiftTailorError: The patterns, the weights or an option cannot be used.
        """
        from swifttailor.workers.work_folder import saying_how_to_go_on

        self._validate()
        with saying_how_to_go_on():
            return self._run()

    def _run(self) -> int:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.maker.run import evaluate
        from swifttailor.evaluation.provenance import code_and_machine, file_identity
        from swifttailor.tailor import Tailor

        plan = self._plan()
        plan.chosen_tasks()
        sewer = self._sewer()
        tailor = Tailor(
            self.weights,
            sewer,
            picture_reader=chosen_reader(
                self.picture_reader_weights, self.close_up_weights, self.plain_reader_weights
            ),
            pattern_library=self.pattern_library,
            threads=self.threads,
        )
        _ = tailor.pattern_maker, tailor.picture_reader  # refused before any pattern is read
        try:
            garments = sewer if self.garments else None
            found = evaluate(tailor, plan, self.out, self._weights(), ItemProgress, garments)
        except KeyboardInterrupt:
            sys.stderr.write(f"What was answered is kept in {self.out}; the same command goes on with it.\n")
            raise
        about = found.about | {"threads": self.threads, "command": self._command()} | code_and_machine()
        if self.garments:
            about["sewer_weights"] = file_identity(self._sewer_file())
        with (
            OutputFolder(self.out, overwrite=self.overwrite) as output,
            output.fill(stale=_stale_sheets(found)) as folder,
        ):
            self._write(found, about, folder)
            if self.pictures:
                self._draw(found, folder)
        return 0 if found.complete else 1

    def _plan(self) -> Plan:
        from swifttailor.evaluation.maker.ask import Asking
        from swifttailor.evaluation.maker.run import Plan

        asking = Asking(
            temperature=self._temperature,
            attempts=self.attempts,
            alter=self.alter,
            crop=self.crop,
            source=self.source,
            refine=self.refine,
            network_alone=self.network_alone,
            decoding=self.decoding,
            seed=self.seed,
        )
        return Plan(
            self.patterns,
            self.data,
            self.edits,
            self.tasks,
            self.limit,
            asking,
            look=self.look,
            view=self.view,
            samples=self.samples,
        )

    @property
    def _temperature(self) -> float:
        if self.temperature is not None:
            return self.temperature
        from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE

        return 0.0 if self.network_alone else USUAL_TEMPERATURE

    def _command(self) -> str:
        """What was run, without the places of the files."""
        parts = ["swifttailor evaluate pattern-maker --patterns", *(p.name for p in self.patterns)]
        parts += [] if self.edits is None else ["--edits", self.edits.name]
        parts += (
            [] if self.data is None else ["--data", f"{self.data.resolve().parent.name}/{self.data.name}"]
        )
        parts += [] if self.look is None else ["--look", self.look, "--view", self.view]
        parts += ["--tasks", *self.tasks] if self.tasks else []
        parts += [] if self.limit is None else ["--limit", str(self.limit)]
        parts += ["--network-alone"] if self.network_alone else ["--source", self.source]
        return " ".join([*parts, "--samples", str(self.samples), "--seed", str(self.seed)])

    def _weights(self) -> dict[str, Any]:
        """The files of all networks that decide the answers."""
        from swifttailor.evaluation.provenance import file_identity
        from swifttailor.parameter_reader.reader import SHIPPED as DESIGNER
        from swifttailor.pattern_library.known import SHIPPED as LIBRARY
        from swifttailor.pattern_maker.maker import SHIPPED
        from swifttailor.picture_reader.reader import SHIPPED as EYES
        from swifttailor.picture_reader.reader import SHIPPED_LAID, SHIPPED_PLAIN, SHIPPED_SHOP
        from swifttailor.wishes.reader import SHIPPED as READER
        from swifttailor.wishes.reader import SHIPPED_SPOKEN as SPOKEN

        found: dict[str, Any] = dict(file_identity(SHIPPED if self.weights is None else self.weights))
        if self.alter and not self.network_alone:
            found["altered_by"] = file_identity(READER)
            found["own_words_by"] = file_identity(SPOKEN)
            eyes = self.picture_reader_weights or (EYES if EYES.is_file() else None)
            if eyes is not None and self.data is not None:
                found["read_by"] = file_identity(eyes)
                own = self.picture_reader_weights is not None
                plain = self.plain_reader_weights if own else SHIPPED_PLAIN
                found["read_from_near_by"] = [file_identity(file) for file in self.close_up_weights]
                found["plain_read_by"] = [file_identity(file) for file in plain]
                if not own:
                    found["laid_read_by"] = file_identity(SHIPPED_LAID)
                    found["photographs_read_by"] = file_identity(SHIPPED_SHOP)
            if self.source != "writer" and (self.weights is None or self.pattern_library is not None):
                found["known_from"] = file_identity(self.pattern_library or LIBRARY)
            if self.source in ("both", "designs") and self.weights is None and self.pattern_library is None:
                found["designed_by"] = file_identity(DESIGNER)
        if not self.network_alone:
            found["sewn_by"] = file_identity(self._sewer_file())
        return found

    def _sewer(self) -> GarmentSewer | None:
        if self.network_alone and not self.garments:
            return None
        from swifttailor.garment_sewer.sewer import GarmentSewer

        return GarmentSewer.load(self._sewer_file(), threads=self.threads)

    def _sewer_file(self) -> Path:
        from swifttailor.garment_sewer.sewer import SHIPPED

        return SHIPPED if self.sewer_weights is None else self.sewer_weights

    def _validate(self) -> None:
        """Refuses what cannot work before anything is loaded."""
        from swifttailor.cli.evaluation_report import require_picture_count

        if not self.patterns:
            raise InputError("No patterns were given. Give at least one file: --patterns FILE")
        if self.look is not None and self.data is None:
            raise InputError("--look is about pictures: give the data set that has the garments, --data DIR.")
        if self.view != "front" and self.look is None:
            raise InputError(f"--view {self.view} goes with --look: say how the pictures are to look.")
        if self.source in ("library", "designs") and not self.alter:
            what = "Known patterns" if self.source == "library" else "Drafts of designs"
            raise InputError(f"{what} are there to be altered: leave --source or --no-alter out.")
        if self.garments and self.data is None:
            raise InputError("--garments compares with drapes: give the data set that has them, --data DIR.")
        if self.decoding != "own" and not self.network_alone:
            raise InputError(
                f"--decoding {self.decoding} is about the network alone, for generate always decodes under "
                "the grammar. Add --network-alone, or leave it out."
            )
        if self.network_alone:
            for name, given in (
                ("--attempts", self.attempts is not None),
                ("--no-alter", not self.alter),
                ("--no-crop", not self.crop),
                ("--source", self.source != "both"),
                ("--refine", self.refine is not None),
                ("--sewer-weights", self.sewer_weights is not None and not self.garments),
            ):
                if given:
                    raise InputError(
                        f"{name} is of no use with --network-alone, which writes one pattern for each "
                        "question and neither alters nor sews it. Leave one of them out."
                    )
        require_limit(self.limit)
        in_range("--seed", self.seed, 0, 2**31)
        in_range("--temperature", self.temperature, 0.0, 10.0)
        in_range("--attempts", self.attempts, 1, 64)
        in_range("--refine", self.refine, 0, 32)
        if (self.attempts or 1) > 1 and self.temperature == 0:
            raise InputError(
                f"At temperature 0 all {self.attempts} attempts are the same. Give a --temperature above 0."
            )
        in_range("--samples", self.samples, 0, MAX_SAMPLES)
        require_threads(self.threads)
        require_picture_count(self.pictures)
        require_writable_folder(self.out)
        OutputFolder(self.out, overwrite=self.overwrite).require_own(FILES)

    def _write(self, found: Evaluation, about: dict[str, Any], folder: Path) -> None:
        from swifttailor.atomic_files import write_text
        from swifttailor.evaluation.maker.recorded_tables import sampling_table, task_tables

        tables = [table for result in found.results for table in task_tables(result)]
        tables += [sampling_table(found.sampling, self.samples)] if found.sampling else []
        numbers = {
            "about": about,
            "tasks": {result.task: result.to_json() for result in found.results},
            "sampling": {task: asdict(summary) for task, summary in found.sampling.items()},
            "garments": {task: asdict(sets) for task, sets in found.garments.items()},
            "tables": [table.to_json() for table in tables],
        }
        text = self._text(found, about)
        summary = json.dumps(numbers, indent=1, allow_nan=False) + "\n"
        lines = [json.dumps(s.to_json()) for scored in found.scored.values() for s in scored]
        for name, content in zip(FILES, ("".join(f"{line}\n" for line in lines), summary, text), strict=True):
            write_text(folder / name, content)
        sys.stdout.write(summary if self.json else text)

    def _text(self, found: Evaluation, about: dict[str, Any]) -> str:
        from swifttailor.evaluation.maker.tables import (
            garments_text,
            provenance_text,
            sampling_text,
            task_text,
        )

        parts = [provenance_text(about), *(task_text(result) for result in found.results)]
        if found.sampling:
            parts.append(sampling_text(found.sampling, self.samples))
        if found.garments:
            parts.append(garments_text(found.garments))
        if found.skipped:
            parts.append("".join(f"{id}: not asked for. {why}\n" for id, why in found.skipped.items()))
        return "\n".join(parts)

    def _draw(self, found: Evaluation, folder: Path) -> None:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.maker.ask import picture_of
        from swifttailor.evaluation.maker.sheet import Shown, chosen, write_sheets

        with ItemProgress(len(found.scored), "tasks drawn") as progress:
            for task, scored in found.scored.items():
                shown = []
                for one in chosen(scored, self.pictures):
                    picture = picture_of(one.answer.question, found.pictures)
                    shown.append(Shown(one, None if picture is None else picture[1][0]))
                write_sheets(folder, task.replace("+", "-"), shown)
                progress.add(1)


def _stale_sheets(found: Evaluation) -> list[str]:
    from swifttailor.render.numbered_sheets import sheets_named

    return [name for task in found.scored for name in sheets_named(f"sheet-{task.replace('+', '-')}")]
