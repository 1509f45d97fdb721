"""``haptonic new``: a study file to begin with."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated

import typer

from haptonic.cli.commands import Json
from haptonic.cli.console import speaking
from haptonic.cli.listing import pairs
from haptonic.errors import StudyError, nearest, shown
from haptonic.paths import target
from haptonic.store import write_atomically
from haptonic.study import ENDING, Template, case_templates, templates

USUAL = "bare-cell"


def complete(incomplete: str) -> list[str]:
    """For a shell: the templates and cases whose names begin so."""
    return [name for name in templates() | case_templates() if name.startswith(incomplete)]


First = Annotated[
    str | None,
    typer.Argument(metavar="TEMPLATE", help=f"Else {USUAL}.", autocompletion=complete, show_default=False),
]
Second = Annotated[str | None, typer.Argument(metavar="FILE", help="The study file that is written.")]
Over = Annotated[bool, typer.Option("--overwrite", help="Replace a file that is there.")]


def run(template: First = None, file: Second = None, overwrite: Over = False, json: Json = False) -> None:
    """Write a template; tell the templates if nothing is named."""
    with speaking(json) as voice:
        known = templates()
        if template is None:
            pairs(voice, {name: text.about for name, text in known.items()})
            voice.tell(f"`haptonic new touchpad my{ENDING}` writes one of them.")
            voice.tell("It also writes the study of a case; `haptonic verify --list` lists the cases.")
            voice.answer(
                {
                    "templates": {name: text.about for name, text in known.items()},
                    "cases": {name: text.about for name, text in case_templates().items()},
                }
            )
            return
        known |= case_templates()
        name, path = resolved(template, file, known)
        refuse_taken(path, overwrite)
        text = known[name].adapted(path)
        write_atomically(path, lambda draft: draft.write_text(text, "utf-8"))
        first = text.commands[0]
        voice.tell(f"written: {path}, from the template {name}. Next:")
        voice.tell(f"  {first}")  # a line of its own, to be copied
        voice.answer({"file": str(path), "template": name, "next": text.commands})


def resolved(template: str, file: str | None, known: dict[str, Template]) -> tuple[str, Path]:
    """The template and the file that two arguments name, or one.

    Raises
    ------
    StudyError : no such template, or no file
    """
    if file is None and template.endswith(ENDING):
        return USUAL, target(template, "FILE")
    name = re.sub(r"[\s_]+", "-", template.strip().lower())
    guess = nearest(name, known)
    if name not in known:
        swapped = file is not None and file in known
        cause = "template and file stand in the wrong order" if swapped else "there is no such template"
        raise StudyError.unknown(
            "TEMPLATE",
            template,
            known,
            cause,
            slip=False,
            next_step=f"haptonic new {file} {template}"
            if swapped
            else f"haptonic new {guess} {file or f'my{ENDING}'}"
            if guess
            else "`haptonic new` tells what they are",
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
    """Raise StudyError if something is there that was not asked to be replaced, or cannot be."""
    if not os.path.lexists(path) or (overwrite and not path.is_dir()):
        return
    raise StudyError.repeated(
        argument="FILE",
        given=shown(str(path), 200),
        allowed="a name that is not taken, unless --overwrite is given",
        cause="it is a folder" if path.is_dir() else "a file of this name is there",
        next_step="choose another name" + ("" if path.is_dir() else ", or give --overwrite to replace it"),
    )
