"""``haptonic keys``: the keys of the study file, as their declarations say them."""

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

Pattern = Annotated[
    str | None, typer.Argument(metavar="PATTERN", help="Part of a path, or a word of a key's help.")
]


def run(pattern: Pattern = None, json: Json = False) -> None:
    """Tell the keys that a pattern finds; without one list them all."""
    with speaking(json) as voice:
        every = table(Study)
        found = every if pattern is None else matching(every, pattern)
        voice.answer({"keys": [facts(key) for key in found.values()]})
        if pattern is None:
            pairs(voice, {path: key.label for path, key in found.items()})
            voice.tell(
                f"{len(found)} keys. `haptonic keys PATTERN` tells all of some: `haptonic keys pillar`."
            )
        else:
            tell(voice, found, pattern)


def tell(voice: Voice, found: dict[str, Key], pattern: str) -> None:
    """Keys whose path the pattern stands in, with all that is known; others that only mention it, by name."""
    named = {path: key for path, key in found.items() if _plain(pattern) in _plain(path)} or found
    for path, key in named.items():
        entry(voice, path, lines(key))
    others = {path: key.label for path, key in found.items() if path not in named}
    if others:
        voice.tell(f"{len(others)} more mention it:")
        pairs(voice, others)


def matching(keys: dict[str, Key], pattern: str) -> dict[str, Key]:
    """The keys in whose path, help or words a pattern stands, whatever its capitals.

    If it stands in none, those below its first part of which the others are said, by them or by a table that
    they are in: ``plate.patch`` finds ``plate.actuator``, whose help speaks of patches, and all in it.

    Raises
    ------
    StudyError : there is none
    """
    wanted = _plain(pattern)
    texts = {
        path: "\n".join((_plain(path), key.title, key.description, *key.known_names)).casefold()
        for path, key in keys.items()
    }
    if found := {path: key for path, key in keys.items() if wanted in texts[path]}:
        return found
    first, *others = wanted.split(".")
    found = {}
    for path in (path for path in keys if first in _plain(path)):
        around = [text for one, text in texts.items() if f"{path}.".startswith((f"{one}.", f"{one}["))]
        if others and all(any(part in text for text in around) for part in others):
            found[path] = keys[path]
    if found:
        return found
    words = {part for path in keys for part in (path, *path.replace("[]", "").split("."))}
    guess = nearest(wanted, sorted(words))
    raise StudyError.unknown(
        "pattern", pattern, words, "no key of the study file has it", slip=False,
        allowed="part of a path such as cell.pillar, or a word of a key's help",
        next_step=f"haptonic keys {guess}" if guess else "list them all with `haptonic keys`",
    )  # fmt: skip


def _plain(path: str) -> str:
    """Without capitals and numbers of tables: plate.actuator[1].size and plate.actuator.size are one."""
    return re.sub(r"\[\d*\]", "", path.casefold())


def lines(key: Key) -> dict[str, str]:
    """All that is known of a key, in words."""
    return {
        "meaning": f"{key.title}. {key.description}",
        "allowed": allowed_at(key),
        "names": ", ".join(key.numbers or (key.known_names if key.named and key.kind != "text" else ())),
        "usual": key.typical,
        "default": "none: it has to be given" if key.required else key.default_text,
        "example": example(key),
    }


def example(key: Key) -> str:
    """A line for the study file; a table's own keys have theirs."""
    if key.kind in {"table", "tables", "entries"} and not key.known_names:
        return ""
    value = key.default_text
    if not value or key.example or key.kind in {"quantities", "text", "choice"}:
        return example_at(key)
    name = key.path.rpartition(".")[2]
    return f'{name} = "{value}"' if key.unit else f"{name} = {value}"


def facts(key: Key) -> dict[str, Any]:
    """What machines are told."""
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
