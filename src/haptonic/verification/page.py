"""Page of the documentation: the table, the remarks, and band diagrams with the source's values."""

from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

from haptonic.atomic import write_atomically
from haptonic.later import Figure
from haptonic.plots import style
from haptonic.results.bands import Bands
from haptonic.results.table import Table
from haptonic.verification.catalogue import Case, OmittedCase
from haptonic.verification.comparison import CaseComparison, load_case_study
from haptonic.verification.tables import comparison_table

PAGE, IMAGES = "verification.md", "images"
BEGINNING = """# Published and exact cases

Written by `haptonic verify --page docs`. Each case is a study: `haptonic new CASE FILE` copies it, and
`haptonic verify CASE` computes it again. All frequencies come from `haptonic bands`, as a user asks for them.

The difference is the largest of all values, relative to the source. The allowed difference is the
sum of haptonic's error, the uncertainty of the source and the tolerance of the case. *Published* values were
printed by others, *exact* ones follow from a formula or from two ways to describe one cell, and *independent*
ones come from another program.
"""


def write_page(
    folder: Path, comparisons: Sequence[CaseComparison], omitted: Sequence[OmittedCase]
) -> list[Path]:
    """Write the page and its pictures into a folder, and replace existing ones.

    Raises
    ------
    ResourceError : the folder cannot be written
    """
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for case, of_case in groupby(comparisons, key=_case_of):
        if not case.picture:
            continue
        drawn = diagram(list(of_case))
        files += style.save(drawn, folder / IMAGES, f"verify-{case.id}", overwrite=True)
    text = page_text(comparisons, omitted)
    write_atomically(folder / PAGE, lambda draft: draft.write_text(text, "utf-8"))
    return [folder / PAGE, *files]


def _case_of(comparison: CaseComparison) -> Case:
    return comparison.case


def page_text(comparisons: Sequence[CaseComparison], omitted: Sequence[OmittedCase]) -> str:
    """The page in Markdown."""
    parts = [BEGINNING, comparison_table(comparisons).written("markdown"), "## Sources and remarks\n"]
    named = [case for case, _ in groupby(comparisons, key=_case_of)]
    parts.append(source_table(named).written("markdown"))
    parts.append("## Diagrams\n\nComputed bands; crosses and dotted lines are the source's values.\n")
    parts += [
        f"### {case.title}\n\n![Band diagram of the case {case.id}]({IMAGES}/verify-{case.id}.svg)\n"
        for case in named
        if case.picture
    ]
    parts.append("## Cases that are not computed\n")
    left_out = [(case.title, case.source, case.reason) for case in omitted]
    parts.append(Table("omitted cases", ("case", "source", "reason"), left_out).written("markdown"))
    return "\n".join(parts)


def source_table(chosen: Sequence[Case]) -> Table:
    """A row for each case: title, kind and source of its values, and reasons for differences."""
    rows = [(case.id, case.title, case.kind, case.source, case.remark) for case in chosen]
    return Table("cases", ("case", "title", "kind", "source", "why values differ"), rows)


def diagram(comparisons: Sequence[CaseComparison]) -> Figure:
    """Band diagram of a case with the published edges, and frequencies at corners of the zone."""
    bands = load_case_study(comparisons[0].case.study).run("bands")
    assert isinstance(bands, Bands)
    data, drawn = bands.dataset, bands.plot()
    corners = dict(
        zip(*(json.loads(data.attrs[f"path_{name}"]) for name in ("labels", "corners")), strict=True)
    )
    for comparison in comparisons:
        for value in comparison.reference:
            if comparison.quantity.measure.endswith("edge"):
                drawn.axes[0].axhline(value / 1e3, color=style.INK, ls=style.DOTTED, lw=1.4, zorder=4)
            elif (corner := corners.get(comparison.quantity.at.replace("G", "Γ"))) is not None:
                place = float(data["distance"][corner])
                drawn.axes[0].plot(place, value / 1e3, "x", color=style.INK, clip_on=False, zorder=5)
    return drawn
