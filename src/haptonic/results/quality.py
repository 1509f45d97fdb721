"""Page with a small plot of every trial, by participant and block, and a list of the excluded ones."""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING

from haptonic.pages import Picture, filled
from haptonic.results.table import Table

if TYPE_CHECKING:
    from haptonic.results.friction import FrictionResult

TEMPLATE = "quality.html"
MOST_LISTED = 500  # excluded trials; trials.csv contains all


def quality(result: FrictionResult) -> str:
    """The page as text."""
    blocks, more = result.blocks()
    pictures = []
    for person, block, figure in result.sheets(blocks):
        name = f"Participant {person}, block {block}"
        pictures.append(Picture(figure, name, f"{name}: the forces of every trial"))
    return filled(
        TEMPLATE,
        origin=result.origin,
        remarks=result.guessed,
        omissions=result.found.omissions,
        counts=result.excluded,
        total=result.trials.sizes["stroke"],
        excluded=_excluded(result),
        most=MOST_LISTED,
        pictures=pictures,
        more=more,
        version=version("haptonic"),
    )


def _excluded(result: FrictionResult) -> Table:
    trials = result.trials
    trials = trials.isel(stroke=trials["excluded"].values != "").isel(stroke=slice(MOST_LISTED))
    head = ("participant", "block", "trial", "waveguide", "actuation", "excluded", "detail")
    columns = [[str(value) for value in trials[name].values] for name in head]
    return Table("Excluded trials.", head, tuple(zip(*columns, strict=True)))
