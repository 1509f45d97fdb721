"""Bands over the whole zone: density of states and iso-frequency contours."""

from __future__ import annotations

import json
from dataclasses import dataclass
from itertools import pairwise
from typing import Self

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.character import characters
from haptonic.bloch.model import BlochModel
from haptonic.bloch.reduced import SPARE_MODES
from haptonic.bloch.representative import images, signed_operations
from haptonic.bloch.symmetry import MIDDLE, mirrors_at
from haptonic.bloch.tracking import (
    STILL,
    VELOCITY_ERROR,
    group_velocity,
    group_velocity_error,
    split_by_parity,
)
from haptonic.brillouin import IrreducibleZone
from haptonic.gate import declared, titled
from haptonic.later import xarray as xr
from haptonic.lattice import Lattice, Operation, PointGroup
from haptonic.superelement import JointImage

DENSITY_BINS = 200  # from zero to the highest frequency, about
BESIDE = 1e-6  # of the highest frequency, by which a bin of states goes beyond the edges of a gap


@dataclass(frozen=True)
class ZoneSurface:
    """Bands as surfaces over the irreducible zone.

    zone, group : irreducible zone, and point group that maps it to the rest of the zone
    kappa : (n, 2) phases, rad; triangles : (m, 3); frequency : (n, k) Hz; error : (n, k) its bounds, Hz
    """

    zone: IrreducibleZone
    group: PointGroup
    kappa: Array
    triangles: Ints
    frequency: Array
    error: Array

    @classmethod
    def of_dataset(cls, dataset: xr.Dataset) -> Self:
        """Read the surface of a result; lattice, operations and corners of the zone are in its attributes."""
        given, operations, corners = (
            json.loads(dataset.attrs[name]) for name in ("lattice", "point_group", "zone")
        )
        sizes = {name: given[name] for name in ("pitch_y", "pitch_2", "angle")}
        lattice = Lattice(lattice=given["form"], pitch=given["period"], **sizes)
        group = tuple(((a, b), (c, d)) for (a, b), (c, d) in operations)
        return cls(
            zone=IrreducibleZone(lattice, tuple((label, tuple(point)) for label, point in corners)),
            group=PointGroup((lattice.a1, lattice.a2), group),
            kappa=dataset["zone_kappa"].values,
            triangles=dataset["zone_triangle"].values,
            frequency=dataset["zone_frequency"].values,
            error=dataset["zone_error"].values,
        )

    def dataset(self) -> xr.Dataset:
        """Samples and density of states; `of_dataset` reads the samples."""
        edges = self.density_edges()
        variables = {
            "zone_kappa": (("zone_point", "axis"), self.kappa, "rad", "phases over the irreducible zone"),
            "zone_triangle": (("triangle", "vertex"), self.triangles, "1", "triangles of the sampling"),
            "zone_frequency": (("zone_point", "band"), self.frequency, "Hz", "frequency"),
            "zone_error": (("zone_point", "band"), self.error, "Hz", "bound of the frequency's error"),
            "density_of_states": (
                "bin", self.density_of_states(edges), "1/Hz", "states per cell and hertz",
            ),
            "density_frequency": ("bin", 0.5 * (edges[:-1] + edges[1:]), "Hz", "middle of the bin"),
            "density_width": ("bin", np.diff(edges), "Hz", "width of the bin"),
        }  # fmt: skip
        return titled(variables)

    def density_edges(self) -> Array:
        """(bins + 1,) frequencies, Hz; no bin contains both states and a part of a gap between two bands."""
        top = float(self.frequency.max())
        upper, lower = self.frequency.max(axis=0)[:-1], self.frequency.min(axis=0)[1:]
        gap = lower - upper > 3 * BESIDE * top
        beside = np.stack([upper[gap] + BESIDE * top, lower[gap] - BESIDE * top], axis=1)
        ends = [0.0, *beside.ravel().tolist(), top]
        parts = [
            np.linspace(low, high, max(1, round((high - low) / top * DENSITY_BINS)), endpoint=False)
            for low, high in pairwise(ends)
        ]
        return np.append(np.concatenate(parts), top)

    def density_of_states(self, edges: Array) -> Array:
        """(bins,) states per cell and Hz between the given frequencies (bins + 1,).

        Linear interpolation on triangles, integrated exactly (Lehmann and Taut 1972,
        doi 10.1002/pssb.2220540211, in two dimensions): every band has one state per cell.
        """
        corners = self.kappa[self.triangles]
        across = corners[:, 1:] - corners[:, :1]
        area = np.abs(across[:, 0, 0] * across[:, 1, 1] - across[:, 0, 1] * across[:, 1, 0])
        share = area / area.sum()
        a, b, c = np.moveaxis(np.sort(self.frequency[self.triangles], axis=1), 1, 0)[..., None]
        floor = 1e-9 * self.frequency.max()  # a flat triangle is treated as a steep ramp
        b, c = np.maximum(b, a + floor), np.maximum(c, a + 2 * floor)
        b = np.minimum(b, c - floor)
        f = edges
        rising = (np.clip(f, a, b) - a) ** 2 / ((b - a) * (c - a))
        falling = 1 - (c - np.clip(f, b, c)) ** 2 / ((c - a) * (c - b))
        below = np.where(f < b, rising, falling)
        counted = np.einsum("mkf,m->f", below, share)
        return np.asarray(np.diff(counted) / np.diff(edges))

    def unfolded(self) -> tuple[Array, Ints, Ints]:
        """Whole first zone by the point group: wavevectors (rad/m), triangles, and number of each sample."""
        wavevectors, number = images(self.group, self.kappa)
        starts = range(0, len(wavevectors), len(self.kappa))
        triangles = np.concatenate([self.triangles + start for start in starts])
        return self.zone.lattice.wavevector(wavevectors), triangles, number

    def turns(self) -> tuple[Array, Ints]:
        """Turns or reflections (copies, 2, 2) of the plane from samples to their images in `unfolded`.

        The second value is the sign of each copy, -1 with time reversal: ``u'(R r) = R u(r)``, its complex
        conjugate for the sign -1.
        """
        vectors = np.transpose(self.zone.lattice.vectors)
        signed = signed_operations(self.group)
        turns = [vectors @ np.array(operation) @ np.linalg.inv(vectors) for operation, _ in signed]
        return np.array(turns), np.array([sign for _, sign in signed])


