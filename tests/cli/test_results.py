"""Where results go when no place is given, and how they are shown."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.cli import results
from swifttailor.cli.results import file_name, new_place, open_file


@given(st.text())
def test_any_text_becomes_a_file_name(text):
    name = file_name(text)
    assert 0 < len(name) <= 40 and name == file_name(name)
    assert Path(name).name == name and not name.startswith((".", "-")) and not name.endswith("-")
    assert "".join(name.split("-")).isalnum()


def test_names_that_are_read_with_pleasure():
    assert (
        file_name("A knee-length sleeveless dress with a V neck") == "a-knee-length-sleeveless-dress-with-a-v"
    )
    assert file_name("") == file_name("...") == "garment"


def test_a_new_place_is_where_nothing_is(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("shirt").mkdir()
    Path("shirt-2").symlink_to("nothing")
    assert new_place("Shirt") == Path("shirt-3") and new_place("shirt", ".json") == Path("shirt.json")


@pytest.fixture
def opener(tmp_path, monkeypatch):
    """A program of that name which notes what it is to open, and then does something."""
    monkeypatch.setattr(results.sys, "platform", "linux")
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")

    def make(then: str) -> Path:
        program = tmp_path / "xdg-open"
        program.write_text(f'#!/bin/sh\necho "$1" > "{tmp_path}/opened"\n{then}\n')
        program.chmod(0o755)
        return tmp_path / "opened"

    return make


@pytest.mark.skipif(os.name == "nt", reason="a shell script")
@pytest.mark.parametrize(("then", "said"), [("", ""), ("exit 3", "knows no program"), ("exec sleep 60", "")])
def test_the_system_s_opener_is_asked(then, said, opener, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(results, "_SECONDS_TO_FAIL", 30.0 if "exit" in then or not then else 0.5)
    opened = opener(then)
    monkeypatch.chdir(tmp_path)
    open_file(Path("preview.png"))
    assert opened.read_text().strip() == str(tmp_path / "preview.png")
    shown = capsys.readouterr()
    assert shown.out == "" and (said in shown.err if said else not shown.err)


def test_without_display_or_opener_it_says_so(monkeypatch, capsys):
    monkeypatch.setattr(results.sys, "platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    open_file(Path("preview.png"))
    assert capsys.readouterr().err == (
        "Cannot show 'preview.png': there is no display. It is written all the same.\n"
    )
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setenv("PATH", "")
    open_file(Path("preview.png"))
    assert "'xdg-open' is not installed" in capsys.readouterr().err


def test_the_preview_is_shown_or_else_the_garment_or_the_folder(tmp_path, monkeypatch):
    from swifttailor.cli.sew import Sew

    shown: list[Path] = []
    monkeypatch.setattr(results, "open_file", shown.append)
    sewn = Sew(patterns=(Path("a.json"),), out=tmp_path, open=True)
    for name in ("", "garment.glb", "preview.png"):
        if name:
            (tmp_path / name).write_text("")
        sewn.show("preview.png", "garment.glb")
    assert shown == [tmp_path, tmp_path / "garment.glb", tmp_path / "preview.png"]
    Sew(patterns=(Path("a.json"),), out=tmp_path).show("preview.png")
    assert len(shown) == 3
