"""Unit cells: what they are made of, and their block-structured meshes."""

from haptonic.cell.geometry import Pillar, UnitCell
from haptonic.cell.mesh import HexMesh, MeshPlan, Topology, mesh_cell

__all__ = ["HexMesh", "MeshPlan", "Pillar", "Topology", "UnitCell", "mesh_cell"]
