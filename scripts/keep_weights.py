"""Rounds the weights of a training to 16 bits, to be kept in the repository for trainings to begin with.

``python scripts/keep_weights.py RUN weights/NAME.safetensors`` writes the file and beside it the card of the
run. Trainings take it as ``--set start=weights/NAME.safetensors``; it is not part of the package, whose model
files (``swifttailor train export``) cannot be trained.
"""

from __future__ import annotations

import argparse
import shutil
from pathlib import Path

import numpy as np
from safetensors.numpy import load_file, save_file

from swifttailor.atomic_files import write_atomically
from swifttailor.training.run_record import CARD, WEIGHTS


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("run", type=Path)
    parser.add_argument("out", type=Path)
    options = parser.parse_args()
    weights = load_file(options.run / WEIGHTS)
    rounded = {name: value.astype(np.float16) for name, value in weights.items()}
    largest = max(float(np.abs(rounded[n].astype(np.float32) - weights[n]).max()) for n in weights)
    if not all(np.isfinite(value).all() for value in rounded.values()):
        raise SystemExit("Some weights are too large for 16 bits.")
    options.out.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(options.out, lambda temporary: save_file(rounded, temporary))
    card = options.run / CARD
    write_atomically(options.out.with_suffix(".json"), lambda temporary: shutil.copyfile(card, temporary))
    print(f"{options.out}: {options.out.stat().st_size / 1e6:.1f} MB, weights rounded by up to {largest:.1e}")


if __name__ == "__main__":
    main()
