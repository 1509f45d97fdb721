"""The view of a result in a notebook: what a notebook gets, and that a browser shows it."""

import base64
import os

import pytest
from playwright.sync_api import Browser

from browser import STILL, page_at, pixels
from haptonic.results.bands import Bands
from haptonic.study import loads
from haptonic.views import notebook
from haptonic.views.packed import compressed, packed
from quick import QUICK_CELL

IN_CI = "CI" in os.environ
SHOW = """async ([code, data]) => {
    const module = await import(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
    const bytes = Uint8Array.from(atob(data), letter => letter.charCodeAt(0));
    const model = { get: name => name === "data" ? new DataView(bytes.buffer) : undefined };
    window.remove = await module.default.render({ model, el: document.getElementById("output") });
}"""
OTHERS = """() => ["html", "body", "h1", "td"].map(name => {
    const { color, backgroundColor, font, margin, padding } = getComputedStyle(document.querySelector(name));
    return [color, backgroundColor, font, margin, padding];
})"""


def show_in_output(browser: Browser, code: str, data: bytes) -> None:
    """Show a view as a notebook does, in an output of a page with a style of its own, and remove it."""
    with page_at(browser, "about:blank", **STILL) as page:
        page.set_content(
            "<!doctype html><html lang=en><title>notebook</title>"
            "<h1>A notebook</h1><table><tr><td>cell</td></tr></table><div id=output></div>"
        )
        before = page.evaluate(OTHERS)
        page.evaluate(SHOW, [code, base64.b64encode(data).decode()])
        page.wait_for_selector("#output canvas[data-shown]")
        assert (pixels(page, "#output .mode canvas")[..., 3] > 0).mean() > 0.05
        page.locator("#output .walk").press("t")
        assert page.get_by_role("table", name="Gaps").is_visible()
        assert page.evaluate(OTHERS) == before
        page.evaluate("window.remove()")
        assert page.locator("#output *").count() == 0


@pytest.fixture(scope="module")
def bands() -> Bands:
    return loads(QUICK_CELL).bands(html=True)


@pytest.fixture
def _widgets():
    if not IN_CI:
        pytest.importorskip("anywidget")


@pytest.mark.usefixtures("_widgets")
def test_a_result_with_a_view_gives_a_widget_that_shows_it(bands, browser, monkeypatch):
    make, widgets = notebook.view_widget, []
    monkeypatch.setattr(notebook, "in_kernel", lambda: True)
    monkeypatch.setattr(notebook, "view_widget", lambda view: widgets.append(make(view)) or widgets[-1])
    bundle = bands._repr_mimebundle_()
    (widget,) = widgets
    assert list(bundle) == [notebook.WIDGET]
    assert bundle[notebook.WIDGET]["model_id"] == widget.model_id
    assert widget.data == compressed(packed(bands.view()))
    show_in_output(browser, widget.get_state()["_esm"], widget.data)


def test_tables_and_pictures_remain_without_a_view_a_notebook_or_the_extra(bands, monkeypatch):
    assert bands._repr_mimebundle_() == {}  # no notebook
    monkeypatch.setattr(notebook, "in_kernel", lambda: True)
    assert loads(QUICK_CELL).bands()._repr_mimebundle_() == {}
    monkeypatch.setattr(notebook, "find_spec", lambda name: None)
    assert bands._repr_mimebundle_() == {}
    assert "<table" in bands._repr_html_()


@pytest.mark.nightly
def test_a_saved_notebook_contains_the_view(browser, tmp_path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    code = f"from haptonic.study import loads\nloads('''{QUICK_CELL}''').bands(html=True)"
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    nbclient.NotebookClient(book, timeout=600, resources={"metadata": {"path": str(tmp_path)}}).execute()
    (shown,) = (output.data for output in book.cells[0].outputs if notebook.WIDGET in output.get("data", {}))
    assert "<table" in shown["text/html"]
    states = book.metadata.widgets["application/vnd.jupyter.widget-state+json"].state
    saved = states[shown[notebook.WIDGET]["model_id"]]
    (data,) = saved.buffers
    show_in_output(browser, saved.state["_esm"], base64.b64decode(data["data"]))
