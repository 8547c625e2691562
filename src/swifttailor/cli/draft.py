"""``swifttailor draft``: a sewing pattern from a garment's name, options and a body, or from a design."""

from __future__ import annotations

import dataclasses
import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from swifttailor.cli.postponed_imports import tyro
from swifttailor.cli.results import new_place
from swifttailor.errors import InputError

if TYPE_CHECKING:
    from swifttailor.pattern.drafts import DraftInfo, Measurements, OptionField

USAGE_ERROR = 2
DESIGN = "--design"
_OUT = "GarmentCode JSON file to write. Default: a new one in the current folder, GARMENT.json."
_OVERWRITE = "Replace the file where there is one."


@dataclass(frozen=True)
class DraftList:
    """Draft the sewing pattern of a garment.

    Name a garment to draft it: swifttailor draft t-shirt --sleeve-length 40 --out shirt.json. Its options:
    swifttailor draft t-shirt --help. Or give GarmentCode's design parameters in a file, and for whom it is:
    swifttailor draft --design FILE --size 44 --out dress.json.
    """

    list: bool = False
    """Show all garments and their options."""
    json: bool = False
    """With --list: print JSON instead of a table."""


def run_draft(arguments: list[str]) -> int:
    """Runs ``swifttailor draft`` with the arguments that follow the command's name.

    Returns:
        The exit code: 0, 2 after a usage error that has been printed, or 1 where a check finds something in
        the pattern of a design.

    Raises:
        SwiftTailorError: The garment, an option or the body is not usable, or the file cannot be written.
    """
    try:
        if any(argument.split("=")[0] == DESIGN for argument in arguments):
            return _draft_design(arguments)
        if arguments and not arguments[0].startswith("-"):
            return _draft(arguments[0], arguments[1:])
        return _list(arguments)
    except SystemExit as leaving:  # tyro has printed help or a usage error
        return leaving.code if isinstance(leaving.code, int) else USAGE_ERROR


def _draft_design(arguments: list[str]) -> int:
    from swifttailor.cli.draft_design import DraftDesign
    from swifttailor.cli.plain_options import operands, read_plain

    named = operands(DraftDesign, arguments)
    if named:
        raise InputError(
            f"Both a garment ('{named[0]}') and {DESIGN} were given. Give one of them: a garment of this "
            "package and its options, or a file with GarmentCode's design parameters."
        )
    options = read_plain(DraftDesign, arguments)
    if options is None:
        options = tyro.cli(DraftDesign, args=arguments, prog=f"swifttailor draft {DESIGN} FILE")
    return options.run()


def _list(arguments: list[str]) -> int:
    from swifttailor.pattern.drafts import list_drafts

    drafts = list_drafts()
    names = ", ".join(d.name for d in drafts)
    request = tyro.cli(
        DraftList,
        args=arguments,
        prog="swifttailor draft [GARMENT]",
        config=(tyro.conf.FlagCreatePairsOff,),
        description=f"{DraftList.__doc__}\n\nGarments: {names}.",
    )
    if not request.list:
        sys.stderr.write(
            f"Name a garment to draft, or give --list or {DESIGN} FILE. Garments: {names}.\n"
            "Example: swifttailor draft t-shirt --out t-shirt.json\n"
        )
        return USAGE_ERROR
    if request.json:
        listed = [
            {"name": d.name, "summary": d.summary, "options": [o.to_json() for o in d.options]}
            for d in drafts
        ]
        sys.stdout.write(json.dumps(listed, indent=2) + "\n")
    else:
        _print_table(drafts)
    return 0


def _print_table(drafts: tuple[DraftInfo, ...]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(highlight=False)
    for info in drafts:
        table = Table(title=f"{info.name}: {info.summary}", title_justify="left", title_style="bold")
        for heading in ("option", "accepts", "default", "what it is"):
            table.add_column(heading, no_wrap=heading in ("option", "default"))
        for field in info.options:
            table.add_row(_flag(field), field.accepted(), _shown(field.default), field.option.help)
        console.print(table)


def _draft(name: str, arguments: list[str]) -> int:
    from swifttailor.pattern.drafts import draft, find_draft

    info = find_draft(name)
    request = tyro.cli(
        _request_class(info),
        args=arguments,
        prog=f"swifttailor draft {info.name}",
        description=f"{info.summary}. Lengths in cm.",
    )
    options = {f.name: getattr(request, f.name) for f in info.options}
    pattern = draft(info.name, measurements=_measurements(request.body), **options)
    place = request.out if request.out is not None else new_place(info.name, ".json")
    path = pattern.save(place, overwrite=request.overwrite)
    sys.stdout.write(f"{path}: {info.name}, {len(pattern.panels)} panels, {len(pattern.stitches)} stitches\n")
    return 0


def _request_class(info: DraftInfo) -> type[Any]:
    """A dataclass with one field, and so one flag, for every option of the garment."""
    fields: list[tuple[str, Any, Any]] = [
        ("out", Annotated[Path | None, tyro.conf.arg(help=_OUT, metavar="FILE")], None),
        ("overwrite", Annotated[tyro.conf.FlagCreatePairsOff[bool], tyro.conf.arg(help=_OVERWRITE)], False),
        (
            "body",
            Annotated[
                Path | None,
                tyro.conf.arg(help="Body mesh to draft for; its measurements are used. None: default body."),
            ],
            None,
        ),
    ]
    for field in info.options:
        literal: Any = Literal
        kind: Any = literal[field.choices] if field.choices else field.kind
        note = field.option.help
        if not field.choices and field.kind is not bool:
            note = f"{note} From {field.accepted()}."
        fields.append((field.name, Annotated[kind, tyro.conf.arg(help=note)], field.default))
    specification = [
        (name, kind) if default is dataclasses.MISSING else (name, kind, dataclasses.field(default=default))
        for name, kind, default in fields
    ]
    return dataclasses.make_dataclass("Request", specification, frozen=True)


def _measurements(body: Path | None) -> Measurements | None:
    if body is None:
        return None
    from swifttailor.body import Body

    return Body.load(body).measurements


def _flag(field: OptionField) -> str:
    name = field.name.replace("_", "-")
    return f"--{name} / --no-{name}" if field.kind is bool else f"--{name}"


def _shown(value: object) -> str:
    return (
        str(value).lower()
        if isinstance(value, bool)
        else f"{value:g}"
        if isinstance(value, float)
        else str(value)
    )
