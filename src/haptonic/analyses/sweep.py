"""Complete gaps along the sweeps of a study."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.analyses.analysis import KEPT, Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.options import NoOptions
from haptonic.analyses.points import ComputedPoint, PointNumber
from haptonic.analyses.runner import Runner, design_gaps, gaps_task
from haptonic.analyses.support import every_cell
from haptonic.bloch import gaps_of
from haptonic.cell import UnitCell
from haptonic.cell.cantilever import euler_bernoulli, timoshenko
from haptonic.errors import StudyError
from haptonic.gate import declared
from haptonic.jobs import Outcome
from haptonic.later import xarray as xr
from haptonic.materials import IsotropicMaterial
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.sweeps import VALUES, Sweep, Sweeps
from haptonic.study.schema import Description
from haptonic.study.sweeps import SweepSettings

RESONANCES = 3  # number of resonances of the pillar alone


def check(study: Description, options: NoOptions) -> None:
    """Raise StudyError if the study has no sweep."""
    if not study.sweep_settings:
        varied = "cell.pillar.diameter / cell.pitch"
        if study.cell.pillar is None:
            sizes = (path for path in study.parameters() if path.startswith(("cell.", "material.")))
            varied = next(sizes, "bands.accuracy")
        raise StudyError.missing(
            argument="sweep",
            allowed="at least one [[sweep]] table",
            cause="the study describes a single design",
            next_step=f'add [[sweep]] with vary = "{varied}", from, to and steps',
        )


def compute(study: Description, options: NoOptions, runner: Runner) -> Sweeps:
    """Complete gaps of every design; a result with designs that could not be computed lists them.

    Raises
    ------
    HaptonicError : the error of the first design, if no design could be computed
    """
    designs = [study.designs(sweep) for sweep in study.sweep_settings]
    rows = [[design.cell for design in row] for row in designs]
    tasks = [gaps_task(cell, study.bands_settings) for row in rows for cell in row]
    steps = [
        (sweep, values, design)
        for sweep, row in zip(study.sweep_settings, designs, strict=True)
        for values, design in zip(sweep.designs, row, strict=True)
    ]
    outcomes = runner.tried(
        design_gaps, tasks, 0, lambda k, outcome: runner.report(swept_point(*steps[k], outcome))
    )
    refused = [outcome.error for outcome in outcomes if outcome.error is not None]
    if len(refused) == len(outcomes):
        raise refused[0]
    remaining = iter(outcomes)
    each = zip(study.sweep_settings, rows, strict=True)
    return Sweeps(tuple(swept(study, sweep, row, [next(remaining) for _ in row]) for sweep, row in each))


def swept_point(
    sweep: SweepSettings, values: Sequence[float], design: Description, outcome: Outcome
) -> ComputedPoint:
    """A design of a sweep with the edges of its widest complete gap."""
    parameters = design.parameters()
    gaps = () if outcome.dataset is None else gaps_of(outcome.dataset)
    widest = max((gap for gap in gaps if gap.complete), key=lambda gap: gap.width, default=None)
    return ComputedPoint(
        group=" and ".join(axis.vary for axis in sweep.axes),
        changes={axis.expression.varied: parameters[axis.expression.varied] for axis in sweep.axes},
        varied=tuple(
            PointNumber(axis.vary, value, axis.unit)
            for axis, value in zip(sweep.axes, values, strict=True)
        ),
        results=() if widest is None else (
            PointNumber("lower edge", widest.lower, "Hz", widest.lower_error),
            PointNumber("upper edge", widest.upper, "Hz", widest.upper_error),
        ),
    )  # fmt: skip


def swept(
    study: Description, sweep: SweepSettings, cells: Sequence[UnitCell], outcomes: Sequence[Outcome]
) -> Sweep:
    """One sweep; values that could not be computed are NaN."""
    slots = max([o.dataset.sizes["gap"] for o in outcomes if o.dataset is not None], default=0)
    names = ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error", "gap_below")
    table = {name: np.full((len(cells), slots), np.nan) for name in names}
    highest, reached = np.full(len(cells), np.nan), np.full(len(cells), np.nan)
    for step, outcome in enumerate(outcomes):
        if outcome.dataset is not None:
            for name in names:
                table[name][step, : outcome.dataset.sizes["gap"]] = outcome.dataset[name]
            highest[step] = float(outcome.dataset["searched_up_to"])
            reached[step] = outcome.dataset.attrs.get("largest_error", np.nan)
    beams = [_cantilever(cell) for cell in cells]
    designs = np.array(sweep.designs)
    dataset = xr.Dataset(
        {
            **{name: ("step", designs[:, k]) for k, name in enumerate(VALUES[: len(sweep.axes)])},
            **{name: (("step", "gap_slot"), array) for name, array in table.items()},
            "searched_up_to": ("step", highest),
            "missed_accuracy": ("step", reached),
            "euler_bernoulli": (("step", "resonance"), np.stack([slender for slender, _ in beams])),
            "timoshenko": (("step", "resonance"), np.stack([stocky for _, stocky in beams])),
        }
    )
    for variable in dataset.values():
        variable.attrs = {"units": "1" if variable.name in ("gap_below", "missed_accuracy") else "Hz"}
    declared(
        dataset,
        **dict.fromkeys(table, "no further gap"),
        searched_up_to="the design could not be computed",
        missed_accuracy="the accuracy was reached, or the design could not be computed",
        **dict.fromkeys(("euler_bernoulli", "timoshenko"), "no formula for this pillar"),
    )
    facts: dict[str, str | float | None] = {
        "carrier_hz": study.carrier,
        "accuracy": study.bands_settings.accuracy,
    }
    for name, prefix, axis in zip(VALUES, ("", "second_"), sweep.axes, strict=False):
        dataset[name].attrs = {"units": axis.unit or "1", "long_name": axis.vary}
        facts |= {f"{prefix}expression": axis.vary, f"own_{name}": axis.expression.value(study.parameters())}
    dataset.attrs = {name: value for name, value in facts.items() if value is not None}
    failed = {step: o.error.parts() for step, o in enumerate(outcomes) if o.error is not None}
    return Sweep(stamped(dataset, study.inputs()), failed)


def _cantilever(cell: UnitCell) -> tuple[np.ndarray, np.ndarray]:
    solid = cell.pillar_material
    if cell.pillar is None or not isinstance(solid, IsotropicMaterial):
        return np.full(RESONANCES, np.nan), np.full(RESONANCES, np.nan)
    slender = np.full(RESONANCES, np.nan)
    if cell.pillar.is_cylinder:  # equation (3) is for cylinders
        slender = euler_bernoulli(cell.pillar, solid)
    return slender, timoshenko(cell.pillar, solid, RESONANCES)


def cost(study: Description, options: NoOptions) -> Cost:
    """Estimated cost of all designs; refused if each of them is."""
    designs = (design for sweep in study.sweep_settings for design in study.designs(sweep))
    costs = (gaps(design) for design in (study, *designs))
    refused = next(costs)
    each = (
        refused
        if refused.refusal is None
        else next((design for design in costs if not design.refusal), refused)
    )
    return each.times(sum(sweep.count for sweep in study.sweep_settings))


ANALYSIS = Analysis(
    name="sweep",
    result=Sweeps,
    compute=compute,
    supports=every_cell,
    cost=cost,
    reported=lambda study: NoOptions() if study.sweep_settings else None,
    check=check,
    parallel=True,
    kept=KEPT,
)
