"""The simulated experiment: the analysis returns its truth; orders are balanced as stated."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from five_parts import refused
from haptonic.friction.participants import Participants
from haptonic.friction.protocol import Protocol, imbalance
from haptonic.friction.signals import Label, exclusions, measure, measured
from haptonic.friction.simulation import Truth, coefficients, strokes
from haptonic.friction.statistics import by_participants, by_trials, drift, paired, reduction, stopped


def statistic_table(truth, participants, seed):
    """Trials with their true coefficients: no forces, so that many experiments are cheap."""
    rows = list(coefficients(truth, Protocol(), participants, np.random.default_rng(seed)))
    columns = {
        name: [getattr(label, name) for label, _ in rows]
        for name in ("participant", "block", "trial", "waveguide", "actuation")
    }
    columns |= {"friction": [friction for _, friction in rows], "excluded": [""] * len(rows)}
    return xr.Dataset({name: ("stroke", np.array(values)) for name, values in columns.items()})


class TestStrokes:
    def test_the_friction_of_every_stroke_is_found_again(self):
        """Without noise of the sensor to a third of a percent, with it to a few per cent, and unbiased."""
        for noise, spread in ((0.0, 0.003), (0.021, 0.03)):
            simulated = list(strokes(Truth(Participants(noise=noise)), Protocol(2, 20), 2, seed=3))
            table = measured((label, record) for label, record, _ in simulated)
            assert exclusions(table) == dict.fromkeys(exclusions(table), 0)
            off = table["friction"].values / np.array([friction for *_, friction in simulated]) - 1
            assert np.sqrt(np.mean(off**2)) < spread
            assert abs(off.mean()) < 0.005

    def test_forces_speeds_and_noise_are_the_published_ones(self):
        records = [record for _, record, _ in strokes(Truth(), Protocol(4, 50), 1, seed=1)]
        results = [measure(record) for record in records]
        assert np.mean([result.speed for result in results]) == pytest.approx(0.078, abs=0.004)
        assert np.std([result.speed for result in results]) == pytest.approx(0.013, abs=0.004)
        assert np.mean([result.force for result in results]) == pytest.approx(0.8, abs=0.1)
        assert np.std([result.force for result in results]) == pytest.approx(0.35, abs=0.1)
        quiet = np.concatenate([record.normal[:200] for record in records])
        assert quiet.std() == pytest.approx(0.021, rel=0.02)
        assert quiet.mean() == pytest.approx(0.3, abs=0.001)

    def test_coefficients_are_those_of_the_population(self):
        """Means over 150 people: the level, what is left on either waveguide, and no net drift."""
        table = statistic_table(Truth(), 150, 0)
        on = table["actuation"] == "on"
        for guide, left in (("WG1", 0.45), ("WG2", 0.89)):
            here = table["waveguide"] == guide
            level = float(table["friction"][here & ~on].mean())
            assert level == pytest.approx(0.42, rel=0.04)
            assert float(table["friction"][here & on].mean()) == pytest.approx(left * level, rel=0.02)

    def test_both_channels_have_the_bias(self):
        records = [
            record for _, record, _ in strokes(Truth(Participants(bias=0.3)), Protocol(2, 10), 1, seed=1)
        ]
        quiet = np.concatenate([[record.normal[:200], record.tangential[:200]] for record in records], axis=1)
        assert quiet.mean(axis=1) == pytest.approx([0.3, -0.3], abs=0.003)

    def test_the_same_seed_the_same_experiment(self):
        first, same, other = (
            next(iter(strokes(Truth(), Protocol(2, 2), 1, seed)))[1].normal for seed in (1, 1, 2)
        )
        assert (first == same).all()
        assert (first != other).any()

    def test_bad_truths_are_refused(self):
        refused(lambda: Truth(Participants(within=22)), code="out-of-range", argument="participants.within")
        refused(
            lambda: Truth(Participants(noise=float("nan"))),
            "nan",
            code="out-of-range",
            argument="participants.noise",
        )
        refused(
            lambda: Truth(Participants(friction=0.0)), code="out-of-range", argument="participants.friction"
        )
        refused(lambda: Truth(remaining={"WG1": 45.0}), code="out-of-range", argument="truth.remaining.WG1")
        refused(
            lambda: list(strokes(Truth(remaining={"WG1": 0.45}), Protocol(), 1)),
            code="out-of-range",
            argument="truth.remaining",
        )
        refused(lambda: list(strokes(Truth(), Protocol(), 0)), code="out-of-range", argument="participants")


class TestExperiment:
    def test_the_published_experiment(self):
        """Three people, 240 strokes each: what went in comes out within its own intervals."""
        truth = Truth(Participants(effect_between=0.03))
        simulated = list(strokes(truth, Protocol(), 3, seed=11))
        table = measured((label, record) for label, record, _ in simulated)
        driven, idle = paired(table, "WG1"), paired(table, "WG2")
        assert len(driven.on) + driven.omitted / 2 == 180
        assert reduction(driven).value == pytest.approx(0.55, abs=0.06)
        assert reduction(idle).value == pytest.approx(0.11, abs=0.08)
        assert stopped(driven, idle).value == pytest.approx(0.8, abs=0.13)
        test = by_trials(idle)
        assert test.high - test.low == pytest.approx(0.04, abs=0.008)  # as published

    def test_intervals_contain_the_truth_in_95_of_100(self):
        truth = Truth(Participants(between=0.1))
        inside, blind = [], []
        for seed in range(100):
            pairs = paired(statistic_table(truth, 3, seed), "WG2")
            for test, hits in ((by_participants, inside), (by_trials, blind)):
                result = test(pairs)
                hits.append(result.low < -0.42 * 0.11 < result.high)
        assert np.mean(inside) >= 0.89  # 95 % less three standard errors
        assert np.mean(blind) < 0.85  # the interval of the test as published

    def test_the_drift_that_was_put_in(self):
        """0.1 of the session's mean, seen through 22 % of scatter by ten people."""
        steady = statistic_table(Truth(Participants(drift=0.4, between=0.0, within=0.0)), 1, 0)
        off = steady["friction"].values[steady["actuation"].values == "off"]
        assert off.mean() == pytest.approx(0.42, rel=0.005)
        estimate = drift(statistic_table(Truth(Participants(drift=0.1)), 10, 0))
        assert estimate.low < 0.1 < estimate.high
        none = drift(statistic_table(Truth(Participants(drift=0.0, within=0.01)), 10, 0))
        assert none.value == pytest.approx(0, abs=0.005)


