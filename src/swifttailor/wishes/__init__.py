"""What a text asks for: its statements about a garment, read by a small network of its own.

May import wording, describing, networks and what lies below them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.wishes.reader import WishReader

_PUBLIC = {
    "WishReader": "reader",
}

__all__ = [
    "WishReader",
]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)
