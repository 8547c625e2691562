"""What a text says of a neckline in front and of the one behind: "a round neck in front and a V behind"."""

from __future__ import annotations

import re

from swifttailor.describing.claims import Claim
from swifttailor.wishes.text.spoken_sides import SpokenSides

_FRONT = {
    **{"v": "neckline=v", "vee": "neckline=v", "round": "neckline=round", "square": "neckline=square"},
    **{"crew": "neckline=crew", "scoop": "neckline=scoop", "scooped": "neckline=scoop"},
    **{
        "boat": "neckline=boat",
        "bateau": "neckline=boat",
        "high": "neck_depth=high",
        "low": "neck_depth=low",
    },
    **{"deep": "neck_depth=low", "plunging": "neck_depth=plunging"},
}
_BACK = {
    **{"v": "back_neckline=v", "vee": "back_neckline=v", "round": "back_neckline=round"},
    **{"scoop": "back_neckline=round", "scooped": "back_neckline=round", "square": "back_neckline=square"},
    **{
        "high": "back_depth=high",
        "low": "back_depth=low",
        "deep": "back_depth=low",
        "open": "back_depth=open",
    },
}
_OF_HEMS = frozenset({"high", "low"})
"""What is said of hems as well."""
_NECK = r"(?:[- ]?(?:neck(?:line)?s?|cut))?"


def _patterns(shapes: dict[str, str], face: str, behind: str) -> tuple[re.Pattern[str], ...]:
    shape = rf"(?P<shape>{'|'.join(sorted(shapes, key=len, reverse=True))})"
    return (
        re.compile(
            rf"(?<![\w-]){shape}{_NECK},? (?:(?:{behind})(?![\w-])|(?:at|in|on) (?:the )?{face}(?![\w-]))"
        ),
        re.compile(rf"(?<![\w-])(?<!in )(?<!the ){face}{_NECK}(?:,|:| is)? (?:an? )?{shape}(?![\w])"),
    )


_FRONTS = _patterns(_FRONT, "front", "in front|in the front")
_BACKS = _patterns(_BACK, "back", "behind|in back|at the rear")


def spoken_faces(text: str) -> SpokenSides:
    """What a text says of both faces of a neckline; nothing where it speaks of one alone.

    Args:
        text: In any case.
    """
    small = text.lower()
    front = next((m for pattern in _FRONTS if (m := pattern.search(small))), None)
    back = next((m for pattern in _BACKS if (m := pattern.search(small))), None)
    if front is None or back is None or (front.start() < back.end() and back.start() < front.end()):
        return SpokenSides()
    if {front["shape"], back["shape"]} & _OF_HEMS and "neck" not in front[0] + back[0]:
        return SpokenSides()  # "high at the front and low at the back" is a hem
    said = _FRONT[front["shape"]], _BACK[back["shape"]]
    return SpokenSides(tuple([Claim(*one.split("=")) for one in said]), (front.span(), back.span()))
