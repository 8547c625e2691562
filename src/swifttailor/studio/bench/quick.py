"""Tasks that are answered at once: live sewing, opening, checking, mending, describing, altering."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from swifttailor.clock import Clock
from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern import Pattern, Reading, repair_pattern, to_specification
from swifttailor.recutting import alter as recut
from swifttailor.recutting.set_dimension import set_dimension
from swifttailor.studio.bench.chips import EMPTY_READING, change_chip, shown_chips, sliders
from swifttailor.studio.bench.documents import (
    Work,
    caption,
    document,
    numbers,
    read_pattern,
    tailored_document,
    unsewable,
)
from swifttailor.studio.bench.mesh_files import garment_record
from swifttailor.studio.bench.part_looks import in_cloth, print_read, print_shown
from swifttailor.studio.bench.pattern_facts import body_probe, check, finding_infos, seam_infos
from swifttailor.studio.bench.trim_blocks import trim_marks
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.worker.link import Link
from swifttailor.studio.worker.refusal import refusal_of
from swifttailor.tailor.reading import facts_of
from swifttailor.wording.wish_lines import wish_line


def live(link: Link, *, pattern: dict[str, Any], edge_length: float, dragging: bool = False) -> Work:
    """The garment of a pattern while it is dragged: findings, seams and a mesh, or why there is none.

    Panels, edges and stitches are numbered as they were sent.

    Args:
        link: To the server.
        pattern: The state to sew.
        edge_length: Of the mesh, cm.
        dragging: Whether another state follows at once: it is sewn in less time, and less finely.
    """
    clock = Clock()
    reading = read_pattern(pattern)
    clock.stop("loading")
    seconds, error, record = {}, None, None
    try:
        worn = wearing(reading.pattern.drafted_for)
        tailor = worn.hasty_tailor if dragging else worn.tailor
        made = tailor.sew(reading.pattern, edge_length=edge_length, relax=not dragging)
    except SwiftTailorError as refused:
        error = refusal_of(refused)
        findings = check(reading.pattern, reading.findings)
    else:
        record = garment_record(made.garment, edge_length)
        # What had to be mended to be sewn has no findings left; those of what is drawn are wanted.
        findings = made.findings if not made.changes else check(reading.pattern)
        findings = (*reading.findings, *findings)
        seconds = numbers(made.seconds)
    clock.stop("sewing")
    answer = {
        "status": "unsewable" if record is None else "sewn",
        "mesh": None if record is None else record.name,
        "findings": finding_infos(reading.pattern, findings),
        "seams": seam_infos(reading.pattern, findings),
        "trims": trim_marks(reading.pattern),
        "error": error,
        "seconds": seconds | numbers(clock.seconds),
    }
    return Work(answer, () if record is None else (record,))


def open_pattern(link: Link, *, pattern: dict[str, Any], title: str, sew: bool) -> Work:
    """A GarmentCode file as a document, sewn where that is wanted and can be done."""
    reading = read_pattern(pattern)
    opened = reading.pattern.canonical()
    if title:
        opened = replace(opened, name=title)
    return _sewn_document(opened, reading, origin="open", sew=sew, title=title or opened.name)


def check_only(link: Link, *, pattern: dict[str, Any]) -> Work:
    """Findings and seams, numbered as they were sent."""
    reading = read_pattern(pattern)
    findings = check(reading.pattern, reading.findings)
    return Work(
        {
            "findings": finding_infos(reading.pattern, findings, try_mending=True),
            "seams": seam_infos(reading.pattern, findings),
            "trims": trim_marks(reading.pattern),
        }
    )


def repair(link: Link, *, pattern: dict[str, Any]) -> Work:
    """What can safely be mended is."""
    reading = read_pattern(pattern)
    done = repair_pattern(reading.pattern, reading.findings, body=body_probe(reading.pattern))
    mended = replace(done.pattern.canonical(), drafted_for=reading.pattern.drafted_for)
    findings = check(mended)
    return Work(
        {
            "pattern": to_specification(mended),
            "changes": [f"{c.where()}: {c.message}" if c.where() else c.message for c in done.changes],
            "findings": finding_infos(mended, findings, try_mending=True),
            "seams": seam_infos(mended, findings),
            "trims": trim_marks(mended),
        }
    )


def describe(link: Link, *, pattern: dict[str, Any]) -> Work:
    """What a pattern shows, in words and on sliders."""
    described = read_pattern(pattern).pattern
    facts = facts_of(described)
    return Work(
        {
            "description": caption(facts),
            "reading": EMPTY_READING | {"shown": shown_chips(facts, pattern=described)},
            "dimensions": sliders(facts),
        }
    )


def alter(
    link: Link,
    *,
    pattern: dict[str, Any],
    changes: list[dict[str, Any]],
    sew: bool = True,
    color: str | None = None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """A pattern recut to chips and sliders, and sewn."""
    original = read_pattern(pattern).pattern.canonical()
    link.stage("altering", 0.0)
    altered, said = original, []
    wishes: list[Change] = []
    for change in changes:
        exact = _exact(altered, change)
        if exact is None:
            wishes.append(_wish(change))
            continue
        altered, words = set_dimension(altered, *exact)
        said += [words] if words else []
    holding, missed = list[Change](), list[Change]()
    if wishes:
        found = recut(altered, wishes)
        altered, missed = found.pattern.canonical(), list(found.open)
        holding = [w for w in wishes if w not in missed]
        said += found.cuts
    altered = replace(altered, drafted_for=original.drafted_for)
    link.stage("sewing", 0.0)
    work = _sewn_document(
        altered,
        Reading(altered, ()),
        origin="alter",
        sew=sew,
        title=original.name,
        color=color,
        looks=looks,
        print=print,
    )
    facts = facts_of(altered)

    def chips(some: list[Change], holds: bool) -> list[dict[str, Any]]:
        return [change_chip(w, certainty=1.0, source="text", holds=holds, spans={}) for w in some]

    made, cannot = chips(holding, True), chips(missed, False)
    shown = shown_chips(facts, [*made, *cannot], pattern=altered)
    reading = EMPTY_READING | {"made": made, "cannot": cannot, "shown": shown}
    notes = work.answer["notes"]
    if not said and not missed:
        notes = [*notes, "Nothing was changed: it was so already."]
    answer = work.answer | {
        "reading": reading,
        "changes": said,
        "open": [wish_line(w) for w in missed],
        "notes": notes,
    }
    return replace(work, answer=answer)


def _sewn_document(
    pattern: Pattern,
    reading: Reading,
    *,
    origin: str,
    sew: bool,
    title: str,
    color: str | None = None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    more: dict[str, Any] = {"title": title} | ({} if color is None else {"color": color})
    more |= {} if print is None else {"print": print_shown(print_read(print))}
    if not sew:
        return document(pattern, origin=origin, reader_findings=reading.findings, **more)
    try:
        made = wearing(pattern.drafted_for).tailor.sew(pattern)
    except SwiftTailorError as error:
        return document(
            pattern, origin=origin, reader_findings=reading.findings, unsewable=unsewable(error), **more
        )
    made = replace(made, garment=in_cloth(made.garment, color, looks, print))
    mended = ["Mended, since it could not be sewn as it was."] if made.changes else []
    read = [f"{f.code}: {f.message}" for f in reading.findings]
    return tailored_document(made, origin=origin, prompt="", seed=None, notes=[*mended, *read], **more)


def _exact(pattern: Pattern, change: dict[str, Any]) -> tuple[str, float] | None:
    """A dimension and the value that it is to have; None of what is said in words."""
    name = change.get("dimension")
    if name is None:
        return None
    if change.get("value") is not None:
        return name, float(change["value"])
    from swifttailor.describing.dimensions import QUANTITIES

    facts = facts_of(pattern)
    was = QUANTITIES[name].of(facts) if facts is not None and name in QUANTITIES else None
    if was is None:
        raise InputError(f"This garment has no '{name}' that can be changed.")
    return name, was + float(change["by"])


def _wish(change: dict[str, Any]) -> Change:
    name, value = change["claim"], change["value"]
    kind = CLAIM_TYPES.get(name)
    if kind is not None and kind.measure is None and not isinstance(value, str):
        raise InputError(
            f"The claim '{name}' takes a word, received {value:g}. Known: {', '.join(kind.words)}."
        )
    return Gain(Claim(name, value))
