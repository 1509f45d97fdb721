"""What is reported before anything is computed: sizes, a map, and the cost of each command."""

from __future__ import annotations

import pytest

from five_parts import assert_five_parts
from haptonic.analyses import NAMES, named
from haptonic.analyses.costs import meshes
from haptonic.analyses.needs import meshes_of
from haptonic.results.cost import Cost
from haptonic.study import load, loads, templates

TEMPLATES = templates()
STUDIES = {name: loads(text) for name, text in TEMPLATES.items()}
PLANNED = {
    name: templates_of[-1]
    for name in NAMES
    if (templates_of := [each for each, study in STUDIES.items() if named(name).is_planned(study)])
}  # commands that a plan lists, with the largest template that each can be run with


def cost_of(command, text):
    """Estimated cost of a command for a study, without options."""
    analysis = named(command)
    return analysis.cost(loads(text), analysis.options())


@pytest.fixture
def nothing_computes(monkeypatch):
    for place in ("superelement.Tiling.condensed", "plate.body.reduction.condense", "bloch.rows.condense"):
        monkeypatch.setattr(f"haptonic.{place}", lambda *_, **__: pytest.fail("computed"))


@pytest.fixture
def file(tmp_path):
    def write(name):
        path = tmp_path / "mine.toml"
        path.write_text(TEMPLATES[name], "utf-8")
        return path

    return write


@pytest.mark.usefixtures("nothing_computes")
class TestPlan:
    @pytest.mark.parametrize("name", TEMPLATES)
    def test_it_shows_sizes_and_costs(self, inside, file, tmp_path, name):
        study = STUDIES[name]
        ran = inside("plan", file(name), "--out", tmp_path / "out")
        assert ran.code == 0, ran.err
        assert f"{1e3 * study.cell.lattice.pitch:.4g}" in ran.out
        for command in PLANNED:
            assert (f"haptonic {command} " in ran.out) == named(command).is_planned(study), command
        drawn = {path.name for path in (tmp_path / "out").glob("*")}
        assert ("files:" in ran.out) == bool(drawn)
        assert drawn == ({"plan.svg", "plan.png"} if study.plate_settings else set())

    @pytest.mark.parametrize("name", TEMPLATES)
    def test_what_it_forecasts_can_be_asked_for(self, name):
        study = STUDIES[name]
        for analysis in map(named, PLANNED):
            if analysis.is_planned(study):
                analysis.check(study, analysis.chosen({}))

    @pytest.mark.parametrize("name", TEMPLATES)
    def test_a_report_has_a_waveguide_wherever_there_are_pillars(self, name):
        study = STUDIES[name]
        if study.carrier is not None and study.cell.has_features:
            assert named("waveguide").reported(study) is not None, "whatever the lattice"

    def test_a_plan_lists_regions_and_drives_of_a_plate(self, inside, file, tmp_path):
        answer = inside("plan", file("glass-keypad"), "--json").json
        assert answer["data"]["area_m_2"] == pytest.approx(
            dict.fromkeys(("key 1", "key 2", "key 3", "key 4"), 4e-4)
        )
        output = inside("plan", file("glass-keypad"), "--out", tmp_path / "out").out
        assert "132 pillars, 4 regions of plain plate and 1 drive" in " ".join(output.split())

    @pytest.mark.parametrize("command", PLANNED)
    def test_a_dry_run_only_prints_the_cost(self, inside, file, tmp_path, monkeypatch, command):
        monkeypatch.chdir(tmp_path)
        path = file(PLANNED[command])
        ran = inside(command, path, "--dry-run")
        assert ran.code == 0, ran.err
        cost = cost_of(command, path.read_text("utf-8"))
        assert cost.sentence in ran.out.replace("\n", " ")
        answer = inside(command, path, "--dry-run", "--json").json
        assert (answer["processor_s"], answer["memory_b"]) == (cost.seconds, cost.memory)
        assert [entry.name for entry in tmp_path.iterdir()] == ["mine.toml"]

    @pytest.mark.parametrize(
        ("command", "name"),
        [
            ("waveguide", "no-carrier"),
            ("design", "touchpad"),
            ("tolerance", "touchpad"),
            ("layers", "no-carrier"),
            ("tolerance", "no-carrier"),
        ],
    )
    def test_what_cannot_end_well_is_refused_before_anything_is_computed(
        self, inside, tmp_path, command, name
    ):
        text = TEMPLATES.get(name) or TEMPLATES["mirror"].replace('carrier = "60 kHz"', "")
        path = tmp_path / "mine.toml"
        path.write_text(text, "utf-8")
        assert_five_parts(inside(command, path, "--out", tmp_path / "out"))
        assert not (tmp_path / "out").exists()

    def test_a_dry_run_refuses_what_the_command_would(self, inside, file):
        assert inside("plate", file("mirror"), "--dry-run").code == 2


