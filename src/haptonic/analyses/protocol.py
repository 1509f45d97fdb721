"""Planning of friction trials: their order, and how many participants are needed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic.analyses.amplitudes import read_amplitudes
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.experiments import basis_of, protocol_of, task_of, truth_of
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.friction.statistics import Population, participants_needed, power, smallest_shown
from haptonic.gate import declared
from haptonic.later import xarray as xr
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.protocol import TrialPlan
from haptonic.study.schema import Description

MOST_DRAWN = 20  # participants; the power is always computed up to this number


@dataclass(frozen=True)
class ProtocolOptions:
    """Options of the protocol."""

    amplitudes: Any = option(
        None, 'Output of `feel --json`, or {"WG1": 1e-6, ...} in m (JSON).', read=read_amplitudes,
        is_path=True, flag="--from", metavar="FILE",
    )  # fmt: skip


def compute(study: Description, options: ProtocolOptions, runner: Runner) -> TrialPlan:
    """Order of a study's trials, task of the participants, and how many participants are needed.

    Raises
    ------
    StudyError : fewer than two waveguides, or strokes that are too short or too long
    FrictionError : amplitudes that load sharing does not explain
    """
    section, people, protocol = study.protocol_settings, study.participants, protocol_of(study)
    reductions = dict(zip(protocol.waveguides, (people.driven, people.idle), strict=True))
    if options.amplitudes is not None:
        remaining = truth_of(study, options.amplitudes).remaining
        reductions = {name: 1 - remaining[name] for name in protocol.waveguides}
    populations = {
        name: Population(reduction, people.effect_between, people.within, people.between)
        for name, reduction in reductions.items()
    }
    participants = section.participants
    pairs = protocol.pairs
    powers, needed = [], []
    for population in populations.values():
        needed.append(participants_needed(population, pairs, wanted=section.power))
    most = max([MOST_DRAWN, *(people + 2 for people in needed if people)])
    tried = sorted({*range(2, most + 1), max(participants, 2)})
    for population in populations.values():
        chance = power(population, tried, [pairs], tests=len(populations), seed=section.seed)
        powers.append(chance.isel(trials=0))
    joined = xr.concat(powers, dim="waveguide", combine_attrs="identical").assign_coords(
        waveguide=list(populations)
    )
    least = None
    if participants > 1:
        least = smallest_shown(next(iter(populations.values())), participants, pairs, wanted=section.power)
    joined["reduction"] = ("waveguide", [population.reduction for population in populations.values()])
    joined["needed"] = ("waveguide", np.array([np.nan if n is None else n for n in needed], dtype=float))
    joined["shown"] = np.nan if least is None else least
    declared(joined, needed="more than are ever tried", shown="no reduction at all")
    joined.attrs |= {"wanted": section.power}
    return TrialPlan(
        study=study.title,
        protocol=protocol,
        participants=participants,
        order=section.order,
        task=task_of(study),
        dataset=stamped(joined, study.inputs()),
        basis=basis_of(study, options.amplitudes),
    )


ANALYSIS = Analysis(
    name="protocol",
    result=TrialPlan,
    compute=compute,
    supports=no_cell,
    options=ProtocolOptions,
    cost=lambda study, options: Cost(3.0),  # simulated experiments
    doing="simulated experiments",
)
