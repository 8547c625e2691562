"""Makes the body that ships with the package: Anny fitted to a target mesh.

Anny (https://github.com/naver/anny) is Apache-2.0 code over MakeHuman's shape data, which are CC0; both
licences are checked in the installed package before anything is written. Only Anny's own parameters
are fitted (phenotype, symmetric local changes, a left-right symmetric pose): every vertex of the result is
Anny's, none is taken from the target, which merely says how large the body is and how it stands.

Needs ``pip install 'swifttailor[body]'``. Anny's data come with its wheel; the first run reads them for about
a minute and keeps them in ``~/.cache/anny`` (``ANNY_CACHE_DIR``). The fit takes a few minutes on one core:

    python scripts/fit_default_body.py --target mean_all.obj --measurements mean_all.yaml

with GarmentCode's ``assets/bodies/mean_all.obj`` (metres) and ``mean_all.yaml``.
"""

from __future__ import annotations

import argparse
import functools
import sys
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.atomic_files import write_atomically
from swifttailor.body import BodyMeasurements, BodyPart, measure_body, signed_distance
from swifttailor.body.measurements import read_measurements
from swifttailor.body.parts import fill_holes

Array = np.ndarray[Any, np.dtype[Any]]

# Anny's local shape changes that may be used: trunk, limbs, neck; nothing in the face, nothing one-sided.
LOCAL_CHANGES = (
    "lowerarm-scale-depth-incr lowerarm-scale-horiz-incr lowerarm-scale-vert-incr lowerarm-fat-incr "
    "upperarm-scale-depth-incr upperarm-scale-horiz-incr upperarm-scale-vert-incr upperarm-fat-incr "
    "upperarm-shoulder-muscle-incr upperarm-muscle-incr lowerarm-muscle-incr measure-wrist-circ-incr "
    "breast-dist-incr breast-volume-vert-up breast-trans-up breast-point-incr buttocks-volume-incr "
    "foot-scale-horiz-incr foot-scale-vert-incr foot-scale-depth-incr foot-trans-forward foot-trans-out "
    "hand-scale-incr hand-fingers-length-incr hand-fingers-diameter-incr measure-ankle-circ-incr "
    "head-scale-vert-incr head-scale-depth-incr head-scale-horiz-incr head-trans-forward head-trans-up "
    "head-fat-incr head-back-scale-depth-incr "
    "hip-scale-horiz-incr hip-scale-depth-incr hip-scale-vert-incr hip-waist-up hip-trans-forward "
    "hip-trans-up measure-calf-circ-incr measure-lowerleg-height-incr upperleg-fat-incr "
    "lowerleg-muscle-incr leg-valgus-incr lowerleg-scale-depth-incr lowerleg-scale-horiz-incr "
    "lowerleg-scale-vert-incr upperleg-scale-depth-incr upperleg-scale-horiz-incr upperleg-scale-vert-incr "
    "lowerleg-fat-incr upperleg-muscle-incr upperlegs-height-incr lowerlegs-height-incr "
    "measure-upperleg-height-incr measure-knee-circ-incr measure-thigh-circ-incr "
    "measure-neck-circ-incr measure-neck-height-incr neck-scale-depth-incr neck-scale-horiz-incr "
    "neck-scale-vert-incr neck-trans-forward neck-trans-up neck-back-scale-depth-incr "
    "pelvis-tone-incr stomach-tone-incr stomach-pregnant-incr torso-trans-forward torso-trans-up "
    "torso-muscle-pectoral-incr torso-muscle-dorsi-incr torso-scale-horiz-incr torso-scale-depth-incr "
    "torso-scale-vert-incr torso-vshape-incr measure-underbust-circ-incr measure-napetowaist-dist-incr "
    "measure-waisttohip-dist-incr measure-shoulder-dist-incr measure-hips-circ-incr "
    "measure-waist-circ-incr measure-frontchest-dist-incr measure-bust-circ-incr "
    "measure-upperarm-circ-incr measure-upperarm-length-incr measure-lowerarm-length-incr"
).split()

