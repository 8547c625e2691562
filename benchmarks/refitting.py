"""Refits patterns to bodies they were not drafted for, drapes them, and measures what became of their ease.

    nice -n 10 python benchmarks/refitting.py validation.jsonl.gz --every 6 --edge-length 3 --out FOLDER

Twelve bodies: four women's sizes, four men's, two children's, two by measures. Each pattern is sewn on the
default body by GarmentSewer, refitted, and draped on each body, and beside it as it was (``--unfitted``).
Every drape is kept in results.jsonl as soon as it is made; started again, it goes on.

Ease is the width of the cloth around the body at a level less the girth of the body there, in the drape. What
is asked is the ease of the pattern before, draped on the default body. It counts where a garment goes around
the body at that level on both bodies. Lengths are those of hems and sleeves: where the lowest point of the
drape should lie by the body's landmarks, and how far down the arm a sleeve should reach.
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
from machine import describe
from swifttailor.body import Body
from swifttailor.body.measure_names import parse_measures
from swifttailor.body.wearer import Wearer
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.refitting.body_profile import BodyProfile, profile_of
from swifttailor.refitting.cloth_girths import cloth_around
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
LEVELS = {"chest": 6, "waist": 5, "hips": 4}
"""Index in `BodyProfile.levels`."""
AROUND = 0.85
"""A garment goes around a body where its cloth is this much of the girth."""
CLOSE_CM = 1.0


@dataclass(frozen=True)
class Worn:
    """A garment on a body, measured."""

    ease: dict[str, float | None]
    lowest: float
    sleeve: float | None


def measured(garment: Garment, profile: BodyProfile) -> Worn:
    places = places_of(garment, profile)
    counted = ~places.arm[garment.mesh.flat_faces].any(axis=1)
    ease: dict[str, float | None] = {}
    for name, index in LEVELS.items():
        level = float(profile.levels[index])
        # A fold is cut twice too often now and then: the median of nearby heights.
        heights = level + np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
        cloth = float(np.median(cloth_around(garment.mesh, places.points[:, 1], counted, heights)))
        girth = float(np.interp(level, profile.heights, profile.girth))
        ease[name] = cloth - girth if cloth > AROUND * girth else None
    sleeve = float(places.down_arm[places.arm].max()) if places.arm.any() else None
    return Worn(ease, float(garment.vertices[:, 1].min()), sleeve)


def off_in_pattern(made: Refitted, start: BodyProfile, end: BodyProfile) -> dict[str, float | None]:
    """By how much the ease of the flat pattern is off, where the garment lay on the first body, cm."""
    places = places_of(made.sewn, start)
    counted = ~places.arm[made.sewn.mesh.flat_faces].any(axis=1)
    grown = replace(made.sewn.mesh, flat_vertices=made.flat_positions)
    off: dict[str, float | None] = {}
    for name, index in LEVELS.items():
        heights = start.levels[index] + np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
        before, after = (
            float(np.median(cloth_around(mesh, places.points[:, 1], counted, heights)))
            for mesh in (made.sewn.mesh, grown)
        )
        girth, other = (float(np.interp(b.levels[index], b.heights, b.girth)) for b in (start, end))
        asked = other + ease_scale(start, end) * (before - girth)
        off[name] = after - asked if before > AROUND * girth else None
    return off


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
    parser.add_argument("--unfitted", action="store_true", help="drape the patterns as they are, too")
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
    for item in chosen:
        pattern = item.read().pattern.canonical()
        wanted = None
        for name, body in bodies.items():
            if (item.id, name) in done:
                continue
            if wanted is None:
                start, quality = draped(pattern, Body.default(), options.edge_length)
                if start is None or not quality["accepted"]:
                    print(f"{item.id}: left out, not accepted on the default body", flush=True)
                    break
                wanted = measured(start, first)
            row = one(pattern, body, profiles[name], first, wanted, options, f"{item.id}-{name}")
            with results.open("a") as file:
                file.write(json.dumps({"key": [item.id, name]} | row) + "\n")
            print(item.id, name, json.dumps(row)[:300], flush=True)
    summarise(results)


def one(
    pattern: Any, body: Body, profile: BodyProfile, first: BodyProfile, wanted: Worn, options: Any, title: str
) -> dict[str, Any]:
    started = time.perf_counter()
    made = refit(pattern, body)
    row: dict[str, Any] = {"refit_seconds": round(time.perf_counter() - started, 2)}
    row["pattern_off"] = off_in_pattern(made, first, profile)
    versions = {"fitted": made.pattern} | ({"unfitted": pattern} if options.unfitted else {})
    to = height_map(first, profile)
    for kind, version in versions.items():
        garment, quality = draped(version, body, options.edge_length)
        row[kind] = quality
        if garment is None:
            continue
        got = measured(garment, profile)
        quality["ease_off"] = {
            k: None
            if got.ease[k] is None or wanted.ease[k] is None
            else got.ease[k] - ease_scale(first, profile) * wanted.ease[k]
            for k in LEVELS
        }
        quality["hem_off"] = got.lowest - float(to(wanted.lowest))
        if got.sleeve is not None and wanted.sleeve is not None:
            longer = profile.measurements.arm_length / first.measurements.arm_length
            quality["sleeve_off"] = got.sleeve - wanted.sleeve * longer
        picture(garment, body, options.out / f"{title}-{kind}.png")
        if options.network and kind == "fitted":
            row["network"] = network(version, body, garment, options.edge_length)
    return row


def network(pattern: Any, body: Body, draped_garment: Garment, edge_length: float) -> dict[str, float]:
    """GarmentSewer beside the drape: mean distance of the same vertices, and share inside the body."""
    from swifttailor.refitting.first_body import sewn_on

    sewn = sewn_on(body, edge_length)(pattern)
    away = np.linalg.norm(sewn.vertices - draped_garment.vertices, axis=1)
    return {"error_cm": float(away.mean()), "inside": sewn.report["sewing"]["inside_body"]}


def picture(garment: Garment, body: Body, path: Path) -> None:
    from swifttailor.garment.preview import render_preview

    render_preview(garment, body, size=(700, 420)).save(path)


def summarise(results: Path) -> None:
    rows = [json.loads(line) for line in results.open()]
    print(f"n = {len(rows)} garments")
    off = [v for r in rows for v in r["pattern_off"].values() if v is not None]
    print(f"ease in the flat pattern: within 1 cm {share(off)}, mean |off| {np.abs(off).mean():.2f} cm")
    for kind in ("fitted", "unfitted"):
        there = [r[kind] for r in rows if kind in r]
        if not there:
            continue
        print(f"{kind}: {np.mean([q['accepted'] for q in there]):.1%} of {len(there)} within the limits")
        for name in LEVELS:
            print(f"  ease at {name}: {line([q.get('ease_off', {}).get(name) for q in there])}")
        print(f"  hem: {line([q.get('hem_off') for q in there])}")
        print(f"  sleeves: {line([q.get('sleeve_off') for q in there])}")
    nets = [r["network"] for r in rows if "network" in r]
    if nets:
        print(
            f"GarmentSewer beside the drape: mean error {np.mean([n['error_cm'] for n in nets]):.2f} cm, "
            f"inside the body {np.mean([n['inside'] for n in nets]):.2%}, n = {len(nets)}"
        )


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
