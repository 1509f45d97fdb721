"""Cells of a CAD program: what is read, what is refused, and frequencies against the mesh of blocks."""

import numpy as np
import pytest
from strategies import ALUMINIUM

from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.bands import count_check
from haptonic.bloch.mesh_levels import MeshLimits, finer_level
from haptonic.bloch.resolution import LEVELS
from haptonic.cell import Disc, Pillar, Solid, SolidPart, UnitCell
from haptonic.errors import HaptonicError
from haptonic.lattice import HALF_TURN, Lattice
from haptonic.materials import material
from haptonic.workshop import Part, write_step

pytest.importorskip("ngsolve")

from cad_cells import TO_MM, occ, prism, step_of
from stacks import DRAFTED, STACKS, drafted_volumes

MM = 1e-3
THICKNESS = 1.5 * MM
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)
RHOMBUS = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]) @ TRIANGULAR.vectors
PILLAR = Disc(3 * MM, low=0.0, high=4 * MM)
INCLUSION = Disc(4 * MM, material=material("steel"))
KAPPAS = np.pi * np.array([(0.2, 0.1), (1.0, 0.0)])


def drawn(folder, lattice, *discs, corners=None):
    """A cell of discs, and the same as a STEP file."""
    blocks = UnitCell(lattice, THICKNESS, ALUMINIUM, disc=discs)
    path, names = step_of(blocks, folder / "cell.step", corners)
    parts = tuple(SolidPart(name=name, material=solid) for name, solid in names.items())
    return blocks, UnitCell(lattice, THICKNESS, ALUMINIUM, solid=Solid(file=str(path), part=parts))


def agree(blocks, solids, order, apart=1e-2):
    """Compare frequencies: within their errors, and within a share."""
    models = [BlochModel.of(blocks, Resolution(3, 1), 6), BlochModel.of(solids, Resolution(order, 1), 6)]
    for kappa in KAPPAS:
        exact, own = (model.solve(kappa) for model in models)
        assert (np.abs(own.frequency - exact.frequency) <= own.error + exact.error).all()
        assert own.frequency == pytest.approx(exact.frequency, rel=apart)
    return models[1]


class TestFrequencies:
    def test_a_pillar_has_those_of_its_block_mesh(self, tmp_path):
        model = agree(*drawn(tmp_path, SQUARE, PILLAR), order=2, apart=3e-2)
        checked, missed = count_check(model, [45e3])
        assert checked > 1
        assert missed == 0

    def test_errors_of_a_hole_are_not_far_above_the_true_ones(self, tmp_path):
        """The median ratio was 18 before the ratio of the two highest degrees counted away from edges."""
        blocks, solids = drawn(tmp_path, SQUARE, *STACKS["hole"])
        exact, own = (
            BlochModel.of(cell, Resolution(order, 1), 6) for cell, order in ((blocks, 5), (solids, 3))
        )
        for kappa in KAPPAS:
            true, solution = exact.solve(kappa), own.solve(kappa)
            away = np.abs(solution.frequency - true.frequency)
            assert (solution.error >= away - true.error).all()
            assert np.median(solution.error / away) < 12

    @pytest.mark.nightly
    @pytest.mark.parametrize("name", STACKS)
    def test_every_stack_of_discs_has_those_of_its_block_mesh(self, tmp_path, name):
        agree(*drawn(tmp_path, SQUARE, *STACKS[name]), order=3, apart=2e-2)

    @pytest.mark.nightly
    @pytest.mark.parametrize(
        ("name", "order"), [("countersunk hole", 4), ("chamfered pillar", 4), ("drafted coated inclusion", 3)]
    )
    def test_cones_have_those_of_their_block_mesh(self, tmp_path, name, order):
        agree(*drawn(tmp_path, SQUARE, *DRAFTED[name]), order=order, apart=5e-3)

    @pytest.mark.nightly
    @pytest.mark.parametrize("discs", [(PILLAR,), (INCLUSION,)], ids=["pillar", "inclusion"])
    def test_a_rhombus_has_those_of_the_hexagon(self, tmp_path, discs):
        agree(*drawn(tmp_path, TRIANGULAR, *discs, corners=RHOMBUS), order=3)

    @pytest.mark.nightly
    def test_a_solid_of_the_plates_material_changes_nothing(self, tmp_path):
        _, solids = drawn(tmp_path, SQUARE, Disc(4 * MM, material=material("aluminium-2017a")))
        plain = UnitCell(SQUARE, THICKNESS, material("aluminium-2017a"))
        file = solids.solid.file
        same = UnitCell(SQUARE, THICKNESS, plain.material, solid=Solid(file=file))
        agree(plain, same, order=3)


