"""Stacks of discs: volumes, identities, a brute solution, an independent library, and what is refused."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from brute import assembled, frequencies, periodic_projection
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM

from five_parts import refusing
from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.cell import Disc, MeshPlan, Pillar, Site, Step, UnitCell, mesh_cell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.superelement import FoldedMesh, Tiling, condense_by_parts, through_levels
from haptonic.superelement.symmetry import THROUGH
from plies import PLY
from stacks import DRAFTED, EPOXY, RIGHT, STACKS, STEEL, above, drafted_volumes

MM = 1e-3
SAME = replace(ALUMINIUM, name="the same metal")
KAPPA = np.array([1.1, 2.3])
COARSE = Resolution(3, 1)
PITCH, THICKNESS = 7 * MM, 1.5 * MM


def cell(*discs, lattice=None, **more):
    return UnitCell(lattice or Lattice.square(PITCH), THICKNESS, ALUMINIUM, disc=discs, **more)


CELLS = {
    **{name: cell(*discs) for name, discs in (STACKS | DRAFTED).items()},
    "pillar": cell(above(3.5, 0, 6)),
    "square hole in a round inclusion": cell(
        Disc(5 * MM, material=STEEL), Disc(2.5 * MM, section="square", empty=True)
    ),
    "both faces": cell(above(3.5, 0, 4), faces="both"),
    "blind holes on both faces": cell(Disc(4 * MM, low=-0.4 * MM, empty=True), faces="both"),
    "triangular": cell(Disc(4 * MM, section="hexagon", empty=True), lattice=Lattice.triangular(PITCH)),
    "two sites": UnitCell(
        Lattice(lattice="honeycomb", pitch=9 * MM),
        THICKNESS,
        ALUMINIUM,
        site=(Site(disc=(Disc(3 * MM, empty=True),)), Site(pillar=Pillar(2.4 * MM, 4 * MM))),
    ),
}


@cache
def model_of(any_cell, count=8, resolution=COARSE):
    return BlochModel.of(any_cell, resolution, count, measured=False)


def solved(any_cell, count=8, resolution=COARSE):
    return model_of(any_cell, count, resolution).solve(KAPPA)


def round_area(diameter):
    return np.pi * (0.5 * diameter * MM) ** 2


AL, EP, IRON = ALUMINIUM.density, EPOXY.density, STEEL.density
PLATE = AL * PITCH**2 * THICKNESS
MASS = {
    "hole": PLATE - AL * round_area(4) * THICKNESS,
    "blind hole": PLATE - AL * round_area(4) * 0.7 * MM,
    "inclusion": PLATE + (IRON - AL) * round_area(4) * THICKNESS,
    "coated inclusion": PLATE + ((EP - AL) * round_area(5) + (IRON - EP) * round_area(4)) * THICKNESS,
    "pillar": PLATE + AL * round_area(3.5) * 6 * MM,
    "pillar on glue": PLATE + round_area(3) * (EP * 0.5 + IRON * 3.5) * MM,
    "cap": PLATE + AL * (round_area(2.5) * 3 + round_area(4.5)) * MM,
    "hollow pillar": PLATE + AL * (round_area(4) - round_area(2.5)) * 4 * MM,
    "square hole in a round inclusion": PLATE
    + ((IRON - AL) * round_area(5) - IRON * (2.5 * MM) ** 2) * THICKNESS,
    "both faces": PLATE + 2 * AL * round_area(3.5) * 4 * MM,
    "blind holes on both faces": PLATE - 2 * AL * round_area(4) * 0.4 * MM,
    **{
        name: sum(
            1e-9 * volume * {"metal": AL, "epoxy": EP, "steel": IRON}[solid]
            for solid, volume in volumes.items()
        )
        for name, volumes in drafted_volumes(49).items()
    },
    "triangular": AL * np.sqrt(0.75) * (PITCH**2 - (4 * MM) ** 2) * THICKNESS,
}


@pytest.mark.parametrize("name", MASS)
def test_mass_is_that_of_the_solid(name):
    tile = CELLS[name].tiles[0].tile
    folded = FoldedMesh.of(tile, replace(MeshPlan.suited(tile, 3, 1), order=7))
    assert folded.nodal_mass.sum() == pytest.approx(MASS[name], rel=1e-9)


@pytest.mark.parametrize("name", CELLS)
def test_elements_are_not_inside_out(name):
    for placed in CELLS[name].tiles:
        for order in (2, 4):
            mesh = mesh_cell(placed.tile, MeshPlan.suited(placed.tile, order, 2))
            for family in mesh.topology.families:
                corners = mesh.points[
                    family.nodes[
                        :,
                        :: family.nodes.shape[1] - 1,
                        :: family.nodes.shape[2] - 1,
                        :: family.nodes.shape[3] - 1,
                    ]
                ]
                edges = np.stack(
                    [np.diff(corners, axis=axis + 1).mean(axis=(1, 2, 3)) for axis in range(3)], axis=1
                )
                assert (np.linalg.det(edges) > 0).all()


@pytest.mark.parametrize("name", ["hole", "coated inclusion", "cap", "both faces"])
def test_frequencies_are_those_of_the_whole_mesh(name):
    """Folded and condensed, against whole matrices of one mesh, which is as coarse as its blocks allow."""
    cell = CELLS[name]
    plan = replace(MeshPlan.suited(cell, 2, 0), order=3, outward=2, upward=2, along=2, thin=2)
    mesh = mesh_cell(cell, plan)
    tile = condense_by_parts(cell, plan, 4, block=20, measured=False)
    condensed = np.sqrt(eigenpairs(bloch_pencil(Tiling.single(tile)), KAPPA, 8)[0]) / (2 * np.pi)
    through = through_levels(cell, mesh, tile.levels)
    P = periodic_projection(mesh.points, cell.lattice.vectors, KAPPA, through, mesh.topology.rim)
    assert condensed == pytest.approx(frequencies(*assembled(mesh, *cell.solids), P, 8), rel=2e-4)


@pytest.mark.parametrize(
    "name",
    ["coated inclusion", *(pytest.param(name, marks=pytest.mark.nightly) for name in ("hole", "triangular"))],
)
def test_discs_through_the_plate_part_waves_by_parity(name):
    """A mode is its image or the opposite; a slight draft, which needs the whole mesh, changes little."""
    cell = CELLS[name]
    model, solution = model_of(cell), solved(cell)
    parity = model.fine.parity(solution.modes)
    assert set(parity) == {1, -1}
    moved = model.displacement(solution)
    image = moved[model.fine.tiling.meshes[0].topology.image] * THROUGH[:, None] * parity
    assert np.abs(image - moved).max() < 1e-9 * np.abs(moved).max()
    drafted = replace(cell, disc=tuple(replace(disc, draft=1e-7) for disc in cell.disc))
    assert not model_of(drafted).fine.parity(solved(drafted).modes).any()
    TestIdentities.agree(cell, drafted, 0.7)


def test_only_prisms_through_the_plate_are_their_images():
    whole = CELLS["hole"].stack
    assert whole.is_its_image
    assert whole.upper_half.heights == pytest.approx([0.5 * THICKNESS, THICKNESS])
    assert CELLS["coated inclusion"].stack.is_its_image
    assert not CELLS["blind hole"].stack.is_its_image
    assert not CELLS["cap"].stack.is_its_image
    assert not replace(whole, discs=(replace(whole.discs[0], draft=0.1),)).is_its_image


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["countersunk hole", "chamfered pillar", "cap on a cone"])
def test_errors_of_cones_bound_the_distance_to_a_finer_mesh(name):
    coarse, fine = (solved(CELLS[name], 8, Resolution(*mesh)) for mesh in ((3, 1), (5, 2)))
    assert (np.abs(coarse.frequency - fine.frequency) < coarse.error).all()


class TestIdentities:
    """Two descriptions of one cell have frequencies that differ by less than both errors."""

    @staticmethod
    def agree(cell, other, share=1.0):
        mine, its = solved(cell), solved(other)
        assert (np.abs(mine.frequency - its.frequency) < share * (mine.error + its.error)).all()

    def test_a_disc_on_the_plate_is_a_pillar(self):
        pillar = UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, Pillar(3.5 * MM, 6 * MM))
        self.agree(CELLS["pillar"], pillar)

    @pytest.mark.nightly
    def test_a_disc_of_another_material_on_the_plate_is_such_a_pillar(self):
        pillar = Pillar(3 * MM, 4 * MM, material=STEEL)
        self.agree(
            cell(above(3, 0, 4, material=STEEL)),
            UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, pillar),
        )

    def test_a_drafted_disc_on_the_plate_is_a_pillar_with_draft(self):
        pillar = UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, Pillar(3.5 * MM, 6 * MM, draft=0.1))
        self.agree(cell(above(3.5, 0, 6, draft=0.1)), pillar)

    @pytest.mark.nightly
    def test_two_cones_that_continue_each_other_are_one(self):
        half = 3.5 - 2 * 3 * math.tan(0.1)
        two = cell(above(3.5, 0, 3, draft=0.1), above(half, 3, 6, draft=0.1))
        assert len(two.stack.borders) == 1
        self.agree(two, cell(above(3.5, 0, 6, draft=0.1)))

    @pytest.mark.nightly
    def test_a_cone_in_a_cone_of_the_same_material_is_the_outer_one(self):
        same = replace(STEEL, name="the same steel")
        outer = Disc(5 * MM, material=same, draft=0.2)
        self.agree(cell(outer, Disc(3 * MM, material=STEEL, draft=-0.1)), cell(outer))

    @pytest.mark.nightly
    def test_two_discs_that_grow_narrower_are_a_pillar_with_a_step(self):

        pillar = Pillar(3.5 * MM, 6 * MM, step=Step(2 * MM, 3 * MM))
        self.agree(
            cell(above(3.5, 0, 3), above(2, 3, 6)),
            UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, pillar),
        )

    def test_a_filled_hole_is_plain_plate(self):
        self.agree(cell(Disc(4 * MM, material=SAME)), cell())

    def test_a_hole_that_a_later_disc_fills_in_part_is_narrower(self):
        ring = cell(Disc(5 * MM, material=SAME), Disc(4 * MM, empty=True))
        self.agree(ring, CELLS["hole"])

    def test_a_coating_of_the_cores_material_is_a_wider_inclusion(self):
        same = replace(STEEL, name="the same steel")
        self.agree(
            cell(Disc(5 * MM, material=same), Disc(3 * MM, material=STEEL)),
            cell(Disc(5 * MM, material=STEEL)),
        )

    def test_a_hole_of_next_to_nothing_is_a_hole(self):
        # as stiff for its weight as aluminium, so that it has no low modes of its own
        nothing = replace(ALUMINIUM, name="next to nothing", youngs_modulus=26e6, density=1.0)
        filled, empty = solved(cell(Disc(4 * MM, material=nothing))), solved(CELLS["hole"])
        assert filled.frequency[:3] == pytest.approx(empty.frequency[:3], rel=5e-3)

    def test_a_blind_hole_through_half_the_plate_on_both_faces_goes_through(self):
        through = replace(CELLS["hole"], faces="both")
        self.agree(through, CELLS["hole"])

    @given(factor=st.floats(0.01, 100.0))
    @settings(max_examples=1, deadline=None)
    def test_frequencies_fall_as_sizes_grow(self, factor):
        cell = CELLS["blind hole"]
        scaled = solved(cell.scaled(factor)).frequency * factor
        assert scaled == pytest.approx(solved(cell).frequency, rel=1e-6)

    @pytest.mark.nightly
    def test_two_sites_alike_are_a_lattice_of_half_the_pitch(self):
        """A centred square of two sites is the square lattice that is turned by 45 degrees."""
        disc = (Disc(3 * MM, empty=True),)
        large = UnitCell(
            Lattice.square(PITCH),
            THICKNESS,
            ALUMINIUM,
            site=(Site(at=(0.0, 0.0), disc=disc), Site(at=(0.5, 0.5), disc=disc)),
        )
        small = UnitCell(Lattice.square(PITCH / np.sqrt(2)), THICKNESS, ALUMINIUM, disc=disc)
        # at Gamma of the large cell fold the points Gamma and M of the small one
        many = BlochModel.of(large, COARSE, 10, measured=False).solve(np.zeros(2))
        few = BlochModel.of(small, COARSE, 8, measured=False)
        both = [few.solve(np.array(kappa)) for kappa in ((0.0, 0.0), (np.pi, np.pi))]
        expected = np.sort(np.concatenate([solution.frequency for solution in both]))[:10]
        assert many.frequency[3:] == pytest.approx(expected[3:], rel=4e-3)


@pytest.mark.nightly
def test_the_trace_resolves_stress_of_an_interface_near_the_side():
    disc = Disc(6.1 * MM, material=replace(STEEL, youngs_modulus=411e9), draft=0.15)
    near = UnitCell(Lattice.square(PITCH), 5 * MM, ALUMINIUM, disc=(disc,))
    plan = Resolution(3, 1).plan(near)
    solution, better = (
        BlochModel.of(near, COARSE, 8, measured=False, whole=Tiling.condensed(near, (used,), 2, 10)).solve(
            KAPPA
        )
        for used in (plan, replace(plan, near_rim=plan.near_rim + 2))
    )
    assert (np.abs(solution.frequency - better.frequency) < 0.3 * solution.error).all()


class TestBordersOfCones:
    def test_discs_whose_sides_meet_have_one_border(self):
        stack = CELLS["cap on a cone"].stack
        assert stack.chains == ((0, 1, 2, 3),)
        assert 2 * stack.widths[0] / MM == pytest.approx([2, 2, 2, 4, 4, 3.2])
        assert stack.widest == pytest.approx(2 * MM)
        assert 2 * stack.widths_at(THICKNESS + 2.5 * MM) / MM == pytest.approx([3])
        assert CELLS["cap"].stack.chains == ((0,), (1,))

    def test_order_of_the_tables_does_not_matter(self):
        discs = DRAFTED["cap on a cone"]
        assert cell(*discs[::-1]).stack.widths == pytest.approx(cell(*discs).stack.widths)

    @pytest.mark.parametrize(("draft", "singular"), [(-0.3, True), (0.3, False), (0.0, False)])
    def test_stress_is_singular_where_a_pillar_bends_outwards(self, draft, singular):
        bent = cell(above(3, 0, 2), above(3, 2, 3, draft=draft)).stack
        assert list(bent.singular[0]) == [False, True, singular, False][: len(bent.heights)]

    @pytest.mark.parametrize(("draft", "singular"), [(-0.3, False), (0.3, True)])
    def test_and_where_a_hole_bends_inwards(self, draft, singular):
        bent = cell(Disc(3 * MM, high=-0.7 * MM, empty=True),
                    Disc(3 * MM, low=-0.7 * MM, draft=draft, empty=True)).stack  # fmt: skip
        assert list(bent.singular[0]) == [False, singular, False]

    def test_and_where_an_interface_ends_at_a_surface(self):
        for draft in (0.0, 0.2):
            assert cell(Disc(4 * MM, material=STEEL, draft=draft)).stack.singular.all()

    def test_a_bend_in_the_middle_plane_is_that_of_both_faces(self):
        waist, belly = (
            cell(Disc(3 * MM, low=-0.75 * MM, draft=sign * 0.3, empty=True), faces="both") for sign in (-1, 1)
        )
        assert not waist.stack.singular.any()
        assert list(belly.stack.singular[0]) == [True, False]


class TestSymmetry:
    def test_it_is_that_of_all_sections(self):
        turned = cell(Disc(5 * MM, material=STEEL), Disc(3 * MM, section="square", turn=0.2, empty=True))
        assert len(turned.point_group.operations) == 4
        assert len(CELLS["coated inclusion"].point_group.operations) == 8

    def test_it_is_that_of_all_materials(self):
        assert len(cell(Disc(4 * MM, material=PLY)).point_group.operations) == 4


REFUSED = {
    "a cone wider than the cell at its upper end": (
        [Disc(5 * MM, draft=-RIGHT, empty=True)], "out-of-range", "cell.disc[1].diameter",
    ),
    "a cone whose sides would meet": (
        [Disc(2 * MM, draft=RIGHT, empty=True)], "out-of-range", "cell.disc[1].draft",
    ),
    "a cone through its coating": (
        [Disc(4 * MM, material=EPOXY), Disc(3 * MM, material=STEEL, draft=-RIGHT)],
        "out-of-range", "cell.disc",
    ),
    "a countersink beside the end of its hole": (
        [Disc(3 * MM, empty=True), Disc(3 * MM, low=-0.6 * MM, draft=-RIGHT, empty=True)],
        "out-of-range", "cell.disc",
    ),
    "wider than the cell": ([Disc(7.2 * MM, empty=True)], "out-of-range", "cell.disc[1].diameter"),
    "out of the plate below": ([Disc(3 * MM, low=-2 * MM, empty=True)], "out-of-range", "cell.disc[1].low"),
    "nothing changes": ([Disc(3 * MM)], "conflict", "cell.disc[1]"),
    "replaced": ([Disc(3 * MM, material=STEEL), Disc(4 * MM, empty=True)], "conflict", "cell.disc[1]"),
    "in the air": ([above(3, 1, 2)], "conflict", "cell.disc"),
    "held by an edge": (
        [above(4, 0, 2), above(2, 0, 2, empty=True), above(2, 2, 3)], "conflict", "cell.disc",
    ),
    "outlines cross": (
        [Disc(4 * MM, material=STEEL),
         Disc(4.5 * MM, section="square", turn=np.pi / 4, low=-1 * MM, empty=True),
         Disc(3.9 * MM, section="square", low=-0.5 * MM, empty=True)],
        "out-of-range", "cell.disc",
    ),
    "a coating too thin": (
        [Disc(4 * MM, material=EPOXY), Disc(3.999 * MM, material=STEEL)], "out-of-range", "cell.disc",
    ),
    "a layer too thin": (
        [above(3, 0, 0.0001, material=EPOXY), above(3, 0.0001, 2, material=STEEL)],
        "out-of-range", "cell.disc",
    ),
}  # fmt: skip


class TestRefusals:
    @pytest.mark.parametrize("name", REFUSED)
    def test_discs_that_make_no_body(self, name):
        discs, code, argument = REFUSED[name]
        with refusing(GeometryError, code, argument):
            cell(*discs)

    def test_a_drafted_ellipse(self):
        with refusing(GeometryError, "unsupported", "cell.disc.draft"):
            Disc(3 * MM, section="ellipse", length=2 * MM, draft=0.1)

    def test_a_draft_steeper_than_a_countersink(self):
        with refusing(GeometryError, "out-of-range", "cell.disc.draft"):
            Disc(3 * MM, draft=1.1)

    def test_a_pillar_and_discs_on_one_site(self):
        with refusing(GeometryError, "conflict", "cell.disc"):
            cell(Disc(2 * MM, empty=True), pillar=Pillar(3 * MM, 4 * MM))

    def test_discs_beside_sites(self):
        with refusing(GeometryError, "conflict", "cell.disc"):
            cell(Disc(2 * MM, empty=True), site=(Site(at=(0.0, 0.0)),))

    def test_an_empty_disc_of_a_material(self):
        with refusing(GeometryError, "conflict", "cell.disc.material"):
            Disc(3 * MM, material=STEEL, empty=True)

    def test_an_upper_end_below_the_lower_one(self):
        with refusing(GeometryError, "out-of-range", "cell.disc.low"):
            Disc(3 * MM, low=1 * MM)

    def test_a_disc_below_the_middle_plane_of_two_faces(self):
        with refusing(GeometryError, "out-of-range", "cell.disc[1].high"):
            cell(Disc(3 * MM, high=-1 * MM, empty=True), faces="both")


def test_a_square_hole_in_a_round_inclusion_is_sound_on_a_triangular_lattice():
    """Blocks of each border alone were sound, the rings between the two were not."""
    discs = Disc(5 * MM, material=STEEL), Disc(3 * MM, section="square", empty=True)
    cell = UnitCell(Lattice.triangular(PITCH), THICKNESS, ALUMINIUM, disc=discs)
    mesh = FoldedMesh.of(cell, MeshPlan.suited(cell, 2, 0))
    steel = STEEL.density * (np.pi / 4 * 25 - 9) * MM**2 * THICKNESS
    metal = ALUMINIUM.density * (cell.lattice.area - np.pi / 4 * 25 * MM**2) * THICKNESS
    assert mesh.nodal_mass.sum() == pytest.approx(steel + metal, rel=1e-4)
