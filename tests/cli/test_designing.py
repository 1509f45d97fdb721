"""The way from a question to the workshop: design, tolerance, export.

Refusals that need no computing run in this process, which saves each the seconds of a start.
"""

from __future__ import annotations

import json
import re
import sys
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import ezdxf
import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.text import Text
from scipy.stats import truncnorm

import haptonic as package
from daily import daily
from five_parts import assert_five_parts
from haptonic.analyses import export
from haptonic.analyses.runner import Runner
from haptonic.bloch import Resolution, gaps_of
from haptonic.cli.app import app
from haptonic.design import edges, quick
from haptonic.store import Store
from haptonic.study import loads
from haptonic.workshop import Part, part_drawing

SWEEP = """
[[sweep]]
vary = "cell.pillar.diameter / cell.pitch"
from = 0.4
to = 0.6
steps = 3
"""
CONSTANTS = '[material]\nyoungs_modulus = "70 GPa"\npoisson_ratio = 0.33\ndensity = "2700 kg/m^3"\n\n[cell]\n'
FINE = ("order = 2\nfoot_rings = 0", "order = 3\nfoot_rings = 1")
BUILT_IN = ('material = "aluminium-paper"\n', "")
LIMITS = "[design]\nstarts = 1\nclimbs = 1\nsteps = 2\npitches = 2\n"
HEIGHT = '[[design.vary]]\nparameter = "cell.pillar.height"\nfrom = "14 mm"\nto = "16 mm"\n'
PITCH = '[[design.vary]]\nparameter = "cell.pitch"\nfrom = "3 mm"\nto = "6.8 mm"\n'
DENSITY = '[[design.vary]]\nparameter = "material.density"\nfrom = "2600 kg/m^3"\nto = "2800 kg/m^3"\n'
SPREAD = '[[tolerance.of]]\nparameter = "{}"\nspread = "{}"\n'
TOLERANCE = "[tolerance]\nsamples = 16\n" + SPREAD.format("cell.pillar.height", "20 um")


@pytest.fixture
def asking(study):
    """Write the quick study with tables in place of its sweep."""

    def write(*tables: str, changes: tuple[tuple[str, str], ...] = ()):
        return study((SWEEP, "\n" + "\n".join(tables)), *changes, name="asking.toml")

    return write


@pytest.fixture
def here(capsys, monkeypatch, tmp_path, store_folder):
    """Run the program in this process."""

    def run(*arguments: object):
        monkeypatch.setenv("HAPTONIC_STORE", str(store_folder))
        monkeypatch.setenv("COLUMNS", "200")
        monkeypatch.setenv("NO_COLOR", "1")
        monkeypatch.chdir(tmp_path)
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            app([str(argument) for argument in arguments])
        out, err = capsys.readouterr()
        return SimpleNamespace(code=ended.value.code or 0, out=out, err=err)

    return run


@pytest.fixture
def cheap(monkeypatch):
    """Designs are computed in a model that is coarser than their own, at fewer wavevectors."""
    monkeypatch.setattr(quick, "QUICK", Resolution(2, 1))
    monkeypatch.setattr(edges, "DIVISIONS", 4)


