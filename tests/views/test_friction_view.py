"""The page of friction trials: its estimates against the result, and the page in a real browser."""

import numpy as np
import pytest
from playwright.sync_api import Browser, expect

from browser import STILL, faults_of_layout, page_at
from haptonic.analyses import named
from haptonic.analyses.runner import Runner
from haptonic.results.friction import FrictionResult
from haptonic.results.friction_view import FRICTION, REDUCTION
from trial_folders import simulated, written


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> FrictionResult:
    folder = written(tmp_path_factory.mktemp("friction") / "<i>trials", simulated(participants=3, trials=4))
    answer = named("friction").run(None, Runner(), {"path": folder, "html": True})
    assert isinstance(answer, FrictionResult)
    return answer


@pytest.fixture(scope="module")
def address(result, tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("page") / "friction.html"
    result.files["friction.html"](path)
    return path.as_uri()


def test_the_view_has_every_estimate_with_its_interval(result):
    data = result.view().dataset
    quantity, name = data["quantity"].values, data["name"].values
    for region, estimate in result.found.reductions.items():
        (row,) = np.flatnonzero((quantity == REDUCTION) & (name == f"{region}, all participants"))
        interval = [float(data[part][row]) for part in ("value", "low", "high")]
        np.testing.assert_allclose(interval, [estimate.value, estimate.low, estimate.high])
    assert (quantity == REDUCTION).sum() == 2 * (1 + 3)
    assert (quantity == FRICTION).sum() == len(result.found.conditions)
    assert data.sizes["trial"] == int((result.trials["excluded"].values == "").sum())
    assert set(data["trial_condition"].values.tolist()) <= set(name.tolist())


def test_the_conclusions_of_the_library_come_first(result):
    view = result.view()
    assert view.extra["summary"] == list(result.found.conclusions)
    assert sorted([*view.extra["summary"], *view.extra["sentences"]]) == sorted(result.summary())


def test_keys_walk_through_the_estimates_and_the_table_has_all(browser: Browser, address, result):
    with page_at(browser, address, **STILL) as page:
        for sentence in result.found.conclusions:
            expect(page.get_by_text(sentence)).to_be_visible()
        facts, walk = page.locator("#point"), page.locator(".walk")
        region, estimate = next(iter(result.found.reductions.items()))
        expect(facts).to_contain_text(f"{region}, all participants")
        expect(facts).to_contain_text(f"{estimate.value:.3f}, from {estimate.low:.3f} to {estimate.high:.3f}")
        walk.press("ArrowDown")
        expect(facts).to_contain_text(f"{region}, ")
        expect(facts).not_to_contain_text("all participants")
        expect(page.locator(".estimates .interval")).to_have_count(8)
        walk.press("q")
        expect(page.get_by_label("Quantity")).to_have_value(FRICTION)
        expect(page.locator(".estimates .trial")).to_have_count(result.view().dataset.sizes["trial"])
        walk.press("t")
        expect(page.locator("table").nth(0).locator("tbody tr")).to_have_count(8)


def test_the_page_is_accessible_and_fits(browser: Browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(".estimates")
        page.locator(".walk").press("t")
        assert faults_of_layout(page) == []
