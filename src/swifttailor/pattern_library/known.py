"""The library of known patterns: one file, opened in milliseconds; patterns are unpacked when taken."""

from __future__ import annotations

import contextlib
import io
import json
import math
import struct
import zipfile
import zlib
from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import read_npy_header
from swifttailor.atomic_files import write_atomically
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern_library.packing import deflated, dictionary_of, inflated, pattern_of, short_json
from swifttailor.pattern_library.truth_table import TruthTable
from swifttailor.picture_reader.labels import labels_checksum

SHIPPED = Path(__file__).with_name("known_patterns.zip")
FORMAT = "swifttailor known-patterns 1"
ABOUT, PATTERNS, DICTIONARY = "about.json", "patterns", "dictionary"
ENDS, DIGESTS, STANDS_FOR = "ends", "digests", "stands_for"
MOST_PATTERNS, MOST_BYTES = 100_000, 2**27
_ARRAYS = (ENDS, DIGESTS, STANDS_FOR, "part", "true", "unclear", "measures", "panels", "boxes")
_DATE = (1980, 1, 1, 0, 0, 0)
# RuntimeError: deep nesting, or a compression or encryption that zipfile lacks.
_DAMAGED = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    KeyError,
    TypeError,
    ValueError,
    EOFError,
    RuntimeError,
)


