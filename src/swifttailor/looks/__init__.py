"""How pictures show garments: cloth, wearer, light, backdrop and camera of a look, and a picture in it.

May import render, garment and what lies below them.
"""

from __future__ import annotations

from swifttailor.looks.draw import draw_look, draw_seen
from swifttailor.looks.look import Look, random_look
from swifttailor.looks.plain_look import plain_look

__all__ = ["Look", "draw_look", "draw_seen", "plain_look", "random_look"]
