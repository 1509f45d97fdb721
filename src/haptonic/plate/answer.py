"""Response of a plate at given points and frequency lines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.plate import Band, Fineness, Plate, PlateModel
from haptonic.plate.damping import real_times
from haptonic.plate.sampling import reference_of, unit_drives
from haptonic.response import FrequencyResponse


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
    band = Band.of(
        model, 0.0, float(frequency[-1])
    )  # from 0, because a band that begins higher may need a new basis
    _, vibration = band.answer(unit_drives(plate), frequency, tolerance)
    seen = real_times(model.displaced(points, vibration.vectors), vibration.amplitudes)
    return FrequencyResponse.of(
        np.ascontiguousarray((seen * (1j * vibration.omega)).T)[..., None],
        frequency=frequency, x=points[:, 0].copy(), y=points[:, 1].copy(), reference=reference,
        origin="simulated", region=regions, title=title, inputs=inputs,
    )  # fmt: skip
