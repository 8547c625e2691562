"""What an instruction takes back: "shorter sleeves, or no, sorry, longer ones".

Only what was said last counts. What it leaves out, the part and the number, is that of what it corrects.
"""

from __future__ import annotations

import re

from swifttailor.wishes.instructions.change_words import PartWord, find_adjectives, find_changes, find_parts
from swifttailor.wishes.instructions.spoken_targets import clauses_of
from swifttailor.wishes.text.mentions import find_mentions

_FIRM = (
    r"no,? wait|wait,? no|wait|(?:scratch|strike|forget) that|actually,? no|no,? actually|or rather|or better"
    r"|on second thoughts?|hang on|hold on|correction|(?:no,? )?i meant?(?: to say)?|(?:no,? )?make that"
    r"|no,? sorry|sorry,? no|oops|whoops|nein,? doch|ach nein|quatsch|non,? plutôt|no,? mejor|anzi|o meglio"
    r"|nee,? toch|ou melhor"
)
"""Takes back whatever was said before it."""
_SOFT = r"(?:(?:or|oh|ah|uh|um|er|hm+|well|but),? )*(?:no|nope|nah|sorry|actually)"
"""Takes back what was said of the same part: "no" may also begin what there is to be none of."""
_TAKEN_BACK = re.compile(
    rf"(?:\s*[,;.…!–—-]+\s*|\s+)(?:(?:or|oh|ah|uh|um|er|hm+|well|but),? )*"
    rf"(?:(?P<firm>{_FIRM})(?!\w)|(?<=[\s,;.…!–—-])(?P<soft>{_SOFT})(?=\s*[,:–—-]|(?<=actually)\s))"
    rf"(?:[\s,.…:–—-]+(?:{_FIRM}|no|sorry|actually)(?!\w))*[\s,.…:–—-]+",
    re.IGNORECASE,
)
_BESIDES = re.compile(r"\W*(?:and|also|too|plus|please also)(?!\w)", re.IGNORECASE)
"""Before what is asked for beside what came before."""
_ONES = re.compile(r"\s*(?<!\w)(?:the )?ones?(?!\w)(?! \w*(?:side|shoulder|sleeve|arm))", re.IGNORECASE)
_MOST = 3


def without_taken_back(text: str) -> str:
    """An instruction without what it takes back itself; as it is where it takes back nothing.

    Args:
        text: In any case.
    """
    start = 0
    for _ in range(_MOST):
        found = _TAKEN_BACK.search(text, start)
        if found is None:
            break
        corrected = _corrected(text, found)
        start = found.end() if corrected is None else 0
        text = text if corrected is None else corrected
    return text


def _corrected(text: str, found: re.Match[str]) -> str | None:
    before, behind = text[: found.start()], text[found.end() :]
    olds, news = clauses_of(before.lower()), clauses_of(behind.lower())
    if not olds or not news or _BESIDES.match(behind):
        return None
    begin, end = olds[-1][0], news[0][1]
    old, new = before[begin:], behind[:end]
    was, now = _parts(old), _parts(new)
    if found["firm"] and was and now and _changes(old) and not _changes(new):
        # "Shorten the sleeves, I mean the skirt": what was asked for, of another part.
        kept = f"{old[: was[-1].start]}{now[-1].word}{old[was[-1].end :]}"
        return f"{before[:begin]}{kept}{behind[end:]}".strip()
    if not (_changes(old) and _changes(new)):
        return None
    if now and not found["firm"] and {p.part for p in was} != {p.part for p in now}:
        return None
    if was and not now:
        new = f"the {was[-1].word} {_ONES.sub('', new).strip()}"
    number = next((m for m in find_mentions(old) if m.is_length), None)
    if number is not None and not any(m.is_length for m in find_mentions(new)):
        new = f"{new.rstrip()} by {old[number.start : number.end]}"
    return f"{before[:begin]}{' ' if begin else ''}{new}{behind[end:]}".strip()


def _changes(said: str) -> bool:
    """Whether it says how something is to be, or to be otherwise than it is."""
    small = said.lower()
    return bool(find_changes(small) or find_adjectives(small))


def _parts(said: str) -> list[PartWord]:
    return [p for p in find_parts(said.lower()) if p.part != "all"]
