"""What a person does with the studio, asked of a real server."""

from __future__ import annotations

import io
import itertools
import json
import struct
import time
import zipfile
from copy import deepcopy

import numpy as np
import pytest
from PIL import Image
from running_studio import content_of, follow

from swifttailor.pattern import read_specification, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.studio.mesh_record import unpack_mesh
from swifttailor.studio.models.documents import Document
from swifttailor.studio.models.jobs import Job
from swifttailor.studio.models.projects import Project, State
from swifttailor.studio.models.quick import CheckAnswer, DescribeAnswer, LiveAnswer, RepairAnswer

ENDINGS = {"clo": "clo.zip"}


def ask(client, path, body):
    answer = client.post(path, json=body)
    assert answer.status_code < 300, answer.text
    return answer.json()


def mesh_of(client, name):
    answer = client.get(f"/api/meshes/{name}")
    assert answer.status_code == 200 and "immutable" in answer.headers["cache-control"]
    return unpack_mesh(answer.content)


def lowest(client, name):
    return mesh_of(client, name)[1]["positions"].reshape(-1, 3)[:, 1].min()


def test_the_first_page_is_filled_without_computing(client):
    state = State.model_validate(client.get("/api/state").json())
    assert len(state.examples) >= 6 and state.claims and state.dimensions
    for example in state.examples:
        document = Document.model_validate(client.get(f"/api/examples/{example.id}").json())
        header, _blocks = mesh_of(client, document.mesh)
        assert set(header["panels"]) == set(document.pattern["pattern"]["panels"])
        assert client.get(example.thumbnail).headers["content-type"] == "image/webp"
    body = client.get(f"/api/body/{state.body}")
    assert unpack_mesh(body.content)[0]["kind"] == "body"


def test_a_hem_that_is_dragged_down_takes_the_garment_with_it(client, dress):
    """All points of the hem 10 cm down: the mesh reaches lower by about as much; then back."""
    pattern = deepcopy(dress["pattern"])
    sequence = time.time_ns() // 1000
    before = ask(client, "/api/live", {"client": "tests-drag", "sequence": sequence, "pattern": pattern})
    LiveAnswer.model_validate(before)
    for panel in pattern["pattern"]["panels"].values():
        heights = [y for _, y in panel["vertices"]]
        if max(heights) - min(heights) > 50:  # of the skirt
            panel["vertices"] = [[x, y - 10 if y < min(heights) + 5 else y] for x, y in panel["vertices"]]
    after = ask(client, "/api/live", {"client": "tests-drag", "sequence": sequence + 1, "pattern": pattern})
    assert after["status"] == "sewn" and after["mesh"] != before["mesh"]
    assert 5 < lowest(client, before["mesh"]) - lowest(client, after["mesh"]) < 15
    again = ask(
        client, "/api/live", {"client": "tests-drag", "sequence": sequence + 2, "pattern": dress["pattern"]}
    )
    assert again["mesh"] == before["mesh"]


def test_a_state_that_comes_late_is_dropped(client, dress):
    body = {"client": "tests-late", "pattern": dress["pattern"]}
    first = ask(client, "/api/live", body | {"sequence": 9})
    late = ask(client, "/api/live", body | {"sequence": 8})
    assert (first["status"], late["status"], late["mesh"]) == ("sewn", "stale", None)


def test_what_cannot_be_sewn_says_why_and_where(client, dress):
    pattern = deepcopy(dress["pattern"])
    name, panel = next(iter(pattern["pattern"]["panels"].items()))
    panel["vertices"][0], panel["vertices"][2] = panel["vertices"][2], panel["vertices"][0]
    answer = ask(client, "/api/live", {"client": "tests-cross", "sequence": 1, "pattern": pattern})
    checked = CheckAnswer.model_validate(ask(client, "/api/check", {"pattern": pattern}))
    crossing = [f for f in checked.findings if f.code == "self-crossing" and f.panel == name]
    assert answer["status"] == "unsewable" and answer["error"]["message"] and answer["mesh"] is None
    assert crossing and len(crossing[0].points) == 1 and crossing[0].edges


