"""Dresses that begin from a draft with a low neck or a short skirt, and that a text wants modest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wording.lexicon import WordReading

_HIGH = Claim("neck_depth", "high")
_OF_THE_NECK = ("neckline", "neck_depth", "neck_depth_cm", "collar", "hood")
_NECKED = ("skater-dress", "fitted-dress", "shift-dress", "empire-dress", "swing-dress", "drop-waist-dress")
_DEEPEST_CM, _WIDEST_CM = 9.5, -1.0
_SKIRTED, _HEMS = ("skater-dress", "fitted-dress"), ("skirt_hem", "skirt_length_cm", "length_cm")
_BELOW_KNEE = Claim("skirt_hem", "below the knee")
_SHORTEST_CM = 71.0
"""Of a skirt from the waist, which ends below the knee."""


def modest_as_asked(draft: NamedDraft, words: WordReading | None, claims: Sequence[Claim]) -> NamedDraft:
    """A dress with a closed neck and a skirt below the knees where it is to be modest; others as they are.

    Args:
        draft: As it goes with what else is asked for.
        words: Of the text, by the lexicon.
        claims: What is asked for, all of it: who speaks of the neck gets that one.
    """
    if words is None or draft.name not in _NECKED:
        return draft
    moods = [i for i in words.implications if i.said and any(e.category == "fits" for e in i.mark.entries)]
    if _HIGH not in [mood.claim for mood in moods]:
        return draft
    options = dict(draft.options)
    if draft.name in _SKIRTED and not any(c.name in _HEMS and c != _BELOW_KNEE for c in claims):
        options["skirt_length"] = max(float(options.get("skirt_length", 0.0)), _SHORTEST_CM)
    necks = any(claim.name in _OF_THE_NECK and claim != _HIGH for claim in claims)
    if necks or "collar" in options:
        return replace(draft, options=tuple(options.items()))
    depth, widening = (float(options.get(name, 99.0)) for name in ("neck_depth", "neck_widening"))
    options |= {"neck_depth": min(depth, _DEEPEST_CM), "neck_widening": min(widening, _WIDEST_CM)}
    return replace(draft, options=tuple(options.items()))
