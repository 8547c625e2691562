"""Poses that people are photographed in."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from swifttailor.body.limbs import Turns, arm, leg, other_side, reaching_arm
from swifttailor.body.pose import Pose, Turn
from swifttailor.body.rig import Rig
from swifttailor.errors import InputError

Chance = np.random.Generator
_Maker = Callable[[Rig, Chance], Turns]


def pose_named(name: str, chance: Chance | None = None, rig: Rig | None = None) -> Pose:
    """A pose by its name, one of `POSES`.

    Args:
        name: Which.
        chance: Draws where in its ranges each angle lies; None takes the first draw of seed 0.
        rig: Whose arms and legs; None takes the default rig.

    Raises:
        InputError: There is no pose of this name.
    """
    if name not in POSES:
        raise InputError(f"There is no pose {name!r}; there are {', '.join(POSES)}.")
    chance = np.random.default_rng(0) if chance is None else chance
    return Pose(POSES[name][0](Rig.default() if rig is None else rig, chance))


def random_pose(chance: Chance, rig: Rig | None = None) -> Pose:
    """A pose that people are photographed in, with a turn of the head and a slight lean of its own.

    Args:
        chance: Where the draw comes from.
        rig: Whose arms and legs; None takes the default rig.
    """
    share = np.array([weight for _, weight in POSES.values()])
    name = str(chance.choice(list(POSES), p=share / share.sum()))
    turns = dict(pose_named(name, chance, rig).turns)
    nod, turn, tilt = chance.normal(0.0, (5.0, 14.0, 5.0)).clip((-10, -30, -10), (14, 30, 10))
    turns = _added(turns, "neck", (0.4 * nod, 0.4 * turn, 0.4 * tilt))
    turns = _added(turns, "head", (0.6 * nod, 0.6 * turn, 0.6 * tilt))
    lean = chance.normal(0.0, (2.0, 3.0, 1.5)).clip((-3, -6, -3), (5, 6, 3))
    turns = _added(turns, "spine", (0.5 * lean[0], 0.5 * lean[1], 0.5 * lean[2]))
    turns = _added(turns, "chest", (0.5 * lean[0], 0.5 * lean[1], 0.5 * lean[2]))
    pose = Pose(turns)
    return pose.mirrored() if chance.random() < 0.5 else pose


def _added(turns: Turns, name: str, more: tuple[float, float, float]) -> Turns:
    x, y, z = turns.get(name, (0.0, 0.0, 0.0))
    return {**turns, name: (float(x + more[0]), float(y + more[1]), float(z + more[2]))}


def _hanging(rig: Rig, chance: Chance, low: float = 13.0, high: float = 20.0) -> Turns:
    return arm(
        rig,
        out=chance.uniform(low, high),
        forward=chance.uniform(-4.0, 8.0),
        inward=chance.uniform(0.0, 35.0),
        bend=chance.uniform(8.0, 22.0),
    )


def _stance(chance: Chance) -> Turns:
    """Both feet flat, knees nearly straight."""
    left = leg(out=chance.uniform(-3.0, 1.5), toes_out=chance.uniform(0, 12), knee=0.0)
    right = leg(out=chance.uniform(-3.0, 1.5), toes_out=chance.uniform(0, 12), knee=0.0)
    return left | other_side(right)


def _weight_on_right(chance: Chance, most: float = 6.0) -> Turns:
    """Contrapposto: the left hip is lower, its knee bent; the shoulders tilt the other way."""
    tilt = chance.uniform(2.5, most)
    turn = chance.uniform(-5.0, 5.0)
    pelvis: Turn = (0.0, turn, -tilt)
    # The free leg is as much too long as its hip is lower; thigh and shin bend to make up for it.
    drop = 19.0 * np.sin(np.deg2rad(tilt)) + 0.3
    bend = float(np.rad2deg(np.arccos(1.0 - drop / 78.5)))
    free = leg(
        forward=bend,
        knee=2 * bend,
        out=chance.uniform(1.0, 4.0) + tilt,
        toes_out=chance.uniform(8, 22),
        pelvis=pelvis,
    )
    loaded = leg(out=-tilt - chance.uniform(0.0, 2.5), toes_out=chance.uniform(0, 10), pelvis=_mirror(pelvis))
    back = chance.uniform(0.8, 1.5)
    torso = {
        "pelvis": pelvis,
        "spine": (0.0, -0.5 * turn, 0.5 * back * tilt),
        "chest": (0.0, -0.5 * turn, 0.6 * back * tilt),
    }
    return torso | free | other_side(loaded)


def _mirror(turn: Turn) -> Turn:
    return turn[0], -turn[1], -turn[2]


def _arms_down(rig: Rig, chance: Chance) -> Turns:
    return _stance(chance) | _hanging(rig, chance) | other_side(_hanging(rig, chance))


def _arms_away(rig: Rig, chance: Chance) -> Turns:
    return _stance(chance) | _hanging(rig, chance, 22, 42) | other_side(_hanging(rig, chance, 22, 42))


def _contrapposto(rig: Rig, chance: Chance) -> Turns:
    return (
        _weight_on_right(chance) | _hanging(rig, chance, 15, 24) | other_side(_hanging(rig, chance, 15, 24))
    )


def _walking(rig: Rig, chance: Chance) -> Turns:
    """The left foot is in front."""
    stride = chance.uniform(0.5, 1.0)
    swing = stride * chance.uniform(0.6, 1.2)
    pelvis: Turn = (0.0, -5.0 * stride, 0.0)
    front = leg(forward=20 * stride, knee=5 * stride, pitch=-6 * stride, toes_out=5, out=-2, pelvis=pelvis)
    rear = leg(
        forward=-14 * stride, knee=16 * stride, pitch=28 * stride, toes_out=5, out=-2, pelvis=_mirror(pelvis)
    )
    left = arm(rig, out=chance.uniform(13, 18), forward=-17 * swing, inward=20, bend=6 + 8 * swing)
    right = arm(rig, out=chance.uniform(13, 18), forward=17 * swing, inward=25, bend=14 + 16 * swing)
    torso: Turns = {"pelvis": pelvis, "spine": (1.0, 4.0 * stride, 0.0), "chest": (0.0, 5.0 * stride, 0.0)}
    return torso | front | other_side(rear) | left | other_side(right)


def _on_hip(rig: Rig, chance: Chance) -> Turns:
    wrist = (chance.uniform(20.5, 22.5), chance.uniform(101.0, 106.0), chance.uniform(-1.0, 4.0))
    return reaching_arm(
        rig, wrist=wrist, elbow=(1.0, 0.0, chance.uniform(-0.6, -0.1)), roll=10, fingers=(0.05, -0.75, 0.65)
    )


def _hand_on_hip(rig: Rig, chance: Chance) -> Turns:
    return _weight_on_right(chance) | other_side(_on_hip(rig, chance)) | _hanging(rig, chance, 15, 24)


def _hands_on_hips(rig: Rig, chance: Chance) -> Turns:
    return _stance(chance) | _on_hip(rig, chance) | other_side(_on_hip(rig, chance))


def _hands_in_front(rig: Rig, chance: Chance) -> Turns:
    """Held together before the belly."""
    height, depth = chance.uniform(93.0, 103.0), chance.uniform(20.5, 22.5)
    left = reaching_arm(rig, wrist=(8.5, height, depth), elbow=(1.0, -0.2, -0.5), roll=35)
    right = reaching_arm(rig, wrist=(8.5, height + 2.0, depth + 1.5), elbow=(1.0, -0.2, -0.5), roll=35)
    return _stance(chance) | left | other_side(right)


def _arms_crossed(rig: Rig, chance: Chance) -> Turns:
    height = chance.uniform(113.0, 116.0)
    left = reaching_arm(
        rig, wrist=(-4.0, height, 21.5), elbow=(1.0, -0.8, -0.1), roll=30, fingers=(-1.0, 0.0, -0.35)
    )
    right = reaching_arm(
        rig, wrist=(-2.0, height + 2.5, 27.0), elbow=(1.0, -0.8, 0.1), roll=30, fingers=(-1.0, 0.1, -0.4)
    )
    return _stance(chance) | left | other_side(right)


def _in_pockets(rig: Rig, chance: Chance) -> Turns:
    def pocket() -> Turns:
        wrist = (chance.uniform(21.0, 22.5), chance.uniform(93.0, 96.0), chance.uniform(4.0, 8.0))
        return reaching_arm(rig, wrist=wrist, elbow=(0.9, 0.0, -0.9), roll=10, fingers=(0.1, -1.0, 0.1))

    stance = _stance(chance) if chance.random() < 0.5 else _weight_on_right(chance, 4.0)
    right = pocket() if chance.random() < 0.6 else _hanging(rig, chance, 15, 22)
    return stance | pocket() | other_side(right)


def _behind_back(rig: Rig, chance: Chance) -> Turns:
    def hand(depth: float) -> Turns:
        return reaching_arm(rig, wrist=(12.0, 97.0, depth), elbow=(1.0, 0.0, -0.35), roll=20)

    return _stance(chance) | hand(-20.0) | other_side(hand(-21.5))


def _arm_bent(rig: Rig, chance: Chance) -> Turns:
    """The left forearm lifted, as with a bag or a telephone."""
    lifted = arm(
        rig,
        out=chance.uniform(16, 26),
        forward=chance.uniform(-6, 14),
        inward=chance.uniform(-10, 30),
        bend=chance.uniform(60, 100),
    )
    stance = _stance(chance) if chance.random() < 0.5 else _weight_on_right(chance)
    return stance | lifted | other_side(_hanging(rig, chance, 14, 22))


def _arm_raised(rig: Rig, chance: Chance) -> Turns:
    """The left hand at the hair or waving."""
    lifted = arm(
        rig,
        out=chance.uniform(72, 92),
        forward=chance.uniform(5, 20),
        inward=chance.uniform(-88, -70),
        bend=chance.uniform(85, 120),
    )
    return _weight_on_right(chance) | lifted | other_side(_hanging(rig, chance, 14, 22))


POSES: dict[str, tuple[_Maker, float]] = {
    "arms_down": (_arms_down, 4.0),
    "arms_away": (_arms_away, 1.5),
    "contrapposto": (_contrapposto, 3.0),
    "walking": (_walking, 3.0),
    "hand_on_hip": (_hand_on_hip, 2.0),
    "hands_on_hips": (_hands_on_hips, 0.7),
    "hands_in_front": (_hands_in_front, 1.2),
    "arms_crossed": (_arms_crossed, 0.7),
    "hands_in_pockets": (_in_pockets, 1.8),
    "hands_behind_back": (_behind_back, 1.0),
    "arm_bent": (_arm_bent, 1.5),
    "arm_raised": (_arm_raised, 0.6),
}
"""Name: how it is made, and how often it is drawn among the others."""
