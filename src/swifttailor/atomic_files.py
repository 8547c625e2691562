"""Writing files so that a crash or a full disk never leaves half a file in place of a good one."""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Callable
from pathlib import Path

from swifttailor.errors import DiskFullError, InputError

_NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT})
START_AGAIN = (
    "Make room, and start the same command again: what is done is kept, and it goes on with the rest."
)


def write_atomically(path: Path | str, write: Callable[[Path], object]) -> Path:
    """Lets `write` fill a temporary file beside `path`, then renames it over `path`.

    Args:
        path: Final file name. Its folder is created when missing.
        write: Called with the temporary file's path, which has the same ending as `path`, so that
            libraries which pick the format from the name do the same for both.

    Returns:
        `path`.

    Raises:
        InputError: The folder cannot be created or written.
        DiskFullError: There is no room for the file.
    """
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent)
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte in it
        if is_disk_full(error):
            raise disk_full(path) from error
        why = getattr(error, "strerror", None) or error
        raise InputError(f"Cannot write {str(path)!r}: {why}. Choose a folder you may write to.") from error
    os.close(handle)
    temporary = Path(name)
    try:
        write(temporary)
        # mkstemp makes private files; give the result the permissions an ordinary open() would have.
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        os.replace(temporary, path)
    except OSError as error:
        if is_disk_full(error):
            raise disk_full(path) from error
        raise InputError(f"Cannot write '{path}': {error.strerror or error}.") from error
    finally:
        temporary.unlink(missing_ok=True)
    return path


def is_disk_full(error: BaseException) -> bool:
    """Whether an error says that there is no room left, or that a quota is used up."""
    return isinstance(error, DiskFullError) or (isinstance(error, OSError) and error.errno in _NO_ROOM)


def disk_full(path: Path | str) -> DiskFullError:
    """The error of a file that there is no room for."""
    return DiskFullError(f"Cannot write '{path}': the disk is full, or your quota is used up.")


def write_text(path: Path | str, text: str) -> Path:
    """Writes `text` as UTF-8 to `path` by way of `write_atomically`."""
    return write_atomically(path, lambda temporary: temporary.write_text(text, encoding="utf-8"))
