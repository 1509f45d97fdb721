"""The map of a plate is painted and its parts are dragged: the text of the study has what the page shows."""

import json
import re
import tomllib
from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from served import Served, served
from test_page import TEXT, opened, text_of, wait_for_text

from browser import WIDTHS, pixels, violations
from haptonic.studio.painting import forecast, painting
from haptonic.study import loads, templates
from quick import QUICK_CELL

MAP = ".paint canvas"
MARGIN = 12  # CSS pixels around the map, as in web/src/studio/paint/canvas.ts
HOSTILE = "<img src=x onerror='harmed = true'>"
PLATE = (
    QUICK_CELL
    + f"""
# what the user wrote about the plate
[plate]
map = "o11o22o"  # one line
rows = 4
[plate.tiles]
o = "lattice"    # pillars
1 = "A"
2 = "{HOSTILE}"
[plate.clamp]
corners = "5 mm"
[[plate.actuator]]
name = "A1"
region = "A"
centre = ["7 mm", "3.5 mm"]  # in the first row
size = ["6 mm", "5 mm", "500 um"]
material = "pzt-4"
[plate.finger]
centre = ["10 mm", "0.02 m"]
damping = "10 N s/m"
diameter = "3 mm"
"""
)
COLUMNS, ROWS, PITCH = 7, 4, 7e-3


