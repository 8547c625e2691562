"""Folders of released systems, read as patterns: recognised, listed, read and mended."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from swifttailor.data.released.garmagenet import GARMAGENET
from swifttailor.data.released.layout import Answer, Layout
from swifttailor.data.released.listing import Listing, list_folder
from swifttailor.data.released.output import Output
from swifttailor.data.released.specification_layouts import PLAIN, SPECIFIC
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern import Pattern, Severity, repair_pattern
from swifttailor.pattern.pattern_list import MAX_ID_LENGTH

_BY_NAME: dict[str, Layout] = {layout.name: layout for layout in (PLAIN, *SPECIFIC, GARMAGENET)}
LAYOUTS: tuple[str, ...] = tuple(_BY_NAME)
"""Names of the systems whose folders are read."""


def read_outputs(folder: Path, layout: str | None = None) -> Iterator[Output]:
    """Reads what a released system has written, output by output, in the order of its folders.

    Patterns are mended as ``swifttailor check --repair`` does: those for a body in T-pose around the origin
    are brought to the body here, outlines left open are closed, stitches to nowhere are removed. Links in the
    folder are not followed, and pickles never opened.

    Args:
        folder: Of one run, or of several.
        layout: One of `LAYOUTS`; recognised from the names of the files when None.

    Returns:
        One `Output` for each garment, also for those that cannot be used; what is wrong with one of them
        is in its `error`.

    Raises:
        InputError: The folder cannot be read, is of no known system or of several, or holds too much. That is
            found out before the first output is given.
    """
    listing = list_folder(Path(folder))
    chosen = _recognised(listing) if layout is None else _chosen(layout)
    name = listing.root.resolve().name or "output"
    answers = [replace(a, input=a.input or name) for a in chosen.answers(listing)]
    if not answers:
        raise InputError(
            f"'{folder}' holds no outputs of {chosen.system}: no {chosen.looks_like}{_links(listing)}."
        )
    return _outputs(listing, chosen, answers)


def _chosen(layout: str) -> Layout:
    if layout not in _BY_NAME:
        raise InputError(f"There is no layout {layout!r}. Accepted: {', '.join(LAYOUTS)}.")
    return _BY_NAME[layout]


def _recognised(listing: Listing) -> Layout:
    fitting = [layout for layout in (*SPECIFIC, GARMAGENET) if layout.answers(listing)]
    if not fitting and PLAIN.answers(listing):
        return PLAIN
    if len(fitting) > 1:
        raise InputError(
            f"'{listing.root}' holds files of {' and of '.join(f.system for f in fitting)}. Give the "
            f"folder of one system, or name the layout: {' or '.join(f.name for f in fitting)}."
        )
    if not fitting:
        known = "; ".join(f"{f.looks_like} ({f.name})" for f in _BY_NAME.values())
        raise InputError(
            f"'{listing.root}' is of no known system{_links(listing)}. Looked for were: {known}. "
            "A folder of other .json patterns needs no conversion: it is a list of patterns as it is."
        )
    return fitting[0]


def _links(listing: Listing) -> str:
    if not listing.links:
        return ""
    return f" (links are not followed: '{listing.links[0]}' and {len(listing.links) - 1} more are left out)"


def _outputs(listing: Listing, layout: Layout, answers: list[Answer]) -> Iterator[Output]:
    answers = sorted(answers, key=lambda a: (a.file is None, str(a.file or a.input)))
    for id, answer in zip(_ids(answers), answers, strict=True):
        yield _read(listing, layout, answer, id)


def _read(listing: Listing, layout: Layout, answer: Answer, id: str) -> Output:
    told = Output(id, None, None, answer.error, (), layout.name, _printable(answer.input))
    if answer.file is None:
        return told
    try:
        reading = layout.reading(listing, answer)
        pattern, settled = reading.pattern, ()
        if layout.place is not None:
            pattern, settled = layout.place.settle(pattern)
        repair = repair_pattern(pattern, reading.findings, keep_places=layout.place is not None)
    except SwiftTailorError as error:
        return replace(told, error=str(error).replace(f"{listing.root}/", ""))
    wrong = [f for f in repair.remaining if f.severity is Severity.ERROR]
    place = f" ({wrong[0].where()})" if wrong and wrong[0].where() else ""
    more = f", and {len(wrong) - 1} more" if len(wrong) > 1 else ""
    error = f"{wrong[0].message}{place}{more}." if wrong else ""
    pattern = replace(_in_house(repair.pattern), name=id)
    return replace(told, pattern=pattern, error=error, changes=(*settled, *repair.changes))


def _in_house(pattern: Pattern) -> Pattern:
    """The same places, with angles as GarmentCode's generator writes them: files do not tell the reading."""
    panels = tuple(
        p if p.placement.reading == "intrinsic" else replace(p, placement=p.placement.read_as("intrinsic"))
        for p in pattern.panels
    )
    return replace(pattern, panels=panels)


def _ids(answers: list[Answer]) -> list[str]:
    """A name for each output: the input's and the part, with the folders where several have the same."""
    short = [f"{a.input}_{a.part}" if a.part else a.input for a in answers]
    often = Counter(name.lower() for name in short)
    names = []
    for name, answer in zip(short, answers, strict=True):
        if often[name.lower()] > 1 and answer.file is not None:
            name = str(answer.file.parent / name)
        names.append(_printable(name))
    again = Counter(name.lower() for name in names)
    return [
        f"{name[: MAX_ID_LENGTH - 9]}-{_digest(a, k)}" if again[name.lower()] > 1 else name
        for k, (name, a) in enumerate(zip(names, answers, strict=True))
    ]


def _digest(answer: Answer, number: int) -> str:
    text = f"{answer.file or number}/{answer.input}/{answer.part}"
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:8]


def _printable(name: str) -> str:
    """A name that fits into a list of patterns: short, printable, and not like the number of a line."""
    text = "".join(c if c.isprintable() else "_" for c in name).lstrip("#") or "output"
    if text == name and len(text) <= MAX_ID_LENGTH:
        return text
    digest = hashlib.sha256(name.encode("utf-8", "surrogateescape")).hexdigest()[:8]
    return f"{text[: MAX_ID_LENGTH - 9]}-{digest}"
