"""Which pictures are photographs of people, and what is looked at in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.person_finder import PersonFinder
from swifttailor.picture_reader.plain_pictures import mostly_one_colour_around
from swifttailor.picture_reader.reading import PictureReading
from swifttailor.picture_reader.view import Square

MOST_DESIGNED = 0.235
"""Of a photograph the design is read no more surely than this by a network that has learnt to say none."""
SURELY_SOMEBODY = 0.8
"""How sure it has to be that somebody is there where networks for clothes see nobody, or clothes alone."""


def says_no_design(read: PictureReading) -> bool:
    """Whether a network that has learnt to say no design of photographs takes a picture for one."""
    designs = [part.design for part in read.parts if part.design is not None]
    return bool(designs) and max(design.certainty for design in designs) <= MOST_DESIGNED


def surely_somebody(pixels: Pixels, people: Callable[[], PersonFinder] | None) -> bool:
    """Whether somebody large is in a picture (h, w, 3)."""
    person = people().find(pixels, small=False) if people else None
    return person is not None and person.certainty >= SURELY_SOMEBODY


def as_photograph(
    pixels: Pixels,
    of_all: PictureReading,
    people: Callable[[], PersonFinder] | None,
    read: Callable[[Pixels, Square], PictureReading],
) -> PictureReading | None:
    """What a photograph of people shows: of the surest of them, cut out; before a plain ground as it is.

    Args:
        pixels: (h, w, 3).
        of_all: What is read of all of it.
        people: Gives what cuts people out.
        read: Reads a cut-out in a square of it.

    Returns:
        None where nobody can be cut out.
    """
    if of_all.figures == "one" and mostly_one_colour_around(pixels):
        return replace(of_all, is_photograph=True)
    person = people().find(pixels) if people else None
    if person is None or (of_all.figures == "none" and person.certainty < SURELY_SOMEBODY):
        return None
    figures = "several" if of_all.figures == "several" else "one"
    return replace(read(*person.cut_out(pixels)), figures=figures, is_photograph=True)
