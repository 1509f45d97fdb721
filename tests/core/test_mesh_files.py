"""Cells as meshes of other programs: formats, groups, refusals, frequencies against the mesh of blocks."""

from dataclasses import replace

import meshio
import numpy as np
import pytest
from strategies import ALUMINIUM

from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.candidates import BestModel
from haptonic.bloch.settings import BandSettings
from haptonic.cell import Disc, Solid, SolidPart, UnitCell
from haptonic.errors import HaptonicError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.results.common import accuracy_remarks

pytest.importorskip("ngsolve")

from cad_cells import occ, prism
from haptonic.foreign import meshes, solids
from haptonic.foreign.elements import CORNERS, EDGES, SHAPES, NamedElements, read_elements
from mesh_cells import hexahedra, tetrahedra, write

MM = 1e-3
THICKNESS = 1.5 * MM
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)
ACROSS, UPWARD = np.array([-3.5, -1.5, 0.0, 1.5, 3.5]), np.array([0.0, 1.5, 5.5])
STEEL = material("steel")
KAPPAS = np.pi * np.array([(0.2, 0.1), (1.0, 0.0)])
COARSE = Resolution(2, 0)


def pillar_at(x, y, z):
    return "plate" if z < 1.5 else "pillar" if max(abs(x), abs(y)) < 1.5 else ""


PILLAR = hexahedra(ACROSS, UPWARD, pillar_at)
PLATE = hexahedra(ACROSS, UPWARD[:2], lambda x, y, z: "plate")


def cell_of(path, *, lattice=SQUARE, thickness=THICKNESS, unit="mm", **parts):
    """The cell of a mesh; ``parts`` are materials of groups."""
    tables = tuple(SolidPart(name=name.replace("_", " "), material=solid) for name, solid in parts.items())
    return UnitCell(lattice, thickness, ALUMINIUM, solid=Solid(file=str(path), unit=unit, part=tables))


def frequencies(cell, resolution=COARSE):
    model = BlochModel.of(cell, resolution, 4, measured=False)
    return np.array([model.solve(kappa).frequency for kappa in KAPPAS])


def agree(cell, blocks, order, apart):
    """Compare frequencies with those of the mesh of blocks: within their errors, and within a share."""
    models = [
        BlochModel.of(each, Resolution(n, 1), 4, measured=False) for each, n in ((blocks, 3), (cell, order))
    ]
    for kappa in KAPPAS:
        exact, ours = (model.solve(kappa) for model in models)
        assert (np.abs(ours.frequency - exact.frequency) <= ours.error + exact.error).all()
        assert ours.frequency == pytest.approx(exact.frequency, rel=apart)


