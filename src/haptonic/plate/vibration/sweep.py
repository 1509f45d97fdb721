"""Response of a plate model over a band: choice of shifts, and refinement for a tolerance."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.cantilever import euler_bernoulli
from haptonic.errors import HaptonicError, ResourceError
from haptonic.later import psutil
from haptonic.materials import IsotropicMaterial
from haptonic.plate.body.assembly import Shifted
from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.parts import Finger, Plate
from haptonic.plate.vibration.direct import direct_answer
from haptonic.plate.vibration.krylov import Basis, Chain, chains
from haptonic.plate.vibration.reduced_plate import ReducedPlate, Vibration
from haptonic.progress import Progress, silent
from haptonic.units import hz_text

# Largest distance of neighbouring shifts: in Hz for plates as large as a hand, as a share of the highest
# frequency for smaller ones, because frequencies are inverse to the size.
SPACING, SPACING_SHARE = 8e3, 0.075
MODES = 85  # between neighbouring shifts, about, at most
CROWDED = 2.7  # times as many, from which on they are parted again: modes crowd where a band begins
ROUNDS = 3  # of parting them, and of adding shifts where modes are still missing
BEYOND = 0.06  # share of the highest frequency by which shifts go beyond the band
BLOCK, LENGTH = 12, 8  # forces at each shift, and blocks of vectors that they give
LOSSES = 3  # orders to which the answer is expanded in losses other than the plate's
FEWEST_RANDOM = 4  # of the forces at each shift
NEAR_ZERO = 1e-3  # share of the highest shift's frequency that the lowest one has at least
UNKNOWNS = 30  # of a tile between others, at least; 38 to 40 seen
FACTORS = 0.9e6  # bytes of a tile while a single frequency is answered, at least; 1.04e6 to 1.08e6 seen
COPIES = 6  # of the basis in memory at the peak, about; 4.5 to 5.6 seen
WORST = 6  # shifts that a refinement adds
MOST_DIRECT = 24  # frequencies that are answered directly rather than by a larger basis


@dataclass(frozen=True, eq=False)
class Band:
    """Reduced plate for all of its drives between two frequencies, Hz."""

    low: float
    high: float
    reduced: ReducedPlate

    @classmethod
    def of(
        cls,
        model: PlateModel,
        low: float,
        high: float,
        progress: Progress = silent,
    ) -> Band:
        """Span a basis for a band; ``progress`` is called with the shifts done and all that are planned.

        A band of a single frequency has no basis; its line is solved directly.

        Raises
        ------
        ResourceError : the basis would need more memory than is free
        """
        if low == high:
            return cls(low, high, ReducedPlate(model, Basis.empty(model.assembly.size), ()))
        first = (2 * np.pi * evenly(low, high)) ** 2
        _check_memory(model, first[0], first[-1], len(first))
        done: list[None] = []
        planned = [len(first)]

        def count_shift() -> None:
            done.append(None)
            progress(len(done), planned[0])

        spanned = chains(model.assembly, _forces(model), first.tolist(), LENGTH, count_shift)
        for crowd in [1.0, *[CROWDED] * ROUNDS]:
            between = _between(spanned, crowd * MODES)
            planned[0] += len(between)
            spanned += chains(model.assembly, _forces(model), between, LENGTH, count_shift)
        band = cls._joined(model, low, high, spanned)
        for _ in range(ROUNDS if _from_zero(first[0], first[-1]) else 0):
            if not (gaps := band.reduced.basis.incomplete):
                break
            band = band.refined(np.sqrt(np.mean(gaps, axis=1)) / (2 * np.pi))
        return band

    @classmethod
    def _joined(
        cls, model: PlateModel, low: float, high: float, spanned: list[Chain], known: Basis | None = None
    ) -> Band:
        basis = Basis.of(model.assembly, spanned, known)
        return cls(low, high, ReducedPlate.of(model, basis, np.pi * (low + high)))

    def refined(self, frequencies: Array) -> Band:
        """Add shifts at frequencies, Hz."""
        model = self.reduced.model
        shifts = ((2 * np.pi * frequencies) ** 2).tolist()
        more = chains(model.assembly, _forces(model), shifts, LENGTH)
        return self._joined(model, self.low, self.high, more, self.reduced.basis)

    def touched(self, finger: Finger | None) -> Band:
        """Change or remove the finger on the same basis, without a factorisation."""
        model = self.reduced.model
        moved = replace(model, plate=replace(model.plate, finger=finger))
        reduced = ReducedPlate.of(moved, self.reduced.basis, np.pi * (self.low + self.high))
        return replace(self, reduced=reduced)

    def from_zero(self) -> Band:
        """Include all modes below the band."""
        return Band.of(self.reduced.model, 0.0, self.high)

    def answer(
        self,
        drives: Mapping[str, complex],
        frequencies: Array,
        tolerance: float,
        progress: Progress = silent,
    ) -> tuple[Band, Vibration]:
        """Compute the response to drives at frequencies, Hz, with an error of at most ``tolerance``.

        If many lines of the reduced plate are not good enough, the basis gets further shifts, or all modes
        below the band if it lacks them. Those that are left are answered directly; ``progress`` is called
        with how many of these are done, and with their number.

        Returns
        -------
        the band, refined if many lines were not good enough, and the answer

        Raises
        ------
        HaptonicError : lines that stay above the tolerance
        """
        band, omega = self, 2 * np.pi * frequencies
        if self.reduced.basis.dimension:
            band, vibration = self._on_basis(drives, omega, tolerance)
            poor = np.flatnonzero(vibration.error > tolerance)
            if len(poor):
                vibration = vibration.with_lines(poor, band._directly(drives, omega[poor], progress))
        else:
            vibration = self._directly(drives, omega, progress)
        poor = np.flatnonzero(vibration.error > tolerance)
        if len(poor):
            worst = float(frequencies[vibration.error.argmax()])
            raise HaptonicError.inaccurate(
                argument="plate.response.tolerance",
                given=f"{tolerance:g}",
                allowed=f"a tolerance that can be reached: {len(poor)} of {len(omega)} frequencies exceed "
                "this one, the worst at "
                f"{hz_text(worst, form='.3f')} with {vibration.error.max():.1e}",
                cause="very little loss, or a tolerance near rounding",
                next_step="ask for a larger tolerance, or give the plate its loss",
            )
        return band, vibration

    def _on_basis(
        self, drives: Mapping[str, complex], omega: Array, tolerance: float
    ) -> tuple[Band, Vibration]:
        """Response of the reduced plate; the basis is enlarged while many lines exceed the tolerance."""
        band, vibration = self, self.reduced.answer(drives, omega)
        for _ in range(ROUNDS):
            if (vibration.error > tolerance).sum() <= MOST_DIRECT:
                break
            larger = band._larger(_worst(omega / (2 * np.pi), vibration.error))
            if larger is None:
                break
            band, vibration = larger, larger.reduced.answer(drives, omega)
        return band, vibration

    def _larger(self, worst: Array) -> Band | None:
        """With further shifts at frequencies, Hz, or all modes below the band; None if these do not fit."""
        # without the modes below the band, a basis has Ritz values that are not modes
        basis = self.reduced.basis
        if basis.complete[0] == 0.0 or _from_zero(min(basis.below), max(basis.below)):
            return self.refined(worst)
        try:
            return self.from_zero()
        except ResourceError:
            return None

    def _directly(self, drives: Mapping[str, complex], omega: Array, progress: Progress) -> Vibration:
        """Direct solution at some angular frequencies, rad/s."""
        model = self.reduced.model
        load = model.load(drives)[:, None]
        fields = np.empty((model.assembly.size, len(omega)), dtype=complex)
        for k, frequency in enumerate(omega.tolist()):
            fields[:, [k]] = direct_answer(model, load, frequency)
            progress(k + 1, len(omega))
        parts = np.hstack([np.eye(len(omega)), 1j * np.eye(len(omega))]).T
        return self.reduced.checked(drives, omega, np.hstack([fields.real, fields.imag]), parts)


def evenly(low: float, high: float) -> Array:
    """First shifts of a basis for a band, (n,) frequencies, Hz."""
    top = high * (1 + BEYOND)
    bottom = max(low * (1 - BEYOND), NEAR_ZERO * top)
    spacing = max(SPACING, SPACING_SHARE * top)
    return np.linspace(bottom, top, int(np.ceil((top - bottom) / spacing)) + 1)


def _between(spanned: list[Chain], most: float) -> list[float]:
    """Shifts, (rad/s)^2, that part neighbours with more modes than that between them, evenly in frequency."""
    shifts = []
    for lower, upper in pairwise(sorted(spanned, key=lambda chain: chain.shift)):
        if (modes := upper.below - lower.below) > most:
            parts = int(np.ceil(modes / MODES))
            roots = np.sqrt([lower.shift, upper.shift])
            shifts += [float(np.interp(k / parts, [0, 1], roots)) ** 2 for k in range(1, parts)]
    return shifts


def _from_zero(low: float, high: float) -> bool:
    """True if shifts, (rad/s)^2, begin at the lowest possible one."""
    return low <= (2 * NEAR_ZERO) ** 2 * high


def check_cost(plate: Plate, high: float, *, single: bool = False) -> None:
    """Raise ResourceError if a plate cannot fit into this machine, before any work.

    Parameters
    ----------
    high : Hz, up to which there has to be a basis
    single : only this frequency is asked for, which needs no basis
    """
    tiles = len(plate.layout.blocks)
    modes = 0 if single else pillars_modes(plate, high)
    basis = 8.0 * COPIES * UNKNOWNS * tiles * BLOCK * LENGTH * modes / MODES
    needed, there = max(basis, FACTORS * tiles), psutil.virtual_memory().total
    if needed <= there:
        return
    share = np.sqrt(there / needed) if needed == basis else there / needed
    fits = int(share * tiles)
    gigabytes = f"{needed / 1e9:.0f} GB"
    asked = "at" if single else f"with {plate.layout.parts}, for a basis up to"
    raise ResourceError.too_large(
        argument="plate.map",
        given=f"{tiles} tiles {asked} {hz_text(high, form='.4g')}",
        allowed=f"about {fits} such tiles in the {there / 1e9:.1f} GB of this machine",
        cause=f"its equations, factorised, need at least {gigabytes}"
        if needed > basis
        else f"the pillars alone have {modes} modes up to there, whose basis needs at least {gigabytes}",
        next_step="take a smaller part of the plate" + ("" if single else ", or ask for lower frequencies"),
    )


def pillars_modes(plate: Plate, high: float) -> int:
    """Modes below a frequency, Hz, at least: those of each pillar as a cantilever that bends in two
    directions on a rigid foot."""
    counts = Counter(pillar for _, _, pillar in plate.layout.standing)
    modes = 0
    for pillar, count in counts.items():
        solid = pillar.material or plate.layout.material
        if isinstance(solid, IsotropicMaterial):
            modes += 2 * count * int((euler_bernoulli(pillar, solid) < high).sum())
    return modes


def _check_memory(model: PlateModel, low: float, high: float, shifts: int) -> None:
    """Raise ResourceError if a basis between two shifts, (rad/s)^2, would not fit.

    The modes of the tiles with their rims at rest, which are known, are a lower bound of all modes; with one
    more for each unknown of the rims they are an upper bound (Wittrick and Williams 1971, doi
    10.1093/qjmam/24.3.263). Only if memory lies between the two are the modes counted.
    """
    assembly = model.assembly
    if _from_zero(low, high):
        at_rest = sum(len(g.blocks) * int((g.tile.values < high).sum()) for g in assembly.groups)
        _check_fit(model, high, shifts, at_rest, "at least ")
        if _needed(model, shifts, at_rest + assembly.free) <= psutil.virtual_memory().available:
            return
    assembly.prepare()
    counts = []
    for shift in dict.fromkeys((low, high)):
        shifted = assembly.shifted(shift)
        counts.append(shifted.below)
        shifted.release()
    _check_fit(model, high, shifts, counts[-1] - counts[0], "")


def _needed(model: PlateModel, shifts: int, modes: float) -> float:
    """Bytes for a basis of some modes, about."""
    vectors = BLOCK * LENGTH * int(np.ceil(shifts / 2 + modes / MODES))
    return 8.0 * COPIES * model.assembly.size * vectors


def _check_fit(model: PlateModel, high: float, shifts: int, modes: int, how_sure: str) -> None:
    needed = _needed(model, shifts, modes)
    free = psutil.virtual_memory().available
    if needed > free:
        raise ResourceError.too_large(
            argument="plate.response.highest",
            given=f"{hz_text(np.sqrt(high) / (2 * np.pi * (1 + BEYOND)))}, for a plate of "
            f"{model.plate.layout.parts} and {model.assembly.size} unknowns",
            allowed=f"a basis that fits into the free memory of {free / 1e9:.1f} GB",
            cause=f"{how_sure}{modes} modes lie in the band; their basis needs {how_sure or 'about '}"
            f"{needed / 1e9:.1f} GB",
            next_step="ask for a lower highest frequency or a smaller plate, or for a larger machine; a "
            "single frequency (--at) needs no basis",
        )


def _forces(model: PlateModel) -> Callable[[Shifted], Array]:
    """Forces that start a chain: the drives, those of losses other than the plate's, and random ones."""
    drives = (
        np.stack(list(model.drives.values()), axis=1) if model.drives else np.zeros((model.assembly.size, 0))
    )

    def forces(shifted: Shifted) -> Array:
        omega = np.array([np.sqrt(abs(shifted.shift))])
        starts = [drives]
        for _ in range(LOSSES if model.extras and drives.shape[1] else 0):
            fields = shifted.solve(starts[-1])
            lossy = np.zeros_like(fields)
            for extra in model.extras:
                weight = abs(extra.impedance(omega)[0])
                lossy[extra.rows] += weight * (extra.axes @ (extra.axes.T @ fields[extra.rows]))
            starts.append(lossy)
        given = sum(start.shape[1] for start in starts)
        count = max(BLOCK - given, FEWEST_RANDOM)
        random = np.random.default_rng(int(omega[0])).standard_normal((model.assembly.size, count))
        starts.append(model.assembly.mass_times(random))
        every = np.hstack(starts)
        size = np.linalg.norm(every, axis=0)
        return np.asarray(every[:, size > 0] / size[size > 0])

    return forces


def _worst(frequencies: Array, errors: Array) -> Array:
    """Frequencies of the largest errors, without neighbouring lines."""
    lines: list[int] = []
    for k in np.argsort(-errors):
        if errors[k] > 0 and len(lines) < WORST and all(abs(int(k) - other) > 1 for other in lines):
            lines.append(int(k))
    return np.asarray(frequencies[lines])
