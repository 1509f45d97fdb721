"""Waves at a given frequency, those that die out included: the complex band structure k(omega).

Seen across them a few rows of cells are a slab between two faces. A wave multiplies what happens on its left
face by a complex number lambda on the right one; within a gap no |lambda| is 1 and the waves fade. All that
is below such a slab takes plain face matrices, whatever they were made from.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.later import csgraph, linalg as la, sparse as sp
from haptonic.superelement import Tiling, steps_between

SHIFT = 1.2 * np.exp(0.9j)  # multiplier about which the waves are sought, off the unit circle
ON_CIRCLE = 1e-7  # real part of an exponent below which a wave counts as propagating
COINCIDENT = 1e-6  # distance below which two multipliers count as the same
BETWEEN = 2  # places on neither of two faces
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


@dataclass(frozen=True)
class Slab:
    """A piece of plate between two faces, one period of it at a fixed phase along them.

    Boundary unknowns: the left face, the right face (n each), then what lies between them. Each face has
    unknowns (level, place, component), without the images of places a period on.

    stiffness, lossless : (b, b) on the boundary, of what has losses and of what has none
    mass : (b, b); coupling : (b, m) mass between it and the modes of the tiles
    poles : (m,) eigenvalues of these modes, (rad/s)^2; lossy : (m,) which of them have losses
    size : n, unknowns of a face
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
        """A tiling that is repeated once, at the phase (rad) of its period.

        left, right : (n, 2) places of the faces, m, in one order; lossy : which tiles have losses
        """
        joint, levels = tiling.joint, tiling.joint.levels
        free, own = np.unique(joint.master, return_inverse=True)
        kind, slot, shift = np.full(len(free), BETWEEN), np.zeros_like(free), np.zeros_like(free)
        for number, face in enumerate((left, right)):
            whole, same = steps_between(joint.position[free], face, joint.period.vectors)
            assert (same.sum(axis=0) == 1).all(), "a place of a face that no tile has, or several have"
            place, slots = np.nonzero(same)
            kind[place], slot[place], shift[place] = number, slots, whole[place, slots, 0]
        between = kind == BETWEEN
        assert (np.bincount(own)[between] > 1).all(), "sides of tiles that meet no other, and no face"
        slot[between] = np.arange(between.sum())
        size = 3 * levels * len(left)
        on_level = 3 * np.where(between, between.sum(), len(left))
        first = (size * kind + 3 * slot)[own][:, None] + np.arange(3)
        column = first + np.arange(levels)[:, None, None] * on_level[own][:, None]
        turn = np.exp(1j * phase * (joint.shift[:, 0] + shift[own]))

        total = 2 * size + 3 * levels * int(between.sum())
        stiffness, lossless, mass = np.zeros((3, total, total), dtype=complex)
        coupling, poles = [], []
        starts = np.concatenate([[0], joint.ends])
        for number, tile in enumerate(tiling.tiles):
            traces, places = tile.trace_size, slice(starts[number], starts[number + 1])
            rows, at = np.unique(column[:, places], return_inverse=True)
            factor = np.broadcast_to(turn[places, None], (levels, len(turn[places]), 3)).ravel()
            spread = sp.csr_array((factor, (np.arange(traces), at.ravel())), shape=(traces, len(rows)))
            fold = spread.conj().T
            K, M = (joint.form(number, form, traces) for form in (tile.stiffness, tile.mass))
            elastic = stiffness if lossy[number] else lossless
            elastic[np.ix_(rows, rows)] += fold @ K[:traces, :traces] @ spread
            mass[np.ix_(rows, rows)] += fold @ M[:traces, :traces] @ spread
            to_modes = np.zeros((total, tile.size - traces), dtype=complex)
            to_modes[rows] = fold @ M[:traces, traces:]
            coupling.append(to_modes)
            poles.append(np.diag(K)[traces:])
        counts = [len(one) for one in poles]
        return cls(
            stiffness=stiffness,
            lossless=lossless,
            mass=mass,
            coupling=np.hstack(coupling),
            poles=np.concatenate(poles),
            lossy=np.repeat(np.asarray(lossy, dtype=bool), counts),
            size=size,
        )

    def at(self, omega: float, loss_factor: float = 0.0) -> FaceStiffness:
        """Dynamic stiffness at omega (rad/s), nothing but the faces kept.

        The stiffness of what has losses is ``1 + i loss_factor`` times the real one.
        """
        loss = 1 + 1j * loss_factor
        poles = np.where(self.lossy, loss, 1.0) * self.poles
        answer = (omega**4 / (poles - omega**2))[:, None] * self.coupling.conj().T
        whole = loss * self.stiffness + self.lossless - omega**2 * self.mass - self.coupling @ answer
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


def symmetric(field: Complex) -> Bools:
    """(w,) whether waves (levels, ..., 3, w) are rather symmetric about the plate's middle plane."""
    image = field[::-1] * np.array([1.0, 1.0, -1.0])[:, None]
    found = (field.conj() * image).reshape(-1, field.shape[-1]).sum(axis=0).real > 0
    return np.asarray(found)


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


def decibels(right: Waves) -> float:
    """Decay from face to face of the wave to the right that reaches farthest, dB; 0 if it propagates."""
    return 0.0 if right.propagates[0] else float(-20 / np.log(10) * right.exponent[0].real)
