"""Putting what a garment shows into words: captions, instructions, wishes read back to people.

May import describing and what lies below it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.wording.captions import write_caption
    from swifttailor.wording.description import Description, describe

_PUBLIC = {
    "Description": "description",
    "describe": "description",
    "write_caption": "captions",
}

__all__ = [
    "Description",
    "describe",
    "write_caption",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)
