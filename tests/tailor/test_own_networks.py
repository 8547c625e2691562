"""Somebody else's networks, body and cloth at work in a tailor: what `tailor.protocols` says is enough."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import swifttailor
from swifttailor.body import Body
from swifttailor.draping.placement import place_vertices
from swifttailor.errors import PatternError
from swifttailor.garment.garment import Garment
from swifttailor.ggi.decode import decode
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.tailor import Order, Tailor, Tailored


class DraftBook:
    """A dozen lines of somebody else's: writes the draft that the text names."""

    def __init__(self) -> None:
        self.card = {"model": "DraftBook", "parameters": 0, "shelf": 3}

    def generate_all(self, requests, *, seed, temperature, draw):
        names = ("trousers", "t-shirt", "fitted-dress", "fitted-skirt")
        found = [next((n for n in names if n.split("-")[-1] in r.text), "t-shirt") for r in requests]
        return [swifttailor.WrittenPattern(r.edit or draft(n)) for r, n in zip(requests, found, strict=True)]


class FlatLay:
    """A dozen lines more: leaves every panel where the pattern places it, and closes the seams."""

    def prepare(self, pattern, *, edge_length, resolution):
        if len(pattern.panels) > 12:
            raise PatternError("It does not fit on the table.")
        return mesh_pattern(pattern.canonical(), edge_length)

    def predict(self, meshes):
        return [place_vertices(mesh) for mesh in meshes]

    def decode(self, mesh, placed):
        return Garment(mesh, placed, {"source": "flat lay"})


@pytest.fixture(scope="module")
def tailor() -> Tailor:
    return Tailor(DraftBook(), FlatLay())


def test_other_networks_write_and_sew(tailor, tmp_path):
    made = tailor.generate("trousers", source="writer")
    names = {p.name for p in draft("trousers").panels}
    assert {p.name for p in made.pattern.panels} == names
    report = made.report
    assert report["source"] == "flat lay" and report["panels"] == len(names)
    assert report["writing"]["tokens"] is None and report["writing"]["attempt"] == 1
    assert report["weights"]["pattern_maker"] == {"model": "DraftBook", "parameters": 0}
    assert report["weights"]["garment_sewer"] == {"model": "FlatLay"}
    assert {"writing", "altering", "drawing", "network", "decoding"} <= set(made.seconds)
    made.save(tmp_path)
    again = Garment.load(tmp_path)
    assert again.pattern.canonical() == made.pattern.canonical()
    with Image.open(tmp_path / "preview.png") as preview:
        assert np.asarray(preview).std() > 5
    # It draws no images, so those of the garment are made when they are asked for.
    rebuilt = decode(made.images)
    assert np.median(np.linalg.norm(rebuilt.vertices.mean(axis=0) - made.garment.vertices.mean(axis=0))) < 3.0


def test_what_another_network_writes_is_altered_checked_and_written_again(tailor):
    made = tailor.generate("a sleeveless t-shirt", source="writer")
    assert not any("sleeve" in p.name for p in made.pattern.panels)
    assert made.report["alterations"]["cuts"]
    longer = tailor.edit(draft("fitted-skirt"), "make it 10 cm longer")
    assert longer.report["alterations"]["of_the_pattern_to_edit"]

    class Improving(DraftBook):
        def generate_all(self, requests, *, seed, temperature, draw):
            torn = draft("t-shirt")
            torn = replace(torn, stitches=torn.stitches[2 - min(draw, 2) :])
            return [swifttailor.WrittenPattern(torn) for _ in requests]

    again = Tailor(Improving(), FlatLay()).generate("a t-shirt", alter=False, source="writer")
    assert again.report["writing"]["attempt"] == 3 and len(again.pattern.stitches) == 14


def test_what_another_sewer_cannot_sew_is_refused_with_its_reason():
    with pytest.raises(PatternError, match="does not fit on the table"):
        Tailor(DraftBook(), FlatLay()).sew(draft("hoodie"))
    (refused,) = Tailor(DraftBook(), Refusing()).make(Order("a t-shirt", attempts=2))
    assert isinstance(refused, PatternError) and "does not fit on the table" in str(refused)


class Refusing(FlatLay):
    def prepare(self, pattern, *, edge_length, resolution):
        raise PatternError("It does not fit on the table.")


def test_a_body_of_ones_own_is_sewn_around_and_shown(sewer):
    body = Body.default()
    wide = replace(body, vertices=body.vertices * [1.15, 1.0, 1.15], name="wider")
    for owner, name in ((None, None), (wide, "wider")):
        tailor = Tailor(DraftBook(), sewer, body=owner)
        made = tailor.generate("a fitted-skirt", edge_length=4.0)
        assert isinstance(made, Tailored) and made.report.get("body") == name
        if owner is None:
            usual = made
    at_hips = [one.garment.vertices[one.garment.vertices[:, 1] > 85.0] for one in (usual, made)]
    extent = [np.ptp(vertices[:, 2]) for vertices in at_hips]
    assert extent[1] > extent[0] + 1.0, "the cloth is kept out of the wider body"
    depth, _ = tailor.garment_sewer.body.full.sample(made.garment.vertices)
    assert (depth > -0.5).mean() > 0.95


def test_cloth_of_ones_own_hangs_where_physics_finishes():
    tailor = swifttailor.Tailor(DraftBook(), FlatLay(), fabric="denim")
    assert tailor.sew(draft("fitted-skirt"), edge_length=6.0, finish=True).report["fabric"] == "denim"
