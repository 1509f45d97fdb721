"""Materials: elastic constants, density and loss, each with its source and what is known of its spread."""

from haptonic.materials.common import elasticity_tensor, is_symmetry
from haptonic.materials.isotropic import IsotropicMaterial
from haptonic.materials.library import Material, library, material
from haptonic.materials.orthotropic import OrthotropicMaterial
from haptonic.materials.piezoelectric import PiezoelectricMaterial

__all__ = [
    "IsotropicMaterial",
    "Material",
    "OrthotropicMaterial",
    "PiezoelectricMaterial",
    "elasticity_tensor",
    "is_symmetry",
    "library",
    "material",
]
