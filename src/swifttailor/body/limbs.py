"""Turns of arms and legs from what one would say of them: where the upper arm points, where the wrist is.

Everything is said of the wearer's left; `Pose.mirrored` has the right.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.pose import Turn, rotation_matrices, rotation_vectors, turn_from_to
from swifttailor.body.rig import Rig, mirrored_name

TWIST_AT_SHOULDER = 0.35
"""The rest of an upper arm's turn about itself happens further down, as under the skin."""
SHOULDER_SHARE = 0.14
"""How much of the arm's rise the shoulder girdle makes."""

FINGERS = np.array([0.62, -0.78, 0.08])
"""Where the fingers of the standing body point."""
WRIST_BENDS = 65.0
"""Degrees at most."""

Turns = dict[str, Turn]
Direction = tuple[float, float, float]


def arm(rig: Rig, *, out: float, forward: float = 0.0, inward: float = 0.0, bend: float = 8.0) -> Turns:
    """An arm by its angles, in degrees.

    Args:
        rig: Whose arm.
        out: How far the upper arm is lifted sideways from hanging straight down.
        forward: How far it is swung forward; negative is backward.
        inward: Where a bent forearm points: 0 forward, 90 across the body.
        bend: Of the elbow; 0 is straight.
    """
    o, f, i, b = np.deg2rad([out, forward, inward, bend])
    swing = rotation_matrices(np.array([[-f, 0.0, 0.0]]))[0] @ rotation_matrices(np.array([[0.0, 0.0, o]]))[0]
    upper = swing @ (0.0, -1.0, 0.0)
    aside = swing @ (-np.sin(i), 0.0, np.cos(i))
    return _arm(rig, upper, np.cos(b) * upper + np.sin(b) * aside, np.cross(upper, aside))


def reaching_arm(
    rig: Rig,
    *,
    wrist: Direction,
    elbow: Direction,
    roll: float = 0.0,
    fingers: Direction | None = None,
) -> Turns:
    """An arm whose wrist is somewhere; out of reach it points there.

    Args:
        rig: Whose arm.
        wrist: Where, in the frame of the chest while it stands straight, cm.
        elbow: Direction to which the elbow points, seen from the line from shoulder to wrist.
        roll: How far the palm turns on the forearm, thumb inward, degrees.
        fingers: Direction to which they point, as far as a wrist bends; None: along the forearm.
    """
    shoulder, at_elbow, hand = (rig.joints[rig.index(f"left_{name}")] for name in ("arm", "forearm", "hand"))
    upper, fore = np.linalg.norm(at_elbow - shoulder), np.linalg.norm(hand - at_elbow)
    line = np.asarray(wrist) - shoulder
    reach = float(np.clip(np.linalg.norm(line), abs(upper - fore) + 4.0, upper + fore - 0.3))
    line = line / np.linalg.norm(line)
    aside = np.asarray(elbow) - (np.asarray(elbow) @ line) * line
    aside = aside / np.linalg.norm(aside)
    along = (reach**2 + upper**2 - fore**2) / (2 * reach)
    bent = along * line + np.sqrt(max(upper**2 - along**2, 0.0)) * aside
    return _arm(rig, bent / upper, (reach * line - bent) / fore, np.cross(bent, line), roll, fingers)


