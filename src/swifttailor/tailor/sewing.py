"""From patterns to garments by the network: checked, prepared, predicted together, decoded one by one."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.body import Body
from swifttailor.body.probe import probe_body
from swifttailor.body.wearer import body_of
from swifttailor.clock import DIGITS
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import has_part, plain_but_for
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.garment_sewer.sewer import BATCH, Prepared
from swifttailor.pattern import Pattern, Reading, check_pattern, read_pattern_file, repair_pattern
from swifttailor.pattern.check import BodyProbe, errors_of, require_no_errors
from swifttailor.pattern.panel import RotationReading
from swifttailor.pattern.trims.quilting import QUILTING, lines_apart
from swifttailor.progress import StageProgress
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.protocols import Sewer
from swifttailor.tailor.tailored import Tailored
from swifttailor.tailor.verdict import Verdict
from swifttailor.tailor.worn_shoulders import SLIPS, slips_off
from swifttailor.wishes.looks.flecks import flecked
from swifttailor.wishes.looks.naps import napped, puffed
from swifttailor.wishes.looks.ribs import ribbed
from swifttailor.wishes.looks.satin import SATIN, is_satin

if TYPE_CHECKING:
    from swifttailor.draping.fabric import Fabric
    from swifttailor.pattern.drafted_for import DraftedFor

_LOSING = frozenset({"dangling-stitch", "open-loop"})
"""Errors that are repaired by leaving a seam open, or by an edge that nobody drew: only when asked."""


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
    relax: bool = True
    """Whether cloth falls for a moment, before it is finished too."""


def prepare(sewer: Sewer, answer: Answer, options: SewingOptions) -> Answer:
    """Gets a pattern ready to be sewn.

    Raises:
        SwiftTailorError: It cannot be sewn.
    """
    started = time.perf_counter()
    prepared = sewer.prepare(answer.pattern, edge_length=options.edge_length, resolution=options.resolution)
    seconds = answer.seconds | {"drawing": time.perf_counter() - started}
    return replace(answer, prepared=prepared, seconds=seconds)


@dataclass(frozen=True)
class PatternSource:
    """A pattern to sew as it was read, or why it could not be."""

    name: str
    """In messages."""
    reading: Reading | SwiftTailorError
    seconds: float

    @property
    def drafted_for(self) -> DraftedFor | None:
        """Whom the pattern says it was drafted for."""
        return None if isinstance(self.reading, SwiftTailorError) else self.reading.pattern.drafted_for


def read_sources(
    patterns: Iterable[Pattern | Path | str], rotation: RotationReading
) -> Iterator[PatternSource]:
    """Reads patterns one by one; what is wrong with one concerns no other.

    Args:
        patterns: Patterns, or GarmentCode JSON files.
        rotation: How files mean their placement angles.
    """
    for source in patterns:
        started = time.perf_counter()
        reading: Reading | SwiftTailorError
        if isinstance(source, Pattern):
            name, reading = f"The pattern '{source.name}'", Reading(source, ())
        else:
            name = f"'{source}'"
            try:
                reading = read_pattern_file(source, rotation=rotation)
            except SwiftTailorError as error:
                reading = error
        yield PatternSource(name, reading, time.perf_counter() - started)


def prepare_sources(
    sewer: Callable[[], Sewer],
    sources: Iterable[PatternSource],
    options: SewingOptions,
    body: Body | None = None,
    *,
    fit: bool = False,
) -> Iterator[Answer | SwiftTailorError]:
    """Checks and prepares patterns one by one; what is wrong with one concerns no other.

    Patterns with errors are refused, unless a repair that loses nothing leaves none.

    Args:
        sewer: Gives who prepares them; called when there is a pattern without errors.
        sources: Patterns as they were read.
        options: How they are sewn.
        body: Who wears them; the default body when None.
        fit: Whether they are refitted to `body` first, from the bodies that they were drafted for.
    """
    for source in sources:
        started = time.perf_counter()
        reading = source.reading
        if isinstance(reading, SwiftTailorError):
            yield reading
            continue
        try:
            drafted_for = body_of(source.drafted_for if fit else None)
            probe = probe_body(drafted_for if body is None or fit else body)
            answer = _sewable(reading, source.name, options, probe)
        except SwiftTailorError as error:
            yield error
            continue
        answer = replace(answer, seconds={"loading": source.seconds + time.perf_counter() - started})
        opened = sewer()  # what is wrong with its weights concerns all patterns
        try:
            yield _prepared(opened, answer, options, body if fit else None)
        except SwiftTailorError as error:
            # What cannot be sewn as it is may be once it is mended; that is said, not done quietly.
            mended = replace(_mended(reading, probe), seconds=answer.seconds)
            if options.repair or not answer.verdict.findings or not mended.changes:
                yield error
                continue
            try:
                yield _prepared(opened, mended, options, body if fit else None)
            except SwiftTailorError as later:
                yield later


def _prepared(sewer: Sewer, answer: Answer, options: SewingOptions, body: Body | None) -> Answer:
    """A pattern ready to be sewn, refitted first where there is a body."""
    if body is not None:
        from swifttailor.tailor.refitted import refitted

        answer = refitted(answer, body)
    return prepare(sewer, answer, options)


def _sewable(reading: Reading, name: str, options: SewingOptions, probe: BodyProbe) -> Answer:
    """A pattern without errors.

    Raises:
        PatternError: It has errors that a repair leaves, or removes by giving up a seam or drawing an edge.
    """
    answer = (_mended if options.repair else _checked)(reading, probe)
    errors = errors_of(answer.verdict.findings)
    if errors and not options.repair and _LOSING.isdisjoint(error.code for error in errors):
        mended = _mended(reading, probe)
        if not errors_of(mended.verdict.findings):
            return mended
    require_no_errors(errors, name, repaired=options.repair, option=True)
    return answer


def _checked(reading: Reading, probe: BodyProbe) -> Answer:
    findings = check_pattern(reading.pattern, reader_findings=reading.findings, body=probe)
    return Answer(reading.pattern, Verdict(findings))


def _mended(reading: Reading, probe: BodyProbe) -> Answer:
    repaired = repair_pattern(reading.pattern, reading.findings, body=probe)
    return Answer(repaired.pattern, Verdict(repaired.remaining), repaired.changes)


def sew_answers(
    sewer: Sewer,
    answers: Sequence[Answer],
    options: SewingOptions,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    progress: StageProgress | None = None,
) -> Iterator[Tailored | SwiftTailorError]:
    """Makes the garments of prepared patterns, a few through the network at a time.

    Args:
        sewer: What prepared them.
        answers: Prepared patterns.
        options: How they are sewn.
        body: What they are worn by; the default body when None.
        fabric: What hangs, where a text does not name another.
        progress: Called with the name of a stage of physics and the share of it that is done.

    Yields:
        Each garment, with the seconds of its stages in its report, or why there is none.
    """
    for first in range(0, len(answers), BATCH):
        part = answers[first : first + BATCH]
        started = time.perf_counter()
        predicted = sewer.predict([one.prepared for one in part])
        share = (time.perf_counter() - started) / len(part)
        for answer, values in zip(part, predicted, strict=True):
            started = time.perf_counter()
            try:
                garment = sewer.decode(answer.prepared, values)
                seconds = answer.seconds | {"network": share, "decoding": time.perf_counter() - started}
                report = _basic_report(garment, options) | garment.report | {"seconds": _rounded(seconds)}
                garment = replace(garment, report=report)
                made_of = _made_of(answer, fabric)
                garment = replace(garment, report=garment.report | made_of.of(garment))
                if options.finish:
                    garment = _finished(garment, options, body, made_of.fabric, progress)
                elif options.relax:
                    garment = relaxed(garment, body=body, fabric=made_of.fabric, progress=progress)
            except SwiftTailorError as error:
                yield error
            else:
                garment = replace(garment, cloth=made_of.name)
                moved = options.finish or "relaxed_frames" in garment.report
                yield _handed_over(garment, answer, None if moved else values, body)


@dataclass(frozen=True)
class _MadeOf:
    """What a garment is made of."""

    fabric: Fabric
    name: str | None
    """None where nobody chose it: then it shines as it always did."""

    def of(self, garment: Garment) -> dict[str, Any]:
        """What the garment's report says of it."""
        from swifttailor.draping.cloth_need import cloth_need

        return {"fabric": self.fabric.name, "cloth": cloth_need(garment.mesh, self.fabric)}


