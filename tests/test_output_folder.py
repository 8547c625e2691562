"""Folders are written whole or not at all, by one process at a time, and over nobody's files."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from swifttailor.atomic_files import write_atomically, write_bytes, write_text
from swifttailor.errors import DiskFullError, InputError
from swifttailor.output_folder import LIST, LOCK, UNFINISHED, FolderLock, OutputFolder

NAMES = ("a.txt", "b.bin", "deep/c.txt")


def fill(folder: Path, said: str, names=NAMES, *, stale=(), **options) -> None:
    with OutputFolder(folder, **options) as output, output.fill(stale=stale) as made:
        for name in names:
            write_text(made / name, f"{name}: {said}")


def snapshot(folder: Path) -> dict[str, tuple]:
    """All that a person could miss: every path with its kind, content and time."""
    return {
        path.relative_to(folder).as_posix(): (
            ("folder",)
            if path.is_dir() and not path.is_symlink()
            else (os.readlink(path),)
            if path.is_symlink()
            else (path.read_bytes(), path.stat().st_mtime_ns)
        )
        for path in sorted(folder.rglob("*"))
    }


def test_one_s_own_files_are_replaced_and_those_of_others_stay(tmp_path):
    fill(tmp_path, "first")
    (tmp_path / "mine.txt").write_text("mine")
    fill(tmp_path, "second")
    assert {n: (tmp_path / n).read_text() for n in NAMES} == {n: f"{n}: second" for n in NAMES}
    assert {p.name for p in tmp_path.iterdir()} == {"a.txt", "b.bin", "deep", "mine.txt", LIST}
    sums = subprocess.run(["sha256sum", "-c", LIST], cwd=tmp_path, capture_output=True, text=True)
    assert sums.returncode == 0 and sums.stdout.count("OK") == 3


def foreign(path: Path, kind: str) -> None:
    path.parent.mkdir(exist_ok=True)
    if kind == "folder":
        path.mkdir()
        (path / "within").write_text("mine")
    elif kind in ("link", "dangling link"):
        path.symlink_to("mine.txt" if kind == "link" else "nothing")
        (path.parent / "mine.txt").write_text("mine")
    else:
        path.write_text("" if kind == "empty" else "mine")


@pytest.mark.parametrize("kind", ["file", "empty", "folder", "link", "dangling link"])
@pytest.mark.parametrize("name", NAMES)
def test_whatever_is_there_of_others_is_refused_and_untouched(name, kind, tmp_path):
    foreign(tmp_path / name, kind)
    before = snapshot(tmp_path)
    with pytest.raises(InputError, match=r"would be replaced|not a file"):
        OutputFolder(tmp_path).require_own(NAMES)
    with pytest.raises(InputError, match=r"would be replaced|not a file"):
        fill(tmp_path, "new")
    assert snapshot(tmp_path) == before


@pytest.mark.parametrize("name", NAMES)
def test_what_a_person_has_changed_is_the_person_s(name, tmp_path):
    fill(tmp_path, "first")
    (tmp_path / name).write_text("changed by hand")
    before = snapshot(tmp_path)
    with pytest.raises(InputError, match=f"{name}' would be replaced"):
        fill(tmp_path, "second")
    assert snapshot(tmp_path) == before
    fill(tmp_path, "second", overwrite=True)
    assert (tmp_path / name).read_text() == f"{name}: second"
    fill(tmp_path, "third")  # it is SwiftTailor's again


def test_with_overwrite_nothing_is_deleted_that_is_not_written(tmp_path):
    for name in (*NAMES, "old.png", "mine.txt"):
        foreign(tmp_path / name, "file")
    fill(tmp_path, "new", stale=("old.png", "*.txt"), overwrite=True)
    assert (tmp_path / "old.png").read_text() == (tmp_path / "mine.txt").read_text() == "mine"
    (tmp_path / "a.txt").unlink()
    (tmp_path / "a.txt").mkdir()
    with pytest.raises(InputError, match="not a file"):
        fill(tmp_path, "newer", overwrite=True)


def test_a_file_in_a_folder_s_place_is_named(tmp_path):
    (tmp_path / "notes").write_text("mine")
    for path in (tmp_path / "notes" / "a.txt", tmp_path / "notes" / "deep" / "a.txt"):
        with pytest.raises(InputError, match=r"notes' is a file, not a folder"):
            write_text(path, "new")
    assert (tmp_path / "notes").read_text() == "mine"


def test_stale_files_go_where_they_are_one_s_own(tmp_path):
    fill(tmp_path, "first", (*NAMES, "sheet-01.png", "sheet-02.png", "other.png"))
    (tmp_path / "sheet-02.png").write_text("painted over")
    (tmp_path / "sheet-03.png").write_text("mine")
    fill(tmp_path, "second", stale=("sheet-*.png",))
    assert {p.name for p in tmp_path.glob("*.png")} == {"sheet-02.png", "sheet-03.png", "other.png"}


def test_a_source_never_becomes_something_else(tmp_path):
    fill(tmp_path, "first", stale=())
    fill(tmp_path, "first", sources=[tmp_path / "a.txt"])  # it stays what it is
    before = snapshot(tmp_path)
    with pytest.raises(InputError, match=r"a\.txt' would be replaced"):
        fill(tmp_path, "second", sources=[tmp_path / "a.txt"])
    assert snapshot(tmp_path) == before
    fill(tmp_path, "third", ("b.bin",), stale=("*.txt",), sources=[tmp_path / "a.txt"])
    assert (tmp_path / "a.txt").read_text() == "a.txt: first"


def test_a_list_that_is_not_one_is_not_believed(tmp_path):
    fill(tmp_path, "first")
    (tmp_path / LIST).write_text("my shopping list\n")
    before = snapshot(tmp_path)
    for overwrite in (False, True):
        with pytest.raises(InputError, match="cannot be read"):
            fill(tmp_path, "second", overwrite=overwrite)
    assert snapshot(tmp_path) == before


class Failing:
    """Lets a call of a function fail, the first, the second, and so on."""

    def __init__(self, monkeypatch, places, error):
        self.calls, self.failing, self.error = 0, 0, error
        for owner, name in places:
            monkeypatch.setattr(owner, name, self._failing(getattr(owner, name)))

    def _failing(self, real):
        def call(*arguments, **options):
            self.calls += 1
            if self.calls == self.failing:
                raise self.error
            return real(*arguments, **options)

        return call

    def every(self):
        """Fails at each call in turn; ends when all succeed."""
        while self.failing == 0 or self.calls >= self.failing:
            self.failing += 1
            self.calls = 0
            yield self.failing


@pytest.mark.parametrize(
    "error", [OSError(errno.ENOSPC, "No space left on device"), KeyboardInterrupt()], ids=["full", "Ctrl-C"]
)
@pytest.mark.parametrize("there", [False, True], ids=["new", "over an older one"])
def test_all_or_nothing_wherever_it_fails(there, error, tmp_path, monkeypatch):
    writes = [(os, "replace"), (os, "link"), (Path, "write_bytes"), (Path, "write_text"), (Path, "mkdir")]
    folder = tmp_path / "made" / "here"
    if there:
        fill(folder, "first", (*NAMES, "old.png"))
        (folder / "mine.txt").write_text("mine")
    before = snapshot(tmp_path)
    failing, failed = Failing(monkeypatch, writes, error), 0
    for _ in failing.every():
        try:
            fill(folder, "second", stale=("old.png",))
        except (InputError, KeyboardInterrupt) as refused:
            failed += 1
            assert snapshot(tmp_path) == before
            assert "unfinished" not in str(refused)
        else:
            assert {n: (folder / n).read_text() for n in NAMES} == {n: f"{n}: second" for n in NAMES}
            assert not (folder / "old.png").exists()
            if failing.calls >= failing.failing:  # `link` has another way to do it
                fill(folder, "first", (*NAMES, "old.png"), overwrite=True)
                before = snapshot(tmp_path)
    assert failed >= 10


@pytest.mark.parametrize("at", range(1, 10))
def test_a_killed_process_leaves_a_folder_that_can_be_written_again(at, tmp_path):
    fill(tmp_path, "first")
    program = f"""
