"""Runs, computed designs, saved files and links in a real browser."""

import base64
import random
import re
import zlib

import numpy as np
import pytest
from PIL import Image, ImageSequence
from playwright.sync_api import expect
from served import served
from test_page import CELL, TEXT, admitted, opened, text_of, write
from test_studio_runs import MANY, SWEEP

from browser import WIDTHS, violations
from quick import QUICK_CELL

expect.set_options(timeout=30_000)


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs_page")
    (folder / "sweep.toml").write_text(SWEEP, "utf-8")
    with served(folder, "sweep.toml") as running:
        fewer = SWEEP.replace("steps = 3", "steps = 2").replace("15 mm", "14.5 mm")
        for analysis, text in (("bands", QUICK_CELL), ("sweep", fewer), ("sweep", SWEEP)):
            asked = {"analysis": analysis, "options": {}, "text": text, "file": "sweep.toml"}
            running.finished(running.post("run", **asked).json["number"])
        yield running


def linked(text: str) -> str:
    packed = zlib.compressobj(wbits=-15)
    content = packed.compress(text.encode()) + packed.flush()
    return "#study=" + base64.urlsafe_b64encode(content).decode().rstrip("=")


def test_designs_are_selected_by_key_and_open_as_one_step_of_undo(browser, studio):
    with opened(browser, studio) as page:
        expect(page.locator("[data-marks]")).to_have_attribute("data-marks", "6")
        page.get_by_role("application", name=re.compile("Computed designs")).focus()
        for _ in range(3):
            page.keyboard.press("ArrowRight")
        expect(page.locator("#selected-design")).to_contain_text("cell.pillar.height 15 mm, lower edge")
        expect(page.locator("#selected-design")).to_contain_text("±")
        page.keyboard.press("Enter")
        expect(page.locator(TEXT)).to_have_value(re.compile('height = "15 mm"'))
        assert "[[sweep]]  # heights" in text_of(page)
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value(SWEEP)
        page.locator("summary", has_text="Runs").click()
        page.locator("summary", has_text="Designs as a table").click()
        expect(page.get_by_role("button", name="Open 3")).to_be_visible()
        page.get_by_role("button", name="Compare the shown run with 2. sweep").click()
        expect(page.get_by_role("heading", name="2. sweep and 3. sweep")).to_be_visible()
        expect(page.get_by_role("row", name="sweep[1].steps 2 3")).to_be_visible()
        assert violations(page) == []
        for width, height in WIDTHS.items():
            page.set_viewport_size({"width": width, "height": height})
            assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_designs_of_a_cancelled_sweep_stay_in_sight(browser, tmp_path):
    (tmp_path / "many.toml").write_text(MANY, "utf-8")
    with served(tmp_path, "many.toml") as running, opened(browser, running) as page:
        page.get_by_label("Analysis").select_option("sweep")
        page.get_by_role("button", name="Compute sweep").click()
        designs = page.get_by_role("application", name=re.compile("Computed designs"))
        designs.wait_for(timeout=60_000)
        designs.scroll_into_view_if_needed()
        page.get_by_role("button", name="Cancel").click()
        page.get_by_text("The computation of sweep was cancelled").wait_for()
        expect(designs).to_be_in_viewport()


def test_the_state_of_a_run_is_unknown_without_the_server_and_right_when_it_is_back(browser, tmp_path):
    (tmp_path / "many.toml").write_text(MANY, "utf-8")
    with served(tmp_path, "many.toml") as first:
        context = browser.new_context(storage_state=admitted(first))  # its console lists the lost server
        page = context.new_page()
        page.goto(f"{first.origin}/")
        page.get_by_label("Analysis").select_option("sweep")
        page.get_by_role("button", name="Compute sweep").click()
        cancel = page.get_by_role("button", name="Cancel")
        expect(cancel).to_be_visible()
        page.locator("summary", has_text="Runs").click()
        page.get_by_role("button", name="1. sweep (running)").wait_for()
    page.get_by_role("button", name="1. sweep (unknown, because the server does not answer)").wait_for()
    expect(cancel).to_have_count(0)
    with served(tmp_path, "many.toml", port=first.port) as again:
        context.add_cookies(admitted(again)["cookies"])  # as its new link does
        page.get_by_role("button", name="1. sweep (interrupted)").wait_for()
        page.get_by_text("The server ended during the computation of sweep").wait_for()
        page.get_by_role("button", name="Continue").click()
        page.get_by_role("button", name="2. sweep (running)").wait_for()
        expect(page.get_by_role("button", name="1. sweep (interrupted)")).to_have_count(0)
        expect(cancel).to_be_visible()
    context.close()


def test_a_run_is_opened_saved_filmed_and_removed(browser, studio, tmp_path):
    with opened(browser, studio) as page:
        page.locator("summary", has_text="Runs").click()
        page.get_by_role("button", name="1. bands", exact=True).click()
        page.wait_for_selector("canvas[data-shown]")
        choices = page.get_by_role("group", name="Save the result").locator("select")
        for place, choice in enumerate(("dispersion", "pdf", "column, 85 mm")):
            choices.nth(place).select_option(label=choice)
        with page.expect_download() as download:
            page.get_by_role("button", name="Save file").click()
        assert download.value.suggested_filename == "dispersion.pdf"
        assert download.value.path().read_bytes().startswith(b"%PDF")
        for kind in ("GIF", "WebM"):
            with page.expect_download(timeout=60_000) as download:
                page.get_by_role("button", name=kind).click()
            download.value.save_as(tmp_path / download.value.suggested_filename)
        assert (tmp_path / "mode.webm").read_bytes().startswith(b"\x1a\x45\xdf\xa3")
        with Image.open(tmp_path / "mode.gif") as gif:
            frames = [np.asarray(frame.convert("RGB"), int) for frame in ImageSequence.Iterator(gif)]
        assert len(frames) == 40
        assert np.abs(frames[0] - frames[20]).max() > 30  # it moves
        page.get_by_role("button", name="Remove 1. bands").click()
        expect(page.get_by_role("button", name="1. bands", exact=True)).to_have_count(0)


