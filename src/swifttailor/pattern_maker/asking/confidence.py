"""How far to trust what a network makes of a picture: beside pictures that it is known to be good with.

Two measures, either of which may tell a garment from something else:

``certainty``
    Mean over the tokens written of the logarithm of the probability of the likeliest one.
``familiarity``
    Logarithm of the density of what the vision transformer makes of the picture, among what it makes of
    pictures that the network was trained on: principal components with a normal distribution each, and one
    for all that is left (Tipping and Bishop 1999). Distances of this kind tell unknown input better than
    likelihoods of the output in other networks that write (Ren et al. 2023).

Which of them is used, and what is usual, was measured with the trained network (`calibration`).
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.errors import InputError

Measure = Literal["certainty", "familiarity"]
MEASURES: tuple[Measure, ...] = ("certainty", "familiarity")

FORMAT = "swifttailor confidence 1"
DOUBT = 0.02
"""Confidence below which a picture is doubted: so many of the validation pictures are, too."""
QUANTILES = 201
_MOST_COMPONENTS = 64


@dataclass(frozen=True)
class Confidence:
    """Of an answer to a picture."""

    value: float
    """0 to 1: the share of validation pictures of which the network was less sure."""
    measure: Measure
    """What it is based on."""
    certainty: float
    familiarity: float

    @property
    def doubtful(self) -> bool:
        """Whether the picture may not be one of a garment."""
        return self.value < DOUBT

    def to_json(self) -> dict[str, Any]:
        """For a report."""
        return asdict(self) | {"doubtful": self.doubtful}


@dataclass(frozen=True, eq=False)
class PictureSpace:
    """Where pictures to learn from lie among all that a vision transformer can make of pictures."""

    mean: Floats
    """(d,)"""
    directions: Floats
    """(k, d) orthonormal."""
    variances: Floats
    """(k,) along them."""
    rest: float
    """Variance along every other direction."""

    @staticmethod
    def fit(looks: NDArray[np.floating]) -> PictureSpace:
        """The space of pictures whose looks are (n, d).

        Raises:
            InputError: There are too few.
        """
        looks = looks.astype(np.float64)
        count, size = looks.shape
        if count < 8:
            raise InputError(f"There are {count} pictures to learn from; at least 8 are needed.")
        mean = looks.mean(axis=0)
        _, singular, directions = np.linalg.svd(looks - mean, full_matrices=False)
        variances = singular**2 / (count - 1)
        kept = max(1, min(_MOST_COMPONENTS, count // 4, size - 1))
        # What few pictures leave of the small components is less than there is: none is taken for nothing.
        rest = max(float(variances[kept:].sum()) / (size - kept), 1e-3 * float(variances.sum()) / size, 1e-12)
        return PictureSpace(mean, directions[:kept], np.maximum(variances[:kept], rest), rest)

    def familiarity(self, looks: NDArray[np.floating]) -> Floats:
        """(n,) logarithms of the density at looks (n, d)."""
        away = looks.astype(np.float64) - self.mean
        along = away @ self.directions.T
        left = np.maximum((away**2).sum(axis=1) - (along**2).sum(axis=1), 0.0)
        size, kept = len(self.mean), len(self.variances)
        spread = (along**2 / self.variances).sum(axis=1) + left / self.rest
        scale = np.log(self.variances).sum() + (size - kept) * np.log(self.rest) + size * np.log(2 * np.pi)
        return -(spread + scale) / 2


@dataclass(frozen=True, eq=False)
class Calibration:
    """What is usual for a trained network."""

    measure: Measure
    """Which tells better, of the two."""
    space: PictureSpace
    usual: dict[Measure, tuple[float, ...]]
    """Of the validation pictures, values in ascending order that divide them into equal parts."""
    pictures: int
    """Validation pictures."""
    told: dict[str, dict[Measure, float]]
    """By kind of picture that shows no garment, the probability that a validation picture has a higher value
    than one of these (area under the ROC curve): 0.5 is chance, 1 perfect."""
    doubted: dict[str, float]
    """By kind, the share that is doubted by `measure`."""

    def confidence(self, look: NDArray[np.floating], certainty: float) -> Confidence:
        """Of an answer.

        Args:
            look: (d,) what the network made of the picture, its places averaged.
            certainty: Of the answer.
        """
        values: dict[Measure, float] = {
            "certainty": certainty,
            "familiarity": float(self.space.familiarity(look[None])[0]),
        }
        return Confidence(rank(values[self.measure], self.usual[self.measure]), self.measure, **values)

    def to_json(self) -> str:
        """As it is written into model files."""
        space = {k: np.asarray(v, np.float32).tolist() for k, v in vars(self.space).items()}
        content = {k: v for k, v in vars(self).items() if k != "space"}
        return json.dumps({"format": FORMAT} | content | {"space": space}, allow_nan=False) + "\n"

    @staticmethod
    def from_json(text: str | bytes, source: str) -> Calibration:
        """Reads what `to_json` wrote.

        Args:
            text: The file.
            source: Its name, for messages.

        Raises:
            InputError: It is another file, or damaged.
        """
        try:
            content: Any = json.loads(text)
            if content.pop("format") != FORMAT:
                raise ValueError("another format")
            space = content.pop("space")
            rest = float(space.pop("rest"))
            arrays = {name: np.array(values, np.float64) for name, values in space.items()}
            usual = {name: tuple(float(v) for v in values) for name, values in content.pop("usual").items()}
            found = Calibration(space=PictureSpace(**arrays, rest=rest), usual=usual, **content)
            kept, size = found.space.directions.shape
            sound = found.space.mean.shape == (size,) and found.space.variances.shape == (kept,)
            sound &= set(usual) == set(MEASURES) and found.measure in MEASURES and all(usual.values())
            finite = all(np.isfinite(a).all() for a in (*arrays.values(), *map(np.array, usual.values())))
            if not (sound and finite and rest > 0 and (found.space.variances > 0).all()):
                raise ValueError("its parts do not belong together")
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            raise InputError(f"'{source}' does not say what is usual for the network: {error}.") from error
        return found


def rank(value: float, usual: tuple[float, ...] | Floats) -> float:
    """Share of the usual values that are below a value; between two of them, of both in proportion."""
    return float(np.interp(value, usual, np.linspace(0, 1, len(usual)), left=0.0, right=1.0))
