"""Files of pillars of other outlines: solids and surfaces with their volume, DXF curves with their area."""

from dataclasses import replace

import ezdxf
import numpy as np
import pytest
from ezdxf.path import make_path
from family import MM, RECTANGLE, cell, enclosed, is_watertight

from haptonic.cell import Pillar, Step
from haptonic.cell.pillar_parts import Corner
from haptonic.workshop import Part, part_drawing, surface, volume_of_step, write_dxf, write_step

pytest.importorskip("netgen.occ", reason="the extra cad is not installed")

SKEW = tuple(Corner(x=x, y=y) for x, y in ((1, -0.8), (0.9, 1), (-1.1, 0.7), (-0.7, -1)))
PILLARS = {
    "ellipse": Pillar(3 * MM, 6 * MM, "ellipse", length=2 * MM, turn=0.4),
    "rounded rectangle with a step": Pillar(
        3 * MM, 6 * MM, "rectangle", length=2 * MM, corner_radius=0.3 * MM, step=Step(2 * MM, 4 * MM)
    ),
    "stadium": Pillar(2 * MM, 6 * MM, "rectangle", length=3 * MM, corner_radius=1 * MM, turn=0.2),
    "triangle with draft and fillet": Pillar(2 * MM, 6 * MM, "polygon", sides=3, draft=0.02, fillet=0.2 * MM),
    "points": Pillar(3 * MM, 6 * MM, "points", point=SKEW),
    "turned square with a fillet": Pillar(3 * MM, 6 * MM, "square", turn=0.3, fillet=0.3 * MM),
}


@pytest.mark.parametrize("faces", ["one", "both"])
@pytest.mark.parametrize("pillar", PILLARS.values(), ids=PILLARS)
def test_files_contain_the_outline(pillar, faces, tmp_path):
    body = replace(cell(pillar, RECTANGLE), faces=faces)
    part, exact = Part.piece(body), body.lattice.area * body.thickness + body.copies * pillar.volume
    path = write_step(tmp_path / "a.step", part)
    assert volume_of_step(path) == pytest.approx(exact, rel=1e-6)
    skin = surface(part, chord=1e-6)
    assert is_watertight(skin.cells_dict["triangle"])
    assert enclosed(skin.points, skin.cells_dict["triangle"]) == pytest.approx(exact, rel=5e-4)
    if faces == "both":
        assert is_its_own_image(path, body.thickness / MM)


def is_its_own_image(path, thickness):
    """True if what a solid has in common with its image in the middle plane is all of it."""
    from netgen import occ

    shape = occ.OCCGeometry(str(path)).shape
    image = shape.Mirror(occ.Axes((0, 0, 0.5 * thickness), occ.Z))
    return (shape * image).mass == pytest.approx(shape.mass, rel=1e-6)


@pytest.mark.parametrize("pillar", PILLARS.values(), ids=PILLARS)
def test_outlines_seen_from_above_have_their_area(pillar, tmp_path):
    space = ezdxf.readfile(write_dxf(tmp_path / "a.dxf", Part.piece(cell(pillar, RECTANGLE)))).modelspace()
    (curve,) = [entity for entity in space if entity.dxf.layer == "PILLAR"]
    points = np.array([(v.x, v.y) for v in make_path(curve).flattening(1e-4)])
    x, y = points.T
    area = 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    assert area == pytest.approx(pillar.outline.area * (pillar.radius / MM) ** 2, rel=1e-3)


NUMBERS = {
    "ellipse": "ellipse, width 3, height 6, length 2, turn 22.918°",
    "rounded rectangle with a step": "rectangle, width 3, height 6, length 2, corner radius 0.3",
    "stadium": "rectangle, width 2, height 6, length 3, corner radius 1, turn 11.459°",
    "triangle with draft and fillet": "polygon of 3 sides, width 2, height 6, fillet 0.2, draft 1.146°",
    "points": "corners x, y: 1.5, -1.2; 1.35, 1.5; -1.65, 1.05; -1.05, -1.5",
    "turned square with a fillet": "square, □3, height 6, turn 17.189°, fillet 0.3",
}


@pytest.mark.parametrize("name", PILLARS)
def test_the_list_of_a_drawing_has_every_number_of_a_section(name):
    sheet = part_drawing(Part.piece(cell(PILLARS[name], RECTANGLE)), "Plate")
    lists = [line for text in sheet.space.query("MTEXT") for line in text.plain_text(split=True)]
    assert any(NUMBERS[name] in line for line in lists), lists
