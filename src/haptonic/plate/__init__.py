"""The finite plate: tiles of lattice and plain plate, supports, drives, and how it all vibrates."""
