"""Solids of a CAD program, or a mesh, instead of pillars and discs: the file, and materials of its parts."""

from __future__ import annotations

import hashlib
import importlib.util
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.cell.solid_refusals import Unit, metres_of, no_period, other_format
from haptonic.errors import GeometryError, ResourceError, shown
from haptonic.fields import Aliases, described, meant, needed, problem, setting
from haptonic.foreign.process import Limits, ask
from haptonic.materials import GIVEN, Material

LARGEST_FILE = 200_000_000  # bytes
DRAWN = (".step", ".stp")
MESHES = (".msh", ".bdf", ".nas", ".inp", ".vtu", ".vtk")  # see `haptonic.foreign.elements`
SECONDS, MEMORY = 600.0, 12 * 2**30  # limits for a file: processor time, and bytes
MOST_PARTS = 64


@described("cell.solid.part", GeometryError)
class SolidPart:
    """Material of a solid, or of a group of a mesh."""

    name: str = needed(
        "Name of the solid in the file; unnamed ones are called solid1, solid2, ... in order. In a mesh, the "
        "name of the physical group or element set; those with a number only are property 3 (Nastran) and "
        "group 3 (Gmsh), or have the name of their array (VTK).",
        examples=["core"],
    )
    material: Annotated[Material, GIVEN] = needed(
        "A built-in name or its constants.", title="Material of the solid"
    )


