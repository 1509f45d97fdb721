"""Materials: elastic constants, density and loss, with sources and uncertainties."""

from haptonic.materials.common import elasticity_tensor, is_symmetry
from haptonic.materials.isotropic import IsotropicMaterial
from haptonic.materials.library import GIVEN, Material, built_in_name, library, material
from haptonic.materials.orthotropic import OrthotropicMaterial
from haptonic.materials.piezoelectric import PiezoelectricMaterial

__all__ = [
    "GIVEN",
    "IsotropicMaterial",
    "Material",
    "OrthotropicMaterial",
    "PiezoelectricMaterial",
    "built_in_name",
    "elasticity_tensor",
    "is_symmetry",
    "library",
    "material",
]
