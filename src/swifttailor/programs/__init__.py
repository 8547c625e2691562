"""GarmentCode's garment programs: a sewing pattern from design parameters and a body's measurements.

Rewritten from GarmentCode (Maria Korosteleva and Olga Sorkine-Hornung, 2023), with its names for parts,
parameters and operations: the same parameters give the same patterns. Its MIT licence is LICENSE-GarmentCode,
beside this file.

May import the lowest floors, `pattern` and `body`.
"""

from __future__ import annotations

from swifttailor.programs.body_parameters import BodyParameters
from swifttailor.programs.design_error import DesignError
from swifttailor.programs.design_parameters import DESIGN_PARAMETERS, DesignParameter
from swifttailor.programs.design_reader import complete_design, read_design
from swifttailor.programs.garment import make_pattern

__all__ = [
    "DESIGN_PARAMETERS",
    "BodyParameters",
    "DesignError",
    "DesignParameter",
    "complete_design",
    "make_pattern",
    "read_design",
]
