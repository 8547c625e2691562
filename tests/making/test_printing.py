"""Printed patterns, measured in their pixels."""

from __future__ import annotations

import numpy as np
import pypdfium2
import pytest
import shapely

from benchmarks.printed_pattern import outline_errors, render, test_square_cm
from swifttailor.errors import InputError
from swifttailor.making import cutting_plan
from swifttailor.making.close_packing import pack_closely
from swifttailor.making.finished_measures import finished_measures, in_inches
from swifttailor.making.paper import MARGIN_CM, PAPERS, Paper, Tile
from swifttailor.making.pattern_pdf import write_pdf
from swifttailor.making.piece_drawing import drawn_shape
from swifttailor.making.sheet_layout import lay_out_sheet

test_square_cm.__test__ = False


@pytest.mark.parametrize("paper", ["a4", "letter"])
def test_true_to_scale(shipped_plans, tmp_path, paper):
    plan = shipped_plans["gc_1000067"]
    printed = write_pdf(plan, tmp_path / "p.pdf", paper=Paper.named(paper))
    (cover,) = render(printed.path, 600)
    width, height = test_square_cm(cover, 600)
    assert width == pytest.approx(10.0, abs=0.01) and height == pytest.approx(5.0, abs=0.01)
    errors = outline_errors(plan, printed, 200)
    assert len(errors) > 40 and np.abs(errors).max() < 0.2


def test_pages_fit_together(shipped_plans, tmp_path):
    """All tiles that show something are there, once, in rows from the top, and no blank ones."""
    plan = shipped_plans["gc_1000272"]
    printed = write_pdf(plan, tmp_path / "p.pdf", paper=Paper.named("a4"))
    sheet = printed.sheet
    document = pypdfium2.PdfDocument(printed.path)
    assert len(document) == printed.pages
    cover = printed.pages - len(sheet.tiles) - printed.steps_pages
    assert cover >= 1 and printed.steps_pages >= 1
    shown = [document[cover + k].get_textpage().get_text_bounded() for k in range(len(sheet.tiles))]
    for tile, text in zip(sheet.tiles, shown, strict=True):
        assert tile.name in text.split()
        for other in ((-1, 0), (1, 0), (0, -1), (0, 1)):
            beside = Tile(tile.column + other[0], tile.row + other[1])
            assert (f"to {beside.name}" in text.replace("\r\n", "\n").split("\n")) == (beside in sheet.tiles)
    width, height = printed.paper.tile
    shapes = [
        shapely.transform(drawn_shape(p), lambda x, t=t, s=s: x @ t.T + s)
        for p, t, s in zip(plan.pieces, sheet.turns, sheet.shifts, strict=True)
    ]
    for row in range(sheet.rows):
        for column in range(sheet.columns):
            box = shapely.box(
                column * width,
                (sheet.rows - 1 - row) * height,
                (column + 1) * width,
                (sheet.rows - row) * height,
            )
            shows = max(s.intersection(box).area for s in shapes)
            assert (Tile(column, row) in sheet.tiles) == (shows > 0), (column, row, shows)
    for k, first in enumerate(shapes):
        for second in shapes[:k]:
            assert first.distance(second) > 0.1
    for page in range(cover, cover + len(sheet.tiles)):
        assert document[page].get_size() == pytest.approx((595.28, 841.89), abs=0.01)


def test_lines_go_on_from_page_to_page(shipped_plans, tmp_path):
    """The cut line leaves one page where it enters the next."""
    printed = write_pdf(shipped_plans["gc_1000067"], tmp_path / "p.pdf", paper=Paper.named("a4"))
    dpi = 150
    scale = dpi / 2.54
    pages = dict(
        zip(
            printed.sheet.tiles,
            render(printed.path, dpi, first=2, last=1 + len(printed.sheet.tiles)),
            strict=True,
        )
    )
    low, high = int(MARGIN_CM * scale), int((printed.paper.height - MARGIN_CM) * scale)
    seen = 0
    for tile, page in pages.items():
        below = pages.get(Tile(tile.column, tile.row + 1))
        if below is not None:
            strip = slice(low + 8, -low - 8)
            rows = [page[high - 25, strip], page[high - 5, strip], below[low + 5, strip]]
            at = [np.flatnonzero(row > 0.8) for row in rows]
            if all(len(k) and np.ptp(k) < 8 for k in at):  # one line alone crosses the border here
                before, leaves, enters = (float(k.mean()) for k in at)
                assert enters == pytest.approx(leaves + 0.5 * (leaves - before), abs=1.5)
                seen += 1
    assert seen


