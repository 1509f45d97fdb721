"""Checks of a cell: sizes, positions and materials that contradict each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from haptonic.cell.pillar import Pillar
from haptonic.cell.sectors import unmeshed
from haptonic.cell.sites import Site, apart, check_shares, check_tiles
from haptonic.cell.stack import Feature, Stack
from haptonic.cell.stack_checks import check_stack
from haptonic.cell.tile import HALF_TURNED
from haptonic.fields import problem
from haptonic.materials import is_symmetry
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from haptonic.cell.geometry import UnitCell

LEAST_CLEARANCE = 0.01  # of the pitch, between a pillar or disc and the nearest side of its cell


def check_cell(cell: UnitCell) -> None:
    """Refuse a cell whose parts contradict each other.

    Raises
    ------
    PydanticCustomError : the contradiction, at its key
    """
    # lattices and outlines always have this symmetry; further symmetries are optional
    for at, solid in cell.materials.items():
        if not is_symmetry(solid.stiffness, HALF_TURNED):
            raise problem(
                "unsupported",
                solid.name,
                "a material that half a turn about the plate's normal leaves unchanged",
                "its constants couple motion in the plane with motion out of it",
                "turn the material so that one of its axes is normal to the plate",
                at=at,
            )
    _check_discs(cell)
    if cell.solid is not None:
        _check_alone(cell)
    if not cell.is_simple:
        _check_sites(cell)
        return
    if (feature := cell.feature) is None:
        return
    room = cell.room_beside(LEAST_CLEARANCE * cell.lattice.pitch)
    if feature.widest > room:
        raise _too_wide(feature, room)
    if (parts := unmeshed(cell)) is not None:
        raise problem("unsupported", **parts, at=f"{feature.table}.section")


def _check_alone(cell: UnitCell) -> None:
    """Refuse pillars, discs and sites beside the solids of a CAD file."""
    beside = {
        "a pillar": cell.pillar is not None,
        "discs": bool(cell.disc),
        "sites": not cell.is_simple,
        "pillars on both faces": cell.is_mirrored,
    }
    for name, is_given in beside.items():
        if is_given:
            raise problem(
                "conflict",
                f"solids of a CAD file and {name}",
                "the solids alone, on a lattice of one site",
                "the file describes both faces of the plate completely",
                "leave one of the two out; draw several sites as one period of a triangular lattice",
                at="solid",
            )


def _check_discs(cell: UnitCell) -> None:
    """Refuse discs beside a pillar, and discs that form no body."""
    places: list[tuple[str, UnitCell | Site]] = [("", cell)]
    places += [(f"site[{number}].", site) for number, site in enumerate(cell.site, start=1)]
    for table, place in places:
        if place.pillar is not None and place.disc:
            raise problem(
                "conflict",
                "a pillar and discs",
                "one of the two on a site",
                "a pillar is one body; with discs about it, it is a disc as well",
                "give the pillar as a disc with low = 0 and its height as high, or leave the discs out",
                at=f"{table}disc",
            )
    for table, discs in cell.disc_tables.items():
        check_stack(Stack(discs, cell.thickness, cell.is_mirrored), table)


def _check_sites(cell: UnitCell) -> None:
    """Refuse sites that contradict each other."""
    if cell.site and (cell.pillar is not None or cell.disc):
        name = "disc" if cell.disc else "pillar"
        raise problem(
            "conflict",
            f"a {name} beside [[cell.site]]",
            f"{name}s of the sites, or one for all of them",
            f"the {name} of a site was given twice",
            f"put it into the tables of the sites, as cell.site.{name}, or leave these out",
            at=name,
        )
    check_shares(cell.site, cell.lattice.given, cell.lattice.name)
    shares = cell.shares
    least = 2 * LEAST_CLEARANCE * cell.lattice.pitch
    if (pair := apart(shares, cell.lattice.vectors, least)) is not None:
        raise problem(
            "repeated",
            f"the place of site[{pair[0] + 1}]",
            f"a place more than {format_quantity(least, 'm', digits=3)} from every other site",
            "two sites have the same position in the lattice, or nearly",
            "move one of them, or leave it out",
            at=f"site[{pair[1] + 1}].at",
        )
    tiles = cell.tiles
    check_tiles(tiles, len(cell.site), cell.lattice.pitch, LEAST_CLEARANCE * cell.lattice.pitch)


def _too_wide(feature: Feature, room: float) -> Exception:
    """Error for a pillar, a fillet or a disc that is wider than the available half-width, m."""
    table = feature.table
    free = "so that a hundredth of the pitch stays free on either side"
    if room <= 0:
        return problem(
            "out-of-range",
            format_quantity(feature.diameter, "m"),
            f"no {feature.noun}, {free}",
            "the lattice's translations are nearly parallel, so that its rows nearly meet",
            "turn one of the translations away from the other",
            at=f"{table}.diameter",
        )
    arc = feature.arc if isinstance(feature, Pillar) else None
    if arc is not None and feature.broadest < room:
        most = arc.radius * (room - feature.radius) / (arc.centre[0] - feature.radius)
        return problem(
            "out-of-range",
            format_quantity(arc.radius, "m"),
            f"less than {format_quantity(most, 'm')}, {free}",
            "the fillet reaches beyond the cell",
            "choose a smaller radius, a thinner pillar or a larger pitch",
            at=f"{table}.fillet",
        )
    per_half = feature.diameter / feature.radius
    beyond = per_half * (feature.broadest - feature.radius)
    return problem(
        "out-of-range",
        format_quantity(feature.diameter, "m")
        + (f", and {format_quantity(beyond, 'm')} more where it is widest" if beyond else ""),
        f"less than {format_quantity(per_half * room - beyond, 'm')}, {free}",
        f"the {feature.noun} is too wide for the cell",
        "choose a smaller diameter or a larger pitch",
        at=f"{table}.diameter",
    )
