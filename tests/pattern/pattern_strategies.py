"""Hypothesis strategies for curves, panels and whole patterns."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from swifttailor.pattern import Arc, Cubic, EdgeRef, Line, Pattern, Placement, Quadratic, Stitch
from swifttailor.pattern import curve as curves
from swifttailor.pattern.panel import Edge, Panel


def numbers(low, high):
    return st.floats(low, high, allow_nan=False, allow_infinity=False, width=64)


relative_points = st.tuples(numbers(-0.5, 1.5), numbers(-1.0, 1.0))
lines = st.just(Line())
quadratics = st.builds(Quadratic, relative_points)
cubics = st.builds(Cubic, relative_points, relative_points)
flags = st.booleans()


@st.composite
def chords(draw):
    """Start and end (2, 2) between 0.01 and 200 cm apart."""
    start = np.array(draw(st.tuples(numbers(-100, 100), numbers(-100, 100))))
    angle, length = draw(numbers(0, 2 * np.pi)), draw(st.sampled_from([0.01, 1.0, 17.3, 200.0]))
    return np.array([start, start + length * np.array([np.cos(angle), np.sin(angle)])])


@st.composite
def shaped_edges(draw, kinds=("line", "quadratic", "cubic", "arc")):
    """A curve and its chord; arcs are wide enough for the chord, from semicircles to nearly straight.

    None turns back on itself: lengths near such a cusp are exact to a millionth, and no seam has one.
    """
    chord = draw(chords())
    kind = draw(st.sampled_from(kinds))
    if kind == "arc":
        half = float(np.hypot(*(chord[1] - chord[0]))) / 2
        curve = Arc(half * draw(numbers(1.001, 50.0)), draw(flags), draw(flags))
    else:
        curve = draw({"line": lines, "quadratic": quadratics, "cubic": cubics}[kind].filter(runs_on))
    return curve, chord


def runs_on(curve):
    """Whether a curve never slows down as at a cusp."""
    points = curves.evaluate(curve, np.array([[0.0, 0.0], [1.0, 0.0]]), np.linspace(0, 1, 201))
    steps = np.hypot(*np.diff(points, axis=0).T)
    return steps.min() > 0.02 * steps.mean()


@st.composite
def panels(draw, name="panel"):
    """A panel with 3 to 7 corners on a rough circle, its edges of all kinds, gently curved."""
    count = draw(st.integers(3, 7))
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    radii = np.array([draw(numbers(10, 60)) for _ in range(count)])
    vertices = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    if draw(flags):
        vertices = vertices[::-1]
    edges = []
    for k in range(count):
        length = float(np.hypot(*(vertices[(k + 1) % count] - vertices[k])))
        bulge = st.tuples(numbers(0.1, 0.9), numbers(-0.1, 0.1))
        curve = draw(
            st.one_of(
                lines,
                st.builds(Quadratic, bulge),
                st.builds(Cubic, bulge, bulge),
                st.builds(lambda f, r, c=length: Arc(c * f, False, r), numbers(1.5, 20), flags),
            )
        )
        edges.append(Edge(curve, draw(st.sampled_from(["", "", "lower_interface"]))))
    placement = Placement(
        draw(st.tuples(numbers(-200, 200), numbers(0, 200), numbers(-200, 200))),
        draw(st.tuples(*[st.sampled_from([0.0, -0.0, 45.48, 90.0, -180.0])] * 3)),
    )
    return Panel(name, vertices, tuple(edges), placement, draw(st.sampled_from(["", "body", "leg", "arm"])))


@st.composite
def patterns(draw):
    """One to four panels in any order, with stitches of edges drawn without repetition."""
    names = draw(st.lists(st.sampled_from(["wb_front", "left_ftorso", "p2", "p10", "ärmel"]), min_size=1,
                          max_size=4, unique=True))  # fmt: skip
    made = tuple(draw(panels(name)) for name in names)
    edges = [EdgeRef(p.name, k) for p in made for k in range(len(p.edges))]
    edges = draw(st.permutations(edges))
    count = draw(st.integers(0, len(edges) // 2))
    stitches = [Stitch(edges[2 * k], edges[2 * k + 1], draw(flags)) for k in range(count)]
    return Pattern(made, tuple(stitches), "drawn")
