"""The table of the study file that describes a ribbon: what lies side by side, and what is asked of it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, field_validator

from haptonic.cell import Ribbon, UnitCell
from haptonic.cell.directed import DirectionSettings
from haptonic.errors import StudyError, nearest, shown
from haptonic.fields import Entries, Frequency, Name, ascending, described, needed, problem, setting
from haptonic.lattice import Lattice
from haptonic.study.plate_map import NOTHING, check_letters, drawn
from haptonic.study.plate_tables import LATTICE, LatticeSettings, TileSize
from haptonic.study.plating import lattices
from haptonic.units import format_quantity

MOST_COLUMNS = 200
MOST_CELLS = 120  # of several lines: with more the blocks of a column take minutes at every wavevector
POINTS, POINTS_OF_LINES = 21, 3
TABLE = "[ribbon.tiles]"


@described("ribbon", kw_only=True)
class RibbonSettings(DirectionSettings):
    """Cells side by side, repeated without end along the other direction; the outermost edges are free."""

    map: Annotated[str, Field(max_length=4000, strict=True)] = needed(
        "A letter for each column, from left to right, such as ooooo1111ooooo; several lines with one letter "
        "changed are a crystal with a defect.",
        examples=["ooooo1111ooooo"],
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = setting(
        None,
        "Length of a guide with free ends, to compute its resonances; by default waves of any length.",
        title="Length in cells",
    )
    tiles: Entries[Name] = needed(
        'For each letter "lattice", the name of a ribbon.cell, or any other name for plain plate.',
        title="Meaning of the letters",
    )
    widths: Entries[TileSize] = setting(
        Entries(), "By name: of a column of plain plate; else that of the lattice."
    )
    cell: tuple[LatticeSettings, ...] = setting(
        (), "For columns of other names.", title="Further lattices", max_length=20
    )
    lowest: Frequency | None = setting(
        None, "That modes are sought at; else somewhat below the gap.", title="Lowest frequency"
    )
    highest: Frequency | None = setting(
        None, "That modes are sought at; else somewhat above the gap.", title="Highest frequency"
    )
    points: Annotated[int, Field(ge=2, le=1000, strict=True)] | None = setting(
        None,
        f"Along the ribbon, if rows are not given; else {POINTS}, of several lines {POINTS_OF_LINES}.",
        title="Wavevectors",
    )

    @field_validator("map")
    @classmethod
    def _lines(cls, text: str) -> str:
        found = drawn(text)
        lines = found.split()
        most = MOST_COLUMNS if len(lines) == 1 else MOST_CELLS
        if NOTHING in found or len(lines) * len(lines[0]) > most:
            raise problem(
                "malformed",
                shown(NOTHING) if NOTHING in found else f"{len(lines)} x {len(lines[0])} letters",
                f"one line of at most {MOST_COLUMNS} letters, or several of {MOST_CELLS} in all; none is "
                f'"{NOTHING}"',
                "a ribbon has no holes" if NOTHING in found else "all cells of a period are joined at once",
                "write one line such as ooooo1111ooooo, or fewer lines around a defect",
            )
        return found if len(lines) > 1 else lines[0]

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "range")
        super().__post_init__()
        check_letters(self.lines, self.tiles, TABLE)
        if self.rows is not None and len(self.lines) > 1:
            raise problem(
                "conflict",
                str(self.rows),
                "a length in cells of a ribbon of one line",
                "the map has several lines, which repeat as a whole",
                "leave rows out, or write a map of one line",
                at="rows",
            )
        known = {LATTICE, *(one.name for one in self.cell)}
        plain = [name for name in self.tiles.values() if name not in known]
        for name in self.widths:
            if name not in plain:
                guess = nearest(name, plain)
                raise problem(
                    "unknown",
                    shown(name),
                    f"one of {', '.join(plain)}" if plain else "none: no column is plain plate",
                    "it is a lattice, which has its own pitch"
                    if name in known
                    else "no column has this name",
                    f'write "{guess}"' if guess else "leave it out",
                    at=f"widths.{name}",
                )
        for number, one in enumerate(self.cell, start=1):
            if one.name not in self.tiles.values():
                raise problem(
                    "unknown",
                    shown(one.name),
                    f"one of {', '.join(self.tiles.values())}",
                    "no column is of this lattice",
                    f'add a letter = "{one.name}" to {TABLE}, or remove it',
                    at=f"cell[{number}].name",
                )
        if not plain and len(set("".join(self.lines))) == 1:
            raise problem(
                "conflict",
                shown(self.map),
                "columns of plain plate between those of a lattice, or two lattices side by side",
                "all columns are alike, and nothing in them guides a wave",
                'write a map such as ooooo1111ooooo, and 1 = "guide" in [ribbon.tiles]',
                at="map",
            )

    @property
    def lines(self) -> list[str]:
        """Of the map, the topmost first."""
        return self.map.split()

    @property
    def names(self) -> list[list[str]]:
        """Of all cells, line by line, the lowest first."""
        return [[self.tiles[letter] for letter in line] for line in reversed(self.lines)]

    @property
    def wavevectors(self) -> int:
        """Along the ribbon, where it has no length in cells."""
        return self.points or (POINTS if len(self.lines) == 1 else POINTS_OF_LINES)

    def ribbon(self, own: UnitCell) -> Ribbon:
        """One period of it, as the core computes with it.

        Parameters
        ----------
        own : the cell that those of the name "lattice" hold

        Raises
        ------
        HaptonicError : columns whose edges do not meet, or a lattice without pillars
        """
        kinds = dict(lattices(self.cell, own, "ribbon.cell"))
        for letter, name in self.tiles.items():
            if name in kinds and not kinds[name].has_features:
                raise StudyError.conflict(
                    argument=f"ribbon.tiles.{letter}",
                    given=shown(name),
                    allowed="a lattice whose cell has a pillar or discs",
                    cause="the cell of this study is plain plate",
                    next_step=f'add [cell.pillar], or write {letter} = "plain"',
                )
            if name not in kinds:
                kinds[name] = self._plain(own, name)
        first, *more = (tuple(kinds[name] for name in line) for line in self.names)
        ribbon = Ribbon(first, self.direction, tuple(more))
        if not ribbon.guide.any():
            raise StudyError.conflict(
                argument="ribbon.map",
                given=shown(" / ".join(self.lines)),
                allowed="cells between the outermost columns that differ from these",
                cause="every cell is one that a column at the edge has, and no two of them meet in a line",
                next_step="keep the first and the last column for the crystal around",
            )
        return ribbon

    def _plain(self, own: UnitCell, name: str) -> UnitCell:
        """A column of plain plate: the cell without its pillars, or a rectangle of another width."""
        if name not in self.widths:
            return own.without_pillar()
        if not (own.is_simple and own.lattice.is_rectangular) or self.direction != (0, 1):
            raise StudyError.unsupported(
                argument=f"ribbon.widths.{name}",
                given=format_quantity(self.widths[name], "m"),
                allowed="columns as wide as the lattice's, or rectangles along y",
                cause="a column of another width would not meet tiles that are no rectangles along x and y",
                next_step="leave it out, and write the letter as often as the guide has columns",
            )
        lattice = Lattice.rectangular(self.widths[name], own.lattice.a2[1])
        return UnitCell(lattice, own.thickness, own.material, faces=own.faces)
