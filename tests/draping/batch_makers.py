"""Makers of garments for tests of the batch itself: quick, or faulty on purpose."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any

from swifttailor.draping.batch.make_garment import GarmentTask

QUALITY = {"accepted": True, "reasons": [], "top_cm": 140.0}


def make_quickly(task: GarmentTask) -> dict[str, Any]:
    """What the real maker returns and leaves, without a drape."""
    id = task.pattern.id
    if id.startswith("dies"):
        os._exit(3)
    if id.startswith("killed"):
        os.kill(os.getpid(), 9)
    if id.startswith("hangs"):
        time.sleep(600)
    folder = task.out / task.pattern.folder
    folder.mkdir(exist_ok=True)
    (folder / "report.json").write_text("{}")
    with Path(task.out / "made.txt").open("a") as log:
        log.write(f"{id}\n")
    rejected = id.startswith("bad")
    reasons = ["12 edges pass through the body (limit 35)", "did not come to rest"] if rejected else []
    quality = QUALITY | {"accepted": not rejected, "reasons": reasons}
    return {
        "id": id,
        "folder": task.pattern.folder,
        "status": "made",
        "accepted": not rejected,
        "reasons": reasons,
        "quality": quality,
        "seconds": {"sewing": 2.0, "draping": 1.0},
    }


def make_slowly(task: GarmentTask) -> dict[str, Any]:
    """Leaves time to be interrupted."""
    time.sleep(0.4)
    return make_quickly(task)


class DiesWhenLoaded:
    """A maker whose workers end before they are ready."""

    def __call__(self, task: GarmentTask) -> dict[str, Any]:
        raise AssertionError("never called")

    def __reduce__(self):
        return os._exit, (5,)
