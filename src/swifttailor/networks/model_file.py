"""Model files: an ONNX graph, or several of them in a ZIP archive, and inside what they are.

A graph alone (``.onnx``) says so in its metadata, an archive (``.zip``) in its ``card.json``. Either way it
is JSON with the ``format``, the ``card`` of the training, and checksums of the rest of the file. Nothing in a
file is run but its graphs, and these hold all of their weights.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import zipfile
from collections.abc import Collection, Generator, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_bytes
from swifttailor.errors import InputError
from swifttailor.networks.onnx_contents import foreign_operators, keeps_values_elsewhere
from swifttailor.networks.onnx_session import open_session

CARD, NOTE = "card.json", "swifttailor"
"""Where an archive and a graph say what they are."""
GRAPH = "graph"
"""The name of the only graph of a file that is no archive."""
Signature = tuple[tuple[str, ...], tuple[str, ...]]
"""Names of the inputs and outputs of a graph."""
_DATE = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class ModelKind:
    """What the file of a network holds."""

    name: str
    """Of the network, for messages."""
    format: str
    max_bytes: int
    graphs: tuple[Mapping[str, Signature], ...]
    """The sets of graphs that it may hold, each complete; a file that is no archive holds one graph. A graph
    may have any of the signatures that sets of the same names give it."""
    archive: bool = False
    needs: frozenset[str] = frozenset()
    """What an archive holds besides."""
    may_hold: frozenset[str] = frozenset()


@dataclass(frozen=True, eq=False)
class ModelFile:
    """A model file, opened and found sound."""

    path: Path
    about: dict[str, Any]
    """What it says of itself: ``format``, ``card``, and what its kind adds."""
    sessions: dict[str, Any]
    """The graphs by name, ready to run with onnxruntime."""
    members: dict[str, bytes]
    """What an archive holds besides its graphs and card."""

    def shape_given(self, graph: str, name: str) -> list[Any]:
        """The shape of an input; axes without a fixed size are names."""
        return next(i.shape for i in self.sessions[graph].get_inputs() if i.name == name)

    def shape_made(self, graph: str, name: str) -> list[Any]:
        """The shape of an output."""
        return next(o.shape for o in self.sessions[graph].get_outputs() if o.name == name)

    @contextlib.contextmanager
    def says(self, what: str) -> Generator[None]:
        """Where the card is read: whatever it lacks becomes the message that it does not say `what`.

        Raises:
            InputError: It does not.
        """
        try:
            yield
        except (KeyError, TypeError, ValueError, InputError) as error:
            raise InputError(f"'{self.path}' does not say {what}: {error!r}.") from error

    def require(self, facts: Mapping[str, tuple[Any, Any]]) -> None:
        """Compares what is found in the graphs with what card and version want.

        Args:
            facts: What it is, as (found, wanted).

        Raises:
            InputError: They differ.
        """
        for what, (found, wanted) in facts.items():
            if found != wanted:
                raise InputError(
                    f"'{self.path}' contradicts itself: {what} should be {wanted}, and is {found}."
                )


def open_model(
    path: Path | str, kind: ModelKind, *, threads: int = 1, only: Collection[str] = ()
) -> ModelFile:
    """Reads a model file and opens its graphs.

    Args:
        path: The file.
        kind: What it must be.
        threads: Processor cores to run on.
        only: Of an archive the graphs that are read, as far as it holds them; all when empty.

    Raises:
        InputError: It is missing, too large, damaged, or another kind of file.
    """
    path = Path(path)
    if kind.archive:
        about, members = read_archive(path, kind, only)
        graphs = {name: members.pop(f"{name}.onnx") for name in _graphs_in(members)}
        sources = {name: f"{path}, {name}.onnx" for name in graphs}
    else:
        about, members = {}, {}
        graphs, sources = {GRAPH: read_bytes(path, kind.max_bytes)}, {GRAPH: str(path)}
    for name, graph in graphs.items():
        _require_self_contained(graph, sources[name], kind)
    sessions = {
        name: open_session(graph, sources[name], kind.name, threads=threads) for name, graph in graphs.items()
    }
    if not kind.archive:
        about = _read_note(sessions[GRAPH], graphs[GRAPH], path, kind)
    may_be = [s for s in kind.graphs if (s.keys() >= graphs.keys() if only else s.keys() == graphs.keys())]
    for name, session in sessions.items():
        _require_signature(session, [wanted[name] for wanted in may_be], sources[name])
    return ModelFile(path, about, sessions, members)


def read_bytes(path: Path, max_bytes: int) -> bytes:
    """The content of a model file.

    Raises:
        InputError: It cannot be read or is too large.
    """
    try:
        _require_size(path, max_bytes)
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"Cannot read the weights '{path}': {error.strerror or error}.") from error


def read_archive(
    path: Path, kind: ModelKind, only: Collection[str] = ()
) -> tuple[dict[str, Any], dict[str, bytes]]:
    """What an archive says of itself, and everything else in it, compared with its checksums.

    Args:
        path: The file.
        kind: What it must be.
        only: The graphs that are read, as far as it holds them; all when empty.

    Raises:
        InputError: It is missing, too large, damaged, or another kind of file.
    """
    try:
        _require_size(path, kind.max_bytes)
        with zipfile.ZipFile(path) as archive:
            infos = archive.infolist()
            names = [info.filename for info in infos]
            sets = [{CARD, *kind.needs, *(f"{graph}.onnx" for graph in graphs)} for graphs in kind.graphs]
            if len(set(names)) < len(names) or set(names) - kind.may_hold not in sets:
                raise InputError(
                    f"'{path}' is not a {kind.name}: it holds {', '.join(names[:8]) or 'nothing'}, not "
                    f"{', '.join(sorted(sets[0]))}. Give the file of a {kind.name}."
                )
            if any(i.compress_type != zipfile.ZIP_STORED or i.file_size > kind.max_bytes for i in infos):
                raise InputError(f"'{path}' was packed by another program. Give the file as it was exported.")
            left = {f"{graph}.onnx" for graph in _graphs_in(names) if only and graph not in only}
            members = {name: archive.read(name) for name in names if name not in left}
    except OSError as error:
        raise InputError(f"Cannot read the weights '{path}': {error.strerror or error}.") from error
    except (zipfile.BadZipFile, ValueError, RuntimeError, NotImplementedError, EOFError) as error:
        raise InputError(
            f"'{path}' is not a {kind.name}, or is damaged ({error}). Give the file of a {kind.name}, or "
            "copy it again from where it came."
        ) from error
    about = _read_about(members.pop(CARD), path, kind)
    checksums = about.get("sha256")
    for name, data in members.items():
        if not isinstance(checksums, dict) or hashlib.sha256(data).hexdigest() != checksums.get(name):
            raise InputError(
                f"'{path}' is damaged: {name} is not what {CARD} says. Copy it again from its source."
            )
    return about, members


def holds_graphs_of(path: Path, kind: ModelKind) -> bool:
    """Whether a file is an archive with the graphs of a kind; opening it tells whether they are sound."""
    try:
        with zipfile.ZipFile(path) as archive:
            names = set(archive.namelist())
    except (OSError, zipfile.BadZipFile, ValueError, RuntimeError, NotImplementedError, EOFError):
        return False
    return any({f"{graph}.onnx" for graph in graphs} <= names for graphs in kind.graphs)


def write_archive(
    path: Path,
    kind: ModelKind,
    members: Mapping[str, bytes],
    card: dict[str, Any],
    *,
    overwrite: bool = False,
) -> Path:
    """Writes an archive; the same content gives the same bytes.

    Args:
        path: File to write, ``.zip``.
        kind: What it is.
        members: What it holds besides the card, by file name.
        card: Of the training.
        overwrite: Whether another file of that name is replaced.

    Raises:
        InputError: The file cannot be written.
    """
    checksums = {name: hashlib.sha256(data).hexdigest() for name, data in members.items()}
    about = {"format": kind.format, "sha256": checksums, "card": card}
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as archive:
        cover = (json.dumps(about, indent=1, allow_nan=False) + "\n").encode()
        for name, data in {CARD: cover, **members}.items():
            archive.writestr(zipfile.ZipInfo(name, _DATE), data)
    return write_bytes(path, buffer.getvalue(), overwrite=overwrite)


def write_graph(path: Path, kind: ModelKind, graph: bytes, card: dict[str, Any], **more: Any) -> Path:
    """Writes a graph with what it is in its metadata; the same content gives the same bytes.

    Args:
        path: File to write, ``.onnx``.
        kind: What it is.
        graph: The content of an .onnx file without metadata.
        card: Of the training.
        more: What else it says of itself.

    Raises:
        InputError: The file cannot be written.
    """
    import onnx

    checksum = {"bytes": len(graph), "sha256": hashlib.sha256(graph).hexdigest()}
    about = {"format": kind.format, **more, "card": card, GRAPH: checksum}
    note = onnx.ModelProto()
    entry = note.metadata_props.add()
    entry.key, entry.value = NOTE, json.dumps(about, separators=(",", ":"), allow_nan=False)
    # Protobuf reads one message behind the other as one: the graph stays at the front, byte for byte.
    whole = graph + note.SerializeToString()
    return write_bytes(path, whole)


def _require_size(path: Path, max_bytes: int) -> None:
    if path.stat().st_size > max_bytes:
        raise InputError(
            f"'{path}' is larger than {max_bytes >> 20} MB; a model file of this kind is smaller."
        )


def _require_self_contained(graph: bytes, source: str, kind: ModelKind) -> None:
    """Refuses a graph that would have other files read, or other people's code run."""
    try:
        foreign, elsewhere = foreign_operators(graph), keeps_values_elsewhere(graph)
    except ValueError as error:
        raise InputError(
            f"'{source}' is not a network that can be run, or is damaged (it has {error}). Give the file of "
            f"a {kind.name}, or copy it again from its source."
        ) from error
    if elsewhere:
        raise InputError(
            f"'{source}' keeps weights in other files (ONNX external data), which are never read. Give a "
            "file that holds them all: export it again without external data."
        )
    if foreign:
        raise InputError(
            f"'{source}' needs operators that onnxruntime does not have: {', '.join(sorted(foreign))}. "
            f"Libraries of custom operators are not loaded. Give the file of a {kind.name} of this version."
        )


