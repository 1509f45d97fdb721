"""MATLAB files: version 5, and version 7.3, which is HDF5."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from haptonic.foreign.process import ForeignError, ask
from haptonic.vibrometry.findings import ELSEWHERE, Notebook
from haptonic.vibrometry.readers.stored import Stored, damaged_matlab
from haptonic.vibrometry.readers.tables import ORIGIN

LARGE = 16_000_000  # numbers, from which a variable of version 7.3 stays in the file until it is asked for


def matlab_arrays(path: Path, notes: Notebook) -> dict[str, Any]:
    """Numeric variables of a file by name, large ones as `Stored`; fields of a structure as
    ``structure.field``. A text ``origin`` that says "simulated" is found as well.

    Raises
    ------
    ScanError : the file is of neither version, or damaged
    OSError, MemoryError : it may not be read, or does not fit into memory
    """
    try:
        found = ask("matlab.variables", path, large=LARGE)
    except ForeignError as error:
        raise damaged_matlab(path, error) from error
    for name in found["others"]:
        notes.remark(f'the variable "{name}" holds no numbers')
    for name in found["elsewhere"]:
        notes.drop(f'the variable "{name}"', ELSEWHERE)
    stored = {name: Stored(path, inside, tuple(shape)) for name, (inside, shape) in found["stored"].items()}
    origin = {} if found[ORIGIN] is None else {ORIGIN: found[ORIGIN]}
    arrays: dict[str, Any] = found["arrays"]
    return arrays | stored | origin
