"""One period of a plate from the solids of a STEP file: cut along the sides of a tile and meshed by Netgen.

Lengths are in units of a tenth of the pitch; see `haptonic.foreign.solids`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

UNITS = 10.0  # length of the pitch in units
# units; places, heights and extents that differ less are equal; STEP files have six digits or more
SAME = 1e-4
SAME_VOLUME = 1e-5  # relative
SAME_SPACE = 1e-4  # relative: what the intersection of a body of ten units and its image may miss
# Mesh sizes: of elements away from edges, in thicknesses and pitches; along edges with singular stress, in
# thicknesses and shares of the edge's extent. For a pillar of 7 mm on 1.5 mm, elements of two thicknesses had
# an error of 0.8 % at order 3, elements of one thickness 0.2 %.
ELEMENTS, WIDEST_ELEMENT, ALONG_EDGE, OF_EDGE = 1.0, 0.25, 1.0, 0.15
GRADING, CURVATURE = 0.5, 1.0  # settings of Netgen: growth of elements, and elements around a curve
LAYERS = 0.2  # ratio of neighbouring layers of elements towards an edge
NEAR_EDGES = 2  # layers of elements at edges with singular stress that count as near them
STRAIGHT = np.radians(185.0)  # an edge with a larger solid angle about it is re-entrant


class FilledTile:
    """Tile that a file's bodies must fill, in units; and the reason if they do not, see `inspected`.

    blocks : polynomials of a trace along each side of the tile
    is_straight : True if round outlines are polygons
    """

    blocks = 2
    is_straight = False
    problem = ""
    number = 0.0
    text = ""
    place: NDArray[Any] = np.zeros(0)

    def __init__(self, tile: NDArray[Any], vectors: NDArray[Any], thickness: float) -> None:
        pitch = float(np.linalg.norm(vectors, axis=1).max())
        self.metres = pitch / UNITS
        self.corners, self.vectors = tile / self.metres, vectors / self.metres
        self.thickness = thickness / self.metres

    @property
    def pieces(self) -> NDArray[Any]:
        """(blocks sides, 2, 2) ends of the pieces of the sides, anticlockwise from the first corner."""
        following = np.roll(self.corners, -1, axis=0)
        shares = np.arange(self.blocks)[:, None] / self.blocks
        starts = (self.corners[:, None] + shares * (following - self.corners)[:, None]).reshape(-1, 2)
        return np.stack([starts, np.roll(starts, -1, axis=0)], axis=1)

    def in_planes(self, places: NDArray[Any]) -> NDArray[Any]:
        """Numbers of the pieces of sides whose planes contain all places (n, 2)."""
        return np.flatnonzero(np.abs(self.beyond(places)).max(axis=0) < SAME)

    def beyond(self, places: NDArray[Any]) -> NDArray[Any]:
        """(n, pieces) distances of places (n, 2) from the planes of the pieces, above zero outside."""
        start, end = self.pieces.swapaxes(0, 1)
        along = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
        normal = np.stack([along[:, 1], -along[:, 0]], axis=1)
        return np.asarray(np.einsum("nsc,sc->ns", places[:, None] - start, normal))


class DrawnPeriod(FilledTile):
    """Solids of one period, cut along the sides of the tile."""

    def __init__(self, path: str, tile: NDArray[Any], vectors: NDArray[Any], thickness: float) -> None:
        from netgen import occ

        super().__init__(tile, vectors, thickness)
        whole = occ.OCCGeometry(path).shape.Scale(occ.Pnt(0, 0, 0), 1e-3 / self.metres)
        solids = list(whole.solids)
        self.names = [str(solid.name or f"solid{number}") for number, solid in enumerate(solids, start=1)]
        self.volumes = [float(solid.mass) for solid in solids]
        self.parts: list[Any] = []
        self.body: Any = None
        self.mesh: Any = None  # of Netgen, if the solids form a period
        self.singular: set[str] = set()  # names of edges with singular stress, once there is a mesh
        if not solids:
            self.problem = "empty"
            return
        low, high = whole.bounding_box
        extent = np.array([high.x - low.x, high.y - low.y, high.z - low.z]) * self.metres
        first = None
        for origin in _origins(whole, solids):
            self._cut([solid.Move(occ.Vec(-origin[0], -origin[1], 0.0)) for solid in solids])
            if not self.problem:
                self._make_mesh()
                return
            first = first or (self.problem, self.number)
        assert first is not None
        self.problem, self.number = first
        self.place = extent

    def _make_mesh(self) -> None:
        """Mesh the period; if this fails, `problem` is the reason."""
        from netgen.meshing import NgException

        try:
            self.mesh = _meshed(self)
        except NgException as error:
            self.problem, self.text = "unmeshed", str(error)

    @property
    def part_names(self) -> list[str]:
        return self.names

    @property
    def elements(self) -> float:
        """Number of elements before refinement."""
        return float(len(self.mesh.Elements3D()))

    def elements_of(self, order: int, rings: int) -> Any:
        """NGSolve's mesh, refined towards edges with singular stress."""
        import ngsolve as ng

        mesh = ng.Mesh(self.mesh.Copy())
        mesh.RefineHP(rings, factor=LAYERS)
        mesh.Curve(order)
        return mesh

    def near_edges(self, mesh: Any) -> Any:
        """Elements of a refined mesh near edges with singular stress, by `NEAR_EDGES`."""
        import ngsolve as ng

        there = {
            vertex.nr - 1
            for segment in mesh.ngmesh.Elements1D()
            if str(mesh.ngmesh.EdgeDescriptor(segment.index).name) in self.singular
            for vertex in segment.vertices
        }
        near = ng.BitArray(mesh.ne)
        near.Clear()
        for _ in range(NEAR_EDGES):
            touching = [
                element
                for element in mesh.Elements(ng.VOL)
                if any(vertex.nr in there for vertex in element.vertices)
            ]
            for element in touching:
                near.Set(element.nr)
            there.update(vertex.nr for element in touching for vertex in element.vertices)
        return near

    def _cut(self, solids: Sequence[Any]) -> None:
        """Cut the repeated solids along the tile's sides; if this fails, `problem` is the reason."""
        from netgen import occ

        low, high = (min(s.bounding_box[0].z for s in solids), max(s.bounding_box[1].z for s in solids))
        outline = [occ.Pnt(x, y, low - 1.0) for x, y in self.pieces[:, 0].tolist()]
        edges = [occ.Segment(*ends) for ends in zip(outline, [*outline[1:], outline[0]], strict=True)]
        prism = occ.Prism(occ.Face(occ.Wire(edges)), occ.Vec(0, 0, high - low + 2.0))
        self.problem = ""
        parts = []
        for solid in solids:
            part = prism * solid
            if abs(part.mass - solid.mass) > SAME_VOLUME * solid.mass:
                repeated = solid
                for step in product((-1, 0, 1), repeat=2):
                    move = np.array(step) @ self.vectors
                    if any(step) and self._reaches(solid, move):
                        repeated = repeated + solid.Move(occ.Vec(move[0], move[1], 0.0))
                part = prism * repeated  # in this order: a union joins the two halves of a side
            parts.append(part)
        self.parts = parts
        off = [abs(part.mass / volume - 1.0) for part, volume in zip(parts, self.volumes, strict=True)]
        if max(off) > SAME_VOLUME:
            worst = int(np.argmax(off))
            self.problem, self.number = "period", float(parts[worst].mass / self.volumes[worst])
            return
        floor = self._floor(parts)
        if floor is None:
            return
        for number, part in enumerate(parts):
            parts[number] = part.Move(occ.Vec(0, 0, -floor))
            for solid in parts[number].solids:
                solid.name = f"part{number}"
        self.body = occ.Glue(parts) if len(parts) > 1 else parts[0]
        if abs(self.body.mass - sum(part.mass for part in parts)) > SAME_VOLUME * self.body.mass:
            self.problem = "overlap"
        elif (pieces := _pieces(self.body)) > 1:
            self.problem, self.number = "pieces", float(pieces)

    def _reaches(self, solid: Any, move: NDArray[Any]) -> bool:
        """True if the bounding box of a moved solid meets that of the tile."""
        low, high = solid.bounding_box
        box = np.array([[low.x, low.y], [high.x, high.y]]) + move
        return bool((box[1] > self.corners.min(axis=0)).all() and (box[0] < self.corners.max(axis=0)).all())

    def piece_of(self, face: Any) -> int | None:
        """Number of the side piece that contains a face; None for a face inside the tile."""
        centre = np.array([face.center.x, face.center.y])
        vertices = [[vertex.p.x, vertex.p.y] for vertex in face.vertices]
        for number in self.in_planes(np.array([*vertices, centre])).tolist():
            start, end = self.pieces[number]
            if 0.0 <= (centre - start) @ (end - start) <= (end - start) @ (end - start):
                return int(number)
        return None

    def _floor(self, parts: Sequence[Any]) -> float | None:
        """Height of the plate's lower face, from its lateral faces; None if these are not complete."""
        count = len(self.pieces)
        area, low, high = np.zeros(count), np.full(count, np.inf), np.full(count, -np.inf)
        beside = set()  # numbers of the parts at the sides
        for position, part in enumerate(parts):
            for face in part.faces:
                number = self.piece_of(face)
                if number is not None:
                    beside.add(position)
                    heights = [vertex.p.z for vertex in face.vertices]
                    area[number] += face.mass
                    low[number], high[number] = min(low[number], *heights), max(high[number], *heights)
        length = np.linalg.norm(self.pieces[:, 1] - self.pieces[:, 0], axis=1)
        depth = high - low
        whole = np.abs(area - length * depth) < SAME * UNITS * length
        level = np.ptp(low) < SAME * UNITS and np.ptp(high) < SAME * UNITS
        if not (np.isfinite(depth).all() and whole.all() and level):
            self.problem = "sides"
            return None
        if abs(depth.mean() - self.thickness) > SAME * UNITS:
            self.problem, self.number = "thickness", float(depth.mean() * self.metres)
            return None
        if len(beside) > 1:
            self.problem = "materials"
            return None
        return float(low.mean())

    def is_kept(self, turn: NDArray[Any]) -> bool:
        """True if a map of the plane maps each part to itself: both occupy the same space."""
        from netgen import occ

        angle = float(np.arctan2(turn[1, 0], turn[0, 0]))
        mirrored = bool(np.linalg.det(turn) < 0)
        normal = occ.Dir(-np.sin(angle / 2), np.cos(angle / 2), 0.0)  # of the mirror
        for part in self.parts:
            if mirrored:
                image = part.Mirror(occ.Axes((0, 0, 0), normal))
            else:
                image = part.Rotate(occ.Axis((0, 0, 0), occ.Z), np.degrees(angle))
            common = part * image
            if abs(common.mass - part.mass) > SAME_SPACE * part.mass:
                return False
        return True


