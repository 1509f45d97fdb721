"""Slopes of a gap's edges: those of the bands beside it, whatever mesh the gap itself was found on."""

import numpy as np
import pytest

from haptonic.analyses.runner import design_gaps
from haptonic.bloch import gaps_of
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.design.edges import edge_slopes
from haptonic.design.parameters import values_of
from haptonic.design.quick import QuickDesign
from simulated import reference_study

PATHS = ("cell.pillar.height", "material.density")


def band_frequency(cell, kappa, number):
    pencil = QuickDesign.of(cell, 8).model.fine.pencil
    return float(np.sqrt(eigenpairs(pencil, kappa, number)[0][-1])) / (2 * np.pi)


@pytest.mark.nightly
def test_slopes_are_differences_of_the_bands_even_if_the_gap_is_from_a_coarse_mesh():
    """On this mesh the lower edge lies 2 kHz too high, nearer to nothing than to another band."""
    cell = reference_study().cell
    dataset = design_gaps((cell, BandSettings(8, 13, 2e-2, MeshSettings(2, 0))))
    gap = next(gap for gap in gaps_of(dataset) if gap.complete and gap.between == (6, 7))
    slopes = edge_slopes(cell, gap, PATHS)
    own = values_of(cell)
    assert abs(gap.lower - band_frequency(cell, np.array(gap.lower_kappa), 6)) > 1e3
    for path, pair in zip(PATHS, slopes, strict=True):
        step = 1e-3 * own[path]  # eigenvalues at the zone's centre are right to some 1e-7
        for kappa, number, slope in ((gap.lower_kappa, 6, pair[0]), (gap.upper_kappa, 7, pair[1])):
            below, above = (
                band_frequency(cell.with_numbers({path: own[path] + d}), np.array(kappa), number)
                for d in (-step, step)
            )
            assert slope == pytest.approx((above - below) / (2 * step), rel=1e-3), (path, number)
