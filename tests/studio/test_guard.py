"""Who is let in, and what is refused before anything of it is read."""

from __future__ import annotations

import asyncio

import httpx
import pytest
from own_loop import run

from swifttailor.studio.app.application import make_application
from swifttailor.studio.app.guard import COOKIE
from swifttailor.studio.app.limits import ServerLimits

TOKEN = "0123456789abcdef-token"
HOST = "http://127.0.0.1:8765"


class Nobody:
    """Stands for the studio, which no request here may reach; the state alone is answered."""

    jobs = projects = None

    def state(self):
        return {"reached": True}


def ask(
    tmp_path, method="GET", path="/api/state", *, token=None, hosts=None, limits=None, address=HOST, **request
):
    """One request to the application, in this process and without workers."""
    given = {} if hosts is None else {"hosts": hosts}
    app = make_application(tmp_path, token=token, limits=limits, **given)
    app._app.state.studio = Nobody()

    async def scene():
        transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url=address) as client:
            return await client.request(method, path, **request)

    return run(scene())


def refusal(answer):
    body = answer.json()
    assert set(body) == {"error"} and set(body["error"]) == {"code", "message", "hint"}
    assert body["error"]["message"]
    return answer.status_code, body["error"]["code"]


@pytest.mark.parametrize("host", ["127.0.0.1:8765", "localhost", "LOCALHOST:1", "[::1]:8765"])
def test_this_machine_is_answered(tmp_path, host):
    assert ask(tmp_path, headers={"host": host}).json() == {"reached": True}


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        "evil.example:8765",
        "127.0.0.1.evil.example",
        "localhost.evil.example",
        "192.168.0.7",
        "",
    ],
)
@pytest.mark.parametrize("path", ["/", "/api/state", "/api/meshes/0"])
def test_other_names_of_this_address_are_not_answered(tmp_path, host, path):
    assert refusal(ask(tmp_path, path=path, headers={"host": host})) == (421, "wrong-host")


@pytest.mark.parametrize(
    "headers",
    [
        {"origin": "https://evil.example"},
        {"origin": "null"},
        {"origin": "http://127.0.0.1:9999"},
        {"origin": "http://localhost:8765"},
        {"sec-fetch-site": "cross-site"},
        {"sec-fetch-site": "same-site"},
    ],
)
@pytest.mark.parametrize("method", ["GET", "POST", "DELETE"])
def test_other_sites_are_refused(tmp_path, headers, method):
    path = "/api/state" if method == "GET" else "/api/jobs/x"
    assert refusal(ask(tmp_path, method, path, headers=headers)) == (403, "other-site")


def test_the_own_page_is_let_in(tmp_path):
    headers = {"origin": HOST, "sec-fetch-site": "same-origin"}
    assert ask(tmp_path, headers=headers).status_code == 200


@pytest.mark.parametrize(
    "kind",
    ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", "", "text/json"],
)
def test_bodies_of_forms_are_refused(tmp_path, kind):
    """A page of another site can send these without asking first."""
    for path in ("/api/check", "/api/jobs", "/api/projects"):
        answer = ask(tmp_path, "POST", path, content=b"{}", headers={"content-type": kind})
        assert refusal(answer) == (415, "wrong-type")


@pytest.mark.parametrize("kind", ["application/json", "image/svg+xml", "text/html", "image/gif"])
def test_pictures_of_other_kinds_are_refused(tmp_path, kind):
    answer = ask(tmp_path, "POST", "/api/files", content=b"x", headers={"content-type": kind})
    assert refusal(answer) == (415, "wrong-type")


def test_every_answer_forbids_frames_sniffing_and_other_hosts(tmp_path):
    for path in ("/", "/api/state", "/api/none", "/none"):
        headers = ask(tmp_path, path=path).headers
        policy = headers["content-security-policy"]
        assert "default-src 'self'" in policy and "frame-ancestors 'none'" in policy
        assert "script-src" not in policy and "http" not in policy
        assert headers["x-content-type-options"] == "nosniff" and headers["x-frame-options"] == "DENY"
        assert "access-control-allow-origin" not in headers


def test_without_the_token_nothing_of_the_api_is_answered(tmp_path):
    for given in (
        {},
        {"authorization": "Bearer wrong"},
        {"authorization": f"Basic {TOKEN}"},
        {"cookie": f"{COOKIE}=x"},
    ):
        assert refusal(ask(tmp_path, token=TOKEN, headers=given)) == (401, "token-missing")
    assert refusal(ask(tmp_path, path=f"/api/state?token={TOKEN}", token=TOKEN)) == (401, "token-missing")
    assert ask(tmp_path, path="/", token=TOKEN).status_code == 200  # the page, which has no secrets


def test_the_token_becomes_a_cookie_that_scripts_and_other_sites_do_not_get(tmp_path):
    answer = ask(tmp_path, "POST", "/api/session", token=TOKEN, headers={"authorization": f"Bearer {TOKEN}"})
    cookie = answer.headers["set-cookie"]
    assert answer.status_code == 204
    assert "HttpOnly" in cookie and "samesite=strict" in cookie.lower() and "Path=/api" in cookie
    assert ask(tmp_path, token=TOKEN, headers={"cookie": cookie.partition(";")[0]}).status_code == 200


@pytest.mark.parametrize("chunked", [False, True])
def test_bodies_that_are_too_large_are_not_read(tmp_path, chunked):
    read = []

    async def pieces():
        for _ in range(10_000):
            read.append(1)
            yield b"x" * 1000

    limits = ServerLimits(pattern_bytes=50_000)
    content = pieces() if chunked else b"x" * 60_000
    headers = {"content-type": "application/json"}
    answer = ask(tmp_path, "POST", "/api/check", content=content, headers=headers, limits=limits)
    assert refusal(answer) == (413, "too-large")
    assert len(read) <= 60


def test_bodies_that_come_slowly_are_given_up(tmp_path):
    async def drops():
        for _ in range(100):
            yield b" "
            await asyncio.sleep(0.2)

    limits = ServerLimits(body_seconds=0.5)
    headers = {"content-type": "application/json"}
    answer = ask(tmp_path, "POST", "/api/check", content=drops(), headers=headers, limits=limits)
    assert refusal(answer) == (408, "too-slow")


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[" * 100_000,
        b'{"pattern":' * 50_000,
        b"\xff\xfe",
        b"null",
        b"[]",
        b'"x"',
        b"NaN",
        b"1e999",
        b'{"pattern": 1}',
    ],
)
@pytest.mark.parametrize("path", ["/api/check", "/api/jobs", "/api/live", "/api/projects"])
def test_what_is_no_request_is_refused_in_words(tmp_path, path, body):
    answer = ask(tmp_path, "POST", path, content=body, headers={"content-type": "application/json"})
    assert answer.status_code in (400, 415, 422)
    refusal(answer)


@pytest.mark.parametrize(
    "path",
    [
        "/../../etc/passwd",
        "/..%2f..%2fetc/passwd",
        "/assets/../index.html",
        "/%2e%2e/pyproject.toml",
        "/sources.sha256",
        "//etc/passwd",
    ],
)
def test_paths_of_requests_are_no_paths_on_the_disk(tmp_path, path):
    answer = ask(tmp_path, path=path)
    assert answer.status_code == 404 or b"<!doctype html>" in answer.content.lower()
    assert b"root:" not in answer.content and b"[project]" not in answer.content
