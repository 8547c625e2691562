"""Altering a pattern: recutting it until what is wished for can be seen on it."""

from __future__ import annotations

from swifttailor.alterations.alter import Alteration, alter

__all__ = ["Alteration", "alter"]
