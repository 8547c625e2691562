"""What a target is, and how its inputs follow from a seed and a number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from random import Random

Feed = Callable[[Path], None]
"""Reads a file. A `SwiftTailorError` means that the file is refused; whatever else it raises is a fault."""


@dataclass(frozen=True)
class File:
    """An input: what is in a file, and its ending, by which some readers go."""

    data: bytes
    ending: str


@dataclass(frozen=True)
class Target:
    """A reader, the sound files that are damaged for it, and what reading one may take."""

    name: str
    about: str
    load_seeds: Callable[[], Sequence[File]]
    mutate: Callable[[File, Random], bytes]
    load_feed: Callable[[], Feed]
    """Loads what the reader needs, once for all inputs."""
    seconds: float = 2.0
    """Most processor time for one input."""
    megabytes: int = 512
    """Most memory that one input may add."""
    in_ci: int = 100
    """How many fresh inputs `make fuzz` feeds by default."""

    @cached_property
    def seeds(self) -> tuple[File, ...]:
        """The sound files."""
        return tuple(self.load_seeds())

    def input(self, seed: int, number: int) -> File:
        """The input of a number: it follows from the name, seed and number, and from the sound files."""
        random = Random(f"{self.name}/{seed}/{number}")
        chosen = random.choice(self.seeds)
        return File(self.mutate(chosen, random), chosen.ending)

    def kept(self, path: Path) -> File:
        """An input from a file, named by its ending among others."""
        endings = sorted({file.ending for file in self.seeds}, key=len)
        ending = next((e for e in reversed(endings) if path.name.endswith(e)), path.suffix)
        return File(path.read_bytes(), ending)
