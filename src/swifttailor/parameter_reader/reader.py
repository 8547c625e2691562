"""Reads design parameters out of what is known of a garment."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import InputError
from swifttailor.networks.model_file import GRAPH, ModelKind, open_model
from swifttailor.parameter_reader.agreement import Design, agreeing_design
from swifttailor.parameter_reader.features import features_of
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.labels import labels_checksum
from swifttailor.picture_reader.seen_design import SeenDesign, mixed
from swifttailor.programs.read_parameter import ReadParameter

SHIPPED = Path(__file__).with_name("parameter_reader.onnx")
INPUTS, OUTPUTS = ("features",), ("logits",)
KIND = ModelKind("parameter reader", "swifttailor parameter-reader 1", 2**26, ({GRAPH: (INPUTS, OUTPUTS)},))
SEEN = 0.5
"""How much what a picture shows of a parameter counts; the rest is what follows from its reading."""


@dataclass(frozen=True, eq=False)
class ParameterReader:
    """Reads what is known of a garment."""

    session: Any
    """Of onnxruntime."""
    parameters: tuple[ReadParameter, ...]
    card: dict[str, Any]
    """What it was trained on, and how good it is."""

    @staticmethod
    def load(weights: Path | str | None = None, *, threads: int = 1) -> ParameterReader:
        """Opens a model file.

        Args:
            weights: The file; the one that comes with the package when None.
            threads: CPU cores for the network.

        Raises:
            InputError: There is no such file, or it is damaged or another.
        """
        model = open_model(SHIPPED if weights is None else weights, KIND, threads=threads)
        with model.says("what it reads"):
            parameters = tuple(ReadParameter.from_json(one) for one in model.about["parameters"])
        count = sum(len(one.values) for one in parameters)
        model.require(
            {
                "what it is told": (model.about.get("labels_sha256"), labels_checksum()),
                "how much it is told": (
                    model.shape_given(GRAPH, "features")[1],
                    len(features_of(Sought.nothing())),
                ),
                "the number of values": (model.shape_made(GRAPH, "logits")[1], count),
            }
        )
        return ParameterReader(model.sessions[GRAPH], parameters, model.about.get("card", {}))

    def shares(self, sought: Sought, seen: SeenDesign | None = None) -> list[NDArray[np.float64]]:
        """How likely each value of each parameter is.

        Args:
            sought: What is known of a garment.
            seen: What a picture shows of it, where its reader reads design parameters.

        Returns:
            For each of `parameters` (values,); they add up to 1.

        Raises:
            InputError: The network's numbers are not finite: its weights are damaged.
        """
        logits = self.session.run(None, {"features": features_of(sought)[None]})[0][0].astype(np.float64)
        if not np.isfinite(logits).all():
            raise InputError("What the parameter reader says are no finite numbers: its weights are damaged.")
        found, first = [], 0
        for one in self.parameters:
            part = logits[first : first + len(one.values)]
            first += len(one.values)
            part = np.exp(part - part.max())
            found.append(part / part.sum())
        return found if seen is None else self._with(found, seen)

    def _with(self, found: list[NDArray[np.float64]], seen: SeenDesign) -> list[NDArray[np.float64]]:
        """The same, heard together with what was seen; a parameter that is not read in pictures stays."""
        shown = dict(zip((one.name for one in seen.parameters), seen.shares, strict=True))
        own = {one.name: one for one in seen.parameters}
        return [
            mixed([mine, shown[one.name]], [1 - SEEN, SEEN]) if own.get(one.name) == one else mine
            for one, mine in zip(self.parameters, found, strict=True)
        ]

    def designs(self, sought: Sought, seen: SeenDesign | None = None, *, seed: int = 0) -> Iterator[Design]:
        """Designs that what is known may mean, endlessly: the likeliest, then others, bolder by and by.

        The first has the likeliest value of each parameter, but for choices with which the panels are
        likelier (`agreeing_design`).

        Args:
            sought: What is known of a garment.
            seen: As in `shares`.
            seed: Of the others.
        """
        shares = self.shares(sought, seen)
        likeliest = {p.name: _likeliest(p, s) for p, s in zip(self.parameters, shares, strict=True)}
        yield agreeing_design(likeliest, self.parameters, shares, sought)
        chance, number = np.random.default_rng(seed), 1
        while True:
            yield {p.name: _drawn(p, s, chance, number) for p, s in zip(self.parameters, shares, strict=True)}
            number += 1


def _likeliest(parameter: ReadParameter, shares: NDArray[np.float64]) -> Any:
    """Of a number the median, which is nearest on average; of choices the likeliest."""
    k = _median(shares) if parameter.is_number else int(shares.argmax())
    return parameter.values[k]


def _drawn(
    parameter: ReadParameter, shares: NDArray[np.float64], chance: np.random.Generator, number: int
) -> Any:
    """Numbers stay the likeliest, choices are drawn."""
    if parameter.is_number:
        return parameter.values[_median(shares)]
    sharper = shares ** (1 + 3 / number)
    return parameter.values[int(chance.choice(len(shares), p=sharper / sharper.sum()))]


def _median(shares: NDArray[np.float64]) -> int:
    return min(int(np.searchsorted(np.cumsum(shares), 0.5)), len(shares) - 1)
