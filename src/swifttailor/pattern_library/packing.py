"""Patterns in few bytes: short JSON, rounded, deflated with a dictionary of what all patterns share."""

from __future__ import annotations

import json
import zlib
from typing import Any

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.pattern import Pattern, read_specification, to_specification
from swifttailor.pattern.json_values import parse_json

DIGITS_CM, DIGITS_DEGREES, DIGITS_RADIUS, DIGITS_CURVE = 3, 3, 3, 4
"""Decimals of places, angles, radii and chord-relative control points."""
MOST_BYTES = 2**20
"""Of a pattern's JSON: the longest of GarmentCode has a fortieth."""
DICTIONARY_BYTES = 2**15
"""What deflate can look back."""
_RAW, _LEVEL, _MEMORY = -15, 9, 9
_KINDS = {"circle": "a", "quadratic": "q", "cubic": "c"}


def short_json(pattern: Pattern) -> bytes:
    """A pattern in canonical order as JSON of few letters.

    Raises:
        InputError: Its angles are not read as GarmentCode's are (`Placement.reading`).
    """
    if any(p.placement.reading != "intrinsic" for p in pattern.panels):
        raise InputError(
            f"The angles of '{pattern.name}' are extrinsic. Give patterns with intrinsic angles."
        )
    content = to_specification(pattern.canonical())["pattern"]
    names = list(content["panels"])
    panels = [
        [
            name,
            _rounded(panel["translation"], DIGITS_CM),
            _rounded(panel["rotation"], DIGITS_DEGREES),
            _rounded(panel["vertices"], DIGITS_CM),
            [_short_edge(edge) for edge in panel["edges"]],
            panel.get("label", ""),
        ]
        for name, panel in content["panels"].items()
    ]
    stitches = [
        [names.index(a["panel"]), a["edge"], names.index(b["panel"]), b["edge"], len(more)]
        for a, b, *more in content["stitches"]
    ]
    return json.dumps([panels, stitches], separators=(",", ":")).encode()


def pattern_of(data: bytes, name: str) -> Pattern:
    """The pattern of `short_json`, but for roundings.

    Raises:
        InputError: The bytes are no such pattern.
    """
    try:
        panels, stitches = parse_json(data, name)
        names = [panel[0] for panel in panels]
        content = {
            "panels": {
                title: {
                    "translation": place,
                    "rotation": angles,
                    "vertices": vertices,
                    "edges": [_long_edge(edge, k, len(edges)) for k, edge in enumerate(edges)],
                    **({"label": label} if label else {}),
                }
                for title, place, angles, vertices, edges, label in panels
            },
            "stitches": [
                [
                    {"panel": names[first], "edge": edge},
                    {"panel": names[second], "edge": other},
                    *(["right_wrong"] if wrong else []),
                ]
                for first, edge, second, other, wrong in stitches
            ],
            "panel_order": names,
        }
        properties = {"curvature_coords": "relative", "normalized_edge_loops": True, "units_in_meter": 100}
        return read_specification({"pattern": content, "properties": properties}, name=name).pattern
    except (SwiftTailorError, TypeError, ValueError, LookupError) as error:
        raise InputError(f"The known pattern '{name}' is damaged: {error}") from error


def dictionary_of(written: list[bytes]) -> bytes:
    """What deflate looks back to: some of the patterns, evenly chosen."""
    size = sum(map(len, written)) // max(len(written), 1) or 1
    count = max(min(DICTIONARY_BYTES // size, len(written)), 1)
    return b"".join(written[k * len(written) // count] for k in range(count))[-DICTIONARY_BYTES:]


def deflated(data: bytes, dictionary: bytes) -> bytes:
    """Compressed."""
    press = zlib.compressobj(_LEVEL, zlib.DEFLATED, _RAW, _MEMORY, zdict=dictionary)
    return press.compress(data) + press.flush()


def inflated(data: bytes, dictionary: bytes) -> bytes:
    """The inverse of `deflated`.

    Raises:
        InputError: The bytes are damaged, or far more than any pattern has.
    """
    press = zlib.decompressobj(_RAW, zdict=dictionary)
    try:
        found = press.decompress(data, MOST_BYTES)
    except zlib.error as error:
        raise InputError(f"A known pattern is damaged: {error}") from error
    if not press.eof:
        raise InputError(f"A known pattern is cut short, or longer than {MOST_BYTES} bytes.")
    return found


def _short_edge(edge: dict[str, Any]) -> Any:
    label, curve = edge.get("label", ""), edge.get("curvature")
    if curve is None:
        return label or 0
    kind, numbers = _KINDS[curve["type"]], curve["params"]
    if kind == "a":
        numbers = [_rounded(numbers[0], DIGITS_RADIUS), *numbers[1:]]
    return [kind, _rounded(numbers, DIGITS_CURVE), *([label] if label else [])]


def _long_edge(edge: Any, number: int, count: int) -> dict[str, Any]:
    long: dict[str, Any] = {"endpoints": [number, (number + 1) % count]}
    if isinstance(edge, str):
        return long | {"label": edge}
    if edge == 0:
        return long
    kind, numbers, *label = edge
    long["curvature"] = {"type": {k: name for name, k in _KINDS.items()}[kind], "params": numbers}
    return long | ({"label": label[0]} if label else {})


def _rounded(value: Any, digits: int) -> Any:
    """A number or nested lists of them; whole numbers without their point."""
    if isinstance(value, list):
        return [_rounded(one, digits) for one in value]
    near = round(float(value), digits)
    return int(near) if near == int(near) else near
