"""Samples sewing patterns with GarmentCode's own programs: as many as training can use.

Needs a checkout of GarmentCode (github.com/maria-korosteleva/GarmentCode, MIT licence; written for commit
d449629) and an environment with what its ``pygarment`` imports, for it pins other versions than SwiftTailor:

python3 -m venv garmentcode-env
garmentcode-env/bin/pip install numpy scipy svgpathtools svgwrite pyyaml psutil cairosvg matplotlib
garmentcode-env/bin/python scripts/sample_garmentcode.py GarmentCode --count 10000 --out sampled.jsonl.gz

Every attempt has a seed of its own, from --start upwards; what GarmentCode's sampler would refuse is left
out, in its order: combinations of parameters that slide off, garments longer than the body, self-crossing
panels. (Its check on a random body needs body data that are not public, and is not made.) One JSON object a
line: id ("gc_SEED"), seed, design (flat parameters), pattern (GarmentCode's format). With --edits-of FILE it
is an edited version of each pattern of such a file: id, base, edits (parameters), pattern. Nothing of
SwiftTailor is imported; give the files to ``swifttailor data build`` and ``swifttailor train``.

GarmentCode draws each parameter for itself, and most of what comes is worn by nobody. With --archetypes
scripts/archetypes the seed draws one of the garments of that folder first, then its parameters around what
shops show; each line has its name as well ("archetype": "pencil skirt").

With --designs FILE no parameters are drawn: of the designs of each
line the first that GarmentCode accepts is built, under the id of the line.
"""

from __future__ import annotations

import argparse
import contextlib
import copy
import functools
import gzip
import io
import itertools
import json
import multiprocessing
import os
import random
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from drawing_archetypes import Archetype, complete, read_archetypes

BODY = "assets/bodies/mean_all.yaml"
DESIGNS = "assets/design_params/default.yaml"
TRIES = 12
"""Changes of parameters tried until a pattern changes: many parameters do nothing in most designs."""
ARCHETYPES: list[Archetype] = []
"""What a worker draws from; all that GarmentCode's sampler may draw, where it is empty."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("garmentcode", type=Path, help="checkout of GarmentCode")
    parser.add_argument("--count", type=int, help="patterns to write; all of --edits-of without it")
    parser.add_argument("--start", type=int, default=10_000_000, help="seed of the first attempt")
    parser.add_argument(
        "--edits-of", type=Path, metavar="FILE", help="write an edited version of each pattern of this file"
    )
    parser.add_argument(
        "--archetypes",
        type=Path,
        metavar="FOLDER",
        help="draw garments that shops sell, of tables like those in scripts/archetypes",
    )
    parser.add_argument("--designs", type=Path, metavar="FILE", help="build given designs: .jsonl.gz")
    parser.add_argument("--out", type=Path, required=True, help="a .jsonl.gz file")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if not (options.garmentcode / DESIGNS).is_file():
        parser.error(f"{options.garmentcode} is no checkout of GarmentCode: it has no {DESIGNS}")
    if options.edits_of is None and options.designs is None and options.count is None:
        parser.error("--count is missing: how many patterns to write")
    make: Callable[[Any], dict[str, Any] | str] = sample
    seeds: Iterable[Any] = itertools.count(options.start)
    if options.designs is not None:
        with gzip.open(options.designs, "rt") as file:
            make, seeds = given_design, [json.loads(line) for line in file]
    if options.edits_of is not None:
        with gzip.open(options.edits_of, "rt") as file:
            make, seeds = edit, [json.loads(line)["seed"] for line in file]
    archetypes = None if options.archetypes is None else read_archetypes(options.archetypes)
    prepared_with = (options.garmentcode.resolve(), archetypes)
    began, attempts, refused, written = time.perf_counter(), 0, {}, 0
    part = options.out.with_name(options.out.name + ".part")
    with (
        multiprocessing.Pool(options.workers, prepare, prepared_with) as pool,
        gzip.GzipFile(part, "wb", mtime=0) as file,
    ):
        for outcome in pool.imap(make, seeds, chunksize=4):
            attempts += 1
            if isinstance(outcome, str):
                refused[outcome] = refused.get(outcome, 0) + 1
                continue
            file.write(json.dumps(outcome, separators=(",", ":")).encode() + b"\n")
            written += 1
            if written % 100 == 0:
                print(f"{written} of {attempts} attempts", file=sys.stderr, flush=True)
            if written == options.count:
                pool.terminate()
                break
    part.replace(options.out)
    print(f"{written} patterns, {attempts} attempts, {time.perf_counter() - began:.0f} s; refused: {refused}")


def prepare(checkout: Path, archetypes: list[Archetype] | None = None) -> None:
    """Makes GarmentCode's modules importable in a worker; their paths are relative to the checkout."""
    ARCHETYPES.extend(archetypes or ())
    os.chdir(checkout)
    sys.path.insert(0, str(checkout))
    import svgpathtools  # ty: ignore[unresolved-import]
    from pygarment.garmentcode import operators  # ty: ignore[unresolved-import]

    # Two thirds of the time, where they go through a curve one point after the other.
    operators._max_curvature = largest_curvature
    svgpathtools.CubicBezier.length = length


def largest_curvature(curve: Any, points_estimates: int = 100) -> float:
    """GarmentCode's ``_max_curvature`` of a Bezier curve, all points at once."""
    polynomial = curve.poly()
    at = np.linspace(0, 1, points_estimates)
    first, second = polynomial.deriv()(at), polynomial.deriv(2)(at)
    speed = np.abs(first)
    if not speed.all():
        return max(curve.curvature(t) for t in at)
    return float(np.max(np.abs((first.conj() * second).imag) / speed**3))


NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)


def length(curve: Any, t0: float = 0, t1: float = 1, **_: float) -> float:
    """Length of a cubic Bezier curve from t0 to t1, by Gauss and Legendre's rule."""
    a, b, c, d = curve.bpoints()
    t = t0 + (t1 - t0) * (NODES + 1) / 2
    first, second, third = b - a, c - b, d - c
    speed = 3 * np.abs(first * (1 - t) ** 2 + 2 * second * (1 - t) * t + third * t * t)
    return float(speed @ WEIGHTS) * (t1 - t0) / 2


@functools.cache
def given() -> tuple[Any, Any]:
    """GarmentCode's sampler of designs, and its body."""
    from assets.bodies.body_params import BodyParameters  # ty: ignore[unresolved-import]
    from pygarment import DesignSampler  # ty: ignore[unresolved-import]

    return DesignSampler(DESIGNS), BodyParameters(BODY)


def sample(seed: int) -> dict[str, Any] | str:
    """The pattern of a seed, or why there is none."""
    archetype, design, pattern = of_seed(seed)
    if isinstance(pattern, str):
        return pattern
    kind = {} if archetype is None else {"archetype": archetype.name}
    return {"id": f"gc_{seed}", "seed": seed, **kind, "design": dict(flatten(design)), "pattern": pattern}


def of_seed(seed: int) -> tuple[Archetype | None, dict[str, Any], dict[str, Any] | str]:
    """The archetype, design and pattern of a seed, or why there is no pattern."""
    random.seed(seed)
    archetype = random.choices(ARCHETYPES, [kind.share for kind in ARCHETYPES])[0] if ARCHETYPES else None
    design = draw_design(archetype)
    return archetype, design, build(f"gc_{seed}", design)


def draw_design(archetype: Archetype | None) -> dict[str, Any]:
    """Design parameters drawn as GarmentCode does, or for a garment that shops sell."""
    sampler = given()[0]
    if archetype is None:
        return sampler.randomize()
    design = copy.deepcopy(sampler.default())
    for path, value in complete(archetype.draw(), dict(flatten(design))).items():
        parameter(design, path)["v"] = value
    return design


def parameter(design: dict[str, Any], path: str) -> dict[str, Any]:
    """The nested parameter at a flat path."""
    return functools.reduce(dict.__getitem__, path.split("."), design)


def edit(seed: int) -> dict[str, Any] | str:
    """A pattern that differs from that of a seed in one to three parameters, or why there is none."""
    archetype, design, base = of_seed(seed)
    if isinstance(base, str):
        return base
    name = f"gc_{seed}"
    outcome: dict[str, Any] | str = "nothing changed"
    random.seed(f"edit of {seed}")
    for _ in range(TRIES):
        other = dict(flatten(draw_design(archetype)))
        values = dict(flatten(design))
        differing = [path for path in values if values[path] != other[path]]
        changed = random.sample(differing, min(random.choices((1, 2, 3), (4, 2, 1))[0], len(differing)))
        edited = copy.deepcopy(design)
        for path in changed:
            parameter(edited, path)["v"] = other[path]
        pattern = build(name, edited)
        if isinstance(pattern, str):
            outcome = pattern
        elif pattern["pattern"]["panels"] != base["pattern"]["panels"]:
            edits = [{"path": p, "from": values[p], "to": other[p]} for p in changed]
            return {"id": f"{name}_edit", "base": name, "edits": edits, "pattern": pattern}
    return outcome


def given_design(line: dict[str, Any]) -> dict[str, Any] | str:
    """The pattern of the first design that GarmentCode accepts, or why it refuses the likeliest."""
    refusals = []
    for number, values in enumerate(line["designs"]):
        design = copy.deepcopy(given()[0].default())
        for path, value in values.items():
            parameter(design, path)["v"] = value
        pattern = build(line["id"], design)
        if not isinstance(pattern, str):
            return {"id": line["id"], "attempts": number + 1, "design": values, "pattern": pattern}
        refusals.append(pattern)
    return refusals[0]


def build(name: str, design: dict[str, Any]) -> dict[str, Any] | str:
    """A pattern in GarmentCode's format, or why its sampler would refuse it."""
    import pattern_sampler  # ty: ignore[unresolved-import]
    from assets.garment_programs.meta_garment import MetaGarment  # ty: ignore[unresolved-import]
    from pygarment.pattern.core import BasicPattern  # ty: ignore[unresolved-import]

    with contextlib.redirect_stdout(io.StringIO()), tempfile.TemporaryDirectory() as folder:
        try:
            pattern_sampler.assert_param_combinations(design)
            garment = MetaGarment(name, given()[1], design)
            garment.assert_total_length()
            if garment.is_self_intersecting():
                return "self-crossing"
            BasicPattern.serialize(garment.assembly(), folder, to_subfolder=False)  # its own draws pictures
            return json.loads(next(Path(folder).rglob("*_specification.json")).read_text())
        except KeyboardInterrupt:
            raise
        except BaseException as error:  # GarmentCode's own errors are BaseExceptions
            return type(error).__name__


def flatten(design: dict[str, Any], path: str = "") -> Any:
    """The values of nested parameters: ("sleeve.length", 0.3)."""
    for key, value in design.items():
        where = f"{path}.{key}" if path else key
        if "v" in value:
            yield where, value["v"]
        else:
            yield from flatten(value, where)


if __name__ == "__main__":
    main()
