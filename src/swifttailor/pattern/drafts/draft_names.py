"""Drafts with their options as words name them, and what they show, for who does not load the garments."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from swifttailor.pattern.drafts.draft_kinds import DRAFT_KINDS, DRAFT_NAMES
from swifttailor.pattern.drafts.flares_to_the_eye import flares_to_the_eye
from swifttailor.pattern.drafts.wide_sleeves import wide_to_the_eye
from swifttailor.pattern.drafts.without_bib import SHOWN_WITHOUT_BIB, WITHOUT_BIB

_SHORT_CAPE_CM = 25.0
"""Capes that end less far below the waist are worn like tops."""


@dataclass(frozen=True, slots=True)
class NamedDraft:
    """A draft as a table names it: ``trousers(flare=24;leg_ease=6)``."""

    name: str
    """One of `DRAFT_NAMES`."""
    options: tuple[tuple[str, float | bool | str], ...] = ()
    """Those that are not as the draft has them by itself."""

    @classmethod
    def parse(cls, text: str) -> NamedDraft:
        """A name, and in parentheses options with their values, semicolons between them.

        Raises:
            ValueError: It is written otherwise, or there is no such draft; the message says which.
        """
        name, opens, inside = text.partition("(")
        if name not in DRAFT_NAMES:
            raise ValueError(f"there is no draft '{name}'. Known: {', '.join(DRAFT_NAMES)}.")
        if not opens:
            return cls(name)
        pairs = [one.partition("=") for one in inside.removesuffix(")").split(";")]
        if not inside.endswith(")") or not all(field and value for field, _, value in pairs):
            raise ValueError(f"'{text}' is not written like 'trousers(flare=24;leg_ease=6)'.")
        return cls(name, tuple([(field, _value(value)) for field, _, value in pairs]))

    @property
    def kind(self) -> str:
        """Of what is cut from it: a short cape is worn like a top, dungarees without a bib are trousers."""
        if self.without_bib:
            return self.without_bib[0]
        length = float(dict(self.options).get("length", _SHORT_CAPE_CM))
        return "top" if self.name == "cape" and length < _SHORT_CAPE_CM else DRAFT_KINDS[self.name]

    @property
    def without_bib(self) -> tuple[str, ...]:
        """Kinds that it is where straps alone hold it, or a waistband; empty of others."""
        return WITHOUT_BIB.get(self.name, ()) if ("bib", False) in self.options else ()

    @property
    def shows(self) -> tuple[str, ...]:
        """What it shows that no way to cut makes: keys of the lexicon's ``cannot.txt``."""
        closed = self.name == "cape" and dict(self.options).get("front") == "closed"
        opens = self.name == "turtleneck" and dict(self.options).get("opening", 0.0)
        collar = _COLLARS_SHOW.get(str(dict(self.options).get("collar", "")))
        shown = SHOWN_WITHOUT_BIB[self.name] if self.without_bib else DRAFTS_SHOW.get(self.name, ())
        if collar is not None:
            shown = (*[key for key in shown if key not in _COLLAR_KEYS], *collar)
        stretches = bool(dict(self.options).get("stretch", self.name in STRETCHING))
        shown = (*shown, *_ARMHOLES_SHOW.get(str(dict(self.options).get(ARMHOLE, "")), ()))
        if float(dict(self.options).get(DROPPED_BY, 0.0)) >= DROPPED_CM:
            shown = (*shown, DROPPED)
        tiered = self.name == "mermaid-dress" and dict(self.options).get("tiers")
        shown = (*shown, *(_OF_TIERED_DRESSES if tiered else ()))
        if float(dict(self.options).get("crotch_drop", 0.0)) >= LOW_CROTCH_CM:
            shown = (*shown, LOW_CROTCH)
        shown = (*shown, *[key for option, key in _OPTIONS_SHOW.items() if dict(self.options).get(option)])
        shown = (*shown, *([TRAILING] if dict(self.options).get("sleeve_shape") == "trailing" else ()))
        shown = (*shown, *([RACERBACK] if dict(self.options).get(RACER) else ()))
        dipped = self.name == "strapless-jumpsuit" and dict(self.options).get("dip", 0.0)
        shown = (*shown, *([SWEETHEART] if dipped or (NECKLINE, SWEETHEART) in self.options else ()))
        shown = tuple([key for key in shown if not (closed and key == "open_front")])
        curves = [CURVED_HEM] if dict(self.options).get(HEM_RISE, 0.0) else []
        curves += [PUFFBALL] if dict(self.options).get(HEM_BAND, 0.0) else []
        curves += [PLEATED] if float(dict(self.options).get(PLEATS, 0.0)) >= _LEAST_PLEATS else []
        return (*shown, *(["open_front"] if opens else ()), *(["stretch"] if stretches else ()), *curves)

    @property
    def stands(self) -> bool:
        """Whether it has a collar that stands on a close neck instead of the one that it has by itself."""
        return not {MANDARIN, STANDING, ROLLED, LOOSE, ("standing", True)}.isdisjoint(self.options)

    @property
    def is_to_the_eye(self) -> tuple[tuple[str, str | float], ...]:
        """Claims, by name and value, that are true of it to the eye, though not as they are measured."""
        stands = self.stands or self.name == "turtleneck"
        cut, behind = (dict(self.options).get(name) for name in (SIDE_SLITS, BACK_SLIT))
        slits = (*_OF_SLITS, ("slit_cm", float(cut))) if cut else _OF_NO_SLITS.get(self.name, ())
        slits = (("slit", "back"), ("slit_cm", float(behind))) if behind and not cut else slits
        flare = dict(self.options).get("flare", 0.0)
        straight = _OF_FLARE if float(flare) >= A_LINE_CM else _OF_NO_FLARE
        falls = straight if self.name == "shift-dress" else ()
        clings = bool(dict(self.options).get("stretch")) and bool(dict(self.options).get("waist_shaping"))
        falls = _OF_CLINGING if clings and self.name == "shift-dress" else falls
        if self.name == "apron":  # whose band behind counts as hem
            length = float(dict(self.options).get("length", 0.0))
            falls = tuple(
                [("skirt_hem", value) for value, own in APRON_HEMS.items() if abs(own - length) < 1.0]
            )
        bib = _OF_BIBS if self.name in ("dungarees", "pinafore", "apron") else ()
        bib = (*bib, *(_OF_CROSSED if dict(self.options).get(CROSSED) else ()))
        bib = tuple([("kind", kind) for kind in self.without_bib]) or bib
        angular = dict(self.options).get(NECKLINE) in ANGULAR
        strapped = (bib or self.name == "bodysuit") and STRAP_WIDTH in dict(self.options)
        wide = self.name == "strappy-dress" and float(dict(self.options).get(STRAP_WIDTH, 0.0)) >= WIDE_CM
        broad = (("straps", "wide"),) if angular or strapped or wide else ()
        broad = (*broad, *(_OF_WIDE_STRAPS if wide else ()))
        high = (("slit_size", "high"),) if float(dict(self.options).get(SIDE_SLITS, 0.0)) >= HIGH_CM else ()
        one = dict(self.options).get(ARMHOLE) == "cut-in-one"
        wings = _OF_WINGS if one else wide_to_the_eye(dict(self.options))
        options = dict(self.options)
        hem = (*(_OF_DIPS if options.get(HEM_DIP) else ()), *(_OF_ARCS if options.get(SCALLOPS) else ()))
        hem = (*hem, *(_OF_RACERS if options.get(RACER) else ()))
        hem = (*hem, *(_OF_BUBBLES if options.get(HEM_BAND) else ()))
        hem = (
            *hem,
            *(_OF_POINTS if options.get(HEM_POINTS) else ()),
            *(_OF_PLEATS if options.get(PLEATS) else ()),
        )
        blousing = self.name == "joggers" and float(options.get("leg_ease", 0.0)) >= BLOUSING_CM
        ends = _blousing_ends(float(options.get("length", 98.0))) if blousing else ()
        bowed = _OF_BOWS if options.get("bow") else _OF_BARRELS if options.get("barrel") else ()
        legs = (*(_OF_BLOUSING if blousing else ()), *ends, *bowed)
        long = self.name in _LONG_TOPS and float(options.get("length", 0.0)) >= LONG_TOP_CM
        legs = (*legs, *(_OF_BODY_BANDS if self.name in _BODY_BANDS else ()))
        legs = (*legs, *self._tiers_to_the_eye, *(_OF_LONG_TOPS if long else ()))
        tall = _OF_TALL if stands and float(dict(self.options).get("collar_height", 0.0)) > _TALL_CM else ()
        tall = _OF_LOOSE_COLLARS if LOOSE in self.options else tall
        shown = (_OF_STANDS if stands else (), tall, slits, falls, bib, broad, high, wings, hem, legs)
        are = _HALTER if options.get("halter") else DRAFTS_ARE.get(self.name, ())
        high_halter = options.get("halter") and float(options.get("neck_depth", _V_CM)) < _V_CM
        are = (*are, *(_OF_HIGH_HALTERS if high_halter else ()), *self._neck_to_the_eye)
        full = max(float(options.get("gathers", 1.0)), float(options.get("fullness", 1.0)))
        flares = flares_to_the_eye(self.name, options, full=full / FULL_GATHERS)
        are = (*are, *((("skirt", "flared"),) if flares else ()))
        round_ = max(float(options.get("skirt_fraction", 0.0)), float(options.get("fraction", 0.0)))
        is_full = round_ >= 1.0 and full < FULL_GATHERS and not options.get("flounce")
        are = (*are, *((("skirt", "gathered"),) if is_full and self.name in _ROUND_SKIRTS else ()))
        return (*are, *[claim for claims in shown for claim in claims])

    @property
    def _neck_to_the_eye(self) -> tuple[tuple[str, float], ...]:
        """How deep the neckline is seen to be on a body, cm."""
        depth = dict(self.options).get("neck_depth")
        if depth is None or self.name not in SEEN_DEEP:
            return ()
        return (("neck_depth_cm", round(float(depth) - LEVEL_NECK_CM, 2)),)

    @property
    def _tiers_to_the_eye(self) -> tuple[tuple[str, str | float], ...]:
        """Of tiers below a close part, which is no tier itself."""
        options = dict(self.options)
        if self.name == "gored-skirt" and options.get("close"):
            return (("skirt", "flared"), ("hips", "close"))
        close = options.get("close") if self.name == "tiered-skirt" else options.get("tiers")
        if not close or self.name not in ("tiered-skirt", "mermaid-dress"):
            wide = self.name == "tiered-skirt" and float(options.get("fullness", 0.0)) >= FULL_TIERS
            return (("skirt", "flared"),) if wide else ()
        return (*_OF_CLOSE_TIERS, ("tiers", float(options.get("tiers", 3.0))))

    @property
    def has_in_spirit(self) -> tuple[tuple[str, str], ...]:
        """Claims that it is near enough to where only a name implies them, and no word says them."""
        if self.name in ("off-shoulder-top", "off-shoulder-dress"):
            return _OF_BARE_ARMS
        roomy = dict(self.options).get("hip_ease", 0.0)
        room = _OF_ROOM if isinstance(roomy, float) and roomy >= ROOMY_CM else ()
        return (*room, *(_OF_CURVES if dict(self.options).get(HEM_RISE, 0.0) else ()))


