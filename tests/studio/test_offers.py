"""The page has no list of its own: keys, analyses and results come from the declarations."""

import re
import shlex
from dataclasses import dataclass, replace
from pathlib import Path

from haptonic import analyses
from haptonic.analyses.options import option
from haptonic.fields.keys import table
from haptonic.studio import offers as module
from haptonic.studio.form import form
from haptonic.studio.offers import as_command, as_python, chosen, offered, offers
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


def test_offered_analyses_need_a_study_only():
    names = [offer["name"] for offer in offers()]
    assert {"plan", "bands", "layers", "plate", "design"} <= set(names)
    assert not {"compare", "scan", "friction", "verdict", "export", "reproduce"} & set(names)
    interactive = [offer["name"] for offer in offers() if offer["interactive"]]
    assert interactive == ["bands", "layers", "ribbon", "plate", "feel"]
    (bands,) = [offer for offer in offers() if offer["name"] == "bands"]
    assert [each["name"] for each in bands["options"]] == ["surface", "modes_at"]


def test_a_new_option_appears_by_itself():
    @dataclass(frozen=True)
    class More:
        depth: int = option(3, "Depth.")
        file: Path | None = option(None, "A file.")

    analysis = replace(offered("plan"), options=More)
    assert [each["name"] for each in module._options(analysis)] == ["depth"]


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
