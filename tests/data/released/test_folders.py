"""Folders that strangers made: recognised or refused, clearly, in bounded time, and without leaving them."""

from __future__ import annotations

import json
import os

import pytest
from system_writers import WRITERS, aipparel, chatgarment, garmentcode

from swifttailor.data.released import LAYOUTS, listing, read_outputs
from swifttailor.errors import InputError
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft

SKIRT = {"skirt": draft("circle-skirt")}


def write(path, content) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content))


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_folder_of_one_answer_is_enough(layout, tmp_path):
    """Wherever between the run and the file a person points."""
    WRITERS[layout](tmp_path / "run", SKIRT)
    file = next(tmp_path.rglob("garment.json" if layout == "garmagenet" else "*.json"))
    found = {o.pattern for o in read_outputs(tmp_path) if o.pattern is not None}
    assert len(found) == 1
    if layout not in ("garmagenet", "sewingldm", "garmentcode", "garment-pattern-generator"):
        folder = next(f for f in file.parents if f.parent == tmp_path)
        assert {o.pattern for o in read_outputs(folder) if o.pattern is not None} == found


@pytest.mark.parametrize("layout", sorted(set(LAYOUTS) - {"garmentcode"}))
def test_another_systems_layout_finds_nothing(layout, tmp_path):
    garmentcode(tmp_path / "run", SKIRT)
    with pytest.raises(InputError, match="holds no outputs of"):
        read_outputs(tmp_path, layout)


def test_unknown_layouts_and_folders(tmp_path):
    with pytest.raises(InputError, match=r"no layout 'gpt'\. Accepted: garmentcode, aipparel"):
        read_outputs(tmp_path, "gpt")
    with pytest.raises(InputError, match="is of no known system"):
        read_outputs(tmp_path)
    with pytest.raises(InputError, match="There is no folder"):
        read_outputs(tmp_path / "none")
    write(tmp_path / "file", "")
    with pytest.raises(InputError, match="There is no folder"):
        read_outputs(tmp_path / "file")
    with pytest.raises(InputError):
        read_outputs(tmp_path / "a\0b")


def test_two_systems_in_one_folder(tmp_path):
    aipparel(tmp_path / "a", SKIRT)
    chatgarment(tmp_path / "b", SKIRT)
    with pytest.raises(InputError, match=r"AIpparel and of ChatGarment\. Give the folder of one"):
        read_outputs(tmp_path)
    assert {o.layout for o in read_outputs(tmp_path, "chatgarment")} == {"chatgarment"}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("{", "is not JSON"),
        ("[]", "an object was expected"),
        ("{}", "no 'pattern' object"),
        ('{"pattern": {"panels": {}}}', "panels is empty"),
        ('{"pattern": {"panels": {"a": {"vertices": [[0, NaN]], "edges": []}}}}', "holds NaN"),
        ('{"pattern": {"panels": {"a": {}, "a": {}}}}', "occurs twice"),
        ("[" * 100_000, "nested too deeply"),
        ("\x80\x04\x95", "is not JSON"),
    ],
)
def test_broken_files_cost_one_output(content, message, tmp_path):
    garmentcode(tmp_path, SKIRT)
    write(tmp_path / "bad_specification.json", content)
    bad, good = sorted(read_outputs(tmp_path), key=lambda o: o.id)
    assert bad.pattern is None and message in bad.error and str(tmp_path) not in bad.error
    assert good.error == "" and good.pattern is not None


def test_a_pattern_that_cannot_be_sewn_comes_with_its_fault(tmp_path):
    """An edge in two stitches: the pattern is there to be compared, and a sentence says what is wrong."""
    content = to_specification(draft("circle-skirt"))
    stitches = content["pattern"]["stitches"]
    stitches.append([stitches[0][0], stitches[1][1]])
    write(tmp_path / "twice_specification.json", content)
    (output,) = read_outputs(tmp_path)
    assert output.pattern is not None and "stitch" in output.error


@pytest.mark.skipif(os.name == "nt", reason="links need rights there")
def test_links_are_not_followed(tmp_path):
    garmentcode(tmp_path / "outside", SKIRT)
    inside = tmp_path / "inside"
    inside.mkdir()
    (inside / "folder").symlink_to(tmp_path / "outside")
    (inside / "self").symlink_to(inside)
    file = next((tmp_path / "outside").rglob("*_specification.json"))
    (inside / file.name).symlink_to(file)
    with pytest.raises(InputError, match=r"links are not followed: 'folder' and 2 more"):
        read_outputs(inside)
    garmentcode(inside / "run", {"own": draft("tank-top")})
    assert [o.id for o in read_outputs(inside)] == ["own"]


def test_a_hundred_thousand_files_are_refused(tmp_path):
    garmentcode(tmp_path, SKIRT)
    many = tmp_path / "many"
    many.mkdir()
    for k in range(listing.MAX_ENTRIES):
        os.close(os.open(many / f"{k}", os.O_CREAT))
    with pytest.raises(InputError, match=r"more than 100,000 files and folders"):
        read_outputs(tmp_path)


def test_folders_nested_without_end_are_refused(tmp_path):
    deep = tmp_path
    for _ in range(listing.MAX_DEPTH + 1):
        deep = deep / "d"
    deep.mkdir(parents=True)
    with pytest.raises(InputError, match="deep"):
        read_outputs(tmp_path)


def test_ids_are_unique_and_can_be_written(tmp_path):
    names = ["#7", "skirt", "SKIRT", "x" * 240, "tab\there"]
    for k, name in enumerate(names):
        write(tmp_path / f"{k}" / f"{name[:220]}_specification.json", to_specification(draft("circle-skirt")))
    ids = [o.id for o in read_outputs(tmp_path)]
    assert len({i.lower() for i in ids}) == len(names)
    for id in ids:
        assert 1 <= len(id) <= 200 and id.isprintable() and not id.startswith("#")


def test_both_garments_of_an_answer_tell_their_input(tmp_path):
    chatgarment(
        tmp_path, {"top": draft("t-shirt"), "skirt": draft("circle-skirt"), "dress": draft("shirt-dress")}
    )
    found = [(o.id, o.input) for o in read_outputs(tmp_path) if o.pattern is not None]
    assert found == [("dress", "dress"), ("top_lower", "top"), ("top_upper", "top")]
