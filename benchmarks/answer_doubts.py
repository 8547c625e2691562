"""What an answer says is wrong with it or was not understood: where it says nothing, a mistake is silent."""

from __future__ import annotations

from swifttailor.tailor.answer import USUAL, Answer
from swifttailor.wording.wish_lines import wish_line

_UNSURE = "may"


def is_unsure_alone(answer: Answer) -> bool:
    """Whether nothing is said but that readers of the text are not sure of a wish."""
    said = doubts(answer)
    return bool(said) and all(doubt.startswith(f"{_UNSURE} ") for doubt in said)


def doubts(answer: Answer) -> list[str]:
    """What a person reads on the terminal that tells them to look; nothing where all seems well.

    What the name of a garment means and cannot be made (a drawstring of trousers) is said, too, but is no
    doubt about what the text asks for, so it does not count here.
    """
    wanted = answer.wanted
    assert wanted is not None
    heard = wanted.heard
    found = [f"not met: {wish_line(change)}" for change in answer.verdict.open]
    found += [f"refused: {wish_line(change)}" for change in answer.verdict.refused]
    found += [f"sits badly: {what}" for what in answer.verdict.sits_badly]
    found += ["nothing understood"] if wanted.misses else []
    found += ["kind is a guess"] if wanted.kind_is_guessed else []
    found += [f"not understood: {word}" for word in heard.unread]
    found += [f"{_UNSURE} not be meant: {wish_line(change)}" for change in heard.unsure]
    found += [f"{_UNSURE} be meant: {wish_line(change)}" for change in heard.perhaps]
    found += [f"cannot be made: {what}" for what in heard.cannot]
    found += [f"contradiction: {one}, {other}" for one, other in heard.contradictions]
    found += [f"said, and not so: {word}" for word, _ in answer.not_so]
    found += [f"changed unasked: {wish_line(change)}" for change in answer.unasked]
    found += [] if answer.moved_waist is None else ["the waist was to stay"]
    missing = [wish.change for wish in answer.not_done if wish.certainty >= USUAL]
    found += [f"not done: {wish_line(change)}" for change in missing]
    found += wanted.warnings
    return [*found, "nothing was changed"] if answer.is_given else found


def left_out(answer: Answer) -> list[str]:
    """What the names of garments in the text mean and cannot be made, as the terminal says it."""
    wanted = answer.wanted
    return [] if wanted is None else [f"usual, and left out: {what}" for what in wanted.heard.left_out]
