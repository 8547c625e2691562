"""What decides the results in a folder, noted there: work goes on only with the same."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_text
from swifttailor.errors import InputError
from swifttailor.workers.work_folder import differences


def keep_settings(path: Path, settings: dict[str, Any], what: str, results: Iterable[str]) -> None:
    """Notes what decides the results in a folder, or compares it with what decided those that are there.

    Args:
        path: File with the settings in that folder.
        settings: What can be written as JSON values.
        what: The results, for messages: "answers".
        results: Names of the files or folders with them, which are nowhere without the settings.

    Raises:
        InputError: They were made in another way, or the file cannot be read or written.
    """
    settings = json.loads(json.dumps(settings))
    if not path.is_file():
        for name in results:
            if os.path.lexists(path.parent / name):
                raise InputError(
                    f"'{path.parent / name}' is there already and does not belong to {what} of SwiftTailor: "
                    f"'{path.name}' is missing beside it. Choose another --out."
                )
        write_text(path, json.dumps(settings, indent=1) + "\n")
        return
    try:
        before = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(before, dict):
            raise ValueError("it is not a JSON object")
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(f"Cannot read '{path}': {error}. Choose another --out.") from error
    different = differences(before, settings)
    if different:
        raise InputError(
            f"'{path.parent}' holds {what} that were made in another way: {different}. Choose another "
            "--out, or give what they were made with."
        )
