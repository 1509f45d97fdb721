"""Report on the machine, and a short check of the physics on it."""

from __future__ import annotations

import platform
import time
from importlib.metadata import distributions, version
from typing import Any

import numpy as np

from haptonic import __version__
from haptonic.bloch import bloch_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.cell import MeshPlan, UnitCell
from haptonic.later import psutil
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.parallel import threads
from haptonic.solvers import PardisoSolver, available, chosen
from haptonic.store import Store
from haptonic.superelement import Tiling, condense

PACKAGES = ("numpy", "scipy", "xarray", "h5netcdf", "pydantic", "matplotlib")
OPTIONAL = {  # extra of pyproject.toml -> the package that it installs
    "cad": "netgen-mesher",
    "cholmod": "scikit-sparse",
    "fast": "pypardiso",
    "modal": "sdypy-EMA",
    "notebook": "anywidget",
    "scheduler": "distributed",
    "tdms": "npTDMS",
}
# processor time for the bands of the template touchpad 10.7 s, for its plate at one frequency 29 s;
# with Pardiso 9.0 s and 19 s
FALLBACK = (
    "MKL Pardiso is not in use: bands take about 1.2 times as long, plates 1.5 times; on x86-64, "
    'install it with: pip install "haptonic[fast]"'
)
TOLERANCE = 1e-4  # relative


def examined() -> dict[str, Any]:
    """Facts for a bug report; ``healthy`` is True if the check of the physics succeeds."""
    start = time.perf_counter()
    error = shear_wave_error()
    memory = psutil.virtual_memory()
    return {
        "haptonic": __version__,
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        **{name: version(name) for name in PACKAGES},
        "extras": ", ".join(extra for extra, package in OPTIONAL.items() if installed(package)) or "none",
        "solver": chosen().name,
        **({} if chosen() is PardisoSolver else {"solver_speed": FALLBACK}),
        "solvers_installed": ", ".join(available()),
        "threads": threads(),
        "memory_gb": round(memory.total / 1e9, 1),
        "memory_free_gb": round(memory.available / 1e9, 1),
        "store": str(Store.default().root),
        "physics_error": float(f"{error:.2g}"),  # two digits: a size, not a result
        "physics_seconds": round(time.perf_counter() - start, 2),
        "healthy": bool(error < TOLERANCE),
    }


def installed(package: str) -> bool:
    """True if a package is installed."""
    return any(True for _ in distributions(name=package))


def shear_wave_error() -> float:
    """Relative error of a shear wave along a plain plate; its exact frequency is speed / wavelength."""
    material = IsotropicMaterial(70e9, 0.33, 2700.0, name="check")
    cell = UnitCell(Lattice.square(7e-3), 1.5e-3, material)
    kappa = np.array([0.5 * np.pi, 0.0])
    pencil = bloch_pencil(Tiling.single(condense(cell, MeshPlan(4, 0, 0), measured=False)))
    frequencies = hertz(eigenpairs(pencil, kappa, 6)[0])
    exact = material.shear_speed * float(kappa[0]) / (2 * np.pi * cell.lattice.pitch)
    return float(np.abs(frequencies / exact - 1.0).min())
