"""What can be computed of a study's finite plate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from haptonic.bloch import Gap
from haptonic.errors import StudyError
from haptonic.fields import extended
from haptonic.friction.lubrication import Touch
from haptonic.plate import Fineness, Plate
from haptonic.plate.parts import Actuator
from haptonic.plate.sweep import check_cost
from haptonic.results import Feel, Pad, PlateQuestion, PlateResult, Runner, compute_loaded, compute_plate
from haptonic.results.carrier import gap_around
from haptonic.results.feel.loading import LOADS, highest
from haptonic.results.plate.question import amplitude_of, check_grid, drives_of, reference_of
from haptonic.store import Store
from haptonic.study.plate_tables import ResponseSection
from haptonic.study.schema import Description
from haptonic.study.touch_tables import VOLTAGE
from haptonic.units import format_quantity

Told = Callable[[int, int, bool], None]


def _silent(done: int, planned: int, stored: bool) -> None:
    """Tell nobody."""


@extended
class PlateStudy(Description):
    """A description that can be asked how its plate vibrates, and what a finger feels of that."""

    def fineness(self) -> Fineness | None:
        """Of the finite plate's mesh, if [mesh] says one."""
        order, rings = self.mesh.order, self.mesh.foot_rings
        if order is None:
            return None
        usual = Fineness()
        rings = usual.rings if rings is None else rings
        return Fineness(min(order, usual.along), usual.through, cell=order, rings=rings, plain=order)

    def vibrating(
        self,
        *,
        at: float | None = None,
        asked: PlateQuestion | None = None,
        store: Store | None = None,
        on_progress: Told = _silent,
    ) -> PlateResult:
        """How the finite plate answers its drives over the band of [plate.response].

        Parameters
        ----------
        at : a single frequency instead, Hz; the gap is then not looked for
        asked : other lines and points than those of [plate.response]

        Raises
        ------
        StudyError : no [plate], no carrier, or nothing that drives the plate
        ResourceError : a grid or a plate that this machine cannot hold, found before anything is computed
        """
        plate, own = self.mounted_plate(), self._response
        carrier = self.need_carrier() if at is None else at
        question = asked or PlateQuestion(own.lowest, own.highest, own.points, own.tolerance, own.grid)
        if at is not None:
            question = replace(question, lowest=at, highest=at, points=1)
        check_cost(plate, question.highest, single=at is not None)
        check_grid(
            plate, question.grid, question.points, "plate.response.grid" if asked is None else "scan.grid"
        )
        store = store or Store.default()
        return compute_plate(
            plate,
            question,
            carrier=carrier,
            gap=self._gap(plate, carrier, store) if at is None else None,
            inputs=self.inputs(),
            store=store,
            fineness=self.fineness(),
            told=on_progress,
        )

    def felt(
        self,
        *,
        at: float | None = None,
        voltage: float | None = None,
        store: Store | None = None,
        on_progress: Told = _silent,
    ) -> Feel:
        """What a finger feels of the plate: friction wherever it lies, by the study's [touch].

        Parameters
        ----------
        at : Hz; else the resonance of the driven region that is loudest near the carrier
        voltage : of the first actuator, V; else that of [touch], or else the plate's

        Raises
        ------
        StudyError : no [plate], no carrier, nothing that drives the plate, or a voltage for a force
        ResourceError : a grid or a plate that this machine cannot hold, found before anything is computed
        """
        plate, carrier, store = self.mounted_plate(), self.need_carrier(), store or Store.default()
        drive = _drive(plate, self.touch.voltage if voltage is None else voltage)
        touch = Touch(carrier if at is None else at, self.touch.force, self.touch.speed)
        check_cost(plate, highest(carrier if at is None else at))
        check_grid(plate, self._response.grid, len(LOADS))
        gap = self._gap(plate, carrier, store)
        loaded = compute_loaded(
            plate,
            Pad(self.touch.diameter, self.touch.damping),
            carrier=carrier,
            at=at,
            gap=gap,
            grid=self._response.grid,
            tolerance=self._response.tolerance,
            inputs=self.inputs(),
            store=store,
            fineness=self.fineness(),
            told=on_progress,
        )
        touch = replace(touch, frequency=loaded.attrs["frequency_hz"])
        edges = (gap.lower, gap.upper) if gap else None
        return Feel(plate, edges, loaded, self.touch.diameter, touch, self.touch.finger(), drive)

    @property
    def _response(self) -> ResponseSection:
        assert self.finite_plate is not None
        return self.finite_plate.response

    def _gap(self, plate: Plate, carrier: float, store: Store) -> Gap | None:
        """The gap of the plate's lattice that holds the carrier."""
        cells = list(plate.layout.cells.values())
        gap = gap_around(cells[0], self.asked(), carrier, Runner(store)) if cells else None
        return gap if gap is not None and gap.lower < carrier < gap.upper else None

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


def _drive(plate: Plate, voltage: float | None) -> float:
    """Amplitude of the first drive, V or N: the voltage given, or else the plate's own."""
    _, own = reference_of(plate)
    if voltage is None:
        return own
    if not VOLTAGE.holds(voltage):
        raise StudyError(
            argument="voltage",
            given=format_quantity(voltage, "V"),
            allowed=VOLTAGE.allowed,
            cause="it is zero or negative, or its unit slipped",
            next_step='give the amplitude, such as "200 V"',
        )
    first = next(drive for drive in drives_of(plate) if amplitude_of(drive))
    if not isinstance(first, Actuator):
        raise StudyError(
            argument="voltage",
            given=format_quantity(voltage, "V"),
            allowed="nothing, because a force drives the plate",
            cause="the first drive of the plate is no actuator",
            next_step="change the force of [[plate.force]] instead, or leave the voltage out",
        )
    return voltage
