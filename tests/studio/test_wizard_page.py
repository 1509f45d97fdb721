"""The wizard for measured files in a real browser: dropped or chosen, understood, corrected, computed."""

import base64
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect
from served import Served, served
from test_page import opened

from browser import faults_of_layout
from haptonic.study import templates

expect.set_options(timeout=30_000)
CASES = Path(__file__).parents[1] / "data/cases"
SCAN = CASES / "scan-plain-hdf5/scan.h5"
DROP = """([name, coded]) => {
  const bytes = Uint8Array.from(atob(coded), (letter) => letter.charCodeAt(0));
  const dropped = new DataTransfer();
  dropped.items.add(new File([bytes], name));
  for (const kind of ["dragover", "drop"])
    document.body.dispatchEvent(
      new DragEvent(kind, { dataTransfer: dropped, bubbles: true, cancelable: true }),
    );
}"""


@pytest.fixture(scope="module")
def studio(tmp_path_factory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("wizard")
    (folder / "cell.toml").write_text(str(templates()["bare-cell"]), "utf-8")
    shutil.copytree(CASES / "scan-names-of-other-languages", folder / "german")
    shutil.copytree(CASES / "friction-names-f-x", folder / "trials")
    with served(folder, "cell.toml") as running:
        yield running


def drop(page: Page, name: str, content: bytes) -> None:
    page.evaluate(DROP, [name, base64.b64encode(content).decode()])


def answer(page: Page, question: str, value: str) -> None:
    page.get_by_label(question, exact=True).fill(value)
    page.keyboard.press("Tab")


def tab_to(page: Page, locator: Locator) -> None:
    """Press the tabulator until an element has the focus."""
    for _ in range(6):
        page.keyboard.press("Tab")
        if locator.evaluate("element => element === document.activeElement"):
            return
    raise AssertionError("the tabulator does not reach it")


def row(page: Page, title: str) -> Locator:
    """The answer beside a title in the table of how the files were read."""
    return (
        page.locator(".understood tr", has=page.get_by_role("cell", name=title, exact=True))
        .locator("td")
        .nth(1)
    )


def test_a_dropped_scan_is_shown_and_a_wrong_unit_is_refused_at_its_question(browser: Browser, studio):
    with opened(browser, studio) as page:
        drop(page, "dropped.h5", SCAN.read_bytes())
        expect(page.get_by_label("Analysis")).to_have_value("scan")
        expect(page.get_by_role("combobox", name="path")).to_have_value("dropped.h5")
        plan = page.get_by_role("img", name=re.compile("^9 points: x from 0 to 50 mm, y from 0 to 30 mm"))
        plan.wait_for()
        expect(row(page, "frequencies")).to_have_text("30, 40 to 60 kHz")
        page.get_by_text("the file gives no unit of the responses: m/s/V was used").wait_for()
        compute = page.get_by_role("button", name="Compute scan")
        expect(compute).to_be_enabled()
        answer(page, "length unit", "kg")
        question = page.get_by_label("length unit", exact=True)
        expect(question).to_have_attribute("aria-invalid", "true")
        refusal = page.locator(".field.wrong .refusal")
        for part in ("allowed", "likely cause", "next step", '"kg" is not a unit of length'):
            expect(refusal).to_contain_text(part)
        expect(compute).to_be_disabled()
        page.get_by_role("link", name="Go to the question: length unit").click()
        expect(question).to_be_focused()
        answer(page, "length unit", "mm")
        page.get_by_role("img", name=re.compile("x from 0 to 0.05 mm")).wait_for()
        expect(compute).to_be_enabled()


def test_wrong_columns_are_corrected_and_the_scan_is_computed_without_a_study(browser: Browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label("Analysis").select_option("scan")
        page.get_by_role("combobox", name="path").select_option("german")
        page.get_by_role("link", name="Go to the question: variables").wait_for()
        expect(page.locator(".field.wrong .refusal")).to_contain_text("Realteil")
        answer(page, "variables", "frequency=Frequenz,real=Realteil,imaginary=Wrong")
        expect(page.locator(".field.wrong .refusal")).to_contain_text("variables.imaginary")
        answer(page, "variables", "frequency=Frequenz,real=Realteil,imaginary=Imaginärteil")
        expect(row(page, "points")).to_have_text("9, in 3 columns and 3 rows")
        page.get_by_role("button", name="Compute scan").click()
        page.locator("#result").get_by_text("9 points (none flagged)").first.wait_for(timeout=90_000)
        page.get_by_text("haptonic scan german --html --variables").wait_for()
        page.get_by_text("""named("scan").run(None""").wait_for()
        assert page.get_by_text("belongs to another version").count() == 0


def test_files_are_chosen_and_computed_by_the_keyboard(browser: Browser, studio):
    with opened(browser, studio) as page:
        select = page.get_by_label("Analysis")
        select.focus()
        page.keyboard.type("friction")
        expect(select).to_have_value("friction")
        for locator in (
            page.get_by_role("button", name="Choose files"),
            page.get_by_role("combobox", name="path"),
        ):
            tab_to(page, locator)
        page.keyboard.type("trials")
        expect(page.get_by_role("combobox", name="path")).to_have_value("trials")
        expect(row(page, "normal channel")).to_have_text('"F_z", 1 unit = 1 N')
        page.wait_for_selector(".understood .curves canvas")
        compute = page.get_by_role("button", name="Compute friction")
        expect(compute).to_be_enabled()
        compute.focus()
        page.keyboard.press("Enter")
        page.locator("#result").get_by_text("haptonic friction trials --html").wait_for(timeout=90_000)


def test_several_files_get_a_folder_and_none_is_replaced_without_a_question(browser: Browser, studio):
    folder = studio.studio.workspace.folder / "mine"
    files = sorted(str(path) for path in (CASES / "friction-names-f-x").iterdir())
    context = browser.new_context()  # the browser reports the refusal on its console
    context.add_cookies(
        [{"name": (pair := studio.cookie.split("=", 1))[0], "value": pair[1], "url": studio.origin}]
    )
    page = context.new_page()
    page.goto(f"{studio.origin}/")
    page.get_by_label("Analysis").select_option("friction")
    for is_first in (True, False):
        page.set_input_files("input[data-choose=files]", files)
        page.get_by_label("Folder for 3 files").fill("mine")
        page.get_by_role("button", name="Add", exact=True).click()
        page.get_by_text("Added mine." if is_first else "In the folder already").wait_for()
        if is_first:
            assert sorted(path.name for path in folder.iterdir()) == ["off.csv", "on.csv", "trials.csv"]
            (folder / "on.csv").write_text("edited")
    assert (folder / "on.csv").read_text() == "edited"
    page.get_by_role("button", name="Replace").click()
    page.get_by_text("Added mine.").wait_for()
    assert (folder / "on.csv").read_text() != "edited"
    expect(page.get_by_role("combobox", name="path")).to_have_value("mine")
    context.close()


def test_settings_of_the_study_are_opened_in_the_form(browser: Browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label("Analysis").select_option("friction")
        page.get_by_label("with the settings of the study of this page").check()
        page.get_by_role("button", name="Open the table trials in the form").click()
        page.get_by_label("Threshold", exact=False).first.wait_for()


def test_a_refused_channel_leads_to_its_table_in_the_form(browser: Browser, studio):
    shutil.copytree(CASES / "friction-without-names", studio.studio.workspace.folder / "unnamed")
    with opened(browser, studio) as page:
        page.get_by_label("Analysis").select_option("friction")
        page.get_by_role("combobox", name="path").select_option("unnamed")
        page.get_by_role("button", name="Open the table trials.sensor in the form").click()
        for label, column in (("Time", "1"), ("Normal", "4"), ("Tangential", "3")):
            name = page.get_by_label(label, exact=False).first
            name.fill(column)
            name.press("Tab")
        expect(row(page, "normal channel")).to_have_text('"4", 1 unit = 1 N')


def test_the_wizard_is_accessible_and_fits(browser: Browser, studio):
    with opened(browser, studio) as page:
        page.get_by_label("Analysis").select_option("scan")
        page.get_by_role("combobox", name="path").select_option("german")
        page.locator(".field.wrong .refusal").wait_for()
        answer(page, "variables", "frequency=Frequenz,real=Realteil,imaginary=Imaginärteil")
        page.wait_for_selector(".reading .points")
        assert faults_of_layout(page) == []
