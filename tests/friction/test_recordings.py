"""From folders of files to trials: every format, guesses, units, calibration, and all that can be wrong."""

import dataclasses

import h5py
import numpy as np
import pandas as pd
import pytest

from five_parts import refused, refusing
from haptonic.errors import ResourceError
from haptonic.friction.recordings import Exclusion, Sensor, analysed, read_calibration, traces
from haptonic.friction.recordings.trial_table import TrialTable
from haptonic.friction.signals import Record, Rules, exclusions, measure, measured
from haptonic.friction.signals.measuring import measure_all
from trial_folders import channels, edited, simulated, written

MADE = simulated(trials=2)
TRUE = measured(MADE)["friction"].values
FEW, FEW_TRUE = MADE[:4], TRUE[:4]  # of one person
PLAIN = Sensor()
ALMOST_DEPENDENT = np.eye(6)
ALMOST_DEPENDENT[0] = ALMOST_DEPENDENT[1] + 1e-9 * ALMOST_DEPENDENT[0]


def friction_in(folder, sensor=PLAIN, **more):
    return analysed(folder, sensor, Rules(), **more).trials


def counts(trials):
    return {reason: count for reason, count in exclusions(trials).items() if count}


class TestTogether:
    def test_strokes_measured_together_or_alone_give_the_same_numbers(self):
        """Other lengths, rates, with and without position, and some spoiled ones between them."""
        records = [record for _, record in MADE[:12]]
        records[2] = Record(
            records[2].normal[:-7], records[2].tangential[:-7], 1000.0, records[2].position[:-7]
        )
        records[4] = Record(records[4].normal, records[4].tangential, 1000.0)
        records[5] = Record(records[5].normal, records[5].tangential, 900.0, records[5].position)
        records[6] = Record(0 * records[6].normal, records[6].tangential, 1000.0, records[6].position)
        records[7] = Record(records[7].normal, records[7].tangential, 1000.0, records[7].position, True)
        together = measure_all(records)
        for row, record in enumerate(records):
            alone = measure(record)
            for name, column in together.items():
                value = getattr(alone, name)
                same = value if isinstance(value, str) else pytest.approx(value, nan_ok=True, rel=1e-9)
                assert column[row] == same, (row, name)
        assert together["excluded"][6] == "no contact"
        assert together["excluded"][7] == "saturated channel"


