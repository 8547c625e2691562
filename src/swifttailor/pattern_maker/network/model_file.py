"""The file of a trained PatternMaker: ONNX graphs, text tokens and card in one ZIP archive."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from swifttailor.errors import InputError
from swifttailor.networks.model_file import ModelKind, open_model, read_archive, write_archive
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
from swifttailor.pattern_maker.tokens.name_text import NameText
from swifttailor.pattern_maker.tokens.vocabulary import NUMBERS, SIZE

Decoding = Literal["grammar", "free"]
"""Whether only patterns can be written, or anything."""

SHIPPED = Path(__file__).parents[1] / "pattern_maker.zip"
TEXT, CONFIDENCE = "text_tokens.json", "confidence.json"
KIND = ModelKind(
    "PatternMaker",
    "swifttailor pattern-maker 1",
    max_bytes=2**31,
    graphs=(
        GRAPHS,
        GRAPHS | COPYING_GRAPHS,
        {name: signature(name, planning=True) for name in GRAPHS | COPYING_GRAPHS | PLANNING_GRAPHS},
    ),
    archive=True,
    needs=frozenset({TEXT}),
    may_hold=frozenset({CONFIDENCE}),
)


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
    names: NameText | None = None
    """Of a network that writes names of panels as text."""
    decoding: Decoding = "grammar"
    """How its method decodes, where the network alone is measured."""


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
    return write_archive(path, KIND, members, card)


def add_calibration(path: Path, calibration: Calibration) -> Path:
    """Writes into a model file what is usual for its network.

    Raises:
        InputError: The file is no model file, or cannot be written.
    """
    about, members = read_archive(path, KIND)
    members |= {CONFIDENCE: calibration.to_json().encode()}
    return write_archive(path, KIND, members, about["card"], overwrite=True)


def load_model(path: Path | str, *, threads: int = 1) -> MakerModel:
    """Opens a model file with onnxruntime.

    Args:
        path: File that ``swifttailor train export`` has written.
        threads: Processor cores to run on.

    Raises:
        InputError: It is missing, damaged, or another kind of file.
    """
    model = open_model(path, KIND, threads=threads)
    text = TextTokenizer.from_json(model.members[TEXT], f"{path}, {TEXT}")
    with model.says("how it must be asked"):
        card = model.about["card"]
        network, tags = network_of(card), card["config"]["tags"]
        grammar = Grammar(tags={"ascending": "ascending", "random": "any"}[tags])
        names = NameText.of(text) if network.names == "text" else None
        decoding = decoding_of(card)
    calibration = None
    if CONFIDENCE in model.members:
        calibration = Calibration.from_json(model.members[CONFIDENCE], f"{path}, {CONFIDENCE}")
    given, made = model.shape_given, model.shape_made
    hidden = made("embed", "embedded")[2]
    facts = {
        "the pictures' size": (given("vision", "pictures")[2:], [network.image_size] * 2),
        "the places of a picture": (made("vision", "looks")[1:], [network.image_tokens, hidden]),
        "the decoder's width": (given("decoder", "embedded")[2], hidden),
        "the tokens of patterns": (made("decoder", "logits")[2], SIZE if names is None else names.outputs),
        "the numbers of a token": (given("embed", "numbers")[2], NUMBERS),
        "the numbers predicted": (made("regress", "numbers")[1], NUMBERS),
    }
    if "leaning" in model.sessions:
        facts["what it says of counterparts"] = (made("leaning", "leanings")[1], LEANINGS)
        facts["the counterparts' width"] = (made("counterpart", "added")[2], hidden)
    if "plan" in model.sessions:
        facts["what it foresees"] = (made("plan", "foreseen")[1], FORESEEN)
        facts["the plan's width"] = (made("planned", "added")[2], hidden)
        facts["what it trusts"] = (made("trust", "shares")[1], NUMBERS)
    if calibration is not None:
        facts["what is usual for pictures"] = (len(calibration.space.mean), hidden)
    model.require(facts)
    return MakerModel(
        runtime=OnnxRuntime(model.sessions),
        text=text,
        grammar=grammar,
        longest_text=network.longest_text,
        image_size=network.image_size,
        image_tokens=network.image_tokens,
        card=card,
        brief_edits=network.edits == "outlines",
        calibration=calibration,
        names=names,
        decoding=decoding,
    )


def decoding_of(card: dict[str, Any]) -> Decoding:
    """How the method of a card decodes; under the grammar where it does not say.

    Raises:
        KeyError, TypeError, InputError: The card says something else.
    """
    found = card["config"].get("decoding", "grammar")
    if found not in ("grammar", "free"):
        raise InputError(f"decoding is {found!r}; grammar or free is accepted.")
    return found


def network_of(card: dict[str, Any]) -> NetworkConfig:
    """The shape of the network of a card.

    Raises:
        KeyError, TypeError, InputError: The card does not say.
    """
    return NetworkConfig(**card["config"]["network"])
