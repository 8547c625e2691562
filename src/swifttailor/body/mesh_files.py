"""Reading a user's own body mesh and bringing it into the package's frame."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.measurements import BodyMeasurements, read_measurements
from swifttailor.body.measuring import measure_body
from swifttailor.body.orientation import oriented_outward
from swifttailor.body.parts import transfer_parts
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.body.body import Body


FORMATS = (".obj", ".ply", ".glb", ".stl")
MAX_FILE_BYTES = 200_000_000
MAX_FACES = 2_000_000
_HEIGHTS = "0.5 to 2.6 m (or 50 to 260 cm, or 500 to 2600 mm)"
_MERGE = 1e-4  # vertices closer than this are one, cm
_OFF_AXIS = 0.02  # of the height: a body closer to the axis than this stays where it is
_HEIGHT_TOLERANCE = 0.05  # between the mesh and a measured height given with it


@dataclass(frozen=True, eq=False)
class ReadBody:
    """What `Body` is made of."""

    name: str
    vertices: Array
    faces: Array
    vertex_part: Array
    measurements: BodyMeasurements


def read_body(path: Path | str, measurements_path: Path | str | None, default: Body) -> ReadBody:
    """Reads a body; see `Body.load`.

    Args:
        path: Mesh.
        measurements_path: Of this body.
        default: The body whose parts are carried over.
    """
    path = Path(path)
    given = read_measurements(measurements_path) if measurements_path is not None else {}
    vertices, faces = _read_mesh(path)
    return fit_body(vertices, faces, given, default, name=path.stem, source=path)


def fit_body(
    vertices: Array,
    faces: Array,
    given: Mapping[str, float],
    default: Body,
    *,
    name: str,
    source: Path | str,
) -> ReadBody:
    """Makes a body from a mesh: in cm, standing on the floor, its parts labelled and its measures taken.

    Args:
        vertices: (N, 3) in metres, centimetres or millimetres, Y up.
        faces: (M, 3) triangles.
        given: Measurements that are known, in cm; the others are measured.
        default: The body whose parts are carried over.
        name: Of the body.
        source: Where it comes from, for messages.

    Raises:
        InputError: It is no body that stands upright and faces +Z.
    """
    path = Path(source)
    _check_upright(vertices, path)
    vertices = vertices * _centimetres(vertices, path)
    vertices, faces = _merged(vertices, faces, path)
    vertices = _placed(vertices)
    _check_facing(vertices, path)
    parts = transfer_parts(vertices, default.vertices, default.vertex_part)
    height = float(vertices[:, 1].max())
    if "height" in given:
        stated = BodyMeasurements.from_mapping(given, default.measurements).height
        if abs(stated - height) > _HEIGHT_TOLERANCE * height:
            raise InputError(
                f"The measurements state a height of {stated:.1f} cm, but '{source}' is {height:.1f} cm "
                "tall. Give the measurements of this very body, in cm."
            )
    BodyMeasurements.from_mapping(given, default.measurements)
    measurements = measure_body(vertices, faces, parts, given)
    return ReadBody(name, vertices, faces, parts, measurements)


def _read_mesh(path: Path) -> tuple[Array, Array]:
    """Vertices (N, 3) in the file's own unit and triangles (M, 3)."""
    if path.suffix.lower() not in FORMATS:
        raise InputError(f"'{path}' is not a body mesh: its ending must be one of {', '.join(FORMATS)}.")
    try:
        size = path.stat().st_size
    except OSError as error:
        raise InputError(f"Cannot read the body '{path}': {error.strerror or error}.") from error
    if not path.is_file():
        raise InputError(f"The body '{path}' is not a file; give an OBJ, PLY, GLB or STL mesh.")
    if size == 0:
        raise InputError(f"The body '{path}' is empty (0 bytes); export the mesh again.")
    if size > MAX_FILE_BYTES:
        raise InputError(
            f"The body '{path}' has {size / 1e6:.0f} MB; at most {MAX_FILE_BYTES / 1e6:.0f} MB are accepted. "
            "Decimate it: 30 000 faces are plenty."
        )
    import trimesh

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with path.open("rb") as file:  # an open file cannot refer to others, such as textures
                kind = path.suffix[1:].lower()
                mesh: Any = trimesh.load_mesh(file, file_type=kind, process=False, skip_materials=True)
            vertices = np.asarray(mesh.vertices, np.float64)
            faces = np.asarray(mesh.faces, np.int64)
    except Exception as error:  # parsers raise anything at all on files that only look like meshes
        raise InputError(
            f"'{path}' cannot be read as {path.suffix[1:].upper()} mesh ({type(error).__name__}: {error}). "
            "Export the body again as a triangle mesh in OBJ, PLY, GLB or STL."
        ) from error
    if vertices.ndim != 2 or vertices.shape[1:] != (3,) or faces.ndim != 2 or faces.shape[1:] != (3,):
        raise InputError(f"'{path}' holds no triangle mesh. Export the body as a mesh with faces.")
    if len(vertices) == 0 or len(faces) == 0:
        raise InputError(
            f"'{path}' holds {len(vertices)} vertices and {len(faces)} faces; a body needs a closed surface. "
            "A point cloud must be meshed first."
        )
    if len(faces) > MAX_FACES:
        raise InputError(
            f"'{path}' has {len(faces)} faces; at most {MAX_FACES} are accepted. "
            "Decimate it: 30 000 are plenty."
        )
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise InputError(f"'{path}' is damaged: faces refer to vertices that do not exist. Export it again.")
    used = np.unique(faces)
    vertices = vertices[used]
    if not np.isfinite(vertices).all():
        bad = int((~np.isfinite(vertices)).any(axis=1).sum())
        raise InputError(f"'{path}' has {bad} vertices that are NaN or infinite. Export it again.")
    return vertices, np.searchsorted(used, faces)


