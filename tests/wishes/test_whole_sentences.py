"""Letters, of which each sentence is heard, too."""

from __future__ import annotations

import pytest

from swifttailor.describing.differences import Step
from swifttailor.wishes.instructions.whole_sentences import BELIEVED, LONG_WORDS, PLAIN, is_letter, whole_of

SHORTER, LONGER, TIGHTER = Step("length", -1), Step("length", 1), Step("chest", -1)
CHAT = "I have worn it to the theatre and to two birthdays and my sister has borrowed it once or twice."


class Hears:
    """A network that says by heart what a text asks for."""

    def __init__(self, **by_words):
        self.by_words, self.asked = by_words, []

    def whole(self, text, *, instruction=True):
        self.asked.append(text)
        return next(
            (said for word, said in self.by_words.items() if word in text), {SHORTER: 0.01, LONGER: 0.01}
        )


def test_each_sentence_of_a_letter_is_heard():
    letter = f"{CHAT} Now it must be shorter please. Take in the chest."
    hears = Hears(theatre={SHORTER: 0.1, TIGHTER: 0.2}, shorter={SHORTER: 0.9}, chest={TIGHTER: 0.7})
    found = whole_of(letter, hears)
    assert found[SHORTER] == 0.9
    assert found[TIGHTER] == BELIEVED, "not enough to be asked for alone"
    assert len(hears.asked) == 4 and hears.asked[-1] == "Take in the chest."


def test_what_all_of_it_says_stands():
    hears = Hears(theatre={SHORTER: 0.6}, shorter={SHORTER: PLAIN - 0.01})
    assert whole_of(f"{CHAT} Make it shorter, please.", hears) == {SHORTER: 0.6}


@pytest.mark.parametrize("text", ["Shorter. Much shorter. And tighter at the chest.", CHAT.removesuffix(".")])
def test_of_short_texts_and_single_sentences_all_is_heard_at_once(text):
    hears = Hears()
    whole_of(text, hears)
    assert hears.asked == [text]


def test_a_letter_has_many_words():
    assert is_letter("word " * LONG_WORDS) and not is_letter("word " * (LONG_WORDS - 1))
