"""Trains lie on the floor behind, overskirts are open in front, and layers stay outside of the skirt."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from swifttailor.garment import trim_layers
from swifttailor.garment.garment import Garment
from swifttailor.garment.layer_surfaces import layer_surfaces
from swifttailor.garment.part_looks import PartLook, looks_of_panels
from swifttailor.garment.preview import trim_surfaces
from swifttailor.garment.trim_meshes import trim_meshes
from swifttailor.garment.trim_parts import trim_parts
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims.layers import LAYERS
from swifttailor.pattern.trims.shapes import Layer

NOT_AROUND = frozenset({"train", "long train", "back cape", "outer skirt", "bustle"})
"""Layers that do not hang around a skirt down to its hem."""


@cache
def gown(name: str = "strapless-dress") -> Garment:
    sewer = GarmentSewer.load(Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx")
    return sewer.sew(draft(name))


def with_trims(garment: Garment, *names: str) -> Garment:
    return replace(garment, mesh=replace(garment.mesh, pattern=replace(garment.pattern, trims=names)))


@pytest.mark.parametrize(("trim", "behind"), [("train", 52.0), ("long train", 100.0)])
def test_a_train_lies_on_the_floor_behind(trim, behind):
    garment = with_trims(gown(), trim)
    (train,) = trim_meshes(garment)
    skirt = garment.vertices[garment.vertices[:, 1] < 40.0]
    lying = train.vertices[train.vertices[:, 1] < 3.0]
    assert len(lying) and train.vertices[:, 1].min() >= 0.0
    assert lying[:, 2].min() == pytest.approx(skirt[:, 2].min() - behind, abs=12.0)
    assert np.abs(train.vertices[:, 0]).max() < behind + np.abs(skirt[:, 0]).max()
    assert train.vertices[:, 2].max() < 0.5 * skirt[:, 2].max()  # nothing of it in front


@pytest.mark.parametrize(
    "trim", sorted(LAYERS - {"train", "long train", "back cape", "outer skirt", "bustle"})
)
def test_layers_lie_outside_of_the_skirt(trim):
    garment = with_trims(gown(), trim)
    (layer,) = trim_meshes(garment)
    low = layer.vertices[layer.vertices[:, 1] < np.quantile(layer.vertices[:, 1], 0.2)]
    level = garment.vertices[np.abs(garment.vertices[:, 1] - low[:, 1].mean()) < 4.0]
    assert np.hypot(*low[:, [0, 2]].T).mean() > np.hypot(*level[:, [0, 2]].T).mean()
    in_front = (np.abs(low[:, 0]) < 4.0) & (low[:, 2] > 0.0)
    assert in_front.any() == (trim in ("tulle layers", "peplum", "hoops"))


@pytest.mark.parametrize("trim", sorted(LAYERS))
def test_layers_are_sound_and_face_outward(trim):
    worn_on = {"back cape": "fitted-dress", "outer skirt": "leggings"}
    garment = with_trims(gown(worn_on.get(trim, "strapless-dress")), trim)
    (layer,) = trim_meshes(garment)
    a, b, c = (layer.vertices[layer.faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    assert np.isfinite(layer.vertices).all() and np.linalg.norm(across, axis=1).min() > 1e-6
    outward = (a + b + c) / 3 * (1, 0, 1)
    assert (across * outward).sum() > 0.0
    assert trim_surfaces(garment) == []  # it is drawn as cloth
    (seen,) = layer_surfaces(garment)
    assert (seen.opacity < 1.0) == ("tulle" in trim) == (trim_parts(garment)[0].opacity < 1.0)


def test_a_bustle_is_gathered_up_behind_alone():
    garment = with_trims(gown("fitted-dress"), "bustle")
    (bustle,) = trim_meshes(garment)
    skirt = garment.vertices[garment.vertices[:, 1] < 100.0]
    assert bustle.vertices[:, 2].min() < skirt[:, 2].min() - 6.0
    assert bustle.vertices[:, 2].max() < 0.6 * skirt[:, 2].max()
    behind = bustle.vertices[np.abs(bustle.vertices[:, 0]) < 2.0]
    behind = behind[np.argsort(-behind[:, 1])]
    turns = np.diff(np.sign(np.diff(behind[::2, 2])))
    assert np.count_nonzero(turns) >= 4, "in puffs, one below the other"


def test_a_bow_lies_on_the_layer():
    garment = with_trims(gown(), "tulle layers", "back bow")
    meshes = trim_meshes(garment)
    bow = np.concatenate([mesh.vertices for mesh in meshes if mesh.trim == "back bow"])
    (layer,) = (mesh for mesh in meshes if mesh.trim == "tulle layers")
    for x, y, z in bow[:: len(bow) // 40]:
        near = layer.vertices[np.hypot(layer.vertices[:, 0] - x, layer.vertices[:, 1] - y) < 2.0]
        behind = near[near[:, 2] < 0.0]
        assert not len(behind) or z < behind[:, 2].min() + 3.0


def test_a_skirt_below_tulle_is_opaque():
    looks = (PartLook("skirt", cloth="tulle"),)
    bare = replace(gown(), looks=looks)
    layered = replace(with_trims(gown(), "tulle layers"), looks=looks)
    assert any(look.is_sheer for look in looks_of_panels(bare))
    assert not any(look.is_sheer for look in looks_of_panels(layered))


@pytest.mark.parametrize("name", ["leggings", "swimsuit"])
def test_a_skirt_over_the_legs_hides_them_to_where_they_end(name):
    options = {"length": 46.0, "taper": 0.0} if name == "leggings" else {}
    sewer = GarmentSewer.load(Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx")
    garment = with_trims(sewer.sew(draft(name, **options)), "outer skirt")
    (skirt,) = trim_meshes(garment)
    around = np.hypot(*skirt.vertices[:, [0, 2]].T)
    low = skirt.vertices[:, 1] < np.quantile(skirt.vertices[:, 1], 0.1)
    assert around[low].min() > np.quantile(around[~low], 0.25)  # it falls outward, whatever is cut out below


@pytest.mark.parametrize(("points", "pointed"), [(20.0, True), (3.0, False)])
def test_a_sheer_layer_ends_where_a_pointed_hem_does(monkeypatch, points, pointed):
    around = np.radians(np.arange(0.0, 360.0, 2.0))
    low = 40.0 + points * np.abs(np.sin(3 * around))
    places = np.stack([30.0 * np.sin(around), low, -30.0 * np.cos(around)], axis=1)
    above = places + np.array([0.0, 30.0, 0.0])
    garment = SimpleNamespace(flat_positions=np.concatenate([places, above]))
    monkeypatch.setattr(trim_layers, "around_trunk", lambda _: np.ones(len(places) * 2, bool))
    layer = Layer("tulle layers", "skirt_back", 90.0, 40.0, opacity=0.7)
    ends = trim_layers._ends(garment, layer, np.zeros(2), np.radians(np.linspace(-180.0, 180.0, 91)))
    assert (ends is not None) is pointed
    if ends is not None:
        assert ends.min() == pytest.approx(40.0, abs=1.0) and ends.max() > 55.0
    assert trim_layers._ends(garment, replace(layer, opacity=1.0), np.zeros(2), around) is None


def test_a_skirt_over_shorts_has_no_steps():
    reach = np.repeat([[10.0], [14.0]], 17, axis=0) * np.ones((1, 4))
    even = trim_layers._evened(reach)
    assert np.abs(np.diff(even, axis=0)).max() < 0.5 and (even >= reach - 1e-9).all()
