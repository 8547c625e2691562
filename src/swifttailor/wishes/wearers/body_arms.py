"""Arms of wearers: whose are short, or long, has sleeves as long as these."""

from __future__ import annotations

import re

from swifttailor.wishes.wearers.body_said import SaidBody

_SHORT, _LONG = r"short(?:er|ish)?|kurze[nr]?", r"long(?:er|ish)?|lange[nr]?"
_VERY = r"(?:(?:very|really|quite|rather|pretty|such|sehr|ziemlich|a bit) )*"
_HAS = (
    r"(?:(?<!\w)(?:i|he|she|they|who|dad|husband|son|mum|wife|mann|frau|er|sie|ich)(?:['’]ve|['’]s)? "
    r"(?:has|have|had|got|with|hat|habe|haben)(?: got)?(?!\w)[^.;!?]{0,60}?(?<!\w)"
    r"|(?<!\w)(?:my|his|her|their|meine|seine|ihre) )"
)
_ARMS = re.compile(
    rf"(?P<lead>{_HAS}){_VERY}(?:(?P<short>{_SHORT})|(?:{_LONG})) (?:arms?|arme)"
    r"(?![\w-]| ?(?:holes?|bands?|length))",
    re.IGNORECASE,
)
_USUAL_CM, _OTHERWISE_CM = {"women": 53.5, "men": 58.0}, 4.5
"""From the shoulder to the wrist, and how much shorter or longer arms are that are called so."""


def hear_arms(said: SaidBody, figure: str | None) -> None:
    """Takes the length of somebody's arms out of a text; "long arms" of a top are its sleeves.

    Args:
        said: What was found so far; it is added to.
        figure: ``women`` or ``men``, as the text says it.
    """
    match = _ARMS.search(said.text)
    if match is None or "arm_length" in said.measures or said.age is not None:
        return
    sign = -1.0 if match["short"] else 1.0
    said.measures["arm_length"] = _USUAL_CM.get(figure or "", _USUAL_CM["women"]) + sign * _OTHERWISE_CM
    said.take(match, match["lead"])
