"""What a finger feels of the plate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from haptonic.analyses import plate as vibration
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.needs import checked_fineness, gap_of_plate, has_plate, need_carrier, response_settings
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import whole_lower_face
from haptonic.errors import StudyError
from haptonic.friction.lubrication.law import check_reduction
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.lubrication.settings import VOLTAGE
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.loaded import LOADS, highest, loaded, whole_finger_by_region
from haptonic.plate.parts import Actuator
from haptonic.plate.sampling import check_grid, driven_regions, drives_of, reference_of
from haptonic.plate.sweep import check_cost
from haptonic.progress import Progress
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.feel.value import Feel
from haptonic.store import Store
from haptonic.study.schema import Description
from haptonic.units import format_quantity


@dataclass(frozen=True)
class FeelOptions:
    """What may be chosen."""

    voltage: float | None = option(
        None, 'Voltage of the first actuator, such as "200 V".', unit="V", metavar="VOLTAGE"
    )
    at: float | None = option(
        None, "Frequency of the drive; by default the loudest resonance.", unit="Hz", metavar="FREQUENCY"
    )
    reduction: float | None = option(
        None, "Also compute the drive for this reduction, 0.5 for 50 %.", metavar="SHARE"
    )


def check(study: Description, options: FeelOptions) -> None:
    """Raise StudyError for a reduction that is no share of friction."""
    if options.reduction is not None:
        check_reduction(options.reduction)


def compute(study: Description, options: FeelOptions, runner: Runner) -> Feel:
    """Friction wherever the finger lies, by the study's [touch].

    Without a frequency it is the resonance of the driven region that is loudest near the carrier; without a
    voltage that of [touch], or else the plate's.

    Raises
    ------
    StudyError : no [plate], no carrier, nothing that drives the plate, or a voltage for a force
    ResourceError : a grid or a plate that this machine cannot hold, found before anything is computed
    """
    plate, carrier, own, finger = (
        study.mounted_plate(),
        need_carrier(study),
        response_settings(study),
        study.touch,
    )
    drive = amplitude(plate, finger.voltage if options.voltage is None else options.voltage)
    middle = carrier if options.at is None else options.at
    finger.at(middle)  # refused before anything is computed
    check_cost(plate, highest(middle))
    check_grid(plate, own.grid, len(LOADS))
    chosen = checked_fineness(study)
    gap = gap_of_plate(study, plate, carrier, runner)
    found = compute_loaded(
        runner.store, study.inputs(), runner.progress, plate=plate,
        diameter=finger.pad.diameter, damping=finger.pad.damping, carrier=carrier, at=options.at,
        gap=(gap.lower, gap.upper) if gap else None,
        grid=own.grid, tolerance=own.tolerance, fineness=chosen,
    )  # fmt: skip
    friction = FrictionOnPlate(
        loaded=found,
        below=whole_finger_by_region(found, plate.layout, finger.pad.diameter),
        driven=driven_regions(plate),
        touch=finger.at(found.attrs["frequency_hz"]),
        skin=finger.skin,
        drive=drive,
    )
    return Feel(plate, gap, friction, options.reduction)


def compute_loaded(
    store: Store, inputs: Mapping[str, Any], progress: Progress, *, plate: Plate, **asked: Any
) -> xr.Dataset:
    """Vibration below a finger, from the store if it was computed before; see `haptonic.plate.loaded.loaded`.

    Parameters
    ----------
    inputs : plain values of what was asked; asked : all that `loaded` is given besides
    """
    asked = {**asked, "plate": replace(plate, finger=None)}  # the finger of [touch] takes its place
    return store.kept(
        {"part": "below a finger", **asked, "inputs": inputs},
        lambda: stamped(loaded(**asked, progress=progress), inputs),
    )


def amplitude(plate: Plate, voltage: float | None) -> float:
    """Of the first drive, V or N: the voltage given, or else the plate's own.

    Raises
    ------
    StudyError : no voltage at all, or one for a force
    """
    _, own = reference_of(plate)
    if voltage is None:
        return own
    if not VOLTAGE.holds(voltage):
        raise StudyError.out_of_range(
            argument="voltage",
            given=format_quantity(voltage, "V"),
            allowed=VOLTAGE.allowed,
            cause="it is zero or negative, or its unit slipped",
            next_step='give the amplitude, such as "200 V"',
        )
    first = next(drive for drive in drives_of(plate) if drive.amplitude)
    if not isinstance(first, Actuator):
        raise StudyError.conflict(
            argument="voltage",
            given=format_quantity(voltage, "V"),
            allowed="nothing, because a force drives the plate",
            cause="the first drive of the plate is no actuator",
            next_step="change the force of [[plate.force]] instead, or leave the voltage out",
        )
    return voltage


def cost(study: Description, options: FeelOptions) -> Cost:
    """As that of the plate."""
    return vibration.cost(study, vibration.PlateOptions(at=options.at))


ANALYSIS = Analysis(
    name="feel",
    result=Feel,
    compute=compute,
    supports=whole_lower_face,
    cost=cost,
    reported=lambda study: FeelOptions() if has_plate(study) else None,
    options=FeelOptions,
    check=check,
    doing="shifts",
)
