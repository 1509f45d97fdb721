"""STEP, STL and DXF: the same body by independent roads, and files that are the same every time."""

import builtins
import math
import re
from dataclasses import replace

import ezdxf
import meshio
import numpy as np
import pytest
import scipy
from family import EXTREME, FAMILY, MM, RECTANGLE, cell, enclosed, is_watertight, volume

from five_parts import refusing
from haptonic.cell import Disc, Pillar, Step
from haptonic.errors import GeometryError, ResourceError
from haptonic.workshop import (
    Part,
    part_drawing,
    surface,
    volume_of_step,
    write_drawing,
    write_dxf,
    write_step,
    write_stl,
)
from haptonic.workshop.stl import CHORD

ALL = FAMILY | EXTREME
SIZES = [(1, 1), (2, 3)]
WRITERS = {"step": write_step, "stl": write_stl, "dxf": write_dxf}

pytest.importorskip("netgen.occ", reason="the extra cad is not installed")


@pytest.mark.parametrize("size", SIZES, ids=str)
@pytest.mark.parametrize("name", ALL)
def test_the_step_file_has_the_exact_volume(name, size, tmp_path):
    path = write_step(tmp_path / "plate.step", Part.piece(ALL[name], *size))
    assert volume_of_step(path) == pytest.approx(volume(ALL[name], math.prod(size)), rel=1e-6)


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_the_step_file_is_one_solid_in_mm_centred_on_the_origin(size, tmp_path):
    from netgen.occ import OCCGeometry

    pillar = Pillar(3.5 * MM, 9 * MM, fillet=0.5 * MM)
    path = write_step(tmp_path / "plate.step", Part.piece(cell(pillar, RECTANGLE), *size))
    assert "LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)" in path.read_text()
    shape = OCCGeometry(str(path)).shape
    assert len(shape.solids) == 1
    low, high = (np.array(list(corner)) for corner in shape.bounding_box)
    assert high == pytest.approx([3.5 * size[0], 4.5 * size[1], 10.5], abs=1e-5)
    assert low == pytest.approx([-3.5 * size[0], -4.5 * size[1], 0.0], abs=1e-5)


@pytest.mark.parametrize("title", ["Mirror", "it's a \\ plate", "Fl\u00e4che \u97f3 \U0001f50a", "a\nb"])
def test_the_product_of_a_step_file_has_the_title_and_no_authors(title, tmp_path):
    path = write_step(tmp_path / "plate.step", Part.piece(ALL["no pillar"]), title=title)
    text = path.read_bytes().decode("ascii")
    assert volume_of_step(path) == pytest.approx(volume(ALL["no pillar"]), rel=1e-6)
    assert "Author" not in text
    assert "translator" not in text
    name, again = re.search(r"= PRODUCT\(('(?:[^']|'')*'),('(?:[^']|'')*'),'',\(#\d+\)\);", text).groups()
    assert name == again
    quoted = name[1:-1].replace("''", "'")
    hidden = quoted.replace("\\\\", "\0")
    shown = re.sub(r"\\X2\\(.*?)\\X0\\", lambda m: bytes.fromhex(m[1]).decode("utf-16-be"), hidden)
    assert shown.replace("\0", "\\") == title


@pytest.mark.parametrize("name", ["SiO\u2082", "R\u00fchl's \\ glass"])
def test_materials_of_a_step_file_may_have_any_name(name, tmp_path):
    cell = replace(ALL["no pillar"], material=replace(ALL["no pillar"].material, name=name))
    part = Part.piece(replace(cell, disc=(Disc(1e-3, material="steel"),)))
    text = write_step(tmp_path / "plate.step", part).read_bytes().decode("ascii")
    hidden = "".join(c if c.isascii() else f"\\X2\\{ord(c):04X}\\X0\\" for c in name.replace("'", "''"))
    assert hidden.split("\\ ")[0] in text
    assert "steel" in text


