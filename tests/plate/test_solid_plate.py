"""Plates whose lattice comes from a CAD file or mesh: against plates of blocks, and identities."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import scipy.linalg as la
from small import LOSS
from whole import answered, forms, lossless

from bricks import ALUMINIUM, PITCH, THICKNESS
from five_parts import refusing
from haptonic.cell import Brickwork, Disc, Solid, SolidPart, UnitCell
from haptonic.errors import GeometryError, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate.body.model import Fineness, PlateModel
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Force, Plate
from haptonic.plate.layout.supports import Support
from haptonic.study import load

pytest.importorskip("ngsolve")

from cad_cells import step_of
from haptonic.superelement.surplus import EDGE
from mesh_cells import hexahedra, write

LEFT = 1 / (1.5 ** (4 * EDGE) - 1)  # error of order 3 over its distance to order 2, at an edge

MM, HZ = 1e-3, 2 * np.pi
STEEL = material("steel")
ACROSS, UPWARD = np.array([-3.5, -1.5, 0.0, 1.5, 3.5]), np.array([0.0, 1.5, 5.5])
SQUARE = Lattice.square(PITCH)
BLOCKS = UnitCell(
    SQUARE, THICKNESS, ALUMINIUM, disc=(Disc(3 * MM, low=0.0, high=4 * MM, section="square", material=STEEL),)
)
PLAIN = UnitCell(SQUARE, THICKNESS, ALUMINIUM)
ON_CELL = np.array([(1.3, 2.2), (5.1, 0.4), (3.5, 3.5), (6.9, 5.0)]) * MM  # of the first tile


def pillar(x, y, z):
    return "plate" if z < 1.5 else "pillar" if max(abs(x), abs(y)) < 1.5 else ""


def three_quarters(x, y, z):
    return "" if z > 1.5 and x < 0 and y < 0 else pillar(x, y, z)


MESHES = {
    "plate": hexahedra(ACROSS, UPWARD[:2], lambda x, y, z: "plate"),
    "pillar": hexahedra(ACROSS, UPWARD, pillar),
    "corner": hexahedra(ACROSS, UPWARD, three_quarters),
    "mirrored": hexahedra(ACROSS, UPWARD, lambda x, y, z: three_quarters(-x, y, z)),
    "hole": hexahedra(ACROSS, UPWARD[:2], lambda x, y, z: "" if max(abs(x), abs(y)) < 1.5 else "plate"),
    "below": hexahedra(ACROSS, -UPWARD[::-1], lambda x, y, z: pillar(x, y, -z)),
}


@pytest.fixture(scope="module")
def cells(tmp_path_factory):
    """The cell of a mesh by its name."""
    folder = tmp_path_factory.mktemp("meshes")

    @cache
    def of_mesh(name):
        path = write(folder / f"{name}.msh", *MESHES[name])
        part = (SolidPart(name="pillar", material=STEEL),) if "pillar" in MESHES[name][2] else ()
        return UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(path), part=part))

    return of_mesh


def plate_of(text, cell, **others):
    """Rows of letters, the first one on top: "o" the lattice, others plain; clamped on the left."""
    tiles = tuple(tuple(row) for row in text.split()[::-1])
    x, y = (tuple((PITCH * np.arange(count + 1)).tolist()) for count in (len(tiles[0]), len(tiles)))
    layout = Layout(tiles, x, y, {"o": cell}, THICKNESS, ALUMINIUM)
    return Plate(layout, **{"supports": (Support("left", "clamped"),), "loss_factor": LOSS, **others})


def model_of(plate, order=2):
    return PlateModel.of(plate, 30e3, Fineness(along=4, through=2, cell=order, rings=order // 3, plain=3))


def modes(plate, order=2):
    return np.sqrt(la.eigh(*lossless(model_of(plate, order)), eigvals_only=True))[:5] / HZ


@pytest.mark.nightly
def test_pillars_of_a_mesh_have_the_resonances_of_pillars_of_blocks(cells):
    """As far apart as the orders of the mesh foretell."""
    coarse, fine = (modes(plate_of("o1o", cells("pillar")), order) for order in (2, 3))
    exact = modes(plate_of("o1o", BLOCKS), 3)
    distance = np.abs(coarse - fine) / fine
    allowed = LEFT * (distance + np.sqrt(np.mean(distance**2)))
    assert (np.abs(fine - exact) / exact < allowed).all()
    assert fine == pytest.approx(exact, rel=4e-2)


@pytest.mark.nightly
def test_drawn_pillars_have_the_resonances_and_answers_of_pillars_of_blocks(tmp_path):
    """Also seen on the curved elements below a pillar."""
    disc = Disc(3 * MM, low=0.0, high=4 * MM, material=STEEL)
    blocks = UnitCell(SQUARE, THICKNESS, ALUMINIUM, disc=(disc,))
    path, names = step_of(blocks, tmp_path / "cell.step")
    parts = tuple(SolidPart(name=name, material=solid) for name, solid in names.items())
    drawn = UnitCell(SQUARE, THICKNESS, ALUMINIUM, solid=Solid(file=str(path), part=parts))
    force, omega = Force("F", (10 * MM, 2 * MM)), HZ * np.array([4e3, 13e3])
    results = []
    for cell in (drawn, blocks):
        model = model_of(plate_of("o1o", cell, forces=(force,)), 3)
        resonances = np.sqrt(la.eigh(*lossless(model), eigvals_only=True))[:5] / HZ
        results.append((resonances, model.observed(ON_CELL) @ answered(model, {"F": 1.0}, omega)))
    assert results[0][0] == pytest.approx(results[1][0], rel=3e-3)
    assert results[0][1] == pytest.approx(results[1][1], rel=3e-2, abs=5e-3 * np.abs(results[1][1]).max())


@pytest.mark.nightly
def test_a_mesh_of_plain_plate_answers_as_plain_plate_does(cells):
    """Also at points of the mesh, which lie on its elements as they come."""
    force = Force("F", (17 * MM, 2 * MM))
    omega = HZ * np.array([4e3, 13e3])
    seen = []
    for text, cell, order in (("o11", cells("plate"), 3), ("111", PLAIN, 3)):
        model = model_of(plate_of(text, cell, forces=(force,)), order)
        seen.append(model.observed(ON_CELL) @ answered(model, {"F": 1.0}, omega))
    assert seen[0] == pytest.approx(seen[1], rel=2e-2, abs=2e-3 * np.abs(seen[1]).max())


def test_a_plate_and_its_mirror_image_move_alike(cells):
    """The file's cell has no symmetry of its own in x: sides that are exchanged would show."""
    width, omega = 2 * PITCH, HZ * np.array([9e3, 14e3])
    flip = np.array([width, 0.0]), np.array([-1.0, 1.0])
    point = np.array([10 * MM, 2.5 * MM])
    seen = []
    for text, name, where, push in (
        ("o1", "corner", ON_CELL, point),
        ("1o", "mirrored", flip[0] + flip[1] * ON_CELL, flip[0] + flip[1] * point),
        ("1o", "corner", flip[0] + flip[1] * ON_CELL, flip[0] + flip[1] * point),
    ):
        model = model_of(plate_of(text, cells(name), forces=(Force("F", tuple(push.tolist())),), supports=()))
        seen.append(model.observed(where) @ answered(model, {"F": 1.0}, omega))
    assert seen[1] == pytest.approx(seen[0], rel=1e-4)
    assert np.abs(seen[2] / seen[0] - 1).max() > 1e-2


