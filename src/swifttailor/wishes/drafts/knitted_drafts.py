"""Jumpers without ribbed bands: none goes around an open hem, nor around a wide sleeve."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.slits_as_told import slit_at_both_sides

_BANDED = "sweatshirt"
_UNBANDED = NamedDraft.parse("t-shirt(length=26;chest_ease=16;sleeve_length=60;sleeve_end=24;arm_ease=9)")
_SHORT = ("cap", "short", "elbow")


def without_bands_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A jumper as a knitted top without bands, where slits at the sides or short sleeves are asked for.

    Args:
        draft: As a table names it; others than jumpers stay.
        claims: What is asked for, all of it.
    """
    short = any(Claim("sleeves", length) in claims for length in _SHORT)
    return _UNBANDED if draft.name == _BANDED and (short or slit_at_both_sides(claims)) else draft
