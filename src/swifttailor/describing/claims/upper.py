"""Claims about the upper part: shoulders, necklines, collars, hoods, bodice."""

from __future__ import annotations

from swifttailor.describing.claims.judgement import Judgement, Predicate
from swifttailor.describing.facts import GarmentFacts, Neckline, NeckShape

_HALF_SHAPES: tuple[NeckShape, ...] = ("round", "v", "square", "trapezoid", "s-curve", "pointed")
PLUNGING_CM = 25.0
"""Below the bust points of the default body."""


def _bare(facts: GarmentFacts, side: str) -> bool:
    torso = facts.torso
    if torso is None:
        return False
    left, right = torso.left_shoulder is None, torso.right_shoulder is None
    return {"both": left and right, "left": left and not right, "right": right and not left}[side]


def _strap(facts: GarmentFacts) -> float | None:
    """Length of the shorter shoulder seam of a sleeveless garment with two shoulders, cm."""
    torso = facts.torso
    if torso is None or facts.left_sleeve or facts.right_sleeve:
        return None
    if torso.left_shoulder is None or torso.right_shoulder is None:
        return None
    return (torso.left_shoulder + torso.right_shoulder) / 2


def _narrow_straps(facts: GarmentFacts, by: Judgement) -> bool:
    strap = _strap(facts)
    return strap is not None and by.below(strap, 4.0, 0.8)


def _wide_straps(facts: GarmentFacts, by: Judgement) -> bool:
    strap = _strap(facts)
    return strap is not None and by.above(strap, 8.5, 1.0)


def _plain(facts: GarmentFacts) -> bool:
    """Whether the neckline is seen as it is cut: without collar or hood."""
    return facts.collar is None and facts.hood is None


def _has_shape(neck: Neckline | None, shape: NeckShape) -> bool:
    return neck is not None and neck.shape == shape


def _front_shape(shape: NeckShape) -> Predicate:
    def test(facts: GarmentFacts, by: Judgement) -> bool:
        neck = facts.front_neck
        # A square or pointed cut that is hardly deeper than the neck shows no shape.
        return (
            _plain(facts) and _has_shape(neck, shape) and neck is not None and by.above(neck.depth, 6.0, 1.0)
        )

    return test


def _round(facts: GarmentFacts, by: Judgement) -> bool:
    return _plain(facts) and _has_shape(facts.front_neck, "round")


def _crew(facts: GarmentFacts, by: Judgement) -> bool:
    neck = facts.front_neck
    return (
        _round(facts, by)
        and neck is not None
        and by.below(neck.depth, 11.0, 0.7)
        and by.below(neck.width, 12.6, 0.5)
    )


def _scoop(facts: GarmentFacts, by: Judgement) -> bool:
    neck = facts.front_neck
    return _round(facts, by) and neck is not None and by.above(neck.depth, 15.0, 1.5)


def _boat(facts: GarmentFacts, by: Judgement) -> bool:
    neck = facts.front_neck
    return (
        _plain(facts)
        and neck is not None
        and neck.shape in ("round", "straight")
        and by.above(neck.width, 13.6, 0.6)
        and by.below(neck.depth, 0.95 * neck.width, 0.5)
    )


def _two_shapes(facts: GarmentFacts, by: Judgement) -> bool:
    """Halves of different shapes that both can be named."""
    neck = facts.front_neck
    if not _plain(facts) or neck is None or neck.left is None or neck.right is None:
        return False
    shapes = {neck.left.shape, neck.right.shape}
    return len(shapes) == 2 and (by.strictness < 0 or "other" not in shapes)


def _half_shape(side: str, shape: NeckShape) -> Predicate:
    """Shape of one half of the front neckline where the halves differ or the other shoulder is bare."""

    def test(facts: GarmentFacts, by: Judgement) -> bool:
        neck = facts.front_neck
        if not _plain(facts) or neck is None or neck.shape is not None:
            return False
        half = neck.left if side == "left" else neck.right
        return half is not None and half.shape == shape

    return test


def _depth(neck: Neckline | None) -> float:
    return neck.depth if neck is not None else 0.0


def _shown_depth(facts: GarmentFacts, face: str) -> float | None:
    """Depth of a neckline that is seen: two shoulders, no hood, and no collar but lapels in front, cm."""
    neck = facts.front_neck if face == "front" else facts.back_neck
    if neck is None or neck.left is None or neck.right is None or facts.hood is not None:
        return None
    if facts.collar is not None and (face == "back" or facts.collar.kind != "lapel"):
        return None
    return neck.depth


def _deeper(face: str, bound: float, tolerance: float) -> Predicate:
    def test(facts: GarmentFacts, by: Judgement) -> bool:
        depth = _shown_depth(facts, face)
        return depth is not None and by.above(depth, bound, tolerance)

    return test


def _shallower(face: str, bound: float, tolerance: float) -> Predicate:
    def test(facts: GarmentFacts, by: Judgement) -> bool:
        depth = _shown_depth(facts, face)
        return depth is not None and by.below(depth, bound, tolerance)

    return test


