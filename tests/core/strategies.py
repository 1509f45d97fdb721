"""Random cells over the design range, extreme ones included."""

import numpy as np
from hypothesis import strategies as st

from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

ALUMINIUM = IsotropicMaterial(youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, name="aluminium")

pitches = st.floats(0.5e-3, 50e-3)


def reference_cell() -> UnitCell:
    """The prototype: pitch 7 mm, plate 1.5 mm, pillar 3.5 mm wide and 14.7 mm high."""
    return UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3))


@st.composite
def upright_lattices(draw: st.DrawFn) -> Lattice:
    """Squares and rectangles."""
    pitch = draw(pitches)
    if draw(st.booleans()):
        return Lattice.square(pitch)
    return Lattice.rectangular(pitch, pitch * draw(st.floats(0.3, 3.0)))


@st.composite
def lattices(draw: st.DrawFn) -> Lattice:
    """Lattices of every kind; those of oblique ones are the shortest translations."""
    kind = draw(st.sampled_from(["upright", "triangular", "oblique"]))
    if kind == "upright":
        return draw(upright_lattices())
    if kind == "triangular":
        return Lattice.triangular(draw(pitches))
    pitch, turn = draw(pitches), draw(st.floats(-3, 3))
    other, lean = pitch * draw(st.floats(1.0, 2.0)), draw(st.floats(0.02, 0.48)) * pitch
    vectors = np.array([(pitch, 0.0), (lean, np.sqrt(other**2 - lean**2))])
    c, s = np.cos(turn), np.sin(turn)
    (x1, y1), (x2, y2) = (vectors @ np.array([(c, s), (-s, c)])).tolist()
    return Lattice.oblique((x1, y1), (x2, y2))


@st.composite
def cells(draw: st.DrawFn) -> UnitCell:
    """Cells with d/a from 0.1 to 0.95, h/a from 0.2 to 4, e/a from 0.05 to 1; a is the shorter pitch."""
    lattice = draw(upright_lattices())
    short = min(abs(lattice.a1[0]), abs(lattice.a2[1]))
    diameter = short * draw(st.floats(0.1, 0.95) | st.sampled_from([0.1, 0.95]))
    height = short * draw(st.floats(0.2, 4.0) | st.sampled_from([0.2, 4.0]))
    thickness = short * draw(st.floats(0.05, 1.0) | st.sampled_from([0.05, 1.0]))
    clear = 0.5 * (short - diameter) > 0.0101 * lattice.pitch
    pillar = Pillar(diameter, height) if clear else Pillar(0.5 * short, height)
    return UnitCell(lattice, thickness, ALUMINIUM, pillar)


@st.composite
def plans(draw: st.DrawFn, cell: UnitCell, highest: int = 5) -> MeshPlan:
    return MeshPlan.suited(cell, draw(st.integers(2, highest)), draw(st.integers(0, 3)))
