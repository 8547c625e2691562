"""Hoods in what a network says of a picture: which answers speak of them, and what a near look adds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.labels import measure_labels, statement_labels
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS, kinds_of_panels
from swifttailor.programs.read_parameter import ReadParameter

_COLLAR, _HOOD = "collar.component.style", "Hood2Panels"


def hood_signs(
    answers: Mapping[str, NDArray[Any]], parameters: Sequence[ReadParameter] = ()
) -> dict[str, NDArray[np.float32]]:
    """Which answers of a network speak of hoods.

    Args:
        answers: Logits by the names of outputs.
        parameters: Whose designs are said; none where the network says no `designs`.

    Returns:
        By output, with the shape of what it says of one part of the body: 1 where it says that there is a
        hood, -1 where it says that there is none, else 0.
    """
    signs = dict(_of_garments())
    if parameters:
        signs["designs"] = _of_designs(tuple(parameters), answers["designs"].shape[-1])
    return signs


def with_hoods_of_near(
    answers: Mapping[str, NDArray[Any]],
    whole: Mapping[str, NDArray[Any]],
    part: int,
    parameters: Sequence[ReadParameter] = (),
) -> dict[str, NDArray[Any]]:
    """What is read of a garment, with a hood as likely everywhere as a look at the neck made its panels.

    From near a hood is told from hair. That look says whether there are the panels of one, not how large a
    hood is or which design has one.

    Args:
        answers: Logits after all looks, see `people_wear.as_people_wear`.
        whole: The same before details were looked at.
        part: Number of the part of the body on which the garment is worn.
        parameters: Whose designs are said.
    """
    signs = hood_signs(answers, parameters)
    hood = signs["panels"] > 0
    more = float((answers["panels"][part, hood] - whole["panels"][part, hood]).mean())
    found = dict(answers)
    for name in signs.keys() & {"has", "designs"}:
        found[name] = np.array(answers[name], np.float64)
        found[name][part] += more * signs[name]
    return found


@cache
def _of_garments() -> Mapping[str, NDArray[np.float32]]:
    """What is said of any garment: `statements` (S,), `has` (M,) and `panels` (P,)."""
    said = {("hood", "hood"): 1, ("hood", "none"): -1}
    signs: dict[str, Any] = {
        "statements": [said.get(label, 0) for label in statement_labels()],
        "has": [name.startswith("hood ") for name in measure_labels()],
        "panels": kinds_of_panels() == PANEL_KINDS.index("hood"),
    }
    return {name: np.array(values, np.float32) for name, values in signs.items()}


@lru_cache(maxsize=4)
def _of_designs(parameters: tuple[ReadParameter, ...], values: int) -> NDArray[np.float32]:
    """(parameters, values): 1 for the design that has a hood."""
    found = np.zeros((len(parameters), values), np.float32)
    for k, one in enumerate(parameters):
        if one.name == _COLLAR and _HOOD in one.values:
            found[k, one.values.index(_HOOD)] = 1
    return found