def _arm(
    rig: Rig, upper: Array, fore: Array, hinge: Array, roll: float = 0.0, fingers: Direction | None = None
) -> Turns:
    """From unit directions of the upper arm and the forearm, and the axis about which the elbow bends."""
    shoulder, elbow, hand = (rig.joints[rig.index(f"left_{name}")] for name in ("arm", "forearm", "hand"))
    upper_0, fore_0 = _unit(elbow - shoulder), _unit(hand - elbow)
    # A hanging arm bends forward: about -X.
    hinge_0 = turn_from_to(upper_0, np.array([0.0, -1.0, 0.0])).T @ (-1.0, 0.0, 0.0)
    whole = _frame(upper, hinge) @ _frame(upper_0, hinge_0).T
    swing = turn_from_to(upper_0, upper)
    twist = rotation_vectors((swing.T @ whole)[None])[0]
    lift = float(np.arcsin(np.clip(upper[1], -1, 1)) - np.arcsin(upper_0[1]))
    girdle = rotation_matrices(np.array([[0.0, 0.0, SHOULDER_SHARE * lift]]))[0]
    at_shoulder, below = rotation_matrices(np.array([[TWIST_AT_SHOULDER], [1 - TWIST_AT_SHOULDER]]) * twist)
    bend = turn_from_to(fore_0, whole.T @ fore)
    half_roll = rotation_matrices((np.deg2rad(-roll) / 2 * fore_0)[None])[0]
    wrist = np.eye(3)
    if fingers is not None:
        before = whole @ bend @ half_roll @ half_roll
        turn = rotation_vectors(turn_from_to(FINGERS, before.T @ np.asarray(fingers))[None])
        most = np.deg2rad(WRIST_BENDS) / max(np.linalg.norm(turn), 1e-9)
        wrist = rotation_matrices(turn * min(1.0, most))[0]
    return as_turns(
        left_clavicle=girdle,
        left_arm=girdle.T @ swing @ at_shoulder,
        left_arm_twist=below,
        left_forearm=bend @ half_roll,
        left_hand=half_roll @ wrist,
    )


def leg(
    *,
    forward: float = 0.0,
    out: float = 0.0,
    knee: float = 0.0,
    toes_out: float = 0.0,
    pitch: float = 0.0,
    pelvis: Turn = (0.0, 0.0, 0.0),
) -> Turns:
    """A leg by its angles in degrees, its foot flat on the floor or pitched.

    Args:
        forward: How far the thigh is swung forward; negative is backward.
        out: How far it is spread.
        knee: How far the knee is bent.
        toes_out: How far the foot is turned outward.
        pitch: How far the heel is lifted, the toes staying down; negative lifts the toes.
        pelvis: Turn of the pelvis, which the foot makes up for.
    """
    f, o, k, t, p = np.deg2rad([forward, out, knee, toes_out, pitch])
    thigh = rotation_matrices(np.array([[0.0, 0.4 * t, 0.0], [-f, 0.0, 0.0], [0.0, 0.0, o]]))
    thigh = thigh[1] @ thigh[2] @ thigh[0]
    shin = rotation_matrices(np.array([[k, 0.0, 0.0]]))[0]
    whole = rotation_matrices(np.deg2rad([pelvis]))[0] @ thigh @ shin
    flat, pitched = rotation_matrices(np.array([[0.0, t, 0.0], [p, 0.0, 0.0]]))
    toes = rotation_matrices(np.array([[-max(p, 0.0), 0.0, 0.0]]))[0]
    return as_turns(left_thigh=thigh, left_shin=shin, left_foot=whole.T @ flat @ pitched, left_toes=toes)


def other_side(turns: Turns) -> Turns:
    """The same for the right arm or leg."""
    return {mirrored_name(name): (x, -y, -z) for name, (x, y, z) in turns.items()}


def as_turns(**matrices: Array) -> Turns:
    """Rotations (3, 3) by joint as vectors in degrees."""
    vectors = np.rad2deg(rotation_vectors(np.stack(list(matrices.values()))))
    return {name: (float(x), float(y), float(z)) for name, (x, y, z) in zip(matrices, vectors, strict=True)}


def _unit(vector: Array) -> Array:
    return vector / np.linalg.norm(vector)


def _frame(first: Array, second: Array) -> Array:
    """(3, 3) columns: the first direction, what of the second is at right angles to it, and their product."""
    first = _unit(first)
    second = _unit(second - (second @ first) * first)
    return np.stack([first, second, np.cross(first, second)], axis=1)
