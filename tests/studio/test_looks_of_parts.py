"""Parts in another look on their way through the studio: documents, meshes, requests, exports."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from running_studio import follow

from swifttailor.garment.garment import Garment
from swifttailor.garment.part_looks import PartLook, looks_of_panels
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.studio.bench.documents import document
from swifttailor.studio.bench.mesh_files import garment_of, garment_record
from swifttailor.studio.bench.part_looks import in_cloth
from swifttailor.studio.mesh_record import unpack_mesh
from swifttailor.studio.models.documents import Document

LOOKS = (PartLook("collar", "#ffffff"), PartLook("sleeves", None, "mesh"))
SENT = [{"part": "collar", "color": "#ffffff"}, {"part": "sleeves", "cloth": "mesh"}]


@pytest.fixture(scope="module")
def shirt() -> Garment:
    """Panels where they stand before draping, sewn at once."""
    pattern = draft("shirt").canonical()
    mesh = mesh_pattern(pattern, 3.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    return Garment(mesh, mesh.welded_mean(np.concatenate(flat)), {}, "#102030", looks=LOOKS)


def test_a_document_says_which_panels_look_how(shirt):
    answer = document(shirt.pattern, origin="open", garment=shirt, state="sewn").answer
    told = Document.model_validate(answer).looks
    assert [look.model_dump(exclude_none=True) for look in told.parts] == SENT
    assert told.panels.keys() == {p.name for p in shirt.pattern.panels if "torso" not in p.name}
    (share,) = {look.opacity for name, look in told.panels.items() if "sleeve" in name}
    assert (
        share == pytest.approx(min(look.opacity for look in looks_of_panels(shirt)), abs=1e-3) and share < 1
    )
    assert {look.color for name, look in told.panels.items() if "collar" in name} == {"#ffffff"}
    plain = document(shirt.pattern, origin="open", garment=replace(shirt, looks=()), state="sewn").answer
    assert plain["looks"] == {"parts": [], "panels": {}}


def test_the_garment_comes_back_with_them_and_has_a_mesh_of_its_own(shirt):
    record = garment_record(shirt, 3.0)
    assert garment_of(record).looks == LOOKS
    other = garment_record(replace(shirt, looks=LOOKS[:1]), 3.0)
    plain = garment_record(replace(shirt, looks=()), 3.0)
    assert len({record.name, other.name, plain.name}) == 3
    assert "looks" not in unpack_mesh(plain.data)[0]


def test_a_garment_takes_those_of_a_request_that_it_has_parts_for(shirt):
    hood = {"part": "hood", "color": "#ff0000"}
    assert in_cloth(replace(shirt, looks=()), None, [hood, *SENT]).looks == LOOKS
    assert in_cloth(shirt, "#ffffff", []).color == "#ffffff"


def ask(client, path: str, body: dict[str, Any]) -> Any:
    answer = client.post(path, json=body)
    assert answer.status_code < 300, answer.text
    return answer


def test_an_edit_keeps_them_and_adds_to_them_and_an_export_has_them(client, shirt):
    pattern = to_specification(shirt.pattern)
    job = {"kind": "edit", "pattern": pattern, "instruction": "make the cuffs white", "looks": SENT}
    made = follow(client, ask(client, "/api/jobs", job).json()["id"])[-1][1]["documents"][0]
    parts = {look["part"]: look for look in made["looks"]["parts"]}
    assert parts.keys() == {"collar", "sleeves", "cuffs"} and parts["cuffs"]["color"] == "#ffffff"
    assert made["looks"]["panels"]["sl_left_cuff_f"]["color"] == "#ffffff"
    export = {
        "pattern": made["pattern"],
        "mesh": made["mesh"],
        "format": "glb",
        "looks": list(parts.values()),
    }
    content = ask(client, "/api/export", export).content
    length = struct.unpack("<I", content[12:16])[0]
    materials = json.loads(content[20 : 20 + length])["materials"]
    assert any(material.get("alphaMode") == "BLEND" for material in materials)
