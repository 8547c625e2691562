"""Reader of Universal Scene Description. Needs usd-core."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.seam_names import read_seam_name
from swifttailor.garment.triangle_mesh import TriangleMesh
from swifttailor.garment.units import CM_PER_METRE
from swifttailor.garment.usd import WEARER
from swifttailor.garment.usd_library import load_usd


def read_usd(path: Path) -> TriangleMesh:
    """Reads all meshes of a USD stage; face subsets, or else mesh names, become groups."""
    pxr = load_usd("Reading USD")
    Usd, UsdGeom = pxr.Usd, pxr.UsdGeom
    stage = Usd.Stage.Open(str(path))
    scale = UsdGeom.GetStageMetersPerUnit(stage) * CM_PER_METRE
    cache = UsdGeom.XformCache()
    vertices, faces, uv, uv_faces, groups, face_group = [], [], [], [], [], []
    lines: list[Array] = []
    names: list[str] = []
    before = uv_before = 0
    for prim in stage.Traverse():
        if not prim.IsA(UsdGeom.Mesh) or prim.GetCustomDataByKey(WEARER):
            continue
        cloth = UsdGeom.Mesh(prim)
        points = np.asarray(cloth.GetPointsAttr().Get() or [], np.float64).reshape(-1, 3)
        corner = np.asarray(cloth.GetFaceVertexIndicesAttr().Get() or [], np.int64)
        counts = np.asarray(cloth.GetFaceVertexCountsAttr().Get() or [], np.int64)
        if counts.sum() != len(corner) or (len(counts) and counts.min() < 3):
            raise ValueError("the face counts do not fit the face indices")
        matrix = np.asarray(cache.GetLocalToWorldTransform(prim))
        vertices.append((points @ matrix[:3, :3] + matrix[3, :3]) * scale)
        fan, polygon = _fan(counts)
        faces.append(corner[fan] + before)
        st = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
        if st and st.HasValue() and st.GetInterpolation() == UsdGeom.Tokens.faceVarying:
            values = np.asarray(st.Get(), np.float64).reshape(-1, 2)
            index = np.asarray(st.GetIndices() if st.IsIndexed() else np.arange(len(values)), np.int64)
            uv.append(values)
            uv_faces.append(index[fan] + uv_before)
            uv_before += len(values)
        of_face = np.full(len(counts), -1)
        for subset in UsdGeom.Subset.GetAllGeomSubsets(cloth):
            of_face[np.asarray(subset.GetIndicesAttr().Get() or [], np.int64)] = len(groups)
            groups.append(subset.GetPrim().GetDisplayName() or subset.GetPrim().GetName())
        if (of_face < 0).any():
            of_face[of_face < 0] = len(groups)
            groups.append(prim.GetName())
        face_group.append(of_face[polygon])
        before += len(points)
    if not faces or not sum(map(len, faces)):
        raise ValueError("it holds no mesh")
    textured = len(uv) == len(faces)
    for prim in stage.Traverse():
        at = UsdGeom.PrimvarsAPI(prim).GetPrimvar("meshVertex") if prim.IsA(UsdGeom.BasisCurves) else None
        if at and at.HasValue() and len(faces) == 1:
            sizes = np.asarray(UsdGeom.BasisCurves(prim).GetCurveVertexCountsAttr().Get(), np.int64)
            lines += np.split(np.asarray(at.Get(), np.int64), np.cumsum(sizes)[:-1])
            names += [prim.GetDisplayName() or prim.GetName()] * len(sizes)
    return TriangleMesh(
        np.concatenate(vertices),
        np.concatenate(faces),
        np.concatenate(uv) if textured else None,
        np.concatenate(uv_faces) if textured else None,
        tuple(groups),
        np.concatenate(face_group),
        tuple(lines),
        line_names=tuple(names) if len(names) == len(lines) and any(map(read_seam_name, names)) else (),
    )


def _fan(counts: Array) -> tuple[Array, Array]:
    """Triangles of polygons with `counts` corners: positions (m, 3) in the corner list, and polygons (m,)."""
    start = np.cumsum(counts) - counts
    polygon = np.repeat(np.arange(len(counts)), counts - 2)
    step = np.arange(len(polygon)) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2)
    first = start[polygon]
    return np.stack([first, first + step + 1, first + step + 2], axis=1), polygon
