"""Claims about the upper part: shoulders, necklines, collars, hoods, bodice."""

from __future__ import annotations

from swifttailor.describing.claims.judgement import (
    Judgement,
    Predicate,
    above,
    all_of,
    below,
    is_one_of,
    missing,
    there,
    where,
)
from swifttailor.describing.dimensions import shoulder_length
from swifttailor.describing.facts import Armhole, GarmentFacts, Neckline
from swifttailor.describing.facts_paths import Measure, measure_of

_HALF_SHAPES = ("round", "v", "square", "trapezoid", "s-curve", "pointed")
PLUNGING_CM = 25.0
"""Below the bust points of the default body."""

_SLEEVELESS = all_of(missing("left_sleeve"), missing("right_sleeve"))
_PLAIN = all_of(missing("collar"), missing("hood"))
"""Whether the neckline is seen as it is cut: without collar or hood."""
_ROUND = all_of(_PLAIN, is_one_of("front_neck.shape", "round"))
_FREE_HEM = all_of(there("torso"), missing("skirt"), missing("trousers"), missing("waistband"))
_FLARE = measure_of("torso", lambda torso: torso.lower_edge - torso.chest)


def _front_shape(shape: str) -> Predicate:
    # A square or pointed cut that is hardly deeper than the neck shows no shape.
    return all_of(_PLAIN, is_one_of("front_neck.shape", shape), above("front_neck.depth", 6.0, 1.0))


def _back_shape(shape: str) -> Predicate:
    return all_of(_PLAIN, is_one_of("back_neck.shape", shape), above("back_neck.depth", 6.5, 1.0))


def _half_shape(side: str, shape: str) -> Predicate:
    """Shape of one half of the front neckline where the halves differ or the other shoulder is bare."""
    return all_of(_PLAIN, missing("front_neck.shape"), is_one_of(f"front_neck.{side}.shape", shape))


def _wider_than_deep(facts: GarmentFacts, by: Judgement) -> bool:
    neck = facts.front_neck
    return neck is not None and by.below(neck.depth, 0.95 * neck.width, 0.5)


def halves_differ(neck: Neckline | None, by: Judgement) -> bool:
    """Whether a neckline has halves of different shapes that both can be named."""
    if neck is None or neck.left is None or neck.right is None:
        return False
    shapes = {neck.left.shape, neck.right.shape}
    return len(shapes) == 2 and (by.strictness < 0 or "other" not in shapes)


def _depth(face: str) -> Measure:
    """Of a neckline, cm; 0 without one."""
    depth = measure_of(f"{face}_neck", lambda neck: neck.depth)
    return lambda facts: depth(facts) or 0.0


def _shown_depth(face: str) -> Measure:
    """Depth of a neckline that is seen: two shoulders, no hood, and no collar but lapels in front, cm."""

    def measure(facts: GarmentFacts) -> float | None:
        neck = facts.front_neck if face == "front" else facts.back_neck
        if neck is None or neck.left is None or neck.right is None or facts.hood is not None:
            return None
        if facts.collar is not None and (face == "back" or facts.collar.kind != "lapel"):
            return None
        return neck.depth

    return measure


def _bare(facts: GarmentFacts) -> list[Armhole]:
    """The armholes without a sleeve."""
    torso = facts.torso
    return [a for a in (torso.left_armhole, torso.right_armhole) if a] if torso else []


def _armholes(shape: str) -> Predicate:
    """Whether all armholes without a sleeve have that shape, and there is one."""
    return lambda facts, by: bool(_bare(facts)) and all(a.shape == shape for a in _bare(facts))


def _deep_armholes(facts: GarmentFacts, by: Judgement) -> bool:
    holes = _bare(facts)
    return len(holes) == 2 and by.above(min(a.depth for a in holes), 25.0, 2.0)


