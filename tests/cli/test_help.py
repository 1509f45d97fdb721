"""The texts of ``--help``: every word of them reaches the reader."""

from __future__ import annotations

import inspect
import typing
from collections.abc import Iterator

import pytest
import typer
from hypothesis import given
from hypothesis import strategies as st
from typer.models import ParameterInfo
from typer.testing import CliRunner

from haptonic.cli.app import app
from haptonic.cli.helping import Worded
from hostile import any_text

WIDE = {"COLUMNS": "1000", "TERMINAL_WIDTH": "1000"}
Path = tuple[str, ...]


def commands(of: typer.Typer, before: Path = ()) -> Iterator[tuple[Path, typing.Callable[..., object]]]:
    """Every command, and the function that it runs."""
    for one in of.registered_commands:
        assert one.callback is not None
        yield (*before, one.name or one.callback.__name__), one.callback
    for group in of.registered_groups:
        assert group.typer_instance is not None
        assert group.name is not None
        yield from commands(group.typer_instance, (*before, group.name))


def helped(of: typer.Typer, *words: str) -> str:
    """What a help says, without the frames around it."""
    ran = CliRunner().invoke(of, [*words, "--help"], env=WIDE)
    assert ran.exit_code == 0, ran.output
    return " ".join(ran.output.replace("│", " ").split())


def written(function: typing.Callable[..., object]) -> Iterator[str]:
    """What was written for a command and for its options."""
    yield inspect.getdoc(function) or ""
    for hint in typing.get_type_hints(function, include_extras=True).values():
        for one in getattr(hint, "__metadata__", ()):
            yield (isinstance(one, ParameterInfo) and one.help) or ""


@pytest.mark.parametrize(
    ("path", "function"), [pytest.param(*one, id="-".join(one[0])) for one in commands(app)]
)
def test_no_help_loses_a_word(path, function):
    seen, listed = helped(app, *path), helped(app, *path[:-1])
    for text in written(function):
        assert " ".join(text.split()) in seen
    assert " ".join((inspect.getdoc(function) or "").split("\n\n")[0].split()) in listed


BRACKETS = (
    "[trials]", "[/x]", "haptonic[cad]", "[bold]", "\\[a]", "[", "]", "\\", "*c* `d`", "[[plate.force]]",
)  # fmt: skip
texts = st.lists(st.sampled_from(BRACKETS) | any_text, min_size=1, max_size=4)


@given(texts, texts)
def test_a_help_text_is_text(command, option):
    """Whatever is written, for a command in a group and for its option."""
    about, what = ("Text " + " ".join(one).replace("│", "") + " end." for one in (command, option))

    option = typer.Option("", "--here", help=what)

    def run(here: str = option) -> None:
        """Nothing."""

    made, group = typer.Typer(cls=Worded), typer.Typer()
    group.command("run", help=about)(run)
    group.command("other")(lambda: None)
    made.add_typer(group, name="group")
    seen = "".join(helped(made, "group", "run").split())
    assert "".join(about.split()) in seen
    assert "".join(what.split()) in seen
