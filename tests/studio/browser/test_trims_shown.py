"""Pockets, buttons and belts on the garment, on the panels and in words."""

from __future__ import annotations

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def looks(studio: StudioPage) -> set[str]:
    """Of the trims that are drawn on the garment."""
    return set((studio.canvas.get_attribute("data-trims") or "").split())


def marked(studio: StudioPage) -> set[str]:
    """Trims that are marked on the panels."""
    marks = studio.page.locator(".pattern-sheet .trims [data-trim]")
    return set(marks.evaluate_all("marks => marks.map(mark => mark.dataset.trim)"))


def test_trims_are_drawn_marked_told_and_changed_in_words(studio_page, shot):
    page = studio_page.page
    assert not looks(studio_page) and not marked(studio_page)
    studio_page.describe("a blue denim jacket")
    assert looks(studio_page) == {"button", "cloth", "dark"}
    assert marked(studio_page) == {"buttons", "chest pockets", "topstitching", "denim seams"}
    assert "two breast pockets with flaps" in page.get_by_role("region", name="Assumed").inner_text()
    shot(page, "trims")

    colouring = page.get_by_role("group", name="Colouring")
    colouring.get_by_text("Strain").click()
    page.locator('.garment-window canvas[data-trims=""]').wait_for()
    colouring.get_by_text("Cloth").click()
    page.locator('.garment-window canvas[data-trims~="button"]').wait_for()

    studio_page.tab("Adjust")
    before = studio_page.mesh()
    page.get_by_role("textbox", name="Change it in words").fill(
        "without breast pockets, with a zip instead of buttons"
    )
    studio_page.button("Change").click()
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    assert marked(studio_page) == {"zip", "topstitching", "denim seams"}
    changed = page.get_by_role("status").filter(has_text="What changed").inner_text()
    assert "put on: a zip down the front" in changed and "two breast pockets" in changed
    studio_page.button("Undo").click()
    page.locator('.pattern-sheet .trims [data-trim="chest pockets"]').first.wait_for()
    assert marked(studio_page) == {"buttons", "chest pockets", "topstitching", "denim seams"}


def test_trims_are_hidden_while_physics_moves_the_cloth(studio_page):
    page = studio_page.page
    studio_page.describe("a white shirt")
    assert looks(studio_page)
    before = studio_page.mesh()
    studio_page.button("Drape").click()
    page.locator('.garment-window canvas[data-frame][data-trims=""]').wait_for(timeout=WORK_MS)
    studio_page.button("Stop").click()
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    page.locator('.garment-window canvas[data-trims~="button"]').wait_for()