class TestFormats:
    @pytest.mark.parametrize("kind", ["csv", "h5", "hdf5", "mat", "tdms"])
    @pytest.mark.parametrize("per", ["trial", "block"])
    def test_every_format_gives_the_same_trials(self, tmp_path, kind, per):
        trials = friction_in(written(tmp_path / "a", FEW, kind=kind, per=per))
        assert trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert trials["trial"].values.tolist() == [label.trial for label, _ in FEW]
        assert trials.attrs["origin"] == "measured"

    def test_records_that_are_missing_are_named(self, tmp_path):
        folder = written(tmp_path / "a", FEW)
        lost = sorted(folder.glob("P*.csv"))[:2]
        for path in lost:
            path.unlink()
        doubts = analysed(folder, PLAIN, Rules()).doubts
        named = [doubt for doubt in doubts if doubt.startswith("1 trial without a readable record: ")]
        assert len(named) == len(lost)
        assert all(path.name in doubt for path, doubt in zip(lost, sorted(named), strict=True))

    def test_workers_change_nothing(self, tmp_path):
        folder = written(tmp_path / "a", MADE, per="block", kind="h5")
        seen = []
        trials = friction_in(folder, workers=1, progress=lambda *seen_now: seen.append(seen_now))
        assert trials["friction"].values == pytest.approx(TRUE, rel=1e-9)
        assert seen[-1] == (len(MADE), len(MADE))

    def test_groups_of_one_hdf5_file(self, tmp_path):
        folder = written(tmp_path / "a", FEW)
        with h5py.File(folder / "all.h5", "w") as file:
            file.attrs["sample_rate"] = 1000.0
            for row, (_, record) in enumerate(FEW):
                for name, values in channels([record]).items():
                    if name != "time":
                        file[f"trial {row}/{name}"] = values
        table = edited(folder, lambda t: t.assign(file="all.h5", group=[f"trial {n}" for n in range(len(t))]))
        assert friction_in(table)["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        missing = edited(folder, lambda t: t.assign(group=["trial 0", "nowhere", *t["group"][2:]]))
        trials = friction_in(missing)
        assert counts(trials) == {"unreadable record": 1}
        assert "nowhere" in str(trials["detail"].values[1])

    def test_a_program_with_decimal_commas(self, tmp_path):
        folder = written(tmp_path / "a", FEW)
        for path in folder.glob("P*.csv"):
            pd.read_csv(path).to_csv(path, sep=";", decimal=",", index=False)
        assert friction_in(folder)["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)

    def test_a_single_table_of_samples(self, tmp_path):
        parts = []
        for label, record in FEW:
            part = pd.DataFrame(channels([record])).rename(columns={"Fz": "normal", "Fy": "tangential"})
            parts.append(part.assign(**{name: getattr(label, name) for name in label.__dataclass_fields__}))
        pd.concat(parts).assign(origin="simulated").to_csv(tmp_path / "all.csv", index=False)
        trials = friction_in(tmp_path / "all.csv")
        assert trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert trials.attrs["origin"] == "simulated"

    def test_a_table_of_trials_that_were_measured_elsewhere(self, tmp_path):
        table = measured(FEW).to_dataframe()[
            ["participant", "block", "trial", "waveguide", "actuation", "friction"]
        ]
        table.to_csv(tmp_path / "done.csv", index=False)
        assert friction_in(tmp_path / "done.csv")["friction"].values == pytest.approx(FEW_TRUE)


class TestOrigin:
    @pytest.mark.parametrize("kind", ["csv", "h5", "tdms"])
    def test_simulated_travels_from_the_file(self, tmp_path, kind):
        folder = written(tmp_path / "a", FEW, kind=kind)
        name = sorted(folder.glob(f"P*.{kind}"))[-1]
        if kind == "csv":
            pd.read_csv(name).assign(origin="simulated").to_csv(name, index=False)
        elif kind == "h5":
            with h5py.File(name, "a") as file:
                file.attrs["origin"] = "simulated"
        else:
            from nptdms import RootObject, TdmsFile, TdmsWriter

            parts = TdmsFile.read(name).groups()[0].channels()
            with TdmsWriter(name) as file:
                file.write_segment([RootObject({"origin": "simulated"}), *parts])
        assert friction_in(folder).attrs["origin"] == "simulated"

    def test_simulated_travels_from_the_table(self, tmp_path):
        folder = written(tmp_path / "a", FEW, origin="measured")
        assert friction_in(folder).attrs["origin"] == "measured"
        mixed = edited(folder, lambda t: t.assign(origin=["simulated", *t["origin"][1:]]))
        assert friction_in(mixed).attrs["origin"] == "simulated"
        refused(
            lambda: friction_in(edited(folder, lambda t: t.assign(origin="guessed"))),
            "guessed",
            code="malformed",
            argument="trials.csv: column origin",
        )


def renamed(**names):
    return lambda signals: {names.get(name, name): values for name, values in signals.items()}


class TestSensor:
    @pytest.mark.parametrize(
        ("names", "scale"),
        [
            ({"Fz": "Force Z", "Fy": "Force Y"}, 1.0),
            ({"Fz": "Fz (mN)", "Fy": "Fy [mN]"}, 1e3),
            ({"Fz": "normal_force", "Fy": "tangential", "time": "Time [s]"}, 1.0),
        ],
    )
    def test_usual_names_are_guessed_and_reported(self, tmp_path, names, scale):
        def change(signals):
            scaled = signals | {"Fz": scale * signals["Fz"], "Fy": scale * signals["Fy"]}
            return renamed(**names)(scaled)

        read = analysed(written(tmp_path / "a", FEW, change=change), PLAIN, Rules())
        assert read.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert any("was taken as normal" in text for text in read.remarks)

    def test_the_sign_of_a_sensor_below_the_plate_is_found_and_reported(self, tmp_path):
        folder = written(tmp_path / "a", FEW, change=lambda signals: signals | {"Fz": -signals["Fz"]})
        read = analysed(folder, PLAIN, Rules())
        assert read.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert "sign was turned" in " ".join(read.remarks)
        named = analysed(folder, Sensor(normal="-Fz", tangential="Fy"), Rules())
        assert named.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert "sign" not in " ".join(named.remarks)
        plain = analysed(folder, Sensor(normal="Fz"), Rules())
        assert plain.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert "sign was turned" in " ".join(plain.remarks)
        refused(
            lambda: friction_in(written(tmp_path / "b", FEW), Sensor(normal="-Fz")),
            "leave the minus out",
            code="too-few",
            argument="trials",
        )

    def test_names_units_and_rate_of_the_study_are_used(self, tmp_path):
        def change(signals):
            return {"A": 1e3 * signals["Fz"], "B": 1e3 * signals["Fy"], "C": 1e3 * signals["position"]}

        folder = written(tmp_path / "a", FEW, change=change)
        sensor = Sensor(
            normal="A", tangential="B", position="C", force_unit="mN", position_unit="mm", rate=1000.0
        )
        trials = friction_in(folder, sensor)
        assert trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-9)
        assert trials["speed"].values == pytest.approx(measured(FEW)["speed"].values)
        refused(
            lambda: friction_in(folder, Sensor(normal="A", tangential="B")),
            "neither times nor a rate",
            code="missing",
            argument="P1-B1-T1.csv: sampling rate",
        )

    def test_a_calibration_matrix_makes_forces_of_gauges(self, tmp_path):
        """Gauges are the matrix' inverse of simulated forces and torques, and return the same forces."""
        matrix = np.random.default_rng(1).normal(size=(6, 6)) * np.array([[3.0]] * 3 + [[0.02]] * 3)
        pd.DataFrame(matrix).to_csv(tmp_path / "m.csv", header=False, index=False)

        def change(signals):
            six = np.array(
                [signals["Fx"], signals["Fy"], signals["Fz"], *0.01 * np.ones((3, len(signals["Fz"])))]
            )
            volts = np.linalg.solve(matrix, six) + 0.5
            return {"time": signals["time"], "position": signals["position"]} | {
                f"G{n}": volts[n] for n in range(6)
            }

        folder = written(tmp_path / "a", FEW, change=change)
        calibration, opposite = str(tmp_path / "m.csv"), str(tmp_path / "opposite.csv")
        pd.DataFrame(-matrix).to_csv(opposite, header=False, index=False)
        assert read_calibration(tmp_path / "m.csv") == pytest.approx(matrix)
        read = analysed(folder, Sensor(calibration=calibration), Rules())
        assert read.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-6)
        assert "G0, G1, G2, G3, G4, G5" in " ".join(read.remarks)
        commas = {f"G{n}": f"G, {n}" for n in range(6)}
        named = written(
            tmp_path / "b", FEW,
            change=lambda signals: {commas.get(name, name): each for name, each in change(signals).items()},
        )  # fmt: skip
        sensor = Sensor(calibration=calibration, gauges=",".join(commas.values()))
        assert friction_in(named, sensor)["friction"].values == pytest.approx(FEW_TRUE, rel=1e-6)
        again = Sensor(calibration=calibration, gauges=",".join([*list(commas.values())[:5], "G, 0"]))
        refused(lambda: friction_in(named, again), code="malformed", argument="trials.sensor.gauges")
        turned = analysed(folder, Sensor(calibration=opposite), Rules())
        assert turned.trials["friction"].values == pytest.approx(FEW_TRUE, rel=1e-6)
        assert "sign was turned" in " ".join(turned.remarks)
        refused(
            lambda: Sensor(calibration=calibration, normal="G1"),
            code="unknown",
            argument="trials.sensor.normal",
        )
        refused(
            lambda: friction_in(folder),
            "such as normal =",
            code="unknown",
            argument="P1-B1-T1.csv: channel of the normal force",
        )
        clipped = Sensor(calibration=calibration, largest_gauge=0.5)
        refused(lambda: friction_in(folder, clipped), "saturated channel", code="too-few", argument="trials")

    @pytest.mark.parametrize(
        ("rows", "code", "argument", "given"),
        [
            (np.eye(5), "unreadable", "trials.sensor.calibration", "5 x 5"),
            (np.ones((6, 6)), "unreadable", "trials.sensor.calibration", "rank 1"),
            (np.diag([1, 1, 1, 1, 1, 0.0]), "unreadable", "trials.sensor.calibration", "rank 5"),
            (np.eye(6) + np.diag([np.nan] * 6), "unreadable", "trials.sensor.calibration", "rank"),
            (ALMOST_DEPENDENT, "unreadable", "trials.sensor.calibration", "rank 6, condition number"),
        ],
    )
    def test_bad_calibrations_are_refused(self, tmp_path, rows, code, argument, given):
        pd.DataFrame(rows).to_csv(tmp_path / "m.csv", header=False, index=False)
        refused(lambda: read_calibration(tmp_path / "m.csv"), given, code=code, argument=argument)
        refused(
            lambda: read_calibration(tmp_path / "none.csv"),
            code="not-found",
            argument="trials.sensor.calibration",
        )
        (tmp_path / "t.csv").write_text("a,b\nc,d\n")
        refused(
            lambda: read_calibration(tmp_path / "t.csv"),
            "no table of numbers",
            code="unreadable",
            argument="trials.sensor.calibration",
        )

    def test_the_matrix_may_have_names_of_axes_around_it(self, tmp_path):
        axes = ["Fx", "Fy", "Fz", "Tx", "Ty", "Tz"]
        pd.DataFrame(np.diag(np.arange(1.0, 7)), axes, [f"G{n}" for n in range(6)]).to_csv(tmp_path / "m.csv")
        assert read_calibration(tmp_path / "m.csv") == pytest.approx(np.diag(np.arange(1.0, 7)))

    def test_a_force_at_the_end_of_the_range_is_saturated(self, tmp_path):
        folder = written(tmp_path / "a", FEW)
        largest = np.array([max(record.normal) for _, record in FEW])
        limit = float(np.median(largest))
        trials = friction_in(folder, Sensor(largest_force=limit))
        assert ((trials["excluded"].values == "saturated channel") == (largest >= limit)).all()


