"""Fast model of a design for the optimiser: coarse bands, critical frequencies and their slopes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.bloch.gaps import ZoneSampling
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import change_in_hertz, eigenpairs, hertz
from haptonic.bloch.reduced import ReducedCell
from haptonic.bloch.resolution import Resolution
from haptonic.cell import UnitCell
from haptonic.design.sensitivity import Directions, eigenvalue_derivatives
from haptonic.parallel import one_thread
from haptonic.superelement import TiledMesh, Tiling

QUICK = Resolution(3, 1)  # frequencies are a few tenths of a percent too high, nearly uniformly
APART = 0.3  # rad, smallest distance between two extremes of a band
CRITICAL = 3  # frequencies on either side of a gap that may become its edge
GLANCE_DIVISIONS = 6  # of the irreducible zone's sides, for a first estimate of the edges


@dataclass(frozen=True)
class Side:
    """Frequencies that limit a gap on one side, the most critical first.

    frequency : (CRITICAL,) Hz; slopes : (CRITICAL, parameters) Hz per SI unit
    """

    frequency: Array
    slopes: Array


def edges_of(cell: UnitCell, count: int) -> Array:
    """(2, count - 1) highest frequency of each band but the last and lowest of the next, Hz.

    They are those of a few wavevectors. The condensed foot of the pillar is stored: a series of designs with
    different heights computes it only once.
    """
    with one_thread():
        pencil = quick_model(cell, count).fine.pencil
        wavevectors, _ = cell.zone.triangles(GLANCE_DIVISIONS)
        values = np.array([eigenpairs(pencil, kappa, count)[0] for kappa in wavevectors])
    frequency = hertz(values)
    return np.stack([frequency[:, :-1].max(axis=0), frequency[:, 1:].min(axis=0)])


def quick_model(cell: UnitCell, count: int) -> BlochModel:
    """Coarse model for ``count`` bands, without an error estimate; the foot of a pillar is stored."""
    with one_thread():
        tiling = Tiling.condensed(cell, QUICK.plans(cell), QUICK.steps, QUICK.block, measured=False)
        return _without_errors(cell, count, tiling)


def _without_errors(cell: UnitCell, count: int, tiling: Tiling) -> BlochModel:
    reduced = ReducedCell.of(tiling, count, np.inf)
    return BlochModel(cell=cell, resolution=QUICK, count=count, fine=reduced)


@dataclass(frozen=True)
class QuickDesign:
    """Bands of a design in a coarse model.

    shared : its meshes
    model : its bands
    zone : wavevectors at which they were sampled
    """

    shared: TiledMesh
    model: BlochModel
    zone: ZoneSampling

    @classmethod
    def of(cls, cell: UnitCell, count: int) -> QuickDesign:
        """Compute ``count`` bands of a cell."""
        with one_thread():
            shared = TiledMesh.of(cell, QUICK.plans(cell))
            model = _without_errors(cell, count, shared.condensed(QUICK.steps, QUICK.block, measured=False))
            return cls(shared, model, ZoneSampling(model))

    def edges(self) -> Array:
        """(2, count - 1) highest frequency of each band but the last, and lowest of the next, as sampled."""
        frequency = np.array(self.zone.frequency)
        return np.stack([frequency[:, :-1].max(axis=0), frequency[:, 1:].min(axis=0)])

    def sides(
        self, band: int, paths: Sequence[str], directions: Directions = MappingProxyType({})
    ) -> tuple[Side, Side]:
        """Frequencies that limit the gap above a band, counted from 1, from below and from above.

        ``paths`` and ``directions`` as in `eigenvalue_derivatives`.
        """
        for edge, sign in ((band - 1, +1), (band, -1)):
            self.zone.edge(edge, sign)
        chosen = self._critical(band - 1, +1) + self._critical(band, -1)
        modes = [self._mode(kappa, number) for kappa, number in chosen]
        values, unknowns = np.array([value for value, _ in modes]), np.hstack([mode for _, mode in modes])
        tiling = self.model.fine.tiling
        trace = unknowns[: tiling.trace_size]
        forms = eigenvalue_derivatives(self.shared, tiling.lifted(unknowns), trace, values, paths, directions)
        frequency = np.sqrt(values) / (2 * np.pi)
        slopes = np.stack([np.diagonal(forms[path]).real for path in paths], axis=1)
        slopes = change_in_hertz(slopes, frequency[:, None])
        return Side(frequency[:CRITICAL], slopes[:CRITICAL]), Side(frequency[CRITICAL:], slopes[CRITICAL:])

    def _critical(self, band: int, sign: int) -> list[tuple[Array, int]]:
        """Wavevectors and numbers (from 0) of candidates for the edge of a band: the band's own extremes, and
        the neighbouring band at the first of them, which may cross it."""
        value = sign * np.array(self.zone.frequency)[:, band]
        peaks: list[Array] = []
        for point in np.argsort(-value):
            kappa = self.zone.kappa[point]
            apart = all(np.linalg.norm(kappa - other) > APART for other in peaks)
            if apart and self._is_peak(int(point), value):
                peaks.append(kappa)
        beside = band - sign
        candidates = [(peaks[0], band)] + [(peaks[0], beside)] * (0 <= beside < self.model.count)
        candidates += [(kappa, band) for kappa in peaks[1:]]
        return (candidates * CRITICAL)[:CRITICAL]

    def _is_peak(self, point: int, value: Array) -> bool:
        around = self.zone.triangles[(self.zone.triangles == point).any(axis=1)]
        return bool((value[point] >= value[around]).all())

    def _mode(self, kappa: Array, band: int) -> tuple[float, NDArray[np.complex128]]:
        """Eigenvalue, (rad/s)^2, and unknowns (t + m, 1) of unit mass of a band, counted from 0."""
        values, modes = eigenpairs(self.model.fine.pencil, kappa, band + 1)
        return float(values[band]), self.model.fine.expanded(modes[:, band:], kappa)
