"""Vibration below a finger at any place of the flat face, per unit of the drive.

On a reduced plate with dynamic stiffness A, a finger of dynamic stiffness Z, spread evenly over the n points
of a disc that it covers, turns the displacement u of these points into ``(1 + Z/n C)^-1 u`` with their
compliance ``C = S A^-1 S^T``, S being the matrix of their displacement, as in `damping`. Only C among the
points of one disc is needed, so no place of the face needs a factorisation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.gate import WORD
from haptonic.later import linalg as la, xarray as xr
from haptonic.parallel import each
from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.tile_construction import Fineness
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.keys import PLATE
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.sampling import (
    driven_region,
    grid_points,
    points_of,
    reference_of,
    unit_drives,
)
from haptonic.plate.vibration.damping import real_times
from haptonic.plate.vibration.modes import PlateModes, modes_between
from haptonic.plate.vibration.reduced_plate import ReducedPlate
from haptonic.plate.vibration.region_measures import NEAR, loudest_within
from haptonic.plate.vibration.sweep import Band
from haptonic.progress import Progress, silent
from haptonic.response.measures import discs

TOGETHER = 32  # number of places solved at once


@dataclass(frozen=True, eq=False)
class Sites:
    """Points of the flat face, and discs of a finger around them.

    points : (k, 2) m, as evenly spread as a grid; diameter : of the disc, m
    """

    points: Array
    diameter: float

    @property
    def discs(self) -> list[list[int]]:
        """For each point, the points below a finger there: those within its radius."""
        return discs(self.points, self.diameter)


def whole_finger_on(points: Array, inside: Bools, layout: Layout, diameter: float) -> Bools:
    """(point,) places (point, 2) of a region at which a whole finger lies on it and on the plate.

    They are all of its points if it is too small for one, or if there is no other region.

    inside : (point,) which points lie in the region
    """
    if inside.all():
        return inside
    clear = scipy.spatial.cKDTree(points[~inside]).query(points)[0] > 0.5 * diameter
    edges = np.array([layout.x[0], layout.y[0]]), np.array([layout.x[-1], layout.y[-1]])
    room = np.minimum(points - edges[0], edges[1] - points).min(axis=1) >= 0.5 * diameter
    whole = inside & clear & room
    return whole if whole.any() else inside


def below_finger(
    reduced: ReducedPlate,
    places: Sites,
    displacement: Complex,
    omega: float,
    impedances: Sequence[complex],
) -> Array:
    """Amplitude below a finger at every place: root mean square over its disc, m.

    Parameters
    ----------
    reduced : the plate without a finger
    displacement : (k,) normal to the face at all places, without a finger, m
    omega : rad/s
    impedances : (p,) dynamic stiffnesses of whole fingers, N/m: force over displacement, 0 for none

    Returns
    -------
    (p, k) m
    """
    discs = places.discs
    most = max(len(disc) for disc in discs)
    # short discs, at the plate's rim, are padded with a point at rest
    still = len(places.points)
    index = np.array([disc + [still] * (most - len(disc)) for disc in discs])
    count = np.array([len(disc) for disc in discs])
    seen = reduced.model.displaced(places.points, reduced.basis.raw) @ reduced.basis.turn
    seen = np.vstack([seen, np.zeros(seen.shape[1])])
    compliance = _Compliance(reduced, seen, omega)
    moved = np.append(displacement, 0.0)
    stiffness = np.asarray(impedances)
    amplitudes = np.empty((len(stiffness), len(index)))
    unit = np.eye(most)

    def some(start: int) -> None:
        picked = slice(start, start + TOGETHER)
        among = compliance.among(index[picked])
        for row, stiff in enumerate(stiffness):
            share = (stiff / count[picked])[:, None, None]
            left = np.linalg.solve(unit + share * among, moved[index[picked]][..., None])[..., 0]
            amplitudes[row, picked] = np.sqrt((np.abs(left) ** 2).sum(axis=1) / count[picked])

    each(some, range(0, len(index), TOGETHER))
    return amplitudes


class _Compliance:
    """Displacement per force between points of a reduced plate at one frequency."""

    def __init__(self, reduced: ReducedPlate, seen: Array, omega: float) -> None:
        line = np.array([omega])
        stiffness = reduced.model.factors[PLATE] * reduced.basis.values - omega**2
        for extra in reduced.extras:
            stiffness = stiffness + extra.alone[:, 0] * extra.unreduced.impedance(line)[0]
        self.seen, self.flexible = seen, 1.0 / stiffness
        directions = np.hstack([np.zeros((len(stiffness), 0)), *(extra.kept for extra in reduced.extras)])
        weights = [
            np.full(extra.kept.shape[1], extra.unreduced.impedance(line)[0]) for extra in reduced.extras
        ]
        stiff = np.concatenate([np.zeros(0), *weights])
        self.through = real_times(seen, self.flexible[:, None] * directions)
        inner = np.diag(1.0 / stiff) + real_times(directions.T, self.flexible[:, None] * directions)
        self.inner = la.inv(inner) if len(inner) else inner

    def among(self, points: Ints) -> Complex:
        """(m, n, n) compliance among each of m sets of n points, given by their numbers (m, n)."""
        near, through = self.seen[points], self.through[points]
        transposed = near.transpose(0, 2, 1)
        real = (near * self.flexible.real) @ transposed
        imaginary = (near * self.flexible.imag) @ transposed
        own = real + 1j * imaginary
        return np.asarray(own - through @ self.inner @ through.transpose(0, 2, 1))


FREE = "free"  # the vibration without a finger
LOADS = (FREE, "low", "value", "high")  # by the damping of the finger


def highest(plate: Plate, middle: float, fineness: Fineness | None = None) -> float:
    """Highest frequency of a basis for the vibration near a frequency, Hz, within what tiles resolve."""
    resolved = (fineness or Fineness()).highest_resolved(plate.layout)
    return max(middle, min((1 + NEAR) * middle, 0.999 * resolved))  # slightly below, whatever the rounding


def loaded(
    plate: Plate,
    *,
    diameter: float,
    damping: Sequence[float],
    carrier: float,
    at: float | None,
    gap: Sequence[float] | None,
    grid: float,
    tolerance: float,
    fineness: Fineness | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Compute the amplitudes below a finger per unit of the first drive.

    Parameters
    ----------
    diameter : of the disc that the finger covers, m
    damping : N s/m of the whole disc, evenly spread: the lowest plausible, the value, the highest plausible
    at : Hz; by default the strongest resonance of the driven region near the carrier, within the gap if
        ``gap`` is given
    gap : edges of the gap around the carrier, Hz
    grid : distance of the places, m; tolerance : relative error of the vibration without a finger

    Returns
    -------
    ``amplitude`` (load, point), m per unit: root mean square over the disc around each point, peak in time;
    ``quality`` (load, point) of the mode with the largest amplitude, with a finger there; ``load`` is "free"
    or the "low", "value" or "high" damping; attributes ``frequency_hz``, ``reference``, ``solver_error`` and,
    for the mode, ``mode_hz``

    Raises
    ------
    StudyError : nothing drives the plate
    ResourceError : the basis needs more memory than is free
    HaptonicError : the vibration does not reach the tolerance
    """
    plate = replace(plate, finger=None)
    middle = carrier if at is None else at
    high = highest(plate, middle, fineness)
    model = PlateModel.of(plate, high, fineness)
    band = Band.of(model, 0.0, high, progress)
    modes = modes_between(band, (1 - NEAR) * middle, high)
    points, regions = grid_points(plate, grid)
    drives = unit_drives(plate)
    low, top = gap or (0.0, np.inf)
    resonances = modes.frequency[(modes.frequency > low) & (modes.frequency < top)]
    frequencies = resonances if at is None and len(resonances) else np.array([middle])
    band, vibration = band.answer(drives, frequencies, tolerance)
    surface = model.displaced(points, vibration.vectors) @ vibration.amplitudes
    there = points_of(regions, driven_region(plate))
    line = loudest_within(frequencies, surface * vibration.omega, there, (0.0, np.inf), middle)
    omega = float(vibration.omega[line])
    places = Sites(points, diameter)
    impedances = [0.0, *(1j * omega * of_disc for of_disc in damping)]
    amplitude = below_finger(band.reduced, places, surface[:, line], omega, impedances)
    mode, quality = _loaded_quality(model, modes, drives, omega, places, damping)
    reference, _ = reference_of(plate)
    return xr.Dataset(
        {
            "amplitude": (("load", "point"), amplitude, {"units": f"m/({reference.unit})"}),
            "quality": (
                ("load", "point"), quality,
                {"long_name": "quality factor of the mode", WORD: "no mode near this frequency"},
            ),
        },
        coords={
            "load": list(LOADS),
            "x": ("point", points[:, 0], {"units": "m"}), "y": ("point", points[:, 1], {"units": "m"}),
            "region": ("point", np.array(regions, dtype=str)),
        },
        attrs={
            "frequency_hz": omega / (2 * np.pi), "mode_hz": mode, "reference": str(reference),
            "solver_error": float(vibration.error[line]), "unknowns": model.assembly.size,
            "basis": band.reduced.basis.dimension, "origin": "simulated",
            WORD: "no mode near this frequency",
        },
    )  # fmt: skip


