"""Pockets, buttons, zips and belts in the studio: drawn, marked, told, and kept by whatever is done."""

from __future__ import annotations

import json
import os
import zipfile
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from running_studio import content_of, follow

from swifttailor.garment.garment import Garment
from swifttailor.garment.trim_colors import trim_color
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Pattern, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import TRIMS
from swifttailor.studio.bench.mesh_files import garment_of, garment_record, same_pattern
from swifttailor.studio.bench.trim_blocks import trim_marks
from swifttailor.studio.compact_mesh import expand, shrink
from swifttailor.studio.mesh_record import unpack_mesh
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.quick import CheckAnswer, LiveAnswer, RepairAnswer

COLORS = Path(__file__).parents[2] / "studio-ui" / "src" / "garment" / "trim-colors.json"
WORN = ("button placket", "chest pocket", "side zip", "tie belt")


def shirt(*trims: str) -> Pattern:
    return replace(draft("shirt").canonical(), trims=trims)


def placed(pattern: Pattern) -> Garment:
    """The panels where they stand before draping, sewn at once."""
    mesh = mesh_pattern(pattern, 3.0)
    flat = [p.to_world(mesh.flat_vertices[mesh.flat_panel == k]) for k, p in enumerate(pattern.panels)]
    return Garment(mesh, mesh.welded_mean(np.concatenate(flat)), {}, "#102030")


@pytest.fixture(scope="module")
def worn() -> Garment:
    return placed(shirt(*WORN))


def ask(client, path: str, body: dict[str, Any]) -> dict[str, Any]:
    answer = client.post(path, json=body)
    assert answer.status_code < 300, answer.text
    return answer.json()


def worked(client, body: dict[str, Any]) -> dict[str, Any]:
    """The document that a job makes."""
    return follow(client, ask(client, "/api/jobs", body)["id"])[-1][1]["documents"][0]


def named(document: dict[str, Any]) -> list[str]:
    return document["pattern"]["properties"].get("trims", [])


@pytest.fixture(scope="module")
def sewn(client) -> dict[str, Any]:
    """The document of a shirt with trims."""
    return ask(client, "/api/open", {"pattern": to_specification(shirt(*WORN))})


def test_the_mesh_file_carries_them_part_by_part(worn):
    header, blocks = unpack_mesh(garment_record(worn, 3.0).data)
    looks = {(trim["name"], trim["look"]) for trim in header["trims"]}
    assert {("button placket (cloth)", "cloth"), ("button placket (button)", "button")} <= looks
    positions, uv = blocks["trim_positions"].reshape(-1, 3), blocks["trim_uv"].reshape(-1, 2)
    faces, lines = blocks["trim_triangles"].reshape(-1, 3), blocks["trim_lines"].reshape(-1, 2)
    ends = np.zeros(3, int)
    low, high = worn.vertices.min(axis=0) - 3, worn.vertices.max(axis=0) + 3
    on_panels = np.concatenate([panel.outline() for panel in worn.pattern.panels])
    for trim in header["trims"]:
        first, ends = ends, ends + np.array([trim[kind] for kind in ("vertices", "triangles", "lines")])
        own = slice(first[0], ends[0])
        assert set(faces[first[1] : ends[1]].ravel()) <= set(range(trim["vertices"]))
        assert set(lines[first[2] : ends[2]].ravel()) <= set(range(trim["vertices"]))
        assert ((positions[own] >= low) & (positions[own] <= high)).all(), trim["name"]
        assert trim["on_panel"] == (trim["look"] in ("cloth", "dark") and "belt" not in trim["name"])
        if trim["on_panel"]:
            assert (uv[own] >= on_panels.min(axis=0) - 1).all() and (
                uv[own] <= on_panels.max(axis=0) + 1
            ).all()
        else:
            assert not uv[own].any()
    assert ends.tolist() == [len(positions), len(faces), len(lines)]


def test_a_pocket_of_the_file_lies_on_the_cloth_of_its_place(worn):
    """Where a vertex lies on its panel and where it lies in space belong together."""
    header, blocks = unpack_mesh(garment_record(worn, 3.0).data)
    first = 0
    for trim in header["trims"]:
        own = slice(first, first := first + trim["vertices"])
        if trim["name"] != "chest pocket (cloth)":
            continue
        positions, uv = (
            blocks[name].reshape(-1, n)[own] for name, n in (("trim_positions", 3), ("trim_uv", 2))
        )
        panel = worn.pattern.panel_index("left_ftorso")
        cloth = worn.mesh.flat_panel == panel
        flat, space = worn.mesh.flat_vertices[cloth], worn.flat_positions[cloth]
        nearest = np.linalg.norm(uv[:, None] - flat, axis=2).argmin(axis=1)
        away = np.linalg.norm(uv - flat[nearest], axis=1)
        assert (np.linalg.norm(positions - space[nearest], axis=1) < away + 1.0).all()
        return
    pytest.fail("the pocket is not in the file")