MIDDLE_JOINTS = ("spine05", "spine04", "spine03", "spine02", "spine01", "neck01", "neck02", "neck03", "head")
SIDE_JOINTS = (
    "clavicle shoulder01 upperarm01 upperarm02 lowerarm01 lowerarm02 wrist upperleg01 upperleg02 lowerleg01 "
    "lowerleg02 foot finger1-1 finger2-1 finger3-1 finger4-1 finger5-1 finger1-2 finger2-2 finger3-2 "
    "finger4-2 finger5-2"
).split()
NORMAL_WEIGHT = 4.0  # cm of distance that one unit of difference between normals is worth
CAVITIES = ("mouth_cavity", "eye_cavity.L", "eye_cavity.R")


@dataclass(frozen=True)
class Target:
    """Points on the target's surface with outward normals, cm, and the mesh they came from."""

    points: Array
    normals: Array
    vertices: Array
    faces: Array

    @functools.cached_property
    def tree(self) -> Any:
        """Search tree over positions and normals together."""
        from scipy.spatial import KDTree

        return KDTree(np.concatenate([self.points, NORMAL_WEIGHT * self.normals], axis=1))


class SymmetricAnny:
    """Anny with parameters that keep left and right alike, in this package's frame and in cm."""

    def __init__(self) -> None:
        import anny
        import torch
        from anny.face_segmentation import get_face_segmentation_mask

        self.torch = torch
        self.model = anny.Anny(
            rig="anny", topology="anny-quads", local_changes="default", skinning_method="lbs"
        )
        self.kind = self.model.dtype
        self.mirror = _mirror_map(self.model.template_vertices.numpy())
        quads = self.model.faces.numpy()
        cavity = get_face_segmentation_mask(self.model, list(CAVITIES)).numpy()
        self.skin = _largest_component(quads[~cavity], len(self.mirror))
        labels = set(self.model.local_change_labels)
        self.changes = [
            [name] if name in labels else [f"l-{name}", f"r-{name}"]
            for name in LOCAL_CHANGES
            if name in labels or f"l-{name}" in labels
        ]
        bones = self.model.bone_labels
        self.middle = [bones.index(name) for name in MIDDLE_JOINTS]
        self.left = [bones.index(f"{name}.L") for name in SIDE_JOINTS]
        self.right = [bones.index(f"{name}.R") for name in SIDE_JOINTS]
        start = torch.zeros(len(self.model.phenotype_labels), dtype=self.kind)
        start[self.model.phenotype_labels.index("age")] = 0.8
        self.phenotype = start.requires_grad_()
        self.change = torch.zeros(len(self.changes), dtype=self.kind, requires_grad=True)
        self.bend = torch.zeros(len(self.middle), dtype=self.kind, requires_grad=True)
        self.turn = torch.zeros(len(self.left), 3, dtype=self.kind, requires_grad=True)
        self.shift = torch.zeros(2, dtype=self.kind, requires_grad=True)

    def vertices(self) -> Any:
        """Vertices (N, 3) in cm, Y up, exactly symmetric about x = 0, as a differentiable tensor."""
        import roma

        torch = self.torch
        flip = torch.tensor([1.0, -1.0, -1.0], dtype=self.kind)
        pose = torch.eye(4, dtype=self.kind)[None].repeat(self.model.bone_count, 1, 1)
        zero = torch.zeros_like(self.bend)
        for bones, vectors in (
            (self.middle, torch.stack([self.bend, zero, zero], dim=1)),
            (self.left, self.turn),
            (self.right, self.turn * flip),
        ):
            pose[bones, :3, :3] = roma.rotvec_to_rotmat(vectors)
        value = torch.sigmoid(self.phenotype)
        change = torch.tanh(self.change)
        out = self.model(
            pose_parameters=pose[None],
            phenotype_kwargs={n: value[i : i + 1] for i, n in enumerate(self.model.phenotype_labels)},
            local_changes_kwargs={
                name: change[i : i + 1] for i, names in enumerate(self.changes) for name in names
            },
        )["vertices"][0]
        across, forward, up = out[:, 0] * 100, -out[:, 1] * 100, out[:, 2] * 100
        across = (across - across[self.mirror]) / 2
        forward = (forward + forward[self.mirror]) / 2 + self.shift[1]
        up = (up + up[self.mirror]) / 2 + self.shift[0]
        return torch.stack([across, up, forward], dim=1)

    def parts(self) -> Array:
        """`BodyPart` (N,) uint8 of each vertex by its skinning weights, alike on both sides."""
        bones, parents = self.model.bone_labels, self.model.bone_parents
        roots = {
            "upperarm01.L": BodyPart.LEFT_ARM,
            "upperarm01.R": BodyPart.RIGHT_ARM,
            "upperleg01.L": BodyPart.LEFT_LEG,
            "upperleg01.R": BodyPart.RIGHT_LEG,
            "neck02": BodyPart.HEAD,
        }
        part_of: list[int] = []
        for name, parent in zip(bones, parents, strict=True):
            inherited = part_of[parent] if parent >= 0 else int(BodyPart.TORSO)
            part_of.append(int(roots.get(name, inherited)))
        weights = np.zeros((len(self.mirror), len(BodyPart)))
        table = np.array(part_of)[self.model.vertex_bone_indices.numpy()]
        np.add.at(weights, (np.arange(len(table))[:, None], table), self.model.vertex_bone_weights.numpy())
        swapped = weights[self.mirror][:, [0, 1, 3, 2, 5, 4]]
        return (weights + swapped).argmax(axis=1).astype(np.uint8)


