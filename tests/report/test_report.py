"""The report: a self-contained file that names what is missing, and shows the numbers that it was given."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import asdict, fields, replace
from datetime import UTC, datetime
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from five_parts import refusing
from haptonic.bloch import gaps_of
from haptonic.cell import Disc, MeshPlan, UnitCell
from haptonic.errors import ResourceError
from haptonic.fields import unchecked
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plots.text import gap_text
from haptonic.report import Absent, Chapter, Results, Table, write_report
from haptonic.report.chapters import IN_ORDER, comparison, dispersion, mirror, sweeps
from haptonic.report.first import first_screen
from haptonic.report.page import MESH, _appendix, page
from haptonic.report.trend import fitted_power, trend_of
from haptonic.results.bands import Bands
from haptonic.results.references import References
from haptonic.results.sweeps import Sweep, Sweeps
from haptonic.study import Study
from simulated import (
    reference_bands,
    reference_guides,
    reference_layers,
    reference_study,
    results_of,
    simulated_sweep,
)
from toy import Toy

STARTED = datetime(2030, 1, 2, 3, 4, tzinfo=UTC)
VOID = {"meta", "img", "br", "hr", "link", "input"}


class Reader(HTMLParser):
    """Tags with their attributes, the text, and whether every element was closed in order."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if not self.open or self.open[-1] != "style":
            self.words.append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.words).split())

    def of(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.tags if name == tag]


def read(content: str) -> Reader:
    reader = Reader()
    reader.feed(content.replace("<wbr>", ""))  # a place where a word may be broken
    reader.close()
    assert not reader.open
    return reader


REFERENCES = References.read(Path(__file__).parents[2] / "studies" / "references" / "touchpad.toml")


def results(**changes) -> Results:
    sweeps = (simulated_sweep(), simulated_sweep(expression="cell.pillar.height / cell.pitch", own_value=0.6))
    timings = {"bands": 1.26, "sweeps": 20.0}
    whole = {"study": reference_study(), "bands": reference_bands(), "sweeps": sweeps, "timings": timings,
             "started": STARTED, "references": REFERENCES}  # fmt: skip
    return results_of(**{**whole, **changes})


def mirrored(**changes) -> Results:
    return results(**{"layers": reference_layers(), "waveguide": reference_guides(), **changes})


def study_with(**changes: object) -> Study:
    return unchecked(reference_study(), **changes)


@pytest.fixture
def empty_pictures(monkeypatch):
    """Pictures are drawn but neither arranged nor rendered, which takes most of the time of a page."""
    monkeypatch.setattr("haptonic.plots.style.arrange", lambda figure: None)
    monkeypatch.setattr("haptonic.plots.rendered", lambda figure, kind: b"<svg/>")
    monkeypatch.setattr("haptonic.plots.moving_modes", lambda dataset: b"")
    for name in ("mode_shapes", "iso_frequency", "layers", "decay", "guide"):
        monkeypatch.setattr(f"haptonic.plots.{name}", lambda *_, **__: Figure())


@pytest.fixture
def undrawn_mirror(monkeypatch):
    """The pictures of a mirror stay empty: the tests of its words need none."""
    for name in ("layers", "decay", "guide"):
        monkeypatch.setattr(f"haptonic.plots.{name}", lambda *_, **__: Figure())


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("haptonic.plots.modes.MOMENTS", 2)  # of moving modes; each moment takes half a second
        path = write_report(mirrored(), tmp_path_factory.mktemp("report") / "report.html")
    return path.read_text("utf-8")