@dataclass(frozen=True, eq=False)
class PatternLibrary:
    """N patterns and what is true of each."""

    table: TruthTable
    ids: tuple[str, ...]
    """Of their sources, such as ``gc_50000000``."""
    digests: tuple[str, ...]
    """`pattern_digest` of each as it was before it was rounded."""
    stands_for: NDArray[np.int64]
    """(N,) for how many garments each was the nearest when it was chosen: patterns of a library lie
    apart even where garments are many."""
    card: dict[str, Any]
    """What it was made of, and how."""
    _packed: bytes
    _ends: NDArray[np.int64]
    _dictionary: bytes

    def __len__(self) -> int:
        return len(self.ids)

    def pattern(self, number: int) -> Pattern:
        """One of them, in canonical order, named by its id.

        Raises:
            InputError: The file is damaged there.
        """
        begin = int(self._ends[number - 1]) if number else 0
        data = inflated(self._packed[begin : int(self._ends[number])], self._dictionary)
        return pattern_of(data, self.ids[number])

    @staticmethod
    def load(path: Path | str | None = None) -> PatternLibrary:
        """Opens a library.

        Args:
            path: Its file; the one that comes with the package when None.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        path = SHIPPED if path is None else Path(path)
        with _says(path), zipfile.ZipFile(path) as archive:
            if sum(member.file_size for member in archive.infolist()) > MOST_BYTES:
                raise InputError(f"It unpacks to more than {MOST_BYTES} bytes.")
            about = json.loads(archive.read(ABOUT))
            if about["format"] != FORMAT:
                raise InputError(f"Its format is {about['format']!r}; {FORMAT!r} is expected.")
            if about["labels_sha256"] != labels_checksum():
                raise InputError("It was made for other statements than this version's. Make it again.")
            arrays = {name: _read_array(archive, name) for name in _ARRAYS}
            ids = tuple(str(one) for one in about["ids"])
            packed, dictionary = archive.read(PATTERNS), archive.read(DICTIONARY)
            ends, digests, stand = (arrays.pop(name) for name in (ENDS, DIGESTS, STANDS_FOR))
            if not 0 < len(ids) <= MOST_PATTERNS or len(arrays["part"]) != len(ids):
                raise InputError(f"It has {len(ids)} ids and {len(arrays['part'])} patterns.")
            sound = ends.dtype == np.int64 and ends.shape == (len(ids),) and digests.shape == (len(ids), 32)
            if not sound or ends[-1] != len(packed) or (np.diff(ends, prepend=0) <= 0).any():
                raise InputError("Its patterns do not lie one after the other.")
            if stand.dtype != np.int64 or stand.shape != (len(ids),) or (stand < 0).any():
                raise InputError("It does not say how many garments each pattern stands for.")
            names = tuple(row.tobytes().hex() for row in digests.astype(np.uint8))
            table = TruthTable.unpacked(arrays)
            return PatternLibrary(table, ids, names, stand, about["card"], packed, ends, dictionary)


@dataclass(frozen=True, eq=False)
class KnownPattern:
    """A pattern for a library."""

    id: str
    pattern: Pattern


def rounded(pattern: Pattern) -> Pattern:
    """A pattern as a library gives it back."""
    return replace(pattern_of(short_json(pattern), "pattern"), name=pattern.name)


def write_library(
    path: Path | str,
    known: Sequence[KnownPattern],
    table: TruthTable,
    stands_for: NDArray[np.int64],
    card: dict[str, Any],
    *,
    overwrite: bool = False,
) -> Path:
    """Writes a library; the same patterns give the same bytes.

    Args:
        path: File to write, ``.zip``.
        known: Its patterns.
        table: What is true of each.
        stands_for: (N,) see `PatternLibrary.stands_for`.
        card: What it is made of, and how.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: There is none, there are not equally many, or the file cannot be written.
    """
    if not known or len(known) != len(table):
        raise InputError(f"Got {len(known)} patterns and {len(table)} rows; give equally many, at least one.")
    written = [short_json(one.pattern) for one in known]
    dictionary = dictionary_of(written)
    parts = [deflated(data, dictionary) for data in written]
    digests = b"".join(bytes.fromhex(pattern_digest(one.pattern)) for one in known)
    arrays = {
        ENDS: np.cumsum([len(p) for p in parts], dtype=np.int64),
        DIGESTS: np.frombuffer(digests, np.uint8).reshape(len(known), 32),
        STANDS_FOR: np.asarray(stands_for, np.int64),
        **table.packed(),
    }
    about = {
        "format": FORMAT,
        "labels_sha256": labels_checksum(),
        "ids": [one.id for one in known],
        "card": card,
    }

    def write(temporary: Path) -> None:
        with zipfile.ZipFile(temporary, "w") as archive:
            _add(archive, ABOUT, json.dumps(about, separators=(",", ":")).encode())
            for name, array in arrays.items():
                stream = io.BytesIO()
                np.save(stream, array, allow_pickle=False)
                _add(archive, f"{name}.npy", stream.getvalue())
            _add(archive, DICTIONARY, dictionary)
            _add(archive, PATTERNS, b"".join(parts), packed=False)

    return write_atomically(path, write, overwrite=overwrite)


def _add(archive: zipfile.ZipFile, name: str, data: bytes, *, packed: bool = True) -> None:
    member = zipfile.ZipInfo(name, _DATE)
    member.compress_type = zipfile.ZIP_DEFLATED if packed else zipfile.ZIP_STORED
    archive.writestr(member, data)


def _read_array(archive: zipfile.ZipFile, name: str) -> NDArray[Any]:
    stream = io.BytesIO(archive.read(f"{name}.npy"))
    shape, fortran, kind = read_npy_header(stream)
    data = stream.read()
    if fortran or kind.hasobject or math.prod(shape) * kind.itemsize != len(data):
        raise ValueError(f"{name} is announced as {kind} of shape {shape} and has {len(data)} bytes")
    return np.frombuffer(data, kind).reshape(shape)


@contextlib.contextmanager
def _says(path: Path) -> Generator[None]:
    try:
        yield
    except InputError as error:
        raise InputError(f"The pattern library '{path}' cannot be used: {error}") from error
    except OSError as error:
        why = error.strerror or error
        raise InputError(f"The pattern library '{path}' cannot be read: {why}.") from error
    except _DAMAGED as error:
        raise InputError(f"The pattern library '{path}' is damaged: {error}.") from error
