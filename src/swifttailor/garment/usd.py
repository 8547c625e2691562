"""Universal Scene Description: one stitched mesh with a subset per panel, in metres. Needs usd-core."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.atomic_files import NO_ROOM, write_atomically
from swifttailor.errors import InputError
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import CM_PER_METRE, to_metres
from swifttailor.garment.usd_library import load_usd
from swifttailor.render.color import BODY, to_linear

ENDINGS = (".usd", ".usda", ".usdc", ".usdz")
WEARER = "swifttailorBody"
"""Custom data of the mesh that is no cloth."""
_PRINT_FILE = "print.png"
_LONGEST_REASON = 300


def write_usd(mesh: TriangleMesh, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes a mesh as USD; the ending chooses text (.usda), binary (.usdc, .usd) or package (.usdz).

    ``/garment/cloth`` is a polygon mesh over the stitched vertices with face-varying ``primvars:st`` and a
    ``materialBind`` subset per panel; below ``/garment/seams`` is a linear curve per seam, with the seam's
    name for display; parts that look otherwise have materials of their own, lace one of its mean opacity; a
    print repeats by ``primvars:repeats``; the wearer is ``/garment/body``. Metres, Y up.

    Raises:
        MissingExtraError: usd-core is not installed.
        InputError: The file cannot be written, or is to hold a print and is no package.
    """
    path = Path(path)
    if mesh.print is not None and path.suffix.lower() != ".usdz":
        raise InputError(f"'{path.name}' cannot hold the picture of a print. Write a .usdz or .glb file.")
    pxr = load_usd("Writing USD")
    stage = _stage(pxr, mesh)

    def write(temporary: Path) -> None:
        if path.suffix.lower() != ".usdz":
            _export(pxr, stage, temporary)
            return
        with tempfile.TemporaryDirectory() as folder:
            layer = Path(folder) / "garment.usdc"
            if mesh.print is not None:
                (Path(folder) / _PRINT_FILE).write_bytes(mesh.print.png)
            _export(pxr, stage, layer)
            with _said_briefly(pxr, path):
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

    if mesh.print is not None and mesh.print.repeats is not None and mesh.uv_faces is not None:
        repeats = UsdGeom.PrimvarsAPI(cloth).CreatePrimvar(
            "repeats", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.faceVarying
        )
        repeats.Set(Vt.Vec2fArray.FromNumpy(mesh.print.repeats.astype(np.float32)))
        repeats.SetIndices(Vt.IntArray.FromNumpy(mesh.uv_faces.ravel().astype(np.int32)))

    material = _material(pxr, stage, "cloth", mesh.color)
    if mesh.print is not None:
        surface = UsdShade.Shader(stage.GetPrimAtPath("/garment/materials/cloth/surface"))
        _print(pxr, stage, surface, "st" if mesh.print.repeats is None else "repeats")
    UsdShade.MaterialBindingAPI.Apply(cloth.GetPrim()).Bind(material)
    looks = list(dict.fromkeys([look for look in mesh.looks if look is not None]))
    others = {
        look: _material(pxr, stage, f"cloth_{k + 2}", look.color, look.opacity)
        for k, look in enumerate(looks)
    }
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
        look = mesh.looks[k] if mesh.looks else None
        UsdShade.MaterialBindingAPI.Apply(subset.GetPrim()).Bind(material if look is None else others[look])
    if mesh.groups:
        UsdShade.MaterialBindingAPI(cloth).SetMaterialBindSubsetsFamilyType(UsdGeom.Tokens.partition)

    _seams(pxr, stage, mesh, points)
    if mesh.wearer is not None:
        _wearer(pxr, stage, *mesh.wearer)
    return stage


