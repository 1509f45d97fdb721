"""The study: everything that one run computes with, as it stands in the study file.

Together with `haptonic.study.sections` this is the single declaration of its keys. Checks, help, report
labels and the written file follow from it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Self

from pydantic import (
    AfterValidator,
    Discriminator,
    Field,
    Tag,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_validator,
)

from haptonic.bloch.resolution import LADDER, Resolution, starting_rung
from haptonic.cell import UnitCell
from haptonic.design.parameters import values_of
from haptonic.errors import HaptonicError, StudyError
from haptonic.fields import Quantity, Section, leaves, number_of, problem, table
from haptonic.fields.problems import refusal
from haptonic.fields.quantity import collected
from haptonic.fields.writing import toml_of
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, Material, material
from haptonic.plate.parts import Plate
from haptonic.results import Asked
from haptonic.study.asking import DesignSection, LayersSection, ToleranceSection, WaveguideSection
from haptonic.study.experiment_tables import ParticipantsSection, ProtocolSection
from haptonic.study.fitting import FitSection
from haptonic.study.plate_tables import PlateSection
from haptonic.study.plating import built_in, plate_of
from haptonic.study.scan_tables import ScanSection
from haptonic.study.sections import BandsSection, CellSection, MeshSection
from haptonic.study.touch_tables import TouchSection
from haptonic.study.trial_tables import Trials
from haptonic.study.vary import Expression, check_names, parse, solve
from haptonic.units import format_quantity

MOST_SWEEPS = 50
AFTERWARDS = {
    "touch",
    "trials",
    "protocol_settings",
    "participants",
    "scan_settings",
    "fit_settings",
}  # they decide no bands, no plate
OF_A_CELL = {"carrier", "material", "cell", "bands"}  # sections whose numbers an expression can name


class SweepSection(Section):
    """A row of designs: an expression of parameters taken from one value to another."""

    vary: str = Field(title="Expression", description="The first parameter in it changes.", strict=True)
    start: float = Field(alias="from", title="First value", description="With its unit, if it has one.")
    stop: float = Field(alias="to", title="Last value", description="With its unit, if it has one.")
    steps: Annotated[int, Field(ge=2, le=1000, strict=True)] = Field(
        25, title="Steps", description="Number of designs, both ends included."
    )

    @field_validator("vary")
    @classmethod
    def _names_parameters(cls, text: str) -> str:
        with collected():
            check_names(parse(text), numeric_parameters(), {})
        return text

    @field_validator("start", "stop", mode="plain")
    @classmethod
    def _has_dimension(cls, value: object, info: ValidationInfo) -> float:
        if "vary" not in info.data:  # refused already; without it the dimension is not known
            return 0.0
        return number_of(value, parse(info.data["vary"]).unit(numeric_parameters()), info.context)

    @model_validator(mode="after")
    def _moves(self) -> SweepSection:
        if self.start == self.stop:
            raise problem(
                format_quantity(self.stop, self.unit),
                "a last value that differs from the first",
                "all designs would be the same",
                "change one end of the sweep, or remove it",
                at="to",
            )
        return self

    @property
    def expression(self) -> Expression:
        return parse(self.vary)

    @property
    def unit(self) -> str:
        """SI unit of ``start``, ``stop`` and ``values``; empty when they are dimensionless."""
        return self.expression.unit(numeric_parameters())

    @property
    def values(self) -> tuple[float, ...]:
        """Value of the expression at every step, in SI units, both ends included."""
        last = self.steps - 1
        inner = ((self.start * (last - step) + self.stop * step) / last for step in range(1, last))
        return (self.start, *inner, self.stop)


def _material_kind(value: object) -> str | None:
    if isinstance(value, str):
        return "name"
    return "table" if isinstance(value, Mapping | IsotropicMaterial) else None


def _in_library(name: str) -> str:
    with collected():
        material(name)
    return name


class Description(Section):
    """Everything that one run computes with; immutable. A `Study` also computes.

    It is read by `haptonic.study.load`, which gives its errors five parts and warns about unusual values.
    """

    title: str = Field(
        "Study", title="Title", description="Heads the report.", min_length=1, max_length=200, strict=True
    )
    carrier: Annotated[float, Quantity("Hz", at_least=1.0, at_most=1e9, typical=(10e3, 1e6))] | None = Field(
        None, title="Carrier", description="Frequency of the drive; marked in the diagrams."
    )
    material: Annotated[
        Annotated[str, AfterValidator(_in_library), Tag("name")] | Annotated[IsotropicMaterial, Tag("table")],
        Discriminator(_material_kind),
    ] = Field(title="Material", description="Of the plate and its pillars: a built-in name or its constants.")
    cell: CellSection = Field(title="Unit cell", description="One period of the plate.")
    bands_settings: BandsSection = Field(
        BandsSection(), alias="bands", title="Bands", description="What the band diagram shows."
    )
    mesh: MeshSection = Field(
        MeshSection(), title="Mesh", description="For experts; else the accuracy decides."
    )
    layers_settings: LayersSection = Field(
        LayersSection(),
        alias="layers",
        title="Layers",
        description="Rows of cells as a mirror between two plates.",
    )
    waveguide_settings: WaveguideSection = Field(
        WaveguideSection(),
        alias="waveguide",
        title="Waveguide",
        description="A strip of plate between two mirrors.",
    )
    design_settings: DesignSection = Field(
        DesignSection(),
        alias="design",
        title="Design",
        description="What may change so that the gap holds the carrier.",
    )
    tolerance_settings: ToleranceSection = Field(
        ToleranceSection(), alias="tolerance", title="Tolerance", description="How much the parts differ."
    )
    finite_plate: PlateSection | None = Field(
        None, alias="plate", title="Plate", description="A finite one, made of cells and of plain plate."
    )
    touch: TouchSection = Field(TouchSection(), title="Touch", description="The finger that feels the plate.")
    trials: Trials = Field(
        Trials(), title="Trials", description="How force records are processed, and which count."
    )
    protocol_settings: ProtocolSection = Field(
        ProtocolSection(),
        alias="protocol",
        title="Protocol",
        description="Trials with people: how many, in which order.",
    )
    participants: ParticipantsSection = Field(
        ParticipantsSection(), title="Participants", description="What is assumed of people."
    )
    scan_settings: ScanSection = Field(
        ScanSection(), alias="scan", title="Scan", description="How a laser vibrometer scans the plate."
    )
    fit_settings: FitSection = Field(
        FitSection(), alias="fit", title="Fit", description="What a measurement of the plate tells."
    )
    sweep_settings: tuple[SweepSection, ...] = Field(
        (), alias="sweep", title="Sweeps", description="Rows of designs to compare.", max_length=MOST_SWEEPS
    )

    @model_validator(mode="after")
    def _every_design_is_possible(self) -> Self:
        try:
            self.unit_cell()
            plate = None if self.finite_plate is None else self.mounted_plate()
        except HaptonicError as error:
            raise problem(
                error.given, error.allowed, error.cause, error.next_step, at=error.argument
            ) from None
        self._names_what_the_cell_has()
        self.fit_settings.check(plate, self.absent_parameters())
        for row, sweep in enumerate(self.sweep_settings, start=1):
            self._gives_what_is_named(sweep.expression, f"sweep[{row}].vary")
            for step, value in enumerate(sweep.values, start=1):
                try:
                    solve(sweep.expression, value, self)
                except HaptonicError as error:
                    reached = format_quantity(value, sweep.unit)
                    raise problem(
                        f"{sweep.vary} = {reached} at step {step} of {sweep.steps}",
                        f"a range in which every design is possible; {error.argument}: {error.allowed}",
                        f"{error.argument} would be {error.given}: {error.cause}",
                        "narrow the range between from and to",
                        at=f"sweep[{row}]",
                    ) from None
        return self

    def _gives_what_is_named(self, expression: Expression, at: str) -> None:
        """Refuse an expression that has no value for the study's own parameters."""
        try:
            check_names(expression, self.parameters(), self.absent_parameters())
            expression.value(self.parameters())
        except StudyError as error:
            raise problem(error.given, error.allowed, error.cause, error.next_step, at=at) from None

    def _names_what_the_cell_has(self) -> None:
        """Refuse parameters of a design or a tolerance that this study's cell does not have, and designs that
        could not be written as a study."""
        there = values_of(self.unit_cell())
        named = {
            f"design.vary[{i}]": one.parameter for i, one in enumerate(self.design_settings.vary, start=1)
        }
        named |= {
            f"tolerance.of[{i}]": one.parameter for i, one in enumerate(self.tolerance_settings.of, start=1)
        }
        for at, path in named.items():
            if path not in there:
                raise problem(
                    path,
                    f"one of {', '.join(there)}",
                    "the cell of this study does not have it",
                    "give it in [cell] first, or leave this table out",
                    at=f"{at}.parameter",
                )
        absent, keys = self.absent_parameters(), table(Description)
        for i, one in enumerate(self.design_settings.vary, start=1):
            at, path = f"design.vary[{i}]", one.parameter
            if path in absent:
                raise problem(
                    path, "a parameter that this study gives", absent[path],
                    "give it in this study, or leave this table out", at=f"{at}.parameter",
                )  # fmt: skip
            quantity = keys[path].quantity
            assert quantity is not None, path
            for name, value in (("from", one.start), ("to", one.stop)):
                if not quantity.holds(value):
                    raise problem(
                        format_quantity(value, one.unit), f"{path} has to be {quantity.limits}",
                        "designs there would not be possible", "choose a narrower range", at=f"{at}.{name}",
                    )  # fmt: skip

    def resolved_material(self) -> Material:
        """The material as the core computes with it."""
        return material(self.material) if isinstance(self.material, str) else self.material

    def unit_cell(self) -> UnitCell:
        """The unit cell as the core computes with it, in SI units."""
        cell = self.cell
        lattice = (
            Lattice.rectangular(cell.pitch, cell.pitch_y) if cell.pitch_y else Lattice.square(cell.pitch)
        )
        return UnitCell(lattice, cell.thickness, self.resolved_material(), cell.pillar)

    def mounted_plate(self) -> Plate:
        """The finite plate as the core computes with it.

        Raises
        ------
        StudyError : the study has no [plate]
        """
        return plate_of(self)

    def without_plate(self) -> Self:
        """The same study of the lattice alone."""
        return self.model_copy(update={"finite_plate": None})

    def asked(self) -> Asked:
        """What is asked of the bands."""
        bands, mesh = self.bands_settings, self.mesh
        resolution = None
        if mesh.order is not None or mesh.foot_rings is not None:
            rung = LADDER[starting_rung(bands.accuracy)]
            order = rung.order if mesh.order is None else mesh.order
            rings = rung.foot_rings if mesh.foot_rings is None else mesh.foot_rings
            resolution = Resolution(order, rings, rung.steps, rung.block)
        return Asked(bands.count, bands.points, bands.accuracy, resolution)

    def parameters(self) -> dict[str, float]:
        """Value of every numeric parameter that this study gives, by path and in SI units."""
        known = numeric_parameters()
        return {path: value for path, value, _ in leaves(self, only=OF_A_CELL) if path in known}

    def absent_parameters(self) -> dict[str, str]:
        """Why a numeric parameter cannot be named in this study, by path."""
        built_in = "the material is a built-in one; give its constants in a [material] table to vary them"
        return {
            path: built_in if path.startswith("material.") else "this study does not give it"
            for path in numeric_parameters().keys() - self.parameters().keys()
        }

    def with_parameter(self, path: str, value: float) -> Self:
        """The same study with one numeric parameter changed; see `with_parameters`."""
        return self.with_parameters({path: value})

    def with_parameters(self, values: Mapping[str, float]) -> Self:
        """The same study with numeric parameters (SI, by path) changed and without sweeps: one design.

        Raises
        ------
        StudyError : a value is out of bounds, or the design is not possible
        """
        assert values.keys() <= self.parameters().keys(), values.keys()
        return self._with_numbers(values, {"sweep_settings", "fit_settings"})

    def with_fitted(self, values: Mapping[str, float]) -> Self:
        """The same study with numbers of [[fit.vary]] (SI, by their names there) changed.

        Raises
        ------
        StudyError : a value is out of bounds
        """
        return self._with_numbers(values, set())

    def _with_numbers(self, values: Mapping[str, float], without: set[str]) -> Self:
        data = self.model_dump(by_alias=True, exclude_none=True, exclude=without)
        for path, value in values.items():
            *sections, name = path.split(".")
            target: dict[str, Any] = data
            for section in sections:
                key, _, number = section.removesuffix("]").partition("[")
                target = target[key][int(number) - 1] if number else target[key]
            target[name] = float(value)
        try:
            return type(self).model_validate(data)
        except ValidationError as error:
            refused = refusal(error, Description)
        raise refused

    def designs(self, sweep: SweepSection) -> tuple[Self, ...]:
        """One study for each step of a sweep, in order."""
        return tuple(solve(sweep.expression, value, self) for value in sweep.values)

    def unusual(self) -> tuple[str, ...]:
        """A sentence on every value outside its typical range; on those that only a sweep reaches, if no
        other is, because a sweep starts from the given values."""
        found = tuple(f"{path}: {words}" for path, words in self._unusual_values().items())
        return found or tuple(self._unusual_sweeps())

    def _unusual_sweeps(self) -> Iterator[str]:
        for row, sweep in enumerate(self.sweep_settings, start=1):
            name = sweep.expression.varied
            ends = (solve(sweep.expression, end, self) for end in (sweep.start, sweep.stop))
            words = [text for design in ends for text in design._unusual_values().values()]
            if words:
                yield f"sweep[{row}]: {name} leaves its usual range; {words[0]}"

    def _unusual_values(self) -> dict[str, str]:
        words = {path: quantity.unusual(value) for path, value, quantity in leaves(self) if quantity}
        words |= self.finite_plate.doubtful() if self.finite_plate else {}
        return {path: text for path, text in words.items() if text}

    def to_toml(self) -> str:
        """A study file that loads to an equal study."""
        return toml_of(self)

    def inputs(self) -> dict[str, Any]:
        """Plain values in SI units of all that decides a result, for provenance and as a key of results.

        The title and the sections that ask for something of such results decide nothing; a built-in
        material is given by its constants, so that a correction in the library changes the key.
        """
        data = self.model_dump(mode="json", by_alias=True, exclude={"title", "material"} | AFTERWARDS)
        if self.finite_plate is None:
            del data["plate"]
        else:
            solids = {name: built_in(name, "").to_dict() for name in self.finite_plate.materials}
            data["plate"]["materials"] = solids
        return {"material": self.resolved_material().to_dict(), **data}


@cache
def numeric_parameters() -> Mapping[str, str]:
    """SI unit of every parameter that an expression can name, by path."""
    return MappingProxyType(
        {
            path: key.unit
            for path, key in table(Description).items()
            if key.quantity and "[]" not in path and path.split(".")[0] in OF_A_CELL
        }
    )
