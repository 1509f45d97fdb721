"""Sites: where pillars stand in a cell, and the tile of each, what lies nearer to it than to any other."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Annotated

import numpy as np
from pydantic import field_validator

from haptonic.arrays import Array, Ints
from haptonic.cell.disc import Disc
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.sectors import unmeshed
from haptonic.cell.stack import Feature
from haptonic.cell.tile import HALF_TURNED, PlacedTile, SiteTile, TileShape
from haptonic.errors import GeometryError
from haptonic.fields import Quantity, described, problem, setting
from haptonic.lattice import LEAST_SIDE, Lattice, Operation
from haptonic.materials import Material, is_symmetry
from haptonic.translations import SAME

Plate = tuple[float, Material, Faces]  # thickness, m, and the faces that pillars stand on
SHARE = Quantity("", at_least=0.0, below=1.0, hint="take whole translations off it")
PLACE = Quantity("m")
MIRRORS = (np.diag([-1.0, 1.0, 1.0]), np.diag([1.0, -1.0, 1.0]))
MOST_SITES, MOST_DISCS = 12, 12  # of one cell, and of one site
# Of a site's tile, from the site to its farthest corner, in radii of the circle within: beside pillars whose
# neighbours are that much nearer on one side, elements were turned inside out from 9.9 on.
MOST_POINTED = 8.0
# sites of lattices that are named after them, in shares of a1 and a2, and places between them that stay empty
SITES: dict[str, tuple[tuple[float, float], ...]] = {
    "honeycomb": ((1 / 3, 1 / 3), (2 / 3, 2 / 3)),
    "kagome": ((0.5, 0.0), (0.0, 0.5), (0.5, 0.5)),
    "lieb": ((0.0, 0.0), (0.5, 0.0), (0.0, 0.5)),
}
EMPTY: dict[str, tuple[tuple[float, float], ...]] = {"lieb": ((0.5, 0.5),)}


@described("cell.site", GeometryError, kw_only=True)
class Site:
    """A place in the cell and the pillar that stands there, or the discs in its place.

    ``at`` counts in the lattice's translations, ``position`` in metres along x and y, both from a corner of
    the cell that they span.
    """

    at: tuple[Annotated[float, SHARE], Annotated[float, SHARE]] | None = setting(
        None, 'Shares of the two translations, such as ["1/3", "2/3"]; each from 0 to below 1.', title="Site"
    )
    position: tuple[Annotated[float, PLACE], Annotated[float, PLACE]] | None = setting(
        None, "The same as two lengths along x and y."
    )
    pillar: Pillar | None = setting(
        None, "Without this table and discs the site is empty.", title="Pillar of the site"
    )
    disc: tuple[Disc, ...] = setting(
        (),
        "In place of a pillar: put in one after the other, a later one replaces what it overlaps.",
        title="Discs of the site",
        max_length=MOST_DISCS,
    )

    @field_validator("at", mode="before")
    @classmethod
    def _fractions(cls, given: object) -> object:
        """Texts such as "1/3" are numbers: no row of digits is a third."""
        return [_number(one) for one in given] if isinstance(given, list | tuple) else given

    def scaled(self, factor: float) -> Site:
        """The same with every length multiplied by ``factor``."""
        place = self.position and (self.position[0] * factor, self.position[1] * factor)
        discs = tuple(disc.scaled(factor) for disc in self.disc)
        return replace(self, position=place, pillar=self.pillar and self.pillar.scaled(factor), disc=discs)

    def shares(self, vectors: Array) -> Array | None:
        """(2,) of the translations; None where the lattice is named after its sites."""
        if self.position is not None:
            found = np.linalg.solve(vectors.T, np.array(self.position))
            rounded = (np.abs(found - np.round(found)) < SAME) & (found < 1)
            return np.where(rounded, np.round(found) % 1.0, found)
        return None if self.at is None else np.array(self.at)


def _number(given: object) -> object:
    try:
        return float(Fraction(given)) if isinstance(given, str) and "/" in given else given
    except (ValueError, ZeroDivisionError):
        return given


@dataclass(frozen=True, eq=False)
class SiteMap:
    """A turn or mirror of a cell: site s goes to site ``image[s]``, ``shift[s]`` translations on.

    move : (2,) translation that follows the turn about the origin, in shares of the lattice's
    """

    move: Array
    image: Ints
    shift: Ints


def site_map(
    shares: Array, features: Sequence[Feature | None], operation: Operation, turn: Array
) -> SiteMap | None:
    """How a turn of a lattice, perhaps with a move, takes sites (n, 2) to others that are alike, if so."""
    turned = shares @ np.array(operation).T
    moves = [np.zeros(2), *(one - turned[0] for one in shares)]
    for move in moves:
        steps = (turned + move)[:, None] - shares
        whole = np.round(steps)
        fits = np.abs(steps - whole).max(axis=2) < SAME
        for s, t in np.argwhere(fits):
            mine, other = features[s], features[t]
            fits[s, t] = mine is other is None or bool(mine and other and mine.is_image(other, turn))
        if fits.any(axis=1).all():
            image = fits.argmax(axis=1)
            return SiteMap(move, image, whole[np.arange(len(shares)), image].astype(np.int64))
    return None


def shares_of(sites: Sequence[Site], lattice: Lattice) -> Array:
    """(n, 2) shares of the translations, of every site with what stays empty between them."""
    if lattice.name in SITES:
        return np.array(SITES[lattice.name] + EMPTY.get(lattice.name, ()))
    return np.array([lattice.counted(np.asarray(one.shares(lattice.given))) for one in sites])


def check_shares(sites: Sequence[Site], vectors: Array, lattice: str) -> None:
    """Refuse places that a study may give and no cell can have.

    Raises
    ------
    PydanticCustomError : too few or too many places, one outside the cell, two that are one
    """
    named = SITES.get(lattice)
    if named is not None:
        if sites and len(sites) != len(named):
            raise problem(
                "conflict",
                f"{len(sites)} of them",
                f"{len(named)}, one for each site of a {lattice} lattice, or none for pillars all alike",
                "a table is missing, or there is one too many",
                "give every site its table; one without a pillar stays empty",
                at="site",
            )
        for number, one in enumerate(sites, start=1):
            if one.at is not None or one.position is not None:
                raise problem(
                    "conflict",
                    "a place",
                    f"none: the sites of a {lattice} lattice have theirs",
                    "the place of a site was given twice",
                    'leave it out, or write lattice = "triangular" or "square"',
                    at=f"site[{number}].{'at' if one.at is not None else 'position'}",
                )
        return
    for number, one in enumerate(sites, start=1):
        if (one.at is None) == (one.position is None):
            raise problem(
                "missing" if one.at is None else "conflict",
                "neither" if one.at is None else "both",
                "at (shares of the translations) or position (lengths), one of the two",
                f"a {lattice} lattice does not say where its sites are"
                if one.at is None
                else "the place of a site was given twice",
                'write at = [0, 0] or position = ["0 mm", "0 mm"]',
                at=f"site[{number}].at",
            )
        shares = one.shares(vectors)
        assert shares is not None
        if not ((shares >= 0) & (shares < 1)).all():
            raise problem(
                "out-of-range",
                f"{shares[0]:.6g} a1 + {shares[1]:.6g} a2",
                "a place in the cell: shares of both translations from 0 to below 1",
                "the site lies outside the cell",
                "take whole translations off it",
                at=f"site[{number}].position",
            )


def polygons(shares: Array, lattice: Lattice) -> list[Array]:
    """What lies nearer to each site (n, 2) of a lattice than to any other: corners (sides, 2) about it, m."""
    if len(shares) == 1:
        return [lattice.corners]
    vectors, pitch = lattice.vectors, float(np.linalg.norm(lattice.vectors, axis=1).max())
    steps = np.array(list(product(range(-2, 3), repeat=2)))
    made = []
    for number, own in enumerate(shares):
        corners = lattice.corners  # nearer to the site than to its own images
        away = ((np.delete(shares, number, axis=0) - own)[:, None] + steps).reshape(-1, 2) @ vectors
        distance = np.linalg.norm(away, axis=1)
        for nearest in np.argsort(distance):
            if distance[nearest] > 2 * np.linalg.norm(corners, axis=1).max():
                break  # it and all that follow are beyond the polygon
            if distance[nearest] <= SAME * pitch:
                continue  # two sites that are one, which a cell refuses
            corners = _cut(corners, away[nearest], SAME * pitch)
        made.append(
            np.roll(corners, -int(np.lexsort((corners[:, 0], np.round(corners[:, 1], 12)))[0]), axis=0)
        )
    return made


def _cut(corners: Array, other: Array, same: float) -> Array:
    """The part of a convex polygon that lies nearer to the origin than to another point."""
    beyond = corners @ (other / np.linalg.norm(other)) - 0.5 * np.linalg.norm(other)
    if beyond.max() <= same:
        return corners
    kept: list[Array] = []
    for k in range(len(corners)):
        here, following = beyond[k], beyond[(k + 1) % len(corners)]
        if here <= same:
            kept.append(corners[k])
        if (here < -same and following > same) or (here > same and following < -same):
            share = here / (here - following)
            kept.append(corners[k] + share * (corners[(k + 1) % len(corners)] - corners[k]))
    return np.array(kept)


def placed_tiles(
    positions: Array,
    outlines: Sequence[Array],
    features: Sequence[Feature | None],
    plate: Plate,
    half_turn: SiteMap | None,
) -> tuple[PlacedTile, ...]:
    """A tile for each site, in its place; equal ones are one object, turned.

    A turned tile has its own axes, along its mirrors where it has any, if the material allows for it. The
    half-turn of the cell takes a tile to the same one turned by just that.
    """
    made: list[PlacedTile] = []
    for number, (outline, position) in enumerate(zip(outlines, positions, strict=True)):
        if half_turn is not None and half_turn.image[number] < number:
            other = made[half_turn.image[number]]
            made.append(PlacedTile(other.tile, HALF_TURNED @ other.turn, position))
            continue
        feature = features[number]
        alike = _like(outline, feature, [other.tile for other in made], plate[1])
        tile, turn = alike or _upright(outline, plate, feature)
        made.append(PlacedTile(tile, turn, position))
    return tuple(made)


def _like(
    outline: Array, feature: Feature | None, tiles: Sequence[TileShape], material: Material
) -> tuple[TileShape, Array] | None:
    """The tile, and the turn, that a polygon with a feature is the image of, if there is one."""
    for tile in tiles:
        if len(tile.corners) != len(outline):
            continue
        for corner in outline:
            turn = _turn(math.atan2(*corner[::-1]) - math.atan2(*tile.corners[0][::-1]))
            image = tile.corners @ turn[:2, :2].T
            apart = np.linalg.norm(image[:, None] - outline, axis=2).min(axis=1).max()
            stands = tile.feature is feature is None or (
                tile.feature is not None and feature is not None and tile.feature.is_image(feature, turn)
            )
            if apart < SAME * tile.extent and stands and is_symmetry(material.stiffness, turn):
                return tile, turn
    return None


def _upright(outline: Array, plate: Plate, feature: Feature | None) -> tuple[SiteTile, Array]:
    """The tile of a polygon in axes along its mirrors, and the turn from these axes to the cell's."""
    best: tuple[int, SiteTile, Array] | None = None
    for angle in _axes(outline):
        turn = _turn(angle)
        if not is_symmetry(plate[1].stiffness, turn) or (feature and not feature.keeps_material(turn)):
            continue
        tile = site_tile(outline, turn, plate, feature)
        mirrors = sum(tile.has_symmetry(mirror) for mirror in MIRRORS)
        if best is None or mirrors > best[0]:
            best = mirrors, tile, turn
    assert best is not None, "axes that are not turned are always possible"
    return best[1:]


