"""What a pattern maker does in the pattern window, in a real browser on a real server."""

from __future__ import annotations

import gzip
import io
import json
from pathlib import Path

import numpy as np
import pytest
from pattern_drawing import PatternDrawing
from PIL import Image

SAMPLES = Path(__file__).parents[2] / "garmentcode_patterns" / "patterns.jsonl.gz"
SKIRT, TROUSERS = "gc_1002038", "gc_1000067"


@pytest.fixture(scope="session")
def real():
    """GarmentCode's own files by id."""
    with gzip.open(SAMPLES, "rt") as lines:
        return {sample["id"]: sample["pattern"] for sample in map(json.loads, lines)}


@pytest.fixture
def drawing(page):
    return PatternDrawing(page)


@pytest.fixture
def opened(drawing, real, tmp_path):
    """Opens one of the real files."""

    def open_file(name, change=lambda specification: None):
        specification = json.loads(json.dumps(real[name]))
        change(specification)
        path = tmp_path / f"{name}_specification.json"
        path.write_text(json.dumps(specification))
        drawing.open(path)
        return drawing

    return open_file


def share_of_pixels_that_differ(one: bytes, other: bytes) -> float:
    a, b = (np.asarray(Image.open(io.BytesIO(p)).convert("RGB"), int) for p in (one, other))
    return float((np.abs(a - b).max(axis=2) > 24).mean())


def test_a_hem_is_dragged_ten_centimetres_and_taken_back(opened, page, shot):
    """The hem of front and back goes down together; the garment follows; one undo takes it back."""
    window = opened(SKIRT)
    before = {name: window.vertices(name) for name in ("skirt_front", "skirt_back")}
    garment = window.picture_of_garment()
    hem = window.lowest_free_edge("skirt_front")
    reading = window.drag(window.on_edge("skirt_front", hem, 0.4), (0.0, 10.0))
    assert reading == "10 cm longer"
    for name, points in before.items():
        moved = np.array(window.vertices(name)) - points
        lower = moved[:, 1] != 0
        assert lower.any() and not lower.all()
        assert moved[lower] == pytest.approx(np.tile([0.0, -10.0], (int(lower.sum()), 1)), abs=1e-6)
    longer = window.picture_of_garment()
    shot(page, "hem-dragged")
    assert share_of_pixels_that_differ(garment, longer) > 0.01
    page.keyboard.press("Control+z")
    assert {name: window.vertices(name) for name in before} == before
    assert share_of_pixels_that_differ(garment, window.picture_of_garment()) < 0.002


def test_escape_ends_a_drag_without_a_trace(opened, page):
    window = opened(SKIRT)
    before = window.vertices("skirt_front")
    x, y = window.on_edge("skirt_front", window.lowest_free_edge("skirt_front"), 0.4)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 60, steps=4)
    assert window.vertices("skirt_front") != before
    page.keyboard.press("Escape")
    page.mouse.up()
    assert window.vertices("skirt_front") == before
    assert page.get_by_role("button", name="Undo").is_disabled()


def finding_is_shown(page, window, severity: str, panel: str) -> None:
    """Opens the findings and clicks the first: its place comes into the middle, nearer."""
    page.wait_for_function(
        f"() => document.querySelector('.findings-badge').textContent.includes('{severity}')"
    )
    page.locator(".findings-badge").click()
    finding = page.locator(f".findings li.{severity} button").first
    assert panel in finding.inner_text()
    far = window.scale()
    finding.click()
    assert window.scale() > far
    place, sheet = (
        page.locator(where).bounding_box() for where in (".overlay .highlight.selected", ".pattern-sheet")
    )
    for start, size in (("x", "width"), ("y", "height")):
        assert sheet[start] < place[start] + place[size] / 2 < sheet[start] + sheet[size]
    # The ring of the exact place is not behind the list, where the list has left room for it.
    rings = page.locator(".overlay .fault")
    if rings.count() > 0:
        page.wait_for_timeout(300)
        shown = rings.first.bounding_box()
        lists = page.locator(".findings-body").bounding_box()
        x, y = shown["x"] + shown["width"] / 2, shown["y"] + shown["height"] / 2
        inside = (
            lists["x"] < x < lists["x"] + lists["width"] and lists["y"] < y < lists["y"] + lists["height"]
        )
        assert not inside, (x, y, lists)


