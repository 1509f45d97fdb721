"""Comparison of the results with published values, as the example of the study gives them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from haptonic.plots.text import minus
from haptonic.report.against import NONE, ComparedValue
from haptonic.report.chapter import Absent, Chapter, Results, Table
from haptonic.units import hz_text, in_percent


def chapter(results: Results) -> Chapter | Absent:
    """Compare published values with the results; list the effect of single changes of the study."""
    known = results.references
    if known is None:
        return Absent("Comparison", "the study brings no reference values")
    head = ("Quantity", known.title[0].upper() + known.title[1:], "haptonic", "Difference", "Remark")
    compared = Table(
        f"Every number of {known.title}, and haptonic for the same study.",
        head,
        [row.cells for row in results.comparisons],
    )
    return Chapter(
        title=f"Comparison with {known.title}",
        identifier="comparison",
        paragraphs=(f"The source is {known.citation}. {known.about}",),
        findings=(_counted(results.comparisons),),
        tables=(compared, *_variants(results)),
    )


def _counted(rows: Sequence[ComparedValue]) -> str:
    """Count the values of each kind, and those that agree."""
    roles = Counter(row.role for row in rows)
    agree = sum(row.agrees is True for row in rows if row.role == "computed")
    differ = sum(row.agrees is False for row in rows if row.role == "computed")
    return (
        f"{len(rows)} values are published. {roles['computed']} of them are compared with computed ones: "
        f"{agree} agree, {differ} differ. {roles['input']} are inputs of the study. {roles['experiment']} "
        "are facts of the experiment, which haptonic does not compute."
    )


def _variants(results: Results) -> list[Table]:
    """Tables of the study with one change each; the first row is the unchanged study."""
    tables = []
    for name in dict.fromkeys(variant.table for variant, _ in results.variants):
        values = [(variant.label, value) for variant, value in results.variants if variant.table == name]
        first = next((value for _, value in values if value), None)
        rows = [
            (label, NONE, NONE) if value is None or first is None
            else (label, hz_text(value, form='.2f'), minus(in_percent(value / first - 1, form='+.2f')))
            for label, value in values
        ]  # fmt: skip
        tables.append(Table(name, ("one thing changed", "frequency", "against the first"), rows))
    return tables
