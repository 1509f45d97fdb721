"""The texts of ``--help``: every word of them reaches the reader."""

from __future__ import annotations

import typing
from collections.abc import Iterator
from importlib import import_module

import pytest
import typer
from hypothesis import given, strategies as st
from typer.models import ParameterInfo
from typer.testing import CliRunner

from haptonic import analyses
from haptonic.cli import commands
from haptonic.cli.app import app
from haptonic.cli.helping import GROUPS, Worded
from haptonic.cli.running import command
from haptonic.errors import StudyError
from hostile import any_text

WIDE = {"COLUMNS": "1000", "TERMINAL_WIDTH": "1000"}
EVERY = analyses.NAMES | commands.NAMES


def helped(of: typer.Typer, *words: str) -> str:
    """Text of a help, without the frames around it."""
    ran = CliRunner().invoke(of, [*words, "--help"], env=WIDE)
    assert ran.exit_code == 0, ran.output
    return " ".join(ran.output.replace("│", " ").split())


def written(name: str) -> Iterator[str]:
    """What was written for the options of a command."""
    known = name in analyses.NAMES
    function = command(analyses.named(name)) if known else import_module(f"{commands.__name__}.{name}").run
    for hint in typing.get_type_hints(function, include_extras=True).values():
        for mark in getattr(hint, "__metadata__", ()):
            yield (isinstance(mark, ParameterInfo) and mark.help) or ""


@pytest.mark.parametrize("name", EVERY)
def test_no_help_loses_a_word(name, monkeypatch):
    path = name.split()
    seen, listed = helped(app, *path), helped(app, *path[:-1])
    for text in (EVERY[name], *written(name)):
        assert " ".join(text.split()) in seen
    assert EVERY[name] in listed
    assert "<bool>" not in seen + listed  # a flag takes no value
    assert GROUPS.get(path[0], "") in helped(app)
    monkeypatch.setattr("typer.rich_utils.MAX_WIDTH", 80)
    assert "…" not in CliRunner().invoke(app, [*path, "--help"]).output  # a cut word


@pytest.mark.parametrize(
    ("name", "asked"),
    [("bands", "STUDY"), ("friction", "PATH"), ("verdict", "RESPONSE"), ("compare", "FIRST and SECOND")],
)
def test_a_folder_is_named_after_what_the_command_is_asked_of(name, asked):
    assert f"named after {asked} and the command" in helped(app, name)


def test_options_are_listed_below_their_topics():
    panels = CliRunner().invoke(app, ["scan", "--help"]).output.split("╭─ ")
    for topic, flag in (
        ("Options", "--window"), ("Facts that the file may lack", "--unit"),
        ("Position of the plate", "--corners"), ("Comparison with a model", "--model"),
        ("Files and printing", "--out"),
    ):  # fmt: skip
        assert [panel.split(" ─")[0] for panel in panels if f"{flag} " in panel] == [topic]


BRACKETS = (
    "[trials]", "[/x]", "haptonic[cad]", "[bold]", "\\[a]", "[", "]", "\\", "*c* `d`", "[[plate.force]]",
)  # fmt: skip
texts = st.lists(st.sampled_from(BRACKETS) | any_text, min_size=1, max_size=4)


@given(texts, texts)
def test_a_help_text_is_text(command, option):
    """Whatever is written, for a command in a group and for its option."""
    about, what = ("Text " + " ".join(words).replace("│", "") + " end." for words in (command, option))

    option = typer.Option("", "--here", help=what)

    def run(here: str = option) -> None:
        """Nothing."""

    program, group = typer.Typer(cls=Worded), typer.Typer()
    group.command("run", help=about)(run)
    group.command("other")(lambda: None)
    program.add_typer(group, name="group")
    seen = "".join(helped(program, "group", "run").split())
    assert "".join(about.split()) in seen
    assert "".join(what.split()) in seen


@pytest.mark.parametrize(("word", "name"), list(analyses.SYNONYMS.items()))
def test_words_that_people_try_are_answered_with_the_command(word, name):
    assert name in analyses.NAMES
    assert word not in EVERY
    ran = CliRunner().invoke(app, [word], env=WIDE)
    assert ran.exit_code == 2
    assert f"No such command {word!r}. Did you mean {name!r}?" in ran.output
    with pytest.raises(StudyError) as caught:
        analyses.named(word)
    assert caught.value.next_step == f'write "{name}"'
