"""A body alone against closed forms, and a cell condensed in two steps against one condensed at once."""

from dataclasses import replace
from functools import cache
from itertools import accumulate, product

import numpy as np
import pytest
import scipy.linalg as la
from hypothesis import example, given, settings, strategies as st
from scipy.spatial import cKDTree
from strategies import ALUMINIUM, reference_cell

from daily import daily
from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.character import characters
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.cell import Pillar, Step, UnitCell, mesh_cell
from haptonic.cell.outlines import SECTIONS
from haptonic.cell.pieces import pieces_of
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.superelement import Tiling, condense, condense_by_parts, on_each, substructured
from haptonic.superelement.kept import Kept
from haptonic.superelement.pillar_body import PARITIES, PillarBody
from plies import PLY

CORK = IsotropicMaterial(70e9, 0.0, 2700.0, name="no lateral contraction")
BRASS, GLASS = material("brass"), material("soda-lime-glass")
LENGTH, RADIUS = 9e-3, 1.2e-3
# parities of u, v, w in the four symmetry classes: a factor x or y changes sides with its component
CLASSES = [tuple((((c == 0) ^ x, (c == 1) ^ y),) for c in range(3)) for x, y in product((0, 1), repeat=2)]
CELLS = {
    "reference": (reference_cell(), (1.1, 2.3)),
    "square section": (
        UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3e-3, 9e-3, section="square")),
        (2.0, 0.7),
    ),
    "orthotropic, fillet": (
        UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, PLY, Pillar(2.8e-3, 7e-3, fillet=0.4e-3)),
        (0.4, 3.0),
    ),
    "both faces": (replace(reference_cell(), faces="both"), (1.1, 2.3)),
}
# their meshes whole are dear; with as many rings at either edge as the whole has there they lose 4e-5
STEPPED = {
    "step": (
        UnitCell(Lattice.square(6e-3), 1e-3, BRASS, Pillar(3e-3, 12e-3, step=Step(2e-3, 5e-3))),
        (1.1, 2.3),
    ),
    "step, square section": (
        UnitCell(
            Lattice.rectangular(7e-3, 6e-3),
            1.2e-3,
            ALUMINIUM,
            Pillar(3e-3, 8e-3, "square", step=Step(1.8e-3, 3e-3)),
        ),
        (2.0, 0.7),
    ),
    "step that is low, fillet": (
        UnitCell(
            Lattice.square(6e-3), 1e-3, GLASS, Pillar(3e-3, 3e-3, fillet=0.3e-3, step=Step(1.6e-3, 1.9e-3))
        ),
        (1.1, 2.3),
    ),
}
# a class has several kinds of polynomials where a cell has fewer than two mirrors
FEW_MIRRORS = {
    f"step, {lattice.name}": (
        UnitCell(lattice, 1.2e-3, ALUMINIUM, Pillar(3e-3, 8e-3, step=Step(1.8e-3, 3e-3))),
        (1.1, 2.3),
    )
    for lattice in (Lattice.triangular(7e-3), Lattice.oblique(7e-3, 6e-3, 1.2))
}


def pillar_body(material=ALUMINIUM, section="round", degree=3, order=16):
    outline = SECTIONS[section]().outline()
    return PillarBody(2e-3, LENGTH, RADIUS, outline, material, degree, order, kinds=1, faces=1)


def free_frequencies(body, count):
    """The lowest of a free body, all symmetry classes together, Hz."""
    mass = body.mass
    values = [
        la.eigh(body.stiffness(parities) / np.sqrt(np.outer(mass, mass)), eigvals_only=True)
        for parities in CLASSES
    ]
    return np.sqrt(np.maximum(np.sort(np.concatenate(values)), 0.0))[:count] / (2 * np.pi)


# --- the body alone --------------------------------------------------------------------------------------


