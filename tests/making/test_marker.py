"""Pieces nested on cloth: all of them, none over another, the grain along the cloth."""

from __future__ import annotations

import io
from collections import Counter
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pypdfium2
import pytest
import shapely
from PIL import Image

from swifttailor.errors import InputError
from swifttailor.making.marker_files import draw_marker, write_marker
from swifttailor.making.nesting import GAP_CM, estimate_length, nest, overlap, pack_boxes, pack_grid


@pytest.fixture(scope="module")
def plan(shipped_plans):
    return shipped_plans["gc_1000272"]


@pytest.fixture(scope="module")
def marker(plan):
    return nest(plan.pieces, 140.0, seconds=2)


@pytest.mark.parametrize("way", ["nested", "nested one way", "boxes", "grid"])
def test_markers_can_be_cut(plan, marker, way):
    made = {
        "nested": lambda: marker,
        "nested one way": lambda: nest(plan.pieces, 150.0, seconds=1, one_way=True),
        "boxes": lambda: pack_boxes(plan.pieces, 150.0),
        "grid": lambda: pack_grid(plan.pieces, 150.0),
    }[way]()
    cut = Counter((i.piece.name, i.mirrored) for i in made.laid)
    for piece in plan.pieces:
        assert cut[piece.name, False] == len(piece.panels) and cut[piece.name, True] == len(piece.mirrored)
    shapes = [shapely.Polygon(i.outline) for i in made.laid]
    for k, shape in enumerate(shapes):
        low_x, low_y, high_x, high_y = shape.bounds
        assert low_x > -1e-6 and low_y > -1e-6 and high_x < made.length + 1e-6 and high_y < made.width + 1e-6
        assert all(shape.distance(other) > GAP_CM / 2 for other in shapes[:k])
    for item in made.laid:
        along = np.diff(item.place(item.piece.grain), axis=0)[0]
        assert abs(along[1]) < 1e-6 and (along[0] > 0 or way in ("nested", "grid"))
        # Mirrored pieces are turned over, never anything else: areas keep their size and change their sign.
        own, laid = (signed_area(points) for points in (item.piece.cut.outline, item.outline))
        assert laid == pytest.approx(-own if item.mirrored else own, rel=1e-9)
    assert overlap(made) < 0.01
    used = sum(s.area for s in shapes)
    assert made.waste == pytest.approx(1 - used / (made.width * made.length))


def signed_area(points) -> float:
    x, y = (points - points.mean(axis=0)).T
    return float(x @ np.roll(y, -1) - np.roll(x, -1) @ y) / 2


def test_a_search_that_ends_with_pieces_over_each_other_is_not_taken(plan, monkeypatch):
    import spyrrow

    class Heap:
        """Puts all pieces on one place."""

        def __init__(self, name, height, items):
            self.items = items

        def solve(self, config):
            solution = type("Solution", (), {})()
            solution.placed_items = [
                type("Placed", (), {"id": i.id, "rotation": 0.0, "translation": (0.0, 60.0)})
                for i in self.items
            ]
            return solution

    monkeypatch.setattr(spyrrow, "StripPackingInstance", Heap)
    made = nest(plan.pieces, 140.0, seconds=1)
    assert overlap(made) < 0.01 and len(made.laid) == sum(p.count for p in plan.pieces)


def test_nesting_needs_less_cloth_than_boxes(plan, marker):
    assert marker.length < 0.95 * pack_boxes(plan.pieces, 140.0).length


def test_the_estimate_is_enough_and_near(plan, marker):
    length = estimate_length(plan.pieces, 140.0)
    assert marker.length <= length <= 1.3 * marker.length and length % 5 == 0
    assert length == estimate_length(plan.pieces, 140.0)


def test_narrow_cloth_and_absurd_widths_are_refused(plan):
    with pytest.raises(InputError, match="wider than the cloth"):
        nest(plan.pieces, 40.0, seconds=1)
    for width in (0.0, -5.0, 1e9, float("nan")):
        with pytest.raises(InputError, match="Usual are"):
            nest(plan.pieces, width, seconds=1)


def test_files_of_a_marker(marker, tmp_path):
    svg = write_marker(marker, tmp_path / "m.svg", title="a <b> & c")
    root = ElementTree.parse(svg).getroot()
    assert root.get("width").endswith("mm")
    cuts = [e for e in root if e.get("class") == "cut"]
    assert len(cuts) == len(marker.laid)
    points = np.array([p.split(",") for p in cuts[0].get("points").split()], float)
    np.testing.assert_allclose(np.ptp(points, axis=0) / 10, np.ptp(marker.laid[0].outline, axis=0), atol=0.01)
    with Image.open(write_marker(marker, tmp_path / "m.png", title="x")) as picture:
        assert max(picture.size) == 2400 and np.asarray(picture.convert("L")).min() < 50
    page = pypdfium2.PdfDocument(write_marker(marker, tmp_path / "m.pdf", title="x"))[0]
    expected = (np.array([marker.length, marker.width]) + 8) / 2.54 * 72
    np.testing.assert_allclose(page.get_size(), expected, atol=0.01)
    content = write_marker(marker, tmp_path / "m.dxf", title="x").read_text()
    space = ezdxf.read(io.StringIO(content)).modelspace()
    assert len(space.query('POLYLINE[layer=="1"]')) == len(marker.laid)
    assert any("waste" in t.dxf.text for t in space.query("TEXT"))
    assert "left over" in draw_marker(marker, "x").texts[0].text
    with pytest.raises(InputError, match="ending"):
        write_marker(marker, tmp_path / "m.gif", title="x")
