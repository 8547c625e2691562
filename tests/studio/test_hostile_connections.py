"""Connections that mean no good: odd heads, upgrades, event streams without end, bodies that are bombs."""

from __future__ import annotations

import gzip
import io
import socket
import zipfile
from urllib.parse import urlsplit

import pytest

from swifttailor.studio.app.limits import ServerLimits


def connect(studio) -> socket.socket:
    at = urlsplit(studio.address)
    return socket.create_connection((at.hostname, at.port), timeout=30)


def first_line(studio, content: bytes) -> bytes:
    """What the server answers to these bytes; empty where it hangs up."""
    with connect(studio) as one:
        try:
            one.sendall(content)
            return one.recv(4096).split(b"\r\n")[0]
        except (ConnectionResetError, BrokenPipeError):
            return b""


HEADS = {
    "a web socket": (
        "GET /api/live HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n",
        b" 404 ",
    ),
    "two hosts": ("GET /api/state HTTP/1.1\r\nHost: evil.example\r\nHost: {host}\r\n\r\n", b" 400 "),
    "a name in front of a host": ("GET /api/state HTTP/1.1\r\nHost: {host}@evil.example\r\n\r\n", b" 421 "),
    "a host that only begins so": (
        "GET /api/state HTTP/1.1\r\nHost: 127.0.0.1.evil.example\r\n\r\n",
        b" 421 ",
    ),
    "another host in the address": (
        "GET http://evil.example/api/state HTTP/1.1\r\nHost: evil.example\r\n\r\n",
        b" 421 ",
    ),
    "no host": ("GET /api/state HTTP/1.0\r\n\r\n", b" 421 "),
    "a negative length": (
        "POST /api/check HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\n"
        "Content-Length: -1\r\n\r\n{{}}",
        b" 400 ",
    ),
    "a head of two megabytes": (
        "GET /api/state HTTP/1.1\r\nHost: {host}\r\nX: " + "a" * 2_000_000 + "\r\n\r\n",
        b" 400 ",
    ),
    "a line break in an id": (
        "GET /api/examples/a%0d%0aSet-Cookie:%20x HTTP/1.1\r\nHost: {host}\r\n\r\n",
        b" 404 ",
    ),
    "the folder of bodies": ("GET /.bodies/x.npz HTTP/1.1\r\nHost: {host}\r\n\r\n", b" 404 "),
    "the folder of bodies as a project": (
        "GET /api/projects/.bodies HTTP/1.1\r\nHost: {host}\r\n\r\n",
        b" 404 ",
    ),
}


@pytest.mark.parametrize(("head", "answer"), HEADS.values(), ids=HEADS.keys())
def test_odd_heads_are_refused(studio, client, head, answer):
    said = first_line(studio, head.format(host=urlsplit(studio.address).netloc).encode())
    assert answer in said or said == b"", said
    assert client.get("/api/state").status_code == 200


def test_event_streams_that_come_at_once_are_counted(studio, client, dress):
    """No more than the limit are answered, and once they are gone there is room again."""
    limit = ServerLimits().streams
    job = client.post("/api/jobs", json={"kind": "drape", "pattern": dress["pattern"], "mesh": None}).json()
    request = f"GET /api/jobs/{job['id']}/events HTTP/1.1\r\nHost: {urlsplit(studio.address).netloc}\r\n\r\n"
    streams = [connect(studio) for _ in range(limit + 20)]
    try:
        for one in streams:
            one.sendall(request.encode())
        lines = [one.recv(12) for one in streams]
        assert lines.count(b"HTTP/1.1 503") >= 20
        assert lines.count(b"HTTP/1.1 200") <= limit
        assert client.get("/api/state").status_code == 200
    finally:
        for one in streams:
            one.close()
        client.delete(f"/api/jobs/{job['id']}")
    other = client.post("/api/jobs", json={"kind": "drape", "pattern": dress["pattern"], "mesh": None}).json()
    client.delete(f"/api/jobs/{other['id']}")
    with client.stream("GET", f"/api/jobs/{other['id']}/events") as answer:
        assert answer.status_code == 200


def test_bodies_that_are_packed_bombs_are_not_unpacked(client):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.obj", b"v 0 0 0\n" * 4_000_000)
    kind = {"Content-Type": "application/octet-stream"}
    for ending in ("zip", "obj", "glb", "ply", "stl"):
        answer = client.post(f"/api/bodies?file_name=a.{ending}", content=packed.getvalue(), headers=kind)
        assert answer.status_code == 422, (ending, answer.text)
        assert answer.json()["error"]["code"] == "input-refused"
    squeezed = {"Content-Type": "application/json", "Content-Encoding": "gzip"}
    answer = client.post("/api/check", content=gzip.compress(b" " * 30_000_000), headers=squeezed)
    assert answer.status_code == 400


def test_a_body_of_two_million_triangles_is_refused_in_bounded_time_and_memory(client):
    content = b"v 0 0 0\nv 1 0 0\nv 0 1.7 0\n" + b"f 1 2 3\n" * 2_000_000
    kind = {"Content-Type": "application/octet-stream"}
    answer = client.post("/api/bodies?file_name=a.obj", content=content, headers=kind)
    assert answer.status_code in (422, 504), answer.text
    assert client.post("/api/describe", json={"pattern": {}}).status_code == 422
