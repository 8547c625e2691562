"""Which panel a picture shows where."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from swifttailor.data.pictures.panel_cells import SEAM, panel_cells
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS


def garment(*names: str, faces: int) -> SimpleNamespace:
    """Of panels in the order of their names, each of as many faces."""
    panels = np.isin(PANEL_NAMES, names).astype(np.uint8)
    face_panel = np.repeat(np.arange(len(names)), faces).astype(np.int16)
    return SimpleNamespace(
        faces=np.zeros((len(face_panel), 3), int), face_panel=face_panel, truth=SimpleNamespace(panels=panels)
    )


def test_cells_name_the_kind_in_their_middle_and_where_panels_of_one_garment_meet():
    shirt = garment("left_ftorso", "wb_front", faces=2)  # faces 10 to 13: the bodice first
    skirt = garment("skirt_front", faces=1)  # face 14
    face = np.full((16, 12), -1)
    face[0:5, 0:12] = 11
    face[5:8, 0:12] = 12
    face[8:16, 0:8] = 14
    face[12:16, 8:12] = 3  # of the body
    cells = panel_cells(face, 10, [shirt, skirt])
    bodice, band, lower = (1 + PANEL_KINDS.index(kind) for kind in ("front bodice", "waistband", "skirt"))
    expected = np.zeros((4, 3), int)
    expected[0] = bodice
    expected[1] = band + SEAM  # one row of the cells is still bodice
    expected[2:, :2] = lower
    np.testing.assert_array_equal(cells, expected)


def test_panels_that_garmentcode_does_not_know_are_of_no_kind():
    own = garment("left_ftorso", "right_ftorso", faces=1)
    own.truth.panels[:] = 0
    face = np.zeros((4, 4), int)
    assert not panel_cells(face, 0, [own]).any()
    known = garment("left_hood", faces=1)
    face[:, :] = 2
    cells = panel_cells(face, 0, [own, known])
    assert cells.tolist() == [[1 + PANEL_KINDS.index("hood")]]
