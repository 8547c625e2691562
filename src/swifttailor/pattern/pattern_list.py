"""The patterns of a batch, one by one: from JSON lines (.jsonl, .jsonl.gz) or a folder of JSON files."""

from __future__ import annotations

import gzip
import hashlib
import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from io import BufferedReader
from itertools import chain
from pathlib import Path

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern import Reading, read_pattern_file, read_specification
from swifttailor.pattern.json_values import MAX_FILE_BYTES, parse_json
from swifttailor.pattern.panel import RotationReading

LINE_ENDINGS = (".jsonl", ".jsonl.gz")
MAX_ID_LENGTH = 200
_FOLDER_LENGTH = 80
_CHUNK = 1 << 20
_UNSAFE = re.compile(r"[^A-Za-z0-9_-]+")
_DEVICE_NAME = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)")


@dataclass(frozen=True)
class BatchPattern:
    """One pattern of a batch, not parsed yet."""

    id: str
    """Its id; ``#7`` when line 7 has none that can be used."""
    folder: str
    """Name of the folder its garment goes to."""
    source: str
    """Where it comes from, for messages."""
    number: int
    """Its line, or its place in the folder, from 1."""
    line: bytes | None = None
    """Its line, where it comes from a file of JSON lines."""
    path: Path | None = None
    """Its own file, where it comes from a folder."""
    error: str = ""
    """Why it cannot be used, when that is plain before it is parsed."""

    def read(self, rotation: RotationReading = "intrinsic") -> Reading:
        """Parses it.

        Args:
            rotation: How to read the placement angles.

        Raises:
            SwiftTailorError: It cannot be used, or is no pattern.
        """
        if self.error:
            raise InputError(self.error)
        if self.path is not None:
            return read_pattern_file(self.path, rotation=rotation)
        assert self.line is not None
        specification = parse_json(self.line, self.source)["pattern"]
        return read_specification(specification, name=self.id, rotation=rotation)


def count_patterns(source: Path) -> int:
    """About how many patterns there are (exact unless the file is damaged)."""
    count, last = 0, b"\n"
    try:
        if source.is_dir():
            return len(pattern_files(source))
        with _open(source) as stream:
            while chunk := stream.read(_CHUNK):
                count, last = count + chunk.count(b"\n"), chunk[-1:]
    except (OSError, EOFError, ValueError, zlib.error):
        pass
    return count + (last != b"\n")


def read_patterns(*sources: Path) -> Iterator[BatchPattern]:
    """Goes through the patterns of files and folders, in their order; bad ones come with their `error`.

    Raises:
        InputError: A source is neither such a file nor a folder with JSON files. That is found out before
            the first pattern is given.
    """
    return refuse_repeats(chain.from_iterable([_patterns_of(source) for source in sources]))


def _patterns_of(source: Path) -> Iterator[BatchPattern]:
    try:
        exists = source.exists()
    except (OSError, ValueError) as error:  # no possible file name
        raise InputError(f"Cannot read {str(source)!r}: {error}.") from error
    if not exists:
        raise InputError(
            f"There is no file or folder '{source}'. Give patterns as .jsonl, .jsonl.gz or folder."
        )
    if source.is_dir():
        return _from_folder(source)
    if source.name.lower().endswith(LINE_ENDINGS):
        return _from_lines(source)
    raise InputError(
        f"'{source.name}' is not a batch of patterns. Give a .jsonl or .jsonl.gz file with one "
        '{"id": ..., "pattern": ...} a line, or a folder of .json files. '
        "For a single pattern: swifttailor drape PATTERN --out DIR"
    )


def folder_name(id: str) -> str:
    """A folder name for an id: the id itself where it is safe on all systems, else with a hash."""
    safe = _UNSAFE.sub("_", id)[:_FOLDER_LENGTH]
    if safe == id and not _DEVICE_NAME.fullmatch(id):
        return id
    return f"{safe}-{hashlib.sha256(id.encode()).hexdigest()[:8]}"


def pattern_files(folder: Path) -> list[Path]:
    """The .json files of a folder by name, but for hidden ones: a killed program may have left half."""
    return sorted(path for path in folder.glob("*.json") if not path.name.startswith("."))


def _from_folder(folder: Path) -> Iterator[BatchPattern]:
    paths = pattern_files(folder)
    if not paths:
        raise InputError(
            f"The folder '{folder}' holds no .json files. Give a folder of GarmentCode patterns."
        )
    for number, path in enumerate(paths, 1):
        yield BatchPattern(path.stem, folder_name(path.stem), str(path), number, path=path)


def _from_lines(source: Path) -> Iterator[BatchPattern]:
    for number, line, trouble in _bounded_lines(source):
        where = f"{source.name} line {number}"
        if trouble:
            yield _unusable(number, where, trouble)
        elif line.strip():
            yield _parse_line(number, where, line)


def _parse_line(number: int, where: str, line: bytes) -> BatchPattern:
    try:
        value = parse_json(line, where)
    except SwiftTailorError as error:
        return _unusable(number, where, str(error))
    if not isinstance(value, dict) or "pattern" not in value or "id" not in value:
        return _unusable(number, where, 'The line is not an object with "id" and "pattern".')
    id = value["id"]
    if isinstance(id, int) and not isinstance(id, bool):
        id = str(id)
    if not isinstance(id, str) or not 1 <= len(id) <= MAX_ID_LENGTH or not id.isprintable() or id[0] == "#":
        return _unusable(
            number,
            where,
            f"The id {str(id)[:60]!r} cannot be used; text of 1 to {MAX_ID_LENGTH} printable characters "
            "that does not start with # is accepted.",
        )
    return BatchPattern(id, folder_name(id), where, number, line=line)


def _unusable(number: int, where: str, error: str) -> BatchPattern:
    return BatchPattern(f"#{number}", "", where, number, error=error)


def _bounded_lines(source: Path) -> Iterator[tuple[int, bytes, str]]:
    """(number from 1, line, what is wrong with it); a damaged file ends with such a trouble."""
    number = 0
    try:
        with _open(source) as stream:
            while line := stream.readline(MAX_FILE_BYTES):
                number += 1
                if len(line) < MAX_FILE_BYTES or line.endswith(b"\n"):
                    yield number, line, ""
                    continue
                while (rest := stream.readline(_CHUNK)) and not rest.endswith(b"\n"):
                    pass
                yield number, b"", f"The line is longer than {MAX_FILE_BYTES // 2**20} MB."
    except (OSError, EOFError, zlib.error) as error:
        if number == 0:
            why = getattr(error, "strerror", None) or error
            raise InputError(f"Cannot read '{source}' as patterns: {why}.") from error
        yield number + 1, b"", f"The file is damaged from here on ({error}); the rest was not read."


def _open(source: Path) -> gzip.GzipFile | BufferedReader:
    return gzip.open(source, "rb") if source.name.lower().endswith(".gz") else source.open("rb")


def refuse_repeats(patterns: Iterator[BatchPattern]) -> Iterator[BatchPattern]:
    """Ids must differ, also where upper and lower case are the same to the file system."""
    seen: dict[str, str] = {}
    for pattern in patterns:
        key = pattern.folder.lower()
        if pattern.error or key not in seen:
            if not pattern.error:
                seen[key] = pattern.source
            yield pattern
        else:
            message = f"The id '{pattern.id}' was used before ({seen[key]}); ids must differ."
            yield _unusable(pattern.number, pattern.source, message)
