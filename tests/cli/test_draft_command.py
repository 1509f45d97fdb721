"""A draft of the table of trials from the names of files."""

import csv
from collections import Counter

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from five_parts import assert_five_parts
from haptonic.friction.recordings import Sensor, analysed
from haptonic.friction.recordings.draft import drafted
from haptonic.friction.signals import Rules
from haptonic.friction.signals.columns import meanings, whole_number
from trial_folders import simulated, written

FORMS = (
    "{p}_{w}_{a}_{t:02d}", "{p}-blk{b}-{w}-{a}-{t}", "{p}/{w}/{a}_{t:03d}", "{p}/block {b}/{w} {a} trial {t}",
    "{p}{w}{a}{t:02d}", "{p}.{w}.B{b}.T{t}.{a}", "rec_{p}_S{b}_{w}_{t}_{a}",
)  # fmt: skip


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.sampled_from(FORMS), st.sampled_from(["P{}", "VP{}", "sub{}"]), st.sampled_from(["WG{}", "guide{}"])
)
def test_columns_are_found_in_drawn_names(tmp_path_factory, form, person, guide):
    folder = tmp_path_factory.mktemp("a")
    expected = {}
    for p in (1, 2, 3):
        for w in (1, 2):
            for t in (1, 2, 3, 4):
                a = ("off", "on")[t % 2]
                name = form.format(p=person.format(p), w=guide.format(w), a=a, t=t, b=w) + ".csv"
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).touch()
                trial = t if "{b}" in form else 2 * (t - 1) + w  # one block of both regions
                expected[name] = (person.format(p), str(trial), guide.format(w), a)
    draft = drafted(folder)
    assert not draft.empty
    assert not draft.unnamed
    columns = [draft.columns[name] for name in ("participant", "trial", "waveguide", "actuation")]
    rows = dict(zip(draft.columns["file"], zip(*columns, strict=True), strict=True))
    assert rows == expected


def test_blanks_in_the_names_of_people(tmp_path):
    people = ("ann", "de Vries", "van der Berg")
    for name in (f"{who}_blk1_WG1_{a}_{t}.csv" for who in people for a in ("on", "off") for t in (1, 2)):
        (tmp_path / name).touch()
    draft = drafted(tmp_path)
    assert not draft.empty
    assert set(draft.columns["participant"]) == set(people)


def test_a_draft_is_written_once_and_read(inside, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = written(tmp_path / "lab", simulated(trials=4))
    rows = list(csv.DictReader((folder / "trials.csv").read_text("utf-8").splitlines()))
    (folder / "trials.csv").unlink()
    for row in rows:
        name = (
            f"{row['participant']}_{row['waveguide']}_blk{row['block']}_{row['actuation']}_{row['trial']}.csv"
        )
        (folder / row["file"]).rename(folder / name)
    ran = inside("friction", folder, "--draft")
    assert ran.code == 0, ran.err
    assert "was drafted from the names of 24 files" in " ".join(ran.out.split())
    assert not (tmp_path / "results").exists()
    assert analysed(folder, Sensor(), Rules()).trials.sizes["stroke"] == 24
    before = (folder / "trials.csv").read_text("utf-8")
    assert_five_parts(inside("friction", folder, "--draft"), code="repeated", argument="--draft")
    assert (folder / "trials.csv").read_text("utf-8") == before


def test_the_draft_of_names_that_number_each_condition_from_1_is_read(inside, tmp_path):
    folder = written(tmp_path / "lab", simulated(trials=4))
    rows = list(csv.DictReader((folder / "trials.csv").read_text("utf-8").splitlines()))
    (folder / "trials.csv").unlink()
    seen = Counter()
    for row in rows:
        condition = (row["participant"], row["block"], row["actuation"])
        seen[condition] += 1
        name = f"{row['participant']}_blk{row['block']}_{row['actuation']}_{seen[condition]:02d}.csv"
        (folder / row["file"]).rename(folder / name)
    ran = inside("friction", folder, "--draft")
    assert ran.code == 0, ran.err
    assert "were numbered consecutively" in " ".join(ran.out.split())
    table = folder / "trials.csv"
    drafted_rows = list(csv.DictReader(table.read_text("utf-8").splitlines()))
    assert {row["waveguide"] for row in drafted_rows} == {""}
    by_file = {row["file"]: row["trial"] for row in drafted_rows}
    first = next(name for name in by_file if name.endswith("off_01.csv"))
    assert [by_file[first.replace("off_01", end)] for end in ("off_01", "on_01", "off_02")] == ["1", "2", "3"]
    with table.open("w", newline="", encoding="utf-8") as file:
        filled = csv.DictWriter(file, drafted_rows[0])
        filled.writeheader()
        filled.writerows(row | {"waveguide": "plate"} for row in drafted_rows)
    assert analysed(folder, Sensor(), Rules()).trials.sizes["stroke"] == len(rows)


def test_columns_missing_from_file_names_are_left_empty(inside, tmp_path):
    for name in ("ann_blk1_01.csv", "ann_blk1_02.csv", "bob_blk2_01.csv"):
        (tmp_path / name).touch()
    draft = drafted(tmp_path)
    assert draft.empty == ("waveguide", "actuation")
    assert draft.columns["participant"] == ["ann", "ann", "bob"]
    assert draft.columns["block"] == ["1", "1", "2"]
    assert draft.columns["trial"] == ["1", "2", "1"]
    empty = tmp_path / "empty"
    empty.mkdir()
    assert_five_parts(inside("friction", empty, "--draft"), code="missing", argument="--draft")


@pytest.mark.parametrize(
    ("heads", "expected"),
    [
        (("Subject ID", "Trial No.", "File name"), {"participant": 0, "trial": 1, "file": 2}),
        (("VP", "Versuch", "Bereich"), {"participant": 0, "trial": 1, "waveguide": 2}),
        (("participant", "subject"), {"participant": 0}),
    ],
)
def test_columns_by_usual_words(heads, expected):
    assert meanings(heads, "trials.csv") == {name: heads[k] for name, k in expected.items()}


@pytest.mark.parametrize(("cell", "number"), [("B3", 3), ("03", 3), (3.0, 3), ("x", "x"), (1.5, 1.5)])
def test_numbers_of_blocks_and_trials(cell, number):
    assert whole_number(cell) == number
