"""Recutting a pattern until what is wished for can be seen on it: the ways to cut, the levers, `alter`.

May import describing, panel_mesh, pattern and what lies below them.
"""

from __future__ import annotations

from swifttailor.recutting.alter import Alteration, alter

__all__ = ["Alteration", "alter"]