def site_tile(outline: Array, turn: Array, plate: Plate, feature: Feature | None) -> SiteTile:
    """The tile of a polygon (sides, 2) in axes turned (3, 3) against the cell's."""
    thickness, material, faces = plate
    own = outline @ turn[:2, :2]
    feature = feature and feature.turned(-math.atan2(turn[1, 0], turn[0, 0]))
    following = np.roll(own, -1, axis=0)
    across = own[:, 0] * following[:, 1] - own[:, 1] * following[:, 0]
    reach = float((across / np.linalg.norm(following - own, axis=1)).max())
    corners = tuple((float(x), float(y)) for x, y in own)
    return SiteTile(
        outline=corners,
        period=2 * reach,
        thickness=thickness,
        material=material,
        site_feature=feature,
        faces=faces,
    )


def _axes(outline: Array) -> Iterator[float]:
    """Angles, rad, of the lines about which a polygon may be its own image; first that of the x axis."""
    yield 0.0
    for point in np.concatenate([outline, 0.5 * (outline + np.roll(outline, -1, axis=0))]):
        yield math.atan2(point[1], point[0])


def _turn(angle: float) -> Array:
    """(3, 3) turn about the normal; by right angles exactly."""
    cosine, sine = math.cos(angle), math.sin(angle)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    near = np.round(turn)
    return np.where(np.abs(turn - near) < SAME, near, turn) if np.abs(turn - near).max() < SAME else turn


def check_tiles(tiles: Sequence[PlacedTile], given: int, pitch: float, least: float) -> None:
    """Refuse sites that are one, sides of tiles that are next to nothing, and pillars that touch a side.

    given : tables of sites in the study, 0 where all pillars are one
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
        if feature is not None and tile.clearance < least:  # before what follows from it
            per_half = feature.diameter / feature.radius
            beyond = per_half * (feature.widest - feature.radius)
            room = per_half * (tile.room - least) - beyond
            raise problem(
                "out-of-range",
                f"{feature.diameter * 1e3:g} mm wide"
                + (f", and {beyond * 1e3:.4g} mm more where it is widest" if beyond else ""),
                f"less than {room * 1e3:.4g} mm wide, so that a hundredth of the pitch stays free up to half-"
                "way to the next site",
                f"the {feature.noun} overlaps the next one, or touches the edge half-way to it",
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
    """Numbers of two sites that are nearer than a length (m), if there are such."""
    for one, other in product(range(len(shares)), repeat=2):
        if one < other:
            steps = shares[one] - shares[other]
            steps = (steps - np.round(steps)) + np.array(list(product((-1, 0, 1), repeat=2)))
            if np.linalg.norm(steps @ vectors, axis=1).min() < least:
                return one, other
    return None
