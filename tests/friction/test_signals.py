"""From force records to trials: filters at their attenuation, strokes of known friction, every exclusion."""

import h5py
import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings, strategies as st

from five_parts import refused
from haptonic.errors import FrictionError, ResourceError
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import (
    OMISSIONS,
    REASONS,
    Label,
    Record,
    Rules,
    design_frequency,
    exclusions,
    measure,
    measured,
    read_records,
    read_trials,
    smoothed,
    write_trials,
)
from haptonic.friction.simulation import Truth, strokes

LABEL = Label("P1", 1, 1, "WG1", "on")


def stroke(friction=0.4, force=0.8, speed=0.08, noise=0.0, seed=0, bias=(0.0, 0.0)):
    """A stroke with 0.3 s before, 1 s of contact, 0.2 s after; moving all the time; arrays to spoil."""
    time = np.arange(1500) / 1000
    normal = force * np.clip(np.minimum(time - 0.3, 1.3 - time) / 0.05, 0, 1)
    normal *= 1 + 0.005 * np.sin(20 * time)  # no finger is quite steady; a channel at its end is
    rng = np.random.default_rng(seed)
    return {
        "normal": normal + noise * rng.standard_normal(1500) + bias[0],
        "tangential": -friction * normal + noise * rng.standard_normal(1500) + bias[1],
        "rate": 1000.0,
        "position": speed * time,
    }


class TestFilters:
    @pytest.mark.parametrize(("name", "level"), [("literal", -6.02), ("compensated", -3.01), ("none", 0.0)])
    def test_attenuation_at_50_hz(self, name, level):
        """A sine that passes the filter shows it, away from the ends."""
        time = np.arange(4000) / 1000
        through = smoothed(np.sin(2 * np.pi * 50 * time), 1000.0, name)[1000:3000]
        attenuation = 20 * np.log10(np.sqrt(2 * np.mean(through**2)))
        assert attenuation == pytest.approx(level, abs=0.01)

    def test_the_compensated_design_is_the_stated_one(self):
        assert design_frequency("compensated", 1000.0) == pytest.approx(62.05, abs=0.005)
        assert design_frequency("literal", 1000.0) == 50.0

    @pytest.mark.parametrize("name", ["literal", "compensated"])
    def test_no_delay_and_no_change_of_the_mean(self, name):
        time = np.arange(2001) / 1000
        pulse = np.exp(-(((time - 1) / 0.05) ** 2))
        through = smoothed(pulse, 1000.0, name)
        assert np.argmax(through) == 1000
        assert through.sum() == pytest.approx(pulse.sum(), rel=1e-4)

    def test_bad_filters_are_refused(self):
        refused(
            lambda: smoothed(np.ones(50), 1000.0, "litteral"),
            'write "literal"',
            code="unknown",
            argument="filter",
        )
        refused(lambda: smoothed(np.ones(50), 1.0), "1 Hz", code="out-of-range", argument="rate")
        refused(lambda: smoothed(np.ones(50), float("nan")), "nan", code="out-of-range", argument="rate")
        refused(lambda: smoothed(np.ones(9), 1000.0), "9 samples", code="too-few", argument="signals")


