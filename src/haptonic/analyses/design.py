"""Design search: the cell whose gap contains the carrier with the widest margin."""

from __future__ import annotations

from dataclasses import dataclass, replace

from haptonic.analyses.analysis import KEPT, Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.designing.front import compute_front
from haptonic.analyses.designing.search import compute_design
from haptonic.analyses.needs import need_carrier
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import made_of_parts
from haptonic.design.brief import Brief
from haptonic.design.discs import with_shared
from haptonic.design.quick import QUICK
from haptonic.design.unmet import check_met
from haptonic.errors import StudyError
from haptonic.later import xarray as xr
from haptonic.materials import IsotropicMaterial
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.design import Design
from haptonic.study.named import links_of
from haptonic.study.schema import Description

# share of the estimate for one mesh, per design of a search: twenty drawn searches of square lattices took
# 0.15 to 0.4 s per design, those of honeycomb and kagome lattices 1.0 and 0.8 s
QUICK_DESIGN = 0.25
REFINED = 6  # designs of a search that are computed to the full accuracy


@dataclass(frozen=True)
class DesignOptions:
    """Options of the design search."""

    pareto: bool = option(False, "Also the widest gap against the pitch.")


def check(study: Description, options: DesignOptions) -> None:
    """Raise StudyError if no parameter may vary, or no design is allowed.

    A front needs the pitch and another parameter.
    """
    check_met(brief(study))
    names = [item.parameter for item in study.design_settings.vary]
    if options.pareto and ("cell.pitch" not in names or len(names) < 2):
        raise StudyError.missing(
            argument="design.vary",
            given=", ".join(names) or "nothing",
            allowed="cell.pitch and at least one other parameter",
            cause="the front shows the best margin of each pitch",
            next_step="let both vary, or leave --pareto out",
        )


def brief(study: Description) -> Brief:
    """Requirements for a design, in the form of `haptonic.design`.

    Raises
    ------
    StudyError : no carrier, or no parameter to vary
    """
    section, carrier = study.design_settings, need_carrier(study)
    if not section.vary:
        raise StudyError.missing(
            argument="design.vary",
            allowed="at least one [[design.vary]] table with parameter, from and to",
            cause="the study does not name a parameter to vary",
            next_step='add [[design.vary]] with parameter = "cell.pillar.height", from and to',
        )
    if section.limits.finger_force is not None and not isinstance(study.cell.material, IsotropicMaterial):
        raise StudyError.unsupported(
            argument="design.finger_force",
            given=f"a plate of {study.cell.material.name}",
            allowed="an isotropic material",
            cause="the formula for a plate under a finger is for isotropic materials",
            next_step="leave design.finger_force out and bound cell.thickness instead",
        )
    return Brief(
        cell=study.cell,
        carrier=carrier,
        count=study.bands_settings.count,
        bounds={item.parameter: (item.low, item.high) for item in section.vary},
        allowed=section.limits,
        links=links_of(study),
    )


def compute(study: Description, options: DesignOptions, runner: Runner) -> Design:
    """Search the design and return it as a study; with ``pareto`` also the widest margin of each pitch.

    Raises
    ------
    StudyError : a carrier that no allowed design reaches
    """
    section = study.design_settings
    design = compute_design(
        brief(study), study.bands_settings, starts=section.starts, climbs=section.climbs, steps=section.steps,
        inputs=study.inputs(), runner=runner,
    )  # fmt: skip
    values = study.parameters()
    return replace(
        design,
        own={path: values[path] for path in design.values},
        study=study.without_plate().with_parameters(with_shared(study.cell, design.values)).to_toml(),
        front=front(study, design, runner) if options.pareto else None,
    )


def front(study: Description, best: Design, runner: Runner) -> xr.Dataset:
    """Widest margin against the pitch, between the bounds of the pitch."""
    asked, count = brief(study), study.design_settings.pitches
    low, high = asked.bounds["cell.pitch"]
    pitches = [low + (high - low) * i / (count - 1) for i in range(count)]
    front = compute_front(asked, best.values, pitches, steps=study.design_settings.steps, runner=runner)
    return stamped(front, study.inputs())


def cost(study: Description, options: DesignOptions) -> Cost:
    """Estimated cost of a search; a carrier that is hard to reach takes longer."""
    section = study.design_settings
    seen = section.starts + section.climbs * section.steps
    refined = replace(gaps(study).times(REFINED), refusal=None)  # other cells may be possible
    once = Cost(QUICK_DESIGN * QUICK.seconds(study.cell) * seen) + refined
    return once.times(1 + section.pitches / 2) if options.pareto else once


ANALYSIS = Analysis(
    name="design",
    result=Design,
    compute=compute,
    supports=made_of_parts,
    cost=cost,
    planned=lambda study: study.carrier is not None and bool(study.design_settings.vary),
    options=DesignOptions,
    check=check,
    parallel=True,
    kept=KEPT,
)
