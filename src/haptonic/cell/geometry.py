"""The unit cell in the words of the field: a plate of some thickness, pillars on it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import product
from typing import Annotated, ClassVar

import numpy as np

from haptonic.arrays import Array
from haptonic.brillouin import IrreducibleZone
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.sectors import unmeshed
from haptonic.cell.sites import (
    MOST_SITES,
    SITES,
    Plate,
    Site,
    SiteMap,
    apart,
    check_shares,
    check_tiles,
    placed_tiles,
    polygons,
    shares_of,
    site_map,
    site_tile,
)
from haptonic.cell.tile import HALF_TURNED, FreeEdge, PlacedTile, TileShape
from haptonic.errors import GeometryError
from haptonic.fields import (
    INLINE,
    TOP,
    Aliases,
    absent,
    described,
    meant,
    needed,
    numbers,
    problem,
    setting,
    size,
    unusual_beside,
    with_numbers,
)
from haptonic.lattice import HALF_TURN, Lattice, Operation, PointGroup
from haptonic.materials import GIVEN, Material, is_symmetry
from haptonic.units import format_quantity

LEAST_CLEARANCE = 0.01  # of the pitch, between a pillar and the nearest side of its cell
# of the pitch: usual ratios of sizes, whatever the size of the cell; a slip of a prefix is a factor of 1000
USUAL_THICKNESS, USUAL_HEIGHT, USUAL_DIAMETER = (0.01, 3.0), (0.02, 8.0), (0.03, 1.0)


@described("cell", GeometryError)
class UnitCell(TileShape):
    """One period of the plate between z = 0 and z = ``thickness``, on which pillars stand.

    With pillars on both ``faces`` those on z = 0 are the images of the others in the middle plane.

    A cell of one site, in its middle, is a tile itself; one of several consists of their `tiles`.

    Raises
    ------
    GeometryError : sizes that are not positive, a pillar that does not fit into the period or its tile, sites
        that do not fit together, or a material that half a turn about the normal does not leave as it is
    """

    aliases: ClassVar[Aliases] = {
        **meant("pitch", "a", "period", "lattice_constant", "spacing", "pitch_x", "size"),
        **meant("lattice", "type", "kind", "symmetry", "form"),
        **meant("thickness", "t", "e", "plate_thickness"),
        **meant(
            "thickness", "height", "h",
            cause="the plate has a thickness; a height belongs to a pillar",
            next_step='write "thickness", or move it to [cell.pillar]',
        ),
        **meant("pillar", "resonator", "inclusion", "post"),
        **meant("site", "sites", "pillars"),
        **absent(
            "hole", "holes", "void", "slot",
            cause="a cell is a plate with pillars; holes through the plate are not computed here",
            next_step="leave this key out",
        ),
        **absent(
            "width", "size_x", "size_y",
            cause="the size of a cell follows from its lattice",
            next_step='write "pitch", and "pitch_y" for a rectangular lattice',
        ),
        **absent(
            "radius", cause="it belongs to the pillar of the cell",
            next_step="write diameter in [cell.pillar]; it is twice a radius",
        ),
    }  # fmt: skip

    lattice: Annotated[Lattice, INLINE] = needed("How the cells repeat.")
    thickness: Annotated[float, size(10e-9, 20e-3)] = needed(
        "Without the pillar.", title="Plate thickness", examples=["1.5 mm"]
    )
    material: Annotated[Material, GIVEN, TOP] = needed(
        "A built-in name or constants, for the plate and for every pillar without a material of its own."
    )
    pillar: Pillar | None = setting(
        None, "On every site, if the sites have no tables; without any the cell is plain plate."
    )
    site: tuple[Site, ...] = setting(
        (),
        "Where pillars of their own stand; in order, where the lattice is named after them.",
        title="Sites",
        max_length=MOST_SITES,
    )
    faces: Faces = setting(
        "one",
        "That pillars stand on; on both each has its image in the plate's middle plane, and every wave is "
        "symmetric or antisymmetric about it.",
        title="Faces with pillars",
    )

    def __post_init__(self) -> None:
        # lattices and outlines always have it; the rest of the group is left until it is asked for
        for at, solid in self.materials.items():
            if not is_symmetry(solid.stiffness, HALF_TURNED):
                raise problem(
                    "unsupported",
                    solid.name,
                    "a material that half a turn about the plate's normal leaves as it is",
                    "its constants couple motion in the plane with motion out of it",
                    "turn the material so that one of its axes is normal to the plate",
                    at=at,
                )
        if not self.is_simple:
            self._check_sites()
            return
        if self.pillar is not None and self.clearance < LEAST_CLEARANCE * self.lattice.pitch:
            raise _too_wide(self.pillar, self.room - LEAST_CLEARANCE * self.lattice.pitch)
        if (parts := unmeshed(self)) is not None:
            raise problem("unsupported", **parts, at="pillar.section")

    def _check_sites(self) -> None:
        if self.site and self.pillar is not None:
            raise problem(
                "conflict",
                "a pillar beside [[cell.site]]",
                "pillars of the sites, or one for all of them",
                "the pillar of a site was given twice",
                "put it into the tables of the sites, as [cell.site.pillar], or leave these out",
                at="pillar",
            )
        check_shares(self.site, self.lattice.given, self.lattice.name)
        shares = self.shares
        least = 2 * LEAST_CLEARANCE * self.lattice.pitch
        if (pair := apart(shares, self.lattice.vectors, least)) is not None:
            raise problem(
                "repeated",
                f"the place of site[{pair[0] + 1}]",
                f"a place more than {format_quantity(least, 'm', digits=3)} from every other site",
                "two sites are one place of the lattice, or nearly",
                "move one of them, or leave it out",
                at=f"site[{pair[1] + 1}].at",
            )
        tiles = self.tiles
        check_tiles(tiles, len(self.site), self.lattice.pitch, LEAST_CLEARANCE * self.lattice.pitch)

    def doubtful(self) -> dict[str, str]:
        """Words, by path below the cell, on sizes that are unusual for its pitch."""
        pitch = self.lattice.pitch
        words = f"for a pitch of {format_quantity(pitch, 'm')}"
        sizes = {"thickness": (self.thickness, USUAL_THICKNESS)}
        for path, sites in self.pillar_tables.items():
            pillar, below = self.pillars[sites[0]], path.removeprefix("cell.")
            assert pillar is not None
            sizes[f"{below}.diameter"] = (pillar.diameter, USUAL_DIAMETER)
            sizes[f"{below}.height"] = (pillar.height, USUAL_HEIGHT)
        return {path: unusual_beside(value, "m", shares, pitch, words)
                for path, (value, shares) in sizes.items()}  # fmt: skip

    @property
    def is_simple(self) -> bool:
        """Whether the cell has one site, in its middle, and so is a tile itself."""
        return not self.site and self.lattice.name not in SITES

    @cached_property
    def shares(self) -> Array:
        """(n, 2) places of the sites in shares of the translations, empty ones included."""
        if self.is_simple:
            return np.zeros((1, 2))
        return shares_of(self.site, self.lattice)

    @cached_property
    def pillars(self) -> tuple[Pillar | None, ...]:
        """The pillar of each site, None for an empty one."""
        if self.is_simple:
            return (self.pillar,)
        named = len(SITES.get(self.lattice.name, ()))
        own = [one.pillar for one in self.site] or [self.pillar] * named
        return (*own, *[None] * (len(self.shares) - len(own)))

    def pillar_path(self, number: int) -> str:
        """Of the table in a study that gives the pillar of a site, counted from 0."""
        return f"cell.site[{number + 1}].pillar" if self.site else "cell.pillar"

    @property
    def materials(self) -> dict[str, Material]:
        """Materials of the plate and of pillars that have their own, by the path of the key in [cell]."""
        solids = {"material": self.material}
        for table, (number, *_) in self.pillar_tables.items():
            pillar = self.pillars[number]
            if pillar is not None and pillar.material is not None:
                solids[f"{table.removeprefix('cell.')}.material"] = pillar.material
        return solids

    @property
    def loss_factors(self) -> tuple[float, ...]:
        """Loss factors of the cell's materials, ascending, equal ones once."""
        return tuple(sorted({solid.loss_factor for solid in self.materials.values()}))

    @property
    def pillar_tables(self) -> dict[str, list[int]]:
        """Numbers, from 0, of the sites whose pillar a table of the study gives, by the table's path."""
        found: dict[str, list[int]] = {}
        for number, pillar in enumerate(self.pillars):
            if pillar is not None:
                found.setdefault(self.pillar_path(number), []).append(number)
        return found

    def ways(self, numbers: Iterable[int]) -> Iterator[float]:
        """Widths of the ways between the pillars of some sites and their neighbours, m."""
        steps = np.array(list(product((-1, 0, 1), repeat=2)))
        for number, (beside, other) in product(numbers, enumerate(self.pillars)):
            pillar = self.pillars[number]
            if pillar is not None and other is not None:
                away = (self.shares[beside] - self.shares[number] + steps) @ self.vectors
                yield pillar.gap_to(other, away[away.any(axis=1)])

    @property
    def has_pillars(self) -> bool:
        """Whether anything stands on the plate."""
        return any(self.pillars)

    @cached_property
    def tiles(self) -> tuple[PlacedTile, ...]:
        """What the cell consists of, a tile for each site; equal ones are one object."""
        if self.is_simple:
            return (PlacedTile(self, np.eye(3), np.zeros(2)),)
        return placed_tiles(
            self.shares @ self.lattice.vectors,
            self.outlines,
            self.pillars,
            self._plate,
            self.site_map(HALF_TURN),
        )

    def tile_like(self, number: int, placed: PlacedTile) -> TileShape:
        """The tile of a site in the axes of another, of whose corners its own are numbered alike."""
        if self.is_simple:
            return self
        outline, turn = self.outlines[number], placed.turn
        away = np.linalg.norm(outline @ turn[:2, :2] - placed.tile.corners[0], axis=1)
        outline = np.roll(outline, -int(away.argmin()), axis=0)
        return site_tile(outline, turn, self._plate, self.pillars[number])

    @property
    def _plate(self) -> Plate:
        return self.thickness, self.material, self.faces

    @cached_property
    def outlines(self) -> list[Array]:
        """(sides, 2) what lies nearer to each site than to any other, about the site, m."""
        return polygons(self.shares, self.lattice)

    @property
    def vectors(self) -> Array:
        """(2, 2) translations, as rows, m."""
        return self.lattice.vectors

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """None: it goes on all around."""
        return ()

    @cached_property
    def area(self) -> float:
        """m^2."""
        return self.lattice.area

    @property
    def corners(self) -> Array:
        assert self.is_simple, "a cell of several sites has a polygon for each"
        return self.lattice.corners

    @property
    def extent(self) -> float:
        return float(np.linalg.norm(self.lattice.vectors, axis=1).max())

    @property
    def elongation(self) -> float:
        sides = np.linalg.norm(self.lattice.vectors, axis=1)
        return float(sides.max() / sides.min())

    @cached_property
    def inradius(self) -> float:
        """Distance from the centre of the cell, or from a site, to the nearest side of its tile, m."""
        return self.lattice.inradius if self.is_simple else min(one.tile.inradius for one in self.tiles)

    @cached_property
    def point_group(self) -> PointGroup:
        """The turns and mirrors that leave lattice, pillars and material as they are.

        Where there are several sites a move may belong to them, see `site_map`.
        """
        group = self.lattice.point_group
        kept = [op for op in group.operations if self.site_map(op) is not None]
        return PointGroup(group.vectors, tuple(kept)).kept(
            lambda turn: is_symmetry(self.material.stiffness, turn)
        )

    def site_map(self, operation: Operation) -> SiteMap | None:
        """Where an operation of the lattice takes the sites; None if not to others that are alike."""
        return site_map(self.shares, self.pillars, operation, self.lattice.point_group.turn(operation))

    @cached_property
    def zone(self) -> IrreducibleZone:
        """The part of the Brillouin zone that these operations and time reversal do not repeat."""
        return IrreducibleZone.of(self.lattice, self.point_group)

    def scaled(self, factor: float) -> UnitCell:
        """The same cell with every length multiplied by ``factor``."""
        return replace(
            self,
            lattice=self.lattice.scaled(factor),
            thickness=self.thickness * factor,
            pillar=self.pillar and self.pillar.scaled(factor),
            site=tuple(one.scaled(factor) for one in self.site),
        )

    def numbers(self) -> dict[str, float]:
        """Every number of the cell, in SI units, by its path in a study: ``cell.pillar.diameter``."""
        return numbers(self, "cell.")

    def with_numbers(self, changes: Mapping[str, float]) -> UnitCell:
        """The cell with some of its `numbers` changed, all at once.

        Raises
        ------
        GeometryError : sizes that do not make a body
        """
        return with_numbers(self, changes, "cell.")

    def without_pillar(self) -> UnitCell:
        """The plain plate of the same period and sites."""
        return replace(self, pillar=None, site=tuple(replace(one, pillar=None) for one in self.site))


