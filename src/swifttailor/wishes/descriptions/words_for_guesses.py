"""Details that a network guesses, and words of which one at least stands in a text that means them.

It has read of many trumpet sleeves on evening dresses: where a text says nothing of sleeves, none are meant.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from swifttailor.describing.claims import Claim

_SLEEVES = (
    r"sleeve\w* (?:that|which|are|is|should|gather|wide|full|big|to|like|with|over|from)|bell|flar|wide|puff"
    r"|full|balloon|bishop|big|large|huge|loose|flow|trumpet|kimono|batwing|gather|cuff|flutter|float|open"
    r"|dramatic|medieval|angel|poet|statement|boho|hippie|70s|seventies|1970|romantic|volume|oversized"
    r"|lantern|juliet|trail|point|fairy|elastic|princess|prairie|milkmaid|peasant|victorian|edwardian"
    r"|suffrag|gibson|19[01]\d|regency|tudor|wizard|witch|elf|elven|mutton|blouson"
)
_BIG = (
    r"big|large|huge|enormous|giant|massive|baggy|loose|slouch|boyfriend|over-?size|room|wide|tent|cocoon"
    r"|size|men|man|husband|dad|brother|swamp|drown|hide|blanket|pyjama|layer|box|kaftan|poncho|batwing|xl"
)
_BIG_DETAILS = re.compile(
    r"(?:big|large|huge|wide|oversized|enormous|giant) (?:[\w-]+ )?(?:buttons?|pockets?|collars?|bows?"
    r"|cuffs?|hood|lapels?|belt|buckle|zip|dots|spots|checks|flowers|stripes|roses)",
    re.IGNORECASE,
)
"""What is big besides the garment."""
_WORDS: Mapping[Claim, re.Pattern[str]] = {
    **dict.fromkeys(
        [Claim("sleeve_shape", shape) for shape in ("bell", "balloon", "puffed")],
        re.compile(_SLEEVES, re.IGNORECASE),
    ),
    Claim("fit", "oversized"): re.compile(_BIG, re.IGNORECASE),
    Claim("hem_shape", "high-low"): re.compile(
        r"long|short|\bhigh|\blow|dip|tail|train|drop|trail|slop|slant|mullet|waterfall|behind", re.IGNORECASE
    ),
    Claim("waistband", "wide"): re.compile(
        r"band|waist|belt|yoga|elastic|high|bump|matern|pregnan|tummy|corset|basque|yoke|pull", re.IGNORECASE
    ),
    Claim("neckline", "asymmetric"): re.compile(
        r"asym|uneven|slant|diagonal|one|shoulder|side|left|right|odd|drap|wrap", re.IGNORECASE
    ),
}


def may_be_meant(claim: Claim, text: str) -> bool:
    """Whether a text has a word for what a network reads in it.

    Args:
        claim: What is read.
        text: As it is read.
    """
    words = _WORDS.get(claim)
    return words is None or words.search(_BIG_DETAILS.sub("", text)) is not None
