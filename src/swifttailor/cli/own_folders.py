"""Which folders a command may write garments into: new ones, and those that hold garments already."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from swifttailor.errors import InputError

_MAX_REPORT_BYTES = 64 * 2**20


def require_own_files(folder: Path, names: Iterable[str]) -> None:
    """Refuses a folder in which files would be replaced that no command of this program has made.

    Args:
        folder: To write a garment into; may not exist.
        names: Of the files that will be written.

    Raises:
        InputError: There is such a file, and no report of a garment beside it.
    """
    from swifttailor.garment.folder import REPORT

    foreign = [name for name in names if (folder / name).exists()]
    if foreign and read_report(folder / REPORT) is None:
        raise InputError(
            f"'{folder / foreign[0]}' would be replaced, and does not look like something SwiftTailor has "
            f"made: there is no {REPORT} of a garment beside it. Choose another --out, or move the file away."
        )


def read_report(path: Path) -> dict[str, Any] | None:
    """The report that every garment's folder has; None where the file is none, or missing."""
    try:
        if path.stat().st_size > _MAX_REPORT_BYTES:
            return None
        report: Any = json.loads(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return None
    return report if isinstance(report, dict) and "edge_length_cm" in report else None
