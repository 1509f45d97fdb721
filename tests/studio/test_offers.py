"""The page has no list of its own: keys, analyses and results come from the declarations."""

import re
import shlex
from dataclasses import dataclass, fields, replace
from pathlib import Path

from haptonic import analyses
from haptonic.analyses.options import option, option_of
from haptonic.fields.keys import table
from haptonic.studio import offers as module
from haptonic.studio.form import form
from haptonic.studio.offers import as_command, as_python, chosen, offered, offers, with_paths
from haptonic.study import Study

WEB = Path(__file__).parents[2] / "web/src"


def test_the_form_has_every_declared_key():
    described = {key["path"]: key for key in form()}
    declared = table(Study)
    assert list(described) == list(declared)
    assert all(described[path]["title"] == key.title for path, key in declared.items())
    assert all(described[path]["help"] for path in declared)


def test_the_program_of_the_page_names_no_key_and_no_analysis():
    text = "\n".join(
        path.read_text("utf-8") for path in [WEB / "studio.tsx", *(WEB / "studio").glob("*.ts*")]
    )
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\bimport [^;]*;", "", text, flags=re.DOTALL)
    quoted = set(re.findall(r"""["'`]([a-z_]+)["'`]""", text))
    # words of the page that are also keys
    shared = {"text", "name", "number", "table", "tables", "true", "status", "change", "section", "y"}
    shared |= {"file", "x"}
    keys = {part for path in table(Study) for part in path.replace("[]", "").split(".")}
    assert quoted & (keys | set(analyses.NAMES)) - shared == set()


def test_offered_analyses_need_only_what_a_page_can_give():
    names = [offer["name"] for offer in offers()]
    assert {"plan", "bands", "layers", "plate", "design", "scan", "friction", "compare"} <= set(names)
    assert not {"export", "reproduce", "simulate scan", "simulate friction"} & set(names)
    interactive = [offer["name"] for offer in offers() if offer["interactive"]]
    assert interactive == ["bands", "layers", "waveguide", "ribbon", "plate", "feel", "scan", "friction"]
    (bands,) = [offer for offer in offers() if offer["name"] == "bands"]
    assert [each["name"] for each in bands["options"]] == ["surface", "modes_at"]


def test_a_new_option_appears_by_itself():
    @dataclass(frozen=True)
    class More:
        depth: int = option(3, "Depth.")
        file: Path | None = option(None, "A file.")

    analysis = replace(offered("plan"), options=More)
    described = {each["name"]: each["form"] for each in module._options(analysis)}
    assert described == {"depth": "int", "file": "path"}


def test_an_option_that_opens_a_file_is_a_name_in_the_folder():
    """A text of the page must not reach a reader of files."""
    for offer in offers():
        analysis = offered(offer["name"])
        forms = {each["name"]: each["form"] for each in offer["options"]}
        for field in fields(analysis.options):
            choice = option_of(field)
            if choice is not None and (choice.metavar in ("FILE", "RESPONSE", "PATH", "MODEL")):
                assert forms.get(field.name, "path") == "path"


def test_paths_of_options_are_those_of_the_folder(tmp_path):
    scan = offered("scan")
    placed = with_paths(scan, {"path": "a.uff", "unit": "mm/s/V"}, lambda name: tmp_path / str(name))
    assert placed == {"path": tmp_path / "a.uff", "unit": "mm/s/V"}


def test_lines_that_repeat_an_analysis_of_files():
    scan, friction = offered("scan"), offered("friction")
    options = {"path": "my scan.uff", "length_unit": "mm"}
    assert as_command(scan, "a.toml", options) == "haptonic scan 'my scan.uff' a.toml --length-unit mm"
    assert as_command(scan, "a.toml", options, alone=True) == "haptonic scan 'my scan.uff' --length-unit mm"
    line = as_python(scan, "a.toml", {"path": "my scan.uff"})
    assert line == 'haptonic.load("a.toml").scan(path="my scan.uff")'
    assert as_command(friction, "a.toml", {"path": "t"}) == "haptonic friction t --study a.toml"
    assert '{"path": "t", "study": "a.toml"}' in as_python(friction, "a.toml", {"path": "t"})


def test_the_line_of_python_without_a_study_runs(monkeypatch):
    monkeypatch.chdir(Path(__file__).parents[1] / "data/cases")
    line = as_python(offered("friction"), "", {"path": "friction-names-f-x"}, alone=True)
    statement, expression = line.split("; ")
    space: dict = {}
    exec(statement, space)
    assert eval(expression, space).summary()


def test_the_command_and_the_line_of_python_repeat_an_analysis():
    bands = offered("bands")
    options = chosen(bands, {"surface": True, "modes_at": "0.3 X-M"})
    command = as_command(bands, "my cell.toml", options)
    assert shlex.split(command) == [
        "haptonic",
        "bands",
        "my cell.toml",
        "--surface",
        "--modes-at",
        "0.3 X-M",
        "--html",
    ]
    line = as_python(bands, "my cell.toml", options)
    assert line == 'haptonic.load("my cell.toml").bands(surface=True, modes_at="0.3 X-M", html=True)'
    assert as_command(offered("plan"), "a.toml", {}) == "haptonic plan a.toml"
