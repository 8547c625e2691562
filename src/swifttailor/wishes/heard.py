"""What was heard of a text: wishes, refusals, cloth, what cannot be made, what was not understood."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.pattern.drafts.draft_names import ARMHOLES, NamedDraft
from swifttailor.render.lab import lab_of_hex
from swifttailor.wishes.drafts.heard_drafts import drafts_of
from swifttailor.wishes.looks.color_of_bodies import color_behind_name, color_of_body
from swifttailor.wishes.looks.flecks import is_flecked
from swifttailor.wishes.looks.heard_looks import NO_LOOKS, HeardLooks, heard_looks
from swifttailor.wishes.looks.heard_print import asks_for_plain, heard_print
from swifttailor.wishes.looks.joined_colors import joined_colors, left_over
from swifttailor.wishes.looks.naps import nap_of
from swifttailor.wishes.looks.printed_parts import ON_ALL, PrintedParts, printed_parts
from swifttailor.wishes.looks.refused_colors import color_besides, is_like
from swifttailor.wishes.looks.ribs import ribs
from swifttailor.wishes.looks.second_colors import with_second_color
from swifttailor.wishes.looks.shades_alone import shade_alone
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.text.lexicon_spelling import near_names
from swifttailor.wording.claim_kinds import implied_kind
from swifttailor.wording.lexicon import (
    Entry,
    Lack,
    NamedColor,
    WordMark,
    WordReading,
    cannot_texts,
    foreign_language,
    usual_color,
)

_COLOR_OF_CLOTH = {"denim": "3b5578"}
"""What a fabric is dyed unless another colour than blue is named."""
_BLUE, _DARK_BLUE, _DARK_DENIM = "365c96", "1d2f5e", "263853"
_NEAR = 30.0
"""The same of a colour that was seen, in Lab: "red" is dark red and scarlet as well."""


@dataclass(frozen=True)
class Heard:
    """What a text asks for."""

    text: str
    """As it was read: with slips of the fingers put right."""
    sure: tuple[Wish, ...] = ()
    likely: tuple[Wish, ...] = ()
    """What names of garments usually imply, and what may be meant."""
    never: tuple[Claim, ...] = ()
    """What it refuses."""
    unread: tuple[str, ...] = ()
    """What of it was not understood, in its own words."""
    lacks: tuple[Lack, ...] = ()
    """What it asks for and cannot be made."""
    words: WordReading | None = None
    """By the lexicon; None where there is no text."""
    guess: str = ""
    """The name that the garment was made by, where none was understood and this is spelt like a word."""
    clashes: tuple[tuple[str, str], ...] = ()
    """What of an instruction asks for opposite things, in words; none of it is done."""
    kept: frozenset[str] = frozenset()
    """Claims and quantities that are to stay as they are, by an instruction."""
    taken: tuple[tuple[str, tuple[Change, ...]], ...] = ()
    """Vague words, and what they are taken to ask for: "winter", long sleeves."""
    unsure: tuple[Change, ...] = ()
    """What of `sure` an instruction may not mean: readers disagree, or one alone guesses."""
    perhaps: tuple[Change, ...] = ()
    """What an instruction may mean as well; it is not asked for."""
    looks: HeardLooks = NO_LOOKS
    """Which parts are to look otherwise than the rest, or are sheer."""
    rest: str = ""
    """What is left of an instruction without the looks of parts; `words` are its words. Empty: all of it."""

    @property
    def color(self) -> str | None:
        """The first colour that it names, ``#rrggbb``, or that a name or a fabric implies: blue jeans."""
        named = self.words.colors if self.words is not None else ()
        unwanted = self._unwanted_colors
        meant = (color for color in self._implied_colors if color not in unwanted)
        body = (
            None if self.words is None else color_of_body(self.words.looks) or color_behind_name(self.words)
        )
        alone = None if self.words is None else shade_alone(self.words)
        rgb = named[0].rgb if named else body or alone or next(meant, None)
        dyed = _COLOR_OF_CLOTH.get(self.cloth or "")
        if rgb is None or (dyed is not None and rgb == _BLUE):
            rgb = dyed or rgb
        if dyed is not None and rgb == _DARK_BLUE:
            rgb = _DARK_DENIM
        return None if rgb is None else f"#{rgb}"

    @property
    def color_besides(self) -> str | None:
        """A colour that is none of those that it refuses, ``#rrggbb``; None where it refuses none."""
        found = color_besides(self._denied_colors)
        return None if found is None else f"#{found}"

    @property
    def says_color(self) -> bool:
        """Whether it names a colour, a print or dyed cloth; names of garments only imply a colour."""
        words = self.words
        dyed = words is not None and not _COLOR_OF_CLOTH.keys().isdisjoint(words.cloths)
        return words is not None and bool(words.colors or dyed or self.print is not None)

    @property
    def only_implies_color(self) -> bool:
        """Whether its colour is that of a name alone: a pencil skirt is black, where nobody says so."""
        words = self.words
        if words is None or words.colors or words.cloths:
            return False
        return not (color_of_body(words.looks) or color_behind_name(words) or shade_alone(words))

    def refuses_color(self, color: str) -> bool:
        """Whether it denies a colour, ``#rrggbb``, or one that is called the same: "not red"."""
        return any(np.linalg.norm(lab_of_hex(color) - lab_of_hex(one)) < _NEAR for one in self._denied_colors)

    @cached_property
    def printed_parts(self) -> PrintedParts:
        """The parts that its print is on, where it is not on the whole."""
        return ON_ALL if self.words is None else printed_parts(self.as_read, self.words)

    @cached_property
    def print(self) -> ClothPrint | None:
        """The print that it asks for."""
        parts = self.printed_parts
        colored = self.words is not None and (self.words.colors or self.words.looks)
        if self.words is None or (self.guess and colored and not self._names_print):
            return None  # the flowers of tea dresses, where a white one is asked for
        return heard_print(self.as_read, self.words, parts, self.kind)

    @property
    def _names_print(self) -> bool:
        marks = () if self.words is None else self.words.marks
        return any(entry.category == "prints" for mark in marks for entry in mark.entries)

    @property
    def ribs(self) -> tuple[float, float] | None:
        """Widths of the ribs of its cloth and between them, cm; None of cloth without, or with a print."""
        return None if self.words is None or self.print is not None else ribs(self.words)

    @property
    def nap(self) -> str | None:
        """What face its cloth has, as a motif; None of cloth without, or with a print."""
        return None if self.words is None or self.print is not None else nap_of(self.words)

    @property
    def is_flecked(self) -> bool:
        """Whether its cloth has flecks, as tweed has, and no print."""
        return self.words is not None and self.print is None and is_flecked(self.words)

    @property
    def plain(self) -> bool:
        """Whether it asks for cloth without print."""
        return self.words is not None and asks_for_plain(self.words)

    @property
    def cloth(self) -> str | None:
        """The fabric that comes nearest to what it names, or to what a name implies: a denim skirt."""
        named = self.words.cloths if self.words is not None else ()
        return named[0] if named else next((e.cloth for e in self.meant if e.cloth is not None), None)

    @cached_property
    def drafts(self) -> tuple[NamedDraft, ...]:
        """Drafts that show what it names, best first (`heard_drafts`)."""
        return drafts_of(self)

    def with_looks(self, words: WordReading | None = None, *, implied: bool = True) -> Heard:
        """The same with the looks of parts that its text asks for.

        Args:
            words: Of the text as it was before looks were taken out of it; its own when None.
            implied: Whether names of garments tell of looks, too.
        """
        words = self.words if words is None else words
        said = () if words is None else [look for look in words.looks if look.said or implied]
        parts = self.printed_parts
        looks = heard_looks(said, self.kind, self.color, self.print, parts) if said or parts else NO_LOOKS
        if implied and words is not None and self.print is None and len(self._joined_colors) > 1:
            lacking = [lack.what for lack in self.lacks]
            looks = with_second_color(looks, self._joined_colors, self.kind, lacking)
        return self if looks == NO_LOOKS else replace(self, looks=looks)

    @cached_property
    def as_read(self) -> str:
        """The text that `words` are the words of: where a name is a guess, it stands before its text."""
        guessed = f"{self.guess}, {self.text}"
        marks = () if self.words is None else self.words.marks
        fits = bool(self.guess) and all(guessed[mark.start : mark.end] == mark.word for mark in marks)
        return self.rest or (guessed if fits else self.text)

    @cached_property
    def _joined_colors(self) -> tuple[NamedColor, ...]:
        """Colours that it names side by side; none where its first colour is not among them."""
        if self.words is None:
            return ()
        found = joined_colors(self.as_read, self.words)
        return found if found and f"#{found[0].rgb}" == self.color else ()

    @property
    def missed_colors(self) -> tuple[str, ...]:
        """Colours of the garment that it names, and that nothing of it is in."""
        if self.words is None or self.color is None:
            return ()
        inks = () if self.print is None else self.print.colors
        blue = [f"#{_BLUE}"] if self.color == f"#{_COLOR_OF_CLOTH.get(self.cloth or '')}" else []
        blue += [f"#{_DARK_BLUE}"] if self.color == f"#{_DARK_DENIM}" else []
        shown = [
            self.color,
            *blue,
            *inks,
            *[look.color for look in self.looks.looks if look.color is not None],
        ]
        return left_over(self.as_read, self.words, shown)

    def made_as(self, draft: NamedDraft) -> Heard:
        """The same, where the garment begins from a draft: what that shows is no longer lacking.

        Nor is what a name means of armholes, where it has others that the text asks for, and of a collar.
        """
        shown = set(draft.shows)
        others = ARMHOLES if ARMHOLES & shown else frozenset()
        others |= _TURNED_DOWN if draft.stands else frozenset()
        lacks = [k for k in self.lacks if k.what not in shown and (k.said or k.what not in others)]
        return replace(self, lacks=tuple(lacks))

    @property
    def _implied_colors(self) -> list[str]:
        """Colours that go with its names and cloths, most telling first.

        Those of persons first, then those of cloths: a swimsuit of Baywatch is red, a skirt of leather black.
        """
        found = [
            ((entry.place[0] != _PERSONS, entry.category != "fabrics", mark.role == "second"), color)
            for mark in self.meant_marks
            for entry in mark.entries
            if entry.category != "colors" and (color := usual_color(mark.word, entry)) is not None
        ]
        return [color for _, color in sorted(found, key=lambda each: each[0])]

    @property
    def _denied_colors(self) -> list[str]:
        marks = () if self.words is None else self.words.marks
        return [e.color for mark in marks if mark.denied for e in mark.entries if e.color is not None]

    @property
    def _unwanted_colors(self) -> frozenset[str]:
        """Colours that it refuses, and such as look like them: a dress for a wedding that is not white."""
        denied, known = self._denied_colors, self._implied_colors
        alike = [one for one in known for other in denied if is_like(one, other)]
        return frozenset([*denied, *alike])

    @property
    def meant_marks(self) -> list[WordMark]:
        """Its words that are not denied, and not said of how a part looks."""
        if self.words is None:
            return []
        of_parts = {id(mark) for look in self.words.looks if look.part != "all" for mark in look.marks}
        return [mark for mark in self.words.marks if not mark.denied and id(mark) not in of_parts]

    @property
    def meant(self) -> list[Entry]:
        """Their entries in the lexicon."""
        return [entry for mark in self.meant_marks for entry in mark.entries]

    @cached_property
    def cannot(self) -> tuple[str, ...]:
        """What it asks for and cannot be made, in words."""
        lacking = [cannot_texts()[lack.what] for lack in self.lacks if lack.said]
        missed = [f"one more colour ({color.lower()})" for color in self.missed_colors]
        return (*lacking, *self.looks.refused, *missed)

    @cached_property
    def left_out(self) -> tuple[str, ...]:
        """What the names of garments in it mean and cannot be made, in words."""
        return tuple([cannot_texts()[lack.what] for lack in self.lacks if not lack.said])

    @property
    def foreign(self) -> str | None:
        """The language that it is in, where that is none that is read."""
        return None if self.words is None else foreign_language(self.text, self.words.unknown)

    @property
    def contradictions(self) -> tuple[tuple[str, str], ...]:
        """Pairs of words in it that cannot both be true."""
        found = () if self.words is None else self.words.contradictions
        pairs = [(_apart(pair.first, pair.second), _apart(pair.second, pair.first)) for pair in found]
        return tuple(dict.fromkeys([*pairs, *self.clashes]))

    @property
    def kind(self) -> str | None:
        """The kind of garment that is asked for, or that details tell; None where nothing does."""
        claims = [w.change.claim for w in (*self.sure, *self.likely) if isinstance(w.change, Gain)]
        named = next((str(claim.value) for claim in claims if claim.name == "kind"), None)
        return named or next(iter(implied_kind(claims)), None)

    @cached_property
    def near(self) -> tuple[str, ...]:
        """Names of garments that are spelt like words that were not understood."""
        return near_names(self.unread)


def _apart(mark: WordMark, other: WordMark) -> str:
    """A word without the other that stands within it: of a "knee length maxi skirt" the knee length skirt."""
    inside = mark.start <= other.start and other.end <= mark.end and mark is not other
    return " ".join(mark.word.replace(other.word, "", 1).split()) if inside else mark.word


_TURNED_DOWN = frozenset({"shirt_collar"})
_PERSONS = "persons.txt"
"""Of whom the looks are known."""
HEARD_NOTHING = Heard("")
"""Where there is no text."""
