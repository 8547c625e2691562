"""Word tables: what they say, and what is said about mistakes in them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import swifttailor.wording
from swifttailor.describing import CLAIM_TYPES
from swifttailor.errors import InputError
from swifttailor.wording.claim_marks import claim_topics
from swifttailor.wording.instructions.requests import gain_words, gains_of, steps_of
from swifttailor.wording.word_tables import Row, by_dialect, parse_table, read_table
from swifttailor.wording.wordings import all_wordings, wordings_of

PHRASES = Path(swifttailor.wording.__file__).parent / "phrases"
LENGTHS = """
list length
    short : short
    elbow : elbow-length | half
"""


def said(table: str) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    return [(row.claims, row.texts) for row in parse_table(table, "table.txt")]


def words(table: str):
    return wordings_of(parse_table(table, "table.txt"))


def test_a_row_has_marks_and_texts():
    (row,) = parse_table(
        "# Necklines\n[features]\nneckline=boat neck_depth_cm=? not:hood=hood,collar=lapel about:sides 2.5"
        "\n   : a boat neck {neck_depth_cm} deep | wide @uk\n   # a comment\n   | shallow\n",
        "table.txt",
    )
    assert row == Row(
        place=("table.txt", 3),
        section="features",
        claims=("neckline=boat",),
        numbers=("neck_depth_cm",),
        options={"not": ("hood=hood", "collar=lapel"), "about": ("sides",)},
        words=(),
        number=2.5,
        texts=("a boat neck {neck_depth_cm} deep", "wide @uk", "shallow"),
    )
    assert by_dialect(row.texts)["us"] == ("a boat neck {neck_depth_cm} deep", "shallow")
    assert by_dialect(row.texts)["uk"] == ("a boat neck {neck_depth_cm} deep", "wide", "shallow")


def test_what_stands_behind_a_section_holds_for_its_rows():
    rows = parse_table(
        "[heads] kind=skirt\nany 5 : skirt\nskirt=a-line : A-line skirt\n[heads]\nany : it", "t"
    )
    assert [row.claims for row in rows] == [("kind=skirt",), ("kind=skirt", "skirt=a-line"), ()]


def test_lists_stand_for_each_of_their_entries():
    assert said(f"{LENGTHS}\nsleeves=<length> : <length> sleeves | <first length> ones") == [
        (("sleeves=short",), ("short sleeves", "short ones")),
        (("sleeves=elbow",), ("elbow-length sleeves", "half sleeves", "elbow-length ones")),
    ]
    both = "left_sleeve=<length> right_sleeve=<other length> : <first length> and <other length>"
    assert said(f"{LENGTHS}\n{both}") == [
        (("left_sleeve=short", "right_sleeve=elbow"), ("short and elbow-length", "short and half")),
        (("left_sleeve=elbow", "right_sleeve=short"), ("elbow-length and short",)),
    ]


def test_for_each_repeats_its_rows_entry_by_entry():
    table = f"""{LENGTHS}
list end
    cuffs=band cuff_cm=? : with cuffs
    cuffs=deep           : with deep cuffs
list called
    short : short ones
    elbow : long ones
for each length and called
    sleeves=<length> : <called>
    sleeves=<length> <end> : <first length> sleeves <end>
