from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.cli import making
from swifttailor.errors import InputError
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.tailor.order import LONGEST_TITLE, MOST_ATTEMPTS, MOST_SAMPLES, Order, one_line


@given(st.text(max_size=400))
def test_any_text_becomes_one_short_line(text):
    line = one_line(text)
    assert len(line) <= LONGEST_TITLE
    assert line == line.strip() and "  " not in line
    assert not any(c in line for c in "\n\r\t\0\x1b\u2028\u202e\ud800")
    line.encode("utf-8")


def test_a_line_that_is_not_cut_says_all():
    assert one_line(" a  long\n<b>dress</b> ") == "a long <b>dress</b>"
    assert one_line("长裙 👗") == "长裙 👗"
    assert one_line("x" * 100_000) == "x" * (LONGEST_TITLE - 3) + "..."
    assert one_line("dress\0" + "\n" * 5000).endswith("..."), (
        "a text that was not looked at to its end is cut"
    )


@pytest.mark.parametrize(
    ("order", "title"),
    [
        (Order("a long dress"), "a long dress"),
        (Order("", "photos/me & you.png"), "me & you"),
        (Order("a dress", "photo.png"), "a dress"),
        (Order("", np.zeros((4, 4, 3), np.uint8)), "pattern"),
        (
            Order("make it\nlonger", edit=Pattern(draft("t-shirt").panels, (), "shirt")),
            "shirt: make it longer",
        ),
    ],
)
def test_patterns_are_named_after_what_was_asked_for(order, title):
    assert order.title == title


def test_what_is_told_of_an_order_holds_no_paths_and_is_json():
    told = Order("\ud800\0 长", "/home/me/secret/photo.png", edit=draft("t-shirt")).to_json()
    assert "secret" not in json.dumps(told)
    assert (told["images"], told["edited"], told["attempts"]) == (["photo.png"], "t-shirt", 4)
    assert Order("x", temperature=0.0).to_json()["attempts"] == 1
    assert Order("x", np.zeros((4, 4, 3), np.uint8)).to_json()["images"] == [True]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"samples": 0}, "samples is 0"),
        ({"samples": MOST_SAMPLES + 1}, "samples is 65"),
        ({"attempts": 0}, "attempts is 0"),
        ({"attempts": MOST_ATTEMPTS + 1}, "attempts is 65"),
        ({"samples": 2, "temperature": 0.0}, "all samples are the same"),
        ({"attempts": 2, "temperature": 0.0}, "all attempts are the same"),
    ],
)
def test_orders_that_make_no_sense_are_refused(options, message):
    with pytest.raises(InputError, match=message):
        Order("x", **options)


def test_commands_have_the_limits_of_what_they_call():
    """They do not import them, so that --help stays fast."""
    assert (making.MOST_SAMPLES, making.MOST_ATTEMPTS) == (MOST_SAMPLES, MOST_ATTEMPTS)
    assert making.Making.temperature == USUAL_TEMPERATURE
