"""The coarse drape is loaded beside the writing of a pattern; what goes wrong is raised where it is sewn."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from swifttailor.draping import compiled_code
from swifttailor.garment_sewer import sewer as sewer_module
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern.drafts import draft

TINY = Path(__file__).with_name("tiny_sewer.onnx")


class Reached(Exception):
    """The drawing of the prior."""


@pytest.fixture
def hung():
    """A sewer whose prior is the coarse drape, and that has begun nothing."""
    tiny = GarmentSewer.load(TINY)
    return replace(
        tiny, model=replace(tiny.model, conditioning=replace(tiny.model.conditioning, prior="hung"))
    )


@pytest.fixture
def begun(monkeypatch):
    """Every loading that is begun, and every wait for it, in order."""
    events = []

    class Loading:
        def wait(self):
            events.append("waited")

    def load(full, armless, measurements):
        events.append((full, armless, measurements))
        return Loading()

    def tabulate(*args, **kwargs):
        events.append("draped")
        raise Reached

    monkeypatch.setattr(compiled_code, "load_coarse_drape", load)
    monkeypatch.setattr(sewer_module, "tabulate", tabulate)
    return events


def test_it_is_begun_once_for_the_body_and_waited_for_before_the_drape(hung, begun):
    body = (hung.body.full, hung.body.without_arms, hung.body.measurements)
    for _ in range(3):
        hung.load_drape()
    assert len(begun) == 1 and all(a is b for a, b in zip(begun[0], body, strict=True))
    with pytest.raises(Reached):
        hung.prepare(draft("t-shirt"))
    assert begun[1:] == ["waited", "draped"]


def test_who_only_sews_begins_nothing(hung, begun):
    with pytest.raises(Reached):
        hung.prepare(draft("t-shirt"))
    assert begun == ["draped"]


def test_another_prior_needs_no_drape(begun, monkeypatch):
    tiny = GarmentSewer.load(TINY)
    assert tiny.model.conditioning.prior != "hung"
    tiny.load_drape()
    monkeypatch.setattr(compiled_code, "coarse_drape_is_compiled", lambda: False)
    assert not tiny.must_compile
    with pytest.raises(Reached):
        tiny.prepare(draft("t-shirt"))
    assert begun == ["draped"]


@pytest.mark.parametrize("compiled", [True, False])
def test_whether_the_first_garment_waits_for_the_compiler(hung, compiled, monkeypatch):
    monkeypatch.setattr(compiled_code, "coarse_drape_is_compiled", lambda: compiled)
    assert hung.must_compile is not compiled


def test_an_empty_cache_must_be_filled(hung, tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    assert hung.must_compile


def test_each_body_has_its_own_loading(hung, begun):
    hung.load_drape()
    other = replace(hung, body=replace(hung.body))
    other.load_drape()
    assert len(begun) == 2


def test_an_error_while_loading_is_raised_by_every_garment(hung, monkeypatch, capfd):
    def broken(*args):
        raise ImportError("numba is damaged")

    monkeypatch.setattr(compiled_code, "_drape_two_squares", broken)
    hung.load_drape()
    for _ in range(2):
        with pytest.raises(ImportError, match="numba is damaged"):
            hung.sew(draft("t-shirt"))
    assert "Traceback" not in capfd.readouterr().err
