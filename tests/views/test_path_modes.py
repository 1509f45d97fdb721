"""Modes of the whole path: against the modes of single wavevectors, as bytes, and on a page."""

import json
import struct

import numpy as np
import pytest

from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.path_modes import path_modes
from haptonic.bloch.tracking import diagram
from haptonic.later import xarray as xr
from haptonic.study import loads
from haptonic.views import InteractiveView, packed
from quick import QUICK_CELL


@pytest.fixture(scope="module")
def study():
    return loads(QUICK_CELL)


@pytest.fixture(scope="module")
def modes(study):
    model = bloch_model(study.cell, study.bands_settings)
    return path_modes(model, diagram(model, study.cell.zone.path(study.bands_settings.points)))


def field(modes: xr.Dataset, row: int, band: int) -> np.ndarray:
    """(nodes, 3) displacement of a mode."""
    amounts = modes["path_mode_real"][row, band].values + 1j * modes["path_mode_imag"][row, band].values
    return np.einsum("s,snx->nx", amounts, modes["path_shape"].values)


def test_modes_of_the_path_are_those_of_its_wavevectors(study, modes):
    model = bloch_model(study.cell, study.bands_settings)
    path = study.cell.zone.path(study.bands_settings.points)
    points = model.fine.tiling.points
    order = {tuple(point): number for number, point in enumerate(np.round(points * 1e9).astype(int))}
    skin = [order[tuple(point)] for point in np.round(modes["skin_position"].values * 1e9).astype(int)]
    for row in (1, 5, 7, 11):
        solution = model.solve(path.kappa[row])
        every = model.displacement(solution)[skin]
        alone = np.diff(solution.frequency, prepend=-1e9, append=1e9)
        for band in range(model.count):
            if min(alone[band], alone[band + 1]) < 1.0:  # any combination of degenerate modes is one
                continue
            own, other = field(modes, row, band).ravel(), every[..., band].ravel()
            factor = np.vdot(own, other) / np.vdot(own, own)
            assert np.abs(other - factor * own).max() < 1e-3 * np.abs(other).max()


def test_every_mode_has_the_largest_displacement_one(modes):
    for row in range(modes.sizes["wavevector"]):
        for band in range(modes.sizes["band"]):
            largest = np.linalg.norm(field(modes, row, band), axis=1).max()
            assert largest == pytest.approx(1.0, abs=1e-3)


def test_opposite_sides_of_a_cell_differ_by_the_bloch_phase(study, modes):
    position = modes["skin_position"].values
    path = study.cell.zone.path(study.bands_settings.points)
    pitch = study.cell.lattice.pitch
    left = np.flatnonzero(np.abs(position[:, 0] - position[:, 0].min()) < 1e-9)
    for row in (3, 8):
        turn = np.exp(1j * path.kappa[row][0])
        for band in (0, 3):
            moved = field(modes, row, band)
            for node in left[::7]:
                away = np.linalg.norm(position - position[node] - [pitch, 0.0, 0.0], axis=1)
                assert away.min() < 1e-9
                np.testing.assert_allclose(moved[away.argmin()], turn * moved[node], atol=1e-3)


def test_bands_from_the_store_have_the_same_modes(study):
    first, again = (study.bands(html=True).dataset for _ in range(2))
    xr.testing.assert_identical(first, again)


def unpacked(content: bytes) -> tuple[dict, dict[str, np.ndarray]]:
    (length,) = struct.unpack_from("<I", content)
    header = json.loads(content[4 : 4 + length])
    front = -(-(4 + length) // 8) * 8
    arrays = {}
    for name, about in header["variables"].items():
        if "texts" in about:
            arrays[name] = np.array(about["texts"])
            continue
        kind = np.dtype(about["type"])
        values = np.frombuffer(content, kind, int(np.prod(about["shape"])), front + about["start"])
        arrays[name] = values.reshape(about["shape"]) * about.get("scale", 1)
    return header, arrays


def test_a_packed_view_contains_the_numbers_of_its_dataset(modes):
    short = ["path_shape"]
    header, arrays = unpacked(
        packed(
            InteractiveView(kind="bands", title="A title", dataset=modes, extra={"a": ["word"]}, short=short)
        )
    )
    assert (header["kind"], header["title"], header["extra"]) == ("bands", "A title", {"a": ["word"]})
    assert arrays.keys() == set(modes.variables)
    for name, values in arrays.items():
        exact = modes[name].values
        if name in short:
            assert np.abs(values - exact).max() <= 0.501 * float(np.abs(exact).max()) / 32767
        else:
            np.testing.assert_array_equal(values, exact)
        assert header["variables"][name]["attrs"]["units"] == modes[name].attrs["units"]


def test_every_array_of_a_packed_view_begins_at_a_multiple_of_eight(modes):
    for title in ("", "é", "a longer title"):
        header, _ = unpacked(packed(InteractiveView(kind="bands", title=title, dataset=modes)))
        assert all(about["start"] % 8 == 0 for about in header["variables"].values())


def test_numbers_of_zero_and_empty_arrays_are_packed():
    data = xr.Dataset(
        {"zero": ("x", np.zeros(3)), "empty": ("y", np.zeros(0)), "text": ("z", np.array(["a"]))}
    )
    _, arrays = unpacked(
        packed(InteractiveView(kind="bands", title="", dataset=data, short=["zero", "empty"]))
    )
    assert arrays["zero"].tolist() == [0, 0, 0]
    assert arrays["empty"].size == 0
    assert arrays["text"].tolist() == ["a"]