def test_a_small_crossing_is_mended_from_the_findings(client, real_pattern):
    """A straight edge gets a loop of a few millimetres, as a hand leaves that slips."""
    pattern = deepcopy(real_pattern)
    panels = pattern["pattern"]["panels"]
    name = next(n for n, p in panels.items() if len(p["vertices"]) >= 5)
    panel = panels[name]
    straight = next(k for k, e in enumerate(panel["edges"]) if "curvature" not in e)
    a, b = (np.array(panel["vertices"][i]) for i in panel["edges"][straight]["endpoints"])
    along, first = (b - a) / np.linalg.norm(b - a), len(panel["vertices"])
    across = np.array([-along[1], along[0]])
    middle = (a + b) / 2
    corners = [middle + 0.5 * along + 0.3 * across, middle - 0.5 * along + 0.3 * across]
    panel["vertices"] += [list(map(float, c)) for c in corners]
    start, end = panel["edges"][straight]["endpoints"]
    chain = [start, first, first + 1, end]
    new = [{"endpoints": [i, j]} for i, j in itertools.pairwise(chain)]
    panel["edges"][straight : straight + 1] = new
    stitches = pattern["pattern"]["stitches"]
    kept = []
    for stitch in stitches:
        sides = stitch[:2]
        if any(s["panel"] == name and s["edge"] == straight for s in sides):
            continue
        for s in sides:
            if s["panel"] == name and s["edge"] > straight:
                s["edge"] += 2
        kept.append(stitch)
    pattern["pattern"]["stitches"] = kept
    checked = ask(client, "/api/check", {"pattern": pattern})
    crossing = [f for f in checked["findings"] if f["code"] in ("self-crossing", "near-crossing")]
    assert crossing and crossing[0]["mendable"], checked["findings"]
    mended = RepairAnswer.model_validate(ask(client, "/api/repair", {"pattern": pattern}))
    assert mended.changes
    assert not [f for f in mended.findings if f.code in ("self-crossing", "near-crossing")]


def test_a_real_pattern_is_opened_with_seams_and_sliders(client, real_pattern):
    document = Document.model_validate(ask(client, "/api/open", {"pattern": real_pattern, "title": "Mine"}))
    pattern = read_specification(document.pattern).pattern
    assert document.title == "Mine" and document.garment == "sewn" and document.mesh
    assert len(document.seams) == len(pattern.stitches)
    for seam in document.seams:
        stitch = pattern.stitches[seam.stitch]
        assert (seam.first.panel, seam.first.edge) == (stitch.first.panel, stitch.first.edge)
        assert seam.mismatch == pytest.approx(
            pattern.edge_length(stitch.first) - pattern.edge_length(stitch.second), abs=0.01
        )
    assert document.dimensions and all(d.min <= d.value <= d.max for d in document.dimensions)
    described = DescribeAnswer.model_validate(ask(client, "/api/describe", {"pattern": real_pattern}))
    assert described.description and described.dimensions == document.dimensions


def test_a_chip_is_corrected_and_the_pattern_cut_to_it(client, dress):
    changed = ask(
        client,
        "/api/alter",
        {"pattern": dress["pattern"], "changes": [{"claim": "skirt_hem", "value": "mini"}]},
    )
    assert changed["changes"] and not changed["open"] and changed["garment"] == "sewn"
    assert [c["value"] for c in changed["reading"]["made"] if c["claim"] == "skirt_hem"] == ["mini"]
    assert lowest(client, changed["mesh"]) > lowest(client, dress["mesh"]) + 15


def test_a_slider_moves_its_dimension_to_the_millimetre(client, dress):
    length = next(d for d in dress["dimensions"] if d["name"] == "length")
    changes = [{"dimension": "length", "value": length["value"] - 7.3}]
    changed = ask(client, "/api/alter", {"pattern": dress["pattern"], "changes": changes, "sew": False})
    after = next(d for d in changed["dimensions"] if d["name"] == "length")
    assert after["value"] == pytest.approx(length["value"] - 7.3, abs=0.1) and changed["mesh"] is None


def test_what_cannot_be_cut_is_said(client, dress):
    body = {"pattern": dress["pattern"], "changes": [{"claim": "legs", "value": "wide"}]}
    refused = client.post("/api/alter", json=body | {"changes": [{"claim": "no such", "value": "x"}]})
    assert refused.status_code == 422 and "no such" in refused.json()["error"]["message"]
    assert ask(client, "/api/alter", body | {"sew": False})["open"]


def test_words_to_garments(client):
    """Two variants at once, each with its seed; made, cannot and unknown are told apart."""
    text = "a knee-length sleeveless red dress with sequins and a blorf"
    job = ask(client, "/api/jobs", {"kind": "generate", "text": text, "seed": 3, "variants": 2})
    events = follow(client, job["id"])
    assert events[-1][0] == "done" and all(not view["documents"] for _, view in events[:-1])
    done = Job.model_validate(events[-1][1])
    assert [d.seed for d in done.documents] == [3, 4] and {s.name for s in done.stages} >= {
        "writing",
        "sewing",
    }
    reading = done.documents[0].reading
    hem = next(chip for chip in reading.made if chip.claim == "skirt_hem")
    assert hem.value == "knee" and "midi" in hem.choices and hem.holds
    assert any("sequins" in chip.text for chip in reading.cannot)
    assert [chip.text for chip in reading.unknown] == ["blorf"]
    assert reading.color == done.documents[0].color == "#ab252e"
    again = ask(client, "/api/jobs", {"kind": "generate", "text": text, "seed": 3})
    assert follow(client, again["id"])[-1][1]["documents"][0]["mesh"] == done.documents[0].mesh


