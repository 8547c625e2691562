"""Patterns for tests of images: hypothesis strategies, hard cases, and garments over them."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Arc, Cubic, Edge, EdgeRef, Line, Panel, Pattern, Quadratic, Stitch

sizes = st.floats(-2.0, 3.1).map(lambda e: 10.0**e)
"""From a tenth of a millimetre to thirteen metres."""


def curved_edges(vertices, curves):
    """An edge per vertex, of a kind (line, quadratic, cubic, arc) and a bulge for each."""
    edges = []
    for k, (kind, bulge) in enumerate(curves):
        chord = float(np.hypot(*(vertices[(k + 1) % len(vertices)] - vertices[k])))
        made = {
            "line": Line(),
            "quadratic": Quadratic((0.5, bulge)),
            "cubic": Cubic((0.3, bulge), (0.7, -bulge)),
            "arc": Arc(chord * (0.6 + 2 * abs(bulge)), False, bulge > 0),
        }[kind]
        edges.append(Edge(made))
    return tuple(edges)


@st.composite
def panels(draw, name, kinds=("line", "quadratic", "cubic", "arc")):
    """A star of 3 to 7 corners, of any size and proportion, in either direction, anywhere."""
    count = draw(st.integers(3, 7))
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False) + draw(st.floats(0, 6))
    radii = np.array([draw(st.floats(0.6, 1.0)) for _ in range(count)])
    unit = radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    vertices = unit * [draw(sizes), draw(sizes)] + [draw(st.floats(-50, 50)), draw(st.floats(-50, 50))]
    if draw(st.booleans()):
        vertices = vertices[::-1]
    curve = st.tuples(st.sampled_from(kinds), st.floats(-0.1, 0.1))
    return Panel(name, vertices, curved_edges(vertices, [draw(curve) for _ in range(count)]))


@st.composite
def patterns(draw, most=8):
    """Up to `most` panels, and stitches of edges drawn without repetition."""
    made = tuple(draw(panels(f"p{k}")) for k in range(draw(st.integers(1, most))))
    edges = draw(st.permutations([EdgeRef(p.name, k) for p in made for k in range(len(p.edges))]))
    pairs = list(zip(edges[::2], edges[1::2], strict=False))
    pairs = pairs[: draw(st.integers(0, len(pairs)))]
    return Pattern(made, tuple(Stitch(a, b, draw(st.booleans())) for a, b in pairs))


def rectangle(name, width, height, x=0.0, y=0.0, clockwise=False):
    corners = np.array([[x, y], [x + width, y], [x + width, y + height], [x, y + height]])
    return Panel(name, corners[::-1] if clockwise else corners, (Edge(),) * 4)


def dart_pattern():
    """A skirt front with a dart, its back clockwise, sewn at the sides; a band gathered onto the front."""
    front = Panel(
        "skirt_front",
        np.array([[0, 0], [40, 0], [38, 50], [24, 52], [20, 38], [16, 52], [2, 50]], float),
        (Edge(Quadratic((0.5, -0.05))), *(Edge(),) * 5, Edge(Cubic((0.3, 0.04), (0.6, -0.03)))),
    )
    back = Panel(
        "skirt_back",
        np.array([[9.3, 47.9], [45.3, 48.9], [47.3, -2.1], [7.3, -2.1]]),
        (Edge(), Edge(), Edge(Arc(60.0, False, False)), Edge()),
    )
    stitches = (
        Stitch(EdgeRef("skirt_front", 3), EdgeRef("skirt_front", 4)),
        Stitch(EdgeRef("skirt_front", 1), EdgeRef("skirt_back", 1)),
        Stitch(EdgeRef("skirt_front", 6), EdgeRef("skirt_back", 3)),
        Stitch(EdgeRef("skirt_front", 2), EdgeRef("wb_front", 0)),
    )
    return Pattern((front, back, rectangle("wb_front", 12.0, 4.0)), stitches, "skirt")


def right_wrong_pattern():
    """Two squares, one of whose stitches joins the right side to the wrong side."""
    squares = (rectangle("left_ftorso", 20.0, 30.0), rectangle("left_collar_front", 20.0, 10.0, 5.0, 5.0))
    return Pattern(squares, (Stitch(EdgeRef("left_ftorso", 2), EdgeRef("left_collar_front", 2), True),))


def sleeve_pattern():
    """A sleeve of one panel, closed along its length onto itself."""
    vertices = np.array([[0, 0], [30, 0], [34, 45], [17, 55], [-4, 45]], float)
    edges = (Edge(), Edge(), Edge(Quadratic((0.5, -0.2))), Edge(Quadratic((0.5, -0.2))), Edge())
    panel = Panel("left_sleeve_f", vertices, edges)
    return Pattern((panel,), (Stitch(EdgeRef("left_sleeve_f", 1), EdgeRef("left_sleeve_f", 4)),), "sleeve")


def sliver_pattern():
    """A cuff of a tenth of a millimetre between a sleeve and its frill, and a panel of thirteen metres."""
    panels = (
        rectangle("left_sleeve_f", 24.0, 40.0),
        rectangle("sl_left_cuff_f", 24.0, 0.01),
        rectangle("sl_left_cuff_skirt_f", 30.0, 9.0, clockwise=True),
        rectangle("skirt_front_0", 1300.0, 30.0),
    )
    stitches = (
        Stitch(EdgeRef("left_sleeve_f", 0), EdgeRef("sl_left_cuff_f", 2)),
        Stitch(EdgeRef("sl_left_cuff_f", 0), EdgeRef("sl_left_cuff_skirt_f", 0)),
    )
    return Pattern(panels, stitches, "sliver")


HARD_CASES = {
    "dart": dart_pattern,
    "right_wrong": right_wrong_pattern,
    "sleeve": sleeve_pattern,
    "sliver": sliver_pattern,
}


def any_garment(pattern, edge_length=3.0, seed=0):
    """A garment over a pattern whose vertices are where chance puts them."""
    mesh = mesh_pattern(pattern.canonical(), edge_length)
    vertices = np.random.default_rng(seed).normal(0.0, 50.0, (mesh.vertex_count, 3))
    return Garment(mesh, vertices, {"edge_length_cm": edge_length})
