"""Drafts that a text begins from: those of the names and details in it, changed to what else it asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.armholes_as_asked import armholes_as_asked, one_racer
from swifttailor.wishes.drafts.asked_hems import hem_as_asked
from swifttailor.wishes.drafts.bubble_hems import bubble_as_asked
from swifttailor.wishes.drafts.bygone_legs import legs_of_their_time
from swifttailor.wishes.drafts.clinging_drafts import STRETCH, clinging_as_asked, top_clinging_as_asked
from swifttailor.wishes.drafts.close_skirts import close_skirt_as_asked
from swifttailor.wishes.drafts.close_wraps import roomy_wrap_as_asked, wrapped_close_as_asked
from swifttailor.wishes.drafts.coats_as_named import coats_as_named
from swifttailor.wishes.drafts.drafts_as_asked import draft_as_asked
from swifttailor.wishes.drafts.drafts_of_names import covers, draft_of_kind, draft_of_name
from swifttailor.wishes.drafts.edge_to_edge import edge_to_edge_as_said
from swifttailor.wishes.drafts.elastic_waists import denied_lacks, elastic_meant
from swifttailor.wishes.drafts.fitted_dresses import fitted_as_asked
from swifttailor.wishes.drafts.godets_as_asked import godets_as_asked
from swifttailor.wishes.drafts.gored_drafts import gored_as_said
from swifttailor.wishes.drafts.hearted_drafts import hearted_as_asked
from swifttailor.wishes.drafts.huge_skirts import huge_as_said
from swifttailor.wishes.drafts.legged_drafts import short_as_a_playsuit
from swifttailor.wishes.drafts.legs_by_words import legs_as_said
from swifttailor.wishes.drafts.loosened_drafts import is_to_be_loose, loosened_as_asked
from swifttailor.wishes.drafts.low_skirts import low_as_asked
from swifttailor.wishes.drafts.mandarin_collars import (
    as_high_as_said,
    asks_for_mandarin_collar,
    with_mandarin_collar,
)
from swifttailor.wishes.drafts.measured_legs import legs_as_measured
from swifttailor.wishes.drafts.modest_necks import modest_as_asked
from swifttailor.wishes.drafts.nipped_waists import nipped_as_said
from swifttailor.wishes.drafts.one_collar import with_one_collar
from swifttailor.wishes.drafts.opened_drafts import opened_as_asked
from swifttailor.wishes.drafts.oversized_drafts import oversized_as_asked
from swifttailor.wishes.drafts.pleated_dresses import pleats_as_asked
from swifttailor.wishes.drafts.refused_looks import as_not_refused
from swifttailor.wishes.drafts.ribbed_dresses import is_ribbed_dress
from swifttailor.wishes.drafts.said_details import with_details
from swifttailor.wishes.drafts.sailor_collars import asks_for_sailor_collar, with_sailor_collar
from swifttailor.wishes.drafts.set_in_refused import armholes_spoken_of
from swifttailor.wishes.drafts.shirt_collars import with_shirt_collar
from swifttailor.wishes.drafts.short_flounces import short_flounce_as_asked
from swifttailor.wishes.drafts.slight_flares import slightly_flared_as_said
from swifttailor.wishes.drafts.straight_edges import straight_as_said
from swifttailor.wishes.drafts.swimsuits_as_asked import on_a_halter
from swifttailor.wishes.drafts.tiers_as_asked import tiers_as_asked
from swifttailor.wishes.drafts.told_measures import as_told, full_by_figures
from swifttailor.wishes.drafts.tops_to_the_legs import is_long_top, to_the_legs_as_said
from swifttailor.wishes.drafts.unbuttoned_cardigans import open_without_buttons
from swifttailor.wishes.drafts.wound_skirts import wound_as_asked
from swifttailor.wishes.drafts.yoked_skirts import YOKE, yoke_as_asked
from swifttailor.wishes.text.flare_starts import flare_as_said
from swifttailor.wishes.text.tier_heights import tier_as_said
from swifttailor.wishes.trims.button_counts import closed_as_counted
from swifttailor.wording.lexicon import Entry

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

MOST_OF_KINDS, MOST_OF_NAMES = 6, 7
"""Up to so many things may be told of a garment that begins from a draft: where words name a mere kind, and
where they say more."""
_TOLD_AS_ONE = {"sleeve_shape": "sleeves", "cuffs": "sleeves", "straps": "sleeves", "neck_depth": "neckline"}
"""What one word tells together: "bishop sleeves" are long, full and end in cuffs."""
_NOT_TOLD = ("kind", "shoulders")
"""What goes with other claims: what has no sleeves covers both shoulders or none."""
_AT_SHOULDERS = ("shoulders", "straps", "sleeves", "neckline", "collar", "hood")
_BARE, _STAND, _TURTLENECK = Claim("shoulders", "strapless"), Claim("collar", "stand"), "turtleneck"
_HIGH = Claim("neck_depth", "high")
_BARE_BACK = Claim("back_depth", "open")
_BARE_BACKS = frozenset({_BARE_BACK, Claim("back_depth", "low")})
_OF_COLLARS = ("collar", "collar_width", "collar_height", "neck_depth")
_OF_DETAILS: Mapping[str, tuple[str, ...]] = {
    "coat": ("flare", "lapels", "lapel_width", "collar_width", "collar"),
    "blazer": ("lapels", "lapel_width", "collar_width"),
    "shirt": _OF_COLLARS,
    "shirt-dress": _OF_COLLARS,
    "jumpsuit": ("collar", "collar_width", "neck_depth"),
    "joggers": ("hip_ease", "leg_ease", "crotch_drop"),
}
"""Options that a word about a detail tells of what another word names."""
_NECKS = ("neckline", "collar", "hood", "straps")
_CUT_AS = {"tunic": "top", "shorts": "trousers", "playsuit": "jumpsuit"}
"""Kinds that are drafted as others."""
_PLAYSUIT = "playsuit"
_STRAIGHT = Claim("skirt", "straight")
_FULL_SKIRTS = {Claim("skirt", "flared"), Claim("skirt", "circle")}
_WHATEVER = NamedDraft("t-shirt", (("neck_widening", -1.0), ("chest_ease", 8.0), ("waist_shaping", 1.0)))
_SWEATSHIRT, _CREW = NamedDraft("sweatshirt"), Claim("neckline", "crew")
_CLOSE_BODY = Claim("fit", "close")
_CLOSE = frozenset({_CLOSE_BODY, Claim("hips", "close")})
_TIGHT = "tight"
_OF_MOODS = frozenset({Claim("sleeves", "long"), Claim("skirt_hem", "below the knee"), Claim("fit", "close")})
"""What words of fits that name a mood make likely, and a draft is to have: a modest dress, a sexy one."""
_KNITTED, _CORDUROY = ("jersey", "rib-knit"), "twill"
"""Fabrics that stretch, and what corduroy is made as, which has ribs and does not."""
_STRAPLESS = ("bandeau", "bustier", "strapless-dress", "strapless-jumpsuit")
_BUSTIER, _STRAPS, _TIED = "bustier", ("straps", True), "shoulder bows"


def drafts_of(heard: Heard) -> tuple[NamedDraft, ...]:
    """Drafts that show what a text names, for the kind of garment that is asked for.

    First those that show what nothing else can (halter necks), then those of names that say more than the
    kind, then of details, then of mere kinds: trousers. Where nothing names a garment, and it
    may be a top, a plain one.
    """
    entries = _entries(heard)
    sure = _sure_claims(heard)
    begun = on_a_halter(_begun(heard, entries, sure), sure)
    armholes = armholes_spoken_of(heard)
    fitting = one_racer([armholes_as_asked(draft, armholes) for draft in begun])
    fitting = [oversized_as_asked(draft, sure) for draft in fitting]
    fitting = [hearted_as_asked(draft, heard.lacks, sure) for draft in fitting]
    if _clings(heard) and not is_to_be_loose(sure):
        named = _named_skirts(heard, sure)
        fitting = [clinging_as_asked(draft, [*sure, *named]) for draft in fitting]
    elif heard.cloth is None and not is_to_be_loose(sure):
        stretchy = any(lack.what == STRETCH and lack.said for lack in heard.lacks)
        fitting = [top_clinging_as_asked(draft, sure, stretchy=stretchy) for draft in fitting]
    fitting = [loosened_as_asked(roomy_wrap_as_asked(d, sure, heard.never), sure) for d in fitting]
    long = is_long_top(heard)
    fitting = [straight_as_said(to_the_legs_as_said(d, heard.text, long=long), heard.text) for d in fitting]
    fitting = [low_as_asked(draft, sure) for draft in gored_as_said(fitting, heard.text, sure)]
    fitting = [modest_as_asked(draft, heard.words, sure) for draft in fitting]
    fitting = [fitted_as_asked(draft, sure, _likely_claims(heard)) for draft in fitting]
    fitting = [close_skirt_as_asked(draft, sure, _said_claims(heard)) for draft in fitting]
    if any(claim.name == "straps" for claim in sure) or any(_TIED in entry.trims for entry in entries):
        fitting = [_on_straps(draft) for draft in fitting]
        fitting = [draft for draft in fitting if not _is_strapless(draft)] or fitting
    if asks_for_mandarin_collar(entries):
        fitting = [with_mandarin_collar(draft) for draft in fitting]
    fitting = [as_high_as_said(draft, entries) for draft in fitting]
    if asks_for_sailor_collar(entries):
        fitting = [with_sailor_collar(draft) for draft in fitting]
    fitting = [legs_as_said(draft, heard.text, elastic_meant(heard), heard.never) for draft in fitting]
    told = any(claim.name in ("legs", "leg_width_cm") for claim in sure)
    fitting = [legs_of_their_time(draft, heard.text, told=told) for draft in fitting]
    fitting = [legs_as_measured(draft, heard.text, sure) for draft in fitting]
    lacks = frozenset([lack.what for lack in heard.lacks])
    fitting = [with_details(draft, lacks, sure) for draft in fitting]
    fitting = [with_shirt_collar(draft, heard.text, lacks) for draft in fitting]
    fitting = [edge_to_edge_as_said(draft, heard.text, sure) for draft in fitting]
    fitting = [flare_as_said(short_flounce_as_asked(draft, sure), heard.text, sure) for draft in fitting]
    fitting = [tiers_as_asked(godets_as_asked(draft, sure), sure) for draft in fitting]
    fitting = [as_told(draft, sure) for draft in fitting]
    fitting = [bubble_as_asked(draft, heard.lacks, sure) for draft in fitting]
    fitting = [wrapped_close_as_asked(draft, sure) for draft in wound_as_asked(fitting, sure)]
    fitting = [pleats_as_asked(draft, heard.lacks, sure) for draft in fitting]
    fitting = [nipped_as_said(slightly_flared_as_said(d, heard.text), heard.text) for d in fitting]
    fitting = [yoke_as_asked(draft, lacks, heard.text) for draft in fitting]
    fitting = [huge_as_said(tier_as_said(draft, heard.text), heard.text) for draft in fitting]
    wanted = {lack.what for lack in heard.lacks if lack.said}
    opened = [opened_as_asked(closed_as_counted(d, heard.text), sure, wanted) for d in fitting]
    denied, knitted = denied_lacks(heard), any(lack.what == "rib_bands" for lack in heard.lacks)
    opened = [open_without_buttons(draft, wanted, denied, knitted=knitted) for draft in opened]
    found = dict.fromkeys([hem_as_asked(draft, sure, wanted, denied) for draft in opened])
    if YOKE in wanted:  # of several that have one, first what has the pleats below it as well
        return tuple(sorted(found, key=lambda draft: -len(wanted.intersection(draft.shows))))
    return tuple(sorted(found, key=lambda draft: wanted.isdisjoint(draft.shows)))


def _on_straps(draft: NamedDraft) -> NamedDraft:
    """A bustier on thin straps; others as they are."""
    return replace(draft, options=(*draft.options, _STRAPS)) if draft.name == _BUSTIER else draft


def _is_strapless(draft: NamedDraft) -> bool:
    return draft.name in _STRAPLESS and _STRAPS not in draft.options


def _entries(heard: Heard) -> list[Entry]:
    """What of the text may name a draft, best first: nothing of which more is told than can be drafted."""
    entries = sorted(heard.meant, key=_names_first if heard.kind in ("shorts", "playsuit") else _says_less)
    told = _told_claims(heard)
    if len(told) < len(heard.sure) or not covers(heard.kind, told):  # known patterns have more
        entries = [e for e in entries if _told_beside(heard, e) <= _most_told(e)]
    beside = (*_worn_beside(heard), *_outdone(heard))
    return [e for e in entries if e not in beside]


def _told_claims(heard: Heard) -> list[Claim]:
    return [w.change.claim for w in heard.sure if isinstance(w.change, Gain)]


def _likely_claims(heard: Heard) -> list[Claim]:
    return [w.change.claim for w in heard.likely if isinstance(w.change, Gain)]


def _sure_claims(heard: Heard) -> list[Claim]:
    """What is told, and what goes with it where nothing else is: bare shoulders, a neck that stands."""
    sure = _told_claims(heard)
    sure += [] if any(claim.name in _AT_SHOULDERS for claim in sure) else _likely_bare(heard)
    sure += [claim for claim in _moods(heard) if not any(claim.name == c.name for c in sure)]
    sure += full_by_figures(heard.kind, sure)
    sure += _standing_necks(heard) if not any(claim.name in _NECKS for claim in sure) else []
    if _refuses_full_skirts(heard) and not any(c.name == "skirt" for c in sure):
        sure.append(_STRAIGHT)
    return sure


def _refuses_full_skirts(heard: Heard) -> bool:
    """Whether none is to be full, or a word is refused that only usually means that: "not poofy"."""
    marks = () if heard.words is None else heard.words.marks
    refused = {
        each.claim for mark in marks if mark.denied for entry in mark.entries for each in entry.implied
    }
    return not _FULL_SKIRTS.isdisjoint({*heard.never, *refused})


def _begun(heard: Heard, entries: Sequence[Entry], sure: Sequence[Claim]) -> list[NamedDraft]:
    """The drafts that entries name, as they are asked for; else such as have all that is told."""
    kind = _CUT_AS.get(heard.kind or "", heard.kind)
    if is_long_top(heard):
        kind, sure = "top", [claim for claim in sure if claim.name != "skirt_hem"]
    named = [draft for entry in entries for draft in entry.drafts if draft.kind == kind]
    named = coats_as_named(named, entries)
    named = with_one_collar([as_not_refused(draft, heard.never) for draft in _in_detail(named, entries)])
    fitting = [draft_as_asked(armholes_as_asked(draft, heard.lacks), sure) for draft in named]
    if not named and heard.kind in (None, "top") and _tells_no_garment(heard):
        fitting = [draft_as_asked(_SWEATSHIRT if _is_a_crewneck(sure) else _WHATEVER, sure)]
    elif not any(fitting):  # a blouse without a collar has nothing of the shirt that blouses begin from
        own = ("tunic", "top") if is_long_top(heard) else (heard.kind,)
        kinds = [(e, k) for e in entries for k in own if k in e.kinds and (named or not e.drafts)]
        fitting = [draft_of_name(entry, kind or "", sure) for entry, kind in kinds]
        if _says_details(heard) and not any(heard.kind in entry.kinds for entry in heard.meant):
            fitting = [draft_of_kind(heard.kind, sure)]
    fitting = [draft for draft in fitting if draft is not None]
    if heard.kind == _PLAYSUIT:
        fitting = [short_as_a_playsuit(draft) for draft in fitting]
    return [as_not_refused(draft, heard.never) for draft in fitting]


def _is_a_crewneck(sure: Sequence[Claim]) -> bool:
    """Whether a close round neck is all that is told of a garment: such sweatshirts are called crewnecks."""
    return _CREW in sure and not {"sleeves", "sleeve_shape", "fit"} & {claim.name for claim in sure}


def _told_beside(heard: Heard, entry: Entry) -> int:
    """How many things are told of the garment that the name of it does not mean anyway."""
    told = [w.change for w in heard.sure if isinstance(w.change, Gain)]
    meant = {_TOLD_AS_ONE.get(each.claim.name, each.claim.name) for each in entry.implied}
    names = {change.claim.name for change in told if change.claim.name not in _NOT_TOLD}
    names = {_TOLD_AS_ONE.get(name, name) for name in names}
    return len(names - meant) + len(heard.sure) - len(told)


def _standing_necks(heard: Heard) -> list[Claim]:
    """A collar that stands, where a word about the neck begins from such a draft: "a high neck".

    None does above a bare back: a close round neck is high there.
    """
    bare = not _BARE_BACKS.isdisjoint(_told_claims(heard))
    outdone = _outdone(heard)
    stands = [e for e in heard.meant if e.category == "styles" and e.drafts and e not in outdone]
    high = any(draft.name == _TURTLENECK for e in stands for draft in e.drafts)
    return [] if not high else [_HIGH if bare else _STAND]


def _likely_bare(heard: Heard) -> list[Claim]:
    """That nothing covers the shoulders, where that is likely: a "fit and flare wedding dress"."""
    likely = _likely_claims(heard)
    if _BARE_BACK in _told_claims(heard):  # the edge of a strapless one runs straight across the back
        return []
    return [claim for claim in likely if claim == _BARE]


def _moods(heard: Heard) -> list[Claim]:
    """What such words make likely."""
    likely = _likely_claims(heard)
    found = () if heard.words is None else heard.words.implications
    moods = [i.claim for i in found if i.said and any(e.category == "fits" for e in i.mark.entries)]
    return [claim for claim in likely if claim in _OF_MOODS and claim in moods]


def _clings(heard: Heard) -> bool:
    """Whether it is to be close, and of cloth that stretches: a tight one, a close one of jersey."""
    changes = [w.change for w in (*heard.sure, *heard.likely) if isinstance(w.change, Gain)]
    close = any(change.claim in _CLOSE for change in changes) or is_ribbed_dress(heard, _said_claims(heard))
    stretches = any(STRETCH in entry.cannot for entry in heard.meant)
    ribbed = heard.ribs is not None and heard.cloth != _CORDUROY
    tight = heard.cloth is None and any(_is_tight(entry) for entry in heard.meant)
    return close and (stretches or ribbed or tight or heard.cloth in _KNITTED)


def _is_tight(entry: Entry) -> bool:
    """Whether it says of a garment that it is tight: closer than what is fitted."""
    return (
        entry.category == "fits"
        and _TIGHT in (*entry.words, entry.english)
        and _CLOSE_BODY in entry.claims("certain")
    )


def _named_skirts(heard: Heard, sure: Sequence[Claim]) -> list[Claim]:
    """The skirt that the name of a dress means, where no more is told of it: that of a tennis dress."""
    if heard.words is None or any(claim.name in ("skirt", "hips") for claim in sure):
        return []
    return [i.claim for i in heard.words.implications if i.claim.name == "skirt" and not i.said]


def _said_claims(heard: Heard) -> list[Claim]:
    """What words about details say."""
    return [] if heard.words is None else [i.claim for i in heard.words.implications if i.said]


def _tells_no_garment(heard: Heard) -> bool:
    """Whether its words tell something, but not of which garment: a red one, puff sleeves."""
    known = [entry for entry in heard.meant if entry.category != "function"]
    told = heard.words is not None and bool(heard.words.colors or heard.words.cloths or known)
    return told and not any(entry.category == "garments" for entry in heard.meant)


def _says_details(heard: Heard) -> bool:
    """Whether its words themselves tell something of how the garment is cut."""
    return heard.words is not None and any(
        i.said and i.claim.name != "kind" for i in heard.words.implications
    )


def _worn_beside(heard: Heard) -> list[Entry]:
    """Garments that another one is only worn with: the apron of a dirndl with an apron."""
    marks = () if heard.words is None else heard.words.marks
    if not any(mark.role == "garment" for mark in marks):
        return []
    own = [entry for mark in marks if mark.role == "garment" for entry in mark.entries]
    like = [entry for mark in marks if mark.role == "like" for entry in mark.entries if entry.kinds]
    return [entry for entry in like if entry not in own]  # a ringmaster wears a tailcoat, too


def _outdone(heard: Heard) -> list[Entry]:
    """Of words that contradict each other the entries of which nothing is left: a high neck that plunges."""
    words = heard.words
    if words is None:
        return []
    opposed = [mark for pair in words.contradictions for mark in (pair.first, pair.second)]
    kept = {i.mark.start for i in words.implications}
    return [entry for mark in opposed if mark.start not in kept for entry in mark.entries]


def _in_detail(named: Sequence[NamedDraft], entries: Sequence[Entry]) -> list[NamedDraft]:
    """Coats and harem trousers as a detail has them: with a swing back, or not too droopy."""
    details: dict[str, dict[str, float | bool | str]] = {}
    for draft in [d for e in entries if e.category == "styles" for d in e.drafts]:
        details[draft.name] = {**details.get(draft.name, {}), **dict(draft.options)}
    found = []
    for draft in named:
        told = details.get(draft.name, {})
        more = {name: told[name] for name in _OF_DETAILS.get(draft.name, ()) if name in told}
        found.append(replace(draft, options=tuple({**dict(draft.options), **more}.items())))
    return found


def _names_first(entry: Entry) -> bool:
    """Of what is shorter than the drafts of details are."""
    return entry.category != "garments"


def _most_told(entry: Entry) -> int:
    return MOST_OF_KINDS if _says_less(entry) == 2 else MOST_OF_NAMES


_WHOLE_LEGS = ("joggers", "leggings", "halter-jumpsuit", "wrap-jumpsuit")
"""Drafts that are more than a shape of legs, or than a bodice on legs."""


def _says_less(entry: Entry) -> int:
    """Smaller for what says more of the whole garment; most names of trousers say little of legs."""
    if entry.category != "garments":
        return 1
    definite = any(claim.name != "kind" for claim in entry.claims("certain"))
    with_legs = bool(entry.kinds & {"trousers", "jumpsuit", "playsuit"})
    definite = definite or any(draft.name in _WHOLE_LEGS for draft in entry.drafts)
    return 2 if entry.is_mere_kind or (with_legs and not definite) else 0
