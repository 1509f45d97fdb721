"""An anisotropic solid of tests: nine constants that differ, so that no two can be exchanged unseen."""

from dataclasses import replace

from haptonic.materials import OrthotropicMaterial

PLY = OrthotropicMaterial(
    name="ply",
    c11=20e9,
    c22=11e9,
    c33=9e9,
    c23=3e9,
    c13=2.5e9,
    c12=4e9,
    c44=3.1e9,
    c55=4.3e9,
    c66=5.7e9,
    density=1500.0,
)
SKEWED = replace(PLY, name="skewed ply", turn=0.4)  # no mirror at right angles to the plate is left