class TestProtocol:
    def test_the_published_order(self):
        labels = Protocol().order(3)
        assert len(labels) == 3 * 240
        assert Counter((label.participant, label.waveguide, label.actuation) for label in labels) == {
            (f"P{n}", guide, side): 60
            for n in (1, 2, 3)
            for guide in ("WG1", "WG2")
            for side in ("on", "off")
        }
        assert {label.waveguide for label in labels if label.block % 2 == 0} == {"WG1"}
        assert {label.waveguide for label in labels if label.block % 2} == {"WG2"}
        for first, second in zip(labels[::2], labels[1::2], strict=True):
            assert (first.actuation, second.actuation) == ("on", "off")
        assert labels[0] == Label("P1", 1, 1, "WG2", "on")

    def test_counterbalancing_takes_away_what_the_order_does(self):
        """As published, off always comes one trial after on; balanced, as often before."""
        assert imbalance(Protocol().order(4)) == pytest.approx(1)
        assert imbalance(Protocol(counterbalanced=True).order(4)) == pytest.approx(0)
        first = {
            label.participant: label.waveguide for label in reversed(Protocol(counterbalanced=True).order(4))
        }
        assert Counter(first.values()) == {"WG1": 2, "WG2": 2}

    @pytest.mark.parametrize("protocol", [Protocol(), Protocol(4, 30, counterbalanced=True), Protocol(2, 6)])
    def test_shuffled_pairs(self, protocol):
        """The same numbers in every block, no drift left, and an order that is not the plain one."""
        drawn = replace(protocol, seed=0)
        plain, mixed = protocol.order(3), drawn.order(3)

        def counted(labels):
            return Counter(
                (label.participant, label.block, label.waveguide, label.actuation) for label in labels
            )

        assert counted(plain) == counted(mixed)
        assert [label.actuation for label in plain] != [label.actuation for label in mixed]
        assert [(label.block, label.trial) for label in plain] == [
            (label.block, label.trial) for label in mixed
        ]
        odd = protocol.pairs % 2
        assert imbalance(mixed) == pytest.approx(odd / protocol.pairs)
        assert mixed == drawn.order(3) != replace(protocol, seed=1).order(3)

    def test_other_names(self):
        labels = Protocol(2, 4, waveguides=("left", "right")).order(1)
        assert [label.waveguide for label in labels] == ["right"] * 4 + ["left"] * 4
        assert Protocol(2, 4).pairs == 2
        refused(
            lambda: Protocol(waveguides=("left", "left")), code="conflict", argument="protocol.waveguides"
        )

    @pytest.mark.parametrize("numbers", [{"blocks": 7}, {"trials": 0}, {"trials": 30.0}, {"blocks": True}])
    def test_bad_protocols_are_refused(self, numbers):
        refused(lambda: Protocol(**numbers), code="out-of-range", argument=f"protocol.{next(iter(numbers))}")

    def test_no_participant_is_refused(self):
        for number in (0, -1, 2.5, True):
            refused(lambda n=number: Protocol().order(n), code="out-of-range", argument="participants")
