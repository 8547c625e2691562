"""A garment and its body as Newton's Style3D solver sees them, and one frame of its time.

Newton counts in metres, kilograms and seconds; everything is converted here.
"""

from __future__ import annotations

import contextlib
import importlib
import io
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Ints
from swifttailor.body import Body
from swifttailor.body.parts import ARMS, surface_without
from swifttailor.draping.cloth import ClothModel
from swifttailor.draping.collider import FIELD_SPACING_CM
from swifttailor.draping.loop_arguments import FRAME_RATE, GRAVITY
from swifttailor.draping.simulation import Simulation
from swifttailor.draping.xpbd_kernels import EDGE_DISTANCE
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

SUBSTEPS = 2
ITERATIONS = 10
LINEAR_ITERATIONS = 10
MAX_STRETCH = 700.0
"""Largest stretch stiffness over density, m^2/s^2: stiffer cloth Style3D moves as if in syrup."""
_METRES = 0.01
SHEAR_SHARE = 0.375
"""Shear stiffness over stretch stiffness: that of the spring lattice of the XPBD engine."""
_SLIVER_HEIGHT = 0.1
"""A triangle lower than this share of its longest side is a sliver."""
_SLIVER_SHARE = 1e-3
"""Stiffness of slivers over that of the cloth."""
_CONTACT_STIFFNESS = 500.0
"""N/m for each vertex that touches the body or is held up."""
_CONTACT_SEARCH = 0.03
"""How far from the body vertices are looked after, beyond the cloth's thickness, m."""
_CREEP_SPEED = 1e-3
"""Slower than this, m/s, friction is a drag instead of Coulomb's; Newton's default is ten times that."""
_NEAR_BODY = 0.3
"""Ends further from contact than this cannot bring the middle of their edge into the body, cm."""
_MAX_LIFT = 0.6
"""Most by which a vertex is lifted so that its edges stay outside, cm."""
_MAX_SPEED = 3.0
"""m/s"""


@dataclass
class Stage:
    """Newton's objects and what is added to them in every step."""

    model: Any
    solver: Any
    pipeline: Any
    contacts: Any
    state: Any
    next_state: Any
    control: Any
    collider: Ints
    """(v,) the shape that each vertex may touch."""
    held: Ints
    """(k,) vertices that may not sink."""
    floor: NDArray[np.float32]
    """(k, 3) points under them, m."""
    floor_shape: int
    clearance: Floats
    """(v,) distance each vertex keeps from the body, cm."""


def build_stage(simulation: Simulation, cloth: ClothModel, mesh: PatternMesh, body: Body) -> Stage:
    """Builds Newton's model of a garment and its body; `NewtonEngine` says what becomes of what."""
    newton: Any = importlib.import_module("newton")
    wp: Any = importlib.import_module("warp")
    style3d: Any = importlib.import_module("newton.solvers").style3d

    fabric = simulation.fabric
    builder = newton.ModelBuilder(up_axis=newton.Axis.Y, gravity=(0.0, -GRAVITY * _METRES, 0.0))
    newton.solvers.SolverStyle3D.register_custom_attributes(builder)
    builder.default_edge_ke = fabric.bending
    rest, sliver = rest_triangles(mesh, cloth)
    stretch = min(fabric.membrane(mesh.pattern.cloth_stretch), MAX_STRETCH * fabric.density)
    stiffness = stretch * np.outer(np.where(sliver, _SLIVER_SHARE, 1.0), [1.0, 1.0, SHEAR_SHARE])
    style3d.add_cloth_mesh(
        builder,
        pos=wp.vec3(0.0, 0.0, 0.0),
        rot=wp.quat_identity(),
        vel=wp.vec3(0.0, 0.0, 0.0),
        vertices=simulation.positions * _METRES,
        indices=mesh.faces.ravel(),
        panel_verts=rest.reshape(-1, 2) * _METRES,
        panel_indices=np.arange(3 * len(rest)),
        density=fabric.density,
        tri_aniso_ke=[wp.vec3(*row) for row in stiffness.tolist()],
        edge_kd=0.0,
        particle_radius=fabric.thickness * _METRES,
    )
    builder.particle_mass[:] = cloth.mass.tolist()

    ignores = simulation.field.ignores_arms == 1
    solid = newton.ModelBuilder.ShapeConfig(density=0.0, mu=fabric.friction, has_shape_collision=False)
    collider = np.zeros(len(ignores), dtype=np.int32)
    for without, vertices in ((frozenset(), ~ignores), (ARMS, ignores)):
        if vertices.any():
            collider[vertices] = builder.add_shape_mesh(-1, mesh=_newton_mesh(body, without), cfg=solid)
    slippery = newton.ModelBuilder.ShapeConfig(
        density=0.0, mu=0.0, has_shape_collision=False, has_particle_collision=False
    )
    floor_shape = builder.add_shape_plane(plane=(0.0, 1.0, 0.0, 0.0), width=0.0, length=0.0, cfg=slippery)

    model = builder.finalize()
    model.soft_contact_ke = _CONTACT_STIFFNESS
    model.soft_contact_kd = 1e-5
    model.soft_contact_mu = fabric.friction  # Newton takes the geometric mean with the shape's
    with contextlib.redirect_stdout(io.StringIO()):  # it prints how long this took
        solver = newton.solvers.SolverStyle3D(
            model,
            config=newton.solvers.SolverStyle3D.Config(
                iterations=ITERATIONS, linear_iterations=LINEAR_ITERATIONS
            ),
        )
    collision = solver.collision
    collision.friction_epsilon = _CREEP_SPEED
    collision.radius = 0.5 * fabric.thickness * _METRES
    if not simulation.settings.self_collision:
        collision.stiff_vf = collision.stiff_ee = collision.stiff_ef = 0.0

    holds = np.isfinite(simulation.held.levels)
    held = simulation.held.vertices[holds]
    room = len(ignores) * model.shape_count + len(held)
    pipeline = newton.CollisionPipeline(model, soft_contact_gap=_CONTACT_SEARCH, soft_contact_max=room)
    collision.body_contact_max = room
    floor = np.zeros((len(held), 3), dtype=np.float32)
    floor[:, 1] = (simulation.held.levels[holds] - fabric.thickness) * _METRES
    state, next_state = model.state(), model.state()
    state.particle_qd.assign((simulation.velocities * _METRES).astype(np.float32))
    return Stage(
        model=model,
        solver=solver,
        pipeline=pipeline,
        contacts=pipeline.contacts(),
        state=state,
        next_state=next_state,
        control=model.control(),
        collider=collider,
        held=held,
        floor=floor,
        floor_shape=floor_shape,
        clearance=np.full(len(ignores), float(fabric.thickness)),
    )


