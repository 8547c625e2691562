"""Garments for the body that a text or the caller names."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.body import Body, body_for
from swifttailor.body.wearer import Wearer
from swifttailor.errors import InputError
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.wearing import body_wanted


@pytest.fixture(scope="module")
def tailor():
    return Tailor.load()


def test_a_size_in_the_text_is_worn_and_heard_no_more(tailor):
    made = tailor.generate("a knee-length dress in size 46", edge_length=4.0)
    assert made.body is not None and made.body.name == "women EU 46"
    assert made.pattern.drafted_for == made.body.made_for
    assert made.report["fitted_to"]["measures"]["bust"] == pytest.approx(104, abs=0.5)
    assert any(note.startswith("Refitted to women EU 46") for note in made.notes)
    assert not any("size" in text for text in made.report["heard"]["cannot"])
    plain = tailor.generate("a knee-length dress", edge_length=4.0)
    assert plain.body is None and "fitted_to" not in plain.report
    assert np.ptp(made.garment.vertices[:, 0]) != np.ptp(plain.garment.vertices[:, 0])


def test_who_wears_it_is_said_by_the_order_then_the_text_then_the_pattern_then_the_tailor():
    own, usual = body_for("men 50"), body_for("children 128")
    assert body_wanted(Order("a dress in size 46", body=own), usual) is own
    assert body_wanted(Order("a dress in size 46"), usual).name == "women EU 46"
    assert body_wanted(Order("a dress"), usual) is usual
    assert body_wanted(Order("a dress"), None) is None
    assert body_wanted(Order("a dress in size 46", alter=False), None) is None
    fitted = replace(draft("fitted-skirt"), drafted_for=own.made_for)
    assert body_wanted(Order("make it longer", edit=fitted), None).made_for == own.made_for


def fitted_to(*who, **more):
    return replace(draft("fitted-skirt"), drafted_for=body_for(*who, **more).made_for)


@pytest.mark.parametrize(
    "words", ["make it longer, for a woman of 160 cm", "for someone 160 cm tall, longer"]
)
def test_a_height_in_an_instruction_leaves_the_size_as_it_was(words):
    worn = body_wanted(Order(words, edit=fitted_to("46")), None)
    assert worn.made_for.measures == (("bust", 104.0), ("waist", 88.0), ("hips", 112.0), ("height", 160.0))
    assert worn.made_for.figure == "women"
    assert worn.name == "women EU 46, height 160"
    for name, value in worn.made_for.measures:
        assert getattr(worn.measurements, name) == pytest.approx(value, abs=0.5)


def test_what_is_said_last_of_the_wearer_holds():
    first = fitted_to("46", {"height": 160, "arm_length": 58})
    again = body_wanted(Order("for a woman of 165 cm", edit=first), None).made_for
    assert dict(again.measures) == dict(first.drafted_for.measures) | {"height": 165.0}
    assert again.name == "women EU 46, arm_length 58, height 165"
    other = body_wanted(Order("in size 40", edit=first), None).made_for
    assert other == body_for("40").made_for
    man = body_wanted(Order("for a man of 180 cm", edit=first), None).made_for
    assert man.figure == "men" and dict(man.measures) == {"height": 180.0}


def test_measures_that_nobody_has_with_those_that_were_kept_say_which_these_are():
    before = body_for("46").made_for
    with pytest.raises(
        InputError, match=r"No body has.*'women EU 46'.*hips=112, height=168\. Give other.*begins anew"
    ):
        Wearer(measures={"waist": 150.0}, before=before).body()


def test_of_a_mesh_the_girths_are_kept_when_the_height_is_another(tmp_path):
    body = Body.default()
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in body.vertices]
    lines += [f"f {a} {b} {c}" for a, b, c in body.faces + 1]
    (tmp_path / "me.obj").write_text("\n".join(lines))
    before = Wearer(file=tmp_path / "me.obj").body().made_for
    worn = Wearer(measures={"height": 160.0}, before=before).body()
    assert worn.measurements.height == pytest.approx(160, abs=0.5)
    assert worn.measurements.waist == pytest.approx(body.measurements.waist, abs=1.0)
    assert "arm_length" not in dict(worn.made_for.measures)


def test_patterns_for_a_body_are_sewn_on_it_as_they_are(tailor):
    body = body_for("women 46")
    fitting = Tailor(body=body, fit=True)
    once = fitting.sew(draft("fitted-skirt"), edge_length=4.0)
    again = fitting.sew(once.pattern, edge_length=4.0)
    assert "fitted_to" in once.report and "fitted_to" not in again.report
    for a, b in zip(once.pattern.panels, again.pattern.panels, strict=True):
        assert np.array_equal(a.vertices, b.vertices)
    plain = Tailor(body=body).sew(draft("fitted-skirt"), edge_length=4.0)
    assert plain.pattern == draft("fitted-skirt").canonical()


def test_a_workshop_for_another_body_shares_the_networks(tailor):
    model = tailor.garment_sewer.model
    other = tailor.worn_by(body_for("children 128"))
    assert other.garment_sewer.model is model
    assert other.worn_by(None).garment_sewer.body.measurements == Body.default().measurements
    assert tailor.body is None
