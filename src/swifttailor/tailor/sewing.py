"""From patterns to garments by the network: checked, drawn, predicted together, decoded one by one."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from swifttailor.arrays import Floats
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.sewer import BATCH, GarmentSewer, Prepared
from swifttailor.pattern import Finding, Pattern, Reading, check_pattern, read_pattern_file, repair_pattern
from swifttailor.pattern.check import Change
from swifttailor.pattern.panel import RotationReading
from swifttailor.progress import StageProgress


@dataclass(frozen=True)
class SewingOptions:
    """How patterns are sewn."""

    edge_length: float = 2.0
    """Of the mesh, cm."""
    resolution: int | None = None
    """Of the images; the network's own when None."""
    repair: bool = False
    """Whether patterns are mended first."""
    finish: bool = False
    """Whether garments hang to rest by physics in the end."""


@dataclass(frozen=True, eq=False)
class Checked:
    """A pattern and what a check finds in it."""

    pattern: Pattern
    findings: tuple[Finding, ...] = ()
    changes: tuple[Change, ...] = ()
    """What was mended."""
    reading: Reading | None = None
    """Where it can be mended still: as it was read."""


@dataclass(frozen=True, eq=False)
class Ready:
    """A pattern that can be sewn, drawn for the network."""

    checked: Checked
    prepared: Prepared
    seconds: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Sewn:
    """A garment and what it was made of."""

    ready: Ready
    garment: Garment
    prediction: Floats
    """(n, 3) cm: where the network puts the occupied pixels of the images."""


def check(reading: Reading, *, repair: bool) -> Checked:
    """Looks for faults in a pattern that was read, and mends it where that is asked for."""
    if repair:
        repaired = repair_pattern(reading.pattern, reading.findings)
        return Checked(repaired.pattern, repaired.remaining, repaired.changes)
    findings = check_pattern(reading.pattern, reader_findings=reading.findings)
    return Checked(reading.pattern, findings, reading=reading)


def make_ready(sewer: GarmentSewer, checked: Checked, options: SewingOptions) -> Ready:
    """Lays a pattern out, meshes it and draws it for the network.

    Raises:
        SwiftTailorError: It cannot be sewn, even mended.
    """
    started = time.perf_counter()

    def draw(one: Checked) -> Ready:
        prepared = sewer.prepare(one.pattern, edge_length=options.edge_length, resolution=options.resolution)
        return Ready(one, prepared, {"drawing": time.perf_counter() - started})

    try:
        return draw(checked)
    except SwiftTailorError:
        # What cannot be sewn as it is may be once it is mended; that is said, not done quietly.
        if checked.reading is None or not checked.findings:
            raise
        mended = check(checked.reading, repair=True)
        if not mended.changes:
            raise
        return draw(mended)


def sew_ready(
    sewer: GarmentSewer, ready: Sequence[Ready], options: SewingOptions, progress: StageProgress | None = None
) -> Iterator[Sewn | SwiftTailorError]:
    """Makes the garments, a few through the network at a time; the reports have the seconds of each stage."""
    for first in range(0, len(ready), BATCH):
        part = ready[first : first + BATCH]
        started = time.perf_counter()
        predicted = sewer.predict([one.prepared for one in part])
        share = (time.perf_counter() - started) / len(part)
        for one, values in zip(part, predicted, strict=True):
            try:
                yield _complete(sewer, one, values, share, options, progress)
            except SwiftTailorError as error:
                yield error


def _complete(
    sewer: GarmentSewer,
    ready: Ready,
    values: Floats,
    network_seconds: float,
    options: SewingOptions,
    progress: StageProgress | None,
) -> Sewn:
    started = time.perf_counter()
    garment = sewer.decode(ready.prepared, values)
    seconds = ready.seconds | {"network": network_seconds, "decoding": time.perf_counter() - started}
    report = garment.report | {"seconds": {name: round(value, 4) for name, value in seconds.items()}}
    garment = replace(garment, report=report)
    if options.finish:
        from swifttailor.draping.finish_or_drape import finish_or_drape

        garment = finish_or_drape(garment, edge_length=ready.prepared.edge_length, progress=progress)
    return Sewn(ready, garment, values)


def read_and_make_ready(
    sewer: GarmentSewer,
    patterns: Iterable[Pattern | Path | str],
    options: SewingOptions,
    rotation: RotationReading,
) -> Iterator[Ready | SwiftTailorError]:
    """Reads, checks and draws patterns one by one; what is wrong with one concerns no other."""
    for source in patterns:
        started = time.perf_counter()
        try:
            if isinstance(source, Pattern):
                reading = Reading(source, ())
            else:
                reading = read_pattern_file(source, rotation=rotation)
            checked = check(reading, repair=options.repair)
            loading = time.perf_counter() - started
            ready = make_ready(sewer, checked, options)
            yield replace(ready, seconds={"loading": loading} | ready.seconds)
        except SwiftTailorError as error:
            yield error
