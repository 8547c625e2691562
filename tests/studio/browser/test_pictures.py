"""From a picture to a garment."""

from __future__ import annotations

import io

import pytest
from PIL import Image
from studio_page import WORK_MS, StudioPage  # ty: ignore[unresolved-import]


@pytest.fixture
def picture(client) -> bytes:
    """A skirt on a plain figure, as PNG."""
    answer = client.get("/api/examples/pencil-skirt/thumbnail")
    out = io.BytesIO()
    Image.open(io.BytesIO(answer.content)).convert("RGB").save(out, "PNG")
    return out.getvalue()


def test_a_picture_becomes_a_garment_and_a_wrong_chip_is_corrected(page, picture, shot):
    studio_page = StudioPage(page).visit()
    before = studio_page.mesh()
    page.get_by_role("textbox", name="Describe a garment").fill("")
    page.get_by_label("Add a picture").set_input_files(
        {"name": "skirt.png", "mimeType": "image/png", "buffer": picture}
    )
    seen = page.get_by_role("img", name="What was looked at")
    seen.wait_for(timeout=WORK_MS)
    page.wait_for_function(
        "() => [...document.querySelectorAll('.picture-pair img')].every((i) => i.naturalWidth > 0)"
    )
    studio_page.button("Make the garment").click()
    studio_page.wait_for_another_mesh(before)
    studio_page.wait_for_work()
    assert "skirt" in studio_page.chip("garment").inner_text()
    shot(page, "picture-to-garment")
    hem = studio_page.chip("hem").inner_text().strip()
    other = "maxi" if "maxi" not in hem else "mini"
    studio_page.choose("hem", other)
    assert studio_page.chip("hem").inner_text().strip() == f"hem: {other}"
    assert studio_page.history()[0] == "Made from a picture"


def test_a_picture_can_be_pasted_dropped_and_removed(page, picture):
    studio_page = StudioPage(page).visit()
    page.evaluate(
        """([bytes, kind]) => {
            const data = new DataTransfer();
            data.items.add(new File([new Uint8Array(bytes)], "skirt.png", {type: "image/png"}));
            const target = document.querySelector(".app");
            target.dispatchEvent(
                kind === "paste"
                    ? new ClipboardEvent("paste", {clipboardData: data, bubbles: true})
                    : new DragEvent(kind, {dataTransfer: data, bubbles: true, cancelable: true}));
        }""",
        [list(picture), "paste"],
    )
    page.get_by_role("img", name="Picture as given").wait_for(timeout=WORK_MS)
    page.evaluate(
        """(bytes) => {
            const data = new DataTransfer();
            data.items.add(new File([new Uint8Array(bytes)], "back.png", {type: "image/png"}));
            const target = document.querySelector(".app");
            const about = {dataTransfer: data, bubbles: true, cancelable: true};
            target.dispatchEvent(new DragEvent("drop", about));
        }""",
        list(picture),
    )
    page.get_by_role("img", name="Back as given").wait_for(timeout=WORK_MS)
    studio_page.button("Remove: Front").click()
    assert page.get_by_role("img", name="Picture as given").count() == 1


def test_files_that_are_neither_are_refused_with_what_to_do(page):
    studio_page = StudioPage(page).visit()
    shown = studio_page.mesh()
    page.locator("#file-input").set_input_files(
        {"name": "notes.txt", "mimeType": "text/plain", "buffer": b"hello"}
    )
    messages = page.get_by_role("region", name="Messages")
    messages.get_by_text("neither a picture nor a pattern").wait_for()
    page.locator("#file-input").set_input_files(
        {"name": "x.json", "mimeType": "application/json", "buffer": b"{"}
    )
    messages.get_by_text("is not JSON").wait_for()
    assert studio_page.mesh() == shown
