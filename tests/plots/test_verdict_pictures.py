"""Pictures of a verdict show the numbers that they are given, and can be read."""

import numpy as np
import pytest
from seeing import artists, assert_readable, shown_texts
from simulated_plates import prototype

from daily import daily
from haptonic import plots
from haptonic.response import mac
from haptonic.updating.agreement import Agreement
from haptonic.updating.shapes import Shapes, pairs

FREQUENCY = np.linspace(5e3, 80e3, 301)
LABELS = ("simulated measurement", "model as given (simulated)", "model fitted (simulated)")
POINTS = np.stack(np.meshgrid(np.arange(1e-3, 127e-3, 2e-3), np.arange(1e-3, 140e-3, 2e-3)), -1).reshape(
    -1, 2
)
FRAC = {label: np.linspace(low, 1, len(POINTS)) for label, low in zip(LABELS[1:], (0.0, 0.9), strict=True)}


def agreement(count):
    chance = np.random.default_rng(0)
    shape = chance.standard_normal((count, 60)) + 0j
    frequency = 8e3 + 2.5e3 * np.arange(count)
    measured = Shapes(frequency, np.full(count, 0.01), shape, "modes")
    computed = Shapes(1.01 * frequency[1:], np.full(count - 1, 0.01), shape[1:] + 0.3, "modes")
    return Agreement(
        np.ones(3),
        0.1,
        measured,
        computed,
        mac(measured.shape, computed.shape),
        tuple(pairs(measured, computed)),
    )


def spectra():
    return {label: 1e-4 * (k + 1) * (1 + np.sin(FREQUENCY / 2e3) ** 2) for k, label in enumerate(LABELS)}


def levels(offset):
    return {label: offset + 10 * np.sin(FREQUENCY / 5e3 + k) for k, label in enumerate(LABELS)}


PICTURES = {
    "before and after": lambda: plots.before_after(
        FREQUENCY, spectra(), {"WG1 over WG2": levels(20), "WG1 over lattice": levels(0)}, units="m/s/V"
    ),
    "no contrast": lambda: plots.before_after(FREQUENCY, spectra(), {}, units="m/s/V"),
    "mac": lambda: plots.mac_matrix(agreement(9), measured=LABELS[0], computed=LABELS[2]),
    "mac, two": lambda: plots.mac_matrix(agreement(2), measured=LABELS[0], computed=LABELS[2]),
    "mac, many": lambda: plots.mac_matrix(agreement(40), measured=LABELS[0], computed=LABELS[2]),
    "frac": lambda: plots.frac_maps(POINTS, FRAC, prototype(), measured=LABELS[0]),
    "frac, one": lambda: plots.frac_maps(
        POINTS, {LABELS[1]: FRAC[LABELS[1]]}, prototype(), measured=LABELS[0]
    ),
}


@pytest.mark.parametrize("name", daily(PICTURES, "before and after", "mac", "frac, one"))
def test_every_picture_can_be_read(name):
    figure = PICTURES[name]()
    assert_readable(figure)
    assert any("simulated" in text for text, _ in shown_texts(figure)), "what is simulated is marked"


def test_curves_are_the_given_ones():
    figure = PICTURES["before and after"]()
    drawn = artists(figure, "curve")
    expected = [*spectra().values(), *levels(20).values(), *levels(0).values()]
    assert len(drawn) == len(expected)
    for line, values in zip(drawn, expected, strict=True):
        assert line.get_xdata() == pytest.approx(FREQUENCY / 1e3)
        assert line.get_ydata() == pytest.approx(values)


def test_the_matrix_has_its_numbers_and_frames():
    given = agreement(9)
    figure = PICTURES["mac"]()
    (image,) = artists(figure, "mac")
    assert np.asarray(image.get_array()) == pytest.approx(given.mac)
    frames = {(round(frame.get_y() + 0.5), round(frame.get_x() + 0.5)) for frame in artists(figure, "pair")}
    assert frames == {(pair.first, pair.second) for pair in given.pairs} == {(k + 1, k) for k in range(8)}
    written = [text for text, _ in shown_texts(figure)]
    assert (
        sum(text.count(".") == 1 and len(text) == 4 and float(text) <= 1 for text in written)
        >= given.mac.size
    )
    assert len(artists(PICTURES["mac, many"](), "pair")) == 39
    many = [text for text, _ in shown_texts(PICTURES["mac, many"]())]
    assert len(many) < 80, "no numbers where they could not be read"


def test_every_point_has_its_criterion():
    figure = PICTURES["frac"]()
    maps = artists(figure, "frac")
    assert len(maps) == 2
    for marks, values in zip(maps, FRAC.values(), strict=True):
        assert np.asarray(marks.get_offsets()) == pytest.approx(1e3 * POINTS)
        assert np.asarray(marks.get_array()) == pytest.approx(values)
        assert (marks.norm.vmin, marks.norm.vmax) == (0, 1)
