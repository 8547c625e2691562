"""Refits patterns to bodies they were not drafted for, drapes them, and measures what became of their ease.

    nice -n 10 python benchmarks/refitting.py validation.jsonl.gz --every 6 --edge-length 3 --out FOLDER

Twelve bodies: four women's sizes, four men's, two children's, two by measures. Each pattern is sewn on the
default body by GarmentSewer, refitted, and draped on each body, and some beside it as they were
(``--unfitted-every``). Every drape is kept in results.jsonl as soon as it is made; started again, it goes on.

Ease is the width of the cloth around the body at a level less the girth of the body there. What is asked is
the ease of the pattern before, on the default body. It counts where a garment goes around the body at that
level on both bodies. It is told three times: in the flat panels, along the line that lay at the level on the
default body; in the drape, where the cloth came to hang; and in the drape with folds counted as more cloth
(`level_lines`). Lengths are those of hems and sleeves: where the lowest point of the drape should lie by the
body's landmarks, and how far down the arm a sleeve should reach.

Patterns and bodies take turns, so that a count that is stopped has some of all.
"""

from __future__ import annotations

import argparse
import json
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

import swifttailor
from level_lines import chest_line, without_folds
from machine import describe
from swifttailor.arrays import Bools, Floats
from swifttailor.body import Body
from swifttailor.body.measure_names import parse_measures
from swifttailor.body.wearer import Wearer
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.refitting.body_profile import BodyProfile, profile_of
from swifttailor.refitting.cloth_girths import cloth_around
from swifttailor.refitting.first_body import sewn_on
from swifttailor.refitting.refitted import Refitted, refit
from swifttailor.refitting.stretch import ease_scale, height_map, places_of

BODIES = {
    "women-36": Wearer(size="women EU 36"),
    "women-42": Wearer(size="women EU 42"),
    "women-46": Wearer(size="women EU 46"),
    "women-52": Wearer(size="women EU 52"),
    "men-44": Wearer(size="men EU 44"),
    "men-50": Wearer(size="men EU 50"),
    "men-54": Wearer(size="men EU 54"),
    "men-58": Wearer(size="men EU 58"),
    "children-122": Wearer(size="children EU 122"),
    "children-146": Wearer(size="children EU 146"),
    "petite": Wearer(
        measures=parse_measures(["height=155", "bust=90", "waist=74", "hips=98"]), figure="women"
    ),
    "tall-slim": Wearer(
        measures=parse_measures(["height=188", "bust=96", "waist=78", "hips=97", "inseam=88"]), figure="men"
    ),
}
DEFAULT = "default"
"""The body that the patterns were drafted for, in the rows of GarmentSewer."""
LEVELS = {"chest": 6, "waist": 5, "hips": 4}
"""Index in `BodyProfile.levels`."""
AROUND = 0.85
"""A garment goes around a body where its cloth is this much of the girth."""
CLOSE_CM = 1.0
SEWN_CM = 2.5
"""Edges of the garment that is refitted."""
LOOSE_CM = 15.0
"""Of ease. What is looser hangs free there, and how high it hangs decides how wide it is."""


@dataclass(frozen=True)
class Worn:
    """A garment on a body, measured."""

    ease: dict[str, float | None]
    with_folds: dict[str, float | None]
    """Ease, folds counted as more cloth."""
    lowest: float
    sleeve: float | None


def measured(garment: Garment, profile: BodyProfile) -> Worn:
    places = places_of(garment, profile)
    counted = ~places.arm[garment.mesh.flat_faces].any(axis=1)
    heights = places.points[:, 1]
    even = without_folds(garment.mesh, heights)
    lines = lines_of(garment.mesh, even, profile)
    sleeve = float(places.down_arm[places.arm].max()) if places.arm.any() else None
    return Worn(
        {name: as_ease(width(garment.mesh, even, counted, at), profile, at) for name, at in lines.items()},
        {name: as_ease(width(garment.mesh, heights, counted, at), profile, at) for name, at in lines.items()},
        float(garment.vertices[:, 1].min()),
        sleeve,
    )


def lines_of(mesh: PatternMesh, heights: Floats, profile: BodyProfile) -> dict[str, float]:
    """Heights at which a garment is measured, by name, cm."""
    levels = {name: float(profile.levels[k]) for name, k in LEVELS.items()}
    return levels | {"chest": chest_line(mesh, heights, profile.measurements)}


def width(mesh: PatternMesh, heights: Floats, counted: Bools, at: float) -> float:
    """Of the cloth around a height, cm; the median of heights nearby."""
    places = at + np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
    return float(np.median(cloth_around(mesh, heights, counted, places)))


def girth_at(profile: BodyProfile, at: float) -> float:
    return float(np.interp(at, profile.heights, profile.girth))


def as_ease(cloth: float, profile: BodyProfile, at: float) -> float | None:
    """Ease of cloth that wide at a height; None where it does not go around."""
    girth = girth_at(profile, at)
    return cloth - girth if cloth > AROUND * girth else None