def test_an_outline_that_crosses_itself_is_mended_from_the_findings(opened, page, shot):
    """A dart's point is typed to lie outside the hem; the finding shows the place, a button mends it."""
    window = opened(TROUSERS)
    page.mouse.click(*window.on_edge("pant_b_l", 6, 0.0))
    field = page.locator(".number-field:has(span:text-is('Y')) input")
    field.fill("-0.3")
    field.press("Enter")
    assert window.vertices("pant_b_l")[6][1] == pytest.approx(-0.3)
    finding_is_shown(page, window, "warning", "pant_b_l")
    shot(page, "crossing")
    page.get_by_role("button", name="Repair what is safe to repair").click()
    page.wait_for_function("() => /No faults/.test(document.querySelector('.findings-badge').textContent)")
    assert window.vertices("pant_b_l")[6][1] > 0


def test_a_file_that_cannot_be_sewn_is_mended_by_hand(opened, page, shot):
    """Too far off to be repaired safely: it opens, says where it is wrong, and a drag puts it right."""

    def poke(specification):
        specification["pattern"]["panels"]["pant_b_l"]["vertices"][6][1] = -3.0

    window = opened(TROUSERS, poke)
    finding_is_shown(page, window, "error", "pant_b_l")
    shot(page, "self-crossing")
    page.locator(".findings-badge").click()
    page.locator(".pattern-sheet").focus()
    page.keyboard.press("f")
    window.drag(window.on_edge("pant_b_l", 6, 0.0), (0.0, -20.0))
    page.wait_for_function("() => /No faults/.test(document.querySelector('.findings-badge').textContent)")
    assert window.vertices("pant_b_l")[6][1] == pytest.approx(17.0, abs=1.5)
    window.wait_until_sewn()
    shot(page, "self-crossing-mended")


def test_a_stitch_is_removed_and_made_again(opened, page, shot):
    """Both ways to sew: two edges and a button, or the tool."""
    window = opened(SKIRT)
    page.get_by_role("button", name="Mirror editing").click()
    seams = [e for e in window.edges("skirt_front") if e["seam"] is not None]
    seam = max(seams, key=lambda e: e["length"])
    (partner,) = [e for e in window.edges("skirt_back") if e["seam"] == seam["seam"]]
    page.mouse.click(*window.on_edge("skirt_front", seam["edge"]))
    page.get_by_role("button", name="Remove stitch").click()
    assert window.edges("skirt_front")[seam["edge"]]["seam"] is None
    assert window.edges("skirt_back")[partner["edge"]]["seam"] is None

    page.keyboard.press("Escape")
    page.locator(".pattern-sheet").focus()
    page.keyboard.press("s")
    page.mouse.click(*window.on_edge("skirt_front", seam["edge"]))
    page.mouse.click(*window.on_edge("skirt_back", partner["edge"]))
    again = window.edges("skirt_front")[seam["edge"]]["seam"]
    assert again is not None and window.edges("skirt_back")[partner["edge"]]["seam"] == again
    shot(page, "sewn-again")
    page.keyboard.press("v")
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert window.edges("skirt_front") == seams_back(window, seam)


def seams_back(window, seam):
    """The edges of the front, which must hold the seam that they held at first."""
    edges = window.edges("skirt_front")
    assert edges[seam["edge"]]["seam"] == seam["seam"]
    return edges


def test_both_sides_are_edited_at_once_or_one_alone(opened, page, shot):
    window = opened(TROUSERS)
    left, right = window.vertices("pant_f_l"), window.vertices("pant_f_r")
    corner = window.on_edge("pant_f_l", 4, 0.0)
    page.keyboard.down("Control")  # No snapping: the shift is what the hand does.
    window.drag(corner, (-2.0, 1.5))
    page.keyboard.up("Control")
    shifts = [np.array(window.vertices(n)) - v for n, v in (("pant_f_l", left), ("pant_f_r", right))]
    (moved,), (other,) = (np.flatnonzero(np.abs(s).sum(axis=1)) for s in shifts)
    assert moved == 4
    assert shifts[1][other] == pytest.approx(shifts[0][moved] * [-1, 1], abs=1e-9)
    assert np.abs(shifts[0][moved]) == pytest.approx([2.0, 1.5], abs=0.3)
    shot(page, "mirrored")

    page.locator(".pattern-sheet").focus()
    page.keyboard.press("m")
    alone = window.vertices("pant_f_r")
    window.drag(window.on_edge("pant_f_l", 4, 0.0), (2.0, 0.0))
    assert window.vertices("pant_f_r") == alone
    assert window.vertices("pant_f_l") != (np.array(left) + shifts[0]).tolist()


