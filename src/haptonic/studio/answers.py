"""Parts of a result for the page, in plain values."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

from haptonic.later import xarray as xr
from haptonic.results.result import Result
from haptonic.results.table import Cell, Column, Ranged, Table, Uncertain
from haptonic.views import InteractiveView, packed

MOST_ROWS = 500  # of a table on the page; files have all


def answer_of(result: Result) -> tuple[dict[str, Any], bytes | None]:
    """Sentences, tables and remarks of a result, and the bytes of its interactive view, if it has one."""
    view = result.view()
    about = {
        "title": result.title,
        "origin": result.origin,
        "summary": result.summary(),
        "tables": [plain_table(table) for table in result.tables()],
        "remarks": result.remarks(),
        "files": [str(name) for name in result.files],
        "pictures": [{"name": name, "caption": text} for name, text in result.figures.captions.items()],
    }
    return about, None if view is None else packed(view)


def packed_part(kind: str, dataset: xr.Dataset) -> bytes:
    """Bytes of a dataset for a view that is shown: its curves before it is complete, or a preview."""
    return packed(InteractiveView(kind=kind, title="", dataset=dataset))


def plain_table(table: Table) -> dict[str, Any]:
    """A table in plain values: texts for the page, and raw cells for comparisons."""
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
        "columns": [asdict(column) for column in table.columns],
        "cells": [[_plain(cell) for cell in row] for row in table.rows[:MOST_ROWS]],
    }


def table_of(plain: dict[str, Any]) -> Table:
    """The table whose plain values the page has."""
    columns = [Column(**column) for column in plain["columns"]]
    return Table(plain["title"], columns, [[_cell(cell) for cell in row] for row in plain["cells"]])


def _plain(cell: Cell) -> Any:
    """A cell as plain values; a number that is not finite is None."""
    if isinstance(cell, Uncertain | Ranged):
        return {name: _plain(value) for name, value in asdict(cell).items()}
    return None if isinstance(cell, float) and not math.isfinite(cell) else cell


def _cell(plain: Any) -> Cell:
    if not isinstance(plain, dict):
        return plain  # type: ignore[no-any-return]  # written by `_plain`
    if "error" not in plain:
        return None if None in (plain["low"], plain["high"]) else Ranged(**plain)
    return None if None in (plain["value"], plain["error"]) else Uncertain(**plain)
