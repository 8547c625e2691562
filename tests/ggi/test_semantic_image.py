import re
from pathlib import Path

import numpy as np
import pytest
from ggi_patterns import rectangle
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.errors import InputError
from swifttailor.ggi import lay_out
from swifttailor.ggi.panel_colors import PANEL_COLORS, color_types, types_of_colors
from swifttailor.ggi.semantic import PANEL_TYPES, panel_type, semantic_image
from swifttailor.pattern import PANEL_NAMES, Pattern
from swifttailor.pattern.drafts import draft


def test_garmentcodes_names_have_a_type_each_in_their_order():
    assert [panel_type(name) for name in PANEL_NAMES] == list(range(1, 76))
    assert [PANEL_TYPES[panel_type(name)] for name in PANEL_NAMES] == list(PANEL_NAMES)
    assert len(PANEL_TYPES) == 79


@pytest.mark.parametrize(
    ("name", "label", "type_name"),
    [
        ("left_ftorso", "arm", "left_ftorso"),  # a known name wins over any label
        ("Left_FTorso", "", "left_ftorso"),
        ("skirt_panel_15", "leg", "skirt_panel_14"),
        ("skirt_panel_9999999999999999999", "", "skirt_panel_14"),
        ("INS_skirt_front_40", "", "ins_skirt_front_5"),
        ("skirt_front_5", "", "skirt_front_4"),
        ("pocket", "", "other_body"),
        ("pocket", "leg", "other_leg"),
        ("long_sleeve_upper", "", "other_arm"),
        ("trouser_leg", "", "other_leg"),
        ("pocket_3", "body", "other_body"),
        ("", "", "other_body"),
        ("ärmel\n_1", "", "other_body"),
    ],
)
def test_other_names_go_by_rule(name, label, type_name):
    assert PANEL_TYPES[panel_type(name, label)] == type_name


@given(st.text(), st.text())
def test_no_name_is_without_a_type(name, label):
    assert 1 <= panel_type(name, label) < len(PANEL_TYPES)


def test_the_image_holds_each_panels_type_where_the_panel_is():
    layout = lay_out(draft("shirt-dress"))
    image = semantic_image(layout)
    assert image.shape == (256, 256) and image.dtype == np.uint8
    for k, panel in enumerate(layout.pattern.panels):
        assert set(image[layout.raster.panel == k]) == {panel_type(panel.name, panel.label)}
    assert set(image[~layout.raster.occupancy]) == {0}


def test_panels_of_one_type_have_one_id():
    pattern = Pattern((rectangle("patch", 5.0, 5.0), rectangle("pocket", 5.0, 6.0)))
    assert set(np.unique(semantic_image(lay_out(pattern, 32)))) == {0, PANEL_TYPES.index("other_body")}


def lab(colors):
    share = colors / 255.0
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = linear @ to_xyz.T / [0.9505, 1.0, 1.089]
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)


def test_colours_can_be_told_apart():
    assert PANEL_COLORS.shape == (len(PANEL_TYPES), 3) and PANEL_COLORS[0].tolist() == [0, 0, 0]
    places = lab(PANEL_COLORS.astype(float))
    apart = np.linalg.norm(places[:, None] - places, axis=2) + 1e3 * np.eye(len(places))
    assert apart.min() > 19


@given(st.lists(st.integers(0, len(PANEL_TYPES) - 1), max_size=50))
def test_colours_and_types_are_inverse(types):
    types = np.array(types, np.uint8)
    assert np.array_equal(types_of_colors(color_types(types)), types)


def test_a_colour_that_is_none_is_refused():
    image = np.zeros((4, 4, 3), np.uint8)
    image[1, 2] = 1, 2, 3
    with pytest.raises(InputError, match="#010203 belongs to no panel type"):
        types_of_colors(image)


def test_the_documented_colours_are_the_colours():
    page = (Path(__file__).parents[2] / "docs" / "ggi.md").read_text()
    listed = re.findall(r"\| (\d+) \| `(\w+)` \| `#([0-9a-f]{6})`", page)
    expected = [
        (str(k), name, bytes(PANEL_COLORS[k].tolist()).hex()) for k, name in enumerate(PANEL_TYPES) if k > 0
    ]
    assert listed == expected
