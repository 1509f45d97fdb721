"""Meaning of the arrays and columns of a scan: by names from the user, or by usual names."""

from __future__ import annotations

import re
import shlex
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from haptonic.channels import Channel, Notebook
from haptonic.channels.labels import Ratio
from haptonic.errors import ScanError
from haptonic.names import listed
from haptonic.response import Reference
from haptonic.vibrometry.curves import Point
from haptonic.vibrometry.estimation.spectra import Estimator

Side = Literal["rows", "columns"]

# Usual names, compared without case, units and blanks; earlier names go before later ones.
NAMES: dict[str, tuple[str, ...]] = {
    "frequency": ("frequency", "freq", "frequencies", "f", "freqs", "fvec", "frequencyvector"),
    "response": (
        "response", "frf", "h1", "h", "hf", "velfrf", "mobility", "receptance", "compliance", "accelerance",
        "inertance", "velocity", "v", "data", "yresp",
    ),
    "real": ("real", "re", "realpart", "responsereal", "frfreal", "hreal", "refrf", "realfrf"),
    "imaginary": (
        "imaginary", "imag", "im", "imaginarypart", "imagpart", "responseimag", "responseimaginary",
        "frfimag", "himag", "imfrf", "imagfrf",
    ),
    "amplitude": ("amplitude", "magnitude", "mag", "ampl", "amp", "abs", "frfmag", "hmag", "absfrf"),
    "phase": ("phase", "phaseangle", "ph", "frfphase", "hphase", "phasefrf"),
    "coherence": ("coherence", "coh", "gamma2", "cxy"),
    "x": ("x", "xs", "xpos", "xcoord", "xcoordinate", "xposition"),
    "y": ("y", "ys", "ypos", "ycoord", "ycoordinate", "yposition"),
    "points": ("points", "xyz", "xy", "coords", "coordinates", "nodes", "pos", "positions"),
    "reference": ("reference", "ref", "drive", "input", "voltage", "excitation"),
    "sample_rate": ("samplerate", "fs", "samplingrate", "rate"),
    "unit": ("unit", "units", "responseunit"),
    "file": ("file", "filename", "name", "point"),
}  # fmt: skip
# Unit of a response that follows from its name, if it has no other
IMPLIED = {
    "mobility": "m/s/N", "receptance": "m/N", "compliance": "m/N", "accelerance": "m/s^2/N",
    "inertance": "m/s^2/N",
}  # fmt: skip
_ENDING = re.compile(
    r"(?P<name>.*\D)_(?P<unit>m|mm|um|µm|cm|nm|hz|khz|mhz|ghz|rad|mrad|deg|degrees|db)", re.I
)
MOST_LISTED = 12  # arrays, in a message
NONE = Reference()


@dataclass(frozen=True)
class Mapped:
    """Options for reading the arrays of a file.

    variables : name of an array or column by its meaning, of `NAMES`; others are guessed from usual names
    unit : of the response in files without one, such as "mm/s/V" or, for time records, "mm/s"
    length_unit, frequency_unit, phase_unit : value of the unit in m, Hz and rad; None for the file's unit
    reference : reference from the user, or empty
    reference_text : text of the user for the reference; None without one
    at : positions of points in files without coordinates
    points_in : side of square arrays that is the points
    estimator : H1, H2 or Hv, if a file has several
    file : file to read
    """

    variables: Mapping[str, str]
    unit: str | None = None
    length_unit: float | None = None
    reference: Reference = NONE
    frequency_unit: float | None = None
    phase_unit: float | None = None
    reference_text: str | None = None
    at: Sequence[Point] = ()
    points_in: Side | None = None
    estimator: Estimator = "H1"
    file: Path = Path("PATH")

    @property
    def path(self) -> str:
        """The file as an argument of a command."""
        return shlex.quote(str(self.file))

    def reference_of(self, unit: Ratio) -> Reference:
        """The reference from the user, or else from the denominator of a unit."""
        named = Reference("reference", unit.under.unit) if unit.under.unit else Reference()
        return self.reference or named


def plain(name: str) -> str:
    """A name without case, blanks and underscores."""
    return re.sub(r"[\s_.\-]", "", unicodedata.normalize("NFKC", name).casefold())


def with_unit(channel: Channel) -> Channel:
    """The channel with the unit at the end of its name, such as that of ``x_mm``."""
    ending = _ENDING.fullmatch(channel.name)
    if ending is None or channel.unit:
        return channel
    return replace(channel, unit=ending["unit"])


def _last(name: str) -> str:
    """The field of a structure, or the data set of a group."""
    return plain(re.split(r"[./]", name)[-1])


def _usual(name: str) -> str:
    """A name without its unit, for comparison with usual names."""
    bare = re.split(r"[\[(]", name)[0]
    ending = _ENDING.fullmatch(bare.strip())
    return plain(ending["name"] if ending else bare)


