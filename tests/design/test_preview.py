"""Previews along a number: their bounds hold, and their sliders fit the study."""

from itertools import islice

import numpy as np
import pytest

from haptonic.analyses.turning import BandsTurning
from haptonic.bloch import bands_dataset, gaps_of
from haptonic.bloch.gap_datasets import dataset_of_gaps
from haptonic.design.preview import CertifiedBands, DesignLine, Samples
from haptonic.later import xarray as xr
from haptonic.results.bands import Bands
from haptonic.study import loads
from turned import TURNED_CELL, previewed, used_of_bound

HOLE = """
material = "aluminium-paper"
[parameters]
size = "9 mm"
[cell]
lattice = "triangular"
pitch = "size"
thickness = "1.5 mm"
[[cell.disc]]
diameter = "5 mm"
high = "1 mm"
[bands]
count = 5
points = 9
accuracy = 2e-2
"""
CELLS = {
    "square, pillar": (TURNED_CELL, "cell.pillar.diameter"),
    "triangular, disc": (HOLE, "parameters.size"),
}


def line_of(curves, values: np.ndarray) -> tuple[DesignLine, CertifiedBands]:
    """A line through exact curves, each with a value for every band at one wavevector."""
    every = [curves(value)[None] for value in values]
    samples = tuple(
        Samples(
            frequency=f, edges=np.zeros((2, f.shape[1] - 1)), doubt=np.zeros((2, f.shape[1] - 1)),
            distance=np.zeros(1), pitch=1.0,
        )
        for f in every
    )  # fmt: skip
    middle = len(values) // 2
    dataset = xr.Dataset(
        {
            "frequency": (("wavevector", "band"), every[middle]),
            "frequency_error": (("wavevector", "band"), np.zeros_like(every[middle])),
        }
    ).merge(dataset_of_gaps(()))
    return DesignLine(tuple(values), samples), CertifiedBands(dataset, samples[middle])


@pytest.mark.parametrize("seed", range(5))
def test_the_bound_covers_bands_that_cross_or_bend(seed):
    random = np.random.default_rng(seed)
    slopes, bends = random.uniform(-1, 1, 2), random.uniform(-0.2, 0.2, 2)
    crossing = random.uniform(-0.7, 0.7)

    def curves(value: float) -> np.ndarray:
        # a crossing anywhere within the inner intervals, with a bend that is small beside it
        return np.sort(10 + slopes * (value - crossing) + bends * 0.01 * value**2)

    line, certified = line_of(curves, np.linspace(-1, 1, 9))
    preview = line.dataset(certified)
    for value in random.uniform(-0.75, 0.75, 50):
        shown, bound = previewed(preview, "frequency", value)
        assert (np.abs(shown - curves(value)) <= bound + 1e-12).all()


@pytest.mark.parametrize(
    "name", ["square, pillar", pytest.param("triangular, disc", marks=pytest.mark.nightly)]
)
def test_certified_bands_and_gaps_lie_within_the_bounds(name):
    text, path = CELLS[name]
    study, turning, random = loads(text), BandsTurning(), np.random.default_rng(7)
    certified = turning.certified(study, Bands(bands_dataset(study.cell, study.bands_settings)))
    knob = next(knob for knob in turning.knobs(study) if knob.path == path)
    previews = (each for each in turning.previews(study, certified, knob) if each is not None)
    first, *_, last = islice(previews, 3)
    assert last.sizes["node"] > first.sizes["node"] >= 5
    for shown in random.uniform(knob.low, knob.high, 2):
        value = knob.scale * shown
        design = study.with_parameter(knob.path, value)
        used = used_of_bound(last, value, design.cell, design.bands_settings)
        assert used < 1, (shown, used)
        frequency, bound = previewed(last, "frequency", value)
        assert np.median(bound / frequency) < 0.1


def test_sliders_are_those_of_numbers_that_vary():
    turning, study = BandsTurning(), loads(HOLE)
    knobs = {knob.path: knob for knob in turning.knobs(study)}
    # the pitch follows the parameter, and constants of a built-in material are not in the study
    assert set(knobs) == {"parameters.size", "cell.thickness", "cell.disc[1].diameter", "cell.disc[1].high"}
    assert knobs["cell.disc[1].high"].title == "Upper end of the disc, disc 1"
    size = knobs["parameters.size"]
    assert (size.title, size.unit, size.value) == ("size", "mm", 9.0)
    assert 7.2 <= size.low < 7.3
    assert 11.1 < size.high <= 11.25
    for knob in knobs.values():
        steps = (knob.value - knob.low) / knob.step
        assert abs(steps - round(steps)) < 1e-6


def test_a_slider_keeps_its_range_until_its_value_is_near_an_end():
    turning, study = BandsTurning(), loads(TURNED_CELL)
    path = "cell.pillar.diameter"

    def at(value: float):
        design = study.with_parameter(path, value)
        return next(knob for knob in turning.knobs(design) if knob.path == path)

    first, near, far = at(3.5e-3), at(3.9e-3), at(4.36e-3)
    assert (first.low, first.high) == (near.low, near.high)
    assert near.value == pytest.approx(3.9)
    assert far.high > first.high


def test_a_slider_ends_where_no_design_is_possible():
    wide = TURNED_CELL.replace('diameter = "3.5 mm"', 'diameter = "6.4 mm"')
    knob = next(k for k in BandsTurning().knobs(loads(wide)) if k.path == "cell.pillar.diameter")
    assert 6.4 < knob.high < 7.0


def test_the_first_curves_are_those_of_the_result():
    study, early = loads(TURNED_CELL), []
    result = bands_dataset(study.cell, study.bands_settings, first=early.append)
    curves, with_gaps = early
    for name in ("frequency", "frequency_error"):
        np.testing.assert_array_equal(curves[name], result[name])
        np.testing.assert_array_equal(with_gaps[name], result[name])
    assert "gap_lower" not in curves
    complete = [gap for gap in gaps_of(result) if gap.complete]
    assert complete
    assert list(gaps_of(with_gaps)) == complete


def test_curves_are_not_reported_before_they_are_as_accurate_as_the_study_demands(monkeypatch):
    study, early = loads(TURNED_CELL.replace("accuracy = 2e-2", "accuracy = 1e-3").partition("[mesh]")[0]), []
    # a start with the coarsest mesh, which is not accurate enough
    monkeypatch.setattr("haptonic.bloch.candidates.first_level", lambda *_: 0)
    result = bands_dataset(study.cell, study.bands_settings, first=early.append)
    for first in early:
        np.testing.assert_array_equal(first["frequency"], result["frequency"])
    assert [("gap_lower" in first) for first in early] == [False, True]
