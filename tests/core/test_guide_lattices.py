"""Guides between rows of any lattice: faces that are no straight lines, other bases, ribbons."""

from functools import cache

import numpy as np
import pytest

from five_parts import refusing
from haptonic.bloch import Resolution
from haptonic.bloch.guide import Guide, strip_mode
from haptonic.bloch.ribbon import RibbonModel
from haptonic.bloch.ribbon_modes import within
from haptonic.bloch.rows import CondensedRows
from haptonic.cell import Pillar, Ribbon, Rows, Site, UnitCell, rows as rows_of_cells
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material

MM, KILOHERTZ = 1e-3, 2e3 * np.pi
ALUMINIUM = IsotropicMaterial(youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, name="aluminium")
PILLAR, COARSE = Pillar(3.5 * MM, 9 * MM), Resolution(2, 0)
PITCH, ALONG = 7 * MM, 380.0
TRIANGULAR = UnitCell(Lattice.triangular(PITCH), 1.5 * MM, ALUMINIUM, PILLAR)
AS_RECTANGLE = UnitCell(
    Lattice.rectangular(PITCH, np.sqrt(3) * PITCH),
    1.5 * MM,
    ALUMINIUM,
    site=tuple(Site(at=at, pillar=PILLAR) for at in ((0, 0), (0.5, 0.5))),
)
HONEYCOMB = UnitCell(
    Lattice(lattice="honeycomb", pitch=8 * MM), 1.5 * MM, ALUMINIUM, Pillar(2.5 * MM, 6 * MM)
)


@cache
def rows(cell, along=(1, 0)):
    return CondensedRows.of(cell, COARSE, along)


def test_a_guide_is_the_same_in_two_bases():
    """A triangular lattice, and rectangles of two sites."""
    modes = [Guide.of(rows(cell), ALONG).mode_at(70 * KILOHERTZ, 0) for cell in (TRIANGULAR, AS_RECTANGLE)]
    assert modes[0].width == pytest.approx(modes[1].width, rel=1e-6)
    assert modes[0].at_edge == pytest.approx(modes[1].at_edge, rel=1e-4)
    assert modes[0].position[-1] == pytest.approx(0.5 * modes[0].width - rows(TRIANGULAR).setback)


def test_what_leads_to_a_straight_line_changes_no_width(monkeypatch):
    """Its own width is arbitrary; widths count from where the zigzag of the hexagons lies on average."""
    near = Guide.of(rows(TRIANGULAR), ALONG)
    monkeypatch.setattr(rows_of_cells, "MARGIN", 0.3)
    other = CondensedRows.of(TRIANGULAR, COARSE, (1, 0))
    assert rows(TRIANGULAR).setback - other.setback == pytest.approx(0.2 * PITCH / 2)
    far = Guide.of(other, ALONG)
    assert far.width(72 * KILOHERTZ, 1) == pytest.approx(near.width(72 * KILOHERTZ, 1), rel=1e-3)
    edges = [guide.mode_at(72 * KILOHERTZ, 1).at_edge for guide in (near, far)]
    assert edges[0] == pytest.approx(edges[1], rel=5e-3)
    walls = [guide.walls(72 * KILOHERTZ)[0] for guide in (near, far)]
    assert walls[0].fixed_line == pytest.approx(walls[1].fixed_line, abs=0.01 * MM)


def test_a_strip_narrower_than_what_leads_to_the_line_is_refused():
    with refusing(StudyError, "out-of-range", "waveguide.width"):
        strip_mode(
            rows(TRIANGULAR), width=5 * MM, length=0.1, intervals=12, nodal_lines=0,
            between=(68 * KILOHERTZ, 78 * KILOHERTZ),
        )  # fmt: skip


@pytest.mark.parametrize(("lattice", "along", "crossing"), [
    (Lattice.square(7 * MM), (0, 1), (1, 0)),
    (Lattice.square(7 * MM), (1, 1), (1, -1)),
    (Lattice.triangular(7 * MM), (0, 1), (2, -1)),
    (Lattice.triangular(7 * MM), (1, 1), (1, -1)),
    (Lattice.rectangular(7 * MM, 9 * MM), (1, 0), (0, 1)),
    (Lattice.rectangular(7 * MM, 7 * np.pi * MM), (1, 1), None),
    (Lattice.oblique(7 * MM, 8 * MM, 1.2), (0, 1), None),
])  # fmt: skip
def test_rows_at_a_right_angle(lattice, along, crossing):
    perpendicular = Rows(UnitCell(lattice, 1 * MM, ALUMINIUM), along).crossing
    assert perpendicular in (crossing, crossing and tuple(-step for step in crossing))


