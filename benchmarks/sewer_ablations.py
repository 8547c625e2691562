"""What GarmentSewer's parts are worth: small trainings that differ in one thing, as a table.

``python benchmarks/sewer_ablations.py DATA OUT [--minutes 10] [--rows NAME ...] [--set FIELD=VALUE ...]``

Every row is trained for the same time from the same seed on ``train`` of DATA and measured on all of
``validation`` at its end. Rows that are done (OUT/NAME/card.json) are not trained again, so it goes on where
it was stopped, and ``--rows`` may add some later. ``--set`` changes all rows. Needs the extra `train`. On two
processor cores ``--processes 2`` trains with both.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

from machine import describe
from swifttailor.garment_sewer.conditioning import PER_PANEL, PLACED

_PAPER = ("conditioning.prior=none", 'conditioning.channels=["color"]', "network.output=absolute")
_REGRESSION = ("losses.edge=100", "losses.edge_band=10", "losses.seam_pairs=0")
_STITCHING = ("losses.stitching=1000",)
_NORMALS = ("losses.normals=0.01",)
_DPT = ("network.convolutions=[]", "network.patch_size=8", "network.layers=8")


def _without(*channels: str) -> str:
    return f"conditioning.channels={json.dumps([c for c in PLACED if c not in channels])}"


ROWS: dict[str, tuple[str, ...]] = {
    "paper-no-semantic": (*_PAPER, *_REGRESSION, 'conditioning.channels=["occupancy"]'),
    "paper-regression": (*_PAPER, *_REGRESSION),
    "paper-stitching": (*_PAPER, *_REGRESSION, *_STITCHING),
    "paper-all": (*_PAPER, *_REGRESSION, *_STITCHING, *_NORMALS),
    "ours": (),
    "prior-placed": ("conditioning.prior=placed",),
    "colors-and-prior": ('conditioning.channels=["color", "occupancy", "prior"]',),
    "no-partners": (_without("partner", "partner_pixel"),),
    "no-body": (_without("body_distance", "body_direction"),),
    "no-slope": (_without("slope"),),
    "paper-losses": (*_REGRESSION, *_STITCHING, *_NORMALS),
    "no-edge": ("losses.edge=0",),
    "no-seam-pairs": ("losses.seam_pairs=0",),
    "gradient": ("losses.gradient=1",),
    "strain": ("losses.strain=0.1",),
    "penetration": ("losses.penetration=1",),
    "dpt": _DPT,
    "dpt-no-norms": (*_DPT, "network.normalized=false"),
    "dpt-no-input-skip": (*_DPT, "network.input_skip=0"),
    "dpt-no-masks": (*_DPT, "network.masked=false"),
    "no-augmentation": ("mirror=0", "repack=0"),
    "pixels-256": ("network.resolution=256", "losses.edge_band=10"),
    "per-panel": ("conditioning.layout=per_panel", f"conditioning.channels={json.dumps(PER_PANEL)}"),
    "garments-250": ("training_garments=250",),
    "garments-500": ("training_garments=500",),
    "garments-1000": ("training_garments=1000",),
    "garments-2000": ("training_garments=2000",),
}
"""By name, what is changed in the configuration ``small``."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("data", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--rows", nargs="*", default=list(ROWS), choices=list(ROWS))
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--set", nargs="+", default=[], metavar="FIELD=VALUE")
    options = parser.parse_args()
    for name in options.rows:
        if not (options.out / name / "card.json").is_file():
            train(name, options)
    done = [name for name in ROWS if (options.out / name / "card.json").is_file()]
    print(describe())
    print(table([(name, json.loads((options.out / name / "card.json").read_text())) for name in done]))


def train(name: str, options: argparse.Namespace) -> None:
    """Trains a row; what it prints is shown."""
    command = [sys.executable, "-m", "swifttailor"]
    if options.processes > 1:
        torchrun = ["torch.distributed.run", "--nproc_per_node", str(options.processes)]
        command = [sys.executable, "-m", *torchrun, "-m", "swifttailor"]
    command += ["train", "garment-sewer", "--data", options.data, "--out", options.out / name]
    command += ["--max-minutes", str(options.minutes), "--threads", "1"]
    # Measured at the end alone, on everything.
    command += ["--set", "validate_every=1000000", "validation_garments=100000", "pictures=0"]
    surroundings = os.environ | {"OMP_NUM_THREADS": "1"}
    subprocess.run([*command, *options.set, *ROWS[name]], check=True, env=surroundings)


def table(cards: list[tuple[str, dict]]) -> str:
    """The rows as Markdown: cm, and % of the vertices inside the body."""
    kinds = sorted({kind for _, card in cards for kind in card["validation"]["kinds"]})
    heads = ["", "mean", "median", *kinds, "seam gap", "in body, %", "garments seen", "commit or version"]
    lines = [" | ".join(heads), "|".join(["---"] * len(heads))]
    for name, card in cards:
        found = card["validation"]
        cells = [name, f"{found['mean']:.2f}", f"{found['median']:.2f}"]
        cells += [f"{found['kinds'][kind]['mean']:.2f}" if kind in found["kinds"] else "" for kind in kinds]
        cells += [f"{found['seam_gap']:.2f}", f"{100 * found['inside']:.1f}"]
        cells += [str(card["training"]["garments_seen"]), str(card["versions"].get("commit", ""))[:7]]
        lines.append(" | ".join(cells))
    return "\n".join(f"| {line} |" for line in lines)


if __name__ == "__main__":
    main()
