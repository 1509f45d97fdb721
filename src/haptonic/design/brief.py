"""A designer's brief: a gap around the carrier, and the limits set by the workshop and the finger."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.cell import UnitCell
from haptonic.cell.checks import LEAST_CLEARANCE
from haptonic.cell.pillar import LEAST_SHARE
from haptonic.cell.sites import MOST_POINTED
from haptonic.cell.stack import LEAST_APART, Stack
from haptonic.cell.tile import inradius, room_in
from haptonic.design.discs import with_shared
from haptonic.design.links import Links
from haptonic.design.parameters import values_of
from haptonic.design.settings import DesignLimits
from haptonic.fields import with_numbers
from haptonic.fields.expressions import NAMED
from haptonic.lattice import LEAST_SIDE
from haptonic.materials import IsotropicMaterial

LEAST_GAP = 0.02  # between pillars, as a share of the pitch, if no tool asks for more
LEAST_BETWEEN = 2 * LEAST_APART  # between the ends or the borders of discs, as in `check_stack`
LEAST_TIP = 0.1  # narrowest width of a pillar, as a share of that at its foot
SLACK = 1e-6  # by which a design may miss a limit
MARGIN = 1e-3  # by which a starting point meets its limits


@dataclass(frozen=True)
class Brief:
    """A gap that has to contain the carrier, and the designs that are allowed.

    cell : start of the search; its other numbers do not change
    carrier : Hz
    count : number of computed bands
    bounds : by path, lowest and highest value (SI) of the parameters
    allowed : limits of the workshop, and the load on the plate
    held : by path, fixed values (SI) instead of the cell's own; alone they need not make a possible cell
    links : expressions of the cell's numbers, for named parameters among the paths
    """

    cell: UnitCell
    carrier: float
    count: int
    bounds: Mapping[str, tuple[float, float]]
    allowed: DesignLimits = field(default_factory=DesignLimits)
    held: Mapping[str, float] = field(default_factory=dict)
    links: Links = field(default_factory=Links)

    @property
    def paths(self) -> tuple[str, ...]:
        return tuple(self.bounds)

    @property
    def box(self) -> Array:
        """(parameters, 2) lowest and highest values."""
        return np.reshape(list(self.bounds.values()), (-1, 2)).astype(float)

    def at(self, share: Array) -> UnitCell:
        """The cell at a position in the box, given in shares of its sides.

        Raises
        ------
        GeometryError : sizes that do not form a body
        """
        return self.made(dict(zip(self.paths, self.values(share), strict=True)))

    def unchecked(self, share: Array) -> UnitCell:
        """The cell at a position in the box, which need not form a body."""
        values = dict(zip(self.paths, self.values(share), strict=True))
        return with_numbers(self.cell, self._numbers(values), "cell.", checked=False)

    def made(self, values: Mapping[str, float]) -> UnitCell:
        """The cell with these values (SI) of the parameters; for errors see `at`."""
        return self.cell.with_numbers(self._numbers(values))

    def _numbers(self, values: Mapping[str, float]) -> dict[str, float]:
        """Numbers of the cell for values of the parameters."""
        return with_shared(self.cell, self.links.numbers({**self.held, **values}))

    def directions(self, share: Array) -> dict[str, dict[str, float]]:
        """Derivatives of numbers of the cell with respect to the named parameters, at a position."""
        return self.links.directions(dict(zip(self.paths, self.values(share), strict=True)))

    def values(self, share: Array) -> list[float]:
        """Values of the parameters (SI) at a position in the box."""
        low, high = self.box.T
        return [float(v) for v in low + np.clip(share, 0.0, 1.0) * (high - low)]

    def share(self, cell: UnitCell) -> Array:
        """Position of a cell in the box, moved to its border if it lies outside.

        Named parameters have the values of the study.
        """
        low, high = self.box.T
        named = [path for path in self.paths if path.startswith(NAMED)]
        numbers = values_of(cell) | {path: self.links.own(path) for path in named}
        values = np.array([numbers[path] for path in self.paths])
        return np.asarray(np.clip((values - low) / (high - low), 0.0, 1.0))

    def fixed(self, path: str, value: float) -> Brief:
        """A copy of the brief with one parameter fixed."""
        bounds = {name: limits for name, limits in self.bounds.items() if name != path}
        return replace(self, bounds=bounds, held={**self.held, path: value})

    def limits(self, share: Array) -> dict[str, float]:
        """Room left to each limit, by its name, at a position in the box; negative if the limit is broken.

        Each is a share of a length of the design, so that they can be compared.
        """
        cell = self.unchecked(share)
        room: dict[str, float] = {}
        if self.allowed.finger_force is not None:
            assert isinstance(self.cell.material, IsotropicMaterial)
            room["finger"] = cell.thickness / self.allowed.least_thickness(self.cell.material) - 1
        tables: dict[str, list[int]] = {}
        for number, feature in enumerate(cell.features):
            if feature is not None:
                tables.setdefault(cell.table_of(number), []).append(number)
        if tables:
            room |= _of_lattice(cell)
        for path, numbers in tables.items():
            feature = cell.features[numbers[0]]
            of_feature = self._of_stack if isinstance(feature, Stack) else self._of_pillar
            suffix = f" of {path.removesuffix('.')}" if len(tables) > 1 else ""
            room |= {f"{name}{suffix}": value for name, value in of_feature(cell, numbers).items()}
        return room

    def _gap(self, cell: UnitCell, numbers: Sequence[int]) -> float:
        """Room left to the gap between a pillar or stack and its neighbours, in shares of their distance."""
        feature = cell.features[numbers[0]]
        assert feature is not None
        # distance across its tile where the tile is narrowest for its outline
        pitch = 2 * min(room_in(cell.outlines[number], feature.outline) for number in numbers)
        gaps = [1 - (2 * feature.broadest + LEAST_GAP * cell.lattice.pitch) / pitch]
        if self.allowed.tool is not None:
            gaps += [(gap - self.allowed.tool) / pitch for gap in cell.ways(numbers)]
        return min(gaps)

    def _of_stack(self, cell: UnitCell, numbers: Sequence[int]) -> dict[str, float]:
        """Room left to limits of a stack: its discs keep their order, and the parts above can be cut."""
        stack, given = cell.features[numbers[0]], self.cell.features[numbers[0]]
        assert isinstance(stack, Stack)
        assert isinstance(given, Stack)
        room = {"gap between discs": self._gap(cell, numbers)}
        for name, apart, whole in (
            ("layers of the discs", stack.layers(given), cell.thickness),
            ("rings of the discs", stack.rings(given), stack.radius),
        ):
            if len(apart):
                room[name] = float(apart.min()) / whole - LEAST_BETWEEN
        for disc in stack.discs:
            room |= disc.form.room()
        ends = [[width for width, _ in disc.side(cell.thickness)] for disc in stack.discs]
        if any(disc.draft for disc in stack.discs):
            taper = min(min(pair) / max(pair) for pair in ends)
            room["taper of the discs"] = taper - LEAST_BETWEEN - LEAST_SHARE
        pairs = list(zip(stack.discs, ends, strict=True))
        widths = [2 * min(pair) for disc, pair in pairs if not disc.empty and disc.high]
        if self.allowed.slenderness is not None and widths:
            room["slenderness"] = 1 - stack.height / (self.allowed.slenderness * min(widths))
        if self.allowed.reach is not None:
            holes = (disc.ends(cell.thickness) for disc in stack.discs if disc.empty)
            deepest = max((high - low for low, high in holes), default=0.0)
            room["reach of the tool"] = 1 - max(stack.height, deepest) / self.allowed.reach
        across = [2 * min(pair) for disc, pair in pairs if disc.empty]
        if self.allowed.tool is not None and across:
            room["width of a hole"] = min(across) / self.allowed.tool - 1
        return room

    def _of_pillar(self, cell: UnitCell, numbers: Sequence[int]) -> dict[str, float]:
        """Room left to limits of a pillar: it is a body, stays on the tiles of its sites, and can be cut."""
        pillar, lattice = cell.pillars[numbers[0]], cell.lattice
        assert pillar is not None
        pitch = 2 * min(room_in(cell.outlines[number], pillar.outline) for number in numbers)
        across = 2 * pillar.radius
        foot = pillar.arc.centre[0] if pillar.arc is not None else pillar.radius
        top, upper = 2 * pillar.half_width(pillar.height, -1), 2 * pillar.stages[-1][2]
        room = {
            "gap between pillars": self._gap(cell, numbers),
            "fillet": 1 - 2 * foot / pitch - LEAST_GAP * lattice.pitch / pitch,
            "tip": min(upper, top) / across - LEAST_TIP,
        } | pillar.form.room()
        if pillar.arc is not None:
            room["height of the fillet"] = (
                0.75 - pillar.fillet * (1 - math.sin(pillar.draft)) / pillar.stages[0][1]
            )
        thinnest = across
        if pillar.step is not None:
            below = 2 * pillar.half_width(pillar.step.height, 0)
            room["step's height"] = 0.95 - pillar.step.height / pillar.height
            room["step's width"] = (0.93 * below - upper) / across
            thinnest = min(thinnest, upper)
        if self.allowed.slenderness is not None:
            room["slenderness"] = 1 - pillar.height / (self.allowed.slenderness * thinnest)
        if self.allowed.reach is not None:
            room["reach of the tool"] = 1 - pillar.height / self.allowed.reach
        return room

    def allows(self, share: Array) -> bool:
        """True if a position in the box meets all limits."""
        return min(self.limits(share).values(), default=0.0) >= -SLACK

    def feasible(self, share: Array) -> Array:
        """A position in the box that meets all limits, near a given one; else the least bad position."""
        if self.allows(share):
            return share
        count = len(share)
        result = scipy.optimize.minimize(
            lambda x: 1e-3 * float(((x[:count] - share) ** 2).sum()) + x[count],
            np.append(share, max(0.0, -min(self.limits(share).values()))),
            method="SLSQP",
            bounds=[(0.0, 1.0)] * count + [(0.0, None)],
            constraints=[
                {
                    "type": "ineq",
                    "fun": lambda x: np.array([*self.limits(x[:count]).values()]) + x[count] - MARGIN,
                }
            ],
        )
        return np.asarray(np.clip(result.x[:count], 0.0, 1.0))


def _of_lattice(cell: UnitCell) -> dict[str, float]:
    """Room left to limits that keep the tiles of the sites fit for meshing."""
    room = {}
    if math.isfinite(cell.lattice.shortest_side):
        room["side of the cell"] = cell.lattice.shortest_side - LEAST_SIDE
    if len(cell.outlines) > 1:
        within = np.array([inradius(outline) for outline in cell.outlines])
        sides = [
            np.linalg.norm(outline - np.roll(outline, 1, axis=0), axis=1).min() for outline in cell.outlines
        ]
        corners = [np.linalg.norm(outline, axis=1).max() for outline in cell.outlines]
        room["side of a tile"] = float((sides / within).min() - LEAST_SIDE)
        room["corner of a tile"] = float(1 - (corners / within).max() / MOST_POINTED)
        room["distance of the sites"] = float(within.min() / cell.lattice.pitch - LEAST_CLEARANCE)
    placed = [site.shares(cell.vectors) for site in cell.site if site.position is not None]
    # shares of exactly zero do not change
    beside = [share for shares in placed if shares is not None for share in shares if share]
    if beside:
        room["sites within the cell"] = float(min(min(share, 1 - share) for share in beside))
    return room
