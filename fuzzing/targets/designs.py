"""Designs: files of design parameters, read and drafted."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.target import Feed, File, Target


def seeds() -> Sequence[File]:
    """Garments of all kinds, flat in JSON and nested as in GarmentCode's YAML, which JSON is part of."""
    from swifttailor.programs import DESIGN_PARAMETERS

    made = []
    uppers, belts, bottoms = (DESIGN_PARAMETERS[f"meta.{part}"].choices for part in ("upper", "wb", "bottom"))
    for k, bottom in enumerate(bottoms):
        values = {name: parameter.default for name, parameter in DESIGN_PARAMETERS.items()}
        parts = {"meta.upper": uppers[k % 2], "meta.wb": belts[k % 3], "meta.bottom": bottom}
        values |= {**parts, "sleeve.sleeveless": k % 2 == 0, "left.enable_asym": k % 3 == 0}
        made.append(File(json.dumps(values).encode(), ".json"))
        made.append(File(json.dumps({"design": _nested(values)}).encode(), ".yaml"))
    return made


def _nested(values: dict[str, Any]) -> dict[str, Any]:
    top: dict[str, Any] = {}
    for name, value in values.items():
        *groups, last = name.split(".")
        level = top
        for group in groups:
            level = level.setdefault(group, {})
        level[last] = {"v": value}
    return top


def mutate(file: File, random: Random) -> bytes:
    """Other values, most of them accepted ones; or damage to the JSON or to the bytes."""
    kind = random.random()
    if kind < 0.1:
        return mutate_bytes(file.data, random)
    if kind < 0.3:
        return written(mutate_json(json.loads(file.data), random), random)
    from swifttailor.programs import DESIGN_PARAMETERS

    values = json.loads(file.data)
    for name in random.sample(list(DESIGN_PARAMETERS), random.choice((3, 30, len(DESIGN_PARAMETERS)))):
        parameter, level = DESIGN_PARAMETERS[name], values.get("design", values)
        value = random.choice(parameter.choices) if parameter.choices else _number(parameter, random)
        if level is values:
            level[name] = value
            continue
        for group in name.split("."):
            level = level[group]
        level["v"] = value
    return json.dumps(values).encode()


def _number(parameter: Any, random: Random) -> float:
    low, high = parameter.range
    value = random.choice((low, high, random.uniform(low, high)))
    return round(value) if parameter.kind == "int" else value


def _load() -> Feed:
    from swifttailor.pattern import to_specification
    from swifttailor.programs import make_pattern, read_design

    def feed(path: Path) -> None:
        json.dumps(to_specification(make_pattern(read_design(path))), allow_nan=False)

    return feed


TARGETS = (Target("design", "design parameters, drafted", seeds, mutate, _load, 10.0, in_ci=200),)
