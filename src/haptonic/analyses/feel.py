"""Friction under a finger on the plate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from haptonic.analyses import plate as vibration
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.needs import need_carrier
from haptonic.analyses.options import option
from haptonic.analyses.plate_needs import (
    check_driven,
    check_waves,
    checked_fineness,
    driven_at,
    gaps_around,
    has_plate,
    lattice_gaps,
    response_settings,
)
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import whole_lower_face
from haptonic.bloch.gaps import common_gap
from haptonic.errors import StudyError
from haptonic.fields import FREQUENCY
from haptonic.friction.lubrication.law import check_reduction
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.lubrication.settings import VOLTAGE
from haptonic.friction.lubrication.sharing import check_force
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.parts import Actuator
from haptonic.plate.layout.sampling import check_grid, driven_regions, reference_of
from haptonic.plate.vibration.sweep import check_cost
from haptonic.plate.vibration.touch import LOADS, highest, loaded, whole_finger_by_region
from haptonic.progress import Progress
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.feel.value import Feel
from haptonic.store import Store
from haptonic.study.schema import Description
from haptonic.units import format_quantity


@dataclass(frozen=True)
class FeelOptions:
    """Options of the friction map."""

    voltage: float | None = option(
        None,
        'Voltage of the first drive, such as "200 V"; the others keep their ratio to it.',
        quantity=VOLTAGE,
        metavar="VOLTAGE",
    )
    at: float | None = option(
        None,
        "Frequency of the drive; by default the strongest resonance of the driven region.",
        quantity=FREQUENCY,
        metavar="FREQUENCY",
    )
    reduction: float | None = option(
        None, "Also compute the drive for this reduction, 0.5 for 50 %.", metavar="SHARE"
    )
    html: bool = option(False, "Also one interactive HTML page, with a finger that is moved over the plate.")


def check(study: Description, options: FeelOptions) -> None:
    """Refuse a wrong reduction, a plate without drive or loss, and too large a force or frequency.

    Raises
    ------
    HaptonicError : one of these
    """
    if options.reduction is not None:
        check_reduction(options.reduction)
    plate, carrier = driven_at(study, options.at), need_carrier(study)
    middle = carrier if options.at is None else options.at
    check_driven(plate)
    check_force(study.touch.at(middle), study.touch.skin.values)
    check_waves(study, plate, middle)


def compute(study: Description, options: FeelOptions, runner: Runner) -> Feel:
    """Friction map of the plate for the finger of [touch].

    The default frequency is the resonance near the carrier at which the driven region vibrates most. The
    default voltage is that of [touch], then that of the plate.

    Raises
    ------
    StudyError : no [plate], no carrier, no drive, or a voltage for a plate that a force drives
    ResourceError : a grid or a plate that is too large for this machine, refused before the computation
    """
    plate, settings, finger = driven_at(study, options.at), response_settings(study), study.touch
    drive = amplitude(plate, finger.voltage if options.voltage is None else options.voltage)
    middle = need_carrier(study) if options.at is None else options.at
    chosen = checked_fineness(study)
    check_cost(plate, highest(plate, middle, chosen))
    check_grid(plate, settings.grid, len(LOADS))
    gaps = gaps_around(study, lattice_gaps(study, plate, runner), middle)
    gap = common_gap(gaps.values())
    vibration_below = compute_loaded(
        runner.store, study.inputs(), runner.progress, plate=plate,
        diameter=finger.pad.diameter, damping=finger.pad.damping, carrier=middle, at=options.at,
        gap=gap.edges if gap else None,
        grid=settings.grid, tolerance=settings.tolerance, fineness=chosen,
    )  # fmt: skip
    friction = FrictionOnPlate(
        loaded=vibration_below,
        below=whole_finger_by_region(vibration_below, plate.layout, finger.pad.diameter),
        driven=driven_regions(plate),
        touch=finger.at(vibration_below.attrs["frequency_hz"]),
        skin=finger.skin,
        drive=drive,
    )
    return Feel(plate, gaps, friction, options.reduction, pad=finger.pad, interactive=options.html)


def compute_loaded(
    store: Store, inputs: Mapping[str, Any], progress: Progress, *, plate: Plate, **asked: Any
) -> xr.Dataset:
    """Vibration below a finger, computed or from the store; see `haptonic.plate.vibration.touch`.

    Parameters
    ----------
    inputs : plain values of the inputs; asked : further arguments of `loaded`
    """
    asked = {**asked, "plate": replace(plate, finger=None)}  # the finger of [touch] takes its place
    return store.kept(
        {"part": "below a finger", **asked, "inputs": inputs},
        lambda: stamped(loaded(**asked, progress=progress), inputs),
    )


def amplitude(plate: Plate, voltage: float | None) -> float:
    """Amplitude of the first drive, V or N: the given voltage, or by default that of the plate.

    Raises
    ------
    StudyError : not a voltage, or a voltage for a plate that a force drives
    """
    _, default = reference_of(plate)
    if voltage is None:
        return default
    first = next(drive for drive in plate.drives if drive.amplitude)
    if not isinstance(first, Actuator):
        raise StudyError.conflict(
            argument="voltage",
            given=format_quantity(voltage, "V"),
            allowed="no voltage, because a force drives the plate",
            cause="the first drive of the plate is a force",
            next_step="change the force of [[plate.force]] instead, or leave the voltage out",
        )
    return voltage


def cost(study: Description, options: FeelOptions) -> Cost:
    """Estimated cost, equal to that of the plate."""
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
    interactive="html",
)
