"""Draft of the table of trials from the names of the files: parts that vary become columns."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from haptonic.channels.formats import SUFFIXES
from haptonic.errors import FrictionError
from haptonic.friction.recordings.sensor import CALIBRATION
from haptonic.friction.recordings.trial_table import TABLE, table_in
from haptonic.friction.signals.columns import OFF, ON, WORDS, plain_word
from haptonic.friction.signals.tables import LABEL

MOST_FILES = 100_000
FEW = 8  # values of a word: at most as many mean a region, more mean a person
# Letters before a number in the name of a file, and their meaning.
LETTERS = {
    "participant": ("p", "s", "vp", "sub", "subj", "subject", "participant", "proband", "pp", "user"),
    "block": ("b", "blk", "bl", "block", "session", "sess", "ses", "set", "s"),
    "trial": ("t", "tr", "trial", "rep", "r", "stroke", "no", "nr", "run", "versuch"),
    "waveguide": ("wg", "guide", "waveguide", "region", "key", "zone", "area", "pad"),
}  # fmt: skip
NUMBERED = ("block", "trial")
_PART = re.compile(r"(?:on|off)(?=\d)|[^\W\d_]+\d*|\d+", re.IGNORECASE)
_WITH_BLANKS = re.compile(r"(?:on|off)(?=\d)|[^\W\d_]+(?: [^\W\d_]+)*\d*|\d+", re.IGNORECASE)
_MIXED = re.compile(r"([^\W\d_]+)(\d+)")


@dataclass(frozen=True)
class Draft:
    """Drafted columns of a table of trials.

    columns : (trial,) texts by name, ``file`` last
    empty : columns that the names of the files do not give
    unnamed : columns of parts whose meaning is not clear
    renumbered : True if the names number the trials of a block more than once, such as ``on_01`` and
        ``off_01``; the trials are then numbered consecutively
    """

    columns: dict[str, list[str]]
    empty: tuple[str, ...]
    unnamed: tuple[str, ...]
    renumbered: bool = False


def drafted(folder: Path) -> Draft:
    """Draft a table of trials from the names of the files in a folder and below it.

    Raises
    ------
    FrictionError : the folder already has a table, has no record, or has too many files
    """
    if table_in(folder).exists():
        raise FrictionError.repeated(
            argument="--draft",
            given=table_in(folder),
            allowed=f"a folder without {TABLE}, which is never replaced",
            cause="the table was drafted or written before",
            next_step="leave --draft out, or rename the table that is there",
        )
    files = records_in(folder)
    if not files:
        raise FrictionError.missing(
            argument="--draft",
            given=f"no record in {folder}",
            allowed=f"files that end in {', '.join(SUFFIXES)}",
            cause="another folder, or records in another format",
            next_step="choose the folder with the records",
        )
    # if some names have more words than others, a blank may be part of one, as in "de Vries_1_on"
    parts = min(
        ([pattern.findall(str(Path(name).with_suffix(""))) for name in files]
         for pattern in (_PART, _WITH_BLANKS)),
        key=lambda rows: len(set(map(len, rows))),
    )  # fmt: skip
    usual = Counter(map(len, parts)).most_common(1)[0][0]
    rows = [row if len(row) == usual else [""] * usual for row in parts]
    places = {place: [row[place] for row in rows] for place in range(usual)}
    named = _meanings(places)
    columns = {
        meaning: [_cell(meaning, value) for value in places[place]]
        for meaning, place in sorted(named.items(), key=lambda item: LABEL.index(item[0]))
    }
    unnamed = {
        f"part{place + 1}": values
        for place, values in places.items()
        if place not in named.values() and len(set(values)) > 1
    }
    if "block" not in columns:
        columns["block"] = ["1"] * len(files)
    blocks = list(zip(*(columns[name] for name in ("participant", "block") if name in columns), strict=True))
    numbers = columns.get("trial", ["1"] * len(files))
    numbered = [pair for pair in zip(blocks, numbers, strict=True) if pair[1]]
    renumbered = "trial" in columns and len(set(numbered)) < len(numbered)
    if "trial" not in columns or renumbered:
        columns["trial"] = _consecutive(blocks, numbers)
    empty = tuple(name for name in LABEL if name not in columns)
    table = {name: columns.get(name, [""] * len(files)) for name in LABEL}
    return Draft({**table, **unnamed, "file": files}, empty, tuple(unnamed), renumbered)


def records_in(folder: Path) -> list[str]:
    """Names of the files of signals in a folder and below it, sorted by the numbers in them."""
    every = sorted(
        (path for path in folder.rglob("*") if path.suffix.lower() in SUFFIXES and path.is_file()),
        key=lambda path: [
            (int(part), "") if part.isdecimal() else (0, part.casefold())
            for part in re.split(r"(\d+)", str(path.relative_to(folder)))
        ],
    )
    if len(every) > MOST_FILES:
        raise FrictionError.too_large(
            argument="--draft",
            given=f"{len(every)} files",
            allowed=f"at most {MOST_FILES}",
            cause="another folder than that of the records",
            next_step="choose the folder with the records",
        )
    names = [path.relative_to(folder) for path in every]
    hidden = [any(part.startswith(".") for part in name.parts) for name in names]
    return [
        name.as_posix()
        for name, hides in zip(names, hidden, strict=True)
        if not hides and name.name.casefold() not in (TABLE, CALIBRATION)
    ]


def _meanings(places: dict[int, list[str]]) -> dict[str, int]:
    """Place in the names for each meaning; each meaning occurs once."""
    by_meaning: dict[str, int] = {}

    def take(meaning: str, place: int) -> None:
        if meaning not in by_meaning and place not in by_meaning.values():
            by_meaning[meaning] = place

    varying = [place for place, values in places.items() if len(set(values) - {""}) > 1]
    for place, values in places.items():
        words = {value.casefold() for value in values if value}
        if words and words <= ON | OFF and not any(word.isdecimal() for word in words):
            take("actuation", place)
        letters = {match[1].casefold() for word in words if (match := _MIXED.fullmatch(word))}
        for meaning, abbreviations in LETTERS.items():
            if words and all(_MIXED.fullmatch(word) for word in words) and letters <= set(abbreviations):
                take(meaning, place)
    for place in varying:  # "block 3": a word that does not vary before a number
        if all(value.isdecimal() for value in places[place] if value) and place - 1 in places:
            before = {value.casefold() for value in places[place - 1] if value}
            if len(before) == 1:
                word = plain_word(next(iter(before)))
                for meaning, abbreviations in LETTERS.items():
                    if word in abbreviations or word in WORDS[meaning]:
                        take(meaning, place)
    numbers = [p for p in varying if all(value.isdecimal() for value in places[p] if value)]
    for meaning, place in zip(("trial", "block"), reversed(numbers), strict=False):
        if all(len(value) <= 4 for value in places[place]):
            take(meaning, place)
    for place in varying:
        if place not in numbers:
            few = len({value.casefold() for value in places[place]}) <= FEW
            take("participant" if "participant" not in by_meaning or not few else "waveguide", place)
    return by_meaning


def _cell(meaning: str, value: str) -> str:
    if meaning == "actuation":
        return "on" if value.casefold() in ON else "off" if value else ""
    if meaning in NUMBERED and value:
        return str(int(re.sub(r"\D", "", value)))
    return value


def _consecutive(blocks: Sequence[tuple[str, ...]], numbers: Sequence[str]) -> list[str]:
    """Numbers from 1 in each block: in the order of the given numbers, of equal ones in that of the files."""
    counted: Counter[tuple[str, ...]] = Counter()
    trials = list(numbers)
    numbered = [row for row, number in enumerate(numbers) if number]
    for row in sorted(numbered, key=lambda row: int(numbers[row])):
        counted[blocks[row]] += 1
        trials[row] = str(counted[blocks[row]])
    return trials
