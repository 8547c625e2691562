import numpy as np
import pytest
from ggi_patterns import any_garment
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.ggi import encode
from swifttailor.ggi.panel_colors import types_of_colors
from swifttailor.ggi.pictures import geometry_picture, stitching_picture, write_pictures
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def images():
    return encode(any_garment(draft("fitted-dress"), 4.0), 160)


def read(path):
    with Image.open(path) as picture:
        assert picture.mode == "RGB"
        return np.asarray(picture)[::-1]


def test_the_semantic_picture_is_the_image_upside_down(images, tmp_path):
    write_pictures(images, tmp_path)
    assert np.array_equal(types_of_colors(read(tmp_path / "semantic.png")), images.semantic)


def test_a_pattern_has_two_pictures_and_a_garment_three(images, tmp_path):
    names = [p.name for p in write_pictures(images, tmp_path / "garment")]
    assert names == ["semantic.png", "stitching.png", "geometry.png"]
    write_pictures(encode(images.layout.pattern, 64), tmp_path / "pattern")
    assert {p.name for p in (tmp_path / "pattern").iterdir()} == {"semantic.png", "stitching.png"}


def test_seams_have_equal_colours_where_their_sides_meet(images):
    picture = stitching_picture(images.stitching, images.occupancy)
    flat, ids = picture.reshape(-1, 3).astype(int), images.stitching.ids.ravel()
    for k in range(images.stitching.stitch_count):
        (first, at_first), (second, at_second) = images.stitching.side(k, 0), images.stitching.side(k, 1)
        own_first, own_second = ids[first] == k + 1, ids[second] == k + 1
        first, at_first, second, at_second = (
            first[own_first], at_first[own_first], second[own_second], at_second[own_second]
        )  # fmt: skip
        if len(first) < 3 or len(second) < 3:
            continue
        nearest = np.abs(at_first[:, None] - at_second).argmin(axis=1)
        near = np.abs(at_first - at_second[nearest]) < 0.02
        assert np.abs(flat[first[near]] - flat[second[nearest[near]]]).max(initial=0) <= 6
        assert flat[first].sum(axis=1)[0] < flat[first].sum(axis=1)[-1]  # darker where it begins
    assert (picture[~images.occupancy] == 0).all()
    unsewn = images.occupancy & (images.stitching.ids == 0)
    assert (picture[unsewn] == 40).all()


def test_positions_are_colours_between_their_extremes(images):
    picture = geometry_picture(images.geometry, images.occupancy)
    shown, values = picture[images.occupancy], images.geometry[images.occupancy]
    assert shown.min(axis=0).tolist() == [40] * 3 and shown.max(axis=0).tolist() == [255] * 3
    for axis in range(3):
        assert (np.diff(shown[np.argsort(values[:, axis]), axis].astype(int)) >= 0).all()
    assert not picture[~images.occupancy].any()


def test_a_flat_garment_has_a_picture_too(images):
    picture = geometry_picture(np.zeros_like(images.geometry), images.occupancy)
    assert (picture[images.occupancy] == 40).all()
    with pytest.raises(InputError, match="not finite"):
        geometry_picture(np.full_like(images.geometry, np.inf), images.occupancy)


def test_equal_images_give_equal_pictures(images, tmp_path):
    one, two = write_pictures(images, tmp_path / "a"), write_pictures(images, tmp_path / "b")
    assert [p.read_bytes() for p in one] == [p.read_bytes() for p in two]