class TestOneFile:
    def test_it_needs_nothing_from_elsewhere(self, whole):
        reader = read(whole)
        for tag, attributes in reader.tags:
            assert tag not in {"script", "link", "iframe", "object", "embed", "base"}
            for name in ("src", "href", "srcset", "data", "action", "poster"):
                value = attributes.get(name)
                assert value is None or value.startswith(("#", "data:image/")), (tag, name)
            assert not [name for name in attributes if name.startswith("on")]
        style = re.search(r"<style>(.*?)</style>", whole, re.S).group(1)
        assert "url(" not in style
        assert "@import" not in style

    def test_pictures_hold_all_of_themselves_and_have_words_in_their_place(self, whole):
        images = read(whole).of("img")
        assert len(images) == 11  # one of them again on the first screen
        moving = [image for image in images if image["src"].startswith("data:image/gif;base64,R0lGOD")]
        assert len(moving) == 1
        for image in images:
            assert len(image["alt"]) > 30
            kind, content = image["src"].split(",", 1)
            if image in moving:
                continue
            assert kind == "data:image/svg+xml;base64"
            svg = base64.b64decode(content).decode()
            assert not re.findall(r'href="(?!#|data:)', svg)

    def test_findings_lead_to_the_picture_that_shows_them(self, whole):
        figures = dict(re.findall(r'<figure id="([^"]*)">.*?<figcaption>(.*?)</figcaption>', whole, re.S))
        assert list(figures) == [f"picture-{k}" for k in range(1, 10)]
        findings = {text: re.findall(r'<a href="#([^"]*)">(.*?)</a>', text)
                for text in re.findall(r"<li>(.*?)</li>", whole.split("</nav>")[1])}  # fmt: skip
        for text, links in findings.items():
            for anchor, words in links:
                assert figures[anchor].startswith(f"<strong>{words}.</strong>")
            shown = "dispersion" if "omplete gap from" in text else "energy" if "energy" in text else ""
            assert not shown or shown in figures[links[0][0]], text

    def test_a_picture_that_moves_can_be_held_and_is_still_where_motion_is_unwanted(self, whole):
        reader = read(whole)
        (hold,) = reader.of("input")
        assert hold["type"] == "checkbox"
        assert hold["id"] in [label.get("for") for label in reader.of("label")]
        style = re.search(r"<style>(.*?)</style>", whole, re.S)[1]
        always, wanted = style.split("@media screen and (prefers-reduced-motion: no-preference) {")
        assert ".pace, .moves { display: none; }" in always
        assert ".moves" not in always.replace(".pace, .moves { display: none; }", "")
        assert ".pace:not(:has(:checked)) ~ .still { display: none; }" in wanted.split("\n}")[0]

    def test_every_entry_of_the_contents_leads_somewhere_once(self, whole):
        reader = read(whole)
        identifiers = [attributes["id"] for _, attributes in reader.tags if "id" in attributes]
        assert len(set(identifiers)) == len(identifiers)
        past_the_contents, *targets = [link["href"].removeprefix("#") for link in reader.of("a")]
        assert past_the_contents == "dispersion"
        chapters = [anchor for anchor in targets if not anchor.startswith("picture-")]
        assert chapters == ["dispersion", "modes", "sweeps", "mirror", "comparison", "appendix"]
        assert set(targets) <= set(identifiers)

    def test_it_names_its_language_and_fits_a_phone(self, whole):
        reader = read(whole)
        assert reader.of("html")[0]["lang"] == "en"
        assert any(meta.get("name") == "viewport" for meta in reader.of("meta"))
        assert "@media print" in whole

    def test_a_light_has_its_colour_and_its_word(self, empty_pictures):
        class Lights(Toy):
            def tables(self):
                rows = [("● green", "a"), ("▲ amber", "b"), ("", "red"), ("5", "red")]
                return [Table("lights", ("light", "demand"), rows)]

        content = page(replace(results(), parts={**results().parts, "toy": Lights(2)}))
        assert re.findall(r'class="light (\w+)">(.*?)</th>', content) == [
            ("green", "● green"),
            ("amber", "▲ amber"),
        ]

    def test_it_is_not_replaced_unasked(self, tmp_path):
        path = tmp_path / "report.html"
        path.write_text("mine")
        with refusing(ResourceError, "repeated", "output file"):
            write_report(results(), path)
        assert path.read_text() == "mine"
        assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


@pytest.mark.usefixtures("empty_pictures")
class TestHostileInput:
    TITLE = '<script>alert(1)</script> & "quotes" \' {{ 7 * 7 }}'

    def test_a_title_is_text_and_nothing_else(self):
        content = page(results(study=study_with(title=self.TITLE)))
        reader = read(content)
        assert not reader.of("script")
        assert self.TITLE in reader.text
        assert "49" not in reader.words[0]

    def test_names_in_the_material_and_the_sweep_are_text(self):
        cell = reference_study().cell
        cell = replace(cell, material=replace(cell.material, name="<img src=x onerror=alert(1)>"))
        sweep = simulated_sweep(expression="<b>$x$ / y_{</b>")
        reader = read(page(results(study=study_with(cell=cell), sweeps=(sweep,))))
        assert not reader.of("b")
        assert all(image["src"].startswith("data:") for image in reader.of("img"))


