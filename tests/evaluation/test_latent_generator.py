"""A latent diffusion among the systems that are compared."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from types import SimpleNamespace
from zipfile import ZipFile

import numpy as np
from maker_standins import write_patterns

from swifttailor.cli.item_progress import ItemProgress
from swifttailor.cli.main import run
from swifttailor.errors import PatternError
from swifttailor.evaluation.maker.ask import Asking
from swifttailor.evaluation.maker.run import Plan
from swifttailor.evaluation.systems.latent import LatentGenerator
from swifttailor.evaluation.systems.run import run_systems
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft


@dataclass
class Reads:
    """A tailor that reads orders alone."""

    orders: list = field(default_factory=list)

    def read(self, order):
        self.orders.append(order)
        return SimpleNamespace(sought=order.text)


@dataclass
class Draws:
    """A latent diffusion that draws what it is given."""

    patterns: dict[str, Pattern]
    drawn: list = field(default_factory=list)

    def draw(self, sought, *, seed, name):
        self.drawn.append((sought, seed, name))
        if name not in self.patterns:
            raise PatternError("The panel tensor holds no panel.")
        return self.patterns[name]


def crossed() -> Pattern:
    """One of whose outlines winds around itself."""
    skirt = draft("fitted-skirt")
    around = 4 * np.pi * np.arange(9) / 9 + 0.3
    star = 30 * np.stack([np.cos(around), np.sin(around)], 1)
    panel = skirt.panels[0]
    own = replace(panel, name="skirt_panel_0", vertices=star, edges=(type(panel.edges[0])(),) * 9)
    return Pattern((*skirt.panels, own), skirt.stitches)


def test_one_drawing_is_asked_for_mended_and_kept_or_failed_with_the_reason(tmp_path):
    inside_out = draft("fitted-skirt").panels
    turned = Pattern((inside_out[0].reversed(), *inside_out[1:]), ())
    draws = Draws({"shirt": draft("t-shirt"), "short": turned, "long": crossed()})
    tailor = Reads()
    system = LatentGenerator("theirs", tailor, Asking(seed=3), {"diffusion": "x"}, draws)
    plan = Plan((write_patterns(tmp_path),), None, tasks=("text",), asking=Asking(seed=3), samples=0)
    run_systems([system], [], plan, tmp_path / "out", ItemProgress)
    lines = (tmp_path / "out" / "theirs" / "answers.jsonl").read_text().splitlines()
    kept = {one["question"].split(" ")[-1]: one for one in map(json.loads, lines) if "question" in one}
    assert len(tailor.orders) == len(draws.drawn) == 4
    assert {text for text, _, _ in draws.drawn} == {order.text for order in tailor.orders}
    assert len({seed for _, seed, _ in draws.drawn}) == 4, "each question draws with a seed of its own"
    found = {
        name: one for id, one in kept.items() for name in ("shirt", "short", "long", "trousers") if name in id
    }
    assert found["shirt"]["pattern"] and not found["shirt"]["mended"]
    assert found["short"]["mended"], "a panel that is inside out is turned, as of other systems"
    assert "error" in found["long"] and "pattern" not in found["long"]
    assert found["trousers"]["error"] == "The panel tensor holds no panel."
    assert system.identity() == {"weights": {"diffusion": "x"}, "seed": 3}


def test_the_command_tells_a_latent_diffusion_from_other_model_files(tmp_path, capsys):
    broken, other = tmp_path / "diffusion.zip", tmp_path / "other.zip"
    with ZipFile(broken, "w") as archive:
        for name in ("card.json", "denoiser.onnx", "decoder.onnx"):
            archive.writestr(name, b"{}")
    other.write_bytes(b"PK nothing")
    asked = ["evaluate", "systems", "--patterns", str(write_patterns(tmp_path)), "--tasks", "text"]
    asked += ["--sewers", "--out", str(tmp_path / "out"), "--generators"]
    assert run([*asked, f"theirs={broken}"]) == 2
    assert "not a latent diffusion of patterns" in capsys.readouterr().err
    assert run([*asked, f"theirs={other}"]) == 2
    assert "not a PatternMaker" in capsys.readouterr().err
    assert run([*asked, f"theirs={tmp_path / 'none.zip'}"]) == 2
    assert "none.zip" in capsys.readouterr().err
