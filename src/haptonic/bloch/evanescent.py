"""Waves at a given frequency, those that die out included: the complex band structure k(omega).

Seen along one translation a cell is a slab between two faces. A wave multiplies what happens on its left
face by a complex number lambda on the right one; within a gap no |lambda| is 1 and the waves fade. All
that is below the slab of a cell takes plain face matrices, whatever they were made from.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.cell import UnitCell
from haptonic.later import csgraph
from haptonic.later import linalg as la
from haptonic.superelement import Superelement, repeated

SHIFT = 1.2 * np.exp(0.9j)  # multiplier about which the waves are sought, off the unit circle
ON_CIRCLE = 1e-7  # real part of an exponent below which a wave counts as propagating
COINCIDENT = 1e-6  # distance below which two multipliers count as the same
SMALLEST = 1e-200  # stands for a multiplier, or a shifted inverse, that is zero


@dataclass(frozen=True)
class FaceStiffness:
    """Dynamic stiffness of a slab, N/m: forces on its left (L) and right (R) face that move these faces.

    LL, LR, RL, RR : (n, n) complex; ``LR`` is the force on the left that a motion of the right face takes
    """

    LL: Complex
    LR: Complex
    RL: Complex
    RR: Complex

    @classmethod
    def of(cls, whole: NDArray[Any]) -> FaceStiffness:
        """From a matrix (2n, 2n), the left face first."""
        n = len(whole) // 2
        return cls(whole[:n, :n], whole[:n, n:], whole[n:, :n], whole[n:, n:])

    @property
    def size(self) -> int:
        return len(self.LL)

    def followed_by(self, right: FaceStiffness) -> FaceStiffness:
        """This slab and another one on its right, the face between them free of forces from outside."""
        n = self.size
        answer = la.solve(self.RR + right.LL, np.hstack([self.RL, right.LR]))
        return FaceStiffness(
            self.LL - self.LR @ answer[:, :n],
            -self.LR @ answer[:, n:],
            -right.RL @ answer[:, :n],
            right.RR - right.RL @ answer[:, n:],
        )

    def projected(self, basis: Complex) -> FaceStiffness:
        """On face motions (n, p) alone, forces by the work that they do on these."""
        adjoint = basis.conj().T
        return FaceStiffness(*(adjoint @ block @ basis for block in (self.LL, self.LR, self.RL, self.RR)))


def row_cell(superelement: Superelement) -> UnitCell:
    """The cell that rows consist of.

    Raises
    ------
    GeometryError : several sites, or a lattice without right angles
    """
    cell = superelement.cell
    assert isinstance(cell, UnitCell), "a tile by itself has no rows"
    cell.check_simple("a row of cells")
    return cell


@dataclass(frozen=True)
class Slab:
    """A cell between two of its lateral faces, at a fixed phase along them.

    Boundary unknowns: the left face, the right face (n each), then what lies between them on the two
    other faces. Each face has unknowns (level, place, component); the place at its far end is the image of
    the first one and not counted.

    stiffness, mass : (b, b) on the boundary; coupling : (b, m) mass between it and the cell's modes
    poles : (m,) eigenvalues of these modes, (rad/s)^2
    size : n, unknowns of a face
    positions : (positions,) positions along the face, from its first corner, m
    """

    stiffness: Complex
    mass: Complex
    coupling: Complex
    poles: Array
    size: int
    positions: Array

    @classmethod
    def of(cls, superelement: Superelement, phase: float, direction: int = 0) -> Slab:
        """The cell seen along translation ``direction``, at the phase (rad) along the other one.

        Raises
        ------
        GeometryError : a lattice without right angles
        """
        lattice = row_cell(superelement).lattice
        topology, levels = superelement.mesh.topology, superelement.levels
        master, shift = repeated(superelement.mesh.points[topology.rim[0], :2], lattice.vectors)
        position = superelement.mesh.points[topology.rim[0], 1 - direction]
        face = np.unique(master[shift[:, direction] == 1])
        face = face[np.argsort(position[face])]
        size = 3 * levels * len(face)
        column = np.empty((levels, len(master), 3), dtype=np.int64)
        for group, first in ((face, 0), (np.setdiff1d(master, face), 2 * size)):
            numbers = first + np.arange(3 * levels * len(group)).reshape(levels, -1, 3)
            slot = np.empty(len(master), dtype=np.int64)
            slot[group] = np.arange(len(group))
            member = np.isin(master, group)
            column[:, member] = numbers[:, slot[master[member]]]
        column += size * shift[:, direction, None]
        turn = np.broadcast_to(np.exp(1j * phase * shift[:, 1 - direction, None]), column.shape)

        traces = superelement.trace_size
        spread: Complex = np.zeros((traces, column.max() + 1), dtype=complex)
        spread[np.arange(traces), column.ravel()] = turn.ravel()
        fold = spread.conj().T
        K, M = superelement.stiffness, superelement.mass
        return cls(
            stiffness=np.asarray(fold @ K[:traces, :traces] @ spread, dtype=complex),
            mass=np.asarray(fold @ M[:traces, :traces] @ spread, dtype=complex),
            coupling=np.asarray(fold @ M[:traces, traces:], dtype=complex),
            poles=np.diag(K)[traces:],
            size=size,
            positions=position[face] - position[face[0]],
        )

    def at(self, omega: float, loss_factor: float = 0.0) -> FaceStiffness:
        """Dynamic stiffness at omega (rad/s), nothing but the faces kept.

        All of the stiffness is ``1 + i loss_factor`` times the real one.
        """
        loss = 1 + 1j * loss_factor
        answer = (omega**4 / (loss * self.poles - omega**2))[:, None] * self.coupling.conj().T
        whole = loss * self.stiffness - omega**2 * self.mass - self.coupling @ answer
        faces, inner = slice(2 * self.size), slice(2 * self.size, None)
        follow = la.solve(whole[inner, inner], whole[inner, faces])
        return FaceStiffness.of(whole[faces, faces] - whole[faces, inner] @ follow)


@dataclass(frozen=True)
class Waves:
    """Waves that go, or die out, to one side of a plane: those that carry energy first, then by their reach.

    exponent : (w,) complex, its exponential multiplies a wave from one face to the next on the right
    displacement : (n, w) of a face, m; force : (n, w) that what lies left of it exerts on what lies right, N
    propagates : (w,) whether a wave carries energy: 1 W if it does, and the others are scaled so that the
        norms of force and velocity would give 1 W
    """

    exponent: Complex
    displacement: Complex
    force: Complex
    propagates: Bools

    def __len__(self) -> int:
        return len(self.exponent)

    def chosen(self, members: Ints) -> Waves:
        """Some of the waves."""
        return Waves(
            self.exponent[members],
            self.displacement[:, members],
            self.force[:, members],
            self.propagates[members],
        )

    def impedance(self) -> Complex:
        """(n, n) force per displacement on the face of a half-space in which there are only these n waves."""
        return np.asarray(la.solve(self.displacement.T, self.force.T).T)


def energy_flux(displacement: Complex, force: Complex, omega: float) -> Complex:
    """(w, w) Hermitian form of the power that waves (n, w) carry to the right, W.

    Its diagonal is ``Re(force* (i omega displacement)) / 2``. Without losses it is the same on all faces, so
    the waves a and b have no entry unless ``conj(lambda_a) lambda_b = 1``.
    """
    work = displacement.conj().T @ force
    return np.asarray(-0.25j * omega * (work - work.conj().T))


def directed(exponent: Complex, displacement: Complex, force: Complex, omega: float) -> tuple[Waves, Waves]:
    """Waves to the right and waves to the left, out of the 2n of a slab or a plate.

    Those that fade go where they fade to, those that propagate where their energy goes. Among propagating
    ones with the same multiplier combinations are taken that carry energy independently of each other.
    """
    scale = np.linalg.norm(displacement, axis=0) * np.linalg.norm(force, axis=0)
    scale = np.sqrt(2 / (omega * scale))
    displacement, force = displacement * scale, force * scale
    propagates = np.abs(exponent.real) < ON_CIRCLE
    to_right = exponent.real < 0
    moving = np.flatnonzero(propagates)
    multiplier = np.exp(exponent[moving])
    _, cluster = csgraph.connected_components(np.abs(multiplier[:, None] - multiplier) < COINCIDENT)
    for number in range(cluster.max(initial=-1) + 1):
        same = moving[cluster == number]
        power, turn = la.eigh(energy_flux(displacement[:, same], force[:, same], omega))
        turn = turn / np.sqrt(np.abs(power))
        displacement[:, same], force[:, same] = displacement[:, same] @ turn, force[:, same] @ turn
        to_right[same] = power > 0

    everything = Waves(exponent, displacement, force, propagates)

    def sorted_out(chosen: Bools) -> Waves:
        members = np.flatnonzero(chosen)
        reach = np.where(propagates[members], -1.0, np.abs(exponent[members].real))
        return everything.chosen(members[np.argsort(reach, kind="stable")])

    right, left = sorted_out(to_right), sorted_out(~to_right)
    assert len(right) == len(left), "as many waves go to the right as to the left"
    return right, left


def bloch_waves(slab: FaceStiffness, omega: float) -> tuple[Waves, Waves]:
    """Waves of an endless row of slabs, on the left face of each: n to the right, n to the left.

    No force from outside acts where two slabs meet, so that ``RL + (LL + RR) lambda + LR lambda^2`` maps the
    displacement of a face to zero. With ``mu = 1 / (lambda - SHIFT)`` it is a standard eigenproblem in which
    neither lambda = 0 nor infinity is special.
    """
    n = slab.size
    middle = slab.LL + slab.RR
    at_shift = slab.RL + SHIFT * (middle + SHIFT * slab.LR)
    companion = np.zeros((2 * n, 2 * n), dtype=complex)
    companion[:n, n:] = np.eye(n)
    companion[n:] = -la.solve(at_shift, np.hstack([slab.LR, middle + 2 * SHIFT * slab.LR]))
    mu, fields = np.linalg.eig(companion)  # NumPy's is nearly twice as fast here as SciPy's
    multiplier = SHIFT + 1 / np.where(np.abs(mu) < SMALLEST, SMALLEST, mu)
    multiplier = np.where(np.abs(multiplier) < SMALLEST, SMALLEST, multiplier)
    u = fields[:n]
    outer = np.abs(multiplier) > 1  # whichever power of lambda is the smaller one
    ahead, behind = np.where(outer, 0, multiplier), np.where(outer, 1 / multiplier, 0)
    force = np.where(outer, -slab.RR @ u - (slab.RL @ u) * behind, slab.LL @ u + (slab.LR @ u) * ahead)
    return directed(np.log(multiplier), u, force, omega)


def attenuation(
    superelement: Superelement, omega: Array, phases: Array, direction: int = 0, loss_factor: float = 0.0
) -> Array:
    """(frequencies, phases) decay of the farthest-reaching wave, dB per cell; 0 where a wave propagates.

    Parameters
    ----------
    omega : (frequencies,) rad/s; phases : (phases,) along the faces, rad
    direction : number of the translation along which waves fade
    """
    found = np.empty((len(omega), len(phases)))
    for column, phase in enumerate(phases):
        slab = Slab.of(superelement, float(phase), direction)
        for row, at in enumerate(omega):
            right, _ = bloch_waves(slab.at(float(at), loss_factor), float(at))
            found[row, column] = decibels(right)
    return found


def decibels(right: Waves) -> float:
    """Decay per cell of the wave to the right that reaches farthest, dB; 0 if it propagates."""
    return 0.0 if right.propagates[0] else float(-20 / np.log(10) * right.exponent[0].real)
