"""Meshes: of garments, of bodies, with a garment's folder and a body's measurements."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.mutation.mesh_mutations import mutate_mesh
from fuzzing.mutation.panel_mutations import mutate_pattern
from fuzzing.target import Feed, File, Target


def mesh_seeds() -> Sequence[File]:
    """A skirt and a tetrahedron in every format that needs no further package."""
    return _meshes((".obj", ".glb", ".ply", ".stl"))


def usd_seeds() -> Sequence[File]:
    """A skirt and a tetrahedron as USD."""
    return _meshes((".usda", ".usdc", ".usdz"))


def _meshes(endings: tuple[str, ...]) -> Sequence[File]:
    from swifttailor.garment.triangle_mesh import TriangleMesh, mesh_of_garment

    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    tetrahedron = TriangleMesh(corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
    return [_as(mesh, ending) for mesh in (mesh_of_garment(_skirt()), tetrahedron) for ending in endings]


@cache
def _skirt() -> Any:
    """A skirt where its panels are placed."""
    from swifttailor.draping.placement import place_vertices
    from swifttailor.garment import Garment
    from swifttailor.panel_mesh import mesh_pattern
    from swifttailor.pattern.drafts import draft

    mesh = mesh_pattern(draft("fitted-skirt").canonical(), 10.0)
    return Garment(mesh, place_vertices(mesh), {"edge_length_cm": 10.0, "rotation": "intrinsic"})


def _as(mesh: Any, ending: str) -> File:
    from swifttailor.garment.formats import write_garment_mesh

    with tempfile.TemporaryDirectory() as folder:
        return File(write_garment_mesh(mesh, Path(folder) / f"mesh{ending}").read_bytes(), ending)


def body_seeds() -> Sequence[File]:
    """The default body, coarse."""
    from swifttailor.body import Body
    from swifttailor.garment.triangle_mesh import TriangleMesh

    body = Body.default()
    _, first, index = np.unique(np.round(body.vertices / 4.0), axis=0, return_index=True, return_inverse=True)
    faces = index.ravel()[body.faces]
    a, b, c = faces.T
    mesh = TriangleMesh(body.vertices[first], faces[(a != b) & (b != c) & (c != a)])
    return [_as(mesh, ending) for ending in (".obj", ".glb", ".ply", ".stl")]


def measurement_seeds() -> Sequence[File]:
    """The default body's measurements."""
    from swifttailor.body import Body

    values = {name: round(value, 3) for name, value in Body.default().measurements.as_dict().items()}
    text = "body:\n" + "".join(f"  {name}: {value}\n" for name, value in values.items())
    return [File(text.encode(), ".yaml"), File(json.dumps({"body": values}).encode(), ".json")]


def folder_seeds() -> Sequence[File]:
    """The files that make the folder of a garment; each is damaged while the others are sound."""
    with tempfile.TemporaryDirectory() as folder:
        _skirt().save(Path(folder), preview=False)
        return [File((Path(folder) / name).read_bytes(), f"-{name}") for name in _OF_A_FOLDER]


def mutate(file: File, random: Random) -> bytes:
    """Damage to lines, headers, numbers or bytes."""
    return mutate_mesh(file.data, file.ending, random)


def mutate_measurements(file: File, random: Random) -> bytes:
    """Damage to JSON, to lines of YAML, or to the bytes."""
    if file.ending == ".json" and random.random() < 0.8:
        return written(mutate_json(json.loads(file.data), random), random)
    lines = file.data.decode().split("\n")
    for _ in range(random.randint(1, 3)):
        k = random.randrange(len(lines))
        name = lines[k].partition(":")[0]
        if random.random() < 0.3:
            lines[k] = random.choice(_YAML)
        else:
            lines[k] = f"{name}: {random.choice(_YAML_VALUES)}"
    data = "\n".join(lines).encode()
    return mutate_bytes(data, random, 3) if random.random() < 0.3 else data


def mutate_folder(file: File, random: Random) -> bytes:
    """Damage to one file of the folder."""
    if file.ending.endswith(".obj"):
        return mutate_mesh(file.data, ".obj", random)
    if random.random() < 0.15:
        return mutate_bytes(file.data, random)
    value = json.loads(file.data)
    if file.ending.endswith("pattern.json") and random.random() < 0.6:
        value = mutate_pattern(value, random)
    else:
        value = mutate_json(value, random)
    return written(value, random)


_OF_A_FOLDER = ("report.json", "pattern.json", "garment.obj")
_YAML_VALUES = (
    "0", "-1", "1e9", ".nan", ".inf", "-.inf", "null", "true", "text", "'84'", "[1, 2]", "{a: 1}", "1_000",
    "0x10", "2024-01-01", "!!python/object/apply:os.system [ls]", "&a [*a]", "*a", "190:20:30",
    "9" * 5000, "1e400", "|",
    "? x",
)  # fmt: skip
_YAML = (
    "a: &a [x,x,x,x,x,x,x,x,x]", "b: &b [*a,*a,*a,*a,*a,*a,*a,*a]",
    "c: &c [*b,*b,*b,*b,*b,*b,*b,*b]", "body: *c",
    "body:", "<<: *a", "\t- x", "---", "...", "%YAML 9.9", "- " * 500, "{" * 500, "[" * 5000,
    "height: 172", "waist: [[[",
    "? [a]", "!!set",
)  # fmt: skip


def _load_meshes() -> Feed:
    from swifttailor.garment.formats import read_garment_mesh, write_garment_mesh

    def feed(path: Path) -> None:
        mesh = read_garment_mesh(path)
        write_garment_mesh(mesh, path.with_name("written.glb"), overwrite=True)

    return feed


def _load_bodies() -> Feed:
    from swifttailor.body import Body

    def feed(path: Path) -> None:
        Body.load(path)

    return feed


def _load_measurements() -> Feed:
    from swifttailor.body.body import Body
    from swifttailor.body.measurements import BodyMeasurements, read_measurements

    usual = Body.default().measurements

    def feed(path: Path) -> None:
        BodyMeasurements.from_mapping(read_measurements(path), usual)

    return feed


def _load_folders() -> Feed:
    from swifttailor.garment import Garment

    def feed(path: Path) -> None:
        with tempfile.TemporaryDirectory(dir=path.parent) as folder:
            for file in folder_seeds_once():
                name = file.ending[1:]
                data = path.read_bytes() if path.name.endswith(file.ending) else file.data
                (Path(folder) / name).write_bytes(data)
            Garment.load(folder)

    return feed


folder_seeds_once = cache(folder_seeds)

TARGETS = (
    Target(
        "mesh", "meshes of garments: OBJ, GLB, PLY, STL", mesh_seeds, mutate, _load_meshes, 5.0, 600, 2000
    ),
    Target("usd", "meshes of garments: USD", usd_seeds, mutate, _load_meshes, 5.0, 600, 400),
    Target("body", "meshes of bodies: OBJ, GLB, PLY, STL", body_seeds, mutate, _load_bodies, 10.0, 600, 200),
    Target(
        "measurements",
        "measurements of bodies",
        measurement_seeds,
        mutate_measurements,
        _load_measurements,
        5.0,
    ),
    Target("folder", "folders of garments", folder_seeds, mutate_folder, _load_folders, 10.0, 600, 160),
)
