"""Real patterns changed by words, with the weights of the package."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from soundness import MADE_FILES, assert_sound

from swifttailor.cli.main import run
from swifttailor.describing import Claim, GarmentFacts, measure_facts
from swifttailor.pattern import write_pattern

Change = Callable[[GarmentFacts, GarmentFacts], bool]


def claims(**values: str | float) -> Change:
    """After it these hold, and before it not all of them."""
    stated = [Claim(name, value) for name, value in values.items()]
    return lambda before, after: (
        all(c.holds(after) for c in stated) and not all(c.holds(before) for c in stated)
    )


def hem_falls(low: float, high: float) -> Change:
    """The hem hangs so many cm lower."""
    return lambda before, after: low <= before.hem.level - after.hem.level <= high


EDITS: list[tuple[str, str, Change]] = [
    ("gc_1000981", "make it 10 cm shorter", hem_falls(-11.5, -8.5)),
    ("gc_1000981", "add long sleeves", claims(sleeves="long")),
    ("gc_1000326", "make it 15 cm longer", hem_falls(13, 17)),
    ("gc_1005537", "remove the sleeves", claims(sleeves="none")),
    ("gc_1000272", "give it a round neckline", claims(neckline="round")),
    ("gc_1001309", "take the hood off", claims(hood="none")),
    ("gc_1002218", "turn them into shorts", claims(kind="shorts")),
    ("gc_1005599", "make it floor length", claims(skirt_hem="floor")),
    ("gc_1001339", "crop it", claims(top_hem="cropped")),
    ("gc_1002766", "make the legs knee-length", claims(leg_hem="knee")),
]


@pytest.mark.parametrize(("name", "instruction", "done"), EDITS, ids=[f"{e[0]}: {e[1]}" for e in EDITS])
def test_what_is_asked_for_is_changed(name, instruction, done, shipped_patterns, tmp_path, capsys):
    base = shipped_patterns[name]
    write_pattern(base, tmp_path / "base.json")
    out = tmp_path / "out"
    assert run(["edit", str(tmp_path / "base.json"), instruction, "--out", str(out), "--no-preview"]) == 0
    pattern, facts, report = assert_sound(out, MADE_FILES)
    assert pattern.canonical() != base.canonical()
    assert done(measure_facts(base), facts)
    assert report["wishes"] and all(wish["holds"] for wish in report["wishes"])


def test_a_garment_of_words_is_changed_twice(tmp_path, capsys):
    """From folder to folder, as in the README."""
    a, b, c = (str(tmp_path / name) for name in "abc")
    common = ["--no-preview", "--seed", "3"]
    assert run(["generate", "a knee-length dress", "--out", a, *common]) == 0
    assert run(["edit", a, "make it 12 cm longer", "--out", b, *common]) == 0
    assert run(["edit", b, "a V neck, please", "--out", c, *common]) == 0
    facts = [assert_sound(tmp_path / folder, MADE_FILES)[1] for folder in "abc"]
    assert hem_falls(10.5, 13.5)(facts[0], facts[1])
    assert abs(facts[2].hem.level - facts[1].hem.level) < 1.5
    assert Claim("neckline", "v").holds(facts[2])