class TestPeriods:
    @pytest.mark.nightly
    def test_volumes_are_those_of_the_discs(self, tmp_path):
        _, solids = drawn(tmp_path, SQUARE, INCLUSION)
        inside = np.pi * (2 * MM) ** 2 * THICKNESS
        period = solids.solid_period
        assert period.volumes == pytest.approx([(7 * MM) ** 2 * THICKNESS - inside, inside], rel=1e-6)

    def test_volumes_are_those_of_cones(self, tmp_path):
        _, solids = drawn(tmp_path, SQUARE, *DRAFTED["drafted coated inclusion"])
        exact = drafted_volumes(49)["drafted coated inclusion"]
        period = solids.solid_period
        assert period.volumes == pytest.approx([1e-9 * volume for volume in exact.values()], rel=1e-6)
        assert period.names == ("part 0", "part 1", "part 2")

    def test_a_round_hole_has_the_symmetry_of_the_lattice(self, tmp_path):
        """Open CASCADE's intersection of two equal walls of an exported hole misses 4e-5 of the volume."""
        lattice, hole = Lattice.square(10 * MM), Disc(7 * MM, empty=True)
        part = Part.piece(UnitCell(lattice, 2 * MM, ALUMINIUM, disc=(hole,)))
        file = str(write_step(tmp_path / "hole.step", part))
        cell = UnitCell(lattice, 2 * MM, ALUMINIUM, solid=Solid(file=file))
        assert len(cell.point_group) == 8

    @pytest.mark.nightly
    def test_a_pillar_at_the_corners_is_one_in_the_middle(self, tmp_path):
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * 3.5 * MM
        plate = prism(corners, 0.0, THICKNESS)
        column = prism(corners, THICKNESS, THICKNESS + 4 * MM)
        for x, y in (corners * TO_MM).tolist():
            pillar = occ.Cylinder(occ.Pnt(x, y, 1.5), occ.Z, r=1.5, h=4.0)
            plate = plate + column * pillar
        plate.WriteStep(str(tmp_path / "corners.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "corners.step")))
        assert len(cell.point_group) == 8

    @pytest.mark.nightly
    def test_an_ellipse_has_not_the_symmetry_of_the_lattice(self, tmp_path):
        plate = prism(SQUARE.corners, 0.0, THICKNESS)
        face = occ.WorkPlane(occ.Axes((0, 0, 1.5), occ.Z)).Ellipse(2.0, 1.0).Face()
        (plate + occ.Prism(face, occ.Vec(0, 0, 3.0))).WriteStep(str(tmp_path / "ellipse.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "ellipse.step")))
        assert len(cell.point_group) == 4
        assert HALF_TURN in cell.point_group


@pytest.fixture(scope="module")
def pillar(tmp_path_factory):
    return drawn(tmp_path_factory.mktemp("solids"), SQUARE, PILLAR)[1].solid


@pytest.fixture(scope="module")
def inclusion(tmp_path_factory):
    return drawn(tmp_path_factory.mktemp("solids"), SQUARE, INCLUSION)[1].solid


def test_meshes_of_a_file_rise_by_one_level(pillar):
    """Each takes three times the memory of the one before, and reaches a seventh of its error."""
    cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=pillar)
    ample = MeshLimits(seconds=1e9, memory=1e12)
    for level in (0, 1):
        mesh = LEVELS[level].for_bands(cell, 8)
        assert finer_level(cell, mesh, level, 6.3, ample, 0.0)[0] == level + 1


class TestRefusals:
    def refused(self, cell):
        with pytest.raises(HaptonicError) as caught:
            _ = cell.solid_period
        return caught.value

    def test_another_thickness(self, pillar):
        error = self.refused(UnitCell(SQUARE, 1 * MM, ALUMINIUM, solid=pillar))
        assert error.argument == "cell.thickness"
        assert "1.5 mm" in error.next_step

    @pytest.mark.parametrize("lattice", [TRIANGULAR, Lattice.square(6 * MM), Lattice.square(14 * MM)])
    def test_another_lattice(self, pillar, lattice):
        assert self.refused(UnitCell(lattice, THICKNESS, ALUMINIUM, solid=pillar)).code == "mismatch"

    def test_a_name_that_no_solid_has(self, inclusion):
        part = SolidPart(name="[red]core", material=ALUMINIUM)
        named = Solid(file=inclusion.file, part=(part,))
        error = self.refused(UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=named))
        assert error.code == "unknown"
        assert "part 1" in error.allowed

    def test_layers_through_the_sides(self, tmp_path):
        low, high = prism(SQUARE.corners, 0.0, 1 * MM), prism(SQUARE.corners, 1 * MM, THICKNESS)
        occ.Glue([low, high]).WriteStep(str(tmp_path / "layers.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "layers.step")))
        assert "several solids" in self.refused(cell).given

    def test_a_hole_that_meets_its_neighbour(self, tmp_path):
        plate = prism(SQUARE.corners, 0.0, THICKNESS)
        slot = prism(np.array([(-4, -1), (4, -1), (4, 1), (-4, 1)]) * MM, -1 * MM, 3 * MM)
        (plate - slot).WriteStep(str(tmp_path / "slot.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "slot.step")))
        assert "not whole" in self.refused(cell).given

    @pytest.mark.parametrize("gap", [1e-5, 0.01])
    def test_a_pillar_above_the_plate(self, tmp_path, gap):
        plate = prism(SQUARE.corners, 0.0, THICKNESS)
        loose = occ.Cylinder(occ.Pnt(0, 0, THICKNESS / MM + gap), occ.Z, r=2.0, h=3.0)
        occ.Compound([plate, loose]).WriteStep(str(tmp_path / "loose.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "loose.step")))
        assert "2 pieces" in self.refused(cell).given

    def test_a_cone_with_a_tip(self, tmp_path):
        plate = prism(7 * MM * (np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) - 0.5), 0.0, THICKNESS)
        (plate + occ.Cone(occ.Axes((0, 0, 1.5), occ.Z), 1.8, 0.0, 4, 2 * np.pi)).WriteStep(
            str(tmp_path / "tip.step")
        )
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "tip.step")))
        error = self.refused(cell)
        assert "Netgen" in error.given
        assert "tip" in error.next_step

    def test_a_plate_that_is_not_normal_to_z(self, tmp_path):
        plate = occ.Box(occ.Pnt(-3.5, 0, -3.5), occ.Pnt(3.5, THICKNESS / MM, 3.5))
        plate.WriteStep(str(tmp_path / "tilted.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "tilted.step")))
        error = self.refused(cell)
        assert "7 mm x 1.5 mm x 7 mm" in error.given
        assert "axes" in error.cause

    def test_solids_that_overlap(self, tmp_path):
        plate = prism(SQUARE.corners, 0.0, THICKNESS)
        inside = occ.Cylinder(occ.Pnt(0, 0, 0), occ.Z, r=2.0, h=3.0)
        occ.Compound([plate, inside]).WriteStep(str(tmp_path / "overlap.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "overlap.step")))
        assert "overlap" in self.refused(cell).given

    def test_surfaces_only(self, tmp_path):
        prism(SQUARE.corners, 0.0, THICKNESS).faces[0].WriteStep(str(tmp_path / "faces.step"))
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "faces.step")))
        assert "without a solid" in self.refused(cell).given

    @pytest.mark.parametrize("content", [b"", b"ISO-10303-21;\nHEADER;", b"\0" * 1000, b"solid x"])
    def test_a_file_that_is_none(self, tmp_path, content):
        (tmp_path / "bad.step").write_bytes(content)
        cell = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(tmp_path / "bad.step")))
        assert self.refused(cell).code in ("unreadable", "mismatch")

    def test_no_file(self, tmp_path):
        with pytest.raises(HaptonicError) as caught:
            Solid(file=str(tmp_path / "none.step"))
        assert caught.value.argument == "cell.solid.file"

    def test_another_format(self):
        with pytest.raises(HaptonicError) as caught:
            Solid(file="cell.sldprt")
        assert caught.value.code == "unsupported"

    def test_a_file_that_was_changed(self, pillar):
        with pytest.raises(HaptonicError) as caught:
            Solid(file=pillar.file, sha256="0" * 64)
        assert caught.value.argument == "cell.solid.sha256"

    @pytest.mark.parametrize(
        "beside", [{"pillar": Pillar(2 * MM, 3 * MM)}, {"disc": (PILLAR,)}, {"faces": "both"}]
    )
    def test_something_beside_the_solids(self, pillar, beside):
        with pytest.raises(HaptonicError) as caught:
            UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=pillar, **beside)
        assert caught.value.code == "conflict"


def test_a_study_finds_the_file_beside_it(tmp_path):
    from haptonic.study import load

    _, solids = drawn(tmp_path, SQUARE, PILLAR)
    (tmp_path / "study.toml").write_text(
        'material = "aluminium-2017a"\n[cell]\nlattice = "square"\npitch = "7 mm"\nthickness = "1.5 mm"\n'
        '[cell.solid]\nfile = "cell.step"\n'
    )
    study = load(tmp_path / "study.toml")
    assert study.cell.solid.sha256 == solids.solid.sha256
    with pytest.raises(HaptonicError) as caught:
        study.tolerance()
    assert caught.value.argument == "cell.solid"


def test_all_files_of_its_bands_are_written(tmp_path):
    """Modes of triangles are drawn too, whose lower faces are finer than the sides."""
    from haptonic.study import load

    drawn(tmp_path, SQUARE, PILLAR)
    (tmp_path / "study.toml").write_text(
        'material = "aluminium-2017a"\n[cell]\npitch = "7 mm"\nthickness = "1.5 mm"\n'
        '[cell.solid]\nfile = "cell.step"\n[bands]\ncount = 6\npoints = 9\n'
        "[mesh]\norder = 2\nfoot_rings = 0\n"
    )
    bands = load(tmp_path / "study.toml").bands(html=True)
    bands.write(tmp_path / "out")
    assert {"bands.csv", "modes.png", "bands.html"} <= {path.name for path in (tmp_path / "out").iterdir()}
