"""Lengths as they are meant of coats: a short one is a jacket, a three-quarter one ends at the knee.

A long one ends at the ankles, a short cape at the hips.

The same words say something else of skirts and tops: a short skirt bares the thighs, a short top the waist.
"""

from __future__ import annotations

import re

from swifttailor.wording.lexicon import read_words

_CLOTH_COAT = r"(?:over|top)?coat"
_SHORT_ONES = rf"(?:{_CLOTH_COAT}|trench(?: ?coat)?|jacket|puffer|blazer|anorak)"
_VERY = r"(?:(?:really|very|super|extra|extremely|ultra|so) )?"
_SHORT = rf"(?:(?:quite|pretty|fairly|rather|nice and|kind of|a bit) )?{_VERY}(?:short|shortish|shorter)"
_OF_PARTS = (
    r"(?! ?-?(?:sleeve|arm|zip|collar|leg|pile|nap|hair|fur|lapel|belt|in|at|on|notice|person|woman|man)\w*)"
)
_WORD = (
    r"(?:(?!(?:for|my|i|im|am|is|who|she|he|we|with|not|too|no|but|or|sleeves?|sleeved|zip|skirt|dress"
    r"|trousers|top|shorts|coats?|jackets?)\b)[\w'-]+)"
)
_BEFORE = re.compile(
    rf"(?<![\w-])(?<!not )(?<!too )(?<!i'm )(?<!am ){_SHORT}{_OF_PARTS},? "
    rf"(?P<name>(?:{_WORD} ){{0,4}}?{_SHORT_ONES})(?!\w)(?! (?:dress|skirt|coat|jacket))",
    re.IGNORECASE,
)
_BEHIND = re.compile(
    rf"(?<![\w-])(?P<name>(?:{_WORD} )?{_SHORT_ONES}(?!\w)(?! (?:dress|skirt|coat|jacket))"
    rf"(?:[ ,]+{_WORD}){{0,5}}?)"
    rf"[ ,]+(?:(?:but|and|cut|kept|it'?s|to be|should be) )*{_SHORT}{_OF_PARTS}(?: length)?(?!\w)"
    r"(?= *(?:[.,;!?]|$|with\b|and\b|but\b|please\b))",
    re.IGNORECASE,
)
_SHORT_CAPE = re.compile(
    rf"(?<![\w-])(?<!not )(?<!too )(?<!i'm )(?<!am ){_SHORT}{_OF_PARTS},? "
    rf"(?P<name>(?:{_WORD} ){{0,4}}?)(?:cape|cloak)(?!\w)(?! (?:dress|coat|sleeve|top|jacket|blazer)s?)",
    re.IGNORECASE,
)
_THREE_QUARTERS = re.compile(
    r"(?<![\w/])(?:three|3)(?:[ -]quarters?|/4)(?:[ -](?:length|long))?(?![\w/])"
    r"(?![ -]*(?:length |long )?(?:sleeve|arm|circle))",
    re.IGNORECASE,
)
_NO_FIGURE = r"(?<!\d )(?<!cm )(?<!inches )(?<!inch )(?<!metres )"
_LONG_BEFORE = re.compile(
    rf"(?<![\w-])(?<!not )(?<!too )long{_OF_PARTS},? (?P<name>(?:{_WORD} ){{1,3}}?{_CLOTH_COAT})(?!\w)",
    re.IGNORECASE,
)
_LONG_BEHIND = re.compile(
    rf"(?<![\w-])(?P<name>{_CLOTH_COAT}(?:[ ,]+{_WORD}){{0,2}}?)[ ,]+{_NO_FIGURE}long{_OF_PARTS}"
    r"(?= *(?:[.,;!?]|$))",
    re.IGNORECASE,
)
"""A long coat ends at the ankles: one to the floor would be trodden on."""
_COAT = re.compile(
    r"(?<![\w-])(?:(?:over|top|trench|rain|great|pea)?coat|parka|mac|mackintosh|duster)(?!\w)"
    r"(?! (?:dress|skirt))",
    re.IGNORECASE,
)


def coats_by_length(text: str) -> str:
    """A text with lengths of coats and jackets put as they are meant; others as they are.

    Args:
        text: A description of one garment, in any case.
    """
    if _COAT.search(text):
        text = _THREE_QUARTERS.sub("knee length", text)
    text = _LONG_BEFORE.sub(r"ankle length \g<name>", text)
    text = _LONG_BEHIND.sub(r"\g<name>, ankle length", text)
    text = _SHORT_CAPE.sub(r"\g<name>hip length cape", text)
    found = _BEFORE.search(text) or _BEHIND.search(text)
    if found is None:
        return text
    name = re.sub(rf"(?<![\w-]){_CLOTH_COAT}(?!\w)", "jacket", found["name"], flags=re.IGNORECASE)
    comma = "," if found.re is _BEFORE and text[found.end() :].startswith(" ") else ""
    put = f"{text[: found.start()]}{name}, to the high hip{comma}{text[found.end() :]}"
    kinds = {i.claim.value for i in read_words(put).implications if i.claim.name == "kind"}
    return put if kinds == {"top"} else text
