"""Garments for other bodies: sizes, measures, and the way back."""

from __future__ import annotations

import re

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]

from swifttailor.body import Body


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def wearer(studio_page) -> str:
    """What the drawn body was made to, once there is one."""
    studio_page.page.locator("canvas[data-wearer]").wait_for()
    return studio_page.canvas.get_attribute("data-wearer")


def choose_size(studio_page, title: str) -> None:
    """Presses a size, and waits for the garment that is sewn on that body."""
    before = studio_page.mesh()
    studio_page.button(title).click()
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    studio_page.page.locator(f"canvas[data-wearer*='{title}']").wait_for(timeout=WORK_MS)


def test_a_size_and_a_measure_refit_the_pattern_and_are_taken_back(studio_page, shot):
    page = studio_page.page
    assert wearer(studio_page) == "null"
    studio_page.tab("Body")
    choose_size(studio_page, "women EU 46")
    assert studio_page.button("women EU 46").get_attribute("aria-pressed") == "true"
    assert page.get_by_role("region", name="Worn by").inner_text().startswith("Made for women EU 46")
    large = studio_page.mesh()
    height = page.get_by_role("spinbutton", name="Height, cm", exact=True)
    height.fill("180")
    height.press("Enter")
    studio_page.wait_for_another_mesh(large)
    studio_page.wait_for_work()
    assert '"height":180' in wearer(studio_page)
    shot(page, "body-measures")
    assert studio_page.history()[-2:] == ["For women EU 46", "Height: 180 cm"]
    studio_page.button("Undo").click()
    page.locator(f'canvas[data-mesh="{large}"]').wait_for()
    page.locator("canvas[data-wearer]:not([data-wearer*='180'])").wait_for()
    studio_page.button("Undo").click()
    page.locator("canvas[data-wearer='null']").wait_for()


def test_impossible_measures_are_refused_with_what_is_possible(studio_page):
    page = studio_page.page
    studio_page.tab("Body")
    before = studio_page.mesh()
    waist = page.get_by_role("spinbutton", name="Waist, cm", exact=True)
    waist.fill("188")
    waist.press("Enter")
    page.get_by_role("button", name="women EU 46").and_(page.locator(":enabled")).wait_for(timeout=WORK_MS)
    choose_size(studio_page, "women EU 36")
    waist.fill("188")
    waist.press("Enter")
    page.get_by_text(re.compile("No body has these measures together.*The nearest")).wait_for(timeout=WORK_MS)
    assert studio_page.mesh() != before
    # The browser logs every answer that is a refusal.
    page.problems[:] = [said for said in page.problems if "422" not in said]


def test_the_body_is_kept_in_the_project_and_after_a_reload(studio_page, studio):
    page = studio_page.page
    studio_page.tab("Body")
    choose_size(studio_page, "women EU 40")
    studio_page.button("Save").click()
    page.get_by_text(re.compile('^Saved "')).wait_for(timeout=WORK_MS)
    mesh = studio_page.mesh()
    page.reload()
    page.locator(f'canvas[data-mesh="{mesh}"][data-wearer*="women EU 40"]').wait_for(timeout=WORK_MS)


def test_panels_stay_where_they_were_laid(studio_page):
    page = studio_page.page
    panel = page.locator(".pattern-sheet [data-panel='skirt_front']").first
    panel.wait_for()
    box = panel.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + 0.7 * box["height"]
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 40, steps=5)
    page.mouse.up()
    moved = panel.bounding_box()
    assert moved["x"] - box["x"] == pytest.approx(60, abs=3)
    assert studio_page.history()[-1] == "Move panels"
    page.keyboard.press("Control+z")
    page.wait_for_timeout(300)
    assert panel.bounding_box()["x"] == pytest.approx(box["x"], abs=1)
    page.keyboard.press("Control+Shift+z")
    page.wait_for_timeout(2500)
    page.reload()
    studio_page.canvas.wait_for()
    page.wait_for_timeout(500)
    other = page.locator(".pattern-sheet [data-panel='skirt_back']").first.bounding_box()
    again = panel.bounding_box()
    assert (again["x"] - other["x"]) / again["width"] > 0.05  # both lay below each other before


def test_an_own_body_is_loaded_worn_and_left_again(studio_page, tmp_path, shot):
    import trimesh

    page, body = studio_page.page, Body.default()
    path = tmp_path / "Ana.glb"
    trimesh.Trimesh(body.vertices * [1.1, 1.0, 1.1] / 100, body.faces, process=False).export(path)
    studio_page.tab("Body")
    before = studio_page.mesh()
    page.locator("#body-input").set_input_files(str(path))
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    page.locator("canvas[data-wearer*='\"mesh\"']").wait_for(timeout=WORK_MS)
    worn = page.get_by_role("region", name="Worn by")
    worn.get_by_text("a mesh of your own").wait_for(timeout=WORK_MS)
    assert worn.inner_text().startswith("Made for Ana")
    bust = page.get_by_role("spinbutton", name="Bust, cm", exact=True)
    assert float(bust.input_value()) == pytest.approx(1.1 * body.measurements.bust, rel=0.02)
    assert studio_page.history()[-1] == "For Ana"
    shot(page, "own-body")
    studio_page.tab("Body")
    choose_size(studio_page, "women EU 40")
    assert worn.get_by_text("a mesh of your own").count() == 0


def test_a_file_that_is_no_body_is_refused_with_what_to_do(studio_page, tmp_path):
    page, shown = studio_page.page, studio_page.mesh()
    path = tmp_path / "tetrahedron.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n")
    studio_page.tab("Body")
    page.locator("#body-input").set_input_files(str(path))
    page.get_by_role("region", name="Messages").get_by_text("The file is").wait_for(timeout=WORK_MS)
    assert studio_page.mesh() == shown
    page.problems[:] = [said for said in page.problems if "422" not in said]
