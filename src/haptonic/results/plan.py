"""Plan of a study before it is computed: sizes, map, and the estimated cost of each command."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.cell import UnitCell
from haptonic.cell.sites import steps_between
from haptonic.fields.expressions import NAMED, ExpressedNumber
from haptonic.fields.keys import leaves
from haptonic.later import Axes, Figure, psutil, xarray as xr
from haptonic.names import counted, listed
from haptonic.plate import Layout, Plate
from haptonic.plate.layout.parts import Actuator, Bond, Force
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.result import Result, figure
from haptonic.results.table import Cell, Column, Table
from haptonic.units import format_quantity


@dataclass(frozen=True, eq=False, repr=False)
class StudyPlan(Result):
    """Contents of a study.

    study : its title; carrier : Hz, if any
    costs : estimates for the commands that apply to it, by name
    inputs : plain values of the study
    tiles : letters of the plate's map, by lattice or region; the layout may cut a letter into several tiles
    parameters : named parameters; expressions : texts of the numbers that are given by expressions, by path
    """

    title = "Plan"

    study: str
    carrier: float | None
    cell: UnitCell
    plate: Plate | None
    costs: Mapping[str, Cost]
    inputs: Mapping[str, Any]
    tiles: Mapping[str, int] = field(default_factory=dict)
    parameters: Mapping[str, ExpressedNumber] = field(default_factory=dict)
    expressions: Mapping[str, str] = field(default_factory=dict)

    @property
    def dataset(self) -> xr.Dataset:
        """Estimated costs, and tiles and area of every region of the plate."""
        data = xr.Dataset(
            {
                "processor_time": ("command", [cost.seconds for cost in self.costs.values()], {"units": "s"}),
                "memory": ("command", [cost.memory for cost in self.costs.values()], {"units": "byte"}),
            },
            coords={"command": list(self.costs)},
        )
        if self.plate:
            layout = self.plate.layout
            data["tiles"] = "region", [self.tiles[name] for name in layout.regions], {"units": "1"}
            data["area"] = "region", [layout.area(name) for name in layout.regions], {"units": "m^2"}
            data = data.assign_coords(region=list(layout.regions))
        return stamped(data, self.inputs)

    def summary(self) -> list[str]:
        sentences = [sentence_of(self.study, self.cell, self.carrier), *neighbours_text(self.cell)]
        if self.plate:
            layout = self.plate.layout
            width, height = (1e3 * lines[-1] for lines in (layout.x, layout.y))
            drives = len(self.plate.actuators) + len(self.plate.forces)
            sentences.append(
                f"A plate of {width:.4g} x {height:.4g} mm with {layout.parts}"
                f"{f' in {len(layout.cells)} lattices' if len(layout.cells) > 1 else ''}, "
                f"{counted(len(layout.regions), 'region')} of plain plate and {counted(drives, 'drive')}."
            )
            carriers = self.plate.carriers(self.carrier or 0.0)
            if len(carriers) > 1:
                shown = listed([format_quantity(carrier, "Hz") for carrier in carriers])
                sentences.append(f"The drives have {len(carriers)} carriers, {shown}, and act separately.")
            sentences += border_text(layout)
        return sentences

    def tables(self) -> list[Table]:
        costs: list[tuple[Cell, ...]] = [
            (f"haptonic {name}", "refused", None)
            if cost.refusal
            else (f"haptonic {name}", cost.time, cost.gigabytes)
            for name, cost in self.costs.items()
        ]
        values = [
            (f"{NAMED}{name}", format_quantity(value, value.unit)) for name, value in self.parameters.items()
        ]
        values += [
            (path, format_quantity(value, declared.unit) if declared else str(value))
            for path, value, declared in leaves(self.cell, "cell.")
            if path.startswith("cell.")
            and (value or path.endswith((".low", ".high")))
            and (declared or path.endswith((".section", ".material")))
        ]
        sizes: list[tuple[Cell, ...]] = [
            (path.removeprefix("cell."), value, *([self.expressions.get(path)] if self.expressions else []))
            for path, value in values
        ]
        head = ("size", "value", "expression") if self.expressions else ("size", "value")
        return [
            Table(
                "estimated cost of each command, as an order of magnitude",
                ("command", "processor time", "memory"),
                costs,
            ),
            Table("sizes and materials of the cell", head, sizes),
            *([_of_the_file(self.cell)] if self.cell.solid else []),
            *(self._of_the_plate(self.plate) if self.plate else []),
        ]

    def _of_the_plate(self, plate: Plate) -> list[Table]:
        layout = plate.layout
        boxes = {name: [layout.bounds(tile) for tile in layout.of(name)] for name in layout.regions}
        regions: list[tuple[Cell, ...]] = [
            (
                name,
                self.tiles[name],
                max(box[2] for box in own) - min(box[0] for box in own),
                max(box[3] for box in own) - min(box[1] for box in own),
            )
            for name, own in boxes.items()
        ]
        wide = [Column(name, "m", "mm", ".4g") for name in ("x", "y")]
        tables = [Table("regions of plain plate", ("region", "tiles", *wide), regions)] if regions else []
        if len(layout.cells) > 1:
            tables.insert(0, _lattices(layout, self.tiles))
        patches = [
            (
                patch.name,
                " x ".join(f"{side * 1e3:.4g}" for side in patch.size),
                patch.material.name,
                _glue(patch.bond),
                *patch.centre,
                patch.voltage,
            )
            for patch in plate.actuators
        ]
        of_patch: list[Column | str] = [
            "patch",
            "size / mm",
            "material",
            "glue",
            *wide,
            Column("voltage", "V"),
        ]
        forces = [(force.name, *force.centre, force.force) for force in plate.forces]
        of_force: list[Column | str] = ["force", *wide, Column("amplitude", "N")]
        return [
            *tables,
            *self._of_drives("patches, by their centres on the plate", of_patch, patches, plate.actuators),
            *self._of_drives("forces, by their centres on the plate", of_force, forces, plate.forces),
        ]

    def _of_drives(
        self,
        title: str,
        columns: Sequence[Column | str],
        rows: Sequence[tuple[Cell, ...]],
        drives: Sequence[Actuator | Force],
    ) -> list[Table]:
        """Table of drives with their phases, if one has a phase, and their carriers, if there are several."""
        assert self.plate is not None
        more: list[tuple[Column, list[Cell]]] = []
        if any(drive.phase for drive in drives):
            more.append((Column("phase", "rad", "deg"), [drive.phase for drive in drives]))
        if len(self.plate.carriers(self.carrier or 0.0)) > 1:
            carriers: list[Cell] = [drive.carrier or self.carrier for drive in drives]
            more.append((Column("carrier", "Hz", "kHz", "g"), carriers))
        added = zip(*(cells for _, cells in more), strict=True) if more else [()] * len(rows)
        rows = [(*row, *cells) for row, cells in zip(rows, added, strict=True)]
        return [Table(title, [*columns, *(column for column, _ in more)], rows)] if rows else []

    def remarks(self) -> list[str]:
        free = psutil.virtual_memory().available
        refused = [
            f"haptonic {name} would be refused: {cost.refusal.cause}; next step: {cost.refusal.next_step}"
            for name, cost in self.costs.items()
            if cost.refusal
        ]
        return refused + [
            f"haptonic {name} may need {cost.gigabytes}, and {free / 1e9:.1f} GB are free"
            for name, cost in self.costs.items()
            if cost.memory > free
        ]

    @figure(
        "plan",
        "The plate seen from the face with the pillars, as the study describes it.",
        when=lambda plan: plan.plate,
    )
    def _plan(self, *, ax: Axes | None = None) -> Figure:
        assert self.plate is not None
        return plots.plate_plan(self.plate, ax=ax)


def _glue(bond: Bond | None) -> str:
    return "none" if bond is None else f"{bond.material.name}, {format_quantity(bond.thickness, 'm')}"


def _lattices(layout: Layout, tiles: Mapping[str, int]) -> Table:
    """Lattices of a plate with the sizes in which they differ."""
    values = {
        name: {path: (value, key) for path, value, key in leaves(cell, "cell.") if key}
        for name, cell in layout.cells.items()
    }
    paths = dict.fromkeys(path for sizes in values.values() for path in sizes)
    differ = [path for path in paths if len({sizes.get(path, (None,))[0] for sizes in values.values()}) > 1]
    rows: list[tuple[Cell, ...]] = [
        (
            name,
            tiles[name],
            ", ".join(
                f"{path.removeprefix('cell.')} {format_quantity(sizes[path][0], sizes[path][1].unit)}"
                for path in differ
                if path in sizes
            ),
        )
        for name, sizes in values.items()
    ]
    return Table("lattices of the plate", ("lattice", "tiles", "sizes that differ"), rows)


def neighbours_text(cell: UnitCell) -> list[str]:
    """Sentence on several parts in a period, which are nearer to each other than the pitch; else empty."""
    filled = [number for number, feature in enumerate(cell.features) if feature is not None]
    if len(filled) < 2:
        return []
    away = np.vstack(
        [steps_between(cell.shares[[*pair]], cell.vectors) for pair in product(filled, repeat=2)]
    )
    nearest = format_quantity(float(f"{np.hypot(*away.T).min():.4g}"), "m")
    return [f"A period contains {len(filled)} {cell.parts}; the nearest are {nearest} apart, between axes."]


def _of_the_file(cell: UnitCell) -> Table:
    """Table of the parts of a CAD file or mesh; it shows a wrong unit or material."""
    assert cell.solid is not None
    period = cell.solid_period
    solids = [cell.solid.material_of(name, cell.material) for name in period.names]
    rows: list[tuple[Cell, ...]] = [
        (name, solid.name, volume, volume * solid.density)
        for name, solid, volume in zip(period.names, solids, period.volumes.tolist(), strict=True)
    ]
    columns = "part", "material", Column("volume", "m^3", "mm^3", ".5g"), Column("mass", "kg", "g", ".5g")
    return Table(f"parts of {Path(cell.solid.file).name}", columns, rows)


def sentence_of(title: str, cell: UnitCell, carrier: float | None) -> str:
    """One sentence on a study: lattice, materials and carrier."""
    bare = "" if cell.has_features else " without pillars"
    at = f", for {format_quantity(carrier, 'Hz')}" if carrier else ""
    lattice = f"a{'n' * (cell.lattice.name[0] in 'aeiou')} {cell.lattice.name} lattice"
    solids = dict.fromkeys(solid.name for solid in cell.materials.values())
    plate, *others = solids
    of_others = f" with {cell.parts} of {' and '.join(others)}" if others else ""
    return f"{title}: {lattice} in {plate}{of_others}{bare}{at}."


def border_text(layout: Layout) -> list[str]:
    """Sentence on pillars left out at the borders of lattices; empty without any."""
    if not layout.left_out:
        return []
    return [
        f"Plain plate replaces {counted(layout.left_out, 'pillar')} that would cross a border of a lattice."
    ]
