"""The finger that is moved over a plate on a page: its numbers are those of the package."""

import re
from dataclasses import replace

import numpy as np
import pytest
from playwright.sync_api import Page
from test_feel import PLATE, gap, response_of

from browser import STILL, WIDTHS, page_at, pixels, violations, written
from haptonic.errors import FrictionError
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.lubrication.law import ENDS, FrictionLaw
from haptonic.friction.lubrication.sharing import check_force
from haptonic.results.feel.value import Feel

MAP = ".finger .map canvas"


@pytest.fixture(scope="module")
def result() -> Feel:
    return Feel(PLATE, {"lattice": gap(52e3, 60e3)}, response_of(drive=80.0), interactive=True)


@pytest.fixture(scope="module")
def view(result):
    return result.view()


@pytest.fixture(scope="module")
def address(result, tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("finger")
    path = folder / "feel.html"
    result.files["feel.html"](path)
    return path.as_uri()


def law_of(result: Feel, data, force: int, speed: int) -> FrictionLaw:
    touch = replace(
        result.friction.touch, force=float(data["force"][force]), speed=float(data["speed"][speed])
    )
    return FrictionLaw.of(touch, result.friction.skin)


def test_tables_give_the_law_of_every_force_and_speed(result, view):
    data = view.dataset
    assert result.friction.touch.force in data["force"].values
    assert result.friction.touch.speed in data["speed"].values
    for force, speed in ((0, 0), (data.sizes["force"] - 1, 5)):
        law = law_of(result, data, force, speed)
        shared, contact = data["load_sharing"][force].values, data["intermittent"][speed].values
        joined = [np.where(np.isnan(shared[0]), contact[0], shared[0])]
        # an interval contains the values of both models, also of one that has no interval
        joined.append(np.fmin.reduce([shared[1], contact[1], shared[0], contact[0]]))
        joined.append(np.fmax.reduce([shared[2], contact[2], shared[0], contact[0]]))
        for end, values in zip(ENDS, joined, strict=True):
            np.testing.assert_allclose(values, getattr(law, end), atol=1e-6)


def test_forces_that_press_the_skin_flat_are_left_out(result, view):
    touch, values = result.friction.touch, result.friction.skin.values
    *_, before, largest = view.dataset["force"].values.tolist()
    check_force(replace(touch, force=largest), values)
    with pytest.raises(FrictionError, match="at rest"):
        check_force(replace(touch, force=largest**2 / before), values)


def felt(page: Page) -> tuple[list[float], list[float], str]:
    """Friction and reduction (%) with their intervals, and the sentence, as the page prints them."""
    numbers = page.locator(".finger dd").all_inner_texts()
    friction, reduction = ([float(n) for n in re.findall(r"[\d.]+", text)] for text in numbers[:2])
    return friction, reduction, page.locator("#felt").inner_text()


def test_numbers_below_the_finger_are_those_of_the_package(browser, address, result, view):
    data, loaded = view.dataset, result.friction.loaded
    force, speed = (
        list(data[name].values).index(getattr(result.friction.touch, name)) for name in ("force", "speed")
    )
    drive = result.friction.drive
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")

        def check() -> None:
            place = int(page.locator(MAP).get_attribute("data-shown"))
            law = law_of(result, data, force, speed)
            moved = loaded["amplitude"].isel(point=place) * drive
            expected = {end: float(law.at(moved.sel(load=end).values, end)) for end in ENDS}
            friction, reduction, words = felt(page)
            np.testing.assert_allclose(friction, [expected[end] for end in ENDS], atol=5.1e-3)
            np.testing.assert_allclose(reduction[0], 100 * (1 - expected["value"]), atol=0.51)
            assert ("not noticed" in words) == (1 - expected["value"] <= WEBER_FRACTION)
            assert words.startswith(str(loaded["region"].values[place]) or "a lattice")

        check()
        page.locator(".walk").focus()
        for _ in range(3):
            page.keyboard.press("Shift+ArrowRight")
        check()
        page.keyboard.press("Shift+ArrowLeft")
        for key in ("f", "S", "S"):
            page.keyboard.press(key)
        force, speed = force + 1, speed - 2
        check()
        page.get_by_label(re.compile("^Drive")).fill("40")
        drive = 40.0
        check()
        before = pixels(page, MAP)
        box = page.locator(MAP).bounding_box()
        page.mouse.move(box["x"] + 0.1 * box["width"], box["y"] + 0.5 * box["height"])
        page.mouse.down()
        page.mouse.move(box["x"] + 0.27 * box["width"], box["y"] + 0.3 * box["height"], steps=3)
        page.mouse.up()
        place = int(page.locator(MAP).get_attribute("data-shown"))
        x, y = 0.27 * 49e-3, 0.7 * 28e-3  # of the plate
        away = np.hypot(loaded["x"].values - x, loaded["y"].values - y)
        assert away[place] < away.min() + 0.5e-3
        assert (pixels(page, MAP) != before).any()
        check()


def test_the_map_is_smooth_between_places(browser, address, view):
    """Each place as a block would give most pixels the colour of their neighbour."""
    data = view.dataset
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        colours = pixels(page, MAP)[..., :3]
    step = colours.shape[1] / len(np.unique(data["x"]))  # pixels
    assert step > 4
    jumps = np.abs(np.diff(colours, axis=1)).max(axis=-1)
    assert (jumps > 0).mean() > 1.5 / step


def test_the_page_has_the_names_of_the_pictures(browser, address):
    with page_at(browser, address, **STILL) as page:
        page.wait_for_selector(f"{MAP}[data-shown]")
        assert page.get_by_text("just noticed, 11 % less friction").is_visible()
        assert page.locator("dt", has_text="μ/μ₀, model").is_visible()
        titles = [text["text"] for text in written(page)]
        assert "μ/μ₀" in titles


def test_the_page_fits_its_window_and_breaks_no_rule_of_accessibility(browser, address):
    for scheme in ("light", "dark"):
        with page_at(browser, address, color_scheme=scheme, **STILL) as page:
            page.get_by_role("button", name="Tables").click()
            assert violations(page) == []
            for width, height in WIDTHS.items():
                page.set_viewport_size({"width": width, "height": height})
                page.wait_for_timeout(300)  # the curve follows its place
                assert page.evaluate("document.documentElement.scrollWidth") <= width
