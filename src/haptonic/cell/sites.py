"""Sites of a cell, and the tile of each: the polygon nearer to it than to any other site."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Annotated, ClassVar

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.disc import Disc
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.sectors import unmeshed
from haptonic.cell.stack import Feature
from haptonic.cell.tile import HALF_TURNED, PlacedTile, SiteTile, TileShape
from haptonic.errors import GeometryError
from haptonic.fields import Aliases, Quantity, described, meant, problem, setting
from haptonic.lattice import LEAST_SIDE, Lattice, Operation
from haptonic.materials import Material, is_symmetry
from haptonic.translations import SAME

Plate = tuple[float, Material, Faces]  # thickness, m, material, and faces with pillars
SHARE = Quantity("", at_least=0.0, below=1.0, hint="subtract whole translations from it")
PLACE = Quantity("m")
MIRRORS = (np.diag([-1.0, 1.0, 1.0]), np.diag([1.0, -1.0, 1.0]))
MOST_SITES, MOST_DISCS = 12, 12  # of one cell, and of one site
# For a site's tile, distance from the site to its farthest corner, in radii of the circle within: beside
# pillars with neighbours nearer by that factor on one side, elements were turned inside out from 9.9 on.
MOST_POINTED = 8.0
# sites of lattices that are named after them, in shares of a1 and a2, and empty places between them
SITES: dict[str, tuple[tuple[float, float], ...]] = {
    "honeycomb": ((1 / 3, 1 / 3), (2 / 3, 2 / 3)),
    "kagome": ((0.5, 0.0), (0.0, 0.5), (0.5, 0.5)),
    "lieb": ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5)),
}
EMPTY: dict[str, tuple[tuple[float, float], ...]] = {"lieb": ((0.5, 0.5),)}


@described("cell.site", GeometryError, kw_only=True)
class Site:
    """A place in the cell with a pillar or discs.

    ``at`` is in translations of the lattice, ``position`` in metres along x and y, both from a corner of the
    cell that the translations span.
    """

    aliases: ClassVar[Aliases] = meant(
        "position",
        "x",
        "y",
        cause="both coordinates are one value",
        next_step='write position = ["1 mm", "2 mm"]',
    )

    at: tuple[Annotated[float, SHARE], Annotated[float, SHARE]] | None = setting(
        None, 'Shares of the two translations, such as ["1/3", "2/3"]; each from 0 to below 1.', title="Site"
    )
    position: tuple[Annotated[float, PLACE], Annotated[float, PLACE]] | None = setting(
        None, "Position of the site as two lengths along x and y, in place of shares."
    )
    pillar: Pillar | None = setting(
        None, "A site without this table and without discs is empty.", title="Pillar of the site"
    )
    disc: tuple[Disc, ...] = setting(
        (),
        "Discs in place of a pillar. A later disc replaces an earlier one where they overlap.",
        title="Discs of the site",
        max_length=MOST_DISCS,
    )

    def scaled(self, factor: float) -> Site:
        """A copy with every length multiplied by ``factor``."""
        place = self.position and (self.position[0] * factor, self.position[1] * factor)
        discs = tuple(disc.scaled(factor) for disc in self.disc)
        return replace(self, position=place, pillar=self.pillar and self.pillar.scaled(factor), disc=discs)

    def shares(self, vectors: Array) -> Array | None:
        """(2,) position in shares of the translations; None for a lattice that is named after its sites."""
        if self.position is not None:
            position = np.linalg.solve(vectors.T, np.array(self.position))
            rounded = (np.abs(position - np.round(position)) < SAME) & (position < 1)
            return np.where(rounded, np.round(position) % 1.0, position)
        return None if self.at is None else np.array(self.at)


@dataclass(frozen=True, eq=False)
class SiteMap:
    """Map of sites by a rotation or mirror of a cell: s goes to ``image[s]``, ``shift[s]`` translations on.

    move : (2,) translation after the rotation about the origin, in shares of the lattice's
    """

    move: Array
    image: Ints
    shift: Ints


def site_map(
    shares: Array, features: Sequence[Feature | None], operation: Operation, turn: Array
) -> SiteMap | None:
    """Map of sites (n, 2) by an operation of a lattice, perhaps with a translation; None if they differ."""
    turned = shares @ np.array(operation).T
    moves = [np.zeros(2), *(share - turned[0] for share in shares)]
    for move in moves:
        steps = (turned + move)[:, None] - shares
        whole = np.round(steps)
        fits = np.abs(steps - whole).max(axis=2) < SAME
        for s, t in np.argwhere(fits):
            feature, other = features[s], features[t]
            fits[s, t] = feature is other is None or bool(feature and other and feature.is_image(other, turn))
        if fits.any(axis=1).all():
            image = fits.argmax(axis=1)
            return SiteMap(move, image, whole[np.arange(len(shares)), image].astype(np.int64))
    return None


def shares_of(sites: Sequence[Site], lattice: Lattice) -> Array:
    """(n, 2) positions of all sites in shares of the translations, including empty places between them."""
    if lattice.name in SITES:
        return np.array(SITES[lattice.name] + EMPTY.get(lattice.name, ()))
    return np.array([lattice.counted(np.asarray(site.shares(lattice.given))) for site in sites])


def check_shares(sites: Sequence[Site], vectors: Array, lattice: str) -> None:
    """Refuse positions that no cell can have.

    Raises
    ------
    PydanticCustomError : too few or too many positions, one outside the cell, or two equal ones
    """
    named = SITES.get(lattice)
    if named is not None:
        if sites and len(sites) != len(named):
            raise problem(
                "conflict",
                f"{len(sites)} of them",
                f"{len(named)}, one for each site of a {lattice} lattice, or none for equal pillars",
                "a table is missing, or there is one too many",
                "give every site its table; one without a pillar stays empty",
                at="site",
            )
        for number, site in enumerate(sites, start=1):
            if site.at is not None or site.position is not None:
                raise problem(
                    "conflict",
                    "a place",
                    f"none: the sites of a {lattice} lattice are fixed",
                    "the place of a site was given twice",
                    'leave it out, or write lattice = "triangular" or "square"',
                    at=f"site[{number}].{'at' if site.at is not None else 'position'}",
                )
        return
    for number, site in enumerate(sites, start=1):
        if (site.at is None) == (site.position is None):
            raise problem(
                "missing" if site.at is None else "conflict",
                "neither" if site.at is None else "both",
                "at (shares of the translations) or position (lengths), one of the two",
                f"a {lattice} lattice does not define its sites"
                if site.at is None
                else "the place of a site was given twice",
                'write at = [0, 0] or position = ["0 mm", "0 mm"]',
                at=f"site[{number}].at",
            )
        shares = site.shares(vectors)
        assert shares is not None
        if not ((shares >= 0) & (shares < 1)).all():
            raise problem(
                "out-of-range",
                f"{shares[0]:.6g} a1 + {shares[1]:.6g} a2",
                "a place in the cell: shares of both translations from 0 to below 1",
                "the site lies outside the cell",
                "subtract whole translations from it",
                at=f"site[{number}].position",
            )


def polygons(shares: Array, lattice: Lattice) -> list[Array]:
    """Polygon of each site (n, 2) of a lattice, nearer to it than to any other: (sides, 2) about it, m."""
    if len(shares) == 1:
        return [lattice.corners]
    vectors, pitch = lattice.vectors, float(np.linalg.norm(lattice.vectors, axis=1).max())
    steps = np.array(list(product(range(-2, 3), repeat=2)))
    outlines = []
    for number, site in enumerate(shares):
        corners = lattice.corners  # nearer to the site than to its own images
        away = ((np.delete(shares, number, axis=0) - site)[:, None] + steps).reshape(-1, 2) @ vectors
        distance = np.linalg.norm(away, axis=1)
        for nearest in np.argsort(distance):
            if distance[nearest] > 2 * np.linalg.norm(corners, axis=1).max():
                break  # this site and all following ones are beyond the polygon
            if distance[nearest] <= SAME * pitch:
                continue  # two coinciding sites, which a cell refuses
            corners = _cut(corners, away[nearest], SAME * pitch)
        outlines.append(
            np.roll(corners, -int(np.lexsort((corners[:, 0], np.round(corners[:, 1], 12)))[0]), axis=0)
        )
    return outlines


def _cut(corners: Array, other: Array, same: float) -> Array:
    """Part of a convex polygon that is nearer to the origin than to another point."""
    beyond = corners @ (other / np.linalg.norm(other)) - 0.5 * np.linalg.norm(other)
    if beyond.max() <= same:
        return corners
    points: list[Array] = []
    for k in range(len(corners)):
        here, following = beyond[k], beyond[(k + 1) % len(corners)]
        if here <= same:
            points.append(corners[k])
        if (here < -same and following > same) or (here > same and following < -same):
            share = here / (here - following)
            points.append(corners[k] + share * (corners[(k + 1) % len(corners)] - corners[k]))
    return np.array(points)


def placed_tiles(
    positions: Array,
    outlines: Sequence[Array],
    features: Sequence[Feature | None],
    plate: Plate,
    half_turn: SiteMap | None,
) -> tuple[PlacedTile, ...]:
    """A tile for each site, at its position; equal tiles are the same object, turned.

    A turned tile has its own axes, along its mirrors if it has any, if the material allows for it. The
    half-turn of the cell maps a tile to the same tile turned by a half-turn.
    """
    tiles: list[PlacedTile] = []
    for number, (outline, position) in enumerate(zip(outlines, positions, strict=True)):
        if half_turn is not None and half_turn.image[number] < number:
            other = tiles[half_turn.image[number]]
            tiles.append(PlacedTile(other.tile, HALF_TURNED @ other.turn, position))
            continue
        feature = features[number]
        alike = _like(outline, feature, [other.tile for other in tiles], plate[1])
        tile, turn = alike or _upright(outline, plate, feature)
        tiles.append(PlacedTile(tile, turn, position))
    return tuple(tiles)


def _like(
    outline: Array, feature: Feature | None, tiles: Sequence[TileShape], material: Material
) -> tuple[TileShape, Array] | None:
    """The tile and the rotation whose image is a polygon with a feature; None without one."""
    for tile in tiles:
        if len(tile.corners) != len(outline):
            continue
        for corner in outline:
            turn = _turn(math.atan2(*corner[::-1]) - math.atan2(*tile.corners[0][::-1]))
            image = tile.corners @ turn[:2, :2].T
            apart = np.linalg.norm(image[:, None] - outline, axis=2).min(axis=1).max()
            same_feature = tile.feature is feature is None or (
                tile.feature is not None and feature is not None and tile.feature.is_image(feature, turn)
            )
            if apart < SAME * tile.extent and same_feature and is_symmetry(material.stiffness, turn):
                return tile, turn
    return None


def _upright(outline: Array, plate: Plate, feature: Feature | None) -> tuple[SiteTile, Array]:
    """Tile of a polygon in axes along its mirrors, and the rotation from these axes to the cell's."""
    best: tuple[int, SiteTile, Array] | None = None
    for angle in _axes(outline):
        turn = _turn(angle)
        if not is_symmetry(plate[1].stiffness, turn) or (feature and not feature.keeps_material(turn)):
            continue
        tile = site_tile(outline, turn, plate, feature)
        mirrors = sum(tile.has_symmetry(mirror) for mirror in MIRRORS)
        if best is None or mirrors > best[0]:
            best = mirrors, tile, turn
    assert best is not None, "the axes of the cell are always possible"
    return best[1:]


