"""The table of the study file that describes a ribbon: its columns, and the range of its waves."""

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
MOST_CELLS = 120  # for several lines: with more cells the blocks of a column take minutes per wavevector
POINTS, POINTS_OF_LINES = 21, 3
TABLE = "[ribbon.tiles]"


@described("ribbon", kw_only=True)
class RibbonSettings(DirectionSettings):
    """Cells side by side, repeated without end along the other direction; the outermost edges are free."""

    map: Annotated[str, Field(max_length=4000, strict=True)] = needed(
        "A letter for each column, from left to right, such as ooooo1111ooooo; equal letters are a strip of "
        "crystal with free edges, several lines with one letter changed a crystal with a defect.",
        examples=["ooooo1111ooooo"],
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = setting(
        None,
        "Length of a guide with free ends, to compute its resonances; by default waves of any length.",
        title="Length in cells",
    )
    tiles: Entries[Name] = needed(
        'Each letter means "lattice", the name of a ribbon.cell, or any other name for plain plate.',
        title="Meaning of the letters",
    )
    widths: Entries[TileSize] = setting(
        Entries(), "Width of columns of plain plate, by name; by default that of the lattice."
    )
    cell: tuple[LatticeSettings, ...] = setting(
        (), "Lattices of columns with other names.", title="Further lattices", max_length=20
    )
    lowest: Frequency | None = setting(
        None, "Lowest frequency of modes; by default somewhat below the gap.", title="Lowest frequency"
    )
    highest: Frequency | None = setting(
        None, "Highest frequency of modes; by default somewhat above the gap.", title="Highest frequency"
    )
    points: Annotated[int, Field(ge=2, le=1000, strict=True)] | None = setting(
        None,
        f"Number of wavevectors along the ribbon, if rows are not given; by default {POINTS}, for several "
        f"lines {POINTS_OF_LINES}.",
        title="Wavevectors",
    )

    @field_validator("map")
    @classmethod
    def _lines(cls, text: str) -> str:
        text = drawn(text, holes=False)
        lines = text.split()
        most = MOST_COLUMNS if len(lines) == 1 else MOST_CELLS
        if NOTHING in text or len(lines) * len(lines[0]) > most:
            raise problem(
                "malformed",
                shown(NOTHING) if NOTHING in text else f"{len(lines)} x {len(lines[0])} letters",
                f"one line of at most {MOST_COLUMNS} letters, or several of {MOST_CELLS} in all, without "
                f'"{NOTHING}"',
                "a ribbon has no holes" if NOTHING in text else "all cells of a period are joined at once",
                "write one line such as ooooo1111ooooo, or fewer lines around a defect",
            )
        return text if len(lines) > 1 else lines[0]

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "range")
        super().__post_init__()
        check_letters(self.lines, self.tiles, TABLE, holes=False)
        if self.rows is not None and len(self.lines) > 1:
            raise problem(
                "conflict",
                str(self.rows),
                "a length in cells of a ribbon of one line",
                "the map has several lines, which repeat as a whole",
                "leave rows out, or write a map of one line",
                at="rows",
            )
        lattice_names = {LATTICE, *(lattice.name for lattice in self.cell)}
        plain = [name for name in self.tiles.values() if name not in lattice_names]
        for name in self.widths:
            if name not in plain:
                guess = nearest(name, plain)
                raise problem(
                    "unknown",
                    shown(name),
                    f"one of {', '.join(plain)}" if plain else "no name: no column is plain plate",
                    "it is a lattice, which has its own pitch"
                    if name in lattice_names
                    else "no column has this name",
                    f'write "{guess}"' if guess else "leave it out",
                    at=f"widths.{name}",
                )
        for number, lattice in enumerate(self.cell, start=1):
            if lattice.name not in self.tiles.values():
                raise problem(
                    "unknown",
                    shown(lattice.name),
                    f"one of {', '.join(self.tiles.values())}",
                    "no column is of this lattice",
                    f'add a letter = "{lattice.name}" to {TABLE}, or remove it',
                    at=f"cell[{number}].name",
                )

    @property
    def lines(self) -> list[str]:
        """Lines of the map, the topmost first."""
        return self.map.split()

    @property
    def names(self) -> list[list[str]]:
        """Names of all cells, line by line, the lowest first."""
        return [[self.tiles[letter] for letter in line] for line in reversed(self.lines)]

    @property
    def wavevectors(self) -> int:
        """Number of wavevectors along a ribbon without a length in cells."""
        return self.points or (POINTS if len(self.lines) == 1 else POINTS_OF_LINES)

    def ribbon(self, cell: UnitCell) -> Ribbon:
        """Build one period of the ribbon.

        Parameters
        ----------
        cell : the cell of columns with the name "lattice"

        Raises
        ------
        HaptonicError : columns whose edges do not meet, or a lattice without pillars
        """
        kinds = dict(lattices(self.cell, cell, "ribbon.cell"))
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
                kinds[name] = self._plain(cell, name)
        first, *more = (tuple(kinds[name] for name in line) for line in self.names)
        return Ribbon(first, self.direction, tuple(more))

    def _plain(self, cell: UnitCell, name: str) -> UnitCell:
        """A column of plain plate: the cell without its pillars, or a rectangle of another width."""
        if name not in self.widths:
            return cell.without_pillar()
        if not (cell.is_simple and cell.lattice.is_rectangular) or self.direction != (0, 1):
            raise StudyError.unsupported(
                argument=f"ribbon.widths.{name}",
                given=format_quantity(self.widths[name], "m"),
                allowed="columns as wide as the lattice's, or rectangles along y",
                cause="a column of another width needs tiles that are rectangles along x and y",
                next_step="leave it out, and repeat the letter for each column of the guide",
            )
        lattice = Lattice.rectangular(self.widths[name], cell.lattice.a2[1])
        return UnitCell(lattice, cell.thickness, cell.material, faces=cell.faces)
