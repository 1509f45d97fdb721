"""Bravais lattices of the plate: integer translations, and point groups.

Wavevectors are given by the phases ``kappa = (k . a1, k . a2)`` in radians, so that only the physical length
of a wavevector depends on the size of the cell.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from haptonic.arrays import Array
from haptonic.errors import GeometryError
from haptonic.fields import LARGEST, Quantity, Synonyms, described, handed_on, problem, remade, setting, size
from haptonic.names import listed
from haptonic.translations import SAME, check_vectors, recognised, shortest, vector_text, voronoi_cell
from haptonic.units import format_quantity

__all__ = ["Lattice", "PointGroup"]

Operation = tuple[tuple[int, int], tuple[int, int]]

HALF_TURN: Operation = ((-1, 0), (0, -1))
DIAGONAL: Operation = ((0, 1), (1, 0))

# ratio of a rectangle's periods: meshes need no larger one, and its square is far from 1 / SAME
MOST_ELONGATED = 1000.0
# shortest side of a six-sided cell, in radii of the inscribed circle; at 4e-5 the bands still agreed with
# those of the square that the cell nearly is
LEAST_SIDE = 1e-3
USUAL_ANGLE = (math.radians(20), math.radians(160))
# keys of a lattice besides the pitch
FURTHER: dict[str, tuple[str, ...]] = {
    "square": (), "rectangular": ("pitch_y",), "triangular": (), "centred": ("pitch_y",),
    "oblique": ("pitch_2", "angle"), "honeycomb": (), "kagome": (), "lieb": (),
}  # fmt: skip
Coordinate = Annotated[float, Quantity("m", at_least=-LARGEST, at_most=LARGEST)]
LETTERS = {0: "x", 90: "y", 135: "d"}  # names of mirrors, by the angle of their normals in degrees


@dataclass(frozen=True)
class PointGroup:
    """Rotations and mirrors of the plane that map a lattice, and everything on it, to itself.

    An operation is an integer matrix W that maps the lattice point ``n1 a1 + n2 a2`` to that of ``W n``. With
    the translations as rows of V it maps the plane by ``R = V^T W V^-T``, and the phases kappa of a
    wavevector to ``W^-T kappa``.

    vectors : a1 and a2, m; operations : closed under products
    """

    vectors: tuple[tuple[float, float], tuple[float, float]]
    operations: tuple[Operation, ...]

    def __contains__(self, operation: Operation) -> bool:
        return operation in self.operations

    def __len__(self) -> int:
        return len(self.operations)

    def turn(self, operation: Operation) -> Array:
        """(3, 3) orthogonal map of space for an operation; it keeps the plate's normal."""
        translations = np.array(self.vectors).T
        space = np.eye(3)
        space[:2, :2] = translations @ np.array(operation) @ np.linalg.inv(translations)
        near = np.round(space)  # rotations by right angles are exact
        return np.where(np.abs(space - near) < SAME, near, space)

    def kept(self, leaves: Callable[[Array], bool]) -> PointGroup:
        """The operations whose map of space (3, 3) also leaves another object unchanged, by ``leaves``."""
        return replace(self, operations=tuple(op for op in self.operations if leaves(self.turn(op))))

    def little_group(self, kappa: Array) -> PointGroup:
        """The operations that leave a wavevector unchanged up to a reciprocal lattice vector."""
        operations = []
        for op in self.operations:
            turns = (np.linalg.inv(np.array(op)).T @ kappa - kappa) / (2 * np.pi)
            if np.allclose(turns, np.round(turns), atol=SAME):
                operations.append(op)
        return replace(self, operations=tuple(operations))

    @property
    def mirrors(self) -> dict[str, Operation]:
        """All reflections, by the names of their normals: x, y, d, or an angle from the x axis.

        d is the reflection in the diagonal x = y.
        """
        mirrors = {}
        for op in self.operations:
            turn = self.turn(op)[:2, :2]
            if np.linalg.det(turn) < 0:  # 1 - 2 n n^T: its angle is twice that of n plus half a turn
                angle = round(math.degrees(0.5 * (math.atan2(turn[0, 1], turn[0, 0]) + math.pi))) % 180
                mirrors[LETTERS.get(angle, f"{angle}°")] = op
        return dict(sorted(mirrors.items(), key=lambda item: ("xyd".find(item[0]) % 4, item[0])))

    @property
    def distinct_mirrors(self) -> dict[str, Operation]:
        """Reflections that distinguish modes: those with a letter, and one of each further class.

        Reflections of one class are conjugate: a representation has the same character for them.
        """
        mirrors = self.mirrors
        distinct = {name: op for name, op in mirrors.items() if name in LETTERS.values()}
        for name, op in mirrors.items():
            if not any(self._conjugate(op, other) for other in distinct.values()):
                distinct[name] = op
        return distinct

    def _conjugate(self, first: Operation, second: Operation) -> bool:
        matrices = [np.array(op) for op in self.operations]
        return any(np.array_equal(g @ np.array(first), np.array(second) @ g) for g in matrices)