class TestFrequencies:
    @pytest.mark.nightly
    def test_a_plain_plate_has_those_of_its_block_mesh(self, tmp_path):
        cell = cell_of(write(tmp_path / "plate.vtu", *PLATE))
        exact = frequencies(UnitCell(SQUARE, THICKNESS, ALUMINIUM), Resolution(3, 1))
        assert frequencies(cell, Resolution(3, 0)) == pytest.approx(exact, rel=2e-3)

    @pytest.mark.nightly
    def test_a_square_pillar_has_those_of_its_block_mesh(self, tmp_path):
        cell = cell_of(write(tmp_path / "pillar.msh", *PILLAR), pillar=STEEL)
        disc = Disc(3 * MM, low=0.0, high=4 * MM, section="square", material=STEEL)
        agree(cell, UnitCell(SQUARE, THICKNESS, ALUMINIUM, disc=(disc,)), order=3, apart=6e-2)

    def test_every_format_gives_the_same(self, tmp_path):
        names = {".msh": "pillar", ".bdf": "property_2", ".inp": "pillar", ".vtk": "material_2"}
        spectra = [frequencies(cell_of(write(tmp_path / f"cell{ending}", *PILLAR), **{name: STEEL}))
                 for ending, name in names.items()]  # fmt: skip
        for others in spectra[1:]:
            assert others == pytest.approx(spectra[0], rel=1e-9)

    @pytest.mark.nightly
    def test_groups_of_one_material_change_nothing(self, tmp_path):
        places, nodes, _ = PILLAR
        undivided = cell_of(write(tmp_path / "one.msh", places, nodes, {"all": np.arange(len(nodes))}))
        divided = cell_of(write(tmp_path / "two.msh", *PILLAR), pillar=ALUMINIUM)
        # so many interior modes that their random start, which depends on the numbering, is unimportant
        many = replace(COARSE, steps=5)
        assert frequencies(divided, many) == pytest.approx(frequencies(undivided, many), rel=1e-9)

    @pytest.mark.nightly
    @pytest.mark.parametrize("lattice", [SQUARE, TRIANGULAR], ids=["square", "triangular"])
    @pytest.mark.parametrize("quadratic", [True, False])
    def test_tetrahedra_of_a_round_pillar_have_those_of_its_block_mesh(self, tmp_path, lattice, quadratic):
        plate = prism(lattice.corners, 0.0, THICKNESS)
        pillar = occ.Cylinder(occ.Pnt(0, 0, 1.5), occ.Z, r=1.5, h=4.0)
        body = _named(plate=plate, pillar=pillar)
        mesh = tetrahedra(body, 1.5, quadratic=quadratic)
        path = write(tmp_path / "cell.msh", *mesh, kind="tetra10" if quadratic else "tetra")
        blocks = UnitCell(lattice, THICKNESS, ALUMINIUM, disc=(Disc(3 * MM, low=0.0, high=4 * MM),))
        agree(cell_of(path, lattice=lattice, pillar=ALUMINIUM), blocks, order=3, apart=3e-2)

    @pytest.mark.nightly
    def test_a_coated_inclusion_has_those_of_its_block_mesh(self, tmp_path):
        epoxy = material("epoxy")
        plate = prism(SQUARE.corners, 0.0, THICKNESS)
        outer, core = (occ.Cylinder(occ.Pnt(0, 0, 0), occ.Z, r=r, h=1.5) for r in (2.5, 2.0))
        body = _named(plate=plate - outer, coat=outer - core, core=core)
        path = write(tmp_path / "cell.inp", *tetrahedra(body, 0.8, quadratic=True), kind="tetra10")
        discs = Disc(5 * MM, material=epoxy), Disc(4 * MM, material=STEEL)
        agree(cell_of(path, coat=epoxy, core=STEEL), UnitCell(SQUARE, THICKNESS, ALUMINIUM, disc=discs),
              order=3, apart=3e-2)  # fmt: skip


def _named(**bodies):
    for name, body in bodies.items():
        for solid in body.solids:
            solid.name = name
    return occ.Glue(list(bodies.values()))


