import importlib.util
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from plain_carrying import carry_plainly

from swifttailor.body import Body, BodyPart
from swifttailor.body.body_shape import BodyShape, random_shape
from swifttailor.body.carrying import carrier_maps, carry, carry_all
from swifttailor.body.carrying_kernels import carry_points
from swifttailor.body.limbs import arm, reaching_arm
from swifttailor.body.mannequin import mannequin
from swifttailor.body.pose import Pose, rotation_matrices, rotation_vectors
from swifttailor.body.posing import POSES, pose_named, random_pose
from swifttailor.body.rig import CARRIERS, Rig
from swifttailor.errors import GeometryError, InputError

MIRROR = np.array([-1.0, 1.0, 1.0])


@pytest.fixture(scope="module")
def rig():
    return Rig.default()


@pytest.fixture(scope="module")
def skin(rig):
    return rig.weights_at(Body.default().vertices)


@pytest.fixture(scope="module")
def around(rig):
    """Points on the body, around it and far away, with their weights."""
    chance = np.random.default_rng(3)
    near = Body.default().vertices[::20] + chance.normal(0.0, 4.0, (len(Body.default().vertices[::20]), 3))
    far = chance.uniform((-120, -20, -120), (120, 220, 120), (500, 3))
    points = np.concatenate([near, far])
    return points, rig.weights_at(points)


def test_a_parent_comes_before_its_children(rig):
    assert rig.parents[0] == -1
    assert all(0 <= parent < k for k, parent in enumerate(rig.parents[1:], start=1))
    assert (rig.mirrored[rig.mirrored] == np.arange(rig.joint_count)).all()
    np.testing.assert_array_equal(rig.joints[rig.mirrored] * MIRROR, rig.joints)


def test_all_joints_but_the_outermost_lie_inside_the_body(rig):
    distance, _ = Body.default().signed_distance(rig.joints)
    assert (distance < -0.5).all(), dict(zip(rig.names, distance.round(1), strict=True))


def test_weights_sum_to_one_wherever_a_point_lies(around):
    _, weights = around
    assert weights.share.shape == weights.carrier.shape == (len(weights), CARRIERS)
    assert (weights.share >= 0).all()
    np.testing.assert_allclose(weights.share.sum(axis=1), 1.0, atol=1e-6)


def test_weights_change_smoothly(rig):
    """No step from one millimetre to the next, within the body and far outside."""
    chance = np.random.default_rng(1)
    start = chance.uniform((-60, 5, -40), (60, 165, 40), (3000, 3))
    steps = chance.normal(size=start.shape)
    steps *= 0.1 / np.linalg.norm(steps, axis=1)[:, None]
    change = np.abs(rig.dense_weights_at(start + steps) - rig.dense_weights_at(start)).max(axis=1)
    assert change.max() < 0.1


@pytest.mark.parametrize(
    ("part", "joints"),
    [
        (BodyPart.HEAD, ("head", "neck")),
        (BodyPart.LEFT_ARM, ("left_arm", "left_arm_twist", "left_forearm", "left_hand", "left_clavicle")),
        (BodyPart.RIGHT_LEG, ("right_thigh", "right_shin", "right_foot", "right_toes", "pelvis")),
    ],
)
def test_parts_go_with_their_joints(rig, part, joints):
    body = Body.default()
    dense = rig.dense_weights_at(body.vertices[body.vertex_part == part])
    own = dense[:, [rig.index(name) for name in joints]].sum(axis=1)
    assert own.mean() > 0.96
    assert np.quantile(own, 0.02) > 0.5


def test_the_side_of_the_chest_does_not_go_with_the_arm(rig):
    body = Body.default()
    x, y, _ = body.vertices.T
    side = (body.vertex_part == BodyPart.TORSO) & (y > 110) & (y < 121) & (np.abs(x) > 13)
    arms = [k for k, name in enumerate(rig.names) if "arm" in name or "hand" in name]
    assert side.sum() > 30
    assert rig.dense_weights_at(body.vertices[side])[:, arms].sum(axis=1).max() < 0.12


def test_without_some_joints_others_carry_their_points(rig, around):
    points, _ = around
    unwanted = tuple(name for name in rig.names if "arm" in name or "hand" in name)
    weights = rig.weights_at(points, without=unwanted)
    named = np.isin(weights.carrier, [rig.index(name) for name in unwanted])
    assert weights.share[named].sum() == 0.0
    np.testing.assert_allclose(weights.share.sum(axis=1), 1.0, atol=1e-6)


