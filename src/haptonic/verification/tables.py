"""Comparisons as a table, and as plain values for JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from haptonic.plots.text import band_text, minus
from haptonic.results.table import Table
from haptonic.units import hz_text, in_percent, uncertain
from haptonic.verification.comparison import CaseComparison

HEAD = ("case", "quantity", "source value", "haptonic", "difference", "allowed", "agrees")
LEAST_SHARE = 1e-6  # differences below it are shown as 0: they are smaller than every error of the table


def comparison_table(comparisons: Sequence[CaseComparison]) -> Table:
    """A row for each quantity of each case; a row that does not agree is marked."""
    rows = [
        (
            comparison.case.id,
            comparison.quantity.name,
            reference_text(comparison),
            computed_text(comparison),
            percent_text(comparison.signed_difference, signed=True),
            percent_text(comparison.allowed),
            "yes" if comparison.agrees else "no",
        )
        for comparison in comparisons
    ]
    marked = [number for number, comparison in enumerate(comparisons) if not comparison.agrees]
    return Table("published and exact cases", HEAD, rows, marked)


def reference_text(comparison: CaseComparison) -> str:
    """The source's value; for several values, the first, the last and their number."""
    values = comparison.reference
    if comparison.quantity.unit != "Hz":
        return in_percent(values[0], form=".3g")
    if len(values) == 1:
        return hz_text(values[0], form=".6g")
    return f"{hz_text(values[0], values[-1], form='.6g')} ({len(values)} values)"


def computed_text(comparison: CaseComparison) -> str:
    """haptonic's value with its error, the first and the last of several, or the range of a varied case."""
    values, errors, count = comparison.computed, comparison.computed_error, comparison.computed.shape[1]
    in_hertz = comparison.quantity.unit == "Hz"
    if len(values) > 1 and count == 1:
        ends = values.min(), values.max()
        return f"{hz_text(*ends, form='.5g') if in_hertz else in_percent(*ends, form='.3g')}, varied"
    if not in_hertz:
        return f"{uncertain(100 * values[0, 0], 100 * errors[0, 0])} %"
    if count == 1:
        return hz_text(values[0, 0], error=errors[0, 0])
    return f"{band_text(values[0, 0], errors[0, 0], values[0, -1], errors[0, -1])} ({count} values)"


def percent_text(share: float, *, signed: bool = False) -> str:
    """A share in percent with two digits and at most four decimals."""
    if abs(share) < LEAST_SHARE:
        return "0 %"
    return minus(f"{100 * share:{'+' if signed else ''}.2g} %")


def plain_comparison(comparison: CaseComparison) -> dict[str, Any]:
    """Values of a comparison in SI units."""
    return {
        "case": comparison.case.id,
        "title": comparison.case.title,
        "kind": comparison.case.kind,
        "source": comparison.case.source,
        "quantity": comparison.quantity.name,
        "unit": comparison.quantity.unit,
        "reference": comparison.reference.tolist(),
        "reference_error": comparison.reference_error.tolist(),
        "computed": comparison.computed.tolist(),
        "computed_error": comparison.computed_error.tolist(),
        "difference": comparison.signed_difference,
        "allowed": comparison.allowed,
        "agrees": comparison.agrees,
        "remark": comparison.case.remark,
    }