class TestPeriods:
    def test_parts_have_the_volumes_of_the_drawing(self, tmp_path):
        period = cell_of(write(tmp_path / "pillar.inp", *PILLAR), pillar=STEEL).solid_period
        volumes = dict(zip(period.names, period.volumes.tolist(), strict=True))
        assert volumes == pytest.approx({"plate": 7 * 7 * 1.5e-9, "pillar": 3 * 3 * 4e-9}, rel=1e-12)

    def test_quadratic_tetrahedra_are_curved(self, tmp_path):
        body = _named(
            plate=prism(SQUARE.corners, 0.0, THICKNESS),
            pillar=occ.Cylinder(occ.Pnt(0, 0, 1.5), occ.Z, r=1.5, h=4.0),
        )
        path = write(tmp_path / "cell.msh", *tetrahedra(body, 2.0, quadratic=True), kind="tetra10")
        period = cell_of(path, pillar=STEEL).solid_period
        assert not period.straight
        volume = period.volumes[period.names.index("pillar")]
        assert volume == pytest.approx(np.pi * 1.5**2 * 4e-9, rel=1e-3)  # of straight edges it is 4 % off

    def test_only_straight_meshes_get_a_remark_on_polygons(self, tmp_path):
        mesh = cell_of(write(tmp_path / "cell.msh", *PLATE))
        for cell, remarks in ((mesh, 1), (UnitCell(SQUARE, THICKNESS, ALUMINIUM), 0)):
            best = BestModel(BlochModel.of(cell, COARSE, 4, measured=False))
            texts = accuracy_remarks(best.attributes(BandSettings(4, accuracy=1e-2), 1e-3))
            assert [text for text in texts if "polygons" in text and "cell.msh" in text] == texts
            assert len(texts) == remarks

    def test_a_symmetric_mesh_has_the_symmetry_of_the_lattice(self, tmp_path):
        assert len(cell_of(write(tmp_path / "a.vtu", *PILLAR), material_2=STEEL).point_group) == 8
        places, nodes, _ = PILLAR
        mesh = meshio.read(tmp_path / "a.vtu")
        mesh.cell_data["material"] = [numbers.astype(float) for numbers in mesh.cell_data["material"]]
        mesh.write(tmp_path / "decimals.vtu")
        assert len(cell_of(tmp_path / "decimals.vtu", material_2=STEEL).point_group) == 8
        pillar = PILLAR[2]["pillar"]  # the first two have x < 0
        askew = {"plate": PILLAR[2]["plate"], "left": pillar[:2], "right": pillar[2:]}
        cell = cell_of(write(tmp_path / "b.msh", places, nodes, askew), left=STEEL, right=ALUMINIUM)
        assert len(cell.point_group) == 2

    def test_place_unit_and_nodes_without_element_do_not_matter(self, tmp_path):
        places, nodes, sets = PILLAR
        moved = np.vstack([places + np.array([3.0, -8.0, 5.0]), [(50.0, 50.0, 50.0)]])
        first = cell_of(write(tmp_path / "a.inp", places, nodes, sets), pillar=STEEL)
        second = cell_of(write(tmp_path / "b.inp", 1e-3 * moved, nodes, sets), unit="m", pillar=STEEL)
        assert second.solid_period.volumes == pytest.approx(first.solid_period.volumes, rel=1e-9)
        assert len(second.point_group) == 8

    def test_a_mesh_from_a_file_is_the_mesh_itself(self, tmp_path, monkeypatch):
        path = write(tmp_path / "cell.msh", *PILLAR)
        drawn = {"tile": SQUARE.corners, "vectors": SQUARE.vectors, "thickness": THICKNESS, "unit": MM,
                 "with_material": ["pillar"]}  # fmt: skip
        rest = {"order": 2, "rings": 0, "stiffness": np.stack([STEEL.stiffness, ALUMINIUM.stiffness]),
                "density": np.array([STEEL.density, ALUMINIUM.density]), "along": np.array([0, 0.3, 1.0]),
                "upward": np.array([0, 0.5, 1.0]), "inside": np.array([0, 0.5, 1.0])}  # fmt: skip
        read = solids.assembled(str(path), digest="file", **drawn, **rest)
        places, nodes, sets = PILLAR
        directly = NamedElements(
            places[np.unique(nodes)],
            [("hexahedron", np.unique(nodes, return_inverse=True)[1].reshape(nodes.shape))],
            sets,
        )
        monkeypatch.setattr(meshes, "read_elements", lambda path: directly)
        handed = solids.assembled(str(path), digest="directly", **drawn, **rest)
        for name in ("stiffness", "mass"):
            assert read[name]["values"] == pytest.approx(handed[name]["values"], rel=1e-9)
        assert read["trace"] == pytest.approx(handed["trace"], rel=1e-9, abs=1e-12)


