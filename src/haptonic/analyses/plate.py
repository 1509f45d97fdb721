"""Vibration of the finite plate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import gaps
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
    response,
    response_settings,
)
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import whole_lower_face
from haptonic.bloch import Gap
from haptonic.bloch.gaps import common_gap, shared_gaps
from haptonic.fields import FREQUENCY
from haptonic.plate import Fineness, Plate
from haptonic.plate.layout.sampling import check_grid
from haptonic.plate.vibration.responses import band_response
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.plate.vibration.sweep import check_cost
from haptonic.progress import Progress, silent
from haptonic.response import from_plain
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.plate.value import CarrierAnswer, PlateResult
from haptonic.store import Store, content_key
from haptonic.study.schema import Description

PARTS = ("response", "maps", "at_maps", "lines", "modes", "body")
STAMPED = ("lines", "modes", "body")  # parts that get the inputs here; a response contains its inputs


@dataclass(frozen=True)
class PlateOptions:
    """Options of the plate.

    settings : other frequencies and points than in [plate.response], in Python only
    """

    at: float | None = option(
        None, 'One frequency only, such as "58.8 kHz".', quantity=FREQUENCY, metavar="FREQUENCY"
    )
    html: bool = option(False, "Also one interactive HTML page, with the plate moving at every frequency.")
    settings: ResponseSettings | None = field(default=None)


def check(study: Description, options: PlateOptions) -> None:
    """Refuse a study without plate or carrier, a plate without drive or loss, and too high frequencies.

    Raises
    ------
    HaptonicError : one of these
    """
    at, plate = options.at, study.mounted_plate()
    if at is None:
        need_carrier(study)
    for frequency in study.carriers if at is None else (at,):
        check_driven(driven_at(study, frequency))
    settings = options.settings or response_settings(study)
    highest = max(settings.highest, *study.carriers) if at is None else at
    check_waves(study, plate, highest)


def compute(study: Description, options: PlateOptions, runner: Runner) -> PlateResult:
    """Response of the plate to its drives over the band of [plate.response], or at one frequency.

    Raises
    ------
    StudyError : no [plate], no carrier, or no drive
    ResourceError : a grid or a plate that is too large for this machine, refused before the computation
    """
    at = options.at
    carriers = study.carriers
    plate = driven_at(study, at)
    carrier = need_carrier(study) if at is None else at
    settings = options.settings or response_settings(study)
    if at is not None:
        settings = settings.single(at)
    check_cost(plate, settings.highest, single=at is not None)
    place = "plate.response.grid" if options.settings is None else "scan.grid"
    check_grid(plate, settings.grid, settings.points, place)
    chosen = checked_fineness(study)  # raises before the gap is searched
    means: Any = {
        "inputs": study.inputs(), "store": runner.store, "fineness": chosen, "progress": runner.progress,
    }  # fmt: skip
    if at is not None:
        single = compute_plate(plate, settings, carrier=carrier, gap=None, **means)
        return replace(single, interactive=options.html)
    plates = {each: study.mounted_plate(each) for each in carriers}
    known = {each: lattice_gaps(study, driven, runner) for each, driven in plates.items()}
    around = {each: gaps_around(study, known[each], each) for each in plates}
    shared = {each: common_gap(beside.values()) for each, beside in around.items()}
    result = replace(
        compute_plate(plate, settings, carrier=carrier, gap=shared[carrier], **means),
        interactive=options.html,
        gaps=shared_gaps(known[carrier].values()),
    )
    if len(carriers) == 1:
        return result
    alone = {
        each: compute_plate(driven, settings.single(each), carrier=each, gap=shared[each], **means)
        for each, driven in plates.items()
    }
    return replace(result, answers=tuple(CarrierAnswer(each, around[each], alone[each]) for each in carriers))


def compute_plate(
    plate: Plate,
    settings: ResponseSettings,
    *,
    carrier: float,
    gap: Gap | None,
    inputs: Mapping[str, Any],
    store: Store,
    fineness: Fineness | None = None,
    progress: Progress = silent,
) -> PlateResult:
    """Response of a plate to its drives, computed or from the store.

    Parameters
    ----------
    carrier : Hz, near which modes are listed
    gap : for maps below, in and above it; without a gap the only map is at the carrier
    inputs : plain values of the inputs; fineness : of the mesh, if not the usual one
    progress : called with shifts done and planned, then with the frequencies that are solved one by one

    Raises
    ------
    StudyError : no drive, or a plate without loss
    ResourceError : the basis needs more memory than this machine has
    HaptonicError : frequencies at which the required tolerance cannot be reached
    """
    check_driven(plate)
    edges = list(gap.edges) if gap else None
    keys = [
        content_key(
            {"part": f"plate {part}", "plate": plate, "settings": settings, "carrier": carrier, "gap": edges,
             "fineness": fineness, "inputs": inputs}
        )
        for part in PARTS
    ]  # fmt: skip
    parts = [dataset for key in keys if (dataset := store.get(key)) is not None]
    if len(parts) < len(keys):
        computed = band_response(
            plate, settings, carrier, edges, inputs=inputs, fineness=fineness, progress=progress
        )
        parts = [stamped(computed[name], inputs) if name in STAMPED else computed[name] for name in PARTS]
        for key, dataset in zip(keys, parts, strict=True):
            store.put(key, dataset)
    response, marked, at_maps, lines, modes, body = parts
    return PlateResult(
        plate=plate,
        gap=gap,
        carrier=carrier,
        response=from_plain(response),
        marked=from_plain(marked),
        at_maps=from_plain(at_maps),
        lines=lines,
        modes=modes,
        body=body,
    )


def cost(study: Description, options: PlateOptions) -> Cost:
    """Estimated cost of the plate's response and of its lattice's gap."""
    plate, settings = study.mounted_plate(), response_settings(study)
    if options.at is not None:
        return response(study, plate, settings.single(options.at))
    total, carriers = gaps(study) + response(study, plate, settings), study.carriers
    for carrier in carriers if len(carriers) > 1 else ():
        total += response(study, plate, settings.single(carrier))
    return total


ANALYSIS = Analysis(
    name="plate",
    result=PlateResult,
    compute=compute,
    supports=whole_lower_face,
    cost=cost,
    reported=lambda study: PlateOptions(html=True) if has_plate(study) else None,
    options=PlateOptions,
    check=check,
    doing="shifts",
    interactive="html",
)
