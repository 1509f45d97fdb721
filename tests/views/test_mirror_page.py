"""The page of a mirror: its numbers against the spectra, and the page in a real browser."""

from dataclasses import replace

import numpy as np
import pytest

from browser import STILL, faults_of_layout, page_at
from haptonic.results.layers_view import layers_view
from haptonic.units import uncertain
from haptonic.views import sent_page
from simulated import simulated_mirror

SHARE = 0.01  # relative error of frequencies
AT_THE_CARRIER = np.linspace(0.1, 0.9, 30).reshape(3, 10)  # errors of losses, dB
DECAY_AT_THE_CARRIER = {"carrier_attenuation_db": 10 / np.log(10), "carrier_attenuation_error_db": 0.7}


@pytest.fixture(scope="module")
def view():
    data = simulated_mirror(
        relative_frequency_error=SHARE, families=("A0", "SH0"), **DECAY_AT_THE_CARRIER
    )  # fmt: skip
    data["carrier_loss_error"] = ("incident", "many"), AT_THE_CARRIER
    return layers_view(data, "Mirror", ["Simulated."])


def test_losses_decays_and_phases_are_those_of_the_spectra(view):
    data, inside = view.dataset, slice(5, 11)
    for number, family in enumerate(view.dataset["incident"].values):
        loss = data["loss"].sel(incident=family).values
        if family == "S0":
            assert np.isnan(loss).all()
            continue
        np.testing.assert_allclose(loss[2, inside], 15.0 * (number + 1))
    np.testing.assert_allclose(data["decay"][1], 2.0 * 20 / np.log(10))
    phase = data["phase"].values[0]
    assert np.isnan(phase[inside]).all()
    assert phase[0] == pytest.approx(0.2)


def test_errors_follow_from_those_of_the_frequencies(view):
    """Slope of the curve times the error of the frequency, and the same share of the value."""
    data = view.dataset
    frequency, loss, error = (data[name].values for name in ("frequency", "loss", "loss_error"))
    slope = np.gradient(loss[0, 0], frequency)
    for k in (4, 11):  # beside the ends of the gap
        expected = SHARE * frequency[k] * np.abs(np.diff(loss[0, 0, k - 1 : k + 2])).max() / 2e3
        assert error[0, 0, k] == pytest.approx(expected + SHARE * loss[0, 0, k])
    assert error[0, 0, 8] == pytest.approx(SHARE * loss[0, 0, 8])
    assert slope[8] == 0


def test_errors_at_the_carrier_are_those_of_the_answer(view):
    data, line = view.dataset, 9
    assert data["frequency"].values[line] == 58e3
    np.testing.assert_array_equal(data["loss_error"].values[..., line], AT_THE_CARRIER[:, :6])
    assert data["decay_error"].values[0, line] == 0.7  # of the slowest wave
    assert data["decay_error"].values[1, line] == pytest.approx(SHARE * data["decay"].values[1, line])


def test_sentences_have_minus_signs_and_powers_of_ten_and_names_are_left(browser, view, tmp_path):
    summary = ["Loss -3.2 dB on 2026-11-28 (-1 to 4), error 6.2e-04 in WG1-2."]
    path = tmp_path / "mirror.html"
    path.write_text(sent_page(replace(view, extra={**view.extra, "summary": summary})), "utf-8")
    minus, times = "\N{MINUS SIGN}", "\N{MULTIPLICATION SIGN}"
    with page_at(browser, path.as_uri(), **STILL) as page:
        page.wait_for_selector(".walk .uplot")
        words = page.locator("header").inner_text()
        assert f"Loss {minus}3.2 dB on 2026-11-28 ({minus}1 to 4), error 6.2{times}10⁻⁴ in WG1-2." in words
        legend = page.locator(".legend").inner_text()
        assert "6 rows" in legend
        assert "1 to 6 rows" in legend


def test_the_page_shows_what_the_keyboard_and_the_mouse_select(browser, view, tmp_path):
    data = view.dataset
    (tmp_path / "mirror.html").write_text(sent_page(view), "utf-8")
    with page_at(browser, (tmp_path / "mirror.html").as_uri(), **STILL) as page:
        page.wait_for_selector(".walk .uplot")

        def words(line: int, rows: int, kind: str) -> str:
            at = {"incident": kind, "rows": rows}
            loss, error = (float(data[name].sel(at)[line]) for name in ("loss", "loss_error"))
            many = f"{rows} row{'s' if rows > 1 else ''}"
            return (
                f"{kind} at {data['frequency'].values[line] / 1e3:g} kHz, {many}: {uncertain(loss, error)} dB"
            )

        point = page.locator("#point")
        assert point.inner_text() == words(9, 6, "A0")  # the carrier, and all rows
        page.keyboard.press("Tab")
        for key in ("ArrowLeft", "ArrowDown", "ArrowDown", "i"):
            page.keyboard.press(key)
        assert point.inner_text() == words(8, 4, "SH0")
        page.keyboard.press("c")
        over = page.locator(".u-over").nth(0)
        box = over.bounding_box()
        over.click(position={"x": box["width"] * 6 / 20, "y": 50})
        assert point.inner_text() == words(6, 4, "SH0")
        rows = page.locator(".u-over").nth(1)
        rows.click(position={"x": rows.bounding_box()["width"] * 1.5 / 6, "y": 50})
        assert point.inner_text() == words(6, 2, "SH0")
        page.keyboard.press("t")
        cells = page.get_by_role("table", name="Insertion loss").locator("tbody tr").nth(1).inner_text()
        assert cells.split("\t")[1:] == [words(6, 2, kind).split(": ")[1] for kind in ("A0", "SH0")]
        decays = page.get_by_role("table", name="Waves of the lattice").locator("tbody td:first-child")
        bounds = zip(data["decay"].values[:, 6], data["decay_error"].values[:, 6], strict=True)
        assert decays.all_inner_texts() == [uncertain(*pair) for pair in bounds]
        assert faults_of_layout(page) == []
