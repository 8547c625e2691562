"""Words for a new shape of sleeves, bodice and necklines."""

from __future__ import annotations

from swifttailor.wording.instructions.gain_wording import GainWording, gain

SHAPE_GAINS: tuple[GainWording, ...] = (
    gain(
        "sleeve_shape=puffed",
        5.8,
        "puff the sleeves at the shoulder",
        "gather the sleeve heads",
        was="sleeve_shape=set_smooth",
        topic="sleeve head",
    ),
    gain(
        "sleeve_shape=set_smooth",
        5.8,
        "set the sleeves in smoothly",
        "take the puff out of the sleeves",
        was="sleeve_shape=puffed",
        topic="sleeve head",
    ),
    gain(
        "sleeve_shape=bell",
        5.8,
        "make them bell sleeves",
        "flare the sleeves out to the end",
        topic="sleeve end",
    ),
    gain(
        "sleeve_shape=tapered", 5.8, "taper the sleeves", "narrow the sleeves to the end", topic="sleeve end"
    ),
    gain(
        "sleeve_shape=balloon",
        5.6,
        "make them balloon sleeves",
        "let the sleeves balloon out",
        was_not="sleeves=none",
    ),
    gain("sleeve_shape=wide", 5.4, "make the sleeves wide", "cut the sleeves full", was_not="sleeves=none"),
    gain("sleeve_shape=slim", 5.4, "make the sleeves slim", "cut the sleeves narrow", was_not="sleeves=none"),
    gain(
        "fit=close bodice=darted",
        6.5,
        "make the bodice fitted, with darts",
        "fit the bodice with darts",
        was="bodice=undarted",
    ),
    gain(
        "bodice=undarted",
        6.5,
        "make the bodice loose, without darts",
        "take out the darts",
        was="bodice=darted",
        topic="fit",
    ),
    gain("fit=close", 5.5, "make it close-fitting", "give it a close fit", "make it fitted"),
    gain("fit=loose", 5.5, "make it loose", "give it a relaxed fit", "make it roomier"),
    gain("fit=oversized", 5.6, "make it oversized", "give it an oversized fit"),
    gain("fit=easy", 5.0, "give it an easy fit", "make it easy-fitting"),
    gain(
        "bodice=gathered",
        3.5,
        "gather the bodice in at the bottom",
        "let the bodice blouse over its lower seam",
    ),
    gain("bodice=flared", 5.5, "flare it out to the hem", "give it a trapeze shape"),
    gain("bodice=tapered", 5.0, "taper it to the hem", "narrow it toward the hem"),
    gain("neck_depth=plunging", 5.8, "give it a plunging neckline", "cut the neckline below the bust"),
    gain("neck_depth=high", 5.6, "give it a high neckline", "close the neckline up to the neck"),
    gain("neck_depth=low", 5.2, "give it a low neckline", "cut the front low"),
    gain("back_depth=open", 5.6, "open the back", "make it backless", "cut the back very low"),
    gain("back_depth=low", 5.0, "give it a low back", "cut the back low"),
    gain("back_depth=high", 5.0, "close the back up to the neck", "give it a high back"),
    gain("back_neckline=v", 4.8, "cut the back to a V", "give it a V back"),
    gain("back_neckline=square", 4.8, "cut the back square", "give it a square back neckline"),
    gain("back_neckline=round", 4.6, "round off the back neckline", "give it a round back neckline"),
    gain(
        "armholes=square",
        4.0,
        "cut the armholes square",
        "give it square armholes",
        was_not="shoulders=strapless",
    ),
    gain(
        "armholes=angled",
        4.0,
        "cut the armholes straight, at an angle",
        "give it angular armholes",
        was_not="shoulders=strapless",
    ),
    gain(
        "armholes=round",
        4.0,
        "round off the armholes",
        "give it rounded armholes",
        was_not="shoulders=strapless",
    ),
    gain("armholes=deep", 4.0, "cut the armholes deep", "give it deep armholes"),
    gain("straps=narrow", 4.2, "use narrow straps", "make the straps thin", topic="neck width"),
    gain("straps=wide", 4.2, "use wide shoulders", "widen the straps", topic="neck width"),
    gain("sides=different", 3.0, "make it asymmetric", "cut the two sides differently"),
    gain("sides=alike", 3.0, "make it symmetrical", "make both sides alike"),
)
"""Above the waist."""