def spoiled(name, change):
    """A change of one file of a folder of CSV files."""

    def spoil(folder):
        path = sorted(folder.glob("P*.csv"))[3]
        if name == "remove":
            path.unlink()
        elif name == "bytes":
            path.write_bytes(change)
        else:
            change(pd.read_csv(path)).to_csv(path, index=False)
        return path.name

    return spoil


@pytest.mark.parametrize("sensor", [PLAIN, dataclasses.replace(PLAIN, rate=1000.0)], ids=["times", "rate"])
def test_rows_that_repeat_the_row_above_them_are_left_out(tmp_path, sensor):
    folder, rng = written(tmp_path / "a", FEW), np.random.default_rng(1)
    once = friction_in(folder, sensor)
    for path in folder.glob("P*.csv"):
        names, *rows = path.read_text().splitlines()
        times = rng.choice([1, 1, 1, 2, 4], len(rows))
        path.write_text("\n".join([names, *np.repeat(rows, times)]) + "\n")
    repeated = analysed(folder, sensor, Rules())
    for name in ("friction", "speed", "duration"):
        assert repeated.trials[name].values == pytest.approx(once[name].values, rel=1e-9), name
    assert any("repeat the row above" in text for text in repeated.doubts)


class TestOmissions:
    """One trial is left out and named; the others stay."""

    @pytest.mark.parametrize(
        ("spoil", "reason", "word"),
        [
            (spoiled("remove", None), "unreadable record", "no such file"),
            (spoiled("bytes", b"\x00\x81\xff\xfe"), "unreadable record", "damaged"),
            (spoiled("bytes", b""), "unreadable record", "damaged"),
            (spoiled("", lambda t: t.drop(columns="Fy")), "unreadable record", "channel Fy"),
            (spoiled("", lambda t: t.assign(Fz=2000.0)), "unreadable record", "2000 N"),
            (spoiled("", lambda t: t.assign(Fz="0,8")), "unreadable record", "decimal commas"),
            (spoiled("", lambda t: t.assign(time=1000 * t["time"])), "unreadable record", "ms"),
            (spoiled("", lambda t: t.assign(time=t["time"].to_numpy()[::-1])), "unreadable record", "evenly"),
            (spoiled("", lambda t: t.assign(Fz=t["Fz"].clip(upper=0.5))), "saturated channel", ""),
            (spoiled("", lambda t: t.assign(Fz=0.001 * np.sin(t["time"]))), "no contact", ""),
            (spoiled("", lambda t: t.assign(Fy=t["Fy"].where(t["time"] > 0.5))), "missing numbers", ""),
            (spoiled("", lambda t: t.iloc[:0]), "unreadable record", "0 times"),
        ],
    )
    def test_what_cannot_be_used(self, tmp_path, spoil, reason, word):
        folder = written(tmp_path / "a", FEW)
        name = spoil(folder)
        trials = friction_in(folder)
        assert counts(trials) == {reason: 1}
        (row,) = np.flatnonzero(trials["excluded"].values)
        table = pd.read_csv(folder / "trials.csv")
        assert table["file"][row] == name
        detail = str(trials["detail"].values[row])
        assert word in detail
        assert (name in detail) == (reason == "unreadable record")
        rest = np.delete(trials["friction"].values, row)
        assert rest == pytest.approx(np.delete(FEW_TRUE, row), rel=1e-9)

    @pytest.mark.parametrize(
        ("channel", "sensor"),
        [
            *((channel, PLAIN) for channel in ("time", "position", "Fx", "Fy", "Fz")),
            ("Fy", Sensor(largest_force=50.0)), ("time", Sensor(rate=1000.0)),
        ],
    )  # fmt: skip
    def test_a_channel_that_is_shorter_than_the_others(self, tmp_path, channel, sensor):
        """A force across that was cut ended in a traceback, as did others where a largest force was given."""
        folder = written(tmp_path / "a", FEW, kind="h5")
        name = sorted(folder.glob("P*.h5"))[3].name
        with h5py.File(folder / name, "r+") as file:
            values = file[channel][:-100]
            del file[channel]
            file[channel] = values
        trials = friction_in(folder, sensor)
        if sensor.rate is not None:  # times are not used
            assert not counts(trials)
            return
        assert counts(trials) == {"unreadable record": 1}
        (row,) = np.flatnonzero(trials["excluded"].values)
        assert f"{name}: channel {channel}" in str(trials["detail"].values[row])
        assert np.delete(trials["friction"].values, row) == pytest.approx(np.delete(FEW_TRUE, row), rel=1e-9)

    def test_times_beyond_the_end_of_a_block(self, tmp_path):
        folder = written(tmp_path / "a", MADE, per="block", kind="h5")
        trials = friction_in(edited(folder, lambda t: t.assign(start=t["start"] + 1000 * (t["trial"] == 2))))
        assert counts(trials) == {"unreadable record": 6}
        assert "start and stop" in str(trials["detail"].values[1])

    @pytest.mark.parametrize("name", ["x" * 60_000, "x" * 300, "folder/" * 2000 + "x", "a\x01b", "missing"])
    def test_a_name_that_no_file_has(self, tmp_path, name):
        """One of 60,000 characters ended in a traceback."""
        folder = written(tmp_path / "a", FEW, kind="h5")
        edited(folder, lambda t: t.assign(file=t["file"].where(t.index != 3, name)))
        trials = friction_in(folder)
        assert counts(trials) == {"unreadable record": 1}
        assert trials["excluded"].values[3] == "unreadable record"

    def test_declared_exclusions(self, tmp_path):
        folder = written(tmp_path / "a", MADE)
        trials = friction_in(
            folder,
            excluded=[Exclusion("P1", "slipped", 1, 2), Exclusion("P2", "ill", 2), Exclusion("P3", "left")],
        )
        assert counts(trials) == {"declared beforehand": 1 + 2 + 4}
        assert str(trials["detail"].values[1]) == "slipped"
        for wrong in (Exclusion("P9", "x"), Exclusion("P1", "x", 7), Exclusion("P1", "x", 1, 70)):
            refused(
                lambda exclusion=wrong: friction_in(folder, excluded=[exclusion]),
                code="mismatch",
                argument="trials.exclude[1]",
            )


