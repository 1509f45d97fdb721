"""The report on the machine: what it lists, and what it calls slow."""

from dataclasses import replace
from pathlib import Path

import pytest

from haptonic.cli.doctor import PARTS, Machine, browser, tables
from haptonic.store import Store

FAST = Machine(
    solver="MKL Pardiso", fast_solver=True, cores=4, threads=4, kernels="", memory=8e9, disk=50e9,
    store=Path("store"), store_fault="",
)  # fmt: skip


def test_the_physics_and_the_machine_are_examined(haptonic):
    ran = haptonic("doctor", "--json")
    assert ran.code == 0, ran.err
    report = ran.json
    assert report["healthy"] is True
    assert 0 < report["physics_error"] < 1e-4
    assert len(f"{report['physics_error']}") <= len("5.6e-05")
    assert report["solver"]
    assert report["threads"] >= 1
    assert report["browser"]
    assert "openblas" in report["linear_algebra"] or "mkl" in report["linear_algebra"]
    assert {part["extra"] for part in report["parts"]} == set(PARTS)
    assert all(part["install"] == f'pip install "haptonic[{part["extra"]}]"' for part in report["parts"])


def test_a_missing_part_is_listed_with_its_command():
    part = {"extra": "cad", "purpose": "STEP files", "install": 'pip install "haptonic[cad]"'}
    report = {"haptonic": "1", "parts": [part | {"version": None}, part | {"version": "6.2"}], "slow": []}
    facts, parts = tables(report)
    assert facts.texts == [("haptonic", "1")]
    assert [row[-1] for row in parts.texts] == ['missing: pip install "haptonic[cad]"', "6.2"]


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"fast_solver": False, "solver": "SciPy SuperLU"}, "haptonic[fast]"),
        ({"threads": 1}, "1 of 4 cores"),
        ({"kernels": "HASWELL"}, "OPENBLAS_CORETYPE=HASWELL"),
        ({"memory": 1e9}, "1.0 GB of memory"),
        ({"disk": 0.5e9}, "0.5 GB left"),
        ({"store_fault": "permission denied", "disk": 0.0}, "permission denied"),
    ],
)
def test_each_cause_of_slowness_is_named_alone(change, word):
    assert FAST.slow() == []
    (reason,) = replace(FAST, **change).slow()
    assert word in reason


def test_a_store_that_does_not_exist_is_examined_and_not_made(tmp_path):
    store = Store(tmp_path / "deep" / "store")
    machine = Machine.examined(store)
    assert machine.store_fault == ""
    assert machine.disk > 0
    assert store.size() == (0, 0)
    assert not store.root.exists()


def test_the_size_of_a_store_is_that_of_its_files(tmp_path):
    store = Store(tmp_path / "store")
    for key, content in {"a" * 64: b"one", "b" * 64: b"three"}.items():
        store.write(key, content, "png")
    (store.root / "aa" / "notes.txt").write_text("not of the store")
    files = list(store.root.rglob("*.png"))
    assert store.size() == (2, sum(path.stat().st_size for path in files))


def test_a_missing_browser_is_reported_as_none(monkeypatch):
    monkeypatch.setattr("webbrowser._tryorder", [])
    assert browser() == "none"
