"""A whole plate as files for the workshop: every file against the map, by roads of its own."""

import math

import ezdxf
import numpy as np
import pytest
from family import LATTICES, METAL, MM, OWN, PATCH, PLATES, RECTANGLE, cell, enclosed, is_watertight, plate
from hypothesis import assume, example, given, settings, strategies as st

from five_parts import refusing
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.plate.layout.grid import Layout, pieces
from haptonic.workshop import Part, surface, volume_of_step, write_dxf, write_step
from haptonic.workshop.part import MOST_PILLARS

CHORD = 20e-6


class Shifted(Layout):
    """Pillars across the sides of tiles, as other lattices may have them."""

    @property
    def features(self):
        pillar = LATTICES["slim"].pillar
        rows = [((3.5 + 3.5 * (k % 2), 4.0 + 6.0 * k), 7 - k % 2) for k in range(5)]
        return tuple(((x + 7 * i) * MM, y * MM, pillar) for (x, y), n in rows for i in range(n))


@st.composite
def maps(draw):
    """Maps that hang together by sides, with holes and cut corners."""
    columns, rows = draw(st.integers(1, 6)), draw(st.integers(1, 5))
    lines = [draw(st.text("oostt11..", min_size=columns, max_size=columns)) for _ in range(rows)]
    there = np.array([[letter != "." for letter in line] for line in lines])
    assume(there.any() and len(pieces(there.tolist())) == 1)
    return lines


def crossed(lines):
    there = np.array([[letter != "." for letter in line] for line in lines])
    a, b, c, d = there[:-1, :-1], there[:-1, 1:], there[1:, :-1], there[1:, 1:]
    return bool(((a == d) & (b == c) & (a != b)).any())


def volume_of(layout):
    """From the map, m^3."""
    tiles = {name for row in layout.tiles for name in row if name}
    area = sum(layout.area(name) for name in tiles)
    return area * layout.thickness + sum(pillar.volume for _, _, pillar in layout.standing)


def reach(layout):
    """Area of curved surfaces, at least, m^2."""
    return sum(2 * math.pi * p.widest * (p.height + p.fillet) for _, _, p in layout.standing)


def check_surface(part, layout):
    skin = surface(part, chord=CHORD)
    triangles = skin.cells_dict["triangle"]
    assert is_watertight(triangles)
    exact = volume_of(layout)
    lost = abs(enclosed(skin.points, triangles) - exact)
    assert lost <= CHORD * reach(layout) + 1e-9 * exact
    a, b, c = np.moveaxis(skin.points[triangles], 1, 0)
    normals = np.cross(b - a, c - a)
    assert np.linalg.norm(normals, axis=1).min() > 1e-12 * np.ptp(skin.points, axis=0)[:2].max() ** 2
    flat = np.isclose(skin.points[triangles][..., 2], 0).all(axis=1)
    area = -0.5 * normals[flat, 2]
    assert (area > 0).all()
    assert area.sum() == pytest.approx(sum(layout.area(n) for n in {t for r in layout.tiles for t in r if t}))


@settings(max_examples=25, deadline=None)
@given(maps())
@example(["11.", "1.1", "111"])
@example(["oo..oo", "o.11.o", "oo..oo", "oooooo"])
def test_every_map_is_a_watertight_surface_of_its_volume_or_is_refused(lines):
    mounted = plate(" ".join(lines))
    if crossed(lines):
        with refusing(GeometryError, "unsupported", "plate.map"):
            Part.whole(mounted, OWN)
        return
    part = Part.whole(mounted, OWN)
    assert part.volume == pytest.approx(volume_of(mounted.layout) / MM**3, rel=1e-9)
    check_surface(part, mounted.layout)


def test_columns_of_a_piece_lie_along_x_whichever_translation_is_the_shorter():
    oblique = Lattice(a1=(7 * MM, 0.0), a2=(3 * MM, 6 * MM))
    assert oblique.a1 == pytest.approx((3 * MM, 6 * MM))
    part = Part.piece(UnitCell(oblique, 1 * MM, METAL, Pillar(3 * MM, 4 * MM)), 3, 2)
    assert np.ptp(part.outline[0], axis=0) == pytest.approx([3 * 7 + 2 * 3, 2 * 6])


@pytest.mark.parametrize("name", PLATES)
def test_the_step_file_is_one_solid_of_the_maps_volume_and_size(name, tmp_path):
    occ = pytest.importorskip("netgen.occ", reason="the extra cad is not installed")
    layout = PLATES[name].layout
    path = write_step(tmp_path / "plate.step", Part.whole(PLATES[name], OWN))
    assert volume_of_step(path) == pytest.approx(volume_of(layout), rel=1e-6)
    shape = occ.OCCGeometry(str(path)).shape
    assert len(shape.solids) == 1
    low, high = (np.array(list(corner)) for corner in shape.bounding_box)
    tallest = max((pillar.height for _, _, pillar in layout.standing), default=0.0)
    assert low == pytest.approx([0, 0, 0], abs=1e-5)
    wanted = np.array([layout.x[-1], layout.y[-1], layout.thickness + tallest])
    assert high == pytest.approx(wanted / MM, abs=1e-5)


