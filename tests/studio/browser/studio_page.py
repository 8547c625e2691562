"""The studio as a person uses it: by what is written on its buttons and fields."""

from __future__ import annotations

import re

WORK_MS = 120_000
"""For work that computes, on a machine that is shared."""


class StudioPage:
    """A window with the studio open."""

    def __init__(self, page) -> None:
        """Nothing is visited yet."""
        self.page = page

    def visit(self, path: str = "/") -> StudioPage:
        """Opens it, skips the tour of the first visit, and waits for the garment."""
        self.page.emulate_media(reduced_motion="reduce")
        self.page.goto(path)
        skip = self.page.get_by_role("button", name="Skip the tour")
        skip.wait_for()
        skip.click()
        self.canvas.wait_for()
        return self

    @property
    def canvas(self):
        """The drawing of the garment, once a mesh is in it."""
        return self.page.locator(".garment-window canvas[data-mesh]")

    def mesh(self) -> str:
        """Name of the mesh that is shown: a digest of its content."""
        return self.canvas.get_attribute("data-mesh")

    def camera(self) -> list[float]:
        """Where the camera is and what it looks at, cm."""
        return [float(number) for number in self.canvas.get_attribute("data-camera").split()]

    def wait_for_another_mesh(self, before: str) -> str:
        """Waits until the garment is another one than before."""
        self.page.locator(f'.garment-window canvas[data-mesh]:not([data-mesh="{before}"])').wait_for(
            timeout=WORK_MS
        )
        return self.mesh()

    def wait_for_work(self) -> None:
        """Until no job is under way, and no quick work either."""
        self.page.locator(".job-bar").wait_for(state="detached", timeout=WORK_MS)
        self.page.locator(".working:not([data-shown])").wait_for(state="attached", timeout=WORK_MS)

    def button(self, name: str):
        """The button with this name, and no other that begins so."""
        return self.page.get_by_role("button", name=name, exact=True)

    def tab(self, name: str) -> None:
        """Turns to a tab of the left column."""
        self.page.get_by_role("tab", name=name).click()

    def describe(self, text: str) -> None:
        """Makes a garment of words, and waits for it."""
        before = self.mesh()
        self.page.get_by_role("textbox", name="Describe a garment").fill(text)
        self.button("Make the garment").click()
        self.wait_for_another_mesh(before)
        self.wait_for_work()

    def chip(self, label: str):
        """The chip of the word that was read about this, such as "hem"; not that of a length."""
        return self.page.get_by_role("region", name="What was read").get_by_role(
            "button", name=re.compile(f"^{label}: [a-z]")
        )

    def choose(self, label: str, value: str) -> None:
        """Corrects a chip, and waits for the garment that is cut to it."""
        before = self.mesh()
        self.chip(label).click()
        self.page.get_by_role("option", name=value, exact=True).click()
        self.wait_for_another_mesh(before)
        self.wait_for_work()

    def history(self) -> list[str]:
        """Labels of the history, oldest first."""
        self.tab("History")
        return self.page.locator(".history-label").all_inner_texts()[::-1]

    def download(self, form: str):
        """Saves in a format; the path of the file."""
        self.button("Download").click()
        with self.page.expect_download(timeout=WORK_MS) as waiting:
            self.page.get_by_role("menuitem", name=re.compile(rf"^{form}\b")).click()
        return waiting.value
