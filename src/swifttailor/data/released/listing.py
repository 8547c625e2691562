"""The files below a folder that a stranger may have made: bounded, and without following links."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path, PurePosixPath

from swifttailor.errors import InputError

MAX_ENTRIES = 100_000
"""Files and folders of one run: twice what AIpparel writes for a test split of 5,000 garments."""
MAX_DEPTH = 12


@dataclass(frozen=True)
class Listing:
    """What a folder holds, relative to it, in alphabetical order."""

    root: Path
    files: tuple[PurePosixPath, ...]
    folders: tuple[PurePosixPath, ...]
    links: tuple[PurePosixPath, ...] = ()
    """Symbolic links, which are not followed: they may lead anywhere."""

    @cached_property
    def names_in(self) -> dict[PurePosixPath, frozenset[str]]:
        """Names of the files in each folder that has any."""
        found: dict[PurePosixPath, set[str]] = {}
        for file in self.files:
            found.setdefault(file.parent, set()).add(file.name)
        return {folder: frozenset(names) for folder, names in found.items()}

    def leaves(self) -> Iterable[PurePosixPath]:
        """Folders without anything in them."""
        full = {entry.parent for entry in (*self.files, *self.folders, *self.links)}
        return (folder for folder in self.folders if folder not in full)


def list_folder(root: Path) -> Listing:
    """Lists all files and folders below a folder.

    Raises:
        InputError: It is no folder, cannot be read, or holds more than is read.
    """
    try:
        if not root.is_dir():
            raise InputError(
                f"There is no folder '{root}'. Give the folder that a system has written its outputs to."
            )
    except (OSError, ValueError) as error:  # no possible name
        raise InputError(f"Cannot read {str(root)!r}: {error}.") from error
    files: list[PurePosixPath] = []
    folders: list[PurePosixPath] = []
    links: list[PurePosixPath] = []
    waiting = [PurePosixPath()]
    while waiting:
        folder = waiting.pop()
        if len(folder.parts) > MAX_DEPTH:
            raise InputError(
                f"'{root}' has folders in folders more than {MAX_DEPTH} deep. Give the folder of one run."
            )
        try:
            with os.scandir(root / folder) as entries:
                for entry in entries:
                    path = folder / entry.name
                    if entry.is_symlink():
                        links.append(path)
                    elif entry.is_dir():
                        folders.append(path)
                        waiting.append(path)
                    elif entry.is_file():
                        files.append(path)
                    if len(files) + len(folders) + len(links) > MAX_ENTRIES:
                        raise InputError(
                            f"'{root}' holds more than {MAX_ENTRIES:,} files and folders. Give the folder of "
                            "one run, or a part. For a download of GarmentCodeData: swifttailor data import"
                        )
        except OSError as error:
            raise InputError(f"Cannot read '{root / folder}': {error.strerror or error}.") from error
    return Listing(root, tuple(sorted(files)), tuple(sorted(folders)), tuple(sorted(links)))
