"""Names as badly as they may be, through whole commands: into files, pictures, terminals, JSON and pages."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
import xarray as xr

from daily import daily
from haptonic.names import file_parts
from haptonic.response import read
from haptonic.vibrometry import read_scan
from tiny_scan import TINY

pytestmark = pytest.mark.filterwarnings("ignore:the period of:haptonic.errors.HaptonicWarning")

NAMES = [  # two regions, an actuator
    ("[/x] $x_$", "=2+5", "x/../../../escaped"),
    ("x /../../../up", "[red]y %s", "x /../../../up"),  # a region's name, with blanks
]


def quoted(name: str) -> str:
    """As TOML writes any text."""
    return '"' + "".join(f"\\U{ord(letter):08x}" for letter in name) + '"'


def beside(text: str) -> str:
    """What a terminal shows, without its tables' lines and blanks."""
    return "".join(letter for letter in text if not letter.isspace() and letter not in "│┃")


def deep(tmp_path: Path) -> Path:
    return tmp_path / "a" / "b" / "c" / "out"


def assert_all_inside(tmp_path: Path, out: Path, before: set[Path]) -> set[str]:
    """Names of the files that were written, all of them in one folder, with pictures that are XML."""
    written = {path for path in tmp_path.rglob("*") if path.is_file()} - before
    assert {path.parent for path in written} == {out}
    for path in written:
        if path.suffix == ".svg":
            ET.fromstring(path.read_bytes())
    return {path.name for path in written}


@pytest.mark.parametrize(("region", "_", "actuator"), daily(NAMES, NAMES[0]))
def test_a_plate_with_bad_names(inside, plated, tmp_path, region, _, actuator):
    path, out = plated(('"WG"', quoted(region)), ('"A1"', quoted(actuator))), deep(tmp_path)
    before = {path for path in tmp_path.rglob("*") if path.is_file()}
    ran = inside("plate", path, "--tables", "--out", out)
    assert ran.code == 0, ran.err
    names = assert_all_inside(tmp_path, out, before)
    assert f"impedance-{file_parts([actuator])[actuator]}.svg" in names
    for name in (region, actuator):
        assert beside(name) in beside(ran.out)
    lines = xr.load_dataset(out / "plate.nc", engine="h5netcdf")
    assert f"region {region}" in lines["part"].values.tolist()
    assert lines["actuator"].values.tolist() == [actuator]
    response = read(out / "response.nc")
    assert (response.reference.name, response.reference.unit) == (actuator, "V")
    answer = inside("plate", path, "--json").json
    assert {f"region {region}", f"actuator {actuator}"} < set(answer["maps"][0]["strain_energy_j_per_v_2"])
    assert list(answer["maps"][0]["impedance_ohm"]) == [actuator]


@pytest.mark.nightly
@pytest.mark.parametrize(("first", "second", "actuator"), NAMES)
def test_a_scan_with_bad_names(inside, tmp_path, first, second, actuator):
    study, out = tmp_path / "tiny.toml", deep(tmp_path)
    text = TINY.replace('name = "A1"', f"name = {quoted(actuator)}")
    study.write_text(text.replace('"WG1"', quoted(first)).replace('"WG2"', quoted(second)), "utf-8")
    ran = inside("simulate", "scan", study, "--out", tmp_path / "twin", "--format", "h5")
    assert ran.code == 0, ran.err
    file = tmp_path / "twin" / "scan.h5"
    records = read_scan(file).records
    assert (records.reference.name, records.reference.unit) == (actuator, "V")
    before = {path for path in tmp_path.rglob("*") if path.is_file()}
    ran = inside("scan", file, study, "--tables", "--out", out)
    assert ran.code == 0, ran.err
    names = assert_all_inside(tmp_path, out, before)
    parts = file_parts([first, second])
    assert {f"waves-{part}.svg" for part in parts.values()} <= names
    for name in (first, second):
        assert beside(f"rms of {name}") in beside(ran.out)
    with xr.open_dataset(out / "scan.nc", engine="h5netcdf") as data:
        assert f"{first} over {second}" in data["pair"].values
        assert {first, second} <= set(data["region"].values.tolist())
    answer = inside("scan", file, study, "--json").json
    assert {first, second} <= answer["shapes"][0]["rms_m_per_s_per_v"].keys()
    assert f"{first} over {second}" in answer["shapes"][0]["contrast_db"]
