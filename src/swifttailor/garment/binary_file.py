"""Writing bytes through `swifttailor.atomic_files`."""

from __future__ import annotations

from pathlib import Path

from swifttailor.atomic_files import write_atomically


def write_bytes(path: Path | str, content: bytes) -> Path:
    """Writes `content` to `path`, whole or not at all, and returns the path."""

    def write(temporary: Path) -> None:
        temporary.write_bytes(content)

    return write_atomically(path, write)
