"""What ``swifttailor generate`` and ``swifttailor edit`` have in common: options, folders, what is said."""

from __future__ import annotations

import json
import re
import sys
import time
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from swifttailor.cli.fabric_option import FabricOption
from swifttailor.cli.findings_shown import REPORT_HAS_ALL, first_of
from swifttailor.cli.option_checks import (
    in_range,
    require_edge_length,
    require_seed,
    require_threads,
    require_writable_folder,
)
from swifttailor.cli.plain_options import operands
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import GarmentResults
from swifttailor.cli.wearer_options import WearerOptions
from swifttailor.errors import InputError, SwiftTailorError

if TYPE_CHECKING:
    from swifttailor.output_folder import OutputFolder
    from swifttailor.pattern import Pattern
    from swifttailor.pattern.drafted_for import DraftedFor
    from swifttailor.tailor import Order, Tailor, Tailored

SOMETHING_TO_LOOK_AT = 1
UNUSABLE = 2
SHEET = "sheet.png"
MOST_SAMPLES = MOST_ATTEMPTS = 64
HIGHEST_TEMPERATURE = 10.0
MEASURE = re.compile(r"\w+=[\w.]+")
PICTURES = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".gif", ".tif", ".tiff")


@dataclass(frozen=True, kw_only=True)
class Making(GarmentResults, WearerOptions, FabricOption):
    """Options of both commands."""

    asks_for: ClassVar[str]
    """What is missing where nothing is given."""
    example: ClassVar[str]

    samples: Annotated[int, tyro.conf.arg(metavar="K")] = 1
    """How many garments to make. Several get a folder each in DIR, and sheet.png shows them all."""
    seed: int = 0
    """Random seed; each further sample adds one."""
    temperature: Annotated[float, tyro.conf.arg(metavar="T")] = 0.2
    """0: always the likeliest pattern; higher: more varied, and odder."""
    attempts: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Patterns to write at most until one can be sewn. Default: 4, or 1 at temperature 0."""
    alter: bool = True
    """Recut the pattern until it is what the text asks for, as far as cutting can do that."""
    finish: tyro.conf.FlagCreatePairsOff[bool] = False
    """Finish with physics: let the garment hang to rest. Adds wrinkles and a report of its quality."""
    relax: bool = True
    """Let the cloth fall for a moment: smooths seams, and gives wide skirts their folds."""
    edge_length: float = 2.0
    """Edge length of the mesh in cm, 0.5 to 10."""
    maker_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.zip) of a trained PatternMaker. Default: the one in the package."""
    sewer_weights: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Model file (.onnx) of a trained GarmentSewer. Default: the one in the package."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """CPU cores for the networks."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print a list of the reports as JSON."""

    @classmethod
    def refuse_unquoted(cls, arguments: list[str]) -> None:
        """Says where quotes were forgotten, or nothing was given at all.

        Args:
            arguments: Of the command line.

        Raises:
            InputError: There are more words than operands, or there are no arguments.
        """
        if not arguments:
            raise cls.nothing_requested()
        words = [
            word
            for word in operands(cls, arguments)
            if Path(word).suffix.lower() not in PICTURES and not MEASURE.fullmatch(word)
        ]
        count = sum("Positional" in str(field.type) for field in fields(cls))
        if {"-h", "--help"}.isdisjoint(arguments) and len(words) > count:
            before = "".join(f"{word} " for word in words[: count - 1])
            text = " ".join(words[count - 1 :])
            out = arguments.index("--out") if "--out" in arguments[:-1] else None
            where = "" if out is None else f" --out {arguments[out + 1]}"
            raise InputError(f'Put the words in quotes: {cls._command()} {before}"{text}"{where}')

    @classmethod
    def nothing_requested(cls) -> InputError:
        """The error that shows how the command is used."""
        return InputError(
            f"Nothing was requested. {cls.asks_for} For example: {cls._command()} {cls.example}"
        )

    @classmethod
    def _command(cls) -> str:
        return f"swifttailor {cls.__name__.lower()}"

    def require_options(self) -> None:
        """Refuses what cannot work before anything is loaded.

        Raises:
            InputError: An option is out of range, or DIR cannot be written.
        """
        in_range("--samples", self.samples, 1, MOST_SAMPLES)
        require_seed(self.seed)
        require_seed(self.seed + self.samples - 1)
        in_range("--temperature", self.temperature, 0.0, HIGHEST_TEMPERATURE)
        in_range("--attempts", self.attempts, 1, MOST_ATTEMPTS)
        require_edge_length(self.edge_length)
        require_threads(self.threads)
        self.require_fabric()
        require_writable_folder(self.folder)

    def usual_fabric(self) -> str:
        """What garments are made of where nothing says otherwise."""
        return "cotton"

    def sources(self) -> tuple[Path, ...]:
        """Files that the garments are made of."""
        return ()

    def folders(self, within: str = "") -> list[str]:
        """Of the samples of an order, in DIR; DIR itself when empty.

        Args:
            within: Folder of the order in DIR; DIR itself when empty.
        """
        if self.samples == 1:
            return [within]
        return [(Path(within) / f"seed-{self.seed + k}").as_posix() for k in range(self.samples)]

    def folders_within(self) -> tuple[str, ...]:
        """Folders of orders in DIR that there may be."""
        return ("",)

    def tailor(self, before: DraftedFor | None = None, **networks: Any) -> Tailor:
        """Who makes the garments.

        Args:
            before: See `wearer`.
            networks: Others than both commands need, or their model files, as `Tailor.load` names them.
        """
        from swifttailor.tailor import Tailor

        body = None if self.refits else self.wearer(before)
        return Tailor.load(
            self.maker_weights,
            self.sewer_weights,
            body=body,
            fabric=self.usual_fabric(),
            threads=self.threads,
            **networks,
        )

    def several(self, tailor: Tailor, order: Order) -> dict[str, Order]:
        """The orders that one is, by their folder in DIR.

        Raises:
            SwiftTailorError: It cannot be read.
        """
        return {"": order}

    def order(self, text: str, **asked: Any) -> Order:
        """What is wanted, and how to make it.

        Args:
            text: Description or instruction.
            asked: The picture, or the pattern to edit (`Order`).

        Raises:
            InputError: It makes no sense.
        """
        from swifttailor.tailor import Order

        return Order(
            text,
            **asked,
            fabric=self.fabric,
            body=self.wearer(_wore(asked.get("edit"))) if self.refits else None,
            samples=self.samples,
            seed=self.seed,
            temperature=self.temperature,
            attempts=self.attempts,
            alter=self.alter,
            edge_length=self.edge_length,
            finish=self.finish,
            relax=self.relax,
        )

    def make(self, order: Order) -> int:
        """Carries out an order, prints what came of it, and returns the exit code.

        Raises:
            SwiftTailorError: Nothing could be made, or DIR holds what is not to be replaced.
        """
        from swifttailor.garment.folder import GLB, PREVIEW
        from swifttailor.output_folder import OutputFolder

        with OutputFolder(self.folder, overwrite=self.overwrite, sources=self.sources()) as output:
            self._require_own(output)
            code = self._make(order, output)
        self.show(SHEET, PREVIEW, GLB)
        return code

    def _require_own(self, output: OutputFolder) -> None:
        from swifttailor.garment.folder import GGI, SEEN, names_written

        names = *names_written(preview=self.preview), GGI, *([SEEN] if self.shows_what_is_seen() else [])
        possible = [name for within in self.folders_within() for name in self.folders(within)]
        for name in possible:
            output.inside(name).require_own(names)
        if self.preview and len(possible) > 1:
            output.require_own([SHEET])

    def _posed(self, made: Tailored) -> Tailored:
        garment, body = self.posed(made.garment, made.body)
        return replace(made, garment=garment, body=body)

    def shows_what_is_seen(self) -> bool:
        """Whether pictures are read."""
        return False

    def _make(self, order: Order, output: OutputFolder) -> int:
        from swifttailor.cli.progress import StageProgress
        from swifttailor.tailor import Tailored

        started = time.perf_counter()
        tailor = self.tailor(_wore(order.edit))
        with StageProgress() as progress:
            for note in tailor.compile_notes(finish=self.finish):
                progress.note(note)
            outcomes = {
                self.folder / folder: one
                for within, part in self.several(tailor, order).items()
                for folder, one in zip(
                    self.folders(within), tailor.make(part, progress=progress), strict=True
                )
            }
            outcomes = {
                folder: self._posed(one) if isinstance(one, Tailored) else one
                for folder, one in outcomes.items()
            }
            made = {folder: one for folder, one in outcomes.items() if isinstance(one, Tailored)}
            if not made:
                raise next(one for one in outcomes.values() if isinstance(one, SwiftTailorError))
            progress("saving", 0.0)
            for folder, one in made.items():
                if folder == self.folder:  # which is locked
                    one.save_in(output, preview=self.preview)
                else:
                    with output.inside(str(folder.relative_to(self.folder))) as inner:
                        one.save_in(inner, preview=self.preview)
            if len(outcomes) > 1:
                from swifttailor.garment.folder import GGI, SEEN, names_written

                # A garment that was alone here before has given place to several.
                with output.fill(stale=(*names_written(preview=True), GGI, SEEN)) as shared_folder:
                    if self.preview:
                        _write_sheet(shared_folder / SHEET, made)
        if self.json:
            _print_json(outcomes)
        else:
            shared = _shared(list(made.values()))
            print("".join(f"{line}\n" for line in shared), end="")  # noqa: T201
            for folder, one in outcomes.items():
                _say(folder, one, shared, alone=len(outcomes) == 1)
            look = self.folder / (SHEET if len(outcomes) > 1 else "preview.png")
            seconds = time.perf_counter() - started
            where = f"; look at {look}" if self.preview else ""
            print(f"{seconds:.1f} s in all{where}.")  # noqa: T201
        return SOMETHING_TO_LOOK_AT if any(_is_flawed(one) for one in outcomes.values()) else 0


