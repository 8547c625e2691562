"""A reader of captions who knows GarmentCode's design, but neither our vocabulary nor our measures."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

Design = dict[str, Any]
Truth = Callable[[Design], bool]


def upper(design: Design) -> bool:
    return design["meta.upper"] is not None


def asymmetric(design: Design) -> bool:
    return upper(design) and design["left.enable_asym"]


def strapless(design: Design) -> bool:
    return design["meta.upper"] == "FittedShirt" and design["shirt.strapless"]


def no_sleeves(design: Design) -> bool:
    sides = ("", "left.") if design["left.enable_asym"] else ("",)
    bare = [design["meta.upper"] == "FittedShirt" and design[s + "shirt.strapless"] for s in sides]
    return all(b or design[s + "sleeve.sleeveless"] for b, s in zip(bare, sides, strict=True))


def bottom(*kinds: str) -> Truth:
    return lambda d: d["meta.bottom"] in kinds


def on_collar(style: str) -> Truth:
    return lambda d: upper(d) and not asymmetric(d) and d["collar.component.style"] == style


def neck(*shapes: str) -> Truth:
    """One half of the front neckline at least has one of these shapes."""
    named = {f"{s}NeckHalf" for s in shapes}
    return lambda d: (d["collar.f_collar"] in named or (asymmetric(d) and d["left.collar.f_collar"] in named))


CIRCLES = ("SkirtCircle", "AsymmSkirtCircle")

# What a text says, and what the design must then be.
READER: dict[str, Truth] = {
    r"(?<!no )\bhood(ed|ie)?\b": on_collar("Hood2Panels"),
    r"\b(?<!no )lapels?\b|lapell?ed": on_collar("SimpleLapel"),
    r"turtleneck|roll[- ]neck|polo neck|funnel|stand(-up)? collar|high-collared": on_collar("Turtle"),
    r"jumpsuit|playsuit|romper": lambda d: upper(d) and bottom("Pants")(d),
    r"trousers|\bpants\b|shorts|culottes|slacks|joggers|capris": lambda d: not upper(d)
    and bottom("Pants")(d),
    r"godet|flared inserts": bottom("GodetSkirt"),
    r"\btier(s|ed)?\b|ruffled tiers": bottom("SkirtLevels"),
    r"\bgores?\b|gored|panell?ed|-panel skirt": bottom("SkirtManyPanels"),
    r"(?<!no )\b(waistband|hem band|banded hem)|band at the (hem|bottom)": lambda d: d["meta.wb"] is not None,
    r"no waistband": lambda d: d["meta.wb"] is None,
    r"\bsleeveless\b|no sleeves|bare arms|arms are bare": no_sleeves,
    r"\b(long|short|puff|balloon|bell|elbow|quarter|half|full|wide|slim)[a-z]*(-length)?,?[- ]sleeves?\b": (
        lambda d: upper(d) and not no_sleeves(d)
    ),
    r"\bstrapless|bandeau|tube top|boob tube|bustier": strapless,
    r"\bdart(s|ed)\b": lambda d: d["meta.upper"] == "FittedShirt",
    r"dartless|boxy": lambda d: d["meta.upper"] == "Shirt",
    r"pencil": bottom("PencilSkirt", "Skirt2", "SkirtCircle"),
    r"circle skirt|full skirt": bottom(*CIRCLES, "SkirtManyPanels"),
    r"handkerchief|pointed hem|zigzag|hangs in points|scalloped|petal": bottom(
        "SkirtManyPanels", "SkirtLevels"
    ),
    r"(?<!no )\bslits?\b|\bvent\b": bottom("PencilSkirt", "Skirt2", *CIRCLES),
    r"(high|hi)-lo|dips? at the back|dipped|longer at the back": bottom("AsymmSkirtCircle", "SkirtLevels"),
    r"\bv[- ]?(neck|shaped neck|neckline)": neck("V", "Trapezoid", "Bezier2", "CircleArc"),
    r"square(d-off)?[- ]neck": neck("Square", "Trapezoid"),
    r"s-curve": neck("Curvy"),
    r"asymmetric(al)? (?!hem)|one-shoulder": asymmetric,
}


def false_statements(text: str, design: Design) -> list[str]:
    """What a text says that the design denies."""
    return [p for p in understood(text) if not READER[p](design)]


def understood(text: str) -> list[str]:
    """What the reader understands of a text."""
    return [p for p in READER if re.search(p, text, re.IGNORECASE)]