@pytest.mark.usefixtures("empty_pictures")
class TestDesign:
    @pytest.fixture
    def question(self, asking, cheap):
        return asking(LIMITS, HEIGHT, PITCH, DENSITY, changes=(FINE, BUILT_IN, ("[cell]\n", CONSTANTS)))

    def test_a_design_is_found_written_and_holds_the_carrier(
        self, inside, question, here, tmp_path, store_folder
    ):
        out = tmp_path / "out"
        ran = inside("design", question, "--pareto", "--json", "--out", out)
        assert ran.code == 0, ran.err
        assert len(ran.out.splitlines()) == 1
        answer = ran.json
        assert {path.name for path in out.iterdir()} == {
            "design.toml", "search.nc", "search.svg", "search.png", "front.nc", "front.svg", "front.png",
        }  # fmt: skip

        design = package.load(out / "design.toml")
        assert answer["study"] == (out / "design.toml").read_text("utf-8")
        own = package.load(question)
        assert design == own.with_parameters(answer["values"])
        assert design.design_settings == own.design_settings
        bounds = {item.parameter: (item.low, item.high) for item in own.design_settings.vary}
        assert answer["values"].keys() == bounds.keys()
        for path, (low, high) in bounds.items():
            assert low <= answer["values"][path] <= high
            assert design.parameters()[path] == answer["values"][path]
        assert design.cell.lattice.pitch != own.cell.lattice.pitch

        # the edges that the command promises are those of the written study
        gap = next(
            g
            for g in gaps_of(design.bands(store=Store(store_folder)).dataset)
            if g.complete and g.lower < 60e3 < g.upper
        )
        promised = answer["gap"]
        assert promised["between"] == list(gap.between)
        assert promised["lower_hz"] == pytest.approx(gap.lower, abs=promised["lower_error_hz"])
        assert promised["upper_hz"] == pytest.approx(gap.upper, abs=promised["upper_error_hz"])
        below = 60e3 - promised["lower_hz"] - promised["lower_error_hz"]
        above = promised["upper_hz"] - promised["upper_error_hz"] - 60e3
        assert answer["margin_hz"] == pytest.approx(min(below, above), rel=1e-9)
        assert answer["margin_hz"] > 0

        stages = [each["stage"] for each in answer["seen"]]
        assert sorted(stages, key=["look", "climb", "polish"].index) == stages
        assert set(stages) == {"look", "climb", "polish"}
        margins = [each["margin"] for each in answer["seen"] if each["stage"] == "polish"]
        assert all(a < b for a, b in pairwise(margins))
        data = xr.load_dataset(out / "search.nc", engine="h5netcdf")
        assert data.attrs["origin"] == "simulated"
        assert json.loads(data.attrs["inputs"])["cell"]["pitch"] == 0.007
        assert data["lower"].values.tolist() == [each["lower_hz"] for each in answer["seen"]]

        # a pitch that leaves no room for the pillar is shown as such
        front = answer["front"]
        assert front["pitch_m"] == pytest.approx([0.003, 0.0068])
        assert (front["lower_hz"][0], front["upper_hz"][0], front["margin"][0]) == (None, None, None)
        assert front["lower_hz"][1] < 60e3 < front["upper_hz"][1]
        assert front["margin"][1] == pytest.approx(
            min(60e3 - front["lower_hz"][1], front["upper_hz"][1] - 60e3) / 60e3
        )

        # once more, for a person: from the store, and not over the same files
        again = here("design", question, "--pareto", "--tables", "--out", tmp_path / "again")
        assert again.code == 0, again.err
        for words in ("best design", "with a margin of at least", "cell.pillar.height", "14.7 mm",
                      "widest gap around the carrier", "none", f"files: {tmp_path / 'again'}"):  # fmt: skip
            assert words in again.out.replace("\n", ""), words
        assert (tmp_path / "again" / "design.toml").read_text() == (out / "design.toml").read_text()

    def test_it_refuses_to_overwrite_before_computing(self, inside, question, tmp_path):
        out = tmp_path / "out"
        out.mkdir()
        (out / "front.nc").write_text("mine")
        assert_five_parts(
            inside("design", question, "--out", out, "--pareto", store=tmp_path / "store"),
            "front.nc",
            "overwrite",
            code="repeated",
            argument="output file",
        )
        assert [path.name for path in out.iterdir()] == ["front.nc"]
        assert (out / "front.nc").read_text() == "mine"
        assert not (tmp_path / "store").exists()

    def test_bounds_that_contradict_each_other(self, here, asking):
        path = asking('[design]\nslenderness = 3\nreach = "20 mm"\n', HEIGHT)
        for dry in ((), ("--dry-run",)):
            ran = here("design", path, *dry)
            assert_five_parts(ran, "cell.pillar.height", code="no-answer", argument="design")
        assert "slenderness = 4 in [design]" in here("plan", path).err

    def test_bounds_upside_down(self, here, asking):
        path = asking(HEIGHT.replace("16 mm", "12 mm"))
        assert_five_parts(
            here("design", path), "12 mm", "14 mm", code="conflict", argument="design.vary[1].to"
        )

    def test_an_unreachable_carrier_is_refused_with_closest_gap_and_limit(
        self, here, cheap, asking, tmp_path
    ):
        """Higher frequencies want shorter pillars; nothing goes from 60 to 75 kHz by a millimetre."""
        path = asking(LIMITS, HEIGHT, changes=(("60 kHz", "75 kHz"),))
        ran = here("design", path, "--out", tmp_path / "out")
        assert_five_parts(ran, "75 kHz", "14 mm", code="no-answer", argument="carrier")
        lower, upper = map(float, re.search(r"([0-9.]+) to ([0-9.]+) kHz", ran.err).groups())
        assert 50 < lower < upper < 75
        assert not (tmp_path / "out" / "design.toml").exists()

    def test_a_model_with_large_errors_is_refused(self, here, cheap, asking):
        """The closest design does hold the carrier, if only the edges' errors were smaller."""
        narrower = ('diameter = "3.5 mm"', 'diameter = "3.3 mm"')
        ran = here("design", asking(LIMITS, HEIGHT, changes=(narrower,)))
        assert_five_parts(ran, code="inaccurate", argument="bands.accuracy")

    def test_nothing_to_vary(self, here, study, tmp_path):
        assert_five_parts(
            here("design", study(), "--out", tmp_path / "out"), code="missing", argument="design.vary"
        )

    def test_no_carrier(self, here, asking):
        path = asking(HEIGHT, TOLERANCE, changes=(('carrier = "60 kHz"\n', ""),))
        for command in ("design", "tolerance"):
            assert_five_parts(here(command, path), "nothing", code="missing", argument="carrier")

    @pytest.mark.parametrize("tables", [[HEIGHT], [PITCH], []], ids=["no pitch", "only the pitch", "nothing"])
    def test_pareto_without_the_pitch_is_refused_before_computing(self, inside, asking, tables, tmp_path):
        ran = inside("design", asking(*tables), "--pareto", store=tmp_path / "store")
        assert_five_parts(ran, code="missing", argument="design.vary")
        assert not (tmp_path / "store").exists()

    def test_an_error_is_one_object_for_machines(self, here, study):
        ran = here("design", study(), "--json")
        assert ran.code == 2
        assert json.loads(ran.out)["error"]["argument"] == "design.vary"