def _pieces(body: Any) -> int:
    """Number of pieces that no faces join; glued solids share the faces where they touch."""
    left = [set(solid.faces) for solid in body.solids]
    pieces = 0
    while left:
        piece, pieces = left.pop(), pieces + 1
        while joined := [faces for faces in left if faces & piece]:
            piece = piece.union(*joined)
            left = [faces for faces in left if faces not in joined]
    return pieces


def _origins(whole: Any, solids: Sequence[Any]) -> Iterator[NDArray[Any]]:
    """Possible centres of the tile: centre of mass, of the box, its corners, the origin of the drawing."""
    mass = np.array([solid.mass for solid in solids])
    centres = np.array([[solid.center.x, solid.center.y] for solid in solids])
    low, high = ((box.x, box.y) for box in whole.bounding_box)
    places = [
        mass @ centres / mass.sum(),
        0.5 * (np.array(low) + high),
        *product(*zip(low, high, strict=True)),
        (0, 0),
    ]
    yield from (np.round(np.asarray(place, dtype=float), 9) for place in places)


def _meshed(period: DrawnPeriod) -> Any:
    """Mesh of tetrahedra, small along edges with singular stress, which are marked for `RefineHP`."""
    from netgen import occ

    body = period.body
    size = min(ELEMENTS * period.thickness, WIDEST_ELEMENT * UNITS)
    for number, face in enumerate(body.faces):
        side = period.piece_of(face)
        face.name = f"inner{number}" if side is None else f"side{side}"
    edges = list(body.edges)
    for number, edge in enumerate(edges):
        edge.name = f"edge{number}"
    coarse = occ.OCCGeometry(body).GenerateMesh(maxh=size, grading=GRADING, curvaturesafety=CURVATURE)
    singular = _singular(coarse, period)
    period.singular = {f"edge{number}" for number in singular}
    for number in singular:
        low, high = edges[number].bounding_box
        extent = max(high.x - low.x, high.y - low.y, high.z - low.z)
        edges[number].hpref = 1
        edges[number].maxh = min(
            ALONG_EDGE * period.thickness, max(OF_EDGE * extent, 0.1 * period.thickness), size
        )
    return occ.OCCGeometry(body).GenerateMesh(maxh=size, grading=GRADING, curvaturesafety=CURVATURE)


