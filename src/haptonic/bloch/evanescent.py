"""Waves at a given frequency, evanescent waves included: the complex band structure k(omega).

A few rows of cells are a slab between two faces. For a wave, displacement and force of the right face are
those of the left face times a complex number lambda. Within a gap no |lambda| is 1 and all waves decay. The
functions below `Slab` need only face matrices.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.bloch.slab_boundary import SlabBoundary
from haptonic.later import csgraph, linalg as la
from haptonic.superelement import Tiling

SHIFT = 1.2 * np.exp(0.9j)  # multiplier about which the waves are computed, off the unit circle
ON_CIRCLE = 1e-7  # real part of an exponent below which a wave counts as propagating
COINCIDENT = 1e-6  # distance below which two multipliers count as equal
SMALLEST = 1e-200  # replaces a multiplier, or a shifted inverse, that is zero


@dataclass(frozen=True)
class FaceStiffness:
    """Dynamic stiffness of a slab, N/m: forces on its left (L) and right (R) face per displacement of these.

    LL, LR, RL, RR : (n, n) complex; ``LR`` is the force on the left face for a motion of the right one
    """

    LL: Complex
    LR: Complex
    RL: Complex
    RR: Complex

    @classmethod
    def of(cls, whole: NDArray[Any]) -> FaceStiffness:
        """Split a matrix (2n, 2n), the left face first."""
        n = len(whole) // 2
        return cls(whole[:n, :n], whole[:n, n:], whole[n:, :n], whole[n:, n:])

    @property
    def size(self) -> int:
        return len(self.LL)

    def followed_by(self, right: FaceStiffness) -> FaceStiffness:
        """Join another slab on the right, without external forces on the common face."""
        n = self.size
        answer = la.solve(self.RR + right.LL, np.hstack([self.RL, right.LR]))
        return FaceStiffness(
            self.LL - self.LR @ answer[:, :n],
            -self.LR @ answer[:, n:],
            -right.RL @ answer[:, :n],
            right.RR - right.RL @ answer[:, n:],
        )

    def projected(self, basis: Complex) -> FaceStiffness:
        """Project onto face motions (n, p); forces are given by their work on these motions."""
        adjoint = basis.conj().T
        return FaceStiffness(*(adjoint @ block @ basis for block in (self.LL, self.LR, self.RL, self.RR)))


@dataclass(frozen=True)
class Slab:
    """Piece of plate between two faces, one period long, at a fixed phase along the faces.

    Boundary unknowns: the left face, the right face (n each), then the sides between them. Each face has
    unknowns (level, place, component), without the images of places one period away.

    stiffness, lossless : (b, b) on the boundary, of tiles with losses and of tiles without
    mass : (b, b); coupling : (b, m) mass between it and the modes of the tiles
    poles : (m,) eigenvalues of these modes, (rad/s)^2; lossy : (m,) True for modes with losses
    size : n, number of unknowns of a face
    """

    stiffness: Complex
    lossless: Complex
    mass: Complex
    coupling: Complex
    poles: Array
    lossy: Bools
    size: int

    @classmethod
    def of(cls, tiling: Tiling, phase: float, left: Array, right: Array, lossy: Sequence[bool]) -> Slab:
        """Make a slab of a tiling with one period, at the phase (rad) of the period.

        left, right : (n, 2) places of the faces, m, in the same order; lossy : True for tiles with losses
        """
        joint, places = tiling.joint, SlabBoundary.of(tiling, phase, left, right)
        total = places.total
        stiffness, lossless, mass = np.zeros((3, total, total), dtype=complex)
        coupling, poles = [], []
        for number, tile in enumerate(tiling.tiles):
            traces = tile.trace_size
            rows, spread = places.rim(number)
            fold = spread.conj().T
            K, M = (joint.form(number, form, traces) for form in (tile.stiffness, tile.mass))
            elastic = stiffness if lossy[number] else lossless
            elastic[np.ix_(rows, rows)] += fold @ K[:traces, :traces] @ spread
            mass[np.ix_(rows, rows)] += fold @ M[:traces, :traces] @ spread
            to_modes = np.zeros((total, tile.size - traces), dtype=complex)
            to_modes[rows] = fold @ M[:traces, traces:]
            coupling.append(to_modes)
            poles.append(np.diag(K)[traces:])
        counts = [len(of_tile) for of_tile in poles]
        return cls(
            stiffness=stiffness,
            lossless=lossless,
            mass=mass,
            coupling=np.hstack(coupling),
            poles=np.concatenate(poles),
            lossy=np.repeat(np.asarray(lossy, dtype=bool), counts),
            size=places.size,
        )

    def at(self, omega: float, loss_factor: float = 0.0) -> FaceStiffness:
        """Dynamic stiffness of the faces at omega (rad/s).

        The stiffness of tiles with losses is ``1 + i loss_factor`` times the real one.
        """
        whole = self._dynamic(omega, loss_factor)
        faces, inner = slice(2 * self.size), slice(2 * self.size, None)
        follow = la.solve(whole[inner, inner], whole[inner, faces])
        return FaceStiffness.of(whole[faces, faces] - whole[faces, inner] @ follow)

    def answer(self, omega: float, faces: Complex) -> tuple[Complex, Complex]:
        """Motion of the boundary (b, k) and of the modes (m, k) for motions of the faces (2n, k).

        Losses are left out.
        """
        whole, inner = self._dynamic(omega, 0.0), slice(2 * self.size, None)
        between = -la.solve(whole[inner, inner], whole[inner, : 2 * self.size] @ faces)
        boundary = np.vstack([faces, between])
        return boundary, (omega**2 / (self.poles - omega**2))[:, None] * (self.coupling.conj().T @ boundary)

    def _dynamic(self, omega: float, loss_factor: float) -> Complex:
        """(b, b) dynamic stiffness of the boundary, without forces on the modes."""
        loss = 1 + 1j * loss_factor
        poles = np.where(self.lossy, loss, 1.0) * self.poles
        answer = (omega**4 / (poles - omega**2))[:, None] * self.coupling.conj().T
        return np.asarray(
            loss * self.stiffness + self.lossless - omega**2 * self.mass - self.coupling @ answer
        )


@dataclass(frozen=True)
class Waves:
    """Waves that propagate or decay to one side of a plane: propagating ones first, then by their decay.

    exponent : (w,) complex; a wave is multiplied by its exponential from one face to the next on the right
    displacement : (n, w) of a face, m; force : (n, w) of the part left of it on the part right of it, N
    propagates : (w,) True for waves that carry energy, 1 W each; evanescent waves are scaled so that the
        product of the norms of force and velocity is that of 1 W
    """

    exponent: Complex
    displacement: Complex
    force: Complex
    propagates: Bools

    def __len__(self) -> int:
        return len(self.exponent)

    def chosen(self, members: Ints) -> Waves:
        """Select waves by number."""
        return Waves(
            self.exponent[members],
            self.displacement[:, members],
            self.force[:, members],
            self.propagates[members],
        )

    def impedance(self) -> Complex:
        """(n, n) force per displacement on the face of a half-space with only these n waves."""
        return np.asarray(la.solve(self.displacement.T, self.force.T).T)


def symmetric(field: Complex) -> Bools:
    """(w,) True for waves (levels, ..., 3, w) that are mostly symmetric about the plate's middle plane."""
    image = field[::-1] * np.array([1.0, 1.0, -1.0])[:, None]
    overlap = (field.conj() * image).reshape(-1, field.shape[-1]).sum(axis=0).real
    return np.asarray(overlap > 0)


