"""What GarmentSewer's parts are worth: small trainings that differ in one thing, as a table.

``python benchmarks/sewer_ablations.py DATA OUT [--minutes 10] [--rows NAME ...] [--seeds 0 1]``

Every row is trained for the same time from the same seeds on ``train`` of DATA and measured on all of
``validation`` at its end; with several seeds, half of the range of what they give stands behind the mean.
What is done (OUT/NAME-seed-N) is not trained again, so it goes on where it was stopped, and ``--rows`` and
``--seeds`` may add some later. ``--set FIELD=VALUE ...`` changes all rows. Needs the extra `train`.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from ablation_rows import Row, as_markdown, train_rows, trained_rows
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
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument("--set", nargs="+", default=[], metavar="FIELD=VALUE")
    options = parser.parse_args()
    command = ["train", "garment-sewer", "--data", options.data, "--threads", "1"]
    command += ["--max-minutes", str(options.minutes)]
    # Measured at the end alone, on everything.
    command += ["--set", "validate_every=1000000", "validation_garments=100000", "pictures=0", *options.set]
    train_rows(ROWS, options.rows, options.seeds, options.out, command)
    print(describe())
    print(table(trained_rows(ROWS, options.out)))


def table(rows: list[Row]) -> str:
    """The rows as Markdown: cm, and % of the vertices inside the body."""
    kinds = sorted({kind for row in rows for card in row.cards for kind in card["validation"]["kinds"]})
    heads = [
        "",
        "seeds",
        "mean",
        "median",
        *kinds,
        "seam gap",
        "in body, %",
        "garments seen",
        "commit or version",
    ]
    lines = []
    for row in rows:
        cells = [row.name, str(len(row.cards))]
        for name in ("mean", "median"):
            cells.append(row.mean(lambda card, name=name: card["validation"][name], ".2f"))
        for kind in kinds:
            cells.append(row.mean(lambda card, kind=kind: card["validation"]["kinds"][kind]["mean"], ".2f"))
        cells.append(row.mean(lambda card: card["validation"]["seam_gap"], ".2f"))
        cells.append(row.mean(lambda card: 100 * card["validation"]["inside"], ".1f"))
        cells.append(row.mean(lambda card: card["training"]["garments_seen"], ".0f"))
        cells.append(str(row.cards[0]["versions"].get("commit", ""))[:7])
        lines.append(cells)
    return as_markdown(heads, lines)


if __name__ == "__main__":
    main()
