"""Orders, read: what their texts and pictures ask for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.describing.differences import Change, Gain
from swifttailor.errors import InputError, NothingAskedError, NothingSeenError
from swifttailor.pattern_maker.asking.framing import Framing, frame_figure
from swifttailor.picture_reader.reading import PartReading
from swifttailor.render.picture_file import read_picture
from swifttailor.tailor.looking import ReadsPictures, SeenPicture, look_at, part_wanted, parts_cut_off
from swifttailor.tailor.order import NO_READER, Order, one_line
from swifttailor.tailor.picture_color import color_taken
from swifttailor.tailor.picture_print import print_taken
from swifttailor.tailor.picture_words import in_words, over_trousers
from swifttailor.tailor.reading import Wanted, facts_of
from swifttailor.tailor.seen_wishes import not_overruled, seen_wishes
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.no_garment import asks_for_none
from swifttailor.wishes.heard import Heard
from swifttailor.wishes.instructions.hearing_changes import hear_instruction
from swifttailor.wishes.reader import SURE, Wish, WishReader
from swifttailor.wishes.wearers.wearer_words import hear_wearer

_UNREAD = (
    "The picture was shown to PatternMaker and not read: this version comes without weights of a picture "
    "reader, so nothing was altered to it."
)
_NOT_READ = "A garment in a picture can be chosen only where patterns are altered: leave part out."
_UNSEEN_OF_LAID = frozenset({"fit"})
"""How close clothes are is not seen where nobody wears them: whatever lies flat is wide."""
_FRAMING_NOTES = {
    Framing.KEPT: (),
    Framing.CROPPED: ("The picture was cropped to its figure: the background is plain.",),
    Framing.BUSY: (
        "The background of the picture is not plain, so it was used whole; the network knows people and "
        "garments before plain backgrounds.",
    ),
    Framing.EMPTY: ("Nothing stands out from the background of the picture; it was used whole.",),
}


def read_order(order: Order, reader: WishReader | None, eyes: ReadsPictures | None = None) -> Wanted:
    """Reads what an order asks for.

    Args:
        order: What is wanted.
        reader: Of the text; None where nothing is to be altered.
        eyes: Reads the pictures; None where nothing is to be altered, or there are none.

    Raises:
        InputError: A picture cannot be read, or there is nothing to read it with.
        NothingSeenError: There is no garment in a picture, and no text.
        NothingAskedError: A text asks for none.
    """
    wanted = _read_order(order, reader, eyes)
    if reader is None or order.body is not None or not one_line(order.text):
        return wanted
    return replace(wanted, warnings=(*wanted.warnings, *_of_wearer(order)))


def _of_wearer(order: Order) -> tuple[str, ...]:
    """What of the body that the text asks for is otherwise than it says."""
    heard = hear_wearer(order.text, instruction=order.edit is not None)
    lacking = "" if heard.wearer is None else heard.wearer.not_had
    return (*heard.notes, lacking) if lacking else heard.notes


def _read_order(order: Order, reader: WishReader | None, eyes: ReadsPictures | None) -> Wanted:
    if reader is None or eyes is None or not order.images:
        if order.images and (order.part or any(isinstance(one, SeenPicture) for one in order.images)):
            raise InputError(NO_READER if reader is not None else _NOT_READ)
        image, notes = _picture(order)
        if reader is not None and order.images:
            notes = (*notes, _UNREAD)
        if reader is None:
            return Wanted(order, order.words, image, notes=notes)
        heard = _heard(order, reader)
        described = bool(one_line(order.text)) and order.edit is None and order.source != "writer"
        if described and not order.images and (why := asks_for_none(heard, " ".join(order.words.split()))):
            raise NothingAskedError(why)
        return Wanted(order, heard.text, image, heard.sure, heard.likely, notes, heard=heard)
    heard = _heard(order, reader)
    text, sure, likely = heard.text, heard.sure, heard.likely
    pictures = tuple(look_at(one, eyes) for one in order.images)
    try:
        part = part_wanted(pictures, order.part)
    except NothingSeenError as error:
        if not order.text.strip():
            raise
        doubt = (str(error),)
        return Wanted(order, text, None, sure, likely, pictures=pictures, warnings=doubt, heard=heard)
    kept, gone = not_overruled(seen_wishes(part), (*sure, *likely))
    photographs = all(one.reading.is_photograph for one in pictures)
    if photographs and order.source in ("both", "drafts") and order.edit is None:
        own = frozenset(w.change for w in (*sure, *likely))
        named = heard.kind is not None
        return _put_into_words(order, reader, pictures, part, gone, named=named, said=own)
    image, notes = _shown(pictures[0], order.crop)
    notes = (*notes, *_left_out(pictures, order))
    sure = (*sure, *(w for w in kept if w.certainty >= SURE))
    likely = (*likely, *(w for w in kept if w.certainty < SURE))
    doubts, color = _doubts(pictures), color_taken(pictures[0], part.part, heard)
    wanted = Wanted(order, text, image, sure, likely, notes, pictures, part, kept, gone, doubts, heard)
    return replace(wanted, seen_color=color, seen_print=print_taken(pictures[0], part.part, heard))


def _put_into_words(
    order: Order,
    reader: WishReader,
    pictures: tuple[SeenPicture, ...],
    part: PartReading,
    gone: tuple[Wish, ...],
    *,
    named: bool,
    said: frozenset[Change],
) -> Wanted:
    """An order whose pictures are photographs, as if their words had been typed beside the text."""
    names = frozenset(w.change.claim.name for w in gone if isinstance(w.change, Gain))
    if any(picture.reading.is_laid for picture in pictures):
        names |= _UNSEEN_OF_LAID
    worn = (other for picture in pictures for other in picture.reading.parts)
    words = in_words(part, names, named=named, over=over_trousers(part, worn))
    typed = [order.text.strip().rstrip(".,"), words] if named else [words, order.text.strip()]
    heard = _heard(replace(order, text=", ".join(filter(None, typed))), reader)
    notes = (f"The picture was put into words: {words}.", *_left_out(pictures, order))
    doubts, color = _doubts(pictures), color_taken(pictures[0], part.part, heard)
    return Wanted(
        order,
        heard.text,
        None,
        heard.sure,
        heard.likely,
        notes,
        pictures,
        overruled=gone,
        warnings=doubts,
        heard=heard,
        seen_color=color,
        seen_print=print_taken(pictures[0], part.part, heard),
        in_words=part,
        worded=tuple([w for w in (*heard.sure, *heard.likely) if w.change not in said]),
    )


def _heard(order: Order, reader: WishReader) -> Heard:
    """The text of an order, as an instruction where there is a pattern to edit."""
    # Who wears it is heard by `wearing.body_wanted`.
    wearer = hear_wearer(order.words, instruction=order.edit is not None)
    rest = wearer.rest
    if order.edit is None:
        heard = hear_description(rest, reader, alone=not order.images)
        # What is still told of a body is not refused where there is one for it.
        lacks = tuple([lack for lack in heard.lacks if wearer.wearer is None or lack.what != "bodies"])
        return heard if lacks == heard.lacks else replace(heard, lacks=lacks)
    return hear_instruction(rest, reader, facts_of(order.edit))


def _left_out(pictures: Sequence[SeenPicture], order: Order) -> tuple[str, ...]:
    """Which garment is not made, since hardly any of it is in the picture."""
    if order.part is not None:
        return ()
    return tuple(
        f"An edge of the picture cuts off most of a garment on the {part} body: --part {part} makes it."
        for part in parts_cut_off(pictures)
    )


def _doubts(pictures: Sequence[SeenPicture]) -> tuple[str, ...]:
    if all(one.reading.figures == "one" for one in pictures):
        return ()
    return ("The picture seems to show several people. What was read may be of any of them: crop it to one.",)


def _picture(order: Order) -> tuple[Pixels | None, tuple[str, ...]]:
    """The first picture as the network is shown it, where nobody reads it."""
    if not order.images:
        return None, ()
    image = order.images[0]
    assert not isinstance(image, SeenPicture)
    pixels = image if isinstance(image, np.ndarray) else read_picture(image)
    if not order.crop:
        return pixels, ()
    framed = frame_figure(pixels)
    return framed.pixels, _FRAMING_NOTES[framed.framing]


def _shown(picture: SeenPicture, crop: bool) -> tuple[Pixels | None, tuple[str, ...]]:
    """A picture that was read as the network is shown it: none before a background that it does not know."""
    if not crop:
        return picture.pixels, ()
    framed = frame_figure(picture.pixels)
    if framed.framing in (Framing.BUSY, Framing.EMPTY):
        return None, ()
    return framed.pixels, _FRAMING_NOTES[framed.framing]
