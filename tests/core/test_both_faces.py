"""Cells with pillars on both faces: parity in the plate's middle plane, and gaps of one parity."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import scipy
from brute import assembled, frequencies, periodic_projection
from strategies import ALUMINIUM, reference_cell

from daily import daily
from five_parts import assert_explained
from haptonic.bloch import BlochModel, Resolution, bands_dataset, gaps_of
from haptonic.bloch.gaps import complete_gaps, parity_gaps
from haptonic.bloch.guide import Guide
from haptonic.bloch.layers import OUTGOING, Interface
from haptonic.bloch.mirrors import condensed_rows
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.bloch.tracking import diagram
from haptonic.bloch.wall import Wall
from haptonic.cell import Pillar, UnitCell, mesh_cell
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from plies import SKEWED

EMPTY = json.loads((Path(__file__).parents[1] / "data" / "empty_lattice.json").read_text("utf-8"))["points"]
PARITY = {"A0": -1, "S0": 1, "SH0": 1}
# its complete gap lies where one of symmetric waves and one of antisymmetric ones overlap
LOW = UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 4e-3), faces="both")
SITES = UnitCell(Lattice("honeycomb", 6e-3), 1e-3, ALUMINIUM, Pillar(2.5e-3, 3e-3), faces="both")
CELLS = {
    "square": LOW,
    "two sites": SITES,
    "turned only": replace(LOW, lattice=Lattice.rectangular(8e-3, 6e-3), material=SKEWED),
}
KAPPA = np.array([1.3, 0.4])


@cache
def model(name: str = "square", order: int = 3) -> BlochModel:
    return BlochModel.of(CELLS[name], Resolution(order, 1), 10)


@cache
def plain() -> BlochModel:
    cell = replace(reference_cell().without_pillar(), faces="both")
    return BlochModel.of(cell, Resolution(4, 0), 13, measured=False)


@pytest.mark.parametrize(("point", "kappa"), [("Gamma", (0.0, 0.0)), ("G-X mid", (0.5, 0.0))])
def test_waves_of_a_plain_plate_have_the_parity_of_their_family(point, kappa):
    """Rayleigh and Lamb's waves, folded: antisymmetric those of A0, symmetric those of S0 and SH0."""
    plate_model = plain()
    solution = plate_model.solve(np.pi * np.array(kappa))
    waves = EMPTY[point][:13]
    exact = np.array([wave["hz"] for wave in waves])
    moving = exact > 0
    true = np.abs(solution.frequency - exact)
    assert (true < solution.error)[moving].all()
    assert (solution.error < 6e-3 * exact)[moving].all()
    assert np.median(solution.error[moving] / exact[moving]) < 1e-3
    signs = plate_model.fine.parity(solution.modes)
    assert np.array_equal(signs[moving], np.array([PARITY[wave["wave"]] for wave in waves])[moving])
    assert sorted(signs[~moving]) == sorted(PARITY[wave["wave"]] for wave in waves if not wave["hz"])


@pytest.mark.parametrize("name", daily(CELLS, "turned only"))
def test_the_label_of_a_mode_is_that_of_its_field(name):
    """Every lifted field is its own image in the middle plane, or the opposite of it."""
    own = model(name, 3 if name == "square" else 2)
    cell, fine, solution = CELLS[name], own.fine, own.solve(KAPPA)
    field, points = fine.tiling.lifted(solution.fields), fine.tiling.points
    distance, image = scipy.spatial.cKDTree(points).query(points * [1, 1, -1] + [0, 0, cell.thickness])
    assert distance.max() < 1e-9 * cell.lattice.pitch
    turned = field[image] * np.array([1.0, 1.0, -1.0])[:, None]
    signs = fine.parity(solution.modes)
    assert np.abs(turned - signs * field).max() < 1e-9 * np.abs(field).max()
    assert set(signs) == {-1, 1}
    for parity, half in own.halves.items():
        these = solution.frequency[signs == parity][: half.count]
        assert half.solve(KAPPA).frequency == pytest.approx(these, rel=1e-9)


def test_either_parity_is_the_half_plate_held_in_its_middle_plane():
    """A mesh of the half above it, without w there or without u and v, against the labels of the whole.

    Nothing of the folding or of the trace is in it.
    """
    (plan,) = Resolution(2, 1).plans(LOW)
    thin = replace(LOW, thickness=0.5 * LOW.thickness, faces="one")
    mesh = mesh_cell(thin, plan)
    K, mass = assembled(mesh, ALUMINIUM)
    P = periodic_projection(mesh.points, LOW.lattice.vectors, KAPPA)
    in_plane = np.repeat(mesh.points[:, 2] < 1e-12, 3).reshape(-1, 3)
    solution = model(order=2).solve(KAPPA)
    signs = model(order=2).fine.parity(solution.modes)
    for parity, held in ((1, [False, False, True]), (-1, [True, True, False])):
        free = np.flatnonzero(~(in_plane & held).ravel())
        rows = P.tocsr()[free]
        used = np.flatnonzero(np.diff(rows.tocsc().indptr))
        exact = frequencies(K.tocsr()[free][:, free], mass[free], rows[:, used], (signs == parity).sum())
        assert solution.frequency[signs == parity] == pytest.approx(exact, rel=1e-2)


@pytest.mark.nightly
def test_estimates_hold_against_a_finer_mesh():
    finer = model(order=4)
    for kappa in (KAPPA, np.array([np.pi, 0.0])):
        solution, better = model().solve(kappa), finer.solve(kappa)
        assert (np.abs(solution.frequency - better.frequency) <= solution.error + better.error).all()
        assert (solution.error < 0.03 * solution.frequency)[solution.frequency > 1].all()


