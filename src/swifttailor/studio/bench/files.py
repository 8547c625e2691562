"""Tasks of files: exports in every format, and the garment's files of a project's folder."""

from __future__ import annotations

import io
import tempfile
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

from swifttailor.body import Body
from swifttailor.errors import GeometryError, InputError, SwiftTailorError
from swifttailor.garment.cloth_color import COLOR
from swifttailor.garment.cloth_print import PRINT
from swifttailor.garment.folder import DRAWING, OF_A_GARMENT, PATTERN, write_files
from swifttailor.garment.formats import MESH_ENDINGS, write_garment_mesh
from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import LOOKS
from swifttailor.garment.triangle_mesh import mesh_of_garment
from swifttailor.output_folder import OutputFolder
from swifttailor.pattern import Pattern
from swifttailor.pattern.svg import write_svg
from swifttailor.studio.bench import sewing_exports
from swifttailor.studio.bench.documents import Work, read_pattern
from swifttailor.studio.bench.mesh_files import garment_of, same_pattern
from swifttailor.studio.bench.part_looks import in_cloth
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.mesh_record import MeshRecord
from swifttailor.studio.worker.link import Link
from swifttailor.tailor.tailored import PREVIEW_SIZE

OF_PATTERNS = ("json", "svg")
_WITHOUT_PRINT = ("usda",)
_EPOCH = 1980, 1, 1, 0, 0, 0
"""Of files in a zip, so that the same garment gives the same bytes."""


def export(
    link: Link, *, pattern: dict[str, Any], mesh: MeshRecord | None, format: str, facts: dict[str, Any]
) -> Work:
    """The bytes of a file.

    Args:
        link: To the server.
        pattern: What is shown.
        mesh: Its garment, where there is one.
        format: Ending without the dot, or ``zip`` of everything.
        facts: What is known besides, for the report: title, prompt, seed, color, looks, print.
    """
    shown = read_pattern(pattern).pattern.canonical()
    shown = replace(shown, name=facts.get("title") or shown.name)
    with tempfile.TemporaryDirectory(prefix="swifttailor-studio-") as folder:
        place = Path(folder)
        if format in OF_PATTERNS:
            return Work(_pattern_file(shown, place / f"pattern.{format}"))
        if format in sewing_exports.FORMATS:
            return Work(sewing_exports.sewing_file(shown, place, format))
        garment = _garment(shown, mesh, facts)
        if format == "png":
            write_files(garment, place, body=_body(garment), preview=True, preview_size=PREVIEW_SIZE)
            return Work((place / "preview.png").read_bytes())
        if f".{format}" in MESH_ENDINGS:
            path = place / f"garment.{format}"
            # USD as text is one file, which has no room for the picture of a print.
            shown = replace(garment, print=None) if format in _WITHOUT_PRINT else garment
            write_garment_mesh(mesh_of_garment(shown), path)
            return Work(path.read_bytes())
        if format == "zip":
            return Work(_zip(garment, place))
    raise InputError(f"There is no format '{format}'.")


def save(
    link: Link,
    *,
    folder: str,
    pattern: dict[str, Any],
    mesh: MeshRecord | None,
    facts: dict[str, Any],
) -> Work:
    """Writes the files that the command line reads into a project's folder, all of them or none.

    Args:
        link: To the server.
        folder: Of the project.
        pattern: What is shown.
        mesh: Its garment; without one, or with that of another pattern, only the pattern is written.
        facts: As for `export`.
    """
    shown = read_pattern(pattern).pattern.canonical()
    shown = replace(shown, name=facts.get("title") or shown.name)
    before = _kept(mesh, shown)
    garment = None if before is None else _described(before, facts)
    with OutputFolder(folder) as output, output.fill(stale=OF_A_GARMENT) as staging:
        if garment is not None:
            write_files(garment, staging, body=_body(garment), preview=True, preview_size=PREVIEW_SIZE)
        else:
            shown.save(staging / PATTERN)
            write_svg(shown, staging / DRAWING)
    return Work({"garment": garment is not None})


def _pattern_file(pattern: Pattern, path: Path) -> bytes:
    if path.suffix == ".svg":
        write_svg(pattern, path)
    else:
        pattern.save(path)
    return path.read_bytes()


def _garment(pattern: Pattern, mesh: MeshRecord | None, facts: dict[str, Any]) -> Garment:
    """The garment that is shown, or the pattern sewn where it is another's."""
    garment = _kept(mesh, pattern)
    return _described(
        wearing(pattern.drafted_for).tailor.sew(pattern).garment if garment is None else garment, facts
    )


def _kept(mesh: MeshRecord | None, pattern: Pattern) -> Garment | None:
    """The garment of a mesh, where it is one of this pattern and can be built again."""
    try:
        garment = None if mesh is None else garment_of(mesh)
    except GeometryError:
        return None
    return garment if garment is not None and same_pattern(garment.pattern, pattern) else None


def _body(garment: Garment) -> Body:
    return wearing(garment.pattern.drafted_for).body


def _described(garment: Garment, facts: dict[str, Any]) -> Garment:
    known = {name: facts[name] for name in ("title", "prompt", "seed") if facts.get(name) not in (None, "")}
    garment = in_cloth(garment, facts.get("color"), facts.get("looks") or (), facts.get("print"))
    said: dict[str, Any] = {LOOKS: [look.to_json() for look in garment.looks]} if garment.looks else {}
    if garment.color is not None:
        said[COLOR] = garment.color
    if garment.print is not None:
        said[PRINT] = garment.print.to_json()
    return replace(garment, report=garment.report | {"studio": known} | said)


def _zip(garment: Garment, place: Path) -> bytes:
    """Everything that the command line writes, in one file."""
    from swifttailor.garment.folder import GGI
    from swifttailor.ggi.file import write_ggi
    from swifttailor.tailor.answer import Answer
    from swifttailor.tailor.tailored import Tailored

    body = _body(garment)
    write_files(garment, place, body=body, preview=True, preview_size=PREVIEW_SIZE)
    write_ggi(Tailored(garment, Answer(garment.pattern), body=body).images, place / GGI)
    for ending in MESH_ENDINGS:
        path = place / f"garment{ending}"
        if not path.exists() and not ending.startswith(".usd"):
            write_garment_mesh(mesh_of_garment(garment), path)
    try:
        write_garment_mesh(mesh_of_garment(garment), place / "garment.usdz")
    except SwiftTailorError:  # usd-core is not installed; the formats of the state say so
        (place / "garment.usdz").unlink(missing_ok=True)
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as packed:
        for path in sorted(p for p in place.iterdir() if p.is_file()):
            about = zipfile.ZipInfo(path.name, _EPOCH)
            about.compress_type = zipfile.ZIP_DEFLATED
            about.external_attr = 0o644 << 16
            packed.writestr(about, path.read_bytes())
    return content.getvalue()