def _newton_mesh(body: Body, without: frozenset[Any]) -> Any:
    """The body's surface in metres, parts cut off and the cuts closed."""
    newton: Any = importlib.import_module("newton")
    vertices, faces = surface_without(body.vertices, body.faces, body.vertex_part, without)
    used = np.unique(faces)
    return newton.Mesh(vertices[used] * _METRES, np.searchsorted(used, faces).ravel(), compute_inertia=False)


def advance_frame(stage: Stage, damping: float) -> Floats:
    """Steps through 1/60 s. Returns the new positions (v, 3) in cm."""
    step = 1.0 / (FRAME_RATE * SUBSTEPS)
    for _ in range(SUBSTEPS):
        stage.state.clear_forces()
        stage.pipeline.collide(stage.state, stage.contacts)
        _choose_contacts(stage)
        stage.solver.step(stage.state, stage.next_state, stage.control, stage.contacts, step)
        stage.state, stage.next_state = stage.next_state, stage.state
    velocity = stage.state.particle_qd.numpy() * math.exp(-damping / FRAME_RATE)
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    stage.state.particle_qd.assign(velocity * np.minimum(1.0, _MAX_SPEED / np.maximum(speed, 1e-9)))
    return stage.state.particle_q.numpy().astype(np.float64) / _METRES


def widen_clearance(stage: Stage, simulation: Simulation, body: Body) -> None:
    """Lifts the ends of edges whose middle comes too near to the body, where that is more curved than they.

    Newton's contacts are those of vertices. The clearance only grows, so that it comes to rest.
    """
    points, edges = simulation.positions, simulation.cloth.edges
    ignores = simulation.field.ignores_arms == 1
    free = ignores[edges].all(axis=1)
    near = _distance(body, points, ignores) < stage.clearance + _NEAR_BODY
    chosen = near[edges].all(axis=1)
    edges, free = edges[chosen], free[chosen]
    lack = EDGE_DISTANCE - _distance(body, points[edges].mean(axis=1), free)
    edges, lack = edges[lack > 0], lack[lack > 0]
    if not len(edges):
        return
    wider = stage.clearance.copy()
    np.maximum.at(wider, edges.ravel(), stage.clearance[edges].ravel() + np.repeat(0.5 * lack, 2))
    stage.clearance = np.minimum(wider, simulation.fabric.thickness + _MAX_LIFT)
    stage.model.particle_radius.assign((stage.clearance * _METRES).astype(np.float32))


def _distance(body: Body, points: Floats, ignores: NDArray[np.bool_]) -> Floats:
    """Distance (n,) in cm from points (n, 3) to the body, without its arms where those are ignored."""
    distance = np.zeros(len(points))
    for without, chosen in ((frozenset(), ~ignores), (ARMS, ignores)):
        if chosen.any():
            field = body.distance_field(spacing=FIELD_SPACING_CM, without=without)
            distance[chosen] = field.sample(points[chosen])[0]
    return distance


