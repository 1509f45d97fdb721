"""A headless browser for tests of pages; tests skip where it is missing, except in CI."""

import base64
import io
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Browser, Page, sync_playwright

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
WIDTHS = {1440: 900, 820: 1100, 360: 740}  # CSS pixels of the window
AXE = Path(__file__).parents[1] / "web/node_modules/axe-core/axe.min.js"
# software rendering of WebGL; the others keep the browser from looking for its maker's servers
FLAGS = (
    "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
# axe-core's rules: accessibility of WCAG 2.2, level AA, and good practice
VIOLATIONS = "async () => (await axe.run()).violations.map(v => [v.id, v.nodes.map(n => n.html)])"
# the program's own complaints count; that of the software renderer about reading its pixels does not
HARMLESS = "GPU stall due to ReadPixels"


def need_browser() -> None:
    """Skip the test without a browser, and fail in CI, which installs one."""
    if CHROMIUM is None and "CI" not in os.environ:
        pytest.skip("no Chromium on this machine")


STILL = {"reduced_motion": "reduce"}  # context of a page without motion


@contextmanager
def chromium() -> Iterator[Browser]:
    need_browser()
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=CHROMIUM, args=list(FLAGS))
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def page_at(
    browser: Browser, url: str, width: int = 1440, *, complains: bool = False, **context: object
) -> Iterator[Page]:
    """Open a page in a window of its own; errors and complaints on its console fail the test.

    complains : True if refusals of the server, which the browser lists there, belong to the test
    """
    with_size = {"viewport": {"width": width, "height": WIDTHS[width]}, **context}
    opened = browser.new_context(**with_size)  # type: ignore[arg-type]
    page, complaints = opened.new_page(), list[str]()
    page.on("console", lambda message: complaints.append(message.text) if message.type != "log" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    try:
        page.goto(url)
        yield page
        assert complains or not [text for text in complaints if HARMLESS not in text]
    finally:
        opened.close()


def pixels(page: Page, selector: str) -> NDArray[np.int64]:
    """(y, x, 4) colours of a canvas."""
    url = page.eval_on_selector(selector, "canvas => canvas.toDataURL()")
    image = Image.open(io.BytesIO(base64.b64decode(url.split(",")[1])))
    return np.asarray(image.convert("RGBA")).astype(int)


def advances(page: Page, frames: str) -> bool:
    """True if the number of drawn frames, an expression of the page, grows by more than three in 10 s."""
    first = page.evaluate(frames)
    for _ in range(200):
        page.wait_for_timeout(50)
        if page.evaluate(frames) > first + 3:
            return True
    return False


def violations(page: Page) -> list[object]:
    """Violations of axe-core's rules on a page."""
    if not AXE.exists() and "CI" not in os.environ:
        pytest.skip("axe-core is not installed: run npm ci in web/")
    # evaluated in the page's world by the driver, so the page's content security policy does not matter
    if page.evaluate("typeof axe") == "undefined":
        page.evaluate(AXE.read_text("utf-8"))
    faults: list[object] = page.evaluate(VIOLATIONS)
    return faults


def faults_of_layout(page: Page) -> list[object]:
    """Windows in which a page is too wide, and violations of accessibility, in all widths, light and dark."""
    faults = list[object]()
    for width, height in WIDTHS.items():
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(100)  # plots follow the width
        if page.evaluate("document.documentElement.scrollWidth") > width:
            faults.append(f"wider than {width} px")
        for scheme in ("light", "dark"):
            page.emulate_media(color_scheme=scheme, reduced_motion="reduce")  # type: ignore[arg-type]
            faults += violations(page)
    return faults


WRITES = """() => {
    window.written = [];
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y, ...others) {
        const { a, b, e, f } = this.getTransform();
        const width = this.measureText(text).width;
        const before = { right: 1, end: 1, center: 0.5 }[this.textAlign] ?? 0; // share of the width
        const left = x - before * width;
        window.written.push({ text, left: (b === 0 ? a * left + e : null), width });
        return fillText.call(this, text, x, y, ...others);
    };
}"""


def written(page: Page) -> list[dict[str, object]]:
    """Texts that plots write anew in a window of 700 pixels, with ``left`` in pixels; None if turned."""
    page.evaluate(WRITES)
    page.set_viewport_size({"width": 700, "height": 900})
    page.wait_for_function("() => window.written.length > 0")
    page.wait_for_timeout(200)
    texts: list[dict[str, object]] = page.evaluate("window.written")
    return texts