@pytest.mark.parametrize("draft", [0.0, 0.03, -0.03])
def test_files_follow_an_outline(draft, tmp_path):
    """With a hexagon in place of the circle every file shows one, with the volume of one."""
    body = cell(Pillar(3 * MM, 9 * MM, draft=draft, fillet=0.5 * MM, step=Step(2 * MM, 5 * MM)), RECTANGLE)
    plate = 6 * body.lattice.area * body.thickness
    exact = plate + (volume(body, 6) - plate) * 2 * math.sqrt(3) / math.pi
    body = replace(body, pillar=replace(body.pillar, section="hexagon"))
    assert volume_of_step(write_step(tmp_path / "a.step", Part.piece(body, 2, 3))) == pytest.approx(
        exact, rel=1e-6
    )
    skin = surface(Part.piece(body, 2, 3), chord=1e-6)
    assert is_watertight(skin.cells_dict["triangle"])
    assert enclosed(skin.points, skin.cells_dict["triangle"]) == pytest.approx(exact, rel=1e-4)
    space = ezdxf.readfile(write_dxf(tmp_path / "a.dxf", Part.piece(body, 2, 3))).modelspace()
    outlines = space.query('LWPOLYLINE[layer=="PILLAR"]')
    assert [len(outline) for outline in outlines] == [6] * 6
    write_drawing(tmp_path / "drawing.dxf", part_drawing(Part.piece(body, 2, 3), "Hexagon"))
    sheet = ezdxf.readfile(tmp_path / "drawing.dxf").paperspace("Drawing")
    assert any(
        d.dxf.text == "<>" and "AF" in str(d.override().get("dimpost")) for d in sheet.query("DIMENSION")
    )


@pytest.mark.parametrize(
    "pillar", ["round draft 2 fillet 0.0005 step True", "square draft -3 fillet 0.0 step False"]
)
def test_with_pillars_on_both_faces_the_solids_have_both(pillar, tmp_path):
    """By volume, and by each body being its own image in the middle plane; outlines have layers of both."""
    body = replace(ALL[pillar], faces="both")
    part = Part.piece(body, 2, 3)
    exact = 6 * (body.lattice.area * body.thickness + 2 * body.pillar.volume)
    assert part.number == 12
    assert part.volume * MM**3 == pytest.approx(exact)
    assert volume_of_step(write_step(tmp_path / "a.step", part)) == pytest.approx(exact, rel=1e-6)
    skin = surface(part, chord=1e-6)
    assert is_watertight(skin.cells_dict["triangle"])
    assert enclosed(skin.points, skin.cells_dict["triangle"]) == pytest.approx(exact, rel=5e-4)
    image = skin.points * [1, 1, -1] + [0, 0, body.thickness]
    assert scipy.spatial.cKDTree(skin.points).query(image)[0].max() < 1e-12
    assert skin.points[:, 2].min() == pytest.approx(-body.pillar.height)
    space = ezdxf.readfile(write_dxf(tmp_path / "b.dxf", part)).modelspace()
    for layer in ("PILLAR", "PILLAR BELOW"):
        assert len(space.query(f'*[layer=="{layer}"]')) == 6


def test_a_step_file_without_a_solid_is_refused(tmp_path):
    (tmp_path / "empty.step").write_text("")
    for name in ("empty.step", "missing.step"):
        with refusing(ResourceError, "unreadable", "STEP file"):
            volume_of_step(tmp_path / name)


