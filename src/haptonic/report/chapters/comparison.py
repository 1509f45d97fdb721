"""What somebody else found beside ours, as the study's example brings it."""

from __future__ import annotations

from typing import Any

from haptonic.plots.text import minus
from haptonic.report.chapter import Absent, Chapter, Results, Table
from haptonic.results.references import Value, found_at

NONE = "-"  # no difference to give


def chapter(results: Results) -> Chapter | Absent:
    """Reference, haptonic, difference, why; then what one thing changed at a time moves."""
    known = results.references
    if known is None:
        return Absent("Comparison", "the study brings no reference values")
    answers = {name: one.to_json() for name, one in results.parts.items()}
    rows = [_row(one, answers.get(one.analysis, {})) for one in known.value]
    head = ("Quantity", known.title[0].upper() + known.title[1:], "haptonic", "Difference", "Why")
    compared = Table(f"{head[1]} and haptonic, for the same study.", head, rows)
    return Chapter(
        title=f"Comparison with {known.title}",
        identifier="comparison",
        paragraphs=(f"It is {known.citation}. {known.about}",),
        tables=(compared, *_variants(results)),
    )


def _row(value: Value, answer: dict[str, Any]) -> tuple[str, str, str, str, str]:
    ours = found_at(answer, value.path) if value.path else None
    if ours is None:
        return (value.quantity, value.value, NONE, NONE, value.remark)
    theirs = value.number
    if theirs is None or not isinstance(ours, int | float):
        shown = " and ".join(map(str, ours)) if isinstance(ours, list) else str(ours)
        same = "none" if shown == value.value else "differ"
        return (value.quantity, value.value, shown, same, value.remark)
    number, _, unit = value.value.partition(" ")
    scale = float(number) / theirs
    error = found_at(answer, value.error) if value.error else None
    doubt = f" ± {error * scale:.2g}" if error else ""
    off = ours - theirs
    remark = "Agrees within our error." if error and abs(off) <= error else value.remark
    difference = minus(" ".join(filter(None, (f"{off * scale:+.2f}", unit, f"({off / theirs:+.1%})"))))
    return (value.quantity, value.value, f"{ours * scale:.2f}{doubt} {unit}".rstrip(), difference, remark)


def _variants(results: Results) -> list[Table]:
    """A table for each name of them, its first row being what the others are compared with."""
    made = []
    for name in dict.fromkeys(one.table for one, _ in results.variants):
        found = [(one.label, value) for one, value in results.variants if one.table == name]
        first = next((value for _, value in found if value), None)
        rows = [
            (label, NONE, NONE) if value is None or first is None
            else (label, f"{value / 1e3:.2f} kHz", minus(f"{100 * (value / first - 1):+.2f} %"))
            for label, value in found
        ]  # fmt: skip
        made.append(Table(name, ("one thing changed", "frequency", "against the first"), rows))
    return made