@pytest.mark.usefixtures("nothing_computes")
class TestOthers:
    """Commands that a plan does not list, since they are quick or depend on a file."""

    @pytest.mark.parametrize(
        ("command", "template"),
        [
            ("chirp", "touchpad"),
            ("protocol", "my-trials"),
            ("export", "mirror"),
            ("simulate scan", "my-scan"),
            ("simulate friction", "my-trials"),
        ],
    )
    def test_a_dry_run_prints_a_cost_not_in_a_plan(
        self, inside, file, tmp_path, monkeypatch, command, template
    ):
        monkeypatch.chdir(tmp_path)
        ran = inside(*command.split(), file(template), "--dry-run")
        assert ran.code == 0, ran.err
        assert " of processor time and " in ran.out
        assert [entry.name for entry in tmp_path.iterdir()] == ["mine.toml"]

    @pytest.mark.parametrize("command", ["scan", "friction"])
    def test_a_larger_file_costs_more(self, inside, tmp_path, command):
        seconds = []
        for size in (10**6, 10**9):
            with (tmp_path / "file.h5").open("wb") as file:
                file.truncate(size)
            seconds.append(inside(command, tmp_path / "file.h5", "--dry-run", "--json").json["processor_s"])
        assert seconds[0] < seconds[1]

    def test_a_model_that_is_judged_costs_more(self, inside, file, tmp_path):
        (tmp_path / "scan.h5").touch()
        asked = ["scan", tmp_path / "scan.h5", "--dry-run", "--json"]
        alone, judged = (inside(*asked, *more).json for more in ([], ["--against", file("my-scan")]))
        assert alone["processor_s"] < judged["processor_s"]

    def test_a_drawing_costs_its_tolerances(self, inside, file):
        asked = ["export", file("mirror"), "--dry-run", "--json"]
        outline, drawing = (inside(*asked, kind).json for kind in ("--dxf", "--drawing"))
        assert outline["processor_s"] < drawing["processor_s"]

    def test_a_plate_with_more_pillars_costs_more_to_export(self, inside, file):
        text, costs = file("touchpad"), []
        for rows in (20, 60):
            text.write_text(text.read_text("utf-8").replace("rows = 20 ", f"rows = {rows} "), "utf-8")
            costs.append(inside("export", text, "--step", "--dry-run", "--json").json)
        assert costs[0]["processor_s"] < costs[1]["processor_s"]
        assert costs[0]["memory_b"] < costs[1]["memory_b"]

    def test_the_memory_is_that_of_the_mesh_which_is_always_computed(self):
        study = STUDIES["mirror"]
        first, finer = meshes_of(study)
        assert meshes(study).memory == first.memory(study.cell) < finer.memory(study.cell)

    def test_every_analysis_that_computes_has_a_forecast(self):
        assert {name for name in NAMES if named(name).cost} == set(NAMES) - {"plan", "compare"}


@pytest.mark.usefixtures("empty_pictures")
class TestWatching:
    """`plan --watch`, whose looks at the file take turns with what somebody does to it."""

    @pytest.fixture
    def watched(self, inside, file, tmp_path, monkeypatch):
        path, out = file("touchpad"), tmp_path / "out"

        def watch(*deeds):
            """Watch the study while deeds are done to it, one between two looks, the last of them Ctrl-C."""
            left = iter(deeds)

            def sleep(seconds):
                deed = next(left, None)
                if deed is None:
                    raise KeyboardInterrupt
                deed(path)

            monkeypatch.setattr("haptonic.cli.watching.time.sleep", sleep)
            return inside("plan", path, "--watch", "--out", out)

        return watch

    @staticmethod
    def saved(old, new):
        return lambda path: path.write_text(TEMPLATES["touchpad"].replace(old, new), "utf-8")

    def test_watching_prints_a_saved_change_and_ends_with_ctrl_c(self, watched):
        ran = watched(lambda path: None, self.saved('title = "', 'title = "Second '), lambda path: None)
        assert ran.code == 0, ran.err
        assert ran.out.count("180 pillars") == 2
        assert ran.out.count("Second Touchpad") == 1

    def test_a_broken_file_is_reported_and_watched(self, watched):
        broken, gone = lambda path: path.write_text("[cell", "utf-8"), lambda path: path.unlink()
        ran = watched(broken, gone, self.saved('title = "', 'title = "Mended '))
        assert ran.code == 0, ran.err
        assert ran.err.count("likely cause") == 1
        assert "Mended Touchpad" in ran.out

    def test_what_was_there_before_is_not_replaced(self, watched, tmp_path):
        (tmp_path / "out").mkdir()
        (tmp_path / "out" / "plan.png").touch()
        assert_five_parts(watched(), "--overwrite", code="repeated", argument="output file")

    def test_it_has_many_answers_and_so_no_json(self, inside, file):
        assert_five_parts(
            inside("plan", file("touchpad"), "--watch", "--json"),
            code="conflict",
            argument="--watch",
        )


