"""What is told of how a text was heard: colours, what cannot be made, what was not understood."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from swifttailor.tailor.fabric_asked import SEWN_FABRIC, fabric_unmet
from swifttailor.tailor.order import one_line

if TYPE_CHECKING:
    from swifttailor.tailor.reading import Wanted

MOST_WORDS = 8
"""Words of a text that a note names; the report has all."""


def heard_report(wanted: Wanted) -> dict[str, Any]:
    """What a report says of the words of an order: JSON values."""
    from swifttailor.wording.wish_lines import wish_line

    heard = wanted.heard
    return {
        "language": None if heard.words is None else heard.words.language,
        "foreign": heard.foreign,
        "kind_is_guessed": wanted.kind_is_guessed,
        "likely": [
            {"wish": wish_line(w.change), "certainty": round(w.certainty, 3)}
            for w in wanted.likely
            if w not in wanted.seen
        ],
        "refused": [f"{claim.name}: {claim.value}" for claim in heard.never],
        "color": heard.color,
        "print": None if heard.print is None else heard.print.to_json(),
        "looks": list(heard.looks.lines),
        "looks_assumed": list(heard.looks.assumed),
        "cloth": heard.cloth,
        "cloth_unmet": fabric_unmet(wanted) is not None,
        "cannot": list(heard.cannot),
        "left_out": list(heard.left_out),
        "taken_to_mean": {words: [wish_line(c) for c in changes] for words, changes in heard.taken},
        "unsure": [wish_line(change) for change in heard.unsure],
        "perhaps": [wish_line(change) for change in heard.perhaps],
        "contradictions": [list(pair) for pair in heard.contradictions],
    }


def heard_notes(wanted: Wanted) -> list[str]:
    """The same for a person; nothing where all of the text is clear."""
    from swifttailor.wording.lexicon.inflection import NAMES
    from swifttailor.wording.wish_lines import wish_line

    heard, found = wanted.heard, []
    if heard.words is not None and heard.words.language != "en":
        found.append(f"Read as {NAMES[heard.words.language]}, by the words of its lexicon.")
    if heard.foreign is not None:
        *others, last = [name for language, name in NAMES.items() if language != "en"]
        found.append(
            f"This seems to be {heard.foreign}, which is not read. English is, and {', '.join(others)} and "
            f"{last} by their words of clothes."
        )
    if heard.unread:
        found.append(f"Not understood: {_quoted(heard.unread)}.")
    for words, changes in heard.taken:
        found.append(f'"{one_line(words)}" is taken to mean: {"; ".join(map(wish_line, changes))}.')
    if heard.unsure:
        found.append(f"Not sure that this is meant: {'; '.join(map(wish_line, heard.unsure))}.")
    if heard.perhaps:
        found.append(f"Perhaps meant as well, and not done: {'; '.join(map(wish_line, heard.perhaps))}.")
    if heard.guess:
        found.append(f'Which garment is meant does not follow from the text; "{heard.guess}" is a guess.')
    elif wanted.kind_is_guessed:
        near = f" Names that are known: {_quoted(heard.near)}." if heard.near else ""
        found.append(f"Which garment is meant was not understood, so this one is a guess.{near}")
    found += [f"{_quoted(pair)} contradict each other." for pair in heard.contradictions]
    if heard.color is not None and heard.words is not None:
        others = heard.missed_colors
        more = f"; of several colours the first is used, so not {_quoted(others)}" if others else ""
        named = f"{heard.words.colors[0].words} ({heard.color})" if heard.words.colors else heard.color
        found.append(f"Colour: {named}{more}.")
    if heard.print is not None:
        from swifttailor.wishes.looks.heard_print import print_line

        found.append(f"Print: {print_line(heard.print)}.")
    if heard.looks.looks:
        found.append(f"Parts in a look of their own: {'; '.join(heard.looks.lines)}.")
    if heard.looks.looks and heard.looks.assumed:
        found.append(f"Assumed of it: {'; '.join(heard.looks.assumed)}.")
    found += _fabric_notes(wanted)
    if heard.cannot:
        found.append(f"Cannot be made: {'; '.join(heard.cannot)}.")
    if heard.left_out:
        found.append(f"Usual, and left out since it cannot be made: {'; '.join(heard.left_out)}.")
    return found


def _fabric_notes(wanted: Wanted) -> list[str]:
    """A fabric that was chosen, or that is met; one that is not met is a warning (`fabric_warning`)."""
    heard, order = wanted.heard, wanted.order
    if order.fabric is not None:
        name = order.fabric if isinstance(order.fabric, str) else order.fabric.name
        return [fabric_line(name, finish=order.finish)]
    if heard.cloth is not None and order.finish:
        return [fabric_line(heard.cloth, finish=True)]
    if heard.cloth == SEWN_FABRIC and heard.words is not None and heard.words.cloths:
        return [f"Fabric: {heard.cloth}, which every garment hangs like without --finish."]
    return []


def fabric_line(name: str, *, finish: bool) -> str:
    """What a fabric was used for.

    Args:
        name: Of the fabric.
        finish: Whether the garment hung to rest by physics.
    """
    if finish:
        return f"Fabric: {name}, the cloth that it was finished with."
    return (
        f"Fabric: {name}, in weight and shine alone: the network knows no fabrics and hangs all as cotton. "
        "With --finish physics hangs it."
    )


def _quoted(words: Sequence[str]) -> str:
    said = ", ".join(f'"{one_line(word)}"' for word in words[:MOST_WORDS])
    return said if len(words) <= MOST_WORDS else f"{said} and {len(words) - MOST_WORDS} more"