@described("cell", GeometryError, kw_only=True)
class Lattice:
    """Two translations ``a1``, ``a2`` in the plane of the plate, m; the shortest of the lattice.

    ``name`` is the name of the intended symmetry. A rectangle with equal sides keeps its name, so that a
    sweep of a side does not switch to another zone there. All geometric tolerances are relative to
    ``pitch``. A lattice from two vectors, ``Lattice(a1=..., a2=...)``, gets its name from them, see `named`;
    sites at shares refer to the given vectors.

    Raises
    ------
    GeometryError : a period that is not positive, missing, superfluous, or far longer than the other; a cell
        with six sides of which one is too short; vectors that span no plane, or whose lattice has no name
    """

    form: Annotated[
        Literal["square", "rectangular", "triangular", "centred", "oblique", "honeycomb", "kagome", "lieb"]
        | None,
        Synonyms(hexagonal="triangular"),
    ] = Field(
        alias="lattice",
        default="square",
        title="Lattice",
        description="Repetition of the cells in the plane; the last three have two or three sites. "
        '"hexagonal" is read as triangular.',
    )
    period: Annotated[float, size(100e-9, 100e-3)] | None = Field(
        alias="pitch",
        default=None,
        title="Pitch",
        description="Period of the lattice, along x if it is rectangular or centred. Neighbours are at 0.577 "
        "of it in a honeycomb, at half of it in kagome and Lieb. Required unless a1 and a2 are given.",
    )
    pitch_y: Annotated[float, size(100e-9, 100e-3)] | None = setting(
        None,
        "Period along y of a rectangular lattice, or of a centred one, with a pillar in the middle.",
        title="Pitch along y",
    )
    pitch_2: Annotated[float, size(100e-9, 100e-3)] | None = setting(
        None, "Length of the second translation of an oblique lattice.", title="Second pitch"
    )
    angle: Annotated[float, Quantity("rad", above=0.0, below=math.pi, typical=USUAL_ANGLE)] | None = setting(
        None,
        "Angle from the first pitch, along x, to the second one of an oblique lattice.",
        examples=["75 deg"],
    )
    first: tuple[Coordinate, Coordinate] | None = Field(
        alias="a1",
        default=None,
        title="First vector",
        description="Components along x and y, in place of a named lattice; its symmetry is detected.",
        examples=['["7 mm", "0 mm"]'],
    )
    second: tuple[Coordinate, Coordinate] | None = Field(
        alias="a2",
        default=None,
        title="Second vector",
        description="Components along x and y; see a1.",
        examples=['["3.5 mm", "6 mm"]'],
    )

    @model_validator(mode="before")
    @classmethod
    def _without_default(cls, given: Any) -> Any:
        """Remove the default name of a lattice that is given by vectors."""
        named = getattr(given, "kwargs", given)
        by_vectors = isinstance(named, dict) and any(named.get(key) is not None for key in ("a1", "a2"))
        return {"lattice": None, **named} if by_vectors else given

    def __post_init__(self) -> None:
        if self.first is not None or self.second is not None:
            self._check_vectors()
            return
        if self.period is None:
            raise problem(
                "missing", "nothing", "a pitch, or two vectors a1 and a2", "the pitch was left out",
                'add pitch = "7 mm"', at="pitch",
            )  # fmt: skip
        for field in ("pitch_y", "pitch_2", "angle"):
            value, needed = getattr(self, field), field in FURTHER[self.name]
            having = [name for name, others in FURTHER.items() if field in others]
            allowed = f"{field} for a lattice that is {listed(having, 'or')}, and for no other"
            if needed and value is None:
                raise problem("missing", "nothing", allowed, "it was left out", f"add {field}", at=field)
            if value is not None and not needed:
                given = format_quantity(value, "rad" if field == "angle" else "m")
                cause = f"a {self.name} lattice is given without it"
                names = listed([f'"{name}"' for name in having], "or")
                raise problem(
                    "conflict", given, allowed, cause, f"remove {field}, or write lattice = {names}", at=field
                )
        lengths = np.linalg.norm(self.vectors, axis=1)
        if lengths.max() > MOST_ELONGATED * lengths.min():
            raise problem(
                "out-of-range", " and ".join(format_quantity(float(length), "m") for length in lengths),
                f"periods whose ratio is at most {MOST_ELONGATED:g}",
                "the ratio is too large", "check their units", at=[*FURTHER[self.name], "pitch"][0],
            )  # fmt: skip
        if self.shortest_side < LEAST_SIDE:
            turned = ", turned by 45 deg with its sections" * (self.name == "centred")
            raise problem(
                "out-of-range",
                f"{self.name}, a side of its cell {self.shortest_side:.2g} radii of the inscribed circle",
                f"six sides, none shorter than {LEAST_SIDE:g} radii of the inscribed circle",
                "its points nearly form rectangles; so short a side cannot be meshed", "change a size by a "
                f'thousandth, or write lattice = "square" or "rectangular"{turned}', at="lattice",
            )  # fmt: skip

    def _check_vectors(self) -> None:
        given = {"lattice": self.form, "pitch": self.period, "pitch_y": self.pitch_y,
                 "pitch_2": self.pitch_2, "angle": self.angle}  # fmt: skip
        check_vectors(self.first, self.second, beside=[key for key in given if given[key] is not None])
        try:
            self.named  # noqa: B018
        except GeometryError as error:
            text = " and ".join(vector_text(vector) for vector in self.given)
            raise handed_on(error.changed(GeometryError, given=text, next_step="change them"), "a1") from None

    @cached_property
    def named(self) -> Lattice:
        """The lattice by name and sizes; the lattice itself unless it was given by vectors.

        Vectors within `MEANT` of those of a square or another named lattice get its symmetry and its sizes.
        """
        return self if self.first is None else Lattice(**dict[str, Any](recognised(self.given)))

    @property
    def name(self) -> str:
        """Name of the intended symmetry, or of the symmetry of the vectors."""
        assert self.named.form is not None
        return self.named.form

    @property
    def pitch(self) -> float:
        """Period along x, m."""
        assert self.named.period is not None
        return self.named.period

    def counted(self, shares: Array) -> Array:
        """(2,) shares of the translations, converted from shares of the given vectors, if any."""
        if self.first is None:
            return shares
        steps = np.round(self.given @ np.linalg.inv(self.vectors))
        converted = shares @ steps
        near = np.round(converted)
        return np.asarray(np.where(np.abs(converted - near) < SAME, near, converted) % 1.0)

    @classmethod
    def square(cls, pitch: float) -> Lattice:
        """Square lattice of period ``pitch`` (m)."""
        return cls(lattice="square", pitch=pitch)

    @classmethod
    def rectangular(cls, pitch: float, pitch_y: float) -> Lattice:
        """Rectangular lattice of periods ``pitch`` along x and ``pitch_y`` along y (m)."""
        return cls(lattice="rectangular", pitch=pitch, pitch_y=pitch_y)

    @classmethod
    def triangular(cls, pitch: float) -> Lattice:
        """Triangular lattice, also called hexagonal, of period ``pitch`` (m); a1 lies along x."""
        return cls(lattice="triangular", pitch=pitch)

    hexagonal = triangular

    @classmethod
    def centred(cls, pitch: float, pitch_y: float) -> Lattice:
        """Centred lattice: rectangles with these sides (m), with points at their corners and centres."""
        return cls(lattice="centred", pitch=pitch, pitch_y=pitch_y)

    @classmethod
    def oblique(cls, pitch: float, pitch_2: float, angle: float) -> Lattice:
        """Oblique lattice of two periods (m), the first along x, with an angle (rad) between them."""
        return cls(lattice="oblique", pitch=pitch, pitch_2=pitch_2, angle=angle)

    @cached_property
    def vectors(self) -> Array:
        """(2, 2) translations a1 and a2 as rows, m."""
        if self.named is not self:
            return self.named.vectors
        first = (self.pitch, 0.0)
        match self.name:
            case "triangular" | "honeycomb" | "kagome":
                return np.array([first, (0.5 * self.pitch, 0.5 * math.sqrt(3) * self.pitch)])
            case "centred":
                assert self.pitch_y is not None
                return shortest(np.array([first, (0.5 * self.pitch, 0.5 * self.pitch_y)]))
            case "oblique":
                assert self.pitch_2 is not None
                assert self.angle is not None
                second = (self.pitch_2 * math.cos(self.angle), self.pitch_2 * math.sin(self.angle))
                return shortest(np.array([first, second]))
        return np.array([first, (0.0, self.pitch_y or self.pitch)])

    @property
    def given(self) -> Array:
        """(2, 2) vectors that sites refer to, as rows, m: the given ones, or else `vectors`."""
        return self.vectors if self.first is None else np.array([self.first, self.second])

    @property
    def a1(self) -> tuple[float, float]:
        """First translation, m."""
        return float(self.vectors[0, 0]), float(self.vectors[0, 1])

    @property
    def a2(self) -> tuple[float, float]:
        """Second translation, m."""
        return float(self.vectors[1, 0]), float(self.vectors[1, 1])

    @property
    def is_rectangular(self) -> bool:
        """True if the translations lie along x and y."""
        return max(abs(self.a1[1]), abs(self.a2[0])) <= SAME * self.pitch

    def scaled(self, factor: float) -> Lattice:
        """The lattice with all periods multiplied by ``factor``."""
        periods = {name: getattr(self, name) for name in ("period", "pitch_y", "pitch_2")}
        vectors = {name: getattr(self, name) for name in ("first", "second")}
        return remade(
            self,
            **{name: value and value * factor for name, value in periods.items()},
            **{name: value and tuple(factor * part for part in value) for name, value in vectors.items()},
        )

    @property
    def area(self) -> float:
        """Area of the cell, m^2."""
        return float(abs(np.linalg.det(self.vectors)))

    @cached_property
    def _cell(self) -> tuple[tuple[tuple[int, int], ...], Array]:
        return voronoi_cell(self.vectors)

    @property
    def neighbours(self) -> tuple[tuple[int, int], ...]:
        """Translations across the sides of the cell, anticlockwise from the lowest side."""
        return self._cell[0]

    @property
    def corners(self) -> Array:
        """(sides, 2) corners of the cell about the origin, m, each at the beginning of its side."""
        return self._cell[1]

    @cached_property
    def inradius(self) -> float:
        """Distance from the centre of the cell to its nearest side, m."""
        return float(0.5 * np.linalg.norm(np.array(self.neighbours) @ self.vectors, axis=1).min())

    @cached_property
    def shortest_side(self) -> float:
        """Shortest side of the cell, in radii of the inscribed circle; 0 for four sides in place of six.

        Infinite for lattices whose cells never have a short side.
        """
        if self.name not in ("centred", "oblique"):
            return math.inf  # their sides cannot be too short
        sides = np.linalg.norm(self.corners - np.roll(self.corners, 1, axis=0), axis=1)
        return float(sides.min() / self.inradius) if len(sides) == 6 else 0.0

    @cached_property
    def point_group(self) -> PointGroup:
        """All operations of the intended symmetry, which leave the lattice unchanged."""
        metric = self.vectors @ self.vectors.T
        operations = []
        for a, b, c, d in product((1, 0, -1), repeat=4):  # sufficient for the shortest translations
            matrix = np.array([[a, b], [c, d]])
            if np.abs(matrix.T @ metric @ matrix - metric).max() < SAME * metric.max():
                operations.append(((a, b), (c, d)))
        return PointGroup((self.a1, self.a2), tuple(operations)).kept(self._is_meant)

    def _is_meant(self, turn: Array) -> bool:
        match self.name:
            case "rectangular" | "centred":
                return bool(turn[0, 1] == 0)
            case "oblique":
                return bool(turn[0, 1] == 0 and turn[0, 0] == turn[1, 1])
        return True

    def wavevector(self, kappa: Array) -> Array:
        """(..., 2) wavevectors in rad/m from (..., 2) phases: k . a_j = kappa_j."""
        return np.asarray(kappa) @ np.linalg.inv(self.vectors).T