def _wore(edited: Pattern | None) -> DraftedFor | None:
    """Who wears the pattern to edit until now."""
    return None if edited is None else edited.drafted_for


def _is_flawed(outcome: Tailored | SwiftTailorError) -> bool:
    return isinstance(outcome, SwiftTailorError) or outcome.needs_a_look


def _remarks(one: Tailored) -> list[str]:
    return [f"warning: {text}" for text in one.warnings] + list(one.notes)


def _shared(made: list[Tailored]) -> list[str]:
    """What is to be said of all garments, of text or picture for instance."""
    return [line for line in _remarks(made[0]) if all(line in _remarks(one) for one in made)]


def _say(folder: Path, outcome: Tailored | SwiftTailorError, said: list[str], *, alone: bool) -> None:
    """Prints what came of one sample, but for what was said of all."""
    lines = []
    if isinstance(outcome, SwiftTailorError):
        lines.append(f"not made. {outcome}")
    else:
        report = outcome.report
        lines += [line for line in _remarks(outcome) if line not in said]
        shown, more = first_of([f.line() for f in outcome.findings], "findings", REPORT_HAS_ALL)
        lines += [*shown, *filter(None, [more])]
        if "quality" in report and not report["quality"]["accepted"]:
            from swifttailor.draping.quality import not_accepted_line

            lines.append(not_accepted_line(report["quality"]))
        stages = ", ".join(f"{name} {value:.2f}" for name, value in outcome.seconds.items() if value >= 0.005)
        lines.append(
            f"{report['panels']} panels, {report['stitches']} stitches, {report['vertices']} vertices; "
            f"seconds: {stages}. Wrote {folder}"
        )
    prefix = "" if alone else f"{folder.name}: "
    print("\n".join(prefix + line for line in lines))  # noqa: T201


