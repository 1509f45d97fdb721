"""Conversion of pydantic's errors to errors with five parts."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import ValidationError

from haptonic.errors import CLOSE, VAGUE, HaptonicError, StudyError, nearest, proposed, shown
from haptonic.fields.aliases import Alias, aliases
from haptonic.fields.keys import Key, key_of, slots, table
from haptonic.fields.quantity import FOLLOWING
from haptonic.names import counted, listed

TAG = "<"  # beginning of the tags of a union, which pydantic puts into the path
MISPLACED = "\0"  # prefix of a key that is in a table but belongs to the top; no file contains a NUL
PARTS = ("given", "allowed", "cause", "next_step")
UNKNOWN = {"extra_forbidden", "unexpected_keyword_argument"}  # pydantic's names for an undeclared key
OUT_OF_RANGE = {"greater_than_equal", "less_than_equal", "greater_than", "less_than"}
EXTRA = "unexpected_positional_argument"
MOST_LISTED = 20
PERSONS = ("Young", "Poisson")  # first words of titles that keep their capital
WRONG_WORD = "it is not one of the known words"


def refusal(
    error: ValidationError,
    kind: type,
    *,
    origin: str = "",
    place: str = "",
    family: type[HaptonicError] = StudyError,
    names: Sequence[str] = (),
) -> HaptonicError:
    """One error for all problems of a value: the first in its parts, the others listed in the next step.

    Parameters
    ----------
    kind : class of the value
    origin : name of the file; put before the path of the key
    place : path of the value in a study
    family : class of the error
    names : fields of positional arguments, in order
    """
    first, *others = problems_of(error, kind, place=place, names=names)
    next_step = first.next_step
    if others:
        lines = [_in_a_line(other) for other in others]
        hidden = len(lines) - MOST_LISTED
        lines = lines[:MOST_LISTED] + ([f"    and {hidden} more"] if hidden > 0 else [])
        count = counted(len(others), "other problem")
        next_step = "\n".join([f"{next_step}\n  {count} in the same study:", *lines])
    argument = f"{origin}: {first.argument}" if origin else first.argument
    return first.changed(family, argument=argument, next_step=next_step)


def _in_a_line(error: HaptonicError) -> str:
    """An error in a list of problems; of its allowed values only the words of a choice are repeated."""
    words = f": {error.allowed}" if error.cause == WRONG_WORD else ""
    return f"    {error.argument}: got {error.given}; {error.cause}{words}; {error.next_step}"


def problems_of(
    error: ValidationError, kind: type, *, place: str = "", names: Sequence[str] = ()
) -> list[StudyError]:
    """Each problem of a value as an error of its own, likely causes of others first; see `refusal`."""
    keys = table(kind, f"{place}." if place else "")
    known_aliases = aliases(kind, f"{place}." if place else "")
    details: list[Any] = [dict(each) for each in error.errors(include_url=False)]
    for each in details:
        if each["loc"] and isinstance(each["loc"][0], int):  # a positional argument
            number, *rest = each["loc"]
            each["loc"] = (names[number] if number < len(names) else f"argument_{number + 1}", *rest)
        each["path"], each["pattern"] = _path(each["loc"], kind, place)
        below = each.get("ctx", {}).get("at", "").split(".")[0]
        if below and _path((*each["loc"], below), kind, place)[0] == below:
            each["path"] = ""  # the blamed key is at the top
    slips = {_meant(each["pattern"], keys, known_aliases) for each in details if each["type"] in UNKNOWN}
    details = [each for each in details if _left_out(each) not in slips]
    details = [each for each in details if each["type"] != FOLLOWING] or details
    details.sort(key=lambda each: each["type"] not in UNKNOWN)  # a slip in a name explains later errors
    return [_in_parts(each, keys, known_aliases) for each in details]


def _in_parts(details: Any, keys: Mapping[str, Key], known_aliases: Mapping[str, Alias]) -> StudyError:
    """Convert one error of pydantic to five parts."""
    kind, context = details["type"], details.get("ctx", {})
    path, pattern = details["path"], details["pattern"]
    if kind in ("haptonic", FOLLOWING):
        where = ".".join(part for part in (path, context["at"]) if part) or "the study"
        return StudyError(context["code"], argument=where, **{name: context[name] for name in PARTS})
    if kind == EXTRA:
        return StudyError.malformed(
            argument=path, given=shown(details["input"], 40), allowed="values for the declared fields",
            cause="more arguments than fields were given", next_step="give fields by their names",
        )  # fmt: skip
    if kind in UNKNOWN:
        return _unknown(path, pattern, details["input"], keys, known_aliases)
    key = key_of(pattern, keys)
    of_an_entry = key is not None and key.kind == "entries" and pattern != key.path
    form = "a text in quotes" if of_an_entry else allowed_at(key)
    is_list = key is not None and key.kind == "quantities"
    title = "value" if key is None else key.title
    title = title if title.startswith(PERSONS) else title.lower()
    code = "out-of-range" if kind in OUT_OF_RANGE else "malformed"
    if kind == "missing":
        code, given, cause = "missing", "nothing", f"the {title} was left out"
        next_step = f"add {example_at(key)}" if key else "add it"
    elif key and key.choices:
        code, given = "unknown", shown(details["input"])
        cause = WRONG_WORD
        words = (*key.choices, *key.synonyms)
        next_step = proposed(str(details["input"])[:40], words) or "choose one of these"
    else:
        given, cause, next_step = (
            shown(details["input"]),
            _cause(kind, details["msg"], is_list),
            f"write {form}",
        )
    argument = path or "the study"
    return StudyError(code, argument=argument, given=given, allowed=form, cause=cause, next_step=next_step)


def _path(location: tuple[int | str, ...], kind: type, place: str = "") -> tuple[str, str]:
    """(``sweep[1].from``, ``sweep[].from``): path counted from 1, and pattern of the table of keys.

    ``place`` is the path of the value itself, whose class is ``kind``.
    """
    path = pattern = place
    kinds: tuple[type, ...] = (kind,)
    for step in location:
        if isinstance(step, int):
            path, pattern = f"{path}[{step + 1}]", f"{pattern}[]"
            continue
        if step.startswith(TAG):  # pydantic's name for an alternative of a union
            continue
        slot = next((each for owner in kinds for each in slots(owner) if step in (each.key, each.name)), None)
        kinds = slot.kinds if slot else ()
        if slot and slot.placed.inline:
            continue
        if slot and slot.placed.top:
            path = pattern = slot.key
            continue
        step = step.removeprefix(MISPLACED)
        name = step if step.replace("_", "").replace("-", "").isalnum() and len(step) < 60 else shown(step)
        path, pattern = f"{path}.{name}".lstrip("."), f"{pattern}.{step}".lstrip(".")
    return path, pattern


def _neighbours(section: str, keys: Mapping[str, Key]) -> list[str]:
    """Names of the keys in a table."""
    start = f"{section}." if section else ""
    names = [key.removeprefix(start) for key in keys if key.startswith(start)]
    return [name for name in names if "." not in name]


def _guess(pattern: str, keys: Mapping[str, Key]) -> str | None:
    """Key of the same table that a misspelt name means; a name of another table's key has to be closer."""
    section, _, name = pattern.rpartition(".")
    is_key = any(key.rpartition(".")[2] == name for key in keys)
    return nearest(name.lower(), _neighbours(section, keys), CLOSE if is_key else VAGUE)


