"""The page of a scan that can be sent: its numbers against the responses, and the page in a real browser."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

from browser import STILL, faults_of_layout, page_at, pixels
from haptonic.analyses import named
from haptonic.analyses.runner import Runner
from haptonic.response import FrequencyResponse
from haptonic.response.rasters import point_map
from haptonic.results.scan import ScanResult
from haptonic.results.scan.interactive import scan_view
from haptonic.results.steps import STEPS
from haptonic.results.verdict import BEFORE, MEASURED

SCAN = Path(__file__).parents[1] / "data/cases/scan-plain-hdf5/scan.h5"
MAP = ".map canvas"
FACTOR = 0.5j  # the model moves half as far, a quarter of a cycle apart


@pytest.fixture(scope="module")
def alone() -> ScanResult:
    result = named("scan").run(None, Runner(), {"path": SCAN, "html": True})
    assert isinstance(result, ScanResult)
    return result


@pytest.fixture(scope="module")
def compared(alone) -> ScanResult:
    """The scan beside a model that differs by a known factor."""
    data = alone.response.dataset
    model = FrequencyResponse(data.assign(response=data["response"] * FACTOR))
    verdict = SimpleNamespace(
        responses={MEASURED: alone.response, BEFORE: model}, last=BEFORE, summary=list, tables=list
    )
    return replace(alone, verdict=verdict)


@pytest.fixture(scope="module")
def address(compared, tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("scan") / "scan.html"
    compared.files["scan.html"](path)
    return path.as_uri()


def field(data, name: str) -> np.ndarray:
    return data[f"{name}_step"].values[:, None] * (
        data[f"{name}_real"].values + 1j * data[f"{name}_imag"].values
    )


def test_the_view_has_the_displacement_of_every_point(compared):
    data = compared.view().dataset
    velocity = compared.response.values[..., 0]
    omega = 2 * np.pi * compared.response.frequency[:, None]
    step = data["shape_step"].values[:, None]
    assert (np.abs(1j * omega * field(data, "shape") - velocity) <= 0.75 * omega * step).all()
    assert (np.abs(1j * omega * field(data, "model") - FACTOR * velocity) <= 0.4 * omega * step).all()
    np.testing.assert_allclose(data["agreement"], 1.0, atol=1e-9)  # a factor does not change the shape
    assert sorted(data["place"].values.ravel().tolist()) == list(range(9))
    rows = {name: data["level"].sel(region=name).values for name in data["region"].values.tolist()}
    np.testing.assert_allclose(rows["all points (model)"], 0.5 * rows["all points"], rtol=1e-6)


def test_the_agreement_is_zero_where_the_model_does_not_move(alone, compared):
    data = compared.verdict.responses[BEFORE].dataset
    moving = data["frequency"] != data["frequency"][-1]
    model = FrequencyResponse(data.assign(response=data["response"].where(moving, 0.0)))
    verdict = SimpleNamespace(
        **vars(compared.verdict) | {"responses": {MEASURED: alone.response, BEFORE: model}}
    )
    agreement = replace(alone, verdict=verdict).view().dataset["agreement"].values
    assert agreement[-1] == 0.0
    np.testing.assert_allclose(agreement[:-1], 1.0, atol=1e-9)


def test_without_a_model_there_is_one_map(alone):
    view = alone.view()
    assert view.extra["maps"] == {"shape": "scan, measured"}
    assert "model_real" not in view.dataset
    assert replace(alone, interactive=False).view() is None
    assert [name for name in alone.files if name == "scan.html"]


def test_a_view_reports_omitted_frequencies_of_a_large_scan(alone):
    view = scan_view(alone, most_numbers=2 * 9 * 10)
    lines = view.dataset["frequency"].values
    assert len(lines) in (10, 11)
    assert np.abs(lines - alone.loudest).min() == 0
    assert view.extra["summary"][-1] == f"This view has {len(lines)} of 30 frequencies."


def test_each_place_of_a_map_shows_the_nearest_point():
    grid = np.stack(np.meshgrid([0.0, 1e-3, 2e-3], [0.0, 1e-3]), axis=-1).reshape(-1, 2)
    number, x, y = point_map(grid[:-1])
    assert number.tolist() == [[0, 1, 2], [3, 4, -1]]
    np.testing.assert_allclose((x[-1], y[-1]), (2e-3, 1e-3))
    cosine, sine = np.cos(0.5), np.sin(0.5)
    turned = grid @ np.array([[cosine, sine], [-sine, cosine]])
    number, x, y = point_map(turned)
    places = np.stack(np.meshgrid(x, y), axis=-1)
    distance = np.linalg.norm(places[:, :, None] - turned, axis=-1)
    seen = number >= 0
    assert set(number[seen].tolist()) == set(range(6))
    assert (distance.argmin(axis=-1)[seen] == number[seen]).all()
    np.testing.assert_array_equal(seen, distance.min(axis=-1) <= 0.75e-3)


def test_points_nearer_than_the_places_of_a_map_are_shown():
    columns, rows = np.meshgrid(np.linspace(0, 60e-3, 20), np.linspace(0, 20e-6, 14) ** 1.1)
    number, _, _ = point_map(np.stack([columns.ravel(), rows.ravel()], axis=1))
    assert (number >= 0).any()


def middle_colours(page: Page, number: int) -> np.ndarray:
    """(row, column, 3) colours at the middles of the squares of a map, from below."""
    page.evaluate(f"document.querySelectorAll('{MAP}')[{number}].id = 'map-{number}'")
    colours = pixels(page, f"#map-{number}")[::-1, :, :3]
    rows, columns = ((np.arange(3) + 0.35) / 3 * size for size in colours.shape[:2])
    return colours[np.ix_(rows.astype(int), columns.astype(int))]


def test_both_maps_show_the_same_moment_and_one_scale_if_asked(browser: Browser, address, compared):
    view = compared.view()
    line = int(np.abs(view.dataset["frequency"].values - view.extra["first"]).argmin())
    shape = field(view.dataset, "shape")[line]
    turned = shape * np.conj(shape[np.abs(shape).argmax()]) / np.abs(shape).max()
    place = view.dataset["place"].values
    colours = np.array(view.extra["colours"])

    def expected(values: np.ndarray, most: float) -> np.ndarray:
        return colours[np.rint(STEPS * values.real / most).astype(int) + STEPS][place]

    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown='{line}']")
        most = np.abs(shape).max()
        assert np.abs(middle_colours(page, 0) - expected(turned, most)).max() <= 6
        assert np.abs(middle_colours(page, 1) - expected(FACTOR * turned, 0.5 * most)).max() <= 6
        page.locator(".walk").press("s")
        expect(page.get_by_label("one scale of colours for both maps")).to_be_checked()
        limits = page.locator(".map .scale span:first-child")
        expect(limits.nth(1)).to_have_text(limits.nth(0).inner_text())
        assert np.abs(middle_colours(page, 1) - expected(FACTOR * turned, most)).max() <= 6


def test_keys_scrub_both_maps_and_the_table_has_their_numbers(browser: Browser, address, compared):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        for key in ("Shift+ArrowLeft", "Shift+ArrowLeft", "ArrowRight"):
            page.locator(".walk").press(key)
        first = int(np.abs(compared.response.frequency - compared.loudest).argmin())
        for number in range(2):
            expect(page.locator(MAP).nth(number)).to_have_attribute("data-shown", str(max(first - 20, 0) + 1))
        page.locator(".walk").press("g")
        for number in range(2):
            expect(page.locator(MAP).nth(number)).to_have_attribute("data-shown", str(first))
        page.locator(".walk").press("t")
        table = page.locator("table", has_text="Regions at")
        expect(table).to_contain_text("agreement of the shapes (MAC)")
        expect(table).to_contain_text("1.000")
        expect(table).to_contain_text("all points (model)")


def test_the_page_is_accessible_and_fits(browser: Browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        page.locator(".walk").press("t")
        assert faults_of_layout(page) == []