@pytest.mark.parametrize("material", [ALUMINIUM, PLY], ids=["isotropic", "orthotropic"])
@pytest.mark.parametrize("section", ["round", "square"])
def test_a_free_shaft_has_six_motions_at_rest(section, material):
    frequency = free_frequencies(pillar_body(material, section), 8)
    assert (frequency[:6] < 1e-4 * frequency[6]).all()
    assert frequency[6] > 1e3


def test_a_round_shaft_twists_at_the_speed_of_shear():
    frequency = free_frequencies(pillar_body(), 30)
    for halves in (1, 2, 3):
        expected = halves * ALUMINIUM.shear_speed / (2 * LENGTH)
        assert np.abs(frequency / expected - 1).min() < 1e-8


@pytest.mark.parametrize("section", ["round", "square"])
def test_without_lateral_contraction_a_shaft_stretches_like_a_string(section):
    frequency = free_frequencies(pillar_body(CORK, section), 40)
    for halves in (1, 2, 3):
        expected = halves * np.sqrt(70e9 / 2700.0) / (2 * LENGTH)
        assert np.abs(frequency / expected - 1).min() < 1e-8


def test_a_square_pillar_twists_with_the_constant_of_saint_venant():
    """Torsion constant 0.140577 (2 b)^4 over polar moment (2 b)^4 / 6; the section must warp for it."""
    slender = replace(pillar_body(section="square", degree=4, order=20), length=40 * RADIUS)
    expected = np.sqrt(0.1405770 * 6) * ALUMINIUM.shear_speed / (2 * 40 * RADIUS)
    assert np.abs(free_frequencies(slender, 40) / expected - 1).min() < 1e-3


@given(st.sampled_from(["round", "square"]), st.integers(0, 4))
def test_the_polynomials_are_orthonormal_over_the_section(section, degree):
    body = pillar_body(section=section, degree=degree)
    # polar Gauss points of the disc, or a grid of them on the square
    points, weights = np.polynomial.legendre.leggauss(14)
    if section == "square":
        x, y = (grid.ravel() for grid in np.meshgrid(points, points))
        weight = np.outer(weights, weights).ravel()
    else:
        radius, turn = 0.5 * (1 + points), 2 * np.pi * np.arange(40) / 40
        x = np.outer(radius, np.cos(turn)).ravel()
        y = np.outer(radius, np.sin(turn)).ravel()
        weight = np.repeat(0.5 * weights * radius, 40) * 2 * np.pi / 40
    for parity in PARITIES:
        values = body.over_section((parity,), RADIUS * x, RADIUS * y)
        assert (values.T * weight) @ values == pytest.approx(np.eye(body.shapes), abs=1e-9)
        turned = body.over_section((parity,), -RADIUS * x, RADIUS * y)
        assert turned == pytest.approx((-1) ** parity[0] * values)


def test_the_polynomials_of_a_turned_triangle_are_orthonormal():
    """A corner near a side of the cell needs many blocks; their nodes allow polynomials of degree 25."""
    pillar = Pillar(3e-3, 4e-3, "polygon", sides=3, turn=0.12)
    cell = UnitCell(Lattice.triangular(7e-3), 1.5e-3, ALUMINIUM, pillar)
    (tile,) = (placed.tile for placed in cell.tiles)
    body = substructured.pillar_body_of(tile, mesh_cell(tile, Resolution(2, 0).plan(tile)))
    assert body.kinds == 4
    points, weights = body.outline.cubature(4 * body.degree + 6)
    values = body.over_section(PARITIES, *(body.half_width * points.T))
    assert (values.T * weights) @ values == pytest.approx(np.eye(body.shapes), abs=1e-6)


