"""The studio's page in a real browser: first paint, size, and frames of a garment that is turned.

    .venv/bin/python benchmarks/studio_browser.py [--visits 5] [--drags 60]

Starts a server of its own and Debian's chromium (Playwright), each time as a first visit with an empty cache,
on loopback. A long dress of about 30,000 vertices is sewn and turned by the mouse; a frame's time is from one
that shows another camera to the next. Without a graphics card chromium draws in software (SwiftShader), on
the same processor as all else; what draws is printed. Processor seconds are those of the browser, user and
system, of all its processes: other programs on the machine hardly change them.
"""

from __future__ import annotations

import argparse
import gzip
import json
import os
import shutil
import signal
import statistics
import sys
import tempfile

import psutil
from playwright.sync_api import Browser, Page, sync_playwright

from studio_load import start

OPTIONS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
SIZE = {"width": 1280, "height": 800}
CANVAS = ".garment-window canvas[data-mesh]"
FINE, FIRST = "long-dress", "summer-dress"
PAINT = f"""() => new Promise((done) => {{
  const look = () => {{
    const [paint] = performance.getEntriesByName("first-contentful-paint");
    if (paint && document.querySelector("{CANVAS}")) done([paint.startTime, performance.now()]);
    else requestAnimationFrame(look);
  }};
  look();
}})"""
COLLECT = f"""() => {{
  const canvas = document.querySelector("{CANVAS}");
  window.frames_ms = [];
  let camera = canvas.dataset.camera, last = performance.now();
  const look = (now) => {{
    if (canvas.dataset.camera !== camera) {{
      window.frames_ms.push(now - last);
      camera = canvas.dataset.camera;
    }}
    last = now;
    requestAnimationFrame(look);
  }};
  requestAnimationFrame(look);
}}"""
SEW = """async (example) => {
  const ask = async (path, body) => (await fetch(path, body && { method: "POST",
    headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) })).json();
  const { pattern } = await ask(`/api/examples/${example}`);
  let job = await ask("/api/jobs", { kind: "sew", pattern, edge_length: 1.0 });
  while (!["done", "failed"].includes(job.state)) {
    await new Promise((go) => setTimeout(go, 300));
    job = await ask(`/api/jobs/${job.id}`);
  }
  const [made] = job.documents;
  const bytes = await (await fetch(`/api/meshes/${made.mesh}`)).arrayBuffer();
  const length = new DataView(bytes).getUint32(8, true);
  return [made, JSON.parse(new TextDecoder().decode(bytes.slice(12, 12 + length))).vertices];
}"""
RENDERER = """() => {
  const gl = document.createElement("canvas").getContext("webgl2");
  const about = gl.getExtension("WEBGL_debug_renderer_info");
  return about ? gl.getParameter(about.UNMASKED_RENDERER_WEBGL) : "unknown";
}"""


def browser_seconds(server: int) -> float:
    """Processor seconds of the browser so far."""
    total = 0.0
    for one in psutil.Process().children(recursive=True):
        try:
            if one.pid != server and one.ppid() != server and "chrom" in one.name():
                total += sum(one.cpu_times()[:2])
        except psutil.NoSuchProcess:
            continue
    return total


def visited(browser: Browser, address: str) -> Page:
    """A window with an empty cache and nothing remembered; the page is under way."""
    page = browser.new_context(viewport=SIZE, base_url=address).new_page()
    page.goto("/", wait_until="commit")
    return page


def first_paint(browser: Browser, address: str, visits: int, server: int) -> None:
    """Milliseconds from the request to the first paint, and to the finished garment."""
    painted, shown = [], []
    used = browser_seconds(server)
    for _ in range(visits):
        page = visited(browser, address)
        first, garment = page.evaluate(PAINT)
        painted.append(first)
        shown.append(garment)
        page.context.close()
    used = (browser_seconds(server) - used) / visits
    print(
        f"first paint: median {statistics.median(painted):.0f} ms, worst {max(painted):.0f} ms; "
        f"finished garment: median {statistics.median(shown):.0f} ms, worst {max(shown):.0f} ms; "
        f"{1000 * used:.0f} ms of a processor for all of it; n = {visits}"
    )


def bundle(browser: Browser, address: str) -> None:
    """Bytes of what the page itself loads, gzipped."""
    page, packed = browser.new_context(base_url=address).new_page(), dict[str, int]()

    def note(response) -> None:
        if response.ok and response.url.startswith(address) and "/api/" not in response.url:
            packed[response.url.rsplit("/", 1)[-1] or "index.html"] = len(gzip.compress(response.body(), 9))

    page.on("response", note)
    page.goto("/")
    page.locator(CANVAS).wait_for()
    parts = ", ".join(f"{name} {size / 1000:.1f}" for name, size in packed.items())
    print(f"bundle: {sum(packed.values()) / 1000:.0f} kB gzipped ({parts})")
    page.context.close()


def orbit(browser: Browser, address: str, steps: int, server: int) -> None:
    """Frames while a fine garment is turned."""
    page = visited(browser, address)
    page.evaluate(PAINT)
    made, vertices = page.evaluate(SEW, FINE)
    page.context.close()
    page = browser.new_context(viewport=SIZE, base_url=address).new_page()

    page.route(f"**/api/examples/{FIRST}", lambda route: route.fulfill(json=made))
    page.goto("/")
    page.locator(f'.garment-window canvas[data-mesh="{made["mesh"]}"]').wait_for(timeout=120_000)
    page.keyboard.press("Escape")  # the tour of a first visit
    box = page.locator(CANVAS).bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 40, y, steps=8)
    page.evaluate(COLLECT)
    used = browser_seconds(server)
    for k in range(steps):
        page.mouse.move(x + 40 + (4 * k if k < steps / 2 else 4 * (steps - k)), y)
    page.mouse.up()
    used = browser_seconds(server) - used
    times = sorted(page.evaluate("() => window.frames_ms"))
    print(
        f"turning {vertices} vertices at {json.dumps(SIZE)}: {len(times)} frames, "
        f"median {statistics.median(times):.0f} ms, p95 {times[int(0.95 * (len(times) - 1))]:.0f} ms, "
        f"{1000 * used / len(times):.0f} ms of a processor a frame; drawn by {page.evaluate(RENDERER)}"
    )
    page.context.close()


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--visits", type=int, default=5)
    parser.add_argument("--drags", type=int, default=60, help="steps of the mouse")
    options = parser.parse_args()
    chromium = os.environ.get("SWIFTTAILOR_CHROMIUM") or shutil.which("chromium")
    if chromium is None:
        sys.exit("There is no chromium: apt-get install chromium, or set SWIFTTAILOR_CHROMIUM.")
    with tempfile.TemporaryDirectory() as projects, sync_playwright() as playwright:
        process, address = start(projects)
        browser = playwright.chromium.launch(executable_path=chromium, args=OPTIONS)
        try:
            first_paint(browser, address, options.visits, process.pid)
            bundle(browser, address)
            orbit(browser, address, options.drags, process.pid)
        finally:
            browser.close()
            process.send_signal(signal.SIGINT)
            process.wait(30)
    return 0


if __name__ == "__main__":
    sys.exit(main())
