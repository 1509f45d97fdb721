"""From the accuracy asked for to a mesh: nobody has to choose one, and an expert can."""

from __future__ import annotations

from dataclasses import dataclass, replace

import psutil

from haptonic.cell import MeshPlan, UnitCell
from haptonic.cell.plan import USUAL_BANDS
from haptonic.errors import ResourceError

MEASURED = {
    (3, 1): 0.3,
    (4, 1): 0.45,
    (5, 1): 0.65,
    (5, 2): 0.3,
    (6, 2): 0.9,
}  # by order and rings, see `remaining`
SHARED = 2.0  # of the worst band's relative distance to the next lower orders that every band's error gets


@dataclass(frozen=True)
class Resolution:
    """How finely a cell is computed.

    order : polynomial order of the elements; see `MeshPlan.suited`
    foot_rings : thin rings on either side of the pillar's foot
    steps, block : number and size of the blocks of the interior's Krylov space
    bands : how many the mesh has to resolve
    """

    order: int
    foot_rings: int
    steps: int = 2
    block: int = 10
    bands: int = USUAL_BANDS

    def for_bands(self, count: int) -> Resolution:
        """The same for so many bands: a mesh that resolves their waves, and more of the interior."""
        block = max(self.block, count) if self.bands >= count else self.block * count // self.bands
        return replace(self, block=block, bands=max(self.bands, count))

    def grown(self) -> Resolution:
        """The same with more of the interior: what is left out falls by about ten."""
        return replace(self, steps=self.steps + 1, block=self.block * 3 // 2)

    def plan(self, cell: UnitCell) -> MeshPlan:
        return MeshPlan.suited(cell, self.order, self.foot_rings, self.bands)

    @property
    def projection_goal(self) -> float:
        """Relative error of a frequency that a small basis may add: little beside what the order leaves."""
        return 1e-4 * 0.4 ** max(self.order - 4, 0)

    def remaining(self, cell: UnitCell) -> float:
        """Error of this resolution as a multiple of its distance to the next lower orders.

        That distance is a band's own plus ``SHARED`` times the worst band's. At the re-entrant edge (270
        degrees) stress grows as r^-0.4555, so on a given mesh the error of a frequency falls as
        order^(-4 * 0.5445) once the edge is all that is left of it; half of that is taken, since the worst
        band counts three times. Before that the smooth part still counts, the error falls faster, and the
        factors are measured ones: with one ring a tenth to a third above what forty designs needed, six for
        order 5 with two rings; that of order 6 was measured on nine while the worst band's share was a
        quarter of this, and stands. With two rings or more the edge never leads up to order 6, which is taken
        to hold beyond. A plain plate has no edge. A step is another re-entrant edge, towards which the mesh
        is graded as towards the foot.
        """
        if cell.pillar is None:
            return 0.25 if self.order > 2 else 0.5
        of_the_edge = max(0.5 / float((self.order / (self.order - 1)) ** (4 * 0.5445) - 1.0), 0.5)
        if self.foot_rings >= 2:
            return MEASURED.get((self.order, 2), MEASURED[6, 2])
        return MEASURED.get((self.order, self.foot_rings), of_the_edge)

    def memory(self, cell: UnitCell) -> float:
        """Estimate of the peak memory, bytes, set to be a little above what orders 3 to 6 were seen to take.

        It counts dense answers to the trace, the sparse factor, element matrices and the condensed ones.
        """
        plan = self.plan(cell)
        nodes = sum(plan.level_sizes)
        trace = 3 * 4 * plan.side * (plan.upward + 1)
        quarter = 3 * nodes / 4
        across, along, upward = plan.outward + 1, plan.order + 1, plan.upward + 1
        pairs = nodes / 4 * 3 * (across * along + along * upward + across * upward)
        return 2.5e8 + 17.6 * float(
            4 * quarter * trace / 4  # static answers of one class, and work space
            + 3 * quarter * (trace / 4 + 13 + self.steps * self.block)  # what the classes keep for lifting
            + 60 * quarter ** (4 / 3)  # factors of two threads
            + 9 * 2 * pairs  # stiffness between pairs of nodes, and work space
            + 60 * (trace / 2 + 150) ** 2  # pencils
        )


# Each rung costs about twice the one before; orders grow, the foot is graded further.
LADDER = (
    Resolution(3, 1),
    Resolution(4, 1),
    Resolution(5, 1),
    Resolution(5, 2, 3),
    Resolution(6, 2, 3, 24),
    Resolution(6, 3, 3, 24),
    Resolution(7, 3, 3, 24),
    Resolution(8, 4, 4, 24),
    Resolution(10, 4, 4, 24),
)
EXPECTED = (5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 3e-5, 1e-5, 2e-6)  # error each is tried for first


def starting_rung(accuracy: float) -> int:
    """The rung of the ladder that an accuracy (relative) is tried on first."""
    for rung, expected in enumerate(EXPECTED):
        if expected <= accuracy:
            return rung
    return len(LADDER) - 1


THIN = 0.04  # thickness, in pitches, below which waves between pillars are short and the mesh reaches less
REACHED_IF_THIN = 5e-2  # by plates of 0.017 to 0.02 pitches in half a minute


def check_reach(cell: UnitCell, accuracy: float) -> None:
    """Refuse at once what no mesh reaches in a time that anybody waits for."""
    pitch = cell.lattice.pitch
    if cell.pillar is None or cell.thickness >= THIN * pitch or accuracy >= REACHED_IF_THIN:
        return
    raise ResourceError(
        argument="bands.accuracy",
        given=f"{accuracy:g}",
        allowed=f"{REACHED_IF_THIN:g} or more with a plate of {cell.thickness * 1e3:.4g} mm",
        cause=f"the plate is thin for a pitch of {pitch * 1e3:.4g} mm: its waves are short and stress is "
        "concentrated at the foot",
        next_step=f"ask for less accuracy, or choose a plate of at least {THIN * pitch * 1e3:.4g} mm",
    )


def check_memory(cell: UnitCell, resolution: Resolution, accuracy: float) -> None:
    """Refuse a resolution that this machine cannot hold."""
    needed, there = resolution.memory(cell), float(psutil.virtual_memory().available)
    if needed > 0.9 * there:
        raise ResourceError(
            argument="bands.accuracy",
            given=f"{accuracy:g}",
            allowed=f"what fits into the {there / 1e9:.1f} GB that are free",
            cause=f"elements of order {resolution.order} with {resolution.foot_rings} rings at the foot "
            f"would need about {needed / 1e9:.1f} GB",
            next_step="ask for less accuracy, or use a machine with more memory",
        )
