"""Bands of a cell along one of its numbers, for a preview while a slider moves.

A coarse model gives every frequency of the path, and every edge over the zone, at some values of the number,
the nodes. Each is scaled by its ratio at the present design, where an exact result is known:

    preview(p) = certified(p0) coarse(p) / coarse(p0).

Between two nodes a sorted frequency, or an edge, is interpolated along a straight line. If the slope of a
curve changes by D in an interval of length h, the line is wrong by at most ``D h t (1 - t)`` at the share t
of the interval, whether bands cross or bend. The changes of the slope at both ends of the interval sum to D.
A crossing may hide a bend of the opposite sign there. The next nodes show it, so their changes are added.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import gaps_of
from haptonic.bloch.gaps import ZoneSampling
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.truncation import REST
from haptonic.cell import UnitCell
from haptonic.design.quick import quick_model
from haptonic.errors import GeometryError
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread

FIRST_NODES = 5  # values at which the first preview is computed, ends included
MOST_NODES = 13
FINE_ENOUGH = 2e-3  # relative error of the interpolation at which no node is added
AT_ENDS = 2.0  # change of the slope beyond the range, in multiples of the change at the next node
OPEN = 0.02  # relative overlap of two bands from which their edges are searched less exactly
ROUGH = 0.02  # relative doubt of such an edge


@dataclass(frozen=True)
class Samples:
    """Coarse bands of one design.

    frequency : (wavevectors of the path, bands) Hz
    edges : (2, bands - 1) Hz, over the zone: highest of each band but the last, and lowest of the next
    doubt : (2, bands - 1) how far each of them may lie inside the band between two samples, Hz
    distance : (wavevectors,) length of the path up to each wavevector, rad/m; pitch : m
    """

    frequency: Array
    edges: Array
    doubt: Array
    distance: Array
    pitch: float

    @classmethod
    def of(cls, cell: UnitCell, settings: BandSettings) -> Samples:
        """Compute the bands of a cell along its path and over its zone."""
        with one_thread():
            model = quick_model(cell, settings.count)
            path = cell.zone.path(settings.points)
            values = [eigenpairs(model.fine.pencil, kappa, settings.count)[0] for kappa in path.kappa]
            zone, columns = ZoneSampling(model), []
            for band in range(settings.count - 1):
                sampled = np.array(zone.frequency)
                far = sampled[:, band].max() > (1 + OPEN) * sampled[:, band + 1].min()
                sides = [zone.edge(band + up, 1 - 2 * up, ROUGH if far else None) for up in (0, 1)]
                columns.append([(value, doubt) for value, _, doubt in sides])
        edges = np.array(columns).transpose(2, 1, 0)
        return cls(
            frequency=hertz(np.array(values)), edges=edges[0], doubt=edges[1], distance=path.distance,
            pitch=cell.lattice.pitch,
        )  # fmt: skip


@dataclass(frozen=True)
class CertifiedBands:
    """Result for the present design: a dataset of `haptonic.bloch.bands_dataset`, with its coarse bands."""

    dataset: xr.Dataset
    coarse: Samples

    def scaled(self, samples: Samples) -> tuple[Samples, Samples]:
        """Preview of a design at a node, and the bounds of its errors without interpolation.

        The certified results of both designs have errors, and the ratio changes between them. The change is
        taken to be smaller than the distance of the ratio from 1.
        """
        reached = self.dataset.attrs.get("largest_error")  # none if the user chose the mesh
        level = 0.0 if reached is None else max(float(reached), float(self.dataset.attrs["accuracy"]))
        exact, error = (self.dataset[name].values for name in ("frequency", "frequency_error"))
        moving = self.coarse.frequency > REST * self.coarse.frequency.max()
        ratio = np.divide(exact, self.coarse.frequency, where=moving, out=np.ones_like(exact))
        frequency = ratio * samples.frequency
        share = np.divide(error, exact, where=moving, out=np.zeros_like(exact))
        bound = np.where(
            moving, frequency * (np.maximum(share, level) + np.abs(ratio - 1)), error + np.abs(frequency)
        )
        # extremes of the path lie next to those of the zone, also where there is no certified gap
        rows = np.stack([exact[:, :-1].argmax(axis=0), exact[:, 1:].argmin(axis=0)])
        bands = np.arange(exact.shape[1] - 1) + np.array([[0], [1]])
        of_edges, error_of_edges = ratio[rows, bands], share[rows, bands]
        for gap in (gap for gap in gaps_of(self.dataset) if gap.complete):
            column = gap.between[0] - 1
            ends = np.array(gap.edges)
            of_edges[:, column] = ends / self.coarse.edges[:, column]
            error_of_edges[:, column] = np.array([gap.lower_error, gap.upper_error]) / ends
        edges = of_edges * samples.edges
        around = edges * (np.maximum(error_of_edges, level) + np.abs(of_edges - 1))
        none = np.zeros_like(samples.doubt)
        around = around + samples.doubt + self.coarse.doubt
        return (
            replace(samples, frequency=frequency, edges=edges, doubt=none),
            replace(samples, frequency=bound, edges=around, doubt=none),
        )


@dataclass(frozen=True)
class DesignLine:
    """Coarse bands of the designs along one number.

    values : (nodes,) ascending, SI; samples : of each node
    """

    values: tuple[float, ...]
    samples: tuple[Samples, ...]

    def with_node(self, value: float, samples: Samples) -> DesignLine:
        """The line with one more node, or the same if it has a node there."""
        if value in self.values:
            return self
        nodes = sorted(
            [*zip(self.values, self.samples, strict=True), (value, samples)], key=lambda node: node[0]
        )
        values, every = zip(*nodes, strict=True)
        return DesignLine(values, every)

    def dataset(self, certified: CertifiedBands) -> xr.Dataset:
        """Preview: frequencies and edges at the nodes, bounds of their errors, and changes of their slopes.

        At the share t of the interval of length h between the nodes i and i + 1 a value and its bound are

            (1 - t) v[i] + t v[i+1]   and   (1 - t) e[i] + t e[i+1] + (b[i] + b[i+1]) h t (1 - t).

        The reciprocal of the length of the path, and the pitch, are linear between two nodes: exactly, if the
        number scales the lattice.
        """
        scaled = [certified.scaled(samples) for samples in self.samples]
        variables: dict[str, Any] = {}
        node = ("node",)
        for name, dims, pick, title in (
            ("frequency", ("wavevector", "band"), "frequency", "frequency along the path"),
            ("edge", ("side", "pair"), "edges", "edge of the gap between two bands over the zone"),
        ):
            value, error = (np.stack([getattr(each[k], pick) for each in scaled]) for k in (0, 1))
            variables |= {
                name: (node + dims, value, {"units": "Hz", "long_name": title}),
                f"{name}_error": (node + dims, error, {"units": "Hz", "long_name": "bound of its error"}),
                f"{name}_bend": (
                    node + dims, _bends(np.array(self.values), value),
                    {"units": "Hz", "long_name": "change of its slope, per SI unit of the number"},
                ),
            }  # fmt: skip
        shared = {
            "distance": (("node", "wavevector"), "rad/m", "arc length of the wavevector"),
            "pitch": (node, "m", "pitch of the lattice"),
        }
        for name, (along, unit, title) in shared.items():
            values = np.array([getattr(samples, name) for samples in self.samples])
            variables[name] = (along, values, {"units": unit, "long_name": title})
        value_attributes = {"units": "1", "long_name": "value of the number, SI"}
        return xr.Dataset(variables | {"value": (node, np.array(self.values), value_attributes)})

    def widest_error(self, certified: CertifiedBands) -> tuple[float, float]:
        """Largest relative error of the interpolation, and the middle of the interval that has it."""
        preview, values = self.dataset(certified), np.array(self.values)
        worst = np.zeros(len(values) - 1)
        for name in ("frequency", "edge"):
            value, bend = (preview[each].values.reshape(len(values), -1) for each in (name, f"{name}_bend"))
            error = 0.25 * (bend[1:] + bend[:-1]) * np.diff(values)[:, None]
            worst = np.maximum(worst, (error / np.maximum(value[1:], 0.1 * value.max())).max(axis=1))
        interval = int(worst.argmax())
        return float(worst[interval]), float(values[interval : interval + 2].mean())


def refined_lines(
    line: DesignLine | None, design: Callable[[float], UnitCell], certified: CertifiedBands,
    settings: BandSettings, ends: tuple[float, float], here: float,
) -> Iterator[DesignLine | None]:  # fmt: skip
    """Add nodes to a line; yields after each, None while there are too few for a preview.

    A value without a possible design ends the line, and so does one whose path has other wavevectors.

    Parameters
    ----------
    line : nodes computed before, of the same designs
    design : gives the cell of a value
    ends : least and largest value
    here : value of the present design
    """

    def with_value(line: DesignLine, value: float) -> DesignLine:
        if value in line.values:
            return line
        try:
            samples = Samples.of(design(value), settings)
        except GeometryError:
            return line
        fits = samples.frequency.shape == certified.coarse.frequency.shape
        return line.with_node(value, samples) if fits else line

    line = (line or DesignLine((), ())).with_node(here, certified.coarse)
    for value in np.linspace(*ends, FIRST_NODES).tolist():
        line = with_value(line, value)
        yield None
    if len(line.values) < FIRST_NODES - 1:
        return
    yield line
    while len(line.values) < MOST_NODES:
        error, middle = line.widest_error(certified)
        refined = with_value(line, middle)
        if error <= FINE_ENOUGH or refined is line:
            return
        line = refined
        yield line


def _bends(values: Array, curves: Array) -> Array:
    """(nodes, ...) changes of the slopes of curves at and beside the nodes; at the ends they are assumed."""
    apart = np.diff(values).reshape(-1, *[1] * (curves.ndim - 1))
    inside = np.abs(np.diff(np.diff(curves, axis=0) / apart, axis=0))
    changes = np.concatenate([AT_ENDS * inside[:1], inside, AT_ENDS * inside[-1:]])
    beside = np.maximum(np.roll(changes, 1, axis=0), np.roll(changes, -1, axis=0))
    beside[0], beside[-1] = changes[1], changes[-2]
    return np.asarray(changes + beside)
