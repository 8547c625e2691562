"""Tasks of physics: a garment hung to rest, with frames while it moves."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.draping.compiled_code import solver_is_compiled
from swifttailor.draping.drape import drape as drape_pattern
from swifttailor.draping.finish_or_drape import finish_or_drape
from swifttailor.draping.simulation import SimulationSettings
from swifttailor.draping.time_limit import TimeLimit, usual_time_limit
from swifttailor.errors import GeometryError, PatternError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern, Severity
from swifttailor.studio.bench.documents import Work, document, read_pattern
from swifttailor.studio.bench.mesh_files import garment_of, garment_record, same_pattern
from swifttailor.studio.bench.part_looks import in_cloth
from swifttailor.studio.bench.pattern_facts import check
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.mesh_record import MeshRecord
from swifttailor.studio.worker.handle import COMPILING
from swifttailor.studio.worker.link import Link, StoppedError

USUAL_EDGE_CM = 2.0
_INSTEAD = "Choose a longer edge length, or keep the garment as it was sewn."


class _Watched:
    """Shows the frames of a simulation, and keeps the latest for the case that it is stopped."""

    def __init__(self, link: Link, edge_length: float) -> None:
        self._link, self._edge_length = link, edge_length
        self._mesh = ""
        self.garment: Garment | None = None
        """As it was in the latest frame."""

    def begin(self, garment: Garment) -> None:
        """Hands over the mesh that frames are of."""
        record = garment_record(garment, self._edge_length)
        self._mesh, self.garment = record.name, garment
        self._link.meshes(record)

    def frame(self, positions: Floats) -> None:
        """Shows positions (v, 3), and keeps them if it is stopped then.

        Raises:
            StoppedError: It is to stop.
        """
        try:
            self._link.frame(self._mesh, positions)
        except StoppedError:
            self.keep(positions)
            raise

    def keep(self, positions: Floats) -> None:
        """Remembers positions that are finite."""
        if self.garment is not None and np.isfinite(positions).all():
            self.garment = replace(self.garment, vertices=positions.copy())

    def settings(self) -> SimulationSettings:
        """Of a simulation that is watched."""
        return SimulationSettings(watch=self.frame)


def drape(
    link: Link,
    *,
    pattern: dict[str, Any],
    mesh: MeshRecord | None,
    fabric: str,
    edge_length: float | None,
    color: str | None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """A garment sewn together by physics from its flat panels."""
    original = _sewable(pattern)
    edge_length = edge_length or USUAL_EDGE_CM
    link.stage("meshing", 0.0)
    watched = _Watched(link, edge_length)
    body = wearing(original.drafted_for).body
    flat = mesh_pattern(original, edge_length)
    placed = Garment(flat, flat.welded_mean(_placed(original, flat)), {}, color)
    watched.begin(in_cloth(placed, color, looks, print))

    def run() -> Garment:
        return drape_pattern(
            original,
            body=body,
            fabric=fabric,
            edge_length=edge_length,
            settings=watched.settings(),
            progress=TimeLimit(usual_time_limit(edge_length), link.stage, instead=_INSTEAD),
        )

    _say_if_it_compiles(link)
    return _hung(
        run, watched, original, origin="drape", state="draped", fabric=fabric, edge_length=edge_length
    )


def finish(
    link: Link,
    *,
    pattern: dict[str, Any],
    mesh: MeshRecord | None,
    fabric: str,
    edge_length: float | None,
    color: str | None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """A garment hung to rest from where the network has sewn it, or from where it hangs already."""
    original = _sewable(pattern)
    link.stage("sewing", 0.0)
    garment, worn = None, wearing(original.drafted_for)
    if mesh is not None and edge_length in (None, mesh.edge_length):
        with suppress(GeometryError):
            before = garment_of(mesh)
            if same_pattern(before.pattern, original):
                garment, edge_length = before, mesh.edge_length
    edge_length = edge_length or USUAL_EDGE_CM
    if garment is None:
        garment = worn.tailor.sew(original, edge_length=edge_length).garment
    garment = in_cloth(garment, color, looks, print)
    watched = _Watched(link, edge_length)
    watched.begin(garment)

    def run() -> Garment:
        return finish_or_drape(
            garment,
            edge_length=edge_length,
            body=worn.body,
            fabric=fabric,
            settings=watched.settings(),
            progress=TimeLimit(usual_time_limit(edge_length), link.stage, instead=_INSTEAD),
        )

    pattern_sewn = garment.pattern
    _say_if_it_compiles(link)
    return _hung(
        run, watched, pattern_sewn, origin="finish", state="finished", fabric=fabric, edge_length=edge_length
    )


def _hung(
    run: Any, watched: _Watched, pattern: Pattern, *, state: str, edge_length: float, **more: Any
) -> Work:
    """The document of what a simulation leaves, stopped or not."""
    assert watched.garment is not None
    seen = watched.garment
    try:
        garment, stopped = replace(run(), color=seen.color, print=seen.print, looks=seen.looks), False
    except StoppedError:
        garment, stopped = watched.garment, True
    notes = ["Stopped before it came to rest."] if stopped else []
    about = garment.report.get("finishing", {"from": "garment"})
    if about["from"] != "garment":
        notes.append(
            f"Draped from the pattern: the sewn garment did not come to rest well ({about['reasons'][0]})."
        )
    work = document(
        pattern,
        title=pattern.name,
        garment=garment,
        state="stopped" if stopped else state,
        edge_length=edge_length,
        notes=notes,
        **more,
    )
    answer = {"documents": [work.answer], "failures": []}
    return Work(answer, work.meshes, stopped)


def _say_if_it_compiles(link: Link) -> None:
    """The solver is compiled once on each machine, which takes half a minute."""
    if not solver_is_compiled():
        link.stage(f"{COMPILING}, once", 0.0)


def _sewable(specification: dict[str, Any]) -> Pattern:
    pattern = read_pattern(specification).pattern.canonical()
    faults = [f for f in check(pattern) if f.severity is Severity.ERROR]
    if faults:
        raise PatternError(
            f"The pattern cannot be draped as it is: {faults[0].line().removeprefix('error: ')}"
        )
    if not pattern.panels:
        raise PatternError("A pattern without panels cannot be draped. Give one with at least one panel.")
    return pattern


def _placed(pattern: Pattern, flat: Any) -> Floats:
    """(m, 3) the flat vertices where their panels are placed, cm."""
    return np.concatenate(
        [panel.to_world(flat.flat_vertices[flat.flat_panel == k]) for k, panel in enumerate(pattern.panels)]
    )
