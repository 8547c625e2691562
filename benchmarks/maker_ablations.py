"""What PatternMaker's parts are worth: small trainings that differ in one thing, as a table.

``python benchmarks/maker_ablations.py OUT --patterns FILE... --validation FILE [--data DIR] [--minutes 10]``

Every row is trained for the same time from the same seeds; with several, half of the range of what they give
stands behind the mean. Then each network alone, one pattern at temperature 0, answers the texts (and pictures
of --data/validation) of --limit validation patterns, as `swifttailor evaluate systems` asks. What is done
(OUT/NAME-seed-N) is not done again: it goes on where it was stopped; --rows and --seeds may add some later.
``--set FIELD=VALUE ...`` changes all rows. Needs the extra `train`.
"""

from __future__ import annotations

import argparse
import gzip
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from ablation_rows import Row, as_markdown, train_rows, trained_rows, with_spread
from machine import describe

_NO_PLAN = ("network.planning=false",)
_NO_FORESIGHT = (*_NO_PLAN, "losses.foresight=0", "losses.foreseen_numbers=0", "reads=0")
ROWS: dict[str, tuple[str, ...]] = {
    "ours": (),
    "no-plan": _NO_PLAN,
    "no-counterparts": (*_NO_PLAN, "network.copying=false", "network.edits=whole", "losses.changed=1"),
    "no-foresight": _NO_FORESIGHT,
    "no-reads": ("reads=0",),
    "numbers-before-token": ("network.command_seen=false",),
    "tags-random": ("tags=random",),
    "errors-squared": ("losses.penalty=squared", "losses.by_kind=true", "losses.numbers=0.1"),
    "one-patch-matrix": ("network.early_convolutions=false",),
    "no-grammar": ("decoding=free",),
    "patterns-500": (),
    "patterns-2000": (),
}
"""By name, what is changed in the configuration ``small``."""
FEWER = {"patterns-500": 500, "patterns-2000": 2000}
"""Rows that learn from the first patterns alone."""
METRICS = {
    "panel %": ("panels_right", 100.0, ".1f"),
    "edge % in order": ("edges_in_order", 100.0, ".1f"),
    "vertex cm": ("vertex_cm", 1.0, ".2f"),
    "transl cm": ("translation_cm", 1.0, ".2f"),
    "stitch %": ("stitches", 100.0, ".1f"),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--patterns", type=Path, nargs="+", required=True)
    parser.add_argument("--validation", type=Path, required=True)
    parser.add_argument("--data", type=Path, help="data set with renders of some of the patterns")
    parser.add_argument("--cache", type=Path, help="where measured patterns are kept")
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--limit", type=int, default=100, help="validation patterns to ask for")
    parser.add_argument("--rows", nargs="*", default=list(ROWS), choices=list(ROWS))
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument("--set", nargs="+", default=[], metavar="FIELD=VALUE")
    options = parser.parse_args()
    for name in options.rows:
        files = fewer(options.patterns, FEWER[name], options.out) if name in FEWER else options.patterns
        train_rows(ROWS, [name], options.seeds, options.out, command(options, files))
    rows = trained_rows(ROWS, options.out)
    print(describe())
    print(table(rows, answered(rows, options)))


def command(options: argparse.Namespace, patterns: list[Path]) -> list[str | Path]:
    """The training of every row."""
    given = ["train", "pattern-maker", "--patterns", *patterns, "--validation", options.validation]
    given += [] if options.data is None else ["--data", options.data / "train", options.data / "validation"]
    given += ["--cache", options.cache or options.out / "cache", "--threads", "1"]
    given += ["--max-minutes", str(options.minutes), "--set", "validate_every=1000000", *options.set]
    return given


def fewer(patterns: list[Path], count: int, out: Path) -> list[Path]:
    """A file with the first patterns of all files."""
    path = out / f"first-{count}.jsonl.gz"
    if not path.is_file():
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = (line for file in patterns for line in gzip.open(file, "rt"))
        with gzip.open(path, "wt") as written:
            written.writelines(line for _, line in zip(range(count), lines, strict=False))
    return [path]


def answered(rows: list[Row], options: argparse.Namespace) -> dict[str, Any]:
    """What each network alone answers, by the name of its folder."""
    folders = [folder for row in rows for folder in row.folders]
    for folder in folders:
        if not (folder / "maker.zip").is_file():
            export = ["train", "export", folder, "--out", folder / "maker.zip", "--half"]
            subprocess.run([sys.executable, "-m", "swifttailor", *export], check=True)
    asked = ["evaluate", "systems", "--patterns", options.validation, "--out", options.out / "answers"]
    asked += ["--limit", str(options.limit), "--sewers", "--generators"]
    asked += [f"{folder.name}={folder / 'maker.zip'}" for folder in folders]
    asked += [] if options.data is None else ["--data", options.data / "validation"]
    asked += ["--tasks", "text"] if options.data is None else ["--tasks", "text", "image"]
    done = subprocess.run([sys.executable, "-m", "swifttailor", *asked, "--overwrite"], check=False)
    if done.returncode not in (0, 1):  # 1: some patterns could not be asked for
        sys.exit(done.returncode)
    summary = json.loads((options.out / "answers" / "summary.json").read_text())
    return summary["answers"] | {"tasks": list(summary["about"]["questions"])}


def table(rows: list[Row], answers: dict[str, Any]) -> str:
    """The rows as Markdown, task by task."""
    parts = []
    for place, task in enumerate(answers["tasks"]):
        lines = []
        for row in rows:
            found = [answers[f.name][place]["patterns"]["PatternMaker"] for f in row.folders]
            cells = [row.name, str(len(row.cards))]
            for key, factor, form in METRICS.values():
                values = [factor * f["aipparel"][key]["mean"] for f in found if key in f["aipparel"]]
                cells.append(with_spread(values, form) if values else "")
            cells.append(with_spread([100 * f["missing"] / f["patterns"] for f in found], ".1f"))
            cells.append(row.mean(lambda card: card["training"]["garments_seen"], ".0f"))
            lines.append(cells)
        heads = [f"by {task}", "seeds", *METRICS, "no pattern %", "samples seen"]
        parts.append(as_markdown(heads, lines))
    return "\n\n".join(parts)


if __name__ == "__main__":
    main()
