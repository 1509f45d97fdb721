"""The page of bands that can be sent, in a real browser: what is drawn, pressed and read."""

import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page

from browser import STILL, advances, faults_of_layout, page_at, pixels
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.later import xarray as xr
from haptonic.results.bands import Bands
from haptonic.study import loads
from haptonic.units import uncertain
from haptonic.views import InteractiveView, sent_page
from quick import QUICK_CELL

POINT = "#point"


@pytest.fixture(scope="module")
def bands() -> Bands:
    return loads(QUICK_CELL).bands(html=True)


@pytest.fixture(scope="module")
def address(bands: Bands, tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("sent") / "bands.html"
    bands.files["bands.html"](path)
    return path.as_uri()


def shown(page: Page) -> tuple[int, int]:
    """Wavevector and band of the mode on the canvas, from 0."""
    row, band = page.locator(".mode canvas").get_attribute("data-shown").split(",")
    return int(row), int(band)


def test_a_page_draws_its_mode_and_its_diagram(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        body = pixels(page, ".mode canvas").reshape(-1, 4)
        covered = (body[:, 3] > 0).mean()
        assert 0.05 < covered < 0.8
        assert len(np.unique(body[body[:, 3] > 0, :3] // 16, axis=0)) > 20  # shades of displacement and light
        curves = pixels(page, ".uplot canvas").reshape(-1, 4)
        assert 0.005 < (curves[:, 3] > 0).mean() < 0.6


def test_a_page_loads_nothing_from_elsewhere(browser, address):
    with page_at(browser, "about:blank") as page:
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto(address)
        page.wait_for_selector("canvas[data-shown]")
        assert asked == [address]


def test_a_click_on_a_band_shows_its_mode(browser, address, bands):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        before = pixels(page, ".mode canvas")
        over = page.locator(".u-over")
        box = over.bounding_box()
        frequency, distance = bands.frequency, bands.distance
        row, band = 4, 2
        top = page.evaluate("() => document.querySelector('canvas[data-shown]').moving.data.header.extra.top")
        x = box["width"] * distance[row] / distance[-1]
        y = box["height"] * (1 - frequency[row, band] / top)
        over.click(position={"x": x, "y": y})
        assert shown(page) == (row, band)
        assert (pixels(page, ".mode canvas") != before).any()
        words = page.locator(POINT).inner_text()
        assert uncertain(frequency[row, band] / 1e3, bands.error[row, band] / 1e3) in words


def test_a_drag_in_the_diagram_enlarges_it_and_selects_nothing(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        first, before = shown(page), pixels(page, ".uplot canvas")
        box = page.locator(".u-over").bounding_box()
        page.mouse.move(box["x"] + 20, box["y"] + 50)
        page.mouse.down()
        page.mouse.move(box["x"] + 150, box["y"] + 180, steps=5)
        page.mouse.up()
        page.wait_for_timeout(100)
        assert shown(page) == first
        assert (pixels(page, ".uplot canvas") != before).any()


def test_the_canvas_gets_the_displacement_of_the_mode(browser, address, bands):
    """What is drawn, against the sum of shapes and amplitudes of the result."""
    data = bands.dataset
    surface = "document.querySelector('.mode canvas').moving.surface"
    field = f"part => Array.from({surface}.getAttribute(part).array)"
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        for key in ("ArrowUp", "ArrowRight", "ArrowRight"):
            page.locator(".walk").press(key)
            row, band = shown(page)
            for part in ("real", "imag"):
                drawn = np.reshape(page.evaluate(field, part), (-1, 3))
                amounts, shapes = data[f"path_mode_{part}"][row, band].values, data["path_shape"].values
                np.testing.assert_allclose(drawn, np.einsum("s,snx->nx", amounts, shapes), atol=2e-3)


def test_the_mode_moves_until_it_is_stopped(browser, address):
    frames = "() => document.querySelector('.mode canvas').moving.frames"
    with page_at(browser, address) as page:
        page.wait_for_selector("canvas[data-shown]")
        assert advances(page, frames)
        page.get_by_role("button", name="Stop").click()
        page.wait_for_timeout(100)  # a frame that was under way
        still = page.evaluate(frames)
        page.wait_for_timeout(400)
        assert page.evaluate(frames) == still


def test_reduced_motion_shows_a_still_mode(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        assert page.get_by_role("button", name="Move").is_visible()


def test_the_keyboard_alone_reaches_everything(browser, address, bands):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        page.keyboard.press("Tab")
        assert page.evaluate("document.activeElement.className") == "walk"
        row, band = shown(page)
        page.keyboard.press("ArrowRight")
        page.keyboard.press("ArrowUp")
        assert shown(page) == (row + 1, band + 1)
        page.keyboard.press("ArrowLeft")
        page.keyboard.press("ArrowDown")
        assert shown(page) == (row, band)
        for _ in range(bands.frequency.shape[1] + 2):
            page.keyboard.press("ArrowDown")
        for _ in range(3):
            page.keyboard.press("Shift+ArrowLeft")
        assert shown(page) == (0, 0)
        page.keyboard.press("g")
        gaps = [gap for gap in bands.gaps if gap.waves == "all"]
        assert shown(page)[1] == min(gap.between[0] for gap in gaps) - 1
        page.keyboard.press(" ")
        assert page.get_by_role("button", name="Stop").is_visible()
        page.keyboard.press("?")
        assert page.get_by_role("table", name="Keys").is_visible()
        page.keyboard.press("t")
        assert page.get_by_role("table", name="Gaps").is_visible()
        places = set()
        for _ in range(40):
            page.keyboard.press("Tab")
            places.add(page.evaluate("document.activeElement.outerHTML.slice(0, 60)"))
        controls = page.locator("button, input, select").count()
        assert len(places) >= controls - 8  # buttons of the table's rows differ beyond these letters


def test_neighbours_move_in_their_phases(browser, address, bands):
    """At X along a1 neighbours are opposite, and along a2 equal."""
    corner = dict(bands.corners)["X"]
    row = int(np.abs(bands.distance - corner).argmin())
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        page.keyboard.press("Tab")
        page.keyboard.press("Shift+ArrowLeft")
        page.keyboard.press("Shift+ArrowLeft")
        for _ in range(row):
            page.keyboard.press("ArrowRight")
        turns = page.evaluate("() => document.querySelector('.mode canvas').moving.turns")
    kappa = bands.dataset["kappa"].values[row]
    angles = [m * kappa[0] + n * kappa[1] for m in range(2) for n in range(2)]
    expected = [value for angle in angles for value in (np.cos(angle), np.sin(angle))]
    np.testing.assert_allclose(turns, expected, atol=1e-6)
    assert sorted(np.round(turns[::2])) == [-1, -1, 1, 1]


def test_tables_print_numbers_as_the_command_does(browser, address, bands):
    with page_at(browser, address, **STILL) as page:
        page.get_by_role("button", name="Tables").click()
        for _ in range(3):
            row, _ = shown(page)
            cells = (
                page.locator("table", has_text="Modes at")
                .locator("tbody tr td:nth-child(2)")
                .all_inner_texts()
            )
            pairs = zip(bands.frequency[row] / 1e3, bands.error[row] / 1e3, strict=True)
            assert cells == [uncertain(*pair) for pair in pairs]
            page.locator(".walk").press("ArrowRight")
        gaps = page.locator("table", has_text="Gaps").locator("tbody tr")
        assert gaps.count() == len(bands.gaps)


def test_the_shown_command_repeats_the_mode(browser, address, bands):
    zone = loads(QUICK_CELL).cell.zone
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        for _ in range(4):
            page.locator(".walk").press("ArrowRight")
            words = page.locator(".again code").first.inner_text()
            kappa, _ = wavevector_at(zone, re.search('--modes-at "(.+)"', words)[1])
            expected = bands.dataset["kappa"].values[shown(page)[0]]
            np.testing.assert_allclose(kappa, expected, atol=5e-3)


def test_frequencies_have_four_units(browser, address, bands):
    """In Hz as computed; relative to the speed of shear waves and the pitch, as papers print them."""
    speed = loads(QUICK_CELL).cell.material.shear_speed
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        row, band = shown(page)
        for unit, factor in (("Hz", 1.0), ("MHz", 1e6), ("ωa/(2πcₜ)", speed / 7e-3)):
            page.get_by_label("Frequencies in").select_option(unit)
            text = uncertain(bands.frequency[row, band] / factor, bands.error[row, band] / factor)
            words = page.locator(POINT).inner_text()
            assert words.endswith(f"{unit} = {text}" if "ω" in unit else f"{text} {unit}")


def test_a_page_fits_its_window_and_breaks_no_rule_of_accessibility(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.get_by_role("button", name="Tables").click()
        assert faults_of_layout(page) == []


def test_a_change_to_dark_draws_again(browser, address):
    with page_at(browser, address, color_scheme="light", **STILL) as page:
        page.wait_for_selector("canvas[data-shown]")
        before = pixels(page, ".uplot canvas")
        page.emulate_media(color_scheme="dark")
        page.wait_for_timeout(200)
        after = pixels(page, ".uplot canvas")
        ink = (before[..., 3] > 250) & (before[..., :3].max(axis=-1) < 60)
        assert ink.sum() > 1000
        assert after[ink, :3].mean() > 180


HOSTILE = "</script><script>window.broken = 1</script><img src=x onerror='window.broken = 1'>"


def test_hostile_words_are_only_words(browser, bands, tmp_path: Path):
    view = bands.view()
    data: xr.Dataset = view.dataset.copy()
    data["gap_direction"] = data["gap_direction"].astype(object).astype("U200")
    data["gap_direction"][:] = HOSTILE
    hostile = InteractiveView(
        kind="bands",
        title=HOSTILE,
        dataset=data,
        extra={**view.extra, "summary": [HOSTILE]},
        short=view.short,
    )
    place = tmp_path / "hostile.html"
    place.write_text(sent_page(hostile), "utf-8")
    with page_at(browser, place.as_uri(), **STILL) as page:
        page.get_by_role("button", name="Tables").click()
        assert page.locator("h1").inner_text() == HOSTILE
        assert page.evaluate("window.broken") is None


def test_a_damaged_page_is_reported(browser, address, tmp_path: Path, bands):
    text = sent_page(bands.view())
    start = text.index('id="data">') + 2000
    place = tmp_path / "damaged.html"
    place.write_text(text[:start] + "AAAA" + text[start + 4 :], "utf-8")
    with page_at(browser, place.as_uri()) as page:
        page.wait_for_selector("p")
        assert "cannot be shown" in page.locator("#view").inner_text()