def test_a_link_opens_its_study_and_a_bad_one_changes_nothing(browser, studio):
    with opened(browser, studio) as page:
        page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        page.get_by_role("button", name="Copy link").click()
        page.get_by_text("The link is copied").wait_for()
        link = page.evaluate("navigator.clipboard.readText()")
        assert link.startswith(f"{studio.origin}/#study=")
        hostile = CELL.replace('"My cell"', "'<img src=x onerror=alert(1)>'")
        questions = []
        page.on("dialog", lambda dialog: (questions.append(dialog.message), dialog.accept()))
        long = linked(f"# {random.Random(0).randbytes(80_000).hex()}\n")
        for bad in (linked("x" * 10_000_000), long, "#study=!!", linked("")[:-1] + "_"):
            page.evaluate("hash => { location.hash = hash }", bad)
            page.get_by_role("alert").get_by_text("next step").wait_for()
            assert text_of(page) == SWEEP
            page.get_by_role("button", name="Close").click()
        page.evaluate("hash => { location.hash = hash }", linked(hostile))
        expect(page.locator(TEXT)).to_have_value(hostile)
        assert questions == []  # the text was saved
        assert page.url == f"{studio.origin}/"
        page.evaluate("hash => { location.hash = hash }", link.split("/")[-1])
        expect(page.locator(TEXT)).to_have_value(SWEEP)
        assert len(questions) == 1
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value(hostile)
        assert (studio.studio.workspace.folder / "sweep.toml").read_text("utf-8") == SWEEP


def test_news_of_the_server_leaves_a_refusal_on_the_page(browser, studio):
    with opened(browser, studio) as page:
        page.route("**/api/jobs/*", lambda route: None)  # the answers wait
        page.reload()
        page.evaluate("location.hash = '#study=!!'")
        refusal = page.get_by_role("alert").get_by_text("next step")
        refusal.wait_for()
        page.unroute("**/api/jobs/*")
        page.locator("summary", has_text="Runs").click()
        page.get_by_role("button", name="2. sweep", exact=True).click()
        page.wait_for_selector("[data-marks]")
        expect(refusal).to_be_visible()


def test_a_change_without_an_answer_is_reported(browser, studio):
    with opened(browser, studio) as page:
        before = page.locator(TEXT).input_value()
        page.evaluate("() => void (window.fetch = () => Promise.reject(new TypeError('gone')))")
        write(page, "Pitch with unit", "7.1 mm")
        page.get_by_text("The server does not answer, so nothing was changed").wait_for()
        expect(page.locator(TEXT)).to_have_value(before)


def options(page) -> list[str]:
    page.evaluate("() => new Promise(requestAnimationFrame)")  # the list follows the text
    return page.locator(".completions li").all_inner_texts()


def test_the_text_is_completed_from_the_declarations_and_keys_are_listed(browser, studio):
    with opened(browser, studio) as page:
        page.fill(TEXT, '[parameters]\nbase = "7 mm"\n\n[cell]\npitch = "6 mm"\n')
        page.locator("[id='key-cell.pitch']").wait_for()
        page.focus(TEXT)
        page.keyboard.press("Control+End")
        page.keyboard.press("Control+Space")
        assert any(option.startswith("thickness Plate thickness, required") for option in options(page))
        assert not any(option.startswith("pitch ") for option in options(page))  # the table has it
        page.keyboard.type("thick")
        assert len(options(page)) == 1
        page.keyboard.press("Enter")
        page.keyboard.type('"0.2*b')
        page.keyboard.press("Control+Space")
        assert options(page) == ['base parameter, "7 mm"']
        page.keyboard.press("Tab")
        page.keyboard.type('"\nlattice = ')
        page.keyboard.press("Control+Space")
        page.keyboard.press("ArrowDown")
        active = page.locator(f"#{page.get_attribute(TEXT, 'aria-activedescendant')}")
        expect(active).to_have_attribute("aria-selected", "true")
        chosen = active.locator("code").inner_text()
        assert violations(page) == []
        page.keyboard.press("Enter")
        page.keyboard.type("\n[[swe")
        page.keyboard.press("Control+Space")
        assert options(page)[0].startswith("[[sweep]] ")
        page.keyboard.press("Escape")
        assert options(page) == []
        page.keyboard.press("Control+Space")
        page.keyboard.press("Enter")
        page.keyboard.type("\nst")
        page.keyboard.press("Control+Space")
        assert options(page)[0].startswith("steps ")
        page.keyboard.press("Enter")
        assert text_of(page).endswith(f'thickness = "0.2*base"\nlattice = "{chosen}"\n[[sweep]]\nsteps = ')
        page.get_by_role("button", name="Undo").focus()
        page.keyboard.press("?")
        expect(page.get_by_role("dialog", name="Keys of the page")).to_be_visible()
        rows = page.get_by_role("dialog").get_by_role("row").all_inner_texts()
        assert {"Ctrl+Z", "Enter", "Ctrl+Space"} <= {row.split("\t")[0] for row in rows}
        page.keyboard.press("Escape")
        expect(page.get_by_role("dialog")).to_have_count(0)
