"""The first hour: a template and its first answer, keys and materials at 80 columns, a schema for editors."""

from __future__ import annotations

import copy
import io
import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, strategies as st

from daily import daily
from five_parts import assert_explained, assert_five_parts
from haptonic import analyses
from haptonic.cli import commands
from haptonic.cli.commands import keys, materials, new
from haptonic.cli.console import Voice
from haptonic.cli.listing import entry
from haptonic.errors import StudyError
from haptonic.fields import remade, table
from haptonic.fields.json_schema import json_schema
from haptonic.fields.keys import pattern_of
from haptonic.materials import library
from haptonic.study import Study, Template, case_templates, load, loads, templates
from haptonic.study.template import COMMAND

TEMPLATES = templates()
STUDIES = sorted((Path(__file__).parents[2] / "studies").glob("*.toml"))
KEYS = table(Study)
EVERY_KEY = (Path(__file__).parents[1] / "data" / "every_key.toml").read_text("utf-8")
SCHEMA = json_schema(Study, "haptonic study")


def squeezed(text: str) -> str:
    return "".join(text.split())


def coarsen(path: Path) -> None:
    """Write a study anew with fewer wavevectors and a coarse mesh."""
    study = load(path)
    coarse = remade(study.bands_settings, points=9, accuracy=2e-2)
    coarse = remade(coarse, mesh=remade(coarse.mesh, order=2, foot_rings=0))
    path.write_text(remade(study, bands_settings=coarse).to_toml(), "utf-8")


class TestTemplates:
    def test_no_case_of_verify_has_the_name_of_a_template(self):
        """`haptonic new NAME` writes either of them."""
        assert set(TEMPLATES).isdisjoint(case_templates())

    @pytest.mark.parametrize("name", daily(TEMPLATES, "coated-inclusion", "my-scan", "my-trials"))
    @pytest.mark.usefixtures("empty_pictures")
    def test_its_first_command_answers(self, inside, tmp_path, name):
        """As written by `haptonic new`, then on a coarse mesh."""
        path = tmp_path / "mine.toml"
        assert inside("new", name, path).code == 0
        first = Template(path.read_text("utf-8")).commands[0]
        assert first.split()[2] == str(path)
        coarsen(path)
        ran = inside(*first.split()[1:], "--out", tmp_path / "out")
        assert ran.code == 0, ran.err
        assert any((tmp_path / "out").iterdir())

    @pytest.mark.parametrize("name", TEMPLATES)
    def test_it_teaches(self, name):
        text = TEMPLATES[name]
        assert text.about.endswith((".", "?"))
        assert all(line.isascii() and len(line) <= 120 for line in text.splitlines())
        for command in text.commands:
            words = command.split()[1:]
            assert words[0] in commands.NAMES or any(
                " ".join(words).startswith(analysis) for analysis in analyses.NAMES
            )
            assert words[0] in commands.NAMES or "FILE" in words
        assert text.count("#") >= 5

    def test_the_studies_of_the_repository_are_templates(self):
        for path in STUDIES:
            assert path.read_text("utf-8") == TEMPLATES[path.stem.replace("_", "-")]

    @given(st.sampled_from(sorted(TEMPLATES)), st.data())
    def test_a_slip_names_the_nearest(self, name, data):
        at = data.draw(st.integers(0, len(name) - 1))
        slip = name[:at] + name[at + 1 :]
        with pytest.raises(StudyError) as refused:
            new.resolved(slip, "my.toml", TEMPLATES)
        assert_explained(refused.value, slip, code="unknown", argument="TEMPLATE")
        assert refused.value.next_step == f"haptonic new {name} my.toml"

    @pytest.mark.parametrize(
        "given",
        [
            ("touchpad",),
            ("my.toml", "touchpad"),
            ("touchpad", ""),
            ("touchpad", "."),
            ("my",),
            ("nothing like it", "my.toml"),
        ],
    )
    def test_what_cannot_be_written(self, inside, tmp_path, monkeypatch, given):
        monkeypatch.chdir(tmp_path)
        assert_five_parts(inside("new", *given))
        assert not any(tmp_path.iterdir())

    def test_a_file_in_the_way_stays(self, inside, tmp_path):
        mine = tmp_path / "my.toml"
        mine.write_text("mine")
        assert_five_parts(inside("new", mine), "my.toml", "--overwrite", code="repeated", argument="FILE")
        assert mine.read_text() == "mine"
        assert inside("new", mine, "--overwrite").code == 0
        assert load(mine).title == "My cell"

    def test_paths_with_blanks_are_put_in_quotes(self, inside, tmp_path):
        path = tmp_path / "sub folder" / "Größe 7.toml"
        answer = inside("new", "Two Carriers", path, "--json").json
        output = inside("new", "Two Carriers", path, "--overwrite").out
        assert f'\n  haptonic bands "{path}"' in output  # not in the middle of a line that a terminal breaks
        assert answer["file"] == str(path)
        assert answer["next"][0] == f'haptonic bands "{path}"'
        assert load(path).carrier == 58e3

    def test_new_without_arguments_lists_templates(self, inside):
        output = inside("new").out
        for name, text in TEMPLATES.items():
            assert name in output
            assert squeezed(text.about) in squeezed(output)