def test_the_cover_says_what_is_needed(shipped_plans, tmp_path):
    plan = shipped_plans["gc_1000272"]
    printed = write_pdf(
        plan, tmp_path / "p.pdf", paper=Paper.named("a4"), cloth=["1.25 m of cloth 140 cm wide"]
    )
    document = pypdfium2.PdfDocument(printed.path)
    cover = document[0].get_textpage().get_text_bounded()
    for expected in (
        "Page map",
        "Made for the default body: bust 99.8, waist 84.3, hips 103.5, height 172 cm",
        "Test square",
        "1.25 m of cloth",
        "Bodice front: cut 2, mirrored",
        "seams 1 cm",
    ):
        assert expected in " ".join(cover.split()), expected
    steps = " ".join(document[printed.pages - 1].get_textpage().get_text_bounded().split())
    assert "Hems." in steps or printed.steps_pages > 1
    fonts = printed.path.read_bytes()
    assert (b"/Helvetica" in fonts and b"CreationDate (D:2000" in fonts) or b"CreationDate" not in fonts


def test_the_finished_garment_s_measures_stand_on_the_cover_or_together_behind_it(
    shipped_plans, skirt, tmp_path
):
    for plan in (cutting_plan(skirt), shipped_plans["gc_1000272"]):
        printed = write_pdf(plan, tmp_path / "p.pdf", paper=Paper.named("a4"), overwrite=True)
        first = printed.pages - printed.steps_pages - len(printed.sheet.tiles)
        document = pypdfium2.PdfDocument(printed.path)
        pages = [" ".join(document[k].get_textpage().get_text_bounded().split()) for k in range(first)]
        (page,) = [page for page in pages if "Finished garment" in page]
        for name, cm in finished_measures(plan.sewn.pattern).items():
            assert name in page and f"{cm:.1f}" in page and in_inches(cm) in page


def test_the_same_bytes_every_time(skirt, tmp_path):
    files = [
        write_pdf(cutting_plan(skirt), tmp_path / f"{k}.pdf", paper=Paper.named("a4")).path.read_bytes()
        for k in range(2)
    ]
    assert files[0] == files[1]


def test_large_paper_has_a_test_square_of_its_own(skirt, tmp_path):
    printed = write_pdf(cutting_plan(skirt), tmp_path / "p.pdf", paper=Paper.named("a0"))
    assert len(printed.sheet.tiles) == 1
    text = pypdfium2.PdfDocument(printed.path)[1].get_textpage().get_text_bounded()
    assert "Test square" in text and "A1" in text.split()
    assert pypdfium2.PdfDocument(printed.path)[0].get_size()[0] == pytest.approx(595.28, abs=0.01)


@pytest.mark.parametrize("name", ["a9", "", "0x0cm", "3x3cm", "100000x20cm", "nanxnan", "9e9x9cm"])
def test_impossible_papers_are_refused(name):
    with pytest.raises(InputError, match="paper"):
        Paper.named(name)


def test_papers():
    assert {name: Paper.named(name.upper()).name for name in PAPERS} == {name: name for name in PAPERS}
    assert (Paper.named("24x36in").width, Paper.named("900x2000 mm").height) == (24 * 2.54, 200.0)
    assert [Tile(k, 2).name for k in (0, 25, 26, 51, 52, 701, 702)] == [
        "A3",
        "Z3",
        "AA3",
        "AZ3",
        "BA3",
        "ZZ3",
        "AAA3",
    ]


def test_nobody_tapes_thousands_of_pages():
    with pytest.raises(InputError, match="pages"):
        lay_out_sheet([shapely.box(0, 0, 3000, 3000)], Paper.named("a4"))


def test_packed_shapes_do_not_touch():
    rng = np.random.default_rng(3)
    shapes = []
    for _ in range(14):
        angle = np.sort(rng.uniform(0, 2 * np.pi, 7))
        reach = rng.uniform(4, 20, 7)
        shapes.append(
            shapely.Polygon(np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=1)).buffer(0.5)
        )
    packed = pack_closely(shapes, 76.0, 500.0)
    assert packed is not None
    moved = [
        shapely.transform(s, lambda x, t=t, d=d: x @ t.T + d)
        for s, (t, d) in zip(shapes, packed, strict=True)
    ]
    for k, first in enumerate(moved):
        assert first.bounds[0] >= 0 and first.bounds[1] >= 0 and first.bounds[2] <= 76.0
        assert all(first.distance(second) > 0.2 for second in moved[:k])
    assert max(m.bounds[3] for m in moved) < 0.75 * sum(s.bounds[3] - s.bounds[1] for s in shapes) / 2
    assert pack_closely([shapely.box(0, 0, 80, 90)], 76.0, 500.0) is None
