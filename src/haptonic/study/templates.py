"""Study files to begin with: what they are for, and what can be asked of them."""

from __future__ import annotations

import re
from importlib.resources import files
from itertools import takewhile
from pathlib import Path

ENDING = ".toml"
COMMAND = re.compile(r"^#   (haptonic .*?)(  |$)")  # in the comments that head a template


def templates() -> dict[str, str]:
    """Text of every template by its name, the simplest first."""
    folder = files("haptonic").joinpath("templates")
    found = {
        one.name.removesuffix(ENDING).replace("_", "-"): one.read_text("utf-8") for one in folder.iterdir()
    }
    return dict(sorted(found.items(), key=lambda pair: pair[1].count("\n")))


def heading(text: str) -> list[str]:
    """The comments before the first key."""
    return list(takewhile(lambda line: line.startswith("#"), text.splitlines()))


def about(text: str) -> str:
    """What a template is for: the heading down to its first command."""
    lines = takewhile(lambda line: not COMMAND.match(line), heading(text))
    return " ".join(line.removeprefix("#").strip() for line in lines)


def commands(text: str) -> list[str]:
    """What can be asked of a template, in the order of its heading."""
    return [found[1].strip() for line in heading(text) if (found := COMMAND.match(line))]


def adapted(text: str, path: Path) -> str:
    """With the file's own name in the commands of the heading, and what they do in a column behind them."""
    name = f'"{path}"' if " " in str(path) else str(path)
    found = {line: match for line in heading(text) if (match := COMMAND.match(line))}
    asked = {line: re.sub(r"\bFILE\b", lambda _: name, match[1]) for line, match in found.items()}
    width = max(map(len, asked.values()), default=0)
    for line, match in found.items():
        text = text.replace(line, f"#   {asked[line]:{width}}   {line[match.end() :].strip()}".rstrip(), 1)
    return text
