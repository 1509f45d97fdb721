"""The table of the study file that describes a ribbon: what lies side by side, and what is asked of it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, field_validator

from haptonic.cell import Ribbon, UnitCell
from haptonic.cell.directed import Along, whole
from haptonic.errors import StudyError, nearest, shown
from haptonic.fields import Entries, Frequency, Name, ascending, described, needed, problem, setting
from haptonic.lattice import Lattice
from haptonic.study.plate_map import NOTHING, check_letters, drawn
from haptonic.study.plate_tables import LATTICE, LatticeSettings, TileSize
from haptonic.study.plating import lattices
from haptonic.units import format_quantity

MOST_COLUMNS = 200
TABLE = "[ribbon.tiles]"


@described("ribbon", kw_only=True)
class RibbonSettings:
    """Cells side by side, repeated without end along the other direction; the outermost edges are free."""

    map: Annotated[str, Field(max_length=1000, strict=True)] = needed(
        "A letter for each column, from left to right, such as ooooo1111ooooo."
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = setting(
        None,
        "Of a guide with free ends, whose resonances are told; else waves of any length.",
        title="Length in cells",
    )
    tiles: Entries[Name] = needed(
        'Of each, "lattice", the name of a ribbon.cell, or any other of plain plate.',
        title="Meaning of the letters",
    )
    widths: Entries[TileSize] = setting(
        Entries(), "By name: of a column of plain plate; else that of the lattice."
    )
    cell: tuple[LatticeSettings, ...] = setting(
        (), "For columns of other names.", title="Further lattices", max_length=20
    )
    along: Along = setting(
        (0.0, 1.0),
        "How many of the lattice's two translations the ribbon repeats after; [0, 1] is along y.",
        title="Direction",
    )
    lowest: Frequency | None = setting(
        None, "That modes are sought at; else somewhat below the gap.", title="Lowest frequency"
    )
    highest: Frequency | None = setting(
        None, "That modes are sought at; else somewhat above the gap.", title="Highest frequency"
    )
    points: Annotated[int, Field(ge=2, le=1000, strict=True)] = setting(
        21, "Along the ribbon, where it has no length in cells.", title="Wavevectors"
    )

    @field_validator("map")
    @classmethod
    def _line(cls, text: str) -> str:
        lines = drawn(text).split()
        if len(lines) > 1 or NOTHING in lines[0] or len(lines[0]) > MOST_COLUMNS:
            raise problem(
                "malformed",
                f"{len(lines)} lines" if len(lines) > 1 else shown(lines[0]),
                f'one line of at most {MOST_COLUMNS} letters, none of them "{NOTHING}"',
                "a ribbon repeats its one line without end, and has no holes",
                "write one line such as ooooo1111ooooo; [plate] takes maps of several lines",
            )
        return lines[0]

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "range")
        whole(self.along, "a ribbon")
        check_letters([self.map], self.tiles, TABLE)
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
        if not plain and len(set(self.map)) == 1:
            raise problem(
                "conflict",
                shown(self.map),
                "columns of plain plate between those of a lattice, or two lattices side by side",
                "all columns are alike, and nothing in them guides a wave",
                'write a map such as ooooo1111ooooo, and 1 = "guide" in [ribbon.tiles]',
                at="map",
            )

    @property
    def period(self) -> tuple[int, int]:
        """Whole translations of the lattice, after which it repeats."""
        return whole(self.along, "a ribbon")

    def ribbon(self, own: UnitCell) -> Ribbon:
        """One period of it, as the core computes with it.

        Parameters
        ----------
        own : the cell that columns of the name "lattice" hold

        Raises
        ------
        HaptonicError : columns whose edges do not meet, or a lattice without pillars
        """
        kinds = dict(lattices(self.cell, own, "ribbon.cell"))
        for letter, name in self.tiles.items():
            if name in kinds and not kinds[name].has_pillars:
                raise StudyError.conflict(
                    argument=f"ribbon.tiles.{letter}",
                    given=shown(name),
                    allowed="a lattice whose cell has a pillar",
                    cause="the cell of this study is plain plate",
                    next_step=f'add [cell.pillar], or write {letter} = "plain"',
                )
            if name not in kinds:
                kinds[name] = self._plain(own, name)
        return Ribbon(tuple(kinds[self.tiles[letter]] for letter in self.map), self.period)

    def _plain(self, own: UnitCell, name: str) -> UnitCell:
        """A column of plain plate: the cell without its pillars, or a rectangle of another width."""
        if name not in self.widths:
            return own.without_pillar()
        if not (own.is_simple and own.lattice.is_rectangular) or self.period != (0, 1):
            raise StudyError.unsupported(
                argument=f"ribbon.widths.{name}",
                given=format_quantity(self.widths[name], "m"),
                allowed="columns as wide as the lattice's, or rectangles along y",
                cause="a column of another width would not meet tiles that are no rectangles along x and y",
                next_step="leave it out, and write the letter as often as the guide has columns",
            )
        lattice = Lattice.rectangular(self.widths[name], own.lattice.a2[1])
        return UnitCell(lattice, own.thickness, own.material)
