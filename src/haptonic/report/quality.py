"""A page to look at every trial: small plots by participant and block, and all that was left out."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path

from haptonic.report.chapter import Picture, Table
from haptonic.report.page import filled
from haptonic.results import FrictionResult

TEMPLATE = "quality.html"
MOST_LISTED = 500  # excluded trials; trials.csv has them all


def quality(result: FrictionResult, told: Callable[[int, int, bool], None]) -> str:
    """The page as text; ``told`` is called with (done, planned, False) in sheets."""
    blocks, more = result.blocks()
    pictures = []
    for person, block, figure in result.sheets(blocks):
        name = f"Participant {person}, block {block}"
        pictures.append(Picture(figure, name, f"{name}: the forces of every trial"))
        told(len(pictures), len(blocks), False)
    return filled(
        TEMPLATE,
        origin=result.origin,
        remarks=result.remarks,
        omissions=result.found.omissions,
        counts=result.excluded,
        total=result.trials.sizes["stroke"],
        excluded=_excluded(result),
        most=MOST_LISTED,
        pictures=pictures,
        more=more,
        version=version("haptonic"),
    )


def write_quality(result: FrictionResult, path: Path, told: Callable[[int, int, bool], None]) -> None:
    """Write the page, UTF-8: pictures and style inside, no script, nothing from elsewhere."""
    path.write_text(quality(result, told), encoding="utf-8")


def _excluded(result: FrictionResult) -> Table:
    trials = result.trials
    trials = trials.isel(stroke=trials["excluded"].values != "").isel(stroke=slice(MOST_LISTED))
    head = ("participant", "block", "trial", "waveguide", "actuation", "excluded", "detail")
    columns = [[str(value) for value in trials[name].values] for name in head]
    return Table("Trials that do not count.", head, tuple(zip(*columns, strict=True)))
