"""Trims that a text names by where they lie or how far they go: pockets at the back, buttons to the waist."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

_LOWER = ("trousers", "shorts")
_ON_THE_BELLY = ("hoodie", "sweatshirt")
"""Drafts whose pocket in front is a kangaroo's."""
_FAR = 45
"""A place stands at most so many characters behind what lies there."""
_BACK = (
    r"(?:back|rear|backside|seat|bum)(?!\w|[ -](?:neck|hem|pockets?|zip))|behind"
    r"|hinten|am rücken|auf dem rücken|(?:dans le|au) dos|derrière|a la espalda|en la espalda|(?:por )?detrás"
)
_CHEST = r"(?:chest|breast|heart|brust|poitrine|pecho)(?!\w)"
_THIGH = (
    r"(?:thighs?|(?:side of the |each |outer |on the |down the )legs?|oberschenkel|cuisses?|muslos?)(?!\w)"
)
_LOW = (
    r"(?:low down|lower down|low on|at (?:the |my )?hips?|on (?:the |my |each )?hips?"
    r"|(?:at )?hip (?:height|level)|below the waist|under the waist|near the hem|at the bottom"
    r"|(?:either|each|both) sides?|auf den hüften|unten|sur les hanches|en bas|en las caderas|abajo)(?!\w)"
)
_SIDES = r"(?:(?:at|in|on) the sides?|side seams?|in den seitennähten|sur les côtés|a los lados)(?!\w)"
_FRONT = r"(?:front|middle|centre|center|tummy|belly|stomach|vorne|vorn|bauch|devant|ventre|delante)(?!\w)"
_NECK = r"(?:neck(?:line)?|collar|hals|ausschnitt|encolure|col|cuello|escote)(?!\w)"
_SHOULDERS = r"(?:shoulders?|yoke|schultern?|passe|épaules?|empiècement|hombros?|canesú)(?!\w)"
_HIGH = (
    r"(?:half ?-?way(?: down)?|(?:down )?to (?:the |my |mid )?(?:chest|bust|breast ?bone)|bis zur brust"
    r"|jusqu['’ ]à la poitrine|hasta el pecho)(?!\w)"
)
_TO_WAIST = (
    r"(?:(?:down |only |just |as far as |up )*(?:to|until|till|as far as)"
    r"|(?:end|stop|finish)(?:s|ing)? (?:at|above)) (?:the |my |her )?(?:natural )?waist(?:line)?(?!\w)"
    r"|(?:on|down) the bodice(?!\w)|bis (?:zur|an die) taille|jusqu['’ ]à la taille|hasta la cintura"
)
_NOUNS: Mapping[str, str] = {
    "pockets": r"pockets?|taschen?|poches?|bolsillos?",
    "buttons": r"button(?:s|ed|ing)?(?: up| down| through)?|knöpfen?|geknöpft|boutons|boutonnée?|botones",
    "zip": r"zips?|zippers?|rei(?:ß|ss)verschluss|fermeture(?: éclair)?|cremallera",
    "pleats": r"pleat(?:s|ing|ed)?|falten?|plis|pliegues",
    "elastic": r"elastic|elasticated|gummizug|gummi|élastique|elástico",
}
"""Words of what is put on, by key of what no panel is cut for."""
_ONE = re.compile(r"pocket|tasche|poche|bolsillo")
_STOP = re.compile(
    r"[.;,:!?\n]|(?<!\w)(?:and|with|but|plus|und|mit|et|avec|y|con)(?!\w)"
    rf"(?! (?:(?:at|in|on|an|der|the) )*(?:{_BACK}|{_FRONT}|{_SIDES}|{_CHEST}|{_THIGH}))",
    re.IGNORECASE,
)
_REFUSED = re.compile(r"(?<!\w)(?:no|not|without|never|ohne|keine?|sans|sin)(?: \w+)? ?$", re.IGNORECASE)
_BEFORE = re.compile(
    r"(?<!\w)(?:front|cent(?:re|er|ral)|middle) pocket(?!\w)|(?:one|single|a) (?:very )?"
    r"(?:big|large|wide|huge|giant) (?:square |patch |flat )?pocket(?!\w)"
    r"(?! (?:on|at) the (?:side|back|thigh|leg|chest|breast))",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class _Place:
    """A place, and what lies there, the best first."""

    where: str
    one: tuple[str, ...]
    more: tuple[str, ...]
    on_legs: tuple[str, ...] | None = None
    """The same on trousers, where that is something else."""


def _places(draft: str) -> Mapping[str, tuple[_Place, ...]]:
    middle = ("kangaroo pocket",) if draft in _ON_THE_BELLY else ("front pocket", "kangaroo pocket")
    return {
        "pockets": (
            _Place(_CHEST, ("chest pocket",), ("chest pockets",)),
            _Place(_THIGH, ("thigh pocket", "cargo pockets"), ("cargo pockets", "thigh pocket")),
            _Place(_BACK, ("lower back pockets",), ("lower back pockets",), ("back pockets",)),
            _Place(_SIDES, ("side pockets",), ("side pockets",)),
            _Place(_LOW, ("patch pockets", "welt pockets"), ("patch pockets", "welt pockets")),
            _Place(_FRONT, middle, ("patch pockets",), ("slant pockets",)),
        ),
        "buttons": (
            _Place(_TO_WAIST, ("waist placket",), ("waist placket",), ()),
            _Place(_HIGH, ("polo placket",), ("polo placket",), ()),
            _Place(_BACK, ("back buttons",), ("back buttons",)),
        ),
        "zip": (
            _Place(_HIGH, ("half zip",), ("half zip",), ()),
            _Place(_BACK, ("back zip",), ("back zip",)),
            _Place(_SIDES, ("side zip",), ("side zip",)),
            _Place(_FRONT, ("zip",), ("zip",), ("fly",)),
        ),
        "pleats": (
            _Place(_NECK, ("neck pleats",), ("neck pleats",), ()),
            _Place(_SHOULDERS, ("shoulder pleats",), ("shoulder pleats",), ()),
            _Place(_BACK, ("back pleat",), ("back pleat",), ()),
            _Place(_FRONT, ("pleated front",), ("pleated front",), ("front pleats",)),
        ),
        "elastic": (_Place(_BACK, ("back elastic",), ("back elastic",)),),
    }


def trims_by_place(text: str, what: str, *, kind: str = "", draft: str = "") -> tuple[tuple[str, ...], ...]:
    """What is told of a kind of trim by its place or extent: of each, the best that can be put there first.

    Args:
        text: All of it.
        what: "pockets", "buttons", "zip", "pleats" or "elastic"; of others nothing is told.
        kind: Of the garment.
        draft: That it is cut from.
    """
    if what not in _NOUNS:
        return ()
    found: list[tuple[str, ...]] = []
    for noun in re.finditer(rf"(?<![\w-])(?:{_NOUNS[what]})(?!\w)", text, re.IGNORECASE):
        if _REFUSED.search(text[: noun.start()]):
            continue
        tail = text[noun.end() : noun.end() + _FAR]
        stop = _STOP.search(tail)
        tail = tail if stop is None else tail[: stop.start()]
        one = _ONE.fullmatch(noun[0].lower()) is not None
        own = [p for p in _places(draft)[what] if re.search(rf"(?<!\w)(?:{p.where})", tail, re.IGNORECASE)]
        for place in own:
            there = place.one if one else place.more
            if kind in _LOWER and place.on_legs is not None:
                there = place.on_legs
            if draft == "leggings" and place.where == _THIGH:  # too close for flaps
                there = ("thigh pocket",)
            found += [there] if there else []
    if what == "pockets" and not found and kind not in _LOWER and _BEFORE.search(text):
        found = [_places(draft)[what][-1].one]
    return tuple(dict.fromkeys(found))


def is_elastic_behind(text: str) -> bool:
    """Whether a waistband has elastic in its back alone, and so is smooth in front."""
    return bool(trims_by_place(text, "elastic")) or _HALF.search(text) is not None


_HALF = re.compile(
    r"(?<!\w)(?:part(?:ial|ly|ially)?|half|semi|back|rear)[- ]?(?:elastic\w*)(?!\w)(?! hem)"
    r"|flat[- ]front(?:ed)?,? elastic(?:ated)? back|elastic(?:ated)? back(?: waist\w*)?(?!\w)",
    re.IGNORECASE,
)
