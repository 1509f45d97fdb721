"""The page of a ribbon: fields of all modes against those of other routes, and the page in a real browser."""

import numpy as np
import pytest
from matplotlib.tri import Triangulation
from playwright.sync_api import Page

from browser import STILL, advances, faults_of_layout, page_at, pixels
from haptonic.bloch.face_grid import FaceGrid
from haptonic.results.ribbon import RibbonWaves
from haptonic.results.steps import STEPS
from haptonic.study import loads
from haptonic.units import uncertain
from quick import QUICK_CELL, QUICK_RIBBON

FIELD = ".map canvas"
# select a unit; true if the page has another plot in the same task
SELECT_UNIT = """async (select) => {
  const earlier = document.querySelector(".u-over");
  select.value = "rad/m";
  select.dispatchEvent(new Event("change", {bubbles: true}));
  for (let round = 0; round < 9; round++) await null;
  return document.querySelector(".u-over") !== earlier;
}"""


@pytest.fixture(scope="module")
def ribbon() -> RibbonWaves:
    return loads(QUICK_CELL + QUICK_RIBBON).ribbon(html=True)


def mode_of_field(ribbon: RibbonWaves) -> int:
    """Number of the mode whose field is stored on the nodes."""
    data = ribbon.dataset
    same = data["phase"].values == float(data["field_phase"])
    away = np.abs(data["frequency"].values - float(data["field_frequency"]))
    return int(np.where(same, away, np.inf).argmin())


def test_a_field_on_the_grid_is_that_on_the_nodes(ribbon):
    data, mode = ribbon.dataset, mode_of_field(ribbon)
    position = data["field_position"].values
    grid = FaceGrid.of_strip(position, data["field_triangle"].values, float(data.attrs["period"]))
    across, _ = np.meshgrid(data["across"], data["along"], indexing="ij")
    np.testing.assert_allclose(
        grid.values(position[:, :1] + 0j, [0.0])[0], across, atol=1e-9
    )  # linear exactly
    field = data["field_real"].values + 1j * data["field_imag"].values
    expected = grid.values(field[:, None], [1j * float(data["field_phase"])])[0]
    stored = data["mode_real"][mode].values + 1j * data["mode_imag"][mode].values
    np.testing.assert_allclose(stored, expected, atol=1e-6)
    assert int(data["mode_component"][mode]) == int(data["field_component"])
    assert data["present"].values.all()
    shown = ribbon.view().dataset["mode_imag"][mode].values / STEPS
    np.testing.assert_allclose(shown, expected.imag, atol=0.51 / STEPS)


def test_a_grid_continues_waves_beyond_the_border_of_a_leaning_tile():
    x, y = (side.ravel() for side in np.meshgrid(np.linspace(0, 2, 41), np.linspace(0, 1, 81)))
    leaning = np.column_stack(
        [x, y + 0.4 * x]
    )  # beyond one period, so points below it come from the next one
    triangles = Triangulation(x, y).triangles
    grid, wavenumber = FaceGrid.of_strip(leaning, triangles, 1.0), 2.0
    wave = np.exp(1j * wavenumber * leaning[:, [1]])
    values = grid.values(wave, [1j * wavenumber])[0]
    there = grid.weights.any(axis=1).reshape(values.shape)
    assert there.all()
    expected = np.broadcast_to(np.exp(1j * wavenumber * grid.along), values.shape)
    np.testing.assert_allclose(values, expected, atol=2e-3)


def shown(page: Page) -> int:
    return int(page.locator(FIELD).get_attribute("data-shown"))


def test_the_page_shows_what_the_keyboard_and_the_mouse_select(browser, ribbon, tmp_path):
    data = ribbon.dataset
    frequency, error, phase = (data[name].values for name in ("frequency", "frequency_error", "phase"))
    ribbon.files["ribbon.html"](tmp_path / "ribbon.html")
    with page_at(browser, (tmp_path / "ribbon.html").as_uri(), **STILL) as page:
        page.wait_for_selector(f"{FIELD}[data-shown]")
        assert shown(page) == np.abs(frequency - 50e3).argmin()  # nearest to the middle, as 60 kHz is the end
        page.keyboard.press("Tab")
        rows = np.unique(phase)
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowRight")
        assert phase[shown(page)] == rows[-1]
        at_end = np.flatnonzero(phase == rows[-1])
        order = at_end[np.argsort(frequency[at_end])]
        for _ in at_end:
            page.keyboard.press("ArrowDown")
        assert shown(page) == order[0]
        page.keyboard.press("ArrowUp")
        assert shown(page) == order[1]
        words = page.locator("#point").inner_text()
        bound = uncertain(frequency[order[1]] / 1e3, error[order[1]] / 1e3)
        assert words.endswith(f"at 1 π/a: {bound} kHz")
        assert page.get_by_label("Wavevectors in").evaluate(SELECT_UNIT)  # the plot changes with the words
        assert f"at {np.pi / 7e-3:.1f} rad/m" in page.locator("#point").inner_text()
        over = page.locator(".u-over")
        box = over.bounding_box()
        mode = int(np.flatnonzero(phase == rows[1])[0])
        x, y = phase[mode] / np.pi * box["width"], (60e3 - frequency[mode]) / 20e3 * box["height"]
        over.click(position={"x": x, "y": y})
        assert shown(page) == mode
        field = data["mode_real"].values[mode]
        colours = np.array(ribbon.view().extra["colours"])
        drawn = pixels(page, FIELD)[..., :3]
        periods = page.evaluate(f"() => document.querySelector('{FIELD}').counted.painter.columns") // 16
        height, width = drawn.shape[:2]
        for period in range(periods):  # the phase of the wave from one period to the next
            turned = ((field + 1j * data["mode_imag"].values[mode]) * np.exp(1j * period * phase[mode])).real[
                ::-1
            ]
            line = ((np.arange(len(turned)) + 0.5) / len(turned) * height).astype(int)
            column = ((period + (np.arange(16) + 0.5) / 16) / periods * width).astype(int)
            expected = colours[np.rint(STEPS * turned).astype(int) + STEPS]
            away = np.abs(drawn[np.ix_(line, column)] - expected).max(axis=-1)
            assert np.median(away[np.abs(turned) > 0.2]) < 12
        assert "; 1 is the largest" in page.locator(".map .scale").inner_text()
        page.keyboard.press("t")
        table = page.get_by_role("table", name="Modes at").locator("tbody tr")
        table.first.wait_for()
        assert table.count() == int((phase == rows[1]).sum())
        page.keyboard.press(" ")
        assert advances(page, f"() => document.querySelector('{FIELD}').counted.frames")
        page.keyboard.press(" ")
        assert faults_of_layout(page) == []
