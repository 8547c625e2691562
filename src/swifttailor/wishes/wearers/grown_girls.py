"""Girls who are grown: "tall girl looking for jeans", "bridesmaid dresses for three girls"."""

from __future__ import annotations

import re

_YOUNG = re.compile(
    r"(?<!\w)(?:\d{1,2}[- ]?(?:years?|yrs?|months?)|aged?|ages|years?|yrs?|twins?|kids?|child\w*|toddlers?"
    r"|little|small|class|pupils?|daughters?"
    r"|school(?:wear|girls?)?|primary|nursery|(?:my|her|his|our) (?:baby )?girl)(?!\w)",
    re.IGNORECASE,
)
_LOOKS = (
    r"tall|short|petite|curvy|plus[- ]?sized?|big|bigger|larger|thick|chubby|skinny|slim|busty|working|office"
    r"|uni|college|older|grown|party|indie|emo|goth|alt|pregnant|single|country|midsize|mid[- ]size"
)
_NOT_NAMES = r"(?<!flower )(?<!land )(?<!pin-up )(?<!gibson )(?<!cow)"
_GROWN = tuple(
    [
        re.compile(pattern, re.IGNORECASE)
        for pattern in (
            rf"(?<![\w-])(?:{_LOOKS}) {_NOT_NAMES}girls?(?!\w| (?:size|clothes|dress))",
            r"(?<!\w)(?:i['’]?m|i am|as|being) (?:just )?(?:an? )?(?:[\w-]+ ){0,2}girl(?!\w)",
            r"(?<!\w)(?:hey|hi|hello|omg|yo|ok|please|thanks),? girls?(?!\w)",
            r"^\W*girls?(?=,| i | we | can | please )",
            r"(?<!\w)girl (?:looking|here|searching|in search|who (?:works|needs|loves|wears|likes))(?!\w)",
            r"(?<!\w)girl with (?:an? )?(?:big|wide|large|long|short|hips|curves|thighs|no)(?!\w)",
        )
    ]
)
"""Who is spoken of so is no child, whatever else is told but an age."""
_AMONG_GROWN = re.compile(
    r"(?<!\w)(?:bridesmaids?|bridal|bride|hen (?:party|do|night)|maids? of honou?r|bachelorette|sorority"
    r"|colleagues?|staff|receptionists?|waitress(?:es)?|barmaids?|nightclub|clubbing)(?!\w)",
    re.IGNORECASE,
)
_GIRL = re.compile(
    rf"{_NOT_NAMES}(?<![\w-])(?P<girl>girl)(?P<more>s?)(?![\w-])(?! (?:guides?|scouts?))",
    re.IGNORECASE,
)


def with_grown_girls(text: str) -> str:
    """A text in which girls who are no children are women.

    Args:
        text: In any case; one that tells an age, a school or a daughter stays as it is.
    """
    if _YOUNG.search(text):
        return text
    if _AMONG_GROWN.search(text):
        return _GIRL.sub(_woman, text)
    for pattern in _GROWN:
        text = pattern.sub(lambda found: _GIRL.sub(_woman, found[0]), text)
    return text


def _woman(found: re.Match[str]) -> str:
    return "women" if found["more"] else "woman"
