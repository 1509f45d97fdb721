"""Templates of study files, with their purpose and their commands."""

from __future__ import annotations

import re
from importlib.resources import files
from itertools import takewhile
from pathlib import Path

ENDING = ".toml"  # ending of a study file
COMMAND = re.compile(r"^#   (haptonic .*?)(  |$)")  # a command in the heading of a template


class Template(str):
    """Text of a study file with a heading in comments: its purpose and its commands."""

    __slots__ = ()

    @property
    def heading(self) -> list[str]:
        """Comments before the first key."""
        return list(takewhile(lambda line: line.startswith("#"), self.splitlines()))

    @property
    def about(self) -> str:
        """Purpose of the study: the heading down to its first command."""
        lines = takewhile(lambda line: not COMMAND.match(line), self.heading)
        return " ".join(line.removeprefix("#").strip() for line in lines)

    @property
    def commands(self) -> list[str]:
        """Commands for the study, in the order of the heading."""
        return [match[1].strip() for line in self.heading if (match := COMMAND.match(line))]

    def adapted(self, path: Path) -> Template:
        """The template with the name of a file in its commands, and their purposes in an aligned column."""
        name = f'"{path}"' if " " in str(path) else str(path)
        matches = {line: match for line in self.heading if (match := COMMAND.match(line))}
        asked = {line: re.sub(r"\bFILE\b", lambda _: name, match[1]) for line, match in matches.items()}
        width, text = max(map(len, asked.values()), default=0), str(self)
        for line, match in matches.items():
            text = text.replace(
                line, f"#   {asked[line]:{width}}   {line[match.end() :].strip()}".rstrip(), 1
            )
        return Template(text)


def templates() -> dict[str, Template]:
    """All templates by name, the shortest first."""
    return _in_folder("templates")


def case_templates() -> dict[str, Template]:
    """Studies of the cases of `haptonic verify` by name, the shortest first."""
    return _in_folder("verification", "studies")


def _in_folder(*folder: str) -> dict[str, Template]:
    named = {
        file.name.removesuffix(ENDING).replace("_", "-"): Template(file.read_text("utf-8"))
        for file in files("haptonic").joinpath(*folder).iterdir()
    }
    return dict(sorted(named.items(), key=lambda pair: pair[1].count("\n")))
