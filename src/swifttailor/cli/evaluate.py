"""``swifttailor evaluate``: the paper's tables."""

from __future__ import annotations

from swifttailor.cli.command_group import CommandGroup, GroupedCommand

EVALUATE = CommandGroup(
    "evaluate",
    "Measure how good the networks are, beside the paper's numbers (docs/evaluation.md).",
    {
        "garment-sewer": GroupedCommand(
            "Garments that a GarmentSewer sews, against the drapes of the same patterns.",
            "swifttailor evaluate garment-sewer --data DIR --split test",
            "swifttailor.cli.evaluate_garment_sewer:EvaluateGarmentSewer",
        ),
        "pattern-maker": GroupedCommand(
            "Patterns that a PatternMaker writes and edits, against true ones.",
            "swifttailor evaluate pattern-maker --patterns FILE --data DIR --edits FILE --out DIR",
            "swifttailor.cli.evaluate_pattern_maker:EvaluatePatternMaker",
        ),
        "picture-reader": GroupedCommand(
            "What a picture reader reads of pictures of garments, against their patterns.",
            "swifttailor evaluate picture-reader --weights FILE --data DIR --out DIR",
            "swifttailor.cli.evaluate_picture_reader:EvaluatePictureReader",
        ),
        "systems": GroupedCommand(
            "Any generator of patterns with any way to sew them, in the paper's tables.",
            "swifttailor evaluate systems --patterns FILE --data DIR --generators ours truth --out DIR",
            "swifttailor.cli.evaluate_systems:EvaluateSystems",
        ),
        "page": GroupedCommand(
            "One page of the tables of recorded runs of evaluate systems.",
            "swifttailor evaluate page RUN/summary.json --out results.md",
            "swifttailor.cli.evaluate_page:EvaluatePage",
        ),
        "drape-floor": GroupedCommand(
            "Drapes against drapes of the same patterns: how near anything can come.",
            "swifttailor evaluate drape-floor --data DIR --split validation --limit 30 --out DIR",
            "swifttailor.cli.evaluate_drape_floor:EvaluateDrapeFloor",
        ),
    },
)
