"""Simulated experiment as a folder that the analysis reads like a measured one, with its truth in a file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.atomic import write_atomically
from haptonic.friction.simulation import Experiment
from haptonic.friction.simulation.files import SIMULATED, WRITERS, channels_of
from haptonic.friction.simulation.gauges import calibration
from haptonic.friction.simulation.strokes import RATE, samples_of
from haptonic.friction.trial_list import NAME, Per, file_of, write_list
from haptonic.later import xarray as xr
from haptonic.paths import inside
from haptonic.progress import Progress, silent
from haptonic.results.result import Result
from haptonic.results.table import Column, Table

NOTHING = 1e-6  # smaller reductions count as zero
TRUTH, STUDY, CALIBRATION = "truth.json", "study.toml", "calibration.csv"


@dataclass(frozen=True, eq=False, repr=False)
class SimulatedFriction(Result):
    """Trials of simulated participants.

    study : text of the study file
    suffix : of the files: ".csv", ".h5", ".mat" or ".tdms"
    per : content of a file: a trial or a block
    raw : True if files contain gauge voltages, with a calibration, instead of forces and torques
    basis : sentence on the origin of the assumed reductions
    """

    title = "Simulated trials"

    experiment: Experiment
    study: str
    suffix: str = ".csv"
    per: Per = "trial"
    raw: bool = False
    basis: str = ""

    @property
    def dataset(self) -> xr.Dataset:
        """True friction and reductions of every participant."""
        people, guides = self.experiment.people, self.experiment.protocol.waveguides
        reduction = [[1 - person.remaining[guide] for guide in guides] for person in people]
        return xr.Dataset(
            {
                "friction": ("participant", [person.friction for person in people], {"units": "1"}),
                "reduction": (("participant", "waveguide"), reduction, {"units": "1"}),
            },
            coords={
                "participant": [f"P{k}" for k in range(1, len(people) + 1)],
                "waveguide": list(guides),
            },
            attrs={"origin": "simulated", "seed": self.experiment.seed},
        )

    @classmethod
    def names(cls, options: Any = None) -> list[str]:
        """Names of the files in every folder of trials; names of records depend on the protocol."""
        return [TRUTH, STUDY, NAME]

    @property
    def file_names(self) -> list[str]:
        """Names of all files."""
        records = dict.fromkeys(file_of(label, self.suffix, self.per) for label in self.experiment.labels)
        return [*records, TRUTH, STUDY, *([CALIBRATION] if self.raw else []), NAME]

    def facts(self) -> dict[str, Any]:
        """True values of the simulation."""
        truth, people, film = self.experiment.truth, self.experiment.truth.people, self.experiment.truth.film
        guides = self.experiment.protocol.waveguides
        driven, idle = (1 - truth.remaining[guide] for guide in guides)
        return {
            "origin": SIMULATED,
            "haptonic_version": version("haptonic"),
            "waveguides": {"driven": guides[0], "idle": guides[1]},
            "amplitude_m": dict(film.amplitude) if film else None,
            "population": {
                "reduction": {guide: 1 - truth.remaining[guide] for guide in guides},
                "stopped": 1 - idle / driven if driven > NOTHING else None,
                "friction": people.friction,
                "between": people.between,
                "effect_between": people.effect_between,
                "within": people.within,
                "drift": people.drift,
            },
            "participants": {
                f"P{number}": {
                    "friction": person.friction,
                    "reduction": {guide: 1 - person.remaining[guide] for guide in guides},
                }
                for number, person in enumerate(self.experiment.people, start=1)
            },
            "sensor": {
                "noise_n": people.noise,
                "bias_n": people.bias,
                "rate_hz": RATE,
                "raw": self.raw,
            },
            "force_n": list(truth.force),
            "speed_m_per_s": list(truth.speed),
        }

    def put(self, draft: Path, progress: Progress = silent) -> None:
        """Write all files in sequence; the list of trials is the last.

        Parameters
        ----------
        progress : called with the number of written trials, and of all trials
        """
        labels, matrix, done = self.experiment.labels, calibration() if self.raw else None, 0
        files = groupby(
            self.experiment.strokes(), key=lambda stroke: file_of(stroke.trial.label, self.suffix, self.per)
        )
        for name, shared in files:
            strokes = list(shared)
            channels = channels_of(strokes, matrix)
            write_atomically(inside(draft, name), partial(WRITERS[self.suffix[1:]], channels))
            done += len(strokes)
            progress(done, len(labels))
        write_atomically(draft / STUDY, lambda path: path.write_text(self.study, encoding="utf-8"))
        text = json.dumps(self.to_json(), indent=1) + "\n"
        write_atomically(draft / TRUTH, lambda path: path.write_text(text, encoding="utf-8"))
        if matrix is not None:  # six lines for Fx Fy Fz (N) and Tx Ty Tz (N m), each per V of a gauge
            write_atomically(
                draft / CALIBRATION, lambda path: np.savetxt(path, matrix, fmt="%.9g", delimiter=",")
            )
        lasting = samples_of(self.experiment.truth) / RATE if self.per == "block" else None
        listed = partial(
            write_list, labels, suffix=self.suffix, per=self.per, origin="simulated", lasting=lasting
        )
        write_atomically(draft / NAME, listed)

    def summary(self) -> list[str]:
        sentences = ["Simulated: these trials are not measured. Their true values are in truth.json."]
        return [*sentences, *([self.basis] if self.basis else [])]

    def tables(self) -> list[Table]:
        """True reductions, of the population and of every participant."""
        truth, guides = self.facts(), self.experiment.protocol.waveguides
        rows = [
            (name, row["friction"], *(row["reduction"][guide] for guide in guides))
            for name, row in {"population": truth["population"], **truth["participants"]}.items()
        ]
        columns = (
            Column("who"),
            Column("friction", form=".3f"),
            *(Column(g, "", "%", ".1f") for g in guides),
        )
        return [Table("true reductions (simulated)", columns, rows)]

    def located(self, folder: Path) -> dict[str, Any]:
        return {"folder": str(folder), "files": len(self.file_names)}
