"""The page of the studio in a real browser: form and text follow each other, and results appear."""

import re
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Browser, Page, expect
from served import Served, served

from browser import STILL, WIDTHS, page_at, violations
from haptonic.study import templates
from quick import QUICK_CELL

expect.set_options(timeout=30_000)
TEXT = "textarea[aria-label^='Text of the study']"
CELL = str(templates()["bare-cell"])


@pytest.fixture(scope="module")
def studio(tmp_path_factory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("page")
    (folder / "cell.toml").write_text(CELL, "utf-8")
    (folder / "quick.toml").write_text(QUICK_CELL, "utf-8")
    with served(folder, "cell.toml") as running:
        yield running


def admitted(studio: Served) -> dict:
    """State of a browser that was admitted."""
    name, value = studio.cookie.split("=", 1)
    cookie = {"name": name, "value": value, "domain": "127.0.0.1", "path": "/", "expires": -1}
    return {"cookies": [cookie | {"httpOnly": True, "secure": False, "sameSite": "Strict"}]}


@contextmanager
def opened(browser: Browser, studio: Served, width: int = 1440, **context) -> Iterator[Page]:
    """The page in a browser that was admitted, with the study in it."""
    state = {"storage_state": admitted(studio), **STILL, **context}
    with page_at(browser, f"{studio.origin}/", width, **state) as page:
        expect(page.locator(TEXT)).to_have_value(re.compile("."))
        yield page


def text_of(page: Page) -> str:
    return page.input_value(TEXT)


def write(page: Page, label: str, value: str) -> None:
    field = page.get_by_label(label, exact=True).first
    field.fill(value)
    field.press("Enter")


def wait_for_text(page: Page, part: str) -> None:
    expect(page.locator(TEXT)).to_have_value(re.compile(re.escape(part)))


def test_the_link_opens_the_page(browser, tmp_path):
    with served(tmp_path, admit=False) as fresh, page_at(browser, fresh.link) as page:
        page.wait_for_selector(".form")
        assert page.url == f"{fresh.origin}/"
        assert page.get_by_text("Choose a template").is_visible()


def test_the_text_follows_the_form_and_keeps_its_comments(browser, studio):
    with opened(browser, studio) as page:
        write(page, "Pitch with unit", "8 mm")
        wait_for_text(page, 'pitch = "8 mm"')
        before, after = CELL.splitlines(), text_of(page).splitlines()
        assert [line for line in before if line not in after] == [
            next(x for x in before if x.startswith("pitch"))
        ]
        page.get_by_role("button", name="Undo").click()
        wait_for_text(page, 'pitch = "6 mm"')
        assert text_of(page) == CELL
        page.get_by_role("button", name="Redo").click()
        wait_for_text(page, 'pitch = "8 mm"')
        page.get_by_label("Lattice").select_option("triangular")
        wait_for_text(page, 'lattice = "triangular"')
        page.locator("summary", has_text="draft angle").click()
        write(page, "Draft angle with unit", "3 deg")
        wait_for_text(page, 'draft = "3 deg"')
        write(page, "Draft angle with unit", "")
        expect(page.locator(TEXT)).not_to_have_value(re.compile("draft"))


def test_the_form_follows_the_text_also_by_the_keyboard(browser, studio):
    with opened(browser, studio) as page:
        page.fill(TEXT, CELL.replace('"6 mm"', '"9 mm"'))
        expect(page.locator("[id='key-cell.pitch']")).to_have_value("9 mm")
        page.focus(TEXT)
        page.keyboard.press("Control+z")
        expect(page.locator("[id='key-cell.pitch']")).to_have_value("6 mm")
        page.keyboard.press("Control+Shift+z")
        expect(page.locator("[id='key-cell.pitch']")).to_have_value("9 mm")


def test_a_crystal_needs_no_constants_of_isotropic_solids(browser, studio):
    constants = 'c11 = "166 GPa"\nc12 = "64 GPa"\nc44 = "80 GPa"\ndensity = "2330 kg/m^3"\n'
    with opened(browser, studio) as page:
        page.fill(TEXT, f'[material]\n{constants}[cell]\npitch = "7 mm"\nthickness = "1 mm"\n')
        expect(page.locator("[id='key-material.c11']")).to_have_value("166 GPa")
        page.locator("summary", has_text=re.compile("Young's modulus, Poisson ratio")).wait_for()
        assert not page.locator("[id='key-material.youngs_modulus']").is_visible()
        assert not page.get_by_text("(required)").is_visible()
        page.get_by_label("Material, by name").first.select_option("steel")
        wait_for_text(page, 'material = "steel"')
        page.get_by_label("Material, by name").first.select_option(label="other, by its constants")
        page.locator(".form .problem", has_text="the Young's modulus was left out").wait_for()


def test_tables_are_added_and_removed(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_text("Further tables").click()
        page.locator("summary", has_text="Sweeps").click()
        page.get_by_role("button", name="Add to sweeps").click()
        wait_for_text(page, "\n[[sweep]]\n")
        page.locator(".problems").get_by_text("sweep[1].vary").wait_for()
        page.get_by_role("button", name="Remove sweeps 1").click()
        expect(page.locator(TEXT)).not_to_have_value(re.compile(r"^\[\[sweep\]\]$", re.MULTILINE))


def test_the_first_key_of_a_table_leaves_the_focus_where_it_is(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_text("Further tables").click()
        page.locator("summary", has_text=re.compile("^Trials")).click()
        page.locator("[id='key-trials.threshold']").fill("50 mN")
        page.keyboard.press("Tab")
        following = page.evaluate("document.activeElement.id")
        wait_for_text(page, "[trials]")
        page.locator("[id='key-trials.threshold'][aria-invalid=false]").wait_for()
        assert following.startswith("key-trials.")
        assert page.evaluate("document.activeElement.id") == following


def test_a_problem_is_shown_at_its_key_and_at_its_line(browser, studio):
    with opened(browser, studio) as page:
        write(page, "Pitch with unit", "8")
        field = page.locator("[id='key-cell.pitch']")
        page.wait_for_selector("[id='key-cell.pitch'][aria-invalid=true]")
        assert "unit is missing" in page.locator("[id='key-cell.pitch-about']").inner_text()
        line = next(k for k, text in enumerate(text_of(page).splitlines(), 1) if text.startswith("pitch"))
        assert page.locator(".editor ol .wrong").inner_text() == str(line)
        problem = page.locator(".problems")
        for part in ("allowed", "likely cause", "next step", "got '8'"):
            assert part in problem.inner_text()
        page.get_by_role("button", name=re.compile(rf"^line {line}, cell.pitch")).click()
        selected = page.eval_on_selector(TEXT, "a => a.value.slice(a.selectionStart, a.selectionEnd)")
        assert selected.startswith('pitch = "8"')
        assert page.get_by_role("button", name="Compute bands").is_disabled()
        field.fill("8 mm")
        field.press("Enter")
        page.get_by_text("The study has no problem.").wait_for()


def test_a_mistake_in_the_syntax_leaves_the_form_as_it_was(browser, studio):
    with opened(browser, studio) as page:
        page.fill(TEXT, CELL.replace('"6 mm"', "6 mm"))
        page.get_by_text("mistake in its syntax").wait_for()
        assert page.locator("[id='key-cell.pitch']").is_disabled()
        assert page.locator("[id='key-cell.pitch']").input_value() == "6 mm"


def test_a_study_is_made_from_a_template_saved_and_opened(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label("New, from a template").select_option("mirror")
        wait_for_text(page, str(templates()["mirror"])[:60])
        page.get_by_label("File name").fill("mine")
        page.get_by_role("button", name="Save", exact=True).click()
        page.get_by_text("saved", exact=True).wait_for()
        path = studio.studio.workspace.folder / "mine.toml"
        assert path.read_text("utf-8") == str(templates()["mirror"])
        page.get_by_label(re.compile("^Open, in")).select_option("cell.toml")
        wait_for_text(page, CELL[:60])


def test_undo_across_the_opening_of_a_file_brings_back_the_file_as_well(browser, studio):
    with opened(browser, studio) as page:
        name = page.get_by_label("File name")
        page.get_by_label(re.compile("^Open, in")).select_option("quick.toml")
        expect(page.locator(TEXT)).to_have_value(QUICK_CELL)
        expect(name).to_have_value("quick.toml")
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value(CELL)
        expect(name).to_have_value("cell.toml")
        expect(page.get_by_text("saved", exact=True)).to_be_visible()
        page.get_by_role("button", name="Redo").click()
        expect(name).to_have_value("quick.toml")


def test_a_change_belongs_to_its_study_and_the_last_choice_is_opened(browser, studio):
    with opened(browser, studio) as page:
        for address in ("change", "open"):
            page.route(f"**/api/{address}", lambda route: (time.sleep(0.4), route.continue_()))
        page.on("dialog", lambda dialog: dialog.accept())
        name, files = page.get_by_label("File name"), page.get_by_label(re.compile("^Open, in"))
        write(page, "Pitch with unit", "8 mm")
        files.select_option("quick.toml")
        expect(name).to_have_value("quick.toml")
        assert text_of(page) == QUICK_CELL
        page.get_by_role("button", name="Undo").click()
        wait_for_text(page, 'pitch = "8 mm"')
        expect(name).to_have_value("cell.toml")
        files.select_option("quick.toml")
        files.select_option("cell.toml")
        page.get_by_label("Analysis").select_option("plan")
        page.get_by_role("button", name="Compute plan").click()  # of the study that is being opened
        expect(page.get_by_text("This result belongs")).to_have_count(0)
        expect(page.locator(TEXT)).to_have_value(CELL)
        expect(page.get_by_role("region", name="Result of plan")).to_be_visible()
        expect(page.get_by_text("This result belongs")).to_have_count(0)


def test_line_numbers_stay_beside_their_lines(browser, studio):
    with opened(browser, studio) as page:
        page.on("dialog", lambda dialog: dialog.accept())
        numbers, area = page.locator(".editor ol"), page.locator(TEXT)
        area.evaluate("area => area.scrollTop = area.scrollHeight")
        area.fill(CELL + "[bands")  # the list of problems leaves the text less height
        page.locator(".problems li").wait_for()
        area.evaluate("area => area.scrollTop = area.scrollHeight")
        area.fill(CELL)
        expect(page.get_by_text("The study has no problem.")).to_be_visible()
        for name in ("mirror", "touchpad"):
            page.get_by_label("New, from a template").select_option(name)
            wait_for_text(page, str(templates()[name])[:60])
            page.wait_for_timeout(300)
            numbered, written = (part.evaluate("part => part.scrollTop") for part in (numbers, area))
            assert abs(numbered - written) <= 1


def test_the_form_of_another_study_shows_only_its_own_tables(browser, studio):
    with opened(browser, studio) as page:
        page.on("dialog", lambda dialog: dialog.accept())  # it asks before it replaces an unsaved study
        plate = page.locator("summary", has_text=re.compile("^Plate"))
        for name, has_plate in (("touchpad", True), ("bare-cell", False)):
            page.get_by_label("New, from a template").select_option(name)
            expect(plate).to_be_visible(visible=has_plate)


def test_bands_of_a_study_that_is_opened_are_computed_if_they_take_seconds(browser, tmp_path):
    slow = QUICK_CELL.replace("order = 2", "order = 6").replace("foot_rings = 0", "foot_rings = 2")
    (tmp_path / "slow.toml").write_text(slow, "utf-8")
    (tmp_path / "quick.toml").write_text(QUICK_CELL, "utf-8")
    with served(tmp_path, "slow.toml") as fresh:
        jobs = fresh.studio.jobs.jobs
        with opened(browser, fresh) as page:
            with page.expect_response("**/api/forecast"):
                page.reload()
            page.get_by_label(re.compile("^Open, in")).select_option("quick.toml")
            page.wait_for_selector("canvas[data-shown]", timeout=120_000)
            # the page has not scrolled
            expect(page.get_by_role("button", name="Compute bands")).to_be_in_viewport()
        assert [job.order.text for job in jobs.values()] == [QUICK_CELL]
        with opened(browser, fresh) as page:  # another page shows this result, and computes nothing
            page.wait_for_selector("canvas[data-shown]", timeout=120_000)
        assert len(jobs) == 1


def test_a_refused_name_is_explained(browser, studio):
    # the browser reports the refusal on its console, which `page_at` would take for a fault
    context = browser.new_context(storage_state=admitted(studio))
    page = context.new_page()
    page.goto(f"{studio.origin}/")
    page.get_by_label("File name").fill("../outside")
    page.get_by_role("button", name="Save", exact=True).click()
    page.get_by_role("alert").get_by_text("next step").wait_for()
    context.close()
    assert not (studio.studio.workspace.folder.parent / "outside.toml").exists()


def test_a_hostile_title_is_text(browser, studio):
    with opened(browser, studio) as page:
        page.evaluate("window.harmed = false")
        title = "<img src=x onerror='harmed = true'><script>harmed = true</script>"
        page.fill(TEXT, CELL.replace('"My cell"', f'"{title}"'))
        expect(page.locator("#key-title")).to_have_value(re.compile("^<img"))
        page.get_by_label("Analysis").select_option("plan")
        page.get_by_role("button", name="Compute plan").click()
        page.locator(".result").get_by_text("onerror").first.wait_for(timeout=60_000)
        assert page.evaluate("window.harmed") is False


def test_a_link_leads_past_the_form_on_a_narrow_screen(browser, studio):
    with opened(browser, studio, 360) as page:
        expect(page.get_by_role("heading", name="Compute")).not_to_be_in_viewport()
        page.get_by_role("link", name="Go to the analyses").click()
        expect(page.get_by_role("heading", name="Compute")).to_be_in_viewport()
    with opened(browser, studio) as page:
        expect(page.get_by_role("link", name="Go to the analyses")).to_be_hidden()


def test_bands_are_computed_shown_and_marked_when_the_study_has_changed(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label(re.compile("^Open, in")).select_option("quick.toml")
        wait_for_text(page, "Quick")
        page.get_by_role("button", name="Compute bands").click()
        page.wait_for_selector("canvas[data-shown]", timeout=120_000)
        expect(page.get_by_role("heading", name="Bands and gaps")).to_be_in_viewport()
        page.locator(".compute").scroll_into_view_if_needed()
        page.get_by_role("link", name="Go to the result").click()
        expect(page.get_by_role("heading", name="Bands and gaps")).to_be_in_viewport()
        assert page.get_by_text("haptonic bands quick.toml --html").is_visible()
        assert page.get_by_text('haptonic.load("quick.toml").bands(html=True)').is_visible()
        pitch = text_of(page)
        write(page, "Pitch with unit", "7.1 mm")
        page.get_by_text("belongs to another version").wait_for()
        page.get_by_role("button", name="Show that study").click()
        wait_for_text(page, 'pitch = "7 mm"')
        assert text_of(page) == pitch
        page.get_by_text("belongs to another version").wait_for(state="detached")
        page.get_by_label(re.compile("^Open, in")).select_option("cell.toml")
        page.get_by_text("belongs to quick.toml").wait_for()
        page.get_by_role("button", name="Show that study").click()
        page.get_by_text("belongs to").wait_for(state="detached")
        page.locator("summary", has_text="Pictures").click()
        page.locator(".pictures img").first.scroll_into_view_if_needed()
        first = page.locator(".pictures figure").first
        expect(first.get_by_text("is being drawn")).to_have_count(0, timeout=120_000)
        assert page.eval_on_selector(".pictures img", "image => image.naturalWidth") > 100
        assert page.locator(".pictures img").count() == 3
        page.locator("summary", has_text="Pictures").click()
        expect(page.locator(".pictures img")).to_have_count(0)


def test_another_page_finds_the_result_of_one_that_was_closed(browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label("Analysis").select_option("plan")
        page.get_by_role("button", name="Compute plan").click()
        page.get_by_role("button", name="Cancel").or_(page.locator(".result")).first.wait_for()
    with opened(browser, studio) as page:
        page.locator(".result").get_by_text("haptonic plan cell.toml").wait_for(timeout=60_000)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_is_accessible_and_fits_every_width(browser, studio, scheme):
    number = studio.post("run", analysis="plan", options={}, text=CELL, file="cell.toml").json["number"]
    studio.finished(number)
    with opened(browser, studio, color_scheme=scheme) as page:
        write(page, "Pitch with unit", "8")
        page.wait_for_selector("[aria-invalid=true]")
        page.locator(".result table").first.wait_for()
        assert violations(page) == []
        for width, height in WIDTHS.items():
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_every_control_is_reached_by_the_keyboard_and_shows_its_focus(browser, studio):
    with opened(browser, studio) as page:
        seen = set()
        for _ in range(60):
            page.keyboard.press("Tab")
            about = page.evaluate(
                "() => { const e = document.activeElement, s = getComputedStyle(e);"
                " return [e.id || e.textContent.slice(0, 20), s.outlineStyle, e.tagName] }"
            )
            if about[2] == "BODY":
                break
            assert about[1] != "none", about
            seen.add(about[0])
        assert {"key-cell.pitch", "Compute bands", "Undo"} & seen >= {"key-cell.pitch", "Compute bands"}
