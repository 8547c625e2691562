"""The list of drafts, and the one function that makes any of them."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, get_type_hints

from swifttailor.errors import PatternError
from swifttailor.pattern.drafts.garments import (
    banded,
    bare_shoulders,
    bibbed,
    capes,
    collared,
    drop_waisted,
    fitted_garments,
    gored_skirts,
    high_waisted,
    long_garments,
    one_pieces,
    pleated_skirts,
    pull_on,
    skirts,
    strappy,
    tiered_skirts,
    tops,
    trousers,
    wrap,
    wrap_jumpsuits,
    wrap_skirts,
)
from swifttailor.pattern.drafts.measurements import Measurements, checked
from swifttailor.pattern.drafts.options import OptionField, make_options, option_fields
from swifttailor.pattern.pattern import Pattern


@dataclass(frozen=True)
class DraftInfo:
    """One garment that can be drafted."""

    name: str
    """Such as ``t-shirt``."""
    summary: str
    """What it is, in one line."""
    function: Callable[[Any, Measurements], Pattern]
    """Makes the pattern from filled-in options and body measurements."""

    @property
    def options_class(self) -> type:
        """A frozen dataclass; every field declares unit, range and help."""
        return get_type_hints(self.function)["options"]

    @property
    def options(self) -> tuple[OptionField, ...]:
        """The options, in order."""
        return option_fields(self.options_class)


_DRAFTS = (
    DraftInfo("t-shirt", "Loose top with set-in sleeves", tops.draft_t_shirt),
    DraftInfo("polo-shirt", "Loose top with short sleeves, a shirt collar", collared.draft_polo_shirt),
    DraftInfo("shirt", "Loose top, long sleeves with cuffs, a shirt collar", collared.draft_shirt),
    DraftInfo("tank-top", "Sleeveless top with straps", tops.draft_tank_top),
    DraftInfo("camisole", "Top on thin straps", strappy.draft_camisole),
    DraftInfo("bandeau", "Strapless top to the waist, its upper edge straight", strappy.draft_bandeau),
    DraftInfo("bustier", "Strapless top to the waist, a heart for its upper edge", strappy.draft_bustier),
    DraftInfo(
        "halter-top", "Top held behind the neck, back and shoulders bare", bare_shoulders.draft_halter_top
    ),
    DraftInfo(
        "off-shoulder-top", "Neckline level around body and arms", bare_shoulders.draft_off_shoulder_top
    ),
    DraftInfo("turtleneck", "Long sleeves, a high collar turned down over itself", tops.draft_turtleneck),
    DraftInfo("wrap-top", "V neck whose right edge runs on to the left side", wrap.draft_wrap_top),
    DraftInfo(
        "peplum-top", "Darted bodice, a short flared piece from the waist", fitted_garments.draft_peplum_top
    ),
    DraftInfo("fitted-top", "Darted bodice that ends at the waist", fitted_garments.draft_fitted_top),
    DraftInfo("blazer", "Shaped sides, long sleeves, deep V neck with lapels", collared.draft_blazer),
    DraftInfo("cardigan", "Long sleeves, V neck, open in front below a button", tops.draft_cardigan),
    DraftInfo("poncho", "Wide cloth over body and arms", long_garments.draft_poncho),
    DraftInfo("waistcoat", "Sleeveless top, deep V neck, pointed front hem", tops.draft_waistcoat),
    DraftInfo("sweatshirt", "Wide top, long sleeves, cuffs and hem band", banded.draft_sweatshirt),
    DraftInfo("bomber-jacket", "Short, with a stand collar, cuffs and hem band", banded.draft_bomber_jacket),
    DraftInfo("denim-jacket", "Short, a shirt collar, cuffs and hem band", banded.draft_denim_jacket),
    DraftInfo("hoodie", "Wide top, long sleeves, hood, cuffs and hem band", banded.draft_hoodie),
    DraftInfo(
        "fitted-dress",
        "Sleeveless dress with darts, waist seam, pencil or A-line skirt",
        fitted_garments.draft_fitted_dress,
    ),
    DraftInfo(
        "mermaid-dress",
        "Sleeveless dress, close to the knee, a flounce below",
        fitted_garments.draft_mermaid_dress,
    ),
    DraftInfo(
        "shirt-dress",
        "Easy bodice, sleeves with cuffs, waist seam, flared skirt",
        fitted_garments.draft_shirt_dress,
    ),
    DraftInfo(
        "skater-dress",
        "Darted bodice, waist seam, skirt cut from a circle",
        fitted_garments.draft_skater_dress,
    ),
    DraftInfo(
        "wrap-dress",
        "Fronts that seem to cross, sleeves, waist seam, flared skirt",
        wrap.draft_wrap_dress,
    ),
    DraftInfo("slip-dress", "Dress on thin straps", strappy.draft_slip_dress),
    DraftInfo(
        "strapless-dress",
        "Darted bodice with a heart for its upper edge, flared skirt",
        strappy.draft_strapless_dress,
    ),
    DraftInfo(
        "strappy-dress",
        "Darted bodice on thin straps, a skirt sewn to its waist",
        strappy.draft_strappy_dress,
    ),
    DraftInfo(
        "halter-dress",
        "Dress held behind the neck, back and shoulders bare",
        bare_shoulders.draft_halter_dress,
    ),
    DraftInfo(
        "off-shoulder-dress",
        "Dress with a neckline level around body and arms",
        bare_shoulders.draft_off_shoulder_dress,
    ),
    DraftInfo("pinafore", "Skirt with a bib held by straps", bibbed.draft_pinafore),
    DraftInfo("apron", "Bib, straps and a band, cloth in front alone", bibbed.draft_apron),
    DraftInfo("empire-dress", "Dress gathered under the bust", high_waisted.draft_empire_dress),
    DraftInfo(
        "drop-waist-dress",
        "Straight to the hips, a skirt gathered into the seam there",
        drop_waisted.draft_drop_waist_dress,
    ),
    DraftInfo("coat", "Coat with notched lapels or a shawl collar", collared.draft_coat),
    DraftInfo("hooded-coat", "Wide coat with a hood, open in front", long_garments.draft_hooded_coat),
    DraftInfo("cape", "Wide cloth from the neck over body and arms, open in front", capes.draft_cape),
    DraftInfo("shift-dress", "Straight dress without a waist", long_garments.draft_shift_dress),
    DraftInfo("swing-dress", "Dress that widens from bust to hem", long_garments.draft_swing_dress),
    DraftInfo("kaftan", "Long and wide, with wide sleeves", long_garments.draft_kaftan),
    DraftInfo(
        "robe", "Wide sleeves, V neck to the waist, front open from the hem up", long_garments.draft_robe
    ),
    DraftInfo("jumpsuit", "Bodice and trousers joined at the waist", fitted_garments.draft_jumpsuit),
    DraftInfo("strapless-jumpsuit", "Bustier and trousers in one", strappy.draft_strapless_jumpsuit),
    DraftInfo(
        "strappy-jumpsuit", "Bodice on thin straps and trousers in one", strappy.draft_strappy_jumpsuit
    ),
    DraftInfo(
        "halter-jumpsuit",
        "Jumpsuit held behind the neck, back and shoulders bare",
        bare_shoulders.draft_halter_jumpsuit,
    ),
    DraftInfo(
        "wrap-jumpsuit",
        "Fronts that seem to cross, trousers sewn to their waist",
        wrap_jumpsuits.draft_wrap_jumpsuit,
    ),
    DraftInfo("bodysuit", "Darted bodice, sleeves or none, cut out over the legs", one_pieces.draft_bodysuit),
    DraftInfo("swimsuit", "Darted bodice on straps, cut out over the legs", one_pieces.draft_swimsuit),
    DraftInfo("dungarees", "Trousers with a bib held by straps", bibbed.draft_dungarees),
    DraftInfo("trousers", "Long or short legs, back darts, waistband", trousers.draft_trousers),
    DraftInfo("jeans", "Slim legs, back darts, waistband", trousers.draft_jeans),
    DraftInfo("leggings", "The closest legs, high waistband", trousers.draft_leggings),
    DraftInfo(
        "pull-on-trousers", "Long or short legs gathered into the waistband", pull_on.draft_pull_on_trousers
    ),
    DraftInfo("joggers", "Gathered into the waistband and into cuffs at the ankles", pull_on.draft_joggers),
    DraftInfo("briefs", "Close, without legs, on a waistband", one_pieces.draft_briefs),
    DraftInfo("flares", "Close to the knee, wide at the hem, waistband", trousers.draft_flares),
    DraftInfo("fitted-skirt", "Pencil or A-line skirt, waistband", skirts.draft_fitted_skirt),
    DraftInfo("mermaid-skirt", "Close to the knee, a flounce below, waistband", skirts.draft_mermaid_skirt),
    DraftInfo("wrap-skirt", "A-line skirt, open in front beside the middle", wrap_skirts.draft_wrap_skirt),
    DraftInfo("sarong", "Long straight skirt, open in front on a slant", wrap_skirts.draft_sarong),
    DraftInfo("circle-skirt", "Part of a circle on a waistband", skirts.draft_circle_skirt),
    DraftInfo("gathered-skirt", "Rectangles gathered into a waistband", skirts.draft_gathered_skirt),
    DraftInfo("tiered-skirt", "Tiers gathered into each other", tiered_skirts.draft_tiered_skirt),
    DraftInfo("gored-skirt", "Tapered panels, flared, waistband", gored_skirts.draft_gored_skirt),
    DraftInfo("pleated-skirt", "Pleats laid into a waistband", pleated_skirts.draft_pleated_skirt),
)


def list_drafts() -> tuple[DraftInfo, ...]:
    """All garments that can be drafted."""
    return _DRAFTS


def find_draft(name: str) -> DraftInfo:
    """The draft of that name; underscores count as hyphens.

    Raises:
        PatternError: There is none.
    """
    known = {d.name: d for d in _DRAFTS}
    wanted = name.replace("_", "-")
    if wanted not in known:
        near = difflib.get_close_matches(wanted, known, n=3, cutoff=0.4)
        meant = f" Did you mean {' or '.join(repr(n) for n in near)}?" if near else ""
        raise PatternError(f"There is no draft '{name}'.{meant} Known: {', '.join(known)}.")
    return known[wanted]


def draft(name: str, *, measurements: Measurements | None = None, **options: Any) -> Pattern:
    """Makes the sewing pattern of a garment.

    Args:
        name: Such as ``t-shirt``; see `list_drafts`.
        measurements: The body, in cm and degrees (`DraftMeasurements` or anything with those attributes);
            None for the default body.
        options: Options of that garment, such as ``sleeve_length=40``; the others keep their defaults.

    Raises:
        PatternError: The garment, an option or a measurement is unknown or out of range.
    """
    info = find_draft(name)
    return info.function(make_options(info.name, info.options_class, options), checked(measurements))
