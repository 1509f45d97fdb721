"""Files of pictures. A picture of the same numbers that the same code has drawn before is not drawn again.

The store contains the files of a picture under a key from everything that it shows and from all code that
draws it. The files in the user's folder are never trusted: each is written again, from the store or drawn.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import fields
from functools import cache, partial
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic import plots
from haptonic.hdf5 import STUDY
from haptonic.plots.looks import PICTURE_KINDS, choice
from haptonic.progress import Progress
from haptonic.results.common import write_files
from haptonic.store import Store, content_key, source_hash

if TYPE_CHECKING:
    import xarray as xr

    from haptonic.results.result import Result


def write_pictures(result: Result, folder: Path, progress: Progress) -> None:
    """Write all pictures of a result into a folder that contains no files of these names."""
    shown, store, figures = shown_by(result), Store.default(), result.figures
    for done, name in enumerate(figures):
        progress(done, len(figures), "pictures")
        paths = {kind: folder / f"{name}.{kind}" for kind in PICTURE_KINDS}
        key = None if shown is None else content_key({**shown, "picture": name})
        stored = {kind: store.read(key, kind) for kind in PICTURE_KINDS} if key else {}
        writers = {
            paths[kind].name: partial(Path.write_bytes, data=content)
            for kind, content in stored.items()
            if content is not None
        }
        if len(writers) == len(PICTURE_KINDS):
            write_files(folder, writers, overwrite=False)
            continue
        plots.save(figures[name], folder, name)
        if key:
            for kind, path in paths.items():
                store.write(key, path.read_bytes(), kind)


@cache
def drawing_fingerprint() -> str:
    """Hash of the code that only draws: the source of the plots and the versions of matplotlib and Pillow."""
    versions = {name: version(name) for name in ("matplotlib", "pillow")}
    return source_hash(Path(plots.__file__).parent, versions, omitted=frozenset())


def shown_by(result: Result) -> dict[str, Any] | None:
    """Everything that the pictures of a result depend on; None for a result with more than one dataset.

    A result with other fields, such as a plate, is always drawn, because its key would take longer.
    """
    if [field.name for field in fields(result)] != ["dataset"]:  # type: ignore[arg-type]  # a dataclass
        return None
    look = choice()
    return {
        "kind": "picture",
        "result": f"{type(result).__module__}.{type(result).__qualname__}",
        "data": _contents(result.dataset),
        "drawing": drawing_fingerprint(),
        "look": (look.look, look.legend, look.colours),
    }


def _contents(dataset: xr.Dataset) -> dict[str, Any]:
    """All numbers and attributes of a dataset but its study, in a form for `haptonic.store.canonical`."""
    variables = {
        str(name): (variable.dims, _hashed(variable.values), _attributes(variable.attrs))
        for name, variable in dataset.variables.items()
    }
    shown = {name: value for name, value in dataset.attrs.items() if name != STUDY}
    return {"variables": variables, "attributes": _attributes(shown)}


def _attributes(attributes: Mapping[Any, Any]) -> dict[str, Any]:
    return {
        str(name): _hashed(value) if isinstance(value, np.ndarray) else value
        for name, value in attributes.items()
    }


def _hashed(values: np.ndarray[Any, Any]) -> tuple[Any, ...]:
    """Type, shape and hash of an array; an array of texts as a list."""
    if values.dtype == object:
        return "texts", values.shape, values.ravel().tolist()
    digest = hashlib.sha256(np.ascontiguousarray(values).data)
    return values.dtype.str, values.shape, digest.hexdigest()