def _made_of(answer: Answer, fabric: Fabric | str) -> _MadeOf:
    """What the order says, else its text, else what the tailor makes all garments of."""
    from swifttailor.draping.known_fabrics import get_fabric

    wanted = answer.wanted
    asked = None if wanted is None else wanted.order.fabric or wanted.heard.cloth
    found = get_fabric(asked or fabric)
    return _MadeOf(found, None if asked is None and found.name == "cotton" else found.name)


def _finished(
    garment: Garment,
    options: SewingOptions,
    body: Body | None,
    fabric: Fabric | str,
    progress: StageProgress | None,
) -> Garment:
    from swifttailor.draping.finish_or_drape import finish_or_drape
    from swifttailor.draping.time_limit import TimeLimit, usual_time_limit

    limited = TimeLimit(
        usual_time_limit(options.edge_length),
        progress or (lambda stage, share: None),
        instead="Choose a longer --edge-length, or leave out --finish.",
    )
    # Hung from where the network put it, cloth that passes through itself there stays so.
    begun = relaxed(garment, body=body, fabric=fabric, progress=limited) if options.relax else garment
    return finish_or_drape(begun, edge_length=options.edge_length, body=body, fabric=fabric, progress=limited)


def _rounded(seconds: dict[str, float]) -> dict[str, float]:
    return {name: round(value, DIGITS) for name, value in seconds.items()}


