"""Unit cell of a lattice: a plate of some thickness, with pillars, discs or other solids on it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import product
from typing import Annotated, ClassVar

import numpy as np

from haptonic.arrays import Array
from haptonic.brillouin import IrreducibleZone
from haptonic.cell.blocks import VOID
from haptonic.cell.checks import check_cell
from haptonic.cell.disc import Disc
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.sites import (
    EMPTY,
    MOST_DISCS,
    MOST_SITES,
    SITES,
    Plate,
    Site,
    SiteMap,
    placed_tiles,
    polygons,
    shares_of,
    site_map,
    site_tile,
    steps_between,
)
from haptonic.cell.solid import Solid, SolidPeriod
from haptonic.cell.stack import Feature, Stack
from haptonic.cell.tile import FreeEdge, PlacedTile, TileShape
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
    setting,
    size,
    unusual_beside,
    with_numbers,
)
from haptonic.lattice import HALF_TURN, Lattice, Operation, PointGroup
from haptonic.materials import GIVEN, Material, is_symmetry
from haptonic.names import listed
from haptonic.units import format_quantity

# of the pitch: usual ratios of sizes, for cells of any size; a wrong prefix is a factor of 1000
USUAL_THICKNESS, USUAL_HEIGHT, USUAL_DIAMETER = (0.01, 3.0), (0.02, 8.0), (0.03, 1.0)


@described("cell", GeometryError)
class UnitCell(TileShape):
    """One period of the plate between z = 0 and z = ``thickness``, with pillars or discs on its sites.

    With pillars or discs on both ``faces``, those below are the mirror images of those above.

    A cell of one site, in its middle, is a single tile; a cell of several sites consists of their `tiles`.

    Raises
    ------
    GeometryError : sizes that are not positive, a pillar that is too wide for the period or its tile, sites
        that contradict each other, or a material that half a turn about the normal changes
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
        **meant("pillar", "resonator", "post"),
        **absent(
            "inclusion",
            cause="an inclusion is a disc of another material through the plate",
            next_step="write a [[cell.disc]] table with its diameter and material",
        ),
        **meant("site", "sites", "pillars"),
        **meant("disc", "discs", "layer", "feature"),
        **absent(
            "hole", "holes", "void", "slot",
            cause="a hole is an empty disc through the plate",
            next_step="write a [[cell.disc]] table with its diameter and empty = true",
        ),
        **absent(
            "coating", "glue", "cap",
            cause="coatings, layers of glue and caps are discs",
            next_step="write a [[cell.disc]] table for each part, with diameter, low, high and material",
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

    lattice: Annotated[Lattice, INLINE] = needed("Lattice on which the cells repeat.")
    thickness: Annotated[float, size(10e-9, 20e-3)] = needed(
        "Thickness without the pillar.", title="Plate thickness", examples=["1.5 mm"]
    )
    material: Annotated[Material, GIVEN, TOP] = needed(
        "A built-in name or constants, for the plate and for every pillar without a material of its own."
    )
    pillar: Pillar | None = setting(
        None, "Pillar on every site, if the sites have no tables; without pillars the cell is plain plate."
    )
    site: tuple[Site, ...] = setting(
        (),
        "Sites with pillars of their own; in order, where the lattice is named after them.",
        title="Sites",
        max_length=MOST_SITES,
    )
    faces: Faces = setting(
        "one",
        "Faces with pillars; with both, each has its image in the plate's middle plane, and every wave is "
        "symmetric or antisymmetric about it.",
        title="Faces with pillars",
    )
    disc: tuple[Disc, ...] = setting(
        (),
        "Discs on every site, in place of a pillar. A later disc replaces an earlier one where they overlap.",
        title="Discs",
        max_length=MOST_DISCS,
    )
    solid: Solid | None = setting(
        None, "One period of the plate from a CAD file or a mesh, in place of pillars and discs."
    )

    def __post_init__(self) -> None:
        check_cell(self)

    def doubtful(self) -> dict[str, str]:
        """Sentences, by path below the cell, on sizes that are unusual for its pitch."""
        pitch = self.lattice.pitch
        words = f"for a pitch of {format_quantity(pitch, 'm')}"
        sizes = {"thickness": (self.thickness, USUAL_THICKNESS)}
        for path, sites in self.pillar_tables.items():
            pillar, below = self.pillars[sites[0]], path.removeprefix("cell.")
            assert pillar is not None
            sizes[f"{below}.diameter"] = (pillar.diameter, USUAL_DIAMETER)
            sizes[f"{below}.height"] = (pillar.height, USUAL_HEIGHT)
        discs = self.discs.items()
        sizes |= {f"{path}.diameter": (disc.diameter, USUAL_DIAMETER) for path, disc in discs}
        return {path: unusual_beside(value, "m", shares, pitch, words)
                for path, (value, shares) in sizes.items()}  # fmt: skip

    @property
    def is_simple(self) -> bool:
        """True if the cell has one site, in its middle, and therefore is a tile itself."""
        return not self.site and self.lattice.name not in SITES

    @cached_property
    def shares(self) -> Array:
        """(n, 2) positions of the sites in shares of the translations, including empty sites."""
        return np.zeros((1, 2)) if self.is_simple else shares_of(self.site, self.lattice)

    @cached_property
    def pillars(self) -> tuple[Pillar | None, ...]:
        """The pillar of each site, None for an empty one or one with discs."""
        return tuple(feature if isinstance(feature, Pillar) else None for feature in self.features)

    @cached_property
    def stack(self) -> Stack | None:  # type: ignore[override]
        """The discs on every site, if the sites have no tables; None without discs."""
        return self._stack(self.disc)

    def _stack(self, discs: tuple[Disc, ...]) -> Stack | None:
        return Stack(discs, self.thickness, self.is_mirrored) if discs else None

    def pillar_path(self, number: int) -> str:
        """Path of the table in a study that gives the pillar of a site, counted from 0."""
        return f"{self.table_of(number)}pillar"

    def table_of(self, number: int) -> str:
        """Path of the table that gives the feature of a site, counted from 0, with a dot at its end."""
        return f"cell.site[{number + 1}]." if self.site else "cell."

    @property
    def materials(self) -> dict[str, Material]:
        """Materials of the plate, and of pillars and discs with a material, by their key in [cell]."""
        solids = {"material": self.material}
        for table, (number, *_) in self.pillar_tables.items():
            pillar = self.pillars[number]
            if pillar is not None and pillar.material is not None:
                solids[f"{table.removeprefix('cell.')}.material"] = pillar.material
        discs = self.discs.items()
        if self.solid is not None:
            return solids | self.solid.materials
        return solids | {
            f"{path}.material": disc.material for path, disc in discs if disc.material is not None
        }

    @property
    def discs(self) -> dict[str, Disc]:
        """All discs of the study, by the path of their table below [cell]."""
        return {
            f"{table}disc[{number}]": disc
            for table, discs in self.disc_tables.items()
            for number, disc in enumerate(discs, start=1)
        }

    @property
    def disc_tables(self) -> dict[str, tuple[Disc, ...]]:
        """Lists of discs in a study, by the path of their site or cell, below [cell]."""
        lists = {"": self.disc} | {f"site[{n}].": site.disc for n, site in enumerate(self.site, start=1)}
        return {table: discs for table, discs in lists.items() if discs}

    @property
    def loss_factors(self) -> tuple[float, ...]:
        """Loss factors of the cell's materials, ascending, without repetitions."""
        return tuple(sorted({solid.loss_factor for solid in self.materials.values()}))

    @property
    def pillar_tables(self) -> dict[str, list[int]]:
        """Indices, from 0, of the sites whose pillar a table of the study gives, by the table's path."""
        sites_of_table: dict[str, list[int]] = {}
        for number, pillar in enumerate(self.pillars):
            if pillar is not None:
                sites_of_table.setdefault(self.pillar_path(number), []).append(number)
        return sites_of_table

    @property
    def hole_below(self) -> str | None:
        """Path below [cell] of a disc that makes a hole in the lower face; None without a hole."""
        for table, discs in self.disc_tables.items():
            stack = Stack(discs, self.thickness, self.is_mirrored)
            if VOID in stack.grid[stack.in_plate - 1 if self.is_mirrored else 0]:
                number = next(n for n, disc in enumerate(discs, start=1) if disc.empty)
                return f"{table}disc[{number}]"
        return None

    def ways(self, numbers: Iterable[int]) -> Iterator[float]:
        """Widths of the gaps between parts above the plate, of some sites and of their neighbours, m."""
        borders = [None if feature is None else feature.raised for feature in self.features]
        for number, (beside, other) in product(numbers, enumerate(borders)):
            if (border := borders[number]) is not None and other is not None:
                away = steps_between(self.shares[[number, beside]], self.vectors)
                yield float(border.gap_to(other, away).min())

    @cached_property
    def features(self) -> tuple[Feature | None, ...]:
        """The pillar or the stack of discs of each site, None for an empty one."""
        if self.is_simple:
            return (self.feature,)
        named, empty = (len(sites.get(self.lattice.name, ())) for sites in (SITES, EMPTY))
        given = [site.pillar or self._stack(site.disc) for site in self.site] or [self.feature] * named
        return (*given, *[None] * empty)

    @property
    def parts(self) -> str:
        """Kinds of features on the sites, as text: pillars, discs or both; or solids."""
        kinds = dict.fromkeys(feature.noun for feature in self.features if feature is not None)
        return "solids" if self.solid else listed([f"{kind}s" for kind in kinds])

    @property
    def has_features(self) -> bool:
        """True unless the cell is plain plate."""
        return any(self.features) or self.solid is not None

    @cached_property
    def solid_period(self) -> SolidPeriod:
        """The solids of the CAD file as one period of the plate; for errors see `Solid.period`."""
        assert self.solid is not None
        group = self.lattice.point_group
        turns = [group.turn(operation)[:2, :2] for operation in group.operations]
        return self.solid.period(self.corners, self.vectors, self.thickness, np.array(turns))

    @cached_property
    def tiles(self) -> tuple[PlacedTile, ...]:
        """Tiles of the cell, one for each site; equal tiles are the same object."""
        if self.is_simple:
            return (PlacedTile(self, np.eye(3), np.zeros(2)),)
        return placed_tiles(
            self.shares @ self.lattice.vectors,
            self.outlines,
            self.features,
            self._plate,
            self.site_map(HALF_TURN),
        )

    def tile_like(self, number: int, placed: PlacedTile) -> TileShape:
        """The tile of a site in the axes of another tile, with corners numbered like those of the other."""
        if self.is_simple:
            return self
        outline, turn = self.outlines[number], placed.turn
        away = np.linalg.norm(outline @ turn[:2, :2] - placed.tile.corners[0], axis=1)
        outline = np.roll(outline, -int(away.argmin()), axis=0)
        return site_tile(outline, turn, self._plate, self.features[number])

    @property
    def _plate(self) -> Plate:
        return self.thickness, self.material, self.faces

    @cached_property
    def outlines(self) -> list[Array]:
        """(sides, 2) polygon about each site, nearer to it than to any other site, m."""
        return polygons(self.shares, self.lattice)

    @property
    def vectors(self) -> Array:
        """(2, 2) translations, as rows, m."""
        return self.lattice.vectors

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """Free edges of the cell: none."""
        return ()

    @cached_property
    def area(self) -> float:
        """Area of the cell, m^2."""
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
        return self.lattice.inradius if self.is_simple else min(placed.tile.inradius for placed in self.tiles)

    @cached_property
    def point_group(self) -> PointGroup:
        """Rotations and mirrors that leave lattice, pillars and material unchanged.

        With several sites, a translation may belong to an operation, see `site_map`.
        """
        group = self.lattice.point_group
        operations = [op for op in group.operations if self.site_map(op) is not None]
        if self.solid is not None:
            operations = [op for op, keeps in zip(operations, self.solid_period.kept, strict=True) if keeps]
        return PointGroup(group.vectors, tuple(operations)).kept(
            lambda turn: all(is_symmetry(solid.stiffness, turn) for solid in self.materials.values())
        )

    def site_map(self, operation: Operation) -> SiteMap | None:
        """Map of the sites by an operation of the lattice; None if a site would meet a different one."""
        return site_map(self.shares, self.features, operation, self.lattice.point_group.turn(operation))

    @cached_property
    def zone(self) -> IrreducibleZone:
        """Part of the Brillouin zone that these operations and time reversal do not repeat."""
        return IrreducibleZone.of(self.lattice, self.point_group)

    def scaled(self, factor: float) -> UnitCell:
        """A copy with every length multiplied by ``factor``."""
        return replace(
            self,
            lattice=self.lattice.scaled(factor),
            thickness=self.thickness * factor,
            pillar=self.pillar and self.pillar.scaled(factor),
            disc=tuple(disc.scaled(factor) for disc in self.disc),
            site=tuple(site.scaled(factor) for site in self.site),
        )

    def numbers(self) -> dict[str, float]:
        """Every number of the cell, in SI units, by its path in a study: ``cell.pillar.diameter``."""
        return numbers(self, "cell.")

    def with_numbers(self, changes: Mapping[str, float]) -> UnitCell:
        """A copy with some of its `numbers` changed, all at once.

        Raises
        ------
        GeometryError : sizes that do not form a body
        """
        return with_numbers(self, changes, "cell.")

    def without_pillar(self) -> UnitCell:
        """Plain plate with the same period and sites."""
        site = tuple(replace(place, pillar=None, disc=()) for place in self.site)
        return replace(self, pillar=None, disc=(), solid=None, site=site)
