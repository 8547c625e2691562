"""Makes src/swifttailor/body/default_rig.npz: the joints of the default body and the field of their weights.

Joints stand in the middle of the slices of the body. Its vertices are given to joints by their part and their
place along the bones, softened by diffusion over the surface, and spread into the space around: what stands
off the body by d cm is carried as the surface is on average within about d/2 cm of the nearest point, so that
a skirt between two legs shears and does not tear. Run from the repository root (a minute):

.venv/bin/python scripts/make_rig.py
"""

from __future__ import annotations

import io

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import factorized
from scipy.spatial import KDTree

from swifttailor.arrays import Array
from swifttailor.atomic_files import write_atomically
from swifttailor.body import Body, BodyPart
from swifttailor.body.rig import RIG_FILE

MIDDLE = {
    "pelvis": (None, (0.0, 93.0, -1.0)),
    "spine": ("pelvis", (0.0, 104.0, 0.0)),
    "chest": ("spine", (0.0, 117.0, -1.0)),
    "neck": ("chest", (0.0, 144.0, -2.5)),
    "head": ("neck", (0.0, 152.0, -0.5)),
}
SIDE = {
    "breast": ("chest", (8.5, 124.5, 5.0)),
    "clavicle": ("chest", (3.0, 138.5, -2.0)),
    "arm": ("clavicle", (17.2, 136.3, -2.8)),
    "arm_twist": ("arm", (26.3, 126.6, -1.8)),
    "forearm": ("arm_twist", (35.4, 116.9, -0.9)),
    "hand": ("forearm", (54.8, 101.2, 3.0)),
    "thigh": ("pelvis", (9.4, 86.5, -0.5)),
    "shin": ("thigh", (10.3, 47.5, -2.4)),
    "foot": ("shin", (10.5, 8.0, -4.8)),
    "toes": ("foot", (11.6, 2.0, 5.5)),
}
"""Joint: what it hangs on, and where the wearer's left one stands; from the middles of slices."""
SOFT_CM = 2.6
"""How far weights diffuse over the surface."""
NEAR_CM, WIDENING = 1.5, 0.5
"""Half width of the mean in space: at the surface, and how much it grows with the distance."""
ARMS_END_CM = 9.0, 20.0
"""Arms carry what is nearer than the first and nothing beyond the second: skirts lie there."""
X = np.concatenate([[0.0, 1.0, 2.5, 4.5, 7.0], np.arange(10.0, 80.0, 3.0)])
Y = np.arange(-3.0, 178.0, 3.0)
Z = np.array([-60, -48, -38, -30, -24, -19, *range(-15, 19, 3), 22, 27, 34, 42, 52, 62], float)


def main() -> None:
    body = Body.default()
    names, parents, joints = skeleton()
    weights = diffused(body, at_vertices(body, names))
    nodes = np.stack(np.meshgrid(X, Y, Z, indexing="ij"), axis=-1).reshape(-1, 3)
    spread_out = spread(body, weights, nodes, [k for k, n in enumerate(names) if n.endswith(ARM)])
    middle = nodes[:, 0] == 0.0
    other = [names.index(swapped(name)) for name in names]
    spread_out[middle] = 0.5 * (spread_out[middle] + spread_out[middle][:, other])
    field = np.round(255 * spread_out).astype(np.uint8).reshape(len(X), len(Y), len(Z), len(names))
    buffer = io.BytesIO()
    np.savez_compressed(buffer, names=names, parents=parents, joints=joints, x=X, y=Y, z=Z, field=field)
    write_atomically(RIG_FILE, lambda path: path.write_bytes(buffer.getvalue()), overwrite=True)
    print(f"{len(names)} joints, {field.shape[:3]} nodes, {len(buffer.getvalue())} bytes")


ARM = "arm", "arm_twist", "forearm", "hand"


def skeleton() -> tuple[list[str], list[int], Array]:
    """Names, parents and positions, a parent before its children."""
    table = dict(MIDDLE)
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for name, (parent, (x, y, z)) in SIDE.items():
            owner = parent if parent in MIDDLE else f"{side}_{parent}"
            table[f"{side}_{name}"] = (owner, (sign * x, y, z))
    names = list(table)
    parents = [-1 if parent is None else names.index(parent) for parent, _ in table.values()]
    return names, parents, np.array([place for _, place in table.values()])


