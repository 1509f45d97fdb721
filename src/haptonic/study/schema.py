"""Data model of a study: all inputs of a run, as in the study file.

It is composed of values that declare their own fields, each in the package that uses them. The keys of the
file, checks, help, labels and the written file follow from these declarations.
"""

from __future__ import annotations

import tomllib
from collections.abc import Container, Iterator, Mapping, Sequence
from functools import cached_property
from types import FrameType
from typing import Annotated, Any, ClassVar, Self

from pydantic import field_validator

from haptonic.bloch.settings import BandSettings, LayersSettings, WaveguideSettings
from haptonic.cell import UnitCell
from haptonic.design.discs import for_given_end
from haptonic.design.settings import DesignSettings
from haptonic.design.tolerance import ToleranceSettings
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields import (
    CARRIER,
    PARAMETERS,
    Aliases,
    AnyUnit,
    Entries,
    ExpressedNumber,
    absent,
    caller,
    described,
    handed_on,
    meant,
    needed,
    numbers,
    remade,
    setting,
    table,
    unchecked,
    unknown_number,
    unusual_values,
    warn_caller,
    with_known_table,
    with_numbers,
)
from haptonic.fields.expressions import NAMED, check_names
from haptonic.fields.keys import key_of
from haptonic.fields.reading import read, with_values
from haptonic.fields.writing import document, toml_of
from haptonic.friction.lubrication.settings import TouchSettings
from haptonic.friction.participants import Participants
from haptonic.materials import PiezoelectricMaterial, built_in_name
from haptonic.plate.layout.parts import Plate
from haptonic.study.doubts import doubts_of
from haptonic.study.experiment_tables import ProtocolSettings
from haptonic.study.named import varied_expressions, with_dependents
from haptonic.study.plate_tables import PlateSettings
from haptonic.study.plating import check_carriers, plate_of
from haptonic.study.ribbon_tables import RibbonSettings
from haptonic.study.sweeps import SweepSettings, can_vary, numeric_parameters
from haptonic.study.trial_tables import TrialSettings
from haptonic.study.varied import check_reached, check_sweeps, check_varied
from haptonic.study.vary import Expression, solve
from haptonic.updating.settings import FitSettings
from haptonic.vibrometry.settings import ScanSettings

MOST_SWEEPS = 50
AFTERWARDS = {"touch", "trials", "protocol", "participants", "scan", "fit"}  # do not change bands or plate


