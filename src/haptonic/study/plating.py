"""Conversion of the [plate] of a study: positions in metres, names resolved."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate, combinations, product
from typing import TypeVar

from haptonic.cell import Brickwork, UnitCell
from haptonic.design.discs import with_joined
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields import unchecked
from haptonic.plate.layout.grid import CLOSE, Layout, Rectangle
from haptonic.plate.layout.parts import Actuator, Finger, Force, Plate
from haptonic.plate.layout.supports import Clamp
from haptonic.study.plate_tables import CHANGEABLE, LATTICE, LatticeSettings, PlateSettings
from haptonic.units import format_quantity

Attached = TypeVar("Attached", Actuator, Force, Finger)


def plate_of(section: PlateSettings | None, cell: UnitCell) -> Plate:
    """Build the plate of a study, in SI units.

    Parameters
    ----------
    cell : the cell of tiles with the name "lattice"

    Raises
    ------
    StudyError : the study has no plate, or one that cannot be built; the argument is the path of the key
    """
    if section is None:
        raise _refused(
            "missing", "plate", "nothing", "a [plate] table with map and tiles",
            "the study describes a lattice without a plate",
            'add map = "AAA" to [plate] and A = "lattice" to [plate.tiles]; see `haptonic keys plate`',
        )  # fmt: skip
    if cell.is_mirrored:
        raise _refused(
            "unsupported", "cell.faces", "both", "one, for a finite plate",
            "the lower face of its regions is flat, for the finger and the actuators",
            'write faces = "one", or leave [plate] out: bands, layers, ribbons and waveguides have both',
        )  # fmt: skip
    if section.loss_factor is None and len(cell.loss_factors) > 1:
        raise _refused(
            "missing", "plate.loss_factor", "nothing, although pillars and plate have different loss factors",
            "a single loss factor for the plate and its pillars",
            "the response of a plate has one loss factor for everything except glued parts",
            f"add loss_factor to [plate], between {cell.loss_factors[0]:g} and {cell.loss_factors[-1]:g}",
        )  # fmt: skip
    layout = _layout(section, cell)
    _check_grid(layout, section.response.grid)
    called = [_called("actuator", i, patch) for i, patch in enumerate(section.actuator, start=1)]
    for at, patch in zip(called, section.actuator, strict=True):
        _check_placed(at, patch, layout)
    patches = tuple(_placed(patch, layout) for patch in section.actuator)
    for (at, first), (_, second) in combinations(zip(called, patches, strict=True), 2):
        _check_apart(at, first, second, layout)
    supports = section.edges.supports
    if section.clamp:
        _check_corners(section.clamp, layout)
        supports += (section.clamp.support,)
    for i, force in enumerate(section.force, start=1):
        _check_placed(_called("force", i, force), force, layout)
    if section.finger:
        _check_finger(section.finger, layout)
    return Plate(
        layout=layout,
        supports=supports,
        actuators=patches,
        forces=tuple(_placed(force, layout) for force in section.force),
        finger=section.finger and _placed(section.finger, layout),
        loss_factor=cell.material.loss_factor if section.loss_factor is None else section.loss_factor,
    )


def lines_of_map(section: PlateSettings, cell: UnitCell) -> tuple[list[float], list[float]]:
    """Positions of the lines between the letters of a map along x and along y, from 0 upwards, m.

    Raises
    ------
    StudyError : letters of different sizes share a column or a row
    """
    widths, heights = _sizes_of_map(section, cell, _cells(section, cell))
    return [0.0, *accumulate(widths)], [0.0, *accumulate(heights)]


def _layout(section: PlateSettings, cell: UnitCell) -> Layout:
    cells = _cells(section, cell)
    for letter, name in section.tiles.items():
        if name in cells and not cells[name].has_features:
            raise _refused(
                "conflict", f"plate.tiles.{letter}", shown(name),
                "a lattice whose cell has a pillar or discs",
                "the cell of this study is plain plate", f'add [cell.pillar], or write {letter} = "plain"',
            )  # fmt: skip
    widths, heights = _sizes_of_map(section, cell, cells)
    return Layout.laid(section.grid, widths, heights, cells, cell.thickness, cell.material)


def _cells(section: PlateSettings, cell: UnitCell) -> dict[str, UnitCell]:
    """Cells of the lattices that the map contains, by name."""
    return {
        name: cell_of_tiles
        for name, cell_of_tiles in lattices(section.cell, cell, "plate.cell")
        if name in section.tiles.values()
    }


def _sizes_of_map(
    section: PlateSettings, cell: UnitCell, cells: Mapping[str, UnitCell]
) -> tuple[list[float], list[float]]:
    """Widths of the columns and heights of the rows of the map, m."""
    tiles = section.grid
    columns = [{row[j] or "" for row in tiles} for j in range(len(tiles[0]))]
    rows = [{name or "" for name in row} for row in tiles]
    bricks, usual = {name: Brickwork.of(each) for name, each in cells.items()}, Brickwork.of(cell)
    widths = _sizes("column", columns, {name: brick.width for name, brick in bricks.items()}, section.widths,
                    usual.width, "plate.widths")  # fmt: skip
    heights = _sizes("row", rows, {name: brick.height for name, brick in bricks.items()}, section.heights,
                     usual.height, "plate.heights")  # fmt: skip
    return [*widths], [*heights]


def lattices(
    further: Sequence[LatticeSettings], cell: UnitCell, table: str
) -> Iterator[tuple[str, UnitCell]]:
    """The cell of the study, then the lattices of a table with changed numbers, each with its name."""
    yield LATTICE, cell
    parameters = cell.numbers()
    for i, lattice in enumerate(further, start=1):
        at = f'{table}[{i}] "{lattice.name}".change'
        for path in lattice.change:
            if path not in parameters:
                raise _refused(
                    "unknown", at, path,
                    f"one of {', '.join(each for each in parameters if each in CHANGEABLE)}",
                    "this study does not give it", "give it in [cell] first, or leave it out here",
                )  # fmt: skip
        try:
            yield lattice.name, cell.with_numbers(with_joined(cell, lattice.change))
        except HaptonicError as error:
            given = ", ".join(
                f"{path} = {format_quantity(value, lattice.units[path])}"
                for path, value in lattice.change.items()
            )
            raise _refused(
                "out-of-range", at, given, f"a cell that can be built; {error.argument}: {error.allowed}",
                f"{error.argument} would be {error.given}: {error.cause}", error.next_step,
            ) from None  # fmt: skip


def _sizes(
    what: str,
    lines: list[set[str]],
    pitches: Mapping[str, float],
    given: Mapping[str, float],
    default: float,
    at: str,
) -> Iterator[float]:
    """Width of every column, or height of every row: a lattice's pitch, or the given size of its regions."""
    free: set[str] = set()  # regions with a column or row without lattice
    for number, names in enumerate(lines, start=1):
        lattices = {name: pitches[name] for name in names if name in pitches}
        place = f"{what} {number}" + (" from below" if what == "row" else "")
        asked = lattices or {name: given[name] for name in names if name in given}
        free |= set() if lattices else asked.keys()
        if asked and max(asked.values()) - min(asked.values()) > CLOSE * max(asked.values()):
            sizes = (f'{format_quantity(size, "m")} of "{name}"' for name, size in sorted(asked.items()))
            raise _refused(
                "conflict", "plate.map" if lattices else at, f"in {place}: {' and '.join(sizes)}",
                f"one size for the whole {what}",
                "two lattices of different pitch meet there" if lattices else "two regions meet there",
                f"draw them in separate {what}s" + ("" if lattices else ", or give them one size"),
            )  # fmt: skip
        yield next(iter(asked.values()), default)
    for name in given:
        if name not in free:
            raise _refused(
                "conflict", f"{at}.{name}", format_quantity(given[name], "m"),
                f"a region that has a {what} without a lattice",
                f"all its {what}s contain cells of a lattice and have its pitch", "leave it out",
            )  # fmt: skip


