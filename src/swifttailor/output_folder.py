"""Folders of results: written whole or not at all, by one process at a time, and over nobody's files.

Which files are SwiftTailor's own is written beside them, in the list `.swifttailor`: a line with checksum and
name for each, as sha256sum has it. A file that is not in it, or has been changed by a person since, is
somebody's, and is neither replaced nor deleted. Single files: `swifttailor.atomic_files`.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import tempfile
from collections.abc import Generator, Iterable
from contextlib import contextmanager, suppress
from fnmatch import fnmatchcase
from pathlib import Path
from types import TracebackType
from typing import Self

from swifttailor.atomic_files import disk_full, is_disk_full, would_be_replaced
from swifttailor.errors import InputError

LIST = ".swifttailor"
LOCK = ".swifttailor.lock"
UNFINISHED = ".swifttailor-unfinished-"
_WHY = "and was not written there by SwiftTailor, or was changed since"
_LINE = re.compile(r"([0-9a-f]{64})  (\S.*)")
_MAX_LIST_BYTES = 64 * 2**20
_TRIES = 100
"""Times that a folder may vanish while it is being locked."""


class FolderLock:
    """Held while this process works on a folder; use as a context manager."""

    def __init__(self, folder: Path, work: str) -> None:
        """Takes the lock; makes the folder when it is missing.

        Args:
            folder: Where work is done.
            work: What is being done there, for the message ("batch").

        Raises:
            InputError: Another process holds it.
            OSError: The folder cannot be made or written.
        """
        self._path = folder / LOCK
        self._made: list[Path] = []
        try:
            self._take(folder, work)
        except BaseException:
            _remove_empty(self._made)
            raise

    def _take(self, folder: Path, work: str) -> None:
        for _ in range(_TRIES):
            self._made = _make(folder) + self._made
            try:
                self._stream = self._path.open("ab")
            except FileNotFoundError:  # somebody who had made the folder for nothing has removed it
                continue
            if not _take_lock(self._stream.fileno()):
                self._stream.close()
                raise InputError(
                    f"Another {work} is at work in '{folder}'. Wait for it or choose another --out."
                )
            with suppress(OSError):
                if os.path.samestat(os.fstat(self._stream.fileno()), os.stat(self._path)):
                    return
            self._stream.close()  # that was the lock of one who has just gone
        raise InputError(f"'{folder}' is made and removed all the time by another {work}.")

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()

    def release(self) -> None:
        """Lets others in, as the end of the process does, and removes folders that were made for nothing."""
        if self._stream.closed:
            return
        _remove_lock(self._path)
        self._stream.close()
        _remove_empty(self._made)


class OutputFolder:
    """A folder that results are written into.

    As a context manager it is locked: from the check of what is there to the end, nobody else writes. Who has
    locked it in another way may call `require_own` and `fill` without that.
    """

    def __init__(self, folder: Path | str, *, overwrite: bool = False, sources: Iterable[Path] = ()) -> None:
        """Nothing is touched yet.

        Args:
            folder: Created when missing.
            overwrite: Whether files of others may be replaced. They are never deleted.
            sources: Files that the results are made of: they may not become others, whoever made them.
        """
        self.folder = Path(folder)
        self._overwrite = overwrite
        self._sources = tuple(sources)
        self._lock: FolderLock | None = None

    def __enter__(self) -> Self:
        try:
            self._lock = FolderLock(self.folder, "SwiftTailor")
        except (OSError, ValueError) as error:
            raise self._unusable(error) from error
        remove_unfinished(self.folder)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def inside(self, name: str) -> OutputFolder:
        """A folder in this one, with the same files to protect."""
        return OutputFolder(self.folder / name, overwrite=self._overwrite, sources=self._sources)

    def require_own(self, names: Iterable[str]) -> None:
        """Refuses, before the work is done, what would be refused after it.

        Args:
            names: Of files that will be written.

        Raises:
            InputError: One of them exists and is somebody's.
        """
        listed = self._listed()
        for name in names:
            path = self.folder / name
            if os.path.lexists(path) and not self._may_replace(path, listed.get(name, set())):
                raise would_be_replaced(path, _WHY)

    def changed(self) -> list[str]:
        """Listed files that are there, but not as they were written: cut short, or changed by a person."""
        try:
            listed = self._listed()
        except InputError:
            return [LIST]
        paths = {name: self.folder / name for name in listed}
        return [n for n, path in paths.items() if os.path.lexists(path) and not _is_sound(path, listed[n])]

    @contextmanager
    def fill(self, *, stale: Iterable[str] = ()) -> Generator[Path]:
        """Gives a folder to write files into, which are put in their places when all are there.

        Args:
            stale: Files, or patterns of names, that say something wrong beside the new ones. Those that are
                SwiftTailor's own and not written again are removed.

        Yields:
            An empty folder.

        Raises:
            InputError: A file cannot be written, or would replace somebody's. Then everything is as before.
            DiskFullError: There is no room for the files; everything is as before, too.
        """
        staging, made = None, []
        try:
            made = _make(self.folder)
            staging = Path(tempfile.mkdtemp(prefix=UNFINISHED, dir=self.folder))
            yield staging
            self._publish(staging, tuple(stale))
        except OSError as error:
            raise self._unusable(error) from error
        except InputError as error:
            if staging is None or str(staging) not in str(error):
                raise
            raise type(error)(str(error).replace(str(staging), str(self.folder))) from error
        finally:
            if staging is not None:
                shutil.rmtree(staging, ignore_errors=True)
            _remove_empty(made)

    def _publish(self, staging: Path, stale: tuple[str, ...]) -> None:
        """Moves files to their places, or none of them."""
        names = sorted(p.relative_to(staging).as_posix() for p in staging.rglob("*") if p.is_file())
        digests = {name: _digest(staging / name) for name in names}
        listed = self._listed()
        gone = [
            name
            for name, own in listed.items()
            if name not in digests
            and any(fnmatchcase(name, pattern) for pattern in stale)
            and _is_as_written(self.folder / name, own)
            and not any(_is_same(source, self.folder / name) for source in self._sources)
        ]
        kept = {name: own for name, own in listed.items() if name not in digests and name not in gone}
        new = {name: {digest} for name, digest in digests.items()}
        # Whenever the program is killed, the list in force knows the old files and the new ones.
        both = {name: listed.get(name, set()) | new.get(name, set()) for name in {**listed, **new}}
        before, lists = staging / ".before", staging / ".lists"
        for part in (before, lists):
            part.mkdir()
        if listed:
            shutil.copy2(self.folder / LIST, lists / "before")
        (lists / "both").write_text(_list_text(both), encoding="utf-8")
        (lists / "new").write_text(_list_text(kept | new), encoding="utf-8")

        own_sources = {n for n in names if any(_is_same(source, self.folder / n) for source in self._sources)}
        moves: list[tuple[Path, Path]] = []
        made: list[Path] = []

        def move(source: Path, target: Path) -> None:
            moves.append((source, target))
            os.replace(source, target)

        def put(source: Path | None, name: str, number: int) -> None:
            target, old = self.folder / name, before / str(number)
            if os.path.lexists(target):
                refused = would_be_replaced(target, _WHY)
                move(target, old)  # looked at where nobody can change it any more
                if not self._may_replace(old, listed.get(name, set())):
                    raise refused
                if name in own_sources and not self._overwrite and _digest(old) != digests[name]:
                    raise refused
            if source is not None:
                made.extend(_make(target.parent))
                move(source, target)

        try:
            move(lists / "both", self.folder / LIST)
            for number, name in enumerate((*names, *gone)):
                put(staging / name if name in digests else None, name, number)
            move(lists / "new", self.folder / LIST)
        except BaseException:  # Ctrl-C too
            for source, target in reversed(moves):
                with suppress(FileNotFoundError):  # the move that failed
                    os.replace(target, source)
            if (lists / "before").exists():
                os.replace(lists / "before", self.folder / LIST)
            _remove_empty(made)
            raise

    def _may_replace(self, path: Path, own: set[str]) -> bool:
        if self._overwrite:
            return path.is_file() or path.is_symlink()
        return _is_as_written(path, own)

    def _listed(self) -> dict[str, set[str]]:
        """The digests that each of SwiftTailor's own files may have."""
        path = self.folder / LIST
        if not os.path.lexists(path):
            return {}
        found: dict[str, set[str]] = {}
        try:
            if path.stat().st_size > _MAX_LIST_BYTES:
                raise ValueError("it is too large")
            for line in path.read_text(encoding="utf-8").splitlines():
                said = _LINE.fullmatch(line)
                if said is None:
                    raise ValueError(f"{line[:80]!r} is not a checksum and a name")
                found.setdefault(said[2], set()).add(said[1])
        except (OSError, ValueError) as error:
            raise InputError(
                f"'{path}', the list of what SwiftTailor has written there, cannot be read: {error}. Choose "
                "another --out, or move the file away: all others then count as yours."
            ) from error
        return found

    def _unusable(self, error: Exception) -> InputError:
        if is_disk_full(error):
            return disk_full(self.folder)
        why = getattr(error, "strerror", None) or error
        return InputError(f"Cannot write to {str(self.folder)!r}: {why}. Nothing in it was changed.")


