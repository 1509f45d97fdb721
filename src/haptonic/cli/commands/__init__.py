"""Commands that compute no study: each is a module with a ``run``, and a line of help here."""

from typing import Annotated

import typer

Json = Annotated[bool, typer.Option("--json", help="Print one JSON object.")]

# name: help (one sentence), in the order of the help
NAMES = {
    "new": "Write a study file from a template; without arguments, list the templates.",
    "studio": "Edit a study and see its results on one page in the browser; a local server, until Ctrl-C.",
    "keys": "List the keys of the study file with meaning, allowed values and an example.",
    "materials": "List the built-in materials with their constants and sources.",
    "schema": "Print the JSON schema of the study file, for editors that complete and check it.",
    "verify": "Compute published and exact cases; exit code 1 if one lies outside its errors.",
    "doctor": "Print versions, optional parts, store and speed, and run a one-second check of the physics.",
}
