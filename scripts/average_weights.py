"""Averages the weights of a training and of the one that it began with.

python scripts/average_weights.py plain eyes --out averaged
swifttailor train export averaged --out plain_reader.onnx --int8

What has learnt on from some weights for one kind of input often does better half-way (Wortsman et al., Robust
fine-tuning of zero-shot models, CVPR 2022): it keeps what both know, at the price of one. The card is that of
the first, and says so.
"""

from __future__ import annotations

import argparse
import hashlib
import json
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file, save

from swifttailor.atomic_files import write_bytes, write_text

WEIGHTS, CARD = "weights.safetensors", "card.json"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("run", type=Path, help="folder of a training")
    parser.add_argument("begun_with", type=Path, help="folder of the one whose weights it began with")
    parser.add_argument("--share", type=float, default=0.5, help="of the first, 0 to 1")
    parser.add_argument("--out", type=Path, required=True, help="folder to write")
    options = parser.parse_args()
    if not 0 <= options.share <= 1:
        parser.error(f"--share is {options.share}; 0 to 1 is accepted")
    ours, others = (load_file(folder / WEIGHTS) for folder in (options.run, options.begun_with))
    if {k: v.shape for k, v in ours.items()} != {k: v.shape for k, v in others.items()}:
        parser.error(f"{options.run} and {options.begun_with} are of networks of different shapes")
    found = {
        name: (options.share * value + (1 - options.share) * others[name]).astype(value.dtype)
        if np.issubdtype(value.dtype, np.floating)
        else value
        for name, value in ours.items()
    }
    card = json.loads((options.run / CARD).read_text(encoding="utf-8"))
    before = hashlib.sha256((options.begun_with / WEIGHTS).read_bytes()).hexdigest()
    card["averaged"] = {"share": options.share, "with": before}
    options.out.mkdir(parents=True, exist_ok=True)
    write_bytes(options.out / WEIGHTS, save(found), overwrite=True)
    write_text(options.out / CARD, json.dumps(card, indent=1) + "\n", overwrite=True)


if __name__ == "__main__":
    main()
