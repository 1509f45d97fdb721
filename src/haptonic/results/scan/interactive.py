"""Interactive view of a scan: the measured map, beside that of the model, at every frequency."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic.arrays import AnyComplex, Array, Ints
from haptonic.later import xarray as xr
from haptonic.plate.layout.drawing import drawing_of
from haptonic.plate.layout.sampling import driven_region
from haptonic.plate.vibration.region_measures import contrasts
from haptonic.response import FrequencyResponse, average_spectrum, frac, rms
from haptonic.response.measures import along
from haptonic.response.rasters import point_map
from haptonic.results.plate.interactive import scales_of
from haptonic.results.steps import step_colours, stepped
from haptonic.results.verdict import MEASURED
from haptonic.views import InteractiveView

if TYPE_CHECKING:
    from haptonic.results.scan.value import ScanResult

NO_PLATE: dict[str, Any] = {"plate": [], "regions": {}, "features": [], "held": [], "patches": {}}


def scan_view(result: ScanResult, most_numbers: int = 40_000_000) -> InteractiveView:
    """View of the measured response, and of the last model if the scan was compared with one.

    ``shape_real`` and ``model_real`` are normal displacements (frequency, point) per unit of the reference,
    in steps as from `stepped`. ``place`` (y, x) is the number of the point that a place of
    the map shows, or -1. Maps with more than ``most_numbers`` numbers have every n-th frequency only.
    """
    shown = {"shape": result.response}
    titles = {"shape": f"scan, {result.origin}"}
    if (verdict := result.verdict) is not None:
        shown = {"shape": verdict.responses[MEASURED], "model": verdict.responses[verdict.last]}
        titles["model"] = f"{verdict.last}, simulated"
    lines = _lines(shown, result.shapes, most_numbers)
    moving = {name: response.with_lines(lines) for name, response in shown.items()}
    first = moving["shape"]
    number, x, y = point_map(first.points)
    variables: dict[str, Any] = {"place": (("y", "x"), number.astype(np.int32))}
    fields = {name: _normal(response.displacement()) for name, response in moving.items()}
    for name, field in fields.items():
        variables |= stepped(name, field, ("frequency", "point"))
    if "model" in fields:
        variables["agreement"] = (
            "frequency", _agreement(fields["shape"], fields["model"]),
            {"units": "1", "long_name": "agreement of the shapes (MAC)"},
        )  # fmt: skip
    data = xr.Dataset(
        variables,
        coords={
            "frequency": ("frequency", first.frequency, {"units": "Hz", "long_name": "frequency"}),
            "x": ("x", x, {"units": "m", "long_name": "x"}),
            "y": ("y", y, {"units": "m", "long_name": "y"}),
        },
        attrs={
            "origin": result.origin,
            "haptonic_version": version("haptonic"),
            **({} if result.plate is None else scales_of(result.plate)),
        },
    )
    data["level"] = along(_levels(moving), "region").assign_attrs(
        units=first.velocity().units, long_name="RMS velocity"
    )
    if result.plate is not None and (compared := _contrasts(moving, driven_region(result.plate))):
        data["contrast"] = along(compared, "pair").assign_attrs(
            units="dB", long_name="contrast of the driven region"
        )
    return InteractiveView(kind="scan", title=result.title, dataset=data, extra=_extra(result, titles, first))


def _lines(shown: Mapping[str, FrequencyResponse], shapes: tuple[float, ...], most_numbers: int) -> Ints:
    """Numbers of the frequencies in the view: all above zero, or every n-th one and the operating shapes."""
    response = shown["shape"]
    positive = np.flatnonzero(response.frequency > 0)
    numbers = 2 * len(shown) * len(response.points) * len(positive)
    every = max(1, -(-numbers // most_numbers))
    marked = [int(np.abs(response.frequency - shape).argmin()) for shape in shapes]
    return np.union1d(positive[::every], [line for line in marked if response.frequency[line] > 0]).astype(
        int
    )


def _normal(response: FrequencyResponse) -> Any:
    """(frequency, point) motion normal to the plate."""
    return response.values[..., list(response.dataset["direction"].values).index("z")]


def _agreement(first: AnyComplex, second: AnyComplex) -> Array:
    """Modal assurance criterion of two fields at each frequency; 0 where one of them does not move."""
    moving = first.any(axis=1) & second.any(axis=1)
    agreement = np.zeros(len(first))
    agreement[moving] = frac(first[moving].T, second[moving].T)  # over the points in place of the lines
    return agreement


def _levels(moving: Mapping[str, FrequencyResponse]) -> dict[str, xr.DataArray]:
    """Velocities of the regions, or of all points together without regions."""
    levels: dict[str, xr.DataArray] = {}
    for name, each in moving.items():
        response = each.velocity()
        of_regions = {region: rms(response, region) for region in response.regions if region}
        of_regions = of_regions or {"all points": average_spectrum(response)}
        levels |= {_called(region, name): level for region, level in of_regions.items()}
    return levels


def _contrasts(moving: Mapping[str, FrequencyResponse], driven: str | None) -> dict[str, xr.DataArray]:
    return {
        _called(pair, name): level
        for name, response in moving.items()
        for pair, level in contrasts(response, driven).items()
    }


def _called(what: str, name: str) -> str:
    return what if name == "shape" else f"{what} ({name})"


def _extra(result: ScanResult, titles: Mapping[str, str], shown: FrequencyResponse) -> dict[str, Any]:
    unit = shown.reference.unit
    total, here = len(result.response.frequency), len(shown.frequency)
    left_out = [f"This view has {here} of {total} frequencies."] if here < total else []
    return {
        "summary": [*result.summary(), *left_out],
        "colours": step_colours(),
        "gap": list(result.gap.edges) if result.gap else None,
        "carrier": result.carrier,
        "first": result.loudest,
        "first_is": "operating shape",
        "drive": f" per {unit}" if unit else "",
        "maps": titles,
        "python": "result",
        **(NO_PLATE if result.plate is None else drawing_of(result.plate)),
    }