def _choose_contacts(stage: Stage) -> None:
    """Drops contacts with the body that a vertex may not touch and adds the floors of the held ones."""
    contacts = stage.contacts
    count = min(int(contacts.soft_contact_count.numpy()[0]), len(contacts.soft_contact_particle))
    particle = contacts.soft_contact_particle.numpy()[:count]
    shape = contacts.soft_contact_shape.numpy()[:count]
    kept = shape == stage.collider[particle]
    if kept.all() and not len(stage.held):
        return
    up = np.tile(np.array([0.0, 1.0, 0.0], dtype=np.float32), (len(stage.held), 1))
    for array, added in (
        (contacts.soft_contact_particle, stage.held),
        (contacts.soft_contact_shape, np.full(len(stage.held), stage.floor_shape, dtype=np.int32)),
        (contacts.soft_contact_body_pos, stage.floor),
        (contacts.soft_contact_body_vel, np.zeros_like(stage.floor)),
        (contacts.soft_contact_normal, up),
    ):
        values = array.numpy().copy()
        chosen = np.concatenate([values[:count][kept], added])
        values[: len(chosen)] = chosen
        array.assign(values)
    contacts.soft_contact_count.fill_(int(kept.sum()) + len(stage.held))


def rest_triangles(mesh: PatternMesh, cloth: ClothModel) -> tuple[Floats, NDArray[np.bool_]]:
    """Rest shape of every face in the plane of its panel, as corners (f, 3, 2) in cm; which are slivers (f,).

    Style3D leaves out triangles of negative area without a word, so panels whose loop runs clockwise are
    mirrored left to right, which keeps the grain upright. Where two panels disagree about the length of
    their common edge, `cloth.arrays.rest` holds: the triangle there gets that side and keeps the other
    two. Where no such triangle exists (a strong gather in a skewed triangle) it keeps its flat shape.
    Slivers, which would be all but rigid or have no area, get `_SLIVER_HEIGHT`.
    """
    flat = mesh.flat_vertices[mesh.flat_faces].copy()
    flat[_area(flat) < 0, :, 0] *= -1
    sides = np.roll(flat, -1, axis=1) - flat
    own = np.linalg.norm(sides, axis=2)
    rest = _side_rest(mesh, cloth)

    # Corner 0 stays, corner 1 goes along side 0, corner 2 to where the two other lengths meet.
    along = sides[:, 0] / np.maximum(own[:, :1], 1e-12)
    a, b, c = rest[:, 0], rest[:, 1], rest[:, 2]
    x = (a * a + c * c - b * b) / (2 * np.maximum(a, 1e-12))
    y = np.sqrt(np.maximum(c * c - x * x, 0.0))
    bent = flat.copy()
    bent[:, 1] = flat[:, 0] + a[:, None] * along
    bent[:, 2] = flat[:, 0] + x[:, None] * along + y[:, None] * _left(along)
    sound = _area(bent) > 0.25 * _area(flat)
    changed = (np.abs(rest - own) > 1e-6 * own).any(axis=1)
    shape = np.where((sound & changed)[:, None, None], bent, flat)

    # A sliver's third corner is raised off its longest side.
    sides = np.roll(shape, -1, axis=1) - shape
    own = np.linalg.norm(sides, axis=2)
    row, k = np.arange(len(shape)), own.argmax(axis=1)
    longest = np.maximum(own[row, k], 1e-6)
    lack = _SLIVER_HEIGHT * longest - 2 * _area(shape) / longest
    sliver = lack > 0
    rise = np.maximum(lack, 0.0)[:, None] * _left(sides[row, k] / longest[:, None])
    shape[row, (k + 2) % 3] += rise
    return shape, sliver


def _left(direction: Floats) -> Floats:
    """(n, 2) directions turned by 90 degrees anticlockwise."""
    return np.stack([-direction[:, 1], direction[:, 0]], axis=1)


def _side_rest(mesh: PatternMesh, cloth: ClothModel) -> Floats:
    """Rest length (f, 3) of every face's sides in cm; side k joins corner k to the next."""
    count = mesh.vertex_count
    edges = np.sort(cloth.arrays.edges, axis=1).astype(np.int64)
    keys = edges[:, 0] * count + edges[:, 1]
    order = np.argsort(keys)
    sides = np.sort(np.stack([mesh.faces, np.roll(mesh.faces, -1, axis=1)], axis=2), axis=2).astype(np.int64)
    found = np.searchsorted(keys, sides[..., 0] * count + sides[..., 1], sorter=order)
    return cloth.arrays.rest[order[found]]


def _area(corners: Floats) -> Floats:
    u, w = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / 2
