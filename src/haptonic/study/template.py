"""Study files to begin with: what they are for, and what can be asked of them."""

from __future__ import annotations

import re
from importlib.resources import files
from itertools import takewhile
from pathlib import Path

ENDING = ".toml"  # of a study file
COMMAND = re.compile(r"^#   (haptonic .*?)(  |$)")  # in the comments that head a template


class Template(str):
    """Text of a study file, with comments at its head that say what it is for and how it is asked."""

    __slots__ = ()

    @property
    def heading(self) -> list[str]:
        """The comments before the first key."""
        return list(takewhile(lambda line: line.startswith("#"), self.splitlines()))

    @property
    def about(self) -> str:
        """What it is for: the heading down to its first command."""
        lines = takewhile(lambda line: not COMMAND.match(line), self.heading)
        return " ".join(line.removeprefix("#").strip() for line in lines)

    @property
    def commands(self) -> list[str]:
        """What can be asked of it, in the order of its heading."""
        return [found[1].strip() for line in self.heading if (found := COMMAND.match(line))]

    def adapted(self, path: Path) -> Template:
        """With the file's own name in the commands, and what they do in a column behind them."""
        name = f'"{path}"' if " " in str(path) else str(path)
        found = {line: match for line in self.heading if (match := COMMAND.match(line))}
        asked = {line: re.sub(r"\bFILE\b", lambda _: name, match[1]) for line, match in found.items()}
        width, text = max(map(len, asked.values()), default=0), str(self)
        for line, match in found.items():
            text = text.replace(
                line, f"#   {asked[line]:{width}}   {line[match.end() :].strip()}".rstrip(), 1
            )
        return Template(text)


def templates() -> dict[str, Template]:
    """Every template by its name, the simplest first."""
    return _in_folder("templates")


def case_templates() -> dict[str, Template]:
    """The studies of the cases of `haptonic verify` by their names, the simplest first."""
    return _in_folder("verification", "studies")


def _in_folder(*folder: str) -> dict[str, Template]:
    named = {
        file.name.removesuffix(ENDING).replace("_", "-"): Template(file.read_text("utf-8"))
        for file in files("haptonic").joinpath(*folder).iterdir()
    }
    return dict(sorted(named.items(), key=lambda pair: pair[1].count("\n")))
