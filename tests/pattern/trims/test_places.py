"""Where trims are put on drafts and on known patterns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from draft_checks import bodies, options_of
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from trim_checks import assert_in_pairs, assert_on_panels, seen

from swifttailor.data.pattern_source import parsed_pattern
from swifttailor.pattern import Arc, Panel, Pattern
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft, list_drafts
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.pattern.trims import TRIMS, Belt, Button, Patch, place_trims, trims_that_fit

TOPS = ("t-shirt", "shirt", "polo-shirt", "turtleneck", "sweatshirt", "hoodie", "cardigan")
JACKETS = ("blazer", "coat", "hooded-coat", "waistcoat", "bomber-jacket", "denim-jacket")
DRESSES = ("fitted-dress", "shirt-dress", "skater-dress", "pinafore", "shift-dress", "swing-dress")
SKIRTS = ("fitted-skirt", "mermaid-skirt", "circle-skirt", "gathered-skirt", "tiered-skirt")
TROUSERS = ("trousers", "jeans", "flares", "pull-on-trousers", "joggers")
BELOW_HIPS = ("cardigan", "coat", "hooded-coat", "robe", "shift-dress")
SHOULD_HAVE = {
    "buttons": (*JACKETS, "cardigan", "shirt"),
    "big buttons": (*JACKETS, "cardigan", "shirt"),
    "button placket": ("shirt", "shirt-dress", "fitted-dress", "circle-skirt", "camisole"),
    "polo placket": ("polo-shirt", "t-shirt"),
    "waist placket": ("shirt-dress", "fitted-dress", "shift-dress", "shirt"),
    "double-breasted buttons": (*JACKETS, *TROUSERS),
    "zip": (*TOPS, *JACKETS, "jumpsuit", "strapless-dress", "camisole", "bustier", "circle-skirt"),
    "half zip": (*TOPS, "hoodie"),
    "back zip": (*DRESSES, *SKIRTS, "strapless-dress", "jumpsuit"),
    "side zip": (*SKIRTS, *TROUSERS, "strapless-dress", "pinafore"),
    "fly": TROUSERS,
    "chest pocket": ("shirt", "t-shirt", "polo-shirt", "fitted-dress", "jumpsuit", "blazer"),
    "chest pockets": ("denim-jacket", "shirt", "jumpsuit"),
    "patch pockets": (*SKIRTS, *BELOW_HIPS, "blazer", "apron", "pinafore"),
    "welt pockets": ("blazer", "coat", "waistcoat"),
    "kangaroo pocket": ("hoodie", "sweatshirt", "t-shirt"),
    "front pocket": ("tank-top", "t-shirt", "gathered-skirt", "skater-dress", "pinafore"),
    "lower back pockets": ("turtleneck", "t-shirt", "bomber-jacket"),
    "bib pocket": ("dungarees", "apron", "pinafore"),
    "side pockets": (*SKIRTS, *TROUSERS, "coat", "shift-dress"),
    "slant pockets": (*TROUSERS, *SKIRTS, "dungarees", "jumpsuit", "shirt-dress"),
    "back pockets": (*TROUSERS, "dungarees", "jumpsuit"),
    "back welt pockets": (*TROUSERS, "dungarees", "jumpsuit"),
    "cargo pockets": (*TROUSERS, "dungarees", "fitted-skirt"),
    "thigh pocket": ("leggings", *TROUSERS),
    "tie belt": ("robe", "coat", "wrap-dress", *DRESSES, *TROUSERS, *SKIRTS),
    "buckle belt": (*TROUSERS, *SKIRTS, "shirt-dress"),
    "quilting": ("bomber-jacket", "coat", "turtleneck"),
    "turn-ups": ("trousers", "jeans"),
    "drawstring": ("joggers", "pull-on-trousers"),
    "elastic waist": ("joggers", "pull-on-trousers", "gathered-skirt", "leggings"),
    "back elastic": (*TROUSERS, "fitted-skirt"),
    "neck cord": ("hoodie", "sweatshirt"),
    "neck rib": ("t-shirt", "sweatshirt", "tank-top"),
    "armhole ribs": ("tank-top",),
    "hem rib": ("tank-top", "t-shirt"),
    "knit bands": ("cardigan", "sweatshirt"),
    "neck frill": (*[name for name in TOPS if name != "hoodie"], "shirt-dress"),
    "sleeve frills": ("t-shirt", "shirt", "shirt-dress"),
    "sleeve turn-ups": ("t-shirt", "shirt", "shirt-dress", "blazer"),
    "hem frill": (*SKIRTS, *DRESSES, "t-shirt"),
    "front frills": ("shirt", "polo-shirt", "t-shirt", "shirt-dress"),
    "yoke frill": ("shirt", "t-shirt", "shirt-dress"),
    "hem fringe": (*SKIRTS, *DRESSES, "denim-jacket"),
    "edging": (*SKIRTS, *DRESSES, *TOPS),
    "piping": (*SKIRTS, *DRESSES, *TOPS, *TROUSERS),
    "bands": (*DRESSES, "robe", "t-shirt", "shirt"),
    "narrow bands": (*DRESSES, "t-shirt", "tank-top"),
    "lace trim": (*SKIRTS, *DRESSES, "camisole"),
    "neck lace": (*DRESSES, "t-shirt", "shirt", "camisole", "slip-dress"),
    "fur trim": (*SKIRTS, *DRESSES, "hoodie", "coat"),
    "neck fur": ("hoodie", "coat", "shirt"),
    "sleeve fur": ("coat", "t-shirt"),
    "side stripes": (*TROUSERS, *SKIRTS[:2], "leggings", "jumpsuit", "shift-dress", "t-shirt"),
    "satin stripes": (*TROUSERS, "leggings", "jumpsuit"),
    "sleeve stripes": ("t-shirt", "bomber-jacket", "sweatshirt", "hoodie"),
    "three side stripes": (*TROUSERS, "leggings", "jumpsuit", "t-shirt"),
    "three sleeve stripes": ("t-shirt", "bomber-jacket", "sweatshirt", "hoodie", "denim-jacket"),
    "side panels": ("t-shirt", "turtleneck", "leggings", "jumpsuit", "shift-dress"),
    "neck bow": (*TOPS, "shirt-dress"),
    "nape bow": ("t-shirt", "shirt", "tank-top", "shift-dress"),
    "waist bow": ("skater-dress", "fitted-dress", "fitted-skirt"),
    "shoulder bows": ("strappy-dress", "camisole", "tank-top", "slip-dress", "fitted-dress"),
    "lacing": ("t-shirt", "shirt", "skater-dress", "bustier"),
    "boning": ("bustier", "strapless-dress", "fitted-dress", "skater-dress"),
    "tucks": ("shirt", "shirt-dress", "t-shirt"),
    "apron": ("skater-dress", "gathered-skirt", "circle-skirt"),
    "creases": TROUSERS[:4],
    "pleat lines": ("trousers", "pull-on-trousers"),
    "front pleats": TROUSERS[:4],
    "stirrups": ("leggings", "trousers"),
    "keyhole": ("t-shirt", "fitted-dress", "shift-dress", "skater-dress"),
    "back keyhole": ("t-shirt", "fitted-dress", "shift-dress"),
    "epaulettes": ("shirt", "polo-shirt", "coat", "t-shirt"),
    "arm slits": ("cape",),
    "diagonal closing": ("fitted-dress", "turtleneck", "shirt"),
    "rips": (*TROUSERS, "jumpsuit", "fitted-skirt", "t-shirt", "denim-jacket"),
    "knee rips": TROUSERS,
    "left knee rip": TROUSERS,
    "right knee rip": TROUSERS,
    "frayed hem": (*TROUSERS, *SKIRTS, "denim-jacket"),
    "knee patches": TROUSERS,
    "back ties": ("shift-dress", "fitted-dress", "t-shirt", "shirt"),
    "back buttons": ("shirt", "fitted-dress", "t-shirt", "blazer"),
    "back lacing": ("bustier", "strapless-dress", "fitted-dress"),
    "back bow": ("fitted-dress", "skater-dress", "bustier", "pinafore"),
    "reflecting bands": (
        "t-shirt",
        "waistcoat",
        "bomber-jacket",
        "cardigan",
        "trousers",
        "joggers",
        "dungarees",
    ),
    "asymmetric zip": ("turtleneck", "blazer", "coat", "denim-jacket", "t-shirt"),
    "storm flap": ("coat", "blazer", "hooded-coat", "turtleneck"),
    "smocking": ("peplum-top", "skater-dress", "strappy-dress", "fitted-dress", "bandeau", "t-shirt"),
    "ruching": ("fitted-dress", "fitted-skirt", "t-shirt", "camisole"),
    "cowl folds": ("slip-dress", "camisole", "t-shirt", "fitted-dress"),
    "shoulder drape": ("fitted-dress", "shift-dress", "t-shirt"),
    "shoulder cut-outs": ("t-shirt", "shirt", "shirt-dress", "sweatshirt", "turtleneck"),
    "waist cut-outs": ("fitted-dress", "skater-dress", "shift-dress", "jumpsuit", "bodysuit", "t-shirt"),
    "back cut-out": ("fitted-dress", "skater-dress", "shift-dress", "shirt", "t-shirt", "jumpsuit"),
    "elbow patches": ("blazer", "sweatshirt", "cardigan", "shirt", "coat"),
    "draped folds": ("fitted-dress", "fitted-skirt", "t-shirt"),
    "princess seams": ("fitted-dress", "skater-dress", "strapless-dress", "blazer"),
    "princess panels": ("skater-dress", "fitted-dress"),
    "yoke": ("shirt", "t-shirt", "fitted-skirt", "circle-skirt", "jeans"),
    "waist frill": ("pull-on-trousers", "trousers", "gathered-skirt", "circle-skirt"),
    "scalloped edge": ("t-shirt", "trousers", "circle-skirt", "peplum-top"),
    "toggles": ("hooded-coat", "coat", "turtleneck", "cardigan"),
    "chest heart": ("t-shirt", "sweatshirt", "hoodie", "tank-top", "t-shirt", "shift-dress"),
    "chest star": ("t-shirt", "sweatshirt", "hoodie", "tank-top", "turtleneck"),
    "pleated front": ("shirt", "t-shirt", "turtleneck", "fitted-dress", "tank-top"),
    "fine pleats": ("shirt", "t-shirt", "turtleneck", "tank-top", "shift-dress"),
    "neck pleats": ("shirt", "t-shirt", "turtleneck", "fitted-dress", "tank-top"),
    "shoulder pleats": ("shirt", "t-shirt", "turtleneck"),
    "back pleat": ("shirt", "t-shirt", "blazer"),
    "box pleats": ("blazer", "shirt", "coat"),
    "sleeve petals": ("t-shirt", "coat", "turtleneck"),
    "neck gathers": ("shirt", "t-shirt", "turtleneck", "fitted-dress", "tank-top"),
    "shoulder gathers": ("shirt", "t-shirt", "turtleneck", "shift-dress"),
    "train": ("strapless-dress", "mermaid-dress", "tiered-skirt"),
    "long train": ("strapless-dress", "mermaid-dress"),
    "overskirt": ("strapless-dress", "skater-dress", "fitted-dress", "circle-skirt"),
    "tulle overskirt": ("strapless-dress", "skater-dress", "fitted-dress", "circle-skirt"),
    "tulle layers": ("strapless-dress", "skater-dress", "circle-skirt"),
    "cups": ("bustier", "strapless-dress", "fitted-dress", "skater-dress"),
    "peplum": ("fitted-dress", "fitted-skirt", "strapless-dress"),
    "back cape": ("fitted-dress", "skater-dress", "shift-dress"),
    "topstitching": (*TROUSERS, "dungarees", "denim-jacket", "circle-skirt", "shirt-dress"),
    "belt loops": (*TROUSERS, "circle-skirt", "fitted-skirt"),
    "denim seams": ("denim-jacket", "bomber-jacket"),
    "strap buckles": ("dungarees", "pinafore"),
    "kilt edge": ("fitted-skirt",),
    "hem border": ("circle-skirt", "gathered-skirt", "gored-skirt", "skater-dress", "fitted-skirt"),
    "folded band": ("leggings", "fitted-skirt", "trousers"),
    "thumb holes": ("sweatshirt", "turtleneck", "hoodie"),
    "sash": ("skater-dress", "fitted-dress", "strapless-dress", "empire-dress"),
    "blouse front": ("skater-dress", "fitted-dress", "t-shirt"),
    "bust gathers": ("t-shirt", "shift-dress"),
    "hip knot": ("sarong", "wrap-skirt", "circle-skirt"),
    "outer skirt": ("leggings", "trousers", "swimsuit", "bodysuit", "briefs"),
    "shoulder frills": ("skater-dress", "strappy-dress", "empire-dress", "shirt"),
    "illusion yoke": ("skater-dress", "fitted-dress", "t-shirt", "shift-dress", "empire-dress"),
    "bustle": ("circle-skirt", "skater-dress", "fitted-dress"),
    "hoops": ("gathered-skirt", "circle-skirt", "strapless-dress"),
    "side tie": ("wrap-top", "wrap-dress", "wrap-jumpsuit", "t-shirt", "cardigan"),
    "kick pleat": ("fitted-skirt", "fitted-dress"),
    "collar buttons": ("shirt", "polo-shirt"),
    "back yoke": ("shirt", "t-shirt", "shirt-dress"),
}
CHILDREN = (60.0, 92.0, 110.0, 128.0, 152.0)
SOME = tuple(info for info in list_drafts() if info.name not in ("gored-skirt", "pleated-skirt"))


def with_all(pattern: Pattern) -> Pattern:
    return replace(pattern, trims=tuple(TRIMS))


def test_the_table_has_every_trim():
    assert list(SHOULD_HAVE) == list(TRIMS)


@pytest.mark.parametrize("name", TRIMS)
def test_has_its_place_on_the_drafts_that_should_have_it(name, drafts):
    missing = [d for d in SHOULD_HAVE[name] if trims_that_fit(drafts[d], (name,)) != (name,)]
    assert not missing


@pytest.mark.parametrize(
    ("name", "draft_name"),
    [
        ("fly", "fitted-skirt"), ("back pockets", "t-shirt"), ("cargo pockets", "shirt-dress"),
        ("kangaroo pocket", "jeans"), ("buttons", "jeans"), ("patch pockets", "bustier"),
        ("chest pocket", "bandeau"), ("drawstring", "shirt"), ("half zip", "fitted-skirt"),
        ("slant pockets", "pleated-skirt"), ("bib pocket", "trousers"), ("neck frill", "fitted-skirt"),
        ("sleeve frills", "tank-top"), ("hem frill", "jeans"), ("neck frill", "hoodie"), ("apron", "t-shirt"),
        ("neck bow", "trousers"), ("lacing", "jeans"), ("neck rib", "turtleneck"),
        ("armhole ribs", "t-shirt"), ("elastic waist", "bomber-jacket"), ("creases", "fitted-skirt"),
        ("diagonal closing", "trousers"), ("knee rips", "fitted-skirt"), ("left knee rip", "t-shirt"),
        ("back buttons", "jeans"), ("back ties", "fitted-skirt"), ("back lacing", "jeans"),
        ("boning", "jeans"), ("boning", "coat"), ("shoulder bows", "jeans"), ("shoulder bows", "bustier"),
        ("waist placket", "fitted-skirt"), ("front pocket", "jeans"), ("lower back pockets", "fitted-skirt"),
        ("thigh pocket", "coat"), ("back elastic", "t-shirt"), ("knee patches", "gathered-skirt"),
        ("arm slits", "coat"), ("yoke frill", "bustier"), ("neck lace", "jeans"),
        ("shoulder drape", "bustier"),
        ("front frills", "fitted-skirt"),
        ("reflecting bands", "fitted-skirt"), ("asymmetric zip", "jeans"), ("storm flap", "trousers"),
        ("smocking", "fitted-skirt"), ("ruching", "jeans"), ("cowl folds", "jeans"),
        ("shoulder cut-outs", "tank-top"), ("waist cut-outs", "jeans"), ("back cut-out", "slip-dress"),
        ("elbow patches", "t-shirt"), ("elbow patches", "tank-top"),
        ("princess seams", "trousers"),
        ("waist frill", "skater-dress"), ("yoke", "bustier"),
        ("pleated front", "fitted-skirt"), ("fine pleats", "jeans"), ("neck pleats", "bustier"),
        ("shoulder pleats", "camisole"), ("back pleat", "fitted-skirt"), ("sleeve petals", "tank-top"),
        ("sleeve petals", "shirt"), ("neck gathers", "bandeau"), ("shoulder gathers", "camisole"),
        ("train", "skater-dress"), ("long train", "jeans"), ("overskirt", "jumpsuit"),
        ("tulle layers", "t-shirt"),
        ("cups", "fitted-skirt"), ("peplum", "t-shirt"), ("back cape", "strapless-dress"),
        ("belt loops", "skater-dress"), ("denim seams", "jeans"),
        ("strap buckles", "trousers"), ("kilt edge", "trousers"), ("hem border", "jeans"),
        ("folded band", "skater-dress"), ("thumb holes", "t-shirt"), ("sash", "camisole"),
        ("blouse front", "bustier"), ("bust gathers", "fitted-skirt"), ("hip knot", "t-shirt"),
        ("outer skirt", "circle-skirt"), ("outer skirt", "t-shirt"),
        ("shoulder frills", "circle-skirt"), ("illusion yoke", "strapless-dress"), ("bustle", "jeans"),
        ("hoops", "t-shirt"), 
        ("big buttons", "jeans"), ("nape bow", "halter-top"),
        ("box pleats", "camisole"), ("side tie", "trousers"),
        ("collar buttons", "blazer"), ("collar buttons", "t-shirt"), ("back yoke", "jeans"),
    ],
)  # fmt: skip
def test_has_none_on_others(name, draft_name, drafts):
    pattern = drafts[draft_name]
    assert trims_that_fit(pattern, (name, "tie belt")) in ((), ("tie belt",))
    assert place_trims(replace(pattern, trims=(name,))) == ()


@pytest.mark.parametrize(
    "name",
    [
        "smocking",
        "ruching",
        "tucks",
        "princess seams",
        "yoke",
        "pleated front",
        "fine pleats",
        "neck pleats",
        "neck gathers",
    ],
)
def test_lines_of_what_is_alike_on_both_sides_are_alike(name, drafts):
    pattern = replace(drafts["fitted-dress"], trims=(name,))
    trims = place_trims(pattern)
    assert len(trims) >= 4
    assert_in_pairs(pattern, trims, (name,))


def test_rows_of_smocking_run_on_over_darts(drafts):
    pattern = replace(drafts["peplum-top"], trims=("smocking",))
    rows = [trim for trim in place_trims(pattern) if isinstance(trim, Patch)]
    of_front = [row for row in rows if row.panel == "left_ftorso"]
    # From the neck down to the waist, though darts cross all of it: a row every 1.7 cm.
    assert len(of_front) >= 10


def test_zips_aslant_end_beside_darts_from_the_hem():
    short = draft("blazer", length=11.0, waist_shaping=2.0, opening=0.0, neck_depth=20.0)
    pattern = replace(short, trims=("asymmetric zip",))
    trims = place_trims(pattern)
    assert {trim.panel for trim in trims} == {"left_ftorso", "right_ftorso"}
    assert_on_panels(pattern, trims)


def test_nothing_is_put_on_unasked(drafts):
    assert all(place_trims(pattern) == () for pattern in drafts.values())


@pytest.mark.parametrize("info", list_drafts(), ids=lambda d: d.name)
def test_lies_on_its_panels_in_pairs(info, drafts):
    pattern = with_all(drafts[info.name])
    trims = place_trims(pattern)
    assert_on_panels(pattern, trims)
    assert_in_pairs(pattern, trims)
    assert {trim.trim for trim in trims} == set(trims_that_fit(pattern, tuple(TRIMS)))


@pytest.mark.parametrize("info", SOME, ids=lambda d: d.name)
@settings(max_examples=3, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(data=st.data())
def test_with_any_options_for_anybody(info, data):
    measures = data.draw(bodies())
    pattern = draft(info.name, measurements=measures, **data.draw(options_of(info)))
    height = data.draw(st.sampled_from([measures.height, *CHILDREN]))
    pattern = scaled(pattern, height / measures.height)
    named = DraftedFor("somebody", "children", (("height", height),))
    pattern = replace(with_all(pattern), drafted_for=named)
    assert_on_panels(pattern, place_trims(pattern))


def scaled(pattern: Pattern, share: float) -> Pattern:
    """For somebody as much smaller, nearly as a refit cuts it."""

    def smaller(panel: Panel) -> Panel:
        arcs = [
            replace(e, curve=replace(e.curve, radius=share * e.curve.radius))
            if isinstance(e.curve, Arc)
            else e
            for e in panel.edges
        ]
        place = tuple(share * x for x in panel.placement.translation)
        placement = replace(panel.placement, translation=place)
        return replace(panel, vertices=share * panel.vertices, edges=tuple(arcs), placement=placement)

    return replace(pattern, panels=tuple(smaller(panel) for panel in pattern.panels))


@pytest.mark.parametrize("height", CHILDREN)
@pytest.mark.parametrize("name", ["t-shirt", "shirt", "hoodie", "trousers", "fitted-dress", "dungarees"])
def test_of_children_smaller(name, height, drafts):
    """Also where their pattern is as large as an adult's, of which it then covers less."""
    named = DraftedFor("a child", "children", (("height", height),))
    pattern = replace(with_all(drafts[name]), drafted_for=named)
    trims = place_trims(pattern)
    assert_on_panels(pattern, trims)
    usual = {
        (t.trim, t.panel, k): t for k, t in enumerate(place_trims(with_all(drafts[name]))) if t.trim == "fly"
    }
    for trim in trims:
        if isinstance(trim, Button) and trim.trim == "button placket":
            assert trim.radius <= 0.6
    assert name != "trousers" or usual
    pockets = [t for t in trims if isinstance(t, Patch) and t.is_cut and "pocket" in t.trim]
    for pocket in pockets:
        assert np.ptp(seen(pattern, pocket), axis=0).max() <= (26 if pocket.trim == "front pocket" else 20)


