"""Refuses files above a size for the repository (a pre-commit hook): ``refuse_large_files.py KB FILE...``."""

from __future__ import annotations

import sys
from pathlib import Path


def main(arguments: list[str]) -> int:
    limit = int(arguments[0])
    large = [name for name in arguments[1:] if Path(name).stat().st_size > limit * 1000]
    for name in large:
        print(f"{name} has {Path(name).stat().st_size / 1000:.0f} kB; at most {limit} kB belong in git.")
    return 1 if large else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
