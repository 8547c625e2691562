"""Which pictures are photographs of people, and what is looked at in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.cloth_on_legs import (
    before_ground,
    reach_of,
    with_legs_before_ground,
    with_legs_of_joints,
)
from swifttailor.picture_reader.laid_heads import LaidHeads
from swifttailor.picture_reader.leg_joints import LegJoints
from swifttailor.picture_reader.person_finder import Person, PersonFinder
from swifttailor.picture_reader.plain_pictures import mostly_one_colour_around
from swifttailor.picture_reader.reading import PartReading, PictureReading
from swifttailor.picture_reader.said import LEAST_PRESENT
from swifttailor.picture_reader.seen_hems import with_hems_near_knees
from swifttailor.picture_reader.view import Square
from swifttailor.picture_reader.worn_heads import WornHeads
from swifttailor.picture_reader.worn_regions import on_their_places
from swifttailor.picture_reader.worn_signs import WornSigns

MOST_DESIGNED = 0.255
"""Of a photograph the design is read no more surely than this by a network that has learnt to say none."""
SURELY_SOMEBODY = 0.8
"""How sure it has to be that somebody is there where networks for clothes see nobody, or clothes alone."""
_LEAST_OF_SHOWN = 0.1
"""Of what stands out from a plain ground: who covers less is nobody, but a knee or a foot."""
_LEAST_LEFT = 0.1
"""Of the mask of the lower garment: where less of it lies outside the upper one's, neither hides any."""


def says_no_design(read: PictureReading) -> bool:
    """Whether a network that has learnt to say no design of photographs takes a picture for one."""
    designs = [part.design for part in read.parts if part.design is not None]
    return bool(designs) and max(design.certainty for design in designs) <= MOST_DESIGNED


def surely_somebody(pixels: Pixels, people: Callable[[], PersonFinder] | None) -> bool:
    """Whether somebody large is in a picture (h, w, 3)."""
    person = people().find(pixels, small=False) if people else None
    return person is not None and person.certainty >= SURELY_SOMEBODY


def as_photograph(
    whole: tuple[Pixels, Square],
    of_all: PictureReading,
    people: Callable[[], PersonFinder] | None,
    read: Callable[..., PictureReading],
    heads: Callable[[], WornHeads] | None = None,
    looks_real: Callable[[], bool] = lambda: False,
    names: Callable[[], LaidHeads] | None = None,
) -> PictureReading | None:
    """What a photograph of people shows: of the surest of them, cut out; before a plain ground as it is, too.

    Args:
        whole: The picture and the square around it.
        of_all: What is read of that.
        people: Gives what cuts people out.
        read: Reads one or more views of the picture, each pixels and a square; the first tells where things
            are. `chest` and `legs` are looked at from nearer, `signs` are other witnesses.
        heads: Gives what has seen nothing but photographs.
        looks_real: Whether the picture looks like a photograph; asked where `of_all` tells of none.
        names: Gives what tells, on the trunk of `heads`, what clothes are called.

    Returns:
        None where it is none, or nobody can be cut out.
    """
    if of_all.parts and not says_no_design(of_all) and not looks_real():
        return None
    pixels, _ = whole
    person = people().find(pixels) if people else None
    told = heads() if heads and person else None
    called = names() if names and told else None
    if of_all.parts and of_all.figures == "one" and mostly_one_colour_around(pixels):
        if person is None or _is_a_bit(person, pixels):
            return replace(of_all, parts=_before_ground(of_all, pixels), is_photograph=True)
        cut = person.cut_out(pixels)
        signs = WornSigns.of(pixels, person, cut, told, called)
        shown = _within(read(cut, whole, chest=person.chest(cut[0]), signs=signs), person)
        return replace(_with_legs(shown, person), figures="one", is_photograph=True)
    unseen = not of_all.parts or of_all.figures == "none"
    if person is None or (unseen and person.certainty < SURELY_SOMEBODY):
        return None
    cut = person.cut_out(pixels)
    signs = WornSigns.of(pixels, person, cut, told, called)
    shown = read(cut, chest=person.chest(cut[0]), legs=person.legs(cut[0]), signs=signs)
    if not of_all.parts and not says_no_design(shown):
        return None
    figures = "several" if of_all.figures == "several" else "one"
    worn = with_hems_near_knees(_within(shown, person), LegJoints.of(person.joints))
    return replace(_with_legs(worn, person), figures=figures, is_photograph=True)


def _within(read: PictureReading, person: Person) -> PictureReading:
    """What is worn is nowhere but where somebody is, and what hangs over trousers hides them."""
    masks = {part.part: part.mask * person.mask for part in read.parts}
    hood = any(part.certainty_of("hood", "hood") > LEAST_PRESENT for part in read.parts)
    masks = on_their_places(masks, person.mask, person.joints, hood=hood)
    if len(masks) == 2:
        shown = np.where(masks["upper"] > 0.5, np.float32(0), masks["lower"])
        if (shown > 0.5).sum() > _LEAST_LEFT * (masks["lower"] > 0.5).sum():
            masks["lower"] = shown
    return replace(read, parts=tuple(replace(part, mask=masks[part.part]) for part in read.parts))


def _with_legs(read: PictureReading, person: Person) -> PictureReading:
    """What is read, whose lower garment is seen on the legs where it is hardly pointed at.

    Where masks end tells of hems (`with_hems_near_knees`), so these are filled afterwards.
    """
    masks = {part.part: part.mask for part in read.parts}
    free = np.where(masks.get("upper", np.float32(0)) > 0.5, np.float32(0), person.mask)
    parts = [
        replace(part, mask=with_legs_of_joints(part.mask, free, person.joints, reach_of(part)))
        if part.part == "lower"
        else part
        for part in read.parts
    ]
    return replace(read, parts=tuple(parts))


def _is_a_bit(person: Person, pixels: Pixels) -> bool:
    """Whether what is hardly taken for somebody before a plain ground is a small bit of what is there."""
    if person.certainty >= SURELY_SOMEBODY:
        return False
    return bool((person.mask > 0.5).sum() < _LEAST_OF_SHOWN * before_ground(pixels).sum())


def _before_ground(read: PictureReading, pixels: Pixels) -> tuple[PartReading, ...]:
    """What is read before a plain ground where nobody is found: of legs with all that they show."""
    return tuple(
        replace(part, mask=with_legs_before_ground(part.mask, pixels, reach_of(part)))
        if part.part == "lower" and len(read.parts) == 1
        else part
        for part in read.parts
    )