APRON_HEMS: Mapping[str, float] = {
    "knee": 64.0,
    "below the knee": 70.0,
    "midi": 78.0,
    "maxi": 92.0,
    "ankle": 96.0,
}
"""Lengths of aprons that end there, cm below the waist."""
STANDING, MANDARIN = ("collar", "standing"), ("collar", "mandarin")
"""The options of a collar that stands, closed or open in front."""
HOODED = ("collar", "hood")
"""The option of a hood instead of one."""
ROLLED, LOOSE = ("collar", "rolled"), ("collar", "loose")
"""The options of one that is turned down over itself, and of a wide one that falls over itself."""
WIDE_CM, _OF_WIDE_STRAPS = 4.5, (("neckline", "square"), ("shoulders", "both"))
"""Straps that are seen to be wide, and what they make of the straight edge between them."""
STRAP_WIDTH = "strap_width"
"""The option of the straps of bibs."""
HEM_RISE, CURVED_HEM = "hem_rise", "curved_hem"
"""The option of hems that are curved like a shirt's, and what they are in the lexicon's ``cannot.txt``."""
HEM_BAND, PUFFBALL = "hem_band", "puffball"
"""The option of gathered hems that are drawn into a band, and what they are in ``cannot.txt``."""
PLEATS, PLEATED, _LEAST_PLEATS = "pleats", "pleats", 2
"""The option of pleated skirts of dresses, what it is in ``cannot.txt``, and how many pleats are some."""
_OF_BUBBLES, _OF_PLEATS = (("skirt", "gathered"),), (("skirt", "flared"), ("skirt", "a-line"))
HEM_DIP, SCALLOPS, HEM_POINTS = "hem_dip", "scallop_width", "hem_points"
"""The options of hems that are lower behind than in front, that are cut in arcs, and that hang in points."""
SIDE_SLITS = "side_slits"
"""The option of slits in garments that have no skirt of their own to be measured."""
BACK_SLIT = "back_slit"
"""The same of the seam in the middle of the back."""
ARMHOLE, DROPPED_BY = "armhole", "shoulder_extension"
"""The options of how sleeves are joined, and of how far the shoulder seam reaches over the shoulder tip."""
RAGLAN, CUT_IN_ONE, DROPPED = "raglan", "cut_in_one", "dropped_shoulder"
"""Keys of ``cannot.txt``: of sleeves that drafts with these options have."""
ARMHOLES = frozenset({RAGLAN, CUT_IN_ONE, DROPPED})
_ARMHOLES_SHOW: Mapping[str, tuple[str, ...]] = {"raglan": (RAGLAN,), "cut-in-one": (CUT_IN_ONE,)}
DROPPED_CM = 6.0
"""Armholes so far beyond the shoulder tip lie on the upper arm."""
_OF_WINGS = (("sleeve_shape", "wide"),)
LEG_SLITS, BACK_RISE, CROSSED, TRAILING = "slits", "back_rise", "crossed", "trailing_sleeves"
CROSSED_STRAPS = "crossed_straps"
_AS_NAMED = (BACK_RISE, "halter", "yoke")
_OPTIONS_SHOW = {SIDE_SLITS: LEG_SLITS, CROSSED: CROSSED_STRAPS, **{key: key for key in _AS_NAMED}}
"""What open ends of legs and the like, which have options of their own, are in ``cannot.txt``."""
_OF_CROSSED = (("neckline", "square"),)
"""Of bibs, whose straps say no more where they end."""
RACER, RACERBACK = "racer", "racerback"
"""The option of tank tops and shift dresses whose back is cut in, and what that is in ``cannot.txt``."""
_OF_RACERS = (("armholes", "angled"), ("armholes", "deep"))
NECKLINE, SWEETHEART = "neckline", "sweetheart"
"""The option of the shape of a neckline, and one of its values, which is a key of ``cannot.txt`` as well."""
ANGULAR = frozenset({"square", SWEETHEART})
"""Necklines that leave broad straps, and would be narrow if these were as broad as shoulders."""
ROOMY_CM = 7.0
"""With so much room on top of the hips drafts look loose there; with more, they stand off at the sides."""
A_LINE_CM = 12.0
"""Shift dresses with hems so much wider than straight ones are A-line."""
_OF_STANDS, _OF_TALL = (("neck_depth", "high"),), (("collar", "stand"),)
_OF_LOOSE_COLLARS = (("collar", "turtleneck"), ("collar", "stand"))
_TALL_CM = 6.0
"""Collars that stand higher are measured as turtlenecks."""
_OF_FLARE, _OF_NO_FLARE = (("skirt", "a-line"),), (("skirt", "straight"),)
_OF_DIPS = (
    ("hem_shape", "high-low"),
    *[("skirt_hem", end) for end in ("micro", "mini", "above the knee", "knee", "below the knee", "midi")],
)
"""A hem that is lower behind ends in two places."""
_OF_POINTS = (("hem_shape", "pointed"), *_OF_DIPS[1:])
_ROUND_SKIRTS = ("skater-dress", "strappy-dress", "strapless-dress", "circle-skirt", "shirt-dress")
"""Drafts whose skirts are cut from a circle: a whole one falls in folds from its waist, as gathers do."""
FULL_GATHERS = 1.8
"""Gathered skirts so many times as wide as their waist fall in folds, as flared ones do."""
LEVEL_NECK_CM = 5.0
"""So much of what a neckline is cut deep lies nearly level around a neck, which leans forward."""
SEEN_DEEP = frozenset(
    {"fitted-dress", "skater-dress", "shift-dress", "swing-dress", "drop-waist-dress", "mermaid-dress"}
    | {"empire-dress", "jumpsuit"}
)
"""Drafts whose neckline is as deep as told when it is worn; those of tops are so when they lie flat."""
BLOUSING_CM = 30.0
"""With so much room at the knee, legs that end in cuffs hang over them."""
_OF_BLOUSING = (("legs", "tapered"), ("legs", "wide"), ("hips", "loose"))
_AT_THE_ANKLE_CM, _AT_THE_CALF_CM = 92.0, 70.0
_OF_BOWS = (("legs", "slim"), ("legs", "tapered"), ("hips", "close"), ("hips", "loose"))
"""Jodhpurs are close below the knee and full above it."""
_BODY_BANDS, _OF_BODY_BANDS = ("jeans",), (("waistband", "shaped"),)
"""Waistbands as wide as the body above and below, by less than a claim needs: of slim legs, which no other
patterns have."""
_OF_BARRELS = (("legs", "tapered"), ("hips", "loose"))
"""Barrel legs are widest at the knee."""
_OF_ARCS = (("hem_shape", "scalloped"),)
_OF_CLINGING = (("skirt", "pencil"), ("skirt", "straight"), ("hips", "close"), ("bodice", "darted"))
"""Cloth that stretches over the body follows it without darts."""
_OF_SLITS = (("slit", "left"), ("slit", "right"))
_OF_NO_SLITS: Mapping[str, tuple[tuple[str, str], ...]] = dict.fromkeys(
    ("shift-dress", "swing-dress", "t-shirt", "tank-top", "turtleneck"), (("slit", "none"),)
)
"""What has no skirt to be measured, and no slits unless an option says so."""
_OF_BIBS = (("fit", "loose"), ("fit", "easy"), ("fit", "oversized"))
"""Nothing goes around the chest of what has a bib."""
HIGH_CM = 26.0
"""Slits of straight tops and dresses that are called high are as long as that."""
_OF_BARE_ARMS = (("sleeves", "none"),)
"""What bare shoulders go with mostly; sleeves below them hold up the edge of the bodice."""
_OF_CURVES = (("hem_shape", "high-low"), ("hem_shape", "pointed"))
"""What guesses make of words for a curved hem."""
_OF_CLOSE_TIERS = (
    *[("skirt", value) for value in ("tiered", "gathered tiers", "fitted base")],
    ("hips", "close"),
)
LONG_TOP_CM, _LONG_TOPS, _OF_LONG_TOPS = 40.0, ("turtleneck", "t-shirt", "cardigan"), (("top_hem", "long"),)
"""Tops that end so far below the waist are long ones, and may be longer: a kurta."""
FULL_TIERS = 1.6
"""Tiers so many times as wide as those above them make a skirt that flares."""
_OF_TIERED_DRESSES = ("frills",)
_OF_ROOM = (("hips", "loose"),)
"""Claims, by name and value, that such options make true to the eye."""