def site_tile(outline: Array, turn: Array, plate: Plate, feature: Feature | None) -> SiteTile:
    """Tile of a polygon (sides, 2) in axes turned (3, 3) against the cell's."""
    thickness, material, faces = plate
    points = outline @ turn[:2, :2]
    feature = feature and feature.turned(-math.atan2(turn[1, 0], turn[0, 0]))
    following = np.roll(points, -1, axis=0)
    across = points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]
    reach = float((across / np.linalg.norm(following - points, axis=1)).max())
    corners = tuple((float(x), float(y)) for x, y in points)
    return SiteTile(
        outline=corners,
        period=2 * reach,
        thickness=thickness,
        material=material,
        site_feature=feature,
        faces=faces,
    )


def _axes(outline: Array) -> Iterator[float]:
    """Angles, rad, of possible mirror axes of a polygon; the first is that of the x axis."""
    yield 0.0
    for point in np.concatenate([outline, 0.5 * (outline + np.roll(outline, -1, axis=0))]):
        yield math.atan2(point[1], point[0])


def _turn(angle: float) -> Array:
    """(3, 3) rotation about the normal; exact for right angles."""
    cosine, sine = math.cos(angle), math.sin(angle)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    near = np.round(turn)
    return np.where(np.abs(turn - near) < SAME, near, turn) if np.abs(turn - near).max() < SAME else turn


