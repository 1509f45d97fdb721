"""Bands of other geometries against an independent finite-element library."""

import math
from typing import Any

import numpy as np
import pytest

from haptonic.bloch import BlochModel, Resolution
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

pytest.importorskip("ngsolve")

from peers.ngsolve_cell import PeerCell, meshed, meshed_sites

INSIDE, CORNER = (1.1, 0.4), (np.pi, np.pi)
COUNT = 8
# pitches, thickness, diameter, height (m), Young's modulus (Pa), Poisson ratio, density (kg/m^3)
GEOMETRIES = {
    "A": (5e-3, 5e-3, 1e-3, 3e-3, 6e-3, 70e9, 0.33, 2700.0),
    "B": (8e-3, 6e-3, 2e-3, 2.4e-3, 9e-3, 200e9, 0.30, 7850.0),
    "C": (4e-3, 4e-3, 0.8e-3, 1.2e-3, 10e-3, 64e9, 0.20, 2230.0),
}


def own_cell(name: str) -> UnitCell:
    pitch_x, pitch_y, thickness, diameter, height, modulus, poisson, density = GEOMETRIES[name]
    lattice = Lattice.square(pitch_x) if pitch_x == pitch_y else Lattice.rectangular(pitch_x, pitch_y)
    material = IsotropicMaterial(modulus, poisson, density, name=name)
    return UnitCell(lattice, thickness, material, Pillar(diameter, height))


@pytest.mark.parametrize(
    ("name", "kappa"),
    [
        pytest.param("A", INSIDE, marks=pytest.mark.nightly),
        pytest.param("A", CORNER, marks=pytest.mark.nightly),
        ("B", INSIDE),
        pytest.param("B", CORNER, marks=pytest.mark.nightly),
        pytest.param("C", CORNER, marks=pytest.mark.nightly),
        pytest.param("C", INSIDE, marks=pytest.mark.nightly),
    ],
    ids=lambda value: value if isinstance(value, str) else ("inside" if value == INSIDE else "corner"),
)
def test_frequencies_agree_with_the_peer(name, kappa):
    peer = meshed(PeerCell(*GEOMETRIES[name]), order=3).solve(kappa, COUNT).frequencies
    model = BlochModel.of(own_cell(name), Resolution(4, 1), COUNT, measured=False)
    assert model.solve(np.array(kappa)).frequency == pytest.approx(peer, rel=5e-3)


MM = 1e-3
MEMBERS = {
    "filleted cone": Pillar(3.5 * MM, 7 * MM, draft=math.radians(3), fillet=0.6 * MM),
    "square": Pillar(3 * MM, 6 * MM, "square"),
    "hexagon": Pillar(3 * MM, 6 * MM, "hexagon"),
    "turned ellipse": Pillar(3 * MM, 6 * MM, "ellipse", length=2 * MM, turn=0.5),
    "triangle": Pillar(2 * MM, 6 * MM, "polygon", sides=3),
    "turned rectangle": Pillar(3 * MM, 6 * MM, "rectangle", length=4 * MM, turn=math.pi / 6),
}


def shape_of(pillar: Pillar) -> dict[str, Any]:
    """The section and its size in the words of the peer: corners or half-axes where it has no name for it."""
    outline, radius = pillar.outline, pillar.radius
    if pillar.section in ("round", "square"):
        return {"section": pillar.section, "diameter": pillar.diameter}
    if outline.joints:
        corners = radius * outline.at(np.arange(outline.joints, dtype=float))
        return {"diameter": 2 * radius, "corners": tuple((x, y) for x, y in corners.tolist())}
    (large, small), (x, y) = outline.half_axes
    return {"diameter": 2 * radius, "ellipse": (radius * large, radius * small, math.atan2(y, x))}


@pytest.mark.nightly
@pytest.mark.parametrize("pillar", MEMBERS.values(), ids=MEMBERS)
def test_members_of_the_pillar_family_agree_with_the_peer(pillar):
    """Within the change by the peer's last order plus our own error estimate."""
    metal = IsotropicMaterial(70e9, 0.33, 2700.0, name="metal")
    cell = UnitCell(Lattice.square(7 * MM), 1.5 * MM, metal, pillar)
    model = BlochModel.of(cell, Resolution(4, 1), COUNT, measured=False)
    same = PeerCell(
        pitch_x=7 * MM, pitch_y=7 * MM, thickness=1.5 * MM, height=pillar.height, youngs_modulus=70e9,
        poisson_ratio=0.33, density=2700.0, draft=pillar.draft, fillet=pillar.fillet, **shape_of(pillar),
    )  # fmt: skip
    lower, higher = meshed(same, order=3), meshed(same, order=4)
    for kappa in ((0.0, 0.0), CORNER):
        moving = slice(3, None) if kappa != CORNER else slice(None)  # at Gamma the cell may just move away
        coarse, fine = (peer.solve(kappa, COUNT).frequencies[moving] for peer in (lower, higher))
        own = model.solve(np.array(kappa))
        allowed = np.abs(coarse - fine) + own.error[moving]
        assert (np.abs(own.frequency[moving] - fine) < allowed).all()
        assert (allowed < 0.02 * fine).all()


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["honeycomb", "kagome"])
def test_cells_with_several_pillars_agree_with_the_peer(name):
    """Each of another height; within half a percent."""
    metal = IsotropicMaterial(70e9, 0.33, 2700.0, name="metal")
    heights = [4 * MM, 5 * MM, 6 * MM][: 2 if name == "honeycomb" else 3]
    lattice = Lattice(lattice=name, pitch=7 * MM)
    site = tuple(Site(pillar=Pillar(1.6 * MM, height)) for height in heights)
    cell = UnitCell(lattice, 1.5 * MM, metal, site=site)
    model = BlochModel.of(cell, Resolution(4, 1), COUNT, measured=False)
    same = PeerCell(7 * MM, 7 * MM, 1.5 * MM, 1.6 * MM, 5 * MM, 70e9, 0.33, 2700.0)
    # the sites moved together, so that no foot crosses the parallelogram
    places = ((cell.shares + (0.0 if name == "honeycomb" else 0.25)) % 1.0) @ lattice.vectors
    peer = meshed_sites(same, lattice.vectors, places, heights)
    for kappa in (INSIDE, (2 * np.pi / 3, 4 * np.pi / 3)):
        expected = peer.solve(kappa, COUNT).frequencies
        assert model.solve(np.array(kappa)).frequency == pytest.approx(expected, rel=5e-3)