def _singular(mesh: Any, period: DrawnPeriod) -> list[int]:
    """Numbers of edges with more than half a turn of solid about them, or between two solids.

    The angles are those of the tetrahedra of a coarse mesh at its segments on the edge.
    """
    points = np.array([point.p for point in mesh.Points()])
    corners = np.array([[vertex.nr - 1 for vertex in element.vertices] for element in mesh.Elements3D()])
    domain = np.array([element.index for element in mesh.Elements3D()])
    of_point: dict[int, set[int]] = {}
    for number, element in enumerate(corners.tolist()):
        for corner in element:
            of_point.setdefault(corner, set()).add(number)
    seen: dict[int, tuple[float, bool]] = {}
    for segment in mesh.Elements1D():
        edge = int(str(mesh.EdgeDescriptor(segment.index).name).removeprefix("edge"))
        first, second = (vertex.nr - 1 for vertex in segment.vertices)
        if edge in seen or len(period.in_planes(points[[first, second], :2])):
            continue
        around = sorted(of_point[first] & of_point[second])
        angle = sum(_dihedral(points, corners[number], first, second) for number in around)
        seen[edge] = (angle, len(set(domain[around].tolist())) > 1)
    return [edge for edge, (angle, shared) in seen.items() if angle > STRAIGHT or shared]


def _dihedral(points: NDArray[Any], element: NDArray[Any], first: int, second: int) -> float:
    """Angle of a tetrahedron at the edge between two of its corners, rad."""
    axis = points[second] - points[first]
    axis /= np.linalg.norm(axis)
    others = [points[corner] - points[first] for corner in element.tolist() if corner not in (first, second)]
    across = [other - (other @ axis) * axis for other in others]
    cosine = across[0] @ across[1] / (np.linalg.norm(across[0]) * np.linalg.norm(across[1]))
    return float(np.arccos(np.clip(cosine, -1.0, 1.0)))
