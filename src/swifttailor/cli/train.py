"""``swifttailor train``: trains the networks."""

from __future__ import annotations

from swifttailor.cli.command_group import CommandGroup, GroupedCommand

TRAIN = CommandGroup(
    "train",
    "Train the networks.",
    {
        "garment-sewer": GroupedCommand(
            "The network that predicts how patterns drape.",
            "swifttailor train garment-sewer --data DIR --out RUN",
            "swifttailor.cli.train_garment_sewer:TrainGarmentSewer",
        ),
        "pattern-maker": GroupedCommand(
            "The network that writes patterns from text, pictures and other patterns.",
            "swifttailor train pattern-maker --patterns FILE... --out RUN",
            "swifttailor.cli.train_pattern_maker:TrainPatternMaker",
        ),
        "wish-reader": GroupedCommand(
            "The network that reads what texts ask for.",
            "swifttailor train wish-reader --patterns FILE... --validation FILE... --out RUN",
            "swifttailor.cli.train_wish_reader:TrainWishReader",
        ),
        "picture-reader": GroupedCommand(
            "The network that reads what pictures show.",
            "swifttailor train picture-reader --data DIR... --validation DIR... --out RUN",
            "swifttailor.cli.train_picture_reader:TrainPictureReader",
        ),
        "export": GroupedCommand(
            "A trained network as one file that is used without torch: .onnx of a GarmentSewer\n"
            "or a reader of wishes or pictures, .zip of a PatternMaker.",
            "swifttailor train export RUN --out FILE",
            "swifttailor.cli.train_export:TrainExport",
        ),
    },
)