def _seams(pxr: Any, stage: Any, mesh: TriangleMesh, points: Array) -> None:
    """A curve for each seam, named after it."""
    Sdf, UsdGeom, Vt = pxr.Sdf, pxr.UsdGeom, pxr.Vt
    lines = [(k, line) for k, line in enumerate(mesh.lines) if len(line) > 1]
    if lines:
        UsdGeom.Scope.Define(stage, "/garment/seams")
    for k, line in lines:
        curve = UsdGeom.BasisCurves.Define(stage, f"/garment/seams/seam_{k:03d}")
        curve.CreateTypeAttr(UsdGeom.Tokens.linear)
        curve.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points[line]))
        curve.CreateCurveVertexCountsAttr(Vt.IntArray([len(line)]))
        curve.CreateWidthsAttr(Vt.FloatArray([0.1 / CM_PER_METRE]))
        curve.SetWidthsInterpolation(UsdGeom.Tokens.constant)
        if mesh.line_names:
            curve.GetPrim().SetDisplayName(mesh.line_names[k])
        # The curve points as vertices of the mesh, so that readers can join them again.
        at = UsdGeom.PrimvarsAPI(curve).CreatePrimvar(
            "meshVertex", Sdf.ValueTypeNames.IntArray, UsdGeom.Tokens.vertex
        )
        at.Set(Vt.IntArray.FromNumpy(line.astype(np.int32)))


def _wearer(pxr: Any, stage: Any, vertices: Array, faces: Array) -> None:
    UsdGeom, Vt = pxr.UsdGeom, pxr.Vt
    mesh = TriangleMesh(vertices, faces)
    body = UsdGeom.Mesh.Define(stage, "/garment/body")
    body.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    body.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(to_metres(mesh.vertices).astype(np.float32)))
    body.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(mesh.faces), 3, np.int32)))
    body.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(mesh.faces.ravel().astype(np.int32)))
    body.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(mesh.vertex_normals.astype(np.float32)))
    body.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    body.GetPrim().SetCustomDataByKey(WEARER, True)
    pxr.UsdShade.MaterialBindingAPI.Apply(body.GetPrim()).Bind(_material(pxr, stage, "body", BODY))


def _print(pxr: Any, stage: Any, shader: Any, coordinates: str) -> None:
    """The picture on the cloth, by the texture coordinates of that name."""
    Sdf, UsdShade = pxr.Sdf, pxr.UsdShade
    reader = UsdShade.Shader.Define(stage, "/garment/materials/cloth/coordinates")
    reader.CreateIdAttr("UsdPrimvarReader_float2")
    reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set(coordinates)
    reader.CreateOutput("result", Sdf.ValueTypeNames.Float2)
    texture = UsdShade.Shader.Define(stage, "/garment/materials/cloth/print")
    texture.CreateIdAttr("UsdUVTexture")
    texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(_PRINT_FILE)
    texture.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(reader.ConnectableAPI(), "result")
    for wrap in ("wrapS", "wrapT"):
        texture.CreateInput(wrap, Sdf.ValueTypeNames.Token).Set("repeat")
    texture.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
    shader.GetInput("diffuseColor").ConnectToSource(texture.ConnectableAPI(), "rgb")


def _material(pxr: Any, stage: Any, name: str, color: str, opacity: float = 1.0) -> Any:
    Gf, Sdf, UsdShade = pxr.Gf, pxr.Sdf, pxr.UsdShade
    material = UsdShade.Material.Define(stage, f"/garment/materials/{name}")
    shader = UsdShade.Shader.Define(stage, f"/garment/materials/{name}/surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(Gf.Vec3f(*to_linear(color).tolist()))
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(0.85)
    if opacity < 1.0:
        shader.CreateInput("opacity", Sdf.ValueTypeNames.Float).Set(opacity)
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    return material


def _export(pxr: Any, stage: Any, path: Path) -> None:
    with _said_briefly(pxr, path):
        if not stage.GetRootLayer().Export(str(path)):
            raise InputError(f"Cannot write '{path}': USD refused the file.")


@contextmanager
def _said_briefly(pxr: Any, path: Path) -> Generator[None]:
    """Tells a full disk from other troubles; USD repeats each for every block that it cannot write."""
    try:
        yield
    except pxr.Tf.ErrorException as error:
        said = str(error)
        for number in NO_ROOM:
            if os.strerror(number) in said:
                raise OSError(number, os.strerror(number)) from error
        raise InputError(f"Cannot write '{path}': {' '.join(said.split())[:_LONGEST_REASON]}") from error