class TestGroups:
    def test_sets_of_abaqus_keep_their_elements_over_several_blocks(self, tmp_path):
        """Blocks of the same set, a set of sets, GENERATE, and a block without a set in front."""
        places, nodes, sets = PILLAR
        lines = ["*NODE", *(f"{n}, {x}, {y}, {z}" for n, (x, y, z) in enumerate(places.tolist(), 1))]
        blocks = {"PLATE": sets["plate"][:7], "": sets["plate"][7:], "TOP": sets["pillar"][:1]}
        for name, members in (*blocks.items(), ("TOP", sets["pillar"][1:])):
            lines.append("*ELEMENT, TYPE=C3D8" + (f", ELSET={name}" if name else ""))
            lines += [", ".join(map(str, [m + 1, *(nodes[m] + 1)])) for m in members.tolist()]
        lines += ["*ELSET, ELSET=ALL, GENERATE", f"1, {len(nodes)}, 1", "*ELSET, ELSET=BOTH", "TOP, PLATE"]
        (tmp_path / "cell.inp").write_text("\n".join(lines) + "\n")
        mesh = read_elements(str(tmp_path / "cell.inp"))
        groups, middles = (
            mesh.groups,
            mesh.points[np.vstack([nodes for _, nodes in mesh.blocks])].mean(axis=1),
        )
        assert {name: len(members) for name, members in groups.items()} == {
            "PLATE": 7, "TOP": 4, "ALL": 20, "BOTH": 11,
        }  # fmt: skip
        assert (middles[groups["TOP"], 2] == 3.5).all()
        assert (middles[groups["PLATE"], 2] == 0.75).all()

    def test_volumes_of_gmsh_may_be_in_several_physical_groups(self, tmp_path):
        """A file of version 4.1, as Gmsh writes it: two entities, of which the upper is in two groups."""
        places, nodes, _ = hexahedra(np.array([0.0, 1.0]), np.arange(3.0), lambda x, y, z: "a")
        lines = [
            "$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '3 1 "plate"', '3 2 "pillar"',
            '3 7 "all"', "$EndPhysicalNames", "$Entities", "0 0 0 2", "1 0 0 0 1 1 1 1 1 0",
            "2 0 0 1 1 1 2 2 7 2 0", "$EndEntities", "$Nodes", f"1 {len(places)} 1 {len(places)}",
            f"3 1 0 {len(places)}", *(str(n + 1) for n in range(len(places))),
            *(f"{x} {y} {z}" for x, y, z in places.tolist()), "$EndNodes", "$Elements", "2 2 1 2",
            *(line for n, row in enumerate((nodes + 1).tolist(), start=1)
              for line in (f"3 {n} 5 1", " ".join(map(str, [n, *row])))), "$EndElements",
        ]  # fmt: skip
        (tmp_path / "cell.msh").write_text("\n".join(lines) + "\n")
        groups = read_elements(str(tmp_path / "cell.msh")).groups
        assert {name: members.tolist() for name, members in groups.items()} == {
            "plate": [0], "pillar": [1], "all": [1],
        }  # fmt: skip

    def test_quadratic_prisms_and_pyramids_of_gmsh_have_their_midpoints(self, tmp_path):
        """One of each, with the order of midpoints from the manual of Gmsh."""
        of_gmsh = {
            "wedge": (18, ((0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5))),
            "pyramid": (19, ((0, 1), (0, 3), (0, 4), (1, 2), (1, 4), (2, 3), (2, 4), (3, 4))),
        }
        corners = {
            "wedge": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)],
            "pyramid": [(2, 0, 0), (3, 0, 0), (3, 1, 0), (2, 1, 0), (2.5, 0.5, 1)],
        }
        places, elements = [], []
        for kind, (number, edges) in of_gmsh.items():
            own = np.array(corners[kind], dtype=float)
            nodes = np.concatenate([own, [own[list(edge)].mean(axis=0) for edge in edges]])
            elements.append([number, 2, 1, 1, *range(len(places) + 1, len(places) + len(nodes) + 1)])
            places += nodes.tolist()
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(places))]
        lines += [f"{n} {x} {y} {z}" for n, (x, y, z) in enumerate(places, start=1)]
        lines += ["$EndNodes", "$Elements", "2"]
        lines += [f"{n} {' '.join(map(str, row))}" for n, row in enumerate(elements, start=1)]
        (tmp_path / "cell.msh").write_text("\n".join([*lines, "$EndElements"]) + "\n")
        read = read_elements(str(tmp_path / "cell.msh"))
        assert {kind for kind, _ in read.blocks} == {"wedge15", "pyramid13"}
        for kind, nodes in read.blocks:
            at = read.points[nodes[0]]
            ends = np.array(EDGES[SHAPES[kind]])
            assert at[CORNERS[SHAPES[kind]] :] == pytest.approx(at[ends].mean(axis=1))

    def test_nastran_files_may_be_the_bulk_data_alone(self, tmp_path):
        whole = write(tmp_path / "cell.bdf", *PILLAR)
        bulk = whole.read_text().split("BEGIN BULK\n")[1].replace("ENDDATA", "")
        (tmp_path / "bulk.nas").write_text(bulk)
        assert cell_of(tmp_path / "bulk.nas", property_2=STEEL).solid_period.volumes.sum() == pytest.approx(
            7 * 7 * 1.5e-9 + 36e-9
        )

    def test_an_element_may_be_in_a_group_without_a_material_too(self, tmp_path):
        places, nodes, sets = PILLAR
        path = tmp_path / "cell.inp"
        write(path, places, nodes, sets)
        path.write_text(path.read_text() + f"*ELSET, ELSET=EALL, GENERATE\n1, {len(nodes)}, 1\n")
        assert set(cell_of(path, pillar=STEEL).solid_period.names) == {"pillar", "plate, EALL"}


