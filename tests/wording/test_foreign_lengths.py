"""Words of other languages for how long skirts, tops, legs and sleeves are."""

from __future__ import annotations

from pathlib import Path

import pytest

from swifttailor.wording.lexicon import read_words


def _rows():
    """Language, claim and a text that means it."""
    entries: list[str] = []
    for line in Path(__file__).with_name("foreign_lengths.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith(" "):
            entries[-1] += f" {line.strip()}"
        elif line and not line.startswith("#"):
            entries.append(line)
    for entry in entries:
        said_of, _, texts = entry.partition(" : ")
        language, _, claim = said_of.partition(" ")
        for text in texts.split(" | "):
            yield language, claim, text


ROWS = [pytest.param(*row, id=f"{row[0]}: {row[2]}") for row in _rows()]
LANGUAGES = ("de", "es", "fr", "it", "nl", "pt")


@pytest.mark.parametrize(("language", "claim", "text"), ROWS)
def test_lengths_are_read_in_other_languages(language, claim, text):
    reading = read_words(text)
    assert reading.language == language
    assert not reading.unknown
    name = claim.partition("=")[0]
    found = [f"{i.claim.name}={i.claim.value}" for i in reading.implications if i.claim.name == name]
    assert found == [claim]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_length_is_tried_in_each_language(language):
    tried = {each: {claim for said, claim, _ in _rows() if said == each} for each in LANGUAGES}
    assert tried[language] == set.union(*tried.values())
