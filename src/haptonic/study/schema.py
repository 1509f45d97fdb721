"""The study: everything that one run computes with, as it stands in the study file.

It is composed of values that declare their own fields, each in the package that computes with it. The keys of
the file, checks, help, labels and the written file follow from these declarations.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from types import FrameType
from typing import Annotated, Any, ClassVar, Self

from haptonic.bloch.settings import CARRIER, BandSettings, LayersSettings, WaveguideSettings
from haptonic.cell import UnitCell
from haptonic.design.settings import DesignSettings
from haptonic.design.tolerance import ToleranceSettings
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields import (
    Aliases,
    absent,
    caller,
    described,
    handed_on,
    meant,
    needed,
    numbers,
    problem,
    remade,
    setting,
    table,
    unchecked,
    unknown_number,
    unusual_values,
    warn_caller,
    with_numbers,
)
from haptonic.fields.keys import key_of
from haptonic.fields.reading import read, with_value
from haptonic.fields.writing import document, toml_of
from haptonic.friction.lubrication.settings import TouchSettings
from haptonic.friction.participants import Participants
from haptonic.materials import IsotropicMaterial, built_in_name
from haptonic.plate.parts import Plate
from haptonic.study.doubts import doubts_of
from haptonic.study.experiment_tables import ProtocolSettings
from haptonic.study.plate_tables import PlateSettings
from haptonic.study.plating import plate_of
from haptonic.study.ribbon_tables import RibbonSettings
from haptonic.study.sweeps import SweepSettings, numeric_parameters
from haptonic.study.trial_tables import TrialSettings
from haptonic.study.varied import check_varied
from haptonic.study.vary import Expression, check_names, solve
from haptonic.units import format_quantity
from haptonic.updating.settings import FitSettings
from haptonic.vibrometry.settings import ScanSettings

MOST_SWEEPS = 50
AFTERWARDS = {"touch", "trials", "protocol", "participants", "scan", "fit"}  # they decide no bands, no plate


@described("", kw_only=True)
class Description:
    """Everything that one run computes with; immutable. A `Study` also computes.

    It is read by `haptonic.study.load`, which gives its errors five parts and warns about unusual values.
    """

    aliases: ClassVar[Aliases] = {
        **meant("title", "name", "description"),
        **meant("carrier", "frequency", "f", "f0", "drive", "carrier_frequency", "target"),
        **meant("sweep", "sweeps", "parameters", "scan_parameters"),
        **meant("cell", "unit_cell", "unitcell", "lattice", "geometry",
                cause="lattice, pitch, thickness and pillar are keys of the cell",
                next_step="write them in [cell]"),
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

    title: str = setting("Study", "Heads the report.", min_length=1, max_length=200, strict=True)
    carrier: Annotated[float, CARRIER] | None = setting(
        None, "Frequency of the drive; marked in the diagrams."
    )
    cell: UnitCell = needed("One period of the plate.", title="Unit cell")
    bands_settings: BandSettings = setting(BandSettings(), "What the band diagram shows.", alias="bands")
    layers_settings: LayersSettings = setting(
        LayersSettings(), "Rows of cells as a mirror between two plates.", alias="layers"
    )
    waveguide_settings: WaveguideSettings = setting(
        WaveguideSettings(), "A strip of plate between two mirrors.", alias="waveguide"
    )
    design_settings: DesignSettings = setting(
        DesignSettings(), "What may change so that the gap holds the carrier.", alias="design"
    )
    tolerance_settings: ToleranceSettings = setting(
        ToleranceSettings(), "How much the parts differ.", alias="tolerance"
    )
    ribbon_settings: RibbonSettings | None = setting(
        None, "Columns of cells side by side, and the waves that run along them.", alias="ribbon"
    )
    finite_plate: PlateSettings | None = setting(
        None, "A finite one, made of cells and of plain plate.", alias="plate"
    )
    touch: TouchSettings = setting(TouchSettings(), "The finger that feels the plate.")
    trials: TrialSettings = setting(TrialSettings(), "How force records are processed, and which count.")
    protocol_settings: ProtocolSettings = setting(
        ProtocolSettings(), "Trials with people: how many, in which order.", alias="protocol"
    )
    participants: Participants = setting(Participants(), "What is assumed of people.")
    scan_settings: ScanSettings = setting(
        ScanSettings(), "How a laser vibrometer scans the plate.", alias="scan"
    )
    fit_settings: FitSettings = setting(FitSettings(), "Unknowns that a measurement determines.", alias="fit")
    sweep_settings: tuple[SweepSettings, ...] = setting(
        (), "Rows of designs to compare.", title="Sweeps", alias="sweep", max_length=MOST_SWEEPS
    )

    def __post_init__(self) -> None:
        try:
            plate = None if self.finite_plate is None else self.mounted_plate()
            if self.ribbon_settings is not None:
                self.ribbon_settings.ribbon(self.cell)
        except HaptonicError as error:
            raise handed_on(error) from None
        check_varied(
            self.design_settings,
            self.tolerance_settings,
            self.cell,
            self.absent_parameters(),
            table(Description),
        )
        self.fit_settings.check(plate, self.absent_parameters())
        for row, sweep in enumerate(self.sweep_settings, start=1):
            for axis, table_name in zip(sweep.axes, ("", "second."), strict=False):
                self._gives_what_is_named(axis.expression, f"sweep[{row}].{table_name}vary")
            for step, values in enumerate(sweep.designs, start=1):
                try:
                    self._design(sweep, values)
                except HaptonicError as error:
                    reached = " and ".join(
                        f"{axis.vary} = {format_quantity(value, axis.unit)}"
                        for axis, value in zip(sweep.axes, values, strict=True)
                    )
                    raise problem(
                        "out-of-range",
                        f"{reached} at step {step} of {sweep.count}",
                        f"a range in which every design is possible; {error.argument}: {error.allowed}",
                        f"{error.argument} would be {error.given}: {error.cause}",
                        "narrow the range between from and to",
                        at=f"sweep[{row}]",
                    ) from None

    def _gives_what_is_named(self, expression: Expression, at: str) -> None:
        """Refuse an expression that has no value for the study's own parameters."""
        try:
            check_names(expression, self.parameters(), self.absent_parameters())
            expression.value(self.parameters())
        except StudyError as error:
            raise handed_on(error, at) from None

    def mounted_plate(self) -> Plate:
        """The finite plate as the core computes with it.

        Raises
        ------
        StudyError : the study has no [plate]
        """
        return plate_of(self.finite_plate, self.cell)

    def within(self, budget: float | str | None, argument: str = "budget") -> Self:
        """The same study with another budget for the meshes of its cells; s, or a text such as "10 min".

        ``argument`` is how an error calls it.

        Raises
        ------
        StudyError : no time, or one that no budget can be
        """
        if budget is None:
            return self
        try:
            return unchecked(self, bands_settings=remade(self.bands_settings, budget=budget))
        except StudyError as error:
            raise error.changed(StudyError, argument=argument) from None

    def without_plate(self) -> Self:
        """The same study of the lattice alone."""
        return unchecked(self, finite_plate=None, ribbon_settings=None)

    def parameters(self) -> dict[str, float]:
        """Value of every numeric parameter that this study gives, by path and in SI units."""
        return dict(self._parameters)

    @cached_property
    def _parameters(self) -> dict[str, float]:
        known = numeric_parameters()  # a study with sweeps asks at every step
        return {path: value for path, value in numbers(self, names=True).items() if path in known}

    def absent_parameters(self) -> dict[str, str]:
        """Why a numeric parameter cannot be named in this study, by path."""
        built_in = "the material is a built-in one; give its constants in a [material] table to vary them"
        return {
            path: built_in if path.startswith("material.") else "this study does not give it"
            for path in numeric_parameters().keys() - self._parameters.keys()
        }

    def with_parameter(self, path: str, value: float) -> Self:
        """The same study with one numeric parameter changed; see `with_parameters`."""
        return self._with_parameters({path: value}, caller())

    def with_parameters(self, values: Mapping[str, float]) -> Self:
        """The same study with numeric parameters (SI, by path) changed and without sweeps: one design.

        Raises
        ------
        StudyError : an unknown name, a value that is out of bounds, or a design that is not possible
        """
        return self._with_parameters(values, caller())

    def _with_parameters(self, values: Mapping[str, float], frame: FrameType | None) -> Self:
        """See `with_parameters`; ``frame`` is that of its caller, who is warned."""
        known = self.parameters()
        for path in values:
            if path not in known:
                raise self._no_parameter(path, known)
        alone = unchecked(self, sweep_settings=(), fit_settings=FitSettings())
        made = alone._with_numbers(values)
        words = made._unusual_values() if values else {}
        warn_caller((f"{path}: {text}" for path, text in words.items() if path in values), frame)
        return made

    def _no_parameter(self, path: object, known: Mapping[str, float]) -> StudyError:
        """The error of a path that is no numeric parameter; other keys of a study are changed otherwise."""
        key = None if path in self.absent_parameters() else key_of(str(path), table(Description))
        if key is None:
            return unknown_number(path, known, self.absent_parameters())
        return StudyError.malformed(
            argument="name of a number",
            given=shown(path),
            allowed="a numeric parameter of the cell, the material or the carrier",
            cause=f"{path} is a key of the study and not one of its numeric parameters",
            next_step=f"write study.with_keys({{{str(path)!r}: ...}}), or change it in the study file",
        )

    def with_keys(self, changes: Mapping[str, Any]) -> Self:
        """The same study with keys of its file changed, and without sweeps: one design.

        ``study.with_keys({"cell.lattice": "triangular", "bands.count": 20, "cell.pitch": "8 mm"})``

        Parameters
        ----------
        changes : new values by key, ``cell.site[2].pillar.height``, as a file has them: quantities with their
            units, whole tables and lists too

        Raises
        ------
        StudyError : no such key, a value that it cannot have, or a study that cannot be written as a file
        """
        data = tomllib.loads(self._with_parameters({}, None).to_toml())
        for key, value in changes.items():
            data = with_value(data, key.replace("[", ".").replace("]", "").split("."), value)
        made = read(type(self), data, "study")
        warn_caller((f"{path}: {text}" for path, text in made._unusual_values().items()), caller())
        return made

    def with_fitted(self, values: Mapping[str, float]) -> Self:
        """The same study with numbers of [[fit.vary]] (SI, by their names there) changed.

        Raises
        ------
        StudyError : a value is out of bounds
        """
        return self._with_numbers(values)

    def _with_numbers(self, values: Mapping[str, float]) -> Self:
        try:
            return with_numbers(self, values)
        except HaptonicError as error:  # of the family of the value that a number belongs to
            raise error.changed(StudyError) from None

    def solved(self, expression: Expression, value: float) -> Self:
        """The study in which an expression has a value (SI): its first parameter changed, without sweeps and
        plate.

        Raises
        ------
        StudyError : unknown name, or a design that is not possible
        """
        wanted = solve(expression, value, self.parameters(), self.absent_parameters())
        return self.without_plate().with_parameter(expression.varied, wanted)

    def designs(self, sweep: SweepSettings) -> tuple[Self, ...]:
        """One study for each design of a sweep, in order."""
        return tuple(self._design(sweep, values) for values in sweep.designs)

    def _design(self, sweep: SweepSettings, values: Sequence[float]) -> Self:
        """The study in which the expressions of a sweep have these values."""
        design = self
        for axis in sweep.order:
            design = design.solved(sweep.axes[axis].expression, values[axis])
        return design

    def unusual(self) -> tuple[str, ...]:
        """A sentence on every value outside its typical range; on those that only a sweep reaches, if no
        other is, because a sweep starts from the given values."""
        found = tuple(f"{path}: {words}" for path, words in self._unusual_values().items())
        return found or tuple(self._unusual_sweeps())

    def _unusual_sweeps(self) -> Iterator[str]:
        for row, sweep in enumerate(self.sweep_settings, start=1):
            for axis in sweep.axes:
                ends = (self.solved(axis.expression, end) for end in (axis.start, axis.stop))
                words = [text for design in ends for text in design._unusual_values().values()]
                if words:
                    yield f"sweep[{row}]: {axis.expression.varied} leaves its usual range; {words[0]}"

    def _unusual_values(self) -> dict[str, str]:
        return unusual_values(self)

    def doubtful(self) -> dict[str, str]:
        """Words, by path, on values that are unusual for one another."""
        return doubts_of(self.carrier, self.cell, self.finite_plate)

    def to_toml(self) -> str:
        """A study file that loads to an equal study.

        Raises
        ------
        StudyError : a material, given in Python, that no file describes
        """
        glued = self.finite_plate.materials.values() if self.finite_plate else ()
        own = [solid for solid in self.cell.materials.values() if not isinstance(solid, IsotropicMaterial)]
        unwritten = [solid for solid in (*own, *glued) if built_in_name(solid) is None]
        if unwritten:
            raise StudyError.unsupported(
                argument="material",
                given=shown(unwritten[0].name),
                allowed="built-in materials; that of the cell may be isotropic",
                cause="a study file has no table for others",
                next_step="keep the study in Python",
            )
        return toml_of(self)

    def inputs(self) -> dict[str, Any]:
        """Plain values in SI units of all that decides a result, for provenance and as a key of results.

        The title and the sections that ask for something of such results decide nothing; a built-in
        material is given by its constants, so that a correction in the library changes the key.
        """
        data = document(self, lambda value, unit: value, absent=True)
        left = {"title"} | AFTERWARDS | ({"plate"} if self.finite_plate is None else set())
        left |= {"ribbon"} if self.ribbon_settings is None else set()
        data = {key: value for key, value in data.items() if key not in left}
        if self.finite_plate is not None:
            glued = self.finite_plate.materials.items()
            data["plate"]["materials"] = {name: solid.to_dict() for name, solid in glued}
        solids = {at: solid.to_dict() for at, solid in self.cell.materials.items()}
        data["material"] = solids.pop("material")
        if solids:
            data["cell"]["materials"] = solids
        return data
