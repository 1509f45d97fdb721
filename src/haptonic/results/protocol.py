"""Plan of friction trials: their order, the participants' task, and how many participants are needed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from haptonic import plots
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.metronome import clicks, write_wav
from haptonic.friction.protocol import Protocol, imbalance
from haptonic.friction.signals import Label
from haptonic.friction.trial_list import NAME, write_list
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import counted
from haptonic.results.plain import split
from haptonic.results.result import Result, figure, file
from haptonic.results.sheet import sheet
from haptonic.results.table import Table
from haptonic.units import In, in_percent


@dataclass(frozen=True)
class StrokeTask:
    """Task of the participants: speed (m/s), normal force (N), length of a stroke (m), pause (s)."""

    speed: Annotated[float, In("m/s")]
    force: Annotated[float, In("N")]
    stroke: Annotated[float, In("m")]
    pause: Annotated[float, In("s")]

    @property
    def lasting(self) -> float:
        """Duration of a stroke, s."""
        return self.stroke / self.speed


@dataclass(frozen=True, eq=False, repr=False)
class TrialPlan(Result):
    """Plan of an experiment.

    study : its title
    protocol, participants : number and order of trials
    order : "published" or "balanced"
    task : the participants' task
    basis : sentence on the origin of the assumed reductions
    dataset : on (waveguide, participants) ``power`` and its Monte-Carlo ``error``; on waveguide:
        assumed ``reduction`` and ``needed`` participants (NaN if more than 60); ``shown``, the smallest
        reduction that this number of participants detects (NaN if none)
    """

    title = "Protocol"
    data_file = "power"

    study: str
    protocol: Protocol
    participants: int
    order: str
    task: StrokeTask
    dataset: xr.Dataset
    basis: str = ""

    @cached_property
    def labels(self) -> list[Label]:
        """All trials, in their order."""
        return self.protocol.order(self.participants)

    @property
    def imbalance(self) -> float:
        """Largest difference between the mean places of on and off in a session, in trials."""
        return imbalance(self.labels)

    @property
    def statements(self) -> list[str]:
        """Sentences on the effects that this number of participants can detect."""
        people = counted(self.participants, "participant")
        wanted = in_percent(self.dataset.attrs["wanted"])
        sentences = []
        for guide in self.protocol.waveguides:
            row = self.dataset.sel(waveguide=guide)
            effect = f"{guide}, {in_percent(row['reduction'])} less friction assumed"
            needed = f"{float(row['needed']):.0f}" if np.isfinite(row["needed"]) else "more than 60"
            if self.participants < 2:
                sentences.append(
                    f"{effect}: one participant allows no conclusion on other people; {needed} are needed."
                )
                continue
            chance = in_percent(row["power"].sel(participants=self.participants))
            sentences.append(
                f"{effect}: with {people} the power to detect it is {chance}; a power of {wanted} needs "
                f"{needed} participants."
            )
        least = float(self.dataset["shown"])
        if np.isfinite(least):
            sentences.append(
                f"With a power of {wanted}, {people} detect reductions of {in_percent(least)} and more."
            )
        elif self.participants > 1:
            sentences.append(f"{people} detect no reduction with a power of {wanted}.")
        idle = self.dataset.sel(waveguide=self.protocol.waveguides[1])
        if float(idle["reduction"]) >= WEBER_FRACTION:
            sentences.append(
                f"If the reduction of {self.protocol.waveguides[1]} is {in_percent(idle['reduction'])}, no "
                "number of participants can prove that it is below the noticeable "
                f"{in_percent(WEBER_FRACTION)}."
            )
        sentences.append(
            f"A test over the {self.protocol.pairs * self.participants} pairs of trials detects smaller "
            f"differences, but only for these {people}, not for other people."
        )
        return sentences

    @property
    def drift_remark(self) -> str:
        """Sentence on the effect of a drift along the session on a difference."""
        trials = self.imbalance
        if trials < 1e-9:
            return "On and off have the same mean place in every session: a steady drift cancels."
        session = self.protocol.blocks * self.protocol.trials
        added = 10 * trials / session
        return (
            f"On average, trials with the vibration on come up to {trials:.2g} place{'s' * (trials != 1)} "
            "earlier or later in a session than those with it off: a steady drift of 10 % over a session of "
            f"{session} adds {added:.2g} % of the friction to a difference."
        )

    def remarks(self) -> list[str]:
        """Warning if all participants feel the regions in the same order."""
        orders = {
            tuple(label.waveguide for label in labels)
            for _, labels in groupby(self.labels, lambda label: label.participant)
        }
        if self.participants < 2 or len(orders) > 1:
            return []
        return [
            "All participants feel the regions in the same order, so a difference between regions also "
            'contains the effect of this order. With order = "balanced" in [protocol] it changes between '
            "participants."
        ]

    def facts(self) -> dict[str, Any]:
        return {
            "order": self.order,
            "participants": self.participants,
            "blocks": self.protocol.blocks,
            "trials": self.protocol.trials,
            "waveguides": self.protocol.waveguides,
            "task": self.task,
            "imbalance_trials": self.imbalance,
            "shown": self.dataset["shown"],
            "waveguide": split(self.dataset.drop_vars("shown"), "waveguide"),
        }

    def summary(self) -> list[str]:
        sentences = self.statements
        return [
            *sentences[:2],
            *([self.basis] if self.basis else []),
            *sentences[2:],
            self.drift_remark,
            "Powers are from simulated experiments with the study's assumptions on participants.",
        ]

    def tables(self) -> list[Table]:
        """Table of the waveguide of every participant in each block."""
        rows = []
        for person in dict.fromkeys(label.participant for label in self.labels):
            blocks = {label.block: label.waveguide for label in self.labels if label.participant == person}
            rows.append((person, *blocks.values()))
        title = f"waveguide in each block, {self.order} order; {self.protocol.waveguides[0]} is driven"
        numbers = (str(block + 1) for block in range(self.protocol.blocks))
        return [Table(title, ("participant", *numbers), rows)]

    @figure("power", "Power against participants.")
    def _power(self, *, ax: Axes | None = None) -> Figure:
        return plots.power(self.dataset, self.participants, ax=ax)

    @file(NAME)
    def _write_list(self, path: Path) -> None:
        """Write the list of trials for the records."""
        write_list(self.labels, path, origin="measured")

    @file("metronome.wav")
    def _write_track(self, path: Path) -> None:
        write_wav(clicks(self.protocol.trials, self.task.lasting, self.task.pause), path)

    @file("sheet.html")
    def _write_sheet(self, path: Path) -> None:
        path.write_text(sheet(self), encoding="utf-8")
