"""Plain English in pages and help texts, as far as it can be counted; see docs/writing.md."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of
from haptonic.fields.keys import table
from haptonic.study import Study

ROOT = Path(__file__).parents[1]
GENERATED = {"reference.md", "verification.md"}
TABLE_OF_WORDS = "writing.md"  # it lists the banned words
PAGES = {
    path.name: path.read_text("utf-8")
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    if path.name not in GENERATED
}
DEVELOPERS = {
    "benchmarks.md",
    "analyses.md",
    "architecture.md",
    "channels.md",
    "meshes.md",
    "plates.md",
    "robustness.md",
}
LONGEST_PARAGRAPH = 90  # words
WIDEST_CODE = 80  # columns

OPENINGS = re.compile(r"(?:^|(?<=[.!?] ))(?:Of the|Of a|Out come|Checked are|Else|And along)\b")
HELP_OPENINGS = re.compile(r"^(?:Of|Else|And|Its|Also along)\b")
WORDS = re.compile(
    r"\b(?:tells?|told|stands?|stood|made[ -]up|fad(?:e|es|ed|ing)|foreseen?|foresees|foresaw|bears?|"
    r"rungs?|ladders?|traction|to and fro|aloud|doubted|says?|said)\b",
    re.IGNORECASE,
)


def prose(page: str) -> str:
    """A page without code, tables, pictures, headings of notebooks and targets of links."""
    text = re.sub(r"\A---\n.*?\n---\n", "", page, flags=re.DOTALL)
    text = re.sub(r"^(`{3,}).*?^\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"^(?:\||:::|!\[).*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    return re.sub(r"`[^`]*`", "CODE", text)


def paragraphs(page: str) -> list[str]:
    """Paragraphs and items of lists, each in one line."""
    blocks = re.split(r"\n\s*\n|\n(?=[-*] |\d+\. )", prose(page))
    return [" ".join(block.split()) for block in blocks if block.strip() and not block.startswith("#")]


def dialect(text: str) -> list[str]:
    """Banned openings and words of a text."""
    return [match[0] for pattern in (OPENINGS, WORDS) for match in pattern.finditer(text)]


def help_texts() -> dict[str, str]:
    """Help of commands, options and keys, by the name of each."""
    texts = dict(NAMES)
    for name in NAMES:
        for field in named(name).options.__dataclass_fields__.values():
            if known := option_of(field):
                texts[f"{name} {field.name}"] = known.help
    return texts | {path: key.description for path, key in table(Study).items()}


@pytest.mark.parametrize("name", [name for name in PAGES if name != TABLE_OF_WORDS])
def test_a_page_has_no_banned_opening_or_word(name):
    found = {paragraph: words for paragraph in paragraphs(PAGES[name]) if (words := dialect(paragraph))}
    assert found == {}


@pytest.mark.parametrize("name", PAGES)
def test_a_paragraph_is_short(name):
    assert [text for text in paragraphs(PAGES[name]) if len(text.split()) > LONGEST_PARAGRAPH] == []


@pytest.mark.parametrize("name", PAGES)
def test_code_fits_its_box(name):
    code = re.findall(r"^```[^\n]*\n(?:---\n.*?---\n)?(.*?)^```$", PAGES[name], re.DOTALL | re.MULTILINE)
    lines = [line for block in code for line in block.splitlines()]
    assert [line for line in lines if len(line) > WIDEST_CODE] == []


@pytest.mark.parametrize("name", sorted(PAGES.keys() - DEVELOPERS - {"writing.md", "README.md"}))
def test_a_page_for_users_names_no_test_and_no_module_file(name):
    assert re.findall(r"`tests/[^`]*`|`\w+/\w+\.py`", PAGES[name]) == []


def test_a_help_text_can_be_read_alone():
    texts = help_texts()
    assert len(texts) > 400
    assert {name: text for name, text in texts.items() if HELP_OPENINGS.match(text)} == {}
    assert {name: words for name, text in texts.items() if (words := dialect(text))} == {}


def test_banned_words_are_found_in_prose_and_not_in_code():
    page = "An edge is told. Of the two, one fades.\n\n```sh\ntold\n```\n\n| told |\n\n![told](told.png)\n"
    assert paragraphs(page) == ["An edge is told. Of the two, one fades."]
    assert dialect(paragraphs(page)[0]) == ["Of the", "told", "fades"]
    assert dialect("the holder of `CODE` withstands an outstanding load") == []