def test_files_without_trims_are_as_they_were():
    header, blocks = unpack_mesh(garment_record(placed(shirt()), 3.0).data)
    assert "trims" not in header and not [name for name in blocks if name.startswith("trim")]


def test_the_garment_comes_back_with_them(worn):
    record = garment_record(worn, 3.0)
    again = garment_of(record)
    assert again.pattern.trims == WORN
    assert garment_record(again, 3.0).name == record.name


def test_small_files_hold_them_too(worn):
    data = garment_record(worn, 3.0).data
    header, blocks = unpack_mesh(expand(shrink(data)))
    before_header, before = unpack_mesh(data)
    assert header["trims"] == before_header["trims"] and list(blocks) == list(before)
    for name in ("trim_positions", "trim_uv"):
        assert np.abs(blocks[name] - before[name]).max() <= 0.0051, name
    for name in ("trim_triangles", "trim_lines"):
        assert np.array_equal(blocks[name], before[name]), name


def test_the_mesh_of_a_garment_with_other_trims_is_not_its_own():
    assert same_pattern(shirt("zip"), replace(shirt("zip"), name="another"))
    assert not same_pattern(shirt("zip"), shirt())
    assert not same_pattern(shirt("buttons"), replace(shirt("buttons"), button_count=4))


def test_marks_lie_on_their_panels():
    pattern = shirt(*WORN, "zip", "patch pockets")
    marks = trim_marks(pattern)
    kinds = {trim: {mark["kind"] for mark in marks if mark["trim"] == trim} for trim in pattern.trims}
    assert kinds == {
        "button placket": {"outline", "button"},
        "chest pocket": {"outline", "line"},
        "side zip": {"line"},
        "tie belt": set(),
        "zip": {"zip", "line"},
        "patch pockets": {"outline", "line"},
    }
    for mark in marks:
        outline = pattern.panel(mark["panel"]).outline()
        points = np.array(mark["points"])
        assert (points >= outline.min(axis=0) - 0.5).all() and (points <= outline.max(axis=0) + 0.5).all(), (
            mark
        )
        assert (mark["radius"] > 0) == (mark["kind"] == "button")
        assert len(points) == 1 if mark["kind"] == "button" else len(points) >= 2


def test_a_pattern_that_cannot_be_measured_has_no_marks(monkeypatch):
    def fail(pattern: Pattern) -> None:
        raise ValueError("min() of nothing")

    assert trim_marks(shirt()) == []
    monkeypatch.setattr("swifttailor.studio.bench.trim_blocks.place_trims", fail)
    assert trim_marks(shirt("zip")) == []


def test_the_page_has_the_colours_of_previews():
    """After a change that is wanted, run this with ``UPDATE_CLIENT_NUMBERS=1``."""
    garment = placed(shirt())
    found = [
        {
            "look": look,
            "cloth": cloth,
            "linear": [round(float(c), 5) for c in trim_color(garment, look, cloth)],
        }
        for cloth in ("#000000", "#1f2a44", "#3b5578", "#d9c8a9", "#ffffff", "#ff0000")
        for look in ("cloth", "dark", "metal", "button", "leather")
    ]
    if "UPDATE_CLIENT_NUMBERS" in os.environ:
        COLORS.write_text(json.dumps(found, indent=1) + "\n")
    assert json.loads(COLORS.read_text()) == found


def test_a_pattern_that_is_opened_shows_them(sewn):
    document = Document.model_validate(sewn)
    assert named(sewn) == list(WORN)
    assert {mark.trim for mark in document.trims} == {"button placket", "chest pocket", "side zip"}
    shown = {chip.text: chip for chip in document.reading.shown}
    for name in WORN:
        chip = shown[TRIMS[name]]
        assert chip.from_ == "pattern" and chip.holds and chip.claim is None


def test_a_trim_without_a_place_is_told():
    from swifttailor.studio.bench.chips import trim_chips

    skirt = replace(draft("fitted-skirt").canonical(), trims=("chest pocket", "side zip"))
    chips = trim_chips(skirt, skirt.trims, source="pattern")
    assert [(chip["id"], chip["holds"]) for chip in chips] == [
        ("trim:chest pocket", False),
        ("trim:side zip", True),
    ]