def fit(body: SymmetricAnny, target: Target, steps: int) -> None:
    """Adjusts the parameters of `body` until its skin lies on the target."""
    torch = body.torch
    with torch.no_grad():
        start = body.vertices().numpy()
        body.shift[0] = float(target.vertices[:, 1].min() - start[:, 1].min())
        body.shift[1] = float(np.median(target.vertices[:, 2]) - np.median(start[:, 2]))
    triangles = split_quads(body.vertices().detach().numpy(), body.skin)
    importance = _importance(body)
    rates = {body.phenotype: 0.05, body.bend: 0.006, body.turn: 0.012, body.shift: 0.2, body.change: 0.03}
    optimiser = torch.optim.Adam(
        [{"params": [p], "lr": rate} for p, rate in rates.items()], betas=(0.9, 0.98)
    )
    stiff = torch.tensor([20.0 if "finger" in name else 1.0 for name in SIDE_JOINTS], dtype=body.kind)
    for step in range(steps):
        progress = step / steps
        for group, rate in zip(optimiser.param_groups, rates.values(), strict=True):
            waits = group["params"][0] is body.change and progress < 0.2
            group["lr"] = 0.0 if waits else rate * (1.0 - progress) + 1e-5
        loss, size = _surface_loss(body, triangles, importance, target, 8.0 * (1.0 - progress) + 1.5)
        loss = loss + 0.005 * (stiff[:, None] * body.turn**2).sum() + 0.005 * (body.bend**2).sum()
        loss = loss + 0.002 * (body.phenotype**2).sum() + 0.001 * (torch.tanh(body.change) ** 2).sum()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        if step % 50 == 0 or step == steps - 1:
            print(f"step {step:4d}  loss {loss.item():.4f}  mean gap {size * 10:.2f} mm", flush=True)


def _surface_loss(
    body: SymmetricAnny, triangles: Array, importance: Array, target: Target, scale: float
) -> tuple[Any, float]:
    """Robust point-to-plane distance both ways (cm2), and the plain mean distance between points (cm)."""
    from scipy.spatial import KDTree

    vertices = body.vertices()
    now = vertices.detach().numpy()
    skin = np.unique(triangles)
    normals, areas = vertex_normals(now, triangles)
    # Normals take part in the search, so that a thigh is never matched with the other thigh.
    ours = np.concatenate([now, NORMAL_WEIGHT * normals], axis=1)[skin]
    _, there = target.tree.query(ours)
    _, here = KDTree(ours).query(target.tree.data)
    here = skin[here]
    pairs = (
        (skin, target.points[there], target.normals[there], areas[skin] * importance[skin]),
        (here, target.points, normals[here], importance[here]),
    )
    total = 0.0
    for index, points, planes, weight in pairs:
        gap = now[index] - points
        facing = (normals[index] * (target.normals if index is here else target.normals[there])).sum(axis=1)
        trust = weight * (facing > 0.3) / (1.0 + (gap**2).sum(axis=1) / scale**2) ** 2
        trust = body.torch.tensor(trust / weight.sum())
        gap = vertices[index] - body.torch.tensor(points)
        along = (gap * body.torch.tensor(planes)).sum(dim=1)
        total = total + (trust * (along**2 + 0.1 * (gap**2).sum(dim=1))).sum()
    return total, float(np.linalg.norm(now[skin] - target.points[there], axis=1).mean())