@pytest.mark.parametrize("name", ["buttons", "button placket", "polo placket", "waist placket"])
@pytest.mark.parametrize("draft_name", ["shirt", "blazer", "cardigan", "denim-jacket", "coat", "camisole"])
def test_buttons_lie_on_the_middle_line_evenly_spaced(name, draft_name, drafts):
    pattern = replace(drafts[draft_name], trims=(name,))
    row = [t for t in place_trims(pattern) if isinstance(t, Button)]
    places = np.concatenate([seen(pattern, button) for button in row])
    assert len(places) >= 2
    seam = [seen_edge(pattern, ref) for ref in middle_edges(pattern)]
    for x, y in places:
        (on,) = {
            round(float(np.interp(y, *edge[np.argsort(edge[:, 1])].T[::-1])), 6)
            for edge in seam
            if edge[:, 1].min() <= y <= edge[:, 1].max()
        } or {0.0}
        assert abs(x - on) <= 0.02
    gaps = np.diff(places[:, 1])
    assert (gaps > 2).all()
    np.testing.assert_allclose(gaps, gaps[0], rtol=1e-6)
    assert len({button.radius for button in row}) == 1


def middle_edges(pattern: Pattern) -> list:
    """The edges of the right front that are sewn to the left one."""
    fronts = {"left_ftorso", "right_ftorso"}
    sewn = [s for s in pattern.stitches if {side.panel for side in s.sides} == fronts]
    return [side for s in sewn for side in s.sides if side.panel == "right_ftorso"]