def _check_upright(vertices: Array, path: Path) -> None:
    """Stops when the body does not stand along Y: its depth, the smallest extent, must lie along Z."""
    extent = np.ptp(vertices, axis=0)
    thin = int(extent.argmin())
    if thin == 1:
        raise InputError(
            f"'{path}' is {_size(extent)}: it seems to stand along Z. Y must point up: "
            "rotate it by -90 degrees about X, or choose 'Y up' when exporting."
        )
    if thin == 0:
        raise InputError(
            f"'{path}' is {_size(extent)}: it seems to face along X. "
            "The body must stand along Y and face +Z: rotate it by 90 degrees about Y."
        )
    if extent[0] > 1.25 * extent[1]:
        raise InputError(
            f"'{path}' is {_size(extent)}: it seems to lie on its side. "
            "The body must stand along Y and face +Z."
        )


def _check_facing(vertices: Array, path: Path) -> None:
    """Stops when the body stands on its head or has its back to +Z."""
    height = vertices[:, 1].max()
    near_axis = np.abs(vertices[:, 0]) < 0.04 * height
    if vertices[near_axis, 1].max(initial=0.0) < 0.9 * height:
        raise InputError(
            f"'{path}' has no head above its middle: it seems to be upside down or off balance. "
            "The body must stand along Y, with +Y up, and be left-right symmetric about x = 0."
        )
    foot = vertices[vertices[:, 1] < 0.03 * height, 2]
    shin = vertices[(vertices[:, 1] > 0.06 * height) & (vertices[:, 1] < 0.12 * height), 2]
    if len(foot) and len(shin):
        middle = (shin.min() + shin.max()) / 2
        if middle - foot.min() > 1.5 * (foot.max() - middle):
            raise InputError(f"'{path}' faces -Z (its toes point there). Rotate it by 180 degrees about Y.")


def _centimetres(vertices: Array, path: Path) -> float:
    """Factor from the file's unit to cm, judged by the height."""
    height = float(np.ptp(vertices[:, 1]))
    for factor in (100.0, 1.0, 0.1):
        if 50.0 <= height * factor <= 260.0:
            return factor
    raise InputError(
        f"'{path}' is {height:.4g} units tall along Y; a body must be {_HEIGHTS}. "
        "Scale it, and make sure that Y points up and only the body is in the file."
    )


def _merged(vertices: Array, faces: Array, path: Path) -> tuple[Array, Array]:
    """One vertex per place, no degenerate faces, oriented outward."""
    _, first, index = np.unique(
        np.round(vertices / _MERGE).astype(np.int64), axis=0, return_index=True, return_inverse=True
    )
    faces = index.reshape(-1)[faces]
    vertices = vertices[first]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    if len(faces) == 0:
        raise InputError(f"'{path}' has only degenerate faces (no area). Export the body again.")
    used = np.unique(faces)
    vertices, faces = vertices[used], np.searchsorted(used, faces)
    return vertices, oriented_outward(vertices, faces)


def _placed(vertices: Array) -> Array:
    """Standing on y = 0; the trunk in the middle of x and z, unless it is near enough already.

    Patterns are placed in the frame of the body they were made for, so a small offset stays.
    """
    height = np.ptp(vertices[:, 1])
    level = vertices[:, 1] - vertices[:, 1].min()
    trunk = vertices[(level > 0.5 * height) & (level < 0.6 * height)]
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    if len(trunk):
        middle[2] = (trunk[:, 2].min() + trunk[:, 2].max()) / 2
    off = np.where(np.abs(middle) > _OFF_AXIS * height, middle, 0.0)
    return vertices - [off[0], vertices[:, 1].min(), off[2]]


def _size(extent: Array) -> str:
    """Extents as text."""
    return f"{extent[0]:.4g} wide (x), {extent[1]:.4g} tall (y) and {extent[2]:.4g} deep (z)"