class TestTables:
    @pytest.mark.parametrize(
        ("change", "code", "argument", "given"),
        [
            (lambda t: t.drop(columns="file"), "missing", "trials.csv: column file", ""),
            (
                lambda t: t.rename(columns={"participant": "particpant"}),
                "missing",
                "trials.csv: column participant",
                "",
            ),
            (
                lambda t: t.assign(file="/etc/passwd"),
                "malformed",
                "trials.csv: file of participant P1, block 1, trial 1",
                "",
            ),
            (
                lambda t: t.assign(file="../other.csv"),
                "malformed",
                "trials.csv: file of participant P1, block 1, trial 1",
                "",
            ),
            (
                lambda t: t.assign(file=""),
                "malformed",
                "trials.csv: file of participant P1, block 1, trial 1",
                "",
            ),
            (
                lambda t: t.assign(actuation="maybe"),
                "malformed",
                "actuation of participant P1, block 1, trial 1",
                "",
            ),
            (lambda t: t.assign(trial=1), "repeated", "records", "more than once"),
            (lambda t: t.iloc[:0], "missing", "trials.csv", "no rows below the head"),
            (lambda t: t.assign(start="soon", stop=1.0), "malformed", "trials.csv", ""),
            (lambda t: t.assign(file="gone.csv"), "not-found", "gone.csv: gone.csv", ""),
        ],
    )
    def test_wrong_tables_are_refused(self, tmp_path, change, code, argument, given):
        folder = edited(written(tmp_path / "a", MADE[:6]), change)
        refused(lambda: friction_in(folder), given, code=code, argument=argument)

    def test_a_record_of_several_trials_is_named(self, tmp_path):
        folder = written(tmp_path / "a", MADE[:6])
        assert not [text for text in TrialTable.read(folder).doubts if "another trial" in text]
        files = [f"P1-B1-T{trial}.csv" for trial in (1, 1, 1, 4, 5, 6)]
        edited(folder, lambda t: t.assign(file=files))
        (doubt,) = TrialTable.read(folder).doubts
        assert "2 trials have the record of another trial" in doubt
        edited(folder, lambda t: t.assign(start=np.arange(6.0), stop=np.arange(6.0) + 1.3))
        assert not TrialTable.read(folder).doubts

    def test_names_that_differ_in_capitals_are_named(self, tmp_path):
        folder = written(tmp_path / "a", MADE[:6])
        edited(folder, lambda t: t.assign(participant=["Ann", "ann", "Bo", "Ann", "Bo", "Bo"]))
        (doubt,) = TrialTable.read(folder).doubts
        assert "Ann and ann" in doubt

    def test_folders_without_a_table(self, tmp_path):
        for folder in (tmp_path, tmp_path / "none"):
            with refusing(ResourceError, "not-found", "folder of trials"):
                friction_in(folder)
        with pytest.raises(ResourceError):
            friction_in(tmp_path / "none.csv")

    def test_force_in_another_unit_everywhere(self, tmp_path):
        folder = written(
            tmp_path / "a", MADE[:6], change=lambda signals: signals | {"Fz": 2500 * signals["Fz"]}
        )
        refused(lambda: friction_in(folder), "6 of 6: unreadable record", code="too-few", argument="trials")

    def test_volts_without_a_calibration(self, tmp_path):
        folder = written(tmp_path / "a", MADE[:6], change=renamed(Fz="Fz (V)", Fy="Fy (V)"))
        refused(
            lambda: friction_in(folder),
            '"V"',
            code="malformed",
            argument="P1-B1-T1.csv: unit of the channel Fz",
        )


class TestTraces:
    def test_the_blocks_asked_for(self, tmp_path):
        folder = written(tmp_path / "a", MADE, per="block", kind="h5")
        blocks = list(traces(folder, PLAIN, Rules(), [("P2", 2), ("P1", 1)]))
        assert [(person, block) for person, block, _ in blocks] == [("P2", 2), ("P1", 1)]
        drawn = blocks[1][2]
        assert drawn["trial"].values.tolist() == [1, 2]
        # friction from the few points that are drawn is about that of all of them
        row = drawn.isel(stroke=0)
        steady = row["steady"].values
        ratio = (-row["tangential"].values / row["normal"].values)[steady].mean()
        assert ratio == pytest.approx(TRUE[0], rel=0.02)

    def test_what_cannot_be_read_is_not_in_it(self, tmp_path):
        folder = written(tmp_path / "a", MADE)
        (folder / "P1-B1-T2.csv").unlink()
        ((_, _, drawn),) = traces(folder, PLAIN, Rules(), [("P1", 1)])
        assert drawn["trial"].values.tolist() == [1]
