"""Mode shapes written for other programs."""

import json

import meshio
import numpy as np
import pytest

from five_parts import refusing
from haptonic.errors import ResourceError
from haptonic.vtu import write_modes
from simulated import reference_bands


def test_what_is_written_is_read_back(tmp_path):
    bands = reference_bands()
    path = write_modes(tmp_path / "modes.vtu", bands)
    mesh = meshio.read(path)
    assert mesh.points == pytest.approx(bands["node_position"].values)
    assert (mesh.cells_dict["hexahedron"] == bands["subcell"].values).all()
    assert len(mesh.point_data) == 2 * bands.sizes["mode"]
    for k in (0, bands.sizes["mode"] - 1):
        name = f"M{k + 1} {float(bands['mode_frequency'][k]) / 1e3:.2f} kHz"
        for part, variable in (("real", "mode_real"), ("imaginary", "mode_imag")):
            assert (mesh.point_data[f"{name} {part}"] == bands[variable].values[k]).all()
    grids = json.loads(bands.attrs["element_grids"])
    expected = np.concatenate([np.full(number, np.prod(orders)) for number, *orders in grids])
    assert np.array_equal(np.unique(mesh.cell_data["element"][0], return_counts=True)[1], expected)


def test_every_hexahedron_has_a_positive_volume(tmp_path):
    mesh = meshio.read(write_modes(tmp_path / "modes.vtu", reference_bands()))
    corners = mesh.points[mesh.cells_dict["hexahedron"]]
    a, b, c = (corners[:, k] - corners[:, 0] for k in (1, 3, 4))
    assert (np.einsum("ij,ij->i", np.cross(a, b), c) > 0).all()


def test_a_file_is_not_replaced_unasked(tmp_path):
    path = tmp_path / "modes.vtu"
    path.write_text("mine")
    with refusing(ResourceError, "repeated", "output file"):
        write_modes(path, reference_bands())
    assert path.read_text() == "mine"
    write_modes(path, reference_bands(), overwrite=True)
    assert meshio.read(path).points.shape == (reference_bands().sizes["node"], 3)