def _basic_report(garment: Garment, options: SewingOptions) -> dict[str, Any]:
    """What a garment's folder cannot be without, whatever sewer made it."""
    return {
        "edge_length_cm": options.edge_length,
        "rotation": garment.pattern.panels[0].placement.reading,
        "vertices": garment.mesh.vertex_count,
        "faces": len(garment.faces),
        "panels": len(garment.pattern.panels),
        "stitches": len(garment.pattern.stitches),
    }


def _seen_on(answer: Answer, garment: Garment, body: Body | None) -> Answer:
    """The answer with what is seen of its garment on the body alone."""
    measures = body_of(garment.pattern.drafted_for).measurements if body is None else body.measurements
    if not slips_off(garment, measures):
        return answer
    verdict = replace(answer.verdict, sits_badly=(*answer.verdict.sits_badly, SLIPS))
    return replace(answer, verdict=verdict)


def _handed_over(garment: Garment, answer: Answer, predicted: Any, body: Body | None) -> Tailored:
    """Images are those that the network saw and drew, where it is one that does."""
    images = answer.prepared if isinstance(answer.prepared, Prepared) else None
    wanted = answer.wanted
    if wanted is not None:
        answer = _seen_on(answer, garment, body)
        color = wanted.color or cloth_color(garment.pattern)
        woven = None if wanted.heard.ribs is None else ribbed(color, wanted.heard.ribs)
        woven = flecked(color) if wanted.heard.is_flecked else woven
        if QUILTING in garment.pattern.trims:
            woven = puffed(color, lines_apart(garment.pattern))
        elif wanted.heard.nap is not None:
            woven = napped(color, wanted.heard.nap)
        looks = tuple([look for look in wanted.looks if has_part(garment.pattern, look.part)])
        looks = plain_but_for(looks, color)
        garment = replace(garment, color=wanted.color, print=wanted.print or woven, looks=looks)
        if garment.cloth == "silk" and wanted.heard.words is not None and is_satin(wanted.heard.words):
            garment = replace(garment, cloth=SATIN)
    return Tailored(
        garment,
        replace(answer, prepared=None),
        layout=None if images is None else images.layout,
        prediction=None if images is None else predicted,
        body=body,
    )
