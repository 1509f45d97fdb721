"""The study: a description that can be asked to compute."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import xarray as xr

from haptonic.bloch import Gap
from haptonic.bloch.mirrors import Incidence
from haptonic.design.brief import Brief
from haptonic.errors import StudyError
from haptonic.fields import extended, remade
from haptonic.materials import IsotropicMaterial
from haptonic.results import (
    Bands,
    Design,
    Guides,
    Layers,
    Row,
    Runner,
    Sweep,
    Tolerance,
    compute_bands,
    compute_design,
    compute_front,
    compute_guides,
    compute_layers,
    compute_sweeps,
    compute_tolerance,
)
from haptonic.results.common import stamped
from haptonic.results.layers import Question
from haptonic.results.tolerance import BATCH
from haptonic.store import Store
from haptonic.study.plate_runs import PlateStudy
from haptonic.units import format_quantity, shown

LOWEST, HIGHEST = 0.6, 1.4  # of the carrier: ends of a mirror's spectrum where the study gives none


@extended
class Study(PlateStudy):
    """What a study file describes, and all that can be computed from it.

    It is read by `haptonic.study.load`. Each method gives a result that holds all of the answer.
    """

    def need_sweeps(self) -> None:
        """Raise StudyError if the study has no sweep."""
        if not self.sweep_settings:
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
            self.cell,
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
                [design.cell for design in self.designs(sweep)],
                {
                    "expression": sweep.vary,
                    "units": sweep.unit,
                    "own_value": sweep.expression.value(self.parameters()),
                    "carrier_hz": self.carrier,
                },
            )
            for sweep in self.sweep_settings
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
        section, carrier = self.design_settings, self.need_carrier()
        if not section.vary:
            raise StudyError(
                argument="design.vary",
                given="nothing",
                allowed="at least one [[design.vary]] table with parameter, from and to",
                cause="the study does not say what may change",
                next_step='add [[design.vary]] with parameter = "cell.pillar.height", from and to',
            )
        if section.finger is not None and not isinstance(self.cell.material, IsotropicMaterial):
            raise StudyError(
                argument="design.finger_force",
                given=f"with {self.cell.material.name}",
                allowed="an isotropic material",
                cause="the formula for a plate under a finger knows no others",
                next_step="leave the finger out and bound cell.thickness instead",
            )
        return Brief(
            cell=self.cell,
            carrier=carrier,
            count=self.bands_settings.count,
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
        section = self.design_settings
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
        names = [one.parameter for one in self.design_settings.vary]
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
        brief, count = self.brief(), self.design_settings.pitches
        low, high = brief.bounds["cell.pitch"]
        pitches = [low + (high - low) * i / (count - 1) for i in range(count)]
        runner = runner or Runner(Store.default())
        front = compute_front(brief, best.values, pitches, steps=self.design_settings.steps, runner=runner)
        return stamped(front, self.inputs())

    def toleranced(self, runner: Runner | None = None) -> Tolerance:
        """How sure the gap is to hold the carrier on plates that are not alike.

        Raises
        ------
        StudyError : no carrier, no spreads, or a gap that does not hold the carrier as drawn
        """
        section = self.tolerance_settings
        if not section.of:
            raise StudyError(
                argument="tolerance.of",
                given="nothing",
                allowed="at least one [[tolerance.of]] table with parameter and spread",
                cause="the study does not say what differs",
                next_step='add [[tolerance.of]] with parameter = "cell.pillar.diameter", spread = "20 um"',
            )
        return compute_tolerance(
            self.cell,
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

    def layered(self, runner: Runner | None = None) -> Layers:
        """What rows of cells between two plain plates let through, and how waves fade in the lattice.

        Raises
        ------
        StudyError : no carrier, or no wave that propagates towards the rows
        """
        section, carrier = self.layers_settings, self.need_carrier()
        question = Question(
            lowest=section.lowest or LOWEST * carrier,
            highest=section.highest or HIGHEST * carrier,
            points=section.points,
            incidence=Incidence(section.angle, section.count, self.cell.material.loss_factor),
        )
        if question.lowest >= question.highest:
            raise StudyError(
                argument="layers.lowest",
                given=format_quantity(question.lowest, "Hz"),
                allowed=f"less than the highest frequency, {format_quantity(question.highest, 'Hz')}",
                cause="only one end of the spectrum was given, beyond the other's default",
                next_step="give both layers.lowest and layers.highest",
            )
        found: Layers = compute_layers(
            self.cell,
            self.asked(),
            question,
            carrier=carrier,
            inputs=self.inputs(),
            runner=runner or Runner(Store.default()),
        )
        return found

    def with_mode(self, mode: str) -> Study:
        """The same study with another mode of its waveguide, such as ``0x17``.

        Raises
        ------
        StudyError : the mode is not written like that
        """
        try:
            return remade(self, waveguide_settings=remade(self.waveguide_settings, mode=mode))
        except StudyError:
            raise StudyError(
                argument="--mode",
                given=shown(mode),
                allowed="nodal lines across, an x, and intervals between nodal lines along, such as 0x17",
                cause="it is not written like that",
                next_step="write it like 0x17",
            ) from None

    def guided(self, runner: Runner | None = None) -> Guides:
        """Waveguides between two mirrors, for the mode of the study's [waveguide].

        Raises
        ------
        StudyError : no carrier, no gap around it, or no such waveguide
        """
        section = self.waveguide_settings
        found: Guides = compute_guides(
            self.cell,
            self.asked(),
            carrier=self.need_carrier(),
            mode=section.nodal_lines,
            width=section.width,
            rows=section.rows,
            ends=section.ends,
            runner=runner or Runner(Store.default()),
        )
        return found

    def gap_with(self, values: Mapping[str, float], runner: Runner | None = None) -> Gap | None:
        """The widest complete gap with some parameters (SI, by path) changed."""
        found = (runner or Runner(Store.default())).gaps(self.cell.with_numbers(values), self.asked())
        return max((gap for gap in found if gap.complete), key=lambda gap: gap.width, default=None)

    def tolerance_tasks(self) -> int:
        """How many tasks `toleranced` has."""
        return -(-self.tolerance_settings.samples // BATCH) + 2
