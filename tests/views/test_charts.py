"""Axes and curves of the plots on pages, in a real browser."""

import re

import numpy as np
import pytest
from playwright.sync_api import Page

from browser import STILL, page_at, pixels, written
from haptonic.later import xarray as xr
from haptonic.views import InteractiveView, write_page

MINUS, TIMES = "\N{MINUS SIGN}", "\N{MULTIPLICATION SIGN}"
NUMBER = re.compile(rf"{MINUS}?[\d.]+({TIMES}10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")
TITLE = 24  # CSS pixels of an axis for its title


def page_of_curves(folder, unit: str = "1", **curves: np.ndarray) -> str:
    """Address of a page with curves against time."""
    count = len(next(iter(curves.values())))
    data = xr.Dataset(
        {name: ("time", values, {"units": unit, "long_name": name}) for name, values in curves.items()},
        coords={"time": ("time", np.linspace(0, 1, count), {"units": "s", "long_name": "time"})},
    )
    path = folder / "curves.html"
    write_page(
        InteractiveView(
            kind="reading", title="Curves", dataset=data, extra={"axis": "time", "drawing": None}
        ),
        path,
    )
    return path.as_uri()


def labels(page: Page) -> list[dict]:
    """Numbers along the axes."""
    page.wait_for_selector(".uplot canvas")
    return [text for text in written(page) if text["left"] is not None and NUMBER.fullmatch(text["text"])]


@pytest.mark.parametrize("largest", [1.0, 123456.0])
def test_an_axis_is_as_wide_as_its_widest_number(browser, tmp_path, largest):
    values = largest - np.linspace(0, 1e-5 * largest, 50)
    with page_at(browser, page_of_curves(tmp_path, value=values), **STILL) as page:
        numbers = labels(page)
        assert max(len(text["text"]) for text in numbers) > 6
        assert min(text["left"] for text in numbers) > TITLE


def test_numbers_have_minus_signs_and_powers_of_ten(browser, tmp_path):
    values = np.linspace(-3e-8, 3e-8, 50)
    with page_at(browser, page_of_curves(tmp_path, value=values), **STILL) as page:
        page.wait_for_selector(".uplot canvas")
        texts = [text["text"] for text in written(page)]
        assert f"{MINUS}2{TIMES}10⁻⁸" in texts
        assert not [text for text in texts if re.search(r"-\d|\de", str(text))]


@pytest.mark.parametrize("unit", ["m/s", "m/s/V"])
def test_small_velocities_have_a_unit_with_a_prefix(browser, tmp_path, unit):
    values = np.linspace(0, 3e-4, 50)
    with page_at(browser, page_of_curves(tmp_path, unit=unit, speed=values), **STILL) as page:
        page.wait_for_selector(".uplot canvas")
        texts = [text["text"] for text in written(page)]
        assert f"speed / (µ{unit})" in texts
        assert "200" in texts


def test_a_curve_lies_between_pixels(browser, tmp_path):
    """On whole pixels, a curve that climbs by few pixels would be a flight of stairs."""
    slope = np.linspace(400, 430, 400)
    values = np.concatenate([slope, [0.0, 1000.0]])
    with page_at(browser, page_of_curves(tmp_path, value=values), **STILL) as page:
        page.wait_for_selector(".uplot canvas")
        page.wait_for_timeout(200)
        drawn, over = pixels(page, ".uplot canvas"), page.locator(".u-over").bounding_box()
        left = int(over["x"] - page.locator(".uplot canvas").bounding_box()["x"])
    ink = drawn[: int(over["height"]), left + 10 : left + int(0.9 * over["width"]), 3].astype(float)
    rows = (np.arange(len(ink)) @ ink) / ink.sum(axis=0)  # height of the curve in each column
    assert np.ptp(rows) > 3
    assert np.abs(np.diff(rows)).max() < 0.4