@pytest.mark.usefixtures("empty_pictures")
class TestChaptersLeftOut:
    def test_the_head_of_a_report_without_sweeps_lists_the_omitted_chapter(self):
        reader = read(page(results(sweeps=())))
        assert "sweeps" not in [link["href"].removeprefix("#") for link in reader.of("a")]
        assert "Left out: Sweeps, because they were not computed in this run." in reader.text

    def test_a_study_without_sweeps_is_distinguished_from_one_not_run(self):
        text = read(page(results(study=study_with(sweep_settings=()), sweeps=()))).text
        assert "because the study describes none" in text

    def test_without_mode_shapes(self):
        bands = reference_bands().drop_vars(["mode_real", "mode_imag"])
        text = read(page(results(bands=bands))).text
        assert "Left out: Mode shapes" in text

    def test_without_the_whole_zone_its_pictures_are_left_out(self):
        bands = reference_bands().drop_vars(["zone_frequency"])
        assert len(read(page(results(bands=bands))).of("img")) == 6

    def test_a_study_without_references_is_not_compared(self):
        text = read(page(results(references=None, sweeps=()))).text
        assert "Left out: Comparison, because the study brings no reference values" in text
        assert "the paper" not in text
        assert "61.4" not in text
        assert "58.8" not in text

    def test_the_head_of_a_report_without_a_mirror_lists_the_omitted_chapter(self):
        reader = read(page(results()))
        assert "mirror" not in [link["href"].removeprefix("#") for link in reader.of("a")]
        assert len(reader.of("img")) == 8
        assert "Left out: Mirror, because it was not computed in this run." in reader.text

    def test_the_mirror_chapter_omits_a_missing_waveguide(self):
        reader = read(page(mirrored(waveguide=None, references=None)))
        assert len(reader.of("img")) == 10
        assert "mirror" in [link["href"].removeprefix("#") for link in reader.of("a")]
        chapter = reader.text[reader.text.index("A plane wave of the plain plate") :]
        assert "waveguide" not in chapter[: chapter.index("Appendix")]

    def test_a_plate_without_a_pillar_has_a_report(self):
        cell = reference_study().cell.without_pillar()
        report = read(page(results(study=study_with(cell=cell, sweep_settings=()), sweeps=())))
        assert "pitch 7 mm; plate 1.5 mm" in report.text

    def test_every_chapter_is_present_or_gives_a_reason(self):
        left_out = [
            chapter.title for chapter in (c(mirrored()) for c in IN_ORDER) if isinstance(chapter, Absent)
        ]
        without = ["Plate", "Simulated scan", "Friction at a fingertip", "Friction trials"]
        assert left_out == without, "no plate was computed here"
        for chapter in IN_ORDER:
            answer = chapter(results(study=study_with(sweep_settings=()), sweeps=()))
            assert isinstance(answer, Chapter | Absent)


