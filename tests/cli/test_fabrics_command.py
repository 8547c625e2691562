"""``swifttailor fabrics``, and --fabric of the commands that make garments."""

from __future__ import annotations

import json

import pytest

from swifttailor import draft
from swifttailor.cli.main import run
from swifttailor.draping import FABRICS


@pytest.fixture(scope="module")
def skirt(tmp_path_factory):
    return draft("fitted-skirt").save(tmp_path_factory.mktemp("drafts") / "skirt.json")


def test_the_table_names_every_fabric_with_units_and_source(capsys):
    assert run(["fabrics"]) == 0
    shown = capsys.readouterr().out
    for fabric in FABRICS.values():
        (line,) = [line for line in shown.splitlines() if line.split()[0] == fabric.name]
        assert float(line.split()[1]) == pytest.approx(1000 * fabric.density)
        assert fabric.kind in line and fabric.source in line
    assert {"g/m2", "N/m", "uN"} <= set(shown.splitlines()[1].split())
    assert run(["fabrics", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row["name"] for row in rows] == list(FABRICS)
    assert {row["name"] for row in rows if not row["measured"]} == {
        "cotton", "linen", "silk", "chiffon", "wool", "leather"
    }  # fmt: skip


@pytest.mark.parametrize("command", ["sew", "drape", "generate", "edit"])
def test_help_names_every_fabric(command, capsys):
    assert run([command, "--help"]) == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in FABRICS)


def test_a_sewn_garment_weighs_what_its_fabric_does(skirt, tmp_path, capsys):
    masses = {}
    for fabric in ("silk", "denim"):
        out = tmp_path / fabric
        assert run(["sew", str(skirt), "--out", str(out), "--fabric", fabric, "--edge-length", "6"]) in (0, 1)
        assert "the network knows no fabrics" in capsys.readouterr().out
        report = json.loads((out / "report.json").read_text())
        assert report["fabric"] == report["cloth"]["fabric"] == fabric
        area = report["cloth"]["area_m2"]
        assert 0.3 < area < 2.0
        masses[fabric] = report["cloth"]["mass_g"]
        assert masses[fabric] == pytest.approx(1000 * area * FABRICS[fabric].density, abs=0.2)
    assert masses["denim"] > 3 * masses["silk"]


def test_an_edit_keeps_the_fabric(skirt, tmp_path, capsys):
    first, second = tmp_path / "first", tmp_path / "second"
    assert run(["sew", str(skirt), "--out", str(first), "--fabric", "linen", "--edge-length", "6"]) in (0, 1)
    assert run(["edit", str(first), "make it shorter", "--out", str(second), "--edge-length", "6"]) in (0, 1)
    assert json.loads((second / "report.json").read_text())["fabric"] == "linen"


@pytest.mark.parametrize("command", [["sew"], ["drape"], ["edit"], ["generate"]])
def test_an_unknown_fabric_is_refused_before_anything_is_made(command, skirt, tmp_path, capsys):
    words = {"generate": ["a skirt"], "edit": [str(skirt), "make it shorter"]}.get(command[0], [str(skirt)])
    out = tmp_path / "out"
    assert run([*command, *words, "--out", str(out), "--fabric", "tweed"]) == 2
    said = capsys.readouterr().err
    assert "no fabric 'tweed'" in said and "cotton" in said and "swifttailor fabrics" in said
    assert not (out / "report.json").exists()