def _graphs_in(members: Iterable[str]) -> list[str]:
    return [name.removesuffix(".onnx") for name in members if name.endswith(".onnx")]


def _read_note(session: Any, graph: bytes, path: Path, kind: ModelKind) -> dict[str, Any]:
    try:
        text = session.get_modelmeta().custom_metadata_map.get(NOTE, "")
    except UnicodeDecodeError as error:
        raise _not_text(str(path)) from error
    about = _read_about(text, path, kind)
    checksum = about.get(GRAPH)
    if checksum is not None:  # older files have none
        size = checksum.get("bytes") if isinstance(checksum, dict) else None
        if type(size) is not int or hashlib.sha256(graph[:size]).hexdigest() != checksum.get("sha256"):
            raise InputError(
                f"'{path}' is damaged: its graph is not what its card says. Copy it again from its source."
            )
    return about


def _read_about(text: str | bytes, path: Path, kind: ModelKind) -> dict[str, Any]:
    known: Any = None
    about: Any = None
    with contextlib.suppress(ValueError, KeyError, TypeError, RecursionError):
        about = json.loads(text)
        known = about["format"]
    if known != kind.format:
        raise InputError(
            f"'{path}' is a network, but not a {kind.name} of this version ({known or 'nothing'} instead of "
            f"'{kind.format}'). Export it again with this version."
        )
    return about


def _not_text(source: str) -> InputError:
    return InputError(
        f"'{source}' is damaged: a name or its card is not text in UTF-8. Copy it again from its source."
    )


def _require_signature(session: Any, accepted: Sequence[Signature], source: str) -> None:
    try:
        both = session.get_inputs(), session.get_outputs()
        # With the shapes: axes have names too, and what is not text is refused before it is needed.
        sides = [[(value.name, value.shape) for value in values] for values in both]
    except UnicodeDecodeError as error:
        raise _not_text(source) from error
    found = tuple(tuple(name for name, _ in side) for side in sides)
    if found not in accepted:
        wanted = accepted[0]
        raise InputError(
            f"'{source}' is another network: it makes {', '.join(found[1])} of {', '.join(found[0])}, not "
            f"{', '.join(wanted[1])} of {', '.join(wanted[0])}."
        )
