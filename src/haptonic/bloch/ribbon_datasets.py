"""Modes of a ribbon, and the bulk bands of its crystals, as labelled arrays."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.guided import decay, harmonics, in_gap, outermost, within
from haptonic.bloch.ribbon import RibbonModel, RibbonModes
from haptonic.gate import declared
from haptonic.later import xarray as xr


def ribbon_dataset(
    model: RibbonModel, found: Sequence[RibbonModes], bulk: Array, rows: int | None
) -> xr.Dataset:
    """Every mode, along ``mode``, with its place between the bulk bands and where its energy is.

    Parameters
    ----------
    found : modes at one wavevector after the other; bulk : (crystals, wavevectors, bands, 2) Hz
    rows : length in cells of a guide with free ends, if there is one
    """
    ribbon = model.ribbon
    pieces = []
    for number, modes in enumerate(found):
        share = modes.energy / modes.energy.sum(axis=(1, 2), keepdims=True)
        inside, there = within(modes.energy, ribbon.guide), in_gap(modes, bulk[:, number])
        wavenumber, across = harmonics(ribbon, model.fine, modes)
        pieces.append({
            "phase": np.full(len(modes.frequency), modes.kappa),
            "frequency": modes.frequency,
            "frequency_error": modes.error,
            "group_velocity": 2 * np.pi * ribbon.period * modes.slope,
            "guide_share": inside,
            "cell_share": share,
            "in_gap": there.astype(np.int8),
            "guided": (there & (inside > within(modes.energy, outermost(ribbon)))).astype(np.int8),
            "decay": np.where(there, decay(ribbon, modes.energy), np.nan),
            "wavenumber": wavenumber,
            "nodal_lines": across,
            "intervals": wavenumber * (rows or np.nan) * ribbon.period / np.pi - 0.5,
        })  # fmt: skip
    joined = {name: np.concatenate([one[name] for one in pieces]) for name in pieces[0]}
    of_cells = ("mode", "line", "column")
    dataset = xr.Dataset({name: (of_cells[: values.ndim], values) for name, values in joined.items()})
    dataset["phase_share"] = dataset["phase"] / np.pi
    words = {
        "phase": ("rad", "phase of the wave from one period of the ribbon to the next"),
        "phase_share": ("1", "the same over pi"),
        "frequency": ("Hz", "frequency"),
        "frequency_error": ("Hz", "bound of the frequency's error"),
        "group_velocity": ("m/s", "group velocity along the ribbon"),
        "guide_share": (
            "1",
            "share of energy in the guide or defect, or in the cells on either side of an edge",
        ),
        "cell_share": ("1", "share of energy in each cell, lines from the bottom up"),
        "in_gap": ("1", "1 between the bulk bands at this phase"),
        "guided": ("1", "1 if so, and more energy is in the guide than in the outermost columns"),
        "decay": ("dB/row", "decay of the energy away from the guide"),
        "wavenumber": ("rad/m", "of the strongest harmonic of the normal motion along the guide"),
        "nodal_lines": ("1", "nodal lines of the normal motion across the guide"),
        "intervals": ("1", "intervals between nodal lines along a guide of the given length"),
    }
    for name, (unit, title) in words.items():
        dataset[name].attrs = {"units": unit, "long_name": title}
    return declared(
        dataset,
        decay="a mode within a bulk band, or fewer than two rows to compare",
        wavenumber="tiles without sides along the ribbon, or several lines of cells",
        nodal_lines="no guide of one line, or tiles without sides along the ribbon",
        intervals="no length in cells was given, or tiles without sides along the ribbon",
    )


def bulk_dataset(kappa: Array, bulk: Array, names: Sequence[Sequence[str]]) -> xr.Dataset:
    """Edges of the bulk bands at phases along a ribbon, and the names of its cells, a list for each line."""
    edges = ("crystal", "wavevector", "bulk_band")
    dataset = xr.Dataset(
        {
            "wavevector_phase": (
                "wavevector",
                kappa,
                {"units": "rad", "long_name": "phases along the ribbon"},
            ),
            "bulk_lower": (edges, bulk[..., 0], {"units": "Hz", "long_name": "lower edge of a bulk band"}),
            "bulk_upper": (edges, bulk[..., 1], {"units": "Hz", "long_name": "upper edge of a bulk band"}),
        }
    )
    return dataset.assign_coords(cell_name=(("line", "column"), np.array(names)))


def field_dataset(model: RibbonModel, chosen: xr.Dataset, found: Sequence[RibbonModes]) -> xr.Dataset:
    """The field of one mode on the flat face, in the direction of its largest, the ribbon along y."""
    modes = next(one for one in found if one.kappa == float(chosen["phase"]))
    number = int(np.abs(modes.frequency - float(chosen["frequency"])).argmin())
    tiling, ribbon = model.fine.tiling, model.ribbon
    points = tiling.points
    faces = tiling.linear_subcells()[:, :4]
    faces = faces[(np.abs(points[faces, 2]) < 1e-9 * ribbon.period).all(axis=1)]
    nodes, faces = np.unique(faces, return_inverse=True)
    faces = faces.reshape(-1, 4)
    motion = tiling.lifted(modes.fields[:, [number]])[nodes, :, 0]
    motion[:, :2] = motion[:, :2] @ ribbon.turn.T
    which = int(np.linalg.norm(motion, axis=0).argmax())
    field = motion[:, which]
    field = field / field[np.abs(field).argmax()]
    dataset = xr.Dataset(
        {
            "field_position": (("node", "axis"), points[nodes, :2] @ ribbon.turn.T),
            "field_triangle": (("triangle", "vertex"), np.concatenate([faces[:, :3], faces[:, [0, 2, 3]]])),
            "field_real": ("node", field.real),
            "field_imag": ("node", field.imag),
            "field_frequency": ((), float(chosen["frequency"])),
            "field_phase": ((), float(chosen["phase"])),
            "field_component": ((), which),
        }
    )
    for name, unit in (("field_position", "m"), ("field_frequency", "Hz"), ("field_phase", "rad")):
        dataset[name].attrs["units"] = unit
    for name in ("field_triangle", "field_real", "field_imag", "field_component"):
        dataset[name].attrs["units"] = "1"
    return dataset