class TestMeasure:
    @settings(max_examples=20)
    @given(st.floats(0.02, 2), st.floats(0.2, 3), st.floats(0.02, 0.4), st.floats(-3, 3), st.floats(-3, 3))
    def test_a_clean_stroke_gives_its_friction(self, friction, force, speed, normal_bias, tangential_bias):
        """Whatever the force, the speed and the bias of the sensor."""
        result = measure(
            Record(**stroke(friction, force, speed, noise=1e-6, bias=(normal_bias, tangential_bias)))
        )
        assert result.excluded == ""
        assert result.mean_of_ratios == pytest.approx(friction, rel=1e-3)
        assert result.ratio_of_means == pytest.approx(friction, rel=1e-3)
        assert result.speed == pytest.approx(speed, rel=0.01)
        assert result.force == pytest.approx(force, rel=0.06)
        assert result.duration == pytest.approx(1.0, abs=0.06)

    def test_the_two_averages_differ_as_they_should(self):
        """Twice the friction while pressed half as hard: 0.3 of ratios, 0.2667 of means."""
        signals = stroke(friction=1.0, force=1.0)
        half = np.arange(1500) < 800
        signals["normal"] = signals["normal"] * np.where(half, 1.0, 0.5)
        signals["tangential"] = signals["normal"] * np.where(half, 0.2, 0.4)
        result = measure(Record(**signals))
        assert result.mean_of_ratios == pytest.approx(0.3, abs=0.01)
        assert result.ratio_of_means == pytest.approx(0.8 / 3, abs=0.01)
        assert result.spread == pytest.approx(0.1, abs=0.01)

    def test_noise_of_the_sensor(self):
        """21 mN rms: below 50 Hz little is left of it."""
        frictions = [measure(Record(**stroke(noise=0.021, seed=seed))).mean_of_ratios for seed in range(20)]
        assert np.mean(frictions) == pytest.approx(0.4, abs=0.003)
        assert np.std(frictions) < 0.004

    def test_the_way_back_does_not_count(self):
        signals = stroke()
        back = np.arange(1500) > 1000
        signals["position"] = np.where(back, 0.08 * (2 - np.arange(1500) / 1000), signals["position"])
        signals["tangential"][back] *= -3
        result = measure(Record(**signals))
        assert result.mean_of_ratios == pytest.approx(0.4, rel=0.02)
        assert result.reversing == pytest.approx(0.2, abs=0.02)

    def test_speeding_up_does_not_count(self):
        signals = stroke()
        slow = np.arange(1500) < 700
        signals["position"] = np.cumsum(np.where(slow, 0.008, 0.08)) / 1000
        signals["tangential"] *= np.where(slow, 3, 1)
        result = measure(Record(**signals))
        assert result.mean_of_ratios == pytest.approx(0.4, rel=0.03)
        assert result.off_plateau == pytest.approx(400 / 1500, abs=0.02)
        assert result.below_threshold == pytest.approx(500 / 1500, abs=0.02)

    def test_without_a_position_the_middle_counts(self):
        signals = stroke()
        signals["position"] = None
        signals["tangential"][:500] *= 3  # the first fifth of the contact is left out
        result = measure(Record(**signals))
        assert result.mean_of_ratios == pytest.approx(0.4, rel=5e-3)
        assert np.isnan(result.speed)
        assert result.duration == pytest.approx(0.6, abs=0.01)

    def test_without_a_position_the_way_back_is_seen_in_the_force(self):
        signals = stroke()
        signals["position"] = None
        signals["tangential"][900:] *= -3  # within the middle of the contact, which ends at 1.1 s
        result = measure(Record(**signals))
        assert result.mean_of_ratios == pytest.approx(0.4, rel=0.03)
        assert result.duration == pytest.approx(0.4, abs=0.02)
        assert result.reversing == pytest.approx(400 / 1500, abs=0.02)

    def test_the_shares_add_up(self):
        result = measure(Record(**stroke()))
        shares = result.below_threshold + result.reversing + result.off_plateau + result.duration / 1.5
        assert shares == pytest.approx(1)


def spoiled(what):
    signals = stroke()
    if what == "missing numbers":
        signals["tangential"][700] = np.nan
    elif what == "record too short":
        signals = {name: array[:9] if name != "rate" else array for name, array in signals.items()}
    elif what == "saturated channel":
        # noise shows that it is an end even where other strokes go beyond
        noise = 1e-3 * np.random.default_rng(0).standard_normal(1500)
        signals["normal"] = np.minimum(signals["normal"] + noise, 0.5)
    elif what == "jump of a channel":
        signals["tangential"][700] += 5
    elif what == "stop of a channel":
        signals["normal"] += 1e-3 * np.random.default_rng(0).standard_normal(1500)
        signals["normal"][600:700] = signals["normal"][600]
    elif what == "contact before the stroke":
        signals = {name: array[310:] if name != "rate" else array for name, array in signals.items()}
    elif what == "normal force in the other direction":
        signals["normal"] *= -1
    elif what == "no contact":
        signals["normal"] = 0.01 * np.sin(np.arange(1500.0))
    elif what == "steady part too short":
        signals["normal"] *= np.abs(np.arange(1500) - 800) < 40
    elif what == "drift of the sensor":
        signals["normal"] += 0.1 * np.arange(1500) / 1000
        signals = {name: array[:1200] if name != "rate" else array for name, array in signals.items()}
    elif what == "normal force outside of the rule":
        signals["normal"] *= 10
        signals["tangential"] *= 10
    elif what == "speed outside of the rule":
        signals["position"] *= 10
    return Record(**signals)