def moved(mesh, node, by):
    places = mesh[0].copy()
    places[node] += by
    return places, *mesh[1:]


def node_at(mesh, *place):
    return int(np.linalg.norm(mesh[0] - place, axis=1).argmin())


def cracked():
    """Nodes of the pillar's foot of their own."""
    places, nodes, sets = PILLAR
    foot = np.unique(nodes[sets["pillar"]][:, :4])
    number = np.arange(len(places))
    number[foot] = len(places) + np.arange(len(foot))
    nodes = nodes.copy()
    nodes[sets["pillar"]] = number[nodes[sets["pillar"]]]
    return np.vstack([places, places[foot]]), nodes, sets


def finer_pillar():
    """A pillar whose elements are half as wide as those of the plate below."""
    fine = np.linspace(-1.5, 1.5, 5)
    places, nodes, _ = hexahedra(fine, UPWARD[1:], lambda x, y, z: "pillar")
    below, plate, _ = PLATE
    shared = {tuple(place): n for n, place in enumerate(below.tolist())}
    number = [shared.get(tuple(place), len(below) + n) for n, place in enumerate(places.tolist())]
    sets = {"plate": np.arange(len(plate)), "pillar": len(plate) + np.arange(len(nodes))}
    return np.vstack([below, places]), np.vstack([plate, np.array(number)[nodes]]), sets


def rhombus():
    shares = hexahedra(np.linspace(-0.5, 0.5, 4), UPWARD[:2], lambda x, y, z: "plate")
    places = shares[0].copy()
    places[:, :2] = shares[0][:, :2] @ (1e3 * TRIANGULAR.vectors)
    return places, *shares[1:]


HOLE = hexahedra(ACROSS, UPWARD[:2], lambda x, y, z: "" if x < -1.5 and -1.5 < y < 0 else "plate")
LOOSE = hexahedra(
    ACROSS, np.array([0.0, 1.5, 2.0, 5.5]),
    lambda x, y, z: "plate" if z < 1.5 else "pillar" if z > 2.0 and max(abs(x), abs(y)) < 1.5 else "",
)  # fmt: skip
HINGE = hexahedra(
    ACROSS, np.array([0.0, 1.5, 3.0]),
    lambda x, y, z: "plate" if z < 1.5 and not (-1.5 < x < 0 and -1.5 < y < 1.5) else
    "flap" if z > 1.5 and -1.5 < x < 0 and -1.5 < y < 1.5 else "",
)  # fmt: skip
TWICE = (PLATE[0], np.vstack([PLATE[1], PLATE[1][:1]]), {"plate": np.arange(17)})
AT_SIDE = hexahedra(ACROSS, UPWARD, lambda x, y, z: "plate" if z < 1.5 or x < -1.5 else "")
LAYERS = hexahedra(ACROSS, np.array([0.0, 1.0, 1.5]), lambda x, y, z: "low" if z < 1.0 else "high")
ONE = hexahedra(np.array([-3.5, 3.5]), UPWARD[:2], lambda x, y, z: "plate")


