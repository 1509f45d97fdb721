"""The tables of the study file that describe a finite plate: its map, its supports and its drives."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from typing import Annotated, Any, ClassVar

from pydantic import Field, ValidationInfo, field_validator

from haptonic.cell import UnitCell
from haptonic.design.parameters import UNITS
from haptonic.errors import StudyError, proposed, shown
from haptonic.fields import (
    Aliases,
    Entries,
    Name,
    absent,
    described,
    handed_on,
    meant,
    needed,
    number_of,
    problem,
    setting,
    size,
    table,
)
from haptonic.fields.keys import ByPattern
from haptonic.materials import Material
from haptonic.plate.layout.parts import Actuator, Finger, Force
from haptonic.plate.layout.supports import Clamp, Edges, Loss
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.response.checks import REST, THE_REST
from haptonic.study.plate_map import check_map, drawn
from haptonic.vibrometry.settings import CLAMPS

KEYS = ByPattern(table(UnitCell, "cell."))
CHANGEABLE = ByPattern({
    path: key.unit
    for path, key in KEYS.items()
    if path.startswith("cell.") and path != "cell.thickness"
    # unlike a design, another lattice has its own mesh, so that its sections may turn
    and (path in UNITS or path.endswith(("pillar.turn", "disc[].turn")))
})  # fmt: skip
"""Numbers in which the lattices of a plate may differ, and their SI units."""
LATTICE = "lattice"  # name of the study's own cell in [plate.tiles]

TileSize = Annotated[float, size(100e-9, 100e-3)]


@described("plate.cell", kw_only=True)
class LatticeSettings:
    """A further lattice of the plate, or of a ribbon: the study's own cell with some numbers changed."""

    name: Name = needed("Name of the lattice in the table of tiles.", examples=["low"])
    change: Entries[float] = needed(
        "Numbers of the cell, by their names in this file; thickness and material stay."
    )

    @field_validator("change", mode="before")
    @classmethod
    def _of_the_cell(cls, value: object, info: ValidationInfo) -> object:
        """SI values by path; TOML reads the dots of an unquoted path as nested tables."""
        if not isinstance(value, dict):
            return value
        read = {}
        for path, given in _flat(value).items():
            _changeable(path)
            read[path] = number_of(given, CHANGEABLE[path], info.context)
        return read

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit of every number that a lattice may change."""
        return CHANGEABLE


def _flat(tree: dict[str, Any], prefix: str = "") -> dict[str, object]:
    flat: dict[str, object] = {}
    for name, value in tree.items():
        flat |= _flat(value, f"{prefix}{name}.") if isinstance(value, dict) else {f"{prefix}{name}": value}
    return flat


def _changeable(path: str) -> None:
    if path in CHANGEABLE:
        return
    slip, cause = path not in KEYS, "it cannot differ between the lattices of a plate"
    if slip:
        cause = "no number of the cell has this name"
    elif path == "cell.thickness" or path.startswith("material."):
        cause = "all lattices of a plate have its thickness and its material"
    raise handed_on(StudyError.unknown("", path, CHANGEABLE, cause, slip=slip, next_step="leave it out"))


@described("plate", kw_only=True)
class PlateSettings:
    """A finite plate: a map of tiles, its supports and its drives."""

    aliases: ClassVar[Aliases] = {
        **meant("actuator", "actuators", "piezo", "patch", "transducer"),
        **meant("force", "forces", "load"),
        **meant("cell", "lattice", "cells"),
        **meant("map", "layout", "pattern"),
        **absent(
            "carrier", "frequency", cause="a carrier belongs to the study or to a drive",
            next_step="write carrier at the top of the study, or in a [[plate.actuator]]",
        ),
        **absent(
            "thickness", "material", cause="a plate has the thickness and the material of the study's cell",
            next_step="give thickness in [cell] and material at the top, and leave this key out",
        ),
        **absent(
            "pitch", "spacing", cause="the tiles of a lattice have the pitch of its cell",
            next_step="give pitch in [cell]; [plate.widths] gives the width of columns of a region",
        ),
        **absent(
            "margin", "rim", "border", "frame", cause="a rim of plain plate belongs to the map",
            next_step="draw it with a letter of its own, with its size in [plate.widths] and [plate.heights]",
        ),
        **absent(
            "width", "height", "length", "size", "columns",
            cause="the size of a plate follows from its map",
            next_step="add letters or rows to the map; [plate.widths] gives the width of columns of a region",
        ),
    }  # fmt: skip

    map: Annotated[str, Field(max_length=200_000, strict=True)] = needed(
        "A letter for each tile, from above on the face with the pillars, largest y first.",
        examples=["oo11oo"],
    )
    rows: Annotated[int, Field(ge=1, le=10_000, strict=True)] | None = setting(
        None, "Number of rows; the lines of the map are repeated to fill them."
    )
    loss_factor: Loss | None = setting(
        None, "Loss factor of the mounted plate; by default that of its material.", examples=["0.01"]
    )
    tiles: Entries[Name] = needed(
        'Each letter means "lattice", the name of a plate.cell, or the name of a region of plain plate.',
        title="Meaning of the letters",
    )
    widths: Entries[TileSize] = setting(
        Entries(), "Width of columns without a lattice, by region; by default the pitch."
    )
    heights: Entries[TileSize] = setting(
        Entries(), "Height of rows without a lattice, by region; by default the pitch along y."
    )
    cell: tuple[LatticeSettings, ...] = setting(
        (), "Lattices of tiles with other names.", title="Further lattices", max_length=20
    )
    edges: Edges = setting(Edges(), "Supports of the edges.")
    clamp: Clamp | None = setting(None, "Clamped corners, if this table is given.", title="Corners")
    actuator: tuple[Actuator, ...] = setting((), "Piezoelectric patches.", title="Actuators", max_length=100)
    force: tuple[Force, ...] = setting((), "Forces on the flat face.", title="Forces", max_length=100)
    finger: Finger | None = setting(None, "Finger on the flat face, if this table is given.")
    response: ResponseSettings = setting(ResponseSettings(), "Frequencies and points of the response.")

    @field_validator("map")
    @classmethod
    def _lines(cls, text: str) -> str:
        return drawn(text)

    @field_validator("tiles")
    @classmethod
    def _no_reserved_names(cls, tiles: Entries[str]) -> Entries[str]:
        rest = "this word means all points outside of a region"
        taken = {
            REST: rest,
            THE_REST: rest,
            CLAMPS: "in skip of [scan] this word means all clamped corners",
        }
        for name in tiles.values():
            if name in taken:
                raise problem("conflict", shown(name), "any other name", taken[name], "choose another name")
        return tiles

    def __post_init__(self) -> None:
        check_map(self.lines, self.rows, self.tiles)
        self._names_are_unique()
        self._names_are_known()

    def _names_are_unique(self) -> None:
        cells = [(f"cell[{i}]", lattice.name) for i, lattice in enumerate(self.cell, start=1)]
        driven = [(f"actuator[{i}]", part.name) for i, part in enumerate(self.actuator, start=1)]
        driven += [(f"force[{i}]", part.name) for i, part in enumerate(self.force, start=1)]
        for kind, places, taken in (("lattice", cells, {LATTICE}), ("actuator or force", driven, set())):
            for place, name in places:
                if name in taken:
                    raise problem(
                        "repeated",
                        shown(name), f"a name that no other {kind} of the plate has",
                        "it is the study's own cell" if name == LATTICE and place in dict(cells)
                        else "a table was copied",
                        "choose another name", at=f"{place}.name",
                    )  # fmt: skip
                taken.add(name)

    def _names_are_known(self) -> None:
        """Check that every name belongs to a tile, and that settings of regions do not name lattices."""
        in_map = list(self.tiles.values())
        for i, lattice in enumerate(self.cell, start=1):
            if lattice.name not in in_map:
                self._unknown(f"cell[{i}].name", lattice.name, self.regions, "no tile is of this lattice",
                              f'add a letter = "{lattice.name}" to [plate.tiles], or remove it')  # fmt: skip
        named = {f"{table}.{name}": name for table in ("widths", "heights") for name in getattr(self, table)}
        patches, forces = enumerate(self.actuator, start=1), enumerate(self.force, start=1)
        named |= {f"actuator[{i}].region": patch.region for i, patch in patches if patch.region}
        for at, name in named.items():
            if name not in self.regions and name in in_map:
                self._unknown(at, name, self.regions, "it is a lattice", "name a region of plain plate")
            elif name not in self.regions:
                self._unknown(at, name, self.regions, "no tile is of this region")
        named = {f"force[{i}].region": force.region for i, force in forces if force.region}
        named |= {"finger.region": self.finger.region} if self.finger and self.finger.region else {}
        for at, name in named.items():
            if name not in in_map:
                self._unknown(at, name, in_map, "no tile has this name")

    @staticmethod
    def _unknown(at: str, name: str, names: list[str], cause: str, next_step: str = "") -> None:
        allowed = f"one of {', '.join(names)}" if names else "the name of a region; this plate has no regions"
        hint = proposed(name, names) or "choose one of these, or add it to [plate.tiles]"
        raise problem("unknown", shown(name), allowed, cause, next_step or hint, at=at)

    @property
    def materials(self) -> dict[str, Material]:
        """Materials of patches and bonds, by path below the table."""
        patches = {f"actuator[{i}]": patch for i, patch in enumerate(self.actuator, start=1)}
        bonds = {f"{at}.bond.material": patch.bond.material for at, patch in patches.items() if patch.bond}
        return {f"{at}.material": patch.material for at, patch in patches.items()} | bonds

    def doubtful(self) -> dict[str, str]:
        """Remarks, by path below the table, on regions whose name resembles that of a lattice."""
        return {
            f"tiles.{letter}": f'"{name}" is a region of plain plate. Did you mean "{guess}"?'
            for letter, name in self.tiles.items()
            if name in self.regions
            for guess in get_close_matches(name.lower(), [LATTICE, *(c.name for c in self.cell)], 1, 0.8)
        }

    @property
    def lines(self) -> list[str]:
        """Lines of the map as given, the topmost first."""
        return self.map.splitlines()

    @property
    def grid(self) -> tuple[tuple[str | None, ...], ...]:
        """[row][column] name of each tile, None for an absent tile; the lowest row first."""
        lines = self.lines * ((self.rows or len(self.lines)) // len(self.lines))
        return tuple(tuple(self.tiles.get(letter) for letter in line) for line in reversed(lines))

    @property
    def regions(self) -> list[str]:
        """Names of the regions of plain plate."""
        lattices = {LATTICE, *(lattice.name for lattice in self.cell)}
        return [name for name in self.tiles.values() if name not in lattices]