def printed(width: int, head: str, lines: dict[str, str]) -> list[str]:
    voice = Voice(machine=False)
    voice.out.file, voice.out.width = io.StringIO(), width
    entry(voice, head, lines)
    return voice.out.file.getvalue().splitlines()


@pytest.mark.parametrize("file", ["a.toml", "a longer name.toml"])
def test_explanations_of_template_commands_are_aligned(file):
    for text in templates().values():
        lines = [line for line in text.adapted(Path(file)).heading if COMMAND.match(line)]
        assert len({line.rindex("   ") for line in lines}) == 1, lines


def test_the_trials_of_the_template_can_be_tried(inside, tmp_path):
    """Simulated records are read by the sensor of the study that they were made for."""
    study = tmp_path / "mine.toml"
    study.write_text(TEMPLATES["my-trials"].replace("blocks = 4", "blocks = 2"), "utf-8")
    simulated = inside("simulate", "friction", study, "--participants", 2, "--out", tmp_path / "trials")
    assert simulated.code == 0, simulated.err
    answer = inside("friction", tmp_path / "trials", "--json").json
    assert answer.get("error") is None


class TestKeys:
    def test_all_that_is_known_is_shown_at_80_columns(self):
        printed_badly = []
        for path, key in KEYS.items():
            texts = keys.lines(key)
            lines = printed(80, path, texts)
            # a continued line is indented below its beginning
            fits = max(map(len, lines)) <= 80 and all(line.startswith("  ") for line in lines[1:])
            whole = all(squeezed(text) in squeezed("".join(lines)) for text in texts.values())
            if not (fits and whole):
                printed_badly.append(path)
        assert printed_badly == []

    def test_allowed_words_are_listed(self, inside):
        output = squeezed(inside("keys", "cell.lattice").out)
        assert all(word in output for word in KEYS["cell.lattice"].choices)
        for path in ("material", "plate.actuator[].bond.material"):
            assert all(name in " ".join(keys.lines(KEYS[path]).values()) for name in library())

    def test_an_example_is_a_line_of_a_study(self):
        examples = {path: line for path, key in KEYS.items() if (line := keys.example(key))}
        assert len(examples) > 250
        names = {path: list(tomllib.loads(line)) for path, line in examples.items()}
        assert names == {path: [path.rpartition(".")[2]] for path in examples}
        assert [path for path, line in examples.items() if "..." in line] == []

    def test_a_pattern_finds_paths_and_help(self, inside):
        paths = {key["path"] for key in inside("keys", "FILLET", "--json").json["keys"]}
        assert "cell.pillar.fillet" in paths
        assert "cell.pillar.diameter" in paths  # whose help speaks of it
        assert "carrier" not in paths
        every = inside("keys", "--json").json["keys"]
        assert [key["path"] for key in every] == list(KEYS)
        assert all(key["allowed"] for key in every)

    @pytest.mark.parametrize(
        ("pattern", "named"),
        [("plate.patch", "plate.actuator"), ("plate.actuator[2].bond", "plate.actuator[].bond")],
    )
    def test_a_table_is_found_by_what_its_help_calls_it_and_by_its_number(self, inside, pattern, named):
        paths = [key["path"] for key in inside("keys", pattern, "--json").json["keys"]]
        assert paths == [path for path in KEYS if path.startswith(named)]
        lines = inside("keys", pattern).out.splitlines()
        assert sorted(line.split()[0] for line in lines if line.startswith(named)) == sorted(paths)

    def test_of_many_keys_those_of_inner_tables_are_listed_by_name(self, inside):
        lines = inside("keys", "pillar").out.splitlines()
        assert "cell.pillar.diameter" in lines  # with its help below
        inner = [line for line in lines if line.startswith("cell.pillar.material.")]
        assert sum(path.startswith("cell.pillar.material.") for path in KEYS) == len(inner)
        assert all(len(line.split()) > 1 for line in inner)
        assert len(lines) < 200

    @pytest.mark.parametrize("path", [path for path in KEYS if path.endswith("[].parameter")])
    def test_keys_that_a_parameter_may_name_are_listed(self, path):
        names = keys.lines(KEYS[path])["names"].split(", ")
        assert "material.youngs_modulus" in names
        assert all(name in KEYS or pattern_of(name) in KEYS for name in names)

    def test_one_that_finds_nothing_names_the_nearest(self, inside):
        assert_five_parts(
            inside("keys", "thicknes s"), "haptonic keys thickness", code="unknown", argument="pattern"
        )


