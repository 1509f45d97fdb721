"""Body of the plate: tiles meshed, reduced to their rims and assembled; matrices of stiffness and mass."""
