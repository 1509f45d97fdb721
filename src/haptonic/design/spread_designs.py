"""Designs within the spreads of a study, and spreads that lead to impossible ones."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import UnitCell
from haptonic.design.discs import is_divided_alike, with_shared
from haptonic.design.links import Links
from haptonic.design.parameters import values_of
from haptonic.design.rare import sobol
from haptonic.design.tolerance import REACH, Spread
from haptonic.errors import GeometryError, HaptonicError, StudyError
from haptonic.units import format_quantity


def deviations(spreads: Sequence[Spread], count: int) -> Array:
    """(count, parameters) deviations, SI, that fill `REACH` times the ranges evenly.

    They are a scrambled Sobol sequence of a fixed seed.
    """
    places = REACH * (2 * sobol(len(spreads), count) - 1)
    return np.asarray(places * [spread.half_range for spread in spreads])


def own_values(cell: UnitCell, spreads: Sequence[Spread], links: Links) -> dict[str, float]:
    """Values without deviations of the numbers that vary, SI, by path; ``links`` for named parameters."""
    values = values_of(cell)
    names = {spread.parameter: spread.names_parameter for spread in spreads}
    return {path: links.own(path) if is_named else values[path] for path, is_named in names.items()}


def samples(
    cell: UnitCell, spreads: Sequence[Spread], count: int, links: Links | None = None
) -> list[UnitCell]:
    """Designs with the `deviations`; ``links`` for spreads of named parameters.

    Raises
    ------
    GeometryError : a spread so large that some designs are not possible, or ends or borders of discs cross
    """
    return _designs(cell, spreads, deviations(spreads, count), links or Links())


def _designs(cell: UnitCell, spreads: Sequence[Spread], rows: Array, links: Links) -> list[UnitCell]:
    own = own_values(cell, spreads, links)
    changes = [{name: own[name] + float(d) for name, d in zip(own, row, strict=True)} for row in rows]
    designs = [cell.with_numbers(with_shared(cell, links.numbers(change))) for change in changes]
    if not all(is_divided_alike(cell, design) for design in designs):
        raise GeometryError.conflict(
            argument="cell.disc",
            given="in another order, from below or from the axis",
            allowed="ends and borders in the order of the study",
            cause="some spreads exceed the distance of two ends or borders",
            next_step="give smaller spreads",
        )
    return designs


def check_possible(cell: UnitCell, spreads: Sequence[Spread], count: int, links: Links) -> None:
    """Refuse spreads with which some `samples` are no body.

    Raises
    ------
    StudyError : with the largest spread of a number that alone leads to impossible bodies
    """
    for position, spread in enumerate(spreads, start=1):
        reason = _reason_impossible(cell, spread, links, 1.0)
        if reason is None:
            continue
        low, high = 0.0, 1.0
        for _ in range(12):
            middle = 0.5 * (low + high)
            possible = _reason_impossible(cell, spread, links, middle) is None
            low, high = (middle, high) if possible else (low, middle)
        farthest = REACH * spread.half_range
        largest = format_quantity(0.99 * low * spread.spread, spread.unit, digits=3)
        raise StudyError.out_of_range(
            argument=f"tolerance.of[{position}].spread",
            given=f"{format_quantity(spread.spread, spread.unit)} for {spread.parameter}",
            allowed=f"at most {largest}",
            cause=f"designs up to {farthest / spread.spread:g} spreads away, "
            f"{format_quantity(farthest, spread.unit)}, are computed: "
            f"{reason.argument} would be {reason.given}: {reason.cause}",
            next_step=f'give at most "{largest}"',
        )
    try:
        samples(cell, spreads, count, links)
    except HaptonicError as error:
        raise StudyError.out_of_range(
            argument="tolerance.of",
            given="spreads that lead to impossible bodies together",
            allowed=f"spreads for which {REACH:g} times their largest deviations still give a body",
            cause=f"{error.argument} would be {error.given}: {error.cause}",
            next_step="give smaller spreads",
        ) from None


def _reason_impossible(cell: UnitCell, spread: Spread, links: Links, share: float) -> HaptonicError | None:
    farthest = share * REACH * spread.half_range
    try:
        _designs(cell, [spread], np.array([[-farthest], [farthest]]), links)
    except HaptonicError as error:
        return error
    return None