@pytest.mark.parametrize("reason", REASONS)
def test_every_reason_has_its_trial(reason):
    assert measure(spoiled(reason)).excluded == reason


@pytest.mark.parametrize("offset", [0.3, -0.3, 2.0])
def test_a_finger_from_the_first_sample_is_seen_beside_an_offset(offset):
    """The sensor does not return to zero, but it is quiet when the finger has gone."""
    signals = stroke(noise=2e-3, bias=(offset, 0.1))
    pressed = signals["normal"] - offset
    signals["normal"] += 0.05 * pressed * np.sin(np.arange(1500) / 50)
    signals = {name: array[360:] if name != "rate" else array for name, array in signals.items()}
    for sign in (1, -1):
        signals["normal"] *= sign
        assert measure(Record(**signals)).excluded == "contact before the stroke"


def test_excluded_trials_stay_in_the_table():
    records = [(Label("P1", 1, n + 1, "WG1", "on"), spoiled(reason)) for n, reason in enumerate(REASONS)]
    records.append((Label("P1", 1, 99, "WG1", "on"), Record(**stroke())))
    table = measured(records)
    counts = exclusions(table)
    assert table.sizes["stroke"] == len(REASONS) + 1
    assert counts == dict.fromkeys(REASONS, 1) | dict.fromkeys(OMISSIONS, 0)
    assert table["excluded"].values[-1] == ""
    assert list(table["trial"].values) == [*range(1, len(REASONS) + 1), 99]


@pytest.mark.parametrize("which", [0, 3, 7])
@pytest.mark.parametrize("offset", [0.0, -2.0])
def test_a_finger_that_lies_on_the_plate_all_the_time_is_seen_beside_other_trials(which, offset):
    records = []
    for trial in range(8):
        signals = stroke()
        signals["normal"] += offset + 0.02 * trial
        if trial == which:  # pressed from the start to the end, by a force that rises a little
            signals = {name: array[500:1000] if name != "rate" else array for name, array in signals.items()}
            signals["normal"] *= np.linspace(1, 1.3, 500) if not offset else 1
            signals["normal"] += 0.3 * np.linspace(0, 1, 500) if offset else 0
        records.append((Label("P1", 1, trial + 1, "WG1", "on"), Record(**signals)))
    excluded = measured(records)["excluded"].values
    assert excluded[which] != ""
    assert (np.delete(excluded, which) == "").all()


def test_a_record_twice_is_refused():
    record = Record(**stroke())
    refused(
        lambda: measured([(LABEL, record), (LABEL, record)]),
        "more than once",
        code="repeated",
        argument="records",
    )
    refused(lambda: measured([]), "none", code="missing", argument="records")


@pytest.mark.parametrize(
    ("name", "array", "code", "argument", "given"),
    [
        ("normal", np.full(1500, 2000.0), "malformed", "record.normal", "2000 N"),
        ("tangential", np.full(1500, -800.0), "malformed", "record.tangential", "800 N"),
        ("position", np.linspace(0, 140, 1500), "malformed", "record.position", "140 m"),
        ("tangential", np.ones(1499), "malformed", "record.tangential", "(1499,)"),
        ("tangential", np.ones((1500, 3)), "malformed", "record.tangential", "(1500, 3)"),
        ("normal", np.array(["a"] * 1500), "malformed", "record.normal", "<U1"),
        ("rate", 0.0, "malformed", "record.rate", "0.0 Hz"),
        ("rate", float("nan"), "malformed", "record.rate", "nan"),
    ],
)
def test_bad_records_are_refused(name, array, code, argument, given):
    refused(lambda: Record(**(stroke() | {name: array})), given, code=code, argument=argument)


