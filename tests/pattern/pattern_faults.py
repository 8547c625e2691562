"""Small patterns with exactly one fault each, and the nearest sound ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import Arc, EdgeRef, Line, Pattern, Placement, Quadratic, Stitch
from swifttailor.pattern.panel import Edge, Panel

HALF_TURN = (0.0, 180.0, 0.0)


def panel(name, vertices, curves=None, z=25.0, **placement):
    """A panel 80 cm up, in front of the body, its edges straight but for ``curves`` {edge: curve}."""
    edges = tuple(Edge((curves or {}).get(k, Line())) for k in range(len(vertices)))
    return Panel(name, vertices, edges, Placement((0.0, 80.0, z), **placement))


def box(name, width=40.0, height=60.0, z=25.0, curves=None):
    """A rectangle: bottom 0, right 1, top 2, left 3."""
    w = width / 2
    return panel(name, [[-w, 0], [w, 0], [w, height], [-w, height]], curves, z)


def lone(vertices, curves=None):
    """A pattern of one panel."""
    return Pattern((panel("front", vertices, curves),))


def sew(a, i, b, j, right_wrong=False):
    return Stitch(EdgeRef(a, i), EdgeRef(b, j), right_wrong)


def tube(front=None, back=None, stitches=None):
    """Front and back box, sewn at both sides; the back is wound clockwise and faces backwards."""
    front = front or box("front")
    back = back or box("back", z=-25.0).reversed()
    sides = (sew("front", 1, "back", 2), sew("front", 3, "back", 0))
    return Pattern((front, back), sides if stitches is None else tuple(stitches))


def skirt(flip=()):
    """Front and back of two pieces each, sewn in one chain at the sides: edges 1, 2 and 4, 5 of each."""
    corners = [[-20, 0], [20, 0], [19, 30], [16, 60], [-16, 60], [-19, 30]]
    front = panel("front", corners)
    back = panel("back", corners, z=-25.0).reversed()
    pairs = [(1, 4), (2, 3), (4, 1), (5, 0)]
    stitches = [sew("front", i, "back", j, k in flip) for k, (i, j) in enumerate(pairs)]
    return Pattern((front, back), tuple(stitches))


def cross_at_corner(reach):
    """A box whose corner 2 pokes ``reach`` cm through its left edge (negative: it stays inside)."""
    return lone([[-20, 0], [20, 0], [-20 - reach, 30], [20, 60], [-20, 60]])


def bow_tie():
    return lone([[0, 0], [30, 0], [0, 40], [30, 40]])


def with_zero_edge(length=0.0, both=True):
    """Front and back whose side seam is split by an edge of the given length on both sides (or one)."""
    right = [[20, 0], [20, 30], [20, 30 + length], [20, 60]]
    front = panel("front", [[-20, 0], *right, [-20, 60]])
    other = [[20, 0], [20, 30], [20, 30 + length if both else 40], [20, 60]]
    back = panel("back", [[-20, 0], *other, [-20, 60]], z=-25.0).reversed()
    pairs = [(1, 4), (2, 3), (3, 2), (5, 0)]
    return Pattern((front, back), tuple(sew("front", i, "back", j) for i, j in pairs))


def wound_alike():
    """The tube with its back wound like its front, as programs that wind every panel alike write it."""
    back = box("back", z=-25.0)
    return tube(back=back, stitches=[sew("front", 1, "back", 1), sew("front", 3, "back", 3)])


def turned_front():
    """The tube with its front placed upside down."""
    front = box("front")
    turned = replace(front, placement=Placement((0.0, 140.0, 25.0), (0.0, 0.0, 180.0)))
    return tube(front=turned)


def dart(right_wrong=False):
    """A box with a dart at the top: edges 3 and 4 meet at its tip."""
    corners = [[-20, 0], [20, 0], [20, 60], [3, 60], [0, 45], [-3, 60], [-20, 60]]
    return Pattern((panel("front", corners),), (sew("front", 3, "front", 4, right_wrong),))


def narrow_ring(width):
    """A triangle strip whose sides are sewn together, which closes its bottom edge to a ring."""
    return Pattern((panel("front", [[0, 0], [width, 0], [width / 2, 50]]),), (sew("front", 1, "front", 2),))


def scaled_lone(size):
    return lone(np.array([[0, 0], [size, 0], [size, size / 2], [0, size / 2]], float))


# code: (severity, faulty pattern, nearest sound pattern)
FAULTS = {
    "zero-length-edge": ("error", with_zero_edge(1e-7), with_zero_edge(0.011)),
    "sliver-edge": ("warning", with_zero_edge(0.009), with_zero_edge(0.011)),
    "short-radius": (
        "warning",
        lone([[0, 0], [40, 0], [40, 60], [0, 60]], {1: Arc(29.9, False, True)}),
        lone([[0, 0], [40, 0], [40, 60], [0, 60]], {1: Arc(29.9999, False, True)}),
    ),
    "no-area": ("error", lone([[0, 0], [40, 0], [20, 0]]), lone([[0, 0], [40, 0], [20, 0.5]])),
    "sliver-panel": (
        "warning",
        lone([[0, 0], [40, 0], [40, 0.05], [0, 0.05]]),
        lone([[0, 0], [40, 0], [40, 0.15], [0, 0.15]]),
    ),
    "self-crossing": ("error", bow_tie(), lone([[0, 0], [30, 0], [30, 40], [0, 40]])),
    "near-crossing": ("warning", cross_at_corner(0.03), cross_at_corner(-0.03)),
    "self-touching": ("info", cross_at_corner(0.0), cross_at_corner(-0.03)),
    "oversized-panel": ("warning", scaled_lone(401.0), scaled_lone(399.0)),
    "tiny-pattern": ("warning", scaled_lone(4.9), scaled_lone(5.1)),
    "dangling-stitch": (
        "error",
        tube(stitches=[sew("front", 1, "back", 2), sew("front", 3, "back", 4)]),
        tube(),
    ),
    "self-stitched-edge": (
        "error",
        tube(stitches=[sew("front", 1, "back", 2), sew("front", 3, "front", 3)]),
        tube(),
    ),
    "duplicate-stitch": ("error", tube(stitches=[*tube().stitches, sew("back", 2, "front", 1)]), tube()),
    "edge-stitched-twice": (
        "error",
        tube(stitches=[*tube().stitches, sew("front", 1, "back", 3)]),
        tube(stitches=[*tube().stitches, sew("front", 2, "back", 1)]),
    ),
    "uneven-seam": (
        "warning",
        tube(front=box("front", height=60), back=box("back", height=14, z=-25).reversed()),
        tube(front=box("front", height=60), back=box("back", height=16, z=-25).reversed()),
    ),
    "twisted-seam": ("warning", skirt(flip=[1]), skirt()),
    "collapsed-edge": ("warning", narrow_ring(2.9), narrow_ring(3.1)),
    "disconnected": ("warning", tube(stitches=[]), tube()),
    "inside-out-panel": ("warning", wound_alike(), tube()),
    "turned-panel": ("warning", turned_front(), tube()),
    "far-placement": ("warning", tube(front=box("front", z=301.0)), tube(front=box("front", z=299.0))),
}
"""Every code that `check_pattern` finds without a body."""


def bulging(depth):
    """A box whose top edge is split; its left part bulges ``depth`` cm over the left side."""
    return lone(
        [[0, 0], [40, 0], [40, 60], [0, 60]],
        {3: Quadratic((0.5, depth / 30))},
    )