def _text(length: float) -> str:
    return format_quantity(length, "m")


def _too_wide(pillar: Pillar, room: float) -> Exception:
    """A pillar, or its fillet, that is wider than the half-width that there is room for, m."""
    free = "so that a hundredth of the pitch stays free on either side"
    if room <= 0:
        return problem(
            "out-of-range",
            _text(pillar.diameter),
            f"no pillar, {free}",
            "the lattice's translations are nearly parallel, so that its rows nearly meet",
            "turn one of the translations away from the other",
            at="pillar.diameter",
        )
    sharp = replace(pillar, fillet=0.0)
    if pillar.arc is not None and sharp.widest < room:
        most = pillar.fillet * (room - pillar.radius) / (pillar.arc.centre[0] - pillar.radius)
        return problem(
            "out-of-range",
            _text(pillar.fillet),
            f"less than {_text(most)}, {free}",
            "the fillet reaches beyond the cell",
            "choose a smaller radius, a thinner pillar or a larger pitch",
            at="pillar.fillet",
        )
    per_half = pillar.diameter / pillar.radius
    beyond = per_half * (sharp.widest - pillar.radius)
    return problem(
        "out-of-range",
        _text(pillar.diameter) + (f", and {_text(beyond)} more where the pillar is widest" if beyond else ""),
        f"less than {_text(per_half * room - beyond)}, {free}",
        "the pillar is wider than the cell",
        "choose a thinner pillar or a larger pitch",
        at="pillar.diameter",
    )
