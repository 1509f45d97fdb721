"""Files that are dropped on the page: each is opened, chosen, explained or refused."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import expect
from served import Served, served
from test_page import CELL, TEXT, opened
from test_wizard_page import SCAN, drop

expect.set_options(timeout=30_000)


@pytest.fixture
def studio(tmp_path) -> Iterator[Served]:
    (tmp_path / "cell.toml").write_text(CELL, "utf-8")
    with served(tmp_path, "cell.toml") as running:
        yield running


def names_in(studio: Served) -> list[str]:
    return sorted(path.name for path in studio.studio.workspace.folder.iterdir())


def test_a_dropped_study_is_opened_with_care_for_unsaved_text(browser, studio):
    other = CELL.replace("6 mm", "7 mm")
    with opened(browser, studio, complains=True) as page:
        drop(page, "other.toml", other.encode())
        expect(page.locator(TEXT)).to_have_value(other)
        expect(page.get_by_label("File name")).to_have_value("other.toml")
        expect(page.get_by_label("Analysis")).to_have_value("bands")
        page.fill(TEXT, "# mine")
        questions = []
        page.once("dialog", lambda dialog: (questions.append(dialog.message), dialog.dismiss()))
        drop(page, "third.toml", CELL.encode())
        page.get_by_text("Added third.toml.").wait_for()
        page.wait_for_timeout(200)
        expect(page.locator(TEXT)).to_have_value("# mine")
        assert "not saved" in questions[0]
        page.on("dialog", lambda dialog: dialog.accept())
        drop(page, "other.toml", CELL.encode())
        page.get_by_role("button", name="Replace").click()
        expect(page.locator(TEXT)).to_have_value(CELL)
        page.get_by_role("button", name="Undo").click()
        expect(page.locator(TEXT)).to_have_value("# mine")
        assert names_in(studio) == ["cell.toml", "other.toml", "third.toml"]


def test_a_dropped_solid_is_kept_and_a_useless_file_is_refused(browser, studio):
    with opened(browser, studio, complains=True) as page:
        drop(page, "cell.step", b"ISO-10303-21;")
        page.get_by_role("alert").get_by_text('file = "cell.step" in its table [cell.solid]').wait_for()
        drop(page, "picture.png", b"\x89PNG")
        page.get_by_role("alert").get_by_text("reads this format").wait_for()
        expect(page.get_by_text("Added")).to_have_count(0)
        expect(page.get_by_label("Analysis")).to_have_value("bands")
        assert names_in(studio) == ["cell.step", "cell.toml"]


def test_a_refused_name_is_explained(browser, studio):
    with opened(browser, studio, complains=True) as page:
        drop(page, "../evil.csv", b"x")
        page.get_by_role("alert").get_by_text("a step upwards").wait_for()
        assert names_in(studio) == ["cell.toml"]


def test_a_folder_is_added_without_the_files_that_nothing_reads(browser, studio, tmp_path_factory):
    folder = tmp_path_factory.mktemp("outside") / "measured"
    folder.mkdir()
    for name, content in (("notes.docx", b"PK"), ("photo.png", b"\x89PNG"), ("scan.h5", SCAN.read_bytes())):
        (folder / name).write_bytes(content)
    with opened(browser, studio, complains=True) as page:
        page.get_by_label("Analysis").select_option("scan")
        page.set_input_files("input[data-choose=folder]", folder)
        page.get_by_text("Added measured. Left out, because nothing reads them: ").wait_for()
        received = studio.studio.workspace.folder / "measured"
        assert [path.name for path in received.iterdir()] == ["scan.h5"]
        expect(page.get_by_role("combobox", name="path")).to_have_value("measured")
        page.get_by_role("button", name="Compute scan").wait_for()


def test_results_are_explained_where_a_scan_was_expected(browser, studio):
    (studio.studio.workspace.folder / "bands.nc").write_bytes(b"no scan")
    with opened(browser, studio, complains=True) as page:
        page.get_by_label("Analysis").select_option("scan")
        page.get_by_role("combobox", name="path").select_option("bands.nc")
        page.get_by_text("are chosen in the analysis compare").wait_for()
