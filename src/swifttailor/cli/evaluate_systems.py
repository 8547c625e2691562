"""``swifttailor evaluate systems``: any generator with any way to sew, in the paper's tables."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from swifttailor.cli.option_checks import (
    in_range,
    require_edge_length,
    require_limit,
    require_threads,
    require_writable_folder,
)
from swifttailor.cli.postponed_imports import tyro
from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.output_folder import OutputFolder

if TYPE_CHECKING:
    from swifttailor.evaluation.maker.run import Plan
    from swifttailor.evaluation.systems.constructor import Constructor
    from swifttailor.evaluation.systems.generator import Generator
    from swifttailor.evaluation.systems.run import SystemsResult
    from swifttailor.pattern import Pattern
    from swifttailor.tailor import Tailor

FILES = "summary.json", "tables.txt", "tables.csv", "tables.tex", "failures.jsonl"
Own = Literal["ours", "uncut", "network-alone", "designs", "library", "nearest", "chance", "truth"]
OWN: tuple[Own, ...] = get_args(Own)
MODEL_FILE = ".zip"
"""The ending of the files of networks that generate."""
_ALONE = {"network_alone": True, "temperature": 0.0}
Sewing = Literal["network", "network+finish", "physics"]


@dataclass(frozen=True, kw_only=True)
class EvaluateSystems:
    """Compare systems: every generator of patterns with every way to sew them.

    Generators are
      ours           answers as swifttailor generate gives them
      uncut          the same, but nothing is recut to what the texts ask for
      network-alone  the first pattern that PatternMaker's network writes, at temperature 0
      designs        drafts of design parameters that are read alone, recut
      library        known patterns alone, recut
      nearest        the known pattern that fits best, as it is
      chance         a known pattern drawn by lot
      truth          the patterns that are asked for
    and NAME=SOURCE for another system: the folder that it wrote (docs/released-outputs.md) or a .jsonl file,
    each pattern under the id of the one that was asked for; or the model file (.zip) of a PatternMaker, whose
    network alone answers at temperature 0, decoded as its own method does, or of a latent diffusion
    (runs/latent_diffusion.sh).

    Prints tables beside the paper's rows and writes into --out: tables.txt, tables.csv, tables.tex,
    summary.json, failures.jsonl, and a folder for each generator with its answers and its garments. What is
    done is kept: stopped and started again it resumes, and a generator that is added later joins the others.

    Exit code 0: done; 1: done, but some patterns could not be asked for; 2: not done.
    """

    patterns: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE...")]
    """Patterns to ask for: .jsonl, .jsonl.gz, folders of .json files, or data sets."""
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("systems-evaluation")
    """Folder for answers, garments and results; created when missing."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    data: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Data set with drapes of these patterns: what garments are compared with, and pictures drawn of."""
    generators: Annotated[tuple[str, ...], tyro.conf.arg(metavar="NAME...")] = ("ours", "chance", "truth")
    """Where patterns come from: the names above, or NAME=SOURCE."""
    sewers: tuple[Sewing, ...] = ("network",)
    """How they become garments; physics takes some ten seconds a garment."""
    edge_length: float = 2.0
    """Edge length of the garments' meshes in cm: physics takes a third of the time at 3."""
    tasks: tuple[Literal["text", "image", "text+image"], ...] = ()
    """What to ask by. Default: everything that the given data allow."""
    limit: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    """Only N patterns, chosen by --seed. A larger N later goes on with the same ones."""
    seed: int = 0
    """Decides which patterns, the words of captions, the pictures, and what is drawn."""
    look: Literal["plain", "seamless", "studio", "people", "held out", "laid"] = "plain"
    """How pictures look; see swifttailor evaluate pattern-maker."""
    view: Literal["front", "back", "free", "both"] = "front"
    """From where they are seen."""
    threads: Annotated[int, tyro.conf.arg(metavar="N")] = 1
    """CPU cores for the networks."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print the numbers as JSON instead of tables."""

    def run(self) -> int:
        """Asks, makes, measures, prints, writes and returns the exit code.

        Raises:
            SwiftTailorError: The patterns, the data or an option cannot be used.
        """
        from swifttailor.workers.work_folder import saying_how_to_go_on

        self._validate()
        with saying_how_to_go_on():
            return self._run()

    def _run(self) -> int:
        from swifttailor.cli.item_progress import ItemProgress
        from swifttailor.evaluation.provenance import code_and_machine
        from swifttailor.evaluation.systems.run import run_systems

        generators = [self._generator(name) for name in self.generators]
        try:
            found = run_systems(generators, self._constructors(), self._plan, self.out, ItemProgress)
        except KeyboardInterrupt:
            sys.stderr.write(f"What was done is kept in {self.out}; the same command goes on with it.\n")
            raise
        about = dict(found.about) | {"threads": self.threads, "command": self._command()} | code_and_machine()
        with OutputFolder(self.out, overwrite=self.overwrite) as output, output.fill() as folder:
            self._write(found, about, folder)
        return 1 if found.skipped else 0

    def _validate(self) -> None:
        if not self.patterns:
            raise InputError("No patterns were given. Give at least one file: --patterns FILE")
        if not self.generators:
            raise InputError(f"No generators were given. Known: {', '.join(OWN)}, or NAME=SOURCE.")
        for name in self.generators:
            if name not in OWN and "=" not in name:
                raise InputError(
                    f"There is no generator {name!r}. Accepted: {', '.join(OWN)}, or NAME=SOURCE for the "
                    "recorded patterns of another system or the model file of a PatternMaker or a latent "
                    "diffusion."
                )
        require_limit(self.limit)
        in_range("--seed", self.seed, 0, 2**31)
        require_threads(self.threads)
        require_edge_length(self.edge_length)
        require_writable_folder(self.out)
        OutputFolder(self.out, overwrite=self.overwrite).require_own(FILES)

    def _command(self) -> str:
        """What was run, without the places of the files."""
        sources = [f"{name}={Path(source).name}" if source else name for name, _, source in self._named]
        parts = ["swifttailor evaluate systems --patterns", *(p.name for p in self.patterns)]
        parts += (
            [] if self.data is None else ["--data", f"{self.data.resolve().parent.name}/{self.data.name}"]
        )
        parts += ["--generators", *sources, "--sewers", *self.sewers]
        parts += [] if self.edge_length == 2.0 else ["--edge-length", f"{self.edge_length:g}"]
        parts += ["--tasks", *self.tasks] if self.tasks else []
        parts += [] if self.limit is None else ["--limit", str(self.limit)]
        parts += ["--seed", str(self.seed)]
        return " ".join(parts) + ("" if self.data is None else f" --look {self.look} --view {self.view}")

    @property
    def _named(self) -> list[tuple[str, str, str]]:
        """Each generator's name, and where its recorded patterns are."""
        return [name.partition("=") for name in self.generators]

    @property
    def _plan(self) -> Plan:
        from swifttailor.evaluation.maker.run import Plan

        look = None if self.data is None else self.look
        return Plan(
            self.patterns, self.data, None, self.tasks, self.limit, self._asking(), look, self.view, samples=0
        )

    def _asking(self, **changed: Any) -> Any:
        from swifttailor.evaluation.maker.ask import Asking

        return Asking(seed=self.seed, **changed)

    @cached_property
    def _tailor(self) -> Tailor:
        from swifttailor.tailor import Tailor

        return Tailor(threads=self.threads)

    @cached_property
    def _weights(self) -> dict[str, Any]:
        """The files that decide the answers of our generators."""
        from swifttailor.evaluation.provenance import file_identity
        from swifttailor.garment_sewer.sewer import SHIPPED as SEWER
        from swifttailor.parameter_reader.reader import SHIPPED as DESIGNER
        from swifttailor.pattern_library.known import SHIPPED as LIBRARY
        from swifttailor.pattern_maker.maker import SHIPPED as WRITER
        from swifttailor.picture_reader.reader import SHIPPED as EYES
        from swifttailor.picture_reader.reader import SHIPPED_LAID as LAID
        from swifttailor.picture_reader.reader import SHIPPED_PLAIN as PLAIN
        from swifttailor.wishes.reader import SHIPPED as READER

        files = {"writer": WRITER, "sewer": SEWER, "words": READER, "library": LIBRARY, "designs": DESIGNER}
        if self.data is not None:
            files |= {"pictures": EYES} | {file.stem: file for file in (*PLAIN, LAID)}
        return {name: file_identity(path) for name, path in files.items() if path.is_file()}

    def _generator(self, name: str) -> Generator:
        from swifttailor.evaluation.systems.generator import (
            Chance,
            NearestKnown,
            Recorded,
            TailorGenerator,
            Truth,
        )
        from swifttailor.pattern_library.known import PatternLibrary

        given, is_recorded, source = name.partition("=")
        if is_recorded and Path(source).suffix == MODEL_FILE:
            return self._model(given, Path(source))
        if is_recorded:
            return Recorded(given, _recorded(Path(source)))
        weights = self._weights
        if name == "truth":
            return Truth()
        if name == "chance":
            return Chance(PatternLibrary.load(), weights["library"], self.seed)
        if name == "nearest":
            return NearestKnown(name, self._tailor, self._asking(), weights, PatternLibrary.load())
        askings = {
            "ours": {},
            "uncut": {"alter": False},
            "network-alone": _ALONE,
            "designs": {"source": "designs"},
            "library": {"source": "library"},
        }
        return TailorGenerator(name, self._tailor, self._asking(**askings[name]), weights)

    def _model(self, name: str, weights: Path) -> Generator:
        """What a model file answers by itself."""
        from swifttailor.evaluation.provenance import file_identity
        from swifttailor.evaluation.systems.generator import TailorGenerator
        from swifttailor.evaluation.systems.latent import LatentGenerator
        from swifttailor.latent_diffusion.designer import KIND, LatentDesigner
        from swifttailor.networks.model_file import holds_graphs_of
        from swifttailor.tailor import Tailor

        if holds_graphs_of(weights, KIND):
            designer = LatentDesigner.load(weights, threads=self.threads)
            identity = self._weights | {"diffusion": file_identity(weights)}
            return LatentGenerator(name, self._tailor, self._asking(), identity, designer)
        tailor = Tailor(weights, threads=self.threads)
        _ = tailor.pattern_maker  # refused before anything is asked
        return TailorGenerator(name, tailor, self._asking(**_ALONE), {"writer": file_identity(weights)})

    def _constructors(self) -> list[Constructor]:
        from swifttailor.evaluation.systems.constructor import NetworkConstructor, PhysicsConstructor
        from swifttailor.garment_sewer.sewer import GarmentSewer

        made: list[Constructor] = []
        networks = [name for name in self.sewers if name != "physics"]
        sewer = GarmentSewer.load(threads=self.threads) if networks else None
        for name in self.sewers:
            if sewer is None or name == "physics":
                made.append(PhysicsConstructor(edge_length=self.edge_length))
            else:
                finish = name != "network"
                made.append(NetworkConstructor(sewer, self._weights["sewer"], finish, self.edge_length))
        return made

    def _write(self, found: SystemsResult, about: Mapping[str, Any], folder: Path) -> None:
        from swifttailor.atomic_files import write_text
        from swifttailor.evaluation.systems.tables import provenance_text, tables_of

        tables = tables_of(found)
        numbers = {
            "about": about,
            "tables": [table.to_json() for table in tables],
            "answers": {
                name: [r.to_json() | {"task": r.task} for r in rs] for name, rs in found.answers.items()
            },
            "cells": [_cell_json(cell) for cell in found.cells],
            "floors": {task: asdict(sets) for task, sets in found.floors.items()},
            "skipped": dict(found.skipped),
        }
        summary = json.dumps(numbers, indent=1, allow_nan=False) + "\n"
        left_out = f"{len(found.skipped)} patterns could not be asked for.\n" if found.skipped else ""
        text = "\n".join([provenance_text(about), *(t.text() for t in tables), left_out])
        failures = [
            {"generator": c.generator, "sewer": c.constructor, "task": c.task, "id": id, "error": why}
            for c in found.cells
            for id, why in c.failures.items()
        ]
        contents = {
            "summary.json": summary,
            "tables.txt": text,
            "tables.csv": "\n".join(t.csv() for t in tables),
            "tables.tex": "\n".join(t.latex() for t in tables),
            "failures.jsonl": "".join(json.dumps(one) + "\n" for one in failures),
        }
        for name in FILES:
            write_text(folder / name, contents[name])
        sys.stdout.write(summary if self.json else text)