UPPER_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "shoulders": (
        "which shoulders are covered",
        {
            "both": all_of(there("torso.left_shoulder"), there("torso.right_shoulder")),
            "strapless": lambda f, by: f.strapless,
            "bare left": all_of(missing("torso.left_shoulder"), there("torso.right_shoulder")),
            "bare right": all_of(there("torso.left_shoulder"), missing("torso.right_shoulder")),
        },
    ),
    "straps": (
        "width of the shoulders of a sleeveless garment",
        {
            "narrow": all_of(_SLEEVELESS, below(shoulder_length, 4.0, 0.8)),
            "wide": all_of(_SLEEVELESS, above(shoulder_length, 8.5, 1.0)),
        },
    ),
    "neckline": (
        "shape of the front neckline, both halves alike, without collar or hood",
        {
            "round": _ROUND,
            "crew": all_of(
                _ROUND, below("front_neck.depth", 11.0, 0.7), below("front_neck.width", 12.6, 0.5)
            ),
            "scoop": all_of(_ROUND, above("front_neck.depth", 15.0, 1.5)),
            "boat": all_of(
                _PLAIN,
                is_one_of("front_neck.shape", "round", "straight"),
                above("front_neck.width", 13.6, 0.6),
                _wider_than_deep,
            ),
            **{shape: _front_shape(shape) for shape in ("v", "square", "trapezoid", "s-curve", "pointed")},
            "asymmetric": all_of(_PLAIN, lambda f, by: halves_differ(f.front_neck, by)),
        },
    ),
    "left_neckline": (
        "shape of the left half of the front neckline, where it differs from the right or is alone",
        {shape: _half_shape("left", shape) for shape in _HALF_SHAPES},
    ),
    "right_neckline": (
        "the same for the right half",
        {shape: _half_shape("right", shape) for shape in _HALF_SHAPES},
    ),
    "neck_depth": (
        "how deep the front neckline is, where it is seen",
        {
            "high": below(_shown_depth("front"), 11.5, 1.0),
            "low": above(_shown_depth("front"), 17.0, 2.0),
            "plunging": above(_shown_depth("front"), PLUNGING_CM, 2.0),
        },
    ),
    "back_neckline": (
        "shape of the back neckline where it is deep enough to have one",
        {shape: _back_shape(shape) for shape in ("round", "v", "square")},
    ),
    "back_depth": (
        "how deep the back neckline is, where it is seen",
        {
            "high": below(_shown_depth("back"), 7.0, 1.0),
            "low": above(_shown_depth("back"), 15.0, 2.0),
            "open": above(_shown_depth("back"), 26.0, 2.0),
        },
    ),
    "collar": (
        "collars",
        {
            "none": all_of(there("torso"), _PLAIN),
            "stand": is_one_of("collar.kind", "stand"),
            # A stand that is high and starts close to the neck.
            "turtleneck": all_of(
                is_one_of("collar.kind", "stand"),
                above("collar.height", 5.0, 0.5),
                below(_depth("front"), 17.0, 1.0),
                below(_depth("back"), 9.0, 1.0),
            ),
            "lapel": is_one_of("collar.kind", "lapel"),
        },
    ),
    "hood": ("hoods", {"none": all_of(there("torso"), missing("hood")), "hood": there("hood")}),
    "armholes": (
        "armholes of a garment without sleeves",
        {
            **{shape: _armholes(shape) for shape in ("round", "square", "angled")},
            "deep": _deep_armholes,
        },
    ),
    "bodice": (
        "how the upper part is shaped",
        {
            "darted": where("torso.darts", lambda darts: darts >= 4),
            "undarted": where("torso.darts", lambda darts: darts == 0),
            # Widens from the chest to a free hem, or narrows.
            "flared": all_of(_FREE_HEM, above(_FLARE, 17.0, 4.0)),
            "tapered": all_of(
                _FREE_HEM, where("torso.darts", lambda darts: not darts), below(_FLARE, -8.0, 3.0)
            ),
            "gathered": above("torso.gather", 1.25, 0.08),
        },
    ),
}
"""About, and the values with their tests."""