@pytest.mark.usefixtures("empty_pictures")
class TestWords:
    def test_all_results_are_marked_as_simulated(self, whole):
        text = read(whole).text
        assert "All results on this page are simulated" in text
        first, *others = re.findall(r"<figcaption>(.*?)</figcaption>", whole)
        assert re.fullmatch(r'Simulated.*<a href="#picture-(\d+)">Figure \1 in its chapter</a>', first)
        for caption in others:
            assert re.match(r"<strong>Figure \d+\.</strong> Simulated", caption)

    def test_numbers_follow_the_results(self, whole):
        """Frequencies doubled: no number of the first report's gap may be left, but the paper's own."""
        bands = reference_bands()
        for name in ("gap_lower", "gap_upper", "frequency", "mode_frequency"):
            bands[name] = 2 * bands[name]
        text = read(page(results(bands=bands, sweeps=()))).text
        for name in ("gap_lower", "gap_upper"):
            value = float(reference_bands()[name][0]) / 1e3
            assert f"{value:.1f}" in read(whole).text
            assert not re.search(rf"(?<!\d){value:.1f}\d? ±", text)
            assert f"{2 * value:.1f}" in text

    def test_inputs_are_listed_with_title_and_unit(self, whole):
        rows = re.findall(
            r"<tr><th scope=\"row\"[^>]*>(.*?)</th><td.*?>(.*?)</td><td.*?>(.*?)</td></tr>", whole
        )
        listed = {
            key.replace("<wbr>", ""): (title, value.replace("\N{NO-BREAK SPACE}", " "))
            for key, title, value in rows
        }
        assert listed["cell.pitch"] == ("Pitch", "7 mm")
        assert listed["material.density"] == ("Density", "2700 kg/m^3")
        assert listed["sweep[2].to"] == ("Last value", "3")

    def test_every_cell_has_the_name_of_its_column_for_narrow_screens(self, whole):
        for head, body in re.findall(r"<thead>(.*?)</thead>\s*<tbody>(.*?)</tbody>", whole, re.DOTALL):
            names = re.findall(r"<th scope=\"col\">(.*?)</th>", head)
            for row in re.findall(r"<tr>(.*?)</tr>", body, re.DOTALL):
                assert re.findall(r"data-name=\"(.*?)\"", row) == names

    def test_constants_of_a_material_given_by_name_are_listed(self):
        cell = replace(reference_study().cell, material="aluminium-paper")
        text = read(page(results(study=study_with(cell=cell), sweeps=()))).text
        assert "material: youngs_modulus" in text
        assert "70 GPa" in text

    def test_run_times_are_listed(self, whole):
        times = dict(re.findall(r"<tr><th scope=\"row\"[^>]*>(.*?)</th><td.*?>(.*?)</td></tr>", whole))
        assert "1.3" in times["bands"]

    def test_no_machine_path_or_address_is_named(self, whole):
        text = read(whole).text
        assert "/work" not in text
        assert "/tmp" not in text
        assert "http" not in text

    @pytest.mark.parametrize(
        ("carrier", "words"),
        [(56e3, "lies inside the gap"), (40e3, "lies in no complete gap"), (60.0e3, "close enough")],
    )
    def test_the_carrier_is_judged(self, carrier, words):
        bands = reference_bands()
        bands["gap_upper_error"][0] = 30.0
        chapter = dispersion.chapter(results(bands=bands.assign_attrs(carrier_hz=carrier)))
        assert words in " ".join(chapter.findings)

    @pytest.mark.parametrize(
        ("carrier", "step"),
        [
            (None, "run `haptonic design`"),
            (30e3, "so none around 30 kHz: change"),
            (500e3, "500 kHz, lies above"),
        ],
    )
    def test_without_a_gap_there_is_a_next_step(self, carrier, step):
        bands = reference_bands().isel(gap=slice(0, 0))
        words = Bands(bands.assign_attrs({} if carrier is None else {"carrier_hz": carrier})).summary()[0]
        assert words.startswith("The computed bands have no complete gap")
        assert step in words
        assert ("bands.count" in words) == (carrier != 30e3)  # further bands are not below the last one

    def test_a_carrier_within_the_error_of_an_edge_is_not_called_safe(self):
        bands = reference_bands()
        carrier = float(bands["gap_upper"][0]) - 0.5 * float(bands["gap_upper_error"][0])
        chapter = dispersion.chapter(results(bands=bands.assign_attrs(carrier_hz=carrier)))
        assert "may lie inside the gap" in chapter.findings[-2]


