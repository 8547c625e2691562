"""Prints on their way through the studio: documents, meshes, requests, tiles, exports, projects."""

from __future__ import annotations

import io
import json
import struct
import typing
import zipfile
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError
from running_studio import follow

from swifttailor.garment.cloth_print import KINDS, MOTIFS, ClothPrint, flat_places
from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import PartLook
from swifttailor.garment.print_tile import print_tile
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.render.picture_file import read_picture
from swifttailor.studio.bench.documents import document
from swifttailor.studio.bench.files import export
from swifttailor.studio.bench.mesh_files import garment_of, garment_record
from swifttailor.studio.bench.part_looks import in_cloth
from swifttailor.studio.bench.quick import alter
from swifttailor.studio.mesh_record import unpack_mesh
from swifttailor.studio.models import base
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.jobs import DrapeJob

DOTS = ClothPrint("dots", ("#203050", "#ffffff"), {"spacing": 4.0, "radius": 0.8})
SENT = DOTS.to_json()


@pytest.fixture(scope="module")
def shirt() -> Garment:
    """Panels where they stand before draping, sewn at once."""
    pattern = draft("shirt").canonical()
    mesh = mesh_pattern(pattern, 3.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    at = mesh.welded_mean(np.concatenate(flat))
    looks = (PartLook("collar", "#ffffff"), PartLook("sleeves", None, "lace"))
    return Garment(mesh, at, {}, "#203050", print=DOTS, looks=looks)


def test_a_document_says_what_is_printed_and_on_which_panels(shirt):
    answer = document(shirt.pattern, origin="open", garment=shirt, state="sewn").answer
    told = Document.model_validate(answer)
    assert told.print is not None and told.print.model_dump(exclude={"motif"}) == SENT
    plain = {name for name, look in told.looks.panels.items() if not look.printed}
    assert plain == {p.name for p in shirt.pattern.panels if "torso" not in p.name}
    assert Document.model_validate({k: v for k, v in answer.items() if k != "print"}).print is None


def test_the_garment_comes_back_with_it_and_its_panels_lie_on_the_cloth_as_in_previews(shirt):
    record = garment_record(shirt, 3.0)
    assert garment_of(record).print == DOTS
    assert record.name != garment_record(replace(shirt, print=None), 3.0).name
    header, blocks = unpack_mesh(record.data)
    assert header["print"] == SENT
    uv, panel = blocks["uv"].reshape(-1, 2), blocks["panel"]
    matrices = np.array(header["on_cloth"]).reshape(-1, 2, 3)[panel]
    laid = np.einsum("nij,nj->ni", matrices, np.column_stack([uv, np.ones(len(uv))]))
    assert np.abs(laid - flat_places(shirt)).max() < 1e-3
    assert (np.linalg.det(matrices[:, :, :2]) < 0).any(), "some are seen from their wrong side"


def test_trims_say_on_which_panel_they_lie():
    pattern = draft("shirt").canonical()
    pattern = replace(pattern, trims=("chest pockets",))
    mesh = mesh_pattern(pattern, 3.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    worn = Garment(mesh, mesh.welded_mean(np.concatenate(flat)), {}, print=DOTS)
    header, blocks = unpack_mesh(garment_record(worn, 3.0).data)
    on_panel = np.concatenate([[one["on_panel"]] * one["vertices"] for one in header["trims"]])
    names = {header["panels"][k] for k in blocks["trim_panel"][on_panel]}
    assert len(blocks["trim_panel"]) == len(blocks["trim_uv"]) // 2
    assert len(names) == 2 and all("ftorso" in name for name in names)


def test_a_garment_takes_that_of_a_request(shirt):
    plain = replace(shirt, print=None)
    assert in_cloth(plain, None, [], SENT).print == DOTS
    assert in_cloth(plain, None, []).print is None
    assert in_cloth(shirt, None, []).print == DOTS


def test_what_cannot_be_sewn_keeps_it():
    pattern = to_specification(draft("circle-skirt"))
    change = [{"claim": "skirt_hem", "value": "knee"}]
    made = alter(_NoLink(), pattern=pattern, changes=change, sew=False, print=SENT).answer
    assert made["mesh"] is None and made["print"] == SENT


@pytest.mark.parametrize("kind", ["usda", "usdz"])
def test_usd_has_it_where_there_is_room_for_a_picture(shirt, kind):
    pytest.importorskip("pxr")
    record = garment_record(replace(shirt, print=None), 3.0)
    pattern = to_specification(shirt.pattern)
    written = export(_NoLink(), pattern=pattern, mesh=record, format=kind, facts={"print": SENT}).answer
    assert (b"print.png" in written) == (kind == "usdz")


class _NoLink:
    def stage(self, *_: Any) -> None:
        """Nobody looks."""


@pytest.mark.parametrize(
    "wrong",
    [
        {"kind": "holes"},
        {"colors": ["#203050"]},
        {"colors": ["#203050"] * 7},
        {"colors": ["navy", "#ffffff"]},
        {"motif": "dragons"},
        {"sizes": {"spacing": 1e9}},
        {"sizes": {"spacing": 0.0}},
        {"sizes": {"angle": 361.0}},
        {"sizes": {"height": 4.0}},
        {"more": 1},
    ],
)
def test_prints_that_cannot_be_drawn_are_refused(wrong):
    with pytest.raises(ValidationError):
        DrapeJob.model_validate({"kind": "drape", "pattern": {}, "print": SENT | wrong})


def test_the_models_know_all_kinds_and_motifs():
    assert set(typing.get_args(base.PrintKind)) == set(KINDS)
    assert set(typing.get_args(base.PrintMotif)) == set(MOTIFS)


def test_a_tile_is_drawn_for_the_address_of_a_print(client, tmp_path):
    query = {"kind": "dots", "colors": list(DOTS.colors), "spacing": 4.0, "radius": 0.8, "angle": 45.0}
    answer = client.get("/api/prints/tile", params=query)
    assert answer.status_code == 200 and answer.headers["content-type"] == "image/png"
    assert "max-age" in answer.headers["cache-control"]
    tile = print_tile(replace(DOTS, sizes={**DOTS.sizes, "angle": 45.0}))
    matrix = [float(number) for number in answer.headers["x-tile"].split()]
    assert matrix == pytest.approx(tile.matrix().ravel(), abs=1e-5)
    path = tmp_path / "tile.png"
    path.write_bytes(answer.content)
    assert np.array_equal(read_picture(path), tile.picture)
    for wrong in ({"kind": "holes"}, {"colors": ["#203050"]}, {"spacing": 1e9}, {"height": 3}):
        assert client.get("/api/prints/tile", params=query | wrong).status_code == 422


def _ask(client, path: str, body: dict[str, Any]) -> Any:
    answer = client.post(path, json=body)
    assert answer.status_code < 300, answer.text
    return answer


def test_work_keeps_it_and_files_have_it(client, dress):
    change = {"dimension": dress["dimensions"][0]["name"], "by": 2.0}
    asked = {"pattern": dress["pattern"], "changes": [change], "color": "#203050", "print": SENT}
    made = _ask(client, "/api/alter", asked).json()
    assert made["print"] == SENT
    job = {"kind": "edit", "pattern": made["pattern"], "instruction": "make it shorter", "print": SENT}
    edited = follow(client, _ask(client, "/api/jobs", job).json()["id"])[-1][1]["documents"][0]
    assert edited["print"] == SENT
    job |= {"instruction": "make it red"}
    red = follow(client, _ask(client, "/api/jobs", job).json()["id"])[-1][1]["documents"][0]
    assert red["print"] is None, "a colour that is asked for takes its place"

    asked = {"pattern": made["pattern"], "mesh": made["mesh"], "print": SENT, "color": "#203050"}
    glb = _ask(client, "/api/export", asked | {"format": "glb"}).content
    length = struct.unpack("<I", glb[12:16])[0]
    assert [one["name"] for one in json.loads(glb[20 : 20 + length])["images"]] == ["print"]
    packed = _ask(client, "/api/export", asked | {"format": "zip"}).content
    with zipfile.ZipFile(io.BytesIO(packed)) as files:
        assert json.loads(files.read("report.json"))["print"] == SENT
    with_dots = _ask(client, "/api/export", asked | {"format": "png"}).content
    asked |= {"mesh": None, "print": None, "format": "png"}
    plain = _ask(client, "/api/export", asked).content
    assert with_dots != plain


def test_a_project_keeps_it_and_its_folder_has_it(client, studio, dress):
    change = {"dimension": dress["dimensions"][0]["name"], "by": 1.0}
    asked = {"pattern": dress["pattern"], "changes": [change], "print": SENT}
    made = _ask(client, "/api/alter", asked).json()
    version = {"number": 1, "label": "made", "pattern": made["pattern"], "color": None, "print": SENT}
    about = {"name": "Dotted", "prompt": "", "seed": None, "view": {}}
    content = about | {"document": made, "versions": [version | {"mesh": made["mesh"]}]}
    project = _ask(client, "/api/projects", {"content": content}).json()
    try:
        opened = client.get(f"/api/projects/{project['id']}").json()
        assert opened["document"]["print"]["kind"] == "dots"
        assert opened["versions"][0]["print"]["colors"] == list(DOTS.colors)
        assert Garment.load(studio.projects / project["folder"]).print == DOTS
    finally:
        client.delete(f"/api/projects/{project['id']}")
