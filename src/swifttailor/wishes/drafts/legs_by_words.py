"""Legs with what words say that no claim does: an elastic waist, hems that drag on the floor."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.trims.trims_by_place import is_elastic_behind

ELASTIC = "elastic"
"""Key of ``cannot.txt``: gathers at the waist stand for it."""
PULLED_ON = "pulled_on"
"""Beside such keys: that nothing is to close trousers, so that they are pulled on."""
_DRAGS = re.compile(
    r"(?<!\w)(?:(?:drag|trail|puddl|pool)\w*\s+(?:(?:on|along|over|across|at|around)\s+)?(?:the\s+|my\s+)?"
    r"(?:floor|ground|feet|shoes)|puddling|puddle hems?"
    r"|(?:super|extra|very|really|too|extremely)[\s-]+long(?!\s+(?:sleeves?|arms?|zips?|slits?|rise)))(?!\w)",
    re.IGNORECASE,
)
_NOT_LONG = re.compile(r"(?<!\w)(?:not|\w*n['’]t|nicht)\s+(?:\w+\s+){0,3}?(?:too|so|very|extra)\s+long", re.I)
_SOFT = re.compile(
    r"(?<!\w)(?:comf(?:y|ier|iest|ortable)|cosy|cozy|snuggl\w*|stay(?:ing)? at home|sofa|loung\w*|slouch\w*"
    r"|(?:long[- ]haul|flights?|plane|airplane|travel(?:l?ing)?|train journey|road trip|car journeys?)"
    r"|arthritis|after (?:an? |the |my )?(?:operation|surgery)|wheelchair|bequem\w*)(?!\w)",
    re.IGNORECASE,
)
_FIRM = re.compile(
    r"(?<!\w)(?:jeans?|denim|tailor\w*|suit|smart\w*|office|work|formal\w*|chinos?|cargos?|cords?|corduroy"
    r"|slacks|dress (?:pants|trousers)|fly|zips?|zipped|buttons?|buttoned|creases?|turn[- ]?ups?|belts?"
    r"|sailor|wide|flared?|flares|skinny|darts?)(?!\w)",
    re.IGNORECASE,
)
"""Trousers that are to be easy to live in have an elastic waist, but not those that are firm by name."""
_FOLDED = re.compile(
    r"(?<!\w)(?:(?:fold(?:s|ed|able|ing)?|roll(?:s|ed)?|turn(?:s|ed)?)[\s-]?(?:over|down|top)\b[\s-]?"
    r"(?:waist|band|top)\w*|yoga[\s-](?:waist|band)\w*|(?:rolled|folded|foldable) waist\w*"
    r"|(?:waist|waistband|band)(?: \w+){0,3} (?:fold|roll)(?:s|ed)? (?:it )?(?:over|down))(?!\w)",
    re.IGNORECASE,
)
_BANDED = ("leggings", "flares", "pull-on-trousers", "joggers", "circle-skirt", "fitted-skirt")
_FOLDED_CM = 9.0
"""Height of a band of jersey that is folded down, as it is worn."""
_DRAGGING_CM = 113.0
_TO_FLOOR = re.compile(
    r"(?<!\w)(?:(?:to|reach(?:es|ing)?|touch(?:es|ing)?|skim(?:s|ming)?|brush(?:es|ing)?|graz(?:es|ing|e)"
    r"|sweep(?:s|ing)?) the (?:floor|ground)|floor[- ](?:length|skimming|sweeping|grazing)"
    r"|cover(?:s|ing)? (?:my|the) (?:shoes|feet|heels)"
    r"|long enough (?:for|to (?:go with|wear with|cover|go over))"
    r" (?:my |the |high )*heels|(?:worn |to go |to wear )over (?:my |the |high )*heels|heel[- ]length"
    r"|bodenlang|bis (?:zum|auf den) boden|jusqu['’ ]au sol|hasta el suelo)(?!\w)",
    re.IGNORECASE,
)
_FLOOR_CM, _FLOOR_NARROW_CM, _WIDE_CM = 107.0, 104.5, 30.0
"""Of legs that reach the floor and do not lie on it: those with less room than that rest on the feet."""
_LONG_CM = 90.0
"""Legs that end above the ankle are not meant."""
_CALF = Claim("leg_hem", "calf")
_FULL, _SHORTER_CM = Claim("leg_hem", "full"), 92.0
"""Legs that are not to be so long, and how long they are then."""
_FLARE_A_LITTLE = re.compile(
    r"(?<!\w)(?:slight(?:ly)?|subtl[ey]|gent(?:ly|le)|soft(?:ly)?|small|mini"
    r"|an? (?:little|bit|touch|tad)(?: of)?(?: an?)?)"
    r" (?:kick[- ]?)?flare[sd]?(?!\w)(?! (?:skirt|sleeve))",
    re.IGNORECASE,
)
_LITTLE_FLARE_CM = 16.0
"""Flares that are to be slight are so much wider at the hem than at the knee."""
_LONGEST = ("trousers", "pull-on-trousers")
_NOT_DRAGGING: Mapping[str, float] = {"flares": 106.0, "jeans": 106.0}
"""Drafts whose legs reach the floor and cannot be longer."""
_SEVEN_EIGHTHS = re.compile(
    r"(?<![\w/])(?:7/8(?:th)?s?|seven[- ]eighths?|siebenachtel|sept huitièmes|siete octavos|sette ottavi"
    r"|sete oitavos|zeven achtste)(?![\w/])"
    r"(?!\W*(?:lang\w* |length )?(?:sleeve|arm|ärmel|manche|manga|manica|mouw))",
    re.IGNORECASE,
)
"""Legs that end a hand above the ankle bone, higher than ankle length does."""
_CROPPED = re.compile(
    r"(?<!\w)(?<!not )(?<!n't )(?<!never )(?<!nor )(?<!non-)"
    r"(?:crop(?:ped)?|ankle[- ]swinging|half[- ]mast)(?!\w)(?! (?:jacket|top|tee|cardigan|sleeve))",
    re.I,
)
_SLIGHTLY, _SLIGHTLY_CM = re.compile(r"(?<!\w)(?:slightly|a (?:little|bit|touch)|just) cropped", re.I), 91.0
_CROPPED_CM: Mapping[str, float] = {
    "trousers": 84.0,
    "pull-on-trousers": 84.0,
    "jeans": 84.0,
    "flares": 86.0,
    "jumpsuit": 84.0,
    "strappy-jumpsuit": 84.0,
    "strapless-jumpsuit": 84.0,
    "halter-jumpsuit": 84.0,
    "wrap-jumpsuit": 84.0,
    "dungarees": 84.0,
}
"""Legs that end a hand above the ankle, as cropped ones do: culottes and capris are shorter by name."""
_ON_BODICES, _CROPPED_FLARE_CM = tuple([name for name in _CROPPED_CM if name.endswith("jumpsuit")]), -1.0
"""Jumpsuits whose cropped legs fall straight: they would narrow to the calf."""
_WHOLE_LEGS = ("trousers", "pull-on-trousers", "jeans", "leggings", "flares")
_PULLED_ON: Mapping[str, float] = {"hip_ease": 7.0, "leg_ease": 22.0, "flare": -8.0}
"""What trousers that are gathered at the waist have at least, as they have no darts."""
_GATHERED_DRESSES, _GATHERS = ("skater-dress", "shirt-dress"), 1.7
"""Dresses whose skirt can be gathered into the waist, and how much wider it then is."""
_OF_BOTH = ("length", "hip_ease", "leg_ease", "flare", "below_waist")


def legs_as_said(
    draft: NamedDraft, text: str, wanted: Collection[str], never: Collection[Claim]
) -> NamedDraft:
    """Trousers that drag, and what is gathered at the waist, where a text says so; others as they are.

    Args:
        draft: As it was asked for otherwise.
        text: All of it.
        wanted: Keys of ``cannot.txt`` that it asks for.
        never: What it refuses.
    """
    folded = _FOLDED.search(text) is not None
    if is_elastic_behind(text):  # smooth in front, with darts
        wanted = [what for what in wanted if what != ELASTIC]
        if draft.name == "pull-on-trousers":
            draft = NamedDraft("trousers", tuple([each for each in draft.options if each[0] in _OF_BOTH]))
    soft = _SOFT.search(text) is not None and _FIRM.search(text) is None
    if draft.name == "trousers" and (folded or soft or not {ELASTIC, PULLED_ON}.isdisjoint(wanted)):
        kept = {name: value for name, value in draft.options if name in _OF_BOTH}
        room = max(_PULLED_ON["hip_ease"], float(kept.get("hip_ease", 0.0)))
        draft = NamedDraft("pull-on-trousers", tuple({**_PULLED_ON, **kept, "hip_ease": room}.items()))
    options = dict(draft.options)
    if folded and draft.name in _BANDED:
        options["band_height"] = _FOLDED_CM
        draft = replace(draft, options=tuple(options.items()))
    if draft.name in _GATHERED_DRESSES and ELASTIC in wanted:
        full = max(_GATHERS, float(options.get("gathers", 0.0)))
        return replace(draft, options=tuple({**options, "gathers": full}.items()))
    if draft.name == "flares" and _FLARE_A_LITTLE.search(text):
        options["flare"] = min(_LITTLE_FLARE_CM, float(options.get("flare", _LITTLE_FLARE_CM)))
        draft = replace(draft, options=tuple(options.items()))
    long = float(options.get("length", _LONG_CM)) >= _LONG_CM
    if draft.name in _CROPPED_CM and long and _CALF not in never and _CROPPED.search(text):
        cropped = _SLIGHTLY_CM if _SLIGHTLY.search(text) else _CROPPED_CM[draft.name]
        more = {"flare": _CROPPED_FLARE_CM} if "flare" not in options and draft.name in _ON_BODICES else {}
        return replace(draft, options=tuple({**options, "length": cropped, **more}.items()))
    if draft.name in _WHOLE_LEGS and long and _SEVEN_EIGHTHS.search(text):
        return replace(draft, options=tuple({**options, "length": _SHORTER_CM}.items()))
    if draft.name in _LONGEST and long and _DRAGS.search(text) and not _NOT_LONG.search(text):
        draft = replace(draft, options=tuple({**options, "length": _DRAGGING_CM}.items()))
    elif draft.name in _LONGEST and long and _TO_FLOOR.search(text):
        wide = float(options.get("leg_ease", _WIDE_CM)) >= _WIDE_CM
        length = _FLOOR_CM if wide else _FLOOR_NARROW_CM
        draft = replace(draft, options=tuple({**options, "length": length}.items()))
    elif draft.name in _NOT_DRAGGING and long and _TO_FLOOR.search(text):
        draft = replace(draft, options=tuple({**options, "length": _NOT_DRAGGING[draft.name]}.items()))
    elif draft.name in _LONGEST and _FULL in never:
        length = min(_SHORTER_CM, float(options.get("length", _SHORTER_CM)))
        draft = replace(draft, options=tuple({**options, "length": length}.items()))
    return draft
