"""The pillar family the long way round: its outline from lines and circles, and random members of it."""

import math

from hypothesis import strategies as st
from strategies import ALUMINIUM, upright_lattices

from haptonic.cell import Pillar, Step, UnitCell
from haptonic.errors import GeometryError

FOOT = 1e-3  # m; of the extremes below


def arc_centre(pillar: Pillar) -> float:
    """Half-width at which the fillet's centre lies, m.

    It is one radius above the plate, and one radius away from the side.
    """
    sine, cosine = math.sin(pillar.draft), math.cos(pillar.draft)
    # the side is the line (w - R) cos + z sin = 0
    return pillar.radius + pillar.fillet * (1 - sine) / cosine


def arc_top(pillar: Pillar) -> float:
    """Height above the plate at which the fillet ends on the side, m."""
    return pillar.fillet * (1 - math.sin(pillar.draft))


def side(pillar: Pillar, height: float) -> float:
    """Half-width at a height above the plate without the fillet, m; above its step at the step's height."""
    stepped = pillar.step is not None and height >= pillar.step.height
    start = (0.5 * pillar.step.diameter, pillar.step.height) if stepped else (0.5 * pillar.diameter, 0.0)
    return start[0] - (height - start[1]) * math.tan(pillar.draft)


def outline(pillar: Pillar, height: float) -> float:
    """Half-width at a height above the plate, m, the fillet counted."""
    if pillar.fillet and height < arc_top(pillar):
        sunk = pillar.fillet - height
        return arc_centre(pillar) - math.sqrt(max(pillar.fillet**2 - sunk**2, 0.0))
    return side(pillar, height)


EXTREMES = {
    "cylinder": Pillar(FOOT, 3 * FOOT),
    "cone": Pillar(FOOT, 2 * FOOT, draft=math.radians(13)),
    "undercut": Pillar(FOOT, 2 * FOOT, "square", draft=math.radians(-12)),
    "largest fillet": Pillar(FOOT, FOOT, fillet=0.799 * FOOT),
    "largest fillet, square": Pillar(FOOT, FOOT, "square", fillet=0.799 * FOOT),
    "largest fillet, undercut": Pillar(FOOT, FOOT, draft=-0.3, fillet=0.799 * FOOT / (1 + math.sin(0.3))),
    "tiny fillet": Pillar(FOOT, 3 * FOOT, fillet=1e-3 * FOOT),
    "step near the foot": Pillar(FOOT, 3 * FOOT, step=Step(0.5 * FOOT, 0.02 * FOOT)),
    "step near the top": Pillar(FOOT, 3 * FOOT, "square", step=Step(0.94 * FOOT, 2.98 * FOOT)),
    "thin tip": Pillar(FOOT, 3 * FOOT, step=Step(0.051 * FOOT, FOOT)),
    "all at once": Pillar(FOOT, 3 * FOOT, "round", 0.05, 0.3 * FOOT, Step(0.6 * FOOT, 1.2 * FOOT)),
    "all at once, square": Pillar(FOOT, 3 * FOOT, "square", -0.05, 0.3 * FOOT, Step(0.6 * FOOT, FOOT)),
}


@st.composite
def pillars(draw: st.DrawFn) -> Pillar:
    """Members of the family of any proportions, 1 m wide at the foot."""
    height = draw(st.floats(0.2, 6.0))
    draft, step, fillet = 0.0, None, 0.0
    if draw(st.booleans()):
        steepest = math.atan(0.45 / height)  # at which a tenth of the foot's width would be left at the top
        draft = draw(st.floats(-min(0.3, 2 * steepest), 0.9 * steepest))
    if draw(st.booleans()):
        low = height * draw(st.floats(0.05, 0.95))
        below = 1 - 2 * low * math.tan(draft)
        needed = 0.06 + 2 * (height - low) * max(math.tan(draft), 0.0)
        step = Step(needed + draw(st.floats(0, 1)) * max(0.94 * below - needed, 0.0), low)
    if draw(st.booleans()):
        room = 0.8 * (step.height if step else height) / (1 - math.sin(draft))
        fillet = room * draw(st.floats(0.02, 0.999))
    try:
        return Pillar(1.0, height, draw(st.sampled_from(["round", "square"])), draft, fillet, step)
    except GeometryError:  # too steep for its step
        return Pillar(1.0, height, fillet=min(fillet, 0.79 * height))


@st.composite
def members(draw: st.DrawFn) -> UnitCell:
    """Cells with a pillar of the family; its widest part takes a tenth to nine tenths of the cell."""
    lattice = draw(upright_lattices())
    pillar = draw(pillars())
    short = min(abs(lattice.a1[0]), abs(lattice.a2[1]))
    below_step = [pillar.step.height * (1 - 1e-12)] if pillar.step else []
    widest = max(outline(pillar, z) for z in (0.0, pillar.height, *below_step))
    room = 0.5 * short - 0.0101 * lattice.pitch
    size = room * draw(st.floats(0.1, 0.9)) / widest
    thickness = short * draw(st.floats(0.05, 1.0))
    return UnitCell(lattice, thickness, ALUMINIUM, pillar.scaled(size))
