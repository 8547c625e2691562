"""Words for a new shape of skirts, hems and legs."""

from __future__ import annotations

from swifttailor.wording.instructions.gain_wording import GainWording, gain

LOWER_GAINS: tuple[GainWording, ...] = (
    gain("skirt=pencil", 6.2, "make it a pencil skirt", "narrow the skirt to a pencil shape", topic="skirt"),
    gain("skirt=narrowing", 5.6, "narrow the skirt to the hem", "take the hem of the skirt in"),
    gain("skirt=straight", 5.4, "make the skirt straight", "let the skirt fall straight"),
    gain("skirt=a-line", 6.2, "make the skirt A-line", "give it an A-line skirt"),
    gain("skirt=circle", 6.2, "make it a circle skirt", "give it a full circle skirt"),
    gain("skirt=half_circle", 6.2, "make it a half-circle skirt", "give it a half-circle skirt"),
    gain("skirt=three-quarter_circle", 6.2, "make it a three-quarter circle skirt"),
    gain("skirt=more_than_a_circle", 6.2, "make the skirt very full", "give it more than a full circle"),
    gain("skirt=flared", 5.8, "flare the skirt", "give it a flared skirt"),
    gain("skirt=gathered", 6.3, "gather the skirt at the waist", "give it a gathered skirt"),
    gain("skirt=tiered", 7.2, "make the skirt tiered", "give the skirt tiers", "build the skirt in tiers"),
    gain("skirt=gored", 7.0, "cut the skirt in panels", "give it a gored skirt"),
    gain("skirt=godets", 7.2, "let godets into the hem", "add godets to the skirt"),
    gain("skirt=peplum", 7.5, "add a peplum", "give it a peplum at the waist"),
    gain(
        "skirt=gathered_tiers", 5.2, "gather the tiers", "ruffle the tiers", was="skirt=tiered", topic="tiers"
    ),
    gain("hem_shape=high-low", 6.2, "make the hem dip at the back", "give it a high-low hem"),
    gain("hem_shape=lower_left", 6.0, "slant the hem down to the left"),
    gain("hem_shape=lower_right", 6.0, "slant the hem down to the right"),
    gain("hem_shape=pointed", 6.0, "give it a handkerchief hem", "let the hem hang in points"),
    gain("hem_shape=scalloped", 6.0, "scallop the hem", "give it a scalloped hem"),
    gain("hem_shape=level", 5.5, "even out the hem", "make the hem level"),
    gain("waist_seam=empire", 5.5, "raise the waist to an empire line", "give it an empire waist"),
    gain("waist_seam=dropped", 5.5, "drop the waist", "give it a dropped waist"),
    gain(
        "waist_seam=natural",
        5.2,
        "put the waist seam at the natural waist",
        "move the waist seam to the waist",
    ),
    gain("rise=high", 5.0, "make it high-waisted", "let it sit at the natural waist"),
    gain("rise=mid", 4.6, "make it mid-rise", "let it sit below the waist"),
    gain("rise=low", 5.0, "make it low-rise", "let it sit on the hips"),
    *(
        wording
        for place in ("front", "back", "left", "right")
        for wording in (
            gain(
                f"slit={place}",
                6.0,
                f"add a slit at the {place}" if place in ("front", "back") else f"add a slit on the {place}",
                f"open a {place} slit",
                topic=f"{place} slit",
            ),
        )
    ),
    gain("slit=none", 6.0, "remove the slits", "sew the slits shut", "close the slits"),
    gain("slit_size=wedge", 5.5, "cut a wedge out of the hem", "notch the hem"),
    gain("legs=wide", 6.0, "make the legs wide", "give it wide legs"),
    gain("legs=straight", 5.6, "make the legs straight", "cut the legs straight"),
    gain("legs=tapered", 6.0, "taper the legs", "narrow the legs toward the hem"),
    gain("legs=flared", 6.0, "flare the legs", "give it flared legs"),
    gain("legs=slim", 6.0, "make the legs slim", "give it slim legs"),
)
"""Below the waist."""
