"""The pictures of an order, read, and which of the garments in them is wanted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol, get_args

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.describing.claims import Claim
from swifttailor.errors import NothingSeenError
from swifttailor.picture_reader.reading import PartReading, PictureReading, Statement
from swifttailor.picture_reader.together import together
from swifttailor.render.picture_file import read_picture
from swifttailor.render.pixels import require_picture
from swifttailor.tailor.order import Image, Part

PARTS: tuple[Part, ...] = get_args(Part)[:3]
_WHOLE_KINDS = ("dress", "jumpsuit")
_TOLD = 0.99
"""How sure it is what a person says of a picture."""
_LEAST_SEEN = {"upper": 0.3, "lower": 0.6}
"""How high what an edge cuts off has to be, as a share of how high the other garment is seen."""
_AT_EDGE = 0.02
"""Of the height of a picture."""


class ReadsPictures(Protocol):
    """What a tailor calls to read a picture, as `picture_reader.PictureReader` does."""

    def read(self, pixels: Pixels) -> PictureReading:
        """What a picture (h, w, 3) shows."""
        ...


@dataclass(frozen=True, eq=False)
class SeenPicture:
    """A picture, and what was read of it."""

    pixels: Pixels
    """(h, w, 3) sRGB, row 0 at the top."""
    reading: PictureReading
    name: str = ""
    """Of its file; empty where it came as an array."""


def look_at(image: Image | SeenPicture, reader: ReadsPictures) -> SeenPicture:
    """Reads a picture; one that was read is left as it is.

    Raises:
        InputError: It is no picture.
    """
    if isinstance(image, SeenPicture):
        return image
    if isinstance(image, np.ndarray):
        require_picture(image)
        return SeenPicture(image, reader.read(image))
    pixels = read_picture(image)
    return SeenPicture(pixels, reader.read(pixels), str(getattr(image, "name", image)))


def parts_seen(pictures: Sequence[SeenPicture]) -> tuple[Part, ...]:
    """The parts of the body on which all pictures show a garment, that which covers most first.

    Not those of which an edge of a picture leaves little beside another: nobody can tell what they are.
    """
    if not pictures or any(one.reading.figures == "none" for one in pictures):
        return ()
    covers: dict[str, list[float]] = {}
    for one in pictures:
        for part in one.reading.parts:
            covers.setdefault(part.part, []).append(float((part.mask > 0.5).mean()))
    seen = [name for name, shares in covers.items() if len(shares) == len(pictures)]
    seen = [name for name in seen if not any(_is_cut_off(one, name) for one in pictures)] or seen
    seen.sort(key=lambda name: -sum(covers[name]))
    return tuple(name for name in seen if name in PARTS)


def parts_cut_off(pictures: Sequence[SeenPicture]) -> tuple[Part, ...]:
    """The parts on which a garment is seen of which an edge of a picture leaves little."""
    read = [{part.part for part in one.reading.parts} for one in pictures]
    found = set.intersection(*read).difference(parts_seen(pictures)) if read else set()
    return tuple(name for name in PARTS if name in found)


def _is_cut_off(picture: SeenPicture, name: str) -> bool:
    """Whether the lower edge leaves little of what covers the legs, or the upper one of what is above.

    So it is where beside another garment nothing can be set off of it.
    """
    rows = {one.part: np.flatnonzero((one.mask > 0.5).any(axis=1)) for one in picture.reading.parts}
    own, other = rows[name], rows.get("upper" if name == "lower" else "lower")
    if other is None or not len(own) or not len(other):
        return not len(own) and other is not None and len(other) > 0
    high, share = np.ptp(own) + 1, _LEAST_SEEN[name] * (np.ptp(other) + 1)
    last = len(picture.pixels) - 1
    margin = _AT_EDGE * last
    at_edge = own[-1] >= last - margin if name == "lower" else own[0] <= margin
    return bool(at_edge and high < share)


def part_wanted(pictures: Sequence[SeenPicture], part: Part | None) -> PartReading:
    """What the pictures say of the garment that is wanted.

    Args:
        pictures: At least one, all of the same garment.
        part: Where it is worn; that which covers most when None.

    Raises:
        NothingSeenError: No garment is seen there.
    """
    seen = parts_seen(pictures)
    if (
        part in PARTS
        and part not in seen
        and all(any(p.part == part for p in o.reading.parts) for o in pictures)
    ):
        seen = (*seen, part)  # little of it, but asked for
    name = part
    if part is None or (part == "whole" and "upper" not in seen):
        name = next(iter(seen), None)
    elif part == "whole":
        name = "upper"
    if name not in seen:
        where = "on this part of the body" if seen else "in the picture"
        shown = f" What is seen: {', '.join(seen)}." if seen else ""
        raise NothingSeenError(
            f"No garment was found {where}.{shown} Give a picture that one person in clothes, or one "
            "garment, fills, or say in words what is wanted."
        )
    found = together([next(p for p in one.reading.parts if p.part == name) for one in pictures])
    return _as_whole(found) if part == "whole" else found


def _as_whole(part: PartReading) -> PartReading:
    """Read as one garment that covers both parts of the body."""
    sure = {kind: part.certainty_of("kind", kind) for kind in _WHOLE_KINDS}
    if not any(sure.values()):
        has_legs = any(s.claim.name in ("legs", "leg_hem") and s.certainty > 0.5 for s in part.statements)
        sure["jumpsuit" if has_legs else "dress"] = 1.0
    kind = Statement(Claim("kind", max(sure, key=lambda name: sure[name])), _TOLD)
    rest = tuple(s for s in part.statements if s.claim.name != "kind")
    return replace(part, statements=(kind, *rest))