def remove_unfinished(folder: Path) -> None:
    """Removes what a killed process has left in a folder that nobody else works on."""
    for path in folder.glob(f"{UNFINISHED}*"):
        shutil.rmtree(path, ignore_errors=True)


def remove_unfinished_folder(folder: Path) -> None:
    """Does so, and removes the folder where that was all."""
    remove_unfinished(folder)
    _remove_lock(folder / LOCK)
    _remove_empty([folder])


def _make(folder: Path) -> list[Path]:
    """Makes a folder; returns those that were missing, the innermost first."""
    missing, at = [], folder
    while not at.exists() and at != at.parent:
        missing.append(at)
        at = at.parent
    try:
        for one in reversed(missing):
            one.mkdir(exist_ok=True)
    except BaseException:
        _remove_empty(missing)
        raise
    return missing


def _remove_lock(path: Path) -> None:
    with suppress(OSError):
        if path.stat().st_size == 0:  # else it is somebody's
            path.unlink()


def _remove_empty(folders: list[Path]) -> None:
    for folder in folders:
        with suppress(OSError):  # there is something in it
            folder.rmdir()


def _is_same(source: Path, path: Path) -> bool:
    with suppress(OSError, ValueError):
        return source.samefile(path)
    return False


def _take_lock(handle: int) -> bool:
    """Locks a file, unless another process has."""
    try:
        import fcntl
    except ImportError:  # Windows: two at work on one folder are not noticed
        return True
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def _is_as_written(path: Path, own: set[str]) -> bool:
    return bool(own) and path.is_file() and not path.is_symlink() and _digest(path) in own


def _is_sound(path: Path, own: set[str]) -> bool:
    try:
        return _is_as_written(path, own)
    except OSError:  # it cannot be read
        return False


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _list_text(digests: dict[str, set[str]]) -> str:
    return "".join(f"{one}  {name}\n" for name in sorted(digests) for one in sorted(digests[name]))
