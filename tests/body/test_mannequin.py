import numpy as np
import pytest

from swifttailor.body import Body, BodyPart, body_for
from swifttailor.body.mannequin import mannequin, smoothed
from swifttailor.body.surface_distance import SurfaceTree

HANDS, FEET = 45.0, 14.0
"""Beyond this from the middle, and below this height, cm."""


@pytest.fixture(scope="module")
def figure():
    return mannequin(Body.default())


def test_it_is_one_closed_surface_with_its_outside_outside(figure):
    vertices, faces = figure
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    assert set(count) == {2}
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    litres = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6000
    assert litres == pytest.approx(volume(Body.default()), rel=0.08)


def volume(body):
    a, b, c = (body.vertices[body.faces[:, k]] for k in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6000


def test_it_lies_inside_the_body_but_for_filled_hollows(figure):
    vertices, _ = figure
    away, _ = Body.default().signed_distance(vertices)
    limbs = (vertices[:, 1] > FEET) & (np.abs(vertices[:, 0]) < HANDS)
    assert away[limbs].max() < 2.5
    assert (away[limbs] > 0.05).mean() < 0.06
    assert vertices[:, 1].min() >= 0.0 and vertices[:, 1].max() <= Body.default().vertices[:, 1].max()


def test_it_has_neither_ears_nor_fingers(figure):
    vertices, _ = figure
    body = Body.default()
    head = body.vertices[body.vertex_part == BodyPart.HEAD]
    middle = 0.5 * (head[:, 1].min() + head[:, 1].max())
    width = np.ptp(head[head[:, 1] > middle, 0])
    ours = vertices[vertices[:, 1] > middle]
    assert np.ptp(ours[:, 0]) < 0.9 * width
    assert sharpness(*mannequin(body)) < 0.5 * sharpness(body.vertices, body.faces)


def sharpness(vertices, faces):
    """How much neighbouring faces turn against each other, degrees at the 99th percentile, per centimetre."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(faces)), 3)
    order = np.lexsort(edges.T)
    edges, owner = edges[order], owner[order]
    pair = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = np.divide(normal, length, out=np.zeros_like(normal), where=length > 1e-9)
    cosine = np.einsum("ij,ij->i", normal[owner[pair]], normal[owner[pair + 1]])
    along = np.linalg.norm(vertices[edges[pair, 0]] - vertices[edges[pair, 1]], axis=1)
    good = along > 0.05
    turn = np.degrees(np.arccos(np.clip(cosine[good], -1, 1))) / along[good]
    return np.percentile(turn, 99)


def test_hollows_are_empty_under_cloth(figure):
    vertices, faces = figure
    body = Body.default()
    away, _ = body.signed_distance(vertices)
    cleft = vertices[(np.abs(vertices[:, 0]) < 1) & (away > 0.5) & (vertices[:, 2] < 0)]
    assert len(cleft) > 5
    worn, _ = mannequin(body, cleft)
    assert np.array_equal(mannequin(body)[0], vertices), "the kept figure is not touched"
    assert body.signed_distance(worn)[0][(np.abs(vertices[:, 0]) < 1) & (away > 0.5)].max() < away.max()
    inside, _ = SurfaceTree.build(worn, faces).signed_distance(cleft - [0.0, 0.0, 0.2])
    before, _ = SurfaceTree.build(vertices, faces).signed_distance(cleft - [0.0, 0.0, 0.2])
    assert (inside > before).all()


def wearer(shape):
    default = Body.default()
    return Body("own", shape(default.vertices), default.faces, default.vertex_part, default.measurements)


def test_it_goes_along_with_the_body(figure):
    vertices, faces = figure
    taller = mannequin(wearer(lambda v: v * [1.0, 1.1, 1.0] + [3.0, 0.0, 0.0]))
    assert np.array_equal(taller[1], faces)
    assert np.abs(taller[0] - (vertices * [1.0, 1.1, 1.0] + [3.0, 0.0, 0.0])).max() < 0.5


@pytest.mark.parametrize("name", ["women EU 50", "men EU 54", "children EU 116"])
def test_people_of_other_sizes_have_neither_ears_nor_fingers(name):
    body = body_for(size=name)
    vertices, faces = mannequin(body)
    assert sharpness(vertices, faces) < 0.6 * sharpness(body.vertices, body.faces)
    head = body.vertices[body.vertex_part == BodyPart.HEAD]
    middle = 0.5 * (head[:, 1].min() + head[:, 1].max())
    ours = vertices[vertices[:, 1] > middle]
    assert np.ptp(ours[:, 0]) < 0.95 * np.ptp(head[head[:, 1] > middle, 0])
    away, _ = body.signed_distance(vertices)
    limbs = (vertices[:, 1] > FEET) & (np.abs(vertices[:, 0]) < HANDS)
    assert away[limbs].max() < 3.0 and (away[limbs] > 0.5).mean() < 0.05
    worn, _ = mannequin(body, body.vertices)
    away, _ = body.signed_distance(worn)
    assert (away[limbs] > 0.2).mean() < 0.02


def test_another_body_is_smoothed_and_hardly_grows():
    body = Body.default()
    own = Body("own", body.vertices, body.faces[::-1], body.vertex_part, body.measurements)
    vertices, faces = mannequin(own)
    assert np.array_equal(faces, own.faces)
    assert body.signed_distance(vertices)[0].max() < 0.6
    assert sharpness(vertices, faces) < 0.75 * sharpness(own.vertices, own.faces)
    assert np.ptp(vertices[:, 1]) == pytest.approx(np.ptp(own.vertices[:, 1]), abs=1.5)


def test_smoothing_leaves_a_ball_round_and_loose_vertices_alone():
    count = 24
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, count, endpoint=False), np.linspace(0.1, 3.0, count))
    ball = 10 * np.stack([np.cos(u) * np.sin(v), np.cos(v), np.sin(u) * np.sin(v)], axis=-1).reshape(-1, 3)
    i = np.arange(count * (count - 1))
    right = i - i % count + (i + 1) % count
    faces = np.concatenate(
        [np.stack([i, right, i + count], axis=1), np.stack([right, right + count, i + count], axis=1)]
    )
    moved = smoothed(np.concatenate([ball, [[50.0, 0, 0]]]), faces)
    assert np.array_equal(moved[-1], [50.0, 0, 0])
    middle = slice(6 * count, 18 * count)
    assert np.linalg.norm(moved[:-1][middle], axis=1) == pytest.approx(10.0, abs=0.6)
