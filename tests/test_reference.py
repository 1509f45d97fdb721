"""The pages of public names agree with the sources, and the site has every page."""

from __future__ import annotations

import re
import sys
from importlib import import_module
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"
sys.path.insert(0, str(DOCS))
write_reference = import_module("write_reference")


PAGES = write_reference.pages()


def test_the_written_pages_are_those_of_these_sources():
    assert set(PAGES) == {write_reference.PAGE, write_reference.METHODS, *write_reference.API.glob("*.md")}
    differ = [path.name for path, text in PAGES.items() if path.read_text("utf-8") != text]
    assert differ == [], "run docs/write_reference.py"


def test_every_public_name_has_a_signature_and_a_meaning():
    entries = [
        entry.partition("\n")[::2]
        for path, text in PAGES.items()
        if path.parent == write_reference.API
        for entry in re.split(r"^## ", text, flags=re.MULTILINE)[1:]
    ]
    assert len(entries) > 300
    assert [name for name, text in entries if not text.strip()] == []
    signed = [text for _, text in entries if text.strip().startswith("```python")]
    assert len(signed) > 200
    assert [text for text in signed if not text.split("```")[2].strip()] == []


def test_a_signature_has_plain_types_and_a_long_one_a_parameter_on_each_line():
    def measure(path: str, *, unit: float | None = None) -> dict[str, float]: ...

    assert write_reference.annotation("Annotated[float, size(1, 2)] | None") == "float | None"
    short = "measure(path: str, *, unit: float | None = None) -> dict[str, float]"
    assert write_reference.signature("measure", measure) == short
    assert write_reference.signature("measure_at_many_places", measure).count("\n") == 4


def test_a_list_of_names_in_a_docstring_becomes_a_list():
    assert write_reference.paragraph("low, high : edges, Hz; at : place\n    of both, m") == [
        "- `low, high`: edges, Hz",
        "- `at`: place of both, m",
    ]


def test_every_public_name_is_there():
    packages = [import_module(package) for package in write_reference.packages()]
    absent = [(each.__name__, name) for each in packages for name in each.__all__ if not hasattr(each, name)]
    assert absent == []


def test_the_site_has_every_page():
    listed = set(re.findall(r"^([a-z-]+)$", (DOCS / "index.md").read_text("utf-8"), re.MULTILINE))
    assert listed == {page.stem for page in DOCS.glob("*.md")} - {"index"}
