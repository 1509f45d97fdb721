"""`haptonic verify`: a case that agrees, spoiled values, unknown names, its page, and nightly every case."""

from __future__ import annotations

import io
import math
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from five_parts import assert_five_parts
from haptonic.cli.commands import verify
from haptonic.cli.console import Voice
from haptonic.study import case_templates, load
from haptonic.verification import (
    Case,
    CaseComparison,
    CaseQuantity,
    cases,
    compare_case,
    comparison_table,
    load_case_study,
    omitted_cases,
)
from haptonic.verification.page import BEGINNING, source_table
from haptonic.verification.tables import computed_text, percent_text, reference_text

PAGE = (Path(__file__).parents[2] / "docs" / "verification.md").read_text("utf-8")
CHEAP = "square-by-points"


def spoiled(case: Case) -> Case:
    """The case with a reference that is 20 % too high."""
    quantity = case.quantity[0]
    other = quantity.other.model_copy(update={"factor": 1.2})
    return case.model_copy(update={"quantity": (quantity.model_copy(update={"other": other}),)})


class TestCommand:
    def test_a_case_that_agrees_is_reproduced_as_on_the_page(self, inside):
        ran = inside("verify", CHEAP, "--json")
        assert ran.code == 0, ran.err
        (answer,) = ran.json["comparisons"]
        assert answer["agrees"]
        assert ran.json["failed"] == []
        shown = inside("verify", CHEAP)
        row = next(line for line in PAGE.splitlines() if line.startswith(f"| {CHEAP} |"))
        for cell in row.strip("| ").split(" | "):
            assert cell in shown.out

    def test_a_spoiled_value_is_reported_and_gives_exit_code_1(self, inside, monkeypatch):
        monkeypatch.setattr(verify, "cases", lambda names=(): tuple(map(spoiled, cases(names))))
        ran = inside("verify", CHEAP, "--json")
        assert ran.code == 1
        assert ran.json["failed"] == [CHEAP]
        assert ran.json["comparisons"][0]["difference"] == pytest.approx(1 / 1.2 - 1)
        assert "outside the errors: square-by-points" in inside("verify", CHEAP).out

    def test_an_unknown_case_is_refused_with_the_nearest_name(self, inside):
        assert_five_parts(inside("verify", "square-by-point"), CHEAP, code="unknown", argument="CASE")

    def test_the_list_names_every_case_and_computes_nothing(self, inside, tmp_path):
        ran = inside("verify", "--list", store=tmp_path / "empty")
        assert ran.code == 0
        assert all(case.id in ran.out for case in cases())
        assert "study prototype)" in " ".join(ran.out.split())
        assert not (tmp_path / "empty").exists()

    def test_new_copies_the_study_of_a_case(self, inside, tmp_path):
        ran = inside("new", "filled-bore", tmp_path / "mine.toml")
        assert ran.code == 0, ran.err
        assert load(tmp_path / "mine.toml") == load_case_study("filled-bore")
        assert "filled-bore" not in inside("new").out


class TestTableOfCases:
    def test_every_study_belongs_to_a_case_and_loads(self):
        assert {case.study for case in cases()} == case_templates().keys()
        for case in cases():
            study = load_case_study(case.study)
            for change in case.vary:
                study.with_keys(change)
            assert all(quantity.published_values or quantity.other for quantity in case.quantity)

    def test_a_quantity_without_a_reference_is_refused(self):
        with pytest.raises(ValueError, match="published values or another study"):
            CaseQuantity(name="nothing", at="M")

    def test_the_committed_page_has_the_cases_and_the_form_of_the_command(self):
        assert PAGE.startswith(BEGINNING)
        rows = [
            line.split(" | ") for line in PAGE.split("## Sources")[0].splitlines() if line.startswith("| ")
        ]
        assert [cell.strip("| ") for cell in rows[0]] == list(comparison_table([]).head)
        pairs = [(case.id, quantity.name) for case in cases() for quantity in case.quantity]
        assert [(row[0].strip("| "), row[1]) for row in rows[2:]] == pairs
        assert source_table(cases()).written("markdown") in PAGE
        assert all(case.title in PAGE for case in omitted_cases())


class TestComparison:
    @staticmethod
    def of(reference, computed, error=0.0, **more):
        quantity = CaseQuantity(name="edge", measure="upper edge", published=("1 Hz",), **more)
        computed = np.array(computed, dtype=float)
        case = cases()[0].model_copy(update={"quantity": (quantity,)})
        zeros = np.zeros(len(reference))
        return CaseComparison(
            case=case,
            quantity=quantity,
            reference=np.array(reference),
            reference_error=zeros,
            computed=computed,
            computed_error=np.full_like(computed, error),
        )

    def test_a_value_within_error_and_tolerance_agrees(self):
        assert not self.of([100.0], [[103.0]]).agrees
        assert self.of([100.0], [[103.0]], error=3.0).agrees
        assert self.of([100.0], [[103.0]], tolerance=0.031).agrees
        assert self.of([100.0], [[103.0]]).signed_difference == pytest.approx(0.03)

    def test_a_reference_inside_the_range_of_variants_agrees(self):
        assert self.of([100.0], [[90.0], [110.0]]).difference == 0.0
        assert self.of([100.0], [[104.0], [110.0]]).signed_difference == pytest.approx(0.04)

    def test_rigid_motions_are_compared_with_the_largest_value(self):
        assert self.of([0.0, 100.0], [[0.05, 100.0]], tolerance=1e-3).agrees

    def test_the_table_fits_into_80_columns(self):
        voice = Voice(machine=False)
        voice.out.file, voice.out.width = io.StringIO(), 80
        voice.show(comparison_table([self.of([58.8e3], [[60.1e3]])]))
        lines = voice.out.file.getvalue().splitlines()
        assert max(map(len, lines)) <= 80
        assert "prototype" in "".join(lines)


