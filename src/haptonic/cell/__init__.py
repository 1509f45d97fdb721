"""Unit cells and their block-structured meshes."""

from haptonic.cell.brickwork import Brickwork
from haptonic.cell.disc import Disc
from haptonic.cell.geometry import UnitCell
from haptonic.cell.mesh import HexMesh, SurfaceMesh, mesh_cell
from haptonic.cell.pillar import Pillar
from haptonic.cell.pillar_parts import Step
from haptonic.cell.plan import MeshPlan
from haptonic.cell.ribbon import Ribbon
from haptonic.cell.rows import Filler, Rows
from haptonic.cell.sites import Site
from haptonic.cell.solid import Solid, SolidPart
from haptonic.cell.stack import Stack
from haptonic.cell.tile import FreeEdge, Period, PlacedTile, TileShape
from haptonic.cell.topology import Topology

__all__ = [
    "Brickwork",
    "Disc",
    "Filler",
    "FreeEdge",
    "HexMesh",
    "MeshPlan",
    "Period",
    "Pillar",
    "PlacedTile",
    "Ribbon",
    "Rows",
    "Site",
    "Solid",
    "SolidPart",
    "Stack",
    "Step",
    "SurfaceMesh",
    "TileShape",
    "Topology",
    "UnitCell",
    "mesh_cell",
]
