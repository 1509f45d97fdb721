"""The page of waveguides: fields against profiles and decays, and the page in a browser."""

import numpy as np
import pytest

from browser import STILL, advances, faults_of_layout, page_at, pixels
from haptonic.bloch.candidates import best_model
from haptonic.bloch.guide import Guide
from haptonic.bloch.guide_fields import guided_field
from haptonic.bloch.mirrors import condensed_rows
from haptonic.results.guides import Guides
from haptonic.study import loads
from haptonic.units import uncertain
from quick import QUICK_CELL

STUDY = (
    QUICK_CELL.replace("60 kHz", "57 kHz").replace("order = 2", "order = 3") + '\n[waveguide]\nmode = "1x9"\n'
)
FIELD = ".map canvas"


@pytest.fixture(scope="module")
def guides() -> Guides:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("haptonic.analyses.waveguide.MOST_LENGTHS", 2)
        return loads(STUDY).waveguide(html=True)


def test_a_field_has_the_profile_of_its_mode_and_its_decay(guides):
    data, positions = guides.dataset, guides.dataset["across"].values
    field = data["mode_real"].values + 1j * data["mode_imag"].values
    for number, strip in enumerate(guides.strips):
        size = np.sqrt((np.abs(field[number]) ** 2).mean(axis=1))
        size /= size.max()
        inside = np.abs(positions) < 0.5 * strip.mode.width
        expected = np.interp(positions[inside], strip.mode.position, strip.mode.amplitude)
        np.testing.assert_allclose(size[inside], expected, atol=0.02)
        edge = 0.5 * strip.mode.width
        assert np.interp(edge, positions, size) == pytest.approx(strip.mode.at_edge, abs=0.05)
        rows = [(positions > edge + n * 7e-3) & (positions < edge + (n + 1) * 7e-3) for n in (1, 3)]
        near, far = (np.sqrt((size[row] ** 2).mean()) for row in rows)
        assert strip.decay - 0.5 < 10 * np.log10(near / far) < strip.decay + 4  # faster waves add to it
        np.testing.assert_allclose(field[number][::-1], -field[number], atol=1e-6)  # one nodal line across


@pytest.mark.parametrize("lattice", ["square", "hexagonal"])
def test_the_displacement_is_continuous_from_the_strip_into_the_rows(lattice):
    """Also beside rows whose face is not straight, and from row to row."""
    study = loads(QUICK_CELL.replace("[cell]", f'[cell]\nlattice = "{lattice}"'))
    rows = condensed_rows(study.cell, best_model(study.cell, study.bands_settings).model.resolution)
    mode = Guide.of(rows, 300.0).mode_at(2 * np.pi * 57e3, 0)
    across = 0.5 * mode.width - 4e-3 + np.linspace(0, 20e-3, 401)
    along = (np.arange(16) + 0.5) * rows.rows.period / 16
    field = guided_field(rows, mode, across, along)
    change = np.abs(np.diff(field, axis=0))
    assert change.max() < 0.03 * np.abs(field).max()
    assert np.abs(field[-1]).max() > 0  # the rows reach to the end of the grid


@pytest.mark.parametrize("width", ["", 'width = "45 mm"\nrows = 11\n'])
def test_decays_on_a_finer_mesh_are_within_both_errors(width):
    """The carrier is near the upper edge of the gap, where the decay changes fast with the frequency."""
    text = STUDY.replace("57 kHz", "59 kHz").replace("foot_rings = 0", "foot_rings = 1") + width
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("haptonic.analyses.waveguide.MOST_LENGTHS", 1)
        own, finer = (loads(of).waveguide().dataset for of in (text, text.replace("order = 3", "order = 4")))
    apart = np.abs(own["decay"] - finer["decay"])
    assert (apart > 0).all()
    assert (apart < own["decay_error"] + finer["decay_error"]).all()
    assert (finer["decay_error"] < own["decay_error"]).all()
    assert (own["decay_error"] < 0.02 * own["decay"]).all()


def test_the_page_shows_the_waveguide_that_one_selects(browser, guides, tmp_path):
    data, best = guides.dataset, guides.strips.index(guides.best)
    guides.files["waveguide.html"](tmp_path / "waveguide.html")
    with page_at(browser, (tmp_path / "waveguide.html").as_uri(), **STILL) as page:
        page.wait_for_selector(f"{FIELD}[data-shown='{best}']")
        page.keyboard.press("Tab")
        for _ in guides.strips:
            page.keyboard.press("ArrowRight")
        last = len(guides.strips) - 1
        page.wait_for_selector(f"{FIELD}[data-shown='{last}']")
        before, sizes = pixels(page, FIELD), pixels(page, ".curves canvas")
        page.keyboard.press("ArrowLeft")
        page.wait_for_selector(f"{FIELD}[data-shown='{last - 1}']")
        assert (pixels(page, FIELD) != before).any()
        assert (pixels(page, ".curves canvas") != sizes).any()  # the mark of the selected waveguide
        strip, share = guides.strips[last - 1], float(data.attrs["relative_frequency_error"])
        assert "normal displacement; 1 is the largest" in page.locator(".map .scale").inner_text()
        shown = page.locator(".facts").inner_text()
        assert f"{uncertain(strip.frequency / 1e3, share * strip.frequency / 1e3)} kHz" in shown
        assert f"{strip.mode.width * 1e3:.2f} mm" in shown
        assert f"{uncertain(strip.decay, strip.decay_error)} dB per row" in shown
        page.keyboard.press("b")
        page.wait_for_selector(f"{FIELD}[data-shown='{best}']")
        page.keyboard.press("t")
        table = page.get_by_role("table", name="Waveguides for mode 1x9")
        table.get_by_role("button").last.click()
        page.wait_for_selector(f"{FIELD}[data-shown='{last}']")
        assert table.locator("tbody tr").count() == len(guides.strips)
        chart = page.locator(".u-over").first
        chart.scroll_into_view_if_needed()
        box = chart.bounding_box()
        chart.click(position={"x": 4, "y": box["height"] / 2})
        page.wait_for_selector(f"{FIELD}[data-shown='0']")
        page.locator("h1").click()
        page.keyboard.press(" ")
        page.locator(FIELD).scroll_into_view_if_needed()
        assert advances(page, f"() => document.querySelector('{FIELD}').counted.frames")
        page.keyboard.press(" ")
        assert faults_of_layout(page) == []