def test_a_long_command_first_prints_its_cost(inside, study, monkeypatch, tmp_path):
    seen = []
    monkeypatch.setattr("haptonic.cli.running.LONG", 0.0)
    monkeypatch.setattr("haptonic.cli.console.Voice.remark", lambda self, text: seen.append(text))
    monkeypatch.setattr(
        "haptonic.analyses.bands.compute_bands", lambda *_, **__: seen.append("computed") or 1 / 0
    )
    with pytest.raises(ZeroDivisionError):
        inside("bands", study(), "--out", tmp_path / "out")
    assert " of processor time and " in seen[0]
    assert seen[1] == "computed"


def test_times_are_classes():
    times = [Cost(seconds).time for seconds in (0.1, 7, 9, 99, 101, 1400, 1600, 7100, 7300, 50_000)]
    classes = ["seconds", "about a minute", "about ten minutes", "about an hour"]
    assert times == [name for name in classes for _ in range(2)] + ["about 2 hours", "about 15 hours"]


def test_estimates_follow_the_sparse_solver_and_the_budget_does_not(study, monkeypatch):
    described = load(study())
    costs, budgeted = [], []
    for name in ("pardiso", "superlu"):
        monkeypatch.setenv("HAPTONIC_SOLVER", name)
        costs.append(meshes(described).seconds)
        budgeted.append([mesh.seconds(described.cell) for mesh in meshes_of(described)])
    assert costs[1] > 1.3 * costs[0]
    assert budgeted[0] == budgeted[1]


def test_costs_add_up():
    both = Cost(2.0, 5e9) + Cost(3.0, 1e9).times(2)
    assert (both.seconds, both.memory) == (8.0, 5e9)


@pytest.mark.parametrize(
    ("command", "old", "new"),
    [
        ("bands", "accuracy = 5e-3", "accuracy = 1e-3"),
        ("bands", "count = 10", "count = 20"),
        ("sweep", "steps = 5", "steps = 50"),
        ("tolerance", "pillars = 100", "samples = 500"),
    ],
)
def test_what_asks_for_more_costs_more(command, old, new):
    text = TEMPLATES["triangular-mirror"]
    assert old in text
    small, large = (cost_of(command, version) for version in (text, text.replace(old, new)))
    assert large.seconds > small.seconds


def test_a_larger_plate_costs_more():
    text = TEMPLATES["my-scan"]
    costs = [cost_of("plate", text.replace("rows = 6", f"rows = {n}")) for n in (6, 24, 96)]
    assert costs[0].seconds < costs[1].seconds < costs[2].seconds
    assert costs[0].memory < costs[1].memory < costs[2].memory


def test_a_finer_mesh_of_a_plate_costs_more():
    """For a small plate order 4 took 11 s, order 5 16 s, order 6 28 s."""
    text = TEMPLATES["my-scan"]
    usual, fine, finer = (
        cost_of("plate", text + mesh).seconds
        for mesh in ("", "\n[mesh]\norder = 5\n", "\n[mesh]\norder = 6\n")
    )
    assert 1.1 < fine / usual < finer / usual < 4


def test_every_patch_costs_its_tiles_and_its_losses():
    text = TEMPLATES["my-scan"]
    table = text[text.index("[[plate.actuator]]") : text.index("\n[scan]")]
    second = table.replace('"A1"', '"A2"').replace('"left"', '"right"')
    single, double = (cost_of("plate", text.replace("\n[scan]", f"\n{more}\n[scan]")).seconds
                for more in ("", second))  # fmt: skip
    assert double > single + 4.0  # four tiles of plain plate with a patch took 4.2 s


def test_a_scan_costs_its_lines():
    text = TEMPLATES["my-scan"]
    short, long = (cost_of("simulate scan", text.replace('"40 ms"', record)).seconds
                   for record in ('"40 ms"', '"400 ms"'))  # fmt: skip
    assert long > short
