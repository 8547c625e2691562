"""Two-piece sleeves whose caps are fitted to the armhole."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline, Point

ARM_Z = -1.5
"""z of the middle of the arm near the shoulder, cm."""
CLEARANCE = 14.0
"""Distance of the sleeve panels from the middle of the arm before draping, cm."""
GAP = 5.0
"""Distance of the sleeve from the armhole before draping, along the arm, cm."""
LIFT = 0.8
"""Height of the sleeve's upper seam over the shoulder tip before draping, across the arm, cm."""
LOWEST_CAP = 3.0
"""Lowest sleeve cap, cm."""
_BENDS = 0.45
"""Where along the arm, from the underarm on, the lower edge of a trailing sleeve bends down."""
_PLUMB = 0.4
"""How far its end is turned from square to the arm to straight down; farther, an arm would seem raised."""
HIGHEST_CAP = 17.0
"""Highest sleeve cap, cm."""


@dataclass(frozen=True)
class Sleeve:
    """How the sleeves are cut."""

    length: float
    """From the shoulder tip along the arm to the sleeve's end, cm; without a cuff."""
    arm_ease: float
    """On top of the upper arm girth, cm around."""
    end_width: float
    """Width around at the end, cm; never wider than at the underarm."""
    cap_ease: float
    """Part by which the cap is longer than the armhole, such as 0.03."""
    shoulder_extension: float = 0.0
    """How far the armhole already lies beyond the shoulder tip, cm."""
    flare: float = 0.0
    """By how much the end is wider than the underarm, cm around, whatever `end_width` says; 0 for nothing."""
    close_below_elbow: bool = False
    """Whether it narrows above the elbow and is as close as at its end from there on, as a leg of mutton."""
    fan: float = 0.0
    """How far the upper seam leans away from the arm at its end, so that cloth falls in ripples there, cm."""
    trails: float = 0.0
    """How far its end hangs down below the arm, cm; 0 for nothing."""


@dataclass(frozen=True)
class Cap:
    """A fitted sleeve cap: its height along the arm and half widths, cm."""

    height: float
    front: float
    back: float


def lay_sleeve(table: CuttingTable, figure: Figure, shape: Sleeve) -> None:
    """Lays the left sleeve and sews it to the left torso, which must already lie on the table.

    Edges of ``left_sleeve_f`` and ``left_sleeve_b``: under, hem, top, cap.
    """
    length = max(shape.length - shape.shoulder_extension, LOWEST_CAP + 4.0)
    holes = [(1 + shape.cap_ease) * table.length(f"left_{side}torso.armhole") for side in "fb"]
    cap = fit_cap(holes[0], holes[1], figure.upper_arm + shape.arm_ease, min(HIGHEST_CAP, length - 3.0))
    narrowing = max((cap.front + cap.back - shape.end_width) / 2, 0.0)
    narrowing = -shape.flare / 2 if shape.flare else min(narrowing, min(cap.front, cap.back) - 3.0)
    for side in "fb":
        outline = sleeve_outline(
            cap, length, narrowing, front=side == "f", early=shape.close_below_elbow, fan=shape.fan
        )
        if shape.trails:
            outline = _trailing_outline(cap, length, shape.trails, figure.arm_angle, front=side == "f")
        place_on_arm(table, figure, f"left_sleeve_{side}", outline)
        table.seam(f"left_{side}torso.armhole", f"left_sleeve_{side}.cap", gathered=True)
    table.seam("left_sleeve_f.top", "left_sleeve_b.top")
    table.seam("left_sleeve_f.under", "left_sleeve_b.under")


def sleeve_outline(
    cap: Cap, length: float, narrowing: float, *, front: bool, early: bool = False, fan: float = 0.0
) -> Outline:
    """Draws one half of a sleeve, x along the arm from the shoulder tip and y across it.

    Edges: under, hem, top, cap.

    Args:
        cap: The fitted cap.
        length: From the shoulder tip to the end, cm; more than the height of the cap.
        narrowing: From the underarm to the end, cm.
        front: Which half.
        early: Whether most of it narrows in the upper half of the underarm seam.
        fan: How far the upper seam leans away from the arm at its end, cm.
    """
    half = cap.front if front else cap.back
    outline = Outline(cap.height, -half)
    end, low = (length, -half + narrowing), length - cap.height
    if early:
        first = (cap.height + 0.2 * low, -half + 0.75 * narrowing)
        outline.cubic("under", first, (cap.height + 0.45 * low, -half + narrowing), end)
    else:
        outline.line("under", *end)
    if fan:
        # All of the hem is as far from the shoulder as its middle is.
        low = -half + narrowing
        outline.cubic("hem", (length + 0.3 * fan, low / 2), (length + 0.3 * fan, 0.4 * fan), (length, fan))
    else:
        outline.line("hem", length, 0.0)
    outline.line("top", 0.0, 0.0)
    _cap_curve(outline, cap.height, half, front)
    return outline.closed()


