"""``swifttailor studio``: its options, and what it says where it cannot serve."""

from __future__ import annotations

import builtins
import socket

import pytest

from swifttailor.cli.main import run
from swifttailor.studio.app.serve import address_of, is_loopback, open_socket


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--port", "70000"], "0 to 65535"),
        (["--port", "-1"], "0 to 65535"),
        (["--token", "short"], "16 or more"),
        (["--token", "x" * 20 + " y"], "A-Z, a-z"),
        (["--host", "no.such.host.invalid", "--no-open"], "no address of this machine"),
    ],
)
def test_options_that_cannot_be_used(options, said, capsys):
    assert run(["studio", *options]) == 2
    assert said in capsys.readouterr().err


def test_a_file_is_no_folder_of_projects(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert run(["studio", "--projects", str(tmp_path / "file"), "--no-open"]) == 2
    assert "not a folder" in capsys.readouterr().err


def test_without_the_extra_it_says_what_to_install(monkeypatch, capsys):
    real = builtins.__import__

    def without(name, *rest):
        if name == "fastapi":
            raise ModuleNotFoundError("No module named 'fastapi'", name="fastapi")
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    assert run(["studio", "--no-open"]) == 2
    assert "pip install 'swifttailor[studio]'" in capsys.readouterr().err


def test_a_port_that_is_taken():
    with open_socket("127.0.0.1", 0) as first:
        port = first.getsockname()[1]
        with pytest.raises(Exception, match=f"port {port}.*--port"):
            open_socket("127.0.0.1", port)


def test_where_the_usual_port_is_taken_another_is_found(monkeypatch):
    with open_socket("127.0.0.1", 0) as first:
        monkeypatch.setattr("swifttailor.studio.app.serve.USUAL_PORT", first.getsockname()[1])
        with open_socket("127.0.0.1", None) as second:
            assert second.getsockname()[1] != first.getsockname()[1]


def test_the_address_has_the_token_where_browsers_send_it_nowhere():
    with open_socket("127.0.0.1", 0) as listening:
        port = listening.getsockname()[1]
        assert address_of(listening, "127.0.0.1", None) == f"http://127.0.0.1:{port}/"
        assert address_of(listening, "127.0.0.1", "abc").endswith(f":{port}/#token=abc")
        assert address_of(listening, "0.0.0.0", None) == f"http://{socket.gethostname()}:{port}/"


@pytest.mark.parametrize(
    ("host", "alone"), [("127.0.0.1", True), ("localhost", True), ("::1", True), ("0.0.0.0", False)]
)
def test_what_is_loopback(host, alone):
    assert is_loopback(host) is alone