def check_tiles(tiles: Sequence[PlacedTile], given: int, pitch: float, least: float) -> None:
    """Refuse sites that coincide, very short sides of tiles, and pillars that touch a side.

    given : number of tables of sites in the study, 0 if all pillars are given by one
    least : free width between a pillar and the sides of its tile, m
    """
    for number, tile in enumerate((placed.tile for placed in tiles), start=1):
        table = f"site[{number}]." if number <= given else ""
        sides = np.linalg.norm(tile.corners - np.roll(tile.corners, 1, axis=0), axis=1)
        if sides.min() < LEAST_SIDE * tile.inradius:
            raise problem(
                "out-of-range",
                f"a side of the site's tile of {sides.min() / tile.inradius:.2g} of the circle within",
                f"none shorter than {LEAST_SIDE:g} of the radius of the circle within",
                "four tiles or more nearly meet in a point, but not quite",
                'write the shares as fractions, such as "1/3", or move a site by a hundredth of the pitch',
                at=f"{table}at" if table else "site",
            )
        feature = tile.feature
        # before the checks that need a clearance
        if feature is not None and feature.widest > (room := tile.room_beside(least)):
            per_half = feature.diameter / feature.radius
            beyond = per_half * (feature.widest - feature.radius)
            raise problem(
                "out-of-range",
                f"{feature.diameter * 1e3:g} mm wide"
                + (f", and {beyond * 1e3:.4g} mm more where it is widest" if beyond else ""),
                f"less than {(per_half * room - beyond) * 1e3:.4g} mm wide, so that a hundredth of the pitch "
                "stays free up to halfway to the next site",
                f"the {feature.noun} overlaps the next one, or touches the edge halfway to it",
                f"choose a thinner {feature.noun}, or move the sites apart",
                at=f"{table}{feature.table}.diameter",
            )
        if feature is not None and (parts := unmeshed(tile)) is not None:
            raise problem("unsupported", **parts, at=f"{table}{feature.table}.section")
        pointed = float(np.linalg.norm(tile.corners, axis=1).max() / tile.inradius)
        if pointed > MOST_POINTED and len(tiles) > 1:
            raise problem(
                "out-of-range",
                f"a tile whose farthest corner is {pointed:.3g} times as far as its nearest side",
                f"at most {MOST_POINTED:g} times",
                "another site is so near on one side, and none on the other, that elements would fold",
                "move the two sites apart, or make them one",
                at=f"{table}at" if table else "site",
            )


def apart(shares: Array, vectors: Array, least: float) -> tuple[int, int] | None:
    """Indices of two sites that are nearer than a length (m), or None."""
    for first, second in product(range(len(shares)), repeat=2):
        if first < second:
            steps = shares[first] - shares[second]
            steps = (steps - np.round(steps)) + np.array(list(product((-1, 0, 1), repeat=2)))
            if np.linalg.norm(steps @ vectors, axis=1).min() < least:
                return first, second
    return None


def steps_between(shares: Array, vectors: Array) -> Array:
    """(n, 2) vectors, m, from the first of two sites to the second one in this and the adjacent cells.

    shares : (2, 2) positions in shares of the translations; a site has no vector to itself
    """
    steps = np.array(list(product((-1, 0, 1), repeat=2)))
    away: Array = (shares[1] - shares[0] + steps) @ vectors
    return away[away.any(axis=1)]
