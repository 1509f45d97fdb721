"""Published values beside ours, as the study's example gives them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from haptonic.plots.text import minus
from haptonic.report.against import NONE, ComparedValue
from haptonic.report.chapter import Absent, Chapter, Results, Table
from haptonic.units import hz_text


def chapter(results: Results) -> Chapter | Absent:
    """Published value, haptonic, difference and remark; then the effect of single changes."""
    known = results.references
    if known is None:
        return Absent("Comparison", "the study brings no reference values")
    head = ("Quantity", known.title[0].upper() + known.title[1:], "haptonic", "Difference", "Remark")
    compared = Table(
        f"Every number of {known.title}, and haptonic for the same study.",
        head,
        [one.cells for one in results.comparisons],
    )
    return Chapter(
        title=f"Comparison with {known.title}",
        identifier="comparison",
        paragraphs=(f"It is {known.citation}. {known.about}",),
        findings=(_counted(results.comparisons),),
        tables=(compared, *_variants(results)),
    )


def _counted(rows: Sequence[ComparedValue]) -> str:
    """How many values are of each kind, and how many agree."""
    roles = Counter(one.role for one in rows)
    agree = sum(one.agrees is True for one in rows if one.role == "computed")
    differ = sum(one.agrees is False for one in rows if one.role == "computed")
    return (
        f"{len(rows)} published values: {roles['computed']} are compared with computed ones, and {agree} "
        f"agree and {differ} differ; {roles['input']} are inputs; {roles['experiment']} are facts of the "
        "experiment that nothing here computes."
    )


def _variants(results: Results) -> list[Table]:
    """A table for each name of them, its first row being what the others are compared with."""
    made = []
    for name in dict.fromkeys(one.table for one, _ in results.variants):
        found = [(one.label, value) for one, value in results.variants if one.table == name]
        first = next((value for _, value in found if value), None)
        rows = [
            (label, NONE, NONE) if value is None or first is None
            else (label, hz_text(value, form='.2f'), minus(f"{100 * (value / first - 1):+.2f} %"))
            for label, value in found
        ]  # fmt: skip
        made.append(Table(name, ("one thing changed", "frequency", "against the first"), rows))
    return made
