"""For everybody: axe-core finds nothing, all is reached by keys, and it fits a small window."""

from __future__ import annotations

from pathlib import Path

import pytest
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]

AXE = Path(__file__).parents[3] / "studio-ui" / "node_modules" / "axe-core" / "axe.min.js"


@pytest.fixture
def check(page):
    """Says what axe-core finds on the page as it is now."""
    if not AXE.is_file():
        pytest.skip("no axe-core: npm ci in studio-ui")

    def run() -> list[str]:
        # By the debugger, not as a script of the page: its content security policy allows none.
        page.evaluate(AXE.read_text())
        found = page.evaluate("() => axe.run(document, {resultTypes: ['violations']})")
        return [
            f"{each['id']} ({each['impact']}): {node['html'][:160]} {node['failureSummary'][:200]}"
            for each in found["violations"]
            for node in each["nodes"][:4]
        ]

    return run


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing_on_any_tab(page, check, theme):
    studio_page = StudioPage(page).visit()
    if theme == "dark":
        studio_page.button("Dark colours").click()
    for tab in ("Describe", "Adjust", "Body", "History"):
        studio_page.tab(tab)
        page.wait_for_timeout(200)
        assert not check(), tab
    page.get_by_text("Strain", exact=True).click()
    assert not check(), "strain"


def test_axe_finds_nothing_in_dialogs_menus_and_the_tour(page, check):
    page.goto("/")
    page.get_by_role("dialog", name="Tour, step 1 of 5").wait_for()
    assert not check(), "tour"
    page.get_by_role("button", name="Skip the tour").click()
    studio_page = StudioPage(page)
    studio_page.canvas.wait_for()
    page.keyboard.press("?")
    page.get_by_role("dialog", name="Keyboard shortcuts").wait_for()
    assert not check(), "shortcuts"
    page.keyboard.press("Escape")
    studio_page.button("Open").click()
    page.get_by_role("dialog", name="Open").wait_for()
    assert not check(), "open"
    page.keyboard.press("Escape")
    studio_page.button("Download").click()
    assert not check(), "download"
    page.keyboard.press("Escape")
    studio_page.chip("hem").click()
    assert not check(), "chip"
    page.get_by_role("option", name="mini", exact=True).click()
    studio_page.wait_for_work()
    page.keyboard.press("c")
    page.get_by_role("dialog", name="Compare two versions").wait_for(timeout=WORK_MS)
    assert not check(), "compare"


def test_the_tour_has_five_steps_and_is_shown_once(page):
    page.goto("/")
    for step in range(1, 6):
        page.get_by_role("dialog", name=f"Tour, step {step} of 5").wait_for()
        box = page.locator(".tour-card").bounding_box()
        assert box["x"] >= 0 and box["y"] >= 0
        assert box["x"] + box["width"] <= 1440 and box["y"] + box["height"] <= 900
        page.get_by_role("button", name="Start" if step == 5 else "Next", exact=True).click()
    page.reload()
    StudioPage(page).canvas.wait_for()
    assert page.locator(".tour").count() == 0


def test_the_whole_way_by_keys(page):
    studio_page = StudioPage(page).visit()
    before = studio_page.mesh()
    prompt = page.get_by_role("textbox", name="Describe a garment")
    for _ in range(40):
        if prompt.evaluate("(field) => field === document.activeElement"):
            break
        page.keyboard.press("Tab")
    page.keyboard.press("Control+A")
    page.keyboard.type("a short pencil skirt")
    page.keyboard.press("Control+Enter")
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    made = studio_page.mesh()
    studio_page.chip("hem").focus()
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    studio_page.wait_for_another_mesh(made)


@pytest.mark.parametrize("width", [1024, 1280, 1920])
def test_nothing_is_cut_off(page, width):
    studio_page = StudioPage(page)
    page.set_viewport_size({"width": width, "height": 720})
    studio_page.visit()
    cut = page.evaluate(
        """() => [...document.querySelectorAll(
                "header button, .window-bar button, .window-foot button, .tabs button")]
            .filter((button) => {
                const box = button.getBoundingClientRect();
                const around = button.closest(".window, .pattern-window, header, .sidebar");
                const frame = around.getBoundingClientRect();
                return box.width > 0 && (box.right > frame.right + 1 || box.left < frame.left - 1);
            })
            .map((button) => button.title || button.textContent)"""
    )
    assert cut == []
    assert page.evaluate("() => document.documentElement.scrollWidth <= window.innerWidth")