def _left_out(details: Any) -> str | None:
    """Path of a missing key, if an error is about one."""
    if details["type"] == "missing":
        return str(details["pattern"])
    context = details.get("ctx", {})
    if details["type"] != "haptonic" or context["code"] != "missing":
        return None
    return ".".join(part for part in (details["pattern"], context["at"]) if part)


def _meant(pattern: str, keys: Mapping[str, Key], known_aliases: Mapping[str, Alias]) -> str:
    """Path of the key that a misspelt name probably means."""
    section = pattern.rpartition(".")[0]
    alias = _alias(pattern, known_aliases)
    return f"{section}.{alias.key if alias else _guess(pattern, keys)}".lstrip(".")


def _alias(pattern: str, known_aliases: Mapping[str, Alias]) -> Alias | None:
    """Declared alias of a name; the case of letters is ignored."""
    section, dot, name = pattern.rpartition(".")
    return known_aliases.get(pattern) or known_aliases.get(f"{section}{dot}{name.lower()}")


def _unknown(
    path: str, pattern: str, value: object, keys: Mapping[str, Key], known_aliases: Mapping[str, Alias]
) -> StudyError:
    section, _, name = pattern.rpartition(".")
    here, guess = _neighbours(section, keys), _guess(pattern, keys)
    elsewhere = [key for key in keys if key.rpartition(".")[2] == name]
    elsewhere.sort(key=lambda key: key.count("."))  # the disc of a cell before that of a site
    inside = [key for key in elsewhere if section and key.startswith(f"{section}.")]
    alias = _alias(pattern, known_aliases)
    if alias is not None:
        cause, next_step = alias.cause, alias.next_step
    elif name in here and section in keys and keys[section].named:
        cause, next_step = (
            "the other keys are those of another kind of material",
            "write the keys of one kind only",
        )
    elif name in here:
        cause, next_step = "another given value already contains it", "leave it out, or change that value"
    elif guess and not inside:
        cause, next_step = "a slip in the name", f'write "{guess}"'
    elif elsewhere:
        there = (inside or elsewhere)[0].replace("[]", "")
        table_name = there.rpartition(".")[0]
        heading = f": [{there}] in a file" if keys[(inside or elsewhere)[0]].kind == "table" else ""
        cause, next_step = (
            "the key belongs to another table",
            f"move it to [{table_name}]{heading}" if table_name else "move it to the top",
        )
    else:
        cause, next_step = "no key has this name", "remove it, or look its name up in the list of keys"
    where = f"the keys of [{section.replace('[]', '')}]" if section else "the keys at the top"
    return StudyError(
        "unknown",
        argument=path,
        given=f"an unknown key, with the value {shown(value, 40)}",
        allowed=f"{where}: {', '.join(here)}",
        cause=cause,
        next_step=next_step,
    )


