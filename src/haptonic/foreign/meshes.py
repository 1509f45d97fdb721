"""One period of a plate from a mesh file, used as it is: nothing is cut, moved or refined.

The sides of the tile must be faces of the mesh. Elements on opposite sides need not match, because the motion
is a polynomial along each side, see `haptonic.foreign.solids`. Quadratic tetrahedra keep their curved edges;
midpoint nodes of straight edges are removed. Geometrical errors, such as a circle of a few straight edges,
are those of the file. Lengths are in the units of `haptonic.foreign.periods`.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.foreign.elements import EDGES, SHAPES, NamedElements, RefusedMesh, of_elements, read_elements
from haptonic.foreign.joined import faces_of, on_faces, padded, parts_of, refuse_pieces, turned
from haptonic.foreign.periods import SAME, FilledTile

# nodes of a quadratic tetrahedron in Netgen's order, and the edges with nodes of its triangles
NETGENS_TETRA, OF_TRIANGLE = [0, 1, 2, 3, 4, 6, 7, 5, 8, 9], ((1, 2), (0, 2), (0, 1))
UNKNOWNS = {"tetra": 1.0, "pyramid": 2.0, "wedge": 3.0, "hexahedron": 6.0}  # relative to a tetrahedron
NEAR = 1e-3  # units; largest distance of a node from its side, for files with few digits
LEAST_ALONG = 2  # elements along each side, so that the polynomials there are those of the elements


class MeshPeriod(FilledTile):
    """A mesh that fills the tile."""

    blocks = 1

    def __init__(
        self, path: str, tile: NDArray[Any], vectors: NDArray[Any], thickness: float, unit: float,
        with_material: Sequence[str],
    ) -> None:  # fmt: skip
        super().__init__(tile, vectors, thickness)
        self.names: list[str] = []
        self.parts: list[str] = []
        self._origin, self._scale = np.zeros(3), unit / self.metres
        try:
            whole = read_elements(path)
            self.names = list(whole.groups)
            self._read(whole, with_material)
        except RefusedMesh as refused:
            self.problem, self.number, self.text = refused.kind, refused.number, refused.text
            self.place = refused.place

    def near_edges(self, mesh: Any) -> None:
        """None for all elements, because a file does not mark its edges."""

    def _read(self, whole: NamedElements, with_material: Sequence[str]) -> None:
        import ngsolve as ng

        self._points = whole.points * self._scale
        blocks = [turned(self._points, *block, self._refused) for block in whole.blocks]
        self._points, self._blocks = of_elements(self._points, blocks)
        self.is_straight = all(kind != "tetra10" for kind, _ in self._blocks)
        self._corners = padded(self._blocks)
        self._refuse_doubled()
        self._origin = self._middle()
        self._points = self._points - self._origin
        faces, element, joined = faces_of(self._blocks, self._refused_at)
        self._refuse_open(faces)
        refuse_pieces(joined, len(self._corners), self._refused_at)
        side = self._sides_of(faces)
        self._part, self.parts = parts_of(whole.groups, with_material, len(self._corners))
        self._refuse_groups(side, element, with_material)
        self.mesh = self._netgen(faces, side, self._part[element])
        mesh = self.elements_of(1, 0)
        self.elements = sum(UNKNOWNS[SHAPES[kind]] * len(nodes) for kind, nodes in self._blocks)
        self.volumes = [
            float(ng.Integrate(ng.CF(1.0), mesh, definedon=mesh.Materials(f"part{number}")))
            for number in range(len(self.parts))
        ]
        self._refuse_folded(mesh)

    @property
    def part_names(self) -> list[str]:
        return self.parts

    def _refused(self, kind: str, place: NDArray[Any], number: float = 0.0, text: str = "") -> RefusedMesh:
        """Error at places (..., 3), in metres in the coordinates of the file."""
        return RefusedMesh(kind, number=number, text=text, place=(place + self._origin) * self.metres)

    def _refused_at(self, kind: str, element: int, number: float) -> RefusedMesh:
        """Error at the centre of an element, numbered over all blocks."""
        corners = self._corners[element]
        return self._refused(kind, self._points[corners[corners >= 0]].mean(axis=0), number)

    def elements_of(self, order: int, rings: int) -> Any:
        """NGSolve's mesh; order and rings do not change it."""
        import ngsolve as ng

        return ng.Mesh(self.mesh)

    def is_kept(self, turn: NDArray[Any]) -> bool:
        """True if a map of the plane maps the mesh to itself, element by element and part by part."""
        from scipy.spatial import cKDTree

        turned = self._points.copy()
        turned[:, :2] = turned[:, :2] @ turn.T
        away, image = cKDTree(self._points).query(turned)
        if away.max() > SAME:
            return False
        images = np.where(self._corners >= 0, image[self._corners], -1)
        before, after = (
            np.unique(np.column_stack([self._part, np.sort(corners, axis=1)]), axis=0)
            for corners in (self._corners, images)
        )
        return np.array_equal(before, after)

    def _refuse_doubled(self) -> None:
        """Refuse several nodes at one place: the mesh has a crack there that the drawing does not have."""
        from scipy.spatial import cKDTree

        near = cKDTree(self._points).query(self._points, k=2)[0][:, 1] < SAME
        if near.any():
            raise self._refused("doubled", self._points[near.argmax()], float(near.sum()))

    def _middle(self) -> NDArray[Any]:
        """Centre of the mesh's bounding box, at its lowest face; the extent must be that of the tile."""
        low, high = self._points.min(axis=0), self._points.max(axis=0)
        extents = np.stack([(high - low)[:2], np.ptp(self.corners, axis=0)])
        if (np.abs(extents[0] - extents[1]) > NEAR).any():
            raise RefusedMesh("extent", place=extents * self.metres)
        return np.array([*(0.5 * (low + high)[:2]), low[2]])

    def _refuse_open(self, faces: NDArray[np.int64]) -> None:
        """Refuse faces that touch without being joined."""
        from scipy.spatial import cKDTree

        corners = np.concatenate([faces[:, [0, 1, 2]], faces[faces[:, 3] >= 0][:, [0, 2, 3]]])
        quads = faces[faces[:, 3] >= 0]
        triples = {tuple(sorted(face)) for face in faces[faces[:, 3] < 0, :3].tolist()}
        for quad in quads.tolist():
            if any(tuple(sorted(quad[:k] + quad[k + 1 :])) in triples for k in range(4)):
                raise self._refused("hanging", self._points[quad].mean(axis=0), 1.0)
        rim = np.unique(corners)
        tree = cKDTree(self._points[rim])
        middles = self._points[corners].mean(axis=1)
        reach = np.linalg.norm(self._points[corners] - middles[:, None], axis=2).max(axis=1)
        hanging, first = 0, np.zeros(3)
        for start in range(0, len(corners), 2000):
            some = slice(start, start + 2000)
            near = tree.query_ball_point(middles[some], reach[some])
            face = np.repeat(np.arange(len(near)), [len(each) for each in near])
            node = rim[np.concatenate([np.array(each, dtype=int) for each in near])]
            inside = on_faces(self._points[corners[some][face]], self._points[node])
            inside &= (corners[some][face] != node[:, None]).all(axis=1)
            if inside.any() and not hanging:
                first = self._points[node[inside.argmax()]]
            hanging += len(np.unique(node[inside]))
        if hanging:
            raise self._refused("hanging", first, hanging)

    def _sides_of(self, faces: NDArray[np.int64]) -> NDArray[np.int64]:
        """Side of each outer face, -1 for others; sides must be complete and level."""
        beyond = self.beyond(self._points[:, :2]).max(axis=1)
        if beyond.max() > NEAR:
            raise self._refused("outside", self._points[beyond.argmax()], beyond.max() * self.metres)
        corners = np.where(faces >= 0, faces, faces[:, :1])
        on_side = np.abs(self.beyond(self._points[corners.ravel(), :2])) < NEAR
        on_side = on_side.reshape(*corners.shape, -1).all(axis=1)
        side = np.where(on_side.any(axis=1), on_side.argmax(axis=1), -1)
        places, lengths = self._points[corners], np.linalg.norm(np.diff(self.pieces, axis=1)[:, 0], axis=1)
        across = np.cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1])
        area = 0.5 * np.linalg.norm(across, axis=1)
        heights = []
        for number, length in enumerate(lengths):
            here = side == number
            z = places[here][:, :, 2]
            depth = np.ptp(z) if here.any() else 0.0
            if not depth or abs(area[here].sum() - length * depth) > NEAR * length:
                ends = np.column_stack([self.pieces[number], [0.0, depth]])
                raise self._refused("side", ends, area[here].sum() / (length * max(depth, self.thickness)))
            heights.append((z.min(), z.max()))
            along = np.unique(np.round(places[here][:, :, :2].reshape(-1, 2) / SAME).astype(int), axis=0)
            if len(along) <= LEAST_ALONG:
                raise self._refused("coarse", np.column_stack([self.pieces[number], [0.0, depth]]))
        low, high = np.array(heights).T
        if np.ptp(low) > NEAR or np.ptp(high) > NEAR:
            raise self._refused("uneven", np.column_stack([self.corners, high]))
        if abs((high - low).mean() - self.thickness) > NEAR:
            raise RefusedMesh("thickness", number=float((high - low).mean()) * self.metres)
        self._points[:, 2] -= low.mean()
        self._origin[2] += low.mean()
        return side

    def _refuse_groups(
        self, side: NDArray[np.int64], element: NDArray[np.int64], with_material: Sequence[str]
    ) -> None:
        """Refuse groups without a material, except for the group along the sides, which is the plate."""
        beside = np.unique(self._part[element[side >= 0]])
        if len(beside) > 1:
            raise RefusedMesh("groups", text=" and ".join(self.parts[number] for number in beside))
        for number, name in enumerate(self.parts):
            if number != beside[0] and name not in with_material:
                raise RefusedMesh("bare", text=name)

    def _netgen(self, faces: NDArray[np.int64], side: NDArray[np.int64], part: NDArray[np.int64]) -> Any:
        """Netgen's mesh, with names of parts and sides as for solids."""
        from netgen import meshing

        mesh = meshing.Mesh(dim=3)
        mesh.AddPoints(np.ascontiguousarray(self._points))
        middle_of = dict[tuple[int, ...], int]()
        for kind, nodes in self._blocks:
            if kind == "tetra10":
                for (a, b), column in zip(EDGES["tetra"], nodes[:, 4:].T, strict=True):
                    ends = np.sort(nodes[:, [a, b]], axis=1)
                    middle_of |= dict(zip(map(tuple, ends.tolist()), column.tolist(), strict=True))
        kinds, of_kind = np.unique(np.stack([side, part], axis=1), axis=0, return_inverse=True)
        for number, (place, inside) in enumerate(kinds.tolist(), start=1):
            mesh.Add(meshing.FaceDescriptor(surfnr=number, domin=inside + 1, domout=0, bc=number))
            mesh.SetBCName(number - 1, f"side{place}" if place >= 0 else f"inner{number}")
            mine = faces[of_kind.ravel() == number - 1]
            triangles = mine[mine[:, 3] < 0, :3]
            middles = np.array(
                [[middle_of.get(tuple(sorted((face[a], face[b]))), -1) for a, b in OF_TRIANGLE]
                 for face in triangles.tolist()]
            ).reshape(-1, 3)  # fmt: skip
            curved = (middles >= 0).all(axis=1)
            _add(mesh, 2, number, triangles[~curved])
            _add(mesh, 2, number, np.hstack([triangles, middles])[curved])
            _add(mesh, 2, number, mine[mine[:, 3] >= 0])
        ends = np.cumsum([len(nodes) for _, nodes in self._blocks])
        for number in range(len(self.parts)):
            for (kind, nodes), part_of in zip(self._blocks, np.split(self._part, ends[:-1]), strict=True):
                columns = NETGENS_TETRA if kind == "tetra10" else slice(None)
                _add(mesh, 3, number + 1, nodes[part_of == number][:, columns])
            mesh.SetMaterial(number + 1, f"part{number}")
        return mesh

    def _refuse_folded(self, mesh: Any) -> None:
        """Refuse quadratic tetrahedra that are turned inside out by their curved edges."""
        import ngsolve as ng

        kinds = {kind for kind, _ in self._blocks}
        if "tetra10" not in kinds:
            return
        if other := next(iter(kinds - {"tetra", "tetra10"}), None):
            raise RefusedMesh("curved", text=f"tetrahedra beside elements of the kind {other}")
        rule = ng.IntegrationRule(ng.TET, 4)
        there = mesh.MapToAllElements(rule, ng.VOL)
        folded = np.array(ng.Det(ng.specialcf.JacobianMatrix(3, 3))(there)).ravel() > 0.0
        if folded.any():
            place = np.array(ng.CF((ng.x, ng.y, ng.z))(there))[folded.argmax()]
            elements = float(folded.reshape(-1, len(rule)).any(axis=1).sum())
            raise self._refused("degenerate", place, elements)


def _add(mesh: Any, dimension: int, index: int, nodes: NDArray[np.int64]) -> None:
    if len(nodes):
        mesh.AddElements(dim=dimension, index=index, data=np.ascontiguousarray(nodes, dtype=np.int32))