def test_the_standing_pose_leaves_everything_where_it_is(rig, around):
    points, weights = around
    carried = carry(points, rig, Pose(), BodyShape(), weights)
    np.testing.assert_allclose(carried, np.maximum(points, (-1e9, 0.0, -1e9)), atol=1e-4)


def test_compiled_and_plain_carry_alike(rig, around):
    points, weights = around
    for seed in range(5):
        chance = np.random.default_rng(seed)
        maps = carrier_maps(rig, random_pose(chance), random_shape(chance))
        compiled = np.empty_like(points)
        lowest = carry_points(points, weights.carrier, weights.share, maps, compiled)
        plain = carry_plainly(points, weights, maps)
        np.testing.assert_allclose(compiled, plain, atol=1e-5)
        assert lowest == pytest.approx(plain[:, 1].min(), abs=1e-5)


def test_a_mirrored_pose_gives_the_mirrored_body(rig, around):
    points, weights = around
    other = rig.weights_at(points * MIRROR)
    for seed in range(6):
        chance = np.random.default_rng(seed)
        pose, shape = random_pose(chance), random_shape(chance)
        here = carry(points, rig, pose, shape, weights)
        there = carry(points * MIRROR, rig, pose.mirrored(), shape, other)
        np.testing.assert_allclose(there, here * MIRROR, atol=1e-3)


def test_a_bent_elbow_moves_only_that_forearm(rig, skin):
    body = Body.default()
    carried = carry(body.vertices, rig, Pose({"left_forearm": (0.0, -70.0, 0.0)}), None, skin)
    moved = np.linalg.norm(carried - body.vertices, axis=1)
    left_arm = body.vertex_part == BodyPart.LEFT_ARM
    assert moved[~left_arm].max() < 0.05
    fingers = left_arm & (body.vertices[:, 0] > 60)
    assert moved[fingers].min() > 20
    shoulder = left_arm & (body.vertices[:, 0] < 25)
    assert moved[shoulder].max() < 0.3


@pytest.mark.parametrize("name", POSES)
def test_bones_keep_their_length_and_sizes_stretch_them(rig, name):
    bones = [
        ("left_arm", "left_arm_twist"),
        ("left_arm_twist", "left_forearm"),
        ("left_forearm", "left_hand"),
    ]
    bones += [("right_thigh", "right_shin"), ("right_shin", "right_foot"), ("pelvis", "spine")]
    pose = pose_named(name)
    for shape in (None, BodyShape(stature=1.1, leg_length=0.9, arm_length=1.05)):
        maps = carrier_maps(rig, pose, shape).reshape(-1, 3, 4)
        for start, end in bones:
            a, b = rig.joints[rig.index(start)], rig.joints[rig.index(end)]
            own = maps[rig.index(start)]
            length = np.linalg.norm(own[:, :3] @ (b - a))
            factor = 1.0
            if shape is not None:
                factor = shape.stature * (
                    0.9 if "thigh" in start or "shin" in start else 1.05 if "arm" in start else 1.0
                )
            assert length == pytest.approx(factor * np.linalg.norm(b - a), rel=1e-5)
            # The next bone begins where this one ends.
            following = maps[rig.index(end)]
            np.testing.assert_allclose(own[:, :3] @ b + own[:, 3], following[:, :3] @ b + following[:, 3])


def test_feet_stand_on_the_floor_and_nothing_is_below_it(rig, skin):
    body = Body.default()
    shell, _ = mannequin(body)
    worn = rig.weights_at(shell)
    for seed in range(12):
        chance = np.random.default_rng(seed)
        pose, shape = random_pose(chance), random_shape(chance)
        carried, figure = carry_all([(body.vertices, skin), (shell, worn)], rig, pose, shape)
        assert carried[:, 1].min() == pytest.approx(0.0, abs=1e-6)
        assert figure[:, 1].min() >= 0.0
        assert np.abs(carried).max() < 230
        in_shoes = carry(body.vertices, rig, pose, shape, skin, sole=3.0)
        np.testing.assert_allclose(
            in_shoes - carried, np.broadcast_to((0.0, 3.0, 0.0), carried.shape), atol=1e-6
        )


def test_random_bodies_stay_bodies(rig, skin):
    """No face is turned inside out by more than a fold, and nobody is a giant or a dwarf."""
    body = Body.default()
    for seed in range(25):
        chance = np.random.default_rng(seed)
        carried = carry(body.vertices, rig, random_pose(chance), random_shape(chance), skin)
        a, b, c = (carried[body.faces[:, k]] for k in range(3))
        litres = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6000
        assert 40 < litres < 140, seed
        assert 145 < carried[:, 1].max() < 205, seed


