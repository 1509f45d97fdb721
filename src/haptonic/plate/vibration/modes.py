"""Modes of a plate near a frequency: energy, losses, rise times, and names by nodal lines, as in 0x17."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.plate.body.model import impedance
from haptonic.plate.layout.keys import FINGER, SUPPORTS, PartKey
from haptonic.plate.vibration.sweep import Band

RISE = 2.2  # time constants from 10 to 90 % of the final amplitude


@dataclass(frozen=True, eq=False)
class PlateModes:
    """Modes in ascending order, of the plate without the finger's stiffness and inertia.

    frequency : (k,) Hz; error : (k,) relative, bound from the residual
    quality : (k,) quality factors with all losses, the finger's among them, to first order: a part of loss
        factor eta_j that stores the share E_j of a mode's strain energy adds eta_j E_j to 1 / Q
    stored : by part (k, blocks) shares of the strain energy
    lost : by part (k,) shares of the loss, supports and finger among them
    vectors : (size, k) of the assembly, modal mass 1
    """

    frequency: Array
    error: Array
    quality: Array
    stored: dict[PartKey, Array]
    lost: dict[PartKey, Array]
    vectors: Array

    @property
    def rise_time(self) -> Array:
        """(k,) from 10 to 90 % of the amplitude after the drive is switched on at resonance, s."""
        return np.asarray(RISE * self.quality / (np.pi * self.frequency))


def modes_between(band: Band, low: float, high: float) -> PlateModes:
    """Compute the modes of a band between two frequencies, Hz."""
    model = band.reduced.model
    assembly, factors = model.assembly, model.factors
    least, largest = (2 * np.pi * np.array([low, high])) ** 2
    values, vectors, error = _modes_around(band, least, largest)
    inside = (values >= least) & (values <= largest)
    values, vectors, error = values[inside], vectors[:, inside], error[inside]
    blocks = len(assembly.skeleton.blocks)
    stored = {part: np.zeros((len(values), blocks)) for part in factors}
    for group, share in assembly.shares(vectors):
        for part in group.tile.stiffness:
            twice = np.einsum("nbk,nbk->kb", share, group.tile.part_times(part, share))
            stored[part][:, group.blocks] += twice / values[:, None]
    loss = {part: factors[part].imag * stored[part].sum(axis=1) for part in factors}
    loss[SUPPORTS] = np.zeros(len(values))
    for foundation in model.foundations:
        on_skeleton = vectors[: assembly.free]
        energy = np.einsum("nk,nk->k", on_skeleton, foundation.stiffness @ on_skeleton)
        loss[SUPPORTS] += foundation.loss_factor * energy / values
    loss[FINGER] = np.zeros(len(values))
    if (finger := model.plate.finger) is not None:
        motion = ((model.pad @ vectors) ** 2).sum(axis=0) / model.pad.shape[0]
        loss[FINGER] = impedance(finger, np.sqrt(values)).imag * motion / values
    total = np.asarray(sum(loss.values()))
    with np.errstate(divide="ignore"):
        quality = 1 / total
    return PlateModes(
        frequency=np.sqrt(values) / (2 * np.pi),
        error=error,
        quality=quality,
        stored=stored,
        lost={part: share / np.where(total > 0, total, 1.0) for part, share in loss.items()},
        vectors=vectors,
    )


def _modes_around(band: Band, least: float, largest: float) -> tuple[Array, Array, Array]:
    """Ritz values that are modes, between the nearest shifts around two squares of omega.

    A basis without the modes below a band has Ritz values that are no modes, with errors near 1. The number
    of modes between two shifts is known from the inertia there; they are the Ritz values with the smallest
    errors.

    Returns
    -------
    (k,) ascending, their vectors (size, k), and (k,) their relative errors, see `_residual_error`
    """
    basis = band.reduced.basis
    start = max((shift for shift in basis.below if shift <= least), default=least)
    end = min((shift for shift in basis.below if shift >= largest), default=largest)
    around = np.flatnonzero((basis.values >= start) & (basis.values <= end))
    values, vectors = basis.values[around], basis.vectors(around)
    error = _residual_error(band, vectors, values)
    if start in basis.below and end in basis.below:
        modes = np.sort(error.argsort()[: basis.below[end] - basis.below[start]])
        values, vectors, error = values[modes], vectors[:, modes], error[modes]
    return values, vectors, error


def _residual_error(band: Band, vectors: Array, values: Array) -> Array:
    """(k,) relative errors of frequencies: half the residual in the norm of the inverse of K + lambda M.

    For ``(K - lambda M) v = r`` an eigenvalue lies within ``|r| |v|`` of lambda in these norms, relative to
    2 lambda (Parlett 1998, The Symmetric Eigenvalue Problem, section 15.9).
    """
    if not len(values):
        return np.zeros(0)
    assembly = band.reduced.model.assembly
    residual = assembly.stiffness_times(vectors) - values * assembly.mass_times(vectors)
    shifted = assembly.shifted(-float(values.mean()))
    dual = np.sqrt(np.einsum("nk,nk->k", residual, shifted.solve(residual)))
    shifted.release()
    return np.asarray(dual / np.sqrt(2 * values))


SEPARABLE = 0.7  # least share of a product of two curves in the square of a shape
QUIET = 0.2  # of a curve's peak, below which a change of sign is not counted


def nodal_name(shape: Array) -> str:
    """Nodal lines across a region and intervals between nodal lines along it, such as "0x17".

    Parameters
    ----------
    shape : (along, across) normal displacement on a regular grid; the region is longer in the first direction

    Returns
    -------
    empty if the shape is not a product of a curve along and a curve across
    """
    left, sizes, right = np.linalg.svd(np.nan_to_num(shape), full_matrices=False)
    if not sizes[0] or sizes[0] ** 2 < SEPARABLE * (sizes**2).sum():
        return ""
    across, along = _changes(right[0]), _changes(left[:, 0])
    return f"{across}x{max(along - 1, 0)}"


def has_one_lobe(name: str) -> bool:
    """True if a mode of this name, see `nodal_name`, has one lobe across its region."""
    return name.startswith("0x")


def _changes(curve: Array) -> int:
    """Changes of sign between parts of a curve that are not small."""
    loud = curve[np.abs(curve) > QUIET * np.abs(curve).max()]
    return int((np.diff(np.sign(loud)) != 0).sum())
