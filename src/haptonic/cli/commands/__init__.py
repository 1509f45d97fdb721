"""The table of commands that compute nothing of a study: for each a module with a ``run``, and its line."""

from typing import Annotated

import typer

Json = Annotated[bool, typer.Option("--json", help="Print one JSON object.")]

# name: help, a sentence; in the order of the help
NAMES = {
    "new": "Write a study file to begin with, from a template; without arguments, tell the templates.",
    "keys": "The keys of the study file: what they mean, what is allowed, an example.",
    "materials": "The built-in materials, with their constants and sources.",
    "schema": "The JSON schema of the study file, for editors that complete and check it.",
    "verify": "Compute published and exact cases; exit code 1 if one lies outside its errors.",
    "doctor": "Versions, threads, solver, memory, and a check of the physics that takes a second.",
}