def _check_grid(layout: Layout, grid: float) -> None:
    shorter = min(layout.x[-1], layout.y[-1])
    if grid > shorter:
        raise _refused(
            "out-of-range", "plate.response.grid", format_quantity(grid, "m"),
            f"at most {format_quantity(shorter, 'm')}",
            "it is wider than the plate", f'write grid = "{format_quantity(0.05 * shorter, "m")}"',
        )  # fmt: skip


def _check_corners(clamp: Clamp, layout: Layout) -> None:
    """Refuse clamped corners that would meet, or that lie on absent tiles."""
    (right, top), length = (layout.x[-1], layout.y[-1]), clamp.corners
    corners = [
        (x, y)
        for x, y in product((0.0, right), (0.0, top))
        if layout.at((0 if y == 0.0 else layout.rows - 1, 0 if x == 0.0 else layout.columns - 1))
    ]
    if not corners:
        raise _refused(
            "out-of-range", "plate.clamp.corners", format_quantity(length, "m"),
            "a plate with a tile at one of the four corners of its map", "the corners are cut out",
            "remove [plate.clamp], and support the plate at [plate.edges]",
        )  # fmt: skip
    room, thin = 0.5 * min(right, top), 1e-3 * layout.thickness
    beside = [
        (max(x - across, 0.0), max(y - up, 0.0), min(x + across, right), min(y + up, top))
        for (x, y), (across, up) in product(corners, ((length, thin), (thin, length)))
    ]
    covered = all(layout.at(tile) for box in beside for tile in layout.under(box))
    if length > room * (1 + CLOSE) or not covered:
        raise _refused(
            "out-of-range", "plate.clamp.corners", format_quantity(length, "m"),
            f"at most {format_quantity(room, 'm')}, half of the shorter side, with tiles all along it",
            "the clamped parts of a side would meet" if length > room else "a tile beside a corner is absent",
            "choose a shorter length",
        )  # fmt: skip


def _placed(part: Attached, layout: Layout) -> Attached:
    """The part with its position on the plate, relative to the plate's corner."""
    return unchecked(part, centre=_centre(part, layout), region=None)


