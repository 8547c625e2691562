"""What was read of pictures, as numbers and as tables."""

from __future__ import annotations

from typing import Any

import numpy as np

from swifttailor.evaluation.pictures.reading import SHOWN, ReadPicture, Share, claim_shares, stated_shares
from swifttailor.evaluation.text_table import Column, Row, text_table

SURE = 0.9
"""What a garment is cut to is at least so certain."""
_LOOKS = tuple(dict.fromkeys(look for look, _ in SHOWN))
_VIEWS = tuple(dict.fromkeys(view for _, view in SHOWN))
_CHECKED = (
    "sleeve length",
    "length",
    "skirt length",
    "leg length",
    "waistband height",
    "neck depth",
    "chest",
)


def summary(pictures: list[ReadPicture]) -> dict[str, Any]:
    """All numbers, as JSON values: by look and view, by claim, measures."""
    groups = {
        f"{look} {view}": [p for p in pictures if (p.look, p.view) == (look, view)] for look, view in SHOWN
    }
    return {
        "pictures": len(pictures),
        "by_look": {name: _group(group) for name, group in groups.items() if group},
        "claims": {
            name: {
                look: _share(shares[name]) for look, shares in _by_look(pictures).items() if name in shares
            }
            for name in claim_shares(pictures)
        },
        "measures_cm": _measures(pictures),
    }


def _group(pictures: list[ReadPicture]) -> dict[str, Any]:
    shares = claim_shares(pictures).values()
    held, said = stated_shares(pictures, SURE)
    return {
        "pictures": len(pictures),
        "not_false": _share(Share(sum(s.good for s in shares), sum(s.of for s in shares))),
        "sure_hold": _share(held),
        "true_said": _share(said),
        "panels": round(float(np.mean([p.panels for p in pictures])), 4),
        "mask": round(float(np.mean([p.mask for p in pictures])), 4),
    }


def _by_look(pictures: list[ReadPicture]) -> dict[str, dict[str, Share]]:
    return {look: claim_shares([p for p in pictures if p.look == look]) for look in _LOOKS}


def _share(share: Share) -> float | None:
    return round(share.value, 4) if share.of else None


def _measures(pictures: list[ReadPicture]) -> dict[str, dict[str, float]]:
    found: dict[str, dict[str, float]] = {}
    for name in _CHECKED:
        for look in _LOOKS:
            off = [p.off[name] for p in pictures if p.look == look and name in p.off]
            if off:
                found.setdefault(name, {})[look] = round(float(np.median(off)), 2)
    return found


def tables(result: dict[str, Any]) -> str:
    """The same as text."""
    names = ("not_false", "sure_hold", "true_said", "panels", "mask")
    heads = ("claims not false %", f"of {SURE:.0%} sure, hold %", "of true, so sure %", "panels %", "mask %")
    rows: list[Row] = [
        (name, [_percent(group[key]) for key in names]) for name, group in result["by_look"].items()
    ]
    text = text_table([Column(head, ".1f") for head in heads], rows)
    claims: list[Row] = [
        (name, [_percent(shares.get(look)) for look in _LOOKS]) for name, shares in result["claims"].items()
    ]
    text += "\nLikeliest word not false, of pictures of garments with a true one, %\n"
    text += text_table([Column(look, ".0f") for look in _LOOKS], claims)
    measures: list[Row] = [
        (name, [off.get(look) for look in _LOOKS]) for name, off in result["measures_cm"].items()
    ]
    text += "\nMeasures, median distance from the truth, cm\n"
    return text + text_table([Column(look, ".1f") for look in _LOOKS], measures)


def _percent(share: float | None) -> float | None:
    return None if share is None else 100 * share
