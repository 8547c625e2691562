"""The ``swifttailor`` command: finds the command that was asked for, runs it, turns errors into messages.

Only the chosen command's module is imported, and nothing at all for ``--help``, so that both answer at once.
"""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

USAGE_ERROR = 2
INTERNAL_ERROR = 70
"""What sysexits.h calls EX_SOFTWARE."""
INTERRUPTED = 130
BROKEN_PIPE = 141

Runner = Callable[[list[str]], int]


@dataclass(frozen=True)
class Command:
    """One command of the list."""

    summary: str
    usage: str
    load: Callable[[], Runner]
    """Imports the command's module and gives what runs it."""


def run(argv: list[str]) -> int:
    """Runs the command line.

    Args:
        argv: Arguments without the program's name. ``--debug`` may stand anywhere before a ``--``.

    Returns:
        The exit code. 0: done; 1: done, with something to look at (findings, a drape beyond the limits);
        2: not done, for a reason the user can mend; 70: a fault of SwiftTailor; 130: interrupted.
    """
    _never_fail_to_print()
    argv, debug = _take_debug(argv)
    try:
        code = _dispatch(argv)
        sys.stdout.flush()
        return code
    except KeyboardInterrupt:
        if debug:
            raise
        _say("Interrupted.")
        return INTERRUPTED
    except BrokenPipeError:
        # Whoever read our output has seen enough. Python would complain once more while closing stdout.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return BROKEN_PIPE
    except Exception as error:
        if debug:
            raise
        return _report(error)


def _dispatch(argv: list[str]) -> int:
    name = argv[0] if argv else ""
    if name in ("-h", "--help") or (name == "help" and len(argv) == 1):
        sys.stdout.write(_overview())
        return 0
    if name in ("-V", "--version"):
        from swifttailor import __version__

        sys.stdout.write(f"swifttailor {__version__}\n")
        return 0
    if not name:
        sys.stderr.write(_overview())
        return USAGE_ERROR
    if name == "help":
        name, argv = argv[1], [argv[1], "--help"]
    if name in COMMANDS:
        try:
            return COMMANDS[name].load()(argv[1:])
        except SystemExit as leaving:  # tyro has printed help or a usage error
            return leaving.code if isinstance(leaving.code, int) else USAGE_ERROR
    _say(_unknown(name))
    return USAGE_ERROR


def _unknown(name: str) -> str:
    if name.startswith("-"):
        return f"There is no option '{name}' before a command. See: swifttailor --help"
    if name.lower().endswith(".json"):
        return f"'{name}' is a file, not a command. To drape it: swifttailor drape {name} --out DIR"
    from difflib import get_close_matches

    close = get_close_matches(name.lower(), COMMANDS, n=1, cutoff=0.5)
    hint = f"Did you mean '{close[0]}'?" if close else f"The commands are: {', '.join(COMMANDS)}."
    return f"There is no command '{name}'. {hint} See: swifttailor --help"


def _report(error: Exception) -> int:
    """Prints an error without its traceback and returns the exit code."""
    from swifttailor.errors import SwiftTailorError

    again = "Run the same command with --debug to see where it happened."
    if isinstance(error, SwiftTailorError):
        _say(f"Error: {error}")
        return error.exit_code
    if isinstance(error, MemoryError):
        _say(
            "Error: there is not enough memory for this. A longer --edge-length needs less, "
            f"and so do fewer --workers. {again}"
        )
        return INTERNAL_ERROR
    if isinstance(error, OSError):
        from swifttailor.atomic_files import is_disk_full

        place = f"'{error.filename}': " if error.filename else ""
        if is_disk_full(error):  # results have their own words for this (`atomic_files`): it is a cache
            place = f"{place}compiled code or other work files cannot be kept: "
            again = "Make room, or raise the limit on file sizes (`ulimit -f`)."
        _say(f"Error: {place}{error.strerror or error}. {again}")
        return USAGE_ERROR
    _say(
        f"Error inside SwiftTailor, not your fault: {type(error).__name__}: {error}\n{again} "
        "Please report it with that output and, if you can, the input file."
    )
    return INTERNAL_ERROR


def _take_debug(argv: list[str]) -> tuple[list[str], bool]:
    end = argv.index("--") if "--" in argv else len(argv)
    kept = [a for a in argv[:end] if a != "--debug"]
    return kept + argv[end:], len(kept) < end


def _overview() -> str:
    width = max(len(name) for name in COMMANDS)
    lines = [
        "SwiftTailor: sewing patterns to stitched 3D garments.",
        "",
        "usage: swifttailor COMMAND [OPTIONS]",
        "",
        *(f"  {name:<{width}}  {c.summary}\n  {'':<{width}}  {c.usage}" for name, c in COMMANDS.items()),
        "",
        "  swifttailor COMMAND --help   all options of a command",
        "  swifttailor --version        the version",
        "  --debug                      with any command: show where an error happened",
        "",
        "Exit codes: 0 done; 1 done, but read what it says; 2 not done, and why; 130 interrupted.",
    ]
    return "\n".join(lines) + "\n"


def _say(text: str) -> None:
    sys.stderr.write(text + "\n")