@described("cell.solid", GeometryError)
class Solid:
    """One period of a plate from a STEP file of a CAD program, or from a mesh of another program.

    A STEP file may have any part of the lattice that fills the plane by repetition: a hexagon or a rhombus,
    with a pillar in its middle or at its corners. A mesh is used unchanged, and has to fill the cell: a
    rectangle, or on a triangular lattice a hexagon. The plate has to be complete along the sides of the cell,
    of one material, and as thick as in ``[cell]``.

    Raises
    ------
    GeometryError : a missing file, one of another format, or one whose content contradicts ``sha256``
    """

    aliases: ClassVar[Aliases] = {
        **meant("file", "path", "step", "cad", "name"),
        **meant("part", "parts", "material", "materials", "solid"),
        **meant("unit", "units", "scale", "length_unit"),
    }

    file: str = needed(
        "A STEP file or a mesh (Gmsh .msh, Nastran .bdf and .nas, Abaqus .inp, .vtu, .vtk), its path counted "
        "from the study's folder.",
        title="CAD file or mesh",
        min_length=1,
        examples=["cell.step"],
    )
    sha256: str = setting(
        "",
        "SHA-256 of the file. haptonic fills it in; a given value must agree.",
        title="Hash of the file",
        examples=["9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"],
    )
    part: tuple[SolidPart, ...] = setting(
        (),
        "Materials of the file's solids, of which those without a table are of the material of the plate; or "
        "of all groups of a mesh but that along the sides of the cell.",
        title="Materials of solids",
        max_length=MOST_PARTS,
    )
    unit: Unit = setting(
        "mm", "Unit of the lengths in a mesh. A STEP file gives its own.", title="Unit of a mesh"
    )

    def __post_init__(self) -> None:
        path = Path(self.file)
        if path.suffix.lower() not in DRAWN + MESHES:
            raise other_format(self.file, path.suffix.lower(), DRAWN + MESHES)
        if not self.is_mesh and self.unit != "mm":
            raise problem(
                "conflict", f'unit = "{self.unit}"', "a unit for a mesh",
                "a STEP file gives the unit of its lengths itself",
                "leave unit out, or export the file again in the right unit", at="unit",
            )  # fmt: skip
        try:
            size = path.stat().st_size if path.is_file() else -1
            content = path.read_bytes() if 0 <= size <= LARGEST_FILE else b""
        except OSError as error:
            raise _unread(self.file, f"the system reports: {error.strerror}") from None
        if size < 0:
            raise _unread(self.file, "there is no such file")
        if size > LARGEST_FILE:
            raise _unread(self.file, f"it is larger than {LARGEST_FILE // 10**6} MB")
        digest = hashlib.sha256(content).hexdigest()
        if self.sha256 and self.sha256 != digest:
            raise problem(
                "mismatch",
                shown(self.sha256, 80),
                digest,
                "the file was changed after its hash was written down",
                "leave sha256 out to take the file as it is, or bring the older file back",
                at="sha256",
            )
        names = [part.name for part in self.part]
        if (twice := next((name for name in names if names.count(name) > 1), None)) is not None:
            raise problem(
                "repeated", shown(twice), "a table for each solid", "a solid has two materials",
                "leave one of the tables out", at="part",
            )  # fmt: skip
        object.__setattr__(self, "sha256", digest)

    def period(self, tile: Array, vectors: Array, thickness: float, turns: Array) -> SolidPeriod:
        """Read the solids as one period of a plate.

        Parameters
        ----------
        tile : (sides, 2) corners of the repeated polygon, m
        vectors : (2, 2) translations, m
        thickness : of the plate, m
        turns : (n, 2, 2) maps of the plane that may leave the solids unchanged

        Raises
        ------
        GeometryError : solids that form no period of such a plate
        ChannelError, ResourceError : the file cannot be read, or the libraries for it are not installed
        """
        answer = self.ask("inspected", tile, vectors, thickness, turns=turns)
        names = list(answer["names"])
        unknown = {part.name for part in self.part}.difference(names)
        if unknown and (names or not answer["problem"]):
            noun = "group" if self.is_mesh else "solid"
            raise GeometryError.unknown(
                known=names,
                argument="cell.solid.part.name",
                given=min(unknown),
                allowed=f"a {noun} of the file: {', '.join(map(shown, names)) or 'it has none'}",
                cause=f"no {noun} has this name",
                next_step="write one of these names; the program that made the file may show others",
            )
        if answer["problem"]:
            raise no_period(answer, thickness, self.unit if self.is_mesh else "")
        return SolidPeriod(
            names=tuple(answer["parts"]),
            volumes=np.array(answer["volumes"]),
            kept=np.asarray(answer["kept"], dtype=bool),
            elements=float(answer["elements"]),
            whole_below=bool(answer["whole_below"]),
            straight=bool(answer["straight"]),
        )

    @property
    def is_mesh(self) -> bool:
        """True for a mesh, which is used unchanged."""
        return Path(self.file).suffix.lower() in MESHES

    @property
    def materials(self) -> dict[str, Material]:
        """Materials of the solids that have one, by their key in [cell]."""
        return {f"solid.part[{n}].material": part.material for n, part in enumerate(self.part, start=1)}

    def material_of(self, name: str, plate: Material) -> Material:
        """Material of the solid with a name; by default the plate's."""
        return next((part.material for part in self.part if part.name == name), plate)

    def ask(
        self, question: str, tile: Array, vectors: Array, thickness: float, **arguments: object
    ) -> dict[str, Any]:
        """Answer of `haptonic.foreign.solids` for the file in a tile; see `period`."""
        if importlib.util.find_spec("ngsolve") is None:
            raise ResourceError.not_installed(
                argument="cell.solid",
                given="a Python without ngsolve",
                allowed="a Python with the package ngsolve, which computes CAD files and meshes",
                cause="the extra for CAD files is not installed",
                next_step='run: pip install "haptonic[cad]"',
            )
        answer: dict[str, Any] = ask(
            f"solids.{question}",
            Path(self.file),
            limits=Limits(SECONDS, 4 * SECONDS, MEMORY),
            digest=self.sha256,
            tile=tile,
            vectors=vectors,
            thickness=thickness,
            unit=metres_of(self.unit) if self.is_mesh else 0.0,
            with_material=[part.name for part in self.part],
            **arguments,
        )
        return answer


@dataclass(frozen=True, eq=False)
class SolidPeriod:
    """Content of a file for one period.

    names, volumes : of its solids or the parts of a mesh, m^3
    kept : True for maps that leave them unchanged
    elements : number of tetrahedra with as many unknowns as their mesh
    whole_below : True if the plate's lower face is whole, and nothing lies below it
    straight : True for a mesh whose edges are all straight, so that round outlines are polygons
    """

    names: tuple[str, ...]
    volumes: Array
    kept: Bools
    elements: float
    whole_below: bool
    straight: bool


def _unread(file: str, cause: str) -> Exception:
    return problem(
        "not-found", shown(file, 100), "a file that can be read", cause,
        "check the path; it is counted from the folder of the study, in Python from the working directory",
        at="file",
    )  # fmt: skip