def seen_edge(pattern: Pattern, ref) -> np.ndarray:
    panel = pattern.panel(ref.panel)
    return panel.to_world(panel.chord(ref.edge))[:, :2]


@pytest.mark.parametrize("name", JACKETS)
def test_two_rows_lie_on_both_sides_of_the_middle(name, drafts):
    pattern = replace(drafts[name], trims=("double-breasted buttons",))
    row = [t for t in place_trims(pattern) if isinstance(t, Button)]
    places = np.concatenate([seen(pattern, button) for button in row])
    left, right = places[places[:, 0] > 0], places[places[:, 0] < 0]
    assert len(left) == len(right) >= 2
    np.testing.assert_allclose(np.sort(left, axis=0)[:, 1], np.sort(right, axis=0)[:, 1])
    np.testing.assert_allclose(left[:, 0], -right[:, 0])
    assert {b.panel for b in row} == {"left_ftorso", "right_ftorso"}


def test_the_edge_of_a_double_breasted_front_runs_to_the_hem(drafts):
    """And not to the last button alone, where it looks like a pocket."""
    pattern = replace(drafts["coat"], trims=("double-breasted buttons",))
    lines = [t for t in place_trims(pattern) if isinstance(t, Patch)]
    lowest = min(seen(pattern, line)[:, 1].min() for line in lines)
    hem = pattern.panel("left_ftorso").to_world(pattern.panel("left_ftorso").outline(0.1))[:, 1].min()
    assert lowest - hem < 4.0


