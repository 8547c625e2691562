"""How far GarmentSewer, which knows no fabric, is from drapes in several.

    nice -n 10 python benchmarks/other_fabrics.py validation.jsonl.gz --every 15 --limit 10 --out FOLDER

Each pattern is sewn once by the network, and draped from its flat panels in each fabric; beside it, the
network's garment finished in that fabric. Every row is kept in results.jsonl; started again, it goes on.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np

import swifttailor
from machine import describe
from swifttailor.body import Body
from swifttailor.draping.finish_or_drape import finish_or_drape
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.pattern.pattern_list import read_patterns

FABRICS = ("cotton", "denim", "silk", "jersey", "leather")


def apart(one: Garment, other: Garment) -> float:
    """Mean distance of the same vertices, cm."""
    return float(np.linalg.norm(one.vertices - other.vertices, axis=1).mean())


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("patterns", type=Path)
    parser.add_argument("--every", type=int, default=1, help="take every k-th pattern")
    parser.add_argument("--limit", type=int, default=None)
    parser.add_argument("--edge-length", type=float, default=2.0, help="cm")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    results = options.out / "results.jsonl"
    done = {tuple(json.loads(line)["key"]) for line in results.open()} if results.exists() else set()
    print(describe())
    tailor = swifttailor.Tailor.load()
    chosen = [p for k, p in enumerate(read_patterns(options.patterns)) if k % options.every == 0]
    for item in chosen[: options.limit]:
        missing = [fabric for fabric in FABRICS if (item.id, fabric) not in done]
        if missing:
            pattern = item.read().pattern.canonical()
            sewn = tailor.sew(pattern, edge_length=options.edge_length).garment
            in_cotton = None
            for fabric in missing:
                try:
                    draped = swifttailor.drape(pattern, fabric=fabric, edge_length=options.edge_length)
                    finished = finish_or_drape(sewn, edge_length=options.edge_length, fabric=fabric)
                except SwiftTailorError as error:
                    print(f"{item.id} {fabric}: {error}", flush=True)
                    continue
                in_cotton = draped if fabric == "cotton" else in_cotton
                row = measured(sewn, draped, finished, in_cotton)
                with results.open("a") as file:
                    file.write(json.dumps({"key": [item.id, fabric]} | row) + "\n")
                picture(draped, fabric, options.out / f"{item.id}-{fabric}.png")
                print(item.id, fabric, json.dumps(row), flush=True)
    summarise(results)


def measured(sewn: Garment, draped: Garment, finished: Garment, cotton: Garment | None) -> dict[str, Any]:
    quality, after = draped.report["quality"], finished.report["quality"]
    return {
        "network_cm": apart(sewn, draped),
        "finished_cm": apart(finished, draped),
        "from_cotton_cm": None if cotton is None else apart(cotton, draped),
        "network_inside": sewn.report["sewing"]["inside_body"],
        "finished_inside": after["penetrating_fraction"],
        "draped_inside": quality["penetrating_fraction"],
        "draped_accepted": quality["accepted"],
        "finished_accepted": after["accepted"],
        "mass_g": draped.report["cloth"]["mass_g"],
    }


def picture(garment: Garment, fabric: str, path: Path) -> None:
    from dataclasses import replace

    from swifttailor.garment.preview import render_preview

    render_preview(replace(garment, cloth=fabric), Body.default(), size=(700, 420)).save(path)


def summarise(results: Path) -> None:
    rows = [json.loads(line) for line in results.open()]
    for fabric in FABRICS:
        own = [r for r in rows if r["key"][1] == fabric]
        if own:
            names = [name for name in own[0] if name != "key"]
            mean = {n: np.mean([r[n] for r in own if r[n] is not None]) for n in names}
            print(fabric, f"n = {len(own)}", ", ".join(f"{k} {v:.4g}" for k, v in mean.items()))


if __name__ == "__main__":
    main()
