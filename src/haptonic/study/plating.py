"""From the [plate] of a study to the plate that is computed with: positions in metres, names resolved."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import accumulate, combinations
from typing import Literal

from haptonic.cell import UnitCell
from haptonic.errors import HaptonicError, StudyError, nearest
from haptonic.materials import Material, PiezoelectricMaterial, library
from haptonic.plate.layout import CLOSE, Layout, Rectangle
from haptonic.plate.parts import Actuator, Bond, Finger, Force, Plate, Support
from haptonic.study.mounting import SIDES, ActuatorSection, ClampSection, FingerSection, ForceSection
from haptonic.study.plate_tables import CHANGEABLE, LATTICE, PlateSection
from haptonic.units import format_quantity, shown


def plate_of(section: PlateSection | None, own: UnitCell) -> Plate:
    """The plate of a study, in SI units.

    Parameters
    ----------
    own : the cell that tiles of the name "lattice" hold

    Raises
    ------
    StudyError : the study has no plate, or one that cannot be built; the argument is the path of the key
    """
    if section is None:
        raise _refused(
            "plate", "nothing", "a [plate] table with map and tiles",
            "the study describes a lattice, and no plate that is made of it",
            'add map = ["AAA"] to [plate] and A = "lattice" to [plate.tiles]; `haptonic keys` lists the rest',
        )  # fmt: skip
    layout = _layout(section, own)
    _check_grid(layout, section.response.grid)
    actuators = [(_called("actuator", i, one), one) for i, one in enumerate(section.actuator, start=1)]
    forces = [(_called("force", i, one), one) for i, one in enumerate(section.force, start=1)]
    patches = [_actuator(at, one, layout) for at, one in actuators]
    for (place, first), (_, second) in combinations(
        zip([at for at, _ in actuators], patches, strict=True), 2
    ):
        _check_apart(place, first, second, layout)
    loss = own.material.loss_factor if section.loss_factor is None else section.loss_factor
    return Plate(
        layout,
        tuple(_supports(section, layout)),
        tuple(patches),
        tuple(_force(at, one, layout) for at, one in forces),
        _finger(section.finger, layout) if section.finger else None,
        loss,
    )


def built_in(name: str, at: str, *, piezoelectric: bool = False) -> Material:
    """A material of the library, whatever the case of its name and the blanks in it.

    Raises
    ------
    StudyError : no such material, or one that is not piezoelectric where it has to be
    """
    known = {
        key: solid
        for key, solid in library().items()
        if not piezoelectric or isinstance(solid, PiezoelectricMaterial)
    }
    key = re.sub(r"[\s_-]+", "-", name.strip().lower())
    if key in known:
        return known[key]
    guess = nearest(key, known)
    raise _refused(
        f"{at}.material", shown(name), f"one of {', '.join(known)}",
        "it is not piezoelectric" if key in library() else "the library does not hold this material",
        f'write "{guess}"' if guess else "choose one of them",
    )  # fmt: skip


def _layout(section: PlateSection, own: UnitCell) -> Layout:
    tiles = section.grid
    cells = {name: cell for name, cell in _lattices(section, own) if name in section.tiles.values()}
    for letter, name in section.tiles.items():
        if name in cells and cells[name].pillar is None:
            raise _refused(
                f"plate.tiles.{letter}", shown(name), "a lattice whose cell has a pillar",
                "the cell of this study is plain plate", f'add [cell.pillar], or write {letter} = "plain"',
            )  # fmt: skip
    columns = [{row[j] or "" for row in tiles} for j in range(len(tiles[0]))]
    rows = [{name or "" for name in row} for row in tiles]
    for cell in cells.values():
        cell.lattice.check_rectangular("a plate")
    pitches = {name: (cell.lattice.a1[0], cell.lattice.a2[1]) for name, cell in cells.items()}
    x = _sizes("column", columns, {name: pitch[0] for name, pitch in pitches.items()}, section.widths,
               own.lattice.a1[0], "plate.widths")  # fmt: skip
    y = _sizes("row", rows, {name: pitch[1] for name, pitch in pitches.items()},
               section.heights, own.lattice.a2[1], "plate.heights")  # fmt: skip
    return Layout(tiles, _summed(x), _summed(y), cells, own.thickness, own.material)


def _summed(sizes: Iterable[float]) -> tuple[float, ...]:
    """Positions of the lines between tiles, each rounded once."""
    return tuple(float(line) for line in accumulate(map(Fraction, sizes), initial=Fraction(0)))


def _lattices(section: PlateSection, own: UnitCell) -> Iterator[tuple[str, UnitCell]]:
    yield LATTICE, own
    known = own.numbers()
    for i, one in enumerate(section.cell, start=1):
        at = f'plate.cell[{i}] "{one.name}".change'
        for path in one.change:
            if path not in known:
                raise _refused(
                    at, path, f"one of {', '.join(each for each in CHANGEABLE if each in known)}",
                    "this study does not give it", "give it in [cell] first, or leave it out here",
                )  # fmt: skip
        try:
            yield one.name, own.with_numbers(one.change)
        except HaptonicError as error:
            given = ", ".join(
                f"{path} = {format_quantity(value, one.units[path])}" for path, value in one.change.items()
            )
            raise _refused(
                at, given, f"a cell that can be built; {error.argument}: {error.allowed}",
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
    """Width of every column, or height of every row: a lattice's pitch, or what its regions say."""
    free: set[str] = set()  # regions with a line of their own
    for number, names in enumerate(lines, start=1):
        lattices = {name: pitches[name] for name in names if name in pitches}
        place = f"{what} {number}" + (" from below" if what == "row" else "")
        asked = lattices or {name: given[name] for name in names if name in given}
        free |= set() if lattices else asked.keys()
        if asked and max(asked.values()) - min(asked.values()) > CLOSE * max(asked.values()):
            sizes = (f'{format_quantity(size, "m")} of "{name}"' for name, size in sorted(asked.items()))
            raise _refused(
                "plate.map" if lattices else at, f"in {place}: {' and '.join(sizes)}",
                f"one size for the whole {what}",
                "two lattices of different pitch meet there" if lattices else "two regions meet there",
                f"draw them in {what}s of their own" + ("" if lattices else ", or give them one size"),
            )  # fmt: skip
        yield next(iter(asked.values()), default)
    for name in given:
        if name not in free:
            raise _refused(
                f"{at}.{name}", format_quantity(given[name], "m"),
                f"a region that has a {what} without a lattice",
                f"all {what}s of it hold cells of a lattice, whose pitch they have", "leave it out",
            )  # fmt: skip


