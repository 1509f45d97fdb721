"""What a command prints: sentences first, as many tables as a screen holds, the others by name."""

from __future__ import annotations

import io
import shlex
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, strategies as st

from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import MEASURED, STUDIES
from haptonic.analyses.reproduce import Reproduction
from haptonic.cli.console import Voice
from haptonic.cli.running import SCREEN, SENTENCES, show
from haptonic.results.bands import Bands
from haptonic.results.scan.value import ScanResult
from haptonic.results.table import Table
from haptonic.vibrometry.maps.edges import Edge, LatticeGap
from haptonic.vibrometry.maps.registration import Registration
from simulated import reference_bands

tables = st.lists(st.integers(0, 40), max_size=6).map(
    lambda counts: [
        Table(f"table {k}", ("name", "value"), [(f"row-{k}-{n}", "1.5") for n in range(count)])
        for k, count in enumerate(counts)
    ]
)


def printed(result_tables: list[Table], width: int, *, every: bool, machine: bool = False) -> list[str]:
    voice = Voice(machine)
    voice.out.file, voice.out.width = io.StringIO(), width
    result = SimpleNamespace(
        summary=lambda: ["The answer.", "A second sentence."], tables=lambda: result_tables, remarks=list
    )
    show(result, voice, every=every)
    return voice.out.file.getvalue().splitlines()


@given(tables, st.sampled_from([40, 80, 200]))
def test_sentences_stay_in_sight_and_nothing_is_lost(result_tables, width):
    lines = printed(result_tables, width, every=False)
    assert lines[:2] == ["The answer.", "A second sentence."]
    drawn = [line for line in lines[2:] if line.startswith(("\u2502", "\u2503"))]
    assert len(drawn) <= SCREEN
    text = "\n".join(lines)
    joined = " ".join(text.split())
    for number, table in enumerate(result_tables):
        rows = [f"row-{number}-{n} " in text for n in range(len(table.rows))]
        assert all(rows) or not any(rows)  # a table is whole or left for later
        assert f"table {number}" in joined


@given(tables, st.sampled_from([40, 80]))
def test_all_tables_on_request(result_tables, width):
    text = "\n".join(printed(result_tables, width, every=True))
    assert all(
        f"row-{k}-{n} " in text for k, table in enumerate(result_tables) for n in range(len(table.rows))
    )
    assert "--tables" not in text


@given(tables)
def test_machines_get_none_of_it(result_tables):
    assert printed(result_tables, 80, every=True, machine=True) == []


@given(st.lists(st.integers(), max_size=8))
def test_more_than_three_sentences_are_for_those_who_ask(numbers):
    sentences = [f"Sentence {n} of {k}." for k, n in enumerate(numbers)]
    result = SimpleNamespace(summary=lambda: sentences, tables=list, remarks=list)

    def shown(*, every: bool) -> list[str]:
        voice = Voice(machine=False)
        voice.out.file = io.StringIO()
        show(result, voice, every=every)
        return voice.out.file.getvalue().splitlines()

    beyond = max(len(sentences) - SENTENCES, 0)
    assert shown(every=True) == sentences
    more = f"more with --tables: {beyond} sentence{'' if beyond == 1 else 's'}"
    assert shown(every=False) == sentences[:SENTENCES] + [more] * (beyond > 0)


@pytest.mark.parametrize(
    "name", [*(f"{stem}.toml" for stem in STUDIES), *(f"{stem}.csv" for stem in MEASURED)]
)
def test_output_folders_for_default_file_names_start_with_the_folder_name(name):
    folders = [named("export").folder_of(Path(f"results/{folder}/{name}")) for folder in ("a", "b")]
    assert folders == ["a-export", "b-export"]


@pytest.mark.parametrize("name", MEASURED)
def test_a_study_that_is_called_as_a_measurement_gives_its_own_name(name):
    assert named("protocol").folder_of(Path(f"mine/{name}.toml")) == f"{name}-protocol"


def test_the_answer_is_there_before_the_pictures_are_drawn(inside, study, tmp_path, monkeypatch):
    """They take as long again; what stops them leaves the answer."""

    def stopped(*given, **how):
        raise KeyboardInterrupt

    monkeypatch.setattr("haptonic.results.result.write_pictures", stopped)
    ran = inside("bands", study(), "--out", tmp_path / "out")
    assert ran.code == 130
    assert ran.out.startswith(("Complete gap", "The computed bands have no complete gap"))
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", NAMES)
def test_the_folder_of_a_command_needs_no_quotes_in_a_shell(name):
    folder = named(name).folder_of(Path("mine.toml"))
    assert shlex.split(folder) == [folder]


