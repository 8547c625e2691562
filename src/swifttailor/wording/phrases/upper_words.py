"""Words for the upper part of a garment."""

from __future__ import annotations

from swifttailor.wording.phrases.phrase import Wording, adjective, feature, sentence, tag

ADJECTIVES: tuple[Wording, ...] = (
    # Fit.
    adjective("fit=close", "close-fitting", "slim-fitting", "snug"),
    adjective("fit=close bodice=darted", "fitted", "tailored", "body-skimming"),
    adjective("fit=close hips=close", "figure-hugging", "body-hugging", weight=0.7),
    adjective("fit=easy", "easy-fitting", "semi-fitted", "regular-fit", weight=0.6),
    adjective("fit=loose", "loose", "loose-fitting", "relaxed", "roomy"),
    adjective("fit=oversized", "oversized", "baggy", "slouchy", "voluminous"),
    adjective("fit=loose bodice=undarted", "boxy", weight=0.5),
    adjective("bodice=darted", "darted", weight=0.3),
    adjective("bodice=flared", "swingy", "flared", "trapeze-shaped"),
    adjective("sides=different", "asymmetric", "asymmetrical", weight=0.8),
    # Shoulders and neck.
    adjective("shoulders=strapless", "strapless", weight=3),
    adjective("shoulders=bare_left", "one-shoulder", "one-shouldered", weight=3),
    adjective("shoulders=bare_right", "one-shoulder", "one-shouldered", weight=3),
    adjective("straps=narrow", "narrow-strapped", "strappy", "thin-strapped", weight=0.8),
    adjective("straps=wide", "wide-shouldered", weight=0.3),
    adjective("hood=hood", "hooded", weight=3),
    adjective("collar=turtleneck", "turtleneck@us", "roll-neck@uk", "funnel-neck", weight=2),
    adjective("collar=stand", "high-collared", "stand-collar", weight=1.2),
    adjective("collar=lapel", "lapelled@uk", "lapeled@us", "lapel-collar", weight=1.2),
    adjective("collar=none", "collarless", weight=0.15),
    adjective("neckline=v", "V-neck", "v-neck", "V-necked@uk", weight=2),
    adjective("neckline=v neck_depth=plunging", "plunging V-neck", "deep V-neck", weight=2),
    adjective("neckline=v neck_depth=low", "low V-neck", "deep V-neck"),
    adjective("neckline=round", "round-neck", "round-necked@uk"),
    adjective("neckline=crew", "crew-neck", "crewneck@us", weight=2),
    adjective("neckline=scoop", "scoop-neck", "U-neck", weight=2),
    adjective("neckline=boat", "boat-neck", "bateau-neck", weight=2),
    adjective("neckline=square", "square-neck", "square-necked@uk", weight=2),
    adjective("neckline=asymmetric", "asymmetric-neck", weight=0.7, topics="sides"),
    adjective("neck_depth=plunging", "low-cut", weight=0.7),
    adjective("back_depth=open", "open-back", "backless", weight=1.5),
    adjective("back_depth=low", "low-backed@uk", "low-back", weight=0.8),
    # Sleeves.
    adjective("sleeves=none shoulders=both", "sleeveless", weight=4),
    adjective("sleeves=short", "short-sleeved@uk", "short-sleeve@us", "short-sleeved", weight=3),
    adjective("sleeves=cap", "cap-sleeved@uk", "cap-sleeve", weight=3),
    adjective("sleeves=elbow", "elbow-sleeved@uk", "elbow-sleeve", "half-sleeve", weight=2),
    adjective("sleeves=three-quarter", "three-quarter-sleeve", "3/4-sleeve", weight=2),
    adjective("sleeves=long", "long-sleeved@uk", "long-sleeve@us", "long-sleeved", weight=3),
    adjective("sleeve_shape=puffed", "puff-sleeved@uk", "puff-sleeve", weight=1.2),
    adjective("sleeve_shape=balloon", "balloon-sleeved@uk", "balloon-sleeve", weight=1.2),
    adjective("sleeve_shape=bell", "bell-sleeved@uk", "bell-sleeve", weight=1.5),
    adjective("sleeves=left_only", "one-sleeved", "single-sleeve", weight=2),
    adjective("sleeves=right_only", "one-sleeved", "single-sleeve", weight=2),
)

