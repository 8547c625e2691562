"""#Sampling: how many patterns must be generated until one can be made into a garment."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import Pattern, Severity, check_pattern

Gate = Literal["decode", "check", "mesh"]
GATES: tuple[Gate, ...] = ("decode", "check", "mesh")
MAX_ATTEMPTS = 20
"""As the paper's appendix has it; an input that gives nothing counts as so many."""


@dataclass(frozen=True)
class Attempts:
    """What came of an input."""

    count: int
    """Of the patterns that were generated."""
    pattern: Pattern | None
    """The first sound one, which is then evaluated; None where there was none."""
    failures: tuple[tuple[Gate, str], ...]
    """Where and why the others failed, in order."""


def make_until_sound(
    generate: Callable[[int], Pattern], *, limit: int = MAX_ATTEMPTS, edge_length: float = 2.0
) -> Attempts:
    """Generates patterns until one passes every gate.

    The gates: it decodes (`generate` returns), the checker finds no error, and its panels can be meshed and
    stitched to a surface in which no edge has more than two faces. These stand for what GarmentCode checks
    before it simulates (docs/evaluation.md).

    Args:
        generate: Makes attempt number k, from 0; raises a `SwiftTailorError` where nothing can be decoded.
        limit: Of the attempts.
        edge_length: Of the mesh, cm.
    """
    failures: list[tuple[Gate, str]] = []
    for k in range(limit):
        try:
            pattern = generate(k)
        except SwiftTailorError as error:
            failures.append(("decode", str(error)))
            continue
        fault = first_fault(pattern, edge_length)
        if fault is None:
            return Attempts(k + 1, pattern, tuple(failures))
        failures.append(fault)
    return Attempts(limit, None, tuple(failures))


@dataclass(frozen=True)
class AttemptsSummary:
    """#Sampling over many inputs."""

    mean: float
    """Of the attempts; those without success count as the limit."""
    inputs: int
    succeeded: int
    failures: dict[Gate, int]
    """Failed attempts at each gate."""


def summarize_attempts(attempts: Sequence[Attempts]) -> AttemptsSummary:
    """Puts inputs together.

    Raises:
        InputError: There are none.
    """
    if not attempts:
        raise InputError("No input was tried, so there is no mean number of attempts.")
    gates = [gate for a in attempts for gate, _ in a.failures]
    return AttemptsSummary(
        mean=sum(a.count for a in attempts) / len(attempts),
        inputs=len(attempts),
        succeeded=sum(a.pattern is not None for a in attempts),
        failures={gate: gates.count(gate) for gate in GATES},
    )


def first_fault(pattern: Pattern, edge_length: float = 2.0) -> tuple[Gate, str] | None:
    """The gate that a decoded pattern fails at and why; None where it can be made into a garment."""
    errors = [f for f in check_pattern(pattern) if f.severity is Severity.ERROR]
    if errors:
        return "check", f"{errors[0].code}: {errors[0].message}"
    try:
        mesh = mesh_pattern(pattern.canonical(), edge_length)
    except SwiftTailorError as error:
        return "mesh", str(error)
    crowded = topology(mesh.faces, mesh.vertex_count).nonmanifold_edges
    if crowded:
        return "mesh", f"{crowded} edges of the stitched mesh have more than two faces."
    return None
