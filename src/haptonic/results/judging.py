"""From a plate and its measurement to a verdict."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import ResponseError, ScanError
from haptonic.plate import Fineness, Plate
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse
from haptonic.results.plate.answer import responded
from haptonic.results.plate.question import reference_of, tile_names, unit_drives
from haptonic.results.scan.analysis import contrast_range
from haptonic.results.verdict import AFTER, BEFORE, MEASURED, Verdict
from haptonic.updating.agreement import agreement, normal_of, together
from haptonic.updating.fit import Fit, SmallModel, fitted
from haptonic.updating.match import MeasuredResponse
from haptonic.updating.settings import FitSettings
from haptonic.updating.shapes import How, can_identify, even
from haptonic.vibrometry.maps.gap import MeasuredGap

Array = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_BESIDE = 0.5  # share of the points that may lie beside the plate


def compute_verdict(
    plate: Plate,
    scan: FrequencyResponse,
    settings: FitSettings,
    *,
    tolerance: float,
    computed: FrequencyResponse | None,
    written: Callable[[Fit], str],
    inputs: Mapping[str, Any],
    fineness: Fineness | None = None,
    progress: Progress = silent,
) -> Verdict:
    """Compare a measurement with the model of a plate, and fit the unknowns.

    Parameters
    ----------
    scan : response registered to the plate
    computed : of this plate, at lines and points of the measurement; else it is computed there
    written : the study file with the numbers of a fit
    inputs : plain values of what was asked; progress : called with words on what is done

    Raises
    ------
    ScanError : a measurement that cannot be of this plate, or no fit
    StudyError : nothing drives the plate
    HaptonicError : lines that cannot be computed as exactly as asked for
    """
    lines = scan.frequency[scan.frequency > 0]
    scan = scan.between(settings.lowest or float(lines[0]), settings.highest or float(lines[-1]))
    _check(plate, scan)
    scan, left_out = _on_plate(plate, scan)

    def whole(of: Plate, title: str) -> FrequencyResponse:
        progress(0, 0, f"response of the {title}")
        return responded(
            of, scan.frequency, scan.points, [str(name) for name in scan.dataset["region"].values],
            tolerance, fineness=fineness, title=title, inputs=inputs,
        )  # fmt: skip

    if computed is not None:
        _check_computed(computed)
        scan, computed = together(scan, computed)
    responses = {MEASURED: scan, BEFORE: computed or whole(plate, BEFORE)}
    fit, recomputed = None, None
    if settings.vary:
        picked = _picked(len(scan.points), settings.points)
        fit = _fit(plate, scan, picked, settings, tolerance, fineness, progress)
        responses[AFTER] = whole(fit.plate, AFTER)
        exact = normal_of(_alike(responses[AFTER], scan))[:, picked]
        recomputed = float(np.linalg.norm(fit.after - exact) / np.linalg.norm(exact))
    progress(0, 0, "comparison")
    how: How = "modes" if can_identify() and even(scan.frequency) else "operating shapes"
    return Verdict(
        plate, {name: _alike(one, scan) for name, one in responses.items()},
        {name: agreement(scan, one, how) for name, one in responses.items() if name != MEASURED},
        {name: _range(plate, one) for name, one in responses.items()},
        fit, recomputed, left_out, written(fit) if fit else None, inputs,
    )  # fmt: skip


def _check(plate: Plate, scan: FrequencyResponse) -> None:
    reference, _ = reference_of(plate)
    unit, own = reference.unit, scan.reference.unit
    if unit != own:
        raise ScanError(
            argument="reference",
            given=f"a response per {own}" if own else "a response that is not divided by the drive",
            allowed=f"a response per {unit}, the unit of the first drive of the study, {reference}",
            cause="the scan refers to another channel than the drive",
            next_step="estimate the response against the drive's voltage or force",
        )
    if plate.finger is not None:
        raise ScanError(
            argument="plate.finger",
            given="a finger on the plate",
            allowed="a plate without a finger",
            cause="the study is that of a touched plate; a laser scans a free one",
            next_step="remove [plate.finger] for the comparison",
        )


def _check_computed(response: FrequencyResponse) -> None:
    if response.dataset.attrs["origin"] != "simulated":
        raise ScanError(
            argument="computed",
            given="a measured response",
            allowed="one that a plate's model has given, and which says that it is simulated",
            cause="it is another scan, or measurement and model are exchanged",
            next_step="give the response.nc of haptonic plate, or the study alone",
        )


def _on_plate(plate: Plate, scan: FrequencyResponse) -> tuple[FrequencyResponse, int]:
    """The points that lie on the plate, with the names of their tiles as regions; how many do not."""
    layout, points = plate.layout, scan.points
    names = tile_names(layout, points)
    kept = np.array([k for k, name in enumerate(names) if name], dtype=np.int64)
    if len(kept) < 3 or len(kept) < (1 - MOST_BESIDE) * len(points):
        low, high = points.min(axis=0) * 1e3, points.max(axis=0) * 1e3
        raise ScanError(
            argument="points",
            given=f"{len(points) - len(kept)} of {len(points)} beside the plate; x from {low[0]:.4g} to "
            f"{high[0]:.4g} mm, y from {low[1]:.4g} to {high[1]:.4g} mm",
            allowed=f"points on the plate, {layout.x[-1] * 1e3:.4g} x {layout.y[-1] * 1e3:.4g} mm from its "
            "lower left corner",
            cause="the scan is not registered to the plate, or is in another unit of length",
            next_step="register the scan to the plate first",
        )
    region = np.array([names[k] for k in kept], dtype=str)
    return FrequencyResponse(scan.dataset.isel(point=kept).assign_coords(region=("point", region))), len(
        points
    ) - len(kept)


def _picked(count: int, wanted: int) -> Ints:
    """Numbers of some points, drawn evenly by chance: every n-th of a grid may lie on one line."""
    return np.sort(np.random.default_rng(0).permutation(count)[:wanted])


def _fit(
    plate: Plate,
    scan: FrequencyResponse,
    picked: Ints,
    settings: FitSettings,
    tolerance: float,
    fineness: Fineness | None,
    progress: Progress,
) -> Fit:
    coherence = scan.dataset["coherence"].values[:, picked] if "coherence" in scan.dataset else None
    data = MeasuredResponse.of(
        scan.frequency, scan.points[picked], normal_of(scan)[:, picked],
        scan.dataset.attrs["quantity"] == "velocity", unit_drives(plate), coherence,
    )  # fmt: skip
    small = SmallModel.of(
        plate,
        settings.vary,
        data.frequency,
        data.points,
        data.drives,
        tolerance,
        fineness,
        progress,
    )
    return fitted(small, data, progress)


def _alike(response: FrequencyResponse, scan: FrequencyResponse) -> FrequencyResponse:
    """Velocity or displacement, as the scan has it."""
    velocity = scan.dataset.attrs["quantity"] == "velocity"
    return response.velocity() if velocity else response.displacement()


def _range(plate: Plate, response: FrequencyResponse) -> MeasuredGap | None:
    """Where the driven region stands out from the lattices; None if it does not."""
    try:
        return contrast_range(response, plate)
    except (ScanError, ResponseError):
        return None
