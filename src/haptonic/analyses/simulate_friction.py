"""Simulated strokes of simulated participants, as a folder that the analysis of friction reads."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from haptonic.analyses.amplitudes import read_amplitudes
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.experiments import basis_of, protocol_of, truth_of
from haptonic.analyses.options import Seeded, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.fields import Quantity
from haptonic.friction.simulation import Experiment
from haptonic.results.cost import Cost
from haptonic.results.simulated_trials import SimulatedFriction
from haptonic.study.experiment_tables import MOST_PARTICIPANTS
from haptonic.study.schema import Description

FILM, STROKE = 3.0, 0.006  # s for load sharing; s per stroke that is simulated and written
PEOPLE = Quantity("", at_least=1, at_most=MOST_PARTICIPANTS)


@dataclass(frozen=True, kw_only=True)
class SimulateFrictionOptions(Seeded):
    """Options of the simulation."""

    participants: int | None = option(
        None, "Number of participants; by default the study's.", metavar="N", quantity=PEOPLE
    )
    form: Literal["csv", "h5", "mat", "tdms"] = option("csv", "Format of the force records.", flag="--format")
    per: Literal["trial", "block"] = option("trial", "Content of a file: a trial or a block.")
    raw: bool = option(False, "Write six gauge voltages of 16 bits and a calibration, not forces.")
    amplitudes: Any = option(
        None, 'Output of `feel --json`, or {"WG1": 1e-6, ...} in m (JSON).', read=read_amplitudes,
        is_path=True, flag="--from", metavar="FILE",
    )  # fmt: skip


def compute(study: Description, options: SimulateFrictionOptions, runner: Runner) -> SimulatedFriction:
    """Participants and order of the strokes; the records are simulated when they are written.

    Raises
    ------
    StudyError : no carrier, fewer than two waveguides, or a waveguide without an amplitude
    FrictionError : amplitudes or reductions that load sharing does not explain
    """
    count = study.protocol_settings.participants if options.participants is None else options.participants
    protocol = protocol_of(study)
    protocol.order(count)
    runner.progress(0, 0, "friction by load sharing")
    return SimulatedFriction(
        experiment=Experiment(truth_of(study, options.amplitudes), protocol, count, options.seed),
        study=study.to_toml(),
        suffix=f".{options.form}",
        per=options.per,
        raw=options.raw,
        basis=basis_of(study, options.amplitudes),
    )


def cost(study: Description, options: SimulateFrictionOptions) -> Cost:
    """Estimated cost of all strokes."""
    asked = study.protocol_settings
    people = options.participants or asked.participants
    return Cost(FILM + STROKE * people * asked.blocks * asked.trials)


ANALYSIS = Analysis(
    name="simulate friction",
    result=SimulatedFriction,
    compute=compute,
    supports=no_cell,
    cost=cost,
    options=SimulateFrictionOptions,
    doing="strokes",
    writes=True,
)
