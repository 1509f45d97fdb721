"""Datasets of ribbon modes and of the bulk bands of the crystals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.face_grid import FlatFace, strongest
from haptonic.bloch.ribbon import RibbonModel, RibbonModes
from haptonic.bloch.ribbon_modes import GuideMotion, decay, in_gap, outermost, within
from haptonic.gate import declared, describe, titled
from haptonic.later import xarray as xr

NO_DECAY = "a strip, a mode within a bulk band, or fewer than two rows to compare"


def ribbon_dataset(
    model: RibbonModel, modes_by_phase: Sequence[RibbonModes], bulk: Array, rows: int | None
) -> xr.Dataset:
    """Dataset of all modes, along ``mode``, with their relation to bulk bands and their energy distribution.

    Parameters
    ----------
    modes_by_phase : modes at each wavevector; bulk : (crystals, wavevectors, bands, 2) Hz
    rows : length in cells of a guide with free ends, or None
    """
    ribbon, motion = model.ribbon, GuideMotion(model)
    pieces = []
    for number, modes in enumerate(modes_by_phase):
        share = modes.energy / modes.energy.sum(axis=(1, 2), keepdims=True)
        share_in_guide, between = within(modes.energy, ribbon.guide), in_gap(modes, bulk[:, number])
        wavenumber, across = motion.harmonics(modes)
        fall, fall_error = (np.where(between, each, np.nan) for each in decay(model, modes))
        towards_guide = share_in_guide > within(modes.energy, outermost(ribbon))
        pieces.append({
            "phase": np.full(len(modes.frequency), modes.kappa),
            "frequency": modes.frequency,
            "frequency_error": modes.error,
            "group_velocity": 2 * np.pi * ribbon.period * modes.slope,
            "group_velocity_error": 2 * np.pi * ribbon.period * modes.slope_error,
            "guide_share": share_in_guide,
            "cell_share": share,
            "in_gap": between.astype(np.int8),
            "guided": (
                (ribbon.kind == "strip")
                | between & towards_guide & ~(fall < 0)
            ).astype(np.int8),
            "decay": fall,
            "decay_error": fall_error,
            "wavenumber": wavenumber,
            "nodal_lines": across,
            "intervals": wavenumber * (rows or np.nan) * ribbon.period / np.pi - 0.5,
        })  # fmt: skip
    joined = {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}
    of_cells = ("mode", "line", "column")
    dataset = xr.Dataset({name: (of_cells[: values.ndim], values) for name, values in joined.items()})
    dataset["phase_share"] = dataset["phase"] / np.pi
    titles = {
        "phase": ("rad", "phase of the wave from one period of the ribbon to the next"),
        "phase_share": ("1", "phase from one period to the next, over pi"),
        "frequency": ("Hz", "frequency"),
        "frequency_error": ("Hz", "bound of the frequency's error"),
        "group_velocity": ("m/s", "group velocity along the ribbon"),
        "group_velocity_error": ("m/s", "estimate of the group velocity's error"),
        "decay_error": ("dB/row", "estimate of the decay's error"),
        "guide_share": (
            "1",
            "share of energy in the guide or defect, in the cells on either side of an edge, or at the free "
            "edges of a strip",
        ),
        "cell_share": ("1", "share of energy in each cell, lines from the bottom up"),
        "in_gap": ("1", "1 for modes between the bulk bands at this phase"),
        "guided": (
            "1",
            "1 for modes between bulk bands with more energy in the guide than in the outermost columns and "
            "no negative decay, and for all modes of a strip",
        ),
        "decay": ("dB/row", "decay of the energy away from the guide"),
        "wavenumber": ("rad/m", "wavenumber of the strongest harmonic of the motion along the guide"),
        "nodal_lines": ("1", "nodal lines of the normal motion across the guide"),
        "intervals": ("1", "intervals between nodal lines along a guide of the given length"),
    }
    describe(dataset, titles)
    return declared(
        dataset,
        decay=NO_DECAY,
        decay_error=NO_DECAY,
        wavenumber="several lines of cells",
        nodal_lines="no guide of one line of cells, or a mode without normal motion",
        intervals="no length in cells was given, or several lines of cells",
    )


def bulk_dataset(kappa: Array, bulk: Array, names: Sequence[Sequence[str]]) -> xr.Dataset:
    """Dataset of bulk band edges at phases along a ribbon, and of the names of its cells for each line."""
    edges = ("crystal", "wavevector", "bulk_band")
    dataset = titled({
        "wavevector_phase": ("wavevector", kappa, "rad", "phases along the ribbon"),
        "bulk_lower": (edges, bulk[..., 0], "Hz", "lower edge of a bulk band"),
        "bulk_upper": (edges, bulk[..., 1], "Hz", "upper edge of a bulk band"),
    })  # fmt: skip
    return dataset.assign_coords(cell_name=(("line", "column"), np.array(names)))


def field_dataset(
    model: RibbonModel, chosen: xr.Dataset, modes_by_phase: Sequence[RibbonModes]
) -> xr.Dataset:
    """Dataset of a mode's field on the flat face: its largest component, with the ribbon along y."""
    modes = next(modes for modes in modes_by_phase if modes.kappa == float(chosen["phase"]))
    number = int(np.abs(modes.frequency - float(chosen["frequency"])).argmin())
    face = FlatFace.of(model.fine.tiling, model.ribbon.turn)
    fields, components = strongest(face.motion(modes.fields[:, [number]]))
    field = fields[:, 0]
    variables = {
        "field_position": (("node", "axis"), face.position, "m"),
        "field_triangle": (("triangle", "vertex"), face.triangles, "1"),
        "field_real": ("node", field.real, "1"),
        "field_imag": ("node", field.imag, "1"),
        "field_frequency": ((), float(chosen["frequency"]), "Hz"),
        "field_phase": ((), float(chosen["phase"]), "rad"),
        "field_component": ((), int(components[0]), "1"),
    }
    return xr.Dataset(
        {name: (dims, values, {"units": unit}) for name, (dims, values, unit) in variables.items()}
    )