def off_in_pattern(
    made: Refitted, start: BodyProfile, end: BodyProfile
) -> tuple[dict[str, float | None], dict[str, float | None]]:
    """By how much the ease of the flat panels is off where they lay on the first body; and that ease."""
    places = places_of(made.sewn, start)
    counted = ~places.arm[made.sewn.mesh.flat_faces].any(axis=1)
    heights = without_folds(made.sewn.mesh, places.points[:, 1])
    grown = replace(made.sewn.mesh, flat_vertices=made.flat_positions)
    off: dict[str, float | None] = {}
    lines = lines_of(made.sewn.mesh, heights, start)
    before = {
        name: as_ease(width(made.sewn.mesh, heights, counted, at), start, at) for name, at in lines.items()
    }
    to = height_map(start, end)
    for name, ease in before.items():
        other = girth_at(end, float(to(lines[name])))
        after = width(grown, heights, counted, lines[name]) - other
        off[name] = None if ease is None else after - ease_scale(start, end) * ease
    return off, before


def draped(pattern: Any, body: Body, edge_length: float) -> tuple[Garment | None, dict[str, Any]]:
    started = time.perf_counter()
    try:
        garment = swifttailor.drape(pattern, body=body, edge_length=edge_length)
    except SwiftTailorError as error:
        return None, {"accepted": False, "reasons": [str(error)]}
    q = garment.report["quality"]
    kept = ("accepted", "reasons", "penetrating_fraction", "strain_p95", "self_intersections")
    return garment, {name: q[name] for name in kept} | {"seconds": round(time.perf_counter() - started, 1)}


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--every", type=int, default=1, help="take every k-th pattern")
    parser.add_argument("--start", type=int, default=0, help="the first of these")
    parser.add_argument("--without-every", type=int, default=None, help="leave every k-th pattern out")
    parser.add_argument("--limit", type=int, default=None)
    parser.add_argument("--bodies", nargs="*", default=list(BODIES))
    parser.add_argument("--edge-length", type=float, default=2.0, help="cm")
    parser.add_argument(
        "--unfitted-every", type=int, default=0, help="drape every k-th pattern as it is, too; 0: none"
    )
    parser.add_argument(
        "--network", action="store_true", help="sew them by GarmentSewer beside the drape, too"
    )
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    results = options.out / "results.jsonl"
    done = {tuple(json.loads(line)["key"]) for line in results.open()} if results.exists() else set()
    print(describe())
    bodies = {name: BODIES[name].body() for name in options.bodies}
    profiles = {name: profile_of(body) for name, body in bodies.items()}
    first = profile_of(Body.default())
    without = options.without_every
    chosen = [
        pattern
        for k, pattern in enumerate(read_patterns(options.patterns))
        if k % options.every == options.start and (without is None or k % without)
    ][: options.limit]
    first_worn: dict[str, Worn | None] = {}
    sewn: dict[str, Garment] = {}
    sew = sewn_on(Body.default(), SEWN_CM)
    # Each turn has every pattern once, on another body each.
    turns = [(k, (k + turn) % len(bodies)) for turn in range(len(bodies)) for k in range(len(chosen))]
    for number, (k, body_number) in enumerate(turns):
        item, name = chosen[k], options.bodies[body_number]
        if (item.id, name) in done or first_worn.get(item.id, item) is None:
            continue
        pattern = item.read().pattern.canonical()
        if item.id not in first_worn:
            start, quality = draped(pattern, Body.default(), options.edge_length)
            if start is None or not quality["accepted"]:
                print(f"{item.id}: left out, not accepted on the default body", flush=True)
                first_worn[item.id] = None
                continue
            first_worn[item.id], sewn[item.id] = measured(start, first), sew(pattern)
            if options.network and (item.id, DEFAULT) not in done:
                beside = network(pattern, Body.default(), start, options.edge_length)
                keep(results, {"key": [item.id, DEFAULT], "network": beside})
        wanted = first_worn[item.id]
        assert wanted is not None
        made = refit(pattern, bodies[name], sewn=sewn[item.id])
        unfitted = bool(options.unfitted_every) and number % options.unfitted_every == 0
        row = one(
            made, pattern, bodies[name], profiles[name], first, wanted, options, f"{item.id}-{name}", unfitted
        )
        keep(results, {"key": [item.id, name]} | row)
        print(item.id, name, json.dumps(row)[:300], flush=True)
    summarise(results)


def keep(results: Path, row: dict[str, Any]) -> None:
    with results.open("a") as file:
        file.write(json.dumps(row) + "\n")


