"""``swifttailor sew`` on a T-shirt damaged, or written as other programs do: a garment, or why not."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from swifttailor.cli.main import run
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft

TINY = str(Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx")
Panels = dict[str, Any]


def without_labels(file: dict[str, Any], panels: Panels) -> None:
    for panel in panels.values():
        panel.pop("label", None)
        for edge in panel["edges"]:
            edge.pop("label", None)


def in_metres(file: dict[str, Any], panels: Panels) -> None:
    file["properties"]["units_in_meter"] = 1
    for panel in panels.values():
        panel["vertices"] = [[x / 100, y / 100] for x, y in panel["vertices"]]
        panel["translation"] = [x / 100 for x in panel["translation"]]


def with_other_names(file: dict[str, Any], panels: Panels) -> None:
    names = {name: f"piece {k}" for k, name in enumerate(list(panels))}
    for name in list(panels):
        panels[names[name]] = panels.pop(name)
    for stitch in file["pattern"]["stitches"]:
        for side in stitch:
            if isinstance(side, dict):
                side["panel"] = names[side["panel"]]
    file["pattern"].pop("panel_order", None)


def with_more_than_is_known(file: dict[str, Any], panels: Panels) -> None:
    file["made_by"] = {"tool": "another", "version": [1, 2]}
    for panel in panels.values():
        panel["color"] = "#fff"


def with_loops_begun_elsewhere(file: dict[str, Any], panels: Panels) -> None:
    for name, panel in panels.items():
        count = len(panel["edges"])
        panel["edges"] = panel["edges"][1:] + panel["edges"][:1]
        for stitch in file["pattern"]["stitches"]:
            for side in stitch:
                if isinstance(side, dict) and side["panel"] == name:
                    side["edge"] = (side["edge"] - 1) % count


def with_an_open_loop(file: dict[str, Any], panels: Panels) -> None:
    next(iter(panels.values()))["edges"].pop()


def with_crossed_corners(file: dict[str, Any], panels: Panels) -> None:
    corners = next(iter(panels.values()))["vertices"]
    corners[0], corners[1] = corners[1], corners[0]


def with_every_stitch_turned(file: dict[str, Any], panels: Panels) -> None:
    file["pattern"]["stitches"] = [[*stitch[:2], "right_wrong"] for stitch in file["pattern"]["stitches"]]


def with_a_stitch_turned(file: dict[str, Any], panels: Panels) -> None:
    file["pattern"]["stitches"][0].append("right_wrong")


def with_a_stitch_to_nothing(file: dict[str, Any], panels: Panels) -> None:
    file["pattern"]["stitches"][0][0]["panel"] = "nobody"


def without_stitches(file: dict[str, Any], panels: Panels) -> None:
    file["pattern"]["stitches"] = []


def with_a_corner_nowhere(file: dict[str, Any], panels: Panels) -> None:
    next(iter(panels.values()))["vertices"][0][0] = float("nan")


def far_apart(file: dict[str, Any], panels: Panels) -> None:
    for k, panel in enumerate(panels.values()):
        panel["translation"] = [300.0 * k, 100.0, 0.0]


def without_placement(file: dict[str, Any], panels: Panels) -> None:
    for panel in panels.values():
        panel["translation"], panel["rotation"] = [0, 0, 0], [0, 0, 0]


# damage: (exit code, pieces of the garment, what is said)
SEWN = {
    without_labels: (0, 1, "are closed"),
    in_metres: (0, 1, "other-units"),
    with_other_names: (0, 1, "are closed"),
    with_more_than_is_known: (0, 1, "unknown-key"),
    with_loops_begun_elsewhere: (0, 1, "are closed"),
    without_placement: (0, 1, "are closed"),
    with_a_stitch_turned: (1, 1, "twisted-seam"),
    with_every_stitch_turned: (1, 1, "twisted-seam"),
    without_stitches: (1, 8, "disconnected"),
    far_apart: (1, 1, "far-placement"),
}
REFUSED = {
    with_crossed_corners: "self-crossing",
    with_a_stitch_to_nothing: "there is no panel 'nobody'. Repair it with: swifttailor check",
    with_an_open_loop: "the outline is open by",
    with_a_corner_nowhere: "every number must be finite",
}


def damaged(tmp_path: Path, damage: Callable[[dict[str, Any], Panels], None]) -> Path:
    file = json.loads(json.dumps(to_specification(draft("t-shirt"))))
    damage(file, file["pattern"]["panels"])
    path = tmp_path / "shirt.json"
    path.write_text(json.dumps(file))
    return path


@pytest.mark.parametrize("damage", SEWN)
def test_what_can_be_sewn_is_and_what_is_wrong_is_said(damage, tmp_path, capsys):
    code, pieces, said = SEWN[damage]
    out = tmp_path / "out"
    assert run(["sew", str(damaged(tmp_path, damage)), "--out", str(out), "--weights", TINY]) == code
    assert said in capsys.readouterr().out
    garment = Garment.load(out)
    counts = topology(garment.faces, len(garment.vertices))
    assert counts.components == pieces and counts.nonmanifold_edges == 0
    assert (counts.inconsistent_edges > 0) == (said == "twisted-seam")


def test_a_turned_stitch_is_turned_back_when_asked(tmp_path):
    path, out = damaged(tmp_path, with_a_stitch_turned), tmp_path / "out"
    assert run(["sew", str(path), "--repair", "--out", str(out), "--weights", TINY]) == 1  # it was at fault
    garment = Garment.load(out)
    counts = topology(garment.faces, len(garment.vertices))
    assert counts.components == 1 and counts.inconsistent_edges == counts.nonmanifold_edges == 0


@pytest.mark.parametrize("damage", REFUSED)
def test_what_cannot_be_sewn_is_refused_with_the_reason(damage, tmp_path, capsys):
    path, out = damaged(tmp_path, damage), tmp_path / "out"
    assert run(["sew", str(path), "--out", str(out), "--weights", TINY]) == 2
    assert REFUSED[damage] in capsys.readouterr().out
    assert not out.exists()
