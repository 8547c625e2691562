"""Tables of sayings are read, and searched as one pattern."""

from __future__ import annotations

import pytest

from swifttailor.errors import InputError
from swifttailor.wishes.descriptions import sayings_of_wishes
from swifttailor.wishes.instructions import sayings as sayings_of_instructions
from swifttailor.wishes.text.sayings_table import read_sayings

TABLE = """
[parts of patterns]
hue
    red|blue

[asides]
knee
    knee (?P<what>room|cap)

[sayings]
long sleeves
    (?P<what>arms|sleeves) down to my hands
a \\g<hue> top  of:top
    something (?P<hue>{hue}) for the top
"""


@pytest.fixture
def table(tmp_path):
    def read(text):
        path = tmp_path / "sayings.txt"
        path.write_text(text)
        return read_sayings(path)

    return read


@pytest.mark.parametrize(
    ("text", "aside", "saying"),
    [
        ("a top with arms down to my hands", False, True),
        ("something blue for the top", False, True),
        ("forearms down to my hands", False, False),
        ("with knee room", True, False),
        ("trousers", False, False),
    ],
)
def test_one_search_finds_what_any_finds(table, text, aside, saying):
    found = table(TABLE)
    assert (bool(found.any_aside.search(text)), bool(found.any_saying.search(text))) == (aside, saying)
    assert any(one.pattern.search(text) for one in found.sayings) == saying
    assert [one.kinds for one in found.sayings] == [frozenset(), frozenset({"top"})]


def test_an_empty_table_finds_nothing(table):
    assert table("").any_saying.search("anything") is None


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("(red", r"sayings\.txt, line 3: the pattern cannot be read"),
        (r"(?P<one>red) (?P=one)", r"sayings\.txt, line 3: a saying may not refer to its own groups"),
        ("{blue}", r"line 3: there is no part of patterns 'blue'"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(table, line, message):
    with pytest.raises(InputError, match=message):
        _ = table(f"[sayings]\nplain\n    {line}\n").any_saying


@pytest.mark.parametrize("own", [sayings_of_wishes._table(), sayings_of_instructions._table()])
def test_every_pattern_of_the_package_can_be_read(own):
    for one in (*own.sayings, *own.asides):
        assert one.pattern.search("") is None, one.place
