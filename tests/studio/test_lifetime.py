"""How a server ends, and what is left then: killed while it saves, interrupted, its workers killed."""

from __future__ import annotations

import json
import signal
import threading
import time

import httpx
import psutil
import pytest
from running_studio import content_of, start_studio, wait_until_ready

from swifttailor.pattern import read_pattern_file


def save_on_and_on(running, project, content, saved, stop):
    """Saves with names that count up; notes what the server has said is saved."""
    with running.client() as client:
        revision, number = project["revision"], 0
        while not stop.is_set():
            number += 1
            body = {"revision": revision, "content": content | {"name": f"save {number}"}}
            try:
                answer = client.put(f"/api/projects/{project['id']}", json=body)
            except httpx.HTTPError:
                return
            if answer.status_code != 200:
                return
            revision = answer.json()["revision"]
            saved.append(number)


@pytest.mark.parametrize("seconds", [0.4, 2.3])
def test_kill_9_loses_no_saved_project(tmp_path, seconds):
    projects = tmp_path / "projects"
    running = start_studio(projects, cold=True)
    with running.client() as client:
        dress = client.get("/api/examples/pencil-skirt").json()
        content = content_of(dress)
        project = client.post("/api/projects", json={"content": content}).json()
        draft = {"revision": 1, "content": content | {"name": "draft"}}
        assert client.put(f"/api/projects/{project['id']}/draft", json=draft).status_code == 200
    saved, stop = [], threading.Event()
    thread = threading.Thread(target=save_on_and_on, args=(running, project, content, saved, stop))
    thread.start()
    while not saved and thread.is_alive():
        time.sleep(0.05)
    time.sleep(seconds)
    workers = psutil.Process(running.process.pid).children(recursive=True)
    running.end(signal.SIGKILL)
    stop.set()
    thread.join()
    assert saved, "nothing was saved before the kill"
    _, alive = psutil.wait_procs(workers, timeout=20)
    assert not alive, "workers outlive a server that was killed"
    folder = projects / project["folder"]
    read_pattern_file(folder / "pattern.json")
    again = start_studio(projects, cold=True)
    try:
        with again.client() as client:
            found = client.get(f"/api/projects/{project['id']}").json()
            assert found["name"] in (f"save {saved[-1]}", f"save {saved[-1] + 1}")
            assert found["document"]["pattern"] == dress["pattern"]
            body = {"revision": found["revision"], "content": content}
            after = client.put(f"/api/projects/{project['id']}", json=body)
            assert after.status_code == 200 and after.json()["notes"] == []
        assert not [p.name for p in folder.iterdir() if p.name.startswith(".") and p.is_dir()]
    finally:
        again.end(signal.SIGKILL)


def test_an_interrupt_ends_everything_and_says_nothing_bad(tmp_path):
    running = start_studio(tmp_path / "projects", cold=True)
    with running.client() as client:
        client.get("/api/state")
    workers = psutil.Process(running.process.pid).children(recursive=True)
    assert running.end(signal.SIGINT) == 0
    assert "Traceback" not in running.process.stdout.read()
    _, alive = psutil.wait_procs(workers, timeout=20)
    assert not alive


def test_a_worker_that_is_killed_is_replaced(tmp_path):
    running = start_studio(tmp_path / "projects", cold=True)
    try:
        wait_until_ready(running)
        with running.client() as client:
            skirt = client.get("/api/examples/pencil-skirt").json()
            for worker in psutil.Process(running.process.pid).children(recursive=True):
                if "resource_tracker" not in " ".join(worker.cmdline()):
                    worker.kill()
            body = {"client": "tests-killed", "pattern": skirt["pattern"]}
            answers = []
            for sequence in range(1, 6):
                answers.append(client.post("/api/live", json=body | {"sequence": sequence}))
                if answers[-1].status_code == 200:
                    break
            assert answers[-1].status_code == 200 and answers[-1].json()["status"] == "sewn"
            for answer in answers[:-1]:
                assert answer.json()["error"]["code"] == "worker-ended" and "retry-after" in answer.headers
            job = client.post("/api/jobs", json={"kind": "sew", "pattern": skirt["pattern"]}).json()
            end = time.monotonic() + 90
            while job["state"] in ("queued", "running"):
                assert time.monotonic() < end
                time.sleep(0.2)
                job = client.get(f"/api/jobs/{job['id']}").json()
            assert job["state"] in ("done", "failed")
            again = client.post("/api/jobs", json={"kind": "sew", "pattern": skirt["pattern"]}).json()
            while again["state"] in ("queued", "running"):
                assert time.monotonic() < end
                time.sleep(0.2)
                again = client.get(f"/api/jobs/{again['id']}").json()
            assert again["state"] == "done", json.dumps(again["error"])
    finally:
        running.end(signal.SIGKILL)


def test_other_addresses_than_loopback_need_the_token(tmp_path):
    running = start_studio(tmp_path / "projects", "--host", "0.0.0.0", cold=True)
    try:
        assert running.token and len(running.token) >= 24
        address = f"http://127.0.0.1:{running.address.rpartition(':')[2]}"
        with httpx.Client(base_url=address, timeout=60) as client:
            assert client.get("/api/state").status_code == 401
            bearer = {"Authorization": f"Bearer {running.token}"}
            assert client.post("/api/session", headers=bearer).status_code == 204
            assert client.get("/api/state").status_code == 200  # by the cookie
    finally:
        running.end(signal.SIGKILL)