class TestComparison:
    def rows(self, **changes):
        return {row[0]: row for row in comparison.chapter(results(**changes)).tables[0].rows}

    def test_the_gap_is_beside_the_reference_with_its_difference(self):
        row = self.rows()["Complete gap, upper edge"]
        ours = float(reference_bands()["gap_upper"][0]) / 1e3
        assert row[1] == "61.4 kHz"
        off = float(row[3].split()[0].replace("\N{MINUS SIGN}", "-"))
        assert off == pytest.approx(ours - 61.4, abs=0.006)
        assert "61.5 kHz" in row[4]

    def test_an_edge_within_our_error_agrees(self):
        bands = reference_bands()
        bands["gap_upper"][0] = 61.42e3
        assert self.rows(bands=bands)["Complete gap, upper edge"][4].startswith("Agrees within our error")

    def test_texts_and_numbers_of_bands(self):
        rows = self.rows()
        assert rows["Bands below and above the gap"][2:4] == ("6 and 7", "none")
        assert rows["M3"][1:4] == ("traction", "longitudinal", "none")
        assert rows["M1 and M2"][1:4] == ("paired by flexural mode", "pillar bending 1", "none")
        assert rows["M5"][1:4] == ("expansion", "torsion", "differs")

    def test_what_was_not_computed_has_no_difference(self):
        assert self.rows()["Distance of its nodal lines"][2:4] == ("not computed in this run", "-")
        strip = reference_guides().best
        row = {r[0]: r for r in comparison.chapter(mirrored()).tables[0].rows}["Distance of its nodal lines"]
        assert float(row[2].split()[0]) == pytest.approx(1e3 * strip.spacing, abs=0.06)

    def test_without_a_gap_nothing_is_compared_with_its_edges(self):
        bands = reference_bands()
        bands["gap_complete"][:] = 0
        assert self.rows(bands=bands)["Complete gap, lower edge"][2:4] == ("not computed in this run", "-")

    def test_variants_are_compared_with_the_first_of_their_table(self):
        first, second, third = REFERENCES.variant[:3]
        varied = replace(results(), variants=((first, 50e3), (second, 51e3), (third, None)))
        _, lower, upper = comparison.chapter(varied).tables
        assert [row[1:] for row in lower.rows] == [("50.00 kHz", "+0.00 %"), ("51.00 kHz", "+2.00 %")]
        assert upper.rows[0][1:] == ("-", "-")

    def test_remarks_and_figures_reach_their_chapters(self, whole, empty_pictures, undrawn_mirror):
        text = read(whole).text
        assert "The paper gives no details of its statement that three rows are enough." in text
        assert "(Fig. 4A of the paper)" in text
        without = read(page(mirrored(references=None))).text
        assert "the paper" not in without

    def test_no_reader_is_given_a_key_of_our_bibliography(self, whole):
        keys = re.findall(
            r"@\w+\{([^,]+),", (Path(__file__).parents[2] / "docs" / "references.bib").read_text("utf-8")
        )
        text = read(whole).text
        assert not [key for key in keys if f"[{key}]" in text]
        assert "Daunizeau, Gueorguiev, Haliyo and Hayward, “Phononic" in text


def test_a_key_is_broken_at_its_dots_and_nowhere_else(whole):
    heads = re.findall(r'<th scope="row"[^>]*>([^\s<]+(?:<wbr>[^\s<]+)*)</th>', whole)
    assert "cell.<wbr>pillar.<wbr>diameter" in heads
    assert "overflow-wrap: anywhere" not in whole


def test_every_number_of_a_mesh_has_words_and_every_tile_its_column():
    assert set(MESH) == {field.name for field in fields(MeshPlan)}
    bands = reference_bands()
    plan = json.loads(bands.attrs["mesh"])
    bands.attrs["mesh"] = json.dumps([plan, plan | {"pillar_layers": 17}])
    (table,) = (table for table in _appendix(results(bands=bands)).tables if table.title.startswith("Mesh"))
    assert table.head == ("What", "Tile 1", "Tile 2")
    layers = str(plan["pillar_layers"])
    assert [row[1:] for row in table.texts if row[0] == MESH["pillar_layers"]] == [(layers, "17")]


def test_a_mesh_of_discs_is_described_by_its_layers_and_rings():
    discs = (Disc(4e-3, low=-0.7e-3, empty=True),)
    cell = UnitCell(Lattice.square(7e-3), 1.5e-3, material("steel"), disc=discs)
    plan = json.loads(json.dumps(asdict(MeshPlan.suited(cell, 3, 1))))
    bands = reference_bands()
    bands.attrs["mesh"] = json.dumps(plan)
    (mesh,) = (table for table in _appendix(results(bands=bands)).tables if table.title.startswith("Mesh"))
    (text,) = (row[1] for row in mesh.texts if row[0] == MESH["stack"])
    assert text == "4 layers, 4 rings"


def test_an_accuracy_that_was_not_reached_is_a_finding():
    bands = reference_bands()
    for error, reported in ((0.0312, True), (0.002, False)):
        chapter = dispersion.chapter(results(bands=bands.assign_attrs(largest_error=error, accuracy=2e-3)))
        assert ("errors go up to 0.032 of a frequency" in str(chapter.findings[-1])) == reported


def test_a_result_that_no_chapter_knows_has_a_plain_one(empty_pictures):
    text = read(page(results(toy=Toy(3)))).text
    assert "A toy" in text
    assert "It counts to 3." in text


