"""Plain English in pages, help texts and sources, as far as it can be counted; see docs/writing.md."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of
from haptonic.fields.keys import table
from haptonic.study import Study
from sources import tree_of

ROOT = Path(__file__).parents[1]
TABLE_OF_WORDS = "writing.md"  # it lists the banned words
TOP = sorted(ROOT.glob("*.md"))
PAGES = {path.name: path.read_text("utf-8") for path in [*TOP, *sorted((ROOT / "docs").glob("*.md"))]}
DEVELOPERS = {
    "benchmarks.md",
    "reference.md",
    "verification.md",
    "analyses.md",
    "architecture.md",
    "channels.md",
    "meshes.md",
    "plates.md",
    "robustness.md",
}
SOURCE = ROOT / "src" / "haptonic"
# docstrings, comments and messages of all packages are checked; the programs of the pages are minified
SOURCES = {
    str(path.relative_to(SOURCE)): path
    for path in sorted(SOURCE.glob("**/*.*"))
    if path.suffix in {".py", ".pyi", ".toml", ".html"} and SOURCE / "views" / "bundle" not in path.parents
}
SCRIPTS = {
    str(path.relative_to(ROOT)): path
    for folder in ("tests", "benchmarks", "docs")
    for path in sorted((ROOT / folder).glob("**/*.py"))
    if path.name not in {"test_prose.py", "test_vocabulary.py"}  # they list the banned words
}
VAGUE_NAMES = {"one", "found", "made", "said", "told"}  # of variables and parameters
LONGEST_PARAGRAPH = 90  # words
WIDEST_CODE = 80  # columns

OPENINGS = re.compile(r"(?:^|(?<=[.!?] ))(?:Of the|Of a|Out come|Checked are|Else|And along)\b")
HELP_OPENINGS = re.compile(r"^(?:Of|Else|And|Its|Also along)\b")
WORDS = re.compile(
    r"\b(?:tells?|told|stands?|stood|made[ -]up|fad(?:e|es|ed|ing)|foreseen?|foresees|foresaw|bears?|"
    r"rungs?|ladders?|traction|to and fro|aloud|doubted|says?|said|lets? (?:[^\s.;:]+ ){0,5}through)\b",
    re.IGNORECASE,
)


def prose(page: str) -> str:
    """A page without code, tables, pictures, headings of notebooks and targets of links."""
    text = re.sub(r"\A---\n.*?\n---\n", "", page, flags=re.DOTALL)
    text = re.sub(r"^(`{3,}).*?^\1$", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"^(?:\||:::|!\[).*$", "", text, flags=re.MULTILINE)
    text = re.sub(r"\]\([^)]*\)", "]", text)
    return re.sub(r"`[^`]*`", "CODE", text)


def cells(page: str) -> list[str]:
    """Cells of tables and alternative texts of pictures, those of code cells too."""
    text = re.sub(r"`[^`\n]*`", "CODE", page)
    rows = re.findall(r"^\|(.*)\|\s*$", text, re.MULTILINE)
    parts = [cell.strip() for row in rows for cell in re.split(r"(?<!\\)\|", row)]
    pictures = re.findall(r"!\[([^\]]*)\]\(|^ *:?alt: (.*)$", text, re.MULTILINE)
    words = [*parts, *(picture or alternative for picture, alternative in pictures)]
    return [" ".join(each.split()) for each in words if re.search(r"[a-z]", each)]


def paragraphs(page: str) -> list[str]:
    """Paragraphs and items of lists, each in one line."""
    blocks = re.split(r"\n\s*\n|\n(?=[-*] |\d+\. )", prose(page))
    return [" ".join(block.split()) for block in blocks if block.strip() and not block.startswith("#")]


def dialect(text: str) -> list[str]:
    """Banned openings and words of a text."""
    return [match[0] for pattern in (OPENINGS, WORDS) for match in pattern.finditer(text)]


def source_texts(path: Path) -> Iterator[str]:
    """Docstrings, comments and messages of a module; comments of a TOML file; the text of a page."""
    text = path.read_text("utf-8")
    if path.suffix == ".toml":
        yield from (line.partition("#")[2] for line in text.splitlines())
    elif path.suffix == ".html":
        yield re.sub(r"<style>.*?</style>|<[^>]*>", " ", text, flags=re.DOTALL)
    else:
        tokens = tokenize.generate_tokens(io.StringIO(text).readline)
        yield from (token.string.lstrip("# ") for token in tokens if token.type == tokenize.COMMENT)
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value.strip():
                yield node.value


def dialect_of_source(path: Path) -> dict[str, list[str]]:
    """Banned words by text of a source file; names in backticks do not count."""
    texts = (" ".join(re.sub(r"`[^`]*`", "CODE", text).split()) for text in source_texts(path))
    words = {text: dialect(text) for text in texts}
    return {text: banned for text, banned in words.items() if banned}


def vague_names(tree: ast.AST) -> set[str]:
    """Names of variables and parameters that name no content; fields of classes do not count."""
    classes = [node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
    fields = {id(node.target) for kind in classes for node in kind.body if isinstance(node, ast.AnnAssign)}
    variables = {
        node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and id(node) not in fields
    }
    parameters = {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    return (variables | parameters) & VAGUE_NAMES


def help_texts() -> dict[str, str]:
    """Help of commands, options and keys, by the name of each."""
    texts = dict(NAMES)
    for name in NAMES:
        for field in named(name).options.__dataclass_fields__.values():
            if known := option_of(field):
                texts[f"{name} {field.name}"] = known.help
    return texts | {path: key.description for path, key in table(Study).items()}


def test_pages_have_no_banned_opening_or_word():
    banned = [
        (name, words, text)
        for name, page in PAGES.items()
        if name != TABLE_OF_WORDS
        for text in [*paragraphs(page), *cells(page)]
        if (words := dialect(text))
    ]
    assert banned == []


def test_all_pages_and_packages_are_checked():
    assert {"README.md", "CHANGELOG.md", "SECURITY.md", "CONTRIBUTING.md", "method.md"} <= PAGES.keys()
    packages = {path.parent.name for path in SOURCE.glob("*/__init__.py")}
    assert packages <= {name.partition("/")[0] for name in SOURCES}
    assert {"studio", "views", "plots"} <= packages
    assert not any("bundle" in name for name in SOURCES)


def test_paragraphs_are_short():
    texts = [(name, text) for name, page in PAGES.items() for text in paragraphs(page)]
    assert [(name, text) for name, text in texts if len(text.split()) > LONGEST_PARAGRAPH] == []


def test_code_fits_its_box():
    wide = [
        (name, line)
        for name, page in PAGES.items()
        for block in re.findall(r"^```[^\n]*\n(?:---\n.*?---\n)?(.*?)^```$", page, re.DOTALL | re.MULTILINE)
        for line in block.splitlines()
        if len(line) > WIDEST_CODE
    ]
    assert wide == []


def test_pages_for_users_name_no_test_and_no_module_file():
    names = sorted(PAGES.keys() - DEVELOPERS - {TABLE_OF_WORDS, *(path.name for path in TOP)})
    files = {name: re.findall(r"`tests/[^`]*`|`\w+/\w+\.py`", PAGES[name]) for name in names}
    assert {name: listed for name, listed in files.items() if listed} == {}


def test_a_help_text_can_be_read_alone():
    texts = help_texts()
    assert len(texts) > 400
    assert {name: text for name, text in texts.items() if HELP_OPENINGS.match(text)} == {}
    assert {name: words for name, text in texts.items() if (words := dialect(text))} == {}


def test_docstrings_comments_and_messages_have_no_banned_opening_or_word():
    banned = {name: dialect_of_source(path) for name, path in (SOURCES | SCRIPTS).items()}
    assert {name: texts for name, texts in banned.items() if texts} == {}


def test_names_of_tests_have_no_banned_word():
    """The words of a name, which underscores join, are checked like those of a text."""
    names = [
        (str(path.relative_to(ROOT)), name)
        for path in sorted((ROOT / "tests").glob("**/*.py"))
        for name in re.findall(r"^ *def (test_\w+)", path.read_text("utf-8"), re.MULTILINE)
    ]
    assert len(names) > 1000
    assert [(path, name) for path, name in names if dialect(name.replace("_", " "))] == []
    assert dialect("test_an_edge_is_told".replace("_", " ")) == ["told"]


def test_variables_are_named_after_their_content():
    modules = {name: path for name, path in (SOURCES | SCRIPTS).items() if path.suffix == ".py"}
    vague = {name: vague_names(tree_of(path)) for name, path in modules.items()}
    assert {name: names for name, names in vague.items() if names} == {}


def test_banned_words_of_a_module_are_found_in_its_texts_and_not_in_its_keys(tmp_path):
    module = tmp_path / "module.py"
    module.write_text(
        '"""An edge is told. `told` is a key."""\n# nobody says it\ntold = f"{0}: it stands there"\n'
        'key = "said"\ndef f(one): ...\n'
    )
    banned = {word for words in dialect_of_source(module).values() for word in words}
    assert banned == {"told", "says", "stands"}
    assert vague_names(ast.parse(module.read_text())) == {"told", "one"}


def test_a_percentage_has_one_spelling():
    """`5 %`, by `haptonic.units.in_percent`: neither `5%` nor the format of Python, which writes that."""
    wrong = re.compile(r"\d%(?![\w;%])|\{[^{}]*:[^{}]*%\}")
    sources = {name: path for name, path in SOURCES.items() if path.suffix == ".py"}
    assert {name: wrong.findall(path.read_text("utf-8")) for name, path in sources.items()
            if wrong.search(path.read_text("utf-8"))} == {}  # fmt: skip
    assert {name: text for name, text in help_texts().items() if wrong.search(text)} == {}
    assert [wrong.search(text) is None for text in ('f"{x:.1%}"', "is 5%.", "is 5 %", "7 % 3")] == [
        False, False, True, True,
    ]  # fmt: skip


def test_banned_words_are_found_in_prose_and_not_in_code():
    page = "An edge is told. Of the two, one fades.\n\n```sh\ntold\n```\n\n| told |\n\n![told](told.png)\n"
    assert paragraphs(page) == ["An edge is told. Of the two, one fades."]
    assert dialect(paragraphs(page)[0]) == ["Of the", "told", "fades"]
    assert cells(page) == ["told", "told"]
    assert cells("---\nimage:\n  alt: It fades.\n---\n\n| it | a `told` \\| b |\n|---|---|\n") == [
        "it", "a CODE \\| b", "It fades.",
    ]  # fmt: skip
    assert dialect("rows let the wave through; it lets through -18 dB") == [
        "let the wave through",
        "lets through",
    ]
    assert dialect("let it go. It runs through") == []
    assert dialect("the holder of `CODE` withstands an outstanding load") == []