def test_coats_are_buttoned_to_the_thighs_and_toggles_end_above_pockets(drafts):
    coat = replace(drafts["coat"], trims=("buttons",))
    row = np.concatenate([seen(coat, t) for t in place_trims(coat) if isinstance(t, Button)])
    assert 70.0 < row[:, 1].min() < 85.0
    duffle = replace(drafts["hooded-coat"], trims=("toggles", "patch pockets"))
    low, high = (
        [seen(duffle, t)[:, 1] for t in place_trims(duffle) if isinstance(t, Patch) and t.trim == name]
        for name in ("toggles", "patch pockets")
    )
    assert min(y.min() for y in low) > max(y.max() for y in high)


def test_welts_lie_beside_two_rows_of_buttons(drafts):
    coat = replace(drafts["coat"], trims=("double-breasted buttons", "welt pockets"))
    placed = place_trims(coat)
    rows = np.concatenate([seen(coat, t) for t in placed if isinstance(t, Button)])
    welts = [seen(coat, t) for t in placed if isinstance(t, Patch) and t.trim == "welt pockets"]
    assert welts and all(np.abs(w[:, 0]).min() > np.abs(rows[:, 0]).max() for w in welts)


def test_a_belt_is_at_the_waist(drafts):
    for name in ("fitted-dress", "coat", "jeans", "circle-skirt"):
        (belt,) = place_trims(replace(drafts[name], trims=("buckle belt",)))
        assert isinstance(belt, Belt) and 90 < belt.height < 112


