"""Sparse symmetric direct solvers with a common interface.

A `Pattern` is analysed once; any values on it are then factorised without a new analysis. MKL Pardiso is
used if it is installed, otherwise CHOLMOD, otherwise SciPy's SuperLU. ``HAPTONIC_SOLVER`` selects one.
"""

from __future__ import annotations

import ctypes
import importlib.metadata
import importlib.util
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.errors import HaptonicError, NumericalError
from haptonic.later import sparse as sp, sparse_linalg

Indices = NDArray[np.int32]


@dataclass(frozen=True)
class Pattern:
    """Pattern of the upper triangle of a symmetric sparse matrix in compressed rows, with the whole diagonal.

    indptr : (n + 1,), indices : (nnz,) ascending within a row
    order : (n,) unknowns in the order of elimination, if known; otherwise the solver computes one
    """

    indptr: Indices
    indices: Indices
    order: Indices | None = None

    @property
    def size(self) -> int:
        return len(self.indptr) - 1

    def matrix(self, data: Array) -> sp.csr_array:
        """The whole symmetric matrix; values that are zero keep their entries."""
        rows = np.repeat(np.arange(self.size, dtype=np.int32), np.diff(self.indptr))
        off = rows != self.indices
        both = (np.concatenate([rows, self.indices[off]]), np.concatenate([self.indices, rows[off]]))
        return sp.csr_array((np.concatenate([data, data[off]]), both), shape=(self.size, self.size))


@contextmanager
def definite() -> Iterator[None]:
    """Raise NumericalError if a cell's stiffness or mass, which must be positive, is not."""
    try:
        yield
    except np.linalg.LinAlgError as error:
        raise NumericalError.inaccurate(
            argument="cell",
            given="sizes whose stiffness is not positive in the computer's arithmetic",
            allowed="sizes that are not too many powers of ten apart",
            cause="a very thin plate, or very unlike sizes",
            next_step="choose a thicker plate or a smaller pitch",
        ) from error


class Solver(Protocol):
    """Analysed pattern with at most one factorisation at a time.

    slower : processor time of a cell's model over that with MKL Pardiso, for estimates; 1.2 measured for the
        prototype, 1.4 and 2.7 for a steel honeycomb at orders 5 and 6 with SuperLU; not measured with CHOLMOD
    """

    name: str
    slower: float

    def __init__(self, pattern: Pattern) -> None: ...

    def factorise(self, data: Array, *, definite: bool = True) -> int:
        """Factorise the values ``data`` on the pattern and return the number of negative eigenvalues.

        Raises ``numpy.linalg.LinAlgError`` if the matrix is singular, or not definite when it should be.
        """

    def solve(self, right: Array) -> Array:
        """(n, m) solutions for (n, m) right-hand sides with the latest factorisation."""


class PardisoSolver:
    """MKL Pardiso without iterative refinement, which costs a factor of 40 for many right-hand sides.

    It always uses one thread: OpenMP's limits apply to the calling thread only, and an analysis with another
    number of threads than its factorisation gives wrong counts or crashes. Several threads of our own, each
    with its solver, use the cores better.
    """

    name, slower = "MKL Pardiso", 1.0

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern
        self._rows, self._columns = pattern.indptr.astype(np.int32), pattern.indices.astype(np.int32)
        self._handles: dict[int, NDArray[np.int64]] = {}
        self._data: Array = np.empty(0)
        self._type = 2
        self._order = np.zeros(1, dtype=np.int32) if pattern.order is None else pattern.order.astype(np.int32)
        self._settings = np.zeros(64, dtype=np.int32)
        # numbers of the settings as in the MKL manual, less one
        self._settings[[0, 1, 4, 7, 9, 20, 34]] = 1, 2, pattern.order is not None, 0, 8, 1, 1

    def factorise(self, data: Array, *, definite: bool = True) -> int:
        # an analysis for indefinite matrices can be used for definite ones too
        self._type = 2 if definite and -2 not in self._handles else -2
        self._data = np.ascontiguousarray(data, dtype=np.float64)
        if definite and not (self._data[self._rows[:-1]] > 0).all():  # Pardiso does not check these pivots
            raise np.linalg.LinAlgError("the matrix is not definite: its diagonal is not positive")
        if self._type not in self._handles:
            self._handles[self._type] = np.zeros(64, dtype=np.int64)
            self._call(11)
        self._call(22)
        if self._type == 2:
            return 0
        if self._settings[13]:
            raise np.linalg.LinAlgError("the matrix is singular: pivots had to be perturbed")
        negative = int(self._settings[22])
        if definite and negative:
            raise np.linalg.LinAlgError("the matrix is not definite")
        return negative

    def solve(self, right: Array) -> Array:
        flat = np.asfortranarray(right, dtype=np.float64)
        out = np.empty_like(flat, order="F")
        self._call(33, flat, out)
        return out

    def _call(self, phase: int, right: Array | None = None, out: Array | None = None) -> None:
        def number(value: int) -> Any:
            return ctypes.byref(ctypes.c_int32(value))

        def integers(array: Indices) -> Any:
            return array.ctypes.data_as(ctypes.POINTER(ctypes.c_int32))

        def reals(array: Array | None) -> Any:
            return None if array is None else array.ctypes.data_as(ctypes.c_void_p)

        count = 1 if right is None or right.ndim == 1 else right.shape[1]
        handle = self._handles[self._type].ctypes.data_as(ctypes.POINTER(ctypes.c_int64))
        error = ctypes.c_int32(0)
        pardiso, set_threads = _mkl_functions()
        before = set_threads(1)
        pardiso(
            handle, number(1), number(1), number(self._type), number(phase), number(self._pattern.size),
            reals(self._data), integers(self._rows), integers(self._columns), integers(self._order),
            number(count), integers(self._settings), number(0), reals(right), reals(out), ctypes.byref(error),
        )  # fmt: skip
        set_threads(before)
        if error.value in (-4, -7):
            raise np.linalg.LinAlgError("the matrix is singular or not definite")
        if error.value == -2:
            raise MemoryError("MKL Pardiso ran out of memory")
        if error.value:
            raise RuntimeError(f"MKL Pardiso stopped with error {error.value} in phase {phase}")

    def __del__(self) -> None:
        if sys.is_finalizing():
            return  # the memory is freed with the process
        for kind in list(getattr(self, "_handles", {})):  # Ctrl-C may come before they are there
            self._type = kind
            self._call(-1)