STEEL_TRIANGLES = UnitCell(
    Lattice.square(10 * MM), 2 * MM, ALUMINIUM,
    Pillar(4 * MM, 5 * MM, "polygon", sides=3, material=material("steel")),
)  # fmt: skip


@pytest.mark.parametrize("nodal_lines", [0, pytest.param(1, marks=pytest.mark.nightly)])
def test_the_width_between_unequal_sides_is_that_of_a_ribbon(nodal_lines):
    """Triangles turn a tip to the strip on one side and a base on the other, in equal crystals."""
    along, omega = (9 * np.pi / 16, 54.5 * KILOHERTZ)
    mesh = Resolution(3, 1)
    right, left = (CondensedRows.of(STEEL_TRIANGLES, mesh, direction) for direction in ((0, 1), (0, -1)))
    assert not right.rows.is_reversible(right.rows.turn[0])
    guides = [Guide.of(*sides) for sides in (
        (right, along / (10 * MM)), (left, along / (10 * MM)), (right, along / (10 * MM), left)
    )]  # fmt: skip
    modes = [guide.mode_at(omega, nodal_lines) for guide in guides]
    widths = [mode.width for mode in modes]
    assert abs(widths[0] - widths[1]) > 0.08 * widths[2] / (1 + nodal_lines)
    assert widths[2] == pytest.approx(np.mean(widths[:2]), rel=1e-12)
    plain = UnitCell(Lattice.rectangular(widths[2], 10 * MM), 2 * MM, ALUMINIUM)
    ribbon = Ribbon((STEEL_TRIANGLES,) * 3 + (plain,) + (STEEL_TRIANGLES,) * 3)
    waves = RibbonModel.of(ribbon, mesh).solve(along, 53e3, 56e3)
    share = within(waves.energy, ribbon.guide)
    assert waves.frequency[share.argmax()] == pytest.approx(54.5e3, rel=2e-3)
    # of this width, the mode lies at the same frequency, and about the same point
    between = 53.5 * KILOHERTZ, 55.5 * KILOHERTZ
    again = guides[2].mode(widths[2], nodal_lines, between)
    assert again.omega == pytest.approx(omega, rel=1e-4)
    assert again.shift == pytest.approx(0.25 * (widths[1] - widths[0]), rel=1e-2)
    mode = modes[2]
    assert mode.position[[0, -1]] == pytest.approx([-0.5 * widths[2], 0.5 * widths[2]], rel=1e-9)
    assert (np.diff(mode.position) > 0).all()
    assert mode.amplitude.max() == pytest.approx(1.0)


@pytest.mark.nightly
@pytest.mark.parametrize(("cell", "columns", "along", "between"), [
    (TRIANGULAR, 4, 380.0, (66.5, 79.0)),
    (TRIANGULAR, 5, 400.0, (66.5, 79.0)),
    (HONEYCOMB, 4, 370.0, (50.0, 54.0)),
    (HONEYCOMB, 5, 370.0, (50.0, 60.0)),
])  # fmt: skip
def test_modes_of_ribbons_are_those_of_guides(cell, columns, along, between):
    """As wide as their plain columns, between half-infinite rows in place of five."""
    beside = rows(cell, (0, 1))
    ribbon = Ribbon((cell,) * 5 + (cell.without_pillar(),) * columns + (cell,) * 5)
    low, high = (kilohertz * 1e3 for kilohertz in between)
    modes = RibbonModel.of(ribbon, COARSE).solve(along * beside.rows.period, low, high)
    share = (modes.energy * ribbon.guide).sum(axis=(1, 2)) / modes.energy.sum(axis=(1, 2))
    held = modes.frequency[share > 0.5]
    width = columns * abs(float(beside.rows.step @ beside.rows.turn[0]))
    frequencies = []
    for nodal_lines in range(3):
        try:
            mode = Guide.of(beside, along).mode(width, nodal_lines, (low * 2 * np.pi, high * 2 * np.pi))
        except StudyError:
            continue
        frequencies.append(mode.omega / (2 * np.pi))
    assert len(held) == len(frequencies) > 0
    assert np.sort(frequencies) == pytest.approx(held, rel=4e-3)
