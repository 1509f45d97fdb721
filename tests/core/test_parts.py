"""Tiles folded by a third of a turn or by the diagonal's mirror, against those folded by mirrors alone."""

import sys
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from strategies import ALUMINIUM
from test_superelement import exact_modes

from daily import daily
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.cell import Disc, Pillar, UnitCell
from haptonic.cell.pillar_parts import Step
from haptonic.lattice import Lattice
from haptonic.superelement import FoldedMesh, Tiling, class_parts, condense, parts
from plies import PLY


def arms(section):
    return Disc(5e-3, section=section, arm_width=1e-3, corner_radius=0.4e-3, empty=True)


HEXAGON = UnitCell(Lattice.triangular(7e-3), 2e-3, ALUMINIUM, Pillar(3.5e-3, 9e-3))
SQUARE = replace(HEXAGON, lattice=Lattice.square(7e-3))
HONEYCOMB = UnitCell(Lattice(lattice="honeycomb", pitch=12e-3), 2e-3, ALUMINIUM, Pillar(2.5e-3, 6e-3))
CELLS = {
    "hexagon": HEXAGON,
    "plain": HEXAGON.without_pillar(),
    "both faces": replace(HEXAGON, faces="both"),
    "triangle": HONEYCOMB,  # with one mirror along its axes
    "step": replace(HEXAGON, pillar=Pillar(3.5e-3, 9e-3, step=Step(2.5e-3, 5e-3))),
    "square": SQUARE,
    "square, both faces": replace(SQUARE, faces="both"),
    "hole": replace(HEXAGON, pillar=None, disc=(Disc(4e-3, empty=True),)),
    "snowflake": replace(HEXAGON, pillar=None, disc=(arms("snowflake"),)),
    "cross": replace(SQUARE, pillar=None, disc=(arms("cross"),)),
}


@pytest.mark.parametrize(
    "name",
    daily(CELLS, "plain", "square", "hole"),
)
def test_parts_and_mirrors_alone_condense_to_the_same(monkeypatch, name):
    cell, plans = CELLS[name], Resolution(1, 0).plans(CELLS[name])
    interior, substructured = (
        sys.modules[f"haptonic.superelement.{module}"] for module in ("interior", "substructured")
    )
    monkeypatch.setattr(interior, "interior_modes", partial(exact_modes, highest=1e7))
    used, tilings, parts_of_mesh = [], [], parts.parts_of_mesh

    def further(mesh):
        used.append(parts_of_mesh(mesh))
        return used[-1]

    for way in (further, lambda mesh: class_parts.whole_classes(mesh.assembler, mesh.rim)):
        monkeypatch.setattr(parts, "parts_of_mesh", way)
        substructured._feet.clear()
        tilings.append(Tiling.condensed(cell, plans, 2, 10))
    assert used
    assert all(any(not part.is_class for part in every) for every in used)
    traces = np.s_[: tilings[0].trace_size]
    motion = np.random.default_rng(0).standard_normal((tilings[0].trace_size, 2))
    for ours, theirs in [
        *((getattr(tiling, form)[traces, traces] for tiling in tilings) for form in ("stiffness", "mass")),
        *(
            (getattr(tiling.measures, form)[traces, traces] for tiling in tilings)
            for form in ("pillar_stiffness", "vertical_mass")
        ),
        [tiling.lifted(np.pad(motion, ((0, tiling.size - len(motion)), (0, 0)))) for tiling in tilings],
        [eigenpairs(lattice_pencil(tiling), np.array([0.9, 0.4]), 10)[0] for tiling in tilings],
    ]:
        assert np.abs(ours - theirs).max() <= 1e-9 * np.abs(theirs).max()


@pytest.mark.parametrize(
    "cell",
    [
        replace(HEXAGON, material=PLY),
        replace(HEXAGON, lattice=Lattice.oblique(7e-3, 6e-3, np.radians(70))),
        UnitCell(Lattice(lattice="kagome", pitch=12e-3), 2e-3, ALUMINIUM, Pillar(2.5e-3, 6e-3)),
    ],
    ids=["ply", "oblique", "kagome"],
)
def test_other_tiles_keep_their_mirrors(cell):
    meshes = [
        FoldedMesh.of(placed.tile, plan)
        for placed, plan in zip(cell.tiles, Resolution(1, 0).plans(cell), strict=True)
    ]
    assert all(part.is_class for mesh in meshes for part in parts.parts_of_mesh(mesh))


def test_the_six_turns_of_a_lattice_share_its_frequencies():
    """To rounding: by mirrors alone the rows of a representation get directions of their own."""
    pencil = lattice_pencil(Tiling.single(condense(HEXAGON, *Resolution(1, 1).plans(HEXAGON))))
    group = [np.linalg.inv(np.array(operation)).T for operation in HEXAGON.point_group.operations]
    assert len(group) == 12
    values = np.array([eigenpairs(pencil, turn @ np.array([0.9, 0.4]), 10)[0] for turn in group])
    assert np.abs(values / values[0] - 1).max() < 1e-8
