"""Bloch model of a cell: frequencies at any wavevector, each with an error estimate."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch.pencil import SplitPencil, change_in_hertz, eigenpairs, error_in_hertz, hertz
from haptonic.bloch.reduced import ReducedCell
from haptonic.bloch.representative import Representative
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.truncation import REST, interior_error, ranked
from haptonic.cell import UnitCell
from haptonic.parallel import one_thread
from haptonic.superelement import Tiling, on_each

ABOVE = 2  # modes above the last band that may change places with it; with none, a tenth band was 1.3 % off
# Multiple of the frequency that rounding gives modes at rest, below which rounding alone is an error of 6e-4
ROUNDED = 30.0
HALVES_DIVISIONS = 6  # of the zone's sides, for the wavevectors at which bands of each parity are counted
ERROR_DIVISIONS = 3  # of the zone's sides, for the wavevectors at which errors of a model are estimated


@dataclass(frozen=True)
class Solution:
    """Modes at one wavevector, lowest first.

    source : the wavevector, and its equivalent in the irreducible zone, for which it was solved
    frequency, error : (k,) Hz; the error bounds the distance to the exact frequency of the model
    fields : (t + m, k) unknowns of the tiling at ``source.kappa``, unit mass; `BlochModel.displacement` gives
        the motion at `kappa`
    modes : (r, k) modes in the small basis; real, unless degenerate modes were combined
    """

    source: Representative
    frequency: Array
    error: Array
    fields: Complex
    modes: Fields

    @property
    def kappa(self) -> Array:
        """(2,) phases of the wavevector, rad."""
        return self.source.image

    @property
    def values(self) -> Array:
        """(k,) eigenvalues omega^2, (rad/s)^2, not negative."""
        return (2 * np.pi * self.frequency) ** 2

    def turned(self, turn: Fields) -> Solution:
        """Combine degenerate modes: new modes = old modes @ turn, (k, k) unitary."""
        return replace(self, fields=self.fields @ turn, modes=self.modes @ turn)

    def lowest(self, count: int) -> Solution:
        """The first ``count`` modes."""
        return Solution(
            source=self.source,
            frequency=self.frequency[:count],
            error=self.error[:count],
            fields=self.fields[:, :count],
            modes=self.modes[:, :count],
        )


@dataclass(frozen=True)
class Sample:
    """Bands at one wavevector, lowest first.

    frequency : (k,) Hz; slope : (k, 2) Hz/rad, zero at rest
    parity : (k,) +1 symmetric, -1 antisymmetric about the plate's middle plane, 0 if that is not a mirror
    """

    frequency: Array
    slope: Array
    parity: Ints


@dataclass(frozen=True)
class BlochModel:
    """Frequencies, modes and group velocities of a cell at any wavevector.

    The small basis covers the irreducible zone; `representative` maps every wavevector there.

    cell, resolution : of the model; count : number of bands
    fine : reduced model
    """

    cell: UnitCell
    resolution: Resolution
    count: int
    fine: ReducedCell

    @classmethod
    def of(
        cls,
        cell: UnitCell,
        resolution: Resolution,
        count: int,
        *,
        measured: bool = True,
        whole: Tiling | None = None,
        highest: float | None = None,
    ) -> BlochModel:
        """Make a model for ``count`` bands.

        Parameters
        ----------
        measured : whether characters of modes are needed
        whole : the cell condensed with this resolution; by default it is condensed here
        highest : Hz, up to which few interior modes suffice; by default all are used
        """
        resolution = resolution.for_bands(cell, count)
        # these matrices are too small for threads inside the linear algebra
        with one_thread():
            if whole is None:
                whole = Tiling.condensed(
                    cell,
                    resolution.plans(cell),
                    resolution.steps,
                    resolution.block,
                    measured=measured,
                    highest=highest,
                )
            fine = ReducedCell.of(whole, count, resolution.projection_goal)
        return cls(cell=cell, resolution=resolution, count=count, fine=fine)

    @cached_property
    def parts(self) -> dict[int, BlochModel]:
        """Models of symmetric (1) and antisymmetric (-1) motions about the middle plane, by parity."""
        if not isinstance(self.fine.pencil, SplitPencil):
            return {}
        return {parity: replace(self, fine=self.fine.of_parity(parity)) for parity in (1, -1)}

    @cached_property
    def halves(self) -> dict[int, BlochModel]:
        """Models of `parts` with the bands that are among those of the whole model at every wavevector.

        A parity without bands has no model.
        """
        wavevectors, _ = self.cell.zone.triangles(HALVES_DIVISIONS)
        counts = {
            parity: min(int((self.sampled(kappa).parity == parity).sum()) for kappa in wavevectors)
            for parity in self.parts
        }
        return {parity: replace(self.parts[parity], count=count) for parity, count in counts.items() if count}

    @cached_property
    def _samples(self) -> dict[bytes, Sample]:
        return {}

    def sampled(self, kappa: Array) -> Sample:
        """Bands at the phases (2,) in the irreducible zone, computed once."""
        key = kappa.tobytes()
        if key not in self._samples:
            self._samples[key] = self._of_parts(kappa) if self.parts else self._sample(kappa)
        return self._samples[key]

    def _sample(self, kappa: Array) -> Sample:
        values, modes = eigenpairs(self.fine.pencil, kappa, self.count)
        slope = np.nan_to_num(self.gradient(kappa, values, modes))
        return Sample(hertz(values), slope, np.zeros(len(values), dtype=np.int64))

    def _of_parts(self, kappa: Array) -> Sample:
        samples = [part.sampled(kappa) for part in self.parts.values()]
        frequency = np.concatenate([sample.frequency for sample in samples])
        slope = np.concatenate([sample.slope for sample in samples])
        parity = np.repeat(list(self.parts), [len(sample.frequency) for sample in samples])
        lowest = np.argsort(frequency, kind="stable")[: self.count]
        return Sample(frequency[lowest], slope[lowest], parity[lowest])

    def representative(self, kappa: Array) -> Representative:
        """Find the wavevector of the irreducible zone that is equivalent to the phases (2,)."""
        return Representative.of(self.cell.zone, self.cell.point_group, kappa)

    def frequencies(self, kappa: Array) -> Array:
        """(count,) frequencies at the phases (2,), Hz, without modes and errors."""
        return hertz(eigenpairs(self.fine.pencil, self.representative(kappa).kappa, self.count)[0])

    def solve(self, kappa: Array, spare: int = 0) -> Solution:
        """Compute modes and error estimates at the phases (2,), and ``spare`` modes above the last band."""
        count, source = self.count + spare, self.representative(kappa)
        kappa = source.kappa
        values, modes = eigenpairs(self.fine.pencil, kappa, count + ABOVE)
        fields = self.fine.expanded(modes, kappa)
        frequency = hertz(values)
        missing, _, left_out = self.fine.losses(modes, kappa)
        relative = self.fine.projection_error + self.fine.tiling.rim_error
        error = interior_error(values, left_out) + frequency * relative
        error += error_in_hertz(missing, frequency, self.fine.rounding)
        error = ranked(frequency, error)
        return Solution(source=source, frequency=frequency, error=error, fields=fields, modes=modes).lowest(
            count
        )

    def to_lower_orders(self, solution: Solution) -> Array:
        """(k,) estimated distances to the frequencies of a mesh with orders one lower, Hz."""
        _, lower, _ = self.fine.losses(solution.modes, solution.source.kappa)
        return error_in_hertz(lower, solution.frequency)

    def displacement(self, solution: Solution) -> Complex:
        """(nodes, 3, k) motion of the meshes of all tiles, one after the other, at `Solution.kappa`."""
        return solution.source.fields(self.fine.tiling, solution.fields)

    @cached_property
    def _worst(self) -> tuple[float, float]:
        """`worst_error` and `mesh_error`."""
        wavevectors, _ = self.cell.zone.triangles(ERROR_DIVISIONS)
        worst = np.zeros(2)
        for kappa in wavevectors:
            solution = self.solve(kappa)
            *_, left_out = self.fine.losses(solution.modes, solution.source.kappa)
            lost = interior_error(solution.values, left_out)
            moving = solution.frequency > self.rest
            errors = np.stack([solution.error, solution.error - lost])[:, moving] / solution.frequency[moving]
            worst = np.maximum(worst, errors.max(axis=1, initial=0.0))
        return float(worst[0]), float(worst[1])

    @property
    def worst_error(self) -> float:
        """Largest relative error on a coarse sampling of the irreducible zone, for modes above `rest`."""
        return self._worst[0]

    @property
    def mesh_error(self) -> float:
        """Largest relative error estimate without the truncation error of the interior."""
        return self._worst[1]

    @cached_property
    def highest(self) -> float:
        """Highest frequency of the last band at the zone's corners, Hz, the reference for rest modes.

        Gamma is not enough: there the last of three bands is a rest mode.
        """
        corners = self.cell.zone.corner_phases.values()
        return max(float(self.frequencies(kappa)[-1]) for kappa in corners)

    @cached_property
    def rest(self) -> float:
        """Frequency below which modes are rigid motions, or have errors that are mostly rounding, Hz.

        No finer mesh reduces these errors.
        """
        return max(REST * self.highest, ROUNDED * float(hertz(np.array(self.fine.rounding))))

    def gradient(self, kappa: Array, values: Array, modes: Fields) -> Array:
        """(k, 2) exact derivatives of the frequencies with respect to the phases, Hz/rad.

        ``values`` are eigenvalues (rad/s)^2 and ``modes`` those of `solve` at ``kappa``, of unit mass;
        degenerate modes must be combined so that the derivative is diagonal among them. At zero frequency it
        is not defined: NaN.
        """
        source = self.representative(kappa)
        frequency = hertz(values)
        slopes = np.stack([
            on_each(dK, modes) - values * on_each(dM, modes)
            for dK, dM in self.fine.pencil.slopes(source.kappa)
        ], axis=1)  # fmt: skip
        moving = frequency > REST * self.highest
        slopes[~moving] = np.nan
        slopes[moving] = change_in_hertz(slopes[moving], frequency[moving, None])
        return source.gradient(slopes)