def allowed_at(key: Key | None) -> str:
    """Allowed values of a key, as text."""
    if key is None:
        return "a value of the form in the list of keys"
    if key.kind == "quantities":
        kind = "quantities with their units" if key.unit else "numbers"
        return f"a list of {key.count} {kind}, such as {_list(key)}"
    if key.kind == "entries":
        value = key.quantity.example if key.quantity else f'"{key.example or "..."}"'
        return f"a table, [{key.path.replace('[]', '')}], of lines such as name = {value}"
    if key.quantity:
        return key.quantity.allowed
    if key.choices:
        return listed([f'"{choice}"' for choice in key.choices], "or")
    if key.named:
        return f"the name of a built-in material or a [{key.path.replace('[]', '')}] table"
    bounds = f" {key.bounds}" if key.bounds else ""
    forms = {
        "number": "a number, or a quantity with its unit in quotes",
        "integer": f"a whole number{bounds}, without quotes",
        "boolean": "true or false, without quotes",
        "text": f"a text in quotes{bounds and ','}{bounds}",
        "table": f"a table, [{key.path}]",
        "tables": f"tables with double brackets, [[{key.path}]],{bounds}",
    }
    return forms[key.kind]


PLAIN, TEXT = {"integer": "10", "boolean": "true"}, '"..."'  # example values by kind of a key


def example_at(key: Key) -> str:
    """An example line of the study file with the key."""
    name = key.path.rpartition(".")[2]
    examples = ["" if key.kind == "quantities" else key.example, *key.known_names, *key.numbers]
    if text := next(filter(None, examples), key.default if key.kind == "text" else None):
        return f"{name} = {text}" if key.quantity and not key.unit else f'{name} = "{text}"'
    if key.kind in {"table", "tables", "entries"}:
        return allowed_at(key)
    if key.kind == "quantities":
        return f"{name} = {_list(key)}"
    if key.quantity:
        return f"{name} = {key.quantity.example}"
    return f"{name} = {PLAIN.get(key.kind, TEXT)}"


def _list(key: Key) -> str:
    assert key.quantity is not None
    return key.example or f"[{', '.join([key.quantity.example] * key.count)}]"


def _cause(kind: str, message: str, is_list: bool) -> str:
    if kind in OUT_OF_RANGE:
        return "the number is out of bounds"
    if kind in {"int_type", "int_from_float", "int_parsing", "int_parsing_size"}:
        return "it is not a whole number"
    if kind in {"too_long", "string_too_long"}:
        most, parts = re.search(r"at most (\d+)", message), "items" if kind == "too_long" else "characters"
        return f"it has more than {most[1]} {parts}" if most else "it is too long"
    if kind == "string_type":
        return "it is not a text"
    if kind == "tuple_type" and is_list:
        return "it is not a list"
    if kind in {"dataclass_type", "model_attributes_type", "tuple_type", "union_tag_not_found", "dict_type"}:
        return "a table is required here"
    return message[:1].lower() + message[1:]
