"""A study before it is computed: its sizes, its map, and what each command will cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from haptonic import plots
from haptonic.cell import UnitCell
from haptonic.fields.keys import leaves
from haptonic.later import Axes, Figure, psutil, xarray as xr
from haptonic.plate import Layout, Plate
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.result import Result, figure
from haptonic.results.table import Cell, Column, Table
from haptonic.units import format_quantity


@dataclass(frozen=True, eq=False, repr=False)
class StudyPlan(Result):
    """What a study describes.

    study : its title; carrier : Hz, if there is one
    costs : forecasts of the commands that it can be asked for, by name
    inputs : plain values of the study
    """

    title = "Plan"

    study: str
    carrier: float | None
    cell: UnitCell
    plate: Plate | None
    costs: Mapping[str, Cost]
    inputs: Mapping[str, Any]

    @property
    def dataset(self) -> xr.Dataset:
        """The forecasts, and tiles and area of every region of the plate."""
        data = xr.Dataset(
            {
                "processor_time": ("command", [one.seconds for one in self.costs.values()], {"units": "s"}),
                "memory": ("command", [one.memory for one in self.costs.values()], {"units": "byte"}),
            },
            coords={"command": list(self.costs)},
        )
        if self.plate:
            layout = self.plate.layout
            data["tiles"] = "region", [len(layout.of(name)) for name in layout.regions], {"units": "1"}
            data["area"] = "region", [layout.area(name) for name in layout.regions], {"units": "m^2"}
            data = data.assign_coords(region=list(layout.regions))
        return stamped(data, self.inputs)

    def summary(self) -> list[str]:
        said = [sentence_of(self.study, self.cell, self.carrier)]
        if self.plate:
            layout = self.plate.layout
            width, height = (1e3 * lines[-1] for lines in (layout.x, layout.y))
            drives = len(self.plate.actuators) + len(self.plate.forces)
            said.append(
                f"A plate of {width:.4g} x {height:.4g} mm with {layout.parts}, "
                f"{_counted(len(layout.regions), 'region')} of plain plate and {_counted(drives, 'drive')}."
            )
            said += border_text(layout)
        return said

    def tables(self) -> list[Table]:
        costs: list[tuple[Cell, ...]] = [
            (f"haptonic {name}", "refused", None)
            if one.refusal
            else (f"haptonic {name}", f"about {one.time}", one.gigabytes)
            for name, one in self.costs.items()
        ]
        sizes: list[tuple[Cell, ...]] = [
            (path.removeprefix("cell."), format_quantity(value, declared.unit) if declared else value)
            for path, value, declared in leaves(self.cell, "cell.")
            if path.startswith("cell.") and value and (declared or path.endswith(".section"))
        ]
        return [
            Table(
                "forecasts, right within about a factor of two",
                ("command", "processor time", "memory"),
                costs,
            ),
            Table("sizes of the cell", ("size", "value"), sizes),
            *([_of_the_file(self.cell)] if self.cell.solid else []),
            *(self._of_the_plate(self.plate) if self.plate else []),
        ]

    @staticmethod
    def _of_the_plate(plate: Plate) -> list[Table]:
        layout = plate.layout
        boxes = {name: [layout.bounds(tile) for tile in layout.of(name)] for name in layout.regions}
        regions: list[tuple[Cell, ...]] = [
            (
                name,
                len(tiles),
                max(box[2] for box in tiles) - min(box[0] for box in tiles),
                max(box[3] for box in tiles) - min(box[1] for box in tiles),
            )
            for name, tiles in boxes.items()
        ]
        wide = [Column(name, "m", "mm", ".4g") for name in ("x", "y")]
        found = [Table("regions of plain plate", ("region", "tiles", *wide), regions)] if regions else []
        rows: list[tuple[Cell, ...]] = [
            (one.name, f"{one.size[0] * 1e3:.4g} x {one.size[1] * 1e3:.4g}", *one.centre, one.voltage)
            for one in plate.actuators
        ]
        columns: list[Column | str] = ["patch", "size / mm", *wide, Column("voltage", "V", form=".4g")]
        return [*found, Table("patches, by their centres on the plate", columns, rows)] if rows else found

    def remarks(self) -> list[str]:
        free = psutil.virtual_memory().available
        refused = [
            f"haptonic {name} would be refused: {one.refusal.cause}; next step: {one.refusal.next_step}"
            for name, one in self.costs.items()
            if one.refusal
        ]
        return refused + [
            f"haptonic {name} may need {one.gigabytes}, and {free / 1e9:.1f} GB are free"
            for name, one in self.costs.items()
            if one.memory > free
        ]

    @figure(
        "plan",
        "The plate seen from the face with the pillars, as the study describes it.",
        when=lambda plan: plan.plate,
    )
    def _plan(self, *, ax: Axes | None = None) -> Figure:
        assert self.plate is not None
        return plots.plate_plan(self.plate, ax=ax)


def _of_the_file(cell: UnitCell) -> Table:
    """Solids of a CAD file, or parts of a mesh, by which a wrong unit or material shows."""
    assert cell.solid is not None
    period = cell.solid_period
    solids = [cell.solid.material_of(name, cell.material) for name in period.names]
    rows: list[tuple[Cell, ...]] = [
        (name, solid.name, volume, volume * solid.density)
        for name, solid, volume in zip(period.names, solids, period.volumes.tolist(), strict=True)
    ]
    columns = "part", "material", Column("volume", "m^3", "mm^3", ".5g"), Column("mass", "kg", "g", ".5g")
    return Table(f"parts of {Path(cell.solid.file).name}, as it has them", columns, rows)


def sentence_of(title: str, cell: UnitCell, carrier: float | None) -> str:
    """What a study describes, a sentence."""
    bare = "" if cell.has_features else " without pillars"
    at = f", for {format_quantity(carrier, 'Hz')}" if carrier else ""
    lattice = f"a{'n' * (cell.lattice.name[0] in 'aeiou')} {cell.lattice.name} lattice"
    solids = dict.fromkeys(solid.name for solid in cell.materials.values())
    plate, *others = solids
    of_others = f" with {cell.parts} of {' and '.join(others)}" if others else ""
    return f"{title}: {lattice} in {plate}{of_others}{bare}{at}."


def border_text(layout: Layout) -> list[str]:
    """What is missing at the borders of lattices, if anything is."""
    if not layout.left_out:
        return []
    whose = "its" if layout.left_out == 1 else "their"
    return [
        f"At the borders of its lattices {_counted(layout.left_out, 'pillar')} would stand across: plain "
        f"plate takes {whose} place."
    ]


def _counted(number: int, what: str) -> str:
    return f"{number or 'no'} {what}{'s' * (number != 1)}"