@pytest.mark.usefixtures("undrawn_mirror")
class TestMirror:
    """Simulated: with A0 at normal incidence a row adds so many dB, and three rows of 7 dB give 21 dB."""

    def mirror(self, per_row: float = 7.0, own: float = 0.25, **changes) -> Results:
        layers = reference_layers()
        rows = layers.dataset["many"].values
        shares = np.array([own, 1 - own, 0.0, 0.0])
        layers.dataset["carrier_transmitted"].loc[{"incident": "A0"}] = (
            10 ** (-per_row * rows[:, None] / 10) * shares
        )
        return mirrored(**{"layers": layers, **changes})

    def findings(self, per_row: float = 7.0, **changes) -> str:
        return " ".join(mirror.chapter(self.mirror(per_row, **changes)).findings)

    def decaying(self, per_row: float, **changes):
        """The prototype's waveguide, whose mode decays by so many dB per row."""
        guides = reference_guides()
        (strip,) = guides.strips
        return replace(guides, strips=(replace(strip, decay=per_row, **changes),))

    @pytest.mark.parametrize(
        ("per_row", "verdict"), [(6.6, "no total"), (6.7, "almost total"), (25.0, "almost total")]
    )
    def test_three_rows_are_judged_by_their_insulation(self, per_row, verdict):
        text = self.findings(per_row)
        assert f"insertion loss {3 * per_row:.1f} dB, {verdict} reflection" in text
        assert f"transmit {100 * 10 ** (-0.3 * per_row):.1f} % of the energy" in text
        assert (
            f"other kinds of waves the insertion loss is {3 * per_row - 10 * np.log10(0.25):.1f} dB" in text
        )

    def test_the_best_frequency_lies_in_the_gap(self):
        layers = reference_layers()
        passed = layers.dataset["transmitted"]
        passed[:] = 0.1
        passed.loc[{"frequency": layers.dataset["frequency"][1], "rows": 3}] = 1e-3
        passed.loc[{"frequency": layers.dataset["frequency"][3], "rows": 3}] = 1e-9  # beyond the gap
        passed.loc[{"frequency": layers.dataset["frequency"][2], "rows": 4}] = (
            1e-9  # of another number of rows
        )
        text = " ".join(mirror.chapter(mirrored(layers=layers)).findings)
        assert "Within the gap the insertion loss of 3 rows is largest at 54.0 kHz: 24 dB." in text
        without = replace(layers, gap=None)
        assert "Within the gap" not in " ".join(mirror.chapter(mirrored(layers=without)).findings)
        few = replace(layers, dataset=layers.dataset.isel(rows=slice(2)))
        text = " ".join(mirror.chapter(mirrored(layers=few)).findings)
        assert "At the carrier, 60 kHz, 2 rows transmit" in text
        assert "Within the gap the insertion loss of 2 rows is largest" in text

    def test_the_mirror_chapter_omits_missing_flexural_waves(self):
        layers = reference_layers()
        for name in ("transmitted", "reflected"):
            layers.dataset[f"carrier_{name}"].loc[{"incident": "A0"}] = np.nan
        chapter = mirror.chapter(mirrored(layers=layers))
        assert len(chapter.findings) == 1
        assert chapter.findings[0].startswith("The waves of the waveguide's mode")
        heads = "incident S0 / dB", "incident SH0 / dB", "S0 alone / dB", "SH0 alone / dB"
        assert chapter.tables[0].head == ("rows", *heads)

    def test_the_angle_of_the_mode_is_that_of_its_two_wavenumbers(self):
        (strip,) = reference_guides().strips
        across, along = np.pi / (strip.mode.width + 2 * strip.fixed_line), np.pi / 8e-3
        assert f"at {np.degrees(np.arctan2(along, across)):.0f}° from the normal" in self.findings()

    def test_tables_follow_the_numbers(self):
        rows, needed, waveguides = mirror.chapter(self.mirror(7.0)).tables
        assert [(row[0], row[1], row[4]) for row in rows.texts] == [
            (str(n), f"{7.0 * n:.1f}", f"{7.0 * n - 10 * np.log10(0.25):.1f}") for n in (1, 2, 3, 4)
        ]
        assert needed.head == ("incident", "20 dB", "40 dB", "60 dB")
        assert needed.rows[0] == ("A0", 3, 6, 9)
        (strip,) = reference_guides().strips
        assert waveguides.texts[0][:5] == ("32.00", "140.0", "20", f"{strip.frequency / 1e3:.3f}", "8.000")
        slow = mirror.chapter(self.mirror(0.5)).tables[1]
        assert slow.rows[0] == ("A0", 40, "more than 60", "more than 60")

    def test_alternative_text_gives_insertion_loss(self):
        picture = mirror.chapter(self.mirror(7.0)).pictures[0]
        assert "Insertion loss of 4 rows at 60 kHz at normal incidence: A0 28" in picture.alternative


