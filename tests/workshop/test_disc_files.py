"""Solids of cells with discs and of pillars of another material: exact volumes by two routes."""

import math
from dataclasses import replace

import ezdxf
import numpy as np
import pytest
from family import METAL, MM, SQUARE, cell, enclosed, is_watertight

from daily import daily
from haptonic.cell import Disc, Pillar, Site, UnitCell
from haptonic.cell.tile import enclosed as area_of
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.workshop import (
    Part,
    part_drawing,
    surface,
    volume_of_step,
    write_drawing,
    write_dxf,
    write_step,
)
from haptonic.workshop.section import ANGLES
from stacks import DRAFTED, EPOXY, STACKS, STEEL, cone, drafted_volumes

pytest.importorskip("netgen.occ", reason="the extra cad is not installed")

PLATE, ROUND = 7 * 7 * 1.5, math.pi / 4  # mm^3, and the area of a disc of 1 mm
EXACT = {
    "hole": {"metal": PLATE - ROUND * 16 * 1.5},
    "blind hole": {"metal": PLATE - ROUND * 16 * 0.7},
    "inclusion": {"metal": PLATE - ROUND * 16 * 1.5, "steel": ROUND * 16 * 1.5},
    "coated inclusion": {
        "metal": PLATE - ROUND * 25 * 1.5, "epoxy": ROUND * 9 * 1.5, "steel": ROUND * 16 * 1.5,
    },
    "pillar on glue": {"metal": PLATE, "epoxy": ROUND * 9 * 0.5, "steel": ROUND * 9 * 3.5},
    "cap": {"metal": PLATE + ROUND * (2.5**2 * 3 + 4.5**2)},
    "hollow pillar": {"metal": PLATE + ROUND * (16 - 2.5**2) * 4},
}  # fmt: skip


def squared(stack):
    return tuple(replace(disc, section="square") for disc in stack)


def solids_of(path):
    from netgen.occ import OCCGeometry

    volumes = {}
    for solid in OCCGeometry(str(path)).shape.solids:
        volumes[solid.name] = volumes.get(solid.name, 0.0) + solid.mass
    return volumes


def check_files(part, exact, tmp_path, polygon=1e-6):
    """Volumes (mm^3) of each material in the part, in the STEP file and within the surface."""
    by_name = {solid.name: solid for solid in part.materials}
    assert set(by_name) == set(exact)
    volumes = solids_of(write_step(tmp_path / "a.step", part))
    for name, volume in exact.items():
        assert part.volume_of(by_name[name]) == pytest.approx(volume, rel=1e-9)
        assert volumes[name] == pytest.approx(volume, rel=1e-6)
        skin = surface(part, chord=1e-6, material=by_name[name])
        assert is_watertight(skin.cells_dict["triangle"])
        inside = enclosed(skin.points, skin.cells_dict["triangle"]) / MM**3
        assert inside == pytest.approx(volume, rel=polygon)


@pytest.mark.parametrize("name", STACKS)
def test_solids_of_discs_have_the_exact_volume_of_each_material(name, tmp_path):
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=STACKS[name]))
    check_files(part, EXACT[name], tmp_path, polygon=2e-3)


@pytest.mark.parametrize("name", daily(DRAFTED, "countersunk hole", "cap on a cone"))
def test_cones_have_the_exact_volume_of_each_material(name, tmp_path):
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=DRAFTED[name]))
    check_files(part, drafted_volumes(49)[name], tmp_path, polygon=2e-3)


def test_square_cones_have_it_to_rounding(tmp_path):
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=squared(DRAFTED["countersunk hole"])), 2, 1)
    hole = 9 * 0.9 + cone(3, -math.pi / 4, 0.6, 1 / 3)[0]
    check_files(part, {"metal": 2 * (PLATE - hole)}, tmp_path)


@pytest.mark.parametrize("name", STACKS)
def test_surfaces_of_square_discs_enclose_the_volume_to_rounding(name, tmp_path):
    square = {
        solid: (PLATE if solid == "metal" else 0) + (volume - (PLATE if solid == "metal" else 0)) / ROUND
        for solid, volume in EXACT[name].items()
    }
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=squared(STACKS[name])), 2, 1)
    check_files(part, {solid: 2 * volume for solid, volume in square.items()}, tmp_path)


def test_discs_on_both_faces_have_their_image_below(tmp_path):
    discs = (
        Disc(4 * MM, low=-0.5 * MM, empty=True),
        Disc(3 * MM, low=-0.5 * MM, high=2 * MM, material=STEEL),
    )
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=discs, faces="both"))
    exact = {"metal": PLATE - 2 * ROUND * 16 * 0.5, "steel": 2 * ROUND * 9 * 2.5}
    check_files(part, exact, tmp_path, polygon=2e-3)
    heights = surface(part, material=STEEL).points[:, 2] / MM
    assert (heights.min(), heights.max()) == pytest.approx((-2, 3.5))


