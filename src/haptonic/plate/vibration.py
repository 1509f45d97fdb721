"""How a plate answers its drives over a band of frequencies, with a check of every line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.plate.damping import Extra, amplitudes
from haptonic.plate.krylov import Basis
from haptonic.plate.model import PlateModel, impedance

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Ints = NDArray[np.int64]

ROUNDING = 1e-9  # relative error that no residual shows, because it is computed in floating point too
CHUNK = 48  # lines that are checked at once
LOWEST_SIGMA = 0.02  # of the largest Ritz frequency: below it tiles are stiff, and bounds tile by tile wide


@dataclass(frozen=True, eq=False)
class Vibration:
    """Answer to drives of given complex amplitudes; energies and powers are time averages.

    omega : (n,) rad/s
    drives : complex amplitudes by name, V or N
    vectors : (size, r); amplitudes : (r, n) of them: together the displacement, m
    error : (n,) bound of the relative error in the energy norm
    stored : by part (n, blocks) strain energy, J; moving : (n, blocks) kinetic energy, J
    dissipated : by part (n,) W, "supports" and "finger" among them; given : (n,) W from the drives
    charge : by actuator (n,) C
    """

    omega: Array
    drives: Mapping[str, complex]
    vectors: Array
    amplitudes: Complex
    error: Array
    stored: Mapping[str, Array]
    moving: Array
    dissipated: Mapping[str, Array]
    given: Array
    charge: Mapping[str, Complex]

    @property
    def frequency(self) -> Array:
        """Hz"""
        return np.asarray(self.omega / (2 * np.pi))

    def with_lines(self, lines: Ints, other: Vibration) -> Vibration:
        """With some lines taken from another answer to the same drives on the same model."""

        def mixed(own: Any, others: Any) -> Any:
            new = own.copy()
            new[lines] = others
            return new

        (old_count, count), new_count = self.amplitudes.shape, len(other.amplitudes)
        found = np.zeros((old_count + new_count, count), dtype=complex)
        found[:old_count] = self.amplitudes
        found[:old_count, lines] = 0.0
        found[old_count:, lines] = other.amplitudes
        by_name = {
            name: {k: mixed(own, getattr(other, name)[k]) for k, own in getattr(self, name).items()}
            for name in ("stored", "dissipated", "charge")
        }
        return replace(
            self,
            vectors=np.hstack([self.vectors, other.vectors]),
            amplitudes=found,
            error=mixed(self.error, other.error),
            moving=mixed(self.moving, other.moving),
            given=mixed(self.given, other.given),
            stored=by_name["stored"],
            dissipated=by_name["dissipated"],
            charge=by_name["charge"],
        )


@dataclass(frozen=True, eq=False)
class ReducedPlate:
    """A model on a basis: any damping and any amplitudes of the drives cost no factorisation any more.

    extras : what damps otherwise than the plate, with its directions (r, p)
    """

    model: PlateModel
    basis: Basis
    extras: tuple[tuple[Extra, Array], ...]

    @classmethod
    def of(cls, model: PlateModel, basis: Basis, omega: float) -> ReducedPlate:
        """``omega`` is a typical one, rad/s."""
        return cls(model, basis, tuple((extra, extra.directions(basis, omega)) for extra in model.extras))

    def answer(self, drives: Mapping[str, complex], omega: Array) -> Vibration:
        """Answer to drives of given complex amplitudes (V or N) at angular frequencies (n,), rad/s."""
        model, basis = self.model, self.basis
        load = model.load(drives)
        extras = [(directions, extra.impedance(omega)) for extra, directions in self.extras]
        found = amplitudes(basis.values, model.factors["plate"], extras, basis.vectors.T @ load, omega)
        return self.checked(drives, omega, basis.vectors, found)

    def checked(
        self, drives: Mapping[str, complex], omega: Array, vectors: Array, found: Complex
    ) -> Vibration:
        """What vectors (size, r) with amplitudes (r, n) are worth as an answer to drives."""
        model = self.model
        checker = _Checker(self, model.load(drives), vectors)
        pieces = [
            checker.lines(omega[start : start + CHUNK], found[:, start : start + CHUNK])
            for start in range(0, len(omega), CHUNK)
        ]
        seen = {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}
        charge, dissipated = {}, {}
        given = np.zeros(len(omega))
        for name, amplitude in drives.items():
            motion = (model.drives[name] @ vectors) @ found
            if name in model.capacitance:
                blocked = model.blocked(name) * amplitude
                charge[name] = blocked + motion
                given += 0.5 * np.real(amplitude * np.conj(1j * omega * charge[name]))
                dissipated[f"{name} dielectric"] = 0.5 * np.real(amplitude * np.conj(1j * omega * blocked))
            else:
                given += 0.5 * np.real(amplitude * np.conj(1j * omega * motion))
        stored = {name[7:]: values for name, values in seen.items() if name.startswith("stored ")}
        for name, values in stored.items():
            dissipated[name] = 2 * omega * model.factors[name].imag * values.sum(axis=1)
        dissipated["supports"], dissipated["finger"] = seen["supports"], seen["finger"]
        return Vibration(
            omega, dict(drives), vectors, found, seen["error"], stored, seen["moving"], dissipated, given,
            charge,
        )  # fmt: skip


def amplification(loss: float, omega: Array, sigma: float, complete: tuple[float, float]) -> Array:
    """Largest (lambda + sigma) / |lambda (1 + i loss) - omega^2| over all lambda of modes not in the basis.

    By it a residual, measured with the inverse of K + sigma M, bounds the error in the energy norm. A basis
    that holds all modes between the two ends of ``complete`` leaves a residual only for those beyond.
    """
    square = omega**2
    low, high = complete
    inside = (low < square) & (square < high)
    # beyond the ends the ratio falls with the distance; it tends to 1 / |1 + i loss|
    above = (high + sigma) / np.where(inside, np.hypot(high - square, loss * high), 1.0)
    below = (low + sigma) / np.where(inside, np.hypot(low - square, loss * low), 1.0) if low else 0.0
    known = np.maximum(np.maximum(above, below), 1.0)
    # |lambda (1 + i loss) - omega^2|^2 = a lambda^2 + 2 b lambda + c: where the ratio's derivative vanishes
    a, b, c = 1 + loss**2, -square, square**2
    best = (c - b * sigma) / (a * sigma - b)
    with np.errstate(divide="ignore"):
        any_mode = (best + sigma) / np.sqrt(np.maximum(a * best**2 + 2 * b * best + c, 0.0))
    return np.where(inside, known, any_mode)


class _Checker:
    """Puts reduced answers back into the unreduced equations."""

    def __init__(self, reduced: ReducedPlate, load: Complex, vectors: Array) -> None:
        self.reduced, self.vectors = reduced, vectors
        assembly = reduced.model.assembly
        counts = assembly.gathered([np.ones((*group.unknowns.shape, 1)) for group in assembly.groups])
        self.share = 1.0 / counts  # of an unknown that each of its tiles gets
        self.total = np.stack([load.real, load.imag], axis=1)
        self._kept: dict[tuple[int, float], Array] = {}

    def lines(self, omega: Array, found: Complex) -> dict[str, Array]:
        """Energies, W and error of some lines."""
        reduced, model = self.reduced, self.reduced.model
        assembly, factors, count = model.assembly, model.factors, len(omega)
        square = np.tile(omega**2, 2)
        fields = self.vectors @ np.hstack([found.real, found.imag])
        blocks = len(assembly.skeleton.blocks)
        out: dict[str, Array] = {
            "moving": np.zeros((count, blocks)),
            **{f"stored {name}": np.zeros((count, blocks)) for name in factors},
        }
        pieces = []
        for group, share in assembly.shares(fields):
            heavy = group.tile.mass @ share
            out["moving"][:, group.blocks] = (
                0.25 * (square * _energy(share, heavy)).reshape(-1, 2, count).sum(1).T
            )
            total = -square * heavy
            for name, part in group.tile.stiffness.items():
                stiff = part @ share
                energy = 0.25 * _energy(share, stiff).reshape(-1, 2, count).sum(1).T
                out[f"stored {name}"][:, group.blocks] += energy
                total += _times(stiff, factors[name])
            pieces.append(total)
        residual = assembly.gathered(pieces)
        out["supports"] = np.zeros(count)
        norm = np.asarray(4 * sum(out[f"stored {name}"].sum(1) for name in factors))
        for bed in model.beds:
            force = bed.stiffness @ fields[: assembly.free]
            residual[: assembly.free] += _times(force, 1 + 1j * bed.loss_factor)
            energy = (fields[: assembly.free] * force).sum(0).reshape(2, count).sum(0)
            out["supports"] += 0.5 * omega * bed.loss_factor * energy
            norm += energy
        out["finger"] = np.zeros(count)
        if (finger := model.plate.finger) is not None:
            pad = model.pad
            felt = impedance(finger, omega) / pad.shape[0]
            motion = pad @ fields
            motion = motion[:, :count] + 1j * motion[:, count:]
            force = felt * motion
            residual += pad.T @ np.hstack([force.real, force.imag])
            out["finger"] = 0.5 * omega * felt.imag * (np.abs(motion) ** 2).sum(0)
        residual[:, :count] -= self.total[:, :1]
        residual[:, count:] -= self.total[:, 1:]
        norm += 4 * out["moving"].sum(1)
        # any sigma gives a bound; few of them, so that tiles are factorised for few of them
        sigma = float(max(omega.min(), LOWEST_SIGMA * np.sqrt(reduced.basis.values[-1])) ** 2)
        sigma = 4.0 ** np.floor(np.log(sigma) / np.log(4.0))
        dual = np.zeros(count)
        for number, (_, share) in enumerate(assembly.shares(residual * self.share)):
            scaled = self._whitening(number, sigma) @ share
            dual += _energy(scaled, scaled).reshape(-1, 2, count).sum((0, 1))
        loss = factors["plate"].imag
        gain = amplification(loss, omega, sigma, reduced.basis.complete)
        out["error"] = ROUNDING + gain * np.sqrt(dual / np.maximum(norm, np.finfo(float).tiny))
        return out

    def _whitening(self, number: int, sigma: float) -> Array:
        """(n, n) inverse of the Cholesky factor of K + sigma M of a group's tile."""
        if (number, sigma) not in self._kept:
            tile = self.reduced.model.assembly.groups[number].tile
            self._kept[number, sigma] = la.inv(la.cholesky(tile.elastic + sigma * tile.mass, lower=True))
        return self._kept[number, sigma]


def _energy(share: Array, force: Array) -> Array:
    """(blocks, columns) products of motion and force."""
    return np.asarray(np.einsum("bnk,bnk->bk", share, force))


def _times(columns: Array, factor: complex) -> Array:
    """Real and imaginary columns, side by side in the last axis, times a complex factor."""
    real, imaginary = np.split(columns, 2, axis=-1)
    return np.concatenate(
        [factor.real * real - factor.imag * imaginary, factor.real * imaginary + factor.imag * real], axis=-1
    )
