"""The page of a plate that can be sent: its numbers against the result, and the page in a real browser."""

import numpy as np
import pytest
from playwright.sync_api import Page

from browser import STILL, advances, faults_of_layout, page_at, pixels
from haptonic.results.plate import PlateResult
from haptonic.results.plate.interactive import plate_view
from haptonic.results.steps import STEPS
from haptonic.study import loads
from quick import QUICK_CELL, QUICK_PLATE

MAP = ".map canvas"
PLATE = QUICK_PLATE.replace('"B"', '"B <i>"')


@pytest.fixture(scope="module")
def result() -> PlateResult:
    return loads(QUICK_CELL.replace("60 kHz", "10 kHz") + PLATE).plate(html=True)


@pytest.fixture(scope="module")
def address(result, tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("plate") / "plate.html"
    result.files["plate.html"](path)
    return path.as_uri()


def shown(page: Page) -> int:
    """Number of the frequency on the map."""
    return int(page.locator(MAP).get_attribute("data-shown"))


def test_the_view_has_the_displacement_of_every_point(result):
    data = plate_view(result).dataset
    step = data["shape_step"].values[:, None, None]
    field = step * (data["shape_real"].values + 1j * data["shape_imag"].values)
    velocity = 10.0 * result.response.grid().sel(direction="z").values  # 10 V
    omega = 2 * np.pi * result.response.frequency[:, None, None]
    assert (np.abs(1j * omega * field - velocity) <= 0.75 * omega * step).all()
    np.testing.assert_allclose(STEPS * step[:, 0, 0], np.abs(velocity / omega).max(axis=(1, 2)), rtol=1e-6)


def test_levels_and_contrasts_are_those_of_the_result(result):
    data = plate_view(result).dataset
    assert data["region"].values.tolist() == ["A", "B <i>"]
    np.testing.assert_allclose(data["level"].sel(region="A"), 10.0 * result.levels["A"], rtol=1e-6)
    for pair, level in result.contrasts(result.response).items():
        np.testing.assert_array_equal(data["contrast"].sel(pair=pair), level)


def test_places_without_a_plate_are_absent():
    rows = 'map = """\no11o22o\no11o22.\n"""'
    text = QUICK_CELL.replace("60 kHz", "10 kHz") + PLATE.replace('map = "o11o22o"\nrows = 2', rows)
    data = plate_view(loads(text).plate()).dataset
    there = data["present"].values == 1
    upper, lower = there[there.shape[0] // 2 + 1 :], there[: there.shape[0] // 2 - 1]
    assert upper.all()
    assert lower[:, :-4].all()
    assert not lower[:, -1].any()
    assert not data["shape_real"].values[:, ~there].any()


def test_the_map_shows_the_moment_of_the_largest_displacement(browser, address, result):
    """Colours of the canvas against those of the numbers, where the vibration is most out of phase."""
    view = plate_view(result)
    fields = view.dataset["shape_real"].values + 1j * view.dataset["shape_imag"].values
    largest = np.take_along_axis(fields.reshape(len(fields), -1), argmax_of(fields)[:, None], axis=1)[:, 0]
    line = int(np.abs((largest**2).imag / np.abs(largest) ** 2).argmax())
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        for _ in range(abs(line - shown(page))):
            page.locator(".walk").press("ArrowRight" if line > shown(page) else "ArrowLeft")
        assert shown(page) == line
        colours = pixels(page, MAP)[..., :3]
    value = (fields[line] * np.conj(largest[line]) / abs(largest[line])).real[::-1]
    expected = np.array(view.extra["colours"])[np.rint(value).astype(int) + STEPS]
    rows, columns = (
        ((np.arange(count) + 0.5) / count * size).astype(int)
        for count, size in zip(value.shape, colours.shape[:2], strict=True)
    )
    drawn = colours[np.ix_(rows, columns)]

    strong = np.abs(value) > 0.2 * STEPS

    def away(others: np.ndarray) -> float:
        """Median difference of colours, because lines and names cover some points."""
        return float(np.median(np.abs(drawn - others).max(axis=-1)[strong]))

    assert away(expected) < 10
    assert away(expected) < 0.5 * away(expected[::-1])


def argmax_of(fields: np.ndarray) -> np.ndarray:
    """(lines,) number of the point with the largest displacement."""
    return np.abs(fields.reshape(len(fields), -1)).argmax(axis=1)


def test_the_keyboard_changes_the_frequency(browser, address, result):
    frequency = result.response.frequency
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        first = shown(page)
        assert first == int(np.abs(frequency - result.resonance).argmin())
        page.keyboard.press("Tab")
        page.keyboard.press("Shift+ArrowRight")
        page.keyboard.press("Shift+ArrowRight")
        assert shown(page) == len(frequency) - 1
        page.keyboard.press("ArrowLeft")
        assert shown(page) == len(frequency) - 2
        page.keyboard.press("c")
        assert shown(page) == int(np.abs(frequency - 10e3).argmin())
        page.keyboard.press("g")
        assert shown(page) == first
        without = pixels(page, MAP)
        page.keyboard.press("l")
        assert (pixels(page, MAP) != without).any(axis=-1).mean() > 0.005  # pillars and clamped corners
        page.keyboard.press("l")
        assert (pixels(page, MAP) == without).all()
        page.keyboard.press("?")
        assert page.get_by_role("table", name="Keys").is_visible()
        modes = [int(np.abs(frequency - f).argmin()) for f in result.modes["frequency"].values]
        page.keyboard.press("Shift+ArrowLeft")
        page.keyboard.press("Shift+ArrowLeft")
        page.keyboard.press("n")
        assert shown(page) == min(line for line in modes if line > 0)


def test_a_click_in_the_spectra_selects_the_frequency(browser, address, result):
    frequency = result.response.frequency
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        over = page.locator(".u-over")
        box = over.bounding_box()
        for line in (3, 12):
            share = (frequency[line] - frequency[0]) / (frequency[-1] - frequency[0])
            over.click(position={"x": share * box["width"], "y": 100})
            assert shown(page) == line
            assert f"{frequency[line] / 1e3:g} kHz" in page.locator("#point").inner_text()
        page.get_by_label("Frequencies in").select_option("Hz")
        over.click(position={"x": box["width"] - 3, "y": 100})
        assert shown(page) == len(frequency) - 1
        assert f"{frequency[-1]:g} Hz" in page.locator("#point").inner_text()


def test_a_drag_in_the_spectra_enlarges_them_and_selects_nothing(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        first, before = shown(page), pixels(page, ".uplot canvas")
        box = page.locator(".u-over").bounding_box()
        page.mouse.move(box["x"] + 20, box["y"] + 50)
        page.mouse.down()
        page.mouse.move(box["x"] + 150, box["y"] + 50, steps=5)
        page.mouse.up()
        page.wait_for_timeout(100)
        assert shown(page) == first
        assert (pixels(page, ".uplot canvas") != before).any()


def test_facts_of_a_frequency_are_those_of_the_result(browser, address, result):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        words, line = page.locator("#point").inner_text(), shown(page)
        for pair, level in result.contrasts(result.response).items():
            assert f"{pair} {float(level[line]):.1f} dB" in words
        page.get_by_role("button", name="Tables").click()
        cells = page.locator("table", has_text="Regions at").inner_text()
        assert "B <i>" in cells
        numbers = [float(text.split()[0]) for text in page.locator("td", has_text="m/s").all_inner_texts()]
        expected = [10 * float(level[line]) for level in result.levels.values()]
        np.testing.assert_allclose(numbers, expected, rtol=6e-3)  # three digits
        modes = page.locator("table", has_text="Modes near").locator("tbody tr")
        assert modes.count() == result.modes.sizes["mode"]


def test_the_plate_moves_until_it_is_stopped(browser, address):
    frames = f"() => document.querySelector('{MAP}').counted.frames"
    with page_at(browser, address) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        assert advances(page, frames)
        page.get_by_role("button", name="Stop").click()
        page.wait_for_timeout(100)
        still = page.evaluate(frames)
        page.wait_for_timeout(400)
        assert page.evaluate(frames) == still


def test_the_page_fits_its_window_and_breaks_no_rule_of_accessibility(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.get_by_role("button", name="Tables").click()
        assert faults_of_layout(page) == []


def test_a_single_frequency_has_a_page_without_spectra(browser, tmp_path):
    result = loads(QUICK_CELL.replace("60 kHz", "10 kHz") + PLATE).plate(html=True, at=10e3)
    result.files["plate.html"](tmp_path / "plate.html")
    with page_at(browser, (tmp_path / "plate.html").as_uri(), **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        assert page.locator(".u-over").count() == 0
        assert page.locator("input[type=range]").first.is_disabled()
        assert "10 kHz" in page.locator("#point").inner_text()
