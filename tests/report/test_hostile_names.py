"""Names as badly as they may be, in everything that is shown of trials: all of it stays text."""

from __future__ import annotations

import base64
import csv
import io
import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest
import xarray as xr
from test_report import read, results

from daily import daily
from five_parts import refusing
from haptonic import plots
from haptonic.analyses.friction import compute_friction
from haptonic.analyses.simulate_scan import rescanned
from haptonic.cli.console import Voice
from haptonic.cli.running import show
from haptonic.errors import FrictionError, HaptonicWarning
from haptonic.friction.recordings import Sensor
from haptonic.friction.signals import Label, Rules
from haptonic.names import cell, from_cell
from haptonic.report.chapters import plate as plates, scan as scans
from haptonic.report.chapters.trials import chapter
from haptonic.report.page import page
from haptonic.results.quality import quality
from haptonic.store import Store
from haptonic.study import loads
from haptonic.vibrometry.of_settings import drive_for, response_for
from tiny_scan import TINY
from trial_folders import simulated, written

# four people and two guides; tables of trials give names back without blanks around them
GROUPS = [
    ["NA", "=2+5", "[/x]", "<script>alert(1)</script>", "$x_$", "_hidden"],
    ["a, b", "x/../../../escaped", "{{ 7 }}", "'=1", "@SUM(A1)", "[red]y <b>&amp;"],
]
FORBIDDEN = {"script", "b", "red"}


def rows_of(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module", params=daily(range(len(GROUPS)), 0), ids=lambda k: "; ".join(GROUPS[k])[:40])
def trials(request, tmp_path_factory):
    """Trials of four people on two guides, all of them called badly."""
    *people, first, second = GROUPS[request.param]
    guides = {"WG1": first, "WG2": second}
    labelled = [
        (replace(label, waveguide=guides[label.waveguide], participant=label.participant), record)
        for label, record in simulated(len(people), 2, 4)
    ]
    folder = written(tmp_path_factory.mktemp("trials"), labelled)
    table = folder / "trials.csv"
    numbers = {f"P{k}": name for k, name in enumerate(people, start=1)}
    rows = rows_of(table)
    for row in rows:  # files keep their plain names
        row["participant"] = numbers[row["participant"]]
    with table.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows({column: cell(text) for column, text in row.items()} for row in rows)
    return compute_friction(folder, Sensor(), Rules(), driven=first), people, [first, second]


def test_tables_hold_the_names_and_no_formula(trials, tmp_path):
    result, people, guides = trials
    for name, write in result.files.items():
        write(tmp_path / name)
    for name in ("trials.csv", "conditions.csv"):
        rows = rows_of(tmp_path / name)
        participants = {from_cell(row["participant"]) for row in rows} - {"all participants"}
        assert participants == set(people)
        assert {from_cell(row["waveguide"]) for row in rows} == set(guides)
        cells = [row[column] for row in rows for column in ("participant", "waveguide")]
        assert not [text for text in cells if re.match(r"[=+\-@](?![\d.]+$)", text)]
    with xr.open_dataset(tmp_path / "trials.nc", engine="h5netcdf") as file:
        assert set(file["participant"].values.tolist()) == set(people)


def test_a_table_that_was_written_is_read_again(trials, tmp_path):
    result, people, _ = trials
    result.files["trials.csv"](tmp_path / "trials.csv")
    again = compute_friction(tmp_path / "trials.csv", Sensor(), Rules())
    assert set(again.trials["participant"].values.tolist()) == set(people)


def test_pictures_and_terminal_show_them(trials, tmp_path):
    result, people, guides = trials
    for name, figure in result.figures.items():
        for path in plots.save(figure, tmp_path, name):
            if path.suffix == ".svg":
                ET.fromstring(path.read_bytes())
    voice = Voice(machine=False)
    voice.out.file, voice.out.width = io.StringIO(), 4000
    show(result, voice, every=True)
    printed = "".join(voice.out.file.getvalue().split())
    assert all("".join(name.split()) in printed for name in guides)
    assert len(people) == 4


def test_pages_hold_text_only(trials, monkeypatch):
    result, people, guides = trials
    monkeypatch.setattr("haptonic.report.page.IN_ORDER", (chapter,))
    report = read(page(results(friction=result)))
    sheets = read(quality(result))
    for seen in (report, sheets):
        assert not FORBIDDEN & {tag for tag, _ in seen.tags}
        assert not [key for _, attributes in seen.tags for key in attributes if key.startswith("on")]
        for picture in seen.of("img"):
            kind, content = str(picture["src"]).split(";base64,")
            assert kind == "data:image/svg+xml"
            ET.fromstring(base64.b64decode(content))
    assert all(" ".join(name.split()) in report.text for name in guides)
    shown = " ".join(str(picture["alt"]) for picture in sheets.of("img"))
    assert all(name in shown for name in people)


def test_the_word_for_all_people_is_nobody_s_name():
    with refusing(
        FrictionError, "malformed", "participant of participant all participants, block 1, trial 1"
    ):
        Label("all participants", 1, 1, "WG1", "on")


@pytest.mark.nightly
def test_pages_of_a_plate_and_its_scan_hold_text_only(tmp_path, monkeypatch):
    regions = ["[/x] $x_$ <script>alert(1)</script>", "x/../../../escaped <b>&amp;"]
    text = TINY.replace('"A1"', '"=2+5 <b>"')
    for plain, name in zip(("WG1", "WG2"), regions, strict=True):
        text = text.replace(f'"{plain}"', f'"{name}"')
    study, store = loads(text), Store(tmp_path)
    question = study.scan_settings
    with pytest.warns(HaptonicWarning, match="ring-down"):
        drive = drive_for(question, study.mounted_plate())
    asked = replace(response_for(question, 1e-3, drive), points=126)
    plate = study.plate(settings=asked, store=store)
    scan = rescanned(study, plate, seed=2, store=store)
    monkeypatch.setattr("haptonic.report.page.IN_ORDER", (plates.chapter, scans.chapter))
    seen = read(page(results(study=study, plate=plate, scan=scan)))
    assert not FORBIDDEN & {tag for tag, _ in seen.tags}
    for picture in seen.of("img"):
        kind, content = str(picture["src"]).split(";base64,")
        if kind == "data:image/svg+xml":
            ET.fromstring(base64.b64decode(content))
    assert all(name in seen.text for name in regions)
    assert f"{regions[0]} over {regions[1]}" in seen.text