FEATURES: tuple[Wording, ...] = (
    # Neckline.
    feature("neckline=v", "a V neck", "a V-neckline", "a v-shaped neckline", "a V neckline", weight=3),
    feature(
        "neckline=v neck_depth=plunging",
        "a plunging V neckline",
        "a deep V neck",
        "a V neck cut below the bust",
    ),
    feature("neckline=v neck_depth=low", "a low V neck", "a deep V neckline"),
    feature(
        "neckline=v neck_depth_cm=?", "a V neck {neck_depth_cm} deep", "a {neck_depth_cm-} deep V neckline"
    ),
    feature("neckline=round", "a round neck", "a round neckline", "a rounded neckline", weight=3),
    feature("neckline=round neck_depth_cm=?", "a round neck {neck_depth_cm} deep"),
    feature("neckline=round neck_depth=plunging", "a very low round neckline", "a deep U-shaped neckline"),
    feature("neckline=crew", "a crew neck", "a high round neck", "a crew neckline", weight=2),
    feature("neckline=scoop", "a scoop neck", "a scooped neckline", "a low round neck", "a U-neck", weight=2),
    feature("neckline=boat", "a boat neck", "a bateau neckline", "a wide, shallow neckline", weight=2),
    feature("neckline=square", "a square neck", "a square neckline", "a squared-off neckline", weight=3),
    feature("neckline=square neck_depth=low", "a low square neckline", "a deep square neck"),
    feature("neckline=square neck_depth_cm=?", "a square neckline, {neck_depth_cm} deep"),
    feature("neckline=trapezoid", "a trapezoid neckline", "an angular neckline with slanted sides", weight=2),
    feature(
        "neckline=s-curve",
        "an S-curved neckline",
        "a curvy neckline that opens out to the shoulders",
        weight=2,
    ),
    feature(
        "neckline=pointed",
        "a pointed, curved neckline",
        "a V neck with rounded sides",
        "a leaf-shaped neckline",
        weight=2,
    ),
    feature(
        "neckline=asymmetric",
        "an asymmetric neckline",
        "a neckline that differs left and right",
        weight=2,
        topics="sides",
    ),
    feature("neck_depth=plunging", "a plunging neckline", "a very low neckline", weight=0.6),
    feature("neck_depth=low collar=none", "a low neckline", "a low-cut front", weight=0.5),
    feature("neck_depth=high collar=none", "a high neckline", weight=0.6),
    # Collars and hoods.
    feature(
        "collar=turtleneck",
        "a turtleneck@us",
        "a roll neck@uk",
        "a polo neck@uk",
        "a funnel neck",
        weight=2.5,
    ),
    feature("collar=stand", "a stand collar", "a stand-up collar", "an upright collar", weight=2.5),
    feature("collar=stand collar_cm=?", "a stand collar {collar_cm} high", "a {collar_cm-} stand-up collar"),
    feature("collar=lapel", "a lapel collar", "lapels", "a turned-down lapel collar", weight=2.5),
    feature("collar=lapel collar_cm=?", "a lapel collar {collar_cm} wide at the back"),
    feature("collar=lapel neck_depth=plunging", "lapels over a deep front opening", "long lapels"),
    feature("collar=none", "no collar", weight=0.1),
    feature("hood=hood", "a hood", "an attached hood", "a two-panel hood", weight=3),
    feature("hood=none", "no hood", weight=0.05),
    # Back.
    feature("back_depth=open", "an open back", "a bare back", "a back cut down low", weight=2),
    feature("back_depth=low", "a low back", "a scooped back", weight=1.2),
    feature("back_depth=low back_depth_cm=?", "a back neckline {back_depth_cm} deep", weight=0.8),
    feature("back_neckline=v", "a V-shaped back", "a V back", weight=2),
    feature("back_neckline=square", "a square-cut back", weight=2),
    feature("back_neckline=round back_depth=low", "a round, low back", "a deep U-shaped back"),
    feature("back_depth=high", "a high back", "a back that is closed up to the neck", weight=0.3),
    # Shoulders and armholes.
    feature("shoulders=strapless", "no straps", "bare shoulders", weight=1.5),
    feature(
        "shoulders=bare_left",
        "the left shoulder bare",
        "one bare shoulder, the left",
        "only a right shoulder",
        weight=2,
    ),
    feature(
        "shoulders=bare_right",
        "the right shoulder bare",
        "one bare shoulder, the right",
        "only a left shoulder",
        weight=2,
    ),
    feature("straps=narrow", "narrow straps", "thin straps", "narrow shoulders", weight=1.5),
    feature("straps=wide", "wide shoulders", "wide straps", "broad shoulder straps", weight=0.8),
    feature("armholes=square", "square armholes", "square-cut armholes", weight=1.3),
    feature("armholes=angled", "angular armholes", "straight-cut armholes", weight=1.3),
    feature("armholes=round", "rounded armholes", weight=0.2),
    feature("armholes=deep", "deep armholes", "low-cut armholes", weight=1.5),
    # Bodice.
    feature("bodice=darted fit=close", "a fitted bodice", "a darted, close-fitting bodice", weight=1.5),
    feature("bodice=darted", "bust and waist darts", "darts that shape the bodice", "a darted bodice"),
    feature("fit=loose bodice=undarted", "a loose, dartless body", "a straight, roomy body"),
    feature("fit=loose chest_cm=?", "plenty of room ({chest_cm} around the chest)", weight=0.5),
    feature("chest_cm=?", "a chest of {chest_cm}", weight=0.25, topics="fit"),
    feature("bodice=gathered", "a bodice gathered in at the bottom", "a blouson bodice", weight=1.5),
    feature("bodice=flared", "a body that flares to the hem", "a trapeze cut", weight=1.3),
    feature("bodice=tapered", "a body that narrows to the hem"),
    feature("sides=different", "an asymmetric cut", "different left and right sides", weight=0.5),
    feature("sides=alike", "a symmetrical cut", weight=0.06),
)