class CholmodSolver:
    """CHOLMOD of SuiteSparse, through scikit-sparse."""

    name, slower = "CHOLMOD", 1.0

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern
        self._factor: Any = None
        self._indefinite: SuperLUSolver | None = None

    def factorise(self, data: Array, *, definite: bool = True) -> int:
        if not definite:  # CHOLMOD's L D L' has no pivoting; the count of SuperLU is more reliable
            self._indefinite = SuperLUSolver(self._pattern)
            return self._indefinite.factorise(data, definite=False)
        from sksparse import cholmod  # optional dependency

        self._indefinite = None
        matrix = sp.csc_array(self._pattern.matrix(data))
        try:
            if self._factor is None:
                self._factor = cholmod.analyze(matrix, mode="supernodal")
            self._factor.cholesky_inplace(matrix)
        except cholmod.CholmodNotPositiveDefiniteError:
            raise np.linalg.LinAlgError("the matrix is not definite") from None
        return 0

    def solve(self, right: Array) -> Array:
        if self._indefinite is not None:
            return self._indefinite.solve(right)
        return np.asarray(self._factor(right))


class SuperLUSolver:
    """SciPy's SuperLU, slower by an order of magnitude but always available."""

    name, slower = "SciPy SuperLU", 1.6

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern
        self._factor: Any = None

    def factorise(self, data: Array, *, definite: bool = True) -> int:
        matrix = sp.csc_array(self._pattern.matrix(data))
        try:
            self._factor = sparse_linalg.splu(
                matrix,
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:
            raise np.linalg.LinAlgError("the matrix is singular") from None
        # without row exchanges U's diagonal is that of L D L', whose signs count eigenvalues (Sylvester)
        if not np.array_equal(self._factor.perm_r, self._factor.perm_c):
            raise np.linalg.LinAlgError("SuperLU had to exchange rows; the count of signs would be wrong")
        negative = int((self._factor.U.diagonal() < 0).sum())
        if definite and negative:
            raise np.linalg.LinAlgError("the matrix is not definite")
        return negative

    def solve(self, right: Array) -> Array:
        return np.asarray(self._factor.solve(np.asarray(right)))


@cache
def _mkl_functions() -> tuple[Any, Any]:
    """Pardiso, and the function that sets MKL's threads for the calling thread, returning the old number."""
    # idle threads of MKL otherwise spin for 0.2 s after every call and occupy the cores
    os.environ.setdefault("KMP_BLOCKTIME", "0")
    if "PYPARDISO_MKL_RT" not in os.environ and (library := _mkl_library()):
        os.environ["PYPARDISO_MKL_RT"] = library
    from pypardiso import PyPardisoSolver  # optional dependency; loads the library

    loaded = PyPardisoSolver()
    return loaded._mkl_pardiso, loaded.libmkl.MKL_Set_Num_Threads_Local


def _mkl_library() -> str | None:
    """Path of pip's MKL; without it pypardiso searches the whole environment, which takes a second."""
    try:
        files = importlib.metadata.files("mkl") or []
    except importlib.metadata.PackageNotFoundError:
        return None
    return next((str(file.locate()) for file in files if "mkl_rt" in file.name), None)


SOLVERS: dict[str, tuple[str | None, type[Solver]]] = {
    "pardiso": ("pypardiso", PardisoSolver),
    "cholmod": ("sksparse", CholmodSolver),
    "superlu": (None, SuperLUSolver),
}


def available() -> list[str]:
    """Short names of the installed solvers, the fastest first."""
    return [
        name for name, (module, _) in SOLVERS.items()
        if module is None or importlib.util.find_spec(module) is not None
    ]  # fmt: skip


def chosen() -> type[Solver]:
    """The fastest installed solver, or the one in ``HAPTONIC_SOLVER``."""
    wanted = os.environ.get("HAPTONIC_SOLVER") or available()[0]
    if wanted not in available():
        cause = "the name is misspelt, or that solver's package is not installed"
        raise HaptonicError.unknown("HAPTONIC_SOLVER", wanted, available(), cause)
    return SOLVERS[wanted][1]
