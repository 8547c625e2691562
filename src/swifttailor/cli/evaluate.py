"""``swifttailor evaluate``: the paper's tables; finds the one that was asked for."""

from __future__ import annotations

import sys

USAGE_ERROR = 2

_OVERVIEW = """Measure how good the networks are, beside the paper's numbers (docs/evaluation.md).

usage: swifttailor evaluate WHAT [OPTIONS]

  garment-sewer  Garments that a GarmentSewer sews, against the drapes of the same patterns.
                 swifttailor evaluate garment-sewer --data DIR --split test
  drape-floor    Drapes against drapes of the same patterns: how near anything can come.
                 swifttailor evaluate drape-floor --data DIR --split validation --limit 30 --out DIR

  swifttailor evaluate WHAT --help   all options
"""


def run_evaluate(arguments: list[str]) -> int:
    """Runs ``swifttailor evaluate`` with the arguments that follow.

    Returns:
        The exit code.

    Raises:
        SwiftTailorError: What the evaluation raises.
    """
    name = arguments[0] if arguments else ""
    if name == "garment-sewer":
        import tyro

        from swifttailor.cli.evaluate_garment_sewer import EvaluateGarmentSewer

        kind = EvaluateGarmentSewer
        return tyro.cli(kind, args=arguments[1:], prog="swifttailor evaluate garment-sewer").run()
    if name == "drape-floor":
        import tyro

        from swifttailor.cli.evaluate_drape_floor import EvaluateDrapeFloor

        return tyro.cli(EvaluateDrapeFloor, args=arguments[1:], prog="swifttailor evaluate drape-floor").run()
    if name in ("-h", "--help"):
        sys.stdout.write(_OVERVIEW)
        return 0
    if name:
        sys.stderr.write(f"There is nothing named '{name}' to evaluate. ")
    sys.stderr.write(_OVERVIEW)
    return USAGE_ERROR
