"""What people say of a garment in other words than those of parts and changes, put into plain ones.

"Gather them into a cuff", "it slides off my waist", "cut both sides open to the thigh" and "can it not be
there" name what is wanted by what is done, felt or seen. They are rewritten before an instruction is read, so
that everything behind this has to know one way of saying it. The table is for anybody to extend.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from swifttailor.wishes.instructions.change_words import find_changes, find_parts
from swifttailor.wishes.instructions.shared_removals import parted
from swifttailor.wishes.text.sayings_table import SayingsTable, read_sayings

_TABLE = Path(__file__).with_name("sayings.txt")
_GRIP = {
    **dict.fromkeys(("skirt", "trousers", "shorts"), "a tighter waist"),
    **dict.fromkeys(("dress", "top", "tunic", "jumpsuit", "playsuit"), "a tighter chest"),
}
_DRAG = dict.fromkeys(("trousers", "shorts", "jumpsuit", "playsuit"), "shorten the legs")
_FEET = {
    **dict.fromkeys(("trousers", "jumpsuit"), "full length legs"),
    **dict.fromkeys(("dress", "skirt"), "to the floor"),
}
_HIGH = re.compile(r"thigh|hip")
_CAN_GO = frozenset({"collar", "hood", "sleeves", "cuffs", "band", "leg_cuffs", "slit"})
_NAME_OF = {"band": "waistband", "leg_cuffs": "leg cuffs"}


def plainly(text: str, kind: str) -> str:
    """An instruction with such sayings put plainly; the rest as it is.

    Args:
        text: In any case.
        kind: Of the garment that it is about.
    """
    small = text.lower().replace("\u2019", "'")
    if len(small) != len(text):
        return text
    text = _not_there(small) or small
    table = _table()
    for saying in table.sayings:
        if not saying.kinds or kind in saying.kinds:
            text = saying.pattern.sub(lambda found, plain=saying.plain: _filled(found, plain, kind), text)
    text = parted(_rule("and").sub(" and ", text))
    text = _rule("made_of_it").sub(lambda found: found[0] if _asks_something(found[0]) else "", text)
    text = _rule("looks").sub("", text) if len(re.split(r"[.;,!?]", text)) > 1 else text
    text = _rule("close_around").sub(
        lambda found: found[0]
        if _rule("asks").search(found["before"])
        else f"{found['before']}too {found['close']} ",
        text,
    )
    text = _rule("too_in_others").sub("demasiado ", text)
    return _rule("said_to_be").sub(_too, text)


def _too(found: re.Match[str]) -> str:
    """What is said to be a bit tight is too tight, where nobody asks that it be so."""
    return found[0] if _rule("asks").search(found["before"]) else f"{found['before']}too {found['adjective']}"


def _asks_something(said: str) -> bool:
    return bool(find_changes(said)) or any(p.part != "all" for p in find_parts(said))


def _not_there(text: str) -> str | None:
    """A sentence that ends in "can it not be there", as the removal of what it spoke of last."""
    found = _rule("not_there").search(text)
    if found is None:
        return None
    before = [p for p in find_parts(text[: found.end()]) if p.part in _CAN_GO]
    own = [p for p in before if p.start >= found.start()]
    if not before:
        return None
    part = (own or before)[-1].part
    return f"{text[: found.start()]} remove the {_NAME_OF.get(part, part)} {text[found.end() :]}".strip()


def _filled(found: re.Match[str], plain: str, kind: str) -> str:
    if "{" not in plain:
        return found.expand(plain)
    groups = found.groupdict()
    side = groups.get("side") or ""
    high = "thigh high" if _HIGH.search(groups.get("to") or "") else ""
    sides = {"left": "on the left", "right": "on the right", "front": "in front", "back": "at the back"}
    if plain.startswith("slit"):
        many = "side slits" if plain.startswith("slits") else f"slit {sides.get(side, sides['left'])}"
        return f"{many}, {high} slits" if high else many
    if plain == "{gone}":
        return f"remove the {groups.get('what') or groups.get('flat')}"
    return plain.format(
        grip=_GRIP.get(kind, "tighter"),
        feet=_FEET.get(kind, found[0]),
        drag=_DRAG.get(kind, "shorten the hem"),
    )


def _rule(name: str) -> re.Pattern[str]:
    return _table().rules[name]


@cache
def _table() -> SayingsTable:
    return read_sayings(_TABLE)