def test_follows_a_longer_pattern(drafts):
    """Rows of buttons reach to the hem; those of coats end at the thigh."""

    def lowest(length: float) -> float:
        pattern = replace(draft("shift-dress", length=length), trims=("button placket",))
        return min(float(seen(pattern, t)[:, 1].min()) for t in place_trims(pattern) if isinstance(t, Button))

    assert lowest(62) < lowest(40) - 15
    coats = [replace(draft("coat", length=length), trims=("buttons",)) for length in (60, 72)]
    ends = [
        min(float(seen(c, t)[:, 1].min()) for t in place_trims(c) if isinstance(t, Button)) for c in coats
    ]
    assert ends[0] == pytest.approx(ends[1], abs=1.0)


def test_never_raises_for_known_patterns(garmentcode_folder):
    """And what it puts on lies on the panels."""
    path = garmentcode_folder / "validation.jsonl.gz"
    if not path.exists():
        pytest.skip(f"no {path.name} in {garmentcode_folder}")
    found = set()
    for number, known in enumerate(read_patterns(path)):
        if number == 60:
            break
        pattern = with_all(parsed_pattern(known))
        trims = place_trims(pattern)
        assert_on_panels(pattern, trims)
        found |= {trim.trim for trim in trims}
        if number % 5 == 0:
            alone = {name for name in TRIMS if place_trims(replace(pattern, trims=(name,)))}
            assert alone == {trim.trim for trim in trims}
    assert found == set(TRIMS) - {"collar buttons"}, "GarmentCode's collars have no points"