def one(
    made: Refitted,
    pattern: Any,
    body: Body,
    profile: BodyProfile,
    first: BodyProfile,
    wanted: Worn,
    options: Any,
    title: str,
    unfitted: bool,
) -> dict[str, Any]:
    row: dict[str, Any] = {}
    row["pattern_off"], row["pattern_ease"] = off_in_pattern(made, first, profile)
    versions = {"fitted": made.pattern} | ({"unfitted": pattern} if unfitted else {})
    to = height_map(first, profile)
    for kind, version in versions.items():
        garment, quality = draped(version, body, options.edge_length)
        row[kind] = quality
        if garment is None:
            continue
        got = measured(garment, profile)
        scale = ease_scale(first, profile)
        quality["ease_off"] = differences(got.ease, wanted.ease, scale)
        quality["ease_off_with_folds"] = differences(got.with_folds, wanted.with_folds, scale)
        quality["hem_off"] = got.lowest - float(to(wanted.lowest))
        if got.sleeve is not None and wanted.sleeve is not None:
            longer = profile.measurements.arm_length / first.measurements.arm_length
            quality["sleeve_off"] = got.sleeve - wanted.sleeve * longer
        picture(garment, body, options.out / f"{title}-{kind}.png")
        if options.network and kind == "fitted":
            row["network"] = network(version, body, garment, options.edge_length)
    return row


def differences(
    got: dict[str, float | None], wanted: dict[str, float | None], scale: float
) -> dict[str, float | None]:
    """By how much ease is off at each level; None where cloth does not go around on both bodies."""
    pairs = {name: (got[name], wanted[name]) for name in LEVELS}
    return {name: None if a is None or b is None else a - scale * b for name, (a, b) in pairs.items()}


def network(pattern: Any, body: Body, draped_garment: Garment, edge_length: float) -> dict[str, float]:
    """GarmentSewer beside the drape: mean distance of the same vertices, and share inside the body."""
    sewn = sewn_on(body, edge_length)(pattern)
    away = np.linalg.norm(sewn.vertices - draped_garment.vertices, axis=1)
    return {"error_cm": float(away.mean()), "inside": sewn.report["sewing"]["inside_body"]}


def picture(garment: Garment, body: Body, path: Path) -> None:
    from swifttailor.garment.preview import render_preview

    render_preview(garment, body, size=(700, 420)).save(path)


def summarise(results: Path) -> None:
    known = [json.loads(line) for line in results.open()]
    rows = [row for row in known if row["key"][1] != DEFAULT]
    print(f"n = {len(rows)} garments")
    for title, low, high in (
        ("", -np.inf, np.inf),
        (", closer", -np.inf, LOOSE_CM),
        (", looser", LOOSE_CM, np.inf),
    ):
        print(f"flat panels{title}:")
        for name in LEVELS:
            off = [
                r["pattern_off"][name]
                for r in rows
                if r["pattern_off"][name] is not None and low <= r["pattern_ease"][name] < high
            ]
            print(f"  ease at {name}: {line(off)}")
    for kind in ("fitted", "unfitted"):
        there = [r[kind] for r in rows if kind in r]
        if not there:
            continue
        print(f"{kind}: {np.mean([q['accepted'] for q in there]):.1%} of {len(there)} within the limits")
        for what in ("ease_off", "ease_off_with_folds"):
            for name in LEVELS:
                print(f"  {what} at {name}: {line([q.get(what, {}).get(name) for q in there])}")
        print(f"  hem: {line([q.get('hem_off') for q in there])}")
        print(f"  sleeves: {line([q.get('sleeve_off') for q in there])}")
    both = [r["fitted"]["accepted"] for r in rows if "unfitted" in r]
    if both:
        print(f"refitted, the same as unfitted: {np.mean(both):.1%} of {len(both)} within the limits")
    for r in rows:
        if not r["fitted"]["accepted"]:
            print(*r["key"], r["fitted"]["reasons"])
    nets = {tuple(r["key"]): r["network"] for r in known if "network" in r}
    for name in (DEFAULT, *BODIES):
        own = [n for (_, body), n in nets.items() if name == body]
        if own:
            error, inside = (np.mean([n[k] for n in own]) for k in ("error_cm", "inside"))
            print(
                f"GarmentSewer beside the drape {name}: {error:.2f} cm, inside {inside:.2%}, n = {len(own)}"
            )
    # On each body beside the default one, with the same patterns.
    pairs = [
        (n["error_cm"], nets[pattern, DEFAULT]["error_cm"])
        for (pattern, body), n in nets.items()
        if body != DEFAULT and (pattern, DEFAULT) in nets
    ]
    if pairs:
        other, default = np.mean(pairs, axis=0)
        print(f"the same patterns on other bodies {other:.2f} cm, on the default body {default:.2f} cm")


def line(values: list[float | None]) -> str:
    known = np.array([v for v in values if v is not None])
    if not len(known):
        return "none"
    middle = f"median |off| {np.median(np.abs(known)):.2f} cm, median {np.median(known):+.2f}"
    return f"within 1 cm {share(known)}, {middle}"


def share(values: Any) -> str:
    values = np.asarray(values)
    return f"{(np.abs(values) <= CLOSE_CM).mean():.1%} of {len(values)}"


if __name__ == "__main__":
    main()