def _centre(part: Actuator | Force | Finger, layout: Layout) -> tuple[float, float]:
    (left, bottom), (x, y) = layout.corner(part.region) if part.region else (0.0, 0.0), part.centre
    return left + x, bottom + y


def _check_placed(at: str, part: Actuator | Force, layout: Layout) -> None:
    """Refuse a patch or a force that leaves its region."""
    size = (part.size[0], part.size[1]) if part.size else (0.0, 0.0)
    box = _box(_centre(part, layout), size)
    solids = {name for name, cell in layout.cells.items() if cell.solid is not None}
    others = layout.cells.keys() - solids if isinstance(part, Force) else set()
    on = {part.region} if part.region else {*layout.regions, *others}
    names = [layout.at(tile) for tile in layout.under(box)]
    is_point = box[0] == box[2]  # a point may lie on the border of its region
    if (any if is_point else all)(name in on for name in names) and solids.isdisjoint(names):
        return
    other = next((name for name in names if name is not None and name not in on), None)
    if other is None:
        cause = "it reaches beyond the plate"
    else:
        kind = "across cells of the lattice" if other in layout.cells else "onto the region"
        cause = f'it reaches {kind} "{other}"'
    where = f'"{part.region}"' if part.region else "the plate" if others else "one region of plain plate"
    around = f'the rectangle around "{part.region}"' if part.region else "the plate"
    raise _refused(
        "out-of-range",
        f"{at}.centre",
        _position_text(part.centre),
        f"a position at which all of it lies on {where}",
        cause,
        f"move it, or make it smaller; its centre is relative to the lower left corner of {around}",
    )


def _check_finger(finger: Finger, layout: Layout) -> None:
    """Refuse a disc that reaches beyond the plate."""
    (x, y), radius = _centre(finger, layout), 0.5 * finger.diameter
    for tile in layout.under(_box((x, y), (finger.diameter, finger.diameter))):
        i, j = tile
        if not layout.at(tile) and _distance(x, y, _bounds(layout, i, j)) < radius * (1 - CLOSE):
            raise _refused(
                "out-of-range",
                "plate.finger.centre", _position_text(finger.centre),
                "a position at which the whole disc lies on the plate",
                f"the disc of {format_quantity(finger.diameter, 'm')} reaches beyond the plate",
                "move it inwards, or choose a smaller diameter",
            )  # fmt: skip


def _bounds(layout: Layout, i: int, j: int) -> Rectangle:
    """Rectangle of a tile; a tile beyond the map is unbounded outwards."""
    x, y = (-math.inf, *layout.x, math.inf), (-math.inf, *layout.y, math.inf)
    return x[j + 1], y[i + 1], x[j + 2], y[i + 2]


def _distance(x: float, y: float, box: Rectangle) -> float:
    left, bottom, right, top = box
    return math.hypot(max(left - x, 0.0, x - right), max(bottom - y, 0.0, y - top))


def _box(centre: tuple[float, float], size: tuple[float, float]) -> Rectangle:
    (x, y), (width, height) = centre, size
    return x - 0.5 * width, y - 0.5 * height, x + 0.5 * width, y + 0.5 * height


def _check_apart(at: str, first: Actuator, second: Actuator, layout: Layout) -> None:
    (xs, ys), (xo, yo) = first.centre, second.centre
    close = CLOSE * max(first.size)
    apart = (
        abs(xs - xo) > 0.5 * (first.size[0] + second.size[0]) - close
        or abs(ys - yo) > 0.5 * (first.size[1] + second.size[1]) - close
    )
    if not apart:
        raise _refused(
            "conflict", f"{at}.centre", f'a patch that overlaps "{second.name}"', "patches side by side",
            "two patches would overlap", "move one of them",
        )  # fmt: skip


def _called(table: str, number: int, part: Actuator | Force) -> str:
    return f'plate.{table}[{number}] "{part.name}"'


def _position_text(centre: tuple[float, float]) -> str:
    return " and ".join(format_quantity(value, "m") for value in centre)


def _refused(code: str, at: str, given: str, allowed: str, cause: str, next_step: str) -> StudyError:
    return StudyError(code, argument=at, given=given, allowed=allowed, cause=cause, next_step=next_step)


def check_carriers(plate: Plate, carrier: float | None) -> None:
    """Refuse a plate whose drives all have a carrier other than the study's, Hz.

    Raises
    ------
    StudyError : the argument is ``carrier``
    """
    own = [drive.carrier for drive in plate.drives if drive.carrier is not None]
    if own and (carrier is None or (len(own) == len(plate.drives) and carrier not in own)):
        every = ", ".join(format_quantity(frequency, "Hz") for frequency in dict.fromkeys(own))
        raise _refused(
            "conflict", "carrier", "nothing" if carrier is None else format_quantity(carrier, "Hz"),
            f"the frequency of a drive: {every}",
            "results are about the study's carrier, and no actuator or force has it",
            f'write carrier = "{format_quantity(own[0], "Hz")}" at the top of the study',
        )  # fmt: skip
