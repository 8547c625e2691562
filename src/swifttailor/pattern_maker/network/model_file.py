"""The file of a trained network: ONNX graphs, text tokens and card in one ZIP archive."""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swifttailor.atomic_files import write_atomically
from swifttailor.errors import InputError
from swifttailor.networks.onnx_session import open_session
from swifttailor.networks.text_tokenizer import TextTokenizer
from swifttailor.pattern_maker.asking.confidence import Calibration
from swifttailor.pattern_maker.asking.copying import LEANINGS
from swifttailor.pattern_maker.asking.foresight import FORESEEN
from swifttailor.pattern_maker.network.network_config import NetworkConfig
from swifttailor.pattern_maker.network.runtime import (
    COPYING_GRAPHS,
    GRAPHS,
    PLANNING_GRAPHS,
    OnnxRuntime,
    Runtime,
    signature,
)
from swifttailor.pattern_maker.tokens.grammar import Grammar
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, SIZE

FORMAT = "swifttailor pattern-maker 1"
CARD, TEXT, CONFIDENCE = "card.json", "text_tokens.json", "confidence.json"
MAX_BYTES = 2**31
_DATE = (1980, 1, 1, 0, 0, 0)
_MEMBERS = {CARD, TEXT, *(f"{name}.onnx" for name in GRAPHS)}
_OF_COPYING = {f"{name}.onnx" for name in COPYING_GRAPHS}
_OF_PLANNING = {f"{name}.onnx" for name in PLANNING_GRAPHS}


@dataclass(frozen=True, eq=False)
class MakerModel:
    """A network ready to run, and how it wants to be asked."""

    runtime: Runtime
    text: TextTokenizer
    grammar: Grammar
    """What it was trained to write."""
    longest_text: int
    """Tokens of a text that it reads."""
    image_size: int
    """Pixels along each side of a picture."""
    image_tokens: int
    card: dict[str, Any]
    """What it was trained on and how good it is."""
    brief_edits: bool = False
    """Whether it is told the outlines of a pattern to edit, and not all of it."""
    calibration: Calibration | None = None
    """What is usual for it; None where that was not measured."""


def write_model(path: Path, graphs: Mapping[str, bytes], text: TextTokenizer, card: dict[str, Any]) -> Path:
    """Writes a model file; the same content gives the same bytes.

    Args:
        path: File to write, ``.zip``.
        graphs: ONNX graphs by their names in `GRAPHS`, `COPYING_GRAPHS` and `PLANNING_GRAPHS`.
        text: Text tokens.
        card: Of the run.

    Raises:
        InputError: The file cannot be written.
    """
    members = {f"{name}.onnx": graph for name, graph in graphs.items()} | {TEXT: text.to_json().encode()}
    return _write(path, members, card)


def add_calibration(path: Path, calibration: Calibration) -> Path:
    """Writes into a model file what is usual for its network.

    Raises:
        InputError: The file is no model file, or cannot be written.
    """
    members = _read_members(path)
    card = _read_about(members, path)["card"]
    del members[CARD]
    return _write(path, members | {CONFIDENCE: calibration.to_json().encode()}, card)


def _write(path: Path, members: Mapping[str, bytes], card: dict[str, Any]) -> Path:
    about = {
        "format": FORMAT,
        "sha256": {name: hashlib.sha256(data).hexdigest() for name, data in members.items()},
        "card": card,
    }
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_STORED) as archive:
        cover = (json.dumps(about, indent=1, allow_nan=False) + "\n").encode()
        for name, data in {CARD: cover, **members}.items():
            archive.writestr(zipfile.ZipInfo(name, _DATE), data)
    return write_atomically(path, lambda temporary: temporary.write_bytes(buffer.getvalue()))