def test_momenta_are_those_of_the_displacement():
    """Of random motions, by Gauss points over the section of one level."""
    body, rng = pillar_body(order=4), np.random.default_rng(3)
    unknowns = rng.standard_normal((len(body.mass), 2))
    level = 2
    height, mass, inertia = body.sizes[:, level]
    points, weights = np.polynomial.legendre.leggauss(12)
    radius, turn = 0.5 * RADIUS * (1 + points), 2 * np.pi * np.arange(24) / 24
    x, y = np.outer(radius, np.cos(turn)).ravel(), np.outer(radius, np.sin(turn)).ravel()
    weight = np.repeat(weights * radius, 24)
    weight *= mass / weight.sum()
    for parities in CLASSES:
        moved = body.displaced(parities, np.column_stack([x, y, np.full(len(x), height)]), unknowns)
        momenta = (body.momenta(parities) @ unknowns)[:, level]
        assert momenta[:3] == pytest.approx(np.einsum("n,nck->ck", weight, moved), abs=1e-9 * mass)
        turning = weight @ (x[:, None] * moved[:, 1] - y[:, None] * moved[:, 0])
        assert momenta[3] == pytest.approx(turning, abs=1e-9 * mass * RADIUS)
        kinetic = np.einsum("n,nck->k", weight, moved**2)
        own = body.mass.reshape(5, -1)[level] @ unknowns.reshape(5, -1, 2)[level] ** 2
        assert kinetic == pytest.approx(own)
    assert inertia == pytest.approx(weight @ (x**2 + y**2))


# --- a cell in two steps ----------------------------------------------------------------------------------


@cache
def both(name, order=4):
    """A cell condensed at once and in two steps on the same plan, and ten modes of each."""
    return [modes_of(name, order, way) for way in (condense, condense_by_parts)]


@cache
def modes_of(name, order, way):
    cell, kappa = (CELLS | STEPPED | FEW_MIRRORS)[name]
    plan = Resolution(order, 1).plan(cell)
    if cell.pillar.step:  # the pieces are graded towards a step as towards the foot; a whole mesh need not be
        plan = replace(plan, step_rings=plan.foot_rings)
    superelement = way(cell, plan, 3, block=20)
    pencil = CentredPencil.of(Tiling.single(superelement))
    values, modes = eigenpairs(pencil, np.array(kappa), 10)
    return (
        superelement,
        values,
        pencil.fields(modes, np.array(kappa)),
    )


EACH = [
    *(
        pytest.param(name, 4, 1.5e-4, marks=pytest.mark.nightly)
        if name in ("orthotropic, fillet", "both faces")
        else (name, 4, 1.5e-4)
        for name in CELLS
    ),
    *(pytest.param(name, 3, 1e-3, marks=pytest.mark.nightly) for name in STEPPED),
]


@pytest.mark.parametrize(("name", "order", "apart"), EACH)
def test_two_steps_lead_to_the_frequencies_of_one(name, order, apart):
    (_, whole, _), (_, parts, _) = both(name, order)
    assert np.sqrt(parts / whole) == pytest.approx(np.ones(10), abs=apart)


@pytest.mark.parametrize(("name", "order", "apart"), EACH)
def test_two_steps_lead_to_the_shapes_of_one(name, order, apart):
    """At the nodes that both meshes have: all of them, or the rim, the axis and some beside a step."""
    (whole, _, here), (parts, _, there) = both(name, order)
    if name in CELLS:
        assert parts.mesh.topology is whole.mesh.topology
    of_whole, of_parts = whole.lifted(here), parts.lifted(there)
    points = np.concatenate([mesh.points for mesh in parts.meshes])
    away, node = cKDTree(whole.mesh.points).query(points)
    common = away < 1e-9
    assert points[common, 2].max() == points[:, 2].max()
    of_whole, of_parts = of_whole[node[common]].reshape(-1, 10), of_parts[common].reshape(-1, 10)
    alike = np.abs((of_whole.conj() * of_parts).sum(axis=0)) ** 2
    alike /= (np.abs(of_whole) ** 2).sum(axis=0) * (np.abs(of_parts) ** 2).sum(axis=0)
    assert (alike > 1 - 1e-3).all()