@pytest.mark.parametrize("name", PLATES)
def test_the_dxf_file_has_every_pillar_at_its_position_and_marks_patches(name, tmp_path):
    mounted = PLATES[name]
    document = ezdxf.readfile(write_dxf(tmp_path / "plate.dxf", Part.whole(mounted, OWN)))
    assert not document.audit().has_errors
    space = document.modelspace()
    circles = {
        (round(c.dxf.center.x, 6), round(c.dxf.center.y, 6), round(c.dxf.radius, 6))
        for c in space.query('CIRCLE[layer=="PILLAR"]')
    }
    squares = [np.array(line.get_points("xy")) for line in space.query('LWPOLYLINE[layer=="PILLAR"]')]
    drawn = circles | {
        (*np.round(p.mean(axis=0), 6).tolist(), round(np.ptp(p[:, 0]) / 2, 6)) for p in squares
    }
    wanted = {
        (round(x / MM, 6), round(y / MM, 6), round(pillar.radius / MM, 6))
        for x, y, pillar in mounted.layout.standing
    }
    assert drawn == wanted
    assert len(circles) + len(squares) == mounted.layout.pillars
    assert len(space.query('LINE[layer=="CENTRE"]')) == 2 * mounted.layout.pillars
    patches = [np.array(line.get_points("xy")) for line in space.query('LWPOLYLINE[layer=="PATCH"]')]
    assert [p.mean(axis=0).tolist() for p in patches] == [pytest.approx([24.5, 4])] * len(mounted.actuators)
    assert all(np.ptp(p, axis=0) == pytest.approx([6, 5]) for p in patches)
    named = {"touchpad": 2, "hole and cut corner": 2, "plain": 1, "long": 0}  # the hole parts its region
    assert len(space.query('LWPOLYLINE[layer=="REGION"]')) == named[name]


def test_holes_turn_the_other_way_and_corners_only_are_kept():
    edge, hole = Part.whole(PLATES["hole and cut corner"], OWN).outline
    assert edge == pytest.approx(np.array([[0, 0], [49, 0], [49, 27], [42, 27], [42, 36], [0, 36]]))
    assert sorted(hole.round(9).tolist()) == [[14, 9], [14, 18], [28, 9], [28, 18]]
    (ax, ay), (bx, by) = hole[1] - hole[0], hole[2] - hole[1]
    assert ax * by - ay * bx < 0


def test_pillars_may_lie_across_the_sides_of_tiles(tmp_path):
    """Only `Layout.features` gives their places."""
    mounted = plate("1111111 1111111 1111111 1111111", kind=Shifted)
    part = Part.whole(mounted, OWN)
    check_surface(part, mounted.layout)
    pytest.importorskip("netgen.occ", reason="the extra cad is not installed")
    path = write_step(tmp_path / "plate.step", part)
    assert volume_of_step(path) == pytest.approx(volume_of(mounted.layout), rel=1e-6)


@pytest.mark.parametrize("lattice", [Lattice.triangular(7 * MM), Lattice.oblique(7 * MM, 8 * MM, 1.2)])
def test_a_piece_of_any_lattice_is_a_watertight_surface(lattice):
    body = UnitCell(lattice, 1.5 * MM, METAL, Pillar(2.5 * MM, 9 * MM, fillet=0.2 * MM))
    part = Part.piece(body, 3, 2)
    skin = surface(part)
    assert is_watertight(skin.cells_dict["triangle"])
    exact = 6 * (lattice.area * body.thickness + len(body.shares) * body.pillar.volume)
    assert part.volume * MM**3 == pytest.approx(exact, rel=1e-9)
    assert enclosed(skin.points, skin.cells_dict["triangle"]) == pytest.approx(exact, rel=5e-3)


def test_square_feet_that_nearly_touch_across_a_step_are_cut_until_they_fit():
    close = Pillar(6.8 * MM, 3 * MM, "square")
    wide = cell(close, Lattice.square(7 * MM))

    class Stepped(Layout):
        @property
        def features(self):
            return tuple(((3.5 + 7 * i) * MM, (3.6 + 7 * j + 3.4 * (i % 2)) * MM, close)
                         for i in range(4) for j in range(3))  # fmt: skip

    mounted = plate("1111 1111 1111", kind=Stepped)
    check_surface(Part.whole(mounted, wide), mounted.layout)


def test_too_many_pillars_are_refused_at_once():
    with refusing(GeometryError, "too-large", "export", f"at most {MOST_PILLARS}"):
        Part.piece(cell(OWN.pillar, RECTANGLE), 10**6, 10**6)
    with refusing(GeometryError, "too-large", "export"):
        Part.whole(plate(" ".join(["o" * 40] * 40)), OWN)
    assert PATCH in PLATES["touchpad"].actuators