def swapped(name: str) -> str:
    return name.replace("left_", "?").replace("right_", "left_").replace("?", "right_")


def ramp(value: Array, middle: Array | float, half_width: float) -> Array:
    """From 0 to 1 around the middle, without a kink."""
    t = np.clip((value - middle) / (2 * half_width) + 0.5, 0.0, 1.0)
    return t * t * (3 - 2 * t)


def at_vertices(body: Body, names: list[str]) -> Array:
    """(N, J) weights of the body's vertices before they are softened."""
    x, y, z = body.vertices.T
    across = np.abs(x)
    part = body.vertex_part
    weights = np.zeros((len(x), len(names)))
    side = np.where(x > 0, "left", "right")

    def give(name: str, value: Array) -> None:
        if name in names:
            weights[:, names.index(name)] += value
        else:
            for which in ("left", "right"):
                weights[:, names.index(f"{which}_{name}")] += np.where(side == which, value, 0.0)

    arm = np.isin(part, [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM]).astype(float)
    middle, elbow, wrist = (along_arm(body.vertices, name) for name in ("arm_twist", "forearm", "hand"))
    twist = ramp(middle, 0.0, 8.0)
    fore = ramp(elbow, 0.0, 5.0)
    hand = ramp(wrist, 0.0, 3.0)
    give("arm", arm * (1 - twist))
    give("arm_twist", arm * twist * (1 - fore))
    give("forearm", arm * twist * fore * (1 - hand))
    give("hand", arm * twist * fore * hand)

    rest = 1 - arm
    leg = rest * (1 - ramp(y, 77.0 + 0.75 * across + 0.35 * z, 6.0))
    shin = 1 - ramp(y, 47.5, 6.0)
    foot = 1 - ramp(y, 8.5 + 0.25 * np.clip(z + 4.8, 0, 8), 3.0)
    toes = ramp(z, 5.5, 2.5)
    give("thigh", leg * (1 - shin))
    give("shin", leg * shin * (1 - foot))
    give("foot", leg * shin * foot * (1 - toes))
    give("toes", leg * shin * foot * toes)

    trunk = rest - leg
    spine = ramp(y, 99.0, 9.0)
    chest = ramp(y, 113.0, 9.0)
    neck = ramp(y, 144.0 - 0.4 * z, 3.5) * ramp(-across, -12.0, 4.0)
    head = ramp(y, 152.5 - 0.4 * z, 2.5)
    clavicle = ramp(across, 9.5, 4.5) * ramp(y, 131.0, 7.0)
    away = np.hypot((across - 8.5) / 9.5, (y - 124.0) / 9.5)
    breast = 0.9 * ramp(1 - away, 0.5, 0.5) * ramp(z, 3.0, 4.0)
    give("pelvis", trunk * (1 - spine))
    give("spine", trunk * spine * (1 - chest))
    upper = trunk * spine * chest * (1 - neck)
    give("breast", upper * breast)
    give("clavicle", upper * (1 - breast) * clavicle)
    give("chest", upper * (1 - breast) * (1 - clavicle))
    give("neck", trunk * spine * chest * neck * (1 - head))
    give("head", trunk * spine * chest * neck * head)
    return weights / weights.sum(axis=1, keepdims=True)


def along_arm(points: Array, joint: str) -> Array:
    """(N,) distance beyond a joint of the arm, along the middle between the bones it joins, cm."""
    parent, place = SIDE[joint]
    before = np.array(place) - SIDE[parent][1]
    ends = {"arm_twist": SIDE["forearm"][1], "forearm": SIDE["hand"][1], "hand": (65.0, 88.0, 5.5)}
    after = np.array(ends[joint]) - place
    axis = before / np.linalg.norm(before) + after / np.linalg.norm(after)
    return (np.abs(points * (1, 0, 0)) + points * (0, 1, 1) - place) @ axis / np.linalg.norm(axis)


