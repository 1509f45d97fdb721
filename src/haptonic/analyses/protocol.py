"""Trials with people before they are made: their order, and how many participants are needed."""

from __future__ import annotations

from haptonic.analyses.analysis import Analysis, NoOptions
from haptonic.analyses.experiments import protocol_of, task_of
from haptonic.friction.statistics import Population
from haptonic.results.protocol import Plan, compute_plan
from haptonic.results.runner import Runner
from haptonic.study.schema import Description


def compute(study: Description, options: NoOptions, runner: Runner) -> Plan:
    """The order of a study's trials, what people are asked to do, and how many of them are needed.

    Raises
    ------
    StudyError : no two waveguides to compare, or strokes that last too short or too long
    """
    section, people, protocol = study.protocol_settings, study.participants, protocol_of(study)
    populations = {
        name: Population(reduction, people.effect_between, people.within, people.between)
        for name, reduction in zip(protocol.waveguides, (people.driven, people.idle), strict=True)
    }
    return compute_plan(
        protocol,
        section.participants,
        populations,
        task_of(study),
        title=study.title,
        order=section.order,
        wanted=section.power,
        seed=section.seed,
        inputs=study.inputs(),
    )


ANALYSIS = Analysis(
    name="protocol",
    help="Order of friction trials: list, printed sheet, metronome, and how many participants are needed.",
    result=Plan,
    compute=compute,
    doing="simulated experiments",
)
