"""Tasks of bodies: a pattern refitted to a size or to measures, and what is known of its wearer."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from swifttailor.body.measure_names import read_measures
from swifttailor.body.size_charts import find_size
from swifttailor.body.wearer import known_measures
from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.studio.bench.documents import Work, document, read_pattern, tailored_document, unsewable
from swifttailor.studio.bench.own_bodies import own_bodies
from swifttailor.studio.bench.part_looks import in_cloth, print_read, print_shown
from swifttailor.studio.bench.wearer_options import LABELS, measures_of_mesh, shown_measures
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.worker.link import Link


def fit(
    link: Link,
    *,
    pattern: dict[str, Any],
    size: str | None,
    figure: str | None,
    measures: dict[str, float],
    called: str = "",
    body: str | None = None,
    color: str | None = None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """A pattern refitted to a body and sewn on it.

    Args:
        link: To the server.
        pattern: Names the body that it was drafted for, or was drafted for the default one.
        size: Of a chart, such as ``women EU 44``.
        figure: Whose shape completes the measures; the size's when None.
        measures: By the names of `body_measures.MEASURES`, cm; they outrank those of the size. Without any,
            a size and a figure the default body is meant.
        called: What the body is called; made up of size and measures where it is empty.
        body: Name of a mesh that was loaded, in place of size, figure and measures.
        color: Of the cloth.
        looks: Of its parts, as requests have them.
        print: On the cloth, as requests have it.

    Raises:
        InputError: There is no such size or figure, no body has these measures, or the mesh is not kept.
    """
    from swifttailor.refitting.refitted import refit

    original = read_pattern(pattern).pattern.canonical()
    named = named_body(size, figure, measures, called) if body is None else _named_mesh(body, called)
    link.stage("fitting", 0.0)
    worn, before = wearing(named), wearing(original.drafted_for)
    if worn.body is before.body or named == original.drafted_for:
        fitted = original
    else:
        fitted = refit(
            original,
            worn.body,
            drafted_for=before.body,
            sew=lambda one: before.tailor.sew(one, edge_length=2.5, relax=False).garment,
        ).pattern
    fitted = replace(fitted, drafted_for=named).canonical()
    link.stage("sewing", 0.0)
    more: dict[str, Any] = {"title": original.name} | ({"color": color} if color else {})
    more |= {} if print is None else {"print": print_shown(print_read(print))}
    try:
        made = worn.tailor.sew(fitted)
    except SwiftTailorError as error:
        return document(fitted, origin="fit", unsewable=unsewable(error), **more)
    made = replace(made, garment=in_cloth(made.garment, color, looks, print))
    for_whom = "the default body" if named is None else named.name
    more |= {"changes": [f"Refitted to {for_whom}."], "seed": None}
    return tailored_document(made, origin="fit", prompt="", **more)


def named_body(
    size: str | None, figure: str | None, measures: dict[str, float], called: str = ""
) -> DraftedFor | None:
    """A body as patterns name it; None for the default body.

    Raises:
        InputError: There is no such size.
    """
    wanted: dict[str, float] = {}
    title = ""
    if size:
        found = find_size(f"{figure} {size}" if figure else size)
        wanted, figure, title = dict(found.measures), found.figure, found.title
    if changed := {k: v for k, v in measures.items() if wanted.get(k) != v}:
        said = [f"{LABELS.get(k, k.replace('_', ' '))} {v:g}" for k, v in changed.items()]
        title = ", ".join([title, *said] if title else said)
    wanted |= measures
    if not wanted and figure is None:
        return None
    return DraftedFor((called or title or figure or "")[:200], figure, tuple(wanted.items()))


def _named_mesh(mesh: str, called: str) -> DraftedFor:
    found = own_bodies().find(mesh)
    return DraftedFor((called or found.name)[:200], None, known_measures(found), mesh)


def wearer(link: Link, *, pattern: dict[str, Any]) -> Work:
    """Who wears a pattern: the body's mesh, what it was made to, and its measures."""
    named = read_pattern(pattern).pattern.drafted_for
    worn = wearing(named)
    of_mesh = named is not None and named.mesh is not None and not worn.stands_in
    answer = {
        "body": worn.name,
        "name": "" if named is None else named.name,
        "figure": None if named is None else named.figure,
        "given": {} if named is None else dict(named.measures),
        "measures": measures_of_mesh(worn.body) if of_mesh else shown_measures(worn.body),
        "mesh": None if named is None else named.mesh,
        "stands_in": worn.stands_in,
    }
    return Work(answer, worn.meshes)


def measures_file(link: Link, *, file_name: str, text: str) -> Work:
    """Measures by name, cm, of a file of GarmentCode's or FreeSewing's measurements.

    Raises:
        InputError: It holds none.
    """
    ending = Path(file_name).suffix.lower()
    if ending not in (".yaml", ".yml", ".json"):
        raise InputError("A file of measures ends in .yaml, .yml or .json.")
    with tempfile.TemporaryDirectory(prefix="swifttailor-studio-") as folder:
        path = Path(folder) / f"measures{ending}"
        path.write_text(text, "utf-8")
        try:
            found = read_measures(path)
        except SwiftTailorError as error:
            raise InputError(str(error).replace(f"'{path}'", "The file")) from None
    return Work({"measures": found})
