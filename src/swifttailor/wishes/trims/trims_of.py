"""Which trims can stand for what cannot be made of panels."""

from __future__ import annotations

from collections.abc import Mapping

from swifttailor.pattern.trims.names import LIKE_EACH_OTHER, TRIMS
from swifttailor.wishes.trims.three_stripes import THREE

POCKETS = tuple(name for name in TRIMS if "pocket" in name)
BUTTONS = tuple(name for name in LIKE_EACH_OTHER[0] if "zip" not in name and name != "toggles")
ZIPS = ("zip", "half zip", "back zip", "side zip", "fly", "asymmetric zip")
BELTS = ("tie belt", "buckle belt", "sash")
TOP_PLEATS = ("pleated front", "fine pleats", "neck pleats", "shoulder pleats", "back pleat", "box pleats")
KNEE_RIPS = ("knee rips", "left knee rip", "right knee rip")
FRILLS = ("neck frill", "sleeve frills", "hem frill", "front frills", "yoke frill", "shoulder frills")
TRIMS_OF: Mapping[str, tuple[str, ...]] = {
    "pockets": POCKETS,
    "buttons": (*BUTTONS, "back buttons", "fly"),
    "toggles": ("toggles",),
    "zip": ZIPS,
    "belt": BELTS,
    "belt_accessory": BELTS,
    "drawstring": ("drawstring", "neck cord", "neck gathers"),
    "elastic": ("elastic waist", "back elastic"),
    "turn_ups": ("turn-ups",),
    "rolled_sleeves": ("sleeve turn-ups",),
    "french_cuffs": ("sleeve turn-ups",),
    "padding": ("quilting",),
    "ties": (
        "tie belt",
        "sash",
        "neck bow",
        "nape bow",
        "waist bow",
        "shoulder bows",
        "back bow",
        "back ties",
        "hip knot",
        "side tie",
    ),
    "braid": ("edging", "piping", "bands", "narrow bands"),
    "lace": ("lace trim", "neck lace"),
    "fur": ("neck fur", "fur trim", "sleeve fur"),
    "side_stripes": ("side stripes", "satin stripes", "sleeve stripes", *THREE),
    "side_panels": ("side panels",),
    "frills": FRILLS,
    "lacing": ("lacing",),
    "boning": ("boning",),
    "tucks": ("tucks",),
    "rib_bands": ("neck rib", "armhole ribs", "hem rib", "knit bands"),
    "fringe": ("hem fringe",),
    "apron": ("apron",),
    "creases": ("creases",),
    "stirrups": ("stirrups",),
    "pleats": ("front pleats", "pleat lines", *TOP_PLEATS),
    "open_back": ("back ties", "back buttons", "back lacing"),
    "back_lacing": ("back lacing",),
    "asymmetric_closing": ("diagonal closing", "asymmetric zip"),
    "tulip_sleeves": ("sleeve petals",),
    "gathers": ("neck gathers", "shoulder gathers"),
    "reflective": ("reflecting bands",),
    "storm_flap": ("storm flap",),
    "smocking": ("smocking",),
    "ruching": ("ruching",),
    "draped": ("cowl folds", "draped folds"),
    "draped_cloth": ("shoulder drape",),
    "knee_patches": ("knee patches",),
    "elbow_patches": ("elbow patches",),
    "cold_shoulder": ("shoulder cut-outs",),
    "cut_outs": ("waist cut-outs", "back cut-out", "keyhole"),
    "princess_seams": ("princess seams",),
    "yoke": ("yoke",),
    "paperbag": ("waist frill",),
    "scallops": ("scalloped edge",),
    "keyhole": ("keyhole",),
    "keyhole_back": ("back keyhole",),
    "epaulettes": ("epaulettes",),
    "arm_slits": ("arm slits",),
    "raw_hem": ("rips", *KNEE_RIPS, "frayed hem"),
    "lettering": ("chest heart", "chest star"),
    "train": ("train", "long train"),
    "overskirt": ("overskirt", "tulle overskirt"),
    "tulle_layers": ("tulle layers",),
    "second_layer": ("tulle layers",),
    "cups": ("cups",),
    "peplum": ("peplum",),
    "cape": ("back cape",),
    "topstitching": ("topstitching",),
    "denim_seams": ("denim seams",),
    "belt_loops": ("belt loops",),
    "buckles": ("strap buckles", "kilt edge"),
    "wrap": ("kilt edge",),
    "hem_border": ("hem border",),
    "illusion": ("illusion yoke",),
    "bustle": ("bustle",),
    "hoops": ("hoops",),
    "folded_band": ("folded band",),
    "thumb_holes": ("thumb holes",),
    "blouse_front": ("blouse front",),
    "bust_gathers": ("bust gathers",),
    "divided": ("outer skirt",),
}
"""By key of what cannot be made of panels, which trims can stand for it."""