def test_quick_work_keeps_them(client, sewn):
    pattern = sewn["pattern"]
    altered = ask(
        client, "/api/alter", {"pattern": pattern, "changes": [{"dimension": "sleeve length", "value": 50.0}]}
    )
    assert altered["changes"] and named(altered) == list(WORN) and altered["trims"]
    cut = ask(client, "/api/alter", {"pattern": pattern, "changes": [{"claim": "sleeves", "value": "short"}]})
    assert named(cut) == list(WORN)
    mended = ask(client, "/api/repair", {"pattern": pattern})
    assert RepairAnswer.model_validate(mended).trims and named(mended) == list(WORN)
    assert CheckAnswer.model_validate(ask(client, "/api/check", {"pattern": pattern})).trims
    fitted = ask(client, "/api/fit", {"pattern": pattern, "size": "women EU 46"})
    assert named(fitted) == list(WORN) and fitted["trims"] != sewn["trims"]


def test_the_garment_that_follows_a_drag_has_them(client, sewn):
    body = {"client": "tests-trims", "sequence": 1, "pattern": sewn["pattern"], "dragging": True}
    answer = ask(client, "/api/live", body | {"edge_length": 3.5})
    assert {mark.trim for mark in LiveAnswer.model_validate(answer).trims} == set(WORN) - {"tie belt"}
    header, _ = unpack_mesh(client.get(f"/api/meshes/{answer['mesh']}").content)
    assert {trim["name"].split(" (")[0] for trim in header["trims"]} == set(WORN)


def test_a_garment_that_was_hung_brings_its_own(client, sewn):
    hung = worked(client, {"kind": "finish", "pattern": sewn["pattern"], "mesh": sewn["mesh"]})
    assert named(hung) == list(WORN)
    before, after = (
        unpack_mesh(client.get(f"/api/meshes/{document['mesh']}").content) for document in (sewn, hung)
    )
    assert after[0]["trims"] == before[0]["trims"]
    assert np.abs(after[1]["trim_positions"] - before[1]["trim_positions"]).max() > 0.1


def test_words_put_them_on_and_take_them_off(client):
    made = worked(client, {"kind": "generate", "text": "a long denim jacket with a zip"})
    assert "zip" in named(made) and "chest pockets" in named(made)
    assert TRIMS["zip"] in [chip["text"] for chip in made["reading"]["made"]]
    # Nobody spoke of pockets: denim jackets have them.
    assert TRIMS["chest pockets"] in [chip["text"] for chip in made["reading"]["assumed"]]
    told = [chip["text"] for part in ("made", "assumed", "shown") for chip in made["reading"][part]]
    assert len(told) == len(set(told))
    body = {"kind": "edit", "pattern": made["pattern"], "instruction": "without pockets, and add a belt"}
    changed = worked(client, body)
    assert "zip" in named(changed) and "chest pockets" not in named(changed)
    assert {f"put on: {TRIMS['tie belt']}", f"taken off: {TRIMS['chest pockets']}"} <= set(changed["changes"])
    assert TRIMS["tie belt"] in [chip["text"] for chip in changed["reading"]["made"]]
    assert TRIMS["zip"] in [chip["text"] for chip in changed["reading"]["shown"]]


def test_files_and_projects_keep_them(client, sewn):
    asked = {"pattern": sewn["pattern"], "mesh": sewn["mesh"]}
    saved = json.loads(client.post("/api/export", json=asked | {"format": "json"}).content)
    assert saved["properties"]["trims"] == list(WORN)
    glb = client.post("/api/export", json=asked | {"format": "glb"}).content
    assert b"chest pocket (cloth)" in glb
    with zipfile.ZipFile(
        BytesIO(client.post("/api/export", json=asked | {"format": "zip"}).content)
    ) as packed:
        assert json.loads(packed.read("pattern.json"))["properties"]["trims"] == list(WORN)
    project = ask(client, "/api/projects", {"content": content_of(sewn, "A shirt")})
    again = client.get(f"/api/projects/{project['id']}").json()
    assert named(again["document"]) == list(WORN) and again["document"]["trims"] == sewn["trims"]
    assert again["versions"][0]["pattern"]["properties"]["trims"] == list(WORN)
    client.delete(f"/api/projects/{project['id']}")


def test_documents_of_earlier_versions_are_read(sewn):
    earlier = {name: value for name, value in sewn.items() if name != "trims"}
    assert Document.model_validate(earlier).trims == []
