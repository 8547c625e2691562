"""A real browser on a real server: Debian's chromium, or what $SWIFTTAILOR_CHROMIUM names, by Playwright.

Where there is none, the tests are skipped, and say so; CI has one.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make setup")

OPTIONS = [
    "--no-sandbox",
    "--disable-gpu",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
]
SIZE = {"width": 1440, "height": 900}
SCALE = 1.0 if "SWIFTTAILOR_SHOTS" in os.environ else 0.5
"""Pixels drawn for one of the layout: the processor draws them, and for tests half as fine does."""
ICON = "/favicon.ico"
"""What the browser asks for, unasked, with an answer that is no page and names no icon."""
WAIT_MS = 60_000
"""On a machine that is shared by many."""


def find_chromium() -> str | None:
    """Where the browser is; None where there is none."""
    named = os.environ.get("SWIFTTAILOR_CHROMIUM")
    return named or shutil.which("chromium") or shutil.which("chromium-browser")


@pytest.fixture(scope="session")
def browser() -> Iterator[playwright.Browser]:
    """One browser for all tests."""
    path = find_chromium()
    if path is None:
        pytest.skip("no chromium: apt-get install chromium, or set SWIFTTAILOR_CHROMIUM")
    with playwright.sync_playwright() as started:
        running = started.chromium.launch(executable_path=path, args=OPTIONS)
        yield running
        running.close()


@pytest.fixture(scope="session")
def window(browser, studio) -> Iterator[playwright.Page]:
    """One window for all tests: to open another and read the program anew takes longer than most of them."""
    context = browser.new_context(
        viewport=SIZE,
        device_scale_factor=SCALE,
        base_url=studio.address,
        accept_downloads=True,
        reduced_motion="reduce",  # What turns while one waits is drawn sixty times a second.
    )
    context.set_default_timeout(WAIT_MS)
    opened = context.new_page()
    opened.problems = []
    opened.on("pageerror", lambda error: opened.problems.append(f"error: {error}"))
    opened.on(
        "console",
        lambda said: opened.problems.append(f"console: {said.text}")
        if said.type == "error" and not said.location["url"].endswith(ICON)
        else None,
    )
    opened.on(
        "request",
        lambda asked: None
        if asked.url.startswith((studio.address, "blob:", "data:"))
        else opened.problems.append(f"another host: {asked.url}"),
    )
    yield opened
    context.close()


@pytest.fixture
def page(window) -> Iterator[playwright.Page]:
    """The studio as on a first visit; `page.problems` lists what the page complained of.

    At the end it must not have complained, nor asked another host.
    """
    # An answer of the server that is no page: what the last test left cannot write itself down again there.
    window.goto("/api/state")
    window.evaluate("() => { localStorage.clear(); sessionStorage.clear() }")
    window.set_viewport_size(SIZE)
    window.mouse.up()
    for key in ("Control", "Shift"):
        window.keyboard.up(key)
    window.problems.clear()
    yield window
    found = list(window.problems)
    assert not found, "\n".join(found)


@pytest.fixture
def shot(request: pytest.FixtureRequest, tmp_path: Path):
    """Takes a screenshot: `shot(page, "name")` writes into $SWIFTTAILOR_SHOTS, or the test's folder."""
    folder = Path(os.environ.get("SWIFTTAILOR_SHOTS") or tmp_path)
    folder.mkdir(parents=True, exist_ok=True)

    def take(window: playwright.Page, name: str) -> Path:
        path = folder / f"{name}.png"
        window.screenshot(path=str(path))
        return path

    return take