def _back_shape(shape: NeckShape) -> Predicate:
    def test(facts: GarmentFacts, by: Judgement) -> bool:
        return (
            _plain(facts)
            and _has_shape(facts.back_neck, shape)
            and by.above(_depth(facts.back_neck), 6.5, 1.0)
        )

    return test


def _armholes(facts: GarmentFacts, shape: str) -> bool:
    """Whether all armholes without a sleeve have that shape, and there is one."""
    torso = facts.torso
    holes = [a for a in (torso.left_armhole, torso.right_armhole) if a] if torso else []
    return bool(holes) and all(a.shape == shape for a in holes)


def _deep_armholes(facts: GarmentFacts, by: Judgement) -> bool:
    torso = facts.torso
    holes = [a for a in (torso.left_armhole, torso.right_armhole) if a] if torso else []
    return len(holes) == 2 and by.above(min(a.depth for a in holes), 25.0, 2.0)


def _collar(kind: str) -> Predicate:
    return lambda facts, by: facts.collar is not None and facts.collar.kind == kind


def _turtleneck(facts: GarmentFacts, by: Judgement) -> bool:
    """A stand that is high and starts close to the neck."""
    return (
        facts.collar is not None
        and facts.collar.kind == "stand"
        and by.above(facts.collar.height, 5.0, 0.5)
        and by.below(_depth(facts.front_neck), 17.0, 1.0)
        and by.below(_depth(facts.back_neck), 9.0, 1.0)
    )


def _collarless(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and _plain(facts)


def _no_hood(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and facts.hood is None


def _darted(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and facts.torso.darts >= 4


def _flared_torso(facts: GarmentFacts, by: Judgement) -> bool:
    """Widens from chest to a free hem."""
    torso = facts.torso
    return (
        torso is not None
        and facts.skirt is None
        and facts.trousers is None
        and facts.waistband is None
        and by.above(torso.lower_edge - torso.chest, 17.0, 4.0)
    )


def _tapered_torso(facts: GarmentFacts, by: Judgement) -> bool:
    torso = facts.torso
    return (
        torso is not None
        and not torso.darts
        and facts.skirt is None
        and facts.trousers is None
        and facts.waistband is None
        and by.below(torso.lower_edge - torso.chest, -8.0, 3.0)
    )


def _bloused(facts: GarmentFacts, by: Judgement) -> bool:
    return facts.torso is not None and by.above(facts.torso.gather, 1.25, 0.08)


UPPER_CLAIMS: dict[str, tuple[str, dict[str, Predicate]]] = {
    "shoulders": (
        "which shoulders are covered",
        {
            "both": lambda f, by: f.torso is not None
            and not any(_bare(f, s) for s in ("both", "left", "right")),
            "strapless": lambda f, by: _bare(f, "both"),
            "bare left": lambda f, by: _bare(f, "left"),
            "bare right": lambda f, by: _bare(f, "right"),
        },
    ),
    "straps": (
        "width of the shoulders of a sleeveless garment",
        {"narrow": _narrow_straps, "wide": _wide_straps},
    ),
    "neckline": (
        "shape of the front neckline, both halves alike, without collar or hood",
        {
            "round": _round,
            "crew": _crew,
            "scoop": _scoop,
            "boat": _boat,
            "v": _front_shape("v"),
            "square": _front_shape("square"),
            "trapezoid": _front_shape("trapezoid"),
            "s-curve": _front_shape("s-curve"),
            "pointed": _front_shape("pointed"),
            "asymmetric": _two_shapes,
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
            "high": _shallower("front", 11.5, 1.0),
            "low": _deeper("front", 17.0, 2.0),
            "plunging": _deeper("front", PLUNGING_CM, 2.0),
        },
    ),
    "back_neckline": (
        "shape of the back neckline where it is deep enough to have one",
        {"round": _back_shape("round"), "v": _back_shape("v"), "square": _back_shape("square")},
    ),
    "back_depth": (
        "how deep the back neckline is, where it is seen",
        {
            "high": _shallower("back", 7.0, 1.0),
            "low": _deeper("back", 15.0, 2.0),
            "open": _deeper("back", 26.0, 2.0),
        },
    ),
    "collar": (
        "collars",
        {
            "none": _collarless,
            "stand": _collar("stand"),
            "turtleneck": _turtleneck,
            "lapel": _collar("lapel"),
        },
    ),
    "hood": ("hoods", {"none": _no_hood, "hood": lambda f, by: f.hood is not None}),
    "armholes": (
        "armholes of a garment without sleeves",
        {
            "round": lambda f, by: _armholes(f, "round"),
            "square": lambda f, by: _armholes(f, "square"),
            "angled": lambda f, by: _armholes(f, "angled"),
            "deep": _deep_armholes,
        },
    ),
    "bodice": (
        "how the upper part is shaped",
        {
            "darted": _darted,
            "undarted": lambda f, by: f.torso is not None and f.torso.darts == 0,
            "flared": _flared_torso,
            "tapered": _tapered_torso,
            "gathered": _bloused,
        },
    ),
}
"""About, and the values with their tests."""
