"""Entry point of ``swifttailor`` and ``python -m swifttailor``."""

from __future__ import annotations

import gc
import sys

OBJECTS_BETWEEN_COLLECTIONS = 50_000
"""Python's own 700 are for programs that make less."""


def main() -> None:
    """Runs the command line and exits with its code."""
    # Imports and tables make objects that stay: looking for garbage takes a twentieth of a short run.
    gc.set_threshold(OBJECTS_BETWEEN_COLLECTIONS, *gc.get_threshold()[1:])
    from swifttailor.cli.main import run

    sys.exit(run(sys.argv[1:]))


if __name__ == "__main__":
    main()
