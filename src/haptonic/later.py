"""Libraries that most modules name but many runs do not use, imported on first access.

``from haptonic.later import xarray as xr`` replaces ``import xarray as xr``. The libraries below take half a
second to load; lists, plans and refusals do not need them.
"""

from __future__ import annotations

import gc
import os
import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

__all__ = [
    "Axes",
    "Figure",
    "colors",
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
    import matplotlib.colors as colors
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
    Axes = Figure = Any  # used in annotations only; code that draws imports matplotlib

    class _Later(ModuleType):
        """A module that is imported on first access; `LazyLoader` would load it on the next ``import``."""

        def __getattr__(self, name: str) -> Any:
            return getattr(import_module(self.__name__), name)

    h5py, jinja2, pandas = _Later("h5py"), _Later("jinja2"), _Later("pandas")
    meshio, psutil, xarray = _Later("meshio"), _Later("psutil"), _Later("xarray")
    colors = _Later("matplotlib.colors")
    linalg, wavfile = _Later("scipy.linalg"), _Later("scipy.io.wavfile")
    elementwise = _Later("scipy.optimize.elementwise")
    sparse, sparse_linalg = _Later("scipy.sparse"), _Later("scipy.sparse.linalg")
    csgraph = _Later("scipy.sparse.csgraph")

# of the garbage collector, before a command that ends soon raises them; they depend on the version of Python
USUAL_THRESHOLDS = gc.get_threshold()
ASKED_FOR = ("dask", "pint")  # xarray imports them if installed, to support their arrays; not used here


def leave_out() -> None:
    """Block work of libraries that haptonic does not use; only for a process of our own.

    Imports that only xarray makes take 0.6 s, pydantic's search of all packages for its plug-ins 0.04 s.
    """
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    for name in ASKED_FOR:
        sys.modules.setdefault(name, None)  # type: ignore[arg-type]  # documented: its import then fails


def admitted(name: str) -> Any:
    """Import a module that `leave_out` has blocked."""
    if sys.modules.get(name, ...) is None:
        del sys.modules[name]
    return import_module(name)