def test_answers_are_reciprocal_and_what_is_driven_is_dissipated(cells):
    """Two forces on plain plate with a cell between them; losses are those of the whole strain energy."""
    places = {"F": (3 * MM, 3 * MM), "G": (17.9 * MM, 4.4 * MM)}
    forces = tuple(Force(name, at) for name, at in places.items())
    model = model_of(plate_of("1o1", cells("corner"), forces=forces, supports=()))
    omega = HZ * np.array([7e3, 14e3])
    fields = [answered(model, {name: 1.0}, omega) for name in places]
    seen = [model.observed(np.array([*places.values()])) @ field for field in fields]
    assert seen[0][1] == pytest.approx(seen[1][0], rel=1e-9)
    given = -0.5 * omega * seen[0][0].imag
    stiffness, _ = forms(model.assembly)
    lost = np.einsum("in,in->n", fields[0].conj(), sum(stiffness.values()) @ fields[0]).real
    assert given == pytest.approx(0.5 * omega * LOSS * lost, rel=1e-9)


def test_faces_at_the_bottom_fill_the_tile(cells):
    model = model_of(plate_of("o1", cells("corner")))
    (inside,) = (g.tile.inside for g in model.assembly.groups if 0 in g.blocks)
    (faces,) = inside.faces
    corners = inside.points[faces][:, [0, -1, -1, 0], [0, 0, -1, -1], :2]
    area = sum(
        0.5 * abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in pairwise([*loop, loop[0]]))) for loop in corners
    )
    assert area == pytest.approx(PITCH**2)


@pytest.mark.parametrize(
    ("name", "whole"), [("pillar", True), ("corner", True), ("hole", False), ("below", False)]
)
def test_only_a_whole_lower_face_counts_as_one(cells, name, whole):
    assert cells(name).solid_period.whole_below == whole


def test_cells_that_are_no_rectangles_are_refused(cells):
    solid = cells("plate").solid
    with refusing(GeometryError, "unsupported", "cell.lattice", "a rectangle of several pillars"):
        Brickwork.of(UnitCell(Lattice.triangular(PITCH), THICKNESS, ALUMINIUM, solid=solid))


@pytest.mark.parametrize("place", ["3 mm", "7 mm", "10 mm"])
def test_a_force_that_touches_a_cell_of_a_file_is_refused(tmp_path, place):
    write(tmp_path / "cell.msh", *MESHES["pillar"])
    (tmp_path / "study.toml").write_text(f"""
material = "aluminium-2017a"
[cell]
lattice = "square"
pitch = "7 mm"
thickness = "1.5 mm"
solid = {{file = "cell.msh", part = [{{name = "pillar", material = "aluminium-2017a"}}]}}
[plate]
map = "o1"
tiles = {{o = "lattice", 1 = "guide"}}
force = [{{name = "F", centre = ["{place}", "3 mm"]}}]
""")
    if place == "10 mm":
        assert load(tmp_path / "study.toml").mounted_plate().forces
    else:
        with refusing(StudyError, "out-of-range", "centre", "one region of plain plate"):
            load(tmp_path / "study.toml")
