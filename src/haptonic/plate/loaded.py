"""Vibration below a finger at any place, per unit of the drive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.plate import Band, Fineness, Plate, PlateModel, PlateModes, modes_between
from haptonic.plate.layout import Layout
from haptonic.plate.sampling import (
    NEAR,
    driven_region,
    grid_points,
    loudest_within,
    points_of,
    reference_of,
    unit_drives,
)
from haptonic.plate.touch import Sites, below_finger, whole_finger_on
from haptonic.progress import Progress, silent

FREE = "free"  # the vibration without a finger
LOADS = (FREE, "low", "value", "high")  # by the damping of the finger


def highest(middle: float) -> float:
    """Highest frequency of a basis for the vibration near a frequency, Hz."""
    return (1 + NEAR) * middle


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
    high = highest(middle)
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


def whole_finger_by_region(found: xr.Dataset, layout: Layout, diameter: float) -> dict[str, Bools]:
    """For each region of plain plate, (point,) True for places at which the whole finger lies on it.

    found : from `loaded`; diameter : of the finger's disc, m
    """
    points = np.stack([found["x"].values, found["y"].values], axis=1)
    return {
        name: whole_finger_on(points, found["region"].values == name, layout, diameter)
        for name in layout.regions
    }
