"""``haptonic new``: write a study file from a template."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated

import typer

from haptonic.atomic import write_atomically
from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.listing import pairs
from haptonic.errors import StudyError, nearest, shown
from haptonic.paths import target
from haptonic.study import ENDING, Template, case_templates, templates

USUAL = "bare-cell"


def complete(incomplete: str) -> list[str]:
    """Names of templates and cases that begin with the typed text, for the completion of a shell."""
    return [name for name in templates() | case_templates() if name.startswith(incomplete)]


First = Annotated[
    str | None,
    typer.Argument(
        metavar="TEMPLATE",
        help=f"The template; {USUAL} if left out.",
        autocompletion=complete,
        show_default=False,
    ),
]
Second = Annotated[str | None, typer.Argument(metavar="FILE", help="The study file to write.")]
Over = Annotated[bool, typer.Option("--overwrite", help="Replace an existing file.")]


def run(template: First = None, file: Second = None, overwrite: Over = False, json: Json = False) -> None:
    """Write a template; without arguments, list the templates."""
    with speaking(json) as voice:
        choices = templates()
        if template is None:
            pairs(voice, {name: text.about for name, text in choices.items()})
            voice.write(f"`haptonic new touchpad my{ENDING}` writes the template touchpad.")
            voice.write(
                "`haptonic new` also writes the study of a case; `haptonic verify --list` lists the cases."
            )
            voice.answer(
                {
                    "templates": {name: text.about for name, text in choices.items()},
                    "cases": {name: text.about for name, text in case_templates().items()},
                }
            )
            return
        choices |= case_templates()
        name, path = resolved(template, file, choices)
        refuse_taken(path, overwrite)
        text = choices[name].adapted(path)
        write_atomically(path, lambda draft: draft.write_text(text, "utf-8"))
        first = text.commands[0]
        voice.write(f"written: {path}, from the template {name}. Next:")
        voice.write(f"  {first}")  # on its own line, easy to copy
        voice.answer({"file": str(path), "template": name, "next": text.commands})


def resolved(template: str, file: str | None, choices: dict[str, Template]) -> tuple[str, Path]:
    """Name of the template and path of the file from one or two arguments.

    Raises
    ------
    StudyError : the template is unknown, or no file is given
    """
    if file is None and template.endswith(ENDING):
        return USUAL, target(template, "FILE")
    name = re.sub(r"[\s_]+", "-", template.strip().lower())
    guess = nearest(name, choices)
    if name not in choices:
        swapped = file is not None and file in choices
        cause = "template and file are in the wrong order" if swapped else "no template has this name"
        raise StudyError.unknown(
            "TEMPLATE",
            template,
            choices,
            cause,
            slip=False,
            next_step=f"haptonic new {file} {template}"
            if swapped
            else f"haptonic new {guess} {file or f'my{ENDING}'}"
            if guess
            else "list the templates with `haptonic new`",
        )
    if file is None:
        raise StudyError.missing(
            argument="FILE",
            allowed=f"the name of a study file, such as my{ENDING}",
            cause=f"{name} is the template",
            next_step=f"haptonic new {name} my{ENDING}",
        )
    return name, target(file, "FILE")


def refuse_taken(path: Path, overwrite: bool) -> None:
    """Raise StudyError if the path is taken, unless it is a file and may be overwritten."""
    if not os.path.lexists(path) or (overwrite and not path.is_dir()):
        return
    raise StudyError.repeated(
        argument="FILE",
        given=shown(str(path), 200),
        allowed="a name that is not taken, unless --overwrite is given",
        cause="it is a folder" if path.is_dir() else "a file of this name exists",
        next_step="choose another name" + ("" if path.is_dir() else ", or give --overwrite to replace it"),
    )
