"""The garment window: views, colours, and what is linked with the pattern."""

from __future__ import annotations

import pytest
from studio_page import StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def studio_page(page) -> StudioPage:
    return StudioPage(page).visit()


def middle(studio_page) -> tuple[float, float]:
    box = studio_page.canvas.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def picture(studio_page) -> bytes:
    """The middle of the view, where no button or note covers it."""
    studio_page.page.wait_for_timeout(600)
    box = studio_page.canvas.bounding_box()
    clip = {
        "x": box["x"] + 0.05 * box["width"],
        "y": box["y"] + 0.12 * box["height"],
        "width": 0.8 * box["width"],
        "height": 0.5 * box["height"],
    }
    return studio_page.page.screenshot(clip=clip)


def test_it_is_looked_at_from_its_sides_by_buttons_and_keys(studio_page):
    page = studio_page.page
    studio_page.button("Front").click()
    page.wait_for_timeout(600)
    x, _, z = studio_page.camera()[:3]
    assert z > 100 and abs(x) < 5
    studio_page.button("Back").click()
    page.wait_for_timeout(600)
    assert studio_page.camera()[2] < -100
    page.get_by_role("application", name="Garment in 3D").focus()
    page.keyboard.press("3")
    page.wait_for_timeout(600)
    assert studio_page.camera()[0] > 100
    before = studio_page.camera()
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("+")
    after = studio_page.camera()
    assert after[:3] != before[:3] and after[3:] == before[3:]


def test_dragging_turns_it(studio_page):
    page = studio_page.page
    before = studio_page.camera()
    x, y = middle(studio_page)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 120, y, steps=6)
    page.mouse.up()
    assert studio_page.camera()[:3] != before[:3]
    # A drag selects nothing.
    assert page.locator('[data-selected="true"]').count() == 0


def test_parts_are_shown_and_hidden(studio_page):
    plain = picture(studio_page)
    for name in ("Body", "Seams", "Wireframe", "Normals"):
        button = studio_page.page.get_by_role("button", name=name, exact=True)
        was = button.get_attribute("aria-pressed")
        button.click()
        assert button.get_attribute("aria-pressed") != was, name
        assert picture(studio_page) != plain, name
        button.click()
        assert picture(studio_page) == plain, name


def test_strain_has_a_legend_and_prints_are_drawn(studio_page, shot):
    page = studio_page.page
    plain = picture(studio_page)
    page.get_by_text("Strain", exact=True).click()
    assert "12 %" in page.locator(".legend").inner_text()
    strained = picture(studio_page)
    assert strained != plain
    shot(page, "strain")
    page.get_by_text("Panels", exact=True).click()
    assert picture(studio_page) not in (plain, strained)
    page.get_by_role("button", name="Cloth: colour and print").click()
    page.get_by_role("radio", name="Checks, 2 cm").check()
    page.keyboard.press("Escape")
    assert picture(studio_page) != plain
    shot(page, "checks")


def test_what_is_pressed_in_one_window_is_marked_in_the_other(studio_page):
    page = studio_page.page
    before = picture(studio_page)
    x, y = middle(studio_page)
    page.mouse.move(x + 25, y + 60)
    page.mouse.click(x + 25, y + 60)
    page.mouse.move(5, 5)
    assert page.locator('.pattern-window [data-selected="true"]').count() == 1
    marked = picture(studio_page)
    assert marked != before
    page.keyboard.press("Escape")
    assert page.locator('.pattern-window [data-selected="true"]').count() == 0
    assert picture(studio_page) == before
    page.locator('.pattern-window [data-panel="skirt_front"]').first.focus()
    page.keyboard.press("Enter")
    page.mouse.move(5, 5)
    assert picture(studio_page) != before


def test_dark_is_kept_and_inches_too(studio_page):
    page = studio_page.page
    studio_page.button("Dark colours").click()
    page.get_by_text("in", exact=True).click()
    page.reload()
    studio_page.canvas.wait_for()
    assert page.locator("html").get_attribute("data-theme") == "dark"
    studio_page.tab("Adjust")
    assert "in inches" in page.get_by_role("region", name="Dimensions").inner_text()
