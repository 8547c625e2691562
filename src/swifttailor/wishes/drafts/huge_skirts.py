"""Skirts that a text calls huge, poofy or those of a ball gown: cut from one and a half circles.

Gathers alone do not make a skirt stand out: cloth that they pull together hangs down from the waist.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wording.lexicon import read_words

_HUGE = (
    r"(?:huge|enormous|massive|giant|gigantic|ginormous|humongous|poof(?:y|ie)|pouff?y|puffy|voluminous|immense"
    r"|big|bouffant|extra[- ]full|(?:very|really|super|so|extremely) (?:full|wide|big))"
)
_POOFY = r"(?:poof(?:y|ie)|pouff?y|puffy|bouffant|fluffy)"
_SAID = re.compile(
    rf"(?<!\w)(?<!no )(?<!not )(?:{_HUGE},? "
    r"(?:(?!sleeves?|bows?|collar|pockets?|and )[\w'-]+,? ){0,3}?skirts?"
    rf"|skirts?(?: (?:that|which|part|is|should|be|to|really|all|so|very|super))*,? {_HUGE}"
    r"(?! (?:sleeve|bow|collar|pocket))"
    rf"|{_POOFY},? (?:(?!sleeve)[\w'-]+,? ){{0,3}}?(?:dress|gown|frock)(?:es|s)?"
    rf"|(?:dress|gown|frock),? (?:(?!sleeve|no|with)[\w'-]+,? ){{0,3}}?{_POOFY}"
    r"(?! (?:\w+ )?(?:sleeve|shoulder|skirt|jacket|coat|vest))"
    r"|ball ?gowns?|ball ?gown skirts?|ball skirts?|(?:like|for) (?:a |my little )?princess"
    r"|princess(?:[- ]style)? (?:dress|gown|skirt)"
    r"|cinderella|quince(?:a[nñ]era)?|meringue|crinoline|hoop skirts?)(?!\w)",
    re.IGNORECASE,
)
_DENIED = re.compile(r"(?<!\w)(?:no|not|nothing|without|never|isn't|n't)(?: \w+){0,3} $", re.IGNORECASE)
_SIZE_BEFORE = re.compile(rf"(?<!\w){_HUGE}\s+$", re.IGNORECASE)
_FULLEST = 1.5
_ROUND: Mapping[str, str] = {
    "circle-skirt": "fraction",
    "skater-dress": "skirt_fraction",
    "shirt-dress": "skirt_fraction",
    "strapless-dress": "skirt_fraction",
    "strappy-dress": "skirt_fraction",
    "off-shoulder-dress": "skirt_fraction",
}
"""Drafts with a round skirt, and the option of its part of a circle."""
_STRONG_CM, _HELD_CLOSE = 3.0, {"bust_ease": 1.0, "waist_ease": 0.0}
"""Straps that hold up so heavy a skirt, and a bodice that does."""
_NOT_ROUND = ("gathers", "fitted", "flounce", "hem_band", "pleats")
_GATHERED, _FULLNESS = "gathered-skirt", 3.0


def huge_as_said(draft: NamedDraft, text: str) -> NamedDraft:
    """A skirt, or a dress with one, as full as can be cut where a text says so; others as they are.

    Args:
        draft: As it goes with all else that is asked for.
        text: The words.
    """
    if _SAID.search(text) is None:
        return draft
    text = _without_prints(text)
    if not any(not _DENIED.search(text[: found.start()]) for found in _SAID.finditer(text)):
        return draft
    options = dict(draft.options)
    if draft.name == _GATHERED and not options.get("hem_band"):
        return replace(draft, options=tuple({**options, "fullness": _FULLNESS}.items()))
    if draft.name == "off-shoulder-dress" and not options.get("waist_seam"):
        return draft
    if draft.name not in _ROUND or any(float(options.get(name, 0.0)) >= 1.0 for name in _NOT_ROUND):
        return draft
    if draft.name == "strappy-dress":
        options |= {**_HELD_CLOSE, "strap_width": max(float(options.get("strap_width", 0.0)), _STRONG_CM)}
    return replace(draft, options=tuple({**options, _ROUND[draft.name]: _FULLEST}.items()))


def _without_prints(text: str) -> str:
    """The text, where figures of a print are large, and not the skirt: "a skirt with big flowers"."""
    for mark in read_words(text).marks:
        if any(entry.category == "prints" for entry in mark.entries):
            size = _SIZE_BEFORE.search(text[: mark.start])
            start = mark.start if size is None else size.start()
            text = f"{text[:start]}{' ' * (mark.end - start)}{text[mark.end :]}"
    return text