def _cell_json(cell: Any) -> dict[str, Any]:
    return asdict(cell) | {"seconds": dict(cell.seconds), "failures": dict(cell.failures)}


def _recorded(source: Path) -> dict[str, Pattern | SwiftTailorError]:
    """The patterns of a system by the ids of what was asked for, or why one cannot be read."""
    found = _outputs(source)
    if all(isinstance(one, SwiftTailorError) for one in found.values()):
        first = next(iter(found.items()), None)
        why = f" The first, '{first[0]}': {first[1]}" if first else ""
        raise InputError(f"'{source}' holds no pattern that can be read.{why}")
    return found


def _outputs(source: Path) -> dict[str, Pattern | SwiftTailorError]:
    from swifttailor.data.pattern_source import is_data_set, patterns_of
    from swifttailor.pattern.pattern_list import pattern_files

    files = {path.name for path in pattern_files(source)} if source.is_dir() else set()
    if (
        not source.is_dir()
        or is_data_set(source)
        or any(not n.endswith("_specification.json") for n in files)
    ):
        return dict(patterns_of(source))
    from collections import Counter

    from swifttailor.data.released import read_outputs

    outputs = list(read_outputs(source))
    answers_to = Counter(output.input for output in outputs)
    found: dict[str, Pattern | SwiftTailorError] = {}
    for output in outputs:
        bad = output.pattern is None or output.error
        answer = PatternError(output.error or "There is no pattern.") if bad else output.pattern
        found[output.id] = answer
        if answers_to[output.input] == 1:  # of two garments that answer one input, each has its own id alone
            found.setdefault(output.input, answer)
    return found
