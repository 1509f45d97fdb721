"""Any wavevector is carried into the irreducible zone, and what is computed there turned back."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import scipy.sparse as sp
import scipy.spatial
from brute import assembled, periodic_projection
from hypothesis import given, settings, strategies as st
from strategies import lattices

from daily import daily
from five_parts import refused
from haptonic.bloch import BlochModel, Resolution, mode_shapes
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.reduced import ReducedCell
from haptonic.bloch.representative import IDENTITY, Representative, images, signed_operations
from haptonic.bloch.ribbon import ACROSS, bulk_bands
from haptonic.bloch.tracking import group_velocity
from haptonic.bloch.truncation import REST
from haptonic.cell import Pillar, Ribbon, UnitCell
from haptonic.cell.sites import Site
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.superelement import TiledMesh

MM = 1e-3
STEEL, SILICON = material("steel"), material("silicon")
WIDE, SLIM = Pillar(2.6 * MM, 6 * MM), Pillar(1.8 * MM, 5 * MM)
ORDER = Resolution(2, 0)


def cell_of(lattice, *sites, of=STEEL, pillar=WIDE, faces="one"):
    """A steel plate with a pillar in each period, or with sites (x, y, pillar)."""
    site = tuple(Site(at=(x, y), pillar=on_site) for x, y, on_site in sites)
    return UnitCell(lattice, 1.2 * MM, of, None if site else pillar, site, faces)


def named(name, pitch, *pillars):
    return UnitCell(
        Lattice(lattice=name, pitch=pitch), 1.2 * MM, STEEL,
        None if pillars else SLIM, tuple(Site(pillar=pillar) for pillar in pillars),
    )  # fmt: skip


SQUARE, TRIANGULAR = Lattice.square(6 * MM), Lattice.triangular(6 * MM)
CELLS = {
    "square": cell_of(SQUARE),
    "square, both faces": cell_of(SQUARE, faces="both"),
    "rectangular": cell_of(Lattice.rectangular(6 * MM, 7.3 * MM)),
    "triangular": cell_of(TRIANGULAR),
    "triangular, both faces": cell_of(TRIANGULAR, faces="both"),
    "silicon on a triangular lattice": cell_of(TRIANGULAR, of=SILICON),
    "centred": cell_of(Lattice.centred(7 * MM, 9 * MM)),
    "oblique": cell_of(Lattice.oblique(6 * MM, 7 * MM, 1.35)),
    "honeycomb": named("honeycomb", 8 * MM),
    "unequal honeycomb": named("honeycomb", 8 * MM, SLIM, WIDE),
    "kagome": named("kagome", 9 * MM),
    "glide": cell_of(Lattice.rectangular(7 * MM, 6 * MM), (0.2, 0.3, SLIM), (0.7, 0.7, SLIM)),
    "diagonal": cell_of(Lattice.square(9 * MM), (0.15, 0.6, SLIM), (0.6, 0.15, SLIM)),
    "anywhere": cell_of(Lattice.square(8 * MM), (0, 0, WIDE), (0.4, 0.45, SLIM)),
}
# both faces, several tiles and a glide; the others at night
DAILY = ("triangular, both faces", "unequal honeycomb", "glide")
by_name = pytest.mark.parametrize("name", daily(CELLS, *DAILY))
phases = st.tuples(*2 * [st.floats(-6 * np.pi, 6 * np.pi)]).map(np.array)
whole_steps = st.tuples(*2 * [st.integers(-3, 3)]).map(np.array)
some_names = st.sampled_from(sorted(CELLS))


@cache
def model(name):
    return BlochModel.of(CELLS[name], ORDER, 6, measured=False)


def unreduced(the_model, kappa, count=6):
    """Frequencies (Hz) and nodal fields of the pencil before any reduction, at the wavevector itself."""
    tiling = the_model.fine.tiling
    pencil = lattice_pencil(tiling)
    values, modes = eigenpairs(pencil, kappa, count)
    return hertz(values), tiling.lifted(pencil.fields(modes, kappa))


def drawn(name, count):
    """(count, 2) wavevectors over several zones."""
    return np.random.default_rng(sorted(CELLS).index(name)).uniform(-4 * np.pi, 4 * np.pi, (count, 2))


# --- the wavevector -----------------------------------------------------------------------------------------


@given(lattices(), phases, st.booleans())
@settings(deadline=None)
def test_every_wavevector_has_an_equivalent_in_the_zone(lattice, kappa, anisotropic):
    plate = UnitCell(lattice, 1 * MM, SILICON if anisotropic else STEEL)
    representative = Representative.of(plate.zone, plate.point_group, kappa)
    assert plate.zone.depth(representative.kappa[None])[0] >= -1e-5
    assert (representative.operation, representative.sign) in signed_operations(plate.point_group)
    back = representative.sign * np.linalg.inv(np.array(representative.operation)).T @ representative.kappa
    steps = (kappa - back) / (2 * np.pi)
    assert steps == pytest.approx(np.round(steps), abs=1e-9)
    assert (representative.image == kappa).all()


@given(some_names, st.floats(0, 1), st.floats(0, 1), whole_steps)
@settings(deadline=None)
def test_one_in_the_zone_is_its_own_and_a_reciprocal_translation_turns_nothing(name, first, second, steps):
    cell = CELLS[name]
    corners = list(cell.zone.corner_phases.values())
    a, b, c = corners[0], corners[1], corners[-1]
    kappa = a + first * (b - a) + (1 - first) * second * (c - a)
    here = Representative.of(cell.zone, cell.point_group, kappa)
    assert here.kappa is here.image
    there = Representative.of(cell.zone, cell.point_group, kappa + 2 * np.pi * steps)
    if cell.zone.depth(kappa[None])[0] > 1e-6:
        assert there.operation == IDENTITY
        assert there.sign == 1
        assert there.kappa == pytest.approx(kappa, abs=1e-12)


@pytest.mark.parametrize(
    "kappa", [np.array([np.nan, 1.0]), np.array([1.0]), np.zeros((3, 2)), np.array([1e12, 0]), np.inf]
)
def test_what_is_no_wavevector_is_refused(kappa):
    cell = CELLS["square"]
    refused(
        lambda: Representative.of(cell.zone, cell.point_group, kappa),
        code="malformed", argument="kappa", kind=StudyError,
    )  # fmt: skip


def test_the_images_of_the_zone_fill_the_period_evenly():
    """Each wavevector of a fine grid over one period is the image of one in the zone."""
    for cell in CELLS.values():
        grid = np.stack(np.meshgrid(*2 * [np.linspace(-3, 3, 5)]), axis=-1).reshape(-1, 2)
        inside = np.array([Representative.of(cell.zone, cell.point_group, kappa).kappa for kappa in grid])
        kappas, number = images(cell.point_group, inside)
        for number_in_grid, kappa in enumerate(grid):
            steps = (kappas[number == number_in_grid] - kappa) / (2 * np.pi)
            assert np.abs(steps - np.round(steps)).max(axis=1).min() < 1e-9


# --- frequencies --------------------------------------------------------------------------------------------


@given(st.sampled_from(DAILY), phases, st.integers(0, 23), whole_steps)
@settings(max_examples=6)
def test_equivalent_wavevectors_have_the_same_frequencies(name, kappa, which, steps):
    the_model = model(name)
    signed = signed_operations(the_model.cell.point_group)
    operation, sign = signed[which % len(signed)]
    other = sign * np.linalg.inv(np.array(operation)).T @ kappa + 2 * np.pi * steps
    here, there = the_model.solve(kappa), the_model.solve(other)
    least = REST * the_model.highest
    assert there.frequency == pytest.approx(here.frequency, rel=1e-7, abs=least)
    assert there.frequency == pytest.approx(the_model.frequencies(other), rel=1e-7, abs=least)
    moving = here.frequency > 0.01 * the_model.highest
    assert there.error[moving] == pytest.approx(here.error[moving], rel=1e-3)


@by_name
def test_over_several_zones_the_basis_adds_no_more_than_it_was_allowed(name):
    the_model = model(name)
    for kappa in drawn(name, 5):
        exact, _ = unreduced(the_model, kappa)
        solution = the_model.solve(kappa)
        assert (np.abs(solution.frequency - exact) <= solution.error).all()
        # the interior's short space has not all symmetries of the mesh: up to 1e-4 of a frequency
        assert solution.frequency == pytest.approx(exact, rel=1e-3, abs=REST * the_model.highest)


def test_the_same_point_of_a_triangle_has_one_value():
    """Its three points M had three frequencies, further apart than their errors."""
    points = np.pi * np.array([(1, 1), (-1, 1), (1, 0), (0, -1), (3, 1), (1, 2)])
    frequency = np.array([model("triangular").frequencies(point) for point in points])
    assert frequency == pytest.approx(np.broadcast_to(frequency[0], frequency.shape), rel=1e-9)


def test_bulk_bands_are_those_of_the_unreduced_pencil():
    """The phases across a ribbon leave the irreducible zone."""
    the_model, ribbon = model("triangular"), Ribbon((CELLS["triangular"],) * 3)
    bulk = bulk_bands(the_model, ribbon, [1.9])[0]
    exact = np.array([
        unreduced(the_model, kappa)[0] for kappa in ribbon.phases(1.9, np.linspace(-np.pi, np.pi, ACROSS))
    ])  # fmt: skip
    allowed = 5 * the_model.fine.projection_error
    assert bulk == pytest.approx(np.stack([exact.min(axis=0), exact.max(axis=0)], axis=1), rel=allowed)


# --- fields turned back -------------------------------------------------------------------------------------


@by_name
def test_fields_are_those_of_the_unreduced_pencil(name):
    the_model = model(name)
    for kappa in drawn(name, 3):
        solution = the_model.solve(kappa)
        fields = the_model.displacement(solution)
        frequency, exact = unreduced(the_model, kappa)
        apart = np.diff(frequency, prepend=-np.inf, append=np.inf)
        alone = np.minimum(apart[:-1], apart[1:]) > 0.02 * frequency
        assert alone.any()
        for number in np.flatnonzero(alone):
            field, other = fields[..., number].ravel(), exact[..., number].ravel()
            likeness = abs(np.vdot(field, other)) ** 2 / (np.vdot(field, field) * np.vdot(other, other)).real
            assert likeness > 0.99999


@pytest.mark.parametrize("name", daily(["triangular", "unequal honeycomb", "glide"], "unequal honeycomb"))
def test_turned_fields_fulfil_the_equations_of_the_whole_mesh(name):
    """As well as those in the zone do, in which nothing is turned: to rounding."""
    cell = CELLS[name]
    meshes = TiledMesh.of(cell, ORDER.for_bands(cell, 6).plans(cell))
    reduced = ReducedCell.of(meshes.condensed(3, 16, measured=False), 6, 1e-4)
    the_model = BlochModel(cell=cell, resolution=ORDER, count=6, fine=reduced)
    blocks, masses = [], []
    for placed, folded in zip(meshes.joint.placed, meshes.meshes, strict=True):
        stiffness, mass = assembled(folded.mesh, cell.material)
        turn = sp.kron(sp.eye_array(len(folded.mesh.points)), sp.csr_array(placed.turn))
        blocks.append(turn @ stiffness @ turn.T)
        masses.append(mass)
    K, M = sp.csr_array(sp.block_diag(blocks)), np.concatenate(masses)
    points = reduced.tiling.points

    def residual(kappa):
        solution = the_model.solve(kappa)
        fields = the_model.displacement(solution).reshape(-1, 6)
        P = periodic_projection(points, cell.vectors, kappa)
        free = P.conj().T @ fields / np.asarray(abs(P).sum(axis=0))[:, None]
        assert np.abs(P @ free - fields).max() < 1e-8 * np.abs(fields).max(), "a Bloch field"
        force = K @ fields - M[:, None] * fields * (2 * np.pi * solution.frequency) ** 2
        scale = abs(P).T @ K.diagonal()
        lost = np.abs(P.conj().T @ force) ** 2 / np.repeat(scale.reshape(-1, 3).sum(axis=1), 3)[:, None]
        return np.sqrt(lost.sum(axis=0) / np.einsum("nk,nk->k", fields.conj(), K @ fields).real), solution

    for kappa in drawn(name, 3):
        there, solution = residual(kappa)
        here, _ = residual(solution.source.kappa)
        assert there == pytest.approx(here, rel=1e-3)
        assert there.max() < 0.05


def test_mode_shapes_are_turned_with_their_wavevector():
    """A bending wave along x of a square cell, and the same along y."""
    the_model = BlochModel.of(CELLS["square"], ORDER, 6)
    along, turned = (
        mode_shapes(the_model, np.array(kappa)) for kappa in ((1.1, 0.3), (-0.3 - 4 * np.pi, 1.1))
    )
    assert turned["mode_kappa"].values == pytest.approx([-0.3 - 4 * np.pi, 1.1])
    for name in ("mode_frequency", "mode_error", "mode_name"):
        assert turned[name].values == pytest.approx(along[name].values)
    sizes = [np.hypot(shapes["mode_real"].values, shapes["mode_imag"].values) for shapes in (along, turned)]
    points = along["node_position"].values
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    _, there = scipy.spatial.cKDTree(points).query(points @ quarter.T)
    assert sizes[1][:, there] == pytest.approx(sizes[0] @ np.abs(quarter).T, abs=1e-5)


@by_name
def test_group_velocities_are_slopes_everywhere(name):
    the_model, step = model(name), 1e-4
    for kappa in drawn(name, 3):
        solution = the_model.solve(kappa)
        apart = np.diff(solution.frequency, prepend=-np.inf, append=np.inf)
        alone = np.minimum(apart[:-1], apart[1:]) > 1e-3 * solution.frequency
        velocity = group_velocity(the_model, solution)
        sides = [[the_model.frequencies(kappa + way * axis) for way in (step, -step)] for axis in np.eye(2)]
        slopes = np.array([(above - below) / (2 * step) for above, below in sides]).T
        expected = 2 * np.pi * slopes @ the_model.cell.vectors
        assert velocity[alone] == pytest.approx(expected[alone], rel=1e-4, abs=1e-4 * np.abs(expected).max())