def energy_flux(displacement: Complex, force: Complex, omega: float) -> Complex:
    """(w, w) Hermitian form of the power that waves (n, w) carry to the right, W.

    Its diagonal is ``Re(force* (i omega displacement)) / 2``. Without losses it is the same on all faces, so
    the waves a and b have no entry unless ``conj(lambda_a) lambda_b = 1``.
    """
    work = displacement.conj().T @ force
    return np.asarray(-0.25j * omega * (work - work.conj().T))


def directed(exponent: Complex, displacement: Complex, force: Complex, omega: float) -> tuple[Waves, Waves]:
    """Divide the 2n waves of a slab or a plate into waves to the right and waves to the left.

    The direction of an evanescent wave is that of its decay, the direction of a propagating wave that of its
    energy. Propagating waves of equal multiplier are combined so that they carry energy independently.
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
    assert len(right) == len(left), "the numbers of waves to the right and to the left are equal"
    return right, left


def bloch_waves(slab: FaceStiffness, omega: float) -> tuple[Waves, Waves]:
    """Compute the waves of an infinite row of slabs, on their left faces: n to the right, n to the left.

    No external force acts between two slabs, so ``RL + (LL + RR) lambda + LR lambda^2`` maps the
    displacement of a face to zero. With ``mu = 1 / (lambda - SHIFT)`` it is a standard eigenproblem in which
    neither lambda = 0 nor infinity is special.
    """
    n = slab.size
    middle = slab.LL + slab.RR
    at_shift = slab.RL + SHIFT * (middle + SHIFT * slab.LR)
    companion = np.zeros((2 * n, 2 * n), dtype=complex)
    companion[:n, n:] = np.eye(n)
    companion[n:] = -la.solve(at_shift, np.hstack([slab.LR, middle + 2 * SHIFT * slab.LR]))
    mu, fields = np.linalg.eig(companion)  # NumPy is nearly twice as fast here as SciPy
    multiplier = SHIFT + 1 / np.where(np.abs(mu) < SMALLEST, SMALLEST, mu)
    multiplier = np.where(np.abs(multiplier) < SMALLEST, SMALLEST, multiplier)
    u = fields[:n]
    outer = np.abs(multiplier) > 1  # use the smaller power of lambda
    ahead, behind = np.where(outer, 0, multiplier), np.where(outer, 1 / multiplier, 0)
    force = np.where(outer, -slab.RR @ u - (slab.RL @ u) * behind, slab.LL @ u + (slab.LR @ u) * ahead)
    return directed(np.log(multiplier), u, force, omega)


def decibels(right: Waves) -> float:
    """Decay from face to face of the least attenuated wave to the right, dB; 0 if it propagates."""
    return 0.0 if right.propagates[0] else float(-20 / np.log(10) * right.exponent[0].real)
