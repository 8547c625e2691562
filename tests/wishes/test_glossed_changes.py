"""Instructions in languages that have no lexicon."""

from __future__ import annotations

import pytest

from swifttailor.describing.differences import Step
from swifttailor.wishes.instructions.spoken_changes import spoken_changes
from swifttailor.wording.lexicon import glossed_change, read_words


@pytest.mark.parametrize(
    ("text", "change"),
    [
        ("dłuższa spódnica", Step("length", 1)),
        ("rękawy o 5 cm krótsze", Step("sleeve length", -1, 5.0)),
        ("gör halsringningen lite djupare, annars är den bra som den är", Step("neck depth", 1)),
        ("lite kortare ärmar tack", Step("sleeve length", -1)),
        ("bredere skjørt", Step("skirt hem", 1)),
        ("højere krave", Step("collar height", 1)),
        ("袖をもっと短くしてください", Step("sleeve length", -1)),
        ("裙子长一点", Step("length", 1)),
        ("소매를 더 길게 해주세요", Step("sleeve length", 1)),
        ("рукава на 5 см длиннее", Step("sleeve length", 1, 5.0)),
        ("юбку покороче, пожалуйста", Step("length", -1)),
        ("eteği biraz daha uzun olsun", Step("length", 1)),
        ("hihat lyhyemmäksi", Step("sleeve length", -1)),
        ("delší rukávy", Step("sleeve length", 1)),
        ("rövidebb ujjak", Step("sleeve length", -1)),
        ("πιο μακριά μανίκια", Step("sleeve length", 1)),
        ("mânecile mai scurte", Step("sleeve length", -1)),
        ("أقصر الأكمام", Step("sleeve length", -1)),
    ],
)
def test_a_few_words_are_enough_for_a_change(text, change):
    plain = glossed_change(text)
    assert change in spoken_changes(plain, read_words(plain, kind="dress"), "dress").changes


@pytest.mark.parametrize(
    "text",
    ["make the sleeves longer", "a den to sort in", "plus long, le dos", "kürzere Ärmel", "więcej", ""],
)
def test_other_texts_stay_as_they_are(text):
    assert glossed_change(text) in (text, "more")