def _importance(body: SymmetricAnny) -> Array:
    """How much each vertex counts: faces and fingers little, since no garment lies on them."""
    bones = body.model.bone_labels
    heaviest = body.model.vertex_bone_weights.argmax(dim=1, keepdim=True)
    strongest = body.model.vertex_bone_indices.gather(1, heaviest)[:, 0].numpy()
    low = [i for i, name in enumerate(bones) if name.startswith(("finger", "toe", "head", "eye"))]
    return np.where(np.isin(strongest, low), 0.2, 1.0)


def read_target(path: Path, count: int, seed: int) -> Target:
    """Samples the target, a mesh in metres with Y up, evenly."""
    import trimesh

    mesh: Any = trimesh.load_mesh(path, process=False)
    vertices, faces = np.asarray(mesh.vertices) * 100.0, np.asarray(mesh.faces)
    if not 100.0 < np.ptp(vertices[:, 1]) < 260.0:
        sys.exit(f"'{path}' is {np.ptp(vertices[:, 1]):.0f} cm tall; give a body in metres with Y up.")
    points, index = trimesh.sample.sample_surface(mesh, count, seed=seed)
    return Target(np.asarray(points) * 100.0, np.asarray(mesh.face_normals)[index], vertices, faces)


def finished_mesh(body: SymmetricAnny) -> tuple[Array, Array, Array]:
    """The skin alone, closed where the mouth and the eyes were, standing on the floor.

    Returns:
        Vertices (N, 3) float32 cm, faces (M, 3) int32, `BodyPart` (N,) uint8.
    """
    vertices = body.vertices().detach().numpy()
    faces = split_quads(vertices, body.skin)
    middle = body.mirror == np.arange(len(body.mirror))
    vertices[middle, 0] = 0.0
    part = body.parts()
    used = np.unique(faces)
    vertices, faces = fill_holes(vertices[used], np.searchsorted(used, faces))
    heads = np.full(len(vertices) - len(used), BodyPart.HEAD, np.uint8)
    part = np.concatenate([part[used], heads])
    vertices[:, 1] -= vertices[:, 1].min()
    return vertices.astype(np.float32), faces.astype(np.int32), part


def split_quads(vertices: Array, quads: Array) -> Array:
    """Two triangles per quad (Q, 4), along the shorter diagonal, so that mirror images split alike."""
    a, b, c, d = (vertices[quads[:, k]] for k in range(4))
    first = ((a - c) ** 2).sum(axis=1) <= ((b - d) ** 2).sum(axis=1) * (1 + 1e-9)
    p, q = quads[first], quads[~first]
    return np.concatenate([p[:, [0, 1, 2]], p[:, [0, 2, 3]], q[:, [1, 2, 3]], q[:, [1, 3, 0]]])


def vertex_normals(vertices: Array, faces: Array) -> tuple[Array, Array]:
    """Unit normals (N, 3) and a third of the adjoining area (N,) of each vertex."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    normals, areas = np.zeros_like(vertices), np.zeros(len(vertices))
    for k in range(3):
        np.add.at(normals, faces[:, k], cross)
        np.add.at(areas, faces[:, k], np.linalg.norm(cross, axis=1) / 6.0)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12), areas


def _mirror_map(template: Array) -> Array:
    """For each vertex of the symmetric template, its mirror image."""
    from scipy.spatial import KDTree

    gap, index = KDTree(template).query(template * [-1.0, 1.0, 1.0])
    if gap.max() > 1e-6 or (index[index] != np.arange(len(index))).any():
        sys.exit("Anny's template is not symmetric in this version; the script was written for anny 0.6.")
    return index


def _largest_component(quads: Array, count: int) -> Array:
    """The quads of the largest connected piece: the skin without eyeballs and tongue."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    ends = np.concatenate([quads[:, :2], quads[:, 1:3], quads[:, 2:]])
    graph = coo_array((np.ones(len(ends)), ends.T), shape=(count, count))
    label = connected_components(graph, directed=False)[1][quads[:, 0]]
    return quads[label == np.bincount(label).argmax()]


