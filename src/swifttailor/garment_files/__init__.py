"""Garments as files: GLB, OBJ, PLY, STL, USD, and the folder that every command leaves behind."""

from __future__ import annotations

from swifttailor.garment_files.folder import save_folder
from swifttailor.garment_files.folder_reader import load_folder
from swifttailor.garment_files.formats import MESH_ENDINGS, read_garment_mesh, write_garment_mesh
from swifttailor.garment_files.triangle_mesh import TriangleMesh, mesh_of_garment
from swifttailor.garment_files.uv_layout import lay_out_uv

__all__ = [
    "MESH_ENDINGS",
    "TriangleMesh",
    "lay_out_uv",
    "load_folder",
    "mesh_of_garment",
    "read_garment_mesh",
    "save_folder",
    "write_garment_mesh",
]