def test_arms_and_hands_stay_outside_the_trunk(rig, skin):
    from swifttailor.body.parts import surface_without
    from swifttailor.body.surface_distance import SurfaceTree

    body = Body.default()
    arms = (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM)
    limb = np.isin(body.vertex_part, arms) & (np.abs(body.vertices[:, 0]) > 30)
    for name in POSES:
        carried = carry(body.vertices, rig, pose_named(name), None, skin)
        vertices, faces = surface_without(carried, body.faces, body.vertex_part, arms)
        distance, _ = SurfaceTree.build(vertices, faces).signed_distance(carried[limb])
        assert (distance < -0.5).mean() < 0.01, name


def test_the_file_holds_the_joints_of_the_script(rig):
    script = Path(__file__).parents[2] / "scripts" / "make_rig.py"
    spec = importlib.util.spec_from_file_location("make_rig", script)
    assert spec is not None and spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    names, parents, joints = made.skeleton()
    assert (tuple(names), tuple(parents)) == (rig.names, rig.parents)
    np.testing.assert_array_equal(joints, rig.joints)


@given(arrays(float, (1, 3), elements=st.floats(-3.0, 3.0)))
def test_turns_are_rotations_and_back(vectors):
    (matrix,) = rotation_matrices(vectors)
    np.testing.assert_allclose(matrix @ matrix.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(matrix) == pytest.approx(1.0)
    np.testing.assert_allclose(rotation_matrices(rotation_vectors(matrix[None]))[0], matrix, atol=1e-7)
    if np.linalg.norm(vectors) > 1e-6:
        np.testing.assert_allclose(matrix @ vectors[0], vectors[0], atol=1e-9)


@given(st.floats(-89, 89), st.floats(-60, 80), st.floats(0, 90), st.floats(1, 130))
def test_an_arm_points_where_it_is_told(out, forward, inward, bend):
    rig = Rig.default()
    maps = carrier_maps(rig, Pose(arm(rig, out=out, forward=forward, inward=inward, bend=bend))).reshape(
        -1, 3, 4
    )
    own = {name: maps[rig.index(f"left_{name}")] for name in ("arm", "forearm", "hand")}
    places = [rig.joints[rig.index(f"left_{name}")] for name in own]
    shoulder, elbow, wrist = (m[:, :3] @ p + m[:, 3] for m, p in zip(own.values(), places, strict=True))
    upper, fore = elbow - shoulder, wrist - elbow
    cosine = upper @ fore / np.linalg.norm(upper) / np.linalg.norm(fore)
    assert np.rad2deg(np.arccos(np.clip(cosine, -1, 1))) == pytest.approx(bend, abs=1.0)
    assert np.rad2deg(np.arcsin(upper[0] / np.linalg.norm(upper))) == pytest.approx(out, abs=1.0)


def test_a_wrist_goes_where_it_is_told(rig):
    for wrist in ((22.0, 102.0, 2.0), (8.5, 98.0, 21.0), (12.0, 97.0, -20.0)):
        turns = reaching_arm(rig, wrist=wrist, elbow=(1.0, 0.0, -0.3), roll=20)
        own = carrier_maps(rig, Pose(turns)).reshape(-1, 3, 4)[rig.index("left_hand")]
        reached = own[:, :3] @ rig.joints[rig.index("left_hand")] + own[:, 3]
        # The shoulder girdle gives way a little.
        assert np.linalg.norm(reached - wrist) < 2.0


def test_the_same_seed_gives_the_same_pose_and_shape():
    for seed in range(3):
        one, two = (np.random.default_rng(seed) for _ in range(2))
        assert random_pose(one) == random_pose(two)
        assert random_shape(one) == random_shape(two)
    assert random_pose(np.random.default_rng(1)) != random_pose(np.random.default_rng(2))


def test_what_is_wrong_is_said(rig):
    with pytest.raises(InputError, match=r"no joint 'tail'.*pelvis"):
        Pose({"tail": (1.0, 0.0, 0.0)}).rotations(rig)
    with pytest.raises(InputError, match="three finite numbers"):
        Pose({"head": (float("nan"), 0.0, 0.0)})
    with pytest.raises(InputError, match=r"waist_width is 0.5 to 1.6.*2"):
        BodyShape(waist_width=2.0)
    with pytest.raises(InputError, match="no pose 'handstand'"):
        pose_named("handstand")
    with pytest.raises(GeometryError, match="finite"):
        rig.weights_at(np.full((2, 3), np.nan))
    with pytest.raises(GeometryError, match="3 points need as many weights, received 1"):
        carry(np.zeros((3, 3)), rig, Pose(), None, rig.weights_at(np.zeros((1, 3))))
