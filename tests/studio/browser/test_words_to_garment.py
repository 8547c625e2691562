"""From words to a garment to files."""

from __future__ import annotations

import io
import json
import re
import zipfile

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def test_words_become_a_garment_and_files(studio_page, shot):
    studio_page.describe("a knee-length sleeveless dress with a V neck and embroidery")
    page = studio_page.page
    read = page.get_by_role("region", name="What was read")
    assert read.get_by_role("button", name="hem: knee").is_visible()
    assert read.get_by_role("button", name="sleeves: none").is_visible()
    # What cannot be made is said, and not passed over.
    assert "embroidery" in page.get_by_role("region", name="Not possible yet").inner_text()
    assert page.get_by_role("button", name="Undo").is_disabled()
    shot(page, "words-to-garment")

    file = studio_page.download("ZIP")
    with zipfile.ZipFile(file.path()) as archive:
        assert archive.testzip() is None
        names = {name.rsplit("/", 1)[-1] for name in archive.namelist()}
        pattern = next(name for name in archive.namelist() if name.endswith("pattern.json"))
        panels = json.load(io.BytesIO(archive.read(pattern)))["pattern"]["panels"]
    assert {"pattern.json", "pattern.svg", "garment.glb", "garment.obj", "report.json"} <= names
    drawn = page.get_by_role("application", name=re.compile("Sewing pattern of"))
    assert drawn.get_attribute("aria-label") == f"Sewing pattern of {len(panels)} panels"


def test_every_format_is_offered_and_each_is_the_shown_garment(studio_page):
    page = studio_page.page
    studio_page.button("Download").click()
    items = page.get_by_role("menuitem").all_inner_texts()
    forms = {item.split()[0] for item in items}
    assert {"ZIP", "JSON", "SVG", "DXF", "MD", "CLO", "GLB", "OBJ", "PLY", "STL", "PNG"} <= forms
    page.keyboard.press("Escape")
    glb = studio_page.download("GLB").path().read_bytes()
    assert glb[:4] == b"glTF"
    svg = studio_page.download("SVG").path().read_text()
    assert svg.lstrip().startswith(("<?xml", "<svg"))


def test_a_wrong_chip_is_corrected_and_taken_back(studio_page):
    studio_page.describe("a knee-length sleeveless dress with a V neck")
    made = studio_page.mesh()
    studio_page.choose("hem", "midi")
    assert studio_page.chip("hem").inner_text().strip() == "hem: midi"
    # What else was asked for stays.
    assert studio_page.chip("neckline").inner_text().strip() == "neckline: v"
    midi = studio_page.mesh()
    assert studio_page.history() == ["Made from words", "hem: midi"]
    studio_page.button("Undo").click()
    assert studio_page.wait_for_another_mesh(midi) == made
    studio_page.tab("Describe")
    assert studio_page.chip("hem").inner_text().strip() == "hem: knee"
    studio_page.page.keyboard.press("Control+Shift+Z")
    assert studio_page.wait_for_another_mesh(made) == midi


def test_four_variants_are_made_to_choose_from(studio_page, shot):
    page = studio_page.page
    page.get_by_title("Four to choose from").click()
    page.get_by_role("spinbutton", name="Seed").fill("11")
    page.get_by_role("textbox", name="Describe a garment").fill("a flared skirt")
    before = studio_page.mesh()
    studio_page.button("Make four garments").click()
    tray = page.get_by_role("region", name="Choose one")
    tray.wait_for(timeout=WORK_MS)
    offers = tray.get_by_role("listitem")
    assert [f"Seed {seed}" in offers.nth(k).inner_text() for k, seed in enumerate([11, 12, 13, 14])] == [
        True
    ] * 4
    tray.get_by_role("img").nth(3).wait_for(timeout=WORK_MS)
    shot(page, "variants")
    offers.nth(2).get_by_role("button").click()
    studio_page.wait_for_another_mesh(before)
    assert tray.count() == 0
    assert page.get_by_role("spinbutton", name="Seed").input_value() == "13"


def test_two_garments_of_one_wish_are_both_made(studio_page):
    page = studio_page.page
    studio_page.describe("a white blouse and a black pencil skirt")
    blouse = studio_page.mesh()
    choice = page.get_by_role("region", name="Two garments")
    choice.get_by_text("Bottom").click()
    skirt = studio_page.wait_for_another_mesh(blouse)
    choice.get_by_text("Top").click()
    assert studio_page.wait_for_another_mesh(skirt) == blouse


def test_the_same_seed_makes_the_same_garment(studio_page):
    studio_page.describe("a tank top")
    first = studio_page.mesh()
    studio_page.describe("wide trousers")
    studio_page.describe("a tank top")
    assert studio_page.mesh() == first


def test_nothing_asked_for_is_answered_with_what_to_do(studio_page):
    page = studio_page.page
    page.get_by_role("textbox", name="Describe a garment").fill("   ")
    studio_page.button("Make the garment").click()
    assert "Describe a garment, or drop a picture" in page.get_by_role("region", name="Messages").inner_text()


def test_a_slider_makes_the_garment_follow_and_one_entry_in_the_history(studio_page):
    page = studio_page.page
    before, camera = studio_page.mesh(), studio_page.camera()
    studio_page.tab("Adjust")
    slider = page.get_by_role("slider", name="Length", exact=True)
    length = float(slider.input_value())
    slider.focus()
    for _ in range(8):
        page.keyboard.press("ArrowLeft")
    studio_page.wait_for_another_mesh(before)
    page.locator(".pulse:not(.on)").wait_for(timeout=WORK_MS)
    labels = studio_page.history()
    assert 2 <= len(labels) <= 9, labels
    assert labels[-1].startswith("Length: ")
    assert studio_page.camera() == camera
    studio_page.tab("Adjust")
    assert float(slider.input_value()) == pytest.approx(length - 8, abs=1.5)
