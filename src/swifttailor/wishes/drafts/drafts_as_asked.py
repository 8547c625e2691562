"""Named drafts with the collar, shoulders, slits, legs and tiers that a text asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import (
    APRON_HEMS,
    ARMHOLE,
    BARE_SHOULDERED,
    COLLARED,
    HOODED,
    LOOSE,
    ROLLED,
    SIDE_SLITS,
    STANDING,
    STRAP_WIDTH,
    NamedDraft,
)
from swifttailor.wishes.drafts.bared_drafts import bared_as_asked
from swifttailor.wishes.drafts.boat_necks import boat_as_asked
from swifttailor.wishes.drafts.close_drafts import close_as_asked
from swifttailor.wishes.drafts.cropped_drafts import cropped_as_asked
from swifttailor.wishes.drafts.held_drafts import held_as_asked, on_straps_that_hold
from swifttailor.wishes.drafts.hooded_drafts import hooded_as_asked
from swifttailor.wishes.drafts.knitted_drafts import without_bands_as_asked
from swifttailor.wishes.drafts.legged_drafts import legs_as_asked
from swifttailor.wishes.drafts.necks_as_asked import neck_as_asked
from swifttailor.wishes.drafts.skirted_coats import skirted_as_asked
from swifttailor.wishes.drafts.sleeved_drafts import sleeves_as_asked
from swifttailor.wishes.drafts.slit_skirts import slit_as_asked
from swifttailor.wishes.drafts.slits_as_told import (
    SLIT_SKIRT_CM,
    close_for_a_slit,
    is_slit,
    with_side_slits,
)
from swifttailor.wishes.drafts.swimsuits_as_asked import on_tank_straps, swimsuit_as_asked

_BARE = Claim("shoulders", "strapless")
_ROLLED_CM, _STANDS_CM = 8.0, 4.0
"""Height of collars when they are worn."""
_STAND, _ROLLED = Claim("collar", "stand"), Claim("collar", "turtleneck")
_OF_LAPELS = frozenset({Claim("collar", "lapel"), Claim("shoulders", "both")})
_OF_HOODS = frozenset({Claim("hood", "hood"), Claim("shoulders", "both")})
_OF_STANDS = frozenset({_STAND, _ROLLED, Claim("neck_depth", "high"), Claim("shoulders", "both")})
"""What may be asked for of the neck of a draft with such a collar."""
_AT_THE_NECK = frozenset(
    {"neckline", "neck_depth", "back_depth", "back_neckline", "shoulders", "straps", "collar", "hood"}
)
"""Names of claims that a collar goes with in one way alone."""
_THIN_STRAPS = Claim("straps", "narrow")
_ON_SHOULDERS = ("t-shirt", "tank-top", "fitted-top", "fitted-dress", "shift-dress", "skater-dress")
"""What thin straps do not hold: other drafts do."""
_LOOSE_DRESS_CM: Mapping[str, tuple[float, float]] = {
    "easy": (8.0, 10.0),
    "loose": (13.0, 18.0),
    "oversized": (20.0, 26.0),
}
"""Room on top of the bust girth of dresses that are to be so, all around, without sleeves and with them:
the wide armholes of what has more catch the arms."""
_WAISTED = frozenset({"skirt", "waist_seam", "hips", "bodice", "shoulders", "straps", "slit", "waistband"})
_STRAIGHT, _TENT = Claim("bodice", "undarted"), Claim("bodice", "flared")
_A_LINE, _A_LINE_CM = Claim("skirt", "a-line"), 30.0
_HANGING_SKIRTS = (
    *(_A_LINE, Claim("skirt", "straight"), Claim("slit", "none"), Claim("shoulders", "both")),
    Claim("waistband", "none"),
)
"""What a dress without a waist seam may have, and by how much its hem is wider where that is to flare."""
_STRAIGHT_CM, _TENT_CM = 10.0, 28.0
"""Room up to which a dress falls straight, and by how much the hem of a tent top is wider, all around."""
_SKATER_CM = 50.0
_SHORT = ("cap", "short", "elbow")
_GATHERED_SKIRT, _GATHERS = Claim("skirt", "gathered"), 2.0
"""What a shirt dress is asked for, and the width of its skirt over the waist then."""
_OF_TANKS = ("length", "chest_ease", "flare", "neck_depth", SIDE_SLITS)
_SLEEVELESS = {"strap_width": 8.0, "neck_widening": 1.0, "neck_depth": 11.0, "back_neck_depth": 3.0}
_SWEATSHIRT = "sweatshirt"
_FLAT = ("collar", "folded")
_OF_NECKLINES = frozenset({"neckline", "collar", "hood", "straps"})
_OF_SLEEVES = ("sleeve_length", "arm_ease", "sleeve_end")
_OF_TORSO = ("length", "chest_ease", "flare", "side_slits", "stretch", *_OF_SLEEVES)
"""Options of T-shirts that turtlenecks have as well."""
_PIECES: Mapping[str, tuple[str, int, int]] = {
    "tiered-skirt": ("tiers", 2, 6),
    "gored-skirt": ("gores", 4, 12),
}
"""Option and claim of a number of pieces, and how few and many can be drafted."""
_BIBBED, _WIDE_STRAP_CM = ("dungarees", "pinafore", "apron"), 6.0


_PULLED_ON = ("t-shirt", "tank-top", "shift-dress")
_OF_PULLED_ON = ("length", "chest_ease", "flare", "sleeve_length", "arm_ease", "sleeve_end")
_SHORTEST_HOODED_CM, _HOODED_EASE_CM = 25.0, 14.0
_HOODED, _COATS = "hooded-coat", ("coat", "robe")
_OF_COATS: Mapping[str, Mapping[str, float]] = {
    "coat": {"length": 56.0, "chest_ease": 20.0},
    "robe": {
        "length": 72.0,
        "chest_ease": 24.0,
        "flare": 12.0,
        "arm_ease": 18.0,
        "sleeve_end": 46.0,
    },
}
"""What hooded ones keep of coats and robes."""


def draft_as_asked(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft | None:
    """A named draft as it goes with what is asked for; None where it does not.

    Shirts get the collar that is asked for, dresses and jumpsuits shoulders, straps or none, what falls
    straight gets slits in its side seams, jumpsuits get legs, and skirts their number of tiers or gores.

    Args:
        draft: As a table names it.
        claims: What is asked for, all of it.
    """
    draft = _as_another(_darted(cropped_as_asked(skirted_as_asked(draft, claims), claims), claims), claims)
    draft = neck_as_asked(_with_hood(_worn_over(draft, claims), claims), claims)
    draft = with_side_slits(without_bands_as_asked(draft, claims), claims)
    if draft.name in _BIBBED and Claim("straps", "wide") in claims:
        draft = replace(draft, options=(*draft.options, (STRAP_WIDTH, _WIDE_STRAP_CM)))
    legged = legs_as_asked(draft, claims)
    if legged is None:
        return None
    draft = _with_pieces(legged, claims)
    if draft.name in ("t-shirt", "tank-top", _SWEATSHIRT) and _stands(claims):
        draft = _with_stand(draft, claims)
    if draft.name in ("turtleneck", _SWEATSHIRT) and Claim("sleeves", "none") in claims:
        draft = replace(draft, options=tuple({**dict(draft.options), "sleeves": False}.items()))
    draft = hooded_as_asked(draft, claims)
    draft = _without_sleeves(_standing(_with_collar(draft, claims), claims), claims)
    if draft.name == "circle-skirt" and is_slit(claims):
        draft = close_for_a_slit(draft, claims)
    if draft.name == "circle-skirt" and _GATHERED_SKIRT in claims:
        draft = NamedDraft("gathered-skirt", tuple([o for o in draft.options if o[0] == "length"]))
    if draft.name == "shirt-dress" and _GATHERED_SKIRT in claims:
        draft = replace(draft, options=tuple({**dict(draft.options), "gathers": _GATHERS}.items()))
    if draft.name == "skater-dress" and is_slit(claims) and "gathers" not in dict(draft.options):
        draft = close_for_a_slit(draft, claims)
    draft = held_as_asked(_hanging_loose(close_as_asked(draft, claims), claims), claims)
    draft = on_straps_that_hold(bared_as_asked(draft, claims))
    draft = _standing(sleeves_as_asked(draft, claims), claims)  # what was strapless has a neck now
    draft = slit_as_asked(boat_as_asked(neck_as_asked(draft, claims), claims), claims)
    if draft.name in _ON_SHOULDERS and _THIN_STRAPS in claims:
        return None
    if _BARE in claims and draft.name not in BARE_SHOULDERED:
        return None
    high = draft.name == "shirt" or bool(draft.options)  # any top is called a shirt
    high = high and _stands(claims) and _ROLLED not in claims and Claim("collar", "lapel") not in claims
    if draft.name in COLLARED and (_STAND in claims or high):
        draft = replace(draft, options=(*[o for o in draft.options if o[0] != "collar"], STANDING))
    stands = draft.stands
    if not stands and draft.name not in COLLARED:
        return draft
    own = _OF_STANDS if stands else _OF_HOODS if HOODED in draft.options else _OF_LAPELS
    others = [claim for claim in claims if claim.name in _AT_THE_NECK and claim not in own]
    return None if others else draft


def _darted(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A plain top that is to be close, with darts, is a fitted one, which ends at the waist."""
    long = any(
        claim.name in ("top_hem", "length_cm", "collar", "hood") and claim != _AT_WAIST for claim in claims
    )
    if draft.name == "tank-top" and not long and _DARTED in claims and "stretch" not in dict(draft.options):
        return NamedDraft("fitted-top", _EASY_DARTED)
    if draft.name != "t-shirt" or long or not _FITTED <= frozenset(claims):
        return draft
    return NamedDraft("fitted-top", ())