@described("", kw_only=True)
class Description:
    """All inputs of a run; immutable. A `Study` also has methods that compute.

    `haptonic.study.load` reads it, reports errors in five parts and warns about unusual values.
    """

    aliases: ClassVar[Aliases] = {
        **meant("title", "name", "description"),
        **meant("carrier", "frequency", "f", "f0", "drive", "carrier_frequency", "target"),
        **meant("sweep", "sweeps", "scan_parameters"),
        **meant("cell", "unit_cell", "unitcell", "lattice", "geometry",
                cause="lattice, pitch, thickness and pillar are keys of the cell",
                next_step="write them in [cell]"),
        **meant("parameters", "variables", "constants", "definitions"),
        **absent(
            "e", "nu", "rho", cause="constants of a material belong to the table [material]",
            next_step="write youngs_modulus, poisson_ratio and density in [material]",
        ),
        **absent(
            "period", "lattice_constant", cause="the period is the pitch of the cell",
            next_step="write pitch in [cell]",
        ),
        **absent(
            "radius", "width", cause="sizes belong to the cell and its pillar",
            next_step="write pitch and thickness in [cell], diameter and height in [cell.pillar]",
        ),
    }  # fmt: skip

    title: str = setting("Study", "Heading of the report.", min_length=1, max_length=200, strict=True)
    named_parameters: Entries[Annotated[ExpressedNumber, AnyUnit()]] = setting(
        Entries(), 'Numbers with names, for expressions such as "a/2" in place of numbers.',
        title="Named numbers", alias=PARAMETERS, examples=["7 mm"],
    )  # fmt: skip
    carrier: Annotated[float, CARRIER] | None = setting(
        None, "Frequency of the drive; marked in the diagrams."
    )
    cell: UnitCell = needed("One period of the plate.", title="Unit cell")
    bands_settings: BandSettings = setting(BandSettings(), "Contents of the band diagram.", alias="bands")
    layers_settings: LayersSettings = setting(
        LayersSettings(), "Rows of cells as a mirror between two plates.", alias="layers"
    )
    waveguide_settings: WaveguideSettings = setting(
        WaveguideSettings(), "A strip of plate between two mirrors.", alias="waveguide"
    )
    design_settings: DesignSettings = setting(
        DesignSettings(), "Parameters that a design search may change, and limits.", alias="design"
    )
    tolerance_settings: ToleranceSettings = setting(
        ToleranceSettings(), "Manufacturing spreads of the parts.", alias="tolerance"
    )
    ribbon_settings: RibbonSettings | None = setting(
        None, "Columns of cells side by side, and the waves that run along them.", alias="ribbon"
    )
    plate_settings: PlateSettings | None = setting(
        None, "Finite plate of cells and of plain plate.", alias="plate"
    )
    touch: TouchSettings = setting(TouchSettings(), "Finger that touches the plate.")
    trials: TrialSettings = setting(TrialSettings(), "Evaluation of force records, and exclusions.")
    protocol_settings: ProtocolSettings = setting(
        ProtocolSettings(), "Trials with people: their number and order.", alias="protocol"
    )
    participants: Participants = setting(Participants(), "Assumptions on the participants.")
    scan_settings: ScanSettings = setting(
        ScanSettings(), "Scan of the plate with a laser vibrometer.", alias="scan"
    )
    fit_settings: FitSettings = setting(FitSettings(), "Unknowns that a measurement determines.", alias="fit")
    sweep_settings: tuple[SweepSettings, ...] = setting(
        (), "Sweeps of designs to compare.", title="Sweeps", alias="sweep", max_length=MOST_SWEEPS
    )

    def __post_init__(self) -> None:
        try:
            plate = None if self.plate_settings is None else self.mounted_plate()
            if plate is not None:
                check_carriers(plate, self.carrier)
            if self.ribbon_settings is not None:
                self.ribbon_settings.ribbon(self.cell)
        except HaptonicError as error:
            raise handed_on(error) from None
        check_varied(self, table(Description))
        if self.fit_settings.vary:
            self.fit_settings.check(plate, self.absent_parameters())
        check_sweeps(self)

    @field_validator("named_parameters")
    @classmethod
    def _has_names(cls, named: Entries[ExpressedNumber]) -> Entries[ExpressedNumber]:
        try:
            check_names(named)
        except StudyError as error:
            raise handed_on(error) from None
        return named

    def mounted_plate(self, carrier: float | None = None) -> Plate:
        """Build the finite plate of the study, with the drives of one carrier.

        carrier : Hz, by default the study's; drives with another one of their own have no amplitude

        Raises
        ------
        StudyError : the study has no [plate]
        """
        plate = plate_of(self.plate_settings, self.cell)
        if self.carrier is None:
            return plate
        return plate.driven_at(self.carrier if carrier is None else carrier, self.carrier)

    @property
    def carriers(self) -> tuple[float, ...]:
        """Different carriers of the plate's drives, Hz, the study's first; without a plate only that one."""
        if self.carrier is None:
            return ()
        if self.plate_settings is None:
            return (self.carrier,)
        others = plate_of(self.plate_settings, self.cell).carriers(self.carrier)
        return tuple(dict.fromkeys((self.carrier, *others)))

    def within(self, budget: float | str | None, argument: str = "budget") -> Self:
        """The study with another budget for the meshes of its cells; s, or a text such as "10 min".

        ``argument`` is the name of the budget in errors.

        Raises
        ------
        StudyError : not a time, or a time outside the limits of a budget
        """
        if budget is None:
            return self
        try:
            return unchecked(self, bands_settings=remade(self.bands_settings, budget=budget))
        except StudyError as error:
            raise error.changed(StudyError, argument=argument) from None

    def without_plate(self) -> Self:
        """The study of the lattice alone."""
        if self.plate_settings is None and self.ribbon_settings is None:
            return self
        return unchecked(self, plate_settings=None, ribbon_settings=None)

    def parameters(self) -> dict[str, float]:
        """Values (SI) of all numeric parameters by path, those of built-in materials among them."""
        return dict(self._parameters)

    @cached_property
    def _parameters(self) -> dict[str, float]:
        every = numbers(self).items()  # a study with sweeps needs the values at every step
        return {path: value for path, value in every if path.startswith(NAMED) or can_vary(path, self.cell)}

    def units(self) -> dict[str, str]:
        """SI units of the `parameters`, by path."""
        of_named = {f"{NAMED}{name}": value.unit for name, value in self.named_parameters.items()}
        allowed = numeric_parameters()
        return {path: of_named[path] if path in of_named else allowed[path] for path in self._parameters}

    def absent_parameters(self) -> dict[str, str]:
        """Reason why a numeric parameter has no value in this study, by path."""
        absent = "this study does not give it"
        if self.cell.solid is not None:
            absent += ", or the file of the cell does"
        return dict.fromkeys(numeric_parameters().keys() - self._parameters.keys(), absent)

    def with_parameter(self, path: str, value: float) -> Self:
        """The study with one changed numeric parameter; see `with_parameters`."""
        return self._with_parameters({path: value}, caller())

    def with_parameters(self, values: Mapping[str, float]) -> Self:
        """The study with changed numeric parameters (SI, by path) and without sweeps: one design.

        Raises
        ------
        StudyError : an unknown name, a value out of bounds, or an impossible design
        """
        return self._with_parameters(values, caller())

    def _with_parameters(self, values: Mapping[str, float], frame: FrameType | None) -> Self:
        """See `with_parameters`; ``frame`` is the frame of the caller that gets the warnings."""
        parameters = self.parameters()
        for path in values:
            if path not in parameters:
                raise self._no_parameter(path, parameters)
        alone = unchecked(self, sweep_settings=(), fit_settings=FitSettings())
        changed = alone._with_numbers(values)
        warn_caller(changed._slips(values), frame)
        return changed

    def _no_parameter(self, path: object, parameters: Mapping[str, float]) -> StudyError:
        """Error for a path that is not a numeric parameter; for other keys with the way to change them."""
        absent, name = self.absent_parameters(), str(path)
        is_unknown = name.startswith(NAMED) or path in absent or with_known_table(name, parameters)
        key = None if is_unknown else key_of(name, table(Description))
        if key is None:
            return unknown_number(path, parameters, absent)
        return StudyError.malformed(
            argument="name of a number",
            given=shown(path),
            allowed="a numeric parameter of the cell, the material or the carrier",
            cause=f"{path} is a key of the study and not one of its numeric parameters",
            next_step=f"write study.with_keys({{{str(path)!r}: ...}}), or change it in the study file",
        )

    def with_keys(self, changes: Mapping[str, Any]) -> Self:
        """The study with changed keys of its file; without sweeps, unless one of the keys belongs to a sweep.

        ``study.with_keys({"cell.lattice": "triangular", "bands.count": 20, "cell.pitch": "8 mm"})``

        Parameters
        ----------
        changes : new values by key, ``cell.site[2].pillar.height``, as in a file: quantities with their
            units, also whole tables and lists

        Raises
        ------
        StudyError : an unknown key, a value that is not allowed, or a study that cannot be written as a file
        """
        of_sweeps = isinstance(changes, Mapping) and any(str(key).startswith("sweep") for key in changes)
        kept = self if of_sweeps else self._with_parameters({}, None)
        tables = tomllib.loads(kept.to_toml())
        changed = read(type(self), with_values(tables, changes), "study")
        warn_caller(changed._slips(), caller())
        return changed

    def with_fitted(self, values: Mapping[str, float]) -> Self:
        """The study with changed numbers of [[fit.vary]] (SI, by their names in this table).

        Raises
        ------
        StudyError : a value is out of bounds
        """
        return self._with_numbers(values)

    def _with_numbers(self, values: Mapping[str, float]) -> Self:
        try:
            return with_numbers(self, with_dependents(self, values))
        except HaptonicError as error:  # the class of error depends on the owner of the number
            raise for_given_end(self.cell, values, error).changed(StudyError) from None

    def solved(self, expression: Expression, value: float) -> Self:
        """The study in which an expression has a value (SI) by its first parameter, without sweeps and plate.

        Raises
        ------
        StudyError : an unknown name, or an impossible design
        """
        wanted = solve(expression, value, self.parameters(), self.absent_parameters())
        return self.without_plate().with_parameter(expression.varied, wanted)

    def designs(self, sweep: SweepSettings) -> tuple[Self, ...]:
        """One study for each design of a sweep, in order."""
        lattice = self.without_plate()
        return tuple(lattice._design(sweep, values) for values in sweep.designs)

    def _design(self, sweep: SweepSettings, values: Sequence[float]) -> Self:
        """The study in which the expressions of a sweep have these values."""
        design, wanted = self, dict[str, float]()
        for axis in sweep.order:
            varied = sweep.axes[axis].expression
            wanted[varied.varied] = solve(varied, values[axis], design.parameters(), self.absent_parameters())
            design = self.with_parameters(wanted)
        check_reached(sweep, values, design.parameters())
        return design

    def unusual(self) -> tuple[str, ...]:
        """Remarks on values outside their typical range; without any, on those that only a sweep reaches."""
        return tuple(self._slips()) or tuple(self._unusual_sweeps())

    def _unusual_sweeps(self) -> Iterator[str]:
        for row, sweep in enumerate(self.sweep_settings, start=1):
            for axis in sweep.axes:
                ends = (self.solved(axis.expression, end) for end in (axis.start, axis.stop))
                words = [text for design in ends for text in design._unusual_values().values()]
                if words:
                    yield f"sweep[{row}]: {axis.expression.varied} leaves its usual range; {words[0]}"

    def _unusual_values(self) -> dict[str, str]:
        return unusual_values(self)

    def _slips(self, changed: Container[str] | None = None) -> Iterator[str]:
        """Remarks on changed numbers, by default on all; only a warning computes them."""
        for path, text in self._unusual_values().items():
            if changed is None or path in changed:
                yield f"{path}: {text}"

    def doubtful(self) -> dict[str, str]:
        """Remarks, by path, on values that are unusual relative to one another."""
        return doubts_of(self.carrier, self.cell, self.plate_settings)

    def to_toml(self) -> str:
        """Text of a study file that loads to an equal study.

        Raises
        ------
        StudyError : a material, given in Python, that cannot be written to a file
        """
        plate = self.plate_settings.materials if self.plate_settings else {}
        bonds = [solid for at, solid in plate.items() if at.endswith("bond.material")]
        for solid in (*self.cell.materials.values(), *bonds):
            if isinstance(solid, PiezoelectricMaterial) and built_in_name(solid) is None:
                raise StudyError.unsupported(
                    argument="material",
                    given=shown(solid.name),
                    allowed="a built-in material, or a table of elastic constants",
                    cause="only the material of a patch may be a table of piezoelectric constants",
                    next_step="keep the study in Python",
                )
        return toml_of(self)

    def inputs(self) -> dict[str, Any]:
        """Plain values in SI units of all inputs of a result, for provenance and as a key of results.

        The title and sections that do not change bands and plate are left out. A built-in material is given
        by its constants, so that a correction in the library changes the key.
        """
        data = document(self, lambda value, unit: value, absent=True)
        left = {"title", PARAMETERS} | AFTERWARDS | ({"plate"} if self.plate_settings is None else set())
        left |= {"ribbon"} if self.ribbon_settings is None else set()
        data = {key: value for key, value in data.items() if key not in left}
        if self.plate_settings is not None:
            glued = self.plate_settings.materials.items()
            data["plate"]["materials"] = {name: solid.to_dict() for name, solid in glued}
        solids = {at: solid.to_dict() for at, solid in self.cell.materials.items()}
        data["material"] = solids.pop("material")
        if solids:
            data["cell"]["materials"] = solids
        if dependents := varied_expressions(self):
            data["expressions"] = dependents
        return data
