from __future__ import annotations

import time

import numpy as np
import pytest
from shapes import icosphere

from swifttailor.body import Body, BodyPart, DistanceField
from swifttailor.body.distance_field import build_field, cache_folder, cached_field
from swifttailor.body.parts import ARMS, face_parts
from swifttailor.errors import GeometryError, InputError


@pytest.fixture(scope="module")
def field(body, cache) -> DistanceField:
    return body.distance_field()


def test_samples_are_close_to_the_exact_distance(body, field):
    random = np.random.default_rng(0)
    points = body.vertices[random.integers(0, len(body.vertices), 4000)] + random.normal(0, 2, (4000, 3))
    exact, _ = body.signed_distance(points)
    sampled, gradient = field.sample(points)
    hands = np.abs(points[:, 0]) > 50
    small = hands | (points[:, 1] < 8) | (points[:, 1] > body.measurements.neck_level)  # fingers, toes, ears
    assert np.abs(sampled - exact).max() < 0.9  # one node apart
    assert np.abs(sampled - exact)[~small].mean() < 0.03
    assert np.percentile(np.abs(sampled - exact)[~small], 99) < 0.25
    assert (np.sign(sampled) == np.sign(exact))[np.abs(exact) > 0.6].all()
    np.testing.assert_allclose(np.linalg.norm(gradient, axis=1), 1.0, atol=1e-9)


def test_nodes_are_exact_near_the_surface_and_bounds_elsewhere(body, field):
    random = np.random.default_rng(1)
    index = np.stack([random.integers(0, n, 3000) for n in field.values.shape], axis=1)
    exact, _ = body.signed_distance(field.origin + field.spacing * index)
    stored = field.values[tuple(index.T)]
    near = np.abs(exact) <= 5.0
    assert np.abs(stored - exact)[near].max() < 1e-4
    assert (np.abs(stored) >= np.abs(exact) - 1e-4).all()
    assert np.abs(stored - exact).max() < 1.5
    assert ((stored < 0) == (exact < 0)).all()


