"""Words for measures that grow or shrink."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class StepWording:
    """What can be asked for when a measure changes, in the imperative.

    The texts hold ``{garment}`` for what the garment is called and ``{by}`` for the amount.
    """

    topic: str
    importance: float
    up: tuple[str, ...]
    down: tuple[str, ...]
    up_by: tuple[str, ...] = ()
    """With the amount."""
    down_by: tuple[str, ...] = ()


def _longer(topic: str, importance: float, noun: str, be: str = "them") -> StepWording:
    """For lengths of parts named by a plural or singular noun."""
    return StepWording(
        topic,
        importance,
        (f"make the {noun} longer", f"lengthen the {noun}", f"let the {noun} reach further down"),
        (f"make the {noun} shorter", f"shorten the {noun}", f"cut the {noun} shorter"),
        (f"make the {noun} {{by}} longer", f"lengthen the {noun} by {{by}}", f"add {{by}} to the {noun}"),
        (f"make the {noun} {{by}} shorter", f"shorten the {noun} by {{by}}", f"take {{by}} off the {noun}"),
    )


def _wider(topic: str, importance: float, noun: str) -> StepWording:
    return StepWording(
        topic,
        importance,
        (f"make the {noun} wider", f"widen the {noun}", f"give the {noun} more width"),
        (f"make the {noun} narrower", f"narrow the {noun}", f"take the {noun} in"),
        (f"make the {noun} {{by}} wider around", f"widen the {noun} by {{by}}"),
        (f"make the {noun} {{by}} narrower around", f"take {{by}} out of the {noun}"),
    )


def _taller(topic: str, importance: float, noun: str) -> StepWording:
    return StepWording(
        topic,
        importance,
        (f"make the {noun} wider", f"make the {noun} deeper", f"use a broader {noun}"),
        (f"make the {noun} narrower", f"make the {noun} slimmer", f"use a narrower {noun}"),
        (f"make the {noun} {{by}} wider", f"add {{by}} to the height of the {noun}"),
        (f"make the {noun} {{by}} narrower", f"take {{by}} off the height of the {noun}"),
    )


def _fuller(topic: str, importance: float, noun: str, seam: str) -> StepWording:
    return StepWording(
        topic,
        importance,
        (
            f"gather the {noun} more at the {seam}",
            f"put more fullness into the {noun}",
            f"make the {noun} fuller",
        ),
        (
            f"gather the {noun} less at the {seam}",
            f"take fullness out of the {noun}",
            f"make the {noun} less full",
        ),
    )


def _slit(place: str) -> StepWording:
    return StepWording(
        f"{place} slit",
        5.0,
        (f"make the {place} slit longer", f"open the {place} slit further up", f"raise the {place} slit"),
        (f"make the {place} slit shorter", f"close the {place} slit a little", f"lower the {place} slit"),
        (f"make the {place} slit {{by}} longer", f"open the {place} slit {{by}} further up"),
        (f"make the {place} slit {{by}} shorter", f"sew {{by}} of the {place} slit shut"),
    )


def _count(topic: str, noun: str) -> StepWording:
    return StepWording(
        topic,
        6.0,
        (f"add {noun}", f"use more {noun}", f"increase the number of {noun}"),
        (f"use fewer {noun}", f"take away some {noun}", f"reduce the number of {noun}"),
    )


STEP_WORDS: dict[str, StepWording] = {
    "sleeve length": _longer("sleeves", 6.0, "sleeves"),
    "sleeve width": _wider("sleeve_shape", 5.0, "sleeves"),
    "sleeve end": _wider("sleeve end", 5.0, "sleeve openings"),
    "sleeve head": StepWording(
        "sleeve head",
        5.5,
        ("gather the sleeve heads more", "puff up the shoulders of the sleeves", "make the sleeves puffier"),
        ("gather the sleeve heads less", "make the sleeves less puffy", "smooth the tops of the sleeves"),
    ),
    "sleeve gathers": StepWording(
        "sleeve gathers",
        4.0,
        ("gather the sleeves more at the cuffs", "put more fullness above the cuffs"),
        ("gather the sleeves less at the cuffs", "take fullness out above the cuffs"),
    ),
    "cuff length": _longer("cuffs", 5.0, "cuffs"),
    "cuff opening": StepWording(
        "cuffs",
        2.0,
        ("widen the cuffs", "make the ends of the cuffs wider", "flare the cuffs more"),
        ("narrow the cuffs", "make the ends of the cuffs tighter", "take in the cuffs"),
    ),
    "length": _longer("length", 7.0, "{garment}"),
    "bodice length": StepWording(
        "waist",
        4.0,
        ("lower the waist seam", "lengthen the bodice", "make the bodice longer"),
        ("raise the waist seam", "shorten the bodice", "make the bodice shorter"),
        ("lower the waist seam by {by}", "lengthen the bodice by {by}"),
        ("raise the waist seam by {by}", "shorten the bodice by {by}"),
    ),
    "leg length": _longer("length", 7.0, "legs"),
    "leg end": _wider("legs", 5.5, "leg hems"),
    "thigh": _wider("thighs", 4.0, "legs at the thigh"),
    "leg cuff length": _longer("leg_cuffs", 4.5, "leg cuffs"),
    "waistband height": _taller("waistband", 5.0, "{band}"),
    "waistband width": StepWording(
        "band width",
        4.0,
        ("make the {band} looser", "let the {band} out", "loosen the {band}"),
        ("make the {band} tighter", "take the {band} in", "tighten the {band}"),
        ("let the {band} out by {by}", "make the {band} {by} longer around"),
        ("take the {band} in by {by}", "make the {band} {by} shorter around"),
    ),
    "collar height": StepWording(
        "collar",
        5.0,
        ("make the collar bigger", "use a wider collar", "make the collar taller"),
        ("make the collar smaller", "use a narrower collar", "make the collar lower"),
        ("make the collar {by} wider", "add {by} to the collar"),
        ("make the collar {by} narrower", "take {by} off the collar"),
    ),
    "hood depth": StepWording(
        "hood",
        4.0,
        ("make the hood deeper", "give the hood more depth", "make the hood roomier"),
        ("make the hood less deep", "take depth out of the hood", "make the hood shallower"),
        ("make the hood {by} deeper",),
        ("make the hood {by} shallower",),
    ),
    "hood height": StepWording(
        "hood",
        4.0,
        ("make the hood taller", "raise the crown of the hood"),
        ("make the hood lower", "lower the crown of the hood"),
        ("make the hood {by} taller",),
        ("make the hood {by} lower",),
    ),
    "neck depth": StepWording(
        "neckline",
        5.5,
        ("lower the neckline", "make the neckline deeper", "cut the front lower"),
        ("raise the neckline", "make the neckline shallower", "cut the front higher"),
        ("lower the neckline by {by}", "make the neckline {by} deeper", "drop the neckline by {by}"),
        ("raise the neckline by {by}", "make the neckline {by} shallower"),
    ),
    "neck width": StepWording(
        "neck width",
        4.5,
        ("widen the neckline", "make the neck opening wider", "open the neckline toward the shoulders"),
        ("narrow the neckline", "make the neck opening narrower", "bring the neckline closer to the neck"),
        ("widen the neckline by {by}",),
        ("narrow the neckline by {by}",),
    ),
    "back depth": StepWording(
        "back",
        4.5,
        ("lower the back", "cut the back lower", "make the back neckline deeper"),
        ("raise the back", "cut the back higher", "close the back further up"),
        ("lower the back neckline by {by}", "cut the back {by} lower"),
        ("raise the back neckline by {by}", "cut the back {by} higher"),
    ),
    "shoulders": StepWording(
        "shoulders",
        2.5,
        ("make the shoulders wider", "use wider straps"),
        ("make the shoulders narrower", "use narrower straps"),
        ("make the shoulders {by} wider",),
        ("make the shoulders {by} narrower",),
    ),
    "armholes": StepWording(
        "armholes",
        3.5,
        ("cut the armholes deeper", "lower the armholes", "make the armholes larger"),
        ("cut the armholes higher", "raise the armholes", "make the armholes smaller"),
        ("lower the armholes by {by}",),
        ("raise the armholes by {by}",),
    ),
    "chest": StepWording(
        "fit",
        5.0,
        ("make it looser", "let it out at the chest", "give it more room around the chest", "loosen the fit"),
        ("make it tighter", "take it in at the chest", "give it a closer fit", "make the fit snugger"),
        ("let it out by {by} around the chest", "add {by} around the chest"),
        ("take it in by {by} around the chest", "take {by} out around the chest"),
    ),
    "top width": StepWording(
        "bodice",
        5.0,
        ("flare the hem more", "make the hem wider", "let it swing out at the hem"),
        ("flare the hem less", "make the hem narrower", "take the hem in"),
        ("widen the hem by {by}",),
        ("take the hem in by {by}",),
    ),
    "skirt hem": StepWording(
        "skirt",
        5.0,
        ("flare the skirt more", "make the skirt wider at the hem", "give the skirt more sweep"),
        ("flare the skirt less", "make the skirt narrower at the hem", "take the hem of the skirt in"),
        ("widen the hem of the skirt by {by}",),
        ("take {by} out of the hem of the skirt",),
    ),
    "base width": StepWording(
        "skirt base",
        3.0,
        ("widen the upper part of the skirt", "make the skirt wider above the flare"),
        ("narrow the upper part of the skirt", "make the skirt narrower above the flare"),
    ),
    "skirt gathers": _fuller("skirt", 5.0, "skirt", "waist"),
    "bodice gathers": _fuller("bodice", 2.0, "bodice", "bottom"),
    "tier gathers": StepWording(
        "tiers",
        5.0,
        ("gather the tiers more", "make the tiers fuller", "ruffle the tiers more"),
        ("gather the tiers less", "make the tiers flatter", "ruffle the tiers less"),
    ),
    "tiers": _count("skirt", "tiers"),
    "gores": _count("skirt", "panels in the skirt"),
    "godets": _count("skirt", "godets"),
    "godet width": _wider("godets", 4.0, "godets"),
    "godet height": _longer("godets", 4.0, "godets"),
    "front slit": _slit("front"),
    "back slit": _slit("back"),
    "left slit": _slit("left"),
    "right slit": _slit("right"),
    "dip": StepWording(
        "hem_shape",
        4.5,
        ("make the hem dip more at the back", "let the back of the hem fall lower than the front"),
        ("make the hem dip less at the back", "even out the hem between front and back"),
    ),
}
"""By name of the quantity."""
