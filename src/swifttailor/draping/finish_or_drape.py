"""Hangs a garment to rest, and drapes its pattern from the start where that ends badly."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from swifttailor.body import Body
from swifttailor.draping.drape import drape
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.finish import finish
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.progress import StageProgress

if TYPE_CHECKING:
    from swifttailor.draping.simulation import SimulationSettings


def finish_or_drape(
    garment: Garment,
    *,
    edge_length: float,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    settings: SimulationSettings | None = None,
    progress: StageProgress | None = None,
) -> Garment:
    """A garment at rest within the limits of quality, if physics finds one.

    Where a garment was sewn too far from its place, layers that pass through each other or a neckline that is
    past the shoulders stay so, however long it hangs. Sewn together by physics from flat panels it may yet
    come out well; that takes some seconds more.

    Args:
        garment: Near where it will come to rest.
        edge_length: Of its mesh, cm.
        body: What it is worn by; the default body when None.
        fabric: A `Fabric` or the name of a preset.
        settings: How long and how finely to simulate.
        progress: Called with the stage's name and the share of it that is done.

    Returns:
        The garment at rest: the one that hung from where it was, unless that is beyond the limits and the
        drape of its pattern is beyond fewer. Under ``finishing`` its report says which it is (``from``:
        ``garment`` or ``pattern``) and what was wrong with the first (``reasons``).

    Raises:
        SimulationError: The cloth went to infinity both times.
    """
    started = time.perf_counter()
    found: dict[str, Garment] = {}
    first_reasons = ["the cloth moved to infinity"]
    try:
        found["garment"] = finish(garment, body=body, fabric=fabric, settings=settings, progress=progress)
        first_reasons = _reasons(found["garment"])
    except SimulationError:
        pass
    if first_reasons:
        try:
            found["pattern"] = drape(
                garment.mesh.pattern,
                body=body,
                fabric=fabric,
                edge_length=edge_length,
                settings=settings,
                progress=progress,
            )
        except SimulationError:
            if not found:
                raise
    origin = min(found, key=lambda name: len(_reasons(found[name])))  # the first where both are as good
    chosen = found[origin]
    report = garment.report | {name: chosen.report[name] for name in ("quality", "fabric")}
    report["finishing"] = {"from": origin, "reasons": first_reasons}
    report["seconds"] = garment.report.get("seconds", {}) | {
        "finishing": round(time.perf_counter() - started, 4)
    }
    return Garment(chosen.mesh, chosen.vertices, report)


def _reasons(garment: Garment) -> list[str]:
    return garment.report["quality"]["reasons"]