class TestTrend:
    @pytest.mark.parametrize("exponent", [1.0, -2.0, 0.37])
    def test_an_exact_power_is_found(self, exponent):
        trend = trend_of(simulated_sweep(exponent=exponent))
        power = trend.power(trend.upper)
        assert power.exponent == pytest.approx(exponent)
        assert power.error < 1e-9
        assert (trend.below, len(trend.value)) == (6, 9)

    def test_the_standard_error_is_that_of_the_textbook(self):
        """The slopes of many noisy samples scatter by the standard error of the fit."""
        random = np.random.default_rng(1)
        value = np.linspace(1, 2, 12)
        fits = [fitted_power(value, value**1.5 * np.exp(0.01 * random.normal(size=12))) for _ in range(800)]
        scatter = np.std([fit.exponent for fit in fits])
        claimed = np.sqrt(np.mean([fit.error**2 for fit in fits]))
        assert claimed == pytest.approx(scatter, rel=0.1)

    def test_a_line_through_equation_3_is_straight(self):
        assert trend_of(simulated_sweep(exponent=1.0)).straightness < 1e-6
        assert trend_of(simulated_sweep(exponent=2.0)).straightness > 1e3

    @pytest.mark.parametrize(
        ("exponent", "words"), [(0.8, "is a straight line"), (3.0, "deviates from a straight line")]
    )
    def test_a_bent_edge_is_not_called_straight(self, exponent, words):
        chapter = sweeps.chapter(results(sweeps=(simulated_sweep(exponent=exponent),)))
        assert words in chapter.findings[1]

    def test_a_sweep_of_two_sizes_is_described_as_a_map_whose_widest_gap_it_names(self):
        lines = simulated_sweep()
        lines["gap_lower"][0, 0] -= 1e3  # 9.4 kHz, the widest for its frequency; at 0.8 it is 14.6 kHz
        second = xr.DataArray(np.full(9, 2e-3), dims="step", attrs={"units": "m", "long_name": "cell.pitch"})
        both = lines.assign(second_value=second)
        both.attrs |= {"second_expression": "cell.pitch", "own_second_value": 2e-3}
        (alone,) = sweeps.chapter(results(sweeps=(lines,))).paragraphs
        assert alone.startswith("Each pair of points")
        chapter = sweeps.chapter(results(sweeps=(both,)))
        assert chapter.paragraphs == (sweeps.OF_MAPS,)
        assert "The widest is at 0.8 and 2 mm: 72.8 to 87.4 kHz" in chapter.findings[0]

    def test_the_gap_is_followed_without_a_break(self):
        sweep = simulated_sweep()
        sweep["gap_lower"][6, 0] = np.nan
        assert len(trend_of(sweep).value) == 6

    def test_a_gap_in_another_slot_is_the_same_gap(self):
        sweep = simulated_sweep()
        for name in ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error", "gap_below"):
            sweep[name][0, [0, 1]] = sweep[name][0, [1, 0]].values
        assert len(trend_of(sweep).value) == 9

    @pytest.mark.parametrize("attrs", [{"own_value": 2.0}, {"own_value": None}])
    def test_no_trend_without_the_own_design(self, attrs):
        assert trend_of(simulated_sweep(**attrs)) is None

    def test_no_trend_from_three_designs_or_from_none_with_a_gap(self):
        assert trend_of(simulated_sweep(steps=3)) is None
        sweep = simulated_sweep()
        sweep["gap_upper"][:] = sweep["gap_lower"]
        assert trend_of(sweep) is None


def test_sweeps_of_several_lengths_and_numbers_of_gaps_are_one_dataset():
    """The reference study has both, and its report ended in a traceback."""
    long = simulated_sweep()
    short = long.isel(step=slice(0, -1), gap_slot=slice(0, 1)).assign_attrs(expression="cell.pitch")
    rows = Sweeps((Sweep(long, {}), Sweep(short, {})))
    assert rows.dataset["gap_lower"].sizes == {"sweep": 2, **long["gap_lower"].sizes}
    assert np.isnan(rows.dataset["value"][1, -1])
    assert rows.to_json()["sweeps"][1]["designs"][-1]["gaps"]
    assert " is at 0.8: " in rows.summary()[0]  # a bare number has no unit


