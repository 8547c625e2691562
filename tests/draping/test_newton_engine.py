"""The second engine: Newton's Style3D for the last stage of a drape."""

from __future__ import annotations

import importlib.util
import subprocess
import sys

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.draping import drape
from swifttailor.draping.cloth import build_cloth
from swifttailor.draping.known_fabrics import get_fabric
from swifttailor.draping.newton_engine import require_newton
from swifttailor.draping.newton_stage import rest_triangles
from swifttailor.errors import MissingExtraError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft

needs_newton = pytest.mark.skipif(
    importlib.util.find_spec("newton") is None,
    reason="Newton is not installed: pip install 'swifttailor[newton]'",
)


@pytest.fixture(scope="module")
def tank_top() -> Garment:
    return drape(draft("tank-top"), edge_length=4.0, engine="newton")


@needs_newton
@pytest.mark.timeout(600)  # the first run on a machine compiles Newton's kernels
class TestTankTop:
    def test_hangs_at_rest_on_the_body(self, tank_top: Garment) -> None:
        quality = tank_top.report["quality"]
        assert np.isfinite(tank_top.vertices).all()
        assert quality["static"]
        assert not quality["reasons"]
        assert tank_top.report["engine"] == "newton"

    def test_no_vertex_is_deep_in_the_body(self, tank_top: Garment) -> None:
        distance, _ = Body.default().signed_distance(tank_top.vertices)
        assert distance.min() > -0.5

    def test_cloth_is_hardly_strained(self, tank_top: Garment) -> None:
        quality = tank_top.report["quality"]
        assert 0 < quality["strain_p50"] < 0.01
        assert quality["strain_p95"] < 0.06

    def test_seams_stay_closed(self, tank_top: Garment) -> None:
        assert tank_top.report["quality"]["seam_gap_max_cm"] == 0

    def test_lies_where_xpbd_puts_it(self, tank_top: Garment) -> None:
        other = drape(tank_top.pattern, edge_length=4.0)
        assert np.linalg.norm(other.vertices - tank_top.vertices, axis=1).mean() < 1.0

    def test_same_every_time(self, tank_top: Garment) -> None:
        import warp

        if not warp.get_device().is_cpu:
            pytest.skip("GPUs add up in any order")
        again = drape(tank_top.pattern, edge_length=4.0, engine="newton")
        assert (again.vertices == tank_top.vertices).all()


@needs_newton
@pytest.mark.timeout(600)
class TestSkirt:
    def test_is_held_at_the_waist_and_passes_the_hands(self) -> None:
        skirt = drape(draft("circle-skirt"), edge_length=5.0, engine="newton")
        quality = skirt.report["quality"]
        waist = Body.default().measurements.waist_level
        assert quality["static"], quality
        assert quality["penetrating_fraction"] == 0
        assert skirt.vertices[:, 1].max() > waist - 4


@needs_newton
def test_progress_reaches_the_end_and_never_goes_back() -> None:
    shares: list[float] = []
    drape(
        draft("tank-top"),
        edge_length=6.0,
        engine="newton",
        progress=lambda stage, share: shares.append(share) if stage == "draping" else None,
    )
    assert shares == sorted(shares)
    assert shares[-1] == 1


@needs_newton
def test_nothing_lands_on_stdout() -> None:
    code = (
        "from swifttailor.draping import drape\n"
        "from swifttailor.pattern.drafts import draft\n"
        "drape(draft('tank-top'), edge_length=8.0, engine='newton')\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == ""


def test_missing_newton_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "newton", None)
    with pytest.raises(MissingExtraError, match=r"The newton engine needs .*swifttailor\[newton\]"):
        require_newton()
    with pytest.raises(MissingExtraError):
        drape(draft("tank-top"), engine="newton")


def test_missing_warp_says_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "warp", None)
    with pytest.raises(MissingExtraError, match=r"swifttailor\[newton\]"):
        require_newton()


class TestRestTriangles:
    @pytest.mark.parametrize("name", ["fitted-dress", "gathered-skirt"])
    def test_sides_have_the_rest_lengths_of_the_cloth(self, name: str) -> None:
        mesh = mesh_pattern(draft(name).canonical(), 4.0)
        cloth = build_cloth(mesh, get_fabric("cotton"))
        shapes, sliver = rest_triangles(mesh, cloth)
        length = np.linalg.norm(np.roll(shapes, -1, axis=1) - shapes, axis=2)
        wanted = {
            frozenset(e): r for e, r in zip(cloth.arrays.edges.tolist(), cloth.arrays.rest, strict=True)
        }
        expected = np.array(
            [[wanted[frozenset((f[k], f[k - 2]))] for k in range(3)] for f in mesh.faces.tolist()]
        )
        as_wanted = np.isclose(length, expected, rtol=1e-6).all(axis=1)
        assert as_wanted[~sliver].mean() > 0.98

    def test_every_triangle_turns_anticlockwise(self) -> None:
        mesh = mesh_pattern(draft("t-shirt").canonical(), 4.0)
        shapes, _ = rest_triangles(mesh, build_cloth(mesh, get_fabric("cotton")))
        u, w = shapes[:, 1] - shapes[:, 0], shapes[:, 2] - shapes[:, 0]
        assert (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0] > 0).all()
