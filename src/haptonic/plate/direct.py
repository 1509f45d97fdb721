"""The answer of a plate at one frequency without any basis: complex, all losses included."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from haptonic.plate.model import PlateModel, impedance
from haptonic.solvers import Pattern, Solver, chosen

Array = NDArray[np.float64]
Ints = NDArray[np.int64]
Complex = NDArray[np.complex128]


class Direct:
    """Answers one frequency after the other; what does not depend on it is done once.

    Modes of the tiles are eliminated, the skeleton is solved for by a real symmetric factorisation of twice
    the size, and the finger is added by Woodbury's formula.
    """

    def __init__(self, model: PlateModel) -> None:
        self.model = model
        beds = model.assembly.beds
        self._lossy = sum(
            (bed.loss_factor * bed.stiffness for bed in model.beds), start=sp.csr_array(beds.shape)
        )

    def answer(self, loads: Complex, omega: float) -> Complex:
        """(size, k) displacement under loads (size, k) at an angular frequency, rad/s."""
        model = self.model
        pad, finger = model.pad, model.plate.finger
        if finger is None:
            return self._without_finger(loads, omega)
        answers = self._without_finger(np.hstack([loads, pad.T.toarray().astype(complex)]), omega)
        own, of_pad = np.split(answers, [loads.shape[1]], axis=1)
        flexibility = np.eye(pad.shape[0]) * pad.shape[0] / impedance(finger, np.array([omega]))[0]
        return np.asarray(own - of_pad @ np.linalg.solve(flexibility + pad @ of_pad, pad @ own))

    def _without_finger(self, loads: Complex, omega: float) -> Complex:
        assembly = self.model.assembly
        eliminated = [group.tile.complex_dynamic(self.model.factors, omega) for group in assembly.groups]
        real = assembly.numbers([one.on_trace.real for one in eliminated], assembly.beds)
        imaginary = assembly.numbers([one.on_trace.imag for one in eliminated], self._lossy)
        self._solver.factorise(self._doubled.numbers(real, imaginary), definite=False)

        def on_skeleton(right: Complex) -> Complex:
            halves = self._solver.solve(np.vstack([right.real, -right.imag]))
            return np.asarray(halves[: assembly.free] + 1j * halves[assembly.free :])

        return assembly.solved(loads, eliminated, on_skeleton)

    @cached_property
    def _doubled(self) -> _Doubled:
        return _Doubled(self.model.assembly.pattern)

    @cached_property
    def _solver(self) -> Solver:
        return chosen()(self._doubled.pattern)


class _Doubled:
    """(R + i I)(x + i y) = b is symmetric as [[R, -I], [-I, -R]] (x, y) = (Re b, -Im b)."""

    def __init__(self, upper: Pattern) -> None:
        size, count = upper.size, len(upper.indices)
        # the number of each entry of the upper triangle, plus one, wherever it stands in the whole matrix
        whole = upper.matrix(np.arange(1.0, count + 1))
        whole.sort_indices()
        self.from_whole = whole.data.astype(np.int64) - 1
        lengths = np.diff(upper.indptr) + np.diff(whole.indptr)
        indptr = np.concatenate([[0], np.cumsum([*lengths, *np.diff(upper.indptr)])])

        def places(of: sp.csr_array | Pattern, start: Ints) -> Ints:
            within = np.arange(len(of.indices)) - np.repeat(of.indptr[:-1], np.diff(of.indptr))
            return np.asarray(np.repeat(start, np.diff(of.indptr)) + within)

        self.first = places(upper, indptr[:size])
        self.between = places(whole, indptr[:size] + np.diff(upper.indptr))
        self.second = places(upper, indptr[size:-1])
        indices = np.empty(indptr[-1], dtype=np.int32)
        indices[self.first] = upper.indices
        indices[self.between] = whole.indices + size
        indices[self.second] = upper.indices + size
        self.pattern = Pattern(indptr.astype(np.int32), indices)

    def numbers(self, real: Array, imaginary: Array) -> Array:
        """Numbers on the pattern from those of two upper triangles."""
        data = np.empty(len(self.pattern.indices))
        data[self.first], data[self.second] = real, -real
        data[self.between] = -imaginary[self.from_whole]
        return data