def test_gaps_of_one_parity_hold_for_its_waves_and_for_no_others():
    """A dense walk over the zone: in the gap of symmetric waves there are antisymmetric ones alone."""
    gaps = parity_gaps(model(), complete_gaps(model()))
    assert gaps
    rng = np.random.default_rng(3)
    walk = [model().solve(kappa) for kappa in rng.uniform(-np.pi, np.pi, (150, 2))]
    for gap in gaps:
        assert gap.certain
        assert not gap.complete
        own = {"symmetric": 1, "antisymmetric": -1}[gap.waves]
        inside = {1: 0, -1: 0}
        for solution in walk:
            for parity in inside:
                these = solution.frequency[model().fine.parity(solution.modes) == parity]
                inside[parity] += sum(map(gap.holds, these))
                if parity == own:
                    below = (these < 0.5 * (gap.lower + gap.upper)).sum()
                    assert below == gap.between[0], "bands are counted among those of the parity"
        assert inside[own] == 0
        assert inside[-own] > 0


def test_a_complete_gap_is_one_of_both_parities():
    (complete,) = (gap for gap in complete_gaps(model()) if gap.between == (5, 6))
    edges = [
        (gap.lower, gap.upper)
        for half in model().halves.values()
        for gap in complete_gaps(half)
        if gap.lower < complete.centre < gap.upper
    ]
    (low_1, high_1), (low_2, high_2) = edges
    assert max(low_1, low_2) == pytest.approx(complete.lower, rel=1e-4)
    assert min(high_1, high_2) == pytest.approx(complete.upper, rel=1e-4)


def test_a_dataset_contains_the_parity_of_bands_corners_and_modes():
    settings = BandSettings(count=10, points=13, mesh=MeshSettings(3, 0))
    dataset = bands_dataset(LOW, settings)
    middle = dataset["middle_parity"].values
    assert set(np.unique(middle)) == {-1, 1}
    for branch in np.unique(dataset["branch"].values):
        assert len(np.unique(middle[dataset["branch"].values == branch])) == 1, "none changes its parity"
    labels = dataset["corner_symmetry"].values
    for corner, row in zip(json.loads(dataset.attrs["path_corners"]), labels, strict=True):
        for sign, label in zip(middle[corner], row, strict=True):
            assert label.endswith(({1: ", symmetric", -1: ", antisymmetric"}[sign], "translation"))
    assert set(dataset["mode_parity"].values) == {-1, 1}
    listed = [gap for gap in gaps_of(dataset) if gap.waves != "all"]
    assert listed
    assert {gap.direction for gap in listed} == {"all"}


def test_modes_at_a_crossing_keep_their_parity():
    """Where a symmetric band crosses an antisymmetric one, modes of one frequency keep their labels."""
    path = LOW.zone.path(40)
    along = diagram(model(), path)
    crossed = 0
    for band in range(9):
        between = np.diff(along.middle[:, band])
        crossed += int((between != 0).sum())
    assert crossed > 5
    assert (along.middle != 0).all()


def test_rows_keep_flexural_waves_apart_from_the_others():
    """In the gap of antisymmetric waves alone rows stop A0 and transmit S0; neither becomes the other.

    With pillars on one face, and the same everything else, both do.
    """
    gap = next(gap for gap in complete_gaps(model().halves[-1]) if gap.width > 0.3 * gap.centre)
    omega = 2 * np.pi * 0.86e5
    assert gap.holds(0.86e5)
    mixed = {}
    for faces in ("both", "one"):
        rows = condensed_rows(replace(LOW, faces=faces), Resolution(3, 0))
        scattering = Interface.of(rows, 0.0).scattering(omega, 3, ("A0", "S0"))
        of_a0, of_s0 = (energy[-1] for energy in scattering.transmitted.swapaxes(0, 1))
        to_other = of_a0[OUTGOING.index("S0")] + of_s0[OUTGOING.index("A0")]
        mixed[faces] = to_other
        if faces == "both":
            assert of_a0.sum() < 1e-3
            assert of_s0.sum() > 0.1
            reflected = scattering.reflected[-1].sum(axis=1) + scattering.transmitted[-1].sum(axis=1)
            assert reflected == pytest.approx(np.ones(2), abs=1e-6)
    assert mixed["both"] < 1e-12
    assert mixed["one"] > 1e-3


def test_a_strip_guides_flexural_waves_whatever_runs_in_its_plane():
    """Pillars on both faces turn none into in-plane waves, which run as well where the wave is long along."""
    cell = replace(LOW, pillar=Pillar(3.5e-3, 14.7e-3))
    omega, along = 2 * np.pi * 77e3, 60.0  # where symmetric waves enter the lattice
    both, one_face = (
        Guide.of(condensed_rows(replace(cell, faces=faces), Resolution(2, 0)), along)
        for faces in ("both", "one")
    )
    running, _ = both.interface.plate_waves(omega)
    assert {"A0", "S0", "SH0"} <= set(running.label)
    wall = Wall.of(both.interface, omega)
    assert abs(wall.reflection[wall.flexural, wall.flexural]) == pytest.approx(1.0, abs=1e-9)
    # held at the fixed lines, the strip is about half a wave wide between them
    assert both.width(omega, 0) + 2 * wall.fixed_line == pytest.approx(np.pi / wall.wavenumber, rel=0.2)
    with pytest.raises(StudyError) as caught:
        one_face.width(omega, 0)
    assert_explained(caught.value, "in-plane waves", argument="waveguide.mode")
