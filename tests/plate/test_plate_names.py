"""A plate whose regions, actuators and forces have any name: all runs, nothing is lost or mixed up."""

from __future__ import annotations

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import HealthCheck, given, settings, strategies as st
from matplotlib.legend import Legend
from small import COARSE, LOSS, drawn, glued

from haptonic import plots
from haptonic.analyses.plate import compute_plate
from haptonic.cli.console import Voice
from haptonic.plate import Plate
from haptonic.plate.layout.keys import FINGER, PLATE, SUPPORTS, bond, ceramic, dielectric, electric
from haptonic.plate.layout.parts import Force
from haptonic.plate.layout.supports import Support
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.response import read, write
from haptonic.results.common import write_netcdf
from haptonic.results.plate.drawing import impedance_names
from haptonic.store import Store
from hostile import NASTY, names

slow_but_few = settings(
    max_examples=1, deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)  # fmt: skip
QUESTION = ResponseSettings(lowest=4e3, highest=12e3, points=3, tolerance=1e-2, grid=3.5e-3)
# of the regions in which the patch and the force lie, of the patch and of the force
fours = st.tuples(
    st.lists(names, min_size=2, max_size=2, unique=True), st.lists(names, min_size=2, max_size=2, unique=True)
)


def called(regions, drives):
    """A patch on one region, a force on another, a spring at an edge."""
    driven, other = regions
    layout = drawn("aab")
    tiles = (tuple({"a": driven, "b": other}[str(name)] for name in layout.tiles[0]),)
    patch, force = drives
    return Plate(
        replace(layout, tiles=tiles),
        supports=(Support("left", "spring", stiffness=3e11, loss_factor=0.08),),
        actuators=(glued((7e-3, 3.5e-3), size=(7e-3, 3.5e-3, 0.7e-3), name=patch),),
        forces=(Force(force, (17.5e-3, 3.5e-3), (3e-3, 2e-3)),),
        loss_factor=LOSS,
    )


def computed(plate, folder):
    return compute_plate(
        plate, QUESTION, carrier=8e3, gap=None, inputs={}, store=Store(folder), fineness=COARSE
    )  # fmt: skip


@pytest.fixture(scope="module")
def energies(tmp_path_factory):
    """Stored in both regions and in the patch, with names that cannot be mistaken."""
    lines = computed(called(("R1", "R2"), ("A1", "F1")), tmp_path_factory.mktemp("plain")).lines
    stored = lines["strain_energy"]
    return stored.sel(part=["region R1", "region R2"]).values, stored.sel(part="actuator A1").values


@slow_but_few
@given(fours)
def test_energy_is_where_it_belongs_whatever_the_names(energies, tmp_path_factory, chosen):
    regions, drives = chosen
    folder = tmp_path_factory.mktemp("named")
    result = computed(called(regions, drives), folder / "store")
    lines = result.lines
    stored = lines["strain_energy"]
    parts = [*(f"region {name}" for name in regions), f"actuator {drives[0]}"]
    assert sorted(stored["part"].values.tolist()) == sorted(parts)
    assert lines["actuator"].values.tolist() == [drives[0]]
    in_plate, in_patch = energies
    for k, name in enumerate(regions):
        there = stored.sel(part=f"region {name}").values
        assert there == pytest.approx(in_plate[:, k], rel=1e-6)
    assert stored.sel(part=parts[-1]).values == pytest.approx(in_patch, rel=1e-6)
    # the loss of the plate's own material is 2 omega times its loss factor times its mean energy, all of it
    turns = 2 * np.pi * lines["frequency"].values
    whole = lines["dissipated"].sel(loss="plate").values / (2 * turns * LOSS)
    assert stored.sel(part=parts[:-1]).sum("part").values == pytest.approx(whole, rel=1e-6)
    lost = lines["dissipated"].sum("loss").values
    assert lost == pytest.approx(lines["given"].values, rel=1e-4)
    assert len(set(lines["loss"].values.tolist())) == lines.sizes["loss"]
    shown_whole(result, regions, drives, folder)


def shown_whole(result, regions, drives, folder: Path):
    """Files, pictures and tables: inside of the folder, and with the names."""
    out = folder / "a" / "b" / "c" / "out"
    out.mkdir(parents=True)
    write_netcdf(result.lines, out / "plate.nc")
    write(result.response, out / "response.nc")
    with xr.open_dataset(out / "plate.nc", engine="h5netcdf") as file:
        assert {f"region {name}" for name in regions} < set(file["part"].values.tolist())
        assert file["actuator"].values.tolist() == [drives[0]]
    back = read(out / "response.nc")
    assert set(back.regions) == set(regions)
    assert (back.reference.name, back.reference.unit) == (drives[0], "V")
    assert back.units == "m/s/V"
    frequency = result.response.frequency
    figures = {
        "plan": plots.plate_plan(result.plate),
        "velocity": plots.velocity_spectrum(
            frequency, {k: v.values for k, v in result.levels.items()}, [], units="m/s/V",
            origin="simulated",
        ),
        "contrast": plots.contrast_spectrum(
            frequency, {k: v.values for k, v in result.contrasts(result.response).items()}, [],
            origin="simulated",
        ),
    }  # fmt: skip
    (impedance,) = impedance_names(result.plate).values()
    figures[impedance] = plots.impedance_spectrum(
        frequency, result.impedance(drives[0]), [], origin="simulated"
    )
    shown = figures["velocity"].findobj(Legend)
    assert sum(len(legend.get_texts()) for legend in shown) >= len(regions)
    for name, figure in figures.items():
        plots.save(figure, out, name)
    written = sorted(path for path in folder.rglob("*.*") if "store" not in path.relative_to(folder).parts)
    assert {path.parent for path in written} == {out}
    assert {path.name for path in written} >= {"plan.svg", f"{impedance}.svg"}
    voice = Voice(machine=False)
    voice.out.file, voice.out.width = io.StringIO(), 4000
    for table in result.tables():
        voice.show(table)
    text = "".join(voice.out.file.getvalue().split())
    assert all("".join(name.split()) in text for name in (*regions, drives[0]))
    answer = result.to_json()["maps"][0]
    parts = {*(f"region {name}" for name in regions), f"actuator {drives[0]}"}
    assert set(answer["strain_energy_j_per_v_2"]) == parts
    assert set(answer["impedance_ohm"]) == {drives[0]}


def test_a_name_that_goes_up_writes_nothing_above():
    """The fault that was found."""
    plate = called(("WG1", "WG2"), ("x/../../../escaped", "F1"))
    assert all(Path(name).name == name for name in impedance_names(plate).values())


@given(st.sampled_from(NASTY), st.sampled_from(NASTY))
def test_the_names_of_parts_are_unique(first, second):
    keys = [PLATE, SUPPORTS, FINGER]
    keys += [part(name) for name in {first, second} for part in (bond, ceramic, dielectric, electric)]
    assert len({str(key) for key in keys}) == len(keys)
