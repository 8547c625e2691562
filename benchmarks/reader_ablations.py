"""What the picture reader's parts are worth: small trainings that differ in one thing, as tables.

``python benchmarks/reader_ablations.py OUT --data DIR... --validation DIR... [--rows NAME ...] [--seeds 0]``

Every row sees as many pictures of as many pixels, all plain, from the same seeds, and is judged by the
fronts and backs of all garments to validate with; with several seeds, half of the range of what they give
stands behind the mean. A second table has the same after each quarter of the training: what more hours and
what more garments are worth. ``--start`` gives the row ``photographs`` the weights that it begins with
(scripts/take_picture_trunk_torch.py). What is done (OUT/NAME-seed-N) is not done again: it goes on where it
was stopped; --rows and --seeds may add some later. ``--set FIELD=VALUE ...`` changes all rows. Needs the
extra `train`.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from ablation_rows import Row, as_markdown, train_rows, trained_rows, with_spread
from machine import describe

PHOTOGRAPHS = "photographs"
_SMALL = (
    "plain=0.95",
    "studio=0",
    "several=0",
    "nothing=0.05",
    "echo=4",
    "pool=4096",
    "block=64",
    "warmup_steps=40",
    "ema=0.99",
    "validation_garments=1000",
)
_MAPS = tuple(f"losses.{name}=0" for name in ("masks", "places", "kinds", "seams"))
ROWS: dict[str, tuple[str, ...]] = {
    "ours": (),
    "garments-500": ("training_garments=500",),
    "garments-1000": ("training_garments=1000",),
    "garments-2000": ("training_garments=2000",),
    "garments-5000": ("training_garments=5000",),
    "no-maps": _MAPS,
    "camera-not-told": ("unguessed=1",),
    "no-close-ups": ("close=0",),
    "as-drawn": ("variation=0",),
    "shown-once": ("echo=1",),
    PHOTOGRAPHS: ("network.trunk=efficientnet-lite2",),
    "lite2": ("network.trunk=efficientnet-lite2",),
}
"""By name, what is changed in the configuration ``small`` besides `_SMALL`."""
METRICS = {
    "not false %": "not_false",
    "near %": "near_not_false",
    "panels all right %": "panels",
    "mask %": "mask",
}
CLAIMS = ("kind", "skirt_hem", "neckline", "waistband", "sleeves", "cuffs")
QUARTERS = 4


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--data", type=Path, nargs="+", required=True, help="folders of splits to learn from")
    parser.add_argument("--validation", type=Path, nargs="+", required=True)
    parser.add_argument("--apart", type=Path, nargs="*", default=[])
    parser.add_argument("--start", type=Path, help=f"weights that {PHOTOGRAPHS} begins with")
    parser.add_argument("--steps", type=int, default=400)
    parser.add_argument("--rows", nargs="*", choices=list(ROWS))
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument("--set", nargs="+", default=[], metavar="FIELD=VALUE")
    options = parser.parse_args()
    names = options.rows or [name for name in ROWS if name != PHOTOGRAPHS or options.start]
    if PHOTOGRAPHS in names and options.start is None:
        parser.error(f"--start is needed for the row {PHOTOGRAPHS}.")
    rows = dict(ROWS)
    rows[PHOTOGRAPHS] = (*ROWS[PHOTOGRAPHS], f"start={options.start}")
    train_rows(rows, names, options.seeds, options.out, command(options))
    done = trained_rows(ROWS, options.out)
    print(describe())
    print(at_the_end(done))
    print()
    print(after_each_quarter(done))


def command(options: argparse.Namespace) -> list[str | Path]:
    """The training of every row."""
    given = ["train", "picture-reader", "--data", *options.data, "--validation", *options.validation]
    given += ["--apart", *options.apart] if options.apart else []
    given += ["--workers", "1", "--threads", "1"]
    steps = (f"steps={options.steps}", f"validate_every={options.steps // QUARTERS}")
    return [*given, "--set", *_SMALL, *steps, *options.set]


def at_the_end(rows: list[Row]) -> str:
    """How well the networks read, as Markdown."""
    lines = []
    for row in rows:
        found = [card["validation"] for card in row.cards]
        shares = [[one[key] for one in found] for key in METRICS.values()]
        shares += [[one["claims"][name] for one in found] for name in CLAIMS]
        cells = [row.name, str(len(row.cards))]
        cells += [with_spread([100 * share for share in several], ".1f") for several in shares]
        cells.append(row.mean(lambda card: card["data"]["train"]["garments"], ".0f"))
        cells.append(row.mean(lambda card: card["training"]["minutes"], ".0f"))
        cells.append(str(row.cards[0]["versions"].get("commit", ""))[:8])
        lines.append(cells)
    names = [f"{name} %" for name in CLAIMS]
    return as_markdown(["", "seeds", *METRICS, *names, "garments", "minutes", "commit or version"], lines)


def after_each_quarter(rows: list[Row]) -> str:
    """Claims that are not false while training, as Markdown."""
    lines = []
    for row in rows:
        curves = [measured(folder) for folder in row.folders]
        steps = sorted(curves[0])
        cells = [with_spread([100 * curve[step] for curve in curves], ".1f") for step in steps]
        lines.append([row.name, *cells])
    heads = [f"after {step} steps" for step in steps] if rows else []
    return as_markdown(["not false %", *heads], lines)


def measured(folder: Path) -> dict[int, float]:
    """Share of claims that are not false by the number of steps."""
    lines: list[dict[str, Any]] = [json.loads(line) for line in (folder / "metrics.jsonl").open()]
    return {line["step"]: line["validation"]["not_false"] for line in lines if "validation" in line}


if __name__ == "__main__":
    main()
