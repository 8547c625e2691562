"""Takes the pictures of docs/studio.md: a studio of its own, driven in chromium as a person would.

    .venv/bin/python scripts/make_studio_pictures.py [--only NAME...]

Writes docs/images/studio*.webp. Needs the extra `studio`, and chromium and Playwright as the tests do.
"""

from __future__ import annotations

import argparse
import io
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

ROOT = Path(__file__).parents[1]
sys.path += [str(ROOT / "tests" / "studio"), str(ROOT / "tests" / "studio" / "browser")]

from pattern_drawing import PatternDrawing  # noqa: E402
from running_studio import start_studio, wait_until_ready  # noqa: E402
from studio_page import StudioPage  # noqa: E402

IMAGES = ROOT / "docs" / "images"
SIZE = {"width": 1440, "height": 900}
ANIMATION_WIDTH, ANIMATION_MS = 900, 125
BROWSER = [
    "--no-sandbox",
    "--disable-gpu",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
]


def keep(page: Page, name: str) -> None:
    """A screenshot as WebP."""
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    picture.save(IMAGES / f"{name}.webp", "WEBP", quality=82, method=6)
    print(f"{name}: {(IMAGES / f'{name}.webp').stat().st_size / 1000:.0f} kB")


def first_page(page: Page, studio: StudioPage) -> None:
    page.wait_for_timeout(1500)
    keep(page, "studio")


def words(page: Page, studio: StudioPage) -> None:
    """What was read, and a chip that is about to be corrected."""
    studio.describe("a knee-length sleeveless red dress with a V neck and sequins")
    studio.chip("hem").click()
    page.wait_for_timeout(1500)
    keep(page, "studio-words")


def compare(page: Page, studio: StudioPage) -> None:
    before = studio.mesh()
    studio.tab("Adjust")
    page.get_by_role("textbox", name="Change it in words").fill(
        "give it long sleeves and make the skirt 20 cm shorter"
    )
    page.keyboard.press("Enter")
    studio.wait_for_another_mesh(before)
    studio.wait_for_work()
    page.locator(".changes").get_by_role("button", name="Compare with before").click()
    page.wait_for_timeout(3000)
    keep(page, "studio-compare")


def body(page: Page, studio: StudioPage) -> None:
    """A garment for another size and height."""
    studio.tab("Body")
    for act in (
        lambda: studio.button("women EU 46").click(),
        lambda: page.get_by_role("spinbutton", name="Height, cm", exact=True).fill("178"),
    ):
        before = studio.mesh()
        act()
        page.keyboard.press("Enter")
        studio.wait_for_another_mesh(before)
        studio.wait_for_work()
    page.wait_for_timeout(2000)
    keep(page, "studio-body")


def strain(page: Page, studio: StudioPage) -> None:
    """Dark, the strain map."""
    studio.button("Dark colours").click()
    page.get_by_text("Strain", exact=True).click()
    studio.tab("Adjust")
    page.wait_for_timeout(2000)
    keep(page, "studio-strain")


def drag(page: Page, studio: StudioPage) -> None:
    """An animation: the hem of the dress goes down and up again, the garment with it."""
    drawing, frames = PatternDrawing(page), []

    def frame(times: int = 1) -> None:
        picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
        size = ANIMATION_WIDTH, round(ANIMATION_WIDTH * SIZE["height"] / SIZE["width"])
        frames.extend([picture.resize(size, Image.Resampling.LANCZOS)] * times)

    panel = "skirt_front"
    start = drawing.on_edge(panel, drawing.lowest_free_edge(panel), 0.45)
    scale = drawing.scale()
    frame(12)
    page.mouse.move(*start)
    page.mouse.down()
    way = (
        [k / 12 for k in range(1, 13)]
        + [1 - k / 18 for k in range(1, 28)]
        + [-0.5 + k / 18 for k in range(1, 10)]
    )
    for share in way:
        page.mouse.move(start[0], start[1] + 30 * share * scale)
        page.wait_for_timeout(700)  # the garment follows; the film runs faster than a busy machine
        frame(3)
    page.mouse.up()
    page.wait_for_timeout(1500)
    frame(12)
    path = IMAGES / "studio-drag.webp"
    frames[0].save(
        path,
        "WEBP",
        save_all=True,
        append_images=frames[1:],
        duration=ANIMATION_MS,
        loop=0,
        quality=60,
        method=4,
    )
    seconds = len(frames) * ANIMATION_MS / 1000
    print(f"studio-drag: {seconds:.0f} s, {path.stat().st_size / 1000:.0f} kB")


SCENES: dict[str, Callable[[Page, StudioPage], None]] = {
    "first_page": first_page,
    "words": words,
    "compare": compare,
    "body": body,
    "strain": strain,
    "drag": drag,
}


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--only", nargs="+", choices=SCENES, default=list(SCENES))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as projects:
        running = start_studio(Path(projects))
        try:
            wait_until_ready(running)
            with sync_playwright() as playwright:
                browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=BROWSER)
                for name in options.only:
                    page = browser.new_page(viewport=SIZE, base_url=running.address)
                    page.set_default_timeout(120_000)
                    SCENES[name](page, StudioPage(page).visit())
                    page.close()
                browser.close()
        finally:
            running.end()


if __name__ == "__main__":
    main()
