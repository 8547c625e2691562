"""GarmentCode's garment programs: a sewing pattern from design parameters and a body's measurements.

Rewritten from GarmentCode (Maria Korosteleva and Olga Sorkine-Hornung, 2023), with its names for parts,
parameters and operations: the same parameters give the same patterns. Its MIT licence is LICENSE-GarmentCode,
beside this file.

May import the lowest floors, `pattern` and `body`.
"""

from __future__ import annotations

__all__: list[str] = []
