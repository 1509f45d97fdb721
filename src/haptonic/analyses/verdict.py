"""Comparison of a measured response with the plate of a study, and a fit of the study's numbers to it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.analyses import plate as vibration
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option
from haptonic.analyses.plate_needs import checked_fineness, response_settings
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import whole_lower_face
from haptonic.arrays import Ints
from haptonic.errors import ResponseError, ScanError
from haptonic.plate import Plate
from haptonic.plate.layout.sampling import reference_of, region_names, unit_drives
from haptonic.plate.vibration.responses import responded
from haptonic.response import FrequencyResponse, read
from haptonic.results.cost import Cost
from haptonic.results.verdict import AFTER, BEFORE, MEASURED, Verdict
from haptonic.study.schema import Description
from haptonic.study.template import ENDING
from haptonic.units import format_quantity
from haptonic.updating.agreement import agreement, normal_of, together
from haptonic.updating.fit import Fit, SmallModel, fitted
from haptonic.updating.match import MeasuredResponse
from haptonic.updating.shapes import How, can_identify, even, resolved
from haptonic.vibrometry.maps.gap import MeasuredGap
from haptonic.vibrometry.on_plate import contrast_range

MOST_BESIDE = 0.5  # share of the points that may lie outside the plate
FITTED = 0.2  # time per fitted number, relative to that for the plate's response


def response_in(given: str) -> FrequencyResponse:
    """Read a response from its file; the command takes it before the study."""
    if Path(given).suffix == ENDING:
        raise ResponseError.conflict(
            argument="response",
            given=given,
            allowed="response.nc of a scan, and after it the study",
            cause="this is a study: the two files are exchanged",
            next_step="haptonic verdict RESPONSE STUDY",
        )
    return read(Path(given))


@dataclass(frozen=True)
class VerdictOptions:
    """Options: the responses to compare; in Python also the paths of their files."""

    response: Any = option(
        help="response.nc of a scan.", read=response_in, is_path=True, metavar="RESPONSE", place="before"
    )
    computed: Any = option(
        None,
        "The model's response, if it has been computed.",
        read=response_in,
        is_path=True,
        metavar="RESPONSE",
    )


def compute(study: Description, options: VerdictOptions, runner: Runner) -> Verdict:
    """Compare a measurement with its model, and fit the numbers of [[fit.vary]] to it.

    Raises
    ------
    StudyError : no [plate], or no drive
    ScanError : a measurement that cannot be of this plate, or that no fit explains
    """
    return compared(study, options.response, options.computed, runner)


def compared(
    study: Description, scan: FrequencyResponse, computed: FrequencyResponse | None, runner: Runner
) -> Verdict:
    """Compare a response with the plate of a study; see `compute`.

    Parameters
    ----------
    scan : response registered to the plate
    computed : response of this study's plate at frequencies and points of the scan; None to compute it
    """
    plate, settings = study.mounted_plate(), study.fit_settings
    tolerance, progress = response_settings(study).tolerance, runner.progress
    lines = scan.frequency[scan.frequency > 0]
    scan = scan.between(settings.lowest or float(lines[0]), settings.highest or float(lines[-1]))
    _check(plate, scan)
    scan, left_out = _on_plate(plate, scan)
    chosen = checked_fineness(study)

    def whole(of: Plate, title: str) -> FrequencyResponse:
        progress(0, 0, f"response of the {title}")
        return responded(
            of, scan.frequency, scan.points, [str(name) for name in scan.dataset["region"].values],
            tolerance, fineness=chosen, title=title, inputs=study.inputs(),
        )  # fmt: skip

    if computed is not None:
        _check_computed(computed)
        scan, computed = together(scan, computed)
    responses = {MEASURED: scan, BEFORE: computed or whole(plate, BEFORE)}
    fit, recomputed = None, None
    if settings.vary:
        # random points, because every n-th point of a grid may lie on one line
        picked = np.sort(np.random.default_rng(0).permutation(len(scan.points))[: settings.points])
        seen = _measured(plate, scan, picked)
        small = SmallModel.of(
            plate, settings.vary, seen.frequency, seen.points, seen.drives, tolerance, chosen, progress,
        )  # fmt: skip
        fit = fitted(small, seen, progress)
        responses[AFTER] = whole(fit.plate, AFTER)
        exact = normal_of(_alike(responses[AFTER], scan))[:, picked]
        recomputed = float(np.linalg.norm(fit.after - exact) / np.linalg.norm(exact))
    progress(0, 0, "comparison")
    identifiable = can_identify() and even(scan.frequency) and resolved(scan.frequency, plate.loss_factor)
    how: How = "modes" if identifiable else "operating shapes"
    return Verdict(
        plate=plate, responses={name: _alike(response, scan) for name, response in responses.items()},
        agreements={
            name: agreement(scan, response, how) for name, response in responses.items() if name != MEASURED
        },
        ranges={name: _range(plate, response) for name, response in responses.items()},
        fit=fit, recomputed=recomputed, left_out=left_out,
        study=fitted_study(study, fit, scan) if fit else None, inputs=study.inputs(),
    )  # fmt: skip


def fitted_study(study: Description, fit: Fit, scan: FrequencyResponse) -> str:
    """Text of the study file with the numbers of a fit, and their origin as a comment."""
    title, origin = scan.dataset.attrs["title"], scan.dataset.attrs["origin"]
    lines = [f"Numbers fitted to a {origin} response" + (f', "{title}":' if title else ":")]
    for number in fit.numbers:
        lines.append(
            f"{number.name}: {format_quantity(number.value, number.unit)}, 95 % interval: {number.range_text}"
        )
    updated = study.with_fitted({number.name: number.value for number in fit.numbers})
    head = [f"# {' '.join(line.splitlines())}" for line in lines]
    return "\n".join([*head, "", updated.to_toml()])


def _check(plate: Plate, scan: FrequencyResponse) -> None:
    reference, _ = reference_of(plate)
    unit, measured = reference.unit, scan.reference.unit
    if unit != measured:
        raise ScanError.mismatch(
            argument="reference",
            given=f"a response per {measured}" if measured else "a response that is not divided by the drive",
            allowed=f"a response per {unit}, the unit of the first drive of the study, {reference}",
            cause="the scan refers to another channel than the drive",
            next_step="estimate the response against the drive's voltage or force",
        )
    if plate.finger is not None:
        raise ScanError.mismatch(
            argument="plate.finger",
            given="a finger on the plate",
            allowed="a plate without a finger",
            cause="the study describes a touched plate; a laser scans a free one",
            next_step="remove [plate.finger] for the comparison",
        )


def _check_computed(response: FrequencyResponse) -> None:
    if response.dataset.attrs["origin"] != "simulated":
        raise ScanError.mismatch(
            argument="computed",
            given="a measured response",
            allowed="the response of a plate's model, marked as simulated",
            cause="this is another scan, or measurement and model are exchanged",
            next_step="give the response.nc of haptonic plate, or the study alone",
        )


def _on_plate(plate: Plate, scan: FrequencyResponse) -> tuple[FrequencyResponse, int]:
    """Points on the plate with the names of their regions, and the number of points outside it."""
    layout, points = plate.layout, scan.points
    names = region_names(layout, points)
    inside = np.array([k for k, name in enumerate(names) if name is not None], dtype=np.int64)
    left_out = len(points) - len(inside)
    if len(inside) < 3 or left_out > MOST_BESIDE * len(points):
        low, high = points.min(axis=0) * 1e3, points.max(axis=0) * 1e3
        raise ScanError.mismatch(
            argument="points",
            given=f"{left_out} of {len(points)} outside the plate; x from {low[0]:.4g} to "
            f"{high[0]:.4g} mm, y from {low[1]:.4g} to {high[1]:.4g} mm",
            allowed=f"points on the plate, {layout.x[-1] * 1e3:.4g} x {layout.y[-1] * 1e3:.4g} mm from its "
            "lower left corner",
            cause="the scan is not registered to the plate, or it is in another unit of length",
            next_step="register the scan to the plate first",
        )
    region = np.array([names[k] for k in inside], dtype=str)
    on_plate = scan.dataset.isel(point=inside).assign_coords(region=("point", region))
    return FrequencyResponse(on_plate), left_out


def _measured(plate: Plate, scan: FrequencyResponse, picked: Ints) -> MeasuredResponse:
    """The scan at the points that are used for the fit."""
    coherence = scan.dataset["coherence"].values[:, picked] if "coherence" in scan.dataset else None
    return MeasuredResponse.of(
        scan.frequency, scan.points[picked], normal_of(scan)[:, picked],
        scan.dataset.attrs["quantity"] == "velocity", unit_drives(plate), coherence,
    )  # fmt: skip


def _alike(response: FrequencyResponse, scan: FrequencyResponse) -> FrequencyResponse:
    """The response as velocity or displacement, like the scan."""
    velocity = scan.dataset.attrs["quantity"] == "velocity"
    return response.velocity() if velocity else response.displacement()


def _range(plate: Plate, response: FrequencyResponse) -> MeasuredGap | None:
    """Frequency range in which the driven region exceeds the lattices; None without such a range."""
    try:
        return contrast_range(response, plate)
    except (ScanError, ResponseError):
        return None


def cost(study: Description, options: VerdictOptions) -> Cost:
    """Estimated cost; see `cost_of`."""
    return cost_of(study, computed=options.computed is not None)


def cost_of(study: Description, *, computed: bool) -> Cost:
    """Estimated cost of the model's response, unless it is given, and of the fits."""
    numbers = len(study.fit_settings.vary)
    times = (0.0 if computed else 1.0) + (1.0 + FITTED * numbers if numbers else 0.0)
    return vibration.cost(study, vibration.PlateOptions()).times(times)


ANALYSIS = Analysis(
    name="verdict",
    result=Verdict,
    compute=compute,
    supports=whole_lower_face,
    cost=cost,
    options=VerdictOptions,
    doing="model",
)
