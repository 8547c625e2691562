from __future__ import annotations

import builtins
import sys

import numpy as np
import pytest
from sewn_tube import component_count, tube_garment

from swifttailor.errors import MissingExtraError
from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh
from swifttailor.garment.seam_names import seam_names
from swifttailor.garment.triangle_mesh import mesh_of_garment

pxr = pytest.importorskip("pxr")


@pytest.mark.parametrize("ending", [".usd", ".usda", ".usdc", ".usdz"])
def test_usd_reads_back(tube, tube_mesh, tmp_path, ending):
    back = read_garment_mesh(write_garment_mesh(tube_mesh, tmp_path / f"tube{ending}"))
    np.testing.assert_allclose(back.vertices, tube.vertices, atol=1e-4)
    np.testing.assert_array_equal(back.faces, tube.faces)
    np.testing.assert_array_equal(back.uv_faces, tube.mesh.flat_faces)
    np.testing.assert_allclose(back.uv, tube.uv, atol=1e-6)
    np.testing.assert_array_equal(back.face_group, tube.mesh.face_panel)
    assert back.groups == ("front", "back")
    assert [line.tolist() for line in back.lines] == [s.vertices.tolist() for s in tube.seams]
    assert component_count(back.faces) == 1


def test_stage_states_its_units_and_parts(tube, tube_mesh, tmp_path):
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.Open(str(write_garment_mesh(tube_mesh, tmp_path / "tube.usda")))
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert stage.GetDefaultPrim().GetPath() == "/garment"
    cloth = UsdGeom.Mesh(stage.GetPrimAtPath("/garment/cloth"))
    np.testing.assert_allclose(cloth.GetPointsAttr().Get(), tube.vertices / 100, atol=1e-6)
    assert cloth.GetSubdivisionSchemeAttr().Get() == "none"
    st = UsdGeom.PrimvarsAPI(cloth).GetPrimvar("st")
    assert st.GetInterpolation() == "faceVarying"
    valid, reason = UsdGeom.Subset.ValidateFamily(cloth, UsdGeom.Tokens.face, "materialBind")
    assert valid, reason
    for subset in UsdGeom.Subset.GetAllGeomSubsets(cloth):
        k = ["front", "back"].index(subset.GetPrim().GetName())
        expected = np.flatnonzero(tube.mesh.face_panel == k)
        np.testing.assert_array_equal(subset.GetIndicesAttr().Get(), expected)
    curves = [UsdGeom.BasisCurves(prim) for prim in stage.GetPrimAtPath("/garment/seams").GetChildren()]
    assert [c.GetCurveVertexCountsAttr().Get()[0] for c in curves] == [len(s.vertices) for s in tube.seams]
    assert [c.GetPrim().GetDisplayName() for c in curves] == list(seam_names(tube.pattern))


@pytest.mark.parametrize("ending", [".usda", ".usdc"])
def test_bytes_are_the_same_every_time(tmp_path, ending):
    files = [
        write_garment_mesh(mesh_of_garment(tube_garment()), tmp_path / f"{k}{ending}").read_bytes()
        for k in range(2)
    ]
    assert files[0] == files[1]


def test_names_become_identifiers_and_stay_readable(tmp_path):
    mesh = mesh_of_garment(tube_garment(front="a b", back="a-b"))
    assert read_garment_mesh(write_garment_mesh(mesh, tmp_path / "n.usda")).groups == ("a b", "a-b")


def test_missing_extra_is_named(tube_mesh, tmp_path, monkeypatch):
    real = builtins.__import__

    def refuse(name, *args, **kwargs):
        if name.partition(".")[0] == "pxr":
            raise ImportError(name)
        return real(name, *args, **kwargs)

    for module in [m for m in sys.modules if m.partition(".")[0] == "pxr"]:
        monkeypatch.setitem(sys.modules, module, None)
    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(MissingExtraError, match=r"swifttailor\[usd\]"):
        write_garment_mesh(tube_mesh, tmp_path / "tube.usd")
    assert not list(tmp_path.iterdir())
