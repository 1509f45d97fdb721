"""Comparisons as a table, and as plain values for JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from haptonic.arrays import Array
from haptonic.results.table import Table
from haptonic.units import hz_text, in_percent
from haptonic.verification.comparison import CaseComparison

HEAD = ("case", "quantity", "source value", "haptonic", "difference", "allowed", "agrees")


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
    return _values_text(comparison.reference, comparison.quantity.unit, ".6g")


def computed_text(comparison: CaseComparison) -> str:
    """haptonic's values with the largest error; a range for a case with variations."""
    unit, values, errors = comparison.quantity.unit, comparison.computed, comparison.computed_error
    if len(values) > 1 and values.shape[1] == 1:
        return f"{_number(values.min(), unit)} to {_number(values.max(), unit)}, varied"
    text = _values_text(values[0], unit)
    if values.shape[1] == 1:
        return f"{text} ± {_number(errors[0, 0], unit, '.2g')}"
    return text


def percent_text(share: float, *, signed: bool = False) -> str:
    """A share in percent with two digits; a rounding error is 0."""
    if abs(share) < 1e-9:
        return "0 %"
    return f"{100 * share:{'+' if signed else ''}.2g} %"


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


def _values_text(values: Array, unit: str, form: str = ".5g") -> str:
    texts = [_number(value, unit, form) for value in values]
    return texts[0] if len(texts) == 1 else f"{texts[0]} to {texts[-1]} ({len(texts)} values)"


def _number(value: float, unit: str, form: str = ".5g") -> str:
    return hz_text(value, form=form) if unit == "Hz" else in_percent(value, form=".3g")