"""
    assert said(table) == [
        (("sleeves=short",), ("short ones",)),
        (("sleeves=short", "cuffs=band"), ("short sleeves with cuffs",)),
        (("sleeves=short", "cuffs=deep"), ("short sleeves with deep cuffs",)),
        (("sleeves=elbow",), ("long ones",)),
        (("sleeves=elbow", "cuffs=band"), ("elbow-length sleeves with cuffs",)),
        (("sleeves=elbow", "cuffs=deep"), ("elbow-length sleeves with deep cuffs",)),
    ]


@pytest.mark.parametrize(
    ("table", "line", "message"),
    [
        ("hood=hood a hood", 1, "' : ' is missing"),
        ("\nhood=hood : a hood | ", 2, "a text is empty"),
        ("hood=hood : a hood | a hood", 1, "stands there twice"),
        ("hood=hood : a hood @fr", 1, "@uk' or ' @us"),
        ("hood=hood : a @uk hood", 1, "at its end"),
        ("hood=hood 3x : a hood", 1, "'3x' begins like a number"),
        ("hood=hood 30 : a hood", 1, "not above 10"),
        ("hood=hood 0 : a hood", 1, "above 0"),
        ("hood=hood 3 4 : a hood", 1, "two numbers, 3 and 4"),
        ("hood=hood not:a=b not:c=d : a hood", 1, "is there twice"),
        ("hood=hood not: : a hood", 1, "NAME:VALUE"),
        ("hood=<size> : a hood", 1, "no list 'size' above. Known: none"),
        ("    hood=hood : a hood", 1, "under no 'list'"),
        ("list size\nhood=hood : a hood", 1, "nothing stands under 'list size'"),
        (f"{LENGTHS}{LENGTHS}", 6, "no other list has"),
        ("list size\n    a : b\n    a : c", 3, "'a' is in the list 'size' already"),
        (f"{LENGTHS}\nfor each size\n    <size> : b", 6, "no list 'size' above. Known: length"),
        (f"{LENGTHS}\nlist end\n    a : b\nfor each length and end\n    <end> : b", 8, "same entries"),
        (f"{LENGTHS}\nsleeves=<other length> : x", 6, "needs a <length> before it"),
        (f"{LENGTHS}\nsleeves=<last length> : x", 6, "<last length>' is none of"),
        (f"{LENGTHS}\nsleeves=<first length> : x", 6, "in texts, <first list>"),
        ("[heads\nany : x", 1, "no closing bracket"),
    ],
)
def test_what_is_not_in_the_format_is_named_with_its_line(table, line, message):
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        parse_table(table, "table.txt")
    assert str(caught.value).startswith(f"table.txt, line {line}: ")


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("sleve=long : x", "There is no claim 'sleve'. Known: kind,"),
        ("sleeves=lang : x", "'sleeves' has no value 'lang'. Known: none, cap,"),
        ("sleeves=? : {sleeves}", "'sleeves' is no number"),
        ("sleeve_cm=58 : x", "takes a number"),
        ("sleeve_cm=? : long", "each number that is claimed must: 'long'"),
        ("sleeves=long : {sleeve_cm} long", "in braces can stand nothing"),
        ("sleeve_cm=? : {sleeve_cm long", "in braces can stand {sleeve_cm}"),
        ("hood=hood : {it} has a hood", "in braces can stand nothing"),
        ("hood=hood plural : hoods", "'plural' is one of heads"),
        ("hood=hood of:coat : a hood", "of:coat is no kind. Known: top,"),
        ("hood=hood not:collar=big : a hood", "no value 'big'"),
        ("hood=hood was:hood=none : a hood", "no mark 'was:'. Known: about:, of:, not:"),
        (
            "hood=hood : a cowl\nhood=hood 2 : a hood | a cowl",
            "'a cowl' is said of the same",
        ),
    ],
)
def test_mistakes_in_phrases_are_named_with_their_line(row, message):
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        words(f"[features]\n{row}")
    assert str(caught.value).startswith("table.txt, line ")
    assert words("[sentences]\nhood=hood : {it} {has} a hood.")[0].form == "sentence"


def test_sections_are_forms():
    with pytest.raises(InputError, match=r"no section 'feature'. Known: heads, adjectives, features"):
        words("[feature]\nhood=hood : a hood")
    with pytest.raises(InputError, match=r"table\.txt, line 1: there is no section ''"):
        words("hood=hood : a hood")


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("hood=hood : add a hood", "a number from 2 to 9 is missing"),
        ("hood=hood 9 : add a {cowl}", "in braces can stand {band}, {garment}"),
        ("9 : add a hood", "claims such as 'hood=hood'"),
        ("hood=hood 9 : add a hood @uk", "'@' has no meaning here"),
        ("hood=hood 9 : add a hood\nhood=hood 8 : add a hood", "in another row already"),
        ("hood=hood not:hood=big 9 : add a hood", "no value 'big'"),
    ],
)
def test_mistakes_in_gains_are_named(row, message):
    with pytest.raises(InputError, match=re.escape(message)):
        gains_of(parse_table(row, "table.txt"))


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("more sleeves 5 : make the sleeves longer", "no measure 'sleeves'. Known: sleeve_length,"),
        ("longer sleeve_length 5 : make the sleeves longer", "'more' or 'less' and a measure"),
        ("more dip 5 : dip more\nmore dip 5 : dip", "has a row already"),
        ("more dip 5 : dip {by} more", "a text without {by} is wanted too"),
    ],
)
def test_mistakes_in_steps_are_named(row, message):
    with pytest.raises(InputError, match=re.escape(message)):
        steps_of(parse_table(row, "table.txt"))


def test_files_that_are_no_tables_are_refused(tmp_path):
    (tmp_path / "a.txt").write_bytes(b"\xff\xfe\x00")
    for name in ("a.txt", "none.txt"):
        with pytest.raises(InputError, match=f"Cannot read the word table '.*{name}'"):
            read_table(tmp_path / name)


_TEXT = st.text("abc {}'-,.ä/", min_size=1).map(str.strip).filter(lambda t: t and t[0] not in "#|:[")


@given(
    st.lists(st.tuples(st.sampled_from(["a=b", "c=?", "not:d=e,f=g", "plural", "2.5"]), _TEXT), min_size=1)
)
def test_what_is_written_is_read(rows):
    table = "".join(f"x=y {mark}   : {text} | ({text})\n" for mark, text in rows)
    read = parse_table(table, "t")
    assert [row.texts for row in read] == [(text, f"({text})") for _, text in rows]
    assert [row.place for row in read] == [("t", k) for k in range(1, len(rows) + 1)]
    for row, (mark, _) in zip(read, rows, strict=True):
        options = [f"{name}:{','.join(values)}" for name, values in row.options.items()]
        number = [] if row.number is None else [f"{row.number:g}"]
        assert [*row.claims[1:], *(f"{n}=?" for n in row.numbers), *options, *row.words, *number] == [mark]


@given(st.text("ab=:|<>[]@ \n#?0{}", max_size=60))
def test_any_text_is_read_or_refused_with_its_line(text):
    try:
        words(text)
    except InputError as error:
        assert re.match(r"t(able)?\.txt, line \d+: ", str(error))


def test_every_value_that_can_be_claimed_has_words():
    unsaid = {(kind.name, word) for kind in CLAIM_TYPES.values() for word in kind.words}
    unsaid -= {(claim.name, claim.value) for wording in all_wordings() for claim in wording.needs}
    assert unsaid == set()
    numbers = {kind.name for kind in CLAIM_TYPES.values() if kind.measure is not None}
    assert numbers == {name for wording in all_wordings() for name in wording.numbers}


def test_every_change_that_can_be_seen_has_words():
    """But for what a garment is, which is said as captions say it, and what is asked for as more or less."""
    unsaid = {
        (kind.name, word) for kind in CLAIM_TYPES.values() for word in kind.words if kind.name != "kind"
    }
    unsaid -= {(claim.name, claim.value) for wording in gain_words() for claim in wording.claims}
    assert unsaid == {
        *(("hips", value) for value in ("close", "loose")),
        *(("leg_cuffs", value) for value in ("deep", "gathered")),
        ("skirt", "fitted base"),
        ("sleeve_shape", "gathered end"),
        ("slit_size", "high"),
        ("top_hem", "high hip"),
    }


def test_topics_are_those_that_are_spoken_of():
    assert claim_topics().keys() == CLAIM_TYPES.keys()
    assert claim_topics()["skirt_hem"] == "length" and claim_topics()["hood"] == "hood"
    assert not set(claim_topics().values()) - CLAIM_TYPES.keys() - {"length", "back", "waist"}


def test_every_table_is_known_and_says_how_it_is_read():
    names = {"heads", "upper", "sleeves", "lower", "gains", "steps", "topics"}
    assert {path.name for path in PHRASES.iterdir()} == {f"{name}.txt" for name in names}
    for path in PHRASES.iterdir():
        head = path.read_text(encoding="utf-8").split("\n\n")[0].splitlines()
        assert len(head) >= 5 and all(line.startswith("#") for line in head), path
        assert any(" : " in line for line in head), path