class TestMaterials:
    def test_the_list_has_every_name_and_number(self, inside):
        output = inside("materials").out
        for name, solid in library().items():
            row = next(line for line in output.splitlines() if f" {name} " in line)
            assert f"{solid.density:.4g}" in row

    @pytest.mark.parametrize("name", library())
    def test_all_of_one_at_80_columns(self, name):
        lines = printed(80, name, materials.lines(library()[name]))
        assert max(map(len, lines)) <= 80
        assert squeezed(library()[name].source) in squeezed("".join(lines))
        assert (
            loads(f'material = "{name}"\n[cell]\npitch = "7 mm"\nthickness = "1 mm"\n').cell.material.name
            == name
        )

    def test_machines_get_the_constants(self, inside):
        solids = inside("materials", "steel", "--json").json["materials"]
        assert solids["steel"]["youngs_modulus"] == 210e9

    def test_an_unknown_one(self, inside):
        assert_five_parts(
            inside("materials", "steal"), "haptonic materials steel", code="unknown", argument="pattern"
        )


@pytest.fixture(scope="session")
def validator():
    draft = pytest.importorskip("jsonschema").Draft7Validator
    draft.check_schema(SCHEMA)
    return draft(SCHEMA)


class TestSchema:
    def test_it_is_what_the_command_prints(self, inside):
        assert json.loads(inside("schema").out) == SCHEMA

    @pytest.mark.parametrize("name", TEMPLATES)
    def test_every_template_keeps_it(self, validator, name):
        assert list(validator.iter_errors(tomllib.loads(TEMPLATES[name]))) == []

    def test_so_does_a_study_with_every_key(self, validator):
        assert list(validator.iter_errors(tomllib.loads(EVERY_KEY))) == []

    def test_a_zero_needs_no_unit(self, validator):
        data = tomllib.loads(TEMPLATES["bare-cell"])
        for zero in (0, 0.0, "0", "0.0", "0 mm"):
            data["cell"]["pillar"]["fillet"] = zero
            assert validator.is_valid(data), zero
        data["cell"]["pillar"]["fillet"] = 1
        assert not validator.is_valid(data)

    @given(st.data())
    def test_a_misspelt_key_is_refused_in_every_table(self, validator, data):
        study = tomllib.loads(EVERY_KEY)
        tables = [(path, where) for path, where in tables_of(study)]
        path, where = data.draw(st.sampled_from(tables))
        name = data.draw(st.sampled_from(sorted(where)))
        where[f"{name}x"] = where.pop(name)
        assert not validator.is_valid(study), (path, name)

    @pytest.mark.parametrize(
        ("path", "wrong"),
        [
            ("cell.lattice", "squar"),
            ("cell.pitch", 7),
            ("cell.pitch", "mm"),
            ("bands.count", 0),
            ("bands.count", "ten"),
            ("bands.accuracy", 2),
            ("title", ""),
            ("plate.map", 3),
            ("carrier", True),
            ("material", "unobtainium"),
        ],
    )
    def test_a_wrong_value_is_refused_by_both(self, validator, path, wrong):
        data = copy.deepcopy(tomllib.loads(TEMPLATES["glass-keypad"]))
        *tables, name = path.split(".")
        inner = data
        for section in tables:
            inner = inner[section]
        inner[name] = wrong
        assert not validator.is_valid(data)
        with pytest.raises(StudyError):
            loads(toml(data))


