"""Whether trousers are gathered at the waist: by a word about that, or by name, or as nothing closes them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.wishes.drafts.legs_by_words import ELASTIC, PULLED_ON
from swifttailor.wording.lexicon import Entry

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_CLOSINGS = frozenset({"zip", "buttons"})


def elastic_meant(heard: Heard) -> frozenset[str]:
    """That there is elastic, where words about details say so and mean the waist: not those of ankles."""
    ankles = any(claim.name == "leg_cuffs" for e in heard.meant for claim in e.claims("certain"))
    styles = [
        e for e in heard.meant if e.drafts and not ankles and (e.category == "styles" or _is_pulled_on(e))
    ]
    pulled = [PULLED_ON] if _CLOSINGS <= denied_lacks(heard) else []
    return frozenset([*pulled, *[key for e in styles for key in e.cannot if key == ELASTIC]])


def _is_pulled_on(entry: Entry) -> bool:
    """Whether it names trousers that are gathered at the waist."""
    return any(draft.name == "pull-on-trousers" for draft in entry.drafts)


def denied_lacks(heard: Heard) -> frozenset[str]:
    """What cannot be made of panels alone, and is refused."""
    marks = () if heard.words is None else heard.words.marks
    return frozenset([key for mark in marks if mark.denied for e in mark.entries for key in e.cannot])
