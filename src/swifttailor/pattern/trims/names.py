"""The trims that a pattern may have, by name, and how its file says them."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from swifttailor.errors import PatternError

TRIMS: Mapping[str, str] = {
    "buttons": "buttons down the front",
    "big buttons": "big buttons down the front",
    "button placket": "a front band with buttons",
    "polo placket": "a short front band with buttons",
    "waist placket": "a front band with buttons down to the waist",
    "double-breasted buttons": "two rows of buttons",
    "zip": "a zip down the front",
    "half zip": "a zip from the neck to the chest",
    "back zip": "a zip down the back",
    "side zip": "a zip in the left side seam",
    "fly": "a fly with a button",
    "chest pocket": "a pocket on the left breast",
    "chest pockets": "two breast pockets with flaps",
    "patch pockets": "two patch pockets",
    "welt pockets": "two welt pockets",
    "kangaroo pocket": "a pocket across the front",
    "front pocket": "a wide pocket in the middle of the front",
    "lower back pockets": "three pockets across the lower back",
    "bib pocket": "a pocket on the bib",
    "side pockets": "pockets in the side seams",
    "slant pockets": "slanted front pockets",
    "back pockets": "two back pockets",
    "back welt pockets": "two welt pockets behind",
    "cargo pockets": "pockets with flaps on the thighs",
    "thigh pocket": "a pocket on the left thigh",
    "tie belt": "a belt that is tied",
    "buckle belt": "a belt with a buckle",
    "quilting": "lines of quilting",
    "turn-ups": "turned-up leg ends",
    "drawstring": "a drawstring at the waist",
    "elastic waist": "elastic in the waistband",
    "back elastic": "elastic in the back of the waistband alone",
    "neck cord": "a cord at the neck",
    "neck rib": "a ribbed band around the neck",
    "armhole ribs": "ribbed bands around the armholes",
    "hem rib": "a ribbed band along the hem",
    "knit bands": "ribbed bands along fronts, neck, hem and sleeves",
    "neck frill": "a frill around the neck",
    "sleeve frills": "frills at the ends of the sleeves",
    "sleeve turn-ups": "turned-up ends of the sleeves",
    "hem frill": "a frill along the hem",
    "front frills": "frills down the front",
    "yoke frill": "a frill around the yoke",
    "hem fringe": "fringe along the hem",
    "edging": "edging in another colour",
    "piping": "piping along the edges",
    "bands": "wide bands in another colour along the edges",
    "narrow bands": "narrow bands in another colour around neck and sleeves",
    "lace trim": "a lace trim along the edges",
    "neck lace": "lace around the neck",
    "fur trim": "fur along the edges",
    "neck fur": "fur at the neck or hood",
    "sleeve fur": "fur at the ends of the sleeves",
    "side stripes": "stripes down the sides",
    "satin stripes": "satin stripes down the legs",
    "sleeve stripes": "stripes down the sleeves",
    "three side stripes": "three stripes down each side",
    "three sleeve stripes": "three stripes down each sleeve",
    "side panels": "side panels in another colour",
    "neck bow": "a bow at the neck",
    "nape bow": "a bow at the nape",
    "waist bow": "a bow at the waist",
    "shoulder bows": "bows on the shoulders",
    "lacing": "lacing down the front",
    "boning": "boning in the bodice",
    "tucks": "tucks beside the middle of the front",
    "apron": "an apron in front",
    "creases": "pressed creases down the legs",
    "pleat lines": "pressed pleats down the legs",
    "front pleats": "pleats below the waistband in front",
    "stirrups": "straps under the feet",
    "keyhole": "a keyhole below the neck",
    "back keyhole": "a keyhole at the back",
    "epaulettes": "epaulettes",
    "arm slits": "slits for the arms",
    "diagonal closing": "a closing from the neck to the armhole",
    "rips": "rips with threads across",
    "knee rips": "a rip at each knee",
    "left knee rip": "a rip at the left knee",
    "right knee rip": "a rip at the right knee",
    "frayed hem": "frayed hems",
    "knee patches": "patches on the knees",
    "back ties": "an opening down the back with ties",
    "back buttons": "buttons down the back",
    "back lacing": "lacing down the back",
    "back bow": "a bow at the back",
    "reflecting bands": "two bands of reflecting tape",
    "asymmetric zip": "a zip aslant across the front",
    "storm flap": "a flap over the right shoulder",
    "smocking": "rows of smocking around the bodice",
    "ruching": "folds gathered along the side seams",
    "cowl folds": "folds that hang below the neck",
    "shoulder drape": "cloth drawn over the left shoulder",
    "shoulder cut-outs": "openings on both shoulders",
    "waist cut-outs": "openings at both sides of the waist",
    "back cut-out": "an opening in the middle of the back",
    "elbow patches": "patches on the elbows",
    "draped folds": "folds drawn across the front",
    "princess seams": "princess seams",
    "princess panels": "princess seams from the shoulders to the hem",
    "yoke": "a yoke",
    "waist frill": "a frill above the waistband",
    "scalloped edge": "arcs along the hem",
    "toggles": "toggles with loops",
    "chest heart": "a heart on the chest",
    "chest star": "a star on the chest",
    "pleated front": "pleats down the front",
    "fine pleats": "narrow pleats all around",
    "neck pleats": "pleats below the neck",
    "shoulder pleats": "pleats below the shoulders",
    "back pleat": "a pleat down the middle of the back",
    "box pleats": "box pleats down fronts and back",
    "sleeve petals": "sleeves of two petals",
    "neck gathers": "gathers below the neck",
    "shoulder gathers": "gathers below the shoulders",
    "train": "a train that lies on the floor behind",
    "long train": "a long train that lies on the floor behind",
    "overskirt": "an overskirt that is open in front",
    "tulle overskirt": "an overskirt of tulle that is open in front",
    "tulle layers": "layers of tulle over the skirt",
    "cups": "cups with seams over the bust",
    "peplum": "a peplum over the hips",
    "back cape": "a cape that hangs from the shoulders behind",
    "topstitching": "stitches in another colour along seams, hems and pockets",
    "belt loops": "loops for a belt",
    "denim seams": "a yoke and the seams of a denim jacket",
    "strap buckles": "buckles where the straps meet the bib",
    "kilt edge": "the edge of the apron with a pin and a buckle",
    "hem border": "a border in another colour along the hem",
    "folded band": "a waistband that is folded over",
    "thumb holes": "holes for the thumbs",
    "sash": "a sash with a bow behind",
    "blouse front": "a white blouse above the bodice",
    "bust gathers": "gathers below the bust",
    "hip knot": "a knot at the left hip",
    "outer skirt": "a short skirt over the legs",
    "shoulder frills": "frills over the shoulders",
    "illusion yoke": "net above the bodice",
    "bustle": "a skirt gathered up behind",
    "hoops": "a skirt held out by hoops",
    "side tie": "a band tied at the left side of the waist",
    "kick pleat": "a pleat above the hem behind",
    "collar buttons": "buttons at the points of the collar",
    "back yoke": "a yoke across the back",
}
"""By name, what each is for people. None joins panels, so none changes how a garment is cut or hangs."""
LIKE_EACH_OTHER = (
    (
        "buttons",
        "big buttons",
        "button placket",
        "double-breasted buttons",
        "zip",
        "polo placket",
        "half zip",
        "waist placket",
        "asymmetric zip",
        "toggles",
    ),
    ("tie belt", "buckle belt", "drawstring", "sash", "side tie"),
    ("elastic waist", "back elastic"),
    ("cargo pockets", "thigh pocket"),
    ("kangaroo pocket", "front pocket"),
    ("hem frill", "hem fringe", "hem rib", "frayed hem", "scalloped edge", "hem border", "knit bands"),
    ("edging", "piping", "bands", "narrow bands", "lace trim", "fur trim", "neck rib", "knit bands"),
    ("cowl folds", "neck rib"),
    ("neck lace", "lace trim"),
    ("neck fur", "fur trim"),
    ("sleeve fur", "fur trim"),
    ("sleeve fur", "sleeve frills", "sleeve turn-ups"),
    ("sleeve petals", "sleeve frills", "sleeve turn-ups", "sleeve stripes", "shoulder cut-outs"),
    ("side stripes", "satin stripes", "three side stripes", "side panels"),
    ("sleeve stripes", "three sleeve stripes"),
    ("back pockets", "back welt pockets"),
    ("neck frill", "neck bow", "neck cord"),
    ("smocking", "ruching", "draped folds", "tucks", "boning", "pleated front", "fine pleats"),
    (
        "neck pleats",
        "shoulder pleats",
        "neck gathers",
        "shoulder gathers",
        "cowl folds",
        "pleated front",
        "fine pleats",
    ),
    ("back pleat", "fine pleats", "box pleats"),
    ("princess seams", "princess panels"),
    ("yoke", "back yoke", "yoke frill", "smocking", "denim seams", "blouse front", "illusion yoke"),
    ("waist frill", "folded band"),
    ("sleeve frills", "sleeve turn-ups", "thumb holes"),
    ("creases", "pleat lines"),
    ("front pleats", "pleat lines"),
    ("back zip", "back ties", "back buttons", "back lacing", "back cut-out"),
    ("keyhole", "cowl folds"),
    ("back keyhole", "back cut-out"),
    ("sleeve stripes", "shoulder cut-outs"),
    ("side panels", "waist cut-outs"),
    ("rips", "knee rips", "left knee rip", "right knee rip", "knee patches"),
    ("chest heart", "chest star"),
    ("train", "long train"),
    ("overskirt", "tulle overskirt", "tulle layers", "peplum", "outer skirt", "hoops"),
    ("bustle", "train", "long train"),
    ("bustle", "overskirt", "tulle overskirt", "tulle layers", "hoops"),
    ("illusion yoke", "neck bow"),
    ("illusion yoke", "lacing"),
    ("illusion yoke", "keyhole"),
    ("shoulder frills", "shoulder bows"),
    ("shoulder frills", "shoulder cut-outs"),
)
"""Groups of which a garment has one at most."""
MOST_BUTTONS = 20
"""So many may close a front, by the number that a pattern states."""
_COUNTED: Mapping[str, str] = {
    "buttons": "{} down the front",
    "big buttons": "{} down the front, big ones",
    "button placket": "a front band with {}",
    "polo placket": "a short front band with {}",
    "waist placket": "a front band with {} down to the waist",
    "double-breasted buttons": "two rows of buttons, {} in all",
}
CLOSES_FRONT = LIKE_EACH_OTHER[0][:5]
"""What closes a front all the way down."""


COUNTED = tuple(_COUNTED)
"""Trims whose buttons are counted."""


def trim_said(name: str, button_count: int = 0) -> str:
    """What a trim is for people, with the number of its buttons where one is stated.

    Args:
        name: One of `TRIMS`.
        button_count: See `Pattern.button_count`.
    """
    if not button_count or name not in _COUNTED:
        return TRIMS[name]
    many = f"{button_count} button{'s' * (button_count != 1)}"
    return _COUNTED[name].format(button_count if name.startswith("double") else many)


def button_count_read(raw: Any) -> int:
    """The number of buttons that a pattern file states under ``properties.button_count``.

    Raises:
        PatternError: It is not a whole number from 1 to `MOST_BUTTONS`.
    """
    if isinstance(raw, int) and not isinstance(raw, bool) and 1 <= raw <= MOST_BUTTONS:
        return raw
    raise PatternError(
        f"properties.button_count: a whole number from 1 to {MOST_BUTTONS} was expected, how many buttons "
        "close the front. Correct or remove it."
    )


_LISTED = f"all {len(TRIMS)} are listed in docs/trims.md"


def trims_read(raw: Any) -> tuple[str, ...]:
    """The trims that a pattern file names under ``properties.trims``.

    Raises:
        PatternError: It is no list of names of `TRIMS`.
    """
    if isinstance(raw, list) and len(raw) <= len(TRIMS) and all(isinstance(name, str) for name in raw):
        unknown = [name for name in raw if name not in TRIMS]
        if not unknown:
            return tuple(dict.fromkeys(raw))
        near = get_close_matches(unknown[0][:40].lower(), TRIMS, n=3)
        hint = f"Names like it: {', '.join(near)}. " if near else ""
        raise PatternError(
            f"properties.trims: there is no trim named {unknown[0][:40]!r}. {hint}{_LISTED.capitalize()}."
        )
    raise PatternError(
        f"properties.trims: a list of names was expected, such as ['buttons', 'tie belt']; {_LISTED}. "
        "Correct or remove it."
    )
