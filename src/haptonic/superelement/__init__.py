"""Superelements: stiffness and mass of a cell condensed onto its lateral faces."""

from haptonic.solvers import definite
from haptonic.superelement.condense import Superelement, condense, condensed, on_each
from haptonic.superelement.dynamic import DynamicStiffness, dynamic_stiffness
from haptonic.superelement.folded import FoldedMesh, through_levels
from haptonic.superelement.interior import CraigBampton, with_all_modes
from haptonic.superelement.joint import Joint, JointImage, repeated, steps_between
from haptonic.superelement.solid import condense_solid
from haptonic.superelement.substructured import condense_by_parts
from haptonic.superelement.surplus import missing_energy
from haptonic.superelement.tiling import TiledMesh, Tiling, whole_mesh
from haptonic.superelement.trace import TraceOperation

__all__ = [
    "CraigBampton",
    "DynamicStiffness",
    "FoldedMesh",
    "Joint",
    "JointImage",
    "Superelement",
    "TiledMesh",
    "Tiling",
    "TraceOperation",
    "condense",
    "condense_by_parts",
    "condense_solid",
    "condensed",
    "definite",
    "dynamic_stiffness",
    "missing_energy",
    "on_each",
    "repeated",
    "steps_between",
    "through_levels",
    "whole_mesh",
    "with_all_modes",
]