@pytest.mark.usefixtures("empty_pictures")
class TestTolerance:
    def test_chances_and_export_with_the_tolerances_found(self, inside, cheap, asking, here, tmp_path):
        path, out = asking(TOLERANCE, changes=(FINE,)), tmp_path / "out"
        ran = inside("tolerance", path, "--json", "--out", out)
        assert ran.code == 0, ran.err
        assert len(ran.out.splitlines()) == 1
        answer = ran.json
        assert {p.name for p in out.iterdir()} == {"tolerance.nc", "tolerance.svg", "tolerance.png"}
        row = answer["parameters"]["cell.pillar.height"]
        assert len(answer["parameters"]) == 1
        assert all(slope < 0 for slope in row["slope_hz_per_si"].values())  # a taller pillar is a lower gap
        assert row["first_order_share"] == {"lower": 1.0, "upper": 1.0}
        assert row["total_index"] == pytest.approx({"lower": 1.0, "upper": 1.0}, abs=1e-3)
        # one parameter: to first order the deviation is that of a normal distribution cut at three sigma
        width = 20e-6 * np.sqrt(0.97333)
        wanted = {edge: -slope * width for edge, slope in row["slope_hz_per_si"].items()}
        assert answer["edges"]["first_order_deviation_hz"] == pytest.approx(wanted, rel=1e-3)
        assert answer["edges"]["deviation_hz"] == pytest.approx(wanted, rel=0.05)
        # the upper edge is near: the carrier is kept by pillars shorter than some height
        gap, spread = answer["gap"], truncnorm(-3, 3)
        assert 60e3 - gap["lower_hz"] > 10 * (gap["upper_hz"] - 60e3) > 0
        sigmas = (60e3 - gap["upper_hz"]) / row["slope_hz_per_si"]["upper"] / 20e-6
        assert answer["chance_to_first_order"] == pytest.approx(spread.cdf(sigmas), abs=5e-4)
        assert answer["chance_of_a_plate"] == pytest.approx(spread.cdf(sigmas), abs=3e-3)
        assert answer["chance_of_one_pillar"] == answer["chance_of_a_plate"]
        # within the error of the edge the carrier may as well be outside, or far inside
        low, high = answer["chance_of_a_plate_range"]
        ends = [sigmas + sign * gap["upper_error_hz"] / -row["slope_hz_per_si"]["upper"] / 20e-6
                for sign in (-1, 1)]  # fmt: skip
        assert [low, high] == pytest.approx(spread.cdf(ends), abs=3e-3)
        assert answer["loosest_factor"] == pytest.approx(sigmas / spread.ppf(0.99), rel=0.03)
        assert answer["largest_factor_tried"] == 2.0
        data = xr.load_dataset(out / "tolerance.nc", engine="h5netcdf")
        assert data["edge"].shape == (16, 2)
        assert data.attrs["origin"] == "simulated"

        # from here on the store has everything
        spoken = here("tolerance", path, "--tables", "--out", tmp_path / "again")
        assert spoken.code == 0, spoken.err
        for words in ("effects on the edges", "20 µm", "100.0", "Within the errors of the edges, ",
                      f"{100 * answer['chance_of_a_plate']:.2f} % for all 180 pillars",
                      f"may be {answer['loosest_factor']:.2f} times as large for a confidence of 99.0 %",
                      ):  # fmt: skip
            assert words in spoken.out, words

        exported = here("export", path, "--out", tmp_path / "files", "--drawing")
        assert exported.code == 0, exported.err
        assert {p.name for p in (tmp_path / "files").iterdir()} == {"asking.pdf", "asking-drawing.dxf"}
        wanted = answer["loosest_factor"] * 3 * 20e-6
        sheet = ezdxf.readfile(tmp_path / "files" / "asking-drawing.dxf").paperspace("Drawing")
        styles = [(d.get_measurement(), d.override()) for d in sheet.query("DIMENSION")]
        (height,) = [(m * s.get("dimlfac"), s) for m, s in styles if s.get("dimtol")]
        assert height[0] == pytest.approx(14.7)
        assert height[1].get("dimtp") == height[1].get("dimtm") == pytest.approx(1e3 * wanted)
        texts = " ".join(
            text.get_text() for text in part_drawing(
                Part.piece(package.load(path).cell), "", tolerances={"cell.pillar.height": wanted}
            ).figure().findobj(Text))  # fmt: skip
        assert f"14.700 ±{1e3 * wanted:.3f}" in texts

    def test_it_refuses_to_overwrite_before_computing(self, inside, asking, tmp_path):
        (tmp_path / "out").mkdir()
        (tmp_path / "out" / "tolerance.svg").write_text("mine")
        assert_five_parts(
            inside("tolerance", asking(TOLERANCE), "--out", tmp_path / "out", store=tmp_path / "store"),
            "tolerance.svg",
            code="repeated",
            argument="output file",
        )
        assert (tmp_path / "out" / "tolerance.svg").read_text() == "mine"
        assert not (tmp_path / "store").exists()

    def test_no_spreads(self, here, study):
        assert_five_parts(here("tolerance", study()), code="missing", argument="tolerance.of")

    def test_too_few_samples(self, here, asking):
        names = ("cell.pillar.height", "cell.pillar.diameter", "cell.thickness")
        path = asking("[tolerance]\nsamples = 19\n", *(SPREAD.format(name, "20 um") for name in names))
        assert_five_parts(
            here("tolerance", path), "at least 20", code="too-few", argument="tolerance.samples"
        )

    @pytest.mark.parametrize("carrier", ["40 kHz", "70 kHz"])
    def test_a_carrier_outside_the_gap(self, here, asking, carrier):
        path = asking(TOLERANCE, changes=(("60 kHz", carrier),))
        assert_five_parts(
            here("tolerance", path), carrier, "haptonic design", code="no-answer", argument="carrier"
        )

    @pytest.mark.parametrize(
        ("name", "spread", "words"),
        [
            ("cell.pillar.diameter", "2 mm", "cannot be negative"),
            ("cell.thickness", "0.6 mm", "cannot be negative"),
            ("material.youngs_modulus", "40 GPa", "outside the range"),
        ],
    )
    def test_spreads_that_make_no_body(self, here, asking, name, spread, words):
        path = asking("[tolerance]\nsamples = 16\n", SPREAD.format(name, spread), changes=(FINE,))
        for options in ([], ["--dry-run"]):
            ran = here("tolerance", path, *options)
            assert_five_parts(ran, name, words, code="out-of-range", argument="tolerance.of[1].spread")
            assert "up to 6 spreads away" in ran.err
        largest = re.search(r'at most "(.+)"', ran.err)[1]
        possible = asking("[tolerance]\nsamples = 16\n", SPREAD.format(name, largest), changes=(FINE,))
        assert here("tolerance", possible, "--dry-run").code == 0

    def test_spreads_that_make_no_body_together(self, here, asking):
        spreads = (SPREAD.format("cell.pillar.diameter", "0.5 mm"), SPREAD.format("cell.pitch", "0.5 mm"))
        path = asking("[tolerance]\nsamples = 16\n", *spreads, changes=(FINE,))
        ran = here("tolerance", path, "--dry-run")
        assert_five_parts(ran, "together", code="out-of-range", argument="tolerance.of")

    def test_a_drawing_with_too_large_spreads_has_none(self, here, asking, tmp_path):
        path = asking(
            "[tolerance]\nsamples = 16\n", SPREAD.format("cell.thickness", "0.6 mm"), changes=(FINE,)
        )
        ran = here("export", path, "--drawing", "--json", "--out", tmp_path / "files")
        assert ran.code == 0, ran.err
        reason = json.loads(ran.out)["why_no_tolerances"]
        assert reason.startswith("a spread is too large, see tolerance.of[1].spread: at most ")