def chosen(
    arrays: Mapping[str, Channel], how: Mapped, notes: Notebook, meanings: Sequence[str]
) -> dict[str, Channel]:
    """Choose arrays by their meaning.

    Parameters
    ----------
    meanings : meanings to look for

    Raises
    ------
    ScanError : a name from the user is missing, or two arrays have usual names of one meaning
    """
    names = {
        meaning: find_named(name, meaning, arrays, notes)
        for meaning, name in how.variables.items()
        if meaning in meanings
    }
    for meaning in meanings:
        if meaning in names or (meaning == "points" and {"x", "y"} <= names.keys()):
            continue
        guess = _guess(meaning, arrays, set(names.values()), how)
        if guess is not None:
            names[meaning] = guess
            if plain(guess) != plain(meaning):
                notes.remark(f'the variable "{guess}" was used as {meaning}')
    for name in arrays:
        if name not in names.values() and arrays[name].kind != "text":
            notes.remark(f'the variable "{name}" was not used')
    return {meaning: with_unit(arrays[name]) for meaning, name in names.items()}


def check_meanings(how: Mapped, meanings: Iterable[str]) -> None:
    """Refuse names for meanings that a file of this format does not have.

    Raises
    ------
    ScanError : an unknown meaning
    """
    allowed = sorted(set(meanings))
    for meaning in how.variables:
        if meaning not in allowed:
            cause = "no array or column of this form has this meaning"
            raise ScanError.unknown(f"variables.{meaning}", meaning, allowed, cause)


def find_named(name: str, meaning: str, arrays: Mapping[str, Channel], notes: Notebook) -> str:
    """The array that a user named: exactly, or the only one with this name in another case."""
    if name in arrays:
        return name
    for compared in (plain, _usual, _last):
        same = [array for array in arrays if compared(array) == plain(name)]
        if len(same) == 1:
            return same[0]
    if name.isdecimal() and 1 <= int(name) <= len(arrays):
        return list(arrays)[int(name) - 1]
    cause = "no array has this name, or the file is another one"
    if name in notes.unread:
        cause = f"this variable is {notes.unread[name]}"
    raise ScanError.unknown(
        f"variables.{meaning}", name, arrays, cause, allowed=f"one of {inventory(arrays, notes)}"
    )


def _guess(meaning: str, arrays: Mapping[str, Channel], taken: set[str], how: Mapped) -> str | None:
    wanted = "text" if meaning in ("unit", "file") else "numbers"
    for usual in NAMES[meaning]:
        same = [
            name
            for name, array in arrays.items()
            if _usual(name) == usual and name not in taken and (array.kind == "text") == (wanted == "text")
        ]
        if len(same) > 1:
            raise ScanError.conflict(
                argument=f"variables.{meaning}",
                given=listed([f'"{name}"' for name in same]),
                allowed=f"one array for {meaning}",
                cause="several arrays have a usual name of the same meaning",
                next_step=f'name it: read_scan(path, variables={{"{meaning}": "{same[0]}"}})',
                command=f"haptonic scan {how.path} --variables {meaning}={same[0]}",
            )
        if same:
            return same[0]
    return None


def inventory(arrays: Mapping[str, Channel], notes: Notebook) -> str:
    """List of a file's arrays in a sentence: name, kind and shape of each, and unreadable ones."""
    variables = [
        f"{name} ({array.kind}{f' in {array.unit}' * bool(array.unit)}, "
        f"{' x '.join(map(str, array.shape)) or '1'})"
        for name, array in arrays.items()
    ]
    variables += [f"{name} ({kind}, not read)" for name, kind in notes.unread.items()]
    more = len(variables) - MOST_LISTED
    return ", ".join(variables[:MOST_LISTED]) + (f" and {more} more" if more > 0 else "") or "nothing"


def unfit(
    argument: str,
    given: str,
    arrays: Mapping[str, Channel],
    notes: Notebook,
    how: Mapped,
    needed: Sequence[str] = ("response", "frequency", "x", "y"),
) -> ScanError:
    """The error for arrays that are missing or contradict each other; it lists the file's arrays."""
    guesses = {}
    for meaning in needed:
        names = [name for name in arrays if _usual(re.split(r"[./]", name)[-1]) in NAMES[meaning]]
        guesses[meaning] = how.variables.get(meaning) or (names[0] if len(names) == 1 else "NAME")
    python = ", ".join(f'"{meaning}": "{name}"' for meaning, name in guesses.items())
    return ScanError.mismatch(
        argument=argument,
        given=f"{given}; the file contains {inventory(arrays, notes)}",
        allowed="a response (or real and imaginary, or amplitude and phase), x and y (or points), and "
        "frequency for responses or reference and sample_rate for records",
        cause="arrays have other names than usual, or belong to different scans",
        next_step=f"name them: read_scan(path, variables={{{python}}})",
        command=f"haptonic scan {how.path} --variables "
        + ",".join(f"{meaning}={name}" for meaning, name in guesses.items()),
    )
