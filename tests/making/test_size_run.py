"""Several sizes of a pattern in one file: nested lines, a layer for each size."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pypdfium2
import pytest
import shapely
from ezdxf import recover

from swifttailor.errors import InputError
from swifttailor.making import cutting_plan
from swifttailor.making.nested_drawing import draw_nested
from swifttailor.making.paper import Paper
from swifttailor.making.pattern_dxf import dxf_text, on_table
from swifttailor.making.pattern_pdf import write_sizes_pdf
from swifttailor.making.size_run import SizeRun, size_names, size_order, size_run
from swifttailor.pattern import Pattern
from swifttailor.refitting.even_lengths import with_corners

SIZES = {"36": 0.95, "38": 1.0, "40": 1.06}
LARGE = Paper.named("200x300cm")


def cut(pattern: Pattern, alike: set[frozenset[str]] | None):
    return cutting_plan(pattern, alike=alike)


def scaled(pattern: Pattern, factor: float) -> Pattern:
    panels = tuple(with_corners(p, np.asarray(p.vertices) * factor) for p in pattern.panels)
    return replace(pattern, panels=panels)


@pytest.fixture(scope="module")
def run(drafts) -> SizeRun:
    dress = drafts["shirt-dress"]
    return size_run([(size, scaled(dress, factor)) for size, factor in SIZES.items()], cut)


def test_each_piece_is_there_in_all_sizes_and_larger_in_larger_ones(run):
    assert run.sizes == tuple(SIZES) and run.base == 1
    assert [n.pieces[1].name for n in run.nested] == [p.name for p in run.plans[run.base].pieces]
    for nested in run.nested:
        assert [piece.size for piece in nested.pieces] == list(SIZES)
        areas = [shapely.Polygon(piece.cut.outline).area for piece in nested.pieces]
        assert areas == sorted(areas) and len(set(areas)) == len(areas)
        assert len({piece.instruction for piece in nested.pieces}) == 1
        together = list(zip(nested.pieces, nested.shifts, strict=True))
        middles = [np.mean([r.points[0] for r in piece.runs], axis=0) + shift for piece, shift in together]
        assert np.ptp([m[1] for m in middles]) == pytest.approx(0.0, abs=1e-9)
        if nested.pieces[0].on_fold:
            assert np.ptp([p.middle + s[0] for p, s in together]) == pytest.approx(0.0, abs=1e-9)


def test_sizes_differ_in_layer_dashes_and_colour(run):
    for nested in run.nested:
        drawn = draw_nested(nested, run)
        assert [layer.layer for layer in drawn.sizes] == list(SIZES) and drawn.common.layer == ""
        styles = [next(s.style for s in layer.strokes if s.style.name == "cut") for layer in drawn.sizes]
        assert len({style.color for style in styles}) == len({style.dash for style in styles}) == len(SIZES)
        assert not any(stroke.style.name == "cut" for stroke in drawn.common.strokes)
        for layer, size in zip(drawn.sizes, SIZES, strict=True):
            assert [t.text for t in layer.texts].count(size) == 2
            cut_line = np.concatenate([s.points for s in layer.strokes if s.style.name == "cut"])
            assert shapely.covers(drawn.shape.buffer(1e-6), shapely.MultiPoint(cut_line))


def test_the_pdf_has_a_layer_for_each_size(run, tmp_path):
    printed = write_sizes_pdf(run, tmp_path / "run.pdf", paper=LARGE)
    raw = printed.path.read_bytes()
    assert raw.startswith(b"%PDF-1.5")
    assert raw.count(b"/Type /OCG") == raw.count(b"/OC ") == len(SIZES)
    assert all(f"(Size {size})".encode() in raw for size in SIZES)
    document = pypdfium2.PdfDocument(printed.path)
    assert len(document) == printed.pages
    text = document[0].get_textpage().get_text_bounded()
    assert "Sizes" in text and all(size in text for size in SIZES)
    again = write_sizes_pdf(run, tmp_path / "again.pdf", paper=LARGE)
    assert again.path.read_bytes() == raw


def test_a_size_can_be_hidden(run, tmp_path):
    one = write_sizes_pdf(run, tmp_path / "run.pdf", paper=LARGE)
    raw = one.path.read_bytes()
    # Readers hide what the catalog lists as off; as many bytes, so that the table of objects holds.
    start = raw.index(b"/ON [")
    end = raw.index(b"]", start)
    first = raw[start + len(b"/ON [") : end].split(b"R")[0].strip() + b" R"
    rest = b" " * (end - start - len(b"/OFF [") - len(first))
    (tmp_path / "hidden.pdf").write_bytes(raw[:start] + b"/OFF [" + first + rest + raw[end:])

    def drawn(path):
        return np.asarray(pypdfium2.PdfDocument(path)[2].render(scale=0.5).to_pil().convert("L"), float)

    everything, less = drawn(one.path), drawn(tmp_path / "hidden.pdf")
    assert (less >= everything - 1).all() and (less > everything + 30).sum() > 500


@pytest.mark.parametrize("dialect", ["astm", "aama"])
def test_the_dxf_has_a_block_for_each_size_nested_on_a_layer_of_its_own(run, dialect):
    document, auditor = recover.read(io.BytesIO(dxf_text(run, dialect=dialect).encode()))
    assert not auditor.errors
    inserts = list(document.modelspace().query("INSERT"))
    assert len(inserts) == len(SIZES) * len(run.nested)
    assert {i.dxf.layer for i in inserts} == {f"SIZE_{size}" for size in SIZES}
    for k, nested in enumerate(run.nested):
        group = inserts[k * len(SIZES) : (k + 1) * len(SIZES)]
        first = np.array(group[0].dxf.insert.vec2)
        for piece, shift, insert in zip(nested.pieces, nested.shifts, group, strict=True):
            entities = document.blocks[insert.dxf.name].query("POLYLINE[layer=='1']")
            points = np.array([v.dxf.location.vec2 for v in entities[0].vertices])
            points += np.array(insert.dxf.insert.vec2)
            # Beside the first size each lies as they are nested.
            wanted = on_table(piece.cut.outline + shift - nested.shifts[0]) + first
            assert np.abs(points.min(axis=0) - wanted.min(axis=0)).max() < 0.03
            assert np.abs(points.max(axis=0) - wanted.max(axis=0)).max() < 0.03


def test_what_is_cut_alike_in_some_sizes_only_is_cut_apart_in_all(drafts):
    dress = drafts["shirt-dress"]
    panels = list(dress.panels)
    group = max(cutting_plan(dress).pieces, key=lambda p: p.count)
    odd = (*group.panels, *group.mirrored)[-1]
    k = dress.panel_index(odd)
    panels[k] = with_corners(panels[k], np.asarray(panels[k].vertices) * 1.05)
    run = size_run([("A", dress), ("B", replace(dress, panels=tuple(panels)))], cut)
    pieces = {frozenset((*n.pieces[0].panels, *n.pieces[0].mirrored)) for n in run.nested}
    assert group.count > 1 and frozenset({odd}) in pieces
    assert set().union(*pieces) == {p.name for p in dress.panels}


def test_refused_runs(drafts, skirt):
    dress = drafts["shirt-dress"]
    with pytest.raises(InputError, match="1 sizes were given; 2 to 12"):
        size_run([("36", dress)], cut)
    with pytest.raises(InputError, match="same name"):
        size_run([("36", dress), ("36", dress)], cut)
    with pytest.raises(InputError, match="not sizes of one pattern"):
        size_run([("36", dress), ("38", skirt)], cut)


def test_names_and_order_of_sizes():
    assert size_names(["women EU 36", "women EU 38"]) == ["36", "38"]
    assert size_names(["women S", "women M"]) == ["S", "M"]
    assert size_names(["women EU 36", "men EU 36"]) == ["women", "men"]
    titles = ["women XL", "women S", "women XXS", "women M"]
    assert [t.split()[-1] for t in sorted(titles, key=size_order)] == ["XXS", "S", "M", "XL"]
    assert sorted(["UK 10", "UK 8", "UK 12"], key=size_order) == ["UK 8", "UK 10", "UK 12"]
