"""Diagrams of `haptonic verify`: each shows all of the source's values that it can."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure
from seeing import artists, assert_readable

from haptonic.results.bands import Bands
from haptonic.verification import CaseComparison, cases, page
from simulated import reference_bands

DOCS = Path(__file__).parents[2] / "docs"


def drawn(name: str, monkeypatch: pytest.MonkeyPatch) -> tuple[Figure, list[float]]:
    """The diagram of a case over eight bands, which end below the source's upper edge, and the values."""
    case = cases([name])[0]
    study = SimpleNamespace(run=lambda analysis: Bands(reference_bands().isel(band=slice(8))))
    monkeypatch.setattr(page, "load_case_study", lambda name: study)
    comparisons = []
    for quantity in case.quantity:
        values = np.array(quantity.published_values)
        zeros = np.zeros_like(values)
        comparisons.append(CaseComparison(case, quantity, values, zeros, values[None], zeros[None]))
    return page.diagram(comparisons), [value for each in comparisons for value in each.reference]


@pytest.mark.parametrize("name", ["prototype", "reference-cell"])
def test_every_value_of_the_source_lies_within_the_axes(name, monkeypatch):
    figure, values = drawn(name, monkeypatch)
    seen = np.concatenate([np.ravel(line.get_ydata()) for line in artists(figure, "source")])
    assert set(np.round(values, 3)) == set(np.round(1e3 * seen, 3))
    assert max(seen) < figure.axes[0].get_ylim()[1]
    assert_readable(figure)


def test_the_edges_of_the_source_are_written_in_the_legend_of_the_bands(monkeypatch):
    figure, _ = drawn("prototype", monkeypatch)
    (legend,) = figure.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert texts == ["bands above band 8 are missing", "edges of the gap in the source, 52.9 and 61.4 kHz"]


def test_a_case_with_a_picture_has_a_value_on_its_path():
    pictured = [case for case in cases() if case.picture]
    assert pictured
    for case in pictured:
        assert any(each.measure.endswith("edge") or each.at in "GXMK" for each in case.quantity), case.id
    files = {file.stem for file in (DOCS / "images").glob("verify-*.png")}
    assert files == {f"verify-{case.id}" for case in pictured}