def test_never_raises_for_patterns_of_other_names(shipped_patterns, square_pattern):
    for pattern in (square_pattern, *shipped_patterns.values()):
        assert_on_panels(pattern, place_trims(with_all(pattern)))


def test_elastic_draws_folds_where_cloth_is_gathered_alone(drafts):
    dress = place_trims(replace(draft("skater-dress", gathers=1.7), trims=("elastic waist",)))
    assert {"skirt_front", "left_ftorso", "right_btorso"} <= {piece.panel for piece in dress}
    assert place_trims(replace(drafts["skater-dress"], trims=("elastic waist",))) == ()
    folds = place_trims(replace(drafts["pull-on-trousers"], trims=("elastic waist",)))
    round_skirt = place_trims(replace(drafts["circle-skirt"], trims=("elastic waist",)))
    assert {"skirt_front", "wb_back"} <= {piece.panel for piece in round_skirt} and len(round_skirt) > 20
    smooth = place_trims(replace(drafts["leggings"], trims=("elastic waist",)))
    assert {piece.panel for piece in smooth} == {"wb_front", "wb_back"}
    assert {"pant_f_l", "pant_b_r", "wb_front"} <= {piece.panel for piece in folds} and len(folds) > 40


def test_rips_lie_where_their_names_say(drafts):
    """At the knees of the left or the right leg, the wearer's, and of shorts on the thighs alone."""

    def places(name: str, pattern: Pattern) -> np.ndarray:
        holes = place_trims(replace(pattern, trims=(name,)))
        return np.array([seen(pattern, hole).mean(axis=0) for hole in holes])

    jeans, shorts = drafts["jeans"], draft("trousers", length=50)
    left, right = places("left knee rip", jeans), places("right knee rip", jeans)
    both = places("knee rips", jeans)
    assert len(left) == len(right) == 1 and len(both) == 2
    assert left[0, 0] > 5 > -5 > right[0, 0] and (42 < both[:, 1]).all() and (both[:, 1] < 58).all()
    assert len(places("rips", jeans)) >= 5 and len(places("knee rips", shorts)) == 0
    thighs = places("rips", shorts)
    assert len(thighs) >= 3 and (thighs[:, 1] > 60).all()
