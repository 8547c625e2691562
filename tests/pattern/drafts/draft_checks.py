"""What every draft must be, whatever its options and the body: the checks that several tests share."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from hypothesis import strategies as st

from swifttailor.pattern import Pattern, Stitch
from swifttailor.pattern.drafts import DraftInfo, DraftMeasurements

MEASURED = list(DraftMeasurements.__dataclass_fields__)
WITH_BACK = {"bust": "back_width", "waist": "waist_back_width", "hips": "hip_back_width"}


FOLDED_OR_NOT = {
    "blazer",
    "cape",
    "coat",
    "polo-shirt",
    "denim-jacket",
    "shirt",
    "shirt-dress",
    "fitted-dress",
    "mermaid-dress",
    "shift-dress",
    "swing-dress",
    "drop-waist-dress",
    "jumpsuit",
    "peplum-top",
}
"""Theirs may also stand, or be turned down over a stand."""


GATHERED_AT_THE_WAIST = (
    "empire-dress",
    "drop-waist-dress",
    "shirt-dress",
    "skater-dress",
    "strappy-dress",
    "strapless-dress",
)
GATHERED_AT_THE_BAND = ("gathered-skirt", "tiered-skirt", "pull-on-trousers", "joggers")


def is_gathered(pattern: Pattern, stitch: Stitch) -> bool:
    """Whether the draft declares fullness in this seam: sleeve caps, cuffs, hem bands, gathered skirts."""
    names = {stitch.first.panel, stitch.second.panel}
    cap = any("torso" in n for n in names) and any("sleeve" in n for n in names)
    cuff = any("sleeve" in n or "pant_" in n for n in names) and sum("cuff" in n for n in names) == 1
    band = any(n.startswith("wb_") for n in names) and (
        any("torso" in n for n in names) or pattern.name in GATHERED_AT_THE_BAND
    )
    if pattern.name == "tiered-skirt" and all(n.startswith("skirt") for n in names):
        return True
    if pattern.name == "mermaid-dress" and any(n[-1].isdigit() for n in names):  # its tiers
        return all(n.startswith("skirt_front") for n in names) or all(
            n.startswith("skirt_back") for n in names
        )
    if any(names == {f"skirt_{part}", f"skirt_{part}_0"} for part in ("front", "back")):
        return True  # a bubble skirt, drawn together by its hem band
    if any("torso" in n for n in names) and any("cuff" in n for n in names):
        return True  # sleeves that are cut in one, into their cuffs
    if pattern.name in GATHERED_AT_THE_WAIST and any(n.startswith("skirt") for n in names):
        return any("torso" in n for n in names)
    return cap or cuff or (band and len(names) == 2 and not all(n.startswith("wb_") for n in names))


def is_fold(stitch: Stitch) -> bool:
    """Whether it is where a collar is turned down over its stand, or cloth is folded away in a pleat."""
    falls = sum("collar_fall" in side.panel for side in stitch.sides)
    strips = [word for side in stitch.sides for word in ("skirt_under", "skirt_pleat") if word in side.panel]
    return falls == 1 or sorted(strips) == ["skirt_pleat", "skirt_under"]


def assert_sound(pattern: Pattern) -> None:
    """Simple panels with area, every edge sewn at most once, seams that fit, one connected garment."""
    for panel in pattern.panels:
        outline = shapely.Polygon(panel.outline(0.002))
        assert outline.is_valid, f"{panel.name} crosses itself: {shapely.is_valid_reason(outline)}"
        assert outline.area > 4.0, panel.name
        lengths = [panel.edge_length(k) for k in range(len(panel.edges))]
        assert min(lengths) > 0.05, f"{panel.name}: sliver edge {lengths}"
        name = panel.name.rstrip("0123456789").removesuffix("_")
        back = name.endswith(("_b", "_b_l", "_b_r", "_back")) or "btorso" in name
        if name == "skirt_panel":  # gores, those behind after those in front
            gores = sum(p.name.startswith(name) for p in pattern.panels)
            back = int(panel.name.removeprefix("skirt_panel_")) >= gores - gores // 2
        assert (panel.signed_area() < 0) == back, f"{panel.name} runs the wrong way"
        assert panel.normal() @ np.array(panel.placement.translation) >= 0, f"{panel.name} faces inward"
    sewn = [side for s in pattern.stitches for side in s.sides]
    assert len(sewn) == len(set(sewn))
    at_necks = {s.right_wrong for s in pattern.stitches if sum("collar" in x.panel for x in s.sides) == 1}
    assert len(at_necks) <= 1
    lies_folded = True in at_necks and pattern.name in FOLDED_OR_NOT
    for stitch in pattern.stitches:
        folded = sum("collar" in side.panel for side in stitch.sides) == 1 and lies_folded
        assert stitch.right_wrong == (folded or is_fold(stitch))
        a, b = (pattern.edge_length(side) for side in stitch.sides)
        if not is_gathered(pattern, stitch):
            assert abs(a - b) <= 1e-3 * max(a, b), f"{stitch}: {a} against {b}"
    assert len(pattern.components()) == 1


@st.composite
def bodies(draw: st.DrawFn) -> DraftMeasurements:
    """The default body with every measurement up to 10 % larger or smaller; backs go with their girths."""
    around = st.floats(0.9, 1.1)
    values = {name: getattr(DraftMeasurements(), name) * draw(around) for name in MEASURED}
    for girth, back in WITH_BACK.items():
        share = getattr(DraftMeasurements(), back) / getattr(DraftMeasurements(), girth)
        values[back] = values[girth] * share * draw(st.floats(0.96, 1.04))
    return DraftMeasurements(**values)


@st.composite
def options_of(draw: st.DrawFn, info: DraftInfo) -> dict[str, Any]:
    """Any options within their ranges, the ends of the ranges included."""
    chosen: dict[str, Any] = {}
    for field in info.options:
        if field.choices:
            chosen[field.name] = draw(st.sampled_from(field.choices))
        elif field.kind is bool:
            chosen[field.name] = draw(st.booleans())
        else:
            low, high = field.option.low, field.option.high
            assert low is not None and high is not None
            numbers = st.floats(low, high) if field.kind is float else st.integers(int(low), int(high))
            chosen[field.name] = draw(st.one_of(st.sampled_from([low, high, field.default]), numbers))
    return chosen
