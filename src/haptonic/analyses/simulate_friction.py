"""Made-up strokes of made-up people, as a folder that the analysis of friction reads."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.experiments import protocol_of, truth_of
from haptonic.analyses.options import Seeded, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.errors import FrictionError, ResourceError, shown
from haptonic.friction.simulation import Experiment
from haptonic.gate import json_from
from haptonic.paths import source, unread
from haptonic.results.cost import Cost
from haptonic.results.simulated_trials import SimulatedFriction
from haptonic.study.schema import Description

FILM, STROKE = 3.0, 0.006  # s, of load sharing; of a stroke that is made up and written


def read_amplitudes(given: str | Path) -> dict[str, float]:
    """Amplitudes of vibration, m, by waveguide.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : it holds something else
    """
    path = source(given, "--from")
    try:
        values: Any = json_from(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise unread(
            ResourceError,
            error,
            argument="--from",
            given=path,
            allowed='a JSON file such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="it cannot be read, or is not JSON",
            next_step="write it anew",
        ) from None
    if isinstance(values, dict) and isinstance(values.get("regions"), dict):  # what `haptonic feel` says
        values = {name: region.get("amplitude_m") for name, region in values["regions"].items()}
    numbers = isinstance(values, dict) and all(
        isinstance(one, int | float) and not isinstance(one, bool) for one in values.values()
    )
    if not numbers or not values:
        raise FrictionError.malformed(
            argument="--from",
            given=shown(values),
            allowed='amplitudes in m by waveguide, such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="the file is of another kind, or a number is written as text",
            next_step="write a number of metres for each waveguide",
        )
    return {str(name): float(value) for name, value in values.items()}


@dataclass(frozen=True, kw_only=True)
class SimulateFrictionOptions(Seeded):
    """What may be chosen."""

    participants: int | None = option(None, "How many; else the study's.", metavar="N")
    form: Literal["csv", "h5", "mat", "tdms"] = option("csv", "Of the force records.", flag="--format")
    per: Literal["trial", "block"] = option("trial", "What a file holds.")
    raw: bool = option(False, "Six gauge voltages of 16 bits and a calibration, not forces.")
    amplitudes: Any = option(
        None, 'What `feel --json` said, or {"WG1": 1e-6, ...} in m (JSON).', read=read_amplitudes,
        flag="--from", metavar="FILE",
    )  # fmt: skip


def compute(study: Description, options: SimulateFrictionOptions, runner: Runner) -> SimulatedFriction:
    """The people and the order of their strokes, which are made when they are written.

    Raises
    ------
    StudyError : no carrier, no two waveguides, or one without an amplitude
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
    )


def cost(study: Description, options: SimulateFrictionOptions) -> Cost:
    """Of every stroke."""
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
