"""Documents: what all work answers with."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from swifttailor.describing import GarmentFacts
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.garment import Garment
from swifttailor.pattern import Finding, Pattern, Reading, read_specification, to_specification
from swifttailor.pattern.trims.names import TRIMS, trim_said
from swifttailor.studio.bench.chips import EMPTY_READING, change_line, reading_of, shown_chips, sliders
from swifttailor.studio.bench.mesh_files import garment_record
from swifttailor.studio.bench.part_looks import looks_of, print_shown
from swifttailor.studio.bench.pattern_facts import check, finding_infos, seam_infos
from swifttailor.studio.bench.trim_blocks import trim_marks
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.mesh_record import MeshRecord
from swifttailor.studio.worker.refusal import refusal_of
from swifttailor.tailor.order import one_line
from swifttailor.tailor.reading import facts_of
from swifttailor.tailor.tailored import Tailored


@dataclass(frozen=True, eq=False)
class Work:
    """What a task hands over: an answer as plain values, and the meshes that it names."""

    answer: Any
    meshes: tuple[MeshRecord, ...] = field(default=())
    stopped: bool = False
    """Whether it was asked to stop, and this is what it had."""


def read_pattern(specification: dict[str, Any]) -> Reading:
    """A pattern that a client has sent.

    Raises:
        PatternError: It is no pattern.
    """
    return read_specification(specification)


def document(
    pattern: Pattern,
    *,
    origin: str,
    title: str = "",
    garment: Garment | None = None,
    state: str = "none",
    edge_length: float = 2.0,
    reader_findings: tuple[Finding, ...] = (),
    **more: Any,
) -> Work:
    """A document of a pattern and, where there is one, its garment.

    Args:
        pattern: In canonical order.
        origin: What it comes from.
        title: Of the garment.
        garment: Sewn from the pattern.
        state: How that came about.
        edge_length: Of its mesh, cm.
        reader_findings: What reading the pattern found.
        more: Other fields of the document.
    """
    findings = check(pattern, reader_findings)
    facts = facts_of(pattern)
    record = None if garment is None else garment_record(garment, edge_length)
    worn = wearing(pattern.drafted_for)
    quality = None if garment is None else garment.report.get("quality")
    answer = {
        "origin": origin,
        "title": one_line(title or pattern.name),
        "pattern": to_specification(pattern),
        "findings": finding_infos(pattern, findings, try_mending=True),
        "seams": seam_infos(pattern, findings),
        "trims": trim_marks(pattern),
        "mesh": None if record is None else record.name,
        "unsewable": None,
        "body": worn.name,
        "reading": EMPTY_READING | {"shown": shown_chips(facts, pattern=pattern)},
        "dimensions": sliders(facts),
        "description": caption(facts),
        "notes": [],
        "warnings": [],
        "changes": [],
        "open": [],
        "quality": None
        if quality is None
        else {"accepted": bool(quality["accepted"]), "reasons": list(quality["reasons"])},
        "garment": state if garment is not None else "none",
        "color": cloth_color(pattern) if garment is None else _shown_color(garment),
        "looks": looks_of(garment),
        "print": None if garment is None else print_shown(garment.print),
        "fabric": "cotton",
        "edge_length": edge_length,
        "seed": None,
        "prompt": "",
        "part": None,
        "seconds": {} if garment is None else numbers(garment.report.get("seconds", {})),
    }
    return Work(answer | more, worn.meshes if record is None else (record, *worn.meshes))


def tailored_document(
    made: Tailored, *, origin: str, prompt: str, edge_length: float = 2.0, **more: Any
) -> Work:
    """The document of what a tailor has made.

    Args:
        made: By `Tailor.generate`, `edit` or `sew`.
        origin: What it comes from.
        prompt: The text that was asked for.
        edge_length: Of the mesh, cm.
        more: Other fields of the document.
    """
    facts = facts_of(made.pattern)
    reading = reading_of(made, facts)
    changes = [change.message for change in made.changes]
    wanted = made.answer.wanted
    if wanted is not None and wanted.order.edit is not None:
        changes += [change_line(change) for change in made.answer.seen or ()]
        changes += [f"put on: {trim_said(name, made.pattern.button_count)}" for name in made.answer.put_on]
        changes += [f"taken off: {TRIMS[name]}" for name in made.answer.taken_off]
    cloth = reading["fabric"] or "cotton"
    work = document(
        made.pattern,
        origin=origin,
        garment=made.garment,
        state="finished" if "quality" in made.report else "sewn",
        edge_length=edge_length,
    )
    known = {
        "prompt": prompt,
        "reading": reading,
        "notes": list(made.notes),
        "warnings": list(made.warnings),
        "changes": changes,
        "open": [chip["text"] for chip in reading["cannot"] if chip["claim"] or chip["dimension"]],
        "seed": made.answer.seed,
        "fabric": cloth,
    }
    return replace(work, answer=work.answer | known | more)


def _shown_color(garment: Garment) -> str:
    """That of its cloth; of printed cloth of no other colour the print's first."""
    printed = None if garment.print is None else garment.print.colors[0]
    return garment.color or printed or cloth_color(garment.pattern)


def unsewable(error: SwiftTailorError) -> dict[str, str]:
    """Why there is no garment, for a document."""
    return refusal_of(error)


def caption(facts: GarmentFacts | None) -> str:
    """A pattern in English; empty where it cannot be measured."""
    from swifttailor.wording import write_caption

    if facts is None:
        return ""
    try:
        return write_caption(facts, 0, style="description").text
    except SwiftTailorError:
        return ""


def numbers(seconds: dict[str, Any]) -> dict[str, float]:
    """Seconds by stage."""
    return {name: round(float(value), 4) for name, value in seconds.items()}