@pytest.mark.parametrize(
    ("name", "order", "apart"),
    [
        pytest.param("reference", 5, 2e-4, marks=pytest.mark.nightly),
        *(pytest.param(name, 3, 2e-4, marks=pytest.mark.nightly) for name in STEPPED),
        # parabolas do not follow a body's polynomials closely
        *daily([(name, 2, 2e-2) for name in FEW_MIRRORS], ("step, triangular", 2, 2e-2)),
    ],
)
def test_a_lifted_field_has_the_energy_of_its_unknowns(name, order, apart):
    """The meshes' own quadrature sees the bodies' polynomials; nothing of the reduction is left in it."""
    from brute import assembled

    parts, values, fields = modes_of(name, order, condense_by_parts)
    moved, kinetic, strain, first = parts.lifted(fields), np.zeros(10), np.zeros(10), 0
    for mesh in parts.meshes:
        stiffness, mass = assembled(mesh, parts.cell.material)
        flat = moved[first : first + len(mesh.points)].reshape(-1, 10)
        kinetic += np.einsum("ik,i,ik->k", flat.conj(), mass, flat).real
        strain += np.einsum("ik,ik->k", flat.conj(), stiffness @ flat).real
        first += len(mesh.points)
    assert first == len(moved)
    if len(parts.meshes) > 1:  # they are one where they meet, and not alike by chance
        lower, upper = (mesh.points for mesh in parts.meshes)
        away, node = cKDTree(lower).query(upper)
        (common,) = np.nonzero(away < 1e-9)
        below, above = moved[node[common]], moved[len(lower) + common]
        assert len(common) >= parts.mesh.topology.plan.around
        assert above == pytest.approx(below, abs=1e-7 * np.abs(moved).max())
    assert kinetic == pytest.approx(np.ones(10), rel=apart)
    assert strain == pytest.approx(values, rel=2.5 * apart)


@pytest.mark.parametrize(("name", "order", "apart"), EACH)
def test_two_steps_lead_to_the_characters_of_one(name, order, apart):
    (whole, values, here), (parts, lower, there) = both(name, order)
    of_whole, of_parts = characters(whole, here, values), characters(parts, there, lower)
    assert (of_whole.name == of_parts.name).all()
    for share in ("vertical", "pillar_strain", "pillar_kinetic"):
        assert getattr(of_parts, share) == pytest.approx(getattr(of_whole, share), abs=2e-3)
    sizes = [superelement.measures.sections[0] for superelement in (whole, parts)]
    # of the nodes at the foot the pillar's sections have none: of a stepped one these are not the same
    assert sizes[1].mass.sum() == pytest.approx(sizes[0].mass.sum(), rel=1e-6 if name in CELLS else 1e-3)
    assert sizes[1].inertia.sum() == pytest.approx(
        sizes[0].inertia.sum(), rel=1e-4 if name in CELLS else 1e-3
    )
    for ours, theirs in zip(sizes[1].energies(there), sizes[0].energies(here), strict=True):
        assert ours == pytest.approx(theirs, abs=2e-3 * sum(sizes[0].energies(here)).max())


def test_the_residual_is_the_error_of_two_steps():
    cell, kappa = CELLS["reference"]
    plan, kappa = Resolution(3, 1).plan(cell), np.array(kappa)
    rich = CentredPencil.of(Tiling.single(condense_by_parts(cell, plan, 4, block=30, measured=False)))
    exact = eigenpairs(rich, kappa, 10)[0]
    poor = condense_by_parts(cell, plan, 2, block=4, measured=False)
    pencil = CentredPencil.of(Tiling.single(poor))
    values, modes = eigenpairs(pencil, kappa, 10)
    fields = pencil.fields(modes, kappa)
    lost = np.sqrt(values / exact) - 1
    estimate = 0.5 * values * on_each(poor.truncation, fields)
    assert lost[-1] > 1e-5, "else the test sees nothing"
    assert lost == pytest.approx(estimate, rel=0.2, abs=2e-6)


