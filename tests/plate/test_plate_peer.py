"""Whole plates against an independent finite-element library."""

import numpy as np
import pytest
import scipy.linalg as la
from small import PITCH, drawn
from whole import lossless

from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import Support

pytest.importorskip("ngsolve")

from peers.ngsolve_cell import PeerCell
from peers.ngsolve_plate import plate_frequencies

REFERENCE = PeerCell(7e-3, 7e-3, 1.5e-3, 3.5e-3, 14.7e-3, 70e9, 0.33, 2700.0)


@pytest.mark.nightly
@pytest.mark.parametrize("clamped", [False, True], ids=["free", "clamped"])
def test_a_plate_with_four_pillars_and_a_plain_strip_agrees_with_the_peer(clamped):
    supports = (Support("left", "clamped"),) if clamped else ()
    layout = drawn("o1o o1o")
    model = PlateModel.of(Plate(layout, supports), 70e3)
    rigid, count = 0 if clamped else 6, 30
    values = la.eigh(*lossless(model), eigvals_only=True, subset_by_index=(rigid, count - 1))
    own = np.sqrt(values) / (2 * np.pi)
    centres = [((j + 0.5) * PITCH, (i + 0.5) * PITCH) for i, j in layout.of("o")]
    peer = plate_frequencies(REFERENCE, (3 * PITCH, 2 * PITCH), centres, count, clamped=clamped)[rigid:]
    assert own[-1] > 50e3
    assert own == pytest.approx(peer, rel=3e-3)
