"""A name is data: where it is filed, shown and read back it stays that name and becomes nothing else."""

from __future__ import annotations

import io
import re
from pathlib import Path
from urllib.parse import unquote

import pytest
import xarray as xr
from hypothesis import assume, example, given, strategies as st
from matplotlib.figure import Figure
from rich.cells import cell_len
from rich.table import Table

from five_parts import refusing
from haptonic import plots
from haptonic.cli.console import PlainConsole, Voice
from haptonic.errors import HaptonicError, ResourceError, StudyError
from haptonic.names import cell, file_parts, from_cell, names_in, variable, visible
from haptonic.response import Reference
from haptonic.results.common import refuse_taken, write_files, write_netcdf
from haptonic.study import loads
from hostile import NASTY, any_text, names
from tiny_scan import TINY

CONTROLS = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
WINDOWS = re.compile(r'[<>:"/\\|?*\x00-\x1f]|[ .]$|^(?i:con|prn|aux|nul|com\d|lpt\d)(\.|$)')


@given(st.lists(names | st.sampled_from(NASTY), unique=True))
def test_files_of_names_stay_in_their_folder_and_apart(chosen):
    parts = file_parts(chosen)
    assert list(parts) == chosen
    for part in parts.values():
        assert (Path("folder") / f"waves-{part}.svg").parent == Path("folder")
        assert not WINDOWS.search(part)
        assert part.isascii()
        assert len(part) <= 48
    assert len({part.casefold() for part in parts.values()}) == len(chosen)


LEAVING = st.sampled_from(["..", ".", "", "a/b", "../up", "/root", "C:\\boot", "a\\b", "a/", "C:x", "./a"])


@given(LEAVING | st.tuples(names, st.sampled_from("/\\"), names).map("".join))
def test_a_name_that_leads_out_of_its_folder_is_refused_where_it_is_written(tmp_path_factory, name):
    """Whatever came before it: this is the last gate."""
    above = tmp_path_factory.mktemp("above")
    folder = above / "out"
    folder.mkdir()
    for write in (
        lambda: write_files(folder, {name: Path.touch}, overwrite=True),
        lambda: refuse_taken(folder, [name], overwrite=True),
        lambda: plots.save(Figure(), folder, f"{name}/x", overwrite=True),
    ):
        with refusing(ResourceError, "malformed", "output file"):
            write()
    assert list(above.rglob("*")) == [folder]


def test_plain_names_are_the_names_of_their_files():
    assert file_parts(["A1", "WG-2", "pad_3"]) == {"A1": "A1", "WG-2": "WG-2", "pad_3": "pad_3"}


@given(st.text())
def test_what_is_shown_moves_no_terminal(text):
    assert not CONTROLS.search(visible(text))
    assert CONTROLS.search(text) or visible(text) == text


@given(st.text(), st.text())
def test_an_error_quotes_a_file_without_its_control_characters(first, second):
    error = HaptonicError.conflict(argument=first, given=second, allowed=first, cause=second, next_step=first)
    assert not CONTROLS.search(str(error))
    assert not any(CONTROLS.search(part) for part in error.parts().values())


@given(st.text() | st.sampled_from(NASTY), st.text())
def test_cells_of_a_table_are_no_formulas_and_come_back(text, other):
    safe = str(cell(text))
    number = re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", safe)
    assert safe[:1] not in ("=", "+", "-", "@", "\t", "\r") or number
    assert from_cell(safe) == text
    assert (cell(other) == safe) == (other == text)


@given(names, st.sampled_from(["V", "N", "m/s", "1", ""]))
@example("a, b", "")
def test_a_reference_is_taken_apart_where_it_was_put_together(name, unit):
    assert Reference.parse(str(Reference(name, unit))) == Reference(name, unit)


@given(st.lists(names, unique=True, min_size=1, max_size=4))
def test_names_are_parted_whatever_commas_they_hold(known):
    """One by one, and plain names in a list."""
    for name in known:
        assert names_in(name, known) == (name,)
    plain = [name for name in known if "," not in name and name == name.strip()]
    assert names_in(", ".join(plain), plain) == tuple(plain)
    assert names_in("a, b, clamps", ("a, b", "a", "clamps")) == ("a, b", "clamps")


@given(st.lists(names, unique=True, min_size=1, max_size=4))
def test_variables_called_by_names_come_back(tmp_path_factory, chosen):
    path = tmp_path_factory.mktemp("file") / "scan.nc"
    data = xr.Dataset({f"rms {name}": ("frequency", [1.0 * k]) for k, name in enumerate(chosen)})
    write_netcdf(data, path)
    with xr.open_dataset(path, engine="h5netcdf") as read:
        stored = {unquote(str(name)): float(values[0]) for name, values in read.items()}
    assert stored == {f"rms {name}": 1.0 * k for k, name in enumerate(chosen)}
    assert [variable(f"rms {name}") for name in ("A", "WG1")] == ["rms A", "rms WG1"]


@given(names, names)
def test_a_terminal_shows_names_as_they_are(title, name):
    assume(cell_len(name))  # a column takes no room for signs that only change their neighbours
    voice = Voice(machine=False)
    voice.out.file = io.StringIO()
    voice.out.width = 4000
    table = Table(name, title=title)
    table.add_row(name)
    voice.write(table)
    voice.write(f"files: {name}")
    shown = voice.out.file.getvalue()
    assert "".join(f"files: {name}".split()) in "".join(shown.split())
    assert "".join(shown.split()).count("".join(name.split())) >= 3


def test_a_terminal_gets_no_control_codes_from_files():
    console = PlainConsole()
    console.file = io.StringIO()
    table = Table("name")
    table.add_row("a\x1b[2Jb\x00c\u202ed")
    console.print(table, "\x1b]0;title\x07")
    assert not CONTROLS.search(console.file.getvalue())
    assert "a\\x1b[2Jb\\x00c\\u202ed" in console.file.getvalue()


def quoted(name):
    """As TOML writes any text."""
    return '"' + "".join(f"\\U{ord(letter):08x}" for letter in name) + '"'


def with_names(region, other, actuator):
    text = TINY.replace('region = "WG1"', f"region = {quoted(region)}").replace('"A1"', quoted(actuator))
    return text.replace('"WG1"', quoted(region)).replace('"WG2"', quoted(other))


@given(st.lists(names.filter(lambda name: name != "lattice"), min_size=2, max_size=2, unique=True), names)
def test_a_study_takes_every_allowed_name_and_keeps_it(regions, actuator):
    study = loads(with_names(*regions, actuator))
    plate = study.mounted_plate()
    assert set(plate.layout.regions) == set(regions)
    assert [patch.name for patch in plate.actuators] == [actuator]
    again = loads(study.to_toml())
    assert again == study


@given(any_text, st.sampled_from("\x00\x07\x1b\x7f\x85\n\t\u2028\u202e\u2066"), st.integers(0, 40))
def test_a_name_with_a_control_character_is_refused_with_its_path(text, control, at):
    name = (text[:at] + control + text[at:])[:39] + control
    with refusing(StudyError, "malformed", "plate.actuator[1].name") as error:
        loads(with_names("WG1", "WG2", name))
    assert not CONTROLS.search(str(error.value))


@pytest.mark.parametrize("name", ["rest", "the rest", "clamps"])
def test_words_for_what_lies_outside_of_regions_are_refused_before_the_computation(name):
    with refusing(StudyError, "conflict", "study: plate.tiles"):
        loads(with_names(name, "WG2", "A1"))
