"""What a tailor calls of the networks that write and sew, for those who bring one of their own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.pattern import Pattern
    from swifttailor.pattern_maker.maker import Request, WrittenPattern


class PatternWriter(Protocol):
    """Writes patterns, as `PatternMaker` does.

    A writer may have an attribute `card`, a dictionary; of what it says, ``model``, ``parameters``, ``data``,
    ``training`` and ``validation`` are told in every report.
    """

    def generate_all(
        self, requests: Sequence[Request], /, *, seed: Sequence[int], temperature: float, draw: int
    ) -> Sequence[WrittenPattern]:
        """Writes one pattern for each request.

        Called once for each attempt with all garments that are still wanting: several times for an order
        whose first patterns have faults.

        Args:
            requests: Each has a `text`, an `image` of shape (h, w, 3), sRGB of bytes, or both; or an `edit`,
                the pattern to change, and a text that says how.
            seed: One for each request.
            temperature: How freely to draw: 0 is the likeliest. Each attempt is made at 0.15 more.
            draw: Number of the attempt, from 0. The same seed and draw give the same pattern.

        Returns:
            A pattern for each request, around the default body, in cm. ``WrittenPattern(pattern)`` is enough:
            the tailor checks it, alters it to the text, and asks again where it has faults.

        Raises:
            SwiftTailorError: The requests cannot be answered at all.
        """
        ...


class Sewer(Protocol):
    """Makes garments of patterns, as `GarmentSewer` does.

    A sewer may have an attribute `card`, as a `PatternWriter`.
    """

    def prepare(self, pattern: Pattern, /, *, edge_length: float, resolution: int | None) -> Any:
        """Gets a pattern ready to be sewn: meshes it, for instance.

        Called for each pattern that a check finds sound, before it is known whether it will be taken; what
        cannot be prepared is written again.

        Args:
            pattern: In any order of its panels.
            edge_length: That the mesh should have, cm.
            resolution: Of images, where there are any; as is best when None.

        Returns:
            Whatever the other two need.

        Raises:
            SwiftTailorError: The pattern cannot be sewn.
        """
        ...

    def predict(self, prepared: Sequence[Any], /) -> Sequence[Any]:
        """Runs the network on a few patterns together (up to 8).

        Args:
            prepared: What `prepare` returned.

        Returns:
            For each whatever `decode` needs.
        """
        ...

    def decode(self, prepared: Any, predicted: Any, /) -> Garment:
        """Makes a garment of what the network predicts.

        Args:
            prepared: What `prepare` returned.
            predicted: What `predict` returned for it.

        Returns:
            The garment; what its report says is kept.

        Raises:
            SwiftTailorError: There is none.
        """
        ...
