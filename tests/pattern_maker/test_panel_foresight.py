"""Panels foreseen from words: what the whole network foresees, opened from half of its file."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_maker.asking.plan import PatternPlan
from swifttailor.pattern_maker.asking.prompt import make_prompt
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.network.model_file import SHIPPED
from swifttailor.pattern_maker.panel_foresight import PanelForesight

TINY = Path(__file__).with_name("tiny_maker.zip")
TEXTS = ("a long dress", "trousers with wide legs, a high waist and a narrow waistband", "Rock")


@pytest.fixture(scope="module")
def foresight() -> PanelForesight:
    found = PanelForesight.load(TINY)
    assert found is not None
    return found


@pytest.mark.parametrize("text", TEXTS)
def test_odds_are_those_of_the_plan(foresight, text):
    model = PatternMaker.load(TINY).model
    prompt = make_prompt(model.text.encode(text, model.longest_text).tokens, model.text.size)
    embedded = model.runtime.embed(prompt.tokens[None], prompt.numbers[None])
    (foreseen,) = model.runtime.foresee(embedded, np.ones((1, len(prompt)), np.float32))
    odds = foresight.odds([text])
    assert odds.shape == (len(PANEL_NAMES),)
    np.testing.assert_allclose(odds, PatternPlan.from_foresight(foreseen).odds, atol=1e-4)


def test_several_texts_count_equally_however_long_they_are(foresight):
    alone = [foresight.odds([text]) for text in TEXTS]
    np.testing.assert_allclose(foresight.odds(TEXTS), np.mean(alone, axis=0), atol=1e-4)
    assert np.abs(alone[0] - alone[1]).max() > 1e-3


def test_one_that_is_open_already_foresees_the_same(foresight):
    other = PanelForesight.of(PatternMaker.load(TINY))
    assert other is not None
    np.testing.assert_array_equal(other.odds(TEXTS), foresight.odds(TEXTS))


def test_no_text_is_refused(foresight):
    with pytest.raises(InputError, match="give one at least"):
        foresight.odds([])


def test_only_what_is_needed_is_read(tmp_path, foresight):
    """What is damaged elsewhere in the file is found by who needs it."""
    damaged = tmp_path / "maker.zip"
    with zipfile.ZipFile(TINY) as old, zipfile.ZipFile(damaged, "w") as new:
        for name in old.namelist():
            new.writestr(name, b"nothing" if name == "vision.onnx" else old.read(name))
    found = PanelForesight.load(damaged)
    assert found is not None
    np.testing.assert_array_equal(found.odds(TEXTS), foresight.odds(TEXTS))
    with pytest.raises(InputError, match=r"vision.onnx is not what"):
        PatternMaker.load(damaged)


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no PatternMaker")
def test_the_shipped_network_knows_what_garments_are_made_of():
    foresight = PanelForesight.load()
    assert foresight is not None

    def likely(text: str) -> set[str]:
        return {PANEL_NAMES[k] for k in np.flatnonzero(foresight.odds([text]) > 0)}

    shirt = likely("a T-shirt with short sleeves and a round neckline")
    assert {"left_ftorso", "right_ftorso", "left_sleeve_f", "right_sleeve_b"} <= shirt
    assert not any("skirt" in name or "pant" in name for name in shirt)
    skirt = likely("a straight knee length skirt with a waistband")
    assert skirt and not any("torso" in name or "sleeve" in name for name in skirt)
    assert any("pant" in name for name in likely("wide trousers to the ankle with a waistband"))
