"""What was sewn badly is draped from its pattern, and said to be."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.draping import drape
from swifttailor.draping.finish_or_drape import finish_or_drape
from swifttailor.garment.garment import Garment
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch
from swifttailor.pattern.drafts import draft
from swifttailor.tailor.reporting import finishing_notes

COARSE = 4.0


@pytest.fixture(scope="module")
def skirt():
    return drape(draft("fitted-skirt"), edge_length=COARSE)


def test_what_hangs_well_stays_where_it_was_sewn(skirt):
    sewn = Garment(skirt.mesh, skirt.vertices, {"seconds": {"network": 0.1}, "source": "garment sewer"})
    rested = finish_or_drape(sewn, edge_length=COARSE)
    assert rested.mesh is sewn.mesh
    assert rested.report["finishing"] == {"from": "garment", "reasons": []}
    assert rested.report["quality"]["accepted"] and rested.report["source"] == "garment sewer"
    assert set(rested.report["seconds"]) == {"network", "finishing"}
    assert np.linalg.norm(rested.vertices - skirt.vertices, axis=1).mean() < 1.0
    assert finishing_notes(rested) == []


def test_what_lies_around_the_feet_is_draped_from_its_pattern(skirt):
    fallen = Garment(skirt.mesh, skirt.vertices - [0.0, 60.0, 0.0], {"seconds": {}})
    stages = []
    rested = finish_or_drape(fallen, edge_length=COARSE, progress=lambda stage, share: stages.append(stage))
    about = rested.report["finishing"]
    assert about["from"] == "pattern" and about["reasons"][0].startswith("not where it is worn")
    assert rested.report["quality"]["accepted"]
    assert "sewing" in stages
    # The drape of the pattern, on the very mesh, so that images of the layout fit it.
    assert np.array_equal(rested.faces, skirt.faces)
    assert np.array_equal(rested.vertices, skirt.vertices)
    (note,) = finishing_notes(rested)
    assert "not where it is worn" in note


def test_what_no_drape_mends_keeps_the_first_and_its_reasons():
    """A tube of 240 cm around the chest: nothing holds it."""
    corners = [[-60.0, 0.0], [60.0, 0.0], [60.0, 50.0], [-60.0, 50.0]]
    front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 80.0, 25.0)))
    back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 80.0, -25.0)))
    sides = tuple(Stitch(EdgeRef("front", k), EdgeRef("back", k)) for k in (1, 3))
    dropped = drape(Pattern((front, back), sides, "tube"), edge_length=8.0)
    rested = finish_or_drape(dropped, edge_length=8.0)
    assert rested.report["finishing"]["from"] == "garment"
    assert rested.report["finishing"]["reasons"] == rested.report["quality"]["reasons"] != []
    assert not rested.report["quality"]["accepted"]