def _check_grid(layout: Layout, grid: float) -> None:
    shorter = min(layout.x[-1], layout.y[-1])
    if grid > shorter:
        raise _refused(
            "plate.response.grid", format_quantity(grid, "m"), f"at most {format_quantity(shorter, 'm')}",
            "it is wider than the plate", f'write grid = "{format_quantity(0.05 * shorter, "m")}"',
        )  # fmt: skip


def _supports(section: PlateSection, layout: Layout) -> Iterator[Support]:
    edges = section.edges
    for side in SIDES:
        hold: Literal["free", "clamped", "simple", "spring"] = getattr(edges, side)
        if hold == "spring":
            yield Support(side, hold, stiffness=edges.spring, loss_factor=edges.loss_factor)
        elif hold != "free":
            yield Support(side, hold)
    if section.clamp:
        yield _corners(section.clamp, layout)


def _corners(clamp: ClampSection, layout: Layout) -> Support:
    ends = ((i, j) for i in (0, layout.rows - 1) for j in (0, layout.columns - 1))
    boxes = [layout.bounds(tile) for tile in ends if layout.at(tile)]
    room = min((min(right - left, top - bottom) for left, bottom, right, top in boxes), default=0.0)
    if clamp.corners > room * (1 + CLOSE):
        raise _refused(
            "plate.clamp.corners", format_quantity(clamp.corners, "m"),
            f"at most {format_quantity(room, 'm')}, the shortest side of the tiles at the corners"
            if boxes else "a plate with a tile at one of the four corners of its map",
            "the held part would reach beyond the outermost tile" if boxes else "the corners are cut out",
            "choose a shorter one" if boxes else "remove [plate.clamp], and hold the plate at [plate.edges]",
        )  # fmt: skip
    if clamp.spring is None:
        return Support("corners", "clamped", length=clamp.corners)
    return Support("corners", "spring", clamp.corners, clamp.spring, clamp.loss_factor)


def _actuator(at: str, one: ActuatorSection, layout: Layout) -> Actuator:
    centre = _centre(one, layout)
    _check_lies_on(at, one.region, layout, _box(centre, (one.size[0], one.size[1])))
    solid = built_in(one.material, at, piezoelectric=True)
    assert isinstance(solid, PiezoelectricMaterial)
    glue = one.bond
    bond = Bond(glue.thickness, built_in(glue.material, f"{at}.bond")) if glue else None
    return Actuator(one.name, centre, one.size, solid, bond, _phasor(one.voltage, one.phase))


