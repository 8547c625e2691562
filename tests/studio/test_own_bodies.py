"""Bodies that people load as meshes: kept, worn, and refused where they are bombs."""

from __future__ import annotations

import io
import json
import struct

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.errors import InputError
from swifttailor.pattern import read_specification, to_specification
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft
from swifttailor.studio.bench import own_bodies
from swifttailor.studio.bench.body_upload import memory_bounded, require_plain_glb
from swifttailor.studio.bench.tasks import TASKS
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.worker.link import Link

LINK = Link(lambda message: None, lambda: False)
WIDER = np.array([1.08, 1.0, 1.08])


def mesh_file(ending: str) -> bytes:
    """The default body, 8 % wider and deeper."""
    import trimesh

    body = Body.default()
    out = io.BytesIO()
    wide = trimesh.Trimesh(body.vertices * WIDER, body.faces, process=False)
    wide.export(out, file_type=ending)
    return out.getvalue()


def glb(told: dict, data: bytes = b"") -> bytes:
    """A binary glTF that says this of itself."""
    text = json.dumps(told).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if data:
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


@pytest.fixture
def kept(tmp_path, monkeypatch):
    """A folder of bodies for the test alone."""
    monkeypatch.setattr(own_bodies, "_kept", own_bodies.OwnBodies(tmp_path))
    return tmp_path


@pytest.mark.parametrize("ending", ["obj", "ply", "glb", "stl"])
def test_a_mesh_is_measured_and_kept(kept, ending):
    answer = TASKS["body"](LINK, file_name=f"Ana.{ending}", content=mesh_file(ending)).answer
    assert answer["name"] == "Ana"
    assert answer["measures"]["bust"] == pytest.approx(1.08 * Body.default().measurements.bust, rel=0.02)
    assert answer["measures"]["height"] == pytest.approx(Body.default().measurements.height, rel=0.01)
    found = own_bodies.own_bodies().find(answer["body"])
    assert len(found.faces) == answer["faces"]
    assert np.ptp(found.vertices, axis=0) == pytest.approx(np.ptp(Body.default().vertices * WIDER, axis=0))


def test_a_pattern_is_refitted_to_it_and_stays_on_it(kept):
    body = TASKS["body"](LINK, file_name="Ana.ply", content=mesh_file("ply")).answer["body"]
    shirt = to_specification(draft("t-shirt"))
    fitted = TASKS["fit"](
        LINK, pattern=shirt, size=None, figure=None, measures={}, body=body, called="Ana"
    ).answer
    named = fitted["pattern"]["properties"]["drafted_for"]
    assert (named["name"], named["mesh"]) == ("Ana", body)
    pattern = read_specification(fitted["pattern"]).pattern
    assert pattern.drafted_for.mesh == body
    worn = wearing(pattern.drafted_for)
    assert not worn.stands_in
    assert np.ptp(worn.body.vertices[:, 2]) == pytest.approx(1.08 * np.ptp(Body.default().vertices[:, 2]))
    assert fitted["body"] == worn.name
    # The command line knows no mesh: a body of the same measures wears it there.
    (kept / f"{body}.npz").unlink()
    told = TASKS["wearer"](LINK, pattern=fitted["pattern"]).answer
    assert told["stands_in"]
    assert told["measures"]["bust"] == pytest.approx(dict(named["measures"])["bust"], abs=1.5)
    with pytest.raises(InputError, match="Load its file again"):
        TASKS["fit"](LINK, pattern=shirt, size=None, figure=None, measures={}, body=body)


def test_a_damaged_file_of_a_body_is_refused(kept):
    name = own_bodies.own_bodies().add(Body.default())
    path = kept / f"{name}.npz"
    path.write_bytes(path.read_bytes()[:-1] + b"!")
    with pytest.raises(InputError, match="not kept here"):
        own_bodies.own_bodies().find(name)


def test_no_more_bodies_are_kept_than_there_is_room_for(kept, monkeypatch):
    monkeypatch.setattr(own_bodies, "MOST_KEPT", 1)
    store = own_bodies.own_bodies()
    name = store.add(Body.default())
    assert store.add(Body.default()) == name
    other = Body.from_mesh(Body.default().vertices * WIDER, Body.default().faces)
    with pytest.raises(InputError, match="1 bodies are kept already"):
        store.add(other)


@pytest.mark.parametrize("mesh", ["../../etc/passwd", "x" * 32, 7, "0" * 31])
def test_names_of_meshes_are_hashes(mesh):
    from swifttailor.errors import PatternError

    with pytest.raises(PatternError, match="drafted_for"):
        DraftedFor.from_json({"name": "a", "measures": {}, "mesh": mesh})