def test_words_for_two_garments_make_both(client):
    text = "a white blouse and a black pencil skirt"
    job = ask(client, "/api/jobs", {"kind": "generate", "text": text, "seed": 3})
    documents = Job.model_validate(follow(client, job["id"])[-1][1]).documents
    assert [(d.part, d.seed, d.color) for d in documents] == [
        ("upper", 3, "#ffffff"),
        ("lower", 3, "#000000"),
    ]
    assert not any("several garments" in chip.text for d in documents for chip in d.reading.cannot)


def test_a_picture_is_read(client):
    from pathlib import Path

    photograph = Path(__file__).parents[2] / "docs" / "images" / "woman-with-dog.jpg"
    sent = client.post("/api/files", content=photograph.read_bytes(), headers={"content-type": "image/jpeg"})
    file = sent.json()
    assert sent.status_code == 201
    shown = Image.open(io.BytesIO(client.get(file["url"]).content))
    assert shown.size == (file["width"], file["height"])
    seen = client.get(file["seen_url"])
    assert seen.status_code == 200 and Image.open(io.BytesIO(seen.content)).format == "PNG"
    job = ask(client, "/api/jobs", {"kind": "generate", "pictures": [file["id"]]})
    document = follow(client, job["id"])[-1][1]["documents"][0]
    assert any(chip["from"] == "picture" for chip in document["reading"]["made"])


def test_an_instruction_changes_a_pattern(client, dress):
    body = {
        "kind": "edit",
        "pattern": dress["pattern"],
        "instruction": "make it 10 cm longer",
        "color": "#336699",
    }
    document = follow(client, ask(client, "/api/jobs", body)["id"])[-1][1]["documents"][0]
    before = next(d["value"] for d in dress["dimensions"] if d["name"] == "length")
    after = next(d["value"] for d in document["dimensions"] if d["name"] == "length")
    assert (
        after - before == pytest.approx(10, abs=3) and document["changes"] and document["color"] == "#336699"
    )


def test_a_drape_shows_frames_and_can_be_stopped(client, dress):
    job = ask(
        client,
        "/api/jobs",
        {"kind": "drape", "pattern": dress["pattern"], "edge_length": 4.0, "fabric": "silk"},
    )
    stopped = False
    with client.stream("GET", f"/api/jobs/{job['id']}/events") as answer:
        for line in answer.iter_lines():
            if line != "event: frame" or stopped:
                continue
            frame = client.get(f"/api/jobs/{job['id']}/frame")
            if frame.status_code != 200:
                continue
            header, _blocks = mesh_of(client, frame.headers["x-mesh"])
            positions = np.frombuffer(frame.content, "<f4").reshape(-1, 3)
            assert len(positions) == header["welded"] and np.isfinite(positions).all()
            client.delete(f"/api/jobs/{job['id']}")
            stopped = True
    view = client.get(f"/api/jobs/{job['id']}").json()
    assert stopped and view["state"] == "stopped"
    document = Document.model_validate(view["documents"][0])
    assert document.garment == "stopped" and document.fabric == "silk" and mesh_of(client, document.mesh)


def test_a_sewn_garment_is_finished(client, dress):
    sewn = ask(client, "/api/open", {"pattern": dress["pattern"]})
    body = {
        "kind": "finish",
        "pattern": sewn["pattern"],
        "mesh": sewn["mesh"],
    }
    view = follow(client, ask(client, "/api/jobs", body)["id"])[-1][1]
    document = view["documents"][0]
    assert view["state"] == "done" and view["frame"] >= 1 and document["garment"] == "finished"
    assert document["quality"]["accepted"] and document["mesh"] != sewn["mesh"]
    assert document["edge_length"] == sewn["edge_length"]


def test_a_drape_around_the_ankles_is_not_called_good(client):
    low = to_specification(draft("t-shirt"))
    for panel in low["pattern"]["panels"].values():
        panel["translation"][1] -= 75.0
    body = {"kind": "drape", "pattern": low, "edge_length": 4.0, "fabric": "cotton"}
    document = follow(client, ask(client, "/api/jobs", body)["id"])[-1][1]["documents"][0]
    assert not document["quality"]["accepted"]
    assert any("not where it is worn" in reason for reason in document["quality"]["reasons"])
    assert any(finding["code"] == "misplaced-panel" for finding in document["findings"])


