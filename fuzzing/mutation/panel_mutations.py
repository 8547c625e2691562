"""Damage to the geometry of a pattern that is sound JSON: what a person or a program could have drawn."""

from __future__ import annotations

import copy
import math
from itertools import pairwise
from random import Random
from typing import Any

_LENGTHS = (0.0, 1e-9, 1e-6, 1e-3, 0.01, 0.05, 0.1, 1.0, 10.0, 100.0, 1e4, 1e7)
_ANGLES = (0, 90, -90, 180, 359.999, 720, 1e7, 45.48)
_NAMES = ("left_sleeve", "", " ", "x" * 200, "ä" * 40, "p\u200b", "a/b", "[red]", "1", "none", "..", "con")


def mutate_pattern(value: Any, random: Random, most: int = 4) -> Any:
    """A specification, changed in place, with one to `most` pieces of damage."""
    for _ in range(random.randint(1, most)):
        try:
            random.choice(_WAYS)(value["pattern"], value, random)
        except (KeyError, IndexError, TypeError, ValueError, AttributeError):
            pass  # what was there to damage is damaged already
    return value


def _panel(pattern: Any, random: Random) -> tuple[str, dict[str, Any]]:
    name = random.choice(list(pattern["panels"]))
    return name, pattern["panels"][name]


def _offset(random: Random) -> float:
    return random.choice((-1, 1)) * random.choice(_LENGTHS) if random.random() < 0.6 else random.gauss(0, 20)


def _move_vertex(pattern: Any, whole: Any, random: Random) -> None:
    vertices = _panel(pattern, random)[1]["vertices"]
    k = random.randrange(len(vertices))
    if random.random() < 0.3:  # onto another, or onto the middle between two
        one, two = random.choice(vertices), random.choice(vertices)
        vertices[k] = [(a + b) / 2 for a, b in zip(one, two, strict=True)]
    else:
        vertices[k] = [x + _offset(random) for x in vertices[k]]


def _scale(pattern: Any, whole: Any, random: Random) -> None:
    panel = _panel(pattern, random)[1]
    factors = [random.choice((0.0, 1e-6, 1e-3, 0.01, 0.1, 0.5, 2.0, 10.0, 100.0, -1.0)) for _ in range(2)]
    if random.random() < 0.5:
        factors[1] = factors[0]
    panel["vertices"] = [[x * f for x, f in zip(v, factors, strict=True)] for v in panel["vertices"]]


def _curve(pattern: Any, whole: Any, random: Random) -> None:
    edge = random.choice(_panel(pattern, random)[1]["edges"])
    point = [random.choice((0, 0.5, 1, -1, 3, 1e-9, 50, -1e6, random.random())) for _ in range(2)]
    other = [random.choice((0, 0.5, 1, -1, 3, 1e-9, 50, -1e6, random.random())) for _ in range(2)]
    edge["curvature"] = random.choice(
        (
            point,
            {"type": "quadratic", "params": [point]},
            {"type": "cubic", "params": [point, other]},
            {"type": "cubic", "params": [[1 - point[0], point[1]], point]},
            {
                "type": "circle",
                "params": [abs(_offset(random)), random.randrange(2), random.randrange(2)],
            },
        )
    )


def _insert_vertices(pattern: Any, random: Random, count: int, depth: float) -> None:
    """Splits an edge in `count` pieces, its corners `depth` cm to and fro."""
    panel = _panel(pattern, random)[1]
    k = random.randrange(len(panel["edges"]))
    edge = panel["edges"][k]
    start, end = (panel["vertices"][i] for i in edge["endpoints"])
    along = [b - a for a, b in zip(start, end, strict=True)]
    length = math.hypot(*along) or 1.0
    across = [-along[1] / length, along[0] / length]
    first = len(panel["vertices"])
    for i in range(1, count):
        side = depth * (1 if i % 2 else -1) * (random.random() if random.random() < 0.3 else 1)
        panel["vertices"].append(
            [s + a * i / count + side * c for s, a, c in zip(start, along, across, strict=True)]
        )
    corners = [edge["endpoints"][0], *range(first, first + count - 1), edge["endpoints"][1]]
    pieces = [{"endpoints": [a, b]} for a, b in pairwise(corners)]
    panel["edges"][k : k + 1] = pieces
    if random.random() < 0.7:  # the stitches follow; else they mean other edges now
        name = next(n for n, p in pattern["panels"].items() if p is panel)
        for stitch in pattern["stitches"]:
            for side_of in stitch[:2]:
                if side_of["panel"] == name and side_of["edge"] > k:
                    side_of["edge"] += count - 1


def _dense(pattern: Any, whole: Any, random: Random) -> None:
    _insert_vertices(
        pattern, random, random.choice((2, 3, 10, 50, 200)), random.choice((0.0, 0.0, 1e-7, 0.01))
    )


def _jagged(pattern: Any, whole: Any, random: Random) -> None:
    _insert_vertices(
        pattern, random, random.choice((4, 8, 20, 60, 150)), random.choice((0.02, 0.2, 1.0, 5.0, 40.0))
    )


