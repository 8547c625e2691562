from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.making import CuttingPlan, cutting_plan
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch


def rectangle(name: str, width: float, height: float, z: float, x: float = 0.0) -> Panel:
    """A panel before or behind the body, its right side facing outward."""
    corners = [[-width / 2, 0.0], [width / 2, 0.0], [width / 2, height], [-width / 2, height]]
    return Panel(name, corners if z > 0 else corners[::-1], (Edge(),) * 4, Placement((x, 60.0, z)))


@pytest.fixture(scope="session")
def skirt() -> Pattern:
    """Two rectangles of 50 x 45 cm, sewn along both sides: hem below, open edge above."""
    front, back = rectangle("skirt_front", 50.0, 45.0, 20.0), rectangle("skirt_back", 50.0, 45.0, -20.0)
    sides = (
        Stitch(EdgeRef("skirt_front", 1), EdgeRef("skirt_back", 1)),
        Stitch(EdgeRef("skirt_front", 3), EdgeRef("skirt_back", 3)),
    )
    return Pattern((front, back), sides, "two rectangles")


@pytest.fixture(scope="session")
def shipped_plans(shipped_patterns) -> dict[str, CuttingPlan]:
    """Of the 20 real patterns beside the tests."""
    return {name: cutting_plan(pattern) for name, pattern in shipped_patterns.items()}


@pytest.fixture(scope="session")
def draft_plans(drafts) -> dict[str, CuttingPlan]:
    return {name: cutting_plan(pattern) for name, pattern in drafts.items()}


@pytest.fixture(scope="session")
def plans(shipped_plans, draft_plans) -> dict[str, CuttingPlan]:
    return shipped_plans | draft_plans


