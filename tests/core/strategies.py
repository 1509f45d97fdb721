"""Random cells over the design range, extreme ones included."""

from hypothesis import assume, strategies as st

from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.errors import GeometryError
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
    """Lattices of every kind."""
    pitch, kind = draw(pitches), draw(st.sampled_from(["upright", "triangular", "centred", "oblique"]))
    if kind == "upright":
        return draw(upright_lattices())
    if kind == "triangular":
        return Lattice.triangular(pitch)
    try:
        if kind == "centred":
            return Lattice.centred(pitch, pitch * draw(st.floats(0.3, 3.0)))
        return Lattice.oblique(pitch, pitch * draw(st.floats(0.3, 3.0)), draw(st.floats(0.3, 2.8)))
    except GeometryError as error:  # so near a rectangle that a side of the cell is next to nothing
        assume(error.argument != "cell.lattice")
        raise


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
