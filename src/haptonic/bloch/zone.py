"""Bands over the whole zone: density of states and iso-frequency contours."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Self

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.bloch.model import BlochModel
from haptonic.bloch.representative import images
from haptonic.brillouin import IrreducibleZone
from haptonic.later import xarray as xr
from haptonic.lattice import Lattice, PointGroup

DENSITY_BINS = 200  # from zero to the highest frequency


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
        edges = np.linspace(0.0, self.frequency.max(), DENSITY_BINS + 1)
        variables = {
            "zone_kappa": (("zone_point", "axis"), self.kappa, "rad", "phases over the irreducible zone"),
            "zone_triangle": (("triangle", "vertex"), self.triangles, "1", "triangles of the sampling"),
            "zone_frequency": (("zone_point", "band"), self.frequency, "Hz", "frequency"),
            "zone_error": (("zone_point", "band"), self.error, "Hz", "bound of the frequency's error"),
            "density_of_states": (
                "bin", self.density_of_states(edges), "1/Hz", "states per cell and hertz",
            ),
            "density_frequency": ("bin", 0.5 * (edges[:-1] + edges[1:]), "Hz", "middle of the bin"),
        }  # fmt: skip
        return xr.Dataset(
            {
                name: (dims, values, {"units": unit, "long_name": title})
                for name, (dims, values, unit, title) in variables.items()
            }
        )

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
