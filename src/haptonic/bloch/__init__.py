"""Bands, gaps and modes of the infinite lattice, computed from one small matrix pencil."""

from haptonic.bloch.bands import bands_dataset, gaps_dataset
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.gap_datasets import gaps_of
from haptonic.bloch.gaps import Gap
from haptonic.bloch.layers import Interface
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import Pencil, bloch_pencil
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import CondensedRows, attenuation
from haptonic.bloch.shapes import mode_shapes

__all__ = [
    "BlochModel",
    "CondensedRows",
    "Gap",
    "Interface",
    "Pencil",
    "Resolution",
    "attenuation",
    "bands_dataset",
    "bloch_model",
    "bloch_pencil",
    "gaps_dataset",
    "gaps_of",
    "mode_shapes",
]
