"""Reader of GarmentCode's pattern JSON and of the older files of the same family.

Handles other units (arc radii included), absolute control points, bare-list quadratic curvature, missing
labels and properties, loops whose edges are listed out of order or against their direction, and both
readings of the rotations. What cannot be understood at all raises `PatternError`; what can be read but is
wrong becomes a `Finding`, so that ``swifttailor check`` can show everything at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern import json_values as values
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic, to_relative
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.edge_loop import Loop, RawEdge, order_loop
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.panel import Edge, Panel, Placement, RotationReading
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.trims.names import button_count_read, trims_read

MAX_PANELS = 500
MAX_EDGES_PER_PANEL = 2000
MAX_EDGES = 20_000
"""In the whole pattern: a hundred times the largest one of GarmentCode."""
MAX_STITCHES = 20_000
MAX_CLOTH_STRETCH = 1.0
"""No cloth of garments gives more."""

_PANEL_KEYS = {"translation", "rotation", "vertices", "edges", "label"}
_TOP_KEYS = {"pattern", "parameters", "parameter_order", "properties"}
_EDGE_KEYS = {"endpoints", "curvature", "label"}
_MAX_UNKNOWN_KEYS = 50


@dataclass(frozen=True)
class Reading:
    """A pattern as read, with everything the reader had to say about the file."""

    pattern: Pattern
    findings: tuple[Finding, ...] = ()


@dataclass
class _Context:
    scale: float = 1.0
    absolute_curvature: bool = False
    rotation: RotationReading = "intrinsic"
    findings: list[Finding] = field(default_factory=list)
    edges: int = 0
    unknown_keys: int = 0

    def in_cm(self, number: float, where: str) -> float:
        """A length of the file in cm, refused where the unit makes it larger than any garment."""
        length = number * self.scale
        if abs(length) > values.MAX_ABSOLUTE:
            raise PatternError(
                f"{where}: {length:g} cm is larger than any garment (limit {values.MAX_ABSOLUTE:g}); "
                "check properties.units_in_meter."
            )
        return length


def load_pattern(path: Path | str, *, rotation: RotationReading = "intrinsic") -> Pattern:
    """Reads a sewing pattern from a GarmentCode JSON file.

    Args:
        path: The specification file.
        rotation: How to read the placement angles; see `Placement.reading`.

    Raises:
        InputError: The file cannot be read or is not JSON.
        PatternError: It is no pattern, or one that cannot be sewn as written (an open loop, a stitch to an
            edge that does not exist). ``swifttailor check FILE --repair OUT`` lists and repairs such faults.
    """
    reading = read_pattern_file(path, rotation=rotation)
    errors = [f for f in reading.findings if f.severity is Severity.ERROR]
    if errors:
        more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
        place = f" ({errors[0].where()})" if errors[0].where() else ""
        raise PatternError(
            f"'{path}': {errors[0].message}{place}{more}. "
            f"Repair it with: swifttailor check {path} --repair REPAIRED ({errors[0].repair})."
        )
    return reading.pattern


def read_pattern_file(path: Path | str, *, rotation: RotationReading = "intrinsic") -> Reading:
    """Reads a file like `load_pattern`, but returns faulty patterns too, with their findings."""
    name = Path(path).stem
    for ending in ("_specification", "_spec"):
        name = name.removesuffix(ending)
    try:
        return read_specification(values.read_json_file(path), name=name, rotation=rotation)
    except PatternError as error:
        raise PatternError(f"'{path}': {error}") from error


def read_specification(
    specification: Any, *, name: str = "pattern", rotation: RotationReading = "intrinsic"
) -> Reading:
    """Turns parsed GarmentCode JSON into a `Pattern`.

    Args:
        specification: The parsed top-level object.
        name: Name for the pattern (the format does not hold one).
        rotation: How to read the placement angles.

    Raises:
        PatternError: The structure or a value is not a pattern's; the message gives its place.
    """
    if rotation not in ("intrinsic", "extrinsic"):
        raise PatternError(f"rotation must be 'intrinsic' or 'extrinsic', got {rotation!r}.")
    top = values.as_object(specification, "the file")
    if "pattern" not in top and "panels" in top:
        top = {"pattern": top}  # the inner object alone, as some tools pass it around
    if "pattern" not in top:
        raise PatternError("the file has no 'pattern' object; a GarmentCode pattern is expected.")
    body = values.as_object(top["pattern"], "pattern")
    if "panels" not in body:
        raise PatternError("pattern has no 'panels' object; a GarmentCode pattern is expected.")
    context = _read_properties(top.get("properties", {}), rotation)
    _note_unknown(context, set(top) - _TOP_KEYS, "the file")

    raw_panels = values.as_object(body["panels"], "panels")
    if not raw_panels:
        raise PatternError("panels is empty; a pattern has at least one panel.")
    if len(raw_panels) > MAX_PANELS:
        raise PatternError(f"panels: {len(raw_panels)} panels; at most {MAX_PANELS} are accepted.")
    panels: dict[str, Panel] = {}
    edge_ids: dict[str, dict[int, int]] = {}
    for key, raw in raw_panels.items():
        values.as_text(key, "panel name")
        panels[key], edge_ids[key] = _read_panel(key, raw, context)
    ordered = [panels[n] for n in _panel_order(body.get("panel_order"), panels, context)]
    stitches = _read_stitches(body.get("stitches", []), panels, edge_ids, context)
    properties = values.as_object(top.get("properties", {}), "properties")
    named = DraftedFor.from_json(properties.get("drafted_for"))
    pattern = Pattern(
        tuple(ordered),
        stitches,
        name,
        named,
        _cloth_stretch(properties),
        _trims(properties),
        button_count_read(properties["button_count"]) if "button_count" in properties else 0,
    )
    return Reading(pattern, tuple(context.findings))


def _trims(properties: Mapping[str, Any]) -> tuple[str, ...]:
    return trims_read(properties["trims"]) if "trims" in properties else ()


def _cloth_stretch(properties: Mapping[str, Any]) -> float:
    stretch = values.as_number(properties.get("cloth_stretch", 0.0), "properties.cloth_stretch")
    if not 0.0 <= stretch <= MAX_CLOTH_STRETCH:
        raise PatternError(
            f"properties.cloth_stretch: {stretch:g} was given; a share from 0 (any cloth) to "
            f"{MAX_CLOTH_STRETCH:g} is accepted. Correct or remove it."
        )
    return stretch


def _read_properties(raw: Any, rotation: RotationReading) -> _Context:
    properties = values.as_object(raw, "properties")
    units = values.as_number(properties.get("units_in_meter", 100), "properties.units_in_meter")
    if not 1e-3 <= units <= 1e5:
        raise PatternError(
            f"properties.units_in_meter: {units:g} is not a unit of length; 100 means cm, 1000 mm, 1 m."
        )
    coordinates = properties.get("curvature_coords", "relative")
    if coordinates not in ("relative", "absolute"):
        raise PatternError(
            "properties.curvature_coords: 'relative' or 'absolute' was expected, "
            f"got {values.describe(coordinates)}."
        )
    context = _Context(100.0 / units, coordinates == "absolute", rotation)
    if units != 100:
        text = f"lengths are in 1/{units:g} m and were converted to cm"
        context.findings.append(found("other-units", text, value=units))
    return context


def _read_panel(name: str, raw: Any, context: _Context) -> tuple[Panel, dict[int, int]]:
    where = f"panel '{name}'"
    panel = values.as_object(raw, where)
    for key in ("vertices", "edges"):
        if key not in panel:
            raise PatternError(f"{where} has no '{key}'.")
    _note_unknown(context, set(panel) - _PANEL_KEYS, where, name)
    listed = values.as_list(panel["vertices"], f"{where}.vertices", limit=MAX_EDGES_PER_PANEL)
    vertices = [values.as_vector(v, f"{where}.vertices[{k}]", 2) for k, v in enumerate(listed)]
    if len(vertices) < 2:
        raise PatternError(f"{where}: at least 2 vertices are needed, got {len(vertices)}.")
    points = np.array([[context.in_cm(x, f"{where}.vertices") for x in v] for v in vertices])
    listed = values.as_list(panel["edges"], f"{where}.edges", limit=MAX_EDGES_PER_PANEL)
    if not listed:
        raise PatternError(f"{where} has no edges.")
    context.edges += len(listed)
    if context.edges > MAX_EDGES:
        raise PatternError(f"panels: more than {MAX_EDGES} edges in all, which is more than any garment has.")
    edges = [_read_edge(e, f"{where}.edges[{k}]", points, context, name) for k, e in enumerate(listed)]
    loop = order_loop(name, points, edges)
    context.findings.extend(loop.findings)
    placement = Placement(
        tuple(
            context.in_cm(x, f"{where}.translation")
            for x in values.as_vector(panel.get("translation", [0, 0, 0]), f"{where}.translation", 3)
        ),  # ty: ignore[invalid-argument-type]
        values.as_vector(panel.get("rotation", [0, 0, 0]), f"{where}.rotation", 3),  # ty: ignore[invalid-argument-type]
        context.rotation,
    )
    label = panel.get("label") or ""
    return _panel_of(name, loop, placement, values.as_text(label, f"{where}.label")), loop.edge_ids


def _panel_of(name: str, loop: Loop, placement: Placement, label: str) -> Panel:
    return Panel(name, loop.vertices, tuple(Edge(e.curve, e.label) for e in loop.edges), placement, label)


def _read_edge(raw: Any, where: str, points: Floats, context: _Context, panel: str) -> RawEdge:
    edge = values.as_object(raw, where)
    if "endpoints" not in edge:
        raise PatternError(f"{where} has no 'endpoints'.")
    _note_unknown(context, set(edge) - _EDGE_KEYS, where, panel)
    ends = values.as_list(edge["endpoints"], f"{where}.endpoints", (2,))
    start, end = (values.as_index(i, f"{where}.endpoints") for i in ends)
    for index in (start, end):
        if not 0 <= index < len(points):
            raise PatternError(
                f"{where}.endpoints: vertex {index} does not exist; "
                f"the panel has vertices 0 to {len(points) - 1}."
            )
    chord = points[[start, end]]
    curve = _read_curvature(edge.get("curvature"), f"{where}.curvature", chord, context)
    label = values.as_text(edge.get("label") or "", f"{where}.label")
    return RawEdge(start, end, curve, label)


def _read_curvature(raw: Any, where: str, chord: Floats, context: _Context) -> Curve:
    if raw is None:
        return Line()
    if isinstance(raw, list):  # the older formats: one quadratic control point
        raw = {"type": "quadratic", "params": [raw]}
    curvature = values.as_object(raw, where)
    kind = curvature.get("type")
    counts = {"quadratic": 1, "cubic": 2, "circle": 3}
    if not isinstance(kind, str) or kind not in counts:
        raise PatternError(
            f"{where}.type: 'quadratic', 'cubic' or 'circle' was expected, got {values.describe(kind)}."
        )
    params = values.as_list(curvature.get("params"), f"{where}.params", (counts[kind],))
    if kind == "circle":
        place = f"{where}.params[0] (radius)"
        radius = context.in_cm(values.as_number(params[0], place), place)
        if radius <= 0:
            raise PatternError(f"{where}: the radius must be positive, got {radius:g} cm.")
        large, right = (_read_flag(p, f"{where}.params[{k + 1}]") for k, p in enumerate(params[1:]))
        return Arc(radius, large, right)
    controls = []
    for k, p in enumerate(params):
        x, y = values.as_vector(p, f"{where}.params[{k}]", 2)
        if context.absolute_curvature:
            x, y = to_relative(np.array([x, y]) * context.scale, chord)
            if max(abs(x), abs(y)) > values.MAX_ABSOLUTE:
                raise PatternError(
                    f"{where}.params[{k}]: the control point is too far from the edge, whose ends all but "
                    "coincide. Split the edge or move its ends apart."
                )
        controls.append((x, y))
    return Quadratic(controls[0]) if kind == "quadratic" else Cubic(controls[0], controls[1])


def _read_flag(raw: Any, where: str) -> bool:
    if raw not in (0, 1, True, False):
        raise PatternError(f"{where}: 0 or 1 was expected, got {values.describe(raw)}.")
    return bool(raw)


def _panel_order(raw: Any, panels: dict[str, Panel], context: _Context) -> list[str]:
    if raw is None:
        return list(panels)
    order = [values.as_text(n, "panel_order") for n in values.as_list(raw, "panel_order", limit=MAX_PANELS)]
    if sorted(order) == sorted(panels):
        return order
    context.findings.append(
        found(
            "panel-order",
            "panel_order does not name every panel exactly once; the order of the panels object is used",
        )
    )
    return list(panels)


def _read_stitches(
    raw: Any, panels: dict[str, Panel], edge_ids: dict[str, dict[int, int]], context: _Context
) -> tuple[Stitch, ...]:
    stitches = []
    for k, item in enumerate(values.as_list(raw, "stitches", limit=MAX_STITCHES)):
        where = f"stitches[{k}]"
        sides = values.as_list(item, where, (2, 3))
        if len(sides) == 3 and sides[2] != "right_wrong":
            raise PatternError(
                f"{where}: the third entry may only be 'right_wrong', got {values.describe(sides[2])}."
            )
        refs = []
        for side in sides[:2]:
            entry = values.as_object(side, where)
            panel = values.as_text(entry.get("panel"), f"{where}.panel")
            edge = values.as_index(entry.get("edge"), f"{where}.edge")
            if panel not in panels or edge not in edge_ids[panel]:
                missing = (
                    f"there is no panel '{panel}'" if panel not in panels else f"'{panel}' has no edge {edge}"
                )
                context.findings.append(
                    found(
                        "dangling-stitch",
                        f"stitch {k} is left out because {missing}",
                        panel=panel,
                        edge=edge,
                        stitch=k,
                        repair="--repair removes the stitch; the seam stays open",
                    )
                )
                break
            refs.append(EdgeRef(panel, edge_ids[panel][edge]))
        else:
            stitches.append(Stitch(refs[0], refs[1], len(sides) == 3))
    return tuple(stitches)


def _note_unknown(context: _Context, keys: set[str], where: str, panel: str = "") -> None:
    for key in sorted(keys):
        context.unknown_keys += 1
        if context.unknown_keys > _MAX_UNKNOWN_KEYS:
            return
        shown = key[:60] if key[:60].isprintable() else ascii(key[:60])
        text = f"{where} has an unknown key {shown!r}, which is not kept"
        context.findings.append(found("unknown-key", text, panel=panel, value=shown))