def _reverse_edge(pattern: Any, whole: Any, random: Random) -> None:
    edges = _panel(pattern, random)[1]["edges"]
    edges[random.randrange(len(edges))]["endpoints"].reverse()


def _other_end(pattern: Any, whole: Any, random: Random) -> None:
    panel = _panel(pattern, random)[1]
    edge = random.choice(panel["edges"])
    edge["endpoints"][random.randrange(2)] = random.choice(
        (-1, 0, len(panel["vertices"]), 1e6, 1.5, random.randrange(9))
    )


def _shuffle_edges(pattern: Any, whole: Any, random: Random) -> None:
    edges = _panel(pattern, random)[1]["edges"]
    if random.random() < 0.5:
        edges.append(edges.pop(0))
    else:
        random.shuffle(edges)


def _drop_edge(pattern: Any, whole: Any, random: Random) -> None:
    edges = _panel(pattern, random)[1]["edges"]
    del edges[random.randrange(len(edges))]


def _mirror(pattern: Any, whole: Any, random: Random) -> None:
    panel = _panel(pattern, random)[1]
    panel["vertices"] = [[-v[0], v[1]] for v in panel["vertices"]]


def _place(pattern: Any, whole: Any, random: Random) -> None:
    panel = _panel(pattern, random)[1]
    if random.random() < 0.5:
        panel["translation"] = [_offset(random) for _ in range(3)]
    else:
        panel["rotation"] = [random.choice(_ANGLES) for _ in range(3)]


def _copy_panel(pattern: Any, whole: Any, random: Random) -> None:
    name, panel = _panel(pattern, random)
    for k in range(random.choice((1, 1, 1, 3, 20))):
        pattern["panels"][f"{name}_{k}"] = copy.deepcopy(panel)


def _drop_panel(pattern: Any, whole: Any, random: Random) -> None:
    del pattern["panels"][_panel(pattern, random)[0]]


def _rename_panel(pattern: Any, whole: Any, random: Random) -> None:
    name = _panel(pattern, random)[0]
    new = random.choice(_NAMES)
    pattern["panels"][new] = pattern["panels"].pop(name)
    if random.random() < 0.7:
        for stitch in pattern["stitches"]:
            for side in stitch[:2]:
                side["panel"] = new if side["panel"] == name else side["panel"]


def _stitch_any(pattern: Any, whole: Any, random: Random) -> None:
    sides = []
    for _ in range(2):
        name, panel = _panel(pattern, random)
        sides.append({"panel": name, "edge": random.randrange(len(panel["edges"]) + (random.random() < 0.1))})
    if random.random() < 0.1:
        sides[0]["panel"] = "nobody"
    pattern["stitches"].insert(random.randrange(len(pattern["stitches"]) + 1), sides)


def _stitch_itself(pattern: Any, whole: Any, random: Random) -> None:
    stitch = random.choice(pattern["stitches"])
    stitch[1] = copy.deepcopy(stitch[0])


def _stitch_again(pattern: Any, whole: Any, random: Random) -> None:
    pattern["stitches"].append(copy.deepcopy(random.choice(pattern["stitches"])))


def _swap_sides(pattern: Any, whole: Any, random: Random) -> None:
    one, two = random.choice(pattern["stitches"]), random.choice(pattern["stitches"])
    one[0], two[1] = two[1], one[0]


def _turn_stitch(pattern: Any, whole: Any, random: Random) -> None:
    stitches = pattern["stitches"]
    k = random.randrange(len(stitches))
    stitches[k] = [*stitches[k][:2], "right_wrong"] if len(stitches[k]) == 2 else stitches[k][:2]


def _drop_stitches(pattern: Any, whole: Any, random: Random) -> None:
    pattern["stitches"] = [s for s in pattern["stitches"] if random.random() < random.choice((0.0, 0.5, 0.9))]


def _units(pattern: Any, whole: Any, random: Random) -> None:
    properties = whole.setdefault("properties", {})
    properties["units_in_meter"] = random.choice((1, 10, 100, 1000, 39.37, 1e-3, 1e5, 0, -100, 1e300))


def _label(pattern: Any, whole: Any, random: Random) -> None:
    _, panel = _panel(pattern, random)
    holder = panel if random.random() < 0.5 else random.choice(panel["edges"])
    holder["label"] = random.choice((*_NAMES, "body", "leg", "arm", "lower_interface", "neck"))


def _order(pattern: Any, whole: Any, random: Random) -> None:
    names = list(pattern["panels"])
    random.shuffle(names)
    pattern["panel_order"] = names[: random.choice((len(names), len(names), 1))]


_WAYS = (
    _move_vertex, _move_vertex, _move_vertex, _scale, _curve, _curve, _dense, _jagged, _reverse_edge,
    _other_end, _shuffle_edges, _drop_edge, _mirror, _place, _place, _copy_panel, _drop_panel, _rename_panel,
    _stitch_any, _stitch_any, _stitch_itself, _stitch_again, _swap_sides, _turn_stitch, _drop_stitches,
    _units, _label, _order,
)  # fmt: skip
