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
_LOOSEST_CM = 20.0
_MOST_ROUNDS = 30
_LONGEST_STEP = 3.0
_SETTLED = 0.01
_STEP = 0.05
"""Of a coordinate, for slopes."""
_UNLIKELY = 7.0
"""Standard deviations from the mean of the figure beyond which there is no such person."""
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
    measures: Mapping[str, float], *, figure: str | None = None, name: str = "measured", nearest: bool = False
) -> MadeBody:
    """Makes the likeliest body that has given measures.

    Coordinates are found by least squares on the measures, which are taken on the mesh, and on the distance
    from the mean of the figure.

    Args:
        measures: By the names of `MEASURES`, cm.
        figure: ``women``, ``men`` or ``children``, by which is chosen what the measures leave open; adults
            near the default body when None, children below 148 cm.
        name: Of the body.
        nearest: Whether the nearest body is taken where none has these measures, instead of refusing them.

    Raises:
        InputError: A measure is unknown or out of range, or no body of the shapes has all of them together;
            the text says which come nearest.
    """
    if nearest:
        measures = _in_range(measures)
    _require_measures(measures)
    if figure is None and measures.get("height", 1e3) < CHILD_CM:
        figure = "children"
    space = ShapeSpace.default()
    mean, covariance = space.prior(figure)
    spread = np.linalg.cholesky(covariance + 1e-9 * np.eye(space.count))
    coordinates = _solve(space, measures, mean, spread)
    landmarks = Landmarks(space.vertices(coordinates))
    taken = {one: take(one, landmarks) for one in measures}
    if not nearest:
        _require_met(measures, taken)
    default = Body.default()
    body = Body(name, landmarks.vertices, default.faces, default.vertex_part, measurements_of(landmarks))
    return MadeBody(body, coordinates, taken)


def _solve(space: ShapeSpace, measures: Mapping[str, float], mean: Array, spread: Array) -> Array:
    """Coordinates (K,); they are sought as standard deviations from the mean of the figure."""
    exact = dict.fromkeys(measures, _EXACT_CM)
    away = _nearest(space, measures, exact, mean, spread)
    while np.linalg.norm(away) > _UNLIKELY and max(exact.values()) < _LOOSEST_CM:
        # No such person: what is the nearest that there might be?
        exact = {name: 4.0 * value for name, value in exact.items()}
        away = _nearest(space, measures, exact, mean, spread, away * (_UNLIKELY / np.linalg.norm(away)))
    return mean + spread @ away


def _nearest(
    space: ShapeSpace,
    measures: Mapping[str, float],
    exact: Mapping[str, float],
    mean: Array,
    spread: Array,
    start: Array | None = None,
) -> Array:
    """Standard deviations (K,) with the least sum of squares of themselves and of what the measures lack.

    The slopes of the measures are taken by differences once, and then mended after every step (Broyden).
    """
    wanted = np.array(list(measures.values()))
    loose = np.array([exact[name] for name in measures])
    away = np.zeros(space.count) if start is None else start
    if not len(wanted):
        return away
    unit = np.tensordot(spread.T.astype(np.float32), space.directions, axes=1)
    middle = space.base + np.tensordot(mean.astype(np.float32), space.directions, axes=1)

    def measured(vertices: Array) -> Array:
        landmarks = Landmarks(vertices - [0.0, vertices[:, 1].min(), 0.0])
        return np.array([take(name, landmarks) for name in measures])

    def vertices(at: Array) -> Array:
        return middle + np.tensordot(at.astype(np.float32), unit, axes=1)

    shape = vertices(away)
    now = measured(shape)
    slope = np.stack([(measured(shape + _STEP * one) - now) / _STEP for one in unit], axis=1)
    for _ in range(_MOST_ROUNDS):
        # min |x|^2 + |(slope (x - away) + now - wanted) / loose|^2
        gram = slope @ slope.T + np.diag(loose**2)
        target = slope.T @ np.linalg.solve(gram, wanted - now + slope @ away)
        step = target - away
        step *= min(1.0, _LONGEST_STEP / max(float(np.linalg.norm(step)), 1e-9))
        away = away + step
        before, now = now, measured(vertices(away))
        if np.linalg.norm(step) < _SETTLED:
            break
        slope = slope + np.outer(now - before - slope @ step, step) / (step @ step)
    return away


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


def _in_range(measures: Mapping[str, float]) -> dict[str, float]:
    """The measures, those that no person has as the nearest that one may have."""
    return {
        name: min(max(value, MEASURES[name].smallest), MEASURES[name].largest) if name in MEASURES else value
        for name, value in measures.items()
    }


def missed(wanted: Mapping[str, float], taken: Mapping[str, float]) -> list[str]:
    """The measures that a body has otherwise than they are wanted."""
    return [
        name
        for name, value in wanted.items()
        if abs(taken[name] - value) > max(TOLERANCE_CM, TOLERANCE * value)
    ]


def _require_met(wanted: Mapping[str, float], taken: Mapping[str, float]) -> None:
    if not missed(wanted, taken):
        return
    nearest = ", ".join(f"{name}={taken[name]:.1f}" for name in wanted)
    asked = ", ".join(f"{name}={value:g}" for name, value in wanted.items())
    raise InputError(
        f"No body has these measures together: {asked}. The nearest that one has: {nearest}. "
        "Give these, or leave one of the measures out."
    )
