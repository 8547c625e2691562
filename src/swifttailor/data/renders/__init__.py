"""Pictures of garments to learn from: how each is to look, and a split's pictures in files."""

from __future__ import annotations

from swifttailor.data.renders.draw import draw_look, draw_seen
from swifttailor.data.renders.look import Look, random_look
from swifttailor.data.renders.plain_look import plain_look

__all__ = ["Look", "draw_look", "draw_seen", "plain_look", "random_look"]
