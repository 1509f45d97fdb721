"""The study: a description that can be asked to compute."""

from __future__ import annotations

from collections.abc import Callable

import xarray as xr

from haptonic.design.brief import Brief
from haptonic.errors import StudyError
from haptonic.results import (
    Bands,
    Design,
    Row,
    Runner,
    Sweep,
    Tolerance,
    compute_bands,
    compute_design,
    compute_front,
    compute_sweeps,
    compute_tolerance,
)
from haptonic.results.tolerance import BATCH
from haptonic.store import Store
from haptonic.study.schema import Description


class Study(Description):
    """What a study file describes, and all that can be computed from it.

    It is read by `haptonic.study.load`. Each method gives a result that holds all of the answer.
    """

    def need_sweeps(self) -> None:
        """Raise StudyError if the study has no sweep."""
        if not self.sweep:
            raise StudyError(
                argument="sweep",
                given="nothing",
                allowed="at least one [[sweep]] table",
                cause="the study describes a single design",
                next_step='add [[sweep]] with vary = "cell.pillar.diameter / cell.pitch", from, to and steps',
            )

    def bands(self, *, surface: bool = False, store: Store | None = None) -> Bands:
        """Band diagram, gaps and mode shapes of the unit cell.

        Parameters
        ----------
        surface : also sample the whole zone evenly, for contours and the density of states
        store : where results are kept; the user's own by default

        Raises
        ------
        ResourceError : the accuracy needs more memory than there is
        """
        return compute_bands(
            self.unit_cell(),
            self.asked(),
            surface=surface,
            inputs=self.inputs(),
            carrier=self.carrier,
            store=store or Store.default(),
        )

    def swept(
        self,
        *,
        store: Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        on_progress: Callable[[int, int, bool], None] | None = None,
    ) -> tuple[Sweep, ...]:
        """Complete gaps of every design of the study's sweeps; see `haptonic.jobs.run_all`."""
        rows = [
            Row(
                sweep.values,
                [design.unit_cell() for design in self.designs(sweep)],
                {
                    "expression": sweep.vary,
                    "units": sweep.unit,
                    "own_value": sweep.expression.value(self.parameters()),
                    "carrier_hz": self.carrier,
                },
            )
            for sweep in self.sweep
        ]
        return compute_sweeps(
            rows,
            self.asked(),
            inputs=self.inputs(),
            store=store or Store.default(),
            workers=workers,
            scheduler=scheduler,
            on_progress=on_progress,
        )

    def brief(self) -> Brief:
        """What is asked of a design, as the core computes with it.

        Raises
        ------
        StudyError : no carrier, or nothing that may change
        """
        section, carrier = self.design, self.need_carrier()
        if not section.vary:
            raise StudyError(
                argument="design.vary",
                given="nothing",
                allowed="at least one [[design.vary]] table with parameter, from and to",
                cause="the study does not say what may change",
                next_step='add [[design.vary]] with parameter = "cell.pillar.height", from and to',
            )
        return Brief(
            cell=self.unit_cell(),
            carrier=carrier,
            count=self.bands_section.count,
            bounds={one.parameter: (one.start, one.stop) for one in section.vary},
            slenderness=section.slenderness,
            tool=section.tool,
            reach=section.reach,
            finger=section.finger,
        )

    def designed(self, runner: Runner | None = None) -> Design:
        """The design whose gap holds the carrier with the widest margin.

        Raises
        ------
        StudyError : bounds that contradict each other, or a carrier that no allowed design reaches
        """
        section = self.design
        return compute_design(
            self.brief(),
            self.asked(),
            starts=section.starts,
            climbs=section.climbs,
            steps=section.steps,
            inputs=self.inputs(),
            runner=runner or Runner(Store.default()),
        )

    def need_pitches(self) -> None:
        """Raise StudyError unless the pitch and something else may change, which `front` needs."""
        names = [one.parameter for one in self.design.vary]
        if "cell.pitch" not in names or len(names) < 2:
            raise StudyError(
                argument="design.vary",
                given=", ".join(names) or "nothing",
                allowed="cell.pitch and at least one other parameter",
                cause="the front shows the best margin of each pitch",
                next_step="let both vary, or leave --pareto out",
            )

    def front(self, best: Design, runner: Runner | None = None) -> xr.Dataset:
        """The widest margin against the pitch, between its bounds; ``best`` is from `designed`.

        Raises
        ------
        StudyError : the pitch does not change, or nothing else does
        """
        self.need_pitches()
        brief, count = self.brief(), self.design.pitches
        low, high = brief.bounds["cell.pitch"]
        pitches = [low + (high - low) * i / (count - 1) for i in range(count)]
        runner = runner or Runner(Store.default())
        return compute_front(brief, best.values, pitches, steps=self.design.steps, runner=runner)

    def toleranced(self, runner: Runner | None = None) -> Tolerance:
        """How sure the gap is to hold the carrier on plates that are not alike.

        Raises
        ------
        StudyError : no carrier, no spreads, or a gap that does not hold the carrier as drawn
        """
        section = self.tolerance
        if not section.of:
            raise StudyError(
                argument="tolerance.of",
                given="nothing",
                allowed="at least one [[tolerance.of]] table with parameter and spread",
                cause="the study does not say what differs",
                next_step='add [[tolerance.of]] with parameter = "cell.pillar.diameter", spread = "20 um"',
            )
        return compute_tolerance(
            self.unit_cell(),
            self.asked(),
            [one.frozen() for one in section.of],
            carrier=self.need_carrier(),
            margin=section.margin,
            confidence=section.confidence,
            pillars=section.pillars,
            count=section.samples,
            inputs=self.inputs(),
            runner=runner or Runner(Store.default()),
        )

    def tolerance_tasks(self) -> int:
        """How many tasks `toleranced` has."""
        return -(-self.tolerance.samples // BATCH) + 2

    def need_carrier(self) -> float:
        """The carrier, Hz; raises StudyError if the study does not give it."""
        if self.carrier is None:
            raise StudyError(
                argument="carrier",
                given="nothing",
                allowed="the frequency of the drive",
                cause="the study does not say which frequency the gap has to hold",
                next_step='add carrier = "60 kHz" at the top of the study',
            )
        return self.carrier
