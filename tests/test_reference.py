"""The page of public names says what the sources do, and the site has every page."""

from __future__ import annotations

import re
import sys
from importlib import import_module
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"
sys.path.insert(0, str(DOCS))
write_reference = import_module("write_reference")


@pytest.mark.parametrize(("path", "made"), [("PAGE", "reference"), ("METHODS", "methods")])
def test_what_is_written_is_that_of_these_sources(path, made):
    written = getattr(write_reference, path).read_text("utf-8")
    assert written == getattr(write_reference, made)(), "run docs/write_reference.py"


def test_every_public_name_says_what_it_is():
    rows = re.findall(r"^\| `(\w+)` \| (.*?) \|$", write_reference.reference(), re.MULTILINE)
    assert len(rows) > 100
    assert [name for name, text in rows if not text.strip()] == []


@pytest.mark.parametrize("package", write_reference.packages())
def test_every_public_name_is_there(package):
    for name in import_module(package).__all__:
        assert hasattr(import_module(package), name), name


def test_the_site_has_every_page():
    listed = set(re.findall(r"^([a-z-]+)$", (DOCS / "index.md").read_text("utf-8"), re.MULTILINE))
    assert listed == {page.stem for page in DOCS.glob("*.md")} - {"index"}
