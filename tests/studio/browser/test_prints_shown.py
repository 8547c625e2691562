"""Prints that words ask for, on the garment and through what is done with it."""

from __future__ import annotations

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def wait_for_print(studio: StudioPage, print_: str) -> None:
    """Until this is drawn on the cloth: a print to look at, or "own" and the kind of the garment's."""
    studio.page.locator(f'.garment-window canvas[data-print="{print_}"]').wait_for(timeout=WORK_MS)


def test_dots_that_are_asked_for_are_drawn_and_kept(studio_page, shot):
    page = studio_page.page
    wait_for_print(studio_page, "plain")
    studio_page.describe("a knee-length polka dot dress")
    wait_for_print(studio_page, "own dots")
    shot(page, "dots")
    studio_page.choose("hem", "midi")
    wait_for_print(studio_page, "own dots")

    page.get_by_role("button", name="Cloth: colour and print").click()
    asked = page.get_by_role("radio", name="As described: dots")
    assert asked.is_checked()
    page.get_by_role("radio", name="Ruler").check()
    wait_for_print(studio_page, "ruler")
    asked.check()
    page.get_by_role("button", name="Colour #a33b3b").click()
    wait_for_print(studio_page, "own dots")
    shot(page, "dots-dyed")
    page.keyboard.press("Escape")

    page.reload()
    wait_for_print(studio_page, "own dots")
    page.get_by_role("button", name="Cloth: colour and print").click()
    assert page.get_by_role("button", name="Colour #a33b3b").get_attribute("aria-pressed") == "true"
    page.keyboard.press("Escape")

    studio_page.tab("Adjust")
    before = studio_page.mesh()
    page.get_by_role("textbox", name="Change it in words").fill("make it plain white")
    studio_page.button("Change").click()
    studio_page.wait_for_another_mesh(before)
    wait_for_print(studio_page, "plain")
    studio_page.button("Undo").click()
    wait_for_print(studio_page, "own dots")


def test_no_body_is_shown_until_the_right_one_is_there(studio_page):
    page = studio_page.page
    page.locator("canvas[data-wearer='null']").wait_for()
    held = []
    page.route("**/api/body/*", lambda route: held.append(route))
    try:
        studio_page.tab("Body")
        before = studio_page.mesh()
        studio_page.button("women EU 44").click()
        studio_page.wait_for_another_mesh(before)
        page.locator(".garment-window canvas:not([data-wearer])").wait_for()
        for route in held:
            route.continue_()
        page.locator("canvas[data-wearer*='women EU 44']").wait_for(timeout=WORK_MS)
    finally:
        page.unroute("**/api/body/*")
