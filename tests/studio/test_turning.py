"""A number is turned beside its diagram: preview at once, certified curves after it, one step to undo."""

import math
import re

import pytest
from playwright.sync_api import expect
from served import served
from test_page import TEXT, opened, text_of

from browser import WIDTHS, pixels, violations
from haptonic.bloch import bands_dataset
from haptonic.studio.answers import packed_part
from haptonic.study import loads, templates
from turned import TURNED_CELL

SLOW = str(templates()["touchpad"])
SLIDER = ".turning input"
DIAMETER = ["cell", "pillar", "diameter"]
PATIENCE = 120_000  # ms


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    folder = tmp_path_factory.mktemp("turning")
    (folder / "quick.toml").write_text(TURNED_CELL, "utf-8")
    with served(folder, "quick.toml") as running:
        yield running


def drag(page, shares: list[float]) -> None:
    """Move the thumb to shares of its range, and keep the button pressed."""
    page.locator(SLIDER).scroll_into_view_if_needed()
    box = page.locator(SLIDER).bounding_box()
    places = [(box["x"] + 8 + share * (box["width"] - 16), box["y"] + box["height"] / 2) for share in shares]
    page.mouse.move(*places[0])
    page.mouse.down()
    for place in places[1:]:
        page.mouse.move(*place)


