"""Report on the machine: versions, optional parts, speed, and a short check of the physics."""

from __future__ import annotations

import os
import platform
import shutil
import time
import webbrowser
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np
import threadpoolctl

from haptonic import __version__
from haptonic.atomic import draft_for
from haptonic.bloch import bloch_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.cell import MeshPlan, UnitCell
from haptonic.errors import ResourceError
from haptonic.later import psutil
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.parallel import THREAD_LIMITS, cores, threads
from haptonic.results.table import Table
from haptonic.solvers import PardisoSolver, available, chosen
from haptonic.store import Store
from haptonic.superelement import Tiling, condense

PACKAGES = ("numpy", "scipy", "xarray", "h5netcdf", "pydantic", "matplotlib")
TOLERANCE = 1e-4  # relative
LEAST_MEMORY = 3e9  # bytes, for a plate of 180 pillars
LEAST_DISK = 1e9  # bytes, for some twenty plates in the store


@dataclass(frozen=True)
class OptionalPart:
    """An optional part of haptonic.

    package : name of the package that the extra of ``pyproject.toml`` installs
    purpose : as in ``docs/install.md``
    """

    package: str
    purpose: str

    @property
    def version(self) -> str | None:
        """Installed version of the package; None if it is missing."""
        try:
            return version(self.package)
        except PackageNotFoundError:
            return None


PARTS = {
    "fast": OptionalPart("pypardiso", "finite plates in two thirds of the time"),
    "cad": OptionalPart("netgen-mesher", "STEP files for the workshop, and cells drawn in a CAD program"),
    "tdms": OptionalPart("npTDMS", "scans and force records of LabVIEW"),
    "notebook": OptionalPart("anywidget", "interactive views of results in a notebook"),
    "modal": OptionalPart("sdypy-EMA", "poles and mode shapes identified from a measured response"),
    "cholmod": OptionalPart("scikit-sparse", "a faster sparse solver where MKL is not available"),
    "scheduler": OptionalPart("distributed", "many designs on several machines"),
}


@dataclass(frozen=True, kw_only=True)
class Machine:
    """The parts of a machine that determine how fast haptonic is.

    solver : name of the sparse solver in use; fast_solver : True for the fastest
    cores : that this process may use; threads : that it uses
    kernels : value of ``OPENBLAS_CORETYPE``
    memory, disk : free bytes; store_fault : reason why the store cannot be written, or empty
    """

    solver: str
    fast_solver: bool
    cores: int
    threads: int
    kernels: str
    memory: float
    disk: float
    store: Path
    store_fault: str

    @classmethod
    def examined(cls, store: Store) -> Machine:
        """Examine this machine, with a store that need not exist."""
        fault = ""
        try:
            with draft_for(store.root):
                pass
        except ResourceError as error:
            fault = error.cause
        existing = next(folder for folder in (store.root, *store.root.parents) if folder.exists())
        return cls(
            solver=chosen().name, fast_solver=chosen() is PardisoSolver, cores=cores(), threads=threads(),
            kernels=os.environ.get("OPENBLAS_CORETYPE", ""), memory=psutil.virtual_memory().available,
            disk=shutil.disk_usage(existing).free, store=store.root, store_fault=fault,
        )  # fmt: skip

    def slow(self) -> list[str]:
        """Reasons why commands would take longer than necessary here, each with a remedy."""
        reasons = []
        if not self.fast_solver:
            # processor time for the bands of the template touchpad 10.7 s, for its plate at one frequency
            # 29 s; with Pardiso 9.0 s and 19 s
            reasons.append(
                f"{self.solver} is used in place of MKL Pardiso: bands take about 1.2 times as long, plates "
                '1.5 times; on x86-64, install it with: pip install "haptonic[fast]"'
            )
        if self.threads < self.cores:
            reasons.append(
                f"Only {self.threads} of {self.cores} cores are used, because OMP_NUM_THREADS is set; remove "
                "this variable."
            )
        if self.kernels:
            reasons.append(
                f"OPENBLAS_CORETYPE={self.kernels} replaces the kernels that OpenBLAS would choose for this "
                "processor; remove this variable."
            )
        if self.memory < LEAST_MEMORY:
            reasons.append(
                f"{self.memory / 1e9:.1f} GB of memory are free, and a plate of 180 pillars needs about "
                f"{LEAST_MEMORY / 1e9:.0f} GB; close other programs."
            )
        if self.store_fault:
            reasons.append(
                f"The store cannot be written: {self.store_fault}. Every result is computed again; set "
                "HAPTONIC_STORE to another folder."
            )
        elif self.disk < LEAST_DISK:
            reasons.append(
                f"The disk of the store has {self.disk / 1e9:.1f} GB left; when it is full, every result is "
                "computed again. Free some space, or set HAPTONIC_STORE to another folder."
            )
        return reasons