class TestTexts:
    """Numbers of the table: value and error have one unit, and as many decimals."""

    def test_a_value_has_its_error_in_the_same_unit(self):
        assert computed_text(TestComparison.of([52.9e3], [[52.518e3]], error=48.0)) == "52.52 ± 0.05 kHz"

    def test_several_values_have_one_unit(self):
        comparison = TestComparison.of([918.7e3, 12.75e6], [[916.4e3, 12.749e6]], error=1e3)
        assert reference_text(comparison) == "0.9187 to 12.75 MHz (2 values)"
        assert computed_text(comparison) == "0.916 ± 0.001 to 12.749 ± 0.001 MHz (2 values)"

    def test_a_varied_case_has_a_range(self):
        assert computed_text(TestComparison.of([1e3], [[990.0], [1010.0]])) == "0.99 to 1.01 kHz, varied"

    def test_a_relative_width_has_its_error_in_percent(self):
        comparison = TestComparison.of([0.137], [[0.1366]], error=2e-4)
        quantity = comparison.quantity.model_copy(update={"measure": "relative width"})
        comparison = replace(comparison, quantity=quantity)
        assert reference_text(comparison) == "13.7 %"
        assert computed_text(comparison) == "13.66 ± 0.02 %"

    @pytest.mark.parametrize(
        ("share", "text"), [(-0.0072, "\N{MINUS SIGN}0.72 %"), (4.4e-7, "0 %"), (1.2e-5, "+0.0012 %")]
    )
    def test_a_difference_has_a_sign_and_no_power_of_ten(self, share, text):
        assert percent_text(share, signed=True) == text


def published(name):
    return [quantity.published_values for quantity in cases([name])[0].quantity]


def test_the_values_of_the_mass_on_a_column_follow_from_rod_and_shaft():
    """Roots of the characteristic equations of a rod between two masses, and of a shaft with a disc."""
    area, length, density = math.pi / 4 * 25e-6, 1e-3, 500.0
    mass, plate = 7850 * area * 4e-3, 7850 * 100e-6 * 6e-3
    upper, lower = (body / (density * area * length) for body in (mass, plate))
    turning = mass * 25e-6 / 8 / (density * math.pi / 32 * 625e-12 * length)
    shaft = brentq(lambda x: x * math.tan(x) - 1 / turning, 1e-6, 1)
    rod = brentq(lambda x: math.tan(x) * (upper * lower * x**2 - 1) - (upper + lower) * x, 1e-2, 1)
    speeds = math.sqrt(5e6 / density), math.sqrt(10e6 / density)
    exact = [x * speed / length / (2 * math.pi) for x, speed in zip((shaft, rod), speeds, strict=True)]
    assert np.ravel(published("soft-mount")) == pytest.approx(exact, rel=1e-5)


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["plain-plate", "triangular-plate"])
def test_the_values_of_the_plain_plate_are_waves_of_rayleigh_and_lamb(name):
    """Each is a root of the frequency equations at a wavevector of the lattice, or an SH wave."""
    case = cases([name])[0]
    lattice = load_case_study(case.study).cell.lattice
    phases = np.pi * np.array(list(map(float, case.quantity[0].at.split(","))))
    shifts = 2 * np.pi * np.array([(m, n) for m in range(-2, 3) for n in range(-2, 3)])
    wavenumbers = [np.linalg.norm(lattice.wavevector(phases + shift)) for shift in shifts]
    for value in published(name)[0]:
        assert any(is_plate_wave(value, k) for k in wavenumbers), value


def is_plate_wave(frequency: float, k: float) -> bool:
    """True if a frequency equation changes its sign within 1e-7 of the frequency."""
    modulus, poisson, density, half = 70e9, 0.33, 2700.0, 0.75e-3
    shear = math.sqrt(modulus / 2 / density / (1 + poisson))
    pressure = shear * math.sqrt((2 - 2 * poisson) / (1 - 2 * poisson))

    def equations(hertz):
        p, q = (np.sqrt(complex((2 * np.pi * hertz / speed) ** 2 - k**2)) for speed in (pressure, shear))
        first, second = (q**2 - k**2) ** 2, 4 * k**2 * p * q
        symmetric = first * np.cos(p * half) * np.sin(q * half) / q
        symmetric += second * np.sin(p * half) * np.cos(q * half) / q
        bending = first * np.sin(p * half) * np.cos(q * half) / p
        bending += second * np.cos(p * half) * np.sin(q * half) / p
        return np.array([symmetric.real, bending.real, 2 * np.pi * hertz - shear * k])

    below, above = equations(frequency * (1 - 1e-7)), equations(frequency * (1 + 1e-7))
    return bool((below * above < 0).any())


@pytest.mark.nightly
@pytest.mark.parametrize("name", [case.id for case in cases()])
def test_every_case_agrees(name):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for comparison in compare_case(cases([name])[0]):
            assert comparison.agrees, (comparison.signed_difference, comparison.allowed)


@pytest.mark.nightly
@pytest.mark.parametrize("name", [case.id for case in cases() if case.source.startswith("NGSolve")])
def test_the_values_of_the_independent_program_are_its_own(name):
    pytest.importorskip("ngsolve")
    from peers.ngsolve_studies import peer_frequencies

    (quantity,) = cases([name])[0].quantity
    study = load_case_study(name)
    coarse, fine = (peer_frequencies(study, quantity.at, len(quantity.bands), order) for order in (2, 3))
    assert fine == pytest.approx(quantity.published_values, rel=1e-4)
    assert (np.abs(coarse / fine - 1) <= quantity.uncertainty).all()
