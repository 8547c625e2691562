"""Makes src/swifttailor/body/body_shapes.npz: the directions in which the default body changes its shape.

Bodies of women, men and children are drawn at random from Anny (Apache-2.0 code, CC0 data, as in
``fit_default_body.py``), all in the pose of the default body. The directions are the principal components of
what they differ by from the default body, left and right alike, weighted by area, with heads, hands and feet
counting little. Beside them is stored where women, men and children lie in these coordinates (mean and
covariance), which is what a body is completed by where its measures leave it open.

Needs ``pip install 'swifttailor[body]'``. About a quarter of an hour on one core:

    python scripts/make_body_shapes.py --target mean_all.obj

``--parameters FILE`` keeps the fit to the default body between runs.
"""

from __future__ import annotations

import argparse
import io
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

import fit_default_body as default_fit
from swifttailor.atomic_files import write_atomically
from swifttailor.body import Body, BodyPart

Array = np.ndarray[Any, np.dtype[Any]]

OUT = Path("src/swifttailor/body/body_shapes.npz")
GROUPS = "women", "men", "children"
COMPONENTS = 28
SAMPLES = 260
"""Of each group."""
HELD_OUT = 20
"""Of each group, from which no directions are made."""
LITTLE = 0.1
"""Weight of heads, hands and feet beside the rest."""
LOCAL_SPREAD = 0.3
PULLED = ("measure-", "torso-", "hip-", "upperleg", "upperarm", "breast", "stomach", "buttocks")
"""Local changes that vary most; others vary a third as much."""


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--target", type=Path, required=True, help="mesh that the default body was fitted to")
    parser.add_argument("--parameters", type=Path, help="where the fit to it is kept")
    parser.add_argument("--out", type=Path, default=OUT)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--steps", type=int, default=900, help="of the fit")
    options = parser.parse_args()

    import torch

    torch.manual_seed(options.seed)
    torch.set_num_threads(1)
    note = default_fit.licences()
    model = default_fit.SymmetricAnny()
    fit_or_load(model, options.target, options.parameters, options.steps, options.seed)
    start = Body.default()
    base, faces, _ = default_fit.finished_mesh(model)
    if len(base) != len(start.vertices) or not (faces == start.faces).all():
        print("The fit splits some quads otherwise than the default body; its own vertices are kept.")
    if len(base) != len(start.vertices):
        raise SystemExit("This version of Anny has another mesh than the default body.")
    print(f"refit to the default body: {np.abs(base - start.vertices).max():.2f} cm off at most", flush=True)

    chance = np.random.default_rng(options.seed)
    drawn = {group: draw_group(model, group, chance) for group in GROUPS}
    offsets = np.stack([v - base for group in GROUPS for v in drawn[group]])
    kind = np.repeat(np.arange(len(GROUPS)), SAMPLES)
    trained = np.tile(np.arange(SAMPLES) >= HELD_OUT, len(GROUPS))
    weight = vertex_weights(start)
    half, _ = halves(start.vertices)
    directions, levels = principal(offsets[trained][:, half], weight[half], COMPONENTS)
    stored, scale = in_16_bits(directions)
    usable = stored * scale[:, None, None]
    places = coordinates(offsets[:, half], usable, weight[half])
    report(offsets[:, half], usable, places, trained, kind, weight[half])
    means = np.stack([places[trained & (kind == k)].mean(axis=0) for k in range(len(GROUPS))])
    spreads = np.stack([np.cov(places[trained & (kind == k)].T) for k in range(len(GROUPS))])
    content = {
        "half": half.astype(np.int16),
        "directions": stored,
        "scale": scale,
        "groups": np.array(GROUPS),
        "means": means,
        "covariances": spreads,
        "provenance": np.array(
            [
                f"anny {metadata.version('anny')}, torch {metadata.version('torch')}",
                note,
                f"python scripts/make_body_shapes.py --target {options.target.name} --steps {options.steps} "
                f"--seed {options.seed}",
                f"{SAMPLES - HELD_OUT} bodies of each of {', '.join(GROUPS)}; {COMPONENTS} components hold "
                f"{levels[COMPONENTS - 1]:.4f} of the variance",
            ]
        ),
    }
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **content)
    write_atomically(options.out, lambda path: path.write_bytes(buffer.getvalue()), overwrite=True)
    print(f"{options.out}: {COMPONENTS} directions, {len(buffer.getvalue())} bytes")


def fit_or_load(model: Any, target: Path, kept: Path | None, steps: int, seed: int) -> None:
    """Sets the model's parameters to those of the default body."""
    names = ("phenotype", "change", "bend", "turn", "shift")
    if kept is not None and kept.is_file():
        with np.load(kept, allow_pickle=False) as stored, model.torch.no_grad():
            for name in names:
                getattr(model, name).copy_(model.torch.tensor(stored[name]))
        return
    default_fit.fit(model, default_fit.read_target(target, 20000, seed), steps)
    if kept is not None:
        np.savez(kept, **{name: getattr(model, name).detach().numpy() for name in names})


