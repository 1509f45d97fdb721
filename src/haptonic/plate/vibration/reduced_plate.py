"""Response of a plate to its drives over a band of frequencies, with an error bound for every line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.parallel import each
from haptonic.plate.body.assembly import Shifted
from haptonic.plate.body.model import PlateModel, impedance as finger_impedance
from haptonic.plate.layout.keys import FINGER, PLATE, SUPPORTS, PartKey, dielectric
from haptonic.plate.vibration.damping import ReducedExtra, amplitudes, real_times
from haptonic.plate.vibration.krylov import Basis

ROUNDING = 1e-9  # relative error due to rounding, which residuals in floating point do not show
TINY = np.finfo(float).tiny
CHUNK = 48  # number of lines checked at once
LOWEST_SIGMA = 1e-4  # of the largest Ritz frequency: below it K + sigma M of a free plate is singular


@dataclass(frozen=True, eq=False)
class Vibration:
    """Response to drives of given complex amplitudes; energies and powers are time averages.

    omega : (n,) rad/s
    drives : complex amplitudes by name, V or N
    vectors : (size, r); amplitudes : (r, n) of them: together the displacement, m
    error : (n,) bound of the relative error in the energy norm
    stored : by part (n, blocks) strain energy, J; moving : (n, blocks) kinetic energy, J
    dissipated : by part (n,) W, supports and finger among them; given : (n,) W from the drives
    charge : by actuator (n,) C
    """

    omega: Array
    drives: Mapping[str, complex]
    vectors: Array
    amplitudes: Complex
    error: Array
    stored: Mapping[PartKey, Array]
    moving: Array
    dissipated: Mapping[PartKey, Array]
    given: Array
    charge: Mapping[str, Complex]

    @property
    def frequency(self) -> Array:
        """Hz"""
        return np.asarray(self.omega / (2 * np.pi))

    def with_lines(self, lines: Ints, other: Vibration) -> Vibration:
        """Replace some lines by those of another response to the same drives on the same model."""

        def mixed(own: Any, others: Any) -> Any:
            new = own.copy()
            new[lines] = others
            return new

        (old_count, count), new_count = self.amplitudes.shape, len(other.amplitudes)
        joint = np.zeros((old_count + new_count, count), dtype=complex)
        joint[:old_count] = self.amplitudes
        joint[:old_count, lines] = 0.0
        joint[old_count:, lines] = other.amplitudes
        by_name = {
            name: {k: mixed(own, getattr(other, name)[k]) for k, own in getattr(self, name).items()}
            for name in ("stored", "dissipated", "charge")
        }
        return replace(
            self,
            vectors=np.hstack([self.vectors, other.vectors]),
            amplitudes=joint,
            error=mixed(self.error, other.error),
            moving=mixed(self.moving, other.moving),
            given=mixed(self.given, other.given),
            stored=by_name["stored"],
            dissipated=by_name["dissipated"],
            charge=by_name["charge"],
        )


@dataclass(frozen=True, eq=False)
class ReducedPlate:
    """Model on a basis: responses for any damping and any drives need no factorisation.

    With u = V a, V^T M V = 1 and V^T K V = Lambda, the plate's equation is
    ``((1 + i eta) Lambda + sum_e Z_e(omega) V^T E_e V - omega^2) a = V^T f``, e running over parts
    with other damping than the plate, of impedance Z_e.

    extras : these parts
    """

    model: PlateModel
    basis: Basis
    extras: tuple[ReducedExtra, ...]

    @classmethod
    def of(cls, model: PlateModel, basis: Basis, omega: float) -> ReducedPlate:
        """Reduce a model to a basis; ``omega`` is a typical angular frequency, rad/s."""
        return cls(model, basis, tuple(ReducedExtra.of(extra, basis, omega) for extra in model.extras))

    def answer(self, drives: Mapping[str, complex], omega: Array) -> Vibration:
        """Response to drives of complex amplitudes (V or N) at angular frequencies (n,), rad/s."""
        model, basis = self.model, self.basis
        load = model.load(drives)
        loads = basis.turn.T @ (basis.raw.T @ load)
        on_basis, force = amplitudes(basis.values, model.factors[PLATE], self.extras, loads, omega)
        missed = self.answered(force, omega)
        return self.checked(drives, omega, basis.raw, real_times(basis.turn, on_basis), missed)

    def answered(self, force: Complex, omega: Array) -> Array:
        """(n,) four times the strain and kinetic energy of Ritz vectors under small forces (r, n) on them."""
        values = self.basis.values
        moved = np.abs(force / (self.model.factors[PLATE] * values[:, None] - omega**2)) ** 2
        return np.asarray(values @ moved + omega**2 * moved.sum(0))

    def checked(
        self,
        drives: Mapping[str, complex],
        omega: Array,
        vectors: Array,
        weights: Complex,
        missed: Array | float = 0.0,
    ) -> Vibration:
        """Compute errors and energies of vectors (size, r) with amplitudes (r, n) as a response to drives.

        ``missed`` (n,) is four times the energy of an error within the basis.
        """
        model = self.model
        checker = _Checker(self, model.load(drives), vectors, omega)
        model.assembly.prepare()
        starts = range(0, len(omega), CHUNK)
        pieces = each(lambda k: checker.lines(omega[k : k + CHUNK], weights[:, k : k + CHUNK]), starts)
        checker.release()
        seen = _Checked.joined(pieces)
        error = ROUNDING + np.sqrt((seen.missed + missed) / np.maximum(seen.energy, TINY))
        charge, dissipated = {}, {}
        given = np.zeros(len(omega))
        for name, amplitude in drives.items():
            motion = (model.drives[name] @ vectors) @ weights
            if name in model.capacitance:
                blocked = model.blocked(name) * amplitude
                charge[name] = blocked + motion
                given += 0.5 * np.real(amplitude * np.conj(1j * omega * charge[name]))
                dissipated[dielectric(name)] = 0.5 * np.real(amplitude * np.conj(1j * omega * blocked))
            else:
                given += 0.5 * np.real(amplitude * np.conj(1j * omega * motion))
        for part, values in seen.stored.items():
            dissipated[part] = 2 * omega * model.factors[part].imag * values.sum(axis=1)
        dissipated[SUPPORTS], dissipated[FINGER] = seen.supports, seen.finger
        return Vibration(
            omega=omega, drives=dict(drives), vectors=vectors, amplitudes=weights, error=error,
            stored=seen.stored, moving=seen.moving, dissipated=dissipated, given=given,
            charge=charge,
        )  # fmt: skip


def amplification(loss: float, omega: Array, sigma: float, complete: tuple[float, float]) -> Array:
    """Largest (lambda + sigma) / |lambda (1 + i loss) - omega^2| over all lambda of modes not in the basis.

    A residual r of ``((1 + i loss) K - omega^2 M) u = f`` makes an error e that is, mode by mode,
    ``r_k / (lambda_k (1 + i loss) - omega^2)``. In the norm of ``N = K + sigma M`` therefore

        e* N e <= amplification^2  r* N^-1 r.

    A basis that contains all modes between the two ends of ``complete`` leaves a residual only for those
    beyond.
    """
    square = omega**2
    low, high = complete
    inside = (low < square) & (square < high)
    # beyond the ends the ratio falls with the distance; it tends to 1 / |1 + i loss|
    above = (high + sigma) / np.where(inside, np.hypot(high - square, loss * high), 1.0)
    below = (low + sigma) / np.where(inside, np.hypot(low - square, loss * low), 1.0) if low else 0.0
    outside = np.maximum(np.maximum(above, below), 1.0)
    # |lambda (1 + i loss) - omega^2|^2 = a lambda^2 + 2 b lambda + c: where the ratio's derivative vanishes
    a, b, c = 1 + loss**2, -square, square**2
    best = (c - b * sigma) / (a * sigma - b)
    with np.errstate(divide="ignore"):
        any_mode = (best + sigma) / np.sqrt(np.maximum(a * best**2 + 2 * b * best + c, 0.0))
    return np.where(inside, outside, any_mode)


@dataclass(frozen=True, eq=False)
class _Checked:
    """Energies, losses and errors of the response at some lines.

    stored : by part (n, blocks) J; moving : (n, blocks) J; supports, finger : (n,) W lost in them
    energy, missed : (n,) four times the energy of the whole, and of its error at most
    """

    stored: Mapping[PartKey, Array]
    moving: Array
    supports: Array
    finger: Array
    energy: Array
    missed: Array

    @classmethod
    def joined(cls, pieces: Sequence[_Checked]) -> _Checked:
        """Join the pieces of all lines in their order."""
        stored = {part: np.concatenate([piece.stored[part] for piece in pieces]) for part in pieces[0].stored}
        names = [field.name for field in fields(cls)[1:]]
        return cls(stored, *(np.concatenate([getattr(piece, name) for piece in pieces]) for name in names))


class _Checker:
    """Check of reduced responses in the unreduced equations."""

    def __init__(self, reduced: ReducedPlate, load: Complex, vectors: Array, omega: Array) -> None:
        self.reduced, self.vectors = reduced, vectors
        low, high = reduced.basis.complete
        inside = (low < omega**2) & (omega**2 < high)
        self.highest = float(omega[inside].max(initial=0.0))  # of lines next to which no mode is missing
        self.total = np.stack([load.real, load.imag], axis=1)
        self._idle: list[Shifted] = []

    def lines(self, omega: Array, weights: Complex) -> _Checked:
        """Check some lines."""
        reduced, model = self.reduced, self.reduced.model
        assembly, factors, count = model.assembly, model.factors, len(omega)
        square = np.tile(omega**2, 2)
        fields = self.vectors @ np.hstack([weights.real, weights.imag])
        blocks = len(assembly.skeleton.blocks)
        moving = np.zeros((count, blocks))
        stored = {part: np.zeros((count, blocks)) for part in factors}
        pieces = []
        for group, share in assembly.shares(fields):
            heavy = group.tile.mass_times(share)
            moving[:, group.blocks] = 0.25 * (square * _energy(share, heavy)).reshape(-1, 2, count).sum(1).T
            total = -square * heavy
            for part in group.tile.stiffness:
                stiff = group.tile.part_times(part, share)
                energy = 0.25 * _energy(share, stiff).reshape(-1, 2, count).sum(1).T
                stored[part][:, group.blocks] += energy
                total += _times(stiff, factors[part])
            pieces.append(total)
        residual = assembly.gathered(pieces)
        supports, lost_in_finger = np.zeros(count), np.zeros(count)
        norm = np.asarray(4 * sum(values.sum(1) for values in stored.values()))
        for foundation in model.foundations:
            force = foundation.stiffness @ fields[: assembly.free]
            residual[: assembly.free] += _times(force, 1 + 1j * foundation.loss_factor)
            energy = (fields[: assembly.free] * force).sum(0).reshape(2, count).sum(0)
            supports += 0.5 * omega * foundation.loss_factor * energy
            norm += energy
        if (finger := model.plate.finger) is not None:
            pad = model.pad
            felt = finger_impedance(finger, omega) / pad.shape[0]
            motion = pad @ fields
            motion = motion[:, :count] + 1j * motion[:, count:]
            force = felt * motion
            residual += pad.T @ np.hstack([force.real, force.imag])
            lost_in_finger = 0.5 * omega * felt.imag * (np.abs(motion) ** 2).sum(0)
        residual[:, :count] -= self.total[:, :1]
        residual[:, count:] -= self.total[:, 1:]
        norm += 4 * moving.sum(1)
        sigma = self._sigma(omega)
        beyond = self._beyond(residual, sigma)
        dual = np.maximum(np.einsum("nk,nk->k", residual, beyond), 0.0).reshape(2, count).sum(0)
        gain = amplification(factors[PLATE].imag, omega, sigma, reduced.basis.complete)
        # the field outside the basis excites its modes through the other losses, most strongly at resonance
        force = np.zeros((reduced.basis.dimension, count), dtype=complex)
        for extra in reduced.extras:
            motion = extra.unreduced.axes.T @ beyond[extra.unreduced.rows]
            force += real_times(
                extra.whole, extra.unreduced.impedance(omega) * (motion[:, :count] + 1j * motion[:, count:])
            )
        missed = gain**2 * (dual + reduced.answered(force, omega))
        return _Checked(
            stored=stored, moving=moving, supports=supports, finger=lost_in_finger, energy=norm, missed=missed
        )

    def _sigma(self, omega: Array) -> float:
        """Shift of the norm for some lines, (rad/s)^2: any gives a bound, but each needs a factorisation.

        If only modes above the band are missing, one shift is used for all lines: with the square of the
        highest frequency, the loss at other lines is below one half. Otherwise it must be near omega^2.
        """
        low, _ = self.reduced.basis.complete
        lowest = LOWEST_SIGMA * np.sqrt(self.reduced.basis.values.max(initial=0.0))
        if low == 0.0 and omega.max() <= self.highest:
            return float(max(self.highest, lowest) ** 2)
        return float(4.0 ** np.ceil(np.log(max(omega.max(), lowest) ** 2) / np.log(4.0)))

    def release(self) -> None:
        """Release the solvers."""
        while self._idle:
            self._idle.pop().release()

    def _beyond(self, residual: Array, sigma: float) -> Array:
        """(size, columns) inverse of K + sigma M, supports included, times residuals."""
        assembly = self.reduced.model.assembly
        norm = self._idle.pop() if self._idle else None  # each thread has its own
        if norm is None or norm.shift != -sigma:
            if norm is not None:
                norm.release()
            norm = assembly.shifted(-sigma)
        solution = norm.solve(residual)
        self._idle.append(norm)
        return solution


def _energy(share: Array, force: Array) -> Array:
    """(blocks, columns) products of motion and force."""
    return np.asarray(np.einsum("nbk,nbk->bk", share, force))


def _times(columns: Array, factor: complex) -> Array:
    """Real and imaginary columns, side by side in the last axis, times a complex factor."""
    real, imaginary = np.split(columns, 2, axis=-1)
    return np.concatenate(
        [factor.real * real - factor.imag * imaginary, factor.real * imaginary + factor.imag * real], axis=-1
    )
