"""Responses of a plate: at given points, and over a band with maps, energies, modes and the body's motion."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex, Array
from haptonic.errors import StudyError
from haptonic.later import xarray as xr
from haptonic.plate.body.bending_waves import shortest_wavelength
from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.tile_construction import Fineness
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.sampling import grid_points, reference_of, unit_drives
from haptonic.plate.vibration.damping import real_times
from haptonic.plate.vibration.datasets import body_dataset, lines_dataset, modes_dataset
from haptonic.plate.vibration.modes import modes_between
from haptonic.plate.vibration.region_measures import ABOVE, BELOW, NEAR, marked_lines, resonance_of
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.plate.vibration.sweep import Band
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse, plain

PER_WAVE = 8  # points of a map along the shortest bending wave; with three, the picture loses half of a peak
MOST_MAPPED = 20_000  # points of a map


def need_loss(plate: Plate) -> None:
    """Raise StudyError for a plate without losses, whose resonances are unbounded."""
    if not plate.loss_factor:
        raise StudyError.missing(
            argument="plate.loss_factor",
            given="0",
            allowed="more than 0",
            cause="without loss the response at a resonance has no bound",
            next_step="add loss_factor = 1e-3 to [plate], or the loss factor of the material",
        )


def band_response(
    plate: Plate,
    settings: ResponseSettings,
    carrier: float,
    gap: list[float] | None,
    *,
    inputs: Mapping[str, Any],
    fineness: Fineness | None = None,
    progress: Progress = silent,
) -> dict[str, xr.Dataset]:
    """Compute datasets of a plate over a band.

    They are the ``response`` at the requested lines, the ``maps``, the response ``at_maps`` at the lines of
    the maps but the points of the response, energies and errors at all ``lines``, the ``modes`` near the
    carrier, and the ``body`` with its motion at the carrier.

    Parameters
    ----------
    carrier : Hz, near which modes are listed
    gap : edges, Hz, for maps below, in and above it; without a gap the only map is at the carrier
    inputs : plain values of the settings; fineness : of the mesh, if not the default
    progress : called with the shifts done and planned, then with the lines solved one by one

    Raises
    ------
    StudyError : nothing drives the plate
    ResourceError : the basis needs more memory than is free
    HaptonicError : lines that do not reach the tolerance
    """
    low, high = settings.lowest, settings.highest
    model = PlateModel.of(plate, high, fineness)

    band = Band.of(model, low, high, progress)
    modes = modes_between(band, max(low, (1 - NEAR) * carrier), min(high, (1 + NEAR) * carrier))
    reference, _ = reference_of(plate)
    aside = [carrier] if gap is None else [BELOW * gap[0], ABOVE * gap[1], *modes.frequency]
    extra = [f for f in aside if low <= f <= high]
    every = np.union1d(settings.frequencies, extra)
    band, vibration = band.answer(unit_drives(plate), every, settings.tolerance, progress)
    points, regions = grid_points(plate, settings.grid)
    surface = model.displaced(points, vibration.vectors)
    velocity = real_times(surface, vibration.amplitudes) * (1j * vibration.omega)
    marked = marked_lines(plate, every, velocity, regions, carrier, gap)
    main = np.searchsorted(every, settings.frequencies)

    def response(
        at: Array, names: Sequence[str], values: AnyComplex, lines: NDArray[np.int64], title: str
    ) -> xr.Dataset:
        return plain(
            FrequencyResponse.of(
                np.ascontiguousarray(values.T, dtype=np.complex64)[..., None],
                frequency=every[lines], x=at[:, 0], y=at[:, 1], reference=reference,
                origin="simulated", region=names, title=title, inputs=inputs,
            )
        )  # fmt: skip

    at, names = grid_points(plate, map_spacing(plate, settings.grid, float(every[marked].max())))
    mapped = real_times(model.displaced(at, vibration.vectors), vibration.amplitudes[:, marked])
    mapped *= 1j * vibration.omega[marked]
    lines = lines_dataset(plate, vibration, band)
    shapes = model.displaced(points, modes.vectors)
    at_resonance = int(marked[np.abs(every[marked] - resonance_of(every[marked], carrier, gap)).argmin()])
    return {
        "response": response(points, regions, velocity[:, main], main, "finite plate"),
        "maps": response(at, names, mapped, marked, "finite plate, the frequencies of its maps"),
        "at_maps": response(
            points, regions, velocity[:, marked], marked, "finite plate, points of the response"
        ),
        "lines": lines,
        "modes": modes_dataset(plate, band, modes, shapes, points, regions),
        "body": body_dataset(band, vibration, at_resonance),
    }


def map_spacing(plate: Plate, spacing: float, highest: float) -> float:
    """Distance of the points of maps, m: ``spacing``, or less up to a frequency (Hz) with shorter waves."""
    area = float(np.ptp(plate.layout.x) * np.ptp(plate.layout.y))
    fine = shortest_wavelength(plate.layout, highest) / PER_WAVE
    return min(spacing, max(fine, math.sqrt(area / MOST_MAPPED)))


def responded(
    plate: Plate,
    frequency: Array,
    points: Array,
    regions: Sequence[str],
    tolerance: float,
    *,
    fineness: Fineness | None = None,
    title: str = "",
    inputs: Mapping[str, Any] | None = None,
) -> FrequencyResponse:
    """Compute the velocity of points of the flat face per unit of the first drive.

    Parameters
    ----------
    frequency : (lines,) ascending, Hz; tolerance : field error of every line
    points : (points, 2) m; regions : of them

    Raises
    ------
    StudyError : nothing drives the plate
    HaptonicError : lines that stay above the tolerance
    """
    reference, _ = reference_of(plate)
    model = PlateModel.of(plate, float(frequency[-1]), fineness)
    # from 0, because a band that begins higher may need a new basis
    band = Band.of(model, 0.0, float(frequency[-1]))
    _, vibration = band.answer(unit_drives(plate), frequency, tolerance)
    seen = real_times(model.displaced(points, vibration.vectors), vibration.amplitudes)
    return FrequencyResponse.of(
        np.ascontiguousarray((seen * (1j * vibration.omega)).T)[..., None],
        frequency=frequency, x=points[:, 0].copy(), y=points[:, 1].copy(), reference=reference,
        origin="simulated", region=regions, title=title, inputs=inputs,
    )  # fmt: skip