def _value(text: str) -> float | bool | str:
    if text in ("true", "false"):
        return text == "true"
    try:
        return float(text)
    except ValueError:
        return text


DRAFTS_SHOW: Mapping[str, tuple[str, ...]] = {
    "pleated-skirt": ("pleats",),
    **dict.fromkeys(("wrap-skirt", "wrap-dress", "wrap-jumpsuit", "sarong"), ("wrap",)),
    **dict.fromkeys(("strapless-dress", "bustier"), ("sweetheart",)),
    "polo-shirt": ("shirt_collar",),
    "shirt": ("shirt_collar", "open_front"),
    "waistcoat": ("open_front",),
    "shirt-dress": ("shirt_collar",),
    "denim-jacket": ("shirt_collar",),
    "cardigan": ("open_front",),
    "blazer": ("open_front",),
    "coat": ("open_front",),
    "hooded-coat": ("open_front",),
    "robe": ("open_front", "wrap"),
    "cape": ("cape", "open_front"),
    **dict.fromkeys(("bodysuit", "swimsuit"), ("swim",)),
    "dungarees": ("bib",),
    "pinafore": ("bib",),
    "apron": ("apron", "bib"),
    **dict.fromkeys(("halter-top", "halter-dress", "halter-jumpsuit"), ("halter",)),
    **dict.fromkeys(("off-shoulder-top", "off-shoulder-dress"), ("off_shoulder",)),
}
"""What a draft shows that no way to cut makes: keys of the lexicon's ``cannot.txt``. Where it
names a shirt dress, that has its collar."""
LOW_CROTCH, LOW_CROTCH_CM = "low_crotch", 7.0
"""Key of it, and how far below the body's a crotch is that hangs low, cm."""
STRETCHING = frozenset({"leggings", "bodysuit", "swimsuit", "briefs"})
"""Drafts that are for cloth that stretches unless their option says otherwise."""
_COLLAR_KEYS = ("shirt_collar", "flat_collar")
_COLLARS_SHOW: Mapping[str, tuple[str, ...]] = {
    "shirt": ("shirt_collar",),
    "folded": ("flat_collar", "shirt_collar"),
    "flat": ("flat_collar",),
    "sailor": ("flat_collar", "shirt_collar"),
    "revers": ("shirt_collar",),
    "standing": (),
    "rolled": (),
    "loose": (),
    "hood": (),
}
"""What a collar shows in place of the one that a draft has by itself."""
_V_CM, _OF_HIGH_HALTERS = 11.0, (("neck_depth", "high"), ("collar", "stand"), ("neckline", "crew"))
"""Halters whose necklines fall less are round and close to the neck, around which their strap goes on."""
_HALTER = (
    ("back_depth", "open"),
    ("back_depth", "low"),
    ("straps", "narrow"),
    ("shoulders", "strapless"),
)
DRAFTS_ARE: Mapping[str, tuple[tuple[str, str], ...]] = {
    "blazer": (("bodice", "darted"),),
    "waistcoat": (("bodice", "darted"),),
    "cardigan": (("waistband", "hem"),),
    "cape": (("fit", "oversized"), ("fit", "loose")),
    "pleated-skirt": (("skirt", "flared"), ("skirt", "a-line")),
    "halter-top": _HALTER,
    "halter-dress": _HALTER,
    "halter-jumpsuit": _HALTER,
}
"""Claims that are true of a draft to the eye, though not as they are measured between two shoulders."""
BARE_SHOULDERED = frozenset(
    {
        "bandeau",
        "bustier",
        "strapless-dress",
        "strapless-jumpsuit",
        "halter-top",
        "halter-dress",
        "halter-jumpsuit",
        "off-shoulder-top",
        "off-shoulder-dress",
    }
)
"""Drafts that leave the shoulders bare; where bare shoulders are asked for, garments begin from no others."""
COLLARED = frozenset({"shirt", "shirt-dress", "polo-shirt"})
"""Begun from only where nothing else is said of the neck: many call any top a shirt."""
_CROSSED = "Its bodice does not overlap in front: a seam runs where the edge of the upper front would lie."
_BUTTONED = "Its front is sewn together where buttons would close it, and open below."
STANDS_IN: Mapping[str, str] = {
    "wrap-dress": _CROSSED,
    "wrap-jumpsuit": _CROSSED,
    "wrap-top": _CROSSED,
    "pleated-skirt": "Each pleat is cut as strips; where they meet in a fold, cut them in one.",
    "shirt": "Its front is sewn together where buttons would close it.",
    "waistcoat": _BUTTONED,
    "polo-shirt": "The slit below its collar is closed, and has no buttons.",
}
"""What a draft has in place of what cannot be made, for people."""


def _blousing_ends(length: float) -> tuple[tuple[str, str], ...]:
    """Where legs end when worn that are longer by what goes in to their cuffs; `length` in cm."""
    if length >= _AT_THE_ANKLE_CM:
        return (("leg_hem", "ankle"), ("leg_hem", "full"))
    return (("leg_hem", "calf"),) if length >= _AT_THE_CALF_CM else ()
