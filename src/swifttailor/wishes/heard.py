"""What was heard of a text: wishes, refusals, cloth, what cannot be made, what was not understood."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain
from swifttailor.garment.cloth_print import ClothPrint
from swifttailor.pattern.drafts.draft_names import ARMHOLES, DRAFT_KINDS, NamedDraft
from swifttailor.wishes.armholes_as_asked import armholes_as_asked
from swifttailor.wishes.asked_hems import hem_as_asked
from swifttailor.wishes.button_counts import closed_as_counted
from swifttailor.wishes.clinging_drafts import STRETCH, clinging_as_asked
from swifttailor.wishes.drafts_as_asked import draft_as_asked
from swifttailor.wishes.drafts_of_names import covers, draft_of_kind, draft_of_name
from swifttailor.wishes.flecks import is_flecked
from swifttailor.wishes.heard_looks import NO_LOOKS, HeardLooks, heard_looks
from swifttailor.wishes.heard_print import asks_for_plain, heard_print
from swifttailor.wishes.legs_by_words import ELASTIC, legs_as_said
from swifttailor.wishes.lexicon_spelling import near_names
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.refused_looks import as_not_refused
from swifttailor.wishes.ribs import ribs
from swifttailor.wishes.sailor_collars import asks_for_sailor_collar, with_sailor_collar
from swifttailor.wording.claim_kinds import implied_kind
from swifttailor.wording.lexicon import (
    Entry,
    Lack,
    WordMark,
    WordReading,
    cannot_texts,
    foreign_language,
    usual_color,
)

MOST_OF_KINDS, MOST_OF_NAMES = 6, 7
"""Up to so many things may be told of a garment that begins from a draft: where words name a mere kind, and
where they say more."""
_TOLD_AS_ONE = {"sleeve_shape": "sleeves", "cuffs": "sleeves", "straps": "sleeves", "neck_depth": "neckline"}
"""What one word tells together: "bishop sleeves" are long, full and end in cuffs."""
_NOT_TOLD = ("kind", "shoulders")
"""What goes with other claims: what has no sleeves covers both shoulders or none."""
_AT_SHOULDERS = ("shoulders", "straps", "sleeves", "neckline", "collar", "hood")
_BARE, _STAND, _TURTLENECK = Claim("shoulders", "strapless"), Claim("collar", "stand"), "turtleneck"
_NECKS = ("neckline", "collar", "hood", "straps")
_CUT_AS = {"tunic": "top", "shorts": "trousers", "playsuit": "jumpsuit"}
"""Kinds that are drafted as others."""
_COLOR_OF_CLOTH = {"denim": "3b5578"}
"""What a fabric is dyed unless another colour than blue is named."""
_BLUE = "365c96"
_ALIKE = 32
"""So far apart at most are red, green and blue, of 255, of colours that are called the same."""


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
        rgb = named[0].rgb if named else next(meant, None)
        dyed = _COLOR_OF_CLOTH.get(self.cloth or "")
        if rgb is None or (dyed is not None and rgb == _BLUE):
            rgb = dyed or rgb
        return None if rgb is None else f"#{rgb}"

    @cached_property
    def print(self) -> ClothPrint | None:
        """The print that it asks for."""
        return None if self.words is None else heard_print(self.rest or self.text, self.words)

    @property
    def ribs(self) -> tuple[float, float] | None:
        """Widths of the ribs of its cloth and between them, cm; None of cloth without, or with a print."""
        return None if self.words is None or self.print is not None else ribs(self.words)

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
        return named[0] if named else next((e.cloth for e in self._meant if e.cloth is not None), None)

    @cached_property
    def drafts(self) -> tuple[NamedDraft, ...]:
        """Drafts that show what it names, for the kind of garment that is asked for.

        First those that show what nothing else can (halter necks), then those of names that say more than the
        kind, then of details, then of mere kinds: trousers. Where nothing names a garment, and it
        may be a top, a plain one.
        """
        kind = _CUT_AS.get(self.kind or "", self.kind)
        order = _names_first if self.kind in ("shorts", "playsuit") else _says_less
        entries = sorted(self._meant, key=order)
        sure = [w.change.claim for w in self.sure if isinstance(w.change, Gain)]
        if len(sure) < len(self.sure) or not covers(self.kind, sure):  # known patterns have more
            entries = [e for e in entries if self._told_beside(e) <= _most_told(e)]
        beside = self._worn_beside
        entries = [e for e in entries if e not in beside]
        named = [draft for entry in entries for draft in entry.drafts]
        named = [draft for draft in named if DRAFT_KINDS[draft.name] == kind]
        sure += [] if any(claim.name in _AT_SHOULDERS for claim in sure) else self._likely_bare
        sure += self._standing_necks if not any(claim.name in _NECKS for claim in sure) else []
        sure += [_STRAIGHT] if _FLARED in self.never and not any(c.name == "skirt" for c in sure) else []
        named = _with_one_collar([as_not_refused(draft, self.never) for draft in named])
        fitting = [draft_as_asked(armholes_as_asked(draft, self.lacks), sure) for draft in named]
        if not named and self.kind in (None, "top") and self._tells_no_garment:
            fitting = [draft_as_asked(_WHATEVER, sure)]
        elif not any(fitting):  # a blouse without a collar has nothing of the shirt that blouses begin from
            kinds = [e for e in entries if self.kind in e.kinds and (named or not e.drafts)]
            fitting = [draft_of_name(entry, self.kind or "", sure) for entry in kinds]
            if self._says_details and not any(self.kind in entry.kinds for entry in self._meant):
                fitting = [draft_of_kind(self.kind, sure)]
        fitting = [armholes_as_asked(draft, self.lacks) for draft in fitting if draft is not None]
        if self._clings:
            fitting = [clinging_as_asked(draft, sure) for draft in fitting]
        wanted = {lack.what for lack in self.lacks if lack.said}
        if asks_for_sailor_collar(entries):
            fitting = [with_sailor_collar(draft) for draft in fitting]
        fitting = [legs_as_said(draft, self.text, self._elastic, self.never) for draft in fitting]
        closed = [closed_as_counted(draft, self.text) for draft in fitting]
        hemmed = [hem_as_asked(draft, sure, wanted, self._denied) for draft in closed]
        found = dict.fromkeys(hemmed)
        return tuple(sorted(found, key=lambda draft: wanted.isdisjoint(draft.shows)))

    def with_looks(self, words: WordReading | None = None, *, implied: bool = True) -> Heard:
        """The same with the looks of parts that its text asks for.

        Args:
            words: Of the text as it was before looks were taken out of it; its own when None.
            implied: Whether names of garments tell of looks, too.
        """
        words = self.words if words is None else words
        said = () if words is None else [look for look in words.looks if look.said or implied]
        if not said:
            return self
        return replace(self, looks=heard_looks(said, self.kind, self.color, self.print))

    def made_as(self, draft: NamedDraft) -> Heard:
        """The same, where the garment begins from a draft: what that shows is no longer lacking.

        Nor is what a name means of armholes, where it has others that the text asks for, and of a collar.
        """
        shown = set(draft.shows)
        others = ARMHOLES if ARMHOLES & shown else frozenset()
        others |= _TURNED_DOWN if draft.stands else frozenset()
        lacks = [k for k in self.lacks if k.what not in shown and (k.said or k.what not in others)]
        return replace(self, lacks=tuple(lacks))

    def _told_beside(self, entry: Entry) -> int:
        """How many things are told of the garment that the name of it does not mean anyway."""
        told = [w.change for w in self.sure if isinstance(w.change, Gain)]
        meant = {_TOLD_AS_ONE.get(each.claim.name, each.claim.name) for each in entry.implied}
        names = {change.claim.name for change in told if change.claim.name not in _NOT_TOLD}
        names = {_TOLD_AS_ONE.get(name, name) for name in names}
        return len(names - meant) + len(self.sure) - len(told)

    @property
    def _standing_necks(self) -> list[Claim]:
        """A collar that stands, where a word about the neck begins from such a draft: "a high neck"."""
        stands = [e for e in self._meant if e.category == "styles" and e.drafts]
        return [_STAND] if any(draft.name == _TURTLENECK for e in stands for draft in e.drafts) else []

    @property
    def _likely_bare(self) -> list[Claim]:
        """That nothing covers the shoulders, where that is likely: a "fit and flare wedding dress"."""
        likely = [w.change.claim for w in self.likely if isinstance(w.change, Gain)]
        return [claim for claim in likely if claim == _BARE]

    @property
    def _implied_colors(self) -> list[str]:
        """Colours that go with its names and cloths, those of cloths first: a skirt of leather is black."""
        found = [
            ((entry.category != "fabrics", mark.role == "second"), color)
            for mark in self._meant_marks
            for entry in mark.entries
            if entry.category != "colors" and (color := usual_color(mark.word, entry)) is not None
        ]
        return [color for _, color in sorted(found, key=lambda each: each[0])]

    @property
    def _unwanted_colors(self) -> frozenset[str]:
        """Colours that it refuses, and such as look like them: a dress for a wedding that is not white."""
        marks = () if self.words is None else self.words.marks
        denied = [e.color for mark in marks if mark.denied for e in mark.entries if e.color is not None]
        known = self._implied_colors
        alike = [one for one in known for other in denied if _alike(one, other)]
        return frozenset([*denied, *alike])

    @property
    def _clings(self) -> bool:
        """Whether it is to be close, and of cloth that stretches: a skin-tight one, a close one of jersey."""
        changes = [w.change for w in (*self.sure, *self.likely) if isinstance(w.change, Gain)]
        close = any(change.claim in _CLOSE for change in changes)
        stretches = any(STRETCH in entry.cannot for entry in self._meant)
        ribbed = self.ribs is not None and self.cloth != _CORDUROY
        return close and (stretches or ribbed or self.cloth in _KNITTED)

    @property
    def _elastic(self) -> frozenset[str]:
        """That there is elastic, where words about details say so and mean the waist: not those of ankles."""
        ankles = any(claim.name == "leg_cuffs" for e in self._meant for claim in e.claims("certain"))
        styles = [e for e in self._meant if e.category == "styles" and e.drafts and not ankles]
        return frozenset([key for e in styles for key in e.cannot if key == ELASTIC])

    @property
    def _denied(self) -> frozenset[str]:
        """What cannot be made of panels alone, and is refused."""
        marks = () if self.words is None else self.words.marks
        return frozenset([key for mark in marks if mark.denied for e in mark.entries for key in e.cannot])

    @property
    def _tells_no_garment(self) -> bool:
        """Whether its words tell something, but not of which garment: a red one, puff sleeves."""
        known = [entry for entry in self._meant if entry.category != "function"]
        told = self.words is not None and bool(self.words.colors or self.words.cloths or known)
        return told and not any(entry.category == "garments" for entry in self._meant)

    @property
    def _says_details(self) -> bool:
        """Whether its words themselves tell something of how the garment is cut."""
        return self.words is not None and any(
            i.said and i.claim.name != "kind" for i in self.words.implications
        )

    @property
    def _worn_beside(self) -> list[Entry]:
        """Garments that another one is only worn with: the apron of a dirndl with an apron."""
        marks = () if self.words is None else self.words.marks
        if not any(mark.role == "garment" for mark in marks):
            return []
        return [entry for mark in marks if mark.role == "like" for entry in mark.entries if entry.kinds]

    @property
    def _meant_marks(self) -> list[WordMark]:
        """Its words that are not denied, and not said of how a part looks."""
        if self.words is None:
            return []
        of_parts = {id(mark) for look in self.words.looks if look.part != "all" for mark in look.marks}
        return [mark for mark in self.words.marks if not mark.denied and id(mark) not in of_parts]

    @property
    def _meant(self) -> list[Entry]:
        return [entry for mark in self._meant_marks for entry in mark.entries]

    @cached_property
    def cannot(self) -> tuple[str, ...]:
        """What it asks for and cannot be made, in words."""
        return (*[cannot_texts()[lack.what] for lack in self.lacks if lack.said], *self.looks.refused)

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
        pairs = [(pair.first.word, pair.second.word) for pair in found]
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


_FLARED, _STRAIGHT = Claim("skirt", "flared"), Claim("skirt", "straight")
_TURNED_DOWN = frozenset({"shirt_collar"})
_WHATEVER = NamedDraft("t-shirt", (("neck_widening", 0.7), ("chest_ease", 8.0), ("waist_shaping", 1.0)))
_CLOSE = frozenset({Claim("fit", "close"), Claim("hips", "close")})
_KNITTED, _CORDUROY = ("jersey", "rib-knit"), "twill"
"""Fabrics that stretch, and what corduroy is made as, which has ribs and does not."""
HEARD_NOTHING = Heard("")
"""Where there is no text."""


_SHAWL = ("lapels", "shawl")
_SHAWL_CARDIGAN = NamedDraft(
    "blazer", (_SHAWL, ("chest_ease", 13.0), ("waist_shaping", 0.5), ("neck_depth", 28.0))
)
"""A cardigan with a shawl collar is cut as a jacket of that collar is."""
_MAY_BE_COLLARED = (
    *("drop-waist-dress", "jumpsuit", "shift-dress", "swing-dress", "fitted-dress"),
    *("shirt", "polo-shirt", "shirt-dress"),
)


def _with_one_collar(named: list[NamedDraft]) -> list[NamedDraft]:
    """Shirts and dresses with the collar that another draft of the text has: a Peter Pan collar."""
    if any(draft.name == "cardigan" for draft in named) and any(_SHAWL in draft.options for draft in named):
        named = [_SHAWL_CARDIGAN if draft.name == "cardigan" else draft for draft in named]
    collars = [option for draft in named for option in draft.options if option[0] == "collar"]
    return [
        replace(draft, options=(*draft.options, collars[0]))
        if collars and draft.name in _MAY_BE_COLLARED and not any(n == "collar" for n, _ in draft.options)
        else draft
        for draft in named
    ]


def _alike(one: str, other: str) -> bool:
    """Whether two colours (``rrggbb``) are hardly told apart by their names."""
    apart = [abs(int(one[k : k + 2], 16) - int(other[k : k + 2], 16)) for k in (0, 2, 4)]
    return max(apart) <= _ALIKE


def _names_first(entry: Entry) -> bool:
    """Of what is shorter than the drafts of details are."""
    return entry.category != "garments"


def _most_told(entry: Entry) -> int:
    return MOST_OF_KINDS if _says_less(entry) == 2 else MOST_OF_NAMES


_WHOLE_LEGS = ("joggers", "leggings")
"""Drafts that are more than a shape of legs."""


def _says_less(entry: Entry) -> int:
    """Smaller for what says more of the whole garment; most names of trousers say little of legs."""
    if entry.category != "garments":
        return 1
    definite = any(claim.name != "kind" for claim in entry.claims("certain"))
    with_legs = bool(entry.kinds & {"trousers", "jumpsuit", "playsuit"})
    definite = definite or any(draft.name in _WHOLE_LEGS for draft in entry.drafts)
    return 2 if entry.is_mere_kind or (with_legs and not definite) else 0