MANY = 2_000_000_000
POSITIONS = {"count": 3, "type": "VEC3", "componentType": 5126}
BOMBS = {
    "an accessor without data": glb({"accessors": [POSITIONS | {"count": MANY}]}),
    "an accessor of two thousand million": glb({"accessors": [POSITIONS | {"count": MANY, "bufferView": 0}]}),
    "a view that is larger than the file": glb({"bufferViews": [{"buffer": 0, "byteLength": MANY}]}),
    "a node within itself many times": glb(
        {"nodes": [{"children": [k + 1, k + 1]} for k in range(60)] + [{}]}
    ),
    "a buffer of another file": glb({"buffers": [{"uri": "../../../etc/passwd", "byteLength": 8}]}),
    "a picture of another file": glb({"images": [{"uri": "/dev/zero"}]}),
    "a length beyond the file": b"glTF" + struct.pack("<II", 2, 20) + struct.pack("<I4s", MANY, b"JSON"),
    "levels without end": glb({}).replace(b"{}  ", b"[" * 4) + b"[" * 100_000,
}


@pytest.mark.parametrize("content", BOMBS.values(), ids=BOMBS.keys())
def test_binary_gltf_that_promises_too_much_is_refused_unread(content):
    with pytest.raises(InputError, match="Export"):
        require_plain_glb(content)


PLY = "ply\nformat {form} 1.0\nelement vertex {n}\n" + "".join(f"property float {axis}\n" for axis in "xyz")
PLY += "end_header\n"
OTHERS = {
    "a.ply": PLY.format(form="binary_little_endian", n=MANY).encode() + b"\0" * 36,
    "b.ply": PLY.format(form="ascii", n=MANY).encode() + b"0 0 0\n",
    "c.ply": b"ply\nformat ascii 1.0\ncomment TextureFile ../../../../etc/passwd\n"
    + PLY.format(form="ascii", n=1).encode()[21:]
    + b"0 0 0\n",
    "a.stl": b"\0" * 80 + struct.pack("<I", MANY) + b"\0" * 50,
    "mtllib.obj": b"mtllib /etc/passwd\n" + b"v 0 0 0\n" * 3 + b"f 1 2 3\n" * 10,
    "b.obj": b"v 0 0 0\n" + b"f 1 1 999999999999\n",
    "c.obj": b"v 1e400 nan 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n",
    "a.glb": b"PK\x03\x04" + b"\0" * 200,
    "a.npz": b"\x93NUMPY",
    "../../x.obj/..": b"v",
    "zip.obj": b"PK\x03\x04" + bytes(range(256)) * 100,
    "zip.ply": b"PK\x03\x04" + bytes(range(256)) * 100,
    "zip.stl": b"PK\x03\x04" + bytes(range(256)) * 100,
    "empty.obj": b"",
}


@pytest.mark.parametrize(("file_name", "content"), OTHERS.items(), ids=OTHERS.keys())
def test_what_is_no_body_is_refused_without_the_server_s_paths(kept, file_name, content):
    with pytest.raises(InputError) as refused:
        TASKS["body"](LINK, file_name=file_name, content=content)
    assert "/tmp" not in str(refused.value)
    assert "swifttailor-studio-" not in str(refused.value)
    assert list(kept.iterdir()) == []


def test_memory_is_bounded_while_a_file_is_read():
    pytest.importorskip("resource")
    with memory_bounded(64 * 2**20), pytest.raises(MemoryError):
        np.ones(2**28)
    assert np.ones(2**20).sum() == 2**20


def test_bodies_are_sent_asked_for_and_worn_over_the_web(client, dress):
    assert client.post("/api/bodies?file_name=a.obj", json={}).status_code == 415
    empty = {"Content-Type": "application/octet-stream"}
    assert client.post("/api/bodies?file_name=a.obj", headers=empty).status_code == 422
    sent = client.post(
        "/api/bodies", params={"file_name": "Ana.ply"}, content=mesh_file("ply"), headers=empty
    )
    assert sent.status_code == 201, sent.text
    body = sent.json()["body"]
    asked = {"pattern": dress["pattern"], "body": body, "size": "44"}
    assert client.post("/api/fit", json=asked).status_code == 422
    fitted = client.post("/api/fit", json={"pattern": dress["pattern"], "body": body})
    assert fitted.status_code == 200, fitted.text
    assert fitted.json()["garment"] == "sewn"
    assert client.get(f"/api/body/{fitted.json()['body']}").status_code == 200
    told = client.post("/api/wearer", json={"pattern": fitted.json()["pattern"]}).json()
    assert (told["mesh"], told["stands_in"]) == (body, False)
    # It is no project, and the list of projects is as it was.
    assert client.get("/api/projects").status_code == 200
    large = client.post("/api/bodies?file_name=a.obj", content=b"v" * (17 * 2**20), headers=empty)
    assert large.status_code == 413