def _trailing_outline(cap: Cap, length: float, trails: float, angle: float, *, front: bool) -> Outline:
    """Draws one half of a sleeve whose end hangs down from an arm that is held out.

    Args:
        cap: The fitted cap.
        length: From the shoulder tip to the end on top, cm.
        trails: How far the end hangs down, cm.
        angle: Of the arm below the horizon, degrees.
        front: Which half.
    """
    half = cap.front if front else cap.back
    lean = math.radians(_PLUMB * angle)
    down = (math.sin(lean), -math.cos(lean))
    # Both halves have the same lower edge, which is sewn; their free ends differ as their widths do.
    beside = (cap.front + cap.back) / 2 - half
    point = (length + trails * down[0], trails * down[1] + beside)
    bend = cap.height + _BENDS * (length - cap.height)
    outline = Outline(cap.height, -half)
    outline.cubic("under", (bend, -half), (bend + 0.3 * (point[0] - bend), 0.5 * (point[1] - half)), point)
    outline.line("hem", length, 0.0).line("top", 0.0, 0.0)
    _cap_curve(outline, cap.height, half, front)
    return outline.closed()


def place_on_arm(
    table: CuttingTable,
    figure: Figure,
    name: str,
    outline: Outline,
    *,
    tip: Point | None = None,
) -> None:
    """Lays a panel drawn with x along the arm from the shoulder tip and y across it.

    Args:
        table: Must already hold the left torso, whose armhole says where the arm begins.
        figure: Gives the arm's direction.
        name: Panel name; those ending in ``_b`` stand behind the arm.
        outline: Closed counter-clockwise outline.
        tip: Of the shoulder, local cm; None where the armhole of the torso reaches it.
    """
    back = name.endswith("_b")
    tip = tip or max((s.end for s in table.pieces["left_ftorso"].find("armhole")), key=lambda p: p[1])
    angle = math.radians(figure.arm_angle)
    along, up = (math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))
    x, y = (tip[k] + GAP * along[k] + LIFT * up[k] for k in (0, 1))
    z = ARM_Z + (-CLEARANCE if back else CLEARANCE + 3.0)
    rotation = (0.0, 0.0, -figure.arm_angle)
    table.lay(name, outline, label="arm", at=(x, y, z), rotation=rotation, back=back)


def fit_cap(front: float, back: float, width: float, highest: float) -> Cap:
    """Finds the cap whose curves have the given lengths and which is `width` cm around at the underarm.

    A higher cap makes a narrower sleeve. Where no height from `LOWEST_CAP` to `highest` gives the width, the
    nearest height is used and the width follows.
    """

    def at(height: float) -> Cap:
        return Cap(height, _half_width(height, front, True), _half_width(height, back, False))

    def excess(height: float) -> float:
        cap = at(height)
        return cap.front + cap.back - width

    highest = max(min(highest, 0.75 * min(front, back)), LOWEST_CAP)
    if excess(LOWEST_CAP) <= 0:
        return at(LOWEST_CAP)
    if excess(highest) >= 0:
        return at(highest)
    return at(find_root(excess, LOWEST_CAP, highest, 1e-4))


def _cap_curve(outline: Outline, height: float, half: float, front: bool) -> None:
    """Draws the S from the top of the cap to the underarm; the front is hollowed out more than the back."""
    top, under = (0.42, 0.5) if front else (0.5, 0.38)
    outline.cubic("cap", (0.0, -top * half), (height, -(1 - under) * half), (height, -half))


def _half_width(height: float, length: float, front: bool) -> float:
    """Half width at which the cap curve has the given length, cm."""

    def excess(half: float) -> float:
        outline = Outline(0.0, 0.0)
        _cap_curve(outline, height, half, front)
        return outline.sides[0].length - length

    return find_root(excess, 0.3 * length, length, 1e-9)


def find_root(function: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    """Where a function is zero between two places that it has different signs at."""
    from scipy.optimize import brentq  # takes a tenth of a second to load

    root = brentq(function, low, high, xtol=tolerance)
    assert isinstance(root, float)
    return root
