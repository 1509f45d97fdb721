"""Wavevectors by their names, and the modes there."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, strategies as st

from five_parts import refused
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.errors import StudyError
from haptonic.study import loads
from quick import QUICK_CELL

ZONES = {
    "square": loads(QUICK_CELL).cell.zone,
    "triangular": loads(QUICK_CELL.replace("[cell]", '[cell]\nlattice = "triangular"')).cell.zone,
    "rectangular": loads(
        QUICK_CELL.replace("[cell]", '[cell]\nlattice = "rectangular"\npitch_y = "8 mm"')
    ).cell.zone,
}
shares = st.floats(0, 1).map(lambda share: round(share, 3))


@given(
    st.sampled_from(sorted(ZONES)),
    st.data(),
    shares,
    st.sampled_from(["{} {}-{}", "{} of {}-{}", " {}  {}-{} "]),
)
def test_a_share_between_two_corners_lies_there(name, data, share, form):
    zone = ZONES[name]
    start, stop = (data.draw(st.sampled_from(list(zone.corner_phases))) for _ in range(2))
    kappa, _ = wavevector_at(zone, form.format(share, start, stop.lower()))
    first, last = zone.corner_phases[start], zone.corner_phases[stop]
    assert kappa == pytest.approx(first + share * (last - first), abs=1e-12)


@given(st.sampled_from(sorted(ZONES)), st.data())
def test_a_corner_is_itself(name, data):
    zone = ZONES[name]
    label = data.draw(st.sampled_from(list(zone.corner_phases)))
    for text in (label, f" {label.lower()} ", *(("G", "gamma") if label == "Γ" else ())):
        kappa, called = wavevector_at(zone, text)
        assert (kappa == zone.corner_phases[label]).all()
        assert called == label


@given(st.floats(-2, 2), st.floats(-2, 2), st.sampled_from([", ", " ", ","]))
def test_two_phases_are_taken_over_pi(first, second, between):
    kappa, _ = wavevector_at(ZONES["square"], f"{first:.6f}{between}{second:.6f}")
    assert kappa == pytest.approx(np.pi * np.array([first, second]), abs=1e-5)


@pytest.mark.parametrize(
    "text", ["", "Q", "X-Q", "1.2 X-M", "-0.1 X-M", "0.5", "3, 0", "a, b", "X-", "-X", "nan, 1"]
)
def test_what_is_no_wavevector(text):
    refused(
        lambda: wavevector_at(ZONES["square"], text), code="malformed", argument="modes_at", kind=StudyError
    )


@pytest.mark.parametrize("given", [3, (0.5, 0.25)])
def test_what_is_no_text_is_refused_in_python(given):
    study = loads(QUICK_CELL)
    refused(lambda: study.bands(modes_at=given), repr(given), code="malformed", argument="modes_at")


def test_modes_at_a_corner_are_those_of_the_diagram(tmp_path):
    study = loads(QUICK_CELL)
    bands = study.bands(modes_at="M")
    data = bands.dataset
    corner = data["frequency"].values[json.loads(data.attrs["path_corners"])[2]]
    assert data["mode_kappa"].values == pytest.approx([np.pi, np.pi])
    assert np.sort(data["mode_frequency"].values) == pytest.approx(np.sort(corner), rel=1e-9)
    assert data.attrs["modes_at"] == "M"
    title = next(artist for artist in bands.figures["modes"].findobj() if artist.get_gid() == "wavevector")
    assert title.get_text() == "modes at M"
    usual = study.bands().dataset
    assert usual.attrs["modes_at"] == "middle of X-M"
    assert usual["mode_kappa"].values == pytest.approx([np.pi, 0.5 * np.pi])


def test_at_the_centre_three_modes_are_rigid(tmp_path):
    data = loads(QUICK_CELL).bands(modes_at="G").dataset
    assert (data["mode_frequency"].values[:3] < 1.0).all()
    assert (data["mode_frequency"].values[3:] > 1e3).all()
    loads(QUICK_CELL).bands(modes_at="G").plot("modes")


def test_modes_at_equivalent_wavevectors_are_alike():
    """Three phases that name the same point M of a triangular lattice, outside the irreducible zone too."""
    study = loads(QUICK_CELL.replace("[cell]", '[cell]\nlattice = "triangular"'))
    first, *others = (study.bands(modes_at=text).dataset for text in ("M", "-1, 1", "0, -1"))
    for other in others:
        for name in ("mode_frequency", "mode_error"):
            assert other[name].values == pytest.approx(first[name].values, rel=1e-9)
        assert (other["mode_name"].values == first["mode_name"].values).all()
    assert others[0]["mode_kappa"].values == pytest.approx([-np.pi, np.pi])
