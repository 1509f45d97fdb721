"""Libraries that most modules name and many runs never use: imported when a name of theirs is asked for.

``from haptonic.later import xarray as xr`` stands for ``import xarray as xr``. All that is below takes half
a second to load, and what only lists, plans or refuses need not wait for them.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

__all__ = [
    "Axes",
    "Figure",
    "csgraph",
    "elementwise",
    "h5py",
    "jinja2",
    "linalg",
    "meshio",
    "pandas",
    "psutil",
    "sparse",
    "sparse_linalg",
    "wavfile",
    "xarray",
]

if TYPE_CHECKING:
    import h5py as h5py
    import jinja2 as jinja2
    import meshio as meshio
    import pandas as pandas
    import psutil as psutil
    import scipy.io.wavfile as wavfile
    import scipy.linalg as linalg
    import scipy.optimize.elementwise as elementwise
    import scipy.sparse as sparse
    import scipy.sparse.csgraph as csgraph
    import scipy.sparse.linalg as sparse_linalg
    import xarray as xarray
    from matplotlib.axes import Axes as Axes
    from matplotlib.figure import Figure as Figure
else:
    Axes = Figure = Any  # results name them in annotations alone; who draws imports matplotlib

    class _Later(ModuleType):
        """Stands for a module; `importlib.util.LazyLoader` would be loaded by the next ``import`` of it."""

        def __getattr__(self, name: str) -> Any:
            return getattr(import_module(self.__name__), name)

    h5py, jinja2, pandas = _Later("h5py"), _Later("jinja2"), _Later("pandas")
    meshio, psutil, xarray = _Later("meshio"), _Later("psutil"), _Later("xarray")
    linalg, wavfile = _Later("scipy.linalg"), _Later("scipy.io.wavfile")
    elementwise = _Later("scipy.optimize.elementwise")
    sparse, sparse_linalg = _Later("scipy.sparse"), _Later("scipy.sparse.linalg")
    csgraph = _Later("scipy.sparse.csgraph")

ASKED_FOR = ("dask", "pint")  # by xarray, wherever they are installed, to know their arrays; it has none here


def leave_out() -> None:
    """Let nobody import what only xarray asks for, which takes 0.6 s; for a process that is ours alone."""
    for name in ASKED_FOR:
        sys.modules.setdefault(name, None)  # type: ignore[arg-type]  # documented: an import of it fails


def admitted(name: str) -> Any:
    """The module of this name after all, imported now."""
    if sys.modules.get(name, ...) is None:
        del sys.modules[name]
    return import_module(name)
