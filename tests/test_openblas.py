"""The name of a processor that OpenBLAS does not know is given before NumPy is loaded, and only then."""

import os
import subprocess
import sys

import pytest

from haptonic import _openblas

FLAGS = "fpu avx2 " + " ".join(sorted(_openblas.NEEDED))


def cpuinfo(vendor="AuthenticAMD", family=26, flags=FLAGS):
    core = f"processor\t: 0\nvendor_id\t: {vendor}\ncpu family\t: {family}\nflags\t\t: {flags}\n"
    return core + "\n" + core


@pytest.fixture
def core(tmp_path, monkeypatch):
    """What a processor is called, from the text of its /proc/cpuinfo."""
    monkeypatch.setenv("OPENBLAS_CORETYPE", "as it was")  # and will be afterwards
    monkeypatch.delenv("OPENBLAS_CORETYPE")
    monkeypatch.delitem(sys.modules, "numpy", raising=False)
    monkeypatch.setattr(_openblas, "CPUINFO", tmp_path / "cpuinfo")

    def named(text):
        if text is not None:
            (tmp_path / "cpuinfo").write_text(text, "utf-8")
        _openblas.name_the_kernels()
        return os.environ.get("OPENBLAS_CORETYPE")

    return named


def test_a_zen_5_gets_the_kernels_of_its_instructions(core):
    assert core(cpuinfo()) == "SkylakeX"


@pytest.mark.parametrize(
    "text",
    [
        cpuinfo(vendor="GenuineIntel"),
        cpuinfo(family=25),  # Zen 4, which OpenBLAS knows
        cpuinfo(flags=FLAGS.replace("avx512dq", "")),
        "",
        None,  # no such file
    ],
)
def test_others_are_left_to_openblas(core, text):
    assert core(text) is None


def test_what_is_set_or_loaded_already_stays(core, monkeypatch):
    monkeypatch.setenv("OPENBLAS_CORETYPE", "Zen")
    assert core(cpuinfo()) == "Zen"
    monkeypatch.delenv("OPENBLAS_CORETYPE")
    monkeypatch.setitem(sys.modules, "numpy", object())
    assert core(cpuinfo()) is None


def test_importing_haptonic_does_it():
    code = "import os, haptonic; print(os.environ.get('OPENBLAS_CORETYPE'), end='')"
    clean = {key: value for key, value in os.environ.items() if key != "OPENBLAS_CORETYPE"}
    asked = "from haptonic import _openblas as o; import os; os.environ.pop('OPENBLAS_CORETYPE', 0); "
    asked += "o.name_the_kernels(); print(os.environ.get('OPENBLAS_CORETYPE'), end='')"
    found, expected = (
        subprocess.run(
            [sys.executable, "-c", text], env=clean, capture_output=True, text=True, check=True
        ).stdout
        for text in (code, asked)
    )
    assert found == expected
