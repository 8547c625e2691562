"""Files that would have others read or run, made byte by byte."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.networks import model_file
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.networks.onnx_contents import MAX_FIELDS, foreign_operators, keeps_values_elsewhere
from swifttailor.wishes.reader import SHIPPED

ADDER = ModelKind("adder", "adder 1", 2**20, ({GRAPH: (("x",), ("y",))},))


def number(value: int) -> bytes:
    digits = []
    while value > 127:
        digits.append(value & 127 | 128)
        value >>= 7
    return bytes([*digits, value])


def field(key: int, content: bytes | int) -> bytes:
    """A field of a protobuf message: a text or message, or a number."""
    if isinstance(content, int):
        return number(key << 3) + number(content)
    return number(key << 3 | 2) + number(len(content)) + content


def opset(domain: str) -> bytes:
    return field(8, (field(1, domain.encode()) if domain else b"") + field(2, 18))


LOCATION = field(1, b"location") + field(2, b"/etc/passwd")
TURNED = field(2, b"/etc/passwd") + field(1, b"location")
ELSEWHERE = {
    "its key first": field(13, LOCATION) + field(14, 1),
    "its key last": field(13, TURNED),
    "a mark": field(14, 1),
}
INSIDE = field(1, 4) + field(9, b"\0" * 16) + field(14, 0)
PLACES = {
    "initializer": lambda t: field(7, field(5, t)),
    "sparse initializer": lambda t: field(7, field(15, field(1, t))),
    "constant": lambda t: field(7, field(1, field(5, field(5, t)))),
    "one of several constants": lambda t: field(7, field(1, field(5, field(10, INSIDE) + field(10, t)))),
    "inner graph": lambda t: field(7, field(1, field(5, field(6, field(5, t))))),
    "second half of a graph": lambda t: field(7, field(5, INSIDE)) + field(7, field(5, t)),
    "function": lambda t: field(25, field(7, field(5, field(5, t)))),
    "training": lambda t: field(20, field(1, field(5, t))),
}


@pytest.mark.parametrize("place", PLACES)
def test_values_in_other_files_are_found_wherever_they_stand(place):
    for how, tensor in ELSEWHERE.items():
        assert keeps_values_elsewhere(opset("") + PLACES[place](tensor)), how
    assert not keeps_values_elsewhere(opset("") + PLACES[place](INSIDE))


def test_a_name_is_no_location():
    node = field(1, b"location") + field(2, b"external_data")
    assert not keeps_values_elsewhere(field(7, field(1, node) + field(2, b"location")))


def test_operators_of_others_are_named():
    assert foreign_operators(opset("") + opset("com.microsoft") + opset("ai.onnx.ml")) == frozenset()
    assert foreign_operators(opset("evil.ops") + opset("") + opset("b")) == {"evil.ops", "b"}


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (opset("evil.ops") + opset(""), "needs operators that onnxruntime does not have: evil.ops"),
        (opset("") + PLACES["constant"](ELSEWHERE["its key last"]), "keeps weights in other files"),
        (opset("") + field(7, b"abc")[:-1], "is damaged"),
        (b"\x07", "is damaged"),
        (b"\xff" * 30, "is damaged"),
    ],
)
def test_such_files_are_refused_before_they_are_opened(content, said, tmp_path, monkeypatch):
    def opened(*given, **options):
        raise AssertionError("a session was made")

    monkeypatch.setattr(model_file, "open_session", opened)
    (tmp_path / "adder.onnx").write_bytes(content)
    with pytest.raises(InputError, match=said):
        open_model(tmp_path / "adder.onnx", ADDER)


def test_the_command_line_says_so(tmp_path, capsys):
    from swifttailor.cli.main import run
    from swifttailor.pattern import write_pattern
    from swifttailor.pattern.drafts import draft

    write_pattern(draft("t-shirt"), tmp_path / "shirt.json")
    (tmp_path / "evil.onnx").write_bytes(opset("evil.ops") + field(7, b""))
    files = ["sew", str(tmp_path / "shirt.json"), "--out", str(tmp_path / "out")]
    assert run([*files, "--weights", str(tmp_path / "evil.onnx")]) == 2
    assert "Error: " in (said := capsys.readouterr().err) and "evil.ops" in said
    assert not (tmp_path / "out").exists()


def test_weights_that_pass_for_fields_are_not_followed_for_long():
    most = field(9, b"") * (MAX_FIELDS - 3)  # a model, its graph and the tensor are fields too
    assert not keeps_values_elsewhere(field(7, field(5, most)))
    with pytest.raises(ValueError, match="fields"):
        keeps_values_elsewhere(field(7, field(5, field(9, b"") * MAX_FIELDS)))
    with pytest.raises(ValueError, match="fields"):
        foreign_operators(field(9, b"") * (MAX_FIELDS + 1))


@given(st.binary(max_size=200))
def test_any_bytes_are_read_or_refused(content):
    for look in (foreign_operators, keeps_values_elsewhere):
        try:
            look(content)
        except ValueError:
            pass


def test_shipped_graphs_hold_all_that_they_need():
    content = SHIPPED.read_bytes()
    assert not keeps_values_elsewhere(content) and foreign_operators(content) == frozenset()
    with pytest.raises(ValueError):
        keeps_values_elsewhere(content[:1000])


def _loaders():
    from swifttailor.garment_sewer.sewer import GarmentSewer
    from swifttailor.picture_reader.reader import PictureReader
    from swifttailor.wishes.reader import WishReader

    return {
        "sewer": GarmentSewer.load,
        "words": WishReader.load,
        "pictures": PictureReader.load,
        "close-ups": lambda path: PictureReader.load(close_ups=[path]),
    }


@pytest.mark.parametrize("reader", ["sewer", "words", "pictures", "close-ups"])
@pytest.mark.parametrize(
    ("content", "said"),
    [
        (opset("evil.ops") + opset(""), "evil.ops"),
        (opset("") + PLACES["constant"](ELSEWHERE["its key last"]), "keeps weights in other files"),
    ],
)
def test_every_network_refuses_such_files(reader, content, said, tmp_path):
    (tmp_path / "evil.onnx").write_bytes(content)
    with pytest.raises(InputError, match=said):
        _loaders()[reader](tmp_path / "evil.onnx")


@pytest.mark.needs_torch
def test_trainings_do_not_begin_with_such_files(tmp_path, monkeypatch):
    pytest.importorskip("torch")
    from swifttailor.networks.graph_weights_torch import graph_tensors

    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret").write_bytes(b"\0" * 64)
    tensor = field(1, 4) + field(2, 1) + field(8, b"weight") + field(14, 1)
    tensor += field(13, field(1, b"location") + field(2, b"secret"))
    with pytest.raises(InputError, match="keeps weights in other files"):
        graph_tensors(field(7, field(5, tensor)), "a graph")
    with pytest.raises(InputError, match="is damaged"):
        graph_tensors(field(7, field(5, field(1, 999) + field(2, 1) + field(8, b"weight"))), "a graph")
