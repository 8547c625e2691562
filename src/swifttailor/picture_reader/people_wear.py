"""What people wear less often in pictures than garments that are drawn by lot have it.

A reader learns how often things are from what it is shown, and says that where it cannot see. GarmentCode's
hoods are all worn over the head; in pictures of people hoods lie on the back, and what is around the head is
hair.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS, kinds_of_panels
from swifttailor.programs.read_parameter import ReadParameter

DRAWN, WORN = 0.08, 0.01
"""Share of upper garments whose hood is over the head: of those drawn of people to validate with; and, by our
estimate, in photographs of people."""
_COLLAR, _HOOD = "collar.component.style", "Hood2Panels"


def as_people_wear(
    answers: Mapping[str, NDArray[Any]], parameters: Sequence[ReadParameter] = ()
) -> dict[str, NDArray[Any]]:
    """What is read of a picture of people, with the odds of hoods as they are there.

    Args:
        answers: Logits by the names of outputs; (parts, S) of `statements`, (parts, M) of `has`, (parts, P)
            of `panels`, (parts, parameters, values) of `designs` where there are `parameters`.
        parameters: Whose designs are said.

    Returns:
        The same, with the odds of hoods multiplied by the ratio of those of `WORN` and `DRAWN`.
    """
    more = np.log(WORN / (1 - WORN)) - np.log(DRAWN / (1 - DRAWN))
    statements, has, panels = _of_hoods()
    changed = {"statements": statements, "has": has, "panels": panels}
    if parameters:
        changed["designs"] = _of_hooded_designs(tuple(parameters), answers["designs"].shape[-1])
    return dict(answers) | {name: answers[name] + more * signs for name, signs in changed.items()}


def with_hoods_of_near(
    answers: Mapping[str, NDArray[Any]],
    whole: Mapping[str, NDArray[Any]],
    part: int,
    parameters: Sequence[ReadParameter] = (),
) -> dict[str, NDArray[Any]]:
    """What is read of a garment, with the odds of a hood that a look at the neck gave it, in everything.

    From near a hood is told from hair. That look says whether there are the panels of one, not how large a
    hood is or which design has one.

    Args:
        answers: Logits after all looks, see `as_people_wear`.
        whole: The same before details were looked at.
        part: Number of the part of the body on which the garment is worn.
        parameters: Whose designs are said.
    """
    _, has, panels = _of_hoods()
    hood = panels > 0
    more = float((answers["panels"][part, hood] - whole["panels"][part, hood]).mean())
    found = dict(answers)
    changed = {"has": has}
    if parameters:
        changed["designs"] = _of_hooded_designs(tuple(parameters), answers["designs"].shape[-1])
    for name, signs in changed.items():
        found[name] = np.array(answers[name], np.float64)
        found[name][part] += more * signs
    return found


@cache
def _of_hoods() -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """(S,), (M,) and (P,): 1 for what says that there is a hood, -1 for what says that there is none."""
    signs = {("hood", "hood"): 1.0, ("hood", "none"): -1.0}
    statements = [signs.get(label, 0.0) for label in statement_labels()]
    panels = kinds_of_panels() == PANEL_KINDS.index("hood")
    has = [name.startswith("hood ") for name in measure_labels()]
    return np.array(statements, np.float32), np.array(has, np.float32), panels.astype(np.float32)


@lru_cache(maxsize=4)
def _of_hooded_designs(parameters: tuple[ReadParameter, ...], values: int) -> NDArray[np.float32]:
    """(parameters, values): 1 for the design that has a hood."""
    found = np.zeros((len(parameters), values), np.float32)
    for k, one in enumerate(parameters):
        if one.name == _COLLAR and _HOOD in one.values:
            found[k, one.values.index(_HOOD)] = 1
    return found