@pytest.mark.parametrize(
    ("carrier", "words", "margin"),
    [
        # edges of 50 and 60 kHz times (value / 0.5)^0.8, with errors of 80 Hz
        (55e3, "inside a gap of 3 of 9 designs; its largest margin is 4.92 kHz, at 0.5.", 4920.0),
        (59.95e3, "inside a gap of 2 of 9 designs; its largest margin is 4.72 kHz, at 0.55.", 4723.8207),
        # a gap that is narrower than its errors
        (20.05e3, "No gap of these designs contains the carrier, 20.05 kHz.", None),
        (np.nan, "", None),
    ],
)
def test_a_sweep_names_the_design_with_the_largest_margin_around_the_carrier(carrier, words, margin):
    dataset = simulated_sweep(carrier_hz=carrier)
    if np.isnan(carrier):
        del dataset.attrs["carrier_hz"]
    sweep = Sweep(dataset, {})
    _, *about_carrier = Sweeps((sweep,)).summary()
    assert words in about_carrier[0] if words else not about_carrier
    margins = [design["carrier_margin_hz"] for design in sweep.facts()["designs"]]
    assert max(filter(None, margins), default=None) == (margin and pytest.approx(margin))
    table = sweep.table()
    if words:
        assert [row[-1] for row in table.rows] == margins
    assert (table.columns[-1].name == "margin") == bool(words)


@pytest.mark.usefixtures("empty_pictures", "undrawn_mirror")
class TestFirstScreen:
    def test_it_has_the_gap_and_the_picture_of_the_bands_where_there_is_no_plate(self):
        content = page(mirrored(sweeps=()))
        first = content[content.index('<div class="first">') : content.index("<nav")]
        assert [
            value.replace("\N{NO-BREAK SPACE}", " ")
            for value in re.findall(r'number-of"><strong>(.*?)</strong>', first)
        ] == [gap_text(gaps_of(reference_bands())[0])]
        assert "Band diagram" in first
        assert re.findall(r'<li class="(\w+)">(.*?)<small>', first) == [
            ("green", "● the drive lies in a band gap: met ")
        ]

    @pytest.mark.parametrize(
        ("carrier", "name", "note", "light"),
        [
            (56e3, "complete band gap around the carrier", "margin of the carrier, 56 kHz: 3.5 kHz", "green"),
            (
                40e3,
                "nearest complete band gap",
                "the carrier, 40 kHz, lies in no complete gap, 13 kHz",
                "red",
            ),
            (None, "complete band gap", "of its centre", None),
        ],
    )
    def test_the_gap_is_that_of_the_carrier(self, carrier, name, note, light):
        """A second gap, twice as wide and far above the carrier, is not shown instead."""
        study, bands = study_with(carrier=carrier), reference_bands().isel(gap=[0, 0])
        bands["gap_lower"][1], bands["gap_upper"][1] = 100e3, 120e3
        screen = first_screen(results(study=study, bands=bands), [])
        near, wide = (gap_text(gap) for gap in gaps_of(bands))
        assert screen.numbers[0].value == (wide if carrier is None else near)
        assert screen.numbers[0].name == name
        assert note in screen.numbers[0].note
        assert [colour for colour, _, _ in screen.requirements] == ([light] if light else [])

    def test_a_missing_gap_is_reported(self):
        bands = reference_bands()
        bands["gap_complete"][:] = 0
        assert "<strong>none</strong> complete band gap" in page(results(bands=bands, sweeps=()))

    def test_a_folded_chapter_shows_at_most_three_findings_and_no_finding_twice(self, whole):
        for section in re.findall(r"<section.*?</section>", whole, re.S):
            seen, folded = section.split("<details>")
            assert seen.count("<li>") <= 3
            assert "<figure" not in seen
            assert "<table" not in seen
            findings = re.findall(r"<li>(.*?)</li>", section)
            assert len(set(findings)) == len(findings)
            more = re.search(r"(\d+) more finding", folded)
            assert (int(more[1]) if more else 0) == folded.count("<li>")

    def test_no_picture_needs_more_than_a_telephone(self, whole):
        widths = [float(width) for width in re.findall(r'<svg [^>]*?width="([\d.]+)pt"', svgs(whole))]
        assert len(widths) >= 9
        assert max(widths) <= 85 / 25.4 * 72 + 1


def svgs(content: str) -> str:
    pictures = re.findall(r"data:image/svg\+xml;base64,([^\"]*)", content)
    return "".join(base64.b64decode(picture).decode() for picture in pictures)