def test_a_seam_is_split_on_both_sides_by_a_double_click(opened, page):
    window = opened(SKIRT)
    page.get_by_role("button", name="Mirror editing").click()
    seam = max((e for e in window.edges("skirt_front") if e["seam"] is not None), key=lambda e: e["length"])
    counts = {name: len(window.edges(name)) for name in ("skirt_front", "skirt_back")}
    page.mouse.dblclick(*window.on_edge("skirt_front", seam["edge"], 0.3))
    assert {name: len(window.edges(name)) for name in counts} == {n: c + 1 for n, c in counts.items()}
    front = window.edges("skirt_front")[seam["edge"]]
    (back,) = [e for e in window.edges("skirt_back") if e["seam"] == front["seam"]]
    assert back["length"] == pytest.approx(front["length"], rel=0.05)
    page.locator(".pattern-sheet").focus()
    page.keyboard.press("Delete")
    assert {name: len(window.edges(name)) for name in counts} == counts


def test_everything_goes_by_keyboard(opened, page, shot):
    """From panel to point with Tab and Enter, moved by arrow keys, taken back."""
    window = opened(SKIRT)
    page.locator(".pattern-sheet").focus()
    page.keyboard.press("Tab")
    focused = "() => document.activeElement.getAttribute('aria-label')"
    assert page.evaluate(focused).startswith("Panel ")
    panel = page.evaluate("() => document.activeElement.dataset.panel")
    before = window.vertices(panel)
    page.keyboard.press("m")
    page.keyboard.press("Enter")
    page.wait_for_function("() => document.activeElement.dataset.target !== undefined")
    page.keyboard.press("Tab")
    assert page.evaluate(focused).startswith("Point 0 of")
    shot(page, "keyboard")
    page.keyboard.press("Shift+ArrowDown")
    page.keyboard.press("ArrowUp")
    moved = np.array(window.vertices(panel)) - before
    assert moved[0] == pytest.approx([0.0, -0.9]) and not moved[1:].any()
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert window.vertices(panel) == before


def test_a_length_that_is_typed_is_the_edge_s_length(opened, page):
    window = opened(SKIRT)
    page.get_by_role("button", name="Mirror editing").click()
    seam = max((e for e in window.edges("skirt_front") if e["seam"] is not None), key=lambda e: e["length"])
    page.mouse.click(*window.on_edge("skirt_front", seam["edge"]))
    field = page.get_by_label("Length", exact=False)
    field.fill("42,5")
    field.press("Enter")
    assert window.edges("skirt_front")[seam["edge"]]["length"] == pytest.approx(42.5, abs=0.01)
    assert "cm" in page.locator(".longer").first.text_content()


def test_fingers_pinch_and_move_the_sheet(opened, page):
    window = opened(SKIRT)
    before = window.vertices("skirt_front")
    box = page.locator(".pattern-sheet").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    scale = window.scale()
    touch = page.context.new_cdp_session(page)

    def fingers(kind, *points):
        places = [{"x": px, "y": py, "id": k} for k, (px, py) in enumerate(points)]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})

    fingers("touchStart", (x - 40, y), (x + 40, y))
    for spread in (50, 60, 70, 80):
        fingers("touchMove", (x - spread, y), (x + spread, y))
    fingers("touchEnd")
    assert window.scale() == pytest.approx(2 * scale, rel=0.1)
    assert window.vertices("skirt_front") == before


def test_no_panel_jumps_while_another_is_edited(opened, page):
    window = opened(SKIRT)
    place = "() => document.querySelector('.panel[data-panel=skirt_back]').getAttribute('transform')"
    before = page.evaluate(place)
    window.drag(window.on_edge("skirt_front", window.lowest_free_edge("skirt_front"), 0.4), (0.0, 25.0))
    window.wait_until_sewn()
    assert page.evaluate(place) == before
