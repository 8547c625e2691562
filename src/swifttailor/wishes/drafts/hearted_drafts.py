"""Named drafts with a neckline like the upper edge of a heart, between shoulders that are covered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NECKLINE, STRAP_WIDTH, SWEETHEART, WIDE_CM, NamedDraft
from swifttailor.wording.lexicon import Lack

_MAY_BE = (
    *("shirt", "t-shirt", "tank-top", "fitted-top", "peplum-top"),
    *("fitted-dress", "skater-dress", "mermaid-dress", "empire-dress", "drop-waist-dress"),
    *("shift-dress", "swing-dress", "jumpsuit"),
)
"""Drafts whose necklines may be cut so."""
_WIDENING_CM, _DEPTH_CM = 4.0, 16.0
"""A heart is as wide and as deep as that: a narrower one is a slit, a higher one has no lobes."""
_STRAPLESS, _DIP_CM = "strapless-jumpsuit", 5.0
"""What has no shoulders and a straight edge otherwise, and how far that falls in the middle of a heart."""
_STRAPPY, _STRAPPY_CM, _OF_STRAPPY = "strappy-dress", 62.0, ("skirt_length", "skirt_fraction", "gathers")
"""What hangs on wide straps has a straight edge, which one cut like shoulders has not; how long it is, cm."""
_OF_SHIRTS = ("length", "chest_ease", "sleeve_length", "sleeve_end", "sleeve_shape", "arm_ease")
"""Options of shirts that T-shirts have as well."""
_OTHERS = frozenset({"collar", "hood"})
_BARE = Claim("shoulders", "strapless")


def hearted_as_asked(draft: NamedDraft, lacks: Sequence[Lack], claims: Sequence[Claim]) -> NamedDraft:
    """A draft with a sweetheart neckline where one is asked for; those that cannot have it as they are.

    Args:
        draft: As it goes with what else is asked for.
        lacks: What the text asks for that is not made by cutting.
        claims: What is asked for, all of it.
    """
    if not any(lack.what == SWEETHEART for lack in lacks):
        return draft
    if draft.name == _STRAPLESS:
        return replace(draft, options=tuple({**dict(draft.options), "dip": _DIP_CM}.items()))
    if draft.name == _STRAPPY and float(dict(draft.options).get(STRAP_WIDTH, 0.0)) >= WIDE_CM:
        kept = [option for option in draft.options if option[0] in _OF_STRAPPY]
        draft = NamedDraft("skater-dress", (("skirt_length", _STRAPPY_CM), *kept))
    if draft.name not in _MAY_BE or draft.stands:
        return draft
    if _BARE in claims or any(claim.name in _OTHERS and claim.value != "none" for claim in claims):
        return draft
    if draft.name == "shirt":  # a blouse, whose front is closed below such a neck
        draft = NamedDraft("t-shirt", tuple([each for each in draft.options if each[0] in _OF_SHIRTS]))
    own = dict(draft.options)
    if "collar" in own:
        return draft
    least = {"neck_widening": _WIDENING_CM, "neck_depth": _DEPTH_CM}
    wide = {name: max(float(own.get(name, 0.0)), cm) for name, cm in least.items()}
    return replace(draft, options=tuple({**own, NECKLINE: SWEETHEART, **wide}.items()))