def _print_json(outcomes: dict[Path, Tailored | SwiftTailorError]) -> None:
    from swifttailor.garment.folder import plain

    reports = [
        {"error": str(one)} | {"folder": str(folder)}
        if isinstance(one, SwiftTailorError)
        else one.report | {"folder": str(folder)}
        for folder, one in outcomes.items()
    ]
    sys.stdout.write(json.dumps(plain(reports), indent=2, allow_nan=False) + "\n")


def _write_sheet(path: Path, made: dict[Path, Tailored]) -> None:
    from swifttailor.atomic_files import write_atomically
    from swifttailor.garment.folder import PREVIEW
    from swifttailor.render.contact_sheet import Tile, draw_contact_sheet

    tiles = []
    for folder, one in made.items():
        count = f"{one.report['panels']} panels"
        doubts = [f.code for f in one.findings if f.severity.value != "info"] + list(one.warnings)
        caption = f"{count}; {'; '.join(doubts)}" if doubts else count
        title = f"{folder.name}: {one.pattern.name}"
        tiles.append(Tile(folder / PREVIEW, title, caption, not one.needs_a_look))
    sheet = draw_contact_sheet(tiles, columns=min(4, max(2, round(len(tiles) ** 0.5))))
    write_atomically(path, lambda target: sheet.save(target, "PNG"))