@pytest.fixture
def without_netgen(monkeypatch):
    """What the extra "cad" brings cannot be imported."""
    monkeypatch.setitem(sys.modules, "netgen", None)


@pytest.fixture
def blank_sheets(monkeypatch):
    """Drawings whose pictures are blank: `tests/workshop` has those."""
    monkeypatch.setattr("haptonic.workshop.sheet.Sheet.figure", lambda sheet: Figure())


@pytest.mark.usefixtures("blank_sheets")
class TestExport:
    def test_all_files_unless_some_are_named(self, inside, study, tmp_path):
        ran = inside("export", study(), "--out", tmp_path / "all", "--columns", 3, "--rows", 2, "--json")
        assert ran.code == 0, ran.err
        names = {*(f"quick.{kind}" for kind in ("step", "dxf", "stl", "pdf")), "quick-drawing.dxf"}
        assert {p.name for p in (tmp_path / "all").iterdir()} == names
        assert sorted(ran.json["files"]) == sorted(str(p) for p in (tmp_path / "all").iterdir())
        assert (tmp_path / "all" / "quick.pdf").read_bytes().startswith(b"%PDF")
        assert "ISO-10303-21" in (tmp_path / "all" / "quick.step").read_text()[:40]

    def test_named_ones_go_to_the_usual_folder(self, here, study, tmp_path):
        ran = here("export", study(), "--dxf", "--stl")
        assert ran.code == 0, ran.err
        folder = tmp_path / "results" / "quick-export"
        assert {p.name for p in folder.iterdir()} == {"quick.dxf", "quick.stl"}
        assert "written: quick.dxf, quick.stl" in " ".join(ran.out.split())
        single = (folder / "quick.stl").stat().st_size
        assert here("export", study(), "--stl", "--overwrite", "--columns", 2).code == 0
        assert (folder / "quick.stl").stat().st_size > 1.5 * single

    def test_an_oblique_piece_is_described_by_its_sides_and_angle(self, inside, tmp_path):
        path = tmp_path / "oblique.toml"
        path.write_text(
            'material = "steel"\n[cell]\npitch = "7 mm"\nlattice = "triangular"\nthickness = "1 mm"\n'
            '[cell.pillar]\ndiameter = "3 mm"\nheight = "4 mm"\n'
        )
        ran = inside("export", path, "--dxf", "--out", tmp_path / "out", "--columns", 3, "--rows", 2)
        assert ran.code == 0, ran.err
        assert "3 x 2 cells, 21 mm x 14 mm at 60 deg, with 6 pillars" in " ".join(ran.out.split())

    @pytest.mark.parametrize("machine", daily([[], ["--json"]], ["--json"]), ids=["person", "machine"])
    @pytest.mark.usefixtures("without_netgen")
    def test_without_the_extra_the_other_files_are_written_and_listed(self, inside, study, tmp_path, machine):
        """Only files that exist are listed, and a single sentence gives the reason for the missing solid."""
        out = tmp_path / "out"
        ran = inside("export", study(), "--out", out, *machine)
        assert ran.code == 0, ran.err
        there = {path.name for path in out.iterdir()}
        assert there == {"quick.dxf", "quick.stl", "quick.pdf", "quick-drawing.dxf"}
        missing = "quick.step is not written: the extra for CAD files is not installed; run: pip install"
        if machine:
            answer = ran.json
            assert {Path(file).name for file in answer["files"]} == there
            assert [missing in text for text in answer["warnings"]] == [True]
        else:
            assert "step" not in ran.out
            assert " ".join(ran.err.split()).count(missing) == 1

    @pytest.mark.usefixtures("without_netgen")
    def test_without_the_extra_a_solid_asked_for_by_name_is_refused_before_any_file(
        self, inside, study, tmp_path
    ):
        ran = inside("export", study(), "--step", "--stl", "--out", tmp_path / "out")
        assert ran.code == 2
        assert "not-installed" in ran.err
        assert "quick.step" not in ran.out
        assert not (tmp_path / "out").exists()

    def test_the_whole_plate_of_a_study_or_a_piece_of_its_lattice(self, here, plated, tmp_path):
        """Without numbers of cells, the plate; its tiles, pillars and patch are those of the map."""
        answers = {}
        for name, more in {"plate": [], "piece": ["--columns", 2]}.items():
            out = tmp_path / name
            ran = here("export", plated(), "--dxf", "--stl", "--out", out, "--json", *more)
            assert ran.code == 0, ran.err
            answers[name] = json.loads(ran.out)
            space = ezdxf.readfile(out / "quick.dxf").modelspace()
            assert len(space.query('CIRCLE[layer=="PILLAR"]')) == answers[name]["pillars"]
            assert len(space.query('*[layer=="PATCH"]')) == (name == "plate")
        assert answers["plate"]["whole_plate"]
        assert answers["plate"]["pillars"] == 4
        assert answers["plate"]["size_m"] == pytest.approx([28e-3, 14e-3])
        assert not answers["piece"]["whole_plate"]
        assert answers["piece"]["pillars"] == 2
        assert answers["piece"]["size_m"] == pytest.approx([14e-3, 7e-3])

    def test_a_plate_with_too_many_pillars(self, here, plated, tmp_path):
        ran = here("export", plated(("rows = 2\nloss", "rows = 1000\nloss")), "--out", tmp_path / "out")
        assert_five_parts(ran, "2000 pillars", "--columns", code="too-large", argument="export")
        assert not (tmp_path / "out").exists()

    def test_nothing_is_written_if_one_name_is_taken(self, here, study, tmp_path):
        folder = tmp_path / "out"
        folder.mkdir()
        (folder / "quick.pdf").write_text("mine")
        assert_five_parts(
            here("export", study(), "--out", folder), "quick.pdf", code="repeated", argument="output file"
        )
        assert [p.name for p in folder.iterdir()] == ["quick.pdf"]
        assert (folder / "quick.pdf").read_text() == "mine"

    @pytest.mark.parametrize(("option", "number"), [("--columns", 0), ("--rows", -1)])
    def test_impossible_numbers_of_cells(self, inside, asking, tmp_path, option, number):
        asked = ("export", asking(TOLERANCE), "--out", tmp_path / "out", option, number)
        ran = inside(*asked, store=tmp_path / "store")
        assert_five_parts(ran, option.strip("-"), str(number), code="out-of-range")
        assert not (tmp_path / "out").exists()
        assert not (tmp_path / "store").exists()

    @pytest.mark.parametrize(
        ("changes", "reason"),
        [
            ((("60 kHz", "40 kHz"),), "see carrier: no complete gap of the cell contains the carrier"),
            ((('carrier = "60 kHz"', ""),), "see carrier: the study does not give the frequency"),
        ],
        ids=["no gap", "no carrier"],
    )
    def test_a_drawing_without_a_gap_has_nominal_sizes_and_states_the_reason(
        self, here, asking, tmp_path, changes, reason
    ):
        ran = here("export", asking(TOLERANCE, changes=changes), "--out", tmp_path / "out", "--json")
        assert ran.code == 0, ran.err
        answer = json.loads(ran.out)
        assert reason in answer["why_no_tolerances"]
        assert reason in " ".join(ran.err.split())
        assert answer["tolerances"] == {}
        (file,) = (tmp_path / "out").glob("*-drawing.dxf")
        drawn = ezdxf.readfile(file).paperspace("Drawing")
        assert len(drawn.query("DIMENSION")) > 3
        words = " ".join(text.plain_text() for text in drawn.query("TEXT MTEXT"))
        assert reason in words
        assert "ISO 2768-m" in words

    def test_what_is_asked_wrongly_of_spreads_is_refused_and_nothing_is_written(self, here, asking, tmp_path):
        names = ("cell.pillar.height", "cell.pillar.diameter", "cell.thickness")
        path = asking("[tolerance]\nsamples = 19\n", *(SPREAD.format(name, "20 um") for name in names))
        ran = here("export", path, "--out", tmp_path / "out")
        assert_five_parts(ran, code="too-few", argument="tolerance.samples")
        assert not (tmp_path / "out").exists()
        assert here("export", path, "--out", tmp_path / "out", "--dxf").code == 0

    def test_only_what_the_drawing_shows_is_toleranced(self, asking, monkeypatch):
        """A draft of zero is not dimensioned, and a material is not machined."""
        tables = [
            SPREAD.format("cell.pillar.draft", "0.1 deg"),
            SPREAD.format("material.density", "9 kg/m^3"),
        ]
        study = package.load(asking(TOLERANCE, *tables))
        result = SimpleNamespace(loosest=0.5, plate=0.42)
        monkeypatch.setattr("haptonic.analyses.tolerance.compute", lambda *_: result)
        drawn = {"cell.pillar.height": pytest.approx(0.5 * 3 * 20e-6)}
        assert export.drawn_tolerances(study, Runner()) == (drawn, "")

    def test_discs_that_share_a_level_share_its_tolerance(self, monkeypatch):
        glued = """
            carrier = "60 kHz"
            material = "steel"
            [cell]
            pitch = "7 mm"
            thickness = "1.5 mm"
            [[cell.disc]]
            diameter = "3 mm"
            low = "0 mm"
            high = "0.2 mm"
            material = "epoxy"
            [[cell.disc]]
            diameter = "4 mm"
            low = "0.2 mm"
            high = "9 mm"
        """
        result = SimpleNamespace(loosest=0.5, plate=0.42)
        monkeypatch.setattr("haptonic.analyses.tolerance.compute", lambda *_: result)
        names = ("cell.disc[1].high", "cell.disc[2].diameter")
        study = loads(glued + "[tolerance]\n" + "".join(SPREAD.format(name, "20 um") for name in names))
        half = pytest.approx(30e-6)
        drawn = dict.fromkeys((*names, "cell.disc[2].low"), half)
        assert export.drawn_tolerances(study, Runner()) == (drawn, "")

    @pytest.mark.parametrize(
        ("spreads", "reason"),
        [
            ([TOLERANCE], "no tolerance keeps the carrier in the gap with the confidence of "
                          "[tolerance], 99.0 %; with the study's own spreads the probability is 42.00 %"),
            ([], "the study gives no spreads"),
            ([TOLERANCE.replace("cell.pillar.height", "material.density").replace("20 um", "9 kg/m^3")],
             "the study gives spreads only for material constants or sizes that are not drawn"),
        ],
    )  # fmt: skip
    def test_missing_tolerances_are_explained(self, here, asking, tmp_path, monkeypatch, spreads, reason):
        """In the drawing, on the terminal if some were asked for, and to machines."""
        result = SimpleNamespace(loosest=0.0, plate=0.42)
        monkeypatch.setattr("haptonic.analyses.tolerance.compute", lambda *_: result)
        for machine in ([], ["--json"]):
            out = tmp_path / f"files{len(machine)}"
            ran = here("export", asking(*spreads), "--out", out, "--drawing", *machine)
            assert ran.code == 0, ran.err
            assert (reason in ran.err.replace("\n", " ")) == bool(spreads)
            (file,) = out.glob("*-drawing.dxf")
            drawn = ezdxf.readfile(file).paperspace("Drawing")
            words = " ".join(text.plain_text() for text in drawn.query("TEXT MTEXT"))
            assert f"No dimension has a tolerance of its own: {reason.split(',')[0]}" in words
        assert reason in json.loads(ran.out)["why_no_tolerances"]
