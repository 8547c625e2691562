"""Which trims are meant by what a text asks for and no panel can be cut for: pockets, buttons, a belt."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.trims.names import LIKE_EACH_OTHER
from swifttailor.wishes.drafts.bygone_legs import PLEATED, is_bygone
from swifttailor.wishes.drafts.edge_to_edge import meets_without_fastening
from swifttailor.wishes.drafts.elastic_waists import denied_lacks
from swifttailor.wishes.trims.big_buttons import BIG, asks_for_big_buttons
from swifttailor.wishes.trims.loops_and_stitches import loops_and_stitches
from swifttailor.wishes.trims.sashes import BIBBED, WOUND, first_of_kind
from swifttailor.wishes.trims.three_stripes import three_as_said
from swifttailor.wishes.trims.trims_by_place import is_elastic_behind, trims_by_place
from swifttailor.wishes.trims.trims_of import KNEE_RIPS, TRIMS_OF

if TYPE_CHECKING:
    from swifttailor.wishes.heard import Heard

_JACKETS = frozenset(
    {
        "blazer",
        "coat",
        "hooded-coat",
        "waistcoat",
        "cardigan",
        "bomber-jacket",
        "denim-jacket",
        "turtleneck",
        "robe",
    }
)
"""Drafts that are buttoned without a band."""
_WRAPS = frozenset({"wrap-dress", "wrap-jumpsuit", "wrap-top", "robe"})
_HOODED = frozenset({"hoodie", "hooded-coat"})
_SHIRTS = frozenset({"shirt", "polo-shirt", "shirt-dress", "shift-dress"})
"""Drafts that are buttoned on a band, unless big buttons are told."""
_OPEN_COATS = frozenset({"blazer", "coat", "cardigan"})
"""Drafts that may be open from the neck down."""
_RIBS, _RIBBED = "rib_bands", frozenset({"t-shirt", "tank-top", "sweatshirt"})
_SECOND = (("side_stripes", "side_stripes", "side stripes"), ("edging", "braid", "edging"))
"""Parts that a second colour may be put on, what they stand for, and their trims."""
_KNITS = frozenset({"jersey", "rib-knit", "sweatshirt", "fleece"})
_SAID_ALONE = frozenset(
    {
        "wrap",
        *("lace", "braid", "apron", "boning", "pleats", "smocking", "ruching", "tucks"),
        *("cut_outs", "draped", "draped_cloth", "yoke", "princess_seams", "scallops"),
        *("train", "overskirt", "tulle_layers", "second_layer", "cups", "cape"),
    }
)
"""What is put on only where the text itself asks for it, or a row of the tables has its trim."""
_INSTEAD = frozenset(
    {"back zip", "back ties", "back buttons", "back lacing", "keyhole", "cowl folds", "neck cord", "lacing"}
)
"""What closes, opens or fills a neck, so that no buttons do."""
_PULLED_ON = frozenset({"off-shoulder-top", "bandeau", "bustier", "halter-top", "tank-top", "camisole"})
"""Drafts that are buttoned in front only where a text or a name says so."""
WITHOUT_FLY = frozenset({"pull-on-trousers", "joggers", "leggings"})
"""Drafts of legs that are drawn up over the hips, and opened only where a text says so."""
_BOAT = Claim("neckline", "boat")
_OPEN_KNIT, _HEM_BAND = "cardigan", Gain(Claim("waistband", "hem"))
"""The draft whose fronts no band joins at the hem: it is put on as a trim."""
_TIES, _HIP_KNOT = frozenset({"belt", "ties", "ties_accessory"}), ("hip knot",)
"""What ties of a skirt that is wound around are heard as, and how they are made."""
_LOWER = ("trousers", "shorts")
_BYGONE = (("pleats", "front pleats"), ("creases", "creases"))
"""What trousers of the time between the wars have in front."""
_FOR_JACKETS, _TAILORED = frozenset({"cardigan", "turtleneck"}), "blazer"
"""Drafts that jackets without a collar and with one that stands are cut from, and the one with lapels."""
_BANDED, _DOWN_THE_FRONT, _OF_A_POLO = ("shirt", "shirt-dress"), ("buttons",), ("polo placket",)
"""Drafts whose buttons are sewn to a band; a row of buttons; what nightshirts have where they say nothing of
a whole row."""
_DENIM = "denim"
_NET, _NETS = ("tulle layers",), frozenset({"tulle", "net", "organza"})
"""What is put on skirts of a net, and which cloths are such."""
_FLOUNCED = Claim("cuffs", "flounce")
"""Frills of the sleeves, where no others are named."""
_KANGAROO, _ANY_BIG = "kangaroo pocket", "patch pockets"
"""What "big pockets" are where nothing tells their place."""
_STRING = "drawstring"
_DETAILS = "styles"
"""The category of entries that name trims themselves."""


@dataclass(frozen=True)
class TrimWish:
    """A trim, or several that go together, and what they stand for."""

    what: str
    """A key of `cannot_texts`."""
    said: bool
    """Whether the text asks for it; otherwise the name of a garment means it."""
    choices: tuple[tuple[str, ...], ...]
    """Names of `TRIMS`; the first of which all find a place is taken."""
    named: bool = False
    """Whether the text says which: cargo pockets, and not pockets."""


def trims_wanted(heard: Heard, draft: str = "", kind: str = "", *, anew: bool = True) -> tuple[TrimWish, ...]:
    """What may be put on a garment, in the order of the text.

    Args:
        heard: What the text asks for.
        draft: Name of the draft that the garment is cut from; empty where it is cut from none.
        kind: Of the garment, where the text does not name it.
        anew: Whether the garment is made, and not one that is there changed: that gets no stitches unasked.
    """
    named = _named(heard)
    kind = heard.kind or kind
    found = []
    no_strings = _refuses_strings(heard)
    for lack in heard.lacks:
        if no_strings and lack.what == _STRING and not lack.said:
            continue
        can = TRIMS_OF.get(lack.what, ())
        own = tuple([name for name in _of_garment(heard) if name in can])
        if lack.what == "zip" and not lack.said and draft in WITHOUT_FLY:
            continue
        if not lack.said and lack.what in _SAID_ALONE and not own and not _is_worn_beside(heard, lack.what):
            can = ()
        if lack.what == "buttons" and not lack.said and _is_closed_otherwise(heard, named, own, draft):
            continue
        if lack.what == "lace" and not lack.said and is_of_lace(heard):
            can = own = ()
        if lack.what == draft == "cape":
            can = own = ()
        if lack.what == "second_layer" and not _has_net_skirt(heard):  # a lining, not layers of tulle
            can = own = ()
        said = tuple([name for name in named if name in can])
        if lack.what == "buttons" and not said and asks_for_big_buttons(heard.text):
            said = (BIG,)
        if lack.what == "buttons" and said == _DOWN_THE_FRONT and (draft in _BANDED or own == _OF_A_POLO):
            said = ("button placket",)
        if draft in _SHIRTS:  # which have a band below their buttons
            said = tuple(["button placket" if name == "buttons" else name for name in said])
        if draft in _HOODED:  # that of a hoodie
            said = tuple([_KANGAROO if name == "front pocket" else name for name in said])
        placed = trims_by_place(heard.text, lack.what, kind=kind, draft=draft) if lack.said else ()
        if placed:
            others = [name for name in said if name != _ANY_BIG]
            said = tuple(dict.fromkeys([*[names[0] for names in placed], *others]))
        choices = _usual(lack.what, kind, heard.cloth, draft) if can else ()
        if lack.what == "pockets" and _is_ribbed(heard):  # a jacket of knit has them on it, not in it
            choices = tuple(sorted(choices, key=lambda names: "welt pockets" in names))
        if choices and (first := first_of_kind(lack, kind, draft, heard.text)):
            choices = (first, *choices)
        if lack.what == "elastic" and is_elastic_behind(heard.text):
            choices = (("back elastic",), *choices)
        if choices and lack.what == "frills" and _FLOUNCED in _claims(heard):
            choices = (("sleeve frills",),)
        if said or own:
            alone = sorted(said or own, key=lambda name: name not in own)
            instead = [(name,) for names in placed for name in names[1:]]
            choices = (said or own, *[(name,) for name in alone], *instead, *choices)
        if draft in WOUND and lack.said and lack.what in _TIES and _is_tied(lack.what, said):
            choices = (_HIP_KNOT, *choices)
        if lack.what == "belt" and "tie belt" in said:  # what ends at the waist is tied there
            choices = (*choices, ("waist bow",))
        if lack.what == "side_stripes":
            choices = three_as_said(choices, heard.text)
        if choices:
            found.append(TrimWish(lack.what, lack.said, choices, bool(said)))
    for part, what, name in _SECOND:
        if heard.looks.second == part and not any(wish.what == what for wish in found):
            found.append(TrimWish(what, False, ((name,),)))
    if (
        kind in ("dress", "skirt")
        and _has_net_skirt(heard)
        and not any(_NET in wish.choices for wish in found)
    ):
        found.append(TrimWish("tulle_layers", False, (_NET,)))
    if draft in _RIBBED and not any(wish.what == _RIBS for wish in found) and _is_knitted(heard, draft):
        found.append(TrimWish(_RIBS, False, (("neck rib", "armhole ribs"), ("neck rib",), ("armhole ribs",))))
    if draft == _OPEN_KNIT and any(wish.change == _HEM_BAND for wish in heard.sure):
        found.append(TrimWish(_RIBS, True, (("knit bands",), ("hem rib",))))
    if draft in _FOR_JACKETS and _is_a_jacket(heard):
        found = [w for w in found if w.said or (w.what, *w.choices[:1]) != ("buttons", ("buttons",))]
    if draft in _FOR_JACKETS and not any(wish.what == "buttons" for wish in found) and _is_a_jacket(heard):
        pocketed = () if any(wish.what == "pockets" for wish in found) else (("buttons", "welt pockets"),)
        found.append(TrimWish("buttons", False, (*pocketed, ("buttons",))))
    if anew and draft in PLEATED and kind == "trousers" and is_bygone(heard.text):
        refused = {*denied_lacks(heard), *[wish.what for wish in found]}
        found += [TrimWish(what, False, ((name,),)) for what, name in _BYGONE if what not in refused]
    own = (*named, *_of_garment(heard))
    taken = {wish.what for wish in found}
    for what, names in loops_and_stitches(kind, draft, cloth=heard.cloth, own=own) if anew else ():
        if what not in taken:
            found.append(TrimWish(what, False, tuple([(name,) for name in names])))
    return tuple(found)


def _has_net_skirt(heard: Heard) -> bool:
    """Whether the skirt alone is of net, which is worn in layers that stand off."""
    return any(look.part == "skirt" and look.cloth in _NETS for look in heard.looks.looks)


def _is_ribbed(heard: Heard) -> bool:
    """Whether what is asked for has ribbed bands: a cardigan, whatever it is cut from."""
    return any(lack.what == _RIBS for lack in heard.lacks)


def _is_a_jacket(heard: Heard) -> bool:
    """Whether what has no lapels is called a jacket, which is closed in front where nothing else is told."""
    marks = () if heard.words is None else heard.words.marks
    named = [entry for mark in marks if not mark.denied for entry in mark.entries]
    lacks = {lack.what for lack in heard.lacks if lack.said}
    jackets = any(draft.name == _TAILORED for entry in named for draft in entry.drafts)
    return jackets and lacks.isdisjoint({"zip", "open_front", "ties", "belt"})


def _is_closed_otherwise(heard: Heard, named: tuple[str, ...], own: tuple[str, ...], draft: str) -> bool:
    """Whether nothing is buttoned in front that usually is: a blouse that closes behind, or is pulled on.

    Args:
        heard: What the text asks for.
        named: Trims that it names.
        own: Buttons that the name of the garment has of its own, if any.
        draft: That it is cut from.
    """
    pulled_on = draft in _PULLED_ON or _BOAT in _claims(heard)
    if draft in _OPEN_COATS and meets_without_fastening(heard.text):
        return True
    return not _INSTEAD.isdisjoint(named) or (pulled_on and not own)


def _is_tied(what: str, said: tuple[str, ...]) -> bool:
    """Whether a skirt that is wound around is to be tied, and not belted."""
    return what != "belt" or "tie belt" in said


def _claims(heard: Heard) -> frozenset[Claim]:
    """What is told of the garment, or likely meant."""
    return frozenset([w.change.claim for w in (*heard.sure, *heard.likely) if isinstance(w.change, Gain)])


def _is_knitted(heard: Heard, draft: str) -> bool:
    """Whether a top is of a knit, whose edges are bound with ribbed bands, and has no frill or bow there."""
    dressed = any(
        name in _named(heard) for group in LIKE_EACH_OTHER if "neck frill" in group for name in group
    )
    return not dressed and (draft == "sweatshirt" or heard.cloth in _KNITS)


def is_of_lace(heard: Heard) -> bool:
    """Whether the garment itself is of lace, whose edges need no other."""
    return any(look.part == "all" and look.cloth == "lace" for look in heard.looks.looks)


def _is_worn_beside(heard: Heard, what: str) -> bool:
    """Whether the text itself names a garment of that name: a skirt with an apron."""
    marks = () if heard.words is None else heard.words.marks
    named = [entry for mark in marks if not mark.denied for entry in mark.entries]
    return any(draft.name == what for entry in named for draft in entry.drafts)


def _refuses_strings(heard: Heard) -> bool:
    """Whether pull-on trousers and the like are to have no drawstring, as they usually have."""
    marks = () if heard.words is None else heard.words.marks
    return any(mark.denied and _STRING in entry.cannot for mark in marks for entry in mark.entries)


def _named(heard: Heard) -> tuple[str, ...]:
    """Trims that words about details name: cargo pockets, double-breasted."""
    marks = () if heard.words is None else heard.words.marks
    entries = [entry for mark in marks if not mark.denied for entry in mark.entries]
    found = tuple(dict.fromkeys([name for e in entries if e.category == _DETAILS for name in e.trims]))
    return _told_where(found)


def _told_where(named: tuple[str, ...]) -> tuple[str, ...]:
    """The same trims; of rips those alone of which the text says where they are, where it does."""
    at_knees = tuple([name for name in KNEE_RIPS if name in named])
    if not at_knees:
        return named
    both = len(at_knees) > 1
    others = [name for name in named if name not in ("rips", *KNEE_RIPS)]
    return (KNEE_RIPS[0] if both else at_knees[0], *others)


def _of_garment(heard: Heard) -> tuple[str, ...]:
    """Trims that names of garments mean: those of cargo trousers."""
    marks = () if heard.words is None else heard.words.marks
    entries = [entry for mark in marks if not mark.denied for entry in mark.entries]
    return tuple(dict.fromkeys([name for e in entries if e.category != _DETAILS for name in e.trims]))


def _usual(what: str, kind: str, cloth: str | None, draft: str) -> tuple[tuple[str, ...], ...]:
    """What it is on garments of the kind, best first."""
    if what == "pockets":
        return _usual_pockets(kind, cloth, draft)
    if what == "buttons":
        if kind in _LOWER:
            return (("fly",),)
        return (("buttons",) if draft in _JACKETS else ("button placket",), ("buttons",))
    if what == "zip":
        if kind in _LOWER:
            return (("fly",), ("side zip",))
        in_front = kind in ("", "top", "tunic") or draft in (*_JACKETS, *_HOODED, "sweatshirt")
        return (("zip",), ("side zip",)) if in_front else (("side zip",), ("back zip",))
    if what in ("belt", "belt_accessory"):
        return (("buckle belt",),) if kind in _LOWER else (("tie belt",), ("buckle belt",))
    if what == "ties":
        return (("side tie",), ("tie belt",)) if draft in _WRAPS else ()
    if (what == "apron" and draft == what) or (what == "ties_accessory" and draft not in WOUND):
        return ()
    if what == "frills":
        return (
            (("hem frill",),)
            if kind in ("skirt", "dress")
            else (("neck frill", "sleeve frills"), ("neck frill",), ("hem frill",))
        )
    if what == "drawstring":
        return (("neck cord",),) if draft in _HOODED else (("drawstring",), ("neck cord",))
    if what == "pleats":
        pleated = "front pleats" if kind in _LOWER else "pleated front"
        return ((pleated,),) if kind in (*_LOWER, "top", "tunic") else ()
    if what == "wrap" or (what == "buckles" and draft not in BIBBED):
        return ()
    if what in (
        "padding",
        "lettering",
        "asymmetric_closing",
        "fur",
        "cut_outs",
        "draped",
        "rib_bands",
        "divided",
    ):
        return ()
    return tuple([(name,) for name in TRIMS_OF.get(what, ())])


def _usual_pockets(kind: str, cloth: str | None, draft: str) -> tuple[tuple[str, ...], ...]:
    if draft == "dungarees":
        return (("bib pocket", "slant pockets"), ("slant pockets",))
    if draft == "hoodie":
        return (("kangaroo pocket",), ("patch pockets",))
    if draft in ("shirt", "polo-shirt", "t-shirt"):
        return (("chest pocket",),)
    if draft == "denim-jacket":
        return (("chest pockets",),)
    if draft == "leggings":  # too close for others
        return (("thigh pocket",),)
    if kind in _LOWER:
        return (("slant pockets", "back pockets"), ("slant pockets",))
    if kind in ("jumpsuit", "playsuit"):
        return (("slant pockets",), ("chest pockets",))
    if kind in ("skirt", "dress"):
        return (("patch pockets",),) if cloth == _DENIM else (("slant pockets",), ("side pockets",))
    if draft in ("blazer", "coat", "waistcoat"):
        return (("welt pockets",), ("patch pockets",))
    others = () if draft == _OPEN_KNIT else (("chest pocket",),)
    return (("patch pockets",), ("welt pockets",), *others)