def load_model(path: Path | str, *, threads: int = 1) -> MakerModel:
    """Opens a model file with onnxruntime.

    Args:
        path: File that ``swifttailor train export`` has written.
        threads: Processor cores to run on.

    Raises:
        InputError: It is missing, damaged, or another kind of file.
    """
    path = Path(path)
    members = _read_members(path)
    about = _read_about(members, path)
    text = TextTokenizer.from_json(members[TEXT], f"{path}, {TEXT}")
    try:
        card = about["card"]
        network, tags = network_of(card), card["config"]["tags"]
        grammar = Grammar(tags={"ascending": "ascending", "random": "any"}[tags])
    except (KeyError, TypeError, InputError) as error:
        raise InputError(f"'{path}' does not say how it must be asked: {error!r}.") from error
    calibration = None
    if CONFIDENCE in members:
        calibration = Calibration.from_json(members[CONFIDENCE], f"{path}, {CONFIDENCE}")
    sessions = {
        name: open_session(members[f"{name}.onnx"], f"{path}, {name}.onnx", "PatternMaker", threads=threads)
        for name in GRAPHS | COPYING_GRAPHS | PLANNING_GRAPHS
        if f"{name}.onnx" in members
    }
    for name, session in sessions.items():
        _require_signature(name, session, path, planning=PLANNING_GRAPHS.keys() <= sessions.keys())
    given = {name: {i.name: i.shape for i in s.get_inputs()} for name, s in sessions.items()}
    made = {name: {o.name: o.shape for o in s.get_outputs()} for name, s in sessions.items()}
    hidden = made["embed"]["embedded"][2]
    facts = {
        "the pictures' size": (given["vision"]["pictures"][2:], [network.image_size] * 2),
        "the places of a picture": (made["vision"]["looks"][1:], [network.image_tokens, hidden]),
        "the decoder's width": (given["decoder"]["embedded"][2], hidden),
        "the tokens of patterns": (made["decoder"]["logits"][2], SIZE),
        "the numbers of a token": (given["embed"]["numbers"][2], NUMBERS),
        "the numbers predicted": (made["regress"]["numbers"][1], NUMBERS),
    }
    if "leaning" in sessions:
        facts["what it says of counterparts"] = (made["leaning"]["leanings"][1], LEANINGS)
        facts["the counterparts' width"] = (made["counterpart"]["added"][2], hidden)
    if "plan" in sessions:
        facts["what it foresees"] = (made["plan"]["foreseen"][1], FORESEEN)
        facts["the plan's width"] = (made["planned"]["added"][2], hidden)
        facts["what it trusts"] = (made["trust"]["shares"][1], NUMBERS)
    if calibration is not None:
        facts["what is usual for pictures"] = (len(calibration.space.mean), hidden)
    for what, (found, wanted) in facts.items():
        if found != wanted:
            raise InputError(f"'{path}' contradicts itself: {what} should be {wanted}, and is {found}.")
    return MakerModel(
        runtime=OnnxRuntime(sessions),
        text=text,
        grammar=grammar,
        longest_text=network.longest_text,
        image_size=network.image_size,
        image_tokens=network.image_tokens,
        card=card,
        brief_edits=network.edits == "outlines",
        calibration=calibration,
    )


def network_of(card: dict[str, Any]) -> NetworkConfig:
    """The shape of the network of a card.

    Raises:
        KeyError, TypeError, InputError: The card does not say.
    """
    return NetworkConfig(**card["config"]["network"])


def _read_members(path: Path) -> dict[str, bytes]:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"'{path}' is larger than 2 GB; a PatternMaker's file is smaller.")
        with zipfile.ZipFile(path) as archive:
            infos = archive.infolist()
            names = [info.filename for info in infos]
            found = set(names) - {CONFIDENCE}
            copying = _MEMBERS | _OF_COPYING
            if len(set(names)) < len(names) or found not in (_MEMBERS, copying, copying | _OF_PLANNING):
                raise InputError(
                    f"'{path}' is no PatternMaker: it holds {', '.join(names[:8]) or 'nothing'}, not "
                    f"{', '.join(sorted(_MEMBERS))}. Give the file of a PatternMaker."
                )
            if any(i.compress_type != zipfile.ZIP_STORED or i.file_size > MAX_BYTES for i in infos):
                raise InputError(f"'{path}' was packed by another program. Give the file as it was exported.")
            return {info.filename: archive.read(info) for info in infos}
    except OSError as error:
        raise InputError(f"Cannot read the weights '{path}': {error.strerror or error}.") from error
    except (zipfile.BadZipFile, ValueError, RuntimeError, NotImplementedError, EOFError) as error:
        raise InputError(
            f"'{path}' is no PatternMaker, or is damaged ({error}). Give the file of a PatternMaker, or copy "
            "it again from where it came."
        ) from error


def _read_about(members: Mapping[str, bytes], path: Path) -> dict[str, Any]:
    try:
        about = json.loads(members[CARD])
        known, checksums = about["format"], dict(about["sha256"])
    except (ValueError, KeyError, TypeError, RecursionError):
        known, checksums, about = "nothing", {}, {}
    if known != FORMAT:
        raise InputError(
            f"'{path}' is no PatternMaker of this version ({known} instead of '{FORMAT}'). Export it again "
            "with this version."
        )
    for name, data in members.items():
        if name != CARD and hashlib.sha256(data).hexdigest() != checksums.get(name):
            raise InputError(
                f"'{path}' is damaged: {name} is not what {CARD} says. Copy it again from where it came."
            )
    return about


def _require_signature(name: str, session: Any, path: Path, *, planning: bool) -> None:
    inputs, outputs = signature(name, planning=planning)
    found = (
        tuple(i.name for i in session.get_inputs()),
        tuple(o.name for o in session.get_outputs()),
    )
    if found != (inputs, outputs):
        raise InputError(
            f"'{path}', {name}.onnx is another network: it makes {', '.join(found[1])} of "
            f"{', '.join(found[0])}, not {', '.join(outputs)} of {', '.join(inputs)}."
        )