def toml(data: dict[str, Any]) -> str:
    """As TOML with every table in one line."""

    def value(item: Any) -> str:
        if isinstance(item, dict):
            return (
                "{" + ", ".join(f"{json.dumps(name)} = {value(inner)}" for name, inner in item.items()) + "}"
            )
        return f"[{', '.join(map(value, item))}]" if isinstance(item, list) else json.dumps(item)

    return "\n".join(f"{name} = {value(item)}" for name, item in data.items())


def tables_of(data: dict[str, Any], path: str = "") -> list[tuple[str, dict[str, Any]]]:
    """Tables whose keys are declared, and their paths."""
    tables = [(path, data)]
    for name, value in data.items():
        at = re.sub(r"^\.", "", f"{path}.{name}")
        if KEYS[re.sub(r"\[\d+\]", "[]", at)].kind == "entries":
            continue
        if isinstance(value, dict):
            tables += tables_of(value, at)
        elif isinstance(value, list) and isinstance(value[0], dict):
            tables += [
                each for k, inner in enumerate(value, start=1) for each in tables_of(inner, f"{at}[{k}]")
            ]
    return tables


def python(code: str, **more: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, **more}, check=False
    )
    return done.stdout


def test_a_help_loads_nothing_that_computes():
    output = python(
        "import sys\nfrom haptonic.cli.app import app\n"
        "try: app(['--help'])\nexcept SystemExit: pass\nprint('loaded', sorted(sys.modules))"
    )
    listed, loaded = output.split("loaded")
    assert "bands" in listed
    assert not {"numpy", "scipy", "xarray", "matplotlib", "pandas"} & set(re.findall(r"'(\w+)'", loaded))


@pytest.mark.parametrize(
    ("words", "at", "offered"),
    [
        ("haptonic ", 1, {"bands", "new", "simulate"}),
        ("haptonic simulate ", 2, {"friction", "scan"}),
        ("haptonic new t", 2, {"touchpad", "two-carriers", "triangular-mirror"}),
        ("haptonic bands --sur", 2, {"--surface"}),
    ],
)
def test_a_shell_completes(words, at, offered):
    output = python(
        "import sys; sys.argv = ['haptonic']; from haptonic.cli import main; main()",
        _HAPTONIC_COMPLETE="complete_bash",
        COMP_WORDS=words,
        COMP_CWORD=str(at),
    )
    assert offered <= set(output.split())
    assert "Usage" not in output
    assert not {"keys", "mirror", "--json"} & set(output.split()) or words == "haptonic "


@pytest.mark.usefixtures("empty_pictures")
def test_the_commands_of_the_page_on_a_first_gap_run_in_their_order(inside, tmp_path, monkeypatch):
    """Every line that it prints, in its order; what a shell does with the output is left to it."""
    page = (Path(__file__).parents[2] / "docs" / "start.md").read_text("utf-8")
    monkeypatch.chdir(tmp_path)
    lines = [
        line.split("#")[0].split(">")[0]
        for text in re.findall(r"```sh\n(.*?)```", page, re.DOTALL)
        for line in text.splitlines()
        if "--install-completion" not in line
    ]
    assert len(lines) >= 7
    for line in lines:
        words = line.split()[1:]
        assert inside(*words).code == 0, line
        if words[0] == "new" and len(words) > 1:
            coarsen(Path(words[-1]))
    assert all(f"`{name}`" in page for name in TEMPLATES)


def test_text_for_another_program_is_there_at_once(monkeypatch):
    # in a pipe, standard output otherwise waits for thousands of letters: the link of the studio never came
    pipe = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(pipe, "utf-8"))
    Voice(False).print("link\n")
    assert pipe.getvalue() == b"link\n"