@pytest.mark.nightly
@settings(max_examples=1)
@given(
    st.sampled_from([Lattice.square(7e-3), Lattice.triangular(7e-3)]),
    st.floats(0.3, 0.75),
    st.floats(0.8, 3.0),
)
@example(Lattice.triangular(7e-3), 0.786, 0.857)
def test_designs_that_were_not_tried(lattice, diameter, height):
    """Two steps against one all over the design range: a small part of what the mesh itself leaves.

    The blocks of a six-sided cell span a third of a quarter turn: their order is not the one of the body.
    """
    pillar = Pillar(diameter * lattice.pitch, height * lattice.pitch)
    cell = UnitCell(lattice, 1.4e-3, ALUMINIUM, pillar)
    plan, kappa = Resolution(3, 1).plan(cell), np.array([1.0, 2.2])
    at_once, by_parts = (
        eigenpairs(CentredPencil.of(Tiling.single(way(cell, plan, 3, block=20, measured=False))), kappa, 8)[0]
        for way in (condense, condense_by_parts)
    )
    assert np.sqrt(by_parts / at_once) == pytest.approx(np.ones(8), abs=5e-4)


# --- which cells have a body, and which feet are the same -------------------------------------------------


@pytest.mark.parametrize(
    "pillar",
    [
        None,
        Pillar(2.4e-3, 9e-3, draft=0.02),
        Pillar(2.4e-3, 9e-3, step=Step(1.6e-3, 0.6e-3)),
        Pillar(4.4e-3, 1.0e-3),
    ],
    ids=["none", "draft", "step at the foot", "short"],
)
def test_what_has_no_shaft_is_condensed_at_once(pillar):
    cell = replace(reference_cell(), pillar=pillar)
    plan = Resolution(2, 1).plan(cell)
    assert substructured.pillar_body_of(cell, mesh_cell(cell, plan)) is None
    at_once, by_parts = condense(cell, plan, measured=False), condense_by_parts(cell, plan, measured=False)
    assert (at_once.stiffness == by_parts.stiffness).all()


@pytest.fixture
def empty(monkeypatch):
    """No foot condensed yet, and a count of those that are."""
    feet = []
    of_mesh = substructured.FoldedMesh.of_mesh

    def counted(*given, **named):
        feet.append(given)
        return of_mesh(*given, **named)

    substructured._feet.clear()
    monkeypatch.setattr(substructured.FoldedMesh, "of_mesh", counted)
    return feet


def test_a_foot_is_condensed_once_for_all_heights(empty):
    cell = reference_cell()
    plans = []
    for height in (8e-3, 16e-3, 8e-3):
        taller = replace(cell, pillar=replace(cell.pillar, height=height))
        plans.append(Resolution(2, 1).plan(taller))
        last = condense_by_parts(taller, plans[-1], measured=False)
    assert plans[0] != plans[1], "the meshes of the two bodies differ, the feet do not"
    assert len(empty) == 1
    substructured._feet.clear()
    anew = condense_by_parts(taller, plans[-1], measured=False)
    assert len(empty) == 2
    assert (anew.stiffness == last.stiffness).all()


def test_what_is_about_a_step_is_condensed_once_for_all_heights(empty):
    cell = reference_cell()
    for height, step in ((8e-3, 3e-3), (13e-3, 3e-3), (13e-3, 7e-3)):
        pillar = Pillar(3e-3, height, step=Step(2e-3, step))
        stepped = replace(cell, pillar=pillar)
        condense_by_parts(stepped, Resolution(2, 1).plan(stepped), measured=False)
    assert len(empty) == 2, "a foot and a step"


