"""Two pages with one study: the second to save it decides about the text of the first."""

import pytest
from playwright.sync_api import Page, expect
from served import served
from test_page import CELL, TEXT, opened, text_of

from browser import violations

expect.set_options(timeout=30_000)


def save(page: Page) -> None:
    page.get_by_role("button", name="Save", exact=True).click()


@pytest.mark.parametrize("choice", ["name", "replace", "open"])
def test_a_file_that_another_page_has_saved_is_left_until_the_user_chooses(browser, tmp_path, choice):
    path = tmp_path / "cell.toml"
    path.write_text(CELL, "utf-8")
    with (
        served(tmp_path, "cell.toml") as studio,
        opened(browser, studio, complains=True) as mine,
        opened(browser, studio) as other,
    ):
        other.fill(TEXT, f"# other\n{CELL}")
        save(other)
        other.get_by_text("saved", exact=True).wait_for()
        mine.fill(TEXT, f"# mine\n{CELL}")
        save(mine)
        mine.get_by_role("alert").get_by_text("the file has changed since this page").wait_for()
        assert path.read_text("utf-8") == f"# other\n{CELL}"
        assert violations(mine) == []
        if choice == "name":
            mine.get_by_role("button", name="Choose another name").click()
            mine.keyboard.type("mine")
            mine.keyboard.press("Enter")
            mine.get_by_text("saved", exact=True).wait_for()
            assert (tmp_path / "mine.toml").read_text("utf-8") == f"# mine\n{CELL}"
            assert path.read_text("utf-8") == f"# other\n{CELL}"
        elif choice == "replace":
            mine.get_by_role("button", name="Replace cell.toml").click()
            mine.get_by_text("saved", exact=True).wait_for()
            assert path.read_text("utf-8") == f"# mine\n{CELL}"
        else:
            mine.once("dialog", lambda dialog: dialog.accept())
            mine.get_by_role("button", name="Open cell.toml in place of this text").click()
            expect(mine.locator(TEXT)).to_have_value(f"# other\n{CELL}")
            mine.get_by_role("button", name="Undo").click()
            assert text_of(mine) == f"# mine\n{CELL}"
        expect(mine.get_by_role("alert")).to_have_count(0)