@dataclass(frozen=True)
class ZoneModes:
    """Modes at samples of the zone; n wavevectors, k bands.

    velocity : (n, k, 2) group velocity, m/s; NaN for rigid-body motions
    velocity_error : (n, k) estimate of the length of its error, m/s
    parity : (n, k) +1 even, -1 odd under the mirror of the wavevector, 0 without one
    mirror : (n,) name of this mirror, empty without one
    middle, character : (n, k), as in `haptonic.bloch.tracking.Diagram`
    fields : (t + m, n k) unknowns of the tiling, unit mass, the bands of each wavevector together
    """

    velocity: Array
    velocity_error: Array
    parity: Ints
    mirror: tuple[str, ...]
    middle: Ints
    character: Ints
    fields: Complex

    @classmethod
    def of(cls, model: BlochModel, kappa: Array) -> Self:
        """Solve at phases (n, 2); degenerate modes are combined to definite parity."""
        tiling, images = model.fine.tiling, dict[Operation, JointImage]()
        velocity, uncertainty, parity, names, middle, solved = [], [], [], [], [], []
        for phases in kappa:
            # spare modes, so that the last band does not divide a degenerate pair
            solution = model.solve(phases, spare=SPARE_MODES)
            name, operation = next(
                iter(mirrors_at(model.cell.point_group, solution.kappa).items()), ("", None)
            )
            mirror = None
            if operation is not None:
                mirror = images.setdefault(operation, tiling.joint.image(operation))
            of_bands, signs = split_by_parity(solution, model, mirror)
            velocity.append(group_velocity(model, of_bands))
            uncertainty.append(group_velocity_error(model, solution)[: model.count])
            parity.append(signs)
            names.append(name)
            middle.append(model.fine.parity(of_bands.modes))
            solved.append(of_bands)
        fields = np.hstack([solution.fields for solution in solved])
        values = np.concatenate([solution.values for solution in solved])
        return cls(
            velocity=np.stack(velocity),
            velocity_error=np.stack(uncertainty),
            parity=np.stack(parity),
            mirror=tuple(names),
            middle=np.stack(middle),
            character=characters(tiling, fields, values).name.reshape(len(names), -1),
            fields=fields,
        )

    def dataset(self) -> xr.Dataset:
        """The modes without their fields."""
        of_modes = ("zone_point", "band")
        variables = {
            "zone_velocity": (
                (*of_modes, "axis"), self.velocity, "m/s",
                "group velocity along x and y; NaN for rigid-body motions",
            ),
            "zone_velocity_error": (of_modes, self.velocity_error, "m/s", VELOCITY_ERROR),
            "zone_parity": (of_modes, self.parity, "1", "+1 even, -1 odd under the mirror, 0 without one"),
            "zone_mirror": (
                of_modes[:1], np.array(self.mirror).astype("U"), "1", "mirror that keeps the wavevector",
            ),
            "zone_middle_parity": (of_modes, self.middle, "1", MIDDLE),
            "zone_character": (of_modes, self.character, "1", "character, a position in character_names"),
        }  # fmt: skip
        dataset = titled(variables)
        return declared(dataset, zone_velocity=STILL, zone_velocity_error=STILL)


def zone_surface(model: BlochModel, divisions: int) -> ZoneSurface:
    """Sample the irreducible zone on a regular triangulation."""
    kappa, triangles = model.cell.zone.triangles(divisions)
    solutions = [model.solve(point) for point in kappa]
    return ZoneSurface(
        zone=model.cell.zone,
        group=model.cell.point_group,
        kappa=kappa,
        triangles=triangles,
        frequency=np.stack([solution.frequency for solution in solutions]),
        error=np.stack([solution.error for solution in solutions]),
    )