@pytest.mark.parametrize("size", SIZES, ids=str)
@pytest.mark.parametrize("name", ALL)
class TestSurface:
    def test_it_is_watertight_and_has_no_flat_triangle(self, name, size):
        skin = surface(Part.piece(ALL[name], *size))
        triangles = skin.cells_dict["triangle"]
        assert is_watertight(triangles)
        a, b, c = np.moveaxis(skin.points[triangles], 1, 0)
        assert np.linalg.norm(np.cross(b - a, c - a), axis=1).min() > 1e-9 * ALL[name].lattice.area
        used, times = np.unique(skin.points, axis=0, return_counts=True)
        assert times.max() == 1
        assert len(np.unique(triangles)) == len(used)

    def test_it_encloses_the_body_within_its_chord(self, name, size):
        exact, cells = volume(ALL[name], math.prod(size)), math.prod(size)
        skin = surface(Part.piece(ALL[name], *size))
        pillar = ALL[name].pillar
        curved = 0.0
        if pillar is not None:
            girth = 2 * math.pi if pillar.section == "round" else 8.0
            curved = girth * pillar.widest * (pillar.height + pillar.fillet) * cells
        assert (
            abs(enclosed(skin.points, skin.cells_dict["triangle"]) - exact) <= CHORD * curved + 1e-9 * exact
        )

    def test_the_plates_top_is_covered_once(self, name, size):
        the_cell, cells = ALL[name], math.prod(size)
        skin = surface(Part.piece(the_cell, *size))
        a, b, c = np.moveaxis(skin.points[skin.cells_dict["triangle"]], 1, 0)
        on_top = (np.abs(np.stack([a, b, c])[..., 2] - the_cell.thickness) < 1e-12).all(axis=0)
        areas = 0.5 * np.cross(b - a, c - a)[on_top, 2]
        assert (areas > 0).all()
        foot = 0.0
        if the_cell.pillar is not None:
            reach = the_cell.pillar.arc.centre[0] if the_cell.pillar.arc else the_cell.pillar.radius
            foot = (math.pi if the_cell.pillar.section == "round" else 4.0) * reach**2
        # a polygon covers less than its circle, at most by a chord all around
        left_over = areas.sum() - cells * (the_cell.lattice.area - foot)
        assert -1e-12 < left_over <= cells * 2 * math.pi * 10 * MM * CHORD


def test_a_finer_chord_brings_the_volume_closer_in_proportion():
    round_cell = ALL["reference"]
    skins = [surface(Part.piece(round_cell), chord=chord) for chord in (16e-6, 1e-6)]
    errors = [abs(enclosed(s.points, s.cells_dict["triangle"]) - volume(round_cell)) for s in skins]
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.2)


def test_the_stl_file_is_the_surface_in_mm_and_agrees_with_the_step_file(tmp_path):
    body = cell(Pillar(3.5 * MM, 9 * MM, fillet=0.5 * MM, draft=0.03, step=Step(2 * MM, 5 * MM)))
    step = volume_of_step(write_step(tmp_path / "plate.step", Part.piece(body, 2, 3)))
    mesh = meshio.read(write_stl(tmp_path / "plate.stl", Part.piece(body, 2, 3), chord=0.5e-6))
    points, triangles = mesh.points.astype(float), mesh.cells_dict["triangle"]
    assert np.ptp(points, axis=0) == pytest.approx([14, 21, 10.5], rel=1e-6)
    welded, number = np.unique(points, axis=0, return_inverse=True)
    triangles = number.ravel()[triangles]
    assert is_watertight(triangles)  # also after rounding to single precision
    assert enclosed(welded, triangles) * MM**3 == pytest.approx(step, rel=2e-4)


def test_a_hole_or_a_turned_triangle_is_noticed():
    triangles = surface(Part.piece(ALL["reference"])).cells_dict["triangle"]
    turned = triangles.copy()
    turned[0] = turned[0, ::-1]
    assert not is_watertight(triangles[1:])
    assert not is_watertight(turned)


@pytest.mark.parametrize("chord", [0.0, -1e-6, math.nan, 1e-3])
def test_a_useless_chord_is_refused(chord):
    with refusing(GeometryError, "out-of-range", "chord"):
        surface(Part.piece(ALL["reference"]), chord=chord)


