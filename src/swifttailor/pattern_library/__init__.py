"""Patterns that are known already: those that fit best what a picture shows and what words ask for.

May import picture_reader, wishes, describing, pattern and what lies below them; numpy is all it needs.
"""

from swifttailor.pattern_library.known import PatternLibrary
from swifttailor.pattern_library.nearest import Found, Search
from swifttailor.pattern_library.sought import Sought

__all__ = ["Found", "PatternLibrary", "Search", "Sought"]