TRIMMED = {
    "denim-jacket": ("denim-jacket", ("buttons", "chest pockets")),
    "trench coat": ("coat", ("tie belt", "double-breasted buttons", "side pockets")),
    "trousers": ("trousers", ("fly", "slant pockets", "back pockets", "buckle belt")),
    "shirt-dress": ("shirt-dress", ("button placket", "chest pocket", "side pockets", "tie belt")),
    "zipped hoodie": ("hoodie", ("zip", "kangaroo pocket")),
    "hoodie": ("hoodie", ("half zip", "kangaroo pocket", "sleeve stripes", "sleeve turn-ups")),
    "dungarees": ("dungarees", ("bib pocket", "cargo pockets", "side zip")),
    "joggers": ("joggers", ("drawstring", "side pockets")),
    "polo shirt": ("polo-shirt", ("polo placket", "back zip")),
    "suit": ("blazer", ("buttons", "welt pockets")),
    "coat with big buttons": ("coat", ("big buttons",)),
    "puffer": ("bomber-jacket", ("zip", "quilting")),
    "turned-up trousers": ("trousers", ("fly", "turn-ups")),
    "tunic": ("shirt-dress", ("patch pockets", "slant pockets")),
    "dirndl": ("skater-dress", ("neck frill", "lacing", "apron", "hem frill")),
    "blouse": ("shirt", ("neck bow", "sleeve frills", "edging")),
    "piped shirt": ("shirt", ("piping", "front frills")),
    "yoked blouse": ("t-shirt", ("yoke frill", "neck lace")),
    "cape": ("cape", ("arm slits",)),
    "working vest": ("waistcoat", ("reflecting bands",)),
    "track top": ("sweatshirt", ("three sleeve stripes",)),
    "track bottoms": ("trousers", ("three side stripes", "back welt pockets")),
    "biker jacket": ("denim-jacket", ("asymmetric zip",)),
    "raincoat": ("coat", ("storm flap", "neck fur", "sleeve fur")),
    "duffle coat": ("hooded-coat", ("toggles",)),
    "banded dress": ("shift-dress", ("bands", "side panels")),
    "sundress": ("strappy-dress", ("shoulder bows", "fur trim")),
    "vest": ("tank-top", ("neck rib", "armhole ribs", "hem rib")),
    "knitted jacket": ("cardigan", ("knit bands",)),
    "pyjama bottoms": ("pull-on-trousers", ("elastic waist",)),
    "slip": ("fitted-dress", ("lace trim", "waist bow")),
    "suit trousers": ("trousers", ("fly", "creases", "front pleats", "stirrups", "side stripes")),
    "dinner trousers": ("trousers", ("fly", "satin stripes")),
    "hakama": ("pull-on-trousers", ("pleat lines",)),
    "keyhole top": ("t-shirt", ("keyhole", "back keyhole")),
    "police shirt": ("shirt", ("epaulettes",)),
    "cheongsam": ("fitted-dress", ("diagonal closing",)),
    "sari": ("fitted-dress", ("shoulder drape",)),
    "hospital gown": ("shift-dress", ("back ties",)),
    "smock": ("t-shirt", ("back buttons", "back bow")),
    "corset dress": ("strapless-dress", ("back lacing", "boning")),
    "evening shirt": ("shirt", ("tucks",)),
    "ringer tee": ("t-shirt", ("narrow bands",)),
    "ripped jeans": ("jeans", ("fly", "rips", "frayed hem")),
    "jeans torn at the knees": ("jeans", ("knee rips",)),
    "dress buttoned to the waist": ("shirt-dress", ("waist placket",)),
    "cycling jersey": ("turtleneck", ("zip", "lower back pockets")),
    "tabard": ("tank-top", ("front pocket",)),
    "working trousers": ("trousers", ("knee patches", "thigh pocket", "back elastic")),
    "jeans torn at the left": ("jeans", ("left knee rip",)),
    "jeans torn at the right": ("jeans", ("right knee rip",)),
    "milkmaid dress": ("skater-dress", ("smocking",)),
    "ruched dress": ("fitted-dress", ("ruching",)),
    "cowl dress": ("slip-dress", ("cowl folds",)),
    "cold shoulder top": ("t-shirt", ("shoulder cut-outs",)),
    "cut-out dress": ("fitted-dress", ("waist cut-outs", "back cut-out")),
    "patched jumper": ("sweatshirt", ("elbow patches",)),
    "draped gown": ("fitted-dress", ("draped folds",)),
    "tucked blouse": ("shirt", ("yoke",)),
    "princess dress": ("skater-dress", ("princess seams",)),
    "paper bag trousers": ("pull-on-trousers", ("waist frill", "scalloped edge")),
    "bride's dress": ("strapless-dress", ("train", "overskirt", "cups")),
    "royal bride's dress": ("strapless-dress", ("long train", "tulle overskirt")),
    "princess gown": ("strapless-dress", ("tulle layers",)),
    "caped dress": ("fitted-dress", ("peplum", "back cape")),
    "flapper dress": ("drop-waist-dress", ("hem fringe", "neck cord")),
    "heart tee": ("t-shirt", ("chest heart",)),
    "star hoodie": ("hoodie", ("chest star",)),
    "pleated blouse": ("shirt", ("pleated front", "back pleat")),
    "Norfolk jacket": ("blazer", ("box pleats",)),
    "pressed blouse": ("shirt", ("fine pleats",)),
    "blouse pleated at the neck": ("t-shirt", ("neck pleats", "sleeve petals")),
    "blouse pleated at the shoulders": ("t-shirt", ("shoulder pleats",)),
    "blouse gathered at the neck": ("t-shirt", ("neck gathers",)),
    "blouse gathered at the shoulders": ("t-shirt", ("shoulder gathers",)),
    "stitched jeans": ("jeans", ("back pockets", "topstitching", "belt loops")),
    "seamed denim jacket": ("denim-jacket", ("denim seams",)),
    "buckled dungarees": ("dungarees", ("strap buckles",)),
    "kilt": ("fitted-skirt", ("kilt edge", "hem border", "hip knot")),
    "folded leggings": ("leggings", ("folded band",)),
    "running top": ("sweatshirt", ("thumb holes",)),
    "girl's dress": ("skater-dress", ("sash",)),
    "dirndl with a blouse": ("skater-dress", ("apron", "lacing", "blouse front")),
    "maternity top": ("t-shirt", ("bust gathers",)),
    "skort": ("leggings", ("outer skirt",)),
    "dress with frilled shoulders": ("skater-dress", ("shoulder frills",)),
    "illusion dress": ("fitted-dress", ("illusion yoke",)),
    "bustle skirt": ("circle-skirt", ("bustle",)),
    "crinoline": ("gathered-skirt", ("hoops",)),
    "wrap top": ("wrap-top", ("nape bow", "side tie")),
    "pleated pencil skirt": ("fitted-skirt", ("kick pleat",)),
    "dress of panels": ("skater-dress", ("princess panels",)),
    "Oxford shirt": ("shirt", ("collar buttons", "back yoke")),
}
"""Name of a draft and what is put on it: between them all trims that there are."""


@pytest.fixture(scope="session")
def trimmed(drafts) -> dict[str, Pattern]:
    """Drafts with trims."""
    return {name: replace(drafts[of], name=name, trims=trims) for name, (of, trims) in TRIMMED.items()}


@pytest.fixture(scope="session")
def trimmed_plans(trimmed) -> dict[str, CuttingPlan]:
    return {name: cutting_plan(pattern) for name, pattern in trimmed.items()}
