"""One reader a format: what is written comes back as the same channels, in every dialect of the format."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings, strategies as st

from five_parts import refused
from haptonic.channels import Channel, Group, delimited, hdf5, matlab, opened, tdms, wav
from haptonic.channels.formats import FORMATS
from haptonic.channels.labels import factor_of
from haptonic.channels.signals import ORIGIN, SIMULATED
from haptonic.errors import ChannelError
from haptonic.response import Reference
from haptonic.vibrometry import InMemory, TimeScan, write_uff_records

RATE = 1000.0
FORCE, SHIFT = np.random.default_rng(4).normal(size=(2, 50))
EVERY = [Channel.of("Fz", FORCE, "mN", RATE), Channel.of("position", SHIFT, "mm", RATE)]
SLOW = settings(max_examples=80, suppress_health_check=[HealthCheck.function_scoped_fixture])


def _uff(path: Path) -> None:
    """Two records of one point; the format of a universal file keeps six digits."""
    records = InMemory(FORCE[None, None], SHIFT[None, None])
    place = np.zeros(1)
    scan = TimeScan(records, ("1",), place, place, 1, 50, RATE, Reference("Fz", "mN"), origin=SIMULATED)
    write_uff_records(scan, path)


WRITTEN = {
    ".csv": lambda path: delimited.write(
        path,
        {f"{channel.name} ({channel.unit})": np.asarray(channel) for channel in EVERY}
        | {ORIGIN: [SIMULATED] * 50},
    ),
    ".h5": lambda path: hdf5.write(path, EVERY, {ORIGIN: SIMULATED, "sample_rate": RATE}),
    ".mat": lambda path: matlab.write(
        path, {channel.name: np.asarray(channel) for channel in EVERY} | {"fs": RATE}, SIMULATED
    ),
    ".tdms": lambda path: tdms.write(
        path, {ORIGIN: SIMULATED}, [[Group("records", {channel.name: channel for channel in EVERY})]]
    ),
    ".uff": _uff,
}
UNITS = {".mat": ""}  # variables of MATLAB have none


@pytest.mark.parametrize("suffix", WRITTEN)
def test_what_is_written_comes_back(tmp_path, suffix):
    path = tmp_path / f"a{suffix}"
    WRITTEN[suffix](path)
    group = opened(path).group("")
    assert group.simulated
    assert np.allclose(group["Fz"], FORCE, rtol=1e-5, atol=1e-7)
    assert group.signals["Fz"].unit == UNITS.get(suffix, "mN")
    assert group.rate == (None if suffix == ".csv" else pytest.approx(RATE, rel=1e-6))
    refused(lambda: group["Fx"], code="unknown", argument="channel Fx", kind=ChannelError)
    refused(lambda: opened(path).group("nowhere"), "nowhere", code="unknown", kind=ChannelError)


@pytest.mark.parametrize("suffix", [suffix for form in FORMATS for suffix in form.suffixes])
def test_every_ending_is_read_and_what_is_none_of_it_is_refused(tmp_path, suffix):
    for content in (b"", b"\0\0\1", b"a,b\n1,2,3\n"):
        (tmp_path / f"a{suffix}").write_bytes(content)
        refused(lambda: np.asarray(opened(tmp_path / f"a{suffix}").group("")["Fz"]), kind=ChannelError)


@given(
    st.sampled_from([",", ";", "\t"]),
    st.booleans(),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from(["utf-8", "utf-8-sig", "latin-1", "utf-16"]),
    st.sampled_from(["", "# rig 2, 1 kHz\n", "\n"]),
    st.integers(0, 3),
    st.lists(st.tuples(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6)), min_size=1, max_size=5),
)
@SLOW
def test_dialects_of_text(tmp_path, separator, behind, end, encoding, above, below, rows):
    """A separator behind every row, as some programs write, once put every column below the next name."""
    comma = separator == ";"
    lines = [separator.join(["time", "Kraft (µN)"])]
    for row in rows:
        cells = separator.join(map(repr, row)).replace("." if comma else "", "," if comma else "")
        lines.append(cells + separator * behind)
    # "1,625" alone may be 1625 or 1.625, and is refused
    numbers = [repr(number) for row in rows for number in row]
    assume(not comma or not all(re.fullmatch(r"-?\d{1,3}\.\d{3}", number) for number in numbers))
    lines += [separator] * below
    text = above + "\n".join(lines) + "\n"
    (tmp_path / "a.csv").write_bytes(text.replace("\n", end).encode(encoding))
    group = opened(tmp_path / "a.csv").group("")
    assert list(group.signals) == ["time", "Kraft"]
    assert group.signals["Kraft"].unit == "µN"
    # the oldest pandas misses the last bit of numbers such as 1e-47
    assert np.transpose([group["time"], group["Kraft"]]) == pytest.approx(np.array(rows), rel=4e-16, abs=0)


@given(st.integers(1, 4), st.booleans())
@SLOW
def test_numbers_without_a_name_are_refused(tmp_path, more, everywhere):
    """As a table with decimal commas that are also its separators."""
    rows = ["1,2" + ",3" * more, "1,2" + ",3" * more * everywhere]
    (tmp_path / "a.csv").write_text("\n".join(["a,b", *rows]))
    refused(
        lambda: opened(tmp_path / "a.csv"),
        "line 2",
        code="unreadable",
        argument="a.csv",
        kind=ChannelError,
    )


def test_a_sound_file_comes_back(tmp_path):
    wav.write(tmp_path / "a.wav", FORCE, 8000)
    group = opened(tmp_path / "a.wav").group("")
    assert group.rate == 8000
    assert group["1"] / wav.SIXTEEN_BITS == pytest.approx(FORCE / np.abs(FORCE).max(), abs=1e-4)
    both = np.arange(8, dtype=np.int16).reshape(4, 2)
    wav.write(tmp_path / "a.wav", both, 8000)
    assert np.array_equal(np.transpose([opened(tmp_path / "a.wav").group("")[name] for name in "12"]), both)


@pytest.mark.parametrize(
    ("text", "si", "factor"),
    [("mN", "N", 1e-3), ("(µm)", "m", 1e-6), ("[ms]", "s", 1e-3), ("inch", "m", 0.0254), ("kHz", "Hz", 1e3),
     ("lbf", "N", 4.4482216152605)],
)  # fmt: skip
def test_units_are_those_that_instruments_write_or_any_other(text, si, factor):
    assert factor_of(text, si) == pytest.approx(factor, rel=1e-12)


def test_a_unit_of_another_kind_is_refused():
    refused(lambda: factor_of("V", "N"), "V", code="malformed", argument="unit")
