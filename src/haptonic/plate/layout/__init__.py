"""Layout of the plate: tiles, supports, drives, finger, regions and sampling points, without a mesh."""