import os, sys
from pathlib import Path
sys.path.insert(0, {str(Path(__file__).parent)!r})
from test_output_folder import fill
real, calls = os.replace, []
def rename(source, target):
    calls.append(target)
    if len(calls) == {at}:
        os.kill(os.getpid(), 9)
    real(source, target)
os.replace = rename
fill(Path({str(tmp_path)!r}), "second")
"""
    code = subprocess.run([sys.executable, "-c", program]).returncode
    assert code in (-9, 0) and (code == -9) == (at <= 8)
    there = {p.read_text().split(": ")[1] for n in NAMES if (p := tmp_path / n).exists()}
    assert there <= {"first", "second"}
    fill(tmp_path, "third")
    assert {n: (tmp_path / n).read_text() for n in NAMES} == {n: f"{n}: third" for n in NAMES}
    assert {p.name for p in tmp_path.iterdir()} == {"a.txt", "b.bin", "deep", LIST}


def test_a_file_in_the_place_of_a_folder(tmp_path):
    (tmp_path / "out").write_text("mine")
    for folder in (tmp_path / "out", tmp_path / "out" / "deeper"):
        with pytest.raises(InputError, match="Cannot write to"):
            fill(folder, "new")
    assert (tmp_path / "out").read_text() == "mine"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written(tmp_path):
    tmp_path.chmod(0o500)
    try:
        with pytest.raises(InputError, match="Cannot write to"):
            fill(tmp_path, "new")
    finally:
        tmp_path.chmod(0o700)
    assert not list(tmp_path.iterdir())


def test_a_lock_keeps_others_out_and_leaves_nothing(tmp_path):
    folder = tmp_path / "new" / "folder"
    with FolderLock(folder, "batch"):
        with pytest.raises(InputError, match="Another batch is at work"):
            FolderLock(folder, "batch")
        with pytest.raises(InputError, match="is at work"):
            fill(folder, "new")
    assert not list(tmp_path.iterdir())


def test_a_lock_of_somebody_else_s_stays(tmp_path):
    (tmp_path / LOCK).write_text("mine")
    fill(tmp_path, "new")
    assert (tmp_path / LOCK).read_text() == "mine"


def test_single_files(tmp_path):
    path = tmp_path / "deep" / "a.bin"
    write_bytes(path, b"one")
    write_bytes(path, b"one")  # the same is no harm
    before = snapshot(tmp_path)
    for content in (b"two", b"longer", b""):
        with pytest.raises(InputError, match="would be replaced"):
            write_bytes(path, content)
    assert snapshot(tmp_path) == before
    write_bytes(path, b"two", overwrite=True)
    assert path.read_bytes() == b"two"


@pytest.mark.parametrize("overwrite", [False, True])
def test_what_is_not_a_file_is_never_replaced(overwrite, tmp_path):
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "dangling").symlink_to("nothing")
    before = {p.name: p.lstat() for p in tmp_path.iterdir()}
    for path in (tmp_path / "folder", tmp_path / "pipe", tmp_path / "dangling", Path("/dev/null")):
        with pytest.raises(InputError, match=r"not a file|would be replaced"):
            write_text(path, "new", overwrite=overwrite)
    assert {p.name: p.lstat() for p in tmp_path.iterdir()} == before
    assert Path("/dev/null").is_char_device()


def test_a_file_that_appears_meanwhile_stays(tmp_path):
    from swifttailor.atomic_files import write_atomically

    def write(temporary: Path) -> None:
        temporary.write_text("new")
        (tmp_path / "a").write_text("somebody was faster")

    with pytest.raises(InputError, match="would be replaced"):
        write_atomically(tmp_path / "a", write)
    assert (tmp_path / "a").read_text() == "somebody was faster"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EACCES])
def test_a_full_disk_is_told_from_other_troubles(number, tmp_path, monkeypatch):
    fill(tmp_path, "first")
    before, replace, refused = snapshot(tmp_path), os.replace, []

    def refuse_once(source, target):
        if not refused:
            refused.append(target)
            raise OSError(number, os.strerror(number))
        replace(source, target)

    monkeypatch.setattr(os, "replace", refuse_once)
    with pytest.raises(InputError) as raised:
        fill(tmp_path, "second")
    assert (type(raised.value) is DiskFullError) == (number != errno.EACCES)
    assert str(tmp_path) in str(raised.value) and UNFINISHED not in str(raised.value)
    assert snapshot(tmp_path) == before
    fill(tmp_path, "second")
    assert (tmp_path / "a.txt").read_text() == "a.txt: second"


def test_a_full_disk_is_told_of_a_file_before_it_has_its_name(tmp_path):
    def full(path):
        raise OSError(errno.ENOSPC, "No space left on device")

    with (
        pytest.raises(DiskFullError, match=r"a\.txt': the disk is full"),
        OutputFolder(tmp_path / "out") as output,
        output.fill() as made,
    ):
        write_atomically(made / "a.txt", full)
    assert not (tmp_path / "out").exists()