@pytest.fixture(scope="module")
def studio(tmp_path_factory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("painted")
    (folder / "plate.toml").write_text(PLATE, "utf-8")
    with served(folder, "plate.toml") as running:
        yield running


def plate_in(page: Page) -> dict:
    return tomllib.loads(text_of(page))["plate"]


def rows_of(page: Page) -> list[str]:
    plate = tomllib.loads(text_of(page)).get("plate", {"map": ""})
    lines = plate["map"].split()
    return lines * (plate.get("rows", len(lines)) // max(len(lines), 1))


def at(page: Page, x: float, y: float) -> tuple[float, float]:
    """Place in the window of a point of the plate, m from its lower left corner."""
    box = page.locator(MAP).bounding_box()
    scale = (box["width"] - 2 * MARGIN) / (COLUMNS * PITCH)
    return box["x"] + MARGIN + scale * x, box["y"] + box["height"] - MARGIN - scale * y


def drag(page: Page, *points: tuple[float, float]) -> None:
    page.locator(MAP).scroll_into_view_if_needed()
    page.mouse.move(*at(page, *points[0]))
    page.mouse.down()
    for point in points[1:]:
        page.mouse.move(*at(page, *point), steps=4)
    page.mouse.up()


def middle(row: int, column: int) -> tuple[float, float]:
    """Middle of a tile, m; rows from above."""
    return (column + 0.5) * PITCH, (ROWS - row - 0.5) * PITCH


def until(page: Page, rows: list[str]) -> None:
    for _ in range(200):
        if rows_of(page) == rows:
            return
        page.wait_for_timeout(50)
    assert rows_of(page) == rows


def test_strokes_change_the_map_in_the_text_and_one_undo_takes_one_back(browser, studio):
    with opened(browser, studio) as page:
        page.evaluate("window.harmed = false")
        page.get_by_role("button", name=f"2 {HOSTILE}").click()
        drag(page, middle(0, 0), middle(0, 2))
        until(page, ["222o22o", *["o11o22o"] * 3])
        assert "rows" not in plate_in(page)
        assert "# one line" in text_of(page)
        assert page.locator(".paint dd").all_inner_texts()[:4] == [
            "6 tiles",
            "11 tiles",
            "11 tiles",
            "7 x 4 tiles",
        ]
        page.get_by_role("button", name="Undo").click()
        until(page, ["o11o22o"] * 4)
        assert text_of(page) == PLATE
        page.get_by_role("button", name="Rectangle").click()
        page.get_by_label("mirror top and bottom").check()
        drag(page, middle(0, 3), middle(0, 6))
        until(page, ["o112222", "o11o22o", "o11o22o", "o112222"])
        page.get_by_role("button", name="Fill").click()
        page.get_by_role("button", name="o lattice").click()
        page.mouse.click(*at(page, *middle(0, 5)))
        until(page, ["o11oooo"] * 4)
        page.locator(".paint").get_by_text("plate.tiles.2").first.wait_for()  # no tile has this letter
        assert page.evaluate("window.harmed") is False


def test_the_keyboard_paints_and_resizes(browser, studio):
    with opened(browser, studio) as page:
        page.locator(MAP).focus()
        for key in ("ArrowRight", "ArrowDown", "3", " "):  # the third tile of the palette: o comes last
            page.keyboard.press(key)
        until(page, ["o11o22o", "oo1o22o", *["o11o22o"] * 2])
        assert "Row 2 from above, column 2: o lattice" in page.locator("#paint-place").inner_text()
        page.keyboard.press("Control+z")
        until(page, ["o11o22o"] * 4)
        for key in ("l", "1", "ArrowLeft", " ", "ArrowDown", "ArrowDown", " "):
            page.keyboard.press(key)
        until(page, ["o11o22o", *["111o22o"] * 3])
        page.keyboard.press("Control+z")
        page.keyboard.press("Control+Shift+z")
        page.keyboard.press("Control+z")
        until(page, ["o11o22o"] * 4)
        page.get_by_role("button", name="Add a line above").click()
        until(page, ["o11o22o"] * 5)
        assert plate_in(page)["rows"] == 5
        page.get_by_role("button", name="Remove a line right").click()
        until(page, ["o11o22"] * 5)
        expect(page.locator(".paint dd", has_text="42 x 35 mm")).to_be_visible()


def test_parts_and_clamps_are_dragged_and_moved_by_keys(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_role("button", name="Move parts").click()
        drag(page, (0.014, 0.0035), (0.0118, 0.0103))  # to a tile's middle
        wait_for_text(page, 'centre = ["4.8 mm", "10.5 mm"]  # in the first row')
        drag(page, (0.0088, 0.013), (0.0078, 0.0138))  # the upper left handle, to a line
        wait_for_text(page, 'size = ["7 mm", "6 mm", "500 um"]')
        page.locator(MAP).focus()
        page.keyboard.press("Shift+ArrowRight")
        page.keyboard.press("+")
        wait_for_text(page, 'size = ["7.1 mm", "6 mm", "500 um"]')
        patch = plate_in(page)["actuator"][0]
        left, low = (float(text.split()[0]) for text in patch["centre"])
        assert (left, low) == pytest.approx((5.3, 11.0))
        page.keyboard.press("n")
        page.keyboard.press("ArrowUp")
        wait_for_text(page, '"0.0201 m"')  # the finger's unit stays
        drag(page, (0.005, 0.0), (0.0091, 0.0))
        wait_for_text(page, 'corners = "9.1 mm"')
        drag(page, (0.012, 0.011), (0.03, 0.011))  # onto the other region
        page.locator(".paint .problem", has_text="plate.actuator").first.wait_for()
        assert "A1: centre at" in page.locator("#paint-place").inner_text()


def test_a_stroke_is_drawn_before_the_server_answers_and_a_plate_begins(browser, studio):
    with opened(browser, studio) as page:
        page.locator(MAP).focus()
        before, asked = pixels(page, MAP), []
        page.route("**/api/change", lambda route: asked.append(route))
        page.keyboard.press("2")
        page.keyboard.press(" ")
        page.wait_for_timeout(100)
        tile = tuple(slice(round(MARGIN + 8), round(MARGIN + 20)) for _ in range(2))
        assert np.abs(pixels(page, MAP)[tile] - before[tile]).max() > 20
        assert text_of(page) == PLATE
        asked[0].continue_()
        until(page, ["211o22o", *["o11o22o"] * 3])
        page.unroute("**/api/change")
        page.fill(TEXT, QUICK_CELL)
        page.get_by_role("button", name="Begin a plate").click()
        until(page, ["oooooo"] * 4)
        expect(page.locator(".paint dd", has_text="24 pillars")).to_be_visible()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_map_is_accessible_and_fits_every_width(browser, studio, scheme):
    with opened(browser, studio, color_scheme=scheme) as page:
        page.get_by_text("Keys on the map").click()
        page.locator(".paint table", has_text="haptonic plate").wait_for()
        assert violations(page) == []
        for width, height in WIDTHS.items():
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_drawing_has_the_lines_and_pillars_of_the_layout():
    study = loads(str(templates()["two-carriers"]))
    drawing, layout = painting(study), study.mounted_plate().layout
    assert drawing is not None
    assert {len(drawing["x"]) - 1, len(drawing["y"]) - 1} == {
        len(study.plate_settings.grid[0]),
        len(study.plate_settings.grid),
    }
    np.testing.assert_allclose([drawing["x"][-1], drawing["y"][-1]], [layout.x[-1], layout.y[-1]], rtol=1e-12)
    places = sorted(place for kind in drawing["features"] for place in map(tuple, kind["places"]))
    np.testing.assert_allclose(places, sorted((x, y) for x, y, _ in layout.features), rtol=1e-5)
    json.dumps(drawing, allow_nan=False)


def test_the_mass_is_that_of_the_sizes():
    drawing = painting(loads(PLATE))
    pillars = 3 * ROWS
    expected = 2700 * (COLUMNS * ROWS * PITCH**2 * 1.5e-3 + pillars * np.pi * 1.75e-3**2 * 14.7e-3)
    assert drawing is not None
    assert drawing["mass"] == pytest.approx(expected, rel=1e-9)
    assert drawing["parts"][0]["corner"] == pytest.approx([PITCH, 0.0])


def test_costs_are_those_of_the_plan():
    rows = {row["command"]: row for row in forecast(loads(PLATE))}
    assert {"bands", "plate"} <= rows.keys()
    assert re.search("second|minute", rows["plate"]["time"])


def test_several_keys_are_changed_together_or_not_at_all(studio):
    changes = [
        {"steps": ["plate", "map"], "value": "o11\no11\n"},
        {"steps": ["plate", "rows"], "value": None},
    ]
    reply = studio.post("change", text=PLATE, changes=changes).json
    assert 'map = """\no11\no11\n"""  # one line' in reply["text"]
    assert "rows" not in tomllib.loads(reply["text"])["plate"]
    for wrong in ([], None, [{"steps": []}], [*changes, {"steps": ["none"], "value": None}]):
        assert studio.post("change", text=PLATE, changes=wrong).status == 422
