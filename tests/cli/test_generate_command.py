"""``swifttailor generate`` and ``swifttailor edit``, from the command line to the files."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from swifttailor.cli.main import run
from swifttailor.errors import InputError
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.garment import Garment
from swifttailor.pattern import load_pattern, write_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker import maker as maker_module
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.network import model_file
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits

TESTS = Path(__file__).parents[1]
from scripted_maker import crossed, scripted_maker  # noqa: E402

TINY_MAKER = str(TESTS / "pattern_maker" / "tiny_maker.zip")
TINY_SEWER = str(TESTS / "garment_sewer" / "tiny_sewer.onnx")
FILES = {
    ".swifttailor",
    "pattern.json",
    "pattern.svg",
    "garment.glb",
    "garment.obj",
    "preview.png",
    "ggi.npz",
    "report.json",
}


@pytest.fixture
def write(monkeypatch):
    """Lets the network write the given patterns, whatever weights are named."""

    def given(*rounds):
        maker = scripted_maker(*rounds)
        monkeypatch.setattr(PatternMaker, "load", staticmethod(lambda weights=None, threads=1: maker))
        return maker

    return given


def command(*arguments) -> int:
    return run([*map(str, arguments), "--sewer-weights", TINY_SEWER])


def test_words_to_a_folder(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert command("generate", "a T-shirt", "--source", "writer", "--out", tmp_path / "out") == 0
    said = capsys.readouterr()
    assert "8 panels, 14 stitches" in said.out and "preview.png" in said.out
    assert "writing" in said.err and "saving" in said.err
    assert {p.name for p in (tmp_path / "out").iterdir()} == FILES
    garment = Garment.load(tmp_path / "out")
    assert garment.report["order"]["text"] == "a T-shirt"
    with Image.open(tmp_path / "out" / "preview.png") as preview:
        picture = np.asarray(preview)
    assert picture.std() > 10, "something is to be seen"


def test_the_same_folder_again_is_replaced_and_other_files_stay(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert command("generate", "a T-shirt", "--out", tmp_path) == 0
    assert (tmp_path / "preview.png").is_file()
    (tmp_path / "note.txt").write_text("mine")
    write([draft("trousers")])
    assert command("generate", "trousers", "--out", tmp_path, "--no-preview") == 0
    assert Garment.load(tmp_path).report["order"]["text"] == "trousers"
    assert (tmp_path / "note.txt").read_text() == "mine"
    assert not (tmp_path / "preview.png").exists(), "a picture of another garment is none"


@pytest.mark.parametrize("name", ["pattern.json", "garment.glb", "report.json", "ggi.npz", "preview.png"])
def test_files_that_others_have_made_are_never_replaced(name, write, tmp_path, capsys):
    maker = write([draft("t-shirt")])
    (tmp_path / name).write_text("my own work")
    assert command("generate", "a T-shirt", "--out", tmp_path) == 2
    assert "would be replaced" in capsys.readouterr().err
    assert (tmp_path / name).read_text() == "my own work"
    assert [p.name for p in tmp_path.iterdir()] == [name] and not maker.model.runtime.asked


def test_two_garments_that_are_worn_together_get_a_folder_each(tmp_path, capsys):
    wish = "a white blouse and a black pencil skirt"
    assert command("generate", wish, "--out", tmp_path / "out") in (0, 1)
    said = capsys.readouterr().out
    assert 'upper: Of the two garments, the upper one: "a white blouse".' in said
    assert {p.name for p in (tmp_path / "out").iterdir()} == {"upper", "lower", "sheet.png", ".swifttailor"}
    for name, words, color in (
        ("upper", "a white blouse", "#ffffff"),
        ("lower", "a black pencil skirt", "#000000"),
    ):
        garment = Garment.load(tmp_path / "out" / name)
        order = garment.report["order"]
        assert (order["text"], order["part"], order["words"]) == (wish, name, words)
        assert garment.report["heard"]["color"] == color and not garment.report["heard"]["cannot"]
    assert command("generate", wish, "--part", "lower", "--no-preview", "--out", tmp_path / "one") in (0, 1)
    assert Garment.load(tmp_path / "one").report["order"]["words"] == "a black pencil skirt"
    assert command("generate", wish, "--part", "whole", "--no-preview", "--out", tmp_path / "whole") == 1
    assert "several garments at once" in Garment.load(tmp_path / "whole").report["heard"]["cannot"][0]


def test_a_garment_that_was_alone_gives_place_to_several(write, tmp_path):
    out = tmp_path / "out"
    arguments = ("generate", "a <wuzzle>", "--out", out, "--source", "writer", "--no-preview")
    write([draft("t-shirt")])
    assert command(*arguments) in (0, 1)
    assert (out / "pattern.json").is_file()
    (out / "notes.txt").write_text("mine")
    write([draft("t-shirt"), draft("fitted-skirt")])
    assert command(*arguments, "--samples", 2) in (0, 1)
    assert {p.name for p in out.iterdir()} == {".swifttailor", "notes.txt", "seed-0", "seed-1"}


def test_several_samples_get_a_folder_each_and_a_sheet(write, tmp_path, capsys):
    script = [draft("t-shirt"), crossed(draft("t-shirt")), draft("fitted-skirt")], [crossed(draft("t-shirt"))]
    write(*script)
    out = tmp_path / "out"
    arguments = (
        "generate",
        "some <wuzzles>",
        "--out",
        out,
        "--source",
        "writer",
        "--samples",
        3,
        "--seed",
        5,
    )
    assert command(*arguments, "--attempts", 2, "--json") == 1
    reports = json.loads(capsys.readouterr().out)
    assert [Path(r["folder"]).name for r in reports] == ["seed-5", "seed-6", "seed-7"]
    assert ["error" in r for r in reports] == [False, True, False]
    assert {p.name for p in out.iterdir()} == {".swifttailor", "seed-5", "seed-7", "sheet.png"}
    assert all({p.name for p in (out / n).iterdir()} == FILES for n in ("seed-5", "seed-7"))
    with Image.open(out / "sheet.png") as sheet:
        assert sheet.width > 2 * 480 and np.asarray(sheet).std() > 10
    write(*script)
    assert command(*arguments) == 1, "once more into the same folder"
    said = capsys.readouterr().out
    assert "seed-6: not made." in said and "seed-7: 4 panels" in said and "sheet.png" in said


def test_a_sheet_that_others_have_made_is_never_replaced(write, tmp_path, capsys):
    write([draft("t-shirt")])
    (tmp_path / "sheet.png").write_text("mine")
    assert command("generate", "a T-shirt", "--out", tmp_path, "--samples", 2) == 2
    assert (tmp_path / "sheet.png").read_text() == "mine"


def test_nothing_made_is_exit_code_2_and_leaves_nothing(write, tmp_path, capsys):
    write([crossed(draft("t-shirt"))])
    for samples in (1, 2):
        asked = ("generate", "a T-shirt", "--source", "writer", "--out", tmp_path / "out")
        assert command(*asked, "--samples", samples) == 2
        assert "None of the 4 patterns" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_warning_is_exit_code_1(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert (
        command("generate", "一条长裙", "--source", "writer", "--out", tmp_path / "out", "--no-preview") == 1
    )
    said = capsys.readouterr().out
    assert said.count("warning: The text is in a script") == 1


def test_a_picture_to_a_folder(write, tmp_path, capsys):
    maker = write([draft("t-shirt")])
    pixels = np.full((200, 300, 3), 230, np.uint8)
    pixels[30:90, 20:80] = (180, 20, 30)
    Image.fromarray(pixels).save(tmp_path / "Häkelkleid <1>.jpg")
    arguments = (
        "generate",
        "--image",
        tmp_path / "Häkelkleid <1>.jpg",
        "--out",
        tmp_path / "out",
        "--no-preview",
        "--no-alter",
    )
    assert command(*arguments) == 0
    assert "was cropped" in capsys.readouterr().out
    assert len(maker.model.runtime.pictures) == 1
    assert "<title>Häkelkleid &lt;1&gt;</title>" in (tmp_path / "out" / "pattern.svg").read_text(
        encoding="utf-8"
    )
    assert command(*arguments, "--no-crop") == 0
    assert "was cropped" not in capsys.readouterr().out


def test_a_pattern_is_edited_from_a_file_or_a_folder(write, tmp_path, capsys):
    write([draft("t-shirt")])
    write_pattern(draft("tank-top"), tmp_path / "top.json")
    assert (
        command("edit", tmp_path / "top.json", "add short sleeves", "--out", tmp_path / "one", "--no-preview")
        == 0
    )
    report = Garment.load(tmp_path / "one").report
    assert (report["order"]["edited"], report["order"]["text"]) == ("top", "add short sleeves")
    write([draft("tank-top")])
    assert command("edit", tmp_path / "one", "no sleeves", "--out", tmp_path / "two", "--no-preview") == 0
    panels = {p.name for p in load_pattern(tmp_path / "two" / "pattern.json").panels}
    assert panels == {p.name for p in draft("tank-top").panels}


def test_a_faulty_pattern_is_edited_once_it_is_mended(write, tmp_path, capsys):
    write([draft("t-shirt")])
    specification = json.loads(write_pattern(draft("tank-top"), tmp_path / "top.json").read_text())
    stitches = specification["pattern"]["stitches"]
    stitches.append(stitches[0])
    (tmp_path / "top.json").write_text(json.dumps(specification))
    arguments = ("edit", tmp_path / "top.json", "longer", "--out", tmp_path / "out", "--no-preview")
    assert command(*arguments) == 2
    assert not (tmp_path / "out").exists()
    assert command(*arguments, "--repair") == 0


def test_the_pattern_that_is_edited_is_never_replaced(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert command("generate", "a T-shirt", "--out", tmp_path, "--no-preview") == 0
    before = (tmp_path / "pattern.json").read_bytes()
    for source in (tmp_path, tmp_path / "pattern.json"):
        assert command("edit", source, "longer", "--out", tmp_path) == 2
        assert "would replace the one that is edited" in capsys.readouterr().err
    assert (tmp_path / "pattern.json").read_bytes() == before


def test_which_way_a_folder_means_its_angles(tmp_path, monkeypatch):
    read: list[str] = []

    def refuse(source, rotation):
        read.append(rotation)
        raise InputError("read")

    monkeypatch.setattr("swifttailor.pattern.read_pattern_file", refuse)
    pattern = write_pattern(draft("t-shirt"), tmp_path / "pattern.json") or tmp_path / "pattern.json"

    def rotation(source: Path, report: object, *more: str) -> str:
        (tmp_path / "report.json").write_text(json.dumps(report))
        assert command("edit", source, "longer", "--out", tmp_path / "out", *more) == 2
        return read[-1]

    told = {"edge_length_cm": 2.0, "rotation": "extrinsic"}
    assert rotation(tmp_path, told) == "extrinsic"
    assert rotation(tmp_path, told, "--rotation", "intrinsic") == "intrinsic"
    assert rotation(pattern, told) == "intrinsic", "a file says nothing of its folder"
    assert rotation(tmp_path, []) == "intrinsic"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["generate"], "Nothing was requested"),
        (["generate", " "], "Nothing was requested"),
        (["generate", "photo.PNG"], "--image photo.PNG"),
        (["generate", "x", "--samples", "0"], "--samples is 0"),
        (["generate", "x", "--seed", "-1"], "--seed is -1"),
        (["generate", "x", "--seed", str(2**63 - 1), "--samples", "2"], "--seed is 9223372036854775808"),
        (["generate", "x", "--temperature", "nan"], "--temperature is nan"),
        (["generate", "x", "--attempts", "100"], "--attempts is 100"),
        (["generate", "x", "--edge-length", "0.1"], "--edge-length is 0.1"),
        (["generate", "x", "--threads", "0"], "--threads is 0"),
        (["generate", "x", "--temperature", "0", "--samples", "2"], "all samples are the same"),
        (["generate", "x", "--maker-weights", "none.zip"], "Cannot read the weights 'none.zip'"),
        (["generate", "--image", "none.png", "--maker-weights", TINY_MAKER], "There is no picture"),
        (["edit", "none.json", " "], "The instruction is empty"),
        (["edit", "none.json", "longer"], "Cannot read 'none.json'"),
    ],
)
def test_what_cannot_work_is_refused(arguments, said, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run([*arguments, "--out", "out", "--sewer-weights", TINY_SEWER]) == 2
    assert said in capsys.readouterr().err
    assert not any(tmp_path.iterdir())


def test_without_weights_it_says_how_to_get_them(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(maker_module, "SHIPPED", tmp_path / "none.zip")
    assert run(["generate", "a dress", "--source", "writer", "--out", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert "without weights for a PatternMaker" in said and "--maker-weights" in said
    assert not (tmp_path / "out").exists()


def test_real_model_files_end_to_end(tmp_path, capsys, monkeypatch):
    """Untrained, so its patterns cross themselves: the way is walked to the end and ends in a sentence.

    They are held short, for it takes long to try what might mend them.
    """
    monkeypatch.setattr(model_file, "Grammar", partial(Grammar, Limits(tokens=100)))
    arguments = [
        "generate",
        "a dress",
        "--source",
        "writer",
        "--out",
        tmp_path / "out",
        "--maker-weights",
        TINY_MAKER,
        "--attempts",
        2,
    ]
    assert command(*arguments, "--seed", 1) == 2
    said = capsys.readouterr().err
    assert "None of the 2 patterns that were tried can be sewn" in said and "Traceback" not in said
    assert not (tmp_path / "out").exists()


def test_finished_by_physics(write, tmp_path, capsys):
    write([draft("fitted-skirt")])
    arguments = ("generate", "a skirt", "--out", tmp_path, "--finish", "--edge-length", 4, "--no-preview")
    code = command(*arguments)
    report = Garment.load(tmp_path).report
    assert report["quality"]["static"] and report["seconds"]["finishing"] > 0
    assert code == (0 if report["quality"]["accepted"] else 1)


# What is answered is so


def test_an_edit_of_which_nothing_is_understood_is_exit_code_1_and_the_same_bytes(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert command("generate", "a T-shirt", "--out", tmp_path / "before") == 0
    before = (tmp_path / "before" / "pattern.json").read_bytes()
    capsys.readouterr()
    given = ["edit", tmp_path / "before", "make it glorped and prettier", "--out", tmp_path / "after"]
    assert command(*given, "--no-preview") == 1
    said = capsys.readouterr().out
    assert 'Not understood: "glorped' in said and "is the one that was given" in said
    assert (tmp_path / "after" / "pattern.json").read_bytes() == before


def test_a_colour_is_changed_alone_and_a_fabric_needs_physics(write, tmp_path, capsys):
    write([draft("t-shirt")])
    assert command("generate", "a T-shirt", "--out", tmp_path / "before") == 0
    before = (tmp_path / "before" / "pattern.json").read_bytes()
    given = ["edit", tmp_path / "before", "make it red", "--no-preview", "--out"]
    assert command(*given, tmp_path / "red") == 0
    given[2] = "make it red and of denim"
    assert command(*given, tmp_path / "after") == 1
    said = capsys.readouterr().out
    assert "Colour: red (#ab252e)." in said and "warning: The fabric, denim, is not met" in said
    assert (tmp_path / "after" / "pattern.json").read_bytes() == before
    assert json.loads((tmp_path / "after" / "report.json").read_text())["color"] == "#ab252e"


def test_unmet_wishes_are_exit_code_1(write, tmp_path, capsys):
    write([draft("t-shirt")])
    shirt = write_pattern(draft("t-shirt"), tmp_path / "shirt.json") or tmp_path / "shirt.json"
    quiet = ["--out", tmp_path / "out", "--no-preview"]
    assert command("generate", "a top with darts", "--source", "writer", *quiet) == 1
    assert "Requested but not met" in capsys.readouterr().out
    assert command("edit", shirt, "make it 300 cm longer", *quiet) == 1
    assert "Requested but not met" in capsys.readouterr().out
    assert command("edit", shirt, "make it 5 cm longer", *quiet) == 0
    assert "Changed: from top to hem" in capsys.readouterr().out


def test_a_garment_keeps_its_colour_through_edits(write, tmp_path):
    write([draft("t-shirt")])
    shirt = write_pattern(draft("fitted-dress"), tmp_path / "dress.json") or tmp_path / "dress.json"
    command("edit", shirt, "give it a V neck", "--out", tmp_path / "one", "--no-preview")
    command("edit", tmp_path / "one", "give it a hood", "--out", tmp_path / "two", "--no-preview")
    colors = {json.loads((tmp_path / n / "report.json").read_text())["color"] for n in ("one", "two")}
    assert colors == {cloth_color(draft("fitted-dress"))}
    edited = load_pattern(tmp_path / "two" / "pattern.json")
    assert cloth_color(edited) not in colors, "else the test shows nothing"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["generate"], 'For example: swifttailor generate "a knee-length dress with a V neck" --out dress'),
        (["edit"], 'For example: swifttailor edit dress "make it 10 cm longer" --out longer'),
        (
            ["generate", "a", "knee", "length", "dress"],
            'Put the words in quotes: swifttailor generate "a knee length dress"',
        ),
        (
            ["generate", "--samples", "3", "--out", "d", "a", "dress"],
            'Put the words in quotes: swifttailor generate "a dress" --out d',
        ),
        (
            ["edit", "dress", "make", "it", "longer", "--out", "d"],
            'Put the words in quotes: swifttailor edit dress "make it longer" --out d',
        ),
    ],
)
def test_forgotten_words_and_quotes_are_told_with_an_example(arguments, said, capsys):
    assert run(arguments) == 2
    error = capsys.readouterr().err.strip()
    assert error.startswith("Error: ") and error.endswith(said)


def test_other_mistakes_are_told_as_before(capsys, tmp_path):
    assert run(["generate", "a dress", "--no-such-option"]) == 2
    assert "quotes" not in capsys.readouterr().err
    assert run(["generate", "--help"]) == 0
