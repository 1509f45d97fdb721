"""What somebody else found, as data: values that stand beside ours, remarks, and what to change to compare.

An example brings them in a folder beside its study, ``references/touchpad.toml`` beside ``touchpad.toml``::

    title = "the paper"
    citation = "A. Author, “A title”"

    [[value]]
    quantity = "Complete gap, lower edge"
    value = "52.9 kHz"
    unit = "Hz"
    analysis = "bands"
    path = "gaps.complete=True.lower_hz"

A path leads into what an analysis answers in JSON; ``name=text`` takes the first of a list that has it so.
Names in it are written as they are, dots and all.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from haptonic.errors import StudyError, shown
from haptonic.paths import source, unread
from haptonic.units import to_si

FOLDER = "references"
Text = Annotated[str, Field(min_length=1, max_length=2000, strict=True)]


class _FileTable(BaseModel):
    """A table of such a file: immutable, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Value(_FileTable):
    """A value that an analysis is compared with; without a unit it is a text."""

    quantity: Text = Field(title="Quantity", description="What it is of.")
    value: Text = Field(title="Value", description="As it was published, with its unit.")
    unit: str = Field("", title="Unit", description="SI unit, 1 for a plain number; empty for a text.")
    analysis: str = Field("", title="Analysis", description="That gives our value.")
    path: str = Field("", title="Path", description="Of our value in its answer.")
    error: str = Field("", title="Error", description="Path of the bound of its error.")
    remark: str = Field("", title="Remark", description="Why they differ, as far as it is known.")

    @property
    def number(self) -> float | None:
        """In the SI unit; None of a text."""
        if not self.unit:
            return None
        return to_si(self.value, "" if self.unit == "1" else self.unit, self.quantity)


class Remark(_FileTable):
    """A sentence for a chapter of the report."""

    chapter: Text = Field(title="Chapter", description="By its anchor in the page.")
    text: Text = Field(title="Text", description="The sentence.")


class Variant(_FileTable):
    """The study with one thing changed, to see what that moves."""

    table: Text = Field(title="Table", description="Variants of one table are compared with its first.")
    label: Text = Field(title="Label", description="What was changed, in words.")
    analysis: Text = Field(title="Analysis", description="That gives the value.")
    path: Text = Field(title="Path", description="Of the value in its answer.")
    change: dict[str, Any] = Field({}, title="Change", description="New values by key of the study file.")


class References(_FileTable):
    """All that an example brings."""

    title: Text = Field("the reference", title="Title", description="How the report calls it.")
    citation: Text = Field("", title="Citation", description="Where it was published.", min_length=0)
    about: str = Field("", title="About", description="What its numbers are.")
    friction: dict[str, float] = Field(
        {}, title="Friction", description="Published reductions, driven and idle, and the share stopped."
    )
    figures: dict[str, str] = Field({}, title="Figures", description="Where it shows what, by picture.")
    value: tuple[Value, ...] = Field((), title="Values", description="To be compared.")
    remark: tuple[Remark, ...] = Field((), title="Remarks", description="For chapters of the report.")
    variant: tuple[Variant, ...] = Field((), title="Variants", description="What is computed besides.")

    @classmethod
    def read(cls, path: str | Path) -> References:
        """From a file.

        Raises
        ------
        StudyError : the file cannot be read, is not TOML, or holds something else
        """
        file = source(path, "references", StudyError)
        try:
            data = tomllib.loads(file.read_text("utf-8"))
        except (OSError, ValueError) as error:
            raise unread(
                StudyError, error,
                argument="references", given=str(path), allowed="a TOML file with reference values",
                cause=str(error), next_step="check the name, or write the file anew",
            ) from None  # fmt: skip
        try:
            return cls.model_validate(data)
        except ValidationError as error:
            first = error.errors()[0]
            raise StudyError.malformed(
                argument=f"{path}: {'.'.join(map(str, first['loc']))}", given=shown(first["input"]),
                allowed=first["msg"], cause="the file of references has another form there",
                next_step="write each value, remark and variant as a table of its own, as the example does",
            ) from None  # fmt: skip

    @classmethod
    def beside(cls, study: Path | None) -> References | None:
        """Those that lie beside a study's file, if any do."""
        file = None if study is None else study.parent / FOLDER / study.name
        return cls.read(file) if file is not None and file.is_file() else None

    def remarks(self, chapter: str) -> list[str]:
        """For a chapter of the report."""
        return [one.text for one in self.remark if one.chapter == chapter]

    def where(self, picture: str) -> str:
        """Where it shows the same as a picture, for the sentence below that."""
        found = self.figures.get(picture)
        return f" ({found} of {self.title})" if found else ""


def found_at(answer: Any, path: str) -> Any:
    """The value that a path leads to in an answer; None if there is none.

    A name may hold dots and signs of equality of its own: of the steps that the path can begin with, the
    longest is taken.
    """
    if not path:
        return answer
    if isinstance(answer, Mapping):
        steps = list(answer.items())
    elif isinstance(answer, list):
        inside = [one for one in answer if isinstance(one, Mapping)]
        steps = [(f"{name}={value}", one) for one in inside for name, value in one.items()]
        steps += [(str(number), one) for number, one in enumerate(answer)]
    else:
        return None
    fitting = [(step, below) for step, below in steps if f"{path}.".startswith(f"{step}.")]
    if not fitting:
        return None
    step, below = max(fitting, key=lambda one: len(one[0]))  # of equal ones the first
    return found_at(below, path[len(step) + 1 :])
