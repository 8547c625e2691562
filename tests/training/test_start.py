"""Beginning with the weights of another run."""

from __future__ import annotations

import pytest

from swifttailor.errors import InputError

torch = pytest.importorskip("torch")
pytestmark = pytest.mark.needs_torch


def network(eye: int, projector: int = 3):
    torch.manual_seed(eye)
    parts = {"eye": torch.nn.Linear(eye, 3), "join": torch.nn.Linear(3, projector)}
    return torch.nn.ModuleDict(parts | {"mind": torch.nn.Linear(3, 3)})


@pytest.fixture
def file(tmp_path):
    from safetensors.torch import save_file

    save_file(network(2).state_dict(), tmp_path / "weights.safetensors")
    return tmp_path / "weights.safetensors"


def same(one, other):
    return all(torch.equal(a, b) for a, b in zip(one.parameters(), other.parameters(), strict=True))


def test_all_weights_of_the_same_network_are_taken(file):
    from swifttailor.training.start_torch import load_start

    made = network(2)
    torch.nn.init.zeros_(made["mind"].weight)
    assert load_start(made, file, [("eye.", "join.")]) == []
    assert same(made, network(2))


def test_an_optional_part_is_taken_whole_or_not_at_all(file):
    from swifttailor.training.start_torch import load_start

    made = network(4)  # its join has the shape of the file's, and belongs to another eye
    assert load_start(made, file, [("eye.", "join.")]) == ["eye.", "join."]
    assert same(made["mind"], network(2)["mind"])
    assert same(made["eye"], network(4)["eye"])
    assert same(made["join"], network(4)["join"])
    alone = network(4)
    assert load_start(alone, file, [("eye.",), ("join.",)]) == ["eye."]
    assert same(alone["join"], network(2)["join"])


def test_other_shapes_elsewhere_are_refused(file, tmp_path):
    from swifttailor.training.start_torch import load_start

    with pytest.raises(InputError, match="cannot be used"):
        load_start(network(4), file)
    file.write_bytes(file.read_bytes()[:40])
    with pytest.raises(InputError, match="cannot be used"):
        load_start(network(2), file, [("eye.",)])
