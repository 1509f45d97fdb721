"""The even grid on the face of a ribbon, which leans if the lattice is oblique."""

import numpy as np
import pytest
from matplotlib.tri import Triangulation

from haptonic.bloch.face_grid import FaceGrid

PER_COLUMN = 8  # elements of the made face along each side of a column


@pytest.mark.parametrize("columns", [1, 5, 10, 16])
@pytest.mark.parametrize(
    "lean", [-0.5, 0.0, 0.5]
)  # of a column along the ribbon, in periods: 0.5 if hexagonal
def test_every_point_of_a_leaning_ribbon_is_found(columns, lean):
    x, y = (
        side.ravel()
        for side in np.meshgrid(
            np.linspace(0, columns, PER_COLUMN * columns + 1), np.linspace(0, 1, 2 * PER_COLUMN + 1)
        )
    )
    leaning = np.column_stack([x, y + lean * x])
    grid = FaceGrid.of_strip(leaning, Triangulation(x, y).triangles, 1.0)
    assert grid.present.all()
    across = np.broadcast_to(grid.across[:, None], grid.present.shape)
    np.testing.assert_allclose(grid.values(leaning[:, :1] + 0j, [0.0])[0], across, atol=1e-9)
