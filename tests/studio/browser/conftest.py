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


@pytest.fixture
def page(browser, studio) -> Iterator[playwright.Page]:
    """A fresh window of the studio, as on a first visit; `page.problems` lists what the page complained of.

    At the end it must not have complained, nor asked another host.
    """
    context = browser.new_context(viewport=SIZE, base_url=studio.address, accept_downloads=True)
    context.set_default_timeout(WAIT_MS)
    window = context.new_page()
    window.problems = []
    window.on("pageerror", lambda error: window.problems.append(f"error: {error}"))
    window.on(
        "console",
        lambda said: window.problems.append(f"console: {said.text}") if said.type == "error" else None,
    )
    window.on(
        "request",
        lambda asked: None
        if asked.url.startswith((studio.address, "blob:", "data:"))
        else window.problems.append(f"another host: {asked.url}"),
    )
    yield window
    found = list(window.problems)
    context.close()
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
