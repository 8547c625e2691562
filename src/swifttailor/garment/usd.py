"""Universal Scene Description: one stitched mesh with a subset per panel, in metres. Needs usd-core."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.errors import InputError
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import CM_PER_METRE, to_metres
from swifttailor.garment.usd_library import load_usd
from swifttailor.render.color import to_linear

ENDINGS = (".usd", ".usda", ".usdc", ".usdz")


def write_usd(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as USD; the ending chooses text (.usda), binary (.usdc, .usd) or package (.usdz).

    ``/garment/cloth`` is a polygon mesh over the stitched vertices with face-varying ``primvars:st`` and a
    ``materialBind`` subset per panel; ``/garment/seams`` are linear curves. Metres, Y up.

    Raises:
        MissingExtraError: usd-core is not installed.
        InputError: The file cannot be written.
    """
    path = Path(path)
    pxr = load_usd("Writing USD")
    stage = _stage(pxr, mesh)

    def write(temporary: Path) -> None:
        if path.suffix.lower() != ".usdz":
            _export(pxr, stage, temporary)
            return
        with tempfile.TemporaryDirectory() as folder:
            layer = Path(folder) / "garment.usdc"
            _export(pxr, stage, layer)
            if not pxr.UsdUtils.CreateNewUsdzPackage(str(layer), str(temporary)):
                raise InputError(f"Cannot write '{path}': USD could not make the package.")

    return write_atomically(path, write, overwrite=overwrite)


def _stage(pxr: Any, mesh: TriangleMesh) -> Any:
    Gf, Sdf, Tf, Usd = pxr.Gf, pxr.Sdf, pxr.Tf, pxr.Usd
    UsdGeom, UsdShade, Vt = pxr.UsdGeom, pxr.UsdShade, pxr.Vt
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    root = UsdGeom.Xform.Define(stage, "/garment")
    stage.SetDefaultPrim(root.GetPrim())

    points = to_metres(mesh.vertices).astype(np.float32)
    cloth = UsdGeom.Mesh.Define(stage, "/garment/cloth")
    cloth.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    cloth.CreateDoubleSidedAttr(True)
    cloth.CreateOrientationAttr(UsdGeom.Tokens.rightHanded)
    cloth.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
    cloth.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(mesh.faces), 3, np.int32)))
    cloth.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(mesh.faces.ravel().astype(np.int32)))
    cloth.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(mesh.vertex_normals.astype(np.float32)))
    cloth.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    if len(points):
        corners = [Gf.Vec3f(*map(float, point)) for point in (points.min(axis=0), points.max(axis=0))]
        cloth.CreateExtentAttr(Vt.Vec3fArray(corners))
    if mesh.uv is not None and mesh.uv_faces is not None:
        st = UsdGeom.PrimvarsAPI(cloth).CreatePrimvar(
            "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.faceVarying
        )
        st.Set(Vt.Vec2fArray.FromNumpy(mesh.uv.astype(np.float32)))
        st.SetIndices(Vt.IntArray.FromNumpy(mesh.uv_faces.ravel().astype(np.int32)))

    material = _material(pxr, stage, mesh.color)
    UsdShade.MaterialBindingAPI.Apply(cloth.GetPrim()).Bind(material)
    taken: set[str] = set()
    for k, name in enumerate(mesh.groups):
        safe = base = Tf.MakeValidIdentifier(name)
        number = 2
        while safe in taken:
            safe, number = f"{base}_{number}", number + 1
        taken.add(safe)
        faces = np.flatnonzero(mesh.face_group == k).astype(np.int32)
        subset = UsdGeom.Subset.CreateGeomSubset(
            cloth, safe, UsdGeom.Tokens.face, Vt.IntArray.FromNumpy(faces), UsdShade.Tokens.materialBind
        )
        subset.GetPrim().SetDisplayName(name)
        UsdShade.MaterialBindingAPI.Apply(subset.GetPrim()).Bind(material)
    if mesh.groups:
        UsdShade.MaterialBindingAPI(cloth).SetMaterialBindSubsetsFamilyType(UsdGeom.Tokens.partition)

    seams = [line for line in mesh.lines if len(line) > 1]
    if seams:
        curves = UsdGeom.BasisCurves.Define(stage, "/garment/seams")
        curves.CreateTypeAttr(UsdGeom.Tokens.linear)
        curves.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points[np.concatenate(seams)]))
        curves.CreateCurveVertexCountsAttr(Vt.IntArray([len(line) for line in seams]))
        curves.CreateWidthsAttr(Vt.FloatArray([0.1 / CM_PER_METRE]))
        curves.SetWidthsInterpolation(UsdGeom.Tokens.constant)
        # The curve points as vertices of the mesh, so that readers can join them again.
        at = UsdGeom.PrimvarsAPI(curves).CreatePrimvar(
            "meshVertex", Sdf.ValueTypeNames.IntArray, UsdGeom.Tokens.vertex
        )
        at.Set(Vt.IntArray.FromNumpy(np.concatenate(seams).astype(np.int32)))
    return stage


def _material(pxr: Any, stage: Any, color: str) -> Any:
    Gf, Sdf, UsdShade = pxr.Gf, pxr.Sdf, pxr.UsdShade
    material = UsdShade.Material.Define(stage, "/garment/materials/cloth")
    shader = UsdShade.Shader.Define(stage, "/garment/materials/cloth/surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(Gf.Vec3f(*to_linear(color).tolist()))
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(0.85)
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    return material


def _export(pxr: Any, stage: Any, path: Path) -> None:
    try:
        if not stage.GetRootLayer().Export(str(path)):
            raise InputError(f"Cannot write '{path}': USD refused the file.")
    except pxr.Tf.ErrorException as error:
        raise InputError(f"Cannot write '{path}': {error}") from error
