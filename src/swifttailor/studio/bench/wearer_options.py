"""Whom garments can be made for: figures, charts of sizes, measures."""

from __future__ import annotations

from typing import Any

from swifttailor.body import Body
from swifttailor.body.body_measures import MEASURES, take
from swifttailor.body.landmarks import Landmarks
from swifttailor.body.size_charts import FIGURES, charts

SHOWN = (
    *("height", "bust", "underbust", "waist", "hips", "shoulder_w", "arm_length", "biceps", "wrist", "neck"),
    *("waist_line", "inseam", "leg_circ", "calf"),
)
"""Measures that a person is asked for, the usual ones first."""
LABELS = {
    "shoulder_w": "shoulder width",
    "arm_length": "arm length",
    "leg_circ": "thigh",
    "waist_line": "neck to waist",
}


def wearer_options() -> dict[str, Any]:
    """`models.projects.WearerOptions`: what can be chosen, with the default body's measures."""
    default = shown_measures(Body.default())
    return {
        "figures": list(FIGURES),
        "sizes": [
            {"figure": figure, "region": region, "labels": list(chart)}
            for (figure, region), chart in charts().items()
        ],
        "measures": [
            {
                "name": name,
                "label": LABELS.get(name, name),
                "about": MEASURES[name].meaning,
                "min": MEASURES[name].smallest,
                "max": MEASURES[name].largest,
                "default": default[name],
            }
            for name in SHOWN
        ],
    }


def shown_measures(body: Body) -> dict[str, float]:
    """The shown measures of a body, taken on its mesh, cm."""
    landmarks = Landmarks(body.vertices)
    return {name: round(take(name, landmarks), 1) for name in SHOWN}


def measures_of_mesh(body: Body) -> dict[str, float]:
    """The shown measures that are known of a body of any mesh, cm: its landmarks are not known."""
    known = body.measurements.as_dict()
    return {name: round(known[name], 1) for name in SHOWN if name in known}
