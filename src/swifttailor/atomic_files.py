"""Writing files whole or not at all, and never over a file that a person may still want.

A crash or a full disk leaves no half file. A file that exists is replaced only where that is asked for; that
the new one is the same, byte for byte, is no fault. Folders of several files: `swifttailor.output_folder`.
"""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Callable
from pathlib import Path

from swifttailor.errors import DiskFullError, InputError

_PART = 1 << 20
NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})
"""Numbers of errors; the last one is of files that are larger than any may be, as `ulimit -f` says."""


def write_atomically(path: Path | str, write: Callable[[Path], object], *, overwrite: bool = False) -> Path:
    """Lets `write` fill a temporary file beside `path`, then gives it that name.

    Args:
        path: Final file name. Its folder is created when missing.
        write: Called with the temporary file's path, which has the same ending as `path`, so that
            libraries which pick the format from the name do the same for both.
        overwrite: Whether a file that exists and is different is replaced.

    Returns:
        `path`.

    Raises:
        InputError: There is another file of that name, or the folder cannot be created or written.
        DiskFullError: There is no room for the file.
    """
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{path.stem}-", suffix=path.suffix, dir=path.parent)
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte in it
        if is_disk_full(error):
            raise disk_full(path) from error
        in_the_way = next((p for p in path.parents if os.path.lexists(p) and not p.is_dir()), None)
        why = (
            f"'{in_the_way}' is a file, not a folder"
            if in_the_way
            else getattr(error, "strerror", "") or error
        )
        raise InputError(f"Cannot write {str(path)!r}: {why}. Choose a folder you may write to.") from error
    os.close(handle)
    temporary = Path(name)
    try:
        write(temporary)
        # mkstemp makes private files; give the result the permissions an ordinary open() would have.
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        _give_name(temporary, path, overwrite)
    except OSError as error:
        if is_disk_full(error):
            raise disk_full(path) from error
        raise InputError(f"Cannot write '{path}': {error.strerror or error}.") from error
    finally:
        temporary.unlink(missing_ok=True)
    return path


def is_disk_full(error: BaseException) -> bool:
    """Whether an error says that there is no room left: on the disk, in a quota, or for a file so large."""
    return isinstance(error, DiskFullError) or (isinstance(error, OSError) and error.errno in NO_ROOM)


def disk_full(path: Path | str) -> DiskFullError:
    """The error of a file that there is no room for."""
    return DiskFullError(
        f"Cannot write '{path}': the disk is full, your quota is used up, or files may not be so large "
        "(see `ulimit -f`)."
    )


def write_text(path: Path | str, text: str, *, overwrite: bool = False) -> Path:
    """Writes `text` as UTF-8 to `path` by way of `write_atomically`."""
    return write_bytes(path, text.encode(), overwrite=overwrite)


def write_bytes(path: Path | str, content: bytes, *, overwrite: bool = False) -> Path:
    """Writes `content` to `path` by way of `write_atomically`."""
    return write_atomically(path, lambda temporary: temporary.write_bytes(content), overwrite=overwrite)


def require_free(path: Path, *, overwrite: bool) -> None:
    """Refuses, before the work is done, a file that must not be replaced after it.

    Raises:
        InputError: There is something of that name.
    """
    if os.path.lexists(path) and not (overwrite and path.is_file()):
        raise would_be_replaced(path)


def would_be_replaced(path: Path, why: str = "by another") -> InputError:
    """The error for a file that is somebody's, or something that is no file.

    Args:
        path: What is there.
        why: End of the sentence that says so.
    """
    if path.exists() and not path.is_file():
        return InputError(f"Cannot write '{path}': what has that name is not a file. Choose another name.")
    return InputError(
        f"'{path}' would be replaced {why}. Choose another name or folder, move the file away, or let it be "
        "replaced with --overwrite (in Python: overwrite=True)."
    )


def _give_name(temporary: Path, path: Path, overwrite: bool) -> None:
    if overwrite and (path.is_file() or not os.path.lexists(path)):
        os.replace(temporary, path)
        return
    try:
        os.link(temporary, path)  # unlike a renaming it fails where something has appeared meanwhile
    except FileExistsError:
        if not _same_content(temporary, path):
            raise would_be_replaced(path) from None
    except OSError:  # a file system without hard links
        if os.path.lexists(path):
            raise
        os.replace(temporary, path)


def _same_content(first: Path, second: Path) -> bool:
    if not second.is_file() or first.stat().st_size != second.stat().st_size:
        return False
    with first.open("rb") as one, second.open("rb") as other:
        while part := one.read(_PART):
            if part != other.read(_PART):
                return False
    return True
