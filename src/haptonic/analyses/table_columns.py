"""Meaning of the columns of another program's table of bands: wavevectors, frequencies, damping, others."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels.text_table import TextColumn, TextTable
from haptonic.errors import ChannelError, HaptonicError, shown
from haptonic.units import kind_of, to_si

Settings = tuple[tuple[str, float], ...]
Damping = Literal["quality factor", "damping ratio", "loss factor", "imaginary part"]

SAME = 1e-3  # relative difference of two columns of the same frequency; tables have four digits or more
_HERTZ = re.compile(r"[kMGT]?Hz", re.IGNORECASE)
_ANGULAR = re.compile(r"[kMG]?rad(?:\s*/\s*s(?:ec)?|\s+s\^?-1|\*s\^?-1)|rpm|(?:deg|°)/s")
_WAVEVECTOR_UNIT = re.compile(r"(?:rad|1)/[nuµmck]?m|(?:rad\s+)?[nuµmck]?m\^?-1|(?:2\s*\*?\s*)?(?:pi|π)/a")
_WAVEVECTOR = re.compile(
    r"[kqβκ]|kappa|beta|(?:bloch[ _-]?|reduced[ _-]?)?wave[ _-]?(?:vector|number)s?|q[ _-]?points?|"
    r"k[ _-]?(?:points?|path|bloch|value|par(?:allel)?)|segments?|path|distance|arc[ _-]?length|share|"
    r"wellenvektor|wellenzahl|wellenzahlvektor|nombre d'onde|vecteur d'onde|n[uú]mero de onda|vector de onda",
    re.IGNORECASE,
)
_AXIS = re.compile(r"[kqβκ][ _-]?(?P<axis>[xyz])", re.IGNORECASE)
_AXIS_IN_BRACKETS = re.compile(r"[kqβκ][({](?P<axis>[xyz])[)}]", re.IGNORECASE)
_INDEX = re.compile(
    r"#|n|no\.?|nr\.?|index|number|band|mode|branch|solution|row|i|(?:solution|mode|band|k|point|row)[ _-]?"
    r"(?:number|index|no\.?|nr\.?|#|id)",
    re.IGNORECASE,
)
# names of columns in Hz that are not eigenfrequencies
_BESIDE = (
    r"quality|\bq\b|qeig|q[ _-]?fac|damping|zeta|ζ|loss|\berr|err$|fehler|residu|uncert|\bstd|tolerance|"
    r"target|\bsearch|\bshift|\bstep|\breference|güte|dämpfung|amortissement|facteur|line ?width"
)
_NO_EIGENFREQUENCY = re.compile(_BESIDE, re.IGNORECASE)
_NO_FREQUENCY = re.compile(  # names of columns without a unit that are not frequencies
    rf"{_BESIDE}|\bbeta\b|η|polari[sz]|^p[_ ]?[a-z]{{1,3}}$|parit|symmetr|participation|degenera|weight|"
    r"\bperiods?\b|périod|wavelength|wellenlänge|longueur|longitud\b|velocity|phase|character|energy|"
    r"\bratio|\bfraction",
    re.IGNORECASE,
)
_DAMPING: dict[Damping, re.Pattern[str]] = {
    "quality factor": re.compile(r"quality|^q$|qeig|q[ _-]?fac|güte|facteur de qualit", re.IGNORECASE),
    "damping ratio": re.compile(r"damping ratio|zeta|ζ|damp|dämpfung|amortissement", re.IGNORECASE),
    "loss factor": re.compile(r"loss|^eta$|η", re.IGNORECASE),
}
_IMAGINARY = re.compile(r"^imag|^im\b|^im[({]|imaginary", re.IGNORECASE)
_AT = re.compile(r"@\s*(?P<what>.*)$|,\s*(?P<other>[^,=]+=.*)$")
_SETTING = re.compile(r"(?P<name>[A-Za-zκβ_][\w.]*)\s*=\s*(?P<value>[+-]?[\d.]+(?:[eE][+-]?\d+)?)")


@dataclass(frozen=True, eq=False)
class TableOfBands:
    """A table of bands, with its columns assigned.

    wavevector : (row, 1 or 2) as in the file; axes : "k", or "x" and "y" of each
    unit : of the wavevector, "" if the file does not give it
    frequency : (row, column) Hz, NaN for a missing one
    loss : (row, column) loss factors, 1/Q, or None
    blocks, lines : (row,) of the text; left : names of unused columns; from_column : origin of the loss
    """

    wavevector: Array
    axes: str
    unit: str
    frequency: Array
    blocks: NDArray[np.int64]
    lines: NDArray[np.int64]
    loss: Array | None = None
    from_column: str = ""
    left: tuple[str, ...] = ()
    remarks: tuple[str, ...] = field(default=())


def columns_of(table: TextTable, frequency_unit: str | None) -> TableOfBands:
    """Assign the columns of a table by names and units; without names, the wavevector is the first column.

    Raises
    ------
    ChannelError : no wavevector, no frequencies, a missing unit, or words among the numbers
    """
    if len(table.columns) < 2:
        raise _refused(table, "a single column", "columns of the wavevector and of frequencies")
    if table.unmatched and len(table.columns) > 2:
        raise _refused(
            table,
            table.remarks[0],
            "names of columns, separated like the numbers or by two blanks",
            f"separate the names in line {table.unmatched} by two blanks; if it has no names, skip it: "
            f"--skip-lines={table.unmatched}",
        )
    if table.short:
        raise _refused(
            table, f"fewer cells in line {table.short[0]} than above it", "as many cells in every row"
        )
    axes = _axes(table)
    chosen = _frequencies(table, axes, frequency_unit)
    axes = _without(axes, chosen)
    frequency = {c.number: table.numbers(c) for c in chosen}
    factor = _factors(table, chosen, frequency_unit)
    values = np.stack([np.real(frequency[c.number]) * factor[c.unit] for c in chosen], axis=1)
    if np.isinf(values).any():
        line = int(table.lines[np.argwhere(np.isinf(values))[0, 0]])
        raise _refused(table, f"an infinite frequency in line {line}", "finite frequencies")
    left = _without(table.columns, [*chosen, *axes])
    values, distinct = _drop_repeated(values, chosen)
    left += _without(chosen, distinct)
    loss, source = _loss(table, left, distinct, frequency, values.shape)
    settings = [_setting(c) for c in distinct]
    named = tuple(c.name for c in sorted(left, key=lambda c: c.number))
    if not axes or (settings[0] and all(settings)):
        return _by_headings(table, distinct, values, settings, named, axes)
    wavevector = np.stack([np.real(table.numbers(c)) for c in axes], axis=1).astype(float)
    if not np.isfinite(wavevector).all():
        row = int(np.argwhere(~np.isfinite(wavevector))[0, 0])
        raise _refused(
            table,
            f"no number for the wavevector in line {int(table.lines[row])}",
            "a wavevector in every row",
        )
    names = "".join(_axis_name(c) for c in axes) or "k"
    if "z" in names:
        if np.any(wavevector[:, names.index("z")] != 0):
            raise _refused(
                table, "wavevectors with a component along z", "wavevectors in the plane of the plate"
            )
        keep = [k for k, name in enumerate(names) if name != "z"]
        wavevector, names = wavevector[:, keep], names.replace("z", "")
    units = {c.unit for c in axes}
    if len(units) > 1:
        raise _refused(table, f"wavevectors in {' and '.join(sorted(map(repr, units)))}", "one unit for both")
    return TableOfBands(
        wavevector=wavevector, axes=names, unit=units.pop(), frequency=values, blocks=table.blocks,
        lines=table.lines, loss=loss, from_column=source,
        left=tuple(name for name in named if name != source), remarks=table.remarks,
    )  # fmt: skip


def _axes(table: TextTable) -> list[TextColumn]:
    """Columns of the wavevector: kx and ky, or a single column."""
    pair = [column for column in table.columns if _axis_name(column)]
    if pair:
        return sorted(pair, key=_axis_name)
    by_unit = [c for c in table.columns if _WAVEVECTOR_UNIT.fullmatch(c.unit)]
    by_name = [c for c in table.columns if c.heading.name and _WAVEVECTOR.fullmatch(_stem(c))]
    for matches in (by_name, by_unit):
        if matches:
            both = [c for c in matches if c in by_unit]
            return (both or matches)[:1]
    others = [
        c
        for c in table.columns
        if not (_is_frequency_unit(c.unit) or _INDEX.fullmatch(_stem(c)) or _is_beside(c))
    ]
    if table.names_line is None:
        return [table.columns[0]]
    return others[:1] if others and others[0].number <= 2 else []


def _axis_name(column: TextColumn) -> str:
    """ "x", "y" or "z" for a component of the wavevector, otherwise ""."""
    match = _AXIS.fullmatch(_stem(column)) or _AXIS_IN_BRACKETS.fullmatch(_stem(column))
    return match["axis"].lower() if match else ""


def _stem(column: TextColumn) -> str:
    """Name of a column without the parameters that COMSOL appends."""
    return _AT.sub("", column.heading.name).strip()


def _is_frequency_unit(unit: str) -> bool:
    return bool(_HERTZ.fullmatch(unit) or _ANGULAR.fullmatch(unit))


def _is_beside(column: TextColumn) -> bool:
    """True for a column that is not of bands, by its name; columns in Hz may be called "symmetric"."""
    pattern = _NO_EIGENFREQUENCY if _is_frequency_unit(column.unit) else _NO_FREQUENCY
    return bool(pattern.search(_stem(column)) or _IMAGINARY.search(_stem(column)))


def _frequencies(
    table: TextTable, axes: Sequence[TextColumn], frequency_unit: str | None
) -> list[TextColumn]:
    """Columns of frequencies: those in hertz, or else those in rad/s, or else those without a unit."""
    rest = [c for c in _without(table.columns, axes) if not c.is_text]
    units = {c.unit for c in rest} - {"", "1"}
    others = {unit for unit in units if kind_of(unit) not in ("", "frequency")}
    other = [c for c in rest if c.unit in others]
    rest = [c for c in rest if c.unit not in others]
    plain = [c for c in rest if not _is_beside(c)]
    for kind in (_HERTZ, _ANGULAR):
        if matches := [c for c in plain if kind.fullmatch(c.unit)]:
            return matches
    unknown = [
        c for c in plain if not c.unit and not (_INDEX.fullmatch(_stem(c)) and not c.heading.name.isdigit())
    ]
    strange = {c.unit for c in plain if c.unit not in ("", "1")}
    if not unknown and frequency_unit is None and strange:
        raise _ask_unit(table, ", ".join(sorted(strange)))
    chosen = unknown or ([c for c in plain if c.unit] if frequency_unit else [])
    if not chosen and other:
        raise ChannelError.malformed(
            argument=table.path.name,
            given=f"the column {other[0].name} in {other[0].unit}",
            allowed="a column of frequencies, in Hz, kHz or rad/s",
            cause=_no_frequency(other[0].unit),
            next_step="export frequencies" + ", 1 / period," * (kind_of(other[0].unit) == "time") + " in Hz",
        )
    if not chosen:
        raise _refused(
            table,
            f"the columns {shown(', '.join(table.names), 200)}",
            "a column of frequencies, in Hz, kHz or rad/s",
        )
    return chosen


def _factors(table: TextTable, chosen: Sequence[TextColumn], frequency_unit: str | None) -> dict[str, float]:
    """Factors to Hz for each unit of the columns; the unit of the user has priority over that of the file."""
    units = {c.unit for c in chosen}
    given = units - {""}
    only = given.pop() if len(given) == 1 else ""
    return {unit: _hertz(table, frequency_unit or unit or only, frequency_unit) for unit in units}


def _hertz(table: TextTable, unit: str, frequency_unit: str | None) -> float:
    if not unit:
        raise _ask_unit(table, "nothing")
    try:
        return to_si(f"1 {unit}", "Hz", "--frequency-unit")
    except HaptonicError as error:
        if not frequency_unit:
            raise _ask_unit(table, shown(unit)) from error
        raise ChannelError.malformed(
            argument="--frequency-unit",
            given=shown(unit),
            allowed="Hz, kHz, MHz, rad/s, ...",
            cause=_no_frequency(unit) if kind_of(unit) else error.cause,
            next_step="give the unit of the frequencies, such as --frequency-unit=kHz",
        ) from error


def _no_frequency(unit: str) -> str:
    """Reason why a unit is not one of frequency."""
    kind = kind_of(unit)
    return "a period is not a frequency" if kind == "time" else f"the unit is one of {kind}, not of frequency"


def _ask_unit(table: TextTable, given: str) -> ChannelError:
    return ChannelError.missing(
        argument="--frequency-unit",
        given=given,
        allowed="Hz, kHz, MHz, rad/s, ...",
        cause=f"columns of {table.path.name} have no unit, or not a unit of frequency",
        next_step="give the unit: --frequency-unit=kHz",
    )


def _drop_repeated(values: Array, columns: Sequence[TextColumn]) -> tuple[Array, list[TextColumn]]:
    """Drop columns of frequencies that repeat another column, such as "Frequency" beside "Eigenfrequency".

    Numbered columns are bands; they may be equal in a symmetric lattice.
    """
    numbering: dict[tuple[str, str], int] = {}
    # the columns of all bands have one name, but for numbers, and one unit
    shared = [(re.sub(r"[\d@].*$|\d+", "", c.heading.name).strip(" _-"), c.unit) for c in columns]
    of = np.array([numbering.setdefault(name, len(numbering)) for name in shared])
    keep = np.ones(len(columns), dtype=bool)
    differing = int((np.diff(np.sort(values, axis=1), axis=1) > 0).sum(axis=1).argmax()) if len(values) else 0
    for k in range(len(columns)) if len(numbering) > 1 else ():
        twins = np.flatnonzero(keep[:k] & (of[:k] != of[k]))
        for rows in (slice(differing, differing + 1), slice(None)):  # a single row excludes most columns
            if len(twins):
                near = np.isclose(
                    values[rows, twins], values[rows, [k]], rtol=SAME, atol=1e-9, equal_nan=True
                )
                twins = twins[near.all(axis=0)]
        keep[k] = len(twins) == 0
    return values[:, keep], [column for column, keep in zip(columns, keep, strict=True) if keep]


def _without(columns: Sequence[TextColumn], others: Sequence[TextColumn]) -> list[TextColumn]:
    """Columns except for some."""
    numbers = {column.number for column in others}
    return [column for column in columns if column.number not in numbers]


def _loss(
    table: TextTable, left: Sequence[TextColumn], columns: Sequence[TextColumn],
    read: dict[int, NDArray[Any]], shape: tuple[int, ...],
) -> tuple[Array | None, str]:  # fmt: skip
    """Loss factors from complex frequencies or a column of damping, and the name of their origin."""
    with np.errstate(divide="ignore", invalid="ignore"):
        for kind, pattern in _DAMPING.items():
            for column in left:
                if pattern.search(_stem(column)) and column.bad is None and not column.is_text:
                    values = np.real(column.values).astype(float)
                    percent = 0.01 if column.unit == "%" else 1.0
                    loss = {"quality factor": 1 / values, "damping ratio": 2 * percent * values}.get(
                        kind, percent * values
                    )
                    return np.broadcast_to(loss[:, None], shape), column.name
        if any(read[c.number].dtype.kind == "c" for c in columns):
            loss = np.stack(
                [2 * np.abs(np.imag(read[c.number])) / np.real(read[c.number]) for c in columns], axis=1
            )
            return loss, "imaginary parts"
    return None, ""


def _setting(column: TextColumn) -> Settings:
    """Values of parameters behind a name: kx and ky for "freq @ kx=0.1, ky=0"."""
    behind = _AT.search(column.heading.name)
    pairs = _SETTING.finditer((behind["what"] or behind["other"]) if behind else "")
    return tuple(
        (pair["name"], float(pair["value"]))
        for pair in pairs
        if _WAVEVECTOR.fullmatch(pair["name"]) or _AXIS.fullmatch(pair["name"])
    )


def _by_headings(
    table: TextTable, columns: Sequence[TextColumn], values: Array, settings: Sequence[Settings],
    left: tuple[str, ...], axes: Sequence[TextColumn],
) -> TableOfBands:  # fmt: skip
    """Table in which each column of frequencies belongs to the wavevector in its heading."""
    names = {tuple(name for name, _ in setting) for setting in settings}
    if len(names) != 1 or not settings[0]:
        raise _refused(
            table,
            f"the columns {shown(', '.join(table.names), 200)}",
            "a column of the wavevector, such as k, or kx and ky",
        )
    axis_matches = [_AXIS.fullmatch(name) for name in names.pop()]
    return TableOfBands(
        wavevector=np.array([[value for _, value in setting] for setting in settings]),
        axes="".join(match["axis"].lower() for match in axis_matches if match) or "k",
        unit="",
        frequency=values.T,
        blocks=np.zeros(len(columns), dtype=np.int64),
        lines=np.full(len(columns), table.names_line or 0, dtype=np.int64),
        left=(*left, *(c.name for c in axes)),
        remarks=table.remarks,
    )


def _refused(table: TextTable, given: str, allowed: str, next_step: str = "") -> ChannelError:
    return ChannelError.malformed(
        argument=table.path.name,
        given=given,
        allowed=allowed,
        cause="another kind of export, or a line above the numbers that does not contain the names",
        next_step=next_step
        or "export the wavevector and the frequencies, with their names and units above them",
    )