def examined() -> dict[str, Any]:
    """Facts for a bug report; ``healthy`` is True if the check of the physics succeeds."""
    start = time.perf_counter()
    error = shear_wave_error()
    seconds = time.perf_counter() - start
    store = Store.default()
    machine = Machine.examined(store)
    files, size = store.size()
    return {
        "haptonic": __version__,
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        **{name: version(name) for name in PACKAGES},
        "solver": machine.solver,
        "solvers_installed": ", ".join(available()),
        "linear_algebra": ", ".join(_libraries()),
        "threads": machine.threads,
        "cores": machine.cores,
        **{name: os.environ[name] for name in THREAD_LIMITS if name in os.environ},
        "memory_gb": round(psutil.virtual_memory().total / 1e9, 1),
        "memory_free_gb": round(machine.memory / 1e9, 1),
        "store": str(store.root),
        "store_files": files,
        "store_gb": round(size / 1e9, 2),
        "store_free_gb": round(machine.disk / 1e9, 1),
        "browser": browser(),
        "physics_error": float(f"{error:.2g}"),  # two digits: a size, not a result
        "physics_seconds": round(seconds, 2),
        "healthy": bool(error < TOLERANCE),
        "parts": [
            {"extra": extra, "package": part.package, "version": part.version, "purpose": part.purpose,
             "install": f'pip install "haptonic[{extra}]"'}
            for extra, part in PARTS.items()
        ],
        "slow": machine.slow(),
    }  # fmt: skip


def tables(report: dict[str, Any]) -> list[Table]:
    """A report of `examined` as tables for people: facts, then optional parts."""
    facts = {name: value for name, value in report.items() if not isinstance(value, list)}
    parts = [
        (part["extra"], part["purpose"], part["version"] or f"missing: {part['install']}")
        for part in report["parts"]
    ]
    rows = [(name if name in THREAD_LIMITS else name.replace("_", " "), str(v)) for name, v in facts.items()]
    return [
        Table("haptonic doctor", ("what", "value"), rows),
        Table("optional parts", ("extra", "needed for", "version"), parts),
    ]


def browser() -> str:
    """Name of the browser in which the studio opens; "none" without one."""
    try:
        return str(getattr(webbrowser.get(), "name", "the system's"))
    except webbrowser.Error:
        return "none"


def _libraries() -> list[str]:
    """Loaded libraries of linear algebra, such as "openblas 0.3.29 (SkylakeX)"."""
    names = set()
    for library in threadpoolctl.threadpool_info():
        if library["user_api"] == "blas":
            kernels = f" ({library['architecture']})" if "architecture" in library else ""
            names.add(f"{library['internal_api']} {library['version']}{kernels}")
    return sorted(names)


def shear_wave_error() -> float:
    """Relative error of a shear wave along a plain plate; its exact frequency is speed / wavelength."""
    material = IsotropicMaterial(70e9, 0.33, 2700.0, name="check")
    cell = UnitCell(Lattice.square(7e-3), 1.5e-3, material)
    kappa = np.array([0.5 * np.pi, 0.0])
    pencil = bloch_pencil(Tiling.single(condense(cell, MeshPlan(4, 0, 0), measured=False)))
    frequencies = hertz(eigenpairs(pencil, kappa, 6)[0])
    exact = material.shear_speed * float(kappa[0]) / (2 * np.pi * cell.lattice.pitch)
    return float(np.abs(frequencies / exact - 1.0).min())
