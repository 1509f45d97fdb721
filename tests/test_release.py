"""What a release promises: dependencies that are used and declared, one version, commands that exist."""

from __future__ import annotations

import ast
import importlib.util
import json
import re
import sys
import tomllib
from functools import cache
from importlib.metadata import packages_distributions
from itertools import chain
from pathlib import Path

import pytest
import yaml

import haptonic
from five_parts import refusing
from haptonic.cli.doctor import PARTS
from haptonic.errors import ResourceError
from haptonic.jobs import check_workers
from sources import tree_of

ROOT = Path(__file__).parents[1]
SOURCE = Path(haptonic.__file__).parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]
BY_NAME = {"h5netcdf", "websockets"}  # xarray's engine and uvicorn's protocol, chosen by their names
AS_CONDA = {"matplotlib-base": "matplotlib"}  # without the windows that nobody opens


def bare(requirement: str) -> str:
    """The package's name in a requirement, as it is compared."""
    return re.split(r"[<>=;\[ ]", requirement)[0].lower().replace("_", "-")


@cache
def imported() -> set[str]:
    """Packages of others that the sources import, wherever in a module, as they are called in a registry."""
    trees = [tree_of(file) for file in SOURCE.rglob("*.py")]
    nodes = [node for tree in trees for node in ast.walk(tree)]
    modules = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    modules |= {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}
    texts = (node.value for node in nodes if isinstance(node, ast.Constant))
    strings = {text.partition(".")[0] for text in texts if isinstance(text, str)}
    first = {name.partition(".")[0] for name in modules} | ({"nptdms", "sdypy", "pyuff"} & strings)
    published = packages_distributions()
    return {
        bare(owner)
        for name in first - set(sys.stdlib_module_names) - {"haptonic"}
        for owner in published.get(name, [name])
    }


def test_every_dependency_is_imported():
    declared = {bare(requirement) for requirement in PROJECT["dependencies"]}
    assert declared - imported() == BY_NAME


def test_every_import_is_declared():
    declared = {bare(requirement) for requirement in [*PROJECT["dependencies"], *chain(*EXTRAS.values())]}
    brought = {  # by a package that is declared
        "dask": "distributed", "netgen-occt": "netgen-mesher", "netgen": "netgen-mesher",
        "pydantic-core": "pydantic", "annotated-types": "pydantic", "typing-extensions": "pydantic",
        "sksparse": "scikit-sparse", "sdypy-sep005": "sdypy-ema", "sdypy": "sdypy-ema", "click": "typer",
    }  # fmt: skip
    assert {brought.get(name, name) for name in imported()} <= declared


def test_doctor_knows_every_extra_of_a_user():
    of_developers = {"dist", "docs", "ngsolve", "test"}
    assert set(PARTS) == set(EXTRAS) - of_developers
    assert all(bare(part.package) in map(bare, EXTRAS[extra]) for extra, part in PARTS.items())
    table = re.findall(r"^\| `(\w+)` \|.*\| (.+) \|$", (ROOT / "docs/install.md").read_text("utf-8"), re.M)
    assert dict(table) == {extra: part.purpose for extra, part in PARTS.items()}


def test_there_is_one_version():
    assert "version" in PROJECT["dynamic"]
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))["version"]
    packed = recipe()["context"]["version"]
    newest = re.search(r"^## \[(\d\S+)\]", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.M)
    deposited = json.loads((ROOT / ".zenodo.json").read_text("utf-8"))["version"]
    described = json.loads((ROOT / "codemeta.json").read_text("utf-8"))["version"]
    assert newest is not None
    assert {cited, packed, deposited, described, newest[1]} == {haptonic.__version__}


def test_catalogues_of_software_agree_with_the_project():
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
    deposited = json.loads((ROOT / ".zenodo.json").read_text("utf-8"))
    described = json.loads((ROOT / "codemeta.json").read_text("utf-8"))
    assert deposited["title"] == described["headline"] == cited["title"]
    assert described["description"] == cited["abstract"].strip()
    assert described["keywords"] == deposited["keywords"] == PROJECT["keywords"]
    assert set(cited["keywords"]) <= set(PROJECT["keywords"])
    assert described["softwareRequirements"] == PROJECT["dependencies"]
    assert described["runtimePlatform"] == f"Python {PROJECT['requires-python']}"
    assert described["license"].rpartition("/")[2] == deposited["license"] == cited["license"]
    assert cited["license"] == PROJECT["license"]
    authors = [author["name"] for author in cited["authors"]]
    assert [author["name"] for author in described["author"]] == authors
    assert [author["name"] for author in deposited["creators"]] == authors


def recipe() -> dict[str, dict]:
    return yaml.safe_load((ROOT / "release" / "recipe.yaml").read_text("utf-8"))


def test_the_recipe_needs_what_the_project_needs():
    needed = {requirement.split(";")[0] for requirement in PROJECT["dependencies"]}
    run = {requirement.replace(" ", "") for requirement in recipe()["requirements"]["run"]} - {"python>=3.11"}
    for conda, name in AS_CONDA.items():
        run = {requirement.replace(conda, name) for requirement in run}
    assert run == needed


@pytest.mark.parametrize("file", sorted((ROOT / ".github" / "workflows").glob("*.yml")), ids=lambda f: f.name)
def test_the_forge_runs_what_a_desk_runs(file):
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text("utf-8"), re.M))
    jobs = yaml.safe_load(file.read_text("utf-8"))["jobs"].values()
    commands = [step["run"].split() for job in jobs for step in job["steps"] if "run" in step]
    assert commands
    for program, *words in commands:
        assert program == "make"
        assert set(words) <= targets


def test_a_scheduler_without_its_extra_is_refused(monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        "importlib.util.find_spec", lambda name: None if name == "distributed" else find_spec(name)
    )
    with refusing(ResourceError, "not-installed", "scheduler", "haptonic[scheduler]"):
        check_workers(0, "tcp://127.0.0.1:8786")
    check_workers(2, None)
