"""The reference study and one that gives every key, for tests that change a line of them."""

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def reference_path() -> Path:
    return ROOT / "studies" / "touchpad.toml"


@pytest.fixture(scope="session")
def reference_text(reference_path) -> str:
    return reference_path.read_text("utf-8")


@pytest.fixture(scope="session")
def every_key_text() -> str:
    return (ROOT / "tests" / "data" / "every_key.toml").read_text("utf-8")


@pytest.fixture
def edited(reference_text):
    """The reference study with texts replaced; each of them has to occur in it."""

    def edit(*changes: tuple[str, str]) -> str:
        text = reference_text
        for old, new in changes:
            assert old in text, old
            text = text.replace(old, new, 1)
        return text

    return edit