@pytest.mark.parametrize(
    ("rules", "code", "argument", "given"),
    [
        ({"threshold": 100.0}, "out-of-range", "trials.threshold", "100"),
        ({"threshold": float("nan")}, "out-of-range", "trials.threshold", "nan"),
        ({"plateau": 50}, "out-of-range", "trials.plateau", "50"),
        ({"steady": "0.1 N"}, "malformed", "trials.steady", "0.1 N"),
        ({"steady": True}, "malformed", "trials.steady", "True"),
        ({"force": (5.0, 0.1)}, "conflict", "trials.force", ""),
        ({"speed": 0.078}, "malformed", "trials.speed", "0.078"),
        ({"filter": "bessel"}, "unknown", "trials.filter", "bessel"),
    ],
)
def test_bad_rules_are_refused(rules, code, argument, given):
    refused(lambda: Rules(**rules), given, code=code, argument=argument)


@pytest.mark.parametrize(
    ("label", "code", "argument"),
    [
        ({"actuation": "onn"}, "malformed", "actuation of participant P1, block 1, trial 1"),
        ({"participant": " "}, "malformed", "participant of participant  , block 1, trial 1"),
        ({"block": 0}, "malformed", "block of participant P1, block 0, trial 1"),
        ({"trial": 1.5}, "malformed", "trial of participant P1, block 1, trial 1.5"),
        ({"waveguide": None}, "malformed", "waveguide of participant P1, block 1, trial 1"),
    ],
)
def test_bad_labels_are_refused(label, code, argument):
    good = {"participant": "P1", "block": 1, "trial": 1, "waveguide": "WG1", "actuation": "on"}
    refused(lambda: Label(**(good | label)), code=code, argument=argument)


