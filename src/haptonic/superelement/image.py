"""Rotations and mirrors of a cell, applied to displacement fields on its meshes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array, Complex, Ints
from haptonic.cell.tile import MEET
from haptonic.errors import GeometryError
from haptonic.lattice import Operation
from haptonic.superelement.tiling import Tiling


@dataclass(frozen=True, eq=False)
class FieldImage:
    """Operation g of a cell on Bloch fields on its meshes: ``turn u(g^-1 x)``.

    turn : (3, 3) rotation or mirror; source : (nodes,) node whose motion each node has afterwards
    shift : (nodes, 2) translations from the image of that node to this one
    """

    turn: Array
    source: Ints
    shift: Ints

    @classmethod
    def of(cls, tiling: Tiling, operation: Operation) -> FieldImage:
        """Find the image of every node. Every mesh of a tile has a counterpart in the image of the tile."""
        cell = tiling.cell
        if cell.solid is not None:
            raise GeometryError.unsupported(
                argument="kappa",
                given="a wavevector outside the irreducible zone",
                allowed="for modes of a CAD file's solids, a wavevector of the zone that the diagram shows",
                cause="their mesh does not have the symmetry of the solids, so modes cannot be rotated",
                next_step="use the equivalent wavevector in the zone; it has the same frequencies",
            )
        mapped = cell.site_map(operation)
        assert mapped is not None, "no symmetry of this cell"
        turn = cell.lattice.point_group.turn(operation)
        move = (mapped.move - mapped.shift) @ cell.lattice.vectors  # of each tile
        nodes = np.split(tiling.points, np.cumsum([len(mesh.points) for mesh in tiling.meshes])[:-1])
        starts = np.cumsum([0, *(len(points) for points in nodes)])
        first = np.cumsum([0, *(len(tile.meshes) for tile in tiling.tiles)])  # mesh of each tile
        source = np.empty(starts[-1], dtype=np.int64)
        shift = np.empty((len(source), 2), dtype=np.int64)
        for tile, image in enumerate(mapped.image):
            for number in range(first[image + 1] - first[image]):
                here, there = first[tile] + number, first[image] + number
                before = (nodes[there] - np.append(move[tile], 0.0)) @ turn
                away, nearest = scipy.spatial.cKDTree(nodes[here]).query(before)
                assert away.max() < MEET * cell.lattice.pitch, (
                    "the meshes of two tiles are not images of each other"
                )
                nodes_there = slice(starts[there], starts[there + 1])
                source[nodes_there], shift[nodes_there] = starts[here] + nearest, mapped.shift[tile]
        return cls(turn, source, shift)

    def applied(self, fields: Complex, kappa: Array) -> Complex:
        """(nodes, 3, k) image of fields; ``kappa`` (2,) phases of the image, rad."""
        phase = np.exp(-1j * (self.shift @ kappa))
        return np.asarray(self.turn @ (fields[self.source] * phase[:, None, None]))