class TestDxf:
    def read(self, tmp_path, *arguments):
        document = ezdxf.readfile(write_dxf(tmp_path / "plate.dxf", Part.piece(*arguments)))
        assert not document.audit().has_errors
        return document

    def test_round_pillars_are_circles_about_the_cells_centres_in_mm(self, tmp_path):
        pillar = Pillar(3.5 * MM, 9 * MM, fillet=0.5 * MM, step=Step(2 * MM, 5 * MM))
        document = self.read(tmp_path, cell(pillar, RECTANGLE), 2, 3)
        assert document.header["$INSUNITS"] == 4
        space = document.modelspace()
        centres = {(x, y) for x in (-3.5, 3.5) for y in (-9, 0, 9)}
        for layer, radius in {"PILLAR": 1.75, "FILLET": 2.25, "STEP": 1.0}.items():
            circles = space.query(f'CIRCLE[layer=="{layer}"]')
            assert {round(circle.dxf.radius, 9) for circle in circles} == {radius}
            assert len(circles) == 6
            assert {(round(c.dxf.center.x, 9), round(c.dxf.center.y, 9)) for c in circles} == centres
        assert len(space.query('LINE[layer=="CENTRE"]')) == 12
        assert len(space.query('LWPOLYLINE[layer=="CELL"]')) == 3 + 4
        (plate,) = space.query('LWPOLYLINE[layer=="PLATE"]')
        assert plate.closed
        corners = {tuple(np.round(point, 9)) for point in plate.get_points("xy")}
        assert corners == {(x, y) for x in (-7, 7) for y in (-13.5, 13.5)}

    def test_square_pillars_are_closed_squares(self, tmp_path):
        pillar = Pillar(3 * MM, 9 * MM, "square", fillet=0.5 * MM)
        space = self.read(tmp_path, cell(pillar)).modelspace()
        for layer, half in {"PILLAR": 1.5, "FILLET": 2.0}.items():
            (outline,) = space.query(f'LWPOLYLINE[layer=="{layer}"]')
            assert outline.closed
            points = np.array(outline.get_points("xy"))
            assert np.abs(points) == pytest.approx(half)
            assert len(np.unique(points, axis=0)) == 4

    def test_only_layers_with_content_are_there(self, tmp_path):
        names = {layer.dxf.name for layer in self.read(tmp_path, ALL["no pillar"]).layers}
        assert names - {"0", "Defpoints"} == {"PLATE", "CELL"}


@pytest.mark.parametrize("kind", WRITERS)
class TestEveryWriter:
    def test_the_same_plate_is_the_same_file(self, kind, tmp_path):
        body = ALL["reference"]
        first, second = (WRITERS[kind](tmp_path / f"{name}.{kind}", Part.piece(body, 2, 1)) for name in "ab")
        assert first.read_bytes() == second.read_bytes()
        if kind == "step":
            assert "'1970-01-01T00:00:00'" in first.read_text()

    def test_a_file_is_not_replaced_unasked(self, kind, tmp_path):
        path = tmp_path / f"plate.{kind}"
        path.write_text("mine")
        with refusing(ResourceError, "repeated", "output file"):
            WRITERS[kind](path, Part.piece(ALL["reference"]))
        assert path.read_text() == "mine"
        WRITERS[kind](path, Part.piece(ALL["reference"]), overwrite=True)
        assert path.stat().st_size > 1000
        assert [p.name for p in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize(
    ("size", "argument"),
    [((0, 1), "columns"), ((1, -2), "rows"), ((2.0, 1), "columns"), ((True, 1), "columns")],
    ids=str,
)
def test_a_number_of_cells_is_a_positive_integer(size, argument):
    with refusing(GeometryError, "out-of-range", argument):
        Part.piece(ALL["reference"], *size)


def test_the_error_for_a_missing_extra_names_the_package(monkeypatch, tmp_path):
    real = builtins.__import__

    def without_netgen(name, *rest):
        if name.split(".")[0] == "netgen":
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without_netgen)
    with pytest.raises(ResourceError) as caught:
        write_step(tmp_path / "plate.step", Part.piece(ALL["reference"]))
    assert 'pip install "haptonic[cad]"' in caught.value.next_step
    assert all(caught.value.parts().values())
    write_stl(tmp_path / "plate.stl", Part.piece(ALL["reference"]))  # needs no extra
