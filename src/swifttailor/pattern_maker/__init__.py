"""Stage 1 (paper, Sec. 4.1): from words and pictures to a sewing pattern. See docs/pattern-maker.md.

May import pattern, networks and what lies below wishes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.pattern_maker.maker import PatternMaker, WrittenPattern
    from swifttailor.pattern_maker.tokens.decode import decode
    from swifttailor.pattern_maker.tokens.encode import encode

_PUBLIC = {
    "PatternMaker": "maker",
    "WrittenPattern": "maker",
    "decode": "tokens.decode",
    "encode": "tokens.encode",
}

__all__ = [
    "PatternMaker",
    "WrittenPattern",
    "decode",
    "encode",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)