_HALVES = {
    "round": ("round", "a curve"),
    "v": ("V-shaped", "a straight slant"),
    "square": ("square", "a right angle"),
    "trapezoid": ("angular", "a slanted angle"),
    "s-curve": ("S-curved", "an S-curve"),
    "pointed": ("pointed", "a pointed curve"),
}


def _half_necklines() -> tuple[Wording, ...]:
    """One half of a neckline that is alone, or differs from the other."""
    found = []
    for side, other in (("left", "right"), ("right", "left")):
        for shape, (word, noun) in _HALVES.items():
            texts = (
                f"a neckline that is {word} on the {side}",
                f"a {word} neckline on the {side}",
                f"{noun} at the {side} of the neckline",
            )
            found.append(feature(f"{side}_neckline={shape}", *texts, weight=0.7, topics="sides"))
            for second, (word_2, _) in _HALVES.items():
                if side == "left" and second != shape:
                    both = f"a neckline that is {word} on the left and {word_2} on the right"
                    needs = f"{side}_neckline={shape} {other}_neckline={second}"
                    found.append(feature(needs, both, weight=1.5, topics="sides"))
    return tuple(found)


FEATURES += _half_necklines()

SENTENCES: tuple[Wording, ...] = (
    sentence("fit=close", "{it} fits closely at the bust.", "{it} is cut close to the body."),
    sentence(
        "fit=close bodice=darted",
        "Darts fit the bodice closely to the body.",
        "The bodice is fitted with darts.",
    ),
    sentence(
        "fit=loose",
        "{it} hangs loosely from the shoulders.",
        "{it} is loose around the chest.",
        "{it} leaves plenty of room.",
    ),
    sentence("fit=oversized", "{it} is oversized.", "The fit is very generous."),
    sentence("fit=easy", "The fit is easy, neither tight nor loose."),
    sentence(
        "bodice=gathered",
        "The bodice is gathered into its lower seam.",
        "The fullness of the bodice is gathered in below.",
    ),
    sentence(
        "sleeves=none shoulders=both", "{it} has no sleeves.", "There are no sleeves.", "The arms are bare."
    ),
    sentence("hood=hood", "{it} has a hood.", "A hood is sewn to the neckline."),
    sentence(
        "collar=stand", "A collar stands up around the neck.", "The neck is finished with a stand collar."
    ),
    sentence("collar=lapel", "{it} has lapels.", "The front opens into lapels."),
    sentence("neckline=v", "The neckline is a V.", "The front is cut to a V."),
    sentence("neckline=square", "The neckline is square.", "The neck opening is square."),
    sentence("neckline=round", "The neckline is round.", "The neck opening is round."),
    sentence("neckline=scoop", "The neckline is a scoop.", "The round neckline is scooped low."),
    sentence("neckline=boat", "The neckline is wide and shallow like a boat neck."),
    sentence("neckline=s-curve", "The neckline swings outward in an S-curve."),
    sentence("neckline=asymmetric", "The neckline is cut differently on either side."),
    sentence("neck_depth=plunging", "The front is cut low, below the bust."),
    sentence("back_depth=open", "The back is open.", "The back is cut very low."),
    sentence("back_depth=low", "The back is cut low."),
    sentence("shoulders=strapless", "The shoulders are bare.", "{it} is strapless."),
    sentence("shoulders=bare_left", "The left shoulder is bare."),
    sentence("shoulders=bare_right", "The right shoulder is bare."),
    sentence("straps=narrow", "The straps are narrow."),
    sentence("armholes=deep", "The armholes are cut deep."),
    sentence("armholes=square", "The armholes are square."),
)

TAGS: tuple[Wording, ...] = (
    tag("sleeves=none shoulders=both", "sleeveless", "no sleeves", weight=3),
    tag("shoulders=strapless", "strapless", "no straps", weight=3),
    tag("shoulders=bare_left", "one-shoulder", "left shoulder bare", weight=3),
    tag("shoulders=bare_right", "one-shoulder", "right shoulder bare", weight=3),
    tag("collar=none", "collarless", "no collar", weight=0.2),
    tag("hood=hood", "hood", "hooded", weight=3),
    tag("fit=close", "close fit", "slim fit", "fitted"),
    tag("fit=easy", "regular fit", weight=0.6),
    tag("fit=loose", "loose fit", "relaxed fit"),
    tag("fit=oversized", "oversized"),
    tag("bodice=darted", "darts", "darted bodice", weight=0.7),
    tag("back_depth=open", "open back", "backless"),
    tag("back_depth=low", "low back"),
    tag("sides=different", "asymmetric"),
)
"""Features can be tags as well; these are tags only."""
