"""Interactive views in the report: closed at first, one open at a time, the program once in the file."""

import base64
import hashlib
import re
from dataclasses import replace

from matplotlib.figure import Figure

from browser import STILL, faults_of_layout, page_at
from haptonic.report.page import page
from haptonic.study import loads
from haptonic.views import program
from quick import QUICK_CELL, QUICK_RIBBON
from simulated import reference_layers, results_of


def test_views_of_chapters_open_one_at_a_time(browser, tmp_path, monkeypatch):
    monkeypatch.setattr("haptonic.plots.style.arrange", lambda figure: None)
    monkeypatch.setattr("haptonic.plots.rendered", lambda figure, kind: b"<svg/>")
    monkeypatch.setattr("haptonic.plots.moving_modes", lambda dataset: b"")
    for name in ("mode_shapes", "iso_frequency", "layers", "decay"):
        monkeypatch.setattr(f"haptonic.plots.{name}", lambda *_, **__: Figure())
    study = loads(QUICK_CELL)
    bands = study.bands(html=True)
    mirror = replace(reference_layers(), interactive=True)
    text = page(results_of(study, bands.dataset, layers=mirror))
    assert text.count(program()) == 1
    allowed = re.search("script-src 'sha256-([^']*)'", text)[1]
    assert base64.b64decode(allowed) == hashlib.sha256(program().encode()).digest()
    (tmp_path / "report.html").write_text(text, "utf-8")
    with page_at(browser, (tmp_path / "report.html").as_uri(), **STILL) as opened:
        first = opened.get_by_role("button", name="Move the modes")
        second = opened.get_by_role("button", name="Choose rows")
        first.wait_for()
        assert opened.locator("canvas").count() == 0
        first.click()
        opened.wait_for_selector("#dispersion canvas[data-shown]")
        assert opened.locator("h1:visible").count() == 1  # that of the report
        assert faults_of_layout(opened) == []
        second.click()
        opened.wait_for_selector("#mirror .uplot")
        assert opened.locator("#dispersion canvas").count() == 0
        assert mirror.summary()[0].split(": ")[1].split(",")[0][:2] in opened.locator("#point").inner_text()
        opened.get_by_role("button", name="Close the view").click()
        assert opened.locator("canvas").count() == 0
        assert first.get_attribute("aria-expanded") == "false"


def test_a_chapter_opens_each_of_its_views_and_a_plain_chapter_its_own(browser, tmp_path, monkeypatch):
    monkeypatch.setattr("haptonic.plots.rendered", lambda figure, kind: b"<svg/>")
    for name in ("mode_shapes", "dispersion", "projected", "ribbon_field"):
        monkeypatch.setattr(f"haptonic.plots.{name}", lambda *_, **__: Figure())
    monkeypatch.setattr("haptonic.plots.moving_modes", lambda dataset: b"")
    study = loads(QUICK_CELL + QUICK_RIBBON)
    bands, ribbon = study.bands(), study.ribbon(html=True)
    results = results_of(study, bands.dataset)
    text = page(replace(results, parts={**results.parts, "ribbon": ribbon}))
    (tmp_path / "report.html").write_text(text, "utf-8")
    with page_at(browser, (tmp_path / "report.html").as_uri(), **STILL) as opened:
        opened.get_by_role("button", name="Open the interactive view").click()
        opened.wait_for_selector("#ribbon .map canvas[data-shown]")
        assert opened.locator("h1:visible").count() == 1
        assert faults_of_layout(opened) == []
