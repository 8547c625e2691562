"""Details of a garment that an instruction names by where they are: hems, slits, what is around the neck."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.wishes.instructions.change_words import ChangeWord, find_parts
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause

_TOO_CLOSE = re.compile(
    r"(?<!\w)(?:remove|off|away|lose|strangl\w*|chok\w*|scratch\w*|itch\w*|suffocat\w*|weg|würgt|étrangle)(?!\w)"
)
_CHOKES = re.compile(r"(?<!\w)(?:strangl\w*|chok\w*|throttl\w*|suffocat\w*|würgt|étrangle)(?!\w)")
_CLOSED = re.compile(
    r"(?<!\w)(?:close|closed|shut|sew up|sewn up|zu|fermer|cerrar|chiudi|fecha|fechar)(?!\w)"
)
_PAIR = re.compile(
    r"(?<!\w)(?:(?:slits|splits|vents)(?= .*sides?(?!\w))|(?:both|two|each|either) sides?"
    r"|side (?:slits|splits|vents))"
)
_SIDE = re.compile(
    r"(?<!\w)(?:(?P<left>left|links|gauche|izquierda|sinistra|esquerda)"
    r"|(?P<right>right|rechts|droite|derecha|destra|direita)"
    r"|(?P<back>back|behind|hinten|derrière|detrás|dietro|achter|achteraan)"
    r"|(?P<front>front|vorne|devant|delante|davanti|vooraan|na frente|à frente))(?!\w)"
)
_PLACES = {
    "front": "front|vorne|devant|delante|davanti|vooraan|na frente|à frente",
    "back": "back|behind|hinten|derrière|detrás|dietro|achter|achteraan",
    "right": "right|rechts|droite|derecha|destra|direita",
    "left": "side|left|leg|links|seite|seitlich|côté|gauche|lado|izquierda|add|put|cut|open"
    r"|lato|sinistra|esquerda|laterale|zijkant|opzij|zijsplit"
    r"|an? (?:\w+ )?slit",
}
"""Where a slit is, by words; "at the side" is at the left."""


def hem_shape(
    said: str, part: str | None, word: ChangeWord, kind: str, amount: float | None = None
) -> tuple[Change, ...]:
    """A hem that is to be longer on one side alone.

    Args:
        said: The clause, in lower case.
        part: That the word is said of.
        word: The word of change.
        kind: Of the garment.
        amount: By how many cm, where that is said.
    """
    if word.what == "width" or kind in ("trousers", "shorts"):
        return ()
    # "The back longer" is said of the hem, "the back lower" of the neckline.
    if part not in (None, "all", "hem", "skirt") and (part, word.what) != ("back", "length"):
        return ()
    side = _SIDE.search(said)
    if side is None:
        return ()
    longer = word.sign > 0 if word.what == "length" else word.sign < 0
    if side["left"] or side["right"]:
        return (Gain(Claim("hem_shape", f"lower {'left' if bool(side['left']) == longer else 'right'}")),)
    if word.what == "height" and part not in ("hem", "skirt") and kind != "skirt":
        # "Too low in front" is said of the neckline where no hem is named.
        quantity = "neck depth" if side["front"] else "back depth"
        return (Step(quantity, 1 if longer else -1, amount),)
    behind = bool(side["back"]) == longer
    if amount is not None and (word.what == "length" or part in ("hem", "skirt")):
        return (Step("dip", 1 if behind else -1, amount),)
    if behind:
        return (Gain(Claim("hem_shape", "high-low")),)
    return (Step("dip", -1),)


def slit(said: str, denied: bool) -> list[Change]:
    """Where a slit is to be cut, or that it is to be closed."""
    if denied or _CLOSED.search(said):
        return [Gain(Claim("slit", "none"))]
    if _PAIR.search(said):
        return [Gain(Claim("slit", "left")), Gain(Claim("slit", "right"))]
    place = next(
        (name for name, words in _PLACES.items() if re.search(rf"(?<!\w)(?:{words})(?!\w)", said)), None
    )
    return [] if place is None else [Gain(Claim("slit", place))]


def slit_step(word: ChangeWord, is_so: Callable[[Claim], bool], amount: float | None) -> tuple[Change, ...]:
    """Slits that are there made longer or shorter.

    Args:
        word: The word of change.
        is_so: Whether a claim is true of the garment.
        amount: By how many cm, where that is said.
    """
    if word.what == "width":
        return ()
    return tuple([Step(f"{p} slit", word.sign, amount) for p in _PLACES if is_so(Claim("slit", p))])


def at_the_neck(text: str, clause: SpokenClause, is_so: Callable[[Claim], bool]) -> SpokenClause:
    """A collar that is not named: "remove what is around the neck", "the neck is strangling me"."""
    said = text[clause.start : clause.end]
    named = {p.part for p in find_parts(said)}
    if _CHOKES.search(said) and named & {"neck", "collar"}:
        high = any(is_so(Claim("collar", each)) for each in ("stand", "turtleneck"))
        if "collar" in named or not high:
            step = Step("collar height", -1) if high else Step("neck depth", 1)
            return replace(clause, changes=(step,), left_over=())
    if clause.changes or not any(p.part == "neck" for p in find_parts(said)) or not _TOO_CLOSE.search(said):
        return clause
    collars = [Claim("collar", kind) for kind in ("stand", "turtleneck", "lapel")]
    if not any(is_so(collar) for collar in collars):
        return clause
    return replace(clause, changes=(Gain(Claim("collar", "none")),), left_over=())
