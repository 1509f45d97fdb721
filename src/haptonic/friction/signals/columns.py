"""Columns of a table of trials by their headings, in several languages."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError
from haptonic.names import listed

Column = NDArray[Any]

# Words are compared without capitals, blanks, "_", "-", "#", "no" and "id" around them.
WORDS: Mapping[str, tuple[str, ...]] = {
    "participant": (
        "participant", "subject", "person", "user", "volunteer", "observer", "vp", "proband", "probandin",
        "teilnehmer", "versuchsperson", "sujet", "sujeto", "participante", "soggetto", "partecipante",
        "deelnemer", "proefpersoon", "subj", "pp", "part",
    ),
    "block": ("block", "blk", "session", "bloc", "bloque", "blocco", "sitzung", "blok", "set"),
    "trial": (
        "trial", "repetition", "rep", "versuch", "durchgang", "wiederholung", "essai", "ensayo", "prova",
        "stroke", "trialnumber", "trialnr", "run", "herhaling", "index",
    ),
    "waveguide": (
        "waveguide", "guide", "region", "zone", "key", "area", "wellenleiter", "bereich", "taste", "région",
        "zona", "wg", "guided", "pad", "gebied", "location", "place", "ort", "position", "site",
    ),
    "actuation": (
        "actuation", "vibration", "ultrasound", "ultrasonic", "state", "onoff", "drive", "voltage", "zustand",
        "anregung", "schwingung", "ultraschall", "actuated", "power", "état", "etat", "estado", "stato",
    ),
    "file": (
        "file", "filename", "record", "recording", "path", "datei", "dateiname", "aufnahme", "fichier",
        "archivo", "fichero", "bestand", "data", "datafile",
    ),
    "friction": (
        "friction", "mu", "µ", "μ", "cof", "coefficient", "frictioncoefficient", "coefficientoffriction",
        "reibwert", "reibungskoeffizient", "reibungszahl", "frottement",
    ),
}  # fmt: skip
UNSURE = ("condition", "bedingung", "condición", "condicion", "condizione", "conditie", "treatment")
ON = {"on", "ein", "an", "true", "yes", "ja", "oui", "sí", "si", "aan", "active", "aktiv", "1", "1.0", "with"}
OFF = {"off", "aus", "false", "no", "nein", "non", "uit", "inactive", "inaktiv", "0", "0.0", "without"}
_SPARE = re.compile(r"[\s_\-#.:]+")
_AROUND = re.compile(r"(?:number|nummer|num|no|nr|id|name|code)$")
_NUMBERED = re.compile(r"\D*?0*(\d+)(?:\.0+)?\s*")


def plain_word(name: str) -> str:
    """A name of a column without capitals, separators and words for number or name."""
    word = _SPARE.sub("", name.casefold())
    shorter = _AROUND.sub("", word)
    return shorter if len(shorter) > 1 else word


def meanings(names: Iterable[str], table: str) -> dict[str, str]:
    """Names of columns by their meaning; a column with the exact name goes before others.

    Raises
    ------
    FrictionError : several columns have the same meaning
    """
    names = list(names)
    by_meaning: dict[str, str] = {}
    for meaning, words in WORDS.items():
        exact = [name for name in names if name.strip() == meaning]
        alike = [name for name in names if plain_word(name) == meaning]
        others = [name for name in names if plain_word(name) in words]
        for some in (exact, alike, others):
            if len(some) == 1:
                by_meaning[meaning] = some[0]
            if some:
                break
        else:
            continue
        if len(some) > 1:
            raise FrictionError.conflict(
                argument=f"{table}: column {meaning}",
                given="the columns " + listed([f'"{name}"' for name in some]),
                allowed=f"one column of this meaning, best with the name {meaning}",
                cause="several names have this meaning",
                next_step=f'rename the right one to "{meaning}"',
            )
    return by_meaning


def renamed(columns: Mapping[str, Column], table: str) -> dict[str, Column]:
    """The columns renamed to haptonic's names; words for on and off become "on" and "off"."""
    columns = {str(name): column for name, column in columns.items()}
    by_meaning = meanings(columns, table)
    if "actuation" not in by_meaning:
        conditions = [n for n in columns if plain_word(n) in UNSURE and switched(columns[n]) is not None]
        if len(conditions) == 1:
            by_meaning["actuation"] = conditions[0]
    if "waveguide" not in by_meaning:
        places = [n for n in columns if plain_word(n) in UNSURE and n not in by_meaning.values()]
        if len(places) == 1:
            by_meaning["waveguide"] = places[0]
    back = {name: meaning for meaning, name in by_meaning.items()}
    columns_by_meaning = {back.get(name, name): column for name, column in columns.items()}
    if "actuation" in columns_by_meaning and (words := switched(columns_by_meaning["actuation"])) is not None:
        columns_by_meaning["actuation"] = words
    return columns_by_meaning


def switched(column: Sequence[Any] | Column) -> Column | None:
    """The column with its words for on and off as "on" and "off"; None if it contains other words."""
    words = [str(cell).strip().casefold() for cell in column]
    empty = {"", "nan", "none"}
    if not set(words) <= ON | OFF | empty or not set(words) - empty:
        return None
    return np.array(["on" if word in ON else "off" if word in OFF else "" for word in words], dtype=object)


def whole_number(cell: object) -> object:
    """The number of a cell such as 3, 3.0, "03" or "B3"; any other cell unchanged."""
    if isinstance(cell, int | float | np.integer | np.floating):
        return int(cell) if float(cell).is_integer() else cell
    match = _NUMBERED.fullmatch(str(cell))
    return int(match[1]) if match else cell
