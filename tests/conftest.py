"""Fixtures shared by all tests."""

from __future__ import annotations

import gzip
import importlib.util
import json
import os
from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path

import pytest
from hypothesis import settings

from swifttailor.data.edits.edit_file import read_edits
from swifttailor.data.pattern_source import parsed_pattern
from swifttailor.describing import GarmentFacts, measure_facts
from swifttailor.pattern import EdgeRef, Pattern, Placement, Stitch, read_specification
from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.panel import Edge, Panel
from swifttailor.pattern.pattern_list import read_patterns

SHIPPED = "repository"
"""Name of the 20 patterns that lie beside the tests (garmentcode_patterns/)."""
EVERY_REAL = 8
"""Of the validation patterns; the others are looked at when captions are worked on (docs/captions.md)."""
FEW_SHIPPED, FEW_REAL = 2, 30
"""Every so many of both, where each is recut."""

SAMPLES = Path(__file__).parent / "garmentcode_patterns" / "patterns.jsonl.gz"
EXTRA_TRAIN = ("torch", "transformers", "accelerate", "onnx", "onnxscript")
"""What the marker ``needs_torch`` asks for."""

LONG_ROOMS = ("tests/end_to_end", "tests/fuzzing", "tests/test_readme.py")
"""Rooms with few tests that take long. Left to the end, one process would wait for the other."""

# No test is timed: on a busy machine an example may take any time.
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests marked ``needs_torch`` are skipped where the extra ``train`` is not installed."""
    missing = [name for name in EXTRA_TRAIN if importlib.util.find_spec(name) is None]
    if missing:
        skip = pytest.mark.skip(reason=f"{', '.join(missing)} missing (extra train): make test-networks")
        for item in items:
            if item.get_closest_marker("needs_torch"):
                item.add_marker(skip)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log):
    """Of several processes each takes whole rooms (or files of no room), if not told otherwise.

    So what a room's tests share is made once: patterns read, networks, a server with its browser, compiled
    loops. `LONG_ROOMS` come first, then the rooms with most tests.
    """
    if config.getoption("dist") != "load":
        return None
    from xdist.scheduler import LoadScopeScheduling

    class ByRoom(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return "/".join(nodeid.partition("::")[0].split("/")[:2])

        def _assign_work_unit(self, node) -> None:
            waiting = next((room for room in LONG_ROOMS if room in self.workqueue), None)
            if waiting:
                self.workqueue.move_to_end(waiting, last=False)
            super()._assign_work_unit(node)

    return ByRoom(config, log)


@pytest.fixture(scope="session")
def garmentcode_folder() -> Path:
    """Folder of GarmentCode samples (``*.jsonl.gz``): $SWIFTTAILOR_GARMENTCODE or ../shared/garmentcode."""
    folder = _samples_folder()
    if not any(folder.glob("*.jsonl.gz")):
        pytest.skip(f"no GarmentCode samples (*.jsonl.gz) in {folder}; set SWIFTTAILOR_GARMENTCODE")
    return folder


@pytest.fixture(scope="session")
def real_samples() -> Callable[..., Iterator[dict]]:
    """Goes through GarmentCode samples (``id``, ``seed``, ``design``, ``pattern``), every so many of a file.

    ``repository`` names those beside the tests; others, such as ``validation``, are files of
    `garmentcode_folder`, of which nothing comes where they are not there.
    """

    def read(*names: str, every: int = 1) -> Iterator[dict]:
        for name in names:
            path = SAMPLES if name == SHIPPED else _samples_folder() / f"{name}.jsonl.gz"
            if path.exists():
                with gzip.open(path, "rt") as lines:
                    yield from (json.loads(line) for line in islice(lines, 0, None, every))

    return read


@pytest.fixture(scope="module")
def rough_falls() -> Iterator[None]:
    """Sewn cloth falls in rough steps, a sixth of the usual ones, and is taken wherever it falls to.

    For what is sewn by an untrained network, which comes out crumpled and so falls longest.
    """
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("swifttailor.draping.relax.SUBSTEPS", 3)
        patched.setattr("swifttailor.garment_sewer.relaxing.SLIPPED_CM", float("inf"))
        patched.setattr("swifttailor.garment_sewer.relaxing.MORE_CROSSINGS", float("inf"))
        yield


@pytest.fixture
def square_pattern() -> Pattern:
    """Two 40 x 60 cm rectangles, front and back, sewn along both sides into a tube around the body."""
    corners = [[-20.0, 0.0], [20.0, 0.0], [20.0, 60.0], [-20.0, 60.0]]
    front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 80.0, 25.0)))
    # The back is travelled clockwise, so that its right side faces away from the body.
    back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 80.0, -25.0)))
    sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 1)), Stitch(EdgeRef("front", 3), EdgeRef("back", 3)))
    return Pattern((front, back), sides, "tube")


@pytest.fixture(scope="session")
def drafts() -> dict[str, Pattern]:
    """All drafts with their usual options."""
    return {d.name: draft(d.name) for d in list_drafts()}


@pytest.fixture(scope="session")
def draft_facts(drafts) -> dict[str, GarmentFacts]:
    return {name: measure_facts(pattern) for name, pattern in drafts.items()}


@pytest.fixture(scope="session")
def shipped_patterns(real_samples) -> dict[str, Pattern]:
    """The 20 real patterns beside the tests."""
    return _patterns(real_samples(SHIPPED))


@pytest.fixture(scope="session")
def real_patterns(shipped_patterns, real_samples) -> dict[str, Pattern]:
    """The 20 beside the tests and, where there are more, others."""
    return shipped_patterns | _patterns(real_samples("validation", every=EVERY_REAL))


@pytest.fixture(scope="session")
def real_facts(real_patterns) -> dict[str, GarmentFacts]:
    return {name: measure_facts(pattern) for name, pattern in real_patterns.items()}


@pytest.fixture(scope="session")
def few_real_patterns(real_samples) -> dict[str, Pattern]:
    return _patterns(real_samples(SHIPPED, every=FEW_SHIPPED)) | _patterns(
        real_samples("validation", every=FEW_REAL)
    )


@pytest.fixture(scope="session")
def garmentcode_edits(garmentcode_folder) -> Callable[..., Iterator[tuple[Pattern, Pattern]]]:
    """Goes through GarmentCode's edits of validation patterns, each after its base."""
    if not (garmentcode_folder / "edits.jsonl.gz").exists():
        pytest.skip(f"no edits.jsonl.gz in {garmentcode_folder}")
    bases = {p.id: p for p in read_patterns(garmentcode_folder / "validation.jsonl.gz")}
    edits = [v for v in read_edits(garmentcode_folder / "edits.jsonl.gz") if v.base in bases]

    def read(every: int = 1):
        for version in edits[::every]:
            yield parsed_pattern(bases[version.base]), parsed_pattern(version.pattern)

    return read


def _samples_folder() -> Path:
    default = Path(__file__).resolve().parents[2] / "shared" / "garmentcode"
    return Path(os.environ.get("SWIFTTAILOR_GARMENTCODE", default))


def _patterns(samples: Iterator[dict]) -> dict[str, Pattern]:
    return {s["id"]: read_specification(s["pattern"], name=s["id"]).pattern for s in samples}
