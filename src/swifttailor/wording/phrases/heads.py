"""What garments are called."""

from __future__ import annotations

from swifttailor.wording.phrases.phrase import Wording, wording


def _head(
    needs: str, *texts: str, weight: float = 1.0, plural: bool = False, topics: str = "", avoids: str = ""
) -> Wording:
    return wording("head", needs, *texts, weight=weight, plural=plural, topics=topics, avoids=avoids)


HEADS: tuple[Wording, ...] = (
    wording("head", "", "garment", "piece", "design", topics="kind", weight=0.05),
    # Tops.
    _head("kind=top", "top", weight=3),
    _head("kind=top", "shirt", avoids="hood=hood shoulders=strapless top_hem=bra"),
    _head(
        "kind=top sleeves=none shoulders=both bodice=undarted",
        "tank top",
        "sleeveless top",
        avoids="hood=hood collar=stand collar=lapel",
    ),
    _head(
        "kind=top sleeves=none shoulders=both straps=narrow",
        "strappy top",
        "cami",
        "camisole",
        avoids="hood=hood collar=stand collar=lapel",
    ),
    _head(
        "kind=top sleeves=none shoulders=both bodice=darted",
        "sleeveless blouse",
        "sleeveless bodice",
        avoids="hood=hood collar=stand collar=lapel",
    ),
    _head(
        "kind=top shoulders=strapless bodice=darted fit=close", "bustier", "bustier top", "corset-style top"
    ),
    _head("kind=top shoulders=strapless", "strapless top", "bandeau top"),
    _head("kind=top shoulders=strapless top_hem=cropped", "bandeau", "tube top@us", "boob tube@uk"),
    _head("kind=top top_hem=cropped", "crop top", "cropped top", weight=2),
    _head("kind=top top_hem=bra", "bralette", "bra top", "very short crop top"),
    _head("kind=top hood=hood sleeves=long", "hoodie", "hooded top", weight=3),
    _head("kind=top hood=hood", "hooded top", weight=2),
    _head("kind=top hood=hood sleeves=none", "sleeveless hoodie", weight=2),
    _head("kind=top sleeves=long", "blouse", "long-sleeved top@uk", "long-sleeve top@us", avoids="hood=hood"),
    _head(
        "kind=top sleeves=long",
        "shirt",
        "long-sleeved shirt@uk",
        "long-sleeve shirt@us",
        "sweater@us",
        "jumper@uk",
        "pullover",
        "sweatshirt",
        weight=2,
        avoids="hood=hood",
    ),
    _head(
        "kind=top sleeves=long bodice=undarted",
        "long-sleeved T-shirt@uk",
        "long-sleeve tee@us",
        avoids="hood=hood collar=stand collar=lapel skirt=peplum waist_seam=natural",
    ),
    _head(
        "kind=top sleeves=short",
        "shirt",
        "short-sleeved shirt@uk",
        "short-sleeve shirt@us",
        avoids="hood=hood",
    ),
    _head("kind=top sleeves=three-quarter", "blouse", avoids="hood=hood"),
    _head("kind=top sleeves=elbow", "blouse", avoids="hood=hood"),
    _head(
        "kind=top sleeves=short cuffs=none sleeve_shape=set_smooth bodice=undarted",
        "T-shirt",
        "tee",
        "t-shirt",
        weight=3,
        avoids="hood=hood collar=stand collar=lapel skirt=peplum waist_seam=natural",
    ),
    _head("kind=top skirt=peplum", "peplum top", weight=4),
    _head(
        "kind=top sleeves=none fit=oversized", "oversized tank", avoids="hood=hood collar=stand collar=lapel"
    ),
    _head("kind=tunic", "tunic", "tunic top", weight=2, topics="length"),
    _head("kind=tunic sleeves=none", "sleeveless tunic", topics="length"),
    # Dresses.
    _head("kind=dress", "dress", weight=9),
    _head("kind=dress", "frock@uk", weight=0.3),
    _head("kind=dress collar=stand sleeves=long", "shirt dress", avoids="hood=hood"),
    _head("kind=dress sleeves=short bodice=undarted", "T-shirt dress", avoids="hood=hood collar=stand"),
    _head("kind=dress skirt_hem=maxi", "maxi dress", "gown", "maxi", weight=1.5),
    _head("kind=dress skirt_hem=floor", "floor-length gown", "evening gown", weight=1.5),
    _head("kind=dress skirt_hem=midi", "midi dress", weight=1.5),
    _head("kind=dress skirt_hem=mini", "mini dress", "minidress", weight=1.5),
    _head("kind=dress skirt_hem=micro", "micro dress", "micro mini dress"),
    _head("kind=dress bodice=darted fit=close skirt=pencil", "sheath dress", "pencil dress", "bodycon dress"),
    _head("kind=dress bodice=darted fit=close skirt=straight", "sheath dress"),
    _head("kind=dress bodice=darted fit=close skirt=flared", "fit-and-flare dress"),
    _head("kind=dress bodice=darted fit=close skirt=circle skirt_hem=mini", "skater dress"),
    _head("kind=dress bodice=darted fit=close skirt=circle skirt_hem=floor", "ball gown"),
    _head("kind=dress skirt=a-line", "A-line dress"),
    _head("kind=dress skirt=tiered", "tiered dress"),
    _head("kind=dress skirt=fitted_base skirt_hem=maxi", "mermaid dress", "mermaid gown", "trumpet dress"),
    _head("kind=dress waist_seam=empire", "empire-waist dress", "empire-line dress@uk"),
    _head("kind=dress waist_seam=empire skirt_hem=mini", "babydoll dress"),
    _head("kind=dress waist_seam=dropped", "drop-waist dress"),
    _head("kind=dress sleeves=none shoulders=both skirt=flared", "sundress"),
    _head("kind=dress sleeves=none shoulders=both skirt=gathered", "sundress"),
    _head("kind=dress straps=narrow", "strappy dress", "slip-strap dress"),
    _head("kind=dress hood=hood", "hooded dress", "hoodie dress", weight=2),
    _head("kind=dress shoulders=strapless", "strapless dress", "bandeau dress"),
    # Skirts.
    _head("kind=skirt", "skirt", weight=5),
    _head("kind=skirt skirt_hem=mini", "mini skirt", "miniskirt", weight=1.5),
    _head("kind=skirt skirt_hem=micro", "micro mini skirt"),
    _head("kind=skirt skirt_hem=midi", "midi skirt", weight=1.5),
    _head("kind=skirt skirt_hem=maxi", "maxi skirt", "long skirt", weight=1.5),
    _head("kind=skirt skirt=pencil", "pencil skirt", weight=3),
    _head("kind=skirt skirt=straight", "straight skirt", weight=2),
    _head("kind=skirt skirt=a-line", "A-line skirt", weight=3),
    _head("kind=skirt skirt=half_circle", "half-circle skirt", weight=2),
    _head("kind=skirt skirt=three-quarter_circle", "three-quarter circle skirt", weight=2),
    _head("kind=skirt skirt=circle", "circle skirt", "full circle skirt", weight=3),
    _head("kind=skirt skirt=circle skirt_hem=mini", "skater skirt", weight=2),
    _head("kind=skirt skirt=flared", "flared skirt", weight=2),
    _head("kind=skirt skirt=gathered", "gathered skirt", "dirndl skirt", weight=2),
    _head("kind=skirt skirt=tiered", "tiered skirt", weight=2),
    _head("kind=skirt skirt=gathered_tiers", "ruffle skirt", "tiered ruffle skirt"),
    _head("kind=skirt skirt=gored", "gored skirt", "panelled skirt@uk", "paneled skirt@us", weight=2),
    _head("kind=skirt skirt=godets", "godet skirt", weight=2),
    _head("kind=skirt skirt=fitted_base", "trumpet skirt", "mermaid skirt", "fishtail skirt@uk", weight=1.5),
    _head("kind=skirt gores=?", "{gores}-gore skirt", "{gores}-panel skirt"),
    _head("kind=skirt tiers=?", "{tiers}-tier skirt", "{tiers}-tiered skirt"),
    # Legs.
    _head("kind=trousers", "trousers@uk", "pants@us", "slacks@us", weight=5, plural=True),
    _head("kind=trousers legs=slim", "leggings", "skinny trousers@uk", "skinny pants@us", plural=True),
    _head("kind=trousers", "jeans", "chinos", weight=0.5, plural=True),
    _head("kind=trousers legs=wide leg_hem=full", "palazzo trousers@uk", "palazzo pants@us", plural=True),
    _head("kind=trousers legs=wide", "wide-leg trousers@uk", "wide-leg pants@us", weight=2, plural=True),
    _head("kind=trousers legs=wide leg_hem=calf", "culottes", weight=2, plural=True),
    _head("kind=trousers legs=straight", "straight-leg trousers@uk", "straight-leg pants@us", plural=True),
    _head("kind=trousers legs=tapered", "tapered trousers@uk", "tapered pants@us", weight=2, plural=True),
    _head("kind=trousers leg_hem=calf", "cropped trousers@uk", "capri pants@us", "capris@us", plural=True),
    _head(
        "kind=trousers legs=slim leg_hem=ankle", "cigarette trousers@uk", "cigarette pants@us", plural=True
    ),
    _head(
        "kind=trousers legs=flared", "flared trousers@uk", "flares", "bell-bottoms@us", weight=2, plural=True
    ),
    _head("kind=trousers leg_cuffs=gathered leg_cuffs=band", "joggers", "cuffed trousers@uk", plural=True),
    _head("kind=shorts", "shorts", weight=4, plural=True),
    _head("kind=shorts leg_hem=knee", "Bermuda shorts", "knee-length shorts", weight=2, plural=True),
    _head("kind=shorts leg_hem=very_short", "short shorts", "hot pants", weight=2, plural=True),
    _head("kind=jumpsuit", "jumpsuit", "one-piece jumpsuit", weight=5),
    _head("kind=jumpsuit shoulders=strapless", "strapless jumpsuit"),
    _head("kind=jumpsuit legs=wide", "wide-leg jumpsuit", weight=2),
    _head("kind=jumpsuit hood=hood", "hooded jumpsuit"),
    _head("kind=playsuit", "playsuit@uk", "romper@us", weight=4),
)
"""Each with the claims that the name alone makes."""
