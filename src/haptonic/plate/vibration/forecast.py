"""Estimates of the time and memory of a plate's response before the computation.

The times were measured part by part on five plates of 48 to 340 tiles with one to four patches, `plate` and
`simulate scan` of each.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from haptonic import solvers
from haptonic.materials import IsotropicMaterial
from haptonic.plate.body.model import OPEN_FROM
from haptonic.plate.body.skeleton import Skeleton, TraceOrders
from haptonic.plate.body.tile_construction import Fineness
from haptonic.plate.layout.blocks import Attached, blocks_of, kind_of
from haptonic.plate.layout.grid import Block, Layout
from haptonic.plate.layout.parts import Plate
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.plate.vibration.sweep import (
    BLOCK,
    COPIES,
    FACTORS,
    FEWEST_RANDOM,
    LENGTH,
    LOSSES,
    MODES,
    evenly,
    pillars_modes,
)

INSIDE = 17  # modes of a tile, without the unknowns on the lines between blocks; 15 to 21 measured
PARTED = 0.8  # further shifts for each `MODES` modes; 0 to 1.1 measured
# times `MODES` below a band, above which a new basis from rest is needed: measured at 4.3, not at 1.5
MISSED = 2.5
INDEPENDENT = 0.7  # share of the shifts' vectors; 0.6 to 1 measured
DIRECTIONS = 40  # of the losses of a patch, or an elastic support; 30 to 94 and 33 to 66 measured

FIXED, FIXED_MEMORY = 4.0, 1.2e9  # s and bytes, of files and of the program itself
SINGLE, SINGLE_FIXED = 0.01, 8.0  # s of a tile for a single frequency, and of the rest
PER_KIND = 1.3  # s, of each tile that a kind of brick covers, and of plain plate
GLUED, STEEPER = 0.46, 1.6  # s of a tile below a patch, and power of the number of tiles in its block
FINER = 4.0  # power of the tiles' order over the usual one, for both; 3.7 measured at order 6
SOLVED = 6e-5  # s, of a shift for each unknown
ORTHOGONAL, TURNED = 1e-10, 1e-9  # s, of vectors squared for each unknown, and of vectors cubed
PAIRED = 5e-10  # s, of a vector at a line for each pair of directions
CHECKED, PER_LINE = 3e-10, 3e-7  # s, of an unknown at a line for each vector, and without vectors
SEEN = 5e-10  # s, of a point at a line for each vector


@dataclass(frozen=True)
class Counted:
    """Numbers that determine the cost of a response between two frequencies.

    tiles : of the plate's map; a brick counts as one
    kinds : tiles of different bricks, and one of plain plate
    glued : number of tiles of each block with attached parts
    order : of the tiles' meshes over the usual one
    unknowns, directions : about, of the equations and of losses other than the plate's
    shifts : of each basis, about; a second basis from rest if many modes lie below the band, none for a
        single frequency
    forces : at each shift
    lines, points : of the response
    """

    tiles: int
    kinds: int
    glued: tuple[int, ...]
    order: float
    unknowns: int
    directions: int
    shifts: tuple[float, ...]
    forces: int
    lines: int
    points: float

    @classmethod
    def of(cls, plate: Plate, asked: ResponseSettings, fineness: Fineness | None = None) -> Counted:
        """Count for a plate; modes of pillars are those of cantilevers, those of the plate between them

            N = A k^2 / (4 pi),   k^2 = omega sqrt(rho h / D),   D = E h^3 / (12 (1 - nu^2))

        by Weyl's law, which is slightly too low because of the pillars' mass.

        Raises
        ------
        GeometryError : things glued so close to a lattice that no block of plain tiles contains them
        """
        layout, blocks, fine = plate.layout, blocks_of(plate), fineness or Fineness()
        tiles = len(layout.blocks)
        kinds = {kind_of(layout, block): block for block in map(layout.block, layout.bricks)}
        area = sum(layout.area(name) for name in set(layout.there.values()))
        elastic = [
            support for support in plate.supports if support.where == "corners" or support.hold == "spring"
        ]
        losses = len(plate.actuators) + len(elastic)
        drives = len(plate.actuators) + len(plate.forces)

        def parted(low: float) -> float:
            modes = _modes(plate, area, asked.highest) - _modes(plate, area, low)
            return len(evenly(low, asked.highest)) + PARTED * modes / MODES

        starts = [] if asked.lowest == asked.highest else [asked.lowest]
        if starts and _modes(plate, area, asked.lowest) > MISSED * MODES:
            starts.append(0.0)
        return cls(
            tiles=tiles,
            kinds=sum(len(block.tiles) for block in kinds.values()) + bool(layout.regions),
            glued=tuple(len(block.tiles) for block, attached in blocks.items() if attached),
            order=max(fine.cell, fine.plain) / Fineness().cell,
            unknowns=_between(layout, blocks, fine.trace) + INSIDE * tiles,
            directions=DIRECTIONS * losses,
            shifts=tuple(parted(low) for low in starts),
            forces=max(BLOCK, drives * (1 + LOSSES * bool(losses)) + FEWEST_RANDOM),
            lines=asked.points,
            points=area / asked.grid**2,
        )

    @property
    def vectors(self) -> tuple[float, ...]:
        """Number of vectors of each basis, about."""
        return tuple(INDEPENDENT * self.forces * LENGTH * shifts for shifts in self.shifts)

    @property
    def seconds(self) -> float:
        """Processor time, s."""
        tile_seconds = PER_KIND * self.kinds + sum(GLUED * math.pow(count, STEEPER) for count in self.glued)
        tile_seconds *= math.pow(self.order, FINER) * solvers.chosen().slower
        if not self.shifts:
            return SINGLE_FIXED + tile_seconds + SINGLE * self.tiles
        bases = sum(map(self._of_basis, self.shifts, self.vectors))
        return FIXED + tile_seconds + bases + SEEN * self.points * self.lines * self.vectors[-1]

    def _of_basis(self, shifts: float, vectors: float) -> float:
        """Processor time of a basis and its solutions, s."""
        per_unknown = SOLVED * shifts + ORTHOGONAL * vectors**2 + (CHECKED * vectors + PER_LINE) * self.lines
        return self.unknowns * per_unknown + TURNED * vectors**3 + PAIRED * self._pairs * vectors * self.lines

    @property
    def memory(self) -> float:
        """Peak memory, bytes."""
        if not self.shifts:
            return FIXED_MEMORY + FACTORS * self.tiles
        return FIXED_MEMORY + 8.0 * self.vectors[-1] * (COPIES * self.unknowns + 3 * self._pairs)

    @property
    def _pairs(self) -> float:
        return 0.5 * self.directions**2


def _between(layout: Layout, blocks: Mapping[Block, Sequence[Attached]], orders: TraceOrders) -> int:
    """Number of unknowns on the lines between blocks, without those condensed into a block.

    Bricks in offset rows have more edges, and form fewer and smaller blocks.
    """
    skeleton = Skeleton.of(layout, list(blocks), orders)
    if skeleton.size < OPEN_FROM:
        return skeleton.size
    opened = skeleton.alone(np.zeros(0, int), [block for block, attached in blocks.items() if attached])
    return skeleton.size - sum(map(len, opened))


def _modes(plate: Plate, area: float, high: float) -> float:
    """Number of modes of pillars and of bending plate (area in m^2) below a frequency, Hz."""
    layout, solid = plate.layout, plate.layout.material
    if not isinstance(solid, IsotropicMaterial):
        return 0.0
    stiffness = solid.youngs_modulus * layout.thickness**2 / (12 * (1 - solid.poisson_ratio**2))
    bending = area * 2 * math.pi * high * math.sqrt(solid.density / stiffness) / (4 * math.pi)
    return pillars_modes(plate, high) + bending
