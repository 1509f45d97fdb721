"""Files of others, damaged: each is read or refused in five parts, and none takes the program with it."""

from __future__ import annotations

import attacks
import pytest

import haptonic.foreign.process as process

# Of each format; MATLAB 5 crashes are one in fifty, and hangs of HDF5 (one in thirty) are waited for.
SHORT = {"MAT 5": 150, "HDF5 records": 20, "NetCDF": 20}
SHORT |= {name: 15 for name, attack in attacks.ATTACKS.items() if attack.containers}
LONG = {"UFF": 50_000, "friction folder": 3_000}  # and 5000 of each other format
HANGING = 1.0  # s of processor time until a reader counts as hanging; good files of this size take 10 ms


def assert_held(name, folder, count, seed):
    counts = attacks.attack(name, folder / "files", count, seed)
    print(f"{name}: {counts}")
    assert counts.tried == count
    assert not counts.faults, f"{len(counts.faults)} of {count}; the first:\n{counts.faults[0]}"


@pytest.fixture(autouse=True)
def quickly(monkeypatch):
    monkeypatch.setattr(process, "SECONDS", HANGING)


@pytest.mark.parametrize("name", attacks.ATTACKS)
def test_damaged_files(tmp_path, name):
    assert_held(name, tmp_path, SHORT.get(name, 30), seed=0)


@pytest.mark.nightly
@pytest.mark.parametrize("name", attacks.ATTACKS)
def test_thousands_of_damaged_files(tmp_path, name):
    assert_held(name, tmp_path, LONG.get(name, 5_000), seed=1)