def check_mesh(vertices: Array, faces: Array) -> None:
    """Stops unless the mesh is closed, oriented outward and free of degenerate faces."""
    import trimesh

    mesh = trimesh.Trimesh(vertices.astype(np.float64), faces, process=False)
    sound = {
        "watertight": mesh.is_watertight,
        "consistent winding": mesh.is_winding_consistent,
        "outward": mesh.volume > 0,
        "no degenerate faces": bool(mesh.area_faces.min() > 1e-6),
        "one piece": mesh.body_count == 1,
    }
    print(", ".join(f"{name}: {value}" for name, value in sound.items()))
    if not all(sound.values()):
        sys.exit("The mesh is not usable; nothing was written.")


def report(vertices: Array, faces: Array, part: Array, target: Target, wanted: BodyMeasurements) -> None:
    """Prints distances to the target, and our measurements beside the wanted ones."""
    away = np.abs(signed_distance(target.vertices, target.faces, vertices)[0])
    back = np.abs(signed_distance(vertices, faces, target.points)[0])
    clothed = (part != BodyPart.HEAD) & (np.abs(vertices[:, 0]) < 50)
    for name, gap in (("ours to target", away), ("without head and hands", away[clothed]), ("back", back)):
        print(f"{name}: mean {gap.mean() * 10:.1f} mm, p95 {np.percentile(gap, 95) * 10:.1f} mm")
    known = {k: wanted.as_dict()[k] for k in ("head_l", "vert_bust_line", "waist_line", "hips_line")}
    ours = measure_body(vertices.astype(np.float64), faces, part, known).as_dict()
    for name, value in wanted.as_dict().items():
        print(f"{name:22s} wanted {value:7.1f}  measured {ours[name]:7.1f}")


def licences() -> str:
    """Says under which licences the installed Anny and its data are, or stops if they are others."""
    import anny

    code = metadata.distribution("anny").read_text("licenses/LICENSE") or ""
    data = Path(anny.__file__).parent / "data" / "mpfb2" / "LICENSE.md"
    if "Apache License" not in code or "CC0 1.0 Universal" not in data.read_text(encoding="utf-8"):
        sys.exit("The installed anny is not Apache-2.0 with CC0 data; its body may not be shipped.")
    return "shape model Anny: Apache-2.0, (C) 2025 NAVER Corp.; shape data from MakeHuman (MPFB2): CC0 1.0"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--target", type=Path, required=True, help="mesh to fit, metres, Y up")
    parser.add_argument("--measurements", type=Path, required=True, help="GarmentCode body YAML to copy")
    parser.add_argument("--out", type=Path, default=Path("src/swifttailor/body/default_body.npz"))
    parser.add_argument("--steps", type=int, default=900)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()

    import torch

    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    note = licences()
    wanted = BodyMeasurements.from_mapping(read_measurements(options.measurements))
    target = read_target(options.target, 20000, options.seed)
    body = SymmetricAnny()
    fit(body, target, options.steps)
    value = torch.sigmoid(body.phenotype).tolist()
    print({name: round(v, 3) for name, v in zip(body.model.phenotype_labels, value, strict=True)})
    strong = torch.tanh(body.change).detach().numpy()
    print({body.changes[i][0]: round(float(strong[i]), 2) for i in np.argsort(-np.abs(strong))[:15]})
    vertices, faces, part = finished_mesh(body)
    check_mesh(vertices, faces)
    report(vertices, faces, part, target, wanted)
    provenance = [
        f"anny {metadata.version('anny')}, torch {metadata.version('torch')}",
        note,
        f"python scripts/fit_default_body.py --target {options.target.name} "
        f"--measurements {options.measurements.name} --steps {options.steps} --seed {options.seed}",
        "measurements copied from the measurements file; see docs/body.md",
    ]

    content = {
        "vertices": vertices,
        "faces": faces,
        "vertex_part": part,
        "measurement_names": np.array(list(wanted.as_dict())),
        "measurement_values": np.array(list(wanted.as_dict().values())),
        "provenance": np.array(provenance),
    }
    write_atomically(options.out, lambda temporary: np.savez_compressed(temporary, **content), overwrite=True)
    print(f"{options.out}: {len(vertices)} vertices, {len(faces)} faces, {options.out.stat().st_size} bytes")


if __name__ == "__main__":
    main()