def test_a_number_is_turned_with_a_preview_and_certified_curves(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_role("button", name="Compute bands").click()
        expect(page.locator(SLIDER)).to_be_enabled(timeout=PATIENCE)
        page.locator(".turning select").select_option("cell.pillar.diameter", timeout=PATIENCE)
        page.wait_for_selector(".turning[data-prepared=true]", timeout=PATIENCE)
        kind, edges = page.locator(".kind"), page.locator(".edges")
        certified, before, drawn = edges.inner_text(), text_of(page), pixels(page, ".curves canvas")
        expect(kind).to_have_text("certified")
        drag(page, [0.44, 0.6, 0.7])
        # no request is needed for the preview
        expect(kind).to_have_text("preview", timeout=2000)
        assert re.search(r"gap\s*\d.*± .* to .*± .* kHz", edges.inner_text())
        assert edges.inner_text() != certified
        assert page.get_by_text("preview with its error").is_visible()
        assert text_of(page) == before
        expect(page.locator("#point")).to_contain_text("earlier design")
        # ordinary curves are hidden, and those of the preview have another colour
        assert (pixels(page, ".curves canvas") != drawn).any()
        assert page.get_by_role("button", name="Hold this design").is_disabled()
        page.mouse.up()
        expect(page.locator(TEXT)).to_have_value(re.compile(r'diameter = "3\.9\d* mm"'))
        expect(kind).to_have_text("certified", timeout=PATIENCE)
        expect(page.locator(".turning select")).to_be_enabled(timeout=PATIENCE)
        after = edges.inner_text()
        assert after != certified
        assert not page.get_by_text("belongs to another version").is_visible()
        expect(page.locator("#point")).not_to_contain_text("earlier design")

        page.keyboard.press("Tab")
        page.locator(".walk").focus()
        page.keyboard.press("h")
        table = page.get_by_role("group", name="Held design and this one")
        page.locator(SLIDER).focus()
        for _ in range(3):
            page.keyboard.press("ArrowLeft")
        expect(kind).to_have_text("preview")
        expect(table.locator("tr", has_text="Pillar diameter").locator("td")).to_have_count(2)
        # more than one press of a key is one step of the history
        expect(page.locator(TEXT)).not_to_have_value(re.compile(r"^$"))
        expect(page.locator(".turning select")).to_be_enabled(timeout=PATIENCE)
        assert violations(page) == []
        for width, height in WIDTHS.items():
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            page.locator(".curves").evaluate("e => e.scrollIntoView({ block: 'end' })")
            expect(edges).to_be_in_viewport(ratio=1)
        # the first of two requests is late, and the second value is still the one that is certified
        late = []

        def delay(route):
            page.wait_for_timeout(500)
            late.append(route)
            route.continue_()

        page.route("**/api/run", delay, times=1)
        for key in ("Home", "End"):
            page.locator(SLIDER).press(key)
            page.wait_for_timeout(300)
        expect(page.locator(".turning select")).to_be_enabled(timeout=PATIENCE)
        assert len(late) == 1
        for _ in range(3):
            page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value(before)
        page.get_by_text("The study has changed: compute it first.").wait_for()


PAUSES_NEVER_END = """() => {
  const usual = window.setTimeout;
  window.setTimeout = (action, milliseconds) => (milliseconds === 50 ? 0 : usual(action, milliseconds));
}"""


def test_curves_are_certified_without_a_pause_when_the_pointer_is_released(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_role("button", name="Compute bands").click()
        expect(page.locator(SLIDER)).to_be_enabled(timeout=PATIENCE)
        page.wait_for_selector(".turning[data-prepared=true]", timeout=PATIENCE)
        page.evaluate(PAUSES_NEVER_END)
        drag(page, [0.5, 0.6])
        expect(page.locator(".kind")).to_have_text("preview")
        page.mouse.up()
        expect(page.locator(".kind")).to_have_text("certified", timeout=PATIENCE)
        expect(page.locator(".turning select")).to_be_enabled(timeout=PATIENCE)


def test_certified_curves_are_drawn_before_their_gaps(browser, studio):
    study, early = loads(TURNED_CELL), []
    bands_dataset(study.cell, study.bands_settings, first=early.append)
    without_gaps = packed_part("bands", early[0])
    with opened(browser, studio) as page:
        page.get_by_role("button", name="Compute bands").click()
        expect(page.locator(SLIDER)).to_be_enabled(timeout=PATIENCE)
        page.locator(".turning select").select_option("cell.pillar.diameter", timeout=PATIENCE)
        page.wait_for_selector(".turning[data-prepared=true]", timeout=PATIENCE)
        page.route("**/first", lambda route: route.fulfill(body=without_gaps))
        views = []
        page.route("**/view", lambda route: views.append(route))
        drag(page, [0.44, 0.6])
        expect(page.locator(".kind")).to_have_text("preview")
        of_preview = page.locator(".edges").inner_text()
        page.mouse.up()
        expect(page.locator(".kind")).to_have_text("preview of gaps", timeout=PATIENCE)
        # the curves are certified, and only their gaps are those of the preview
        assert page.locator(".edges").inner_text() == of_preview
        assert not page.get_by_text("preview with its error").is_visible()
        assert page.get_by_role("button", name="Hold this design").is_disabled()
        while not views:
            page.wait_for_timeout(50)
        views[0].continue_()
        expect(page.locator(".kind")).to_have_text("certified", timeout=PATIENCE)


def test_keys_in_a_row_are_one_step_of_the_history_though_the_server_is_slow(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_role("button", name="Compute bands").click()
        expect(page.locator(SLIDER)).to_be_enabled(timeout=PATIENCE)
        before = text_of(page)

        def delay(route):
            page.wait_for_timeout(1000)
            route.continue_()

        page.route("**/api/change", delay)
        for _ in range(3):
            page.locator(SLIDER).press("ArrowRight")
        expect(page.locator(".turning select")).to_be_enabled(timeout=PATIENCE)
        expect(page.locator(TEXT)).not_to_have_value(before)
        page.wait_for_timeout(3500)
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value(before)
        assert page.get_by_role("button", name="Undo").is_disabled()


NAMED = TURNED_CELL.replace('pitch = "7 mm"', 'pitch = "a"') + '\n[parameters]\na = "7 mm"\n'
END = "() => document.querySelector('.curves').plot.scales.x.max"


def test_the_axis_of_wavevectors_follows_a_turned_pitch(browser, tmp_path):
    (tmp_path / "named.toml").write_text(NAMED, "utf-8")
    path = 2 + 2**0.5  # from the middle of the zone to X, M and back, in units of pi over the pitch
    with served(tmp_path, "named.toml") as running, opened(browser, running) as page:
        page.get_by_role("button", name="Compute bands").click()
        expect(page.locator(SLIDER)).to_be_enabled(timeout=PATIENCE)
        page.locator(".turning select").select_option("parameters.a", timeout=PATIENCE)
        page.wait_for_selector(".turning[data-prepared=true]", timeout=PATIENCE)
        assert page.evaluate(END) == pytest.approx(path, rel=1e-9)
        page.get_by_label("Wavevectors in").first.select_option("rad/m")
        assert page.evaluate(END) == pytest.approx(path * math.pi / 7e-3, rel=1e-9)
        drag(page, [0.5, 0.55, 0.6])
        expect(page.locator(".kind")).to_have_text("preview")
        turned = float(re.search(r"[\d.]+", page.locator(".turning output").inner_text())[0]) * 1e-3
        assert turned > 7.01e-3
        expected = pytest.approx(path * math.pi / turned, rel=1e-4)
        assert page.evaluate(END) == expected
        page.get_by_label("Wavevectors in").first.select_option("π/a")
        assert page.evaluate(END) == pytest.approx(path, rel=1e-9)
        page.get_by_label("Wavevectors in").first.select_option("rad/m")
        page.mouse.up()
        expect(page.locator(".kind")).to_have_text("certified", timeout=PATIENCE)
        assert page.evaluate(END) == expected
        page.locator(".walk").focus()
        page.keyboard.press("h")
        page.locator(SLIDER).press("End")
        expect(page.locator(".kind")).to_have_text("preview")
        assert page.evaluate(END) == expected  # the held design has the longer path


def turn(studio, text: str, value: str) -> int:
    reply = studio.post("run", analysis="bands", options={}, text=text, steps=DIAMETER, value=value)
    assert reply.status == 200, reply.content
    return reply.json["number"]


def test_a_newer_move_drops_the_one_that_is_computed_and_keeps_its_worker(studio):
    studio.finished(turn(studio, TURNED_CELL, "3.5 mm"))
    worker = studio.studio.jobs._worker.process.pid
    dropped = [turn(studio, SLOW, f"3.{digit} mm") for digit in (6, 7, 8)]
    last = studio.finished(turn(studio, TURNED_CELL, "3.9 mm"))
    assert last["state"] == "done"
    assert 'diameter = "3.9 mm"' in last["text"]
    assert studio.studio.jobs._worker.process.pid == worker
    for number in dropped:
        assert studio.ask("GET", f"/api/jobs/{number}").status == 404


@pytest.mark.parametrize("steps", [[], ["cell", "<script>", "x"], ["cell", None], "cell.pitch"])
def test_another_key_than_one_of_the_study_is_refused(studio, steps):
    reply = studio.post("run", analysis="bands", options={}, text=TURNED_CELL, steps=steps, value="3 mm")
    assert reply.status == 422 or studio.finished(reply.json["number"])["state"] == "failed"
