"""``swifttailor data``: data sets to learn from; finds the command that was asked for."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

USAGE_ERROR = 2


@dataclass(frozen=True)
class DataCommand:
    """One command of the list."""

    summary: str
    usage: str
    load: Callable[[], Any]
    """Imports the command's module and gives its dataclass of options, which has a `run` method."""


def run_data(arguments: list[str]) -> int:
    """Runs ``swifttailor data`` with the arguments that follow.

    Returns:
        The exit code.

    Raises:
        SwiftTailorError: What the command raises.
    """
    name = arguments[0] if arguments else ""
    if name in COMMANDS:
        import tyro

        return tyro.cli(COMMANDS[name].load(), args=arguments[1:], prog=f"swifttailor data {name}").run()
    if name in ("-h", "--help"):
        sys.stdout.write(_overview())
        return 0
    if name:
        sys.stderr.write(f"There is no command 'data {name}'. ")
    sys.stderr.write(_overview())
    return USAGE_ERROR


def _overview() -> str:
    width = max(len(name) for name in COMMANDS)
    lines = [
        "Data sets to learn from.",
        "",
        "usage: swifttailor data COMMAND [OPTIONS]",
        "",
        *(f"  {name:<{width}}  {c.summary}\n  {'':<{width}}  {c.usage}" for name, c in COMMANDS.items()),
        "",
        "  swifttailor data COMMAND --help   all options of a command",
    ]
    return "\n".join(lines) + "\n"


def _load_build() -> Any:
    from swifttailor.cli.data_build import DataBuild

    return DataBuild


def _load_import() -> Any:
    from swifttailor.cli.data_import import DataImport

    return DataImport


def _load_render() -> Any:
    from swifttailor.cli.data_render import DataRender

    return DataRender


def _load_captions() -> Any:
    from swifttailor.cli.data_captions import DataCaptions

    return DataCaptions


def _load_edits() -> Any:
    from swifttailor.cli.data_edits import DataEdits

    return DataEdits


def _load_verify() -> Any:
    from swifttailor.cli.data_verify import DataVerify

    return DataVerify


def _load_stats() -> Any:
    from swifttailor.cli.data_stats import DataStats

    return DataStats


COMMANDS: dict[str, DataCommand] = {
    "build": DataCommand(
        "Drape patterns and put those that come out well into shards.",
        "swifttailor data build --patterns FILE... --out DIR",
        _load_build,
    ),
    "import": DataCommand(
        "Put folders of GarmentCodeData into shards.",
        "swifttailor data import ROOT --out DIR [--splits FILE]",
        _load_import,
    ),
    "render": DataCommand(
        "Draw pictures of every garment of a data set.",
        "swifttailor data render DIR",
        _load_render,
    ),
    "captions": DataCommand(
        "Write texts about garments, from what their patterns show.",
        "swifttailor data captions SOURCE [--out FILE]",
        _load_captions,
    ),
    "edits": DataCommand(
        "Recut patterns and write instructions that ask for it.",
        "swifttailor data edits SOURCE --out FILE",
        _load_edits,
    ),
    "verify": DataCommand(
        "Compare checksums and check everything that must hold of each sample.",
        "swifttailor data verify DIR",
        _load_verify,
    ),
    "stats": DataCommand(
        "Numbers, contact sheets, and a page to look through.",
        "swifttailor data stats DIR",
        _load_stats,
    ),
}
"""In the order in which they are needed."""
