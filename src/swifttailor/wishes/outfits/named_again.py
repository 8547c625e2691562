"""Two garments that are named first and told of afterwards: "skirt and blouse, the blouse white".

What is told of each is put behind its name, where all that follows looks for it.
"""

from __future__ import annotations

import re

_TWO = re.compile(
    r"(?P<one>(?:an? |the |my )?(?:[\w-]+ ){0,2}?(?P<a>[\w-]+)) and "
    r"(?P<other>(?:an? |the |my )?(?:[\w-]+ ){0,2}?(?P<b>[\w-]+))"
    r"(?P<both>(?: (?:in|for|of|from|please)(?!\w)[^,:;.]*)?)[,:;.]\s*"
    r"(?=(?:with |and )?the (?:(?P=a)|(?P=b))(?!\w))",
    re.IGNORECASE,
)
_JOINT = r"\s*[,;.]\s*(?:and |with )?|\s+and "


def told_behind_names(text: str) -> str:
    """The text with what is told of each garment behind its name; the text itself where nothing is told so.

    Args:
        text: A description in any case, in English.
    """
    two = _TWO.search(text)
    if two is None:
        return text
    names = two["a"].lower(), two["b"].lower()
    begins = rf"(?:with |and )?the (?P<name>{re.escape(names[0])}|{re.escape(names[1])})(?!\w)"
    parts = re.split(rf"(?:^|{_JOINT})(?={begins})", text[two.end() :], flags=re.IGNORECASE)
    told = dict.fromkeys(names, "")
    for part in parts:
        found = re.match(begins, part or "", re.IGNORECASE)
        if found is not None:
            told[found["name"].lower()] += part[found.end() :].rstrip(" .,;")
    return (
        f"{text[: two.start()]}{two['one']}{told[names[0]]}, and {two['other']}{told[names[1]]}{two['both']}"
    )