@pytest.mark.parametrize("faces", ["one", "both"])
def test_a_pillar_of_another_material_is_a_body_of_its_own(faces, tmp_path):
    body = replace(cell(Pillar(3 * MM, 6 * MM, "square", material=EPOXY)), faces=faces)
    check_files(Part.piece(body, 2, 2), {"metal": 4 * PLATE, "epoxy": 4 * 54 * body.copies}, tmp_path)


def test_a_pillar_and_a_hole_are_side_by_side_on_a_honeycomb(tmp_path):
    lattice = Lattice(lattice="honeycomb", pitch=12 * MM)
    sites = (Site(pillar=Pillar(3 * MM, 5 * MM, "square")), Site(disc=squared(STACKS["hole"])))
    body = UnitCell(lattice, 1.5 * MM, METAL, site=sites)
    exact = 6 * (lattice.area / MM**2 * 1.5 + 9 * 5 - 16 * 1.5)
    check_files(Part.piece(body, 3, 2), {"metal": exact}, tmp_path)
    assert np.isfinite(volume_of_step(tmp_path / "a.step"))


CUT = {  # mm^2, of each material in a section 14 mm long through two stacks
    "hole": {"metal": 14 * 1.5 - 2 * 4 * 1.5},
    "blind hole": {"metal": 14 * 1.5 - 2 * 4 * 0.7},
    "inclusion": {"metal": 14 * 1.5 - 2 * 4 * 1.5, "steel": 2 * 4 * 1.5},
    "coated inclusion": {"metal": 14 * 1.5 - 2 * 5 * 1.5, "epoxy": 2 * 1.5, "steel": 2 * 4 * 1.5},
    "pillar on glue": {"metal": 14 * 1.5, "epoxy": 2 * 3 * 0.5, "steel": 2 * 3 * 3.5},
    "cap": {"metal": 14 * 1.5 + 2 * (2.5 * 3 + 4.5)},
    "hollow pillar": {"metal": 14 * 1.5 + 2 * (4 - 2.5) * 4},
}


def test_the_hatches_of_six_materials_differ(tmp_path):
    names = ("steel", "epoxy", "brass", "silicon", "pmma")
    discs = tuple(Disc((6 - i) * MM, material=material(name)) for i, name in enumerate(names))
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=discs), 3, 2)
    space = ezdxf.readfile(write_drawing(tmp_path / "a.dxf", part_drawing(part, "Discs"))).modelspace()
    patterns = {(hatch.dxf.pattern_angle, hatch.dxf.pattern_scale) for hatch in space.query("HATCH")}
    assert len(patterns) == len(names) + 1


CUT |= {
    "countersunk hole": {"metal": 14 * 1.5 - 2 * (3 * 1.5 + 0.6**2)},
    "chamfered pillar": {"metal": 14 * 1.5 + 2 * (3 * 4 - 0.5**2)},
    "cap on a cone": {"metal": 14 * 1.5 + 2 * (2 * 2 + 3 * 1 + 4 * 0.6 + 3.6 * 0.4)},
}
CIRCLES = {"countersunk hole": [3.0, 4.2], "chamfered pillar": [2.0, 3.0], "cap on a cone": [2.0, 3.2, 4.0]}


@pytest.mark.parametrize("name", CUT)
def test_the_section_shows_each_material_and_the_outlines_have_their_layers(name, tmp_path):
    part = Part.piece(UnitCell(SQUARE, 1.5 * MM, METAL, disc=(STACKS | DRAFTED)[name]), 3, 2)
    path = write_drawing(tmp_path / "a.dxf", part_drawing(part, "Discs"))
    space = ezdxf.readfile(path).modelspace()
    areas = dict.fromkeys([solid.name for solid in part.materials], 0.0)
    for hatch in space.query("HATCH"):
        solid = part.materials[ANGLES.index(hatch.dxf.pattern_angle)]
        areas[solid.name] += abs(area_of(np.array(list(hatch.paths[0].vertices))[:, :2]))
    assert areas == pytest.approx(CUT[name])
    outlines = ezdxf.readfile(write_dxf(tmp_path / "b.dxf", part)).modelspace()
    circles = {
        layer: sorted({2 * circle.dxf.radius for circle in outlines.query(f'CIRCLE[layer=="{layer}"]')})
        for layer in ("HOLE", "DISC")
    }
    widths = CIRCLES.get(name) or sorted({1e3 * disc.diameter for disc in STACKS[name]})
    holes = widths if "hole" in name else []
    assert circles == {"HOLE": pytest.approx(holes), "DISC": pytest.approx([] if holes else widths)}
    assert len(outlines.query("CIRCLE")) == 6 * len(widths)