def _as_another(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Sweatshirts with a hood are hoodies, blazers without a collar are cut like cardigans.

    Bustiers with shoulders are fitted tops.
    """
    if draft.name == "bustier" and Claim("shoulders", "both") in claims:
        return NamedDraft("fitted-top")
    if draft.name == "swimsuit":
        draft = swimsuit_as_asked(draft, claims)
    draft = on_tank_straps(draft, claims)
    if draft.name == _SWEATSHIRT and Claim("hood", "hood") in claims:
        return NamedDraft("hoodie", tuple([o for o in draft.options if o[0] in _OF_BANDED]))
    if draft.name == "blazer" and _bares_its_collar(claims):
        short = float(dict(draft.options).get("length", 24.0)) < _SHORT_JACKET_CM
        return _COLLARLESS if not short else _COLLARLESS_SHORT
    if draft.name == "coat" and _bares_its_collar(claims):
        kept = [option for option in draft.options if option[0] not in _OF_LAPELLED]
        return replace(draft, options=(*kept, ("collar", "none")))
    return draft


def _bares_its_collar(claims: Sequence[Claim]) -> bool:
    """Whether a jacket is to have no collar, as one with a round neck unless some collar is told of."""
    collars = {claim.value for claim in claims if claim.name == "collar"}
    return collars == {"none"} or (not collars and not _ROUND.isdisjoint(claims))


_OF_LAPELLED = ("collar", "standing", "lapels", "lapel_width", "collar_width", "neck_depth")
_ROUND = frozenset({Claim("neckline", "round"), Claim("neckline", "crew")})
_SHORT_JACKET_CM = 8.0
_OF_BANDED = ("length", "chest_ease", "shoulder_extension", "sleeve_length", "arm_ease", "sleeve_end")
_COLLARLESS = NamedDraft.parse(
    "cardigan(length=19;chest_ease=10;neck_depth=13;opening=0;sleeve_end=27;closed_to=8)"
)
_COLLARLESS_SHORT = NamedDraft.parse(
    "cardigan(length=4;chest_ease=8;neck_depth=12;opening=0;sleeve_end=26;waist_shaping=2)"
)
_AT_WAIST = Claim("top_hem", "waist")
_DARTED = Claim("bodice", "darted")
_FITTED, _EASY_DARTED = frozenset({Claim("fit", "close"), _DARTED}), (("bust_ease", 8.0), ("waist_ease", 9.0))
_LONG_KNITTED = (("sleeve_length", 58.0), ("sleeve_end", 23.0))
_MAY_STAND = ("drop-waist-dress", "jumpsuit", "shift-dress", "swing-dress", "fitted-dress")
_OF_SHIRT_DRESSES = "skirt_length skirt_fraction gathers bust_ease waist_ease sleeve_shape sleeves".split()
_ROLL_CM, _FUNNEL_CM = 8.5, 7.0


def _standing(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Dresses and coats on whose necks a collar stands, where one is asked for."""
    options = dict(draft.options)
    if "collar" in options or not _stands(claims):
        return draft
    rolled = _ROLLED in claims
    if draft.name == "skater-dress" and (rolled or _STAND in claims):  # its bodice bears none
        kept = {name: options[name] for name in (*_OF_SHIRT_DRESSES, *_OF_SLEEVES) if name in options}
        draft, options = NamedDraft("shirt-dress"), {"sleeves": False, "cuffs": False, **kept}
    if draft.name in (*_MAY_STAND, "shirt-dress"):
        more = {ROLLED[0]: ROLLED[1], "collar_height": _ROLL_CM} if rolled else dict([STANDING])
    elif draft.name == "coat":
        more = {"standing": True, "collar_height": _FUNNEL_CM if rolled else _STANDS_CM}
    elif draft.name == "blazer" and "lapels" not in options:
        more = {STANDING[0]: STANDING[1], "collar_height": _FUNNEL_CM if rolled else _STANDS_CM}
    else:
        return draft
    return replace(draft, options=tuple({**options, **more}.items()))


def _with_collar(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Tops with a collar turned down are shirts, knitted ones without cuffs; that of dresses lies flat."""
    if Claim("collar", "lapel") not in claims:
        return draft
    options = dict(draft.options)
    if draft.name == "robe":  # which has no collar of its own
        return NamedDraft("coat", tuple({**_SHAWL_ROBE, "length": options.get("length", 70.0)}.items()))
    sleeves = [] if Claim("sleeves", "none") not in claims else [("sleeves", False)]
    kept = [(name, options[name]) for name in ("length", "chest_ease") if name in options]
    if draft.name in ("t-shirt", "tank-top"):
        short = any(claim.name == "sleeves" and claim.value in _SHORT for claim in claims)
        return NamedDraft("polo-shirt" if short else "shirt", (*kept, *sleeves))
    if draft.name == _SWEATSHIRT and not sleeves and options.get(ARMHOLE) is None:
        short = any(claim.name == "sleeves" and claim.value in _SHORT for claim in claims)
        return NamedDraft("polo-shirt", (*kept, *(() if short else _LONG_KNITTED)))
    if draft.name in _MAY_STAND and "collar" not in options:
        return replace(draft, options=(*draft.options, _FLAT))
    if draft.name == "skater-dress":
        kept = [(name, options[name]) for name in ("skirt_length", "skirt_fraction") if name in options]
        return NamedDraft("shirt-dress", (*kept, _FLAT, *sleeves))
    return draft


_SHAWL_ROBE: Mapping[str, float | str] = {
    **{"lapels": "shawl", "chest_ease": 18.0, "neck_depth": 28.0, "opening": -14.0, "closed_to": 4.0},
    **{"crossing": 7.0, "arm_ease": 13.0, "sleeve_end": 38.0},
}
"""Of a robe with a collar: it is cut as a coat that is held by its belt."""


def _with_hood(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Coats and robes with a hood are hooded coats; these without, or with a collar, are coats.

    Tops and dresses that hang from the shoulders are hooded coats that do not open.
    """
    options = dict(draft.options)
    if draft.name in _PULLED_ON and Claim("hood", "hood") in claims:
        hooded = {name: options[name] for name in _OF_PULLED_ON if name in options}
        hooded["length"] = max(float(hooded.get("length", 0.0)), _SHORTEST_HOODED_CM)
        hooded["chest_ease"] = max(float(hooded.get("chest_ease", 0.0)), _HOODED_EASE_CM)
        hooded["arm_ease"] = min(max(float(hooded.get("arm_ease", 0.0)), 10.0), 18.0)
        bare = draft.name == "tank-top" or Claim("sleeves", "none") in claims
        return NamedDraft(_HOODED, tuple({**hooded, "opening": 0.0, "sleeves": not bare}.items()))
    if draft.name in _COATS and Claim("hood", "hood") in claims:
        kept = {"length": options["length"]} if "length" in options else {}
        return NamedDraft(_HOODED, tuple({**_OF_COATS[draft.name], **kept}.items()))
    unhooded = Claim("hood", "none") in claims or any(
        c.name == "collar" and c.value != "none" for c in claims
    )
    return NamedDraft("coat", draft.options) if draft.name == _HOODED and unhooded else draft


def _worn_over(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """Aprons as long as is asked for, capes with a hood where one is."""
    if draft.name == "apron":
        hems = [APRON_HEMS[str(c.value)] for c in claims if c.name == "skirt_hem" and c.value in APRON_HEMS]
        own = dict(draft.options)
        return replace(draft, options=tuple({**own, "length": hems[0]}.items())) if hems else draft
    if draft.name == "cape":
        hood = Claim("hood", "hood") in claims
        worn = {**dict(draft.options), "hood": hood, **({} if hood else _collar_of_cape(claims))}
        return replace(draft, options=tuple(worn.items()))
    return draft


def _collar_of_cape(claims: Sequence[Claim]) -> dict[str, str | float]:
    if _ROLLED in claims:
        return {ROLLED[0]: ROLLED[1], "collar_height": _ROLL_CM}
    if Claim("collar", "lapel") in claims:
        return {"collar": "shirt", "collar_width": 7.0}
    return {STANDING[0]: STANDING[1], "collar_height": _STANDS_CM} if _STAND in claims else {}


_BARE_BACKS = frozenset({Claim("back_depth", "open"), Claim("back_depth", "low")})
"""A collar that stands goes all around; with these a high neck is a close round one."""


def _without_sleeves(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """T-shirts lose their sleeves; halter dresses with a slit have skirts in which it is seen."""
    options = dict(draft.options)
    if draft.name == "t-shirt" and Claim("sleeves", "none") in claims:
        kept = {name: options[name] for name in _OF_TANKS if name in options}
        return NamedDraft("tank-top", tuple({**_SLEEVELESS, **kept}.items()))
    if draft.name == "halter-dress" and is_slit(claims):
        return replace(
            draft, options=tuple({**options, "skirt_fraction": 0.3, "length": SLIT_SKIRT_CM}.items())
        )
    return draft


def _hanging_loose(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A dress that is to be loose, and of whose skirt and waist nothing is said, hangs from the shoulders."""
    options = dict(draft.options)
    if draft.name == "t-shirt" and _TENT in claims:
        return replace(draft, options=tuple({**options, "flare": _TENT_CM}.items()))
    straight = _STRAIGHT in claims or _TENT in claims
    fits = [str(claim.value) for claim in claims if claim.name == "fit" and claim.value in _LOOSE_DRESS_CM]
    hangs = _HANGING_SKIRTS if straight else ()
    waisted = any(claim.name in _WAISTED and claim not in (_STRAIGHT, _TENT, *hangs) for claim in claims)
    hung = draft.name == "skater-dress" or (draft.name == "fitted-dress" and _STRAIGHT in claims)
    if not hung or waisted or not (straight or {"loose", "oversized"}.intersection(fits)):
        return draft
    sleeves = any(claim.name == "sleeves" and claim.value != "none" for claim in claims)
    kept = {"length": float(options.get("skirt_length", _SKATER_CM)), "neck_widening": 1.0}
    if _TENT in claims:
        return NamedDraft("swing-dress", tuple({**kept, "sleeves": sleeves}.items()))
    ease = _LOOSE_DRESS_CM[fits[0] if fits else "easy"][sleeves]
    flare = 24.0 if ease > _STRAIGHT_CM else _A_LINE_CM if _A_LINE in claims else 8.0
    wide = {"chest_ease": ease, "flare": flare}
    return NamedDraft("shift-dress", tuple({**kept, **wide, "sleeves": sleeves}.items()))


def _with_pieces(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    """A tiered or gored skirt of as many pieces as are asked for, where so many can be drafted."""
    option, low, high = _PIECES.get(draft.name, ("", 0, 0))
    counts = [c.value for c in claims if c.name == option and not isinstance(c.value, str)]
    if not counts or not low <= counts[0] <= high:
        return draft
    return replace(draft, options=(*[o for o in draft.options if o[0] != option], (option, counts[0])))


def _stands(claims: Sequence[Claim]) -> bool:
    """Whether a collar is to stand; a high neck of which no more is said is such a one."""
    if _STAND in claims or _ROLLED in claims:
        return True
    high = Claim("neck_depth", "high") in claims and not any(c.name in _OF_NECKLINES for c in claims)
    return high and _BARE_BACKS.isdisjoint(claims)


def _with_stand(draft: NamedDraft, claims: Sequence[Claim]) -> NamedDraft:
    if draft.name == _SWEATSHIRT:
        if LOOSE in draft.options:
            return draft
        collar = ROLLED if _ROLLED in claims else STANDING
        high = {"collar_height": _ROLL_CM} if _ROLLED in claims else {}
        return replace(draft, options=tuple({**high, **dict(draft.options), collar[0]: collar[1]}.items()))
    bare = draft.name == "tank-top" or Claim("sleeves", "none") in claims
    kept = [option for option in draft.options if option[0] in _OF_TORSO]
    kept += [
        ("collar_height", _ROLLED_CM if _ROLLED in claims else _STANDS_CM),
        ("rolled", _ROLLED in claims),
        *([("sleeves", False)] if bare else []),
    ]
    return NamedDraft("turtleneck", tuple(kept))
