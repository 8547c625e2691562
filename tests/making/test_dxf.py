"""DXF of cutting rooms, read back by ezdxf and by a reader made from the description of the format."""

from __future__ import annotations

import io

import ezdxf
import numpy as np
import pytest
import shapely

from benchmarks.sewing_files import distance_mm, dxf_error
from benchmarks.small_dxf import read_dxf
from swifttailor.making import Allowances, cutting_plan
from swifttailor.making.dxf_text import block_names
from swifttailor.making.pattern_dxf import dxf_text, on_table

STYLE = {
    "Style Name", "Creation Date", "Creation Time", "Author", "Sample Size", "Grade Rule Table", "Units",
    "Curve Tolerance", "ASTM/D13Proposal 1 Version",
}  # fmt: skip
PIECE = {"Piece Name", "Quantity", "Material", "Size"}
LAYERS = {1, 2, 3, 4, 7, 8, 13, 14, 15, 84, 85, 87}


def test_all_pieces_are_read_back_by_both_readers(plans):
    for name in list(plans)[::12]:
        assert dxf_error(plans[name]) < 0.05, name


def test_layers_and_texts_are_those_of_the_standard(shipped_plans):
    plan = shipped_plans["gc_1000272"]
    text = dxf_text(plan)
    blocks, free = read_dxf(text)
    style = free.texts(1)
    assert set(style) == STYLE and style["Units"] == "METRIC"
    assert style["ASTM/D13Proposal 1 Version"] == "D6673-10"
    assert [e.kind for e in free.entities].count("INSERT") == len(plan.pieces)
    assert text.startswith("0\r\nSECTION\r\n2\r\nHEADER") and "AC1009" in text
    assert "*MODEL" not in text.upper() and "*PAPER" not in text.upper()
    groups = text.split("\r\n")[::2]
    assert "250" not in groups
    for piece, block in zip(plan.pieces, blocks.values(), strict=True):
        assert PIECE <= set(block.texts(1))
        assert {e.layer for e in block.entities} <= LAYERS
        assert len(block.name) <= 31 and block.name.isascii() and " " not in block.name
        quantity = block.texts(1)["Quantity"]
        if not piece.symmetric:
            assert quantity == f"{len(piece.panels)},{len(piece.mirrored)}"
        # Each line stands there once more for validation.
        for line, again in ((1, 84), (14, 87)):
            np.testing.assert_array_equal(block.outline(line), block.outline(again))
        assert len(block.on(8, "POLYLINE")) == len(block.on(85, "POLYLINE")) == 2 * len(piece.darts)
        # Every key point of the cut line once, as a turn or as a point of a curve.
        keys = [e.at for e in (*block.on(2, "POINT"), *block.on(3, "POINT"))]
        assert sorted(keys) == sorted(map(tuple, block.outline(1).tolist()))


def test_notches_lie_on_the_cut_line_and_point_inward(shipped_plans):
    plan = shipped_plans["gc_1000272"]
    blocks, _ = read_dxf(dxf_text(plan))
    for block in blocks.values():
        cloth = shapely.Polygon(block.outline(1))
        for notch in block.on(4, "POINT"):
            assert cloth.exterior.distance(shapely.Point(notch.at)) < 0.05
            angle, depth = np.radians(float(notch.groups[50])), float(notch.groups[30])
            tip = np.array(notch.at) + depth * np.array([np.cos(angle), np.sin(angle)])
            assert depth == 5.0 and cloth.buffer(0.1).contains(shapely.Point(tip))


def test_grain_lies_along_x_and_units_are_millimetres(skirt):
    plan = cutting_plan(skirt, Allowances(1, 3, 1, 1))
    (block,) = read_dxf(dxf_text(plan))[0].values()
    (grain,) = block.on(7, "LINE")
    assert grain.groups[20] == grain.groups[21] and float(grain.groups[11]) - float(grain.groups[10]) > 200
    np.testing.assert_allclose(np.ptp(block.outline(1), axis=0), [490, 520], atol=0.02)
    assert distance_mm(block.outline(14), on_table(plan.pieces[0].sew_line)) < 0.02


def test_aama_has_its_own_header_and_no_validation_lines(shipped_plans):
    text = dxf_text(shipped_plans["gc_1000272"], dialect="aama")
    blocks, free = read_dxf(text)
    assert text.startswith("999\r\nANSI/AAMA\r\n") and "ANSI/AAMA VERSION" in free.texts(1)
    assert not any("D6673" in e.text for e in free.entities if e.kind == "TEXT")
    assert not {e.layer for b in blocks.values() for e in b.entities} & {84, 85, 87}
    assert ezdxf.read(io.StringIO(text.replace("\r\n", "\n"))).dxfversion == "AC1009"


@pytest.mark.parametrize("name", ["Größe, 中文 \r\n0\r\nEOF", "", "x" * 300])
def test_no_name_breaks_the_file(skirt, name):
    from dataclasses import replace

    plan = cutting_plan(replace(skirt, name=name))
    blocks, free = read_dxf(dxf_text(plan))
    assert len(blocks) == 1 and "Style Name" in free.texts(1)


def test_block_names_are_told_apart():
    assert block_names(["Sleeve, front", "sleeve front", "Ärmel", "中"]) == [
        "SLEEVE_FRONT",
        "SLEEVE_FRONT_2",
        "ARMEL",
        "PIECE",
    ]
