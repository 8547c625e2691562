"""What a picture says becomes part of what is asked, and of what the pattern is cut to."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from scripted_maker import scripted_maker
from seeing import Seeing, worn

from swifttailor.cli.main import run
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.errors import InputError, NothingSeenError
from swifttailor.pattern.drafts import draft
from swifttailor.picture_reader.reading import Measure, PictureReading
from swifttailor.picture_reader.seen_design import SeenDesign
from swifttailor.picture_reader.together import together
from swifttailor.programs.read_parameter import ReadParameter
from swifttailor.render import Camera
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.looking import SeenPicture, part_wanted, parts_cut_off, parts_seen
from swifttailor.tailor.seen_wishes import not_overruled, seen_wishes
from swifttailor.wishes.reader import Wish

PHOTO = np.random.default_rng(0).integers(0, 255, (90, 60, 3), np.uint8)
SHIRT = worn("upper", {"kind": ("top", 0.98), "sleeves": ("long", 0.95), "top_hem": ("hip", 0.6)})
TROUSERS = worn("lower", {"kind": ("trousers", 0.97), "leg_hem": ("full", 0.93)}, covers=0.3)


def tailor(sewer, *readings, pattern="t-shirt", figures="one"):
    return Tailor(scripted_maker([draft(pattern)]), sewer, picture_reader=Seeing(*readings, figures=figures))


def test_a_garment_is_cut_to_what_its_picture_shows(sewer):
    made = tailor(sewer, (SHIRT,)).generate(image=PHOTO)
    assert Claim("sleeves", "short").holds(measure_facts(draft("t-shirt")))
    assert Claim("sleeves", "long").holds(measure_facts(made.pattern))
    wishes = {w["wish"]: w for w in made.report["wishes"]}
    assert len(wishes) == 2 and all(w["from"] == "picture" and w["holds"] for w in wishes.values())
    (likely,) = made.report["pictures"]["likely"]
    assert "hip" in likely["wish"] and made.report["pictures"]["part"] == "upper"
    assert any("Read in the picture" in n and "long (95%)" in n for n in made.notes)
    assert made.report["weights"]["picture_reader"] == {"model": "PictureReader", "parameters": 5}
    assert "wish_reader" not in made.report["weights"]


@pytest.mark.parametrize(("certainty", "cut"), [(0.65, False), (0.75, True)])
def test_what_is_hardly_likely_is_read_and_not_cut(sewer, certainty, cut):
    seen = worn("upper", {"kind": ("top", 0.98), "neckline": ("v", certainty)})
    made = tailor(sewer, (seen,)).generate(image=PHOTO)
    v_neck = Claim("neckline", "v")
    assert not v_neck.holds(measure_facts(draft("t-shirt")))
    assert v_neck.holds(measure_facts(made.pattern)) == cut
    (likely,) = made.report["pictures"]["likely"]
    assert "v" in likely["wish"].lower() and likely["certainty"] == certainty


def test_words_outrank_the_picture_and_that_is_said(sewer):
    made = tailor(sewer, (SHIRT,)).generate("a sleeveless top", PHOTO)
    assert Claim("sleeves", "none").holds(measure_facts(made.pattern))
    (overruled,) = (w for w in made.report["pictures"]["overruled_by_text"] if "sleeves" in w["wish"])
    assert overruled["certainty"] == 0.95
    assert any("overruled" in n and "long" in n for n in made.notes)


def test_without_alterations_no_picture_is_read(sewer):
    asked = tailor(sewer, (SHIRT,))
    made = asked.generate(image=PHOTO, alter=False)
    assert not asked.picture_reader.shown and "pictures" not in made.report
    assert made.pattern == draft("t-shirt").canonical() or made.pattern.panels


def test_the_garment_that_covers_most_is_made_unless_another_is_asked_for(sewer):
    asked = tailor(sewer, (TROUSERS, SHIRT))
    seen = asked.look(PHOTO)
    assert parts_seen([seen]) == ("upper", "lower")
    assert part_wanted([seen], None).part == "upper" and part_wanted([seen], "lower").part == "lower"
    whole = part_wanted([seen], "whole")
    assert whole.part == "upper" and whole.certainty_of("kind", "dress") > 0.9
    assert whole.certainty_of("kind", "top") == 0
    alone = tailor(sewer, (TROUSERS,), pattern="trousers")
    made = alone.generate(image=seen, part="lower")
    assert not alone.picture_reader.shown, "what was read is not read again"
    assert measure_facts(made.pattern).kind == "trousers"
    with pytest.raises(NothingSeenError, match=r"on this part of the body.* What is seen: lower"):
        alone.generate(image=PHOTO, part="upper")
    with pytest.raises(InputError, match="names no two garments"):
        Order("a dress", part="upper")
    with pytest.raises(InputError, match="front and a back"):
        Order(image=[PHOTO] * 3)


@pytest.mark.parametrize("readings", [(), (SHIRT,)])
def test_nothing_is_invented_for_a_picture_without_a_garment(readings, sewer):
    empty = tailor(sewer, readings, figures="none" if readings else "one")
    with pytest.raises(NothingSeenError, match="No garment was found in the picture") as error:
        empty.generate(image=PHOTO)
    assert error.value.exit_code == 1
    made = empty.generate("a long-sleeved top", PHOTO)
    assert any("No garment was found" in w for w in made.warnings) and made.needs_a_look
    assert Claim("sleeves", "long").holds(measure_facts(made.pattern))


def test_a_group_is_said_to_be_one(sewer):
    made = tailor(sewer, (SHIRT,), figures="several").generate(image=PHOTO)
    assert any("several people" in w for w in made.warnings) and made.needs_a_look


def test_of_front_and_back_each_says_what_it_shows_best(sewer):
    front = worn("upper", {"kind": ("top", 0.9), "neckline": ("v", 0.9), "back_depth": ("high", 0.4)})
    back = worn("upper", {"kind": ("tunic", 0.6), "neckline": ("round", 0.5), "back_depth": ("open", 0.8)})
    both = together([front, back])
    said = {s.claim.name: s.claim.value for s in both.statements}
    assert said == {"kind": "top", "neckline": "v", "back_depth": "open"}
    assert together([front]) is front
    asked = tailor(sewer, (front,), (back,))
    made = asked.generate(image=(PHOTO, PHOTO))
    assert len(asked.picture_reader.shown) == 2 and len(made.report["pictures"]["read"]) == 2
    assert Claim("back_depth", "open").holds(measure_facts(made.pattern))


def test_measures_are_asked_for_as_far_as_they_are_certain():
    sure = Measure("sleeve length", 58.04, 0.8, 0.99)
    vague = Measure("length", 66.0, 9.0, 0.99)
    absent = Measure("skirt length", 60.0, 0.5, 0.2)
    flat = Measure("tiers", 2.8, 0.1, 0.95)
    found = {w.change.claim.name: w for w in seen_wishes(worn("upper", {}, (sure, vague, absent, flat)))}
    assert set(found) == {"sleeve_cm", "tiers"}
    assert found["sleeve_cm"].change.claim.value == 58.0 and found["tiers"].change.claim.value == 3
    # Off by 0.8 cm in half of all cases: a Laplace distribution of width 0.8 / ln 2, and 3.48 cm are granted.
    expected = 0.99 * (1 - 0.5 ** (0.06 * 58.0 / 0.8))
    assert abs(found["sleeve_cm"].certainty - expected) < 1e-9


def test_a_thing_said_in_words_is_not_taken_from_the_picture_in_centimetres():
    seen = [Wish(Gain(Claim("sleeve_cm", 58.0)), 0.9), Wish(Gain(Claim("skirt_hem", "knee")), 0.9)]
    kept, gone = not_overruled(seen, [Wish(Gain(Claim("sleeves", "short")), 0.95)])
    assert kept == (seen[1],) and gone == (seen[0],)
    kept, gone = not_overruled(seen, [Wish(Gain(Claim("kind", "jumpsuit")), 0.95)])
    assert kept == (seen[0],) and gone == (seen[1],)
    kept, _ = not_overruled(seen, [])
    assert kept == tuple(seen)


def test_what_words_and_picture_agree_on_is_not_overruled():
    hem = Wish(Gain(Claim("skirt_hem", "knee")), 0.9)
    assert not_overruled([hem], [Wish(Gain(Claim("skirt_hem", "knee")), 0.6)]) == ((), ())
    assert not_overruled([hem], [Wish(Gain(Claim("skirt_hem", "maxi")), 0.6)]) == ((), (hem,))
    no_slit = Wish(Gain(Claim("slit", "none")), 0.9)
    assert not_overruled([hem, no_slit], [Wish(Gain(Claim("kind", "trousers")), 0.9)]) == ((), (hem,))


TWO_COLORS = np.zeros((90, 60, 3), np.uint8)
TWO_COLORS[:27], TWO_COLORS[27:45], TWO_COLORS[45:] = (123, 19, 32), (31, 42, 68), 240
"""A picture that is dark red where `TROUSERS` are seen, navy as well where `SHIRT` is, and white."""


def test_a_garment_has_the_colour_that_its_cloth_has_in_the_picture(sewer):
    seen = tailor(sewer, (SHIRT, TROUSERS)).look(TWO_COLORS)
    made = tailor(sewer, pattern="trousers").generate(image=seen, part="lower")
    assert made.garment.color == made.report["color"] == "#7b1320"
    assert "Seen in the picture: dark red (#7b1320)." in made.notes
    assert made.report["pictures"]["color"]["name"] == "dark red"
    upper = tailor(sewer).generate("with long sleeves", seen, part="upper")
    assert upper.garment.color == "#7b1320"
    assert any("more than one colour (navy)" in note for note in upper.notes)


@pytest.mark.parametrize("text", ["a green top", "a striped top", "a top in denim", "a top, not red"])
def test_words_outrank_the_colour_of_the_picture(sewer, text):
    made = tailor(sewer, (TROUSERS, SHIRT)).generate(text, TWO_COLORS, part="upper")
    assert made.garment.color != "#7b1320" and made.report["pictures"]["color"] is None
    assert not any("Seen in the picture" in note for note in made.notes)


def test_the_colour_of_a_picture_is_surer_than_what_a_name_implies(sewer):
    wanted = tailor(sewer, (TROUSERS,)).read(Order("jeans", TWO_COLORS))
    assert wanted.heard.color == "#3b5578" and wanted.color == "#7b1320"


def test_the_colours_of_plain_pictures_mean_nothing_and_of_two_pictures_the_first_counts(sewer):
    plain = Tailor(scripted_maker([]), sewer, picture_reader=Seeing((TROUSERS,), is_plain=True))
    assert plain.read(Order(image=TWO_COLORS)).color is None
    wanted = tailor(sewer, (TROUSERS,)).read(Order(image=(TWO_COLORS, TWO_COLORS[::-1])))
    assert wanted.color == "#7b1320"


@pytest.fixture
def shown(monkeypatch, sewer, tmp_path):
    """The command line with eyes that see a shirt above trousers, and a picture for it."""
    Image.fromarray(PHOTO).save(tmp_path / "photo.png")

    def load(*_, **__):
        return tailor(sewer, (SHIRT, TROUSERS))

    monkeypatch.setattr(Tailor, "load", load)
    return ["generate", "--image", str(tmp_path / "photo.png"), "--out", str(tmp_path / "out")]


def test_both_garments_of_a_picture_get_a_folder_each(shown, tmp_path, capsys):
    run([*shown, "--no-preview"])
    for name in ("upper", "lower"):
        report = json.loads((tmp_path / "out" / name / "report.json").read_text())
        assert report["pictures"]["part"] == name and report["order"]["part"] == name
        assert Image.open(tmp_path / "out" / name / "seen.png").size == (384, 384)
    printed = capsys.readouterr().out
    assert "upper: " in printed and "lower: " in printed
    run([*shown, "--no-preview", "--part", "upper"])
    assert (tmp_path / "out" / "pattern.json").is_file()


def test_reading_alone_makes_nothing(shown, tmp_path, capsys):
    assert run([*shown, "--read"]) == 0
    printed = capsys.readouterr().out
    assert "how long both sleeves are: long (95%)" in printed and "lower (97%)" in printed
    assert printed.count("  colour: ") == 2
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == [
        ".swifttailor",
        "reading.json",
        "seen.png",
    ]
    (told,) = json.loads((tmp_path / "out" / "reading.json").read_text())
    assert told["file"] == "photo.png" and [p["part"] for p in told["parts"]] == ["upper", "lower"]
    assert all(part["color"]["rgb"].startswith("#") for part in told["parts"])
    assert all("design" not in part for part in told["parts"]), "of a reader that reads none"


def test_reading_alone_tells_the_design_parameters_that_are_seen(shown, tmp_path, capsys, monkeypatch):
    trousers = SeenDesign((ReadParameter("meta.bottom", ("Pants", None)),), (np.array([0.8, 0.2]),))
    look = Tailor.look

    def designed(self, image):
        seen = look(self, image)
        parts = tuple(replace(part, design=trousers) for part in seen.reading.parts)
        return replace(seen, reading=replace(seen.reading, parts=parts))

    monkeypatch.setattr(Tailor, "look", designed)
    assert run([*shown, "--read"]) == 0
    assert "    meta.bottom: Pants (80%)" in capsys.readouterr().out
    (told,) = json.loads((tmp_path / "out" / "reading.json").read_text())
    for part in told["parts"]:
        assert part["design"] == [{"name": "meta.bottom", "value": "Pants", "certainty": 0.8}]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["generate", "a top", "--read"], "--read is about a picture"),
        (["generate", "a top", "--part", "upper"], "--part upper chooses one of two garments"),
        (["generate", "--image", "none.png", "a top"], "Put the text before --image"),
    ],
)
def test_options_for_pictures_need_one(arguments, said, tmp_path, capsys):
    assert run([*arguments, "--out", str(tmp_path / "out")]) == 2
    assert said in capsys.readouterr().err


@pytest.fixture
def blind(monkeypatch, sewer, tmp_path):
    """A tailor of a version without weights to read pictures with."""
    from swifttailor.picture_reader import reader

    monkeypatch.setattr(reader, "SHIPPED", tmp_path / "none.onnx")
    return Tailor(scripted_maker([draft("t-shirt")]), sewer)


def test_without_a_reader_the_network_alone_sees_the_picture_and_that_is_said(blind):
    made = blind.generate(image=PHOTO)
    assert any("not read" in n for n in made.notes) and "pictures" not in made.report
    assert len(blind.pattern_maker.model.runtime.pictures) == 1
    with pytest.raises(InputError, match="without weights of a picture reader"):
        blind.look(PHOTO)
    with pytest.raises(InputError, match="--picture-reader-weights"):
        blind.generate(image=PHOTO, part="upper")


def seen_rows(upper, lower, high=90):
    """A picture in which garments are seen in these rows."""
    parts = []
    for part, (first, last) in ((SHIRT, upper), (TROUSERS, lower)):
        mask = np.zeros((high, 60), np.float32)
        mask[first:last, 20:40] = 1
        parts.append(replace(part, mask=mask))
    reading = PictureReading(tuple(parts), Camera(), (0, 0, high, high))
    return SeenPicture(np.zeros((high, 60, 3), np.uint8), reading)


@pytest.mark.parametrize(
    ("upper", "lower", "seen"),
    [
        ((10, 60), (62, 90), ("upper",)),  # trousers, cut off at the thigh
        ((10, 60), (60, 85), ("upper", "lower")),  # shorts
        ((10, 50), (50, 90), ("upper", "lower")),
        ((0, 12), (12, 80), ("lower",)),  # the hem of a shirt
        ((0, 30), (30, 80), ("lower", "upper")),
        ((10, 60), (0, 0), ("upper",)),
        ((0, 0), (0, 0), ("upper", "lower")),
    ],
)
def test_of_what_an_edge_leaves_little_nothing_is_made(upper, lower, seen):
    picture = seen_rows(upper, lower)
    assert parts_seen([picture]) == seen
    rest = {"upper", "lower"} - set(seen)
    assert set(parts_cut_off([picture])) == rest
    for part in ("upper", "lower"):
        assert part_wanted([picture], part).part == part, "but it may be asked for"


def test_what_is_left_out_is_told(sewer):
    made = tailor(sewer, ()).generate(image=seen_rows((10, 60), (62, 90)))
    assert any(
        "cuts off most of a garment on the lower body" in note and "--part lower" in note
        for note in made.notes
    )
