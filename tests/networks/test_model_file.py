"""One loader for the model files of all networks."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.model_file import KIND as SEWER
from swifttailor.garment_sewer.sewer import SHIPPED as SEWER_FILE
from swifttailor.networks import model_file
from swifttailor.networks.model_file import (
    GRAPH,
    ModelKind,
    open_model,
    read_archive,
    write_archive,
    write_graph,
)
from swifttailor.pattern_maker.network.model_file import KIND as MAKER
from swifttailor.wishes.reader import KIND as READER
from swifttailor.wishes.reader import SHIPPED as READER_FILE

TINY_MAKER = Path(__file__).parents[1] / "pattern_maker/tiny_maker.zip"
TINY_SEWER = Path(__file__).parents[1] / "garment_sewer/tiny_sewer.onnx"
FILES = {"maker": (TINY_MAKER, MAKER), "sewer": (TINY_SEWER, SEWER), "reader": (READER_FILE, READER)}


@pytest.mark.parametrize("name", FILES)
def test_each_file_is_its_kind_and_no_other(name):
    path, kind = FILES[name]
    model = open_model(path, kind)
    assert model.about["format"] == kind.format and isinstance(model.about["card"], dict)
    assert model.sessions.keys() in [graphs.keys() for graphs in kind.graphs]
    for other in (MAKER, SEWER, READER):
        if other is not kind:
            with pytest.raises(InputError, match=path.name):
                open_model(path, other)


def test_cards_beside_the_shipped_files_are_those_inside():
    for path, kind in ((SEWER_FILE, SEWER), (READER_FILE, READER)):
        assert json.loads(path.with_suffix(".json").read_text()) == open_model(path, kind).about["card"]


@pytest.mark.parametrize("name", FILES)
def test_missing_large_and_empty_files_are_refused(name, tmp_path):
    path, kind = FILES[name]
    with pytest.raises(InputError, match="Cannot read the weights"):
        open_model(tmp_path / "none", kind)
    with pytest.raises(InputError, match="Cannot read the weights"):
        open_model(tmp_path, kind)
    with pytest.raises(InputError, match="larger than 0 MB"):
        open_model(path, replace(kind, max_bytes=1000))
    empty = tmp_path / "empty"
    empty.write_bytes(b"")
    with pytest.raises(InputError, match="empty"):
        open_model(empty, kind)


def test_graphs_with_other_inputs_or_outputs_are_refused():
    inputs, outputs = SEWER.graphs[0][GRAPH]
    for wanted in ((inputs[:2], outputs), (inputs, ("depths",))):
        with pytest.raises(InputError, match="is another network: it makes positions of conditioning"):
            open_model(TINY_SEWER, replace(SEWER, graphs=({GRAPH: wanted},)))


def test_what_contradicts_the_card_is_said(tmp_path):
    model = open_model(TINY_SEWER, SEWER)
    with pytest.raises(InputError, match="the width should be 3, and is 2"):
        model.require({"the height": (1, 1), "the width": (2, 3)})
    with (
        pytest.raises(InputError, match=r"does not say how wide it is: KeyError\('width'\)"),
        model.says("how wide it is"),
    ):
        model.about["width"]
    assert model.shape_given(GRAPH, "prior")[1] == model.shape_made(GRAPH, "positions")[1] == 3


def test_an_archive_is_written_as_it_was_read(tmp_path):
    about, members = read_archive(TINY_MAKER, MAKER)
    again = write_archive(tmp_path / "again.zip", MAKER, members, about["card"])
    assert again.read_bytes() == TINY_MAKER.read_bytes()


@pytest.fixture
def graph() -> bytes:
    """y = x + w."""
    import numpy as np
    from onnx import TensorProto, helper, numpy_helper

    weight = numpy_helper.from_array(np.arange(1000, dtype=np.float32), "w")
    shape = helper.make_tensor_value_info
    made = helper.make_graph(
        [helper.make_node("Add", ["x", "w"], ["y"])],
        "add",
        [shape("x", TensorProto.FLOAT, [1000])],
        [shape("y", TensorProto.FLOAT, [1000])],
        [weight],
    )
    model = helper.make_model(made, opset_imports=[helper.make_opsetid("", 18)], ir_version=9)
    return model.SerializeToString()


ADDER = ModelKind("adder", "adder 1", 2**20, ({GRAPH: (("x",), ("y",))},))


@pytest.mark.needs_torch
def test_a_graph_says_what_it_is_and_is_refused_wherever_it_is_damaged(graph, tmp_path):
    path = write_graph(tmp_path / "adder.onnx", ADDER, graph, {"seed": 3}, more="words")
    whole = path.read_bytes()
    assert whole.startswith(graph)
    assert write_graph(tmp_path / "again.onnx", ADDER, graph, {"seed": 3}, more="words").read_bytes() == whole
    model = open_model(path, ADDER)
    assert (model.about["card"], model.about["more"]) == ({"seed": 3}, "words")
    assert model.about[GRAPH] == {"bytes": len(graph), "sha256": hashlib.sha256(graph).hexdigest()}
    for place in range(0, len(graph), len(graph) // 60):
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 0x10]) + whole[place + 1 :])
        with pytest.raises(InputError, match=r"adder\.onnx"):
            open_model(path, ADDER)


@pytest.mark.needs_torch
def test_names_and_cards_that_are_not_text_are_refused(graph, tmp_path):
    path = write_graph(tmp_path / "adder.onnx", ADDER, graph, {"seed": 3})
    whole = path.read_bytes()
    assert b'"seed"' in whole and b"\x0a\x01x" in graph
    path.write_bytes(whole.replace(b'"seed"', b'"s\xeded"'))
    with pytest.raises(InputError, match="not text in UTF-8"):
        open_model(path, ADDER)
    path = write_graph(tmp_path / "names.onnx", ADDER, graph.replace(b"\x0a\x01x", b"\x0a\x01\xed"), {})
    with pytest.raises(InputError, match=r"not text in UTF-8|not a network that can be run"):
        open_model(path, ADDER)


def test_axes_whose_names_are_not_text_are_refused_before_they_are_needed():
    class Value:
        name = "x"

        @property
        def shape(self):
            return [b"\x8f".decode()]

    class Session:
        def get_inputs(self):
            return [Value()]

        get_outputs = get_inputs

    with pytest.raises(InputError, match=r"'a\.zip, trust\.onnx' is damaged: a name or its card is not text"):
        model_file._require_signature(Session(), (("x",), ("x",)), "a.zip, trust.onnx")


@pytest.mark.needs_torch
def test_weights_in_other_files_are_not_read(graph, tmp_path):
    import onnx

    model = onnx.load_from_string(graph)
    (tmp_path / "secret").write_bytes(model.graph.initializer[0].raw_data)
    onnx.external_data_helper.set_external_data(model.graph.initializer[0], "secret")
    model.graph.initializer[0].ClearField("raw_data")
    path = write_graph(tmp_path / "adder.onnx", ADDER, model.SerializeToString(), {})
    with pytest.raises(InputError, match="keeps weights in other files"):
        open_model(path, ADDER)
