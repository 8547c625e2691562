"""The pipeline, with a network that writes what it is told to and one that sews untrained."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scripted_maker import crossed, scripted_maker, sure_of
from seeing import Seeing, worn

import swifttailor
from swifttailor.describing import measure_facts
from swifttailor.errors import InputError, PatternError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer import sewer as sewer_module
from swifttailor.garment_sewer.relaxing import relaxed
from swifttailor.ggi.decode import decode
from swifttailor.ggi.file import read_ggi
from swifttailor.pattern import load_pattern, write_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker import maker as maker_module
from swifttailor.pattern_maker.maker import PatternMaker
from swifttailor.pattern_maker.network.model_file import load_model
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.pattern_maker.tokens.grammar import Grammar, Limits
from swifttailor.tailor import Order, Tailor, Tailored
from swifttailor.tailor.reporting import NOTHING_UNDERSTOOD, ONE_OF_TWO

TINY_MAKER = Path(__file__).parents[1] / "pattern_maker" / "tiny_maker.zip"
SHIRT, SKIRT, DRESS = draft("t-shirt"), draft("fitted-skirt"), draft("fitted-dress")
STAGES = ["loading", "reading", "writing", "checking", "altering", "drawing", "network", "decoding"]
STAGES += ["relaxing"]
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


def like(pattern, other) -> bool:
    """Whether two patterns have the same panels, stitches and outlines to the digits of 32 bits."""
    a, b = pattern.canonical(), other.canonical()
    same = [p.name for p in a.panels] == [p.name for p in b.panels] and a.stitches == b.stitches
    return same and all(
        np.allclose(p.vertices - p.vertices[0], q.vertices - q.vertices[0], atol=1e-3)
        for p, q in zip(a.panels, b.panels, strict=True)
    )


@pytest.fixture(scope="module")
def shirt(sewer):
    return Tailor.load(scripted_maker([SHIRT]), sewer).generate(
        "a <b>T-shirt</b>\n& more", seed=3, source="writer"
    )


def test_words_become_the_pattern_that_was_written_and_its_garment(shirt, sewer):
    assert like(shirt.pattern, SHIRT)
    assert shirt.pattern.name == "a <b>T-shirt</b> & more"
    alone = relaxed(sewer.sew(shirt.pattern), fabric=shirt.report["fabric"])
    assert np.array_equal(shirt.garment.vertices, alone.vertices)
    assert list(shirt.seconds) == STAGES
    assert min(shirt.seconds.values()) >= 0
    assert shirt.report["order"]["text"] == "a <b>T-shirt</b>\n& more" and shirt.report["heard"]["likely"]
    assert (shirt.findings, shirt.changes, shirt.warnings, shirt.confidence) == (
        (),
        (),
        (),
        None,
    )
    assert shirt.notes[0] == 'Not understood: "b", "b".'  # between brackets
    assert shirt.notes[1].startswith("Assumed: ")


def test_the_report_tells_what_made_it(shirt):
    report = shirt.report
    assert report["order"]["text"] == "a <b>T-shirt</b>\n& more"
    assert report["order"]["seed"] == 3 and report["order"]["temperature"] == USUAL_TEMPERATURE
    assert report["versions"]["swifttailor"] == swifttailor.__version__
    assert set(report["versions"]) == {"swifttailor", "python", "numpy", "scipy", "onnxruntime"}
    assert report["weights"]["pattern_maker"]["data"] == {"train": {"garments": 2}}
    assert report["weights"]["garment_sewer"]["model"] == "GarmentSewer"
    assert "config" not in report["weights"]["pattern_maker"]
    assert report["writing"]["attempt"] == 1 and report["writing"]["failed_attempts"] == []
    assert report["writing"]["tokens"] == 106
    assert report["panels"] == 8 and report["findings"] == []
    json.dumps(report, allow_nan=False)


def test_the_folder_holds_everything_and_can_be_read_back(shirt, tmp_path):
    (tmp_path / "note.txt").write_text("mine")
    assert shirt.save(tmp_path) == tmp_path
    assert {p.name for p in tmp_path.iterdir()} == FILES | {"note.txt"}
    again = Garment.load(tmp_path)
    assert again.report == json.loads(json.dumps(shirt.report))
    assert np.allclose(again.vertices, shirt.garment.vertices, atol=1e-5)
    assert load_pattern(tmp_path / "pattern.json").canonical() == shirt.pattern
    with Image.open(tmp_path / "preview.png") as preview:
        assert preview.size == (1000, 600)
    images = read_ggi(tmp_path / "ggi.npz")
    assert images.layout.pattern == shirt.pattern and images.layout.pattern.name == shirt.pattern.name
    occupied = images.occupancy
    assert np.allclose(images.geometry[occupied], shirt.images.geometry[occupied], atol=0.005)


def test_less_is_written_where_less_is_wanted(shirt, tmp_path):
    less = FILES - {"preview.png", "ggi.npz"}
    shirt.save(tmp_path / "new", preview=False, images=False)
    assert {p.name for p in (tmp_path / "new").iterdir()} == less
    # A picture of another garment would be worse than none; one that somebody has put there is not ours.
    shirt.save(tmp_path / "own")
    (tmp_path / "own" / "preview.png").write_bytes(b"drawn by hand")
    for folder in ("new", "own"):
        (tmp_path / folder / "notes.txt").write_bytes(b"older")
        shirt.save(tmp_path / folder, preview=False, images=False)
    assert {p.name for p in (tmp_path / "new").iterdir()} == less | {"notes.txt"}
    assert {p.name for p in (tmp_path / "own").iterdir()} == less | {"notes.txt", "preview.png"}
    assert (tmp_path / "own" / "preview.png").read_bytes() == b"drawn by hand"


def test_the_image_is_what_the_network_predicted(sewer):
    shirt = Tailor.load(scripted_maker([SHIRT]), sewer).generate("a T-shirt", relax=False)
    prepared = sewer.prepare(shirt.pattern)
    (values,) = sewer.predict([prepared])
    table = prepared.table
    assert np.array_equal(shirt.images.geometry.reshape(-1, 3)[table.pixels], values.astype(np.float32))
    assert np.array_equal(np.flatnonzero(shirt.images.occupancy), np.sort(table.pixels))
    assert not shirt.images.geometry[~shirt.images.occupancy].any()
    decoded = decode(shirt.images)
    assert np.median(np.linalg.norm(decoded.vertices - shirt.garment.vertices, axis=1)) < 1.0


def test_text_is_escaped_wherever_markup_is_written(sewer, tmp_path):
    text = '</title><script>alert("1")</script><!-- ]]> &amp; \x1b[31m \0 \u202e \ufffe 长裙 👗 \'"'
    made = Tailor.load(scripted_maker([SKIRT]), sewer).generate(text)
    made.save(tmp_path, preview=False)
    root = ET.parse(tmp_path / "pattern.svg").getroot()
    ns = "{http://www.w3.org/2000/svg}"
    assert root.find(f"{ns}title").text.startswith('</title><script>alert("1")')
    assert not list(root.iter(f"{ns}script"))
    assert "\x1b" not in (tmp_path / "pattern.svg").read_text(encoding="utf-8")
    assert json.loads((tmp_path / "report.json").read_text())["order"]["text"] == text
    assert (tmp_path / "report.json").read_bytes().isascii()
    assert b"script" not in (tmp_path / "garment.obj").read_bytes()
    assert b"script" not in (tmp_path / "garment.glb").read_bytes()
    assert "长裙" in read_ggi(tmp_path / "ggi.npz").layout.pattern.name


@pytest.mark.parametrize("text", ["flared " * 15_000, "长裙" * 20_000, "a\0b" * 30_000, "🎉" * 25_000])
def test_100_kb_of_text_are_read_to_a_limit_and_that_is_said(text, sewer):
    made = Tailor.load(scripted_maker([SKIRT]), sewer).generate(text, source="writer")
    assert any("192 tokens" in w for w in made.warnings)
    assert made.needs_a_look
    assert made.report["order"]["text"] == text and len(made.pattern.name) <= 60


@pytest.mark.parametrize("text", ["", " \n", "\0", "\u200b\u202e"])
def test_nothing_to_go_by_is_refused(text, sewer):
    tailor = Tailor.load(scripted_maker([SKIRT]), sewer)
    with pytest.raises(InputError, match="a text or an image is needed"):
        tailor.generate(text)
    with pytest.raises(InputError, match="an instruction is needed"):
        tailor.edit(SHIRT, text)


def test_other_scripts_are_answered_with_a_warning(sewer):
    made = Tailor.load(scripted_maker([SKIRT]), sewer).generate("一条长裙", source="writer")
    assert "script that the network has never seen" in made.warnings[0]
    assert made.report["warnings"] == list(made.warnings)


def test_a_pattern_that_cannot_be_sewn_is_written_again(sewer):
    maker = scripted_maker([crossed(SHIRT)], [crossed(SKIRT)], [SHIRT])
    made = Tailor.load(maker, sewer).generate("a top", source="writer")
    assert like(made.pattern, SHIRT)
    assert maker.model.runtime.asked == [1, 1, 1]
    assert made.report["writing"]["attempt"] == 3
    assert [f.split(" ")[0] for f in made.report["writing"]["failed_attempts"]] == ["self-crossing"] * 2
    assert made.notes == ("3 patterns were tried; number 3 was taken.",)
    assert not made.needs_a_look


def test_attempts_have_an_end_and_the_reason_is_told(sewer):
    maker = scripted_maker([crossed(SHIRT)])
    with pytest.raises(PatternError, match=r"None of the 3 patterns .* crosses itself .* seed than 5"):
        Tailor.load(maker, sewer).generate("a top", seed=5, attempts=3, source="writer")
    assert maker.model.runtime.asked == [1, 1, 1]
    with pytest.raises(PatternError, match="The pattern that was written cannot be sewn: self-crossing"):
        Tailor.load(scripted_maker([crossed(SHIRT)]), sewer).generate(
            "a top", temperature=0.0, source="writer"
        )
    for wrong in (0, 65):
        with pytest.raises(InputError, match=f"attempts is {wrong}"):
            Tailor.load(maker, sewer).generate("a top", attempts=wrong)


def test_one_that_passes_the_check_and_cannot_be_drawn_is_written_again(sewer, monkeypatch):
    real = sewer_module.GarmentSewer.prepare

    def prepare(self, pattern, **options):
        if len(pattern.panels) == len(SKIRT.panels):
            raise PatternError("no room in the images")
        return real(self, pattern, **options)

    monkeypatch.setattr(sewer_module.GarmentSewer, "prepare", prepare)
    made = Tailor.load(scripted_maker([SKIRT], [SHIRT]), sewer).generate("a top", source="writer")
    assert like(made.pattern, SHIRT)
    assert made.report["writing"]["failed_attempts"] == ["no room in the images"]


def shrunk(pattern, *names):
    panels = [replace(p, vertices=p.vertices * 0.15) if p.name in names else p for p in pattern.panels]
    return replace(pattern, panels=tuple(panels))


def test_of_faulty_patterns_that_can_be_sewn_all_the_same_the_best_is_taken(sewer):
    """A sleeve of a seventh of its size is doubted by the check, not by the mesher."""
    one, both = shrunk(SHIRT, "right_sleeve_f"), shrunk(SHIRT, "right_sleeve_f", "left_sleeve_f")
    maker = scripted_maker([both], [one], [both])
    made = Tailor.load(maker, sewer).generate("a shirt", attempts=3, alter=False)
    assert like(made.pattern, one)
    assert made.report["writing"]["attempt"] == 2
    assert made.needs_a_look and {f["code"] for f in made.report["findings"]} == {"uneven-seam"}


def test_samples_are_written_together_and_each_is_known_by_its_seed(sewer):
    maker = scripted_maker([SHIRT, crossed(SKIRT), DRESS], [SKIRT])
    outcomes = Tailor.load(maker, sewer).make(Order("some", samples=3, seed=7, alter=False))
    assert all(isinstance(one, Tailored) for one in outcomes)
    assert [like(o.pattern, p) for o, p in zip(outcomes, (SHIRT, SKIRT, DRESS), strict=True)] == [True] * 3
    assert [o.report["order"]["seed"] for o in outcomes] == [7, 8, 9]
    assert maker.model.runtime.asked == [3, 1], "only the one that failed is written again"


def test_a_sample_that_fails_stops_no_other(sewer):
    maker = scripted_maker([SHIRT, crossed(SKIRT), DRESS], [crossed(SKIRT)])
    first, second, third = Tailor.load(maker, sewer).make(Order("some", samples=3, seed=7, alter=False))
    assert like(first.pattern, SHIRT) and like(third.pattern, DRESS)
    assert isinstance(second, PatternError) and "seed than 8" in str(second)


def test_the_same_again_gives_the_same_bytes(sewer, tmp_path):
    for name in "ab":
        tailor = Tailor.load(scripted_maker([SHIRT]), sewer)
        tailor.generate("a shirt", seed=2).save(tmp_path / name)
    for file in FILES - {"report.json", ".swifttailor"}:
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes(), file
    first, second = (json.loads((tmp_path / n / "report.json").read_text()) for n in "ab")
    assert first | {"seconds": {}} == second | {"seconds": {}}
    assert re.search(r"\b20\d\d-\d\d", json.dumps(first)) is None and str(tmp_path) not in json.dumps(first)


def photo(tmp_path: Path, color=(200, 30, 30), background=(240, 240, 240), size=(300, 200)) -> Path:
    picture = np.full((*size, 3), background, np.uint8)
    picture[40:120, 20:70] = color
    Image.fromarray(picture).save(tmp_path / "photo.png")
    return tmp_path / "photo.png"


def shown_for(image, sewer, **order):
    maker = scripted_maker([SKIRT])
    eyes = Seeing((worn("lower", {"kind": ("skirt", 0.95)}),))
    tailor = Tailor.load(maker, sewer, picture_reader=eyes)
    (made,) = tailor.make(Order("", image, **order))
    return made, next(iter(maker.model.runtime.pictures), None)


def cloth_share(shown: np.ndarray) -> float:
    """How much of a normalised picture (3, h, w) is red."""
    return float((shown[0] - shown[1] > 1.0).mean())


def test_a_picture_is_cropped_to_the_garment_unless_told_otherwise(tmp_path, sewer):
    path = photo(tmp_path)
    made, shown = shown_for(path, sewer)
    _, whole = shown_for(path, sewer, crop=False)
    assert shown.shape == (3, 32, 32)
    assert cloth_share(shown) > 0.3 > 0.12 > cloth_share(whole)
    assert any("cropped" in n for n in made.notes)
    assert made.confidence is None and made.report["confidence"] is None
    assert made.report["order"]["images"] == ["photo.png"] and made.pattern.name == "photo"
    array, same = shown_for(np.asarray(Image.open(path)), sewer)
    assert np.array_equal(same, shown) and array.report["order"]["images"] == [True]


@pytest.mark.parametrize("background", ["noise", "plain"])
def test_what_could_not_be_cropped_is_said_where_it_is_shown_to_the_network(background, tmp_path, sewer):
    pixels = np.random.default_rng(0).integers(0, 255, (80, 60, 3), np.uint8)
    pixels = pixels if background == "noise" else np.full_like(pixels, 200)
    made, shown = shown_for(pixels, sewer)
    assert shown is None, "words say what was read; the network knows no such backgrounds"
    said = "not plain" if background == "noise" else "Nothing stands out"
    made, shown = shown_for(pixels, sewer, alter=False)
    assert shown is not None and any(said in n for n in made.notes)
    assert any("was not judged" in n for n in made.notes), "without a measure none is made up"


def test_a_picture_unlike_all_that_are_known_is_doubted(tmp_path, sewer):
    _, shown = shown_for(photo(tmp_path), sewer)
    usual = sure_of(tuple(shown.mean(axis=(1, 2))))
    maker = scripted_maker([SKIRT], calibration=usual)
    eyes = Seeing((worn("lower", {}),))
    tailor = Tailor.load(maker, sewer, picture_reader=eyes)
    trusted = tailor.generate(image=photo(tmp_path))
    assert trusted.confidence.value > 0.5 and not trusted.warnings
    assert trusted.report["confidence"]["measure"] == "familiarity"
    doubted = tailor.generate(image=photo(tmp_path, (10, 10, 10), (20, 120, 20)))
    assert doubted.confidence.value == 0 and doubted.confidence.doubtful and doubted.needs_a_look
    assert "may show no garment" in doubted.warnings[0] and "confidence 0.000" in doubted.warnings[0]
    assert doubted.report["confidence"]["doubtful"] is True
    assert tailor.generate("a skirt").confidence is None
    crossing = scripted_maker([crossed(SKIRT)], calibration=usual)
    helpless = Tailor.load(crossing, sewer, picture_reader=eyes)
    with pytest.raises(PatternError, match=r"crosses itself .* may show no garment"):
        helpless.generate(image=photo(tmp_path, (10, 10, 10), (20, 120, 20)))


def test_a_picture_that_cannot_be_read_is_refused(tmp_path, sewer):
    (tmp_path / "text.png").write_text("a long dress")
    tailor = Tailor.load(scripted_maker([SKIRT]), sewer, picture_reader=Seeing())
    with pytest.raises(InputError, match="is not a readable picture"):
        tailor.generate(image=tmp_path / "text.png")
    with pytest.raises(InputError, match="of bytes"):
        tailor.generate(image=np.zeros((4, 4), np.uint8))


def test_a_pattern_is_edited(sewer):
    maker = scripted_maker([DRESS])
    before = draft("t-shirt")
    made = Tailor.load(maker, sewer).edit(before, "turn it into a dress")
    assert like(made.pattern, DRESS) and made.pattern.name == "t-shirt: turn it into a dress"
    assert made.report["order"]["edited"] == "t-shirt"
    assert before == draft("t-shirt")


def test_an_edit_recuts_the_pattern_that_was_given(sewer):
    before = draft("fitted-dress")
    made = Tailor.load(scripted_maker([SHIRT]), sewer).edit(before, "make it 6 cm longer")
    (wish,) = made.report["wishes"]
    assert wish["holds"] and wish["wish"].endswith("more by 6 cm")
    assert made.report["alterations"]["of_the_pattern_to_edit"]
    assert [p.name for p in made.pattern.panels] == [p.name for p in before.canonical().panels]
    assert measure_facts(made.pattern).length == pytest.approx(measure_facts(before).length + 6, abs=1.5)
    assert made.report["alterations"]["changes"] == [wish["wish"]]
    assert made.notes == (f"Changed: {wish['wish']}.",)


def test_what_cannot_be_cut_is_told(sewer):
    made = Tailor.load(scripted_maker([SHIRT]), sewer).generate(
        "a top with darts", attempts=1, source="writer"
    )
    assert like(made.pattern, SHIRT)
    assert made.notes == ("Requested but not met: how the upper part is shaped: darted.",)
    assert {w["wish"]: w["holds"] for w in made.report["wishes"]}[
        "how the upper part is shaped: darted"
    ] is False
    unread = Tailor.load(scripted_maker([SHIRT]), sewer).generate(
        "asdf qwer zxcv", attempts=1, source="writer"
    )
    assert unread.notes[0] == NOTHING_UNDERSTOOD and unread.report["wishes"] == []
    red = Tailor.load(scripted_maker([SHIRT]), sewer).generate("a red one", attempts=1, source="writer")
    assert NOTHING_UNDERSTOOD not in red.notes
    two = Tailor.load(scripted_maker([SHIRT]), sewer)
    of_both = [
        two.generate("a blouse and a skirt", part=part, attempts=1, source="writer")
        for part in (None, "upper")
    ]
    assert [ONE_OF_TWO in made.notes for made in of_both] == [True, False]
    left = Tailor.load(scripted_maker([DRESS]), sewer).generate("a midi dress", attempts=1, alter=False)
    assert like(left.pattern, DRESS) and left.report["wishes"] == []


def test_a_pattern_that_does_not_fit_the_network_is_refused(sewer):
    odd = replace(SHIRT, panels=(replace(SHIRT.panels[0], name="pocket"), *SHIRT.panels[1:]), stitches=())
    with pytest.raises(PatternError, match="pocket"):
        Tailor.load(scripted_maker([DRESS]), sewer).edit(odd, "longer")


def test_patterns_are_sewn_alone_or_many(sewer, tmp_path):
    tailor = Tailor.load("/no/maker/is/needed.zip", sewer)
    one = tailor.sew(SHIRT)
    assert np.array_equal(one.garment.vertices, relaxed(sewer.sew(SHIRT)).vertices)
    assert np.array_equal(tailor.sew(SHIRT, relax=False).garment.vertices, sewer.sew(SHIRT).vertices)
    assert "order" not in one.report and "pattern_maker" not in one.report["weights"]
    write_pattern(SKIRT, tmp_path / "skirt.json")
    (tmp_path / "broken.json").write_text("{")
    many = list(tailor.sew_all([SHIRT, tmp_path / "broken.json", tmp_path / "skirt.json", *[DRESS] * 7]))
    assert [isinstance(o, Tailored) for o in many] == [True, False] + [True] * 8
    assert like(many[2].pattern, SKIRT) and many[2].pattern.name == "skirt"
    assert all(np.array_equal(o.garment.vertices, many[3].garment.vertices) for o in many[4:])
    with pytest.raises(InputError, match="broken"):
        tailor.sew(tmp_path / "broken.json")


def test_what_cannot_be_sewn_as_it_is_may_be_mended(sewer):
    twice = replace(SHIRT, stitches=(*SHIRT.stitches, SHIRT.stitches[0]))
    made = Tailor.load(None, sewer).sew(twice)
    assert made.changes and made.report["mended"][0].startswith("duplicate-stitch")
    assert like(made.pattern, SHIRT)


def test_finished_by_physics_the_images_are_of_the_garment_at_rest(sewer):
    progress = []
    tailor = Tailor.load(scripted_maker([SKIRT]), sewer)
    made = tailor.generate("a skirt", finish=True, edge_length=4.0, progress=lambda *a: progress.append(a[0]))
    assert made.report["quality"]["static"] and made.seconds["finishing"] > 0
    assert made.report["order"]["seed"] == 0, "what physics adds takes nothing away"
    plain = tailor.generate("a skirt", edge_length=4.0)
    moved = np.linalg.norm(made.garment.vertices - plain.garment.vertices, axis=1)
    assert moved.max() > 0.5
    decoded = decode(made.images, edge_length=4.0)
    assert np.median(np.linalg.norm(decoded.vertices - made.garment.vertices, axis=1)) < 0.3
    assert progress[:3] == ["loading", "writing", "sewing"] and len(progress) > 3
    refused = replace(
        made, garment=replace(made.garment, report=made.report | {"quality": {"accepted": False}})
    )
    assert refused.needs_a_look


def test_packages_under_other_names_are_no_fault(monkeypatch):
    from importlib import metadata

    from swifttailor.tailor import provenance

    def version(name):
        asked.append(name)
        raise metadata.PackageNotFoundError(name)

    usual, asked = provenance.versions(), []
    provenance._versions.cache_clear()
    monkeypatch.setattr(metadata, "version", version)
    try:
        assert provenance.versions() == usual
        assert "onnxruntime" in asked, "the versions were asked for anew"
    finally:
        provenance._versions.cache_clear()


def test_networks_are_opened_when_they_are_needed(monkeypatch):
    monkeypatch.setattr(maker_module, "SHIPPED", Path("/nowhere/pattern_maker.zip"))
    monkeypatch.setattr(sewer_module, "SHIPPED", Path("/nowhere/garment_sewer.onnx"))
    tailor = swifttailor.Tailor.load()
    with pytest.raises(InputError, match="without weights for a PatternMaker"):
        _ = tailor.pattern_maker
    with pytest.raises(InputError, match="without weights for a GarmentSewer"):
        tailor.sew(SHIRT)
    with pytest.raises(InputError, match="Cannot read the weights"):
        swifttailor.Tailor.load("/nowhere/other.zip").generate("a dress")


def test_an_untrained_network_is_refused_with_a_reason(sewer):
    """Nothing scripted: a real model, whose patterns cross themselves even where they are short."""
    maker = PatternMaker(replace(load_model(TINY_MAKER), grammar=Grammar(Limits(tokens=100))))
    with pytest.raises(PatternError, match=r"None of the 2 patterns .* can be sewn; the best has"):
        Tailor.load(maker, sewer).generate("a dress", seed=1, attempts=2, source="writer")


def test_what_was_doubtful_before_an_edit_does_not_make_it_be_written_again(sewer):
    small = shrunk(SHIRT, "right_sleeve_f")
    for edit, asked in ((small, [1]), (SHIRT, [1, 1, 1])):
        maker = scripted_maker([small])
        made = Tailor.load(maker, sewer).edit(edit, "make the right sleeve small", attempts=3, alter=False)
        assert maker.model.runtime.asked == asked
        assert like(made.pattern, small) and made.needs_a_look


def test_all_garments_of_a_wish_are_made_by_where_they_are_worn(sewer):
    tailor = Tailor(garment_sewer=sewer)
    made = tailor.generate_all("a navy top and matching shorts")
    assert {part: one.report["order"]["words"] for part, one in made.items()} == {
        "upper": "a navy top",
        "lower": "navy shorts",
    }
    assert list(tailor.generate_all("a skirt")) == ["whole"]
