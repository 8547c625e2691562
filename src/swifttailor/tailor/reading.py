"""What an order asks for, read once: its words, its picture, its pattern to edit."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, subject_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.garment.part_looks import PartLook, merged
from swifttailor.pattern import Finding, Pattern, check_pattern
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.pattern_library.sought import GENTLY, Sought
from swifttailor.pattern_maker.asking.scripts import says_something
from swifttailor.pattern_maker.maker import Request
from swifttailor.pattern_maker.panel_foresight import PanelForesight
from swifttailor.picture_reader.reading import PartReading
from swifttailor.picture_reader.seen_color import SeenColor
from swifttailor.picture_reader.seen_print import SeenPrint
from swifttailor.recutting.alter import Alteration, alter
from swifttailor.recutting.clearer import clearer
from swifttailor.recutting.nearer import towards
from swifttailor.recutting.one_sided import asks_for_one_side
from swifttailor.recutting.to_the_figure import to_the_figures
from swifttailor.tailor.color_of_set import color_of_set
from swifttailor.tailor.looking import SeenPicture
from swifttailor.tailor.order import Order, one_line
from swifttailor.tailor.picture_print import cloth_of
from swifttailor.tailor.seen_wishes import LEAST_CUT, LEAST_CUT_OF_DRAFT
from swifttailor.wishes.assumed.unsaid_looks import unexpected_looks
from swifttailor.wishes.assumed.usual_measures import usual_measures, usual_necks
from swifttailor.wishes.corrections.loose_wholes import of_loose_wholes
from swifttailor.wishes.descriptions.own_words import in_own_words
from swifttailor.wishes.heard import HEARD_NOTHING, Heard
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import SURENESS

_UNSAID = (Claim("hem_shape", "level"), Claim("sides", "alike"))
_NO_SLIT = Claim("slit", "none")
_UNSAID_OF = {
    "skirt": (_NO_SLIT,),
    "dress": (_NO_SLIT,),
    "trousers": (Claim("leg_cuffs", "none"),),
}
"""The same by kind of garment."""
_MERE_COLLAR = Gain(Claim("collar", "lapel"))
_USUAL, _UNEXPECTED = 0.8, 0.35
"""Known patterns are preferred for what is usual where nobody speaks of it, and left for what is not."""
_PERHAPS = 0.6
_OF_THE_WAIST = frozenset(
    {"bodice length", "waist_seam", "waistband", "waistband height", "kind", "shoulders"}
)
"""What a waist moves with."""


@dataclass(frozen=True, eq=False)
class Wanted:
    """An order that was read. What takes long is done when it is first needed, and once."""

    order: Order
    text: str
    """With slips of the fingers put right, where the order is altered to it."""
    image: Pixels | None = None
    """(h, w, 3) as the network is shown it."""
    wishes: tuple[Wish, ...] = ()
    """What text and pictures ask for, as far as it was understood for certain."""
    likely: tuple[Wish, ...] = ()
    """What they may ask for, to be done last, where that costs nothing else."""
    notes: tuple[str, ...] = ()
    """What was done to the pictures."""
    pictures: tuple[SeenPicture, ...] = ()
    """As they were read; none where nothing is to be altered to them."""
    part: PartReading | None = None
    """What they say of the garment."""
    seen: tuple[Wish, ...] = ()
    """The wishes that are the pictures', sure and likely ones."""
    overruled: tuple[Wish, ...] = ()
    """What the pictures say and the text says otherwise."""
    warnings: tuple[str, ...] = ()
    """What is doubtful about the pictures."""
    heard: Heard = HEARD_NOTHING
    """What its words say beyond wishes: colours, what cannot be made, what was not understood."""
    foresight: PanelForesight | None = None
    """Tells of its words which panels the garment may have; None where that is not asked."""
    is_designed: bool = False
    """Whether it is as a draft is cut to it whose design was read: then to nothing that is merely likely."""
    seen_color: SeenColor | None = None
    """Of its cloth in the first picture, where words leave it to that."""
    seen_print: SeenPrint | None = None
    """The same of what is printed on it."""
    in_words: PartReading | None = None
    """What the pictures say of the garment, where that was put into words and these joined the text."""
    worded: tuple[Wish, ...] = ()
    """The wishes that these words ask for."""
    shown: frozenset[Change] = frozenset()
    """What is true to the eye of the draft that it begins from, though not as it is measured."""

    def is_shown(self, wish: Wish) -> bool:
        """Whether a wish is the pictures', read there or put into words."""
        return wish in self.seen or wish in self.worded

    @property
    def said(self) -> tuple[Wish, ...]:
        """The wishes that are the text's, as far as it was understood for certain."""
        return tuple(wish for wish in self.wishes if wish not in self.seen)

    @property
    def maybe(self) -> tuple[Change, ...]:
        """What is likely, and cut last where that costs nothing else: of pictures what is sure enough."""
        if self.is_designed:  # the design was read of that, too
            return ()
        cut = [w for w in self.likely if w not in self.seen or w.certainty >= LEAST_CUT]
        return tuple(wish.change for wish in cut)

    def of_draft(self) -> Wanted:
        """The same, as a draft is cut to it whose design was read in the pictures (`LEAST_CUT_OF_DRAFT`)."""
        doubted = [w for w in self.wishes if w in self.seen and w.certainty < LEAST_CUT_OF_DRAFT]
        kept = tuple([wish for wish in self.wishes if wish not in doubted])
        return replace(self, wishes=kept, likely=(*self.likely, *doubted), is_designed=True)

    def begun_from(self, draft: NamedDraft) -> Wanted:
        """The same, where the garment begins from a draft: what that shows is neither cut nor lacking."""
        shown = {Gain(Claim(name, value)) for name, value in draft.is_to_the_eye}
        near = shown | {Gain(Claim(name, value)) for name, value in draft.has_in_spirit}
        wishes = tuple([w for w in self.wishes if w.change not in shown])
        likely = tuple([w for w in self.likely if w.change not in near and not _is_mere_collar(w)])
        heard = self.heard.made_as(draft)
        return replace(self, wishes=wishes, likely=likely, heard=heard, shown=frozenset(shown))

    @property
    def color(self) -> str | None:
        """The one asked for, seen, or that of the garment that it is made from; None where none is."""
        if self.seen_print is not None:
            return self.seen_print.colors[0]
        if self.seen_color is not None:
            return self.seen_color.rgb
        order = self.order
        kept = order.color or cloth_color(order.edit) if order.edit is not None else None
        of_set = order.is_of_two and (order.part != "beside" or (order.outfit and order.outfit.third_alike))
        shared = color_of_set(order.outfit) if of_set else None
        return shared or self._asked_color or kept or self.heard.color_besides

    @property
    def _asked_color(self) -> str | None:
        """The colour of its words; of a garment that is there, "pencil skirt" changes no colour."""
        becomes = any(isinstance(w.change, Gain) and w.change.claim.name == "kind" for w in self.wishes)
        if self.order.edit is not None and self.heard.only_implies_color and not becomes:
            return None
        return self.heard.color

    @property
    def print(self) -> ClothPrint | None:
        """The print asked for, or seen; that of the garment it is made from where no colour is asked for."""
        if self.seen_print is not None:
            return cloth_of(self.seen_print)
        kept = None if self._asked_color or self.heard.plain else self.order.print
        return self.heard.print or kept

    @property
    def looks(self) -> tuple[PartLook, ...]:
        """Those of parts: of the garment that it is made from, and those asked for."""
        return merged(self.order.looks, self.heard.looks.looks)

    @property
    def leaves_cut(self) -> bool:
        """Whether there is a text, and nothing in it for certain of how the garment is cut."""
        return self.order.alter and bool(one_line(self.order.text)) and not self.said

    @property
    def misses(self) -> bool:
        """Whether there is a text and nothing was understood of it for certain."""
        clothed = self.heard.color or self.heard.print or self.heard.plain or self.heard.cloth
        clothed = clothed or self.heard.looks
        # A draft that it begins from may be of a kind.
        named = any(isinstance(each, Gain) and each.claim.name == "kind" for each in self.shown)
        return self.leaves_cut and not clothed and not named

    @property
    def kind_is_guessed(self) -> bool:
        """Whether a garment is described, and nothing in text or pictures tells which it is."""
        described = self.order.edit is None and bool(one_line(self.order.text)) and not self.order.images
        words = self.heard.words
        unsaid = words is not None and not words.implications and not self.heard.sure  # "sackcloth"
        return (
            self.order.alter and described and (self.heard.kind is None or bool(self.heard.guess) or unsaid)
        )

    @cached_property
    def sought(self) -> Sought:
        """What is known of the garment, to be looked up among known patterns."""
        said = [w for w in (*self.wishes, *self.likely) if w not in self.seen]
        if self.unsaid and said:
            names = {w.change.claim.name for w in said if isinstance(w.change, Gain)}
            usual = (*_UNSAID, *_UNSAID_OF.get(self.heard.kind or "", ()))
            said += [Wish(Gain(claim), _USUAL) for claim in usual if claim.name not in names]
        found = Sought.of(self.part, [*said, *self._unexpected()], self.heard.never, self._foreseen(said))
        if not self.unsaid or not said:
            return found
        meant = [wish for wish in said if wish.certainty >= _PERHAPS]
        found = found.with_measures(usual_measures(meant, self.heard.kind))
        return found.with_measures(usual_necks(meant, self.heard.kind), GENTLY)

    def _unexpected(self) -> list[Wish]:
        """What the garment should rather not be like, as nobody speaks of it."""
        if not self.unsaid:
            return []
        told = (*self.wishes, *self.likely)
        claims = unexpected_looks(told, self.heard.kind)
        loose = of_loose_wholes(told, self.heard.kind)
        return [*[Wish(Gain(claim), _UNEXPECTED) for claim in claims], *loose]

    def _foreseen(self, said: Sequence[Wish]) -> NDArray[np.float64] | None:
        """Which panels there may be, by the text as it is and in words that the network was taught."""
        if self.foresight is None or not said:
            return None
        taught = in_own_words([wish.change for wish in said])
        return self.foresight.odds([one for one in (one_line(self.text), taught) if says_something(one)])

    @property
    def unsaid(self) -> bool:
        """Whether words are all there is to go by, so that what they do not speak of is to be as usual."""
        return self.order.alter and self.order.edit is None and self.image is None and self.part is None

    @cached_property
    def tolerated(self) -> frozenset[str]:
        """Codes of what a check finds in the pattern to edit."""
        edit = self.order.edit
        return frozenset(f.code for f in checked(edit, edit)) if edit else frozenset()

    @cached_property
    def original(self) -> GarmentFacts | None:
        """What the pattern to edit shows; None where it cannot be measured, or nothing is to be altered."""
        return None if self.order.edit is None or not self.wishes else facts_of(self.order.edit)

    @cached_property
    def recut(self) -> Alteration | None:
        """The pattern to edit, altered: the same whatever the network writes."""
        if self.order.edit is None or self.original is None:
            return None
        changes = [wish.change for wish in self.wishes]
        kept = self.heard.kept
        if seen := clearer(changes, self.original):
            recut = altered(self.order.edit, seen, self.original, keep_others=True, kept=kept)
            if recut is not None and recut.cuts:
                return replace(recut, done=tuple(changes), open=())
        recut = self._at_the_hem(changes)
        if recut is None or recut.open:
            recut = altered(self.order.edit, changes, self.original, keep_others=True, kept=kept)
        if recut is not None:
            recut = to_the_figures(recut, changes, self.original, kept)
        nearer = [] if recut is None else towards(recut.open, changes)
        if recut is None or not nearer:
            return recut
        again = altered(recut.pattern, [*changes, *nearer], self.original, keep_others=True, kept=kept)
        if again is None or not again.cuts or not set(again.open) <= {*recut.open, *nearer}:
            return recut
        missing = tuple([change for change in again.open if change not in nearer])
        return replace(again, done=recut.done, open=missing, cuts=(*recut.cuts, *again.cuts))

    def _at_the_hem(self, changes: Sequence[Change]) -> Alteration | None:
        """The pattern to edit with its waist where it was, where it is only to be longer or shorter.

        A shorter bodice shortens a dress, too, where its hem is to be of some width besides.
        """
        subjects = {subject_of(change) for change in changes}
        if self.order.edit is None or "length" not in subjects or subjects & _OF_THE_WAIST:
            return None
        kept = self.heard.kept | {"bodice length"}
        return altered(self.order.edit, changes, self.original, keep_others=True, kept=kept)

    def request(self, attempt: int) -> Request:
        """What the network is asked.

        Of a picture it is told in words what was read of it; of a description it is asked every second time
        in words that it was taught.
        """
        if self.part is not None:
            text = self._seen_words(attempt)
            return Request(text, self.image if text or self.image is not None else self.pictures[0].pixels)
        return Request(self._own_words(attempt) or self.text, self.image, self.order.edit)

    def _own_words(self, attempt: int) -> str:
        if self.order.edit is not None or self.image is not None or attempt % 2 == 0:
            return ""
        changes = [wish.change for wish in (*self.wishes, *self.likely)]
        if asks_for_one_side(changes):
            return ""  # easily mistaken for each other
        return in_own_words(changes, attempt)

    def _seen_words(self, attempt: int) -> str:
        if self.text.strip() and attempt % 2 == 0:
            return f"{self.text.strip().rstrip('.')}. {in_own_words([w.change for w in self.seen], attempt)}"
        return in_own_words([w.change for w in (*self.wishes, *self.likely)], attempt) or self.text