class TestRefusals:
    def refused(self, cell):
        with pytest.raises(HaptonicError) as caught:
            _ = cell.solid_period
        return caught.value

    @pytest.mark.parametrize(
        ("mesh", "words"),
        [
            (moved(PILLAR, node_at(PILLAR, 0, 0, 1.5), (0, 0, -2.0)), "without volume or turned inside out"),
            (cracked(), "18 nodes at the place of another"),
            (finer_pillar(), "on an element's face that are not joined"),
            (LOOSE, "pieces that no faces join"),
            (HINGE, "pieces that no faces join"),
            (TWICE, "more than two elements"),
            (HOLE, "of a side of the cell"),
            (AT_SIDE, "of a side of the cell"),
            (LAYERS, "groups that meet the sides of the cell: "),
            (ONE, "one element along a side"),
            (moved(PILLAR, node_at(PILLAR, -1.5, -3.5, 0), (0, 0.4, 0)), "of a side of the cell"),
        ],
        ids=["inverted", "crack", "hanging", "loose", "hinge", "twice", "hole", "pillar at side", "layers",
             "coarse", "bent side"],
    )  # fmt: skip
    def test_a_mesh_that_is_no_period(self, tmp_path, mesh, words):
        parts = {name: STEEL for name in mesh[2] if name != "plate"}
        error = self.refused(cell_of(write(tmp_path / "cell.msh", *mesh), **parts))
        assert words in error.given
        assert error.code == "mismatch"

    def test_tetrahedra_on_the_faces_of_hexahedra(self, tmp_path):
        places, nodes, sets = PILLAR
        ways = [(0, a, b, 6) for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))]
        split = np.vstack([nodes[sets["pillar"]][:, way] for way in ways])
        blocks = [("hexahedron", nodes[sets["plate"]]), ("tetra", split)]
        meshio.vtu.write(tmp_path / "cell.vtu", meshio.Mesh(places, blocks))
        assert "on an element's face" in self.refused(cell_of(tmp_path / "cell.vtu")).given

    def test_a_curved_tetrahedron_that_is_folded(self, tmp_path):
        body = _named(plate=prism(SQUARE.corners, 0.0, THICKNESS))
        places, nodes, sets = tetrahedra(body, 3.0, quadratic=True)
        top = np.isclose(places[nodes[:, 4], 2], 1.5) & (np.abs(places[nodes[:, 4], :2]) < 3).all(axis=1)
        places[nodes[top.argmax(), 4], 2] -= 1.2
        path = write(tmp_path / "cell.msh", places, nodes, sets, kind="tetra10")
        assert "turned inside out" in self.refused(cell_of(path)).given

    def test_another_size_names_the_unit_that_fits(self, tmp_path):
        path = write(tmp_path / "cell.msh", *PLATE)
        error = self.refused(cell_of(path, unit="in"))
        assert error.given == "a mesh of 177.8 mm x 177.8 mm in x and y"
        assert 'unit = "mm"' in error.next_step
        assert "7 mm x 7 mm" in self.refused(cell_of(path, lattice=Lattice.square(6 * MM))).given

    def test_a_rhombus(self, tmp_path):
        error = self.refused(cell_of(write(tmp_path / "cell.msh", *rhombus()), lattice=TRIANGULAR))
        assert error.code == "mismatch"

    def test_a_hexagon_with_a_corner_that_is_moved(self, tmp_path):
        body = _named(plate=prism(TRIANGULAR.corners, 0.0, THICKNESS))
        places, *rest = tetrahedra(body, 3.0)
        assert cell_of(
            write(tmp_path / "a.msh", places, *rest, kind="tetra"), lattice=TRIANGULAR
        ).solid_period
        corner = (1e3 * TRIANGULAR.corners[0]).tolist()
        at = np.linalg.norm(places[:, :2] - corner, axis=1) < 0.1
        places[at, 1 - int(np.abs(corner).argmax())] += 0.3
        path = write(tmp_path / "b.msh", places, *rest, kind="tetra")
        assert "beyond a side of the cell, at (" in self.refused(cell_of(path, lattice=TRIANGULAR)).given

    def test_another_thickness(self, tmp_path):
        error = self.refused(cell_of(write(tmp_path / "cell.msh", *PLATE), thickness=1 * MM))
        assert error.argument == "cell.thickness"
        assert "1.5 mm" in error.next_step

    def test_a_group_without_a_material(self, tmp_path):
        error = self.refused(cell_of(write(tmp_path / "cell.msh", *PILLAR)))
        assert (error.code, error.argument) == ("missing", "cell.solid.part")
        assert 'name = "pillar"' in error.next_step

    def test_a_name_that_no_group_has(self, tmp_path):
        error = self.refused(cell_of(write(tmp_path / "cell.msh", *PILLAR), piller=STEEL))
        assert error.code == "unknown"
        assert error.next_step == 'write "pillar"'

    def test_two_materials_for_an_element(self, tmp_path):
        path = write(tmp_path / "cell.inp", *PILLAR)
        path.write_text(path.read_text() + "*ELSET, ELSET=TOP\n17, 18\n")
        assert "pillar and TOP" in self.refused(cell_of(path, pillar=STEEL, TOP=STEEL)).given

    def test_surfaces_only(self, tmp_path):
        triangles = np.array([[0, 1, 2], [1, 2, 3]])
        meshio.vtu.write(tmp_path / "cell.vtu", meshio.Mesh(PLATE[0], [("triangle", triangles)]))
        error = self.refused(cell_of(tmp_path / "cell.vtu"))
        assert error.given == "a mesh without volume elements (it has: triangle)"

    def test_elements_of_a_kind_that_is_not_read(self, tmp_path):
        nodes = np.arange(27)[None]
        places = np.random.default_rng(1).random((27, 3))
        meshio.vtu.write(tmp_path / "cell.vtu", meshio.Mesh(places, [("hexahedron27", nodes)]))
        error = self.refused(cell_of(tmp_path / "cell.vtu", core=STEEL))
        assert error.given == "elements of the kind 'hexahedron27'"

    @pytest.mark.parametrize("ending", [".msh", ".bdf", ".nas", ".inp", ".vtu", ".vtk"])
    @pytest.mark.parametrize("content", [b"", b"\0" * 1000, b"$MeshFormat\n4.1 0 8\n", b"*NODE\n1, 0, 0\n"])
    def test_a_file_that_is_none(self, tmp_path, ending, content):
        path = tmp_path / f"bad{ending}"
        path.write_bytes(content)
        assert self.refused(cell_of(path)).code in ("unreadable", "mismatch")

    @pytest.mark.parametrize(
        ("name", "content", "words"),
        [
            ("a.inp", "*NODE\n1, 0, 0, 0\n*NODE\n1, 1, 0, 0\n", "several parts"),
            ("a.inp", "*INCLUDE, INPUT=/etc/passwd\n", "*INCLUDE"),
            ("a.inp", "*INSTANCE, NAME=a, PART=b\n1, 0, 0\n*NODE\n1, 0, 0, 0\n", "*INSTANCE"),
            ("a.bdf", "BEGIN BULK\nINCLUDE 'b.bdf'\nENDDATA\n", "INCLUDE"),
            ("a.bdf", "BEGIN BULK\nCTETRA* 1               1\n", "large field"),
        ],
    )
    def test_unsupported_statements_are_refused(self, tmp_path, name, content, words):
        (tmp_path / name).write_text(content)
        assert words in self.refused(cell_of(tmp_path / name)).given

    def test_a_file_that_is_too_large_before_it_is_read(self, tmp_path):
        with (tmp_path / "large.msh").open("wb") as file:
            file.truncate(2 * 10**9)
        with pytest.raises(HaptonicError) as caught:
            Solid(file=str(tmp_path / "large.msh"))
        assert "larger than 200 MB" in caught.value.cause

    def test_a_mesh_of_comsol_names_the_way_to_export_another(self):
        with pytest.raises(HaptonicError) as caught:
            Solid(file="cell.mphtxt")
        assert caught.value.code == "unsupported"
        assert "Nastran" in caught.value.next_step

    def test_a_unit_for_a_step_file(self, tmp_path):
        (tmp_path / "cell.step").write_text("")
        with pytest.raises(HaptonicError) as caught:
            Solid(file=str(tmp_path / "cell.step"), unit="m")
        assert caught.value.argument == "cell.solid.unit"


def test_a_study_gives_unit_and_groups(tmp_path):
    from haptonic.study import load

    write(tmp_path / "cell.bdf", *PILLAR)
    (tmp_path / "study.toml").write_text(
        'material = "aluminium-2017a"\n[cell]\nlattice = "square"\npitch = "7 mm"\nthickness = "1.5 mm"\n'
        '[cell.solid]\nfile = "cell.bdf"\nunit = "mm"\n'
        '[[cell.solid.part]]\nname = "property 2"\nmaterial = "steel"\n'
    )
    study = load(tmp_path / "study.toml")
    assert study.cell.solid.unit == "mm"
    assert replace(study.cell, material=ALUMINIUM).solid_period.names == ("property 2", "property 1")
    with pytest.raises(HaptonicError) as caught:
        study.layers()  # a mirror has one loss factor
    assert (caught.value.code, caught.value.argument) == ("unsupported", "cell.solid.part[1].material")