def test_a_pipe_gets_no_line_of_a_bar(inside, study, tmp_path):
    """No progress bar is drawn there; standard error holds messages only, without empty lines."""
    ran = inside("bands", study(), "--out", tmp_path / "out")
    assert ran.code == 0
    assert [line for line in ran.err.splitlines() if not line.strip()] == []
    assert ran.out.startswith(("Complete gap", "The computed bands have no complete gap"))


def test_the_option_is_every_command_s(inside, study, tmp_path):
    few = inside("sweep", study(("steps = 3", "steps = 30")), "--help").out
    assert "--tables" in few


@given(st.floats(1e3, 2e5))
def test_bands_report_where_the_carrier_lies(carrier):
    bands = reference_bands()
    sentence = Bands(bands.assign_attrs(carrier_hz=carrier)).summary()[1]
    lower, upper = (bands[f"gap_{edge}"].values[0] for edge in ("lower", "upper"))  # of the only complete gap
    room, edge = min((carrier - lower, "lower"), (upper - carrier, "upper"))
    if abs(room) <= bands[f"gap_{edge}_error"].values[0]:
        assert "may lie inside the gap" in sentence
        return
    assert ("lies inside the gap" if room > 0 else "lies in no complete gap") in sentence
    assert f"{abs(room) / 1e3:.2g} kHz" in sentence


@pytest.mark.parametrize("side", [-1, 1])
def test_a_carrier_within_the_error_of_an_edge_is_undecided(side):
    """On both sides of the edge; no distance is given, which would contradict the rounded edge."""
    bands = reference_bands()
    edge = bands["gap_lower"].values[0]
    uncertain = bands.assign(gap_lower_error=("gap", [2e3] * bands.sizes["gap"]))
    sentence = Bands(uncertain.assign_attrs(carrier_hz=edge + 1e3 * side)).summary()[1]
    assert "may lie inside the gap" in sentence
    assert "from the lower edge is smaller than the error of that edge" in sentence
    assert "1 kHz" not in sentence


def test_the_carrier_is_in_the_first_sentences_of_a_cell_with_several_gaps():
    bands = reference_bands()
    summary = Bands(bands.isel(gap=[0, 0, 0]).assign_attrs(carrier_hz=1e3)).summary()
    assert summary[0].startswith("Complete gaps from ")
    assert summary[0].count("between bands") == 3
    assert "The carrier, 1 kHz, lies in no complete gap" in summary[1]


@pytest.mark.parametrize("others", [(), ("plate",), ("feel", "plate")])
def test_a_report_lists_the_first_line_of_each_part(others):
    parts = {
        name: SimpleNamespace(summary=lambda name=name: [f"{name} 1", f"{name} 2"], remarks=lambda: ["but"])
        for name in others
    }
    bands = Bands(reference_bands())
    report = Reproduction({"bands": bands, **parts}, None)
    first = bands.summary()
    assert report.summary() == (
        [first[0], *(f"{name} 1" for name in ("plate", "feel") if name in parts)] if parts else first
    )
    assert [text for text in report.remarks() if "but" in text] == [f"{name}: but" for name in others]


@pytest.mark.parametrize("all_of_it", [True, False])
def test_a_scan_summary_lists_the_data_then_the_agreement_with_a_model_and_the_gap(all_of_it):
    """Reading and registration come last; parts that are not asked for are not mentioned."""
    moved = Registration(scale=1.0, angle=0.0, shift=np.zeros(2), mirrored=False, misfit=0.0)
    edges = LatticeGap(Edge(66e3, 100.0), None, ("no upper edge",))
    stands_out = SimpleNamespace(lower=53e3, upper=59e3, lower_error=10.0, upper_error=20.0)
    scan = SimpleNamespace(
        response=SimpleNamespace(points=np.zeros((3, 2)), frequency=np.array([40e3, 70e3])),
        flags={"low": 2, "odd": 0}, origin="measured", lattice=edges, measured=stands_out,
        verdict=SimpleNamespace(summary=lambda: ["The model fits.", "Compared."]), registration=moved,
        gap=SimpleNamespace(lower=52e3, upper=60e3, edges=(52e3, 60e3)),
        report=SimpleNamespace(complete=False, remarks=()),
    )  # fmt: skip
    if not all_of_it:
        scan.verdict = scan.lattice = scan.measured = scan.registration = None
        scan.report.complete = True
    summary = ScanResult.summary(scan)
    begun = ["3 points (2 low), 2 frequencies", "The model fits.", "Gap in the scan (experimental): lower",
             "  no upper edge", "High contrast of the driven region", "Compared.", "namespace(",
             "Registered: scale"]  # fmt: skip
    assert len(summary) == (len(begun) if all_of_it else 1)
    assert all(text.startswith(start) for text, start in zip(summary, begun, strict=False)), summary
    assert all_of_it == any("another range" in text for text in summary)
