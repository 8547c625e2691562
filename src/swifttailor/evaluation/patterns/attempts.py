"""#Sampling: how many patterns must be generated until one can be made into a garment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from swifttailor.errors import InputError, SwiftTailorError
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import Pattern, Severity, check_pattern

Gate = Literal["decode", "check", "mesh"]
GATES: tuple[Gate, ...] = get_args(Gate)
MAX_ATTEMPTS = 20
"""As the paper's appendix has it; an input that gives nothing counts as so many."""

Fault = tuple[Gate, str]


@dataclass(frozen=True)
class Attempts:
    """What came of an input."""

    count: int
    """Of the patterns generated until one was sound, that one included; the limit where none was."""
    sound: bool
    """Whether one was."""
    failures: tuple[Fault, ...]
    """Where and why the others failed, in order."""


def attempts_of(faults: Sequence[Fault | None], limit: int = MAX_ATTEMPTS) -> Attempts | None:
    """Counts the patterns of one input.

    Args:
        faults: Of the patterns in the order in which they were generated: from `first_fault`, or
            ``("decode", why)`` where nothing was decoded.
        limit: Of the attempts.

    Returns:
        None where it takes more patterns than these to know.
    """
    failures: list[Fault] = []
    for fault in faults[:limit]:
        if fault is None:
            return Attempts(len(failures) + 1, True, tuple(failures))
        failures.append(fault)
    return Attempts(limit, False, tuple(failures)) if len(failures) == limit else None


def until_sound(patterns: Sequence[Pattern], edge_length: float = 2.0) -> int:
    """How many of the patterns that were made for an answer it took until one could be made into a garment.

    That is the paper's #Sampling of a method that may make further patterns for other reasons.

    Args:
        patterns: In the order in which they were made, at least one.
        edge_length: See `first_fault`.

    Returns:
        That one included; the number of all where there is none.
    """
    count = 0
    for pattern in patterns:
        count += 1
        if first_fault(pattern, edge_length) is None:
            break
    return count


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
        succeeded=sum(a.sound for a in attempts),
        failures={gate: gates.count(gate) for gate in GATES},
    )


def first_fault(pattern: Pattern, edge_length: float = 2.0) -> Fault | None:
    """The gate that a decoded pattern fails at and why; None where it can be made into a garment.

    The gates: the checker finds no error, and the panels can be meshed and stitched to a surface in which no
    edge has more than two faces. With decoding before them they stand for what GarmentCode checks before it
    simulates (docs/evaluation.md).

    Args:
        pattern: As it was decoded.
        edge_length: Of the mesh, cm.
    """
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
