"""How often people wear what in photographs, where a network has learnt from as many skirts as trousers.

It says how often things are where it cannot see them: dark trousers below a coat were a skirt in every third
photograph of the street, and a jumper above trousers of its colour was a jumpsuit.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.said import share_of

KINDS: Mapping[str, Mapping[str, tuple[float, float]]] = MappingProxyType(
    {
        "upper": MappingProxyType({"jumpsuit": (0.1, 0.01), "playsuit": (0.05, 0.01)}),
        "lower": MappingProxyType({"skirt": (0.45, 0.1)}),
    }
)
"""By part of the body: the share of garments there that are of a kind, of those that are drawn to learn from
(docs/data.md, usual garments), and of those in photographs of people (benchmarks/photographs); rounded."""
BEFORE_PLAIN = 0.5
"""How far the odds go before a plain ground, which may be a shop's: shops show as many skirts as trousers."""
_MOST = 0.98
"""Nothing becomes surer than this by being more usual."""
_LEAST = 1e-9
"""What is so sure, or so unlikely, has a logit still."""


def kinds_as_worn(answers: Mapping[str, Any], how_far: float = 1.0) -> dict[str, Any]:
    """What is read of somebody in a photograph, with the odds of kinds as they are worn there.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`.
        how_far: The odds go from drawn ones (0) to those of photographs (1).

    Returns:
        The same with other logits of kinds; those of a part have the sum of shares that they had, unless one
        were all too sure.
    """
    statements = np.array(answers["statements"], np.float64)
    labels = statement_labels()
    kinds = [k for k, (claim, _) in enumerate(labels) if claim == "kind"]
    for number, name in enumerate(PARTS):
        before = share_of(statements[number, kinds])
        after = before.copy()
        for k, index in enumerate(kinds):
            if labels[index][1] in KINDS[name]:
                drawn, worn = KINDS[name][labels[index][1]]
                after[k] *= (worn / (1 - worn) * (1 - drawn) / drawn) ** how_far
        surest = max(float(before.max()), _MOST) / after.max()
        after = np.clip(after * min(before.sum() / after.sum(), surest), _LEAST, 1 - _LEAST)
        statements[number, kinds] = np.log(after) - np.log1p(-after)
    return dict(answers) | {"statements": statements}
