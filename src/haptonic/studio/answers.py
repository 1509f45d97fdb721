"""Parts of a result for the page, in plain values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from haptonic import plots
from haptonic.results.result import Result
from haptonic.results.table import Table
from haptonic.views import packed

MOST_ROWS = 500  # of a table on the page; files have all


def answer_of(result: Result) -> tuple[dict[str, Any], bytes | None]:
    """Sentences, tables and remarks of a result, and the bytes of its interactive view, if it has one."""
    view = result.view()
    about = {
        "title": result.title,
        "origin": result.origin,
        "summary": result.summary(),
        "tables": [_table(table) for table in result.tables()],
        "remarks": result.remarks(),
        "pictures": [{"name": name, "caption": text} for name, text in result.figures.captions.items()],
    }
    return about, None if view is None else packed(view)


def pictures_of(result: Result) -> Iterator[tuple[str, bytes]]:
    """The pictures of a result as SVG, by name, each drawn when it is asked for."""
    figures = result.figures
    for name in figures:
        yield name, plots.rendered(figures[name], "svg")


def _table(table: Table) -> dict[str, Any]:
    numeric = [
        any(not isinstance(cell, str | None) for cell in cells) for cells in zip(*table.rows, strict=True)
    ]
    return {
        "title": table.title,
        "head": list(table.head),
        "rows": table.texts[:MOST_ROWS],
        "count": len(table.rows),
        "numeric": numeric,
        "strong": sorted(table.strong),
    }
