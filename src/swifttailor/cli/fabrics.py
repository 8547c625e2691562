"""``swifttailor fabrics``: the fabrics that are known by name, with their constants."""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, dataclass

from swifttailor.cli.postponed_imports import tyro


@dataclass(frozen=True, kw_only=True)
class Fabrics:
    """Show the fabrics that --fabric takes: constants, units, and where they come from.

    Weight, stretch and bending are measured or estimated, as the last column says; friction on the body and
    the distance between layers are estimated throughout.
    """

    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print JSON instead of a table: SI units, thickness in cm."""

    def run(self) -> int:
        """Prints them; returns 0."""
        from swifttailor.draping.known_fabrics import FABRICS

        if self.json:
            rows = [asdict(fabric) | {"measured": fabric.is_measured} for fabric in FABRICS.values()]
            sys.stdout.write(json.dumps(rows, indent=2) + "\n")
            return 0
        width = max(len(name) for name in FABRICS)
        print(f"{'fabric':<{width}}  weight  stretch  bending  friction  layers")  # noqa: T201
        print(f"{'':<{width}}    g/m2      N/m     uN m                mm")  # noqa: T201
        for fabric in FABRICS.values():
            print(  # noqa: T201
                f"{fabric.name:<{width}}  {1000 * fabric.density:6.0f}  {fabric.stretch:7.0f}  "
                f"{1e6 * fabric.bending:7.1f}  {fabric.friction:8.2f}  {10 * fabric.thickness:6.1f}"
                f"  {fabric.kind}; {fabric.source}"
            )
        return 0