def _never_fail_to_print() -> None:
    """File names and pattern texts may hold what the terminal cannot show."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _runner(kind: Any, name: str) -> Runner:
    """Runs a command that is a dataclass of options with a `run` method."""

    def runner(arguments: list[str]) -> int:
        from swifttailor.cli.plain_options import read_plain
        from swifttailor.cli.postponed_imports import postpone_parts_of_numpy, tyro

        options = read_plain(kind, arguments)
        if options is None:
            if hasattr(kind, "refuse_unquoted"):
                kind.refuse_unquoted(arguments)
            options = tyro.cli(kind, args=arguments, prog=f"swifttailor {name}")
        postpone_parts_of_numpy()
        return options.run()

    return runner


def _load_draft() -> Runner:
    from swifttailor.cli.draft import run_draft

    return run_draft


def _load_drape() -> Runner:
    from swifttailor.cli.drape import Drape

    return _runner(Drape, "drape")


def _load_check() -> Runner:
    from swifttailor.cli.check import Check

    return _runner(Check, "check")


def _load_convert() -> Runner:
    from swifttailor.cli.convert import Convert

    return _runner(Convert, "convert")


def _load_marker() -> Runner:
    from swifttailor.cli.marker import MakeMarker

    return _runner(MakeMarker, "marker")


def _load_ggi() -> Runner:
    from swifttailor.cli.ggi import Ggi

    return _runner(Ggi, "ggi")


def _load_data() -> Runner:
    from swifttailor.cli.data import DATA

    return DATA.run


def _load_sew() -> Runner:
    from swifttailor.cli.sew import Sew

    return _runner(Sew, "sew")


def _load_fit() -> Runner:
    from swifttailor.cli.fit import Fit

    return _runner(Fit, "fit")


def _load_fabrics() -> Runner:
    from swifttailor.cli.fabrics import Fabrics

    return _runner(Fabrics, "fabrics")


def _load_generate() -> Runner:
    from swifttailor.cli.generate import Generate

    return _runner(Generate, "generate")


def _load_edit() -> Runner:
    from swifttailor.cli.edit import Edit

    return _runner(Edit, "edit")


def _load_studio() -> Runner:
    from swifttailor.cli.studio import Studio

    return _runner(Studio, "studio")


def _load_train() -> Runner:
    from swifttailor.cli.train import TRAIN

    return TRAIN.run


def _load_evaluate() -> Runner:
    from swifttailor.cli.evaluate import EVALUATE

    return EVALUATE.run


COMMANDS: dict[str, Command] = {
    "generate": Command(
        "Make a pattern and its garment from words or a picture.",
        'swifttailor generate "a long dress" --out DIR    or from a picture: --image FILE',
        _load_generate,
    ),
    "edit": Command(
        "Change a pattern as instructed, and make its garment.",
        'swifttailor edit PATTERN "make the sleeves longer" --out DIR',
        _load_edit,
    ),
    "studio": Command(
        "Open pattern and garment side by side in the browser.",
        "swifttailor studio    needs: pip install 'swifttailor[studio]'",
        _load_studio,
    ),
    "drape": Command(
        "Sew a pattern together on a body and let it hang: pattern in, 3D garment out.",
        "swifttailor drape PATTERN --out DIR    or many: --batch PATTERNS.jsonl.gz --out DIR",
        _load_drape,
    ),
    "draft": Command(
        "Draft a sewing pattern from a garment's name, or from design parameters and a size.",
        "swifttailor draft t-shirt --out FILE    all: --list    or: --design FILE --size 44",
        _load_draft,
    ),
    "fit": Command(
        "Refit a pattern to another body: a size, measures, or a run of sizes.",
        "swifttailor fit PATTERN --size 44 --out FILE    or a run: --sizes 36-46 --out DIR",
        _load_fit,
    ),
    "check": Command(
        "Find faults in a sewing pattern, and repair those that are safe to repair.",
        "swifttailor check PATTERN [--repair MENDED]",
        _load_check,
    ),
    "convert": Command(
        "Convert a pattern (.pdf to print, .dxf, .svg, ...) or a garment (.glb, .obj, .usd, ...).",
        "swifttailor convert IN OUT",
        _load_convert,
    ),
    "marker": Command(
        "Nest the pieces of a pattern on a width of cloth; tells the length needed.",
        "swifttailor marker PATTERN --width 140 --out marker.svg",
        _load_marker,
    ),
    "fabrics": Command(
        "Show the fabrics that --fabric takes, with their constants and sources.",
        "swifttailor fabrics [--json]",
        _load_fabrics,
    ),
    "ggi": Command(
        "Draw a pattern or a garment as images, or turn images back into a garment.",
        "swifttailor ggi INPUT --out DIR    back: swifttailor ggi --decode FILE --out DIR",
        _load_ggi,
    ),
    "data": Command(
        "Build data sets from patterns, verify them, look at them.",
        "swifttailor data build --patterns FILE... --out DIR    all: swifttailor data --help",
        _load_data,
    ),
    "sew": Command(
        "Turn patterns into garments with a network, in a fraction of a second each.",
        "swifttailor sew PATTERN... --out DIR",
        _load_sew,
    ),
    "train": Command(
        "Train the networks on a data set.",
        "swifttailor train garment-sewer --data DIR --out RUN",
        _load_train,
    ),
    "evaluate": Command(
        "Measure how good the networks are, beside the paper's numbers.",
        "swifttailor evaluate garment-sewer --data DIR --split test",
        _load_evaluate,
    ),
}
"""In the order in which a newcomer needs them."""
