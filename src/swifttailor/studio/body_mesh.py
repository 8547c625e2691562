"""The mannequin as a mesh file."""

from __future__ import annotations

import numpy as np

from swifttailor.body import Body
from swifttailor.body.mannequin import mannequin
from swifttailor.render.color import BODY, to_linear
from swifttailor.studio.mesh_record import MeshRecord, name_of, pack_mesh, smooth_normals


def body_record(body: Body | None = None) -> MeshRecord:
    """A body as a mannequin, with no hollows filled: cloth lies over it everywhere.

    Args:
        body: The default body when None.
    """
    body = body or Body.default()
    vertices, faces = mannequin(body, np.asarray(body.vertices))
    header = {
        "version": 1,
        "kind": "body",
        "vertices": len(vertices),
        "triangles": len(faces),
        "welded": len(vertices),
        "panels": [],
        "seams": [],
        "edges": [],
        "color": None,
    }
    blocks = {
        "positions": np.asarray(vertices, np.float32),
        "normals": smooth_normals(vertices, faces),
        "weld": np.arange(len(vertices)),
        "triangles": faces,
        "color": np.tile(to_linear(BODY), (len(vertices), 1)),
    }
    data = pack_mesh(header, blocks)
    return MeshRecord(name_of(data), data)
