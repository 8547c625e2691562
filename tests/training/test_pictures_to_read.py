"""The pictures that the picture reader learns from."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.data.pictures.bank import PictureBank
from swifttailor.data.pictures.blocks import Blocks, draw
from swifttailor.data.pictures.laid import laid_flat
from swifttailor.data.pictures.panel_cells import SEAM
from swifttailor.data.pictures.scenes import (
    HELD_OUT_BACKDROPS,
    HELD_OUT_WEAVES,
    VIEWS,
    Wardrobe,
    draw_scene,
)
from swifttailor.data.reader import SplitReader
from swifttailor.data.renders.backdrops import MAKER_NAMES
from swifttailor.errors import InputError
from swifttailor.pattern.digest import pattern_digest
from swifttailor.picture_reader.close_ups import CLOSE_UPS, WHOLE
from swifttailor.picture_reader.labels import PARTS
from swifttailor.picture_reader.view import camera_of

SIZE = 64


@pytest.fixture(scope="module")
def bank(data):
    bank = PictureBank([data / "train"])
    bank.prepare()
    return bank


def test_some_garments_are_kept_from_all_over(data):
    bank = PictureBank([data / "train"])
    bank.prepare()
    every = bank.ids
    with pytest.raises(InputError, match=f"There are {len(every)} garments to learn from"):
        bank.keep(len(every) + 1)
    bank.keep(len(every))
    assert bank.ids == every
    bank.keep(1)
    assert bank.ids == every[:1]


@pytest.fixture(scope="module")
def wardrobe(bank):
    return Wardrobe(bank)


def test_the_bank_keeps_what_is_drawn(bank, data):
    reader = SplitReader(data / "train")
    assert len(bank) == len(reader) == 6
    for k, sample in enumerate(reader):
        worn = bank[k]
        assert np.abs(worn.vertices - sample.vertices).max() <= 0.011  # kept in hundredths of a centimetre
        np.testing.assert_array_equal(worn.faces, sample.mesh.faces)
        flat = sample.mesh.flat_vertices[sample.mesh.flat_faces]
        assert np.abs(worn.cloth_at - flat).max() <= 0.006
        np.testing.assert_allclose(worn.weights.share.sum(axis=1), 1.0, atol=2e-3)
        assert PARTS[worn.truth.part] == ("upper" if sample.id.startswith("shirt") else "lower")
        assert bank.part(k) == worn.truth.part
    assert bank.digests() == {pattern_digest(sample.pattern) for sample in reader}


def test_garments_of_others_and_twins_are_left_out(data):
    bank = PictureBank([data / "train", data / "train"])
    bank.prepare()
    bank.leave_out([])
    assert len(bank) == 12, "a split that is given twice counts twice"
    digest = next(iter(bank.digests()))
    bank.leave_out([digest])
    assert len(bank) == 10 and digest not in bank.digests()
    bank._places += bank._places[:3]
    bank.leave_out([])
    assert len(bank) == 10, "equal patterns of one split are there once"


def test_an_empty_bank_is_refused():
    with pytest.raises(InputError, match="There are no garments to draw"):
        PictureBank([])


@pytest.mark.parametrize("family", ["plain", "seamless", "studio", "people", "held out", "laid"])
def test_pictures_are_fixed_by_their_lots_and_masks_lie_on_the_garment(wardrobe, family):
    for number, view in ((0, "front"), (4, "back"), (1, "free")):
        first, again = (
            draw(wardrobe, number, family, view, np.random.default_rng(7), SIZE) for _ in range(2)
        )
        for a, b in zip(first, again, strict=True):
            np.testing.assert_array_equal(a, b)
        other = draw(wardrobe, number, family, view, np.random.default_rng(8), SIZE)
        assert (first.pixels != other.pixels).any() or family in ("plain", "seamless")
        part = wardrobe.bank.part(number)
        assert first.garments[part] == number
        mask = first.masks[:, :, part]
        assert mask.max() > 100, "the garment is seen"
        assert (first.garments[1 - part] >= 0) or not first.masks[:, :, 1 - part].any()
        camera = camera_of(first.views)
        middle = camera.project(np.array([[0.0, 120.0 if part == 0 else 70.0, 0.0]]), (SIZE, SIZE))[0, :2]
        rows, columns = np.nonzero(mask > 100)
        at = first.places[rows, columns].astype(float) * 100
        seen = at[np.isfinite(at).all(axis=1)]
        worn = wardrobe.bank[number].vertices
        assert len(seen) >= 0.4 * len(rows)
        near = ((seen > worn.min(axis=0) - 25) & (seen < worn.max(axis=0) + 25)).all(axis=1)
        assert near.mean() > 0.9, "but for hair and hands before it"
        away = np.abs(np.array([columns.mean(), rows.mean()]) * 4 + 2 - middle)
        assert away.max() < 0.45 * SIZE, "the camera of the view looks at the mask"


@pytest.mark.parametrize("family", ["plain", "studio", "people"])
def test_close_ups_show_a_part_of_one_garment(wardrobe, family):
    seen = set()
    for k in range(12):
        number = k % 6
        scene = draw(wardrobe, number, family, "front", np.random.default_rng(k), SIZE, close=True)
        part = wardrobe.bank.part(number)
        assert scene.garments[part] == number and scene.garments[1 - part] == -1
        assert scene.masks[:, :, part].max() > 100
        assert camera_of(scene.views).height < (120 if CLOSE_UPS[scene.close_up].part == "skirt" else 90)
        assert scene.close_up < WHOLE
        seen.add(CLOSE_UPS[scene.close_up].name)
        rows, columns = np.nonzero(scene.masks[:, :, part] > 200)
        at = scene.places[rows, columns].astype(float) * 100
        inside = CLOSE_UPS[scene.close_up].points(at, _kinds(scene, rows, columns))
        assert inside.any() or family == "people", "the part is in the picture"
    assert {"waist"} < seen


def _kinds(scene, rows, columns):
    return scene.cells[rows, columns].astype(int) % SEAM - 1


def test_so_many_pictures_are_close_ups(bank):
    shares = {"plain": 0.5, "nothing": 0.2}
    near = [Blocks(bank, seed=3, size=32, count=30, shares=shares, close=c)[0].close_up for c in (0, 0.5, 1)]
    counts = [(found < WHOLE).sum() for found in near]
    assert counts[0] == 0 and 5 < counts[1] < 20 and 18 < counts[2] < 30, "where there is nothing, none"


def test_two_garments_are_worn_by_one_person(wardrobe):
    found = [draw_scene(wardrobe, k % 6, "front", np.random.default_rng(k), SIZE) for k in range(24)]
    both = [scene for scene in found if (scene.garments >= 0).all()]
    assert 12 <= len(both) < 24
    for scene in both:
        upper, lower = scene.garments
        assert wardrobe.bank.part(upper) == 0 and wardrobe.bank.part(lower) == 1
    rows = np.arange(SIZE // 4)[:, None]
    heights = [
        [(rows * scene.masks[:, :, part]).sum() / scene.masks[:, :, part].sum() for part in (0, 1)]
        for scene in both
        if scene.masks.sum(axis=(0, 1)).min() > 2000
    ]
    assert len(heights) > 5 and all(upper < lower for upper, lower in heights)


def test_people_who_are_cut_out_have_white_behind_them(wardrobe):
    for k in range(6):
        whole, cut = (
            draw_scene(wardrobe, k, "front", np.random.default_rng(k), SIZE, cut_out=cut_out)
            for cut_out in (1e-9, 1.0)
        )
        assert (whole.masks == cut.masks).all() and (whole.garments == cut.garments).all()
        border = np.concatenate([cut.pixels[0], cut.pixels[:, 0], cut.pixels[:, -1]])
        assert (border.min(axis=1) > 240).mean() > 0.5
        inside = cut.masks.max(axis=2).repeat(4, 0).repeat(4, 1) == 255
        kept = np.abs(cut.pixels.astype(int) - whole.pixels).max(axis=2)[inside] < 40
        assert not inside.any() or kept.mean() > 0.6


def test_looks_that_are_held_out_are_never_learnt_from(wardrobe, monkeypatch):
    from swifttailor.data.pictures import scenes as picture_scenes

    drawn = []
    cloth, scenery = picture_scenes._random_cloth, picture_scenes._background

    def remember(*arguments):
        made = cloth(*arguments)
        drawn.append(made.cloth.weave)
        return made

    monkeypatch.setattr(picture_scenes, "_random_cloth", remember)
    for k in range(30):
        draw_scene(wardrobe, k % 6, VIEWS[k % 3], np.random.default_rng(k), 32)
    assert not any(w is not None and w.kind in HELD_OUT_WEAVES for w in drawn)
    drawn.clear()
    for k in range(10):
        draw_scene(wardrobe, 0, "front", np.random.default_rng(k), 32, held_out=True)
    assert any(w is not None and w.kind in HELD_OUT_WEAVES for w in drawn)
    assert set(MAKER_NAMES) > HELD_OUT_BACKDROPS
    assert scenery(np.random.default_rng(0), 16, True).shape == (16, 16, 3)


def test_what_nobody_wears_lies_flat_with_its_sleeves_aside(bank):
    worn = bank[0]
    before = np.ptp(worn.vertices, axis=0)
    for hangs in (False, True):
        flat = laid_flat(worn, np.random.default_rng(4), hangs=hangs)
        after = np.ptp(flat, axis=0)
        assert after[2] < 0.35 * before[2], "all depth but a little is pressed out"
        trunk = np.abs(worn.vertices[:, 0]) < 20
        assert np.ptp(flat[trunk, 0]) > 1.02 * np.ptp(worn.vertices[trunk, 0]), "half a girth is wider"
        # Left stays left, high stays high.
        for axis in (0, 1):
            assert np.corrcoef(flat[trunk, axis], worn.vertices[trunk, axis])[0, 1] > 0.97
    sleeve = max(range(len(bank)), key=lambda k: np.ptp(bank[k].vertices[:, 0]))
    assert np.abs(bank[sleeve].vertices[:, 0]).max() > 35, "an arm is beside the trunk"
    widths = {
        hangs: np.mean(
            [np.ptp(laid_flat(bank[sleeve], np.random.default_rng(n), hangs=hangs)[:, 0]) for n in range(6)]
        )
        for hangs in (False, True)
    }
    assert widths[True] < widths[False], "sleeves hang down"


def test_blocks_are_fixed_by_their_number_and_show_every_garment(bank):
    blocks = Blocks(bank, seed=3, size=32, count=6, shares={"plain": 0.2, "studio": 0.3})
    first, second, again = blocks[0], blocks[1], blocks[0]
    for name in ("pixels", "masks", "places", "views", "garments", "figures"):
        np.testing.assert_array_equal(getattr(first, name), getattr(again, name))
    assert (first.pixels != second.pixels).any()
    for block in (first, second):
        assert set(range(6)) <= set(block.garments.ravel())
    assert first.pixels.shape == (6, 32, 32, 3) and first.masks.shape == (6, 8, 8, 2)


def test_pictures_that_nothing_can_be_read_from_say_so(bank):
    nothing = Blocks(bank, seed=3, size=32, count=6, shares={"nothing": 1.0})[0]
    group = Blocks(bank, seed=3, size=32, count=6, shares={"several": 1.0})[0]
    people = Blocks(bank, seed=3, size=32, count=6, shares={})[0]
    assert (nothing.figures == 0).all() and (people.figures == 1).all() and (group.figures == 2).all()
    assert (nothing.garments == -1).all() and (group.garments == -1).all()
    assert not nothing.masks.any() and people.masks.any()
    worn = Blocks(bank, seed=3, size=32, count=6, shares={"worn": 1.0})[0]
    assert (worn.figures == 0).all() and (worn.garments == -1).all(), "not for a reader of laid garments"
    assert len(np.unique(group.pixels)) > 50