def altered(
    pattern: Pattern,
    changes: Sequence[Change],
    original: GarmentFacts | None = None,
    *,
    keep_others: bool = False,
    kept: Collection[str] = (),
) -> Alteration | None:
    """The pattern altered (`recutting.alter`); None where it cannot be measured."""
    try:
        return alter(pattern, changes, original=original, keep_others=keep_others, kept=kept)
    except SwiftTailorError:
        return None


def checked(pattern: Pattern, edit: Pattern | None) -> tuple[Finding, ...]:
    """What a check finds; in an edited pattern, around the body that the pattern to edit was drafted for."""
    named = None if edit is None else edit.drafted_for
    if named is None:
        return check_pattern(pattern)
    from swifttailor.body.probe import probe_body
    from swifttailor.body.wearer import body_of

    return check_pattern(pattern, body=probe_body(body_of(named)))


def facts_of(pattern: Pattern) -> GarmentFacts | None:
    """What a pattern shows; None where it cannot be measured."""
    try:
        return measure_facts(pattern)
    except SwiftTailorError:
        return None


def _is_mere_collar(wish: Wish) -> bool:
    """Whether it is no more than the collar that such garments often have, as blouses do.

    Drafts for them have it; sewn to another it stands off.
    """
    return wish.change == _MERE_COLLAR and wish.certainty <= SURENESS["likely"]