def test_gradient_points_away_from_a_sphere(cache):
    field = build_field(*icosphere(20.0, 4, centre=(0, 40, 0)), spacing=1.0, margin=8.0)
    random = np.random.default_rng(2)
    direction = random.normal(size=(500, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    points = [0, 40, 0] + direction * random.uniform(16, 24, (500, 1))
    distance, gradient = field.sample(points)
    assert (gradient * direction).sum(axis=1).min() > 0.99
    assert np.abs(distance - (np.linalg.norm(points - [0, 40, 0], axis=1) - 20)).max() < 0.1


def test_far_away_is_far_away(field):
    points = np.array([[500.0, 90, 0], [0.0, -300, 0], [0.0, 90, 1e6], [-1e9, 1e9, 1e9]])
    distance, gradient = field.sample(points)
    assert (distance >= 8.0).all()
    assert distance[0] == pytest.approx(500 - 66, abs=12)
    assert gradient[0, 0] > 0.9
    assert gradient[1, 1] < -0.9
    assert np.isfinite(distance).all()


def test_sampling_is_continuous_across_the_lattice_border(field):
    top = field.origin + field.spacing * (np.array(field.values.shape) - 1)
    edge = np.array([[top[0], 90.0, 0.0]])
    step = np.array([1e-6, 0.0, 0.0])
    inside, _ = field.sample(edge - step)
    outside, _ = field.sample(edge + step)
    assert outside[0] == pytest.approx(inside[0], abs=1e-4)


def test_without_arms_the_arms_are_outside_and_the_rest_stays(body, field):
    bare = body.distance_field(without=ARMS)
    part = face_parts(body.faces, body.vertex_part)
    centres = body.vertices[body.faces].mean(axis=1)
    arm = centres[np.isin(part, [int(p) for p in ARMS]) & (np.abs(centres[:, 0]) > 24)]
    assert (bare.sample(arm)[0] > 1.0).all()
    assert bare.sample(arm[np.abs(arm[:, 0]) > 50])[0].min() > 20
    inner = body.vertices[body.vertex_part == BodyPart.LEFT_ARM]
    core = [inner[np.abs(inner[:, 0] - x) < 1.5].mean(axis=0) for x in np.linspace(28, 50, 12)]
    assert (field.sample(core)[0] < -1.0).all()
    assert (bare.sample(core)[0] > 1.0).all()
    low = centres[(centres[:, 1] < 115) & (part != BodyPart.LEFT_ARM) & (part != BodyPart.RIGHT_ARM)]
    near = low + np.random.default_rng(4).normal(0, 0.5, low.shape)
    np.testing.assert_allclose(bare.sample(near)[0], field.sample(near)[0], atol=1e-4)


def test_points_that_are_no_places_are_refused(field):
    for points in (np.full((2, 3), np.nan), np.full((1, 3), np.inf), np.zeros(3), np.zeros((4, 2))):
        with pytest.raises(GeometryError, match="points"):
            field.sample(points)
    distance, gradient = field.sample(np.zeros((0, 3)))
    assert distance.shape == (0,)
    assert gradient.shape == (0, 3)


def test_without_everything_is_refused(body):
    with pytest.raises(InputError, match="leaves nothing"):
        body.distance_field(without=frozenset(BodyPart))


def test_field_is_symmetric_and_deterministic(body, field):
    again = build_field(body.vertices, body.faces, 1.0, 8.0)
    assert again.values.tobytes() == field.values.tobytes()
    near = np.abs(field.values) < 5
    assert np.abs(field.values - field.values[::-1])[near].max() < 1e-3


def test_field_is_fast_enough(body):
    build_field(*icosphere(5.0, 1), spacing=1.0, margin=2.0)  # compile
    start = time.process_time()
    build_field(body.vertices, body.faces, 1.0, 8.0)
    assert time.process_time() - start < 4.0  # about 0.8 s on an idle core


def test_cache_is_used_and_a_damaged_file_is_made_again(tmp_path, monkeypatch):
    monkeypatch.setenv("SWIFTTAILOR_CACHE", str(tmp_path))
    surface = icosphere(5.0, 2)
    first = cached_field(*surface, 1.0, 3.0)
    (file,) = tmp_path.glob("*.npz")
    good = file.read_bytes()
    monkeypatch.setattr("swifttailor.body.distance_field.build_field", _forbidden)
    assert cached_field(*surface, 1.0, 3.0).values.tobytes() == first.values.tobytes()
    monkeypatch.undo()
    monkeypatch.setenv("SWIFTTAILOR_CACHE", str(tmp_path))
    flipped = bytearray(good)
    flipped[len(good) // 2] ^= 0xFF
    for content in (b"", b"not a zip", good[: len(good) // 2], bytes(flipped), _npz(values=np.zeros(3))):
        file.write_bytes(content)
        assert cached_field(*surface, 1.0, 3.0).values.tobytes() == first.values.tobytes()
        assert file.read_bytes() == good


def test_cache_key_depends_on_everything(tmp_path, monkeypatch):
    monkeypatch.setenv("SWIFTTAILOR_CACHE", str(tmp_path))
    vertices, faces = icosphere(5.0, 1)
    for arguments in (
        (vertices, faces, 1.0, 3.0),
        (vertices + 1e-9, faces, 1.0, 3.0),
        (vertices, faces[::-1], 1.0, 3.0),
        (vertices, faces, 0.9, 3.0),
        (vertices, faces, 1.0, 3.1),
    ):
        cached_field(*arguments)
    assert len(list(tmp_path.glob("*.npz"))) == 5


def test_pickles_in_the_cache_are_never_loaded(tmp_path, monkeypatch):
    monkeypatch.setenv("SWIFTTAILOR_CACHE", str(tmp_path))
    surface = icosphere(5.0, 1)
    first = cached_field(*surface, 1.0, 3.0)
    (file,) = tmp_path.glob("*.npz")
    np.savez(file, values=np.array([_Trap()], dtype=object), origin=np.zeros(3))
    assert cached_field(*surface, 1.0, 3.0).values.tobytes() == first.values.tobytes()


def test_an_unwritable_cache_is_no_error(tmp_path, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_text("in the way")
    monkeypatch.setenv("SWIFTTAILOR_CACHE", str(blocked / "below"))
    assert cached_field(*icosphere(5.0, 1), 1.0, 3.0).values.min() < 0


def test_cache_folder_follows_the_environment(monkeypatch, tmp_path):
    monkeypatch.delenv("SWIFTTAILOR_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_folder() == tmp_path / "swifttailor"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder() == tmp_path / ".cache" / "swifttailor"


@pytest.mark.parametrize(
    ("spacing", "margin"), [(0, 8), (-1, 8), (np.nan, 8), (1, -1), (1, np.inf), (1e-4, 8)]
)
def test_absurd_lattices_are_refused(body, spacing, margin):
    with pytest.raises(InputError, match=r"spacing|margin"):
        body.distance_field(spacing=spacing, margin=margin)


def test_fields_are_kept_in_memory(body, field):
    assert body.distance_field() is field
    assert Body.default().distance_field(1.0, 8.0, frozenset()) is field


class _Trap:
    def __reduce__(self):
        return (_forbidden, ())


def _forbidden(*_arguments):
    raise AssertionError("must not be called")


def _npz(**arrays) -> bytes:
    import io

    stream = io.BytesIO()
    np.savez(stream, **arrays)
    return stream.getvalue()


def test_a_covering_field_hides_no_part_of_the_body(body, field):
    covering = body.distance_field(covering=True)
    corners = body.vertices[body.faces]
    points = np.concatenate([body.vertices, corners.mean(axis=1), (corners[:, 0] + corners[:, 1]) / 2])
    assert (field.sample(points)[0] > 0.1).any()  # fingers and ears are lost in the plain one
    assert covering.sample(points)[0].max() <= 1e-3
    lowered = field.values - covering.values
    assert lowered.min() >= 0 and lowered.max() < 0.9 and (lowered > 0).mean() < 0.05