def _loaded_quality(
    model: PlateModel,
    modes: PlateModes,
    drives: Mapping[str, complex],
    omega: float,
    places: Sites,
    damping: Sequence[float],
) -> tuple[float, Array]:
    """Mode with the largest amplitude at omega, Hz, and (load, point) its quality factor with a finger.

    Its loss is that of the plate alone and, to first order, that of the finger: damping times the mean square
    of the mode shape, of modal mass 1, below it, over omega.
    """
    if not len(modes.frequency):
        return float("nan"), np.full((len(LOADS), len(places.points)), np.nan)
    values = (2 * np.pi * modes.frequency) ** 2
    answer = modes.vectors.T @ model.load(drives) / (values * (1 + 1j / modes.quality) - omega**2)
    best = int(np.abs(answer).argmax())
    shape = model.displaced(places.points, modes.vectors[:, [best]])[:, 0]
    square = np.array([(shape[disc] ** 2).mean() for disc in places.discs])
    lost = np.array([0.0, *damping])[:, None] * square / np.sqrt(values[best])
    return float(modes.frequency[best]), 1 / (1 / modes.quality[best] + lost)


def whole_finger_by_region(vibration: xr.Dataset, layout: Layout, diameter: float) -> dict[str, Bools]:
    """For each region of plain plate, (point,) True for places at which the whole finger lies on it.

    vibration : from `loaded`; diameter : of the finger's disc, m
    """
    points = np.stack([vibration["x"].values, vibration["y"].values], axis=1)
    return {
        name: whole_finger_on(points, vibration["region"].values == name, layout, diameter)
        for name in layout.regions
    }
