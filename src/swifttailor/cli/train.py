"""``swifttailor train``: trains the networks; finds the one that was asked for."""

from __future__ import annotations

import sys

USAGE_ERROR = 2

_OVERVIEW = """Train the networks.

usage: swifttailor train NETWORK [OPTIONS]

  garment-sewer  The network that drapes patterns without physics.
                 swifttailor train garment-sewer --data DIR --out RUN
  pattern-maker  The network that writes patterns from text, pictures and other patterns.
                 swifttailor train pattern-maker --patterns FILE... --out RUN
  export         A trained network as one file that is used without torch: .onnx of a GarmentSewer,
                 .zip of a PatternMaker.
                 swifttailor train export RUN --out FILE

  swifttailor train NETWORK --help   all options
"""


def run_train(arguments: list[str]) -> int:
    """Runs ``swifttailor train`` with the arguments that follow.

    Returns:
        The exit code.

    Raises:
        SwiftTailorError: What the training raises.
    """
    name = arguments[0] if arguments else ""
    if name == "garment-sewer":
        import tyro

        from swifttailor.cli.train_garment_sewer import TrainGarmentSewer

        kind = TrainGarmentSewer
        return tyro.cli(kind, args=arguments[1:], prog="swifttailor train garment-sewer").run()
    if name == "pattern-maker":
        import tyro

        from swifttailor.cli.train_pattern_maker import TrainPatternMaker

        return tyro.cli(TrainPatternMaker, args=arguments[1:], prog="swifttailor train pattern-maker").run()
    if name == "export":
        import tyro

        from swifttailor.cli.train_export import TrainExport

        return tyro.cli(TrainExport, args=arguments[1:], prog="swifttailor train export").run()
    if name in ("-h", "--help"):
        sys.stdout.write(_OVERVIEW)
        return 0
    if name:
        sys.stderr.write(f"There is no network '{name}'. ")
    sys.stderr.write(_OVERVIEW)
    return USAGE_ERROR
