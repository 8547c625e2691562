"""Where results go, whether a preview is drawn, and showing them: for all commands that make garments."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated

from swifttailor.cli.postponed_imports import tyro

_LONGEST_NAME = 40
_SECONDS_TO_FAIL = 2.0
"""Openers that are still at work after this long have found something to open it with."""


@dataclass(frozen=True, kw_only=True)
class GarmentResults:
    """Options of the commands that leave a garment's folder behind."""

    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None
    """Folder to write; created when missing. Default: a new one in the current folder, named after what is
    made."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace files in DIR even where SwiftTailor has not written them, or they were changed since."""
    preview: bool = True
    """Draw preview.png, 0.1 to 0.2 s per garment, and the sheets of several."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the result: the preview, or the garment where there is none."""

    @cached_property
    def folder(self) -> Path:
        """DIR."""
        return self.out if self.out is not None else self.usual_place()

    def usual_place(self) -> Path:
        """A folder for the results where none is given."""
        raise NotImplementedError

    def show(self, *pictures: str) -> None:
        """Opens what was made, where that is wanted.

        Args:
            pictures: Files in DIR, of which the first that is there is opened; else the folder.
        """
        if self.open:
            there = (self.folder / name for name in pictures)
            open_file(next((path for path in there if path.is_file()), self.folder))


def new_place(name: str, ending: str = "") -> Path:
    """A path in the current folder where nothing is yet: the name, or the name and a number.

    Args:
        name: Any text (`file_name`).
        ending: Of a file, ``.json``.
    """
    words = file_name(name)
    number, place = 1, Path(words + ending)
    while os.path.lexists(place):
        number += 1
        place = Path(f"{words}-{number}{ending}")
    return place


def file_name(text: str) -> str:
    """A text as a short file name: small letters, digits and hyphens."""
    words = re.sub(r"[\W_]+", "-", text.lower()).strip("-")
    if len(words) > _LONGEST_NAME:
        words = words[:_LONGEST_NAME].rpartition("-")[0] or words[:_LONGEST_NAME]
    return words or "garment"


def open_file(path: Path) -> None:
    """Opens a file or folder with what the system opens such files with; says so where that is impossible."""
    trouble = _open(path.resolve())
    if trouble:
        sys.stderr.write(f"Cannot show '{path}': {trouble}. It is written all the same.\n")


def _open(path: Path) -> str:
    """Opens a path; returns why that is not possible, or nothing."""
    if sys.platform == "win32":
        try:
            os.startfile(path)
        except OSError as error:
            return str(error.strerror or error)
        return ""
    import shutil
    import subprocess

    name = "open" if sys.platform == "darwin" else "xdg-open"
    if name == "xdg-open" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return "there is no display"
    opener = shutil.which(name)
    if opener is None:
        return f"the program '{name}' is not installed"
    try:
        running = subprocess.Popen(
            [opener, str(path)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        code = running.wait(_SECONDS_TO_FAIL)
    except subprocess.TimeoutExpired:
        return ""
    except OSError as error:
        return f"'{opener}' cannot be run ({error.strerror or error})"
    return f"'{name}' knows no program for it" if code else ""