def draw_group(model: Any, group: str, chance: np.random.Generator) -> list[Array]:
    """Meshes (N, 3) of a group, standing where the default body stands."""
    torch = model.torch
    labels = list(model.model.phenotype_labels)
    first = model.phenotype.detach().clone(), model.change.detach().clone()
    pulled = np.array([any(p in names[0] for p in PULLED) for names in model.changes])
    drawn = []
    for number in range(SAMPLES):
        share = {
            "women": {"gender": FEMALE, "age": (0.62, 0.95)},
            "men": {"gender": MALE, "age": (0.62, 0.95)},
            "children": {"gender": (0.0, 1.0), "age": (0.25, 0.52)},
        }[group]
        value = torch.sigmoid(first[0]).numpy().copy()
        for k, name in enumerate(labels):
            low, high = share.get(name, (0.0, 0.0))
            if name in share:
                value[k] = chance.uniform(low, high)
            elif name == "height":  # Anny's end at 1.3 and 2.5 m
                value[k] = np.clip(chance.normal(0.43, 0.1), 0.02, 0.98)
            elif name in ("muscle", "weight", "proportions"):
                value[k] = np.clip(chance.normal(0.5, 0.24), 0.02, 0.98)
        spread = np.where(pulled, LOCAL_SPREAD, LOCAL_SPREAD / 3)
        kept = chance.uniform(0.0, 1.0) * (0.5 if group == "children" else 1.0)
        change = np.tanh(first[1].numpy()) * kept + chance.normal(0.0, spread)
        with torch.no_grad():
            value = np.clip(value, 1e-3, 1 - 1e-3)
            model.phenotype.copy_(torch.tensor(np.log(value / (1 - value))))
            model.change.copy_(torch.tensor(np.arctanh(np.clip(change, -0.95, 0.95))))
            vertices, _, _ = default_fit.finished_mesh(model)
        drawn.append(placed(vertices.astype(np.float64) * chance.uniform(0.97, 1.03)))
        if number % 50 == 49:
            height = np.array([v[:, 1].max() for v in drawn])
            print(f"{group}: {number + 1}, {height.min():.0f} to {height.max():.0f} cm tall", flush=True)
    with torch.no_grad():
        model.phenotype.copy_(first[0])
        model.change.copy_(first[1])
    return drawn


FEMALE, MALE = (0.85, 1.0), (0.0, 0.15)
"""Anny's gender."""


def placed(vertices: Array) -> Array:
    """The mesh with its soles on the floor and its trunk, seen from the side, where the default body's is."""
    default = Body.default()
    trunk = (default.vertex_part == BodyPart.TORSO) & (np.abs(default.vertices[:, 1] - 97.0) < 8.0)
    moved = vertices - [0.0, vertices[:, 1].min(), 0.0]
    moved[:, 2] += default.vertices[trunk, 2].mean() - moved[trunk, 2].mean()
    return moved


def vertex_weights(body: Body) -> Array:
    """(N,) how much each vertex counts: its area, little on heads, hands and feet."""
    _, area = default_fit.vertex_normals(body.vertices, body.faces)
    x, y, _ = body.vertices.T
    far = (body.vertex_part == BodyPart.HEAD) & (y > 152.0)
    far |= np.abs(x) > 56.0
    far |= y < 7.0
    return area * np.where(far, LITTLE, 1.0)


def halves(vertices: Array) -> tuple[Array, Array]:
    """Vertices of the left half and the middle (H,), and of each vertex its mirror image (N,)."""
    from scipy.spatial import KDTree

    gap, mirror = KDTree(vertices).query(vertices * [-1.0, 1.0, 1.0])
    if gap.max() > 1e-3:
        raise SystemExit("The default body is not symmetric.")
    return np.flatnonzero(vertices[:, 0] >= -1e-6), mirror


def principal(offsets: Array, weight: Array, count: int) -> tuple[Array, Array]:
    """Directions (count, H, 3) in cm for one unit, and the share of the variance that the first k hold."""
    rows = (offsets * np.sqrt(weight)[None, :, None]).reshape(len(offsets), -1)
    values, vectors = np.linalg.eigh(rows @ rows.T)
    order = np.argsort(-values)
    size = np.sqrt(values[order[:count]] / len(rows))
    combine = vectors[:, order[:count]] / np.sqrt(values[order[:count]])
    directions = np.einsum("sk,svc->kvc", combine, offsets) * size[:, None, None]
    return directions, np.cumsum(values[order]) / values.sum()


def in_16_bits(directions: Array) -> tuple[Array, Array]:
    """The directions as int16 and what a unit of each is, cm."""
    scale = np.abs(directions).max(axis=(1, 2)) / 32767
    return np.round(directions / scale[:, None, None]).astype(np.int16), scale


def coordinates(offsets: Array, directions: Array, weight: Array) -> Array:
    """(S, K) of meshes along the directions."""
    root = np.sqrt(weight)[None, :, None]
    basis = (directions * root).reshape(len(directions), -1)
    rows = (offsets * root).reshape(len(offsets), -1)
    return np.linalg.solve(basis @ basis.T, basis @ rows.T).T


def report(
    offsets: Array, directions: Array, places: Array, trained: Array, kind: Array, weight: Array
) -> None:
    counted = weight > np.median(weight) * 0.3
    for k, group in enumerate(GROUPS):
        chosen = ~trained & (kind == k)
        rest = offsets[chosen] - np.einsum("sk,kvc->svc", places[chosen], directions)
        gap = np.linalg.norm(rest, axis=-1)[:, counted] * 10
        print(
            f"{group}, {chosen.sum()} held out: mean {gap.mean():.1f} mm, p95 {np.percentile(gap, 95):.1f} mm"
        )


if __name__ == "__main__":
    main()