def diffused(body: Body, weights: Array) -> Array:
    """Weights softened over the surface, by heat that spreads for a while."""
    laplacian, area = surface_laplacian(body.vertices, body.faces)
    steps = 4
    solve = factorized((sparse.diags(area) + SOFT_CM**2 / 2 / steps * laplacian).tocsc())
    for _ in range(steps):
        weights = np.stack([solve(area * column) for column in weights.T], axis=1)
    weights = np.clip(weights, 0.0, None)
    return weights / weights.sum(axis=1, keepdims=True)


def surface_laplacian(vertices: Array, faces: Array) -> tuple[sparse.csr_matrix, Array]:
    """Stiffness (N, N) by cotangents, never negative, and the area (N,) around each vertex."""
    count = len(vertices)
    area = np.zeros(count)
    rows, columns, values = [], [], []
    for k in range(3):
        a, b, c = faces[:, k], faces[:, (k + 1) % 3], faces[:, (k + 2) % 3]
        one, two = vertices[b] - vertices[a], vertices[c] - vertices[a]
        double = np.linalg.norm(np.cross(one, two), axis=1)
        np.add.at(area, a, double / 6)
        cotangent = np.clip((one * two).sum(axis=1) / np.maximum(double, 1e-9), 0.05, 10.0) / 2
        rows += [b, c]
        columns += [c, b]
        values += [cotangent, cotangent]
    links = sparse.coo_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (count, count)
    ).tocsr()
    return sparse.diags(np.asarray(links.sum(axis=1)).ravel()) - links, np.maximum(area, 1e-6)


def spread(body: Body, weights: Array, nodes: Array, arm_joints: list[int]) -> Array:
    """(n, J) weights at the nodes: means over the surface, wider the further away a node is."""
    _, area = surface_laplacian(body.vertices, body.faces)
    samples, sample_weights, sample_area = thinned(body.vertices, weights, area)
    arm = np.isin(body.vertex_part, [BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM])
    away, _ = KDTree(body.vertices).query(nodes)
    from_arm, _ = KDTree(body.vertices[arm]).query(nodes)
    kept = 1 - ramp(from_arm, sum(ARMS_END_CM) / 2, (ARMS_END_CM[1] - ARMS_END_CM[0]) / 2)
    result = np.zeros((len(nodes), weights.shape[1]))
    for first in range(0, len(nodes), 1000):
        part = slice(first, first + 1000)
        squared = ((nodes[part, None] - samples[None]) ** 2).sum(axis=-1)
        # Where the arms do not carry, the nearest of the rest of the body counts as the nearest.
        width = NEAR_CM + WIDENING * away[part]
        near = squared.min(axis=1)
        mean = softest(squared, near, width, sample_area) @ sample_weights
        is_arm = sample_weights[:, arm_joints].sum(axis=1) > 0.5
        others = squared[:, ~is_arm]
        far_width = NEAR_CM + WIDENING * np.sqrt(others.min(axis=1))
        trunk = softest(others, others.min(axis=1), far_width, sample_area[~is_arm]) @ sample_weights[~is_arm]
        trunk[:, arm_joints] *= kept[part, None]
        mean /= mean.sum(axis=1, keepdims=True)
        trunk /= trunk.sum(axis=1, keepdims=True)
        result[part] = kept[part, None] * mean + (1 - kept[part, None]) * trunk
    return result


def softest(squared: Array, near: Array, width: Array, area: Array) -> Array:
    return np.exp(-(squared - near[:, None]) / (2 * width[:, None] ** 2)) * area


def thinned(vertices: Array, weights: Array, area: Array) -> tuple[Array, Array, Array]:
    """The surface by fewer points, each the middle of a cell of 1.5 cm; left and right alike."""
    side = (vertices[:, :1] > 0).astype(int)
    cells = np.floor(np.abs(vertices) / 1.5).astype(int) * np.where(vertices < 0, -1, 1)
    key = np.concatenate([cells, side, (vertices[:, 2:] < 0).astype(int)], axis=1)
    _, cell = np.unique(key, axis=0, return_inverse=True)
    cell = cell.ravel()
    total = np.bincount(cell, area)
    mean = [np.bincount(cell, area * column) / total for column in np.concatenate([vertices, weights], 1).T]
    table = np.stack(mean, axis=1)
    return table[:, :3], table[:, 3:], total


if __name__ == "__main__":
    main()
