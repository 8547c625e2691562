"""``swifttailor marker``: all pieces of a pattern nested on a width of cloth."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Literal

from swifttailor.cli.option_checks import in_range, require_seed
from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place
from swifttailor.errors import InputError
from swifttailor.pattern.panel import RotationReading

_MOST_SECONDS = 600
_MOST_ALLOWANCE_CM = 10.0


@dataclass(frozen=True)
class MakeMarker:
    """Nest the pieces of a pattern on a width of cloth, and tell the length that is needed.

    Grain lines run along the cloth; pieces are cut from one layer, right side up.
    """

    pattern: tyro.conf.Positional[Path]
    """GarmentCode JSON file, or a garment's folder."""
    width: float = 140.0
    """Width of the cloth, cm."""
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    """Drawing to write: .svg, .pdf, .png or .dxf. Default: a new one in the current folder,
    PATTERN-marker.svg."""
    seconds: int = 10
    """Time for the search; more seconds waste less cloth."""
    seed: int = 0
    """Of the search."""
    one_way: tyro.conf.FlagCreatePairsOff[bool] = False
    """All pieces point the same way, as cloth with nap or a directed print needs."""
    allowance: float | None = None
    """Seam allowance, cm. Default: 1."""
    hem_allowance: float | None = None
    """Allowance of hems, cm. Default: 3."""
    edge_allowance: float | None = None
    """Allowance of necklines, armholes and other open edges, cm. Default: 1."""
    fold: Literal["none", "front", "back", "both"] = "none"
    """What is cut on the fold, where the pattern has a straight seam in the middle."""
    rotation: RotationReading = "intrinsic"
    """How to read the placement angles (see convert)."""
    overwrite: tyro.conf.FlagCreatePairsOff[bool] = False
    """Replace the drawing where there is one already."""
    json: tyro.conf.FlagCreatePairsOff[bool] = False
    """Print one JSON object instead of text."""
    open: tyro.conf.FlagCreatePairsOff[bool] = False
    """Show the drawing."""

    def run(self) -> int:
        """Nests, writes the drawing, prints what is needed, and returns the exit code."""
        self._require_sense()
        from swifttailor.atomic_files import require_free
        from swifttailor.making import Allowances, cutting_plan
        from swifttailor.making.centre_folds import fold_with_trims
        from swifttailor.making.marker_files import require_ending, write_marker
        from swifttailor.making.nesting import nest, pack_boxes, require_width
        from swifttailor.making.sewn_pattern import require_sewable
        from swifttailor.pattern import load_pattern

        require_width(self.width)
        source = self.pattern / "pattern.json" if self.pattern.is_dir() else self.pattern
        if not source.exists():
            raise InputError(
                f"There is no pattern '{source}'. Give a GarmentCode JSON file or a garment's folder."
            )
        name = self.pattern.resolve().name if self.pattern.is_dir() else source.stem
        out = self.out if self.out is not None else new_place(f"{name}-marker", ".svg")
        require_ending(out)
        require_free(out, overwrite=self.overwrite)
        usual = Allowances()
        given = {"seam": self.allowance, "hem": self.hem_allowance, "edge": self.edge_allowance}
        allowances = Allowances(**{k: getattr(usual, k) if v is None else v for k, v in given.items()})
        pattern = load_pattern(source, rotation=self.rotation)
        if self.pattern.is_dir():
            pattern = replace(pattern, name=self.pattern.resolve().name or pattern.name)
        trims = None
        if self.fold != "none":
            require_sewable(pattern)
            pattern, trims = fold_with_trims(pattern, front=self.fold != "back", back=self.fold != "front")
        plan = cutting_plan(pattern, allowances, trims=trims)
        boxes = pack_boxes(plan.pieces, self.width)
        marker = nest(plan.pieces, self.width, seconds=self.seconds, seed=self.seed, one_way=self.one_way)
        write_marker(marker, out, title=plan.name, overwrite=self.overwrite)
        if self.json:
            result = {
                "file": str(out),
                "pieces": len(marker.laid),
                "width_cm": self.width,
                "length_cm": round(marker.length, 1),
                "waste": round(marker.waste, 4),
                "length_of_boxes_cm": round(boxes.length, 1),
            }
            sys.stdout.write(json.dumps(result) + "\n")
        else:
            saved = 100 * (1 - marker.length / boxes.length)
            sys.stdout.write(
                f"{len(marker.laid)} pieces on {marker.length / 100:.2f} m of cloth {self.width:g} cm wide; "
                f"{100 * marker.waste:.1f} % is left over. Packed by their boxes they need "
                f"{boxes.length / 100:.2f} m ({saved:.0f} % saved).\n{out}\n"
            )
        if self.open:
            from swifttailor.cli.results import open_file

            open_file(out)
        return 0

    def _require_sense(self) -> None:
        in_range("--seconds", self.seconds, 1, _MOST_SECONDS, "seconds are accepted.")
        require_seed(self.seed)
        for option, value in (
            ("--allowance", self.allowance),
            ("--hem-allowance", self.hem_allowance),
            ("--edge-allowance", self.edge_allowance),
        ):
            in_range(
                option, value, 0.0, _MOST_ALLOWANCE_CM, "cm is accepted. Usual are 1 for seams, 3 for hems."
            )
