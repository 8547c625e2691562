"""Engines of others: registered by name, given as an object, offered by an installed package."""

from __future__ import annotations

from importlib import metadata

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.draping import Engine, Settled, drape, engines, register_engine
from swifttailor.draping.engines import ENTRY_POINTS, engine_names, find_engine
from swifttailor.draping.simulation import SimulationSettings
from swifttailor.errors import InputError, SimulationError
from swifttailor.pattern.drafts import draft

QUICK = SimulationSettings(max_frames=3)


class Stiff:
    """Somebody's engine: cloth like sheet metal, pushed out of the body where it was sewn."""

    def settle(self, sewn, progress):
        positions = sewn.positions
        distance, _ = sewn.body.signed_distance(positions)
        outward = positions * [1.0, 0.0, 1.0]
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        progress("draping", 1.0)
        return Settled(positions - np.minimum(distance, 0.0)[:, None] * outward, frames=1, static=True)


@pytest.fixture
def registry(monkeypatch):
    """Forgets afterwards what a test registers."""
    monkeypatch.setattr(engines, "_MAKERS", dict(engines._MAKERS))


@pytest.fixture(scope="module")
def skirt():
    return draft("fitted-skirt")


def test_a_registered_engine_brings_the_garment_to_rest(registry, skirt):
    register_engine("stiff", Stiff)
    assert engine_names()[:3] == ("xpbd", "newton", "stiff")
    stages = []
    say = lambda stage, share: stages.append(stage)  # noqa: E731
    garment = drape(skirt, engine="stiff", edge_length=6.0, settings=QUICK, progress=say)
    assert garment.report["engine"] == "stiff" and garment.report["quality"]["frames"] == 1
    assert "draping" in stages
    given = drape(skirt, engine=Stiff(), edge_length=6.0, settings=QUICK)
    assert given.report["engine"] == "Stiff"
    assert np.array_equal(given.vertices, garment.vertices)


def test_a_body_of_ones_own_made_of_arrays(skirt):
    """As `Body.load` reads a file: part labels and measurements are found on the mesh."""
    ours = Body.default()
    taller = Body.from_mesh(ours.vertices * 1.1, ours.faces, name="taller")
    assert taller.measurements.height == pytest.approx(1.1 * ours.vertices[:, 1].max(), rel=1e-3)
    assert taller.measurements.waist == pytest.approx(1.1 * ours.measurements.waist, rel=0.03)
    parts = [np.bincount(body.vertex_part, minlength=8) / len(body.vertices) for body in (ours, taller)]
    assert np.abs(parts[0] - parts[1]).max() < 0.01
    garment = drape(skirt, body=taller, engine=Stiff(), edge_length=6.0, settings=QUICK)
    assert garment.report["body"] == "taller"


def test_the_engine_of_an_installed_package(registry, monkeypatch):
    point = metadata.EntryPoint("theirs", f"{__name__}:Stiff", ENTRY_POINTS)
    monkeypatch.setattr(engines, "_entry_points", lambda: iter([point]))
    assert "theirs" in engine_names()
    assert isinstance(find_engine("theirs"), Engine)
    none = metadata.EntryPoint("none", "builtins:dict", ENTRY_POINTS)
    monkeypatch.setattr(engines, "_entry_points", lambda: iter([none]))
    with pytest.raises(InputError, match="without a method 'settle'"):
        find_engine("none")


def test_names_are_given_once_and_must_be_known(registry, skirt):
    register_engine("stiff", Stiff)
    with pytest.raises(InputError, match=r"'stiff' already\. Known engines: xpbd, newton, stiff"):
        register_engine("stiff", Stiff)
    with pytest.raises(InputError, match=r"no engine 'soft'\. Known engines: xpbd, newton, stiff"):
        drape(skirt, engine="soft")


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (lambda p: p[:-1], r"positions of shape \(\d+, 3\); \(\d+, 3\) is expected"),
        (lambda p: p * np.nan, "infinity"),
    ],
)
def test_what_an_engine_returns_is_checked(skirt, wrong, says):
    class Broken:
        def settle(self, sewn, progress):
            return Settled(wrong(sewn.positions), frames=1, static=True)

    with pytest.raises(SimulationError, match=says):
        drape(skirt, engine=Broken(), edge_length=6.0, settings=QUICK)
