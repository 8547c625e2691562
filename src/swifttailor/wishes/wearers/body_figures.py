"""Whether a woman, a man or a child is to wear a garment, in other languages than English."""

from __future__ import annotations

import re

from swifttailor.wishes.wearers.body_words import whole_word

_JUST = re.compile(
    r"(?<!\w)(?:jeune fille|petite fille modèle|kinder surprise|junge[rsn]? (?:frau|mann|mode))",
    re.IGNORECASE,
)


def without_events(text: str) -> str:
    """The text without the feasts of others: "boda de mi hermano"."""
    return _JUST.sub(" ", whole_word("figures", "event").sub(" ", text))


def spoken_figure(text: str) -> str | None:
    """The figure that a text speaks of, where a size or measures ask for one."""
    text = without_events(text)
    for figure in ("children", "men", "women"):
        if whole_word("figures", figure).search(text):
            return figure
    return None


def is_for_a_child(text: str) -> bool:
    """Whether a text says that it is for a child: "für meinen Sohn"."""
    return whole_word("figures", "child_for").search(without_events(text)) is not None
