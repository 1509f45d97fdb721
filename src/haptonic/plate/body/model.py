"""Model of a plate: blocks, tiles, supports and drives on one assembly."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.later import linalg as la, sparse as sp
from haptonic.plate.body.assembly import Assembly
from haptonic.plate.body.foundations import Foundation, supported, total_stiffness
from haptonic.plate.body.skeleton import Skeleton
from haptonic.plate.body.tile_construction import Fineness, recipe_of, tiles_of
from haptonic.plate.body.unreduced import loss_factors
from haptonic.plate.layout.blocks import blocks_of
from haptonic.plate.layout.keys import PLATE, PartKey
from haptonic.plate.layout.parts import Finger, Plate

NO_STIFFNESS = 1e-13  # share of a form's largest eigenvalue below which eigenvalues are rounding errors
OPEN_FROM = 4000  # unknowns between blocks from which on those at free edges are condensed into their tiles
FINGER_POINTS = 37  # of equal area on the disc below a finger


@dataclass(frozen=True, eq=False)
class Extra:
    """Addition ``impedance(omega) A A^T`` to the dynamic stiffness of a plate with uniform loss.

    rows : (m,) its unknowns; axes : (m, k) A
    impedance : complex factor at angular frequencies (n,), rad/s
    """

    rows: Ints
    axes: Array
    impedance: Callable[[Array], Complex]

    @classmethod
    def of_form(cls, rows: Ints, form: Array, weight: complex) -> Extra:
        """Make it from a positive semidefinite form (m, m) with a constant weight."""
        sizes, axes = la.eigh(form)
        significant = sizes > NO_STIFFNESS * sizes[-1]
        axes = axes[:, significant] * np.sqrt(sizes[significant])
        return cls(rows, axes, lambda omega: np.full(len(omega), weight))


@dataclass(frozen=True, eq=False)
class PlateModel:
    """Model of a plate. Vectors are those of the assembly.

    plate, fineness : of the model
    highest : frequency up to which tiles are reduced, Hz
    assembly : stiffness and mass without losses
    foundations : of the supports, on the free unknowns of the skeleton
    drives : by name of actuators and forces, (size,) force per volt or newton
    capacitance : by actuator, F
    """

    plate: Plate
    fineness: Fineness
    highest: float
    assembly: Assembly
    foundations: tuple[Foundation, ...]
    drives: Mapping[str, Array]
    capacitance: Mapping[str, float]

    @classmethod
    def of(
        cls,
        plate: Plate,
        highest: float,
        fineness: Fineness | None = None,
        bonds: Mapping[str, tuple[float, float]] = MappingProxyType({}),
        open_from: int = OPEN_FROM,
    ) -> PlateModel:
        """Reduce the tiles of a plate for frequencies up to ``highest`` (Hz) and put them together.

        ``bonds`` contains, by actuator, the smallest and the largest thickness (m) of its bond that the tile
        allows; see `haptonic.plate.body.parameter_update`. From ``open_from`` unknowns between blocks on,
        those at free edges are condensed into their tiles.

        Raises
        ------
        HaptonicError : a frequency whose waves are too short for the tiles; with a coarser mesh than usual,
            which the study chooses, only waves that it does not represent at all
        GeometryError : things glued so close to a lattice that no block of plain tiles contains them
        """
        layout, fineness = plate.layout, fineness or Fineness()
        fineness.check_waves(layout, highest)
        blocks = blocks_of(plate)
        skeleton = Skeleton.of(layout, list(blocks), fineness.trace)
        held, foundations = supported(skeleton, plate.supports)
        total = total_stiffness(foundations, skeleton.size)
        pays = skeleton.size >= open_from
        needed = np.union1d(held, total.indices) if pays else np.arange(skeleton.size)
        opened = skeleton.alone(needed, [block for block, attached in blocks.items() if attached])
        recipes = [
            recipe_of(plate, block, attached, tuple(trace.tolist()))
            for (block, attached), trace in zip(blocks.items(), opened, strict=True)
        ]
        unique = list(dict.fromkeys(recipes))
        tiles = tiles_of(plate, unique, highest, fineness, bonds)
        which = [unique.index(recipe) for recipe in recipes]
        assembly = Assembly.of(skeleton, tiles, which, held, total, opened)
        return cls(
            plate=plate,
            fineness=fineness,
            highest=highest,
            assembly=assembly,
            foundations=tuple(foundation.on(assembly.is_free) for foundation in foundations),
            drives=drives_on(assembly),
            capacitance={name: c for tile in tiles for name, c in tile.capacitance.items()},
        )

    @property
    def factors(self) -> Mapping[PartKey, complex]:
        """Complex factor of each part's stiffness."""
        return loss_factors(self.plate)

    def load(self, drives: Mapping[str, complex]) -> Complex:
        """(size,) forces of drives of given complex amplitudes, V or N."""
        total = sum(amplitude * self.drives[name] for name, amplitude in drives.items())
        return np.asarray(total, np.complex128)

    def blocked(self, actuator: str) -> complex:
        """Capacitance of an actuator at rest with its dielectric loss, F."""
        (loss,) = (a.material.clamped_loss for a in self.plate.actuators if a.name == actuator)
        return self.capacitance[actuator] * (1 - 1j * loss)

    def observed(self, where: Array) -> sp.csr_array:
        """(k, size) normal displacement of points (k, 2) of the flat face, m, per unknown."""
        rows, columns, values = [np.zeros(0, int)], [np.zeros(0, int)], [np.zeros(0)]
        for points, unknowns, weights in self._seen_on_blocks(where):
            rows.append(np.repeat(points, len(unknowns)))
            columns.append(np.tile(unknowns, len(points)))
            values.append(weights.ravel())
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        return sp.csr_array(entries, shape=(len(where), self.assembly.size + 1))[:, :-1]

    def displaced(self, where: Array, vectors: Array) -> Array:
        """(k, n) normal displacement of points (k, 2) of the flat face, m, for many vectors (size, n)."""
        seen = np.empty((len(where), vectors.shape[1]))
        for points, unknowns, weights in self._seen_on_blocks(where):
            free = unknowns < self.assembly.size
            seen[points] = weights[:, free] @ vectors[unknowns[free]]
        return seen

    def _seen_on_blocks(self, where: Array) -> Iterator[tuple[Ints, Ints, Array]]:
        """Points (m,) on each block, its unknowns (n,), and their weights (m, n) in the displacement."""
        assembly, layout = self.assembly, self.plate.layout
        x, y = np.array(layout.x), np.array(layout.y)
        column = np.clip(np.searchsorted(x, where[:, 0], side="right") - 1, 0, layout.columns - 1)
        row = np.clip(np.searchsorted(y, where[:, 1], side="right") - 1, 0, layout.rows - 1)
        block_of = np.full((layout.rows, layout.columns), -1)
        corners, sizes = np.zeros((2, len(assembly.skeleton.blocks), 2))
        for number, block in enumerate(assembly.skeleton.blocks):
            block_of[slice(*block.rows), slice(*block.columns)] = number
            corners[number] = x[block.columns[0]], y[block.rows[0]]
            sizes[number] = np.array([x[block.columns[1]], y[block.rows[1]]]) - corners[number]
        block_at = block_of[row, column]
        assert (block_at >= 0).all(), "points beside the plate"
        local = np.clip(where - corners[block_at], 0.0, sizes[block_at])
        for group in assembly.groups:
            of_blocks = [np.flatnonzero(block_at == block) for block in group.blocks]
            together = np.concatenate(of_blocks)
            if not len(together):
                continue
            weights = group.tile.inside.normal_at(local[together])
            ends = np.cumsum([len(points) for points in of_blocks])[:-1]
            yield from zip(of_blocks, group.unknowns, np.split(weights, ends), strict=True)

    @cached_property
    def pad(self) -> sp.csr_array:
        """(points, size) normal displacement of points of equal area below the finger, per unknown."""
        finger = self.plate.finger
        if finger is None:
            return sp.csr_array((0, self.assembly.size))
        return self.observed(np.array(finger.centre) + 0.5 * finger.diameter * sunflower(FINGER_POINTS))

    @cached_property
    def extras(self) -> tuple[Extra, ...]:
        """Parts with losses other than the plate's, and the finger."""
        assembly, factors = self.assembly, self.factors
        plain = factors[PLATE]
        extras = []
        for group in assembly.groups:
            for part, whole in group.tile.stiffness.items():
                if part != PLATE:
                    for unknowns in group.unknowns:
                        free = unknowns < assembly.size
                        rows, form = unknowns[free], whole[np.ix_(free, free)]
                        extras.append(Extra.of_form(rows, form, factors[part] - plain))
        for foundation in self.foundations:
            rows = np.flatnonzero(np.diff(foundation.stiffness.indptr))
            form = foundation.stiffness[rows][:, rows].toarray()
            extras.append(Extra.of_form(rows, form, 1 + 1j * foundation.loss_factor - plain))
        if (finger := self.plate.finger) is not None:
            rows = np.unique(self.pad.indices)
            share = 1 / self.pad.shape[0]
            axes = self.pad[:, rows].toarray().T
            extras.append(Extra(rows, axes, lambda omega: share * impedance(finger, omega)))
        return tuple(extras)


def drives_on(assembly: Assembly) -> dict[str, Array]:
    """(size,) force per unit of every drive of the tiles, by name."""
    drives: dict[str, Array] = {}
    for group in assembly.groups:
        for name, drive in group.tile.drive.items():
            (unknowns,) = group.unknowns  # a block with a drive is one of its kind
            drives.setdefault(name, np.zeros(assembly.size + 1))[unknowns] += drive
    return {name: drive[:-1] for name, drive in drives.items()}


def impedance(finger: Finger, omega: Array) -> Complex:
    """Dynamic stiffness of a whole finger: force over displacement, N/m."""
    spring = finger.stiffness + 1j * omega * finger.damping
    if finger.mass is None:
        return np.asarray(spring)
    inertia = -(omega**2) * finger.mass
    return np.asarray(spring * inertia / (spring + inertia))


def sunflower(count: int) -> Array:
    """(count, 2) points that share the unit disc evenly (Vogel 1979, doi 10.1016/0025-5564(79)90080-4)."""
    number = np.arange(count) + 0.5
    angle, radius = np.pi * (3 - np.sqrt(5)) * number, np.sqrt(number / count)
    return np.asarray(radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1))