@given(st.floats(0.3, 6.0), st.floats(0.3, 0.9), st.floats(0.05, 3.0), st.sampled_from([0.0, 0.2]))
def test_the_pieces_of_a_stepped_pillar_are_the_whole_of_it(step, narrower, above, fillet):
    """Each has one edge; they meet where the pillar is a prism, or none of them is made."""
    width = 3e-3
    height = (step + fillet) * width
    pillar = Pillar(width, height + above * width, fillet=fillet * width, step=Step(narrower * width, height))
    cell = UnitCell(Lattice.square(7e-3), 1.4e-3, ALUMINIUM, pillar)
    pieces = pieces_of(cell, Resolution(3, 1).plan(cell))
    if step < 0.44:
        assert [piece.tile for piece in pieces] == [cell]
    elif step > 0.46:
        lower, upper = (piece.tile for piece in pieces)
        assert lower.thickness + lower.pillar.height == pytest.approx(pieces[1].base)
        assert pieces[1].base + upper.thickness == pytest.approx(cell.thickness + height)
        assert upper.thickness + upper.pillar.height == pytest.approx(
            cell.thickness + pillar.height - pieces[1].base
        )
        volume = lower.pillar.volume + upper.pillar.volume + np.pi * upper.free_width**2 * upper.thickness
        assert volume == pytest.approx(pillar.volume)
        assert all(piece.tile.pillar.is_prism and not piece.plan.step_layers for piece in pieces)


def test_the_estimated_cost_of_a_step_is_small():
    """Its rings ran through the plate, and the foot's through it: the estimate was four times as much."""
    pillar = Pillar(3e-3, 12e-3, step=Step(2e-3, 5e-3))
    cell = UnitCell(Lattice.square(6e-3), 1e-3, BRASS, pillar)
    plain = replace(cell, pillar=replace(pillar, step=None))
    for order in (3, 5):
        used = Resolution(order, 1)
        assert used.seconds(cell) < 2 * used.seconds(plain)
        assert used.memory(plain) < used.memory(cell) < 2 * used.memory(plain)


@pytest.mark.parametrize(
    "change",
    [
        {"thickness": 1.1e-3},
        {"material": IsotropicMaterial(70e9, 0.33, 3000.0, name="denser")},
        {"material": IsotropicMaterial(71e9, 0.33, 2700.0, name="stiffer")},
        {"pillar": Pillar(2.41e-3, 9e-3)},
        {"lattice": Lattice.square(7.2e-3)},
    ],
    ids=["thickness", "density", "stiffness", "diameter", "pitch"],
)
def test_another_foot_is_another(empty, change):
    cell = replace(reference_cell(), thickness=1e-3, pillar=Pillar(2.4e-3, 9e-3))
    for design in (cell, replace(cell, **change)):
        condense_by_parts(design, Resolution(2, 1).plan(design), measured=False)
    assert len(empty) == 2


@given(st.lists(st.integers(1, 12), min_size=1, max_size=40))
def test_what_waits_is_what_was_asked_for_last_up_to_a_size_in_all(asked):
    kept = Kept(10, int)
    for size in asked:
        assert kept.of(size, lambda size=size: size) == size
    last = [size for size in dict.fromkeys(reversed(asked)) if size <= 10]
    waiting = [size for size, needed in zip(last, accumulate(last), strict=True) if needed <= 10]
    assert len(kept) == len(waiting)
    for size in waiting:
        assert kept.of(size, lambda: pytest.fail("it was waiting")) == size


def test_many_values_of_one_group_leave_the_last_of_another():
    kept = Kept(10, int)
    kept.of("design", lambda: 3, "fine")
    for number in range(8):
        kept.of(number, lambda: 2, "coarse")
    assert kept.of("design", lambda: pytest.fail("it is stored"), "fine") == 3
    assert len(kept) == 4
    kept.of("other", lambda: 4, "finest")
    kept.of("large", lambda: 9, "largest")
    assert kept.of("large", lambda: pytest.fail("it is stored"), "largest") == 9
    assert len(kept) == 1
