"""Lengths as they are meant of coats and jackets."""

from __future__ import annotations

import pytest

from swifttailor.wishes.descriptions.coats_by_length import coats_by_length


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("teddy bear coat brown, really short", "teddy bear jacket brown, to the high hip"),
        ("short black wool coat", "black wool jacket, to the high hip"),
        (
            "red puffer jacket short with a high collar",
            "red puffer jacket, to the high hip with a high collar",
        ),
        ("very short puffer jacket", "puffer jacket, to the high hip"),
        ("blazer, quite short", "blazer, to the high hip"),
        ("three quarter length camel overcoat", "knee length camel overcoat"),
        ("short wool cape with a collar", "wool hip length cape with a collar"),
        ("3/4 coat, navy", "knee length coat, navy"),
        ("red coat long, short collar", "red coat, ankle length, short collar"),
        ("long wool coat with a belt", "ankle length wool coat with a belt"),
        ("camel coat, long", "camel coat, ankle length"),
    ],
)
def test_short_coats_end_at_the_hip_and_long_ones_where_coats_do(text: str, read: str) -> None:
    assert coats_by_length(text) == read


@pytest.mark.parametrize(
    "text",
    [
        "a coat, I'm short",
        "coat for a short woman",
        "a denim jacket with short sleeves",
        "short sleeved jacket",
        "jacket, not too short",
        "a jacket and a short skirt",
        "camel coat with three quarter sleeves",
        "long sleeved wool coat",
        "coat with long sleeves",
        "a wool coat, not too long",
        "a short skirt",
        "a short cape dress",
        "a cape with a short collar",
        "short pea coat",
    ],
)
def test_other_texts_stay(text: str) -> None:
    assert coats_by_length(text) == text
