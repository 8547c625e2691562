"""``swifttailor data``: data sets to learn from."""

from __future__ import annotations

from swifttailor.cli.command_group import CommandGroup, GroupedCommand

DATA = CommandGroup(
    "data",
    "Data sets to learn from.",
    {
        "build": GroupedCommand(
            "Drape patterns and put those that come out well into shards.",
            "swifttailor data build --patterns FILE... --out DIR",
            "swifttailor.cli.data_build:DataBuild",
        ),
        "import": GroupedCommand(
            "Put folders of GarmentCodeData into shards.",
            "swifttailor data import ROOT --out DIR [--splits FILE]",
            "swifttailor.cli.data_import:DataImport",
        ),
        "render": GroupedCommand(
            "Draw pictures of every garment of a data set.",
            "swifttailor data render DIR",
            "swifttailor.cli.data_render:DataRender",
        ),
        "captions": GroupedCommand(
            "Write texts about garments, from what their patterns show.",
            "swifttailor data captions SOURCE [--out FILE]",
            "swifttailor.cli.data_captions:DataCaptions",
        ),
        "edits": GroupedCommand(
            "Recut patterns and write instructions that ask for it.",
            "swifttailor data edits SOURCE --out FILE",
            "swifttailor.cli.data_edits:DataEdits",
        ),
        "verify": GroupedCommand(
            "Compare checksums and check everything that must hold of each sample.",
            "swifttailor data verify DIR",
            "swifttailor.cli.data_verify:DataVerify",
        ),
        "stats": GroupedCommand(
            "Numbers, contact sheets, and a page to look through.",
            "swifttailor data stats DIR",
            "swifttailor.cli.data_stats:DataStats",
        ),
    },
)
"""In the order in which they are needed."""
