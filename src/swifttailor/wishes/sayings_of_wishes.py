"""What people say of a garment that they wish for in other words than the lexicon has, put into plain ones.

Grammar that neighbouring words do not show: "one sleeve puffed, the other shoulder bare", "between the knee and the
ankle", "high in front and low behind", "10 inches up from the hem" of a slit.
"""

from __future__ import annotations

import re
from functools import cache

_N = r"(?:an?|one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|\d[\d.,/]*) ?(?:cms?|centimet\w+|inch(?:es)?|in|\"|mm)"
_BARE = r"(?:(?:left|all|completely|entirely|totally|quite|fully) )*(?:bare|naked|uncovered|exposed|nothing|without)"
_SAYINGS: tuple[tuple[str, str], ...] = (
    # One side.
    (
        r"(?:one|a single) (?P<how>(?:[\w-]+ ){0,2})sleeve(?P<what>[^.;,]{0,40}?),? (?:and |with |but )?(?:on )?(?:the other|one) (?:shoulder|arm|side)(?: is| left)? "
        + _BARE
        + r"\b",
        r"bare left shoulder, right sleeve only, \g<how>sleeves\g<what>",
    ),
    # Shapes by what they are like.
    (
        r"sleeves? (?:shaped |cut |that look |that are |look |looking )?(?:like|as|in the shape of) (?:an? |the |those of an? )?(?P<what>angel|bat|butterfly|bell|trumpet|funnel"
        r"|balloon|lantern|bishop|wizard|witch|fairy|kimono|pirate|poet)(?:'s|s)?(?: wings?)?(?: sleeves?)?\b",
        r"\g<what> sleeves",
    ),
    (r"wings? (?:for|as) sleeves\b", "angel sleeves"),
    (r"(?:trousers|pants)(?P<more>[^.;]{0,30}?) (?:but|that|which|and)(?: it| they)? looks? (?:just )?like a skirt\b", r"culottes\g<more>"),
    (r"column(?= (?:in|of|cut|made|with|to)\b)", "column dress"),
    # Heights.
    (r"(?:(?:somewhere|halfway|half way|midway|anywhere) )?(?:in )?between (?:the |my |her )?knees? and (?:the |my |her )?ankles?\b", "calf length"),
    (r"(?:(?:somewhere|halfway|half way|midway|anywhere) )?(?:in )?between (?:the |my |her )?elbows? and (?:the |my |her )?wrists?\b", "three quarter length"),
    (r"(?:(?:somewhere|halfway|half way|midway|anywhere) )?(?:in )?between (?:the |my |her )?shoulders? and (?:the |my |her )?elbows?\b", "short"),
    (r"(?:(?:somewhere|halfway|half way|midway|anywhere) )?(?:in )?between (?:the |my |her )?(?:hips?|crotch) and (?:the |my |her )?knees?\b", "mid thigh length"),
    (
        r"(?:cut )?(?:high|closed|demure|modest) in (?:the )?front (?:and|but|yet|,) ?(?:\w+ly )?(?:low|plunging|scooped|deep|open|bare|backless) (?:behind|(?:at|in) the back)\b",
        "with a high neckline and a low back",
    ),
    (
        r"(?:cut )?(?:low|plunging|scooped|deep) in (?:the )?front (?:and|but|yet|,) ?(?:\w+ly )?(?:high|closed|modest|demure) (?:behind|(?:at|in) the back)\b",
        "with a low neckline and a high back",
    ),
    # Slits.
    (
        r"(?:one|a|a single|just one|only one) (?:slit|split|vent),? (?:just |only )?(?:on |at |up |in )?(?:the |my )?(?P<side>left|right|back|front)(?: hand)?(?: side| leg)?(?: only)?\b",
        r"slit on the \g<side> only",
    ),
    (rf"(?P<before>(?:slit|split|vent)s?\b[^.;]{{0,40}}?),? (?:that (?:goes|comes|reaches) |going |reaching |coming )?(?P<n>{_N}) up from the hem\b", r"\g<before>, slit \g<n>"),
    # Parts.
    (r"(?:triangles?|triangular (?:pieces|panels|inserts)|wedges|gussets) (?:let|set|sewn|put|inserted|added)(?: in)?(?:to)?(?: it| the skirt| the sides| at the sides| the hem)?\b", "with godets"),
    (r"not (?:also )?(?:a|like a) (?:tent|sack|bag|potato sack|bin bag)\b", "easy fit"),
)


def plainly_wished(text: str) -> str:
    """A description with such sayings put plainly; the rest as it is.

    Args:
        text: In any case.
    """
    for pattern, plain in _compiled():
        text = pattern.sub(plain, text)
    return text


@cache
def _compiled() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple([(re.compile(rf"(?<![\w-]){pattern}", re.IGNORECASE), plain) for pattern, plain in _SAYINGS])
