from __future__ import annotations

import json

import pytest

from swifttailor.cli.draft import run_draft
from swifttailor.errors import PatternError
from swifttailor.pattern import load_pattern
from swifttailor.pattern.drafts import draft, list_drafts


def test_writes_the_pattern(tmp_path, capsys):
    out = tmp_path / "new" / "dress.json"
    code = run_draft(
        ["fitted-dress", "--skirt-flare", "-2", "--neckline", "v", "--skirt-length=70", "--out", str(out)]
    )
    assert code == 0
    expected = draft("fitted-dress", skirt_flare=-2, neckline="v", skirt_length=70)
    assert load_pattern(out).panels == expected.panels
    assert f"{len(expected.panels)} panels" in capsys.readouterr().out


def test_switches(tmp_path):
    out = tmp_path / "h.json"
    assert run_draft(["hoodie", "--no-cuffs", "--no-hem-band", "--out", str(out)]) == 0
    assert len(load_pattern(out).panels) == 10


def test_list_as_table(capsys):
    assert run_draft(["--list"]) == 0
    shown = capsys.readouterr().out
    for info in list_drafts():
        assert info.name in shown
    assert "--sleeve-length" in shown


def test_list_as_json(capsys):
    assert run_draft(["--list", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    assert [d["name"] for d in listed] == [d.name for d in list_drafts()]
    assert {"name", "type", "default", "unit", "low", "high", "choices", "help"} == set(
        listed[0]["options"][0]
    )


def test_help_shows_every_option_with_unit_and_range(capsys):
    assert run_draft(["t-shirt", "--help"]) == 0
    shown = " ".join(capsys.readouterr().out.replace("│", " ").split())
    assert "--sleeve-length" in shown and "12 to 74 cm" in shown and "(default: 22.0)" in shown


@pytest.mark.parametrize("arguments", [[], ["--nonsense"], ["t-shirt", "--sleeves", "3"]])
def test_usage_errors_end_with_2(arguments, capsys):
    assert run_draft(arguments) == 2
    assert capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["gown"], ["t-shirt", "--length", "900", "--out", "x.json"]])
def test_refusals_are_raised(arguments, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PatternError):
        run_draft(arguments)
    assert not (tmp_path / "x.json").exists()
