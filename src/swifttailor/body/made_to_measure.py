"""A body for given measures: the likeliest of the shapes that have them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.body import Body
from swifttailor.body.body_measures import MEASURES, measurements_of, take
from swifttailor.body.landmarks import Landmarks
from swifttailor.body.shape_space import ShapeSpace
from swifttailor.errors import InputError

TOLERANCE_CM, TOLERANCE = 0.5, 0.008
"""A measure counts as met within the first, or this share of it."""
_EXACT_CM = 0.08
"""How far off a measure is as unlikely as a body one standard deviation from the mean."""
_MOST_ROUNDS = 8
_SETTLED = 0.02
_STEP = 0.05
"""Of a coordinate, for slopes."""
_UNLIKELY = 5.0
"""Root mean square of standard deviations beyond which there is no such person in the shapes."""
CHILD_CM = 148.0
"""Who is smaller counts as a child where nothing else is said."""


@dataclass(frozen=True, eq=False)
class MadeBody:
    """A body and what it was made to."""

    body: Body
    coordinates: Array
    """(K,) in the shape space."""
    taken: dict[str, float]
    """The measures that were asked for, as they are on the mesh, cm."""


def body_to_measure(
    measures: Mapping[str, float], *, figure: str | None = None, name: str = "measured"
) -> MadeBody:
    """Makes the likeliest body that has given measures.

    Coordinates are found by damped Gauss-Newton on the measures, which are taken on the mesh, and on the
    distance from the mean of the figure.

    Args:
        measures: By the names of `MEASURES`, cm.
        figure: ``women``, ``men`` or ``children``, by which is chosen what the measures leave open; adults
            near the default body when None, children below 148 cm.
        name: Of the body.

    Raises:
        InputError: A measure is unknown or out of range, or no body of the shapes has all of them together;
            the text says which come nearest.
    """
    _require_measures(measures)
    if figure is None and measures.get("height", 1e3) < CHILD_CM:
        figure = "children"
    space = ShapeSpace.default()
    mean, covariance = space.prior(figure)
    spread = np.linalg.cholesky(covariance + 1e-9 * np.eye(space.count))
    coordinates = _solve(space, measures, mean, spread)
    landmarks = Landmarks(space.vertices(coordinates))
    taken = {one: take(one, landmarks) for one in measures}
    away = np.linalg.solve(spread, coordinates - mean)
    _require_met(measures, taken, float(np.sqrt((away**2).mean())))
    default = Body.default()
    body = Body(name, landmarks.vertices, default.faces, default.vertex_part, measurements_of(landmarks))
    return MadeBody(body, coordinates, taken)


def _solve(space: ShapeSpace, measures: Mapping[str, float], mean: Array, spread: Array) -> Array:
    """Coordinates (K,); they are sought as standard deviations from the mean of the figure."""
    wanted = np.array(list(measures.values()))

    def measured(away: Array) -> Array:
        landmarks = Landmarks(space.vertices(mean + spread @ away))
        return np.array([take(name, landmarks) for name in measures])

    away = np.zeros(space.count)
    if not len(wanted):
        return mean
    now = measured(away)
    for _ in range(_MOST_ROUNDS):
        # Measures move most along few directions of the spread, but their slopes are cheap.
        slope = np.stack(
            [(measured(away + _STEP * one) - now) / _STEP for one in np.eye(space.count)], axis=1
        )
        # The nearest to the mean that has the measures: min |x|^2 + |(slope (x - away) + now - wanted) / e|^2.
        gram = slope @ slope.T + _EXACT_CM**2 * np.eye(len(wanted))
        target = slope.T @ np.linalg.solve(gram, wanted - now + slope @ away)
        step, size = target - away, float(np.abs(target - away).max())
        away = away + step * min(1.0, 2.5 / max(size, 1e-9))
        now = measured(away)
        if size < _SETTLED or np.abs(now - wanted).max() < 0.02:
            break
    return mean + spread @ away


def _require_measures(measures: Mapping[str, float]) -> None:
    for name, value in measures.items():
        if name not in MEASURES:
            raise InputError(f"There is no measure '{name}'. There are: {', '.join(MEASURES)}.")
        one = MEASURES[name]
        if not np.isfinite(value) or not one.smallest <= value <= one.largest:
            raise InputError(
                f"The measure '{name}' ({one.meaning}) is {value:g} cm; {one.smallest:g} to "
                f"{one.largest:g} cm is accepted."
            )


def _require_met(wanted: Mapping[str, float], taken: Mapping[str, float], unlikely: float) -> None:
    missed = [
        name
        for name, value in wanted.items()
        if abs(taken[name] - value) > max(TOLERANCE_CM, TOLERANCE * value)
    ]
    if not missed and unlikely <= _UNLIKELY:
        return
    nearest = ", ".join(f"{name}={taken[name]:.1f}" for name in wanted)
    asked = ", ".join(f"{name}={value:g}" for name, value in wanted.items())
    raise InputError(
        f"No body has these measures together: {asked}. The nearest that one has: {nearest}. "
        "Give these, or leave one of the measures out."
    )
