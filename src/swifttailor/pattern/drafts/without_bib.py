"""What drafts with a bib are where they have none: on braces, or on a waistband alone."""

from __future__ import annotations

from collections.abc import Mapping

WITHOUT_BIB: Mapping[str, tuple[str, ...]] = {
    "dungarees": ("trousers", "shorts"),
    "pinafore": ("skirt",),
    "apron": ("skirt",),
}
"""Kinds of garments, by name of the draft."""
SHOWN_WITHOUT_BIB: Mapping[str, tuple[str, ...]] = {
    "dungarees": ("suspenders",),
    "pinafore": ("suspenders",),
    "apron": ("apron",),
}
"""Keys of the lexicon's ``cannot.txt`` that they then show."""
