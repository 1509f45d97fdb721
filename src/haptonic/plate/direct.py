"""The answer of a plate at one frequency without any basis: complex, all losses included."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from haptonic.plate.model import PlateModel, impedance
from haptonic.solvers import Pattern, chosen

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def direct_answer(model: PlateModel, loads: Complex, omega: float) -> Complex:
    """(size, k) displacement under loads (size, k) at an angular frequency, rad/s.

    Modes of the tiles are eliminated, the skeleton is solved for by a real symmetric factorisation of twice
    the size, and the finger is added by Woodbury's formula.
    """
    pad = model.pad
    right = np.hstack([loads, pad.T.toarray().astype(complex)])
    answers = _without_finger(model, right, omega)
    count = loads.shape[1]
    if not pad.shape[0]:
        return answers
    finger = model.plate.finger
    assert finger is not None
    own, of_pad = answers[:, :count], answers[:, count:]
    flexibility = np.eye(pad.shape[0]) * pad.shape[0] / impedance(finger, np.array([omega]))[0]
    return np.asarray(own - of_pad @ np.linalg.solve(flexibility + pad @ of_pad, pad @ own))


def _without_finger(model: PlateModel, loads: Complex, omega: float) -> Complex:
    assembly, factors = model.assembly, model.factors
    matrices, eliminated = [], []
    reduced = loads[: assembly.free].copy()
    pieces = []
    for group, share in assembly.shares(loads):
        tile = group.tile
        trace = tile.trace_size
        whole = sum(factors[name] * part for name, part in tile.stiffness.items()) - omega**2 * tile.mass
        inner = np.linalg.inv(whole[trace:, trace:])
        follow = -inner @ whole[trace:, :trace]
        matrices.append(whole[:trace, :trace] + whole[:trace, trace:] @ follow)
        eliminated.append((inner, follow))
        own = share[:, trace:]
        pieces.append(np.concatenate([follow.T @ own, np.zeros_like(own)], axis=1))
    reduced += assembly.gathered(pieces)[: assembly.free]
    on_skeleton = _solved(model, matrices, reduced)
    out = np.zeros((assembly.size + 1, loads.shape[1]), dtype=complex)
    out[: assembly.free] = on_skeleton
    for (group, share), (inner, follow) in zip(assembly.shares(loads), eliminated, strict=True):
        trace = group.tile.trace_size
        out[group.unknowns[:, trace:]] = inner @ share[:, trace:] + follow @ out[group.unknowns[:, :trace]]
    return out[:-1]


def _solved(model: PlateModel, matrices: list[NDArray[Any]], right: Complex) -> Complex:
    """Solution on the skeleton: (R + i I)(x + i y) = b is symmetric as [[R, -I], [-I, -R]] (x, y)."""
    assembly = model.assembly
    without_beds = [assembly.numbers([part(matrix) for matrix in matrices]) for part in (np.real, np.imag)]
    real, imaginary = (assembly.pattern.matrix(numbers) for numbers in without_beds)
    # `numbers` adds the beds to either
    beds = sp.csr_array(assembly.beds)
    lossy = sum((bed.loss_factor * bed.stiffness for bed in model.beds), start=sp.csr_array(beds.shape))
    imaginary = imaginary - beds + lossy
    both = sp.csr_array(sp.triu(sp.block_array([[real, -imaginary], [-imaginary, -real]])))
    both.sort_indices()
    pattern = Pattern(both.indptr.astype(np.int32), both.indices.astype(np.int32))
    solver = chosen()(pattern)
    solver.factorise(both.data, definite=False)
    halves = solver.solve(np.vstack([right.real, -right.imag]))
    return np.asarray(halves[: assembly.free] + 1j * halves[assembly.free :])
