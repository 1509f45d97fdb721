"""Discs about an axis against an independent finite-element library."""

import numpy as np
import pytest
from strategies import ALUMINIUM

from haptonic.bloch import BlochModel, Resolution
from haptonic.cell import Disc, UnitCell
from haptonic.lattice import Lattice

pytest.importorskip("ngsolve")

from peers.ngsolve_discs import PeerDisc, frequencies
from stacks import STACKS

MM = 1e-3
PITCH, THICKNESS, COUNT = 7 * MM, 1.5 * MM, 8
KAPPAS = ((1.1, 2.3), (np.pi, 0.0))
CASES = STACKS | {
    "square hole": (Disc(3 * MM, section="square", empty=True),),
    "cross hole": (Disc(5 * MM, section="cross", arm_width=2 * MM, empty=True),),
}


def constants(solid):
    return solid.youngs_modulus, solid.poisson_ratio, solid.density


def peer(disc):
    return PeerDisc.of(disc, THICKNESS, None if disc.empty else constants(disc.material or ALUMINIUM))


@pytest.mark.nightly
@pytest.mark.parametrize("name", CASES)
def test_stacks_agree_with_the_peer(name):
    """Within what the peer's last order changed and the own error, and within half a percent as well."""
    discs = CASES[name]
    cell = UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, disc=discs)
    model = BlochModel.of(cell, Resolution(4, 1), COUNT, measured=False)
    peers = [
        frequencies(
            PITCH,
            THICKNESS,
            constants(ALUMINIUM),
            [peer(d) for d in discs],
            KAPPAS,
            COUNT,
            order=p,
            maxh=THICKNESS,
        )
        for p in (2, 3)
    ]
    for kappa, coarse, fine in zip(KAPPAS, *peers, strict=True):
        own = model.solve(np.array(kappa))
        assert (np.abs(own.frequency - fine) < np.abs(coarse - fine) + own.error).all()
        assert own.frequency == pytest.approx(fine, rel=5e-3)
