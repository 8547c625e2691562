"""The likeliest design whose pattern has the panels that are seen.

Each parameter is read for itself, and which panels there are follows from several at once; so the likeliest
choices together may have a cuff that nobody saw. Choices that are nearly as likely are tried in turn, and
kept where the panels of the pattern are likelier for them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern.names import PANEL_NAMES
from swifttailor.pattern_library.sought import Sought
from swifttailor.programs import make_pattern
from swifttailor.programs.read_parameter import ReadParameter

MAKE_PANELS = frozenset(
    {
        *("meta.upper", "meta.wb", "meta.bottom", "left.enable_asym", "collar.component.style"),
        *("shirt.strapless", "left.shirt.strapless", "sleeve.sleeveless", "left.sleeve.sleeveless"),
        *("sleeve.cuff.type", "left.sleeve.cuff.type", "pants.cuff.type", "levels-skirt.num_levels"),
        *("flare-skirt.skirt-many-panels.n_panels", "godet-skirt.num_inserts"),
    }
)
"""The only choices that decide which panels there are."""
LEAST_SHARE = 0.002
"""Of choices that are tried."""
PANELS_COUNT = 0.3
"""Of the likelihood of panels, as an exponent: those of one kind are seen or not seen together, and choices
were read from them, too."""
MOST_TRIED, MOST_CHANGED = 16, 3
"""So many in each round, and so many rounds."""

Design = dict[str, Any]
"""Values of design parameters by flat names; those that are not there have their defaults."""


def agreeing_design(
    design: Design, parameters: Sequence[ReadParameter], shares: Sequence[Floats], sought: Sought
) -> Design:
    """Changes choices of a design until no other makes the panels that are seen likelier.

    Args:
        design: The likeliest value of each parameter.
        parameters: That were read.
        shares: For each (values,) how likely they are.
        sought: Whose panels count.

    Returns:
        The same, or a design that is likelier as a whole: by its choices and by its panels.
    """
    if not sought.named.any():
        return design
    best, fit = design, _fit_of_panels(design, sought)
    for _ in range(MOST_CHANGED):
        others = [(more, best | change) for more, change in _others(best, parameters, shares)]
        fits = [_fit_of_panels(other, sought) for _, other in others]
        whole = [more + one for (more, _), one in zip(others, fits, strict=True)]
        if max(whole, default=fit) <= fit:
            break
        k = int(np.argmax(whole))
        best, fit = others[k][1], fits[k]
    return best


def _others(
    design: Design, parameters: Sequence[ReadParameter], shares: Sequence[Floats]
) -> list[tuple[float, Design]]:
    """Other choices, the likeliest first, and how much likelier than those of a design: a logarithm."""
    found = []
    for one, share in zip(parameters, shares, strict=True):
        if one.name not in MAKE_PANELS:
            continue
        now = one.values.index(design[one.name])
        found += [
            (float(np.log(share[k]) - np.log(max(share[now], 1e-9))), {one.name: one.values[k]})
            for k in np.flatnonzero(share >= LEAST_SHARE)
            if k != now
        ]
    return sorted(found, key=lambda other: -other[0])[:MOST_TRIED]


def _fit_of_panels(design: Design, sought: Sought) -> float:
    """How likely the panels of a design are, as a logarithm; minus infinity where it makes no pattern."""
    try:
        names = {panel.name for panel in make_pattern(design).panels}
    except SwiftTailorError:
        return -float("inf")
    likelihoods = np.where(_there(names), sought.panels, 1 - sought.panels)
    return PANELS_COUNT * float(np.sum(sought.named * np.log(likelihoods)))


def _there(names: set[str]) -> NDArray[np.bool_]:
    return np.array([name in names for name in PANEL_NAMES])
