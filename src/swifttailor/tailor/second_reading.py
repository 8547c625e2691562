"""A draft is drawn like the picture that it was read in, and read again.

By as much as that reads otherwise, the first reading was off: a network that takes this kind of sleeve for
wider than it is does so in the drawing of the draft, too, whose width is known. So what both readings have in
common, right or wrong, cancels, and the difference corrects the numbers of the design. That pays for pictures
that can be drawn alike: those of GarmentCodeData's look.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.looks import draw_look, plain_look
from swifttailor.parameter_reader.agreement import Design
from swifttailor.parameter_reader.reader import ParameterReader
from swifttailor.pattern import Pattern
from swifttailor.pattern_library.sought import Sought
from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.together import together
from swifttailor.tailor.looking import ReadsPictures
from swifttailor.tailor.protocols import Sewer
from swifttailor.tailor.reading import Wanted

EDGE_CM = 3.0
"""Edge length of the mesh that is drawn."""
SMALLEST, LARGEST = 256, 800
"""Pixels along each side of a drawing: as many as its picture has, within these."""
MOST_PLACES = 4.0
"""No number moves by more of its ranges: a reading that is so far off saw something else."""
BY_WORDS = 2.0
"""Where words move a number by so many ranges, it is theirs, and the picture does not move it back."""


@dataclass(frozen=True, eq=False)
class SecondReading:
    """Reads drafts as the pictures of an order were read."""

    sewer: Sewer
    """Around the default body."""
    reader: ReadsPictures

    def corrected(
        self, design: Design, pattern: Pattern, wanted: Wanted, parameters: ParameterReader
    ) -> list[Design]:
        """Designs with the numbers that the drawing would have to have to be read like the pictures.

        Args:
            design: What was read of the pictures, and of words with them.
            pattern: Its draft.
            wanted: With the pictures and what was read of them.
            parameters: Who read it.

        Returns:
            One, and one that goes half the way, in case the first is none that can be cut; none where the
            pictures cannot be drawn alike, or the draft cannot be sewn or is not seen.
        """
        first = wanted.part
        if first is None or first.design is None or not can_be_drawn_alike(wanted):
            return []
        second = self._read_again(pattern, wanted)
        if second is None or second.design is None:
            return []
        was, seems = first.design.middles(), second.design.middles()
        kept = _moved_by_words(wanted, first, parameters) if wanted.said else frozenset()
        off = {name: was[name] - seems[name] for name in was.keys() & seems.keys() - kept}
        return [_moved(design, off, parameters, share) for share in (1.0, 0.5)]

    def _read_again(self, pattern: Pattern, wanted: Wanted) -> PartReading | None:
        """What is read of a garment in drawings from where the pictures were taken."""
        try:
            prepared = self.sewer.prepare(pattern, edge_length=EDGE_CM, resolution=None)
            garment = self.sewer.decode(prepared, self.sewer.predict([prepared])[0])
        except SwiftTailorError:
            return None
        seen = []
        for picture in wanted.pictures:
            look, size = plain_look(picture.reading.face), max(picture.pixels.shape[:2])
            drawing = draw_look(garment, Body.default(), look, min(max(size, SMALLEST), LARGEST))
            read = self.reader.read(drawing)
            part = "upper" if wanted.part is None else wanted.part.part
            found = next((one for one in read.parts if one.part == part), None)
            if found is None:
                return None
            seen.append(found)
        return together(seen)


def can_be_drawn_alike(wanted: Wanted) -> bool:
    """Whether all pictures are like GarmentCodeData's, from the front or the back."""
    read = [picture.reading for picture in wanted.pictures]
    return bool(read) and all(one.is_plain and one.face != "side" for one in read)


def _moved_by_words(wanted: Wanted, first: PartReading, parameters: ParameterReader) -> frozenset[str]:
    """Numbers that would be others without the words."""
    with_words = parameters.shares(wanted.sought, first.design)
    without = parameters.shares(Sought.of_reading(first), first.design)
    rows = zip(parameters.parameters, with_words, without, strict=True)
    return frozenset(
        one.name for one, a, b in rows if one.is_number and abs(float(np.arange(len(a)) @ (a - b))) > BY_WORDS
    )


def _moved(
    design: Design, off: Mapping[str, float], parameters: ParameterReader, share: float = 1.0
) -> Design:
    """With each number moved by so many of its ranges, or a share of them, to the middle of one."""
    found = dict(design)
    for one in parameters.parameters:
        if one.is_number and one.name in found and one.name in off:
            by = share * float(np.clip(off[one.name], -MOST_PLACES, MOST_PLACES))
            place = round(one.place_of(found[one.name]) + by)
            found[one.name] = one.values[int(np.clip(place, 0, len(one.values) - 1))]
    return found
