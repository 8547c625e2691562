"""Patterns refitted to bodies, and everything after that on the same body."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.errors import InputError
from swifttailor.pattern import read_specification, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.studio.bench.fitting import named_body
from swifttailor.studio.bench.tasks import TASKS
from swifttailor.studio.mesh_record import unpack_mesh
from swifttailor.studio.shipped import shipped_options
from swifttailor.studio.worker.link import Link

LINK = Link(lambda message: None, lambda: False)


@pytest.fixture(scope="module")
def shirt() -> dict:
    return to_specification(draft("t-shirt"))


@pytest.fixture(scope="module")
def fitted(shirt):
    return TASKS["fit"](LINK, pattern=shirt, size="women EU 46", figure=None, measures={"height": 175.0})


def width(pattern: dict) -> float:
    """Of all panels together, cm."""
    return sum(
        float(np.ptp(np.array(panel["vertices"])[:, 0])) for panel in pattern["pattern"]["panels"].values()
    )


def test_the_pattern_names_its_body_and_is_wider(shirt, fitted):
    named = fitted.answer["pattern"]["properties"]["drafted_for"]
    assert named["name"] == "women EU 46, height 175"
    assert named["measures"]["height"] == 175.0
    assert width(fitted.answer["pattern"]) > 1.03 * width(shirt)
    assert fitted.answer["origin"] == "fit"
    assert fitted.answer["garment"] == "sewn"


def test_the_body_comes_along_and_has_the_measures(fitted):
    names = {mesh.name: mesh for mesh in fitted.meshes}
    assert set(names) == {fitted.answer["mesh"], fitted.answer["body"]}
    header, blocks = unpack_mesh(names[fitted.answer["body"]].data)
    assert header["kind"] == "body"
    heights = blocks["positions"].reshape(-1, 3)[:, 1]
    assert np.ptp(heights) == pytest.approx(175.0, abs=1.0)
    known = TASKS["wearer"](LINK, pattern=fitted.answer["pattern"]).answer
    assert known["body"] == fitted.answer["body"]
    assert known["measures"]["height"] == pytest.approx(175.0, abs=1.4)
    assert known["given"]["height"] == 175.0


def test_the_garment_is_sewn_around_that_body(fitted):
    from swifttailor.studio.bench.wearers import wearing

    pattern = read_specification(fitted.answer["pattern"]).pattern
    probe = wearing(pattern.drafted_for).probe
    _, blocks = unpack_mesh(fitted.meshes[0].data)
    positions = blocks["positions"].reshape(-1, 3).astype(float)
    assert float((np.asarray(probe.signed_distance(positions)) < -1.0).mean()) < 0.02
    assert positions[:, 1].max() > 175 * 0.78


@pytest.mark.parametrize("task", ["alter", "live", "repair", "sew"])
def test_what_follows_stays_on_that_body(fitted, task):
    pattern = fitted.answer["pattern"]
    more = {
        "alter": {"changes": [{"dimension": "length", "value": None, "by": 5.0}]},
        "live": {"edge_length": 4.0, "dragging": True},
        "repair": {},
        "sew": {"edge_length": 4.0, "repair": False, "color": None},
    }[task]
    answer = TASKS[task](LINK, pattern=pattern, **more).answer
    document = answer["documents"][0] if "documents" in answer else answer
    if task == "live":
        assert answer["status"] == "sewn"
    else:
        named = document["pattern"]["properties"]["drafted_for"]
        assert named["name"] == "women EU 46, height 175"
    if task in ("alter", "sew"):
        assert document["body"] == fitted.answer["body"]


def test_back_to_the_default_body(fitted):
    back = TASKS["fit"](LINK, pattern=fitted.answer["pattern"], size=None, figure=None, measures={}).answer
    assert "drafted_for" not in back["pattern"]["properties"]
    assert back["body"] == shipped_options()["body"]
    assert width(back["pattern"]) < 0.97 * width(fitted.answer["pattern"])


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"size": "99", "figure": None, "measures": {}}, "There is no size '99'"),
        ({"size": None, "figure": None, "measures": {"tail": 40.0}}, "There is no measure 'tail'"),
        ({"size": None, "figure": None, "measures": {"waist": 400.0}}, "38 to 190 cm is accepted"),
        ({"size": None, "figure": None, "measures": {"waist": 180.0, "bust": 50.0}}, "The nearest that one"),
    ],
)
def test_bodies_that_there_are_not_are_refused_with_what_there_is(shirt, asked, said):
    with pytest.raises(InputError, match=said):
        TASKS["fit"](LINK, pattern=shirt, **asked)


def test_a_pattern_that_names_an_impossible_body_is_refused(shirt):
    named = {"name": "nobody", "figure": None, "measures": {"waist": 4000.0}}
    pattern = shirt | {"properties": shirt["properties"] | {"drafted_for": named}}
    for task, more in (("live", {"edge_length": 4.0}), ("check", {}), ("wearer", {})):
        with pytest.raises(InputError, match="waist"):
            TASKS[task](LINK, pattern=pattern, **more)


def test_nothing_asked_for_is_the_default_body():
    assert named_body(None, None, {}) is None
    assert named_body(None, "men", {}).figure == "men"
    assert named_body("M", None, {"waist": 80.0}, "Ana").name == "Ana"


@pytest.mark.parametrize(
    ("file_name", "text"),
    [
        ("ana.yaml", "body:\n  bust: 95.0\n  waist: 70\n  shoulder_incl: 20\n"),
        ("ana.json", '{"bust": 95, "waist": 70}'),
    ],
)
def test_files_of_measures_are_read(file_name, text):
    found = TASKS["measures"](LINK, file_name=file_name, text=text).answer["measures"]
    assert found == {"bust": 95.0, "waist": 70.0}


@pytest.mark.parametrize(
    ("file_name", "text"),
    [
        ("../../etc/passwd", "x"),
        ("a.yaml", "!!python/object/apply:os.system ['true']"),
        ("a.yaml", "- [" * 5000),
        ("a.json", "[]"),
        ("a.json", '{"waist": NaN}'),
    ],
)
def test_other_files_are_refused_without_the_server_s_paths(file_name, text):
    with pytest.raises(InputError) as refused:
        TASKS["measures"](LINK, file_name=file_name, text=text)
    assert "/tmp" not in str(refused.value)


def test_the_default_body_is_among_what_can_be_chosen():
    options = shipped_options()["wearers"]
    heights = [one for one in options["measures"] if one["name"] == "height"]
    assert heights[0]["default"] == pytest.approx(float(np.ptp(Body.default().vertices[:, 1])), abs=0.1)
    assert {"figure": "women", "region": "EU"}.items() <= options["sizes"][0].items()