def test_an_example_is_finished_from_how_it_hangs(client):
    example = client.get("/api/examples/pencil-skirt").json()
    body = {"kind": "finish", "pattern": example["pattern"], "mesh": example["mesh"]}
    view = follow(client, ask(client, "/api/jobs", body)["id"])[-1][1]
    document = view["documents"][0]
    assert document["edge_length"] == example["edge_length"] == 2.5
    before, after = (mesh_of(client, one["mesh"])[1]["positions"] for one in (example, document))
    apart = np.linalg.norm((before - after).reshape(-1, 3), axis=1)
    assert np.median(apart) < 1.0


def test_a_job_that_waits_has_a_place_and_can_be_cancelled(client, dress):
    bodies = [{"kind": "sew", "pattern": dress["pattern"]}] * 3
    jobs = [ask(client, "/api/jobs", body) for body in bodies]
    last = client.delete(f"/api/jobs/{jobs[-1]['id']}").json()
    assert last["state"] in ("cancelled", "running", "done")
    ends = [follow(client, job["id"])[-1] for job in jobs]
    assert [event for event, _ in ends[:2]] == ["done", "done"]
    assert ends[2][0] == ("cancelled" if last["state"] != "done" else "done")


@pytest.mark.parametrize(
    "name", ["json", "svg", "pdf", "dxf", "md", "clo", "glb", "obj", "ply", "stl", "png", "zip"]
)
def test_every_export(client, dress, name):
    if name == "pdf":
        pytest.importorskip("reportlab")
    body = {"pattern": dress["pattern"], "mesh": dress["mesh"], "format": name, "title": "My dress!"}
    answer = client.post("/api/export", json=body)
    assert answer.status_code == 200, answer.text
    assert (
        answer.headers["content-disposition"] == f'attachment; filename="my-dress.{ENDINGS.get(name, name)}"'
    )
    content = answer.content
    if name == "json":
        assert read_specification(json.loads(content)).pattern == read_specification(dress["pattern"]).pattern
    elif name == "pdf":
        assert content.startswith(b"%PDF-")
    elif name == "dxf":
        assert b"SECTION" in content[:40] and content.rstrip().endswith(b"EOF")
    elif name == "md":
        assert content.decode().startswith("# My dress!: how to sew it")
    elif name == "clo":
        assert zipfile.is_zipfile(io.BytesIO(content))
    elif name == "glb":
        assert struct.unpack("<4sII", content[:12]) == (b"glTF", 2, len(content))
    elif name == "png":
        assert Image.open(io.BytesIO(content)).size == (1000, 600)
    elif name == "zip":
        with zipfile.ZipFile(io.BytesIO(content)) as packed:
            assert packed.testzip() is None
            assert {
                "pattern.json",
                "pattern.svg",
                "garment.glb",
                "garment.obj",
                "preview.png",
                "report.json",
                "ggi.npz",
            } <= set(packed.namelist())


def test_a_project_is_a_folder_that_the_command_line_reads(client, studio, dress, capsys):
    from swifttailor import Garment
    from swifttailor.cli.main import run

    created = client.post("/api/projects", json={"content": content_of(dress, "Été: my/dress..")})
    project = Project.model_validate(created.json())
    folder = studio.projects / project.folder
    assert created.status_code == 201 and folder.parent == studio.projects and folder.is_dir()
    garment = Garment.load(folder)
    assert garment.pattern == read_specification(dress["pattern"]).pattern
    assert run(["check", str(folder / "pattern.json")]) == 0
    capsys.readouterr()
    content = content_of(dress, "Another name")
    saved = client.put(f"/api/projects/{project.id}", json={"revision": project.revision, "content": content})
    assert saved.status_code == 200 and saved.json()["notes"] == []
    changed = client.put(
        f"/api/projects/{project.id}", json={"revision": project.revision, "content": content}
    )
    assert changed.status_code == 409 and changed.json()["error"]["code"] == "project-changed"
    content["view"] = {"draft": True}
    body = {"revision": saved.json()["revision"], "content": content}
    assert client.put(f"/api/projects/{project.id}/draft", json=body).status_code == 200
    again = Project.model_validate(client.get(f"/api/projects/{project.id}").json())
    assert again.name == "Another name" and again.view == {"units": "cm"}
    assert again.draft is not None and again.draft.view == {"draft": True}
    listed = next(p for p in client.get("/api/projects").json() if p["id"] == project.id)
    assert Image.open(io.BytesIO(client.get(listed["thumbnail"]).content)).format == "PNG" and listed["draft"]
    exported = client.get(f"/api/projects/{project.id}/export/zip")
    assert zipfile.is_zipfile(io.BytesIO(exported.content))
    assert client.delete(f"/api/projects/{project.id}").status_code == 204
    assert client.get(f"/api/projects/{project.id}").status_code == 404 and not folder.exists()
    assert client.post(f"/api/trash/{project.id}/restore").json()["id"] == project.id
    assert client.get(f"/api/projects/{project.id}").json()["name"] == "Another name"
