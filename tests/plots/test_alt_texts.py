"""Alternative texts of the pictures of the gallery name what the axes show."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from test_designs import UNITS
from test_plate_pictures import FREQUENCY, GAP, IMPEDANCE

from haptonic import plots
from simulated import reference_bands, simulated_mirror, simulated_search

PAGE = (Path(__file__).parents[2] / "docs" / "gallery.md").read_text("utf-8")
ALTERNATIVES = {
    code.strip().splitlines()[-1]: alt
    for alt, code in re.findall(r"    alt: ([^\n]*)\n---\n(.*?)```", PAGE, re.DOTALL)
}
DRAWN = {
    'bands.plot("density_of_states")': lambda: plots.density_of_states(reference_bands()),
    'rows.plot("decay")': lambda: plots.decay(simulated_mirror()),
    "study.design().plot()": lambda: plots.search(simulated_search(), UNITS),
    'plate.plot("impedance-A1")': lambda: plots.impedance_spectrum(FREQUENCY[1:], IMPEDANCE, [GAP]),
}
UNNAMED = {"the", "per", "and", "khz", "dimensionless", "cell", "wavevector", "frequency"}


def words(text: str) -> set[str]:
    return set(re.findall(r"[a-z]{3,}", text.lower())) - UNNAMED


@pytest.mark.parametrize("code", DRAWN)
def test_a_text_names_the_quantities_of_the_axes(code):
    axes = DRAWN[code]().axes
    named = set().union(
        *(words(label) for panel in axes for label in (panel.get_xlabel(), panel.get_ylabel()))
    )
    assert named <= words(ALTERNATIVES[code]), named - words(ALTERNATIVES[code])
