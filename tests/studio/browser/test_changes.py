"""Edits by instruction, comparison, physics, and going on after a reload."""

from __future__ import annotations

import json
import re

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def test_an_instruction_changes_the_garment_and_the_two_are_compared(studio_page, shot):
    page, before = studio_page.page, studio_page.mesh()
    studio_page.tab("Adjust")
    page.get_by_role("textbox", name="Change it in words").fill("make it 15 cm shorter")
    page.keyboard.press("Enter")
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    changes = page.locator(".changes")
    assert "15 cm" in changes.inner_text()
    changes.get_by_role("button", name="Compare with before").click()
    dialog = page.get_by_role("dialog", name="Compare two versions")
    row = dialog.get_by_role("row", name=re.compile("length", re.I)).first
    row.wait_for()
    left, right, difference = (
        float(re.sub("[^0-9.−]", "", cell).replace("−", "-"))
        for cell in row.get_by_role("cell").all_inner_texts()
    )
    assert right - left == pytest.approx(difference, abs=0.11)
    assert difference == pytest.approx(-15, abs=1.5)
    assert dialog.locator("canvas").count() == 2
    page.wait_for_timeout(1500)
    shot(page, "compare")
    dialog.get_by_role("region", name=re.compile("^Left")).get_by_role(
        "button", name="Go to this one"
    ).click()
    assert (
        studio_page.wait_for_another_mesh(studio_page.mesh() if studio_page.mesh() != before else "")
        == before
    )


def test_a_drape_is_watched_and_stopped(studio_page, shot):
    page, before, camera = studio_page.page, studio_page.mesh(), studio_page.camera()
    studio_page.button("Drape").click()
    bar = page.locator(".job-bar")
    page.locator(".garment-window canvas[data-frame]").wait_for(timeout=WORK_MS)
    first = int(page.locator(".garment-window canvas").get_attribute("data-frame"))
    page.locator(f'.garment-window canvas:not([data-frame="{first}"])').wait_for(timeout=WORK_MS)
    assert int(page.locator(".garment-window canvas").get_attribute("data-frame")) > first
    assert "frame" in bar.inner_text()
    bar.get_by_role("button", name="Stop").click()  # before the drape has come to its own end
    shot(page, "drape-live")
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    assert page.locator(".stage-note").inner_text() == "Draped until stopped"
    assert studio_page.camera() == camera
    assert studio_page.history()[-1] == "Drape in cotton, stopped"
    studio_page.button("Undo").click()
    page.locator(f'.garment-window canvas[data-mesh="{before}"]').wait_for()


def test_work_can_be_cancelled_before_anything_is_lost(studio_page):
    page, before = studio_page.page, studio_page.mesh()
    page.get_by_role("textbox", name="Describe a garment").fill("a hooded jumpsuit with wide legs")
    studio_page.button("Make the garment").click()
    page.locator(".job-bar").get_by_role("button", name="Cancel").click()
    studio_page.wait_for_work()
    assert studio_page.mesh() == before
    assert studio_page.history() == ["Example: Summer dress"]


def test_after_a_reload_one_goes_on_where_one_was(studio_page):
    page = studio_page.page
    studio_page.choose("hem", "mini")
    mini = studio_page.mesh()
    page.get_by_role("textbox", name="Name of the project").fill("Mine, for June")
    page.reload()
    page.locator(f'.garment-window canvas[data-mesh="{mini}"]').wait_for(timeout=WORK_MS)
    assert page.get_by_role("textbox", name="Name of the project").input_value() == "Mine, for June"
    assert studio_page.history() == ["Example: Summer dress", "hem: mini"]
    studio_page.button("Undo").click()
    studio_page.wait_for_another_mesh(mini)


def test_a_project_is_saved_changed_autosaved_and_opened_again(studio_page, studio):
    page = studio_page.page
    page.get_by_role("textbox", name="Name of the project").fill("Dress for Ada")
    page.keyboard.press("Control+S")
    page.locator(".save-state.saved").wait_for(timeout=WORK_MS)
    (folder,) = studio.projects.glob("dress-for-ada*")
    assert json.loads((folder / "pattern.json").read_text())["pattern"]["panels"]
    studio_page.choose("hem", "mini")
    mini = studio_page.mesh()
    page.locator(".save-state.autosaved").wait_for(timeout=WORK_MS)
    page.reload()
    page.locator(f'.garment-window canvas[data-mesh="{mini}"]').wait_for(timeout=WORK_MS)
    page.get_by_role("region", name="Messages").get_by_role("button", name="Open what was saved").click()
    studio_page.wait_for_another_mesh(mini)
    assert studio_page.history() == ["Example: Summer dress"]
    studio_page.button("Open").click()
    listed = page.get_by_role("dialog", name="Open").get_by_role("button", name=re.compile("Dress for Ada"))
    assert listed.first.is_visible()


def test_a_pattern_file_is_opened(studio_page, real_pattern):
    page, before = studio_page.page, studio_page.mesh()
    buffer = json.dumps(real_pattern).encode()
    page.locator("#file-input").set_input_files(
        {"name": "real_specification.json", "mimeType": "application/json", "buffer": buffer}
    )
    studio_page.wait_for_another_mesh(before)
    panels = len(real_pattern["pattern"]["panels"])
    assert page.get_by_role("application", name=f"Sewing pattern of {panels} panels").count() == 1
    assert page.get_by_role("textbox", name="Name of the project").input_value() == "real"
