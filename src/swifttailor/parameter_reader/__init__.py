"""Design parameters of garment programs, read out of what is known of a garment.

What pictures and words say (`pattern_library.sought`) is turned into GarmentCode's design parameters, from
which `programs` drafts a pattern. Known patterns are the nearest of so many; a draft can be what is sought
itself.

May import `programs`, `pattern_library` and what these may import.
"""

from swifttailor.parameter_reader.reader import ParameterReader

__all__ = ["ParameterReader"]
