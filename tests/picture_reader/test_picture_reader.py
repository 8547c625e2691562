"""Reading pictures with a network, here one that has learnt nothing."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.parameter_reader import ParameterReader
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.body_joints import PLACES, BodyJoints
from swifttailor.picture_reader.close_looks import DESIGN_SHARE
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.figures import FIGURES
from swifttailor.picture_reader.labels import labels_checksum, measure_labels, statement_labels
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS, kinds_of_panels
from swifttailor.picture_reader.reader import DESIGNS, SHIPPED, PictureReader
from swifttailor.picture_reader.said import LEAST_CERTAINTY

UNSEEN = BodyJoints(np.zeros((PLACES, 2)), np.zeros(PLACES))
PARAMETERS = ParameterReader.load().parameters
TINY = {"image_size": 64, "embedding": 8, "stages": [8, 8, 16, 16], "depths": [1, 1, 1, 1], "width": 24}


def test_every_panel_of_garmentcode_is_of_a_kind():
    kinds = dict(zip(PANEL_NAMES, (PANEL_KINDS[k] for k in kinds_of_panels()), strict=True))
    assert set(kinds.values()) == set(PANEL_KINDS)
    some = {
        "left_ftorso": "front bodice",
        "sl_right_cuff_skirt_b": "cuff flounce",
        "sl_left_cuff_f": "cuff",
        "skirt_front": "skirt",
        "skirt_back_3": "tier",
        "skirt_panel_14": "gore",
        "ins_skirt_back_5": "inset",
        "pant_l_cuff_f": "leg cuff",
        "pant_b_r": "leg",
    }
    assert {name: kinds[name] for name in some} == some


def test_squares_are_cut_and_the_border_goes_on():
    picture = np.arange(4 * 6 * 3, dtype=np.uint8).reshape(4, 6, 3)
    inside = cut_square(picture, (1, 0, 4), 4)
    np.testing.assert_array_equal(inside, picture[:, 1:5])
    around = cut_square(picture, (0, -1, 6), 6)
    np.testing.assert_array_equal(around[0], picture[0])
    np.testing.assert_array_equal(around[1:5], picture)
    np.testing.assert_array_equal(around[5], picture[3])


@given(
    st.tuples(*[st.integers(1, 20)] * 2),
    st.tuples(*[st.integers(-40, 40)] * 2),
    st.integers(1, 30),
    st.data(),
)
def test_squares_are_as_if_the_border_went_on_for_ever(shape, corner, side, data):
    picture = np.random.default_rng(data.draw(st.integers(0, 9))).integers(0, 256, (*shape, 3), np.uint8)
    (left, top), (height, width) = corner, shape
    rows, columns = np.arange(top, top + side), np.arange(left, left + side)
    expected = picture[rows.clip(0, height - 1)[:, None], columns.clip(0, width - 1)]
    np.testing.assert_array_equal(cut_square(picture, (left, top, side), side), expected)


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    pytest.importorskip("torch")
    import torch

    from swifttailor.picture_reader.export_torch import build_network, compare, export

    torch.manual_seed(0)
    network = build_network(TINY | {"heads": 2, "mask_width": 8})
    path = export(network, {"model": "PictureReader"}, tmp_path_factory.mktemp("reader") / "reader.onnx")
    assert compare(PictureReader.load(path), network) < 1e-4
    return path


@pytest.mark.needs_torch
def test_what_is_read_is_sorted_and_within_bounds(file):
    reader = PictureReader.load(file)
    assert (reader.size, reader.card) == (64, {"model": "PictureReader"})
    picture = np.random.default_rng(1).integers(0, 256, (90, 50, 3), np.uint8)
    found = reader.read(picture)
    assert json.loads(json.dumps(found.to_json()))["side"] in ("front", "back", "side")
    left, top, right, bottom = found.box
    assert right - left == bottom - top > 0
    for part in found.parts:
        certainties = [s.certainty for s in part.statements]
        assert certainties == sorted(certainties, reverse=True)
        assert all(LEAST_CERTAINTY <= c <= 1 for c in certainties)
        assert part.mask.shape == (90, 50) and 0 <= part.mask.min() <= part.mask.max() <= 1
        assert all(m.off > 0 for m in part.measures)
    again = PictureReader.load(file).read(picture)
    assert again.to_json() == found.to_json()


@pytest.mark.needs_torch
@pytest.mark.parametrize("shape", [(1, 1, 3), (1, 400, 3), (400, 1, 3), (64, 64, 3)])
@pytest.mark.parametrize("level", [0, 255])
def test_odd_pictures_are_read_as_well(file, shape, level):
    found = PictureReader.load(file).read(np.full(shape, level, np.uint8))
    assert all(np.isfinite(part.mask).all() for part in found.parts)


@pytest.mark.needs_torch
@pytest.mark.parametrize(
    "bad", [np.zeros((4, 4), np.uint8), np.zeros((4, 4, 3)), np.zeros((0, 4, 3), np.uint8)]
)
def test_what_is_no_picture_is_refused(file, bad):
    with pytest.raises(InputError, match=r"\(h, w, 3\)"):
        PictureReader.load(file).read(bad)


@pytest.mark.needs_torch
def test_files_for_other_labels_are_refused(file, tmp_path):
    from swifttailor.networks.model_file import write_graph
    from swifttailor.picture_reader.reader import KIND

    graph = file.read_bytes()
    scales = [[1.0, 0.0]] * len(statement_labels())
    for name, said in {
        "labels": {"labels_sha256": "0", "scales": scales},
        "scales": {"labels_sha256": labels_checksum(), "scales": scales[1:]},
        "nothing": {},
    }.items():
        path = write_graph(tmp_path / f"{name}.onnx", KIND, _bare(graph), {}, **said)
        with pytest.raises(InputError, match="does not say what it reads"):
            PictureReader.load(path)


def _bare(graph: bytes) -> bytes:
    """The graph without what it says of itself."""
    import onnx

    model = onnx.load_model_from_string(graph)
    del model.metadata_props[:]
    return model.SerializeToString()


@pytest.mark.needs_torch
def test_weights_fit_pictures_of_any_size():
    import torch

    from swifttailor.picture_reader.export_torch import build_network
    from swifttailor.picture_reader.network_torch import Reading

    torch.manual_seed(0)
    size = TINY | {"heads": 2, "mask_width": 8}
    small, large = build_network(size).eval(), build_network(size | {"image_size": 192}).eval()
    large.load_state_dict(small.state_dict())
    picture, guess = torch.rand(1, 3, 192, 192), torch.tensor([[0.0, 1.0, 0.0, -0.7, 0.1, 0.0, 1.0]])
    with torch.no_grad():
        first, again = small(picture, guess), large(picture, guess)
        assert all(torch.equal(a, b) for a, b in zip(first, again, strict=True))
        reduced = small(torch.nn.functional.avg_pool2d(picture, 3), guess)
    shapes = [Reading(*said).masks.shape for said in (reduced, first)]
    assert shapes == [(1, 2, 16, 16), (1, 2, 48, 48)]


@pytest.mark.needs_torch
def test_pixels_are_told_where_on_the_wearer_they_are():
    import torch

    from swifttailor.picture_reader.network_torch import places_of
    from swifttailor.picture_reader.view import view_of
    from swifttailor.render import Camera

    size = 96
    camera = Camera((5.0, 90.0, 0.0), 190.0, 0.0, 0.0, 0.0)
    view = torch.from_numpy(view_of(camera, size))
    guess = torch.cat([view, torch.ones(1)])[None]
    found = places_of(torch.zeros(1, 3, size, size), guess)[0]
    for x, y in ((0.0, 100.0), (20.0, 150.0), (-30.0, 40.0)):
        column, row = (int(v) for v in camera.project(np.array([[x, y, 0.0]]), (size, size))[0, :2])
        aside, level = float(found[1, row, column]) * 100, float(found[0, row, column]) * 100
        np.testing.assert_allclose([aside, level], [x, y - 100.0], atol=2.1)
    assert (found[2] == 1).all()
    assert not places_of(torch.zeros(1, 3, size, size), torch.zeros(1, 7)).any()


class Looking:
    """A network that sees a garment in the middle, or one above another, and remembers what it was told."""

    def __init__(self, *, two: bool = False) -> None:
        self.guesses: list[np.ndarray] = []
        self.two = two
        self.figures = "one"

    def run(self, names, feeds):
        self.guesses.append(feeds["guess"][0])
        statements, measures, panels = len(statement_labels()), len(measure_labels()), len(PANEL_NAMES)
        mask = np.full((1, 2, 16, 16), -9.0, np.float32)
        mask[:, 0, 6:10, 6:10] = 9.0
        if self.two:
            mask[:] = -9.0
            mask[:, 0, 2:6, 5:9] = mask[:, 1, 9:15, 6:8] = 9.0
        look = np.float32(len(self.guesses))
        found = {
            "present": np.array([[9.0, 9.0 if self.two else -9.0]]),
            "statements": np.full((1, 2, statements), look),
            "has": np.full((1, 2, measures), -9.0),
            "measures": np.zeros((1, 2, measures, 2)),
            "panels": np.full((1, 2, panels), -9.0),
            "boxes": np.zeros((1, 2, panels, 5)),
            "camera_view": np.array([[0.0, 1.0, 0.0, -0.7, 0.02, -0.01]]),
            "figures": np.array([[9.0 * (name == self.figures) for name in FIGURES]]),
            "masks": mask,
            "worn_places": np.zeros((1, 3, 16, 16)),
            "panel_kinds": np.zeros((1, len(PANEL_KINDS), 16, 16)),
            "seams": np.zeros((1, 1, 16, 16)),
        }
        return [found[name].astype(np.float32) for name in names]


def test_it_looks_at_the_whole_and_then_told_the_camera_thrice_at_the_garment():
    looking = Looking()
    reader = PictureReader(looking, 64, np.tile([1.0, 0.0], (len(statement_labels()), 1)), {})
    found = reader.read(np.zeros((640, 640, 3), np.uint8))
    assert len(looking.guesses) == 4 and not looking.guesses[0].any()
    left, _, right, _ = found.box
    assert right - left == round(160 * 1.7)  # the garment is 160 pixels wide and high
    for guess, scale in zip(looking.guesses[1:], (1.0, 0.87, 1.15), strict=True):
        assert guess[6] == 1 and abs(guess[3] - (-0.7 + np.log(640 / (272 * scale)))) < 0.01
        assert abs(guess[4] - 0.02 * 640 / (272 * scale)) < 0.01
    assert found.figures == "one", "only the whole picture shows who else is there"
    (part,) = found.parts
    assert abs(part.statements[0].certainty - 1 / (1 + np.exp(-3.0))) < 1e-6  # the mean of 2, 3 and 4


class Wearing(Looking):
    """A network that sees a vest where people wear one, and is always as sure of everything."""

    def __init__(self, certain: float) -> None:
        super().__init__()
        self.certain = certain

    def run(self, names, feeds):
        found = dict(zip(names, super().run(names, feeds), strict=True))
        height = 145 - (np.arange(16) - 5.5) * 12.0
        found["worn_places"][0, 1] = height[:, None] / 100
        found["panel_kinds"][0, PANEL_KINDS.index("front bodice")] = 5.0
        found["statements"][:] = self.certain
        return [found[name] for name in names]


def test_details_are_looked_at_by_the_network_for_them():
    count = len(statement_labels())
    as_said, doubled = np.tile([1.0, 0.0], (count, 1)), np.tile([2.0, 0.0], (count, 1))
    whole, close = Wearing(1.0), Wearing(3.0)
    near = PictureReader(close, 64, doubled, {}, close_ups=("neck", "waist"))
    reader = PictureReader(whole, 64, as_said, {}, close_ups=(), near=(near,))
    found = reader.read(np.zeros((1280, 1280, 3), np.uint8))
    assert len(whole.guesses) == 4 and len(close.guesses) == 2
    assert all(guess[6] == 1 for guess in close.guesses), "told where the camera is"
    certain = {f"{s.claim.name} {s.claim.value}": s.certainty for s in found.parts[0].statements}
    told = {1 / (1 + np.exp(-logit)) for logit in (1.0, 0.4 * 1.0 + 0.6 * 6.0)}
    assert all(min(abs(value - one) for one in told) < 1e-6 for value in certain.values())
    assert abs(certain["neckline v"] - max(told)) < 1e-6 and abs(certain["skirt_hem knee"] - min(told)) < 1e-6


def test_each_network_looks_at_its_own_details():
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    networks = Wearing(1.0), Wearing(3.0), Wearing(-3.0)
    neck, waist = (
        PictureReader(n, 64, said, {}, (name,))
        for n, name in zip(networks[1:], ("neck", "waist"), strict=True)
    )
    reader = PictureReader(networks[0], 64, said, {}, near=(neck, waist))
    (part,) = reader.read(np.zeros((1280, 1280, 3), np.uint8)).parts
    assert [len(n.guesses) for n in networks] == [4, 1, 1]
    certain = {f"{s.claim.name} {s.claim.value}": s.certainty for s in part.statements}
    for claim, logit in (("neckline v", 3.0), ("waistband none", -3.0)):
        assert abs(certain[claim] - 1 / (1 + np.exp(-(0.4 + 0.6 * logit)))) < 1e-6


def test_of_several_that_know_a_detail_the_last_looks_at_it():
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    networks = Wearing(1.0), Wearing(3.0), Wearing(-3.0)
    both = PictureReader(networks[1], 64, said, {}, ("neck", "waist"))
    neck = PictureReader(networks[2], 64, said, {}, ("neck",))
    reader = PictureReader(networks[0], 64, said, {}, near=(both, neck))
    (part,) = reader.read(np.zeros((1280, 1280, 3), np.uint8)).parts
    assert [len(n.guesses) for n in networks] == [4, 1, 1]
    certain = {f"{s.claim.name} {s.claim.value}": s.certainty for s in part.statements}
    for claim, logit in (("neckline v", -3.0), ("waistband none", 3.0)):
        assert abs(certain[claim] - 1 / (1 + np.exp(-(0.4 + 0.6 * logit)))) < 1e-6


class Designing(Wearing):
    """One that is as sure of the last value of each design parameter."""

    def run(self, names, feeds):
        others = [name for name in names if name != DESIGNS]
        found = dict(zip(others, super().run(others, feeds), strict=True))
        most = max(len(one.values) for one in PARAMETERS)
        designs = np.zeros((1, 2, len(PARAMETERS), most), np.float32)
        for k, one in enumerate(PARAMETERS):
            designs[0, :, k, len(one.values) - 1] = self.certain
        return [(found | {DESIGNS: designs})[name] for name in names]


@pytest.mark.parametrize("near_designs", [True, False])
def test_who_looks_from_near_tells_the_design_parameters_that_he_sees(near_designs):
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    networks = Designing(1.0), Designing(3.0)
    waist = PictureReader(
        networks[1], 64, said, {}, ("waist",), parameters=PARAMETERS, near_designs=near_designs
    )
    reader = PictureReader(networks[0], 64, said, {}, near=(waist,), parameters=PARAMETERS)
    (part,) = reader.read(np.zeros((1280, 1280, 3), np.uint8)).parts
    assert len(networks[1].guesses) == 1
    for one, shares in zip(PARAMETERS, part.design.shares, strict=True):
        told = near_designs and one.name in ("meta.wb", "waistband.waist", "waistband.width")
        logit = (1 - DESIGN_SHARE) * 1.0 + DESIGN_SHARE * 3.0 if told else 1.0
        expected = np.exp(logit) / (np.exp(logit) + len(one.values) - 1)
        assert abs(shares[-1] - expected) < 1e-6, one.name


@pytest.mark.skipif(not SHIPPED.is_file(), reason="the package has no weights")
def test_the_network_of_the_package_looks_at_details_itself():
    reader = PictureReader.load()
    assert not reader.near and {name.split()[-1] for name in reader.close_ups} == {"neck", "waist", "sleeve"}
    assert [{name.split()[-1] for name in one.close_ups} for one in reader.plain().near] == [
        {"neck"},
        {"waist", "sleeve", "skirt", "armhole"},
    ]
    assert all(one.near_designs for one in reader.plain().near)
    assert all(one.parameters == reader.parameters for one in (*reader.plain().near, reader.plain()))


@pytest.mark.parametrize("border", ["one colour", "a little noise", "a hand", "a place"])
@pytest.mark.parametrize("known", [True, False])
def test_plain_pictures_are_read_by_the_network_that_knows_them_as_well(border, known):
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    others, own = Wearing(1.0), Wearing(3.0)
    own.figures = "one" if known else "none"
    opened = []

    def plain():
        opened.append(True)
        return PictureReader(own, 64, said, {})

    picture = np.full((640, 640, 3), 250, np.uint8)
    chance = np.random.default_rng(0)
    picture[100:500, 200:400] = chance.integers(0, 256, (400, 200, 3))
    if border == "a little noise":
        picture = picture + chance.integers(0, 5, picture.shape, np.uint8)
    if border == "a hand":
        picture[300:340, :20] = 0
    if border == "a place":
        picture[:, :200] = 90
    read = PictureReader(others, 64, said, {}, plain=plain).read(picture)
    (part,) = read.parts
    asked = border != "a place"
    assert bool(opened) == asked and bool(own.guesses) == asked
    is_plain = asked and known
    assert read.is_plain == is_plain
    said_of = {(s.claim.name, s.claim.value): s.certainty for s in part.statements}
    assert abs(said_of["skirt_hem", "knee"] - 1 / (1 + np.exp(-(2.0 if is_plain else 1.0)))) < 1e-6
    # Of a picture that is none, hoods are believed less.
    assert (said_of["hood", "hood"] < 0.5) == (not is_plain)
    assert len(others.guesses) == 4, "the first look is theirs, and three of the garment"
    assert len(own.guesses) == (4 if is_plain else int(asked)), "whether it is plain, and as many"


@pytest.mark.parametrize("somebody", [None, 0.5, 0.9])
def test_what_somebody_wears_is_not_laid(somebody):
    from swifttailor.picture_reader.person_finder import Person

    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    picture = np.random.default_rng(0).integers(0, 256, (640, 640, 3), np.uint8)

    class Finder:
        def find(self, pixels, small):
            return (
                None
                if somebody is None
                else Person(somebody, np.ones(pixels.shape[:2], np.float32), (0.0, 0.0), 1.0, UNSEEN)
            )

    laid = PictureReader(Wearing(3.0), 64, said, {})
    reader = PictureReader(Wearing(1.0), 64, said, {}, laid=lambda: laid, people=Finder)
    assert reader.read(picture).is_laid == (somebody != 0.9)


@pytest.mark.parametrize("known", [True, False])
def test_what_nobody_wears_is_read_by_the_network_for_it(known):
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    others, own = Wearing(1.0), Wearing(3.0)
    own.figures = "one" if known else "none"
    picture = np.random.default_rng(0).integers(0, 256, (640, 640, 3), np.uint8)
    read = PictureReader(others, 64, said, {}, laid=lambda: PictureReader(own, 64, said, {})).read(picture)
    assert read.is_laid == known and read.to_json()["worn"] == (not known)
    (part,) = read.parts
    certain = next(s.certainty for s in part.statements if s.claim.value == "knee")
    assert abs(certain - 1 / (1 + np.exp(-(3.0 if known else 1.0)))) < 1e-6
    assert len(others.guesses) == (1 if known else 4)


class Telling(Designing):
    """The same, which is so sure of designs alone."""

    def __init__(self, certain: float, sure: float) -> None:
        super().__init__(sure)
        self.says = certain

    def run(self, names, feeds):
        found = dict(zip(names, super().run(names, feeds), strict=True))
        found["statements"][:] = self.says
        return [found[name] for name in names]


@pytest.mark.parametrize("ground", ["white", "a place"])
@pytest.mark.parametrize(("sure", "figures"), [(0.0, "one"), (4.0, "one"), (0.0, "none")])
def test_photographs_are_told_by_a_network_and_read_by_it_before_a_plain_ground(ground, sure, figures):
    said = np.tile([1.0, 0.0], (len(statement_labels()), 1))
    others, own = Wearing(1.0), Telling(3.0, sure)
    own.figures = figures
    picture = np.random.default_rng(0).integers(0, 256, (640, 640, 3), np.uint8)
    if ground == "white":
        picture[:, :200] = picture[:200] = 255
    shop = PictureReader(own, 64, said, {}, parameters=PARAMETERS)
    read = PictureReader(others, 64, said, {}, shop=lambda: shop).read(picture)
    photograph = sure == 0.0 and figures == "one"
    assert read.is_photograph == photograph == read.to_json()["photograph"]
    by_shop = photograph and ground == "white"
    (part,) = read.parts
    certain = next(s.certainty for s in part.statements if s.claim.value == "knee")
    assert abs(certain - 1 / (1 + np.exp(-(3.0 if by_shop else 1.0)))) < 1e-6
    assert len(own.guesses) == 3 and not any(guess.any() for guess in own.guesses)
    assert len(others.guesses) == (1 if by_shop else 4)


def test_each_of_two_garments_is_looked_at_nearer():
    looking = Looking(two=True)
    reader = PictureReader(looking, 64, np.tile([1.0, 0.0], (len(statement_labels()), 1)), {})
    found = reader.read(np.zeros((640, 640, 3), np.uint8))
    assert len(looking.guesses) == 1 + 3 + 3
    boxes = {part.part: part.cells.box for part in found.parts}
    assert set(boxes) == {"upper", "lower"}
    for part, height, middle in (("upper", 160, (280, 160)), ("lower", 240, (280, 480))):
        left, top, right, bottom = boxes[part]
        assert right - left == bottom - top == round(height * 1.7)
        assert abs((left + right) / 2 - middle[0]) <= 1 and abs((top + bottom) / 2 - middle[1]) <= 1
