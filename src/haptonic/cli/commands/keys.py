"""``haptonic keys``: the keys of the study file, as they are declared."""

from __future__ import annotations

import re
from typing import Annotated, Any

import typer

from haptonic.cli.commands import Json
from haptonic.cli.console import Voice, speaking
from haptonic.cli.listing import entry, pairs
from haptonic.errors import StudyError, nearest
from haptonic.fields import Key, table
from haptonic.fields.problems import allowed_at, example_at
from haptonic.study import Study

MANY = 25  # keys; more fill several screens
Pattern = Annotated[
    str | None, typer.Argument(metavar="PATTERN", help="Part of a path, or a word of a key's help.")
]


def run(pattern: Pattern = None, json: Json = False) -> None:
    """Print the keys that match a pattern in full; without a pattern, list all keys."""
    with speaking(json) as voice:
        every = table(Study)
        keys = every if pattern is None else matching(every, pattern)
        voice.answer({"keys": [facts(key) for key in keys.values()]})
        if pattern is None:
            pairs(voice, {path: key.label for path, key in keys.items()})
            voice.write(
                f"{len(keys)} keys. `haptonic keys PATTERN` explains some, such as `haptonic keys pillar`."
            )
        else:
            print_keys(voice, keys, pattern)


def print_keys(voice: Voice, keys: dict[str, Key], pattern: str) -> None:
    """Print all facts of the keys whose path contains the pattern; list the others by name.

    Of many keys, those of tables in the tables are listed by name too.
    """
    named = {path: key for path, key in keys.items() if _plain(pattern) in _plain(path)} or keys
    highest = min(path.count(".") for path in named)
    is_short = len(named) <= MANY
    whole = {path: key for path, key in named.items() if is_short or path.count(".") <= highest + 1}
    for path, key in whole.items():
        entry(voice, path, lines(key))
    _list(
        voice, {path: key.label for path, key in named.items() if path not in whole}, "Keys of inner tables"
    )
    others = {path: key.label for path, key in keys.items() if path not in named}
    _list(voice, others, "Other keys whose help contains the pattern")


def _list(voice: Voice, labels: dict[str, str], heading: str) -> None:
    if labels:
        voice.write(f"{heading} ({len(labels)}):")
        pairs(voice, labels)


def matching(keys: dict[str, Key], pattern: str) -> dict[str, Key]:
    """Keys whose path, help or known names contain a pattern; capitals do not matter.

    If no text contains it, the first part of the pattern has to be in the path, and the other parts in the
    texts of the key or of a table around it: ``plate.patch`` finds ``plate.actuator``, whose help names
    patches, and all its keys.
    Raises
    ------
    StudyError : no key matches
    """
    wanted = _plain(pattern)
    texts = {
        path: "\n".join((_plain(path), key.title, key.description, *key.known_names)).casefold()
        for path, key in keys.items()
    }
    if matches := {path: key for path, key in keys.items() if wanted in texts[path]}:
        return matches
    first, *others = wanted.split(".")
    matches = {}
    for path in (path for path in keys if first in _plain(path)):
        around = [text for other, text in texts.items() if f"{path}.".startswith((f"{other}.", f"{other}["))]
        if others and all(any(part in text for text in around) for part in others):
            matches[path] = keys[path]
    if matches:
        return matches
    words = {part for path in keys for part in (path, *path.replace("[]", "").split("."))}
    guess = nearest(wanted, sorted(words))
    raise StudyError.unknown(
        "pattern", pattern, words, "no key of the study file contains it", slip=False,
        allowed="part of a path such as cell.pillar, or a word of a key's help",
        next_step=f"haptonic keys {guess}" if guess else "list all keys with `haptonic keys`",
    )  # fmt: skip


def _plain(path: str) -> str:
    """Lower-case path without numbers of tables: ``plate.actuator[1]`` becomes ``plate.actuator``."""
    return re.sub(r"\[\d*\]", "", path.casefold())


def lines(key: Key) -> dict[str, str]:
    """All facts about a key, as texts by their labels."""
    return {
        "meaning": f"{key.title}. {key.description}",
        "allowed": allowed_at(key),
        "names": ", ".join(key.numbers or (key.known_names if key.named and key.kind != "text" else ())),
        "usual": key.typical,
        "default": _default(key),
        "example": example(key),
    }


def _default(key: Key) -> str:
    if not key.required:
        return key.default_text
    return "none: required in a table of this kind" if key.is_alternative else "none: the key is required"


def example(key: Key) -> str:
    """An example line for the study file; empty for a table, whose keys have their own examples."""
    if key.kind in {"table", "tables", "entries"} and not key.known_names:
        return ""
    value = key.default_text
    if not value or key.example or key.kind in {"quantities", "text", "choice"}:
        return example_at(key)
    name = key.path.rpartition(".")[2]
    return f'{name} = "{value}"' if key.unit else f"{name} = {value}"


def facts(key: Key) -> dict[str, Any]:
    """All facts about a key, for ``--json``."""
    return {
        "path": key.path,
        "title": key.title,
        "kind": key.kind,
        "unit": key.unit,
        "default": key.default,
        "required": key.required,
        "allowed": allowed_at(key),
        "bounds": key.bounds,
        "usual": key.typical,
        "known_names": list(key.known_names or key.numbers),
        "description": key.description,
        "example": example(key),
    }
