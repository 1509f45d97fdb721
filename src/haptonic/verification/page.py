"""Page of the documentation: the table, the remarks, and band diagrams with the source's values."""

from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

from haptonic.atomic import write_atomically
from haptonic.later import Figure
from haptonic.plots import stage, style
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
DIAGRAMS = """## Diagrams

Curves are computed. Crosses and dotted lines are the source's values. A case has a diagram if the source
gives edges of a gap, or frequencies at corners of the zone.
"""
ROOM = 1.04  # height of a diagram over its highest value


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
    parts.append(DIAGRAMS)
    parts += [
        f"### {case.title}\n\n![Computed bands of the case {case.id} with the source's values]"
        f"({IMAGES}/verify-{case.id}.svg)\n"
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
    """Band diagram of a case with the source's edges, and its frequencies at corners of the zone."""
    bands = load_case_study(comparisons[0].case.study).run("bands")
    assert isinstance(bands, Bands)
    data, drawn = bands.dataset, bands.plot()
    axes = drawn.axes[0]
    names, rows = (json.loads(data.attrs[f"path_{name}"]) for name in ("labels", "corners"))
    corners = [(name, float(data["distance"][row])) for name, row in zip(names, rows, strict=True)]
    edges, crosses = [], []
    for comparison in comparisons:
        values = (comparison.reference / 1e3).tolist()
        if comparison.quantity.measure.endswith("edge"):
            edges += values
        at = comparison.quantity.at.replace("G", "Γ")
        crosses += [(place, value) for name, place in corners if name == at for value in values]
    highest = max([*edges, *(value for _, value in crosses)])
    axes.set_ylim(top=max(axes.get_ylim()[1], ROOM * highest))
    handles = []
    with style.styled():
        if crosses:
            handles += axes.plot(
                *zip(*crosses, strict=True), "x", color=style.BLUE, ms=5, clip_on=False, zorder=5,
                label="frequencies of the source", gid="source",
            )  # fmt: skip
        for value in edges:
            line = axes.axhline(value, color=style.INK, ls=style.DOTTED, lw=1.4, zorder=4, gid="source")
        if edges:
            line.set_label(f"edges of the gap in the source, {' and '.join(map('{:g}'.format, edges))} kHz")
            handles.append(line)
        stage.below(drawn, handles, ncols=2)
    return drawn