class TestFiles:
    def rows(self):
        """Two simulated trials, one row for each sample."""
        parts = []
        for n, (label, record, _) in enumerate(strokes(Truth(), Protocol(2, 2), 1)):
            if n < 2:
                parts.append(
                    pd.DataFrame(
                        {
                            "participant": label.participant,
                            "block": label.block,
                            "trial": label.trial,
                            "waveguide": label.waveguide,
                            "actuation": label.actuation.upper(),
                            "time": 5.0 + np.arange(len(record.normal)) / 1000,
                            "normal": record.normal,
                            "tangential": record.tangential,
                            "position": record.position,
                        }
                    )
                )
        return pd.concat(parts, ignore_index=True)

    def written(self, table, path):
        if path.suffix == ".csv":
            table.to_csv(path, index=False)
        elif path.suffix == ".nc":
            table.to_xarray().drop_vars("index").to_netcdf(path, engine="h5netcdf")
        else:
            with h5py.File(path, "w") as file:
                for name in table:
                    array = table[name].to_numpy()
                    file[name] = array if array.dtype.kind in "fi" else [str(cell) for cell in array]
        return path

    @pytest.mark.parametrize("name", ["a.csv", "a.nc", "a.h5", "a.hdf5"])
    def test_every_format_gives_the_same_trials(self, tmp_path, name):
        table = self.rows()
        records = dict(read_records(self.written(table, tmp_path / name)))
        assert list(records) == [Label("P1", 1, 1, "WG2", "on"), Label("P1", 1, 2, "WG2", "off")]
        for label, record in records.items():
            rows = table[table["trial"] == label.trial]
            assert record.rate == pytest.approx(1000)
            assert record.normal == pytest.approx(rows["normal"].to_numpy())
            assert record.tangential == pytest.approx(rows["tangential"].to_numpy())
            assert record.position == pytest.approx(rows["position"].to_numpy())

    @pytest.mark.parametrize(
        ("spoil", "code", "argument", "given"),
        [
            (lambda t: t.drop(columns="normal"), "missing", "a.csv: column normal", ""),
            (
                lambda t: t.rename(columns={"tangential": "tangental"}),
                "missing",
                "a.csv: column tangential",
                "",
            ),
            (
                lambda t: t.assign(time=t["time"].to_numpy()[::-1]),
                "malformed",
                "a.csv, participant P1, block 1, trial 1",
                "times that do not advance evenly",
            ),
            (
                lambda t: t.drop(index=range(500, 600)),
                "malformed",
                "a.csv, participant P1, block 1, trial 1",
                "no sample for 0.101 s after 0.499 s",
            ),
            (
                lambda t: t.assign(actuation="maybe"),
                "malformed",
                "actuation of participant P1, block 1, trial 1",
                "",
            ),
            (
                lambda t: t.assign(waveguide=["WG1", *["WG2"] * (len(t) - 1)]),
                "malformed",
                "a.csv",
                "waveguide changes",
            ),
            (lambda t: t.assign(normal=1000 * t["normal"]), "malformed", "record.normal", ""),
            (lambda t: t.assign(normal="0,8"), "malformed", "a.csv", "text in the column normal"),
            (lambda t: t.assign(block=1.5), "malformed", "block of participant P1, block 1.5, trial 1", ""),
            (lambda t: t.iloc[:0], "missing", "a.csv", "no rows below the head"),
        ],
    )
    def test_bad_tables_of_records(self, tmp_path, spoil, code, argument, given):
        path = self.written(spoil(self.rows()), tmp_path / "a.csv")
        refused(lambda: list(read_records(path)), given, code=code, argument=argument)

    def test_all_missing_columns_are_named_at_once(self, tmp_path):
        rows = self.rows().drop(columns=["participant", "block"])
        path = self.written(rows.rename(columns={"time": "times"}), tmp_path / "a.csv")
        with pytest.raises(FrictionError) as error:
            list(read_records(path))
        assert error.value.argument == "a.csv: columns participant, block and time"
        assert (
            error.value.next_step == 'rename "times" to "time" and add "participant" and "block" to every row'
        )

    def test_files_that_cannot_be_read(self, tmp_path):
        (tmp_path / "b.nc").write_bytes(b"no such thing")
        (tmp_path / "b.h5").write_bytes(b"no such thing")
        (tmp_path / "b.csv").write_bytes(b"\x00\x81\xff\xfe")
        for name in ("a.csv", "a.nc", "a.h5", "b.nc", "b.h5", "b.csv"):
            with pytest.raises(ResourceError):
                list(read_records(tmp_path / name))
        refused(
            lambda: list(read_records(tmp_path / "a.tdms")),
            "a.tdms",
            code="malformed",
            argument="table of trials",
        )

    @pytest.mark.parametrize("name", ["t.csv", "t.nc"])
    def test_trials_come_back(self, tmp_path, name):
        records = [(label, record) for label, record, _ in strokes(Truth(), Protocol(2, 2), 2)]
        records.append((Label("P9", 1, 1, "WG1", "off"), spoiled("no contact")))
        table = measured(records)
        write_trials(table, tmp_path / name)
        back = read_trials(tmp_path / name)
        for column in ("participant", "block", "trial", "waveguide", "actuation", "excluded"):
            assert list(back[column].values) == list(table[column].values), column
        for column in ("friction", "ratio_of_means", "force", "speed"):
            assert back[column].values == pytest.approx(table[column].values, nan_ok=True)

    def test_bad_tables_of_trials(self, tmp_path):
        good = pd.DataFrame(
            {
                "participant": ["1", "1"],
                "block": [1, 1],
                "trial": [1, 2],
                "waveguide": "WG1",
                "actuation": ["on", "off"],
                "friction": [0.2, 0.4],
            }
        )
        path = tmp_path / "t.csv"
        good.to_csv(path, index=False)
        assert read_trials(path)["participant"].values.tolist() == ["1", "1"]  # a name, though a number
        for bad, shown, code, argument in (
            (good.assign(friction=[-0.2, 0.4]), "-0.2", "malformed", "t.csv"),
            (good.assign(friction=[20.0, 40.0]), "friction 20", "malformed", "t.csv"),
            (good.drop(columns="friction"), "actuation", "missing", "column friction"),
            (good.assign(participant=None), "''", "malformed", "block 1, trial 1"),
        ):
            bad.to_csv(path, index=False)
            refused(lambda: read_trials(path), shown, code=code, argument=argument)
        good.to_csv(path, index=False)
        refused(
            lambda: write_trials(read_trials(path), tmp_path / "t.xlsx"),
            "t.xlsx",
            code="malformed",
            argument="table of trials",
        )
