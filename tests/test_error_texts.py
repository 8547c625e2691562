"""Errors say what is wrong at a length that can be read, whatever they quote."""

from __future__ import annotations

import pickle

import pytest

from swifttailor.errors import InputError, SwiftTailorError


@pytest.mark.parametrize("length", [0, 10, 1500])
def test_texts_of_usual_length_stay_as_they_are(length):
    assert str(SwiftTailorError("x" * length)) == "x" * length


@pytest.mark.parametrize("length", [1501, 5_000_000])
def test_of_long_texts_the_start_and_the_end_are_kept(length):
    text = str(InputError(f"The file 'a.json' is damaged: {'x' * length}. Copy it again."))
    assert text.startswith("The file 'a.json' is damaged: xxx") and text.endswith("xxx. Copy it again.")
    assert len(text) < 1500 and f"{length + 46 - 1400} characters" in text


def test_shortened_errors_survive_the_way_between_processes():
    error = InputError("y" * 9000)
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is InputError and str(again) == str(error)