def _force(at: str, one: ForceSection, layout: Layout) -> Force:
    centre = _centre(one, layout)
    _check_lies_on(at, one.region, layout, _box(centre, one.size or (0.0, 0.0)))
    return Force(one.name, centre, one.size, _phasor(one.force, one.phase))


def _phasor(amplitude: float, phase: float) -> complex:
    """Amplitude times exp(i phase); quarter turns, such as antiphase, are exact."""
    quarters = round(phase / (0.5 * math.pi))
    if abs(phase - quarters * 0.5 * math.pi) < 1e-12:
        return amplitude * (1, 1j, -1, -1j)[quarters % 4]
    return cmath.rect(amplitude, phase)


def _finger(one: FingerSection, layout: Layout) -> Finger:
    (x, y), radius = _centre(one, layout), 0.5 * one.diameter
    for tile in layout.under(_box((x, y), (one.diameter, one.diameter))):
        i, j = tile
        if not layout.at(tile) and _distance(x, y, _bounds(layout, i, j)) < radius * (1 - CLOSE):
            raise _refused(
                "plate.finger.centre", _written(one.centre),
                "a place at which the whole disc lies on the plate",
                f"the disc of {format_quantity(one.diameter, 'm')} reaches beyond the plate",
                "move it inwards, or choose a smaller diameter",
            )  # fmt: skip
    mass = math.inf if one.mass is None else one.mass
    return Finger((x, y), one.diameter, mass, one.stiffness, one.damping)


def _bounds(layout: Layout, i: int, j: int) -> Rectangle:
    """Of a tile, or of what lies beyond the map, without end."""
    x, y = (-math.inf, *layout.x, math.inf), (-math.inf, *layout.y, math.inf)
    return x[j + 1], y[i + 1], x[j + 2], y[i + 2]


def _distance(x: float, y: float, box: Rectangle) -> float:
    left, bottom, right, top = box
    return math.hypot(max(left - x, 0.0, x - right), max(bottom - y, 0.0, y - top))


def _centre(one: ActuatorSection | ForceSection | FingerSection, layout: Layout) -> tuple[float, float]:
    (left, bottom), (x, y) = layout.corner(one.region), one.centre
    return left + x, bottom + y


def _box(centre: tuple[float, float], size: tuple[float, float]) -> Rectangle:
    (x, y), (width, height) = centre, size
    return x - 0.5 * width, y - 0.5 * height, x + 0.5 * width, y + 0.5 * height


def _check_lies_on(at: str, region: str, layout: Layout, box: Rectangle) -> None:
    """Refuse a rectangle that leaves its region; a point may lie on the region's border."""
    names = [layout.at(tile) for tile in layout.under(box)]
    is_point = box[0] == box[2]
    if (any if is_point else all)(name == region for name in names):
        return
    strange = next((name for name in names if name not in (region, None)), None)
    left, bottom = layout.corner(region)
    centre = (0.5 * (box[0] + box[2]) - left, 0.5 * (box[1] + box[3]) - bottom)
    if strange is None:
        cause = "it reaches beyond the plate"
    else:
        kind = "across cells of the lattice" if strange in layout.cells else "onto the region"
        cause = f'it reaches {kind} "{strange}"'
    raise _refused(
        f"{at}.centre", _written(centre), f'a place at which all of it lies on "{region}"', cause,
        "move it, or make it smaller; the centre counts from the lower left corner of the rectangle around "
        f'"{region}"',
    )  # fmt: skip


def _check_apart(at: str, first: Actuator, second: Actuator, layout: Layout) -> None:
    (xs, ys), (xo, yo) = first.centre, second.centre
    close = CLOSE * max(first.size)
    apart = (
        abs(xs - xo) > 0.5 * (first.size[0] + second.size[0]) - close
        or abs(ys - yo) > 0.5 * (first.size[1] + second.size[1]) - close
    )
    if not apart:
        raise _refused(
            f"{at}.centre", f'a patch that overlaps "{second.name}"', "patches side by side",
            "two of them would take the same place", "move one of them",
        )  # fmt: skip


def _called(table: str, number: int, one: ActuatorSection | ForceSection) -> str:
    return f'plate.{table}[{number}] "{one.name}"'


def _written(centre: tuple[float, float]) -> str:
    return " and ".join(format_quantity(value, "m") for value in centre)


def _refused(at: str, given: str, allowed: str, cause: str, next_step: str) -> StudyError:
    return StudyError(argument=at, given=given, allowed=allowed, cause=cause, next_step=next_step)
