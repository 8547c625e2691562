"""``python -m fuzzing``: feed mutated files to what reads them, count, and keep what fails."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from fuzzing.campaign import Campaign
from fuzzing.corpus import corpus_of
from fuzzing.registry import all_targets, module_of


def main() -> int:
    """Runs the targets that are named; 1 where one failed."""
    targets = all_targets()
    parser = argparse.ArgumentParser(prog="python -m fuzzing", description=__doc__)
    listed = "; ".join(f"{t.name}: {t.about}" for t in targets.values())
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"default: all. {listed}")
    parser.add_argument(
        "--inputs", type=int, help="fresh inputs of each target (default: some seconds' worth)"
    )
    parser.add_argument("--seed", type=int, default=0, help="other seeds give other inputs (default: 0)")
    parser.add_argument(
        "--out", type=Path, default=Path("out/fuzzing"), help="progress and failures (default: %(default)s)"
    )
    parser.add_argument(
        "--write", type=int, metavar="NUMBER", help="write the input of this number, and stop"
    )
    options = parser.parse_args()
    unknown = set(options.targets) - set(targets)
    if unknown:
        parser.error(f"there is no target {', '.join(sorted(unknown))}; there are {', '.join(targets)}")
    chosen = [targets[name] for name in options.targets or targets]
    if options.write is not None:
        for target in chosen:
            file = target.input(options.seed, options.write)
            path = Path(f"{target.name}-{options.seed}-{options.write}{file.ending}")
            path.write_bytes(file.data)
            print(path)
        return 0
    failed = False
    for target in chosen:
        resume = options.inputs is not None  # the few of every day are fed anew to what has changed since
        campaign = Campaign(target, module_of(target.name), options.seed, options.out, resume=resume)
        again = campaign.replay(corpus_of(target.name))
        progress = campaign.run(target.in_ci if options.inputs is None else options.inputs, _say)
        failures = progress.failures | {f"kept input: {name}": n for name, n in again.items()}
        _say(progress.line())
        for signature, count in sorted(failures.items()):
            _say(f"{target.name}: {count} x {signature}")
        failed = failed or bool(failures)
    if failed:
        _say(f"Inputs that fail are in {options.out}/failures.")
    return int(failed)


def _say(line: str) -> None:
    print(line, flush=True)


if __name__ == "__main__":
    sys.exit(main())
