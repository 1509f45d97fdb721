"""Published values as data: what they are compared with, remarks, and changes that explain differences.

An example brings them in a folder beside its study, ``references/touchpad.toml`` beside ``touchpad.toml``::

    title = "the paper"
    citation = "A. Author, “A title”"

    [[value]]
    quantity = "Complete gap, lower edge"
    value = "52.9 kHz"
    unit = "Hz"
    analysis = "bands"
    path = "gaps.complete=True.lower_hz"
    error = "gaps.complete=True.lower_error_hz"

A path leads into the JSON answer of an analysis; ``name=text`` takes the first of a list that has it so.
Names in it are written as they are, dots and all.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from haptonic.errors import StudyError, shown
from haptonic.paths import source, unread
from haptonic.units import to_si

FOLDER = "references"
Text = Annotated[str, Field(min_length=1, max_length=2000, strict=True)]


class _FileTable(BaseModel):
    """A table of such a file: immutable, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Value(_FileTable):
    """A value that an analysis is compared with; without a unit it is a text.

    Our value is found at ``path`` in the answer of ``analysis``. The answer "study" has the inputs by their
    keys, "derived" what `haptonic.report.derived` computes from a study and its results.
    """

    quantity: Text = Field(title="Quantity", description="What it is of.")
    value: Text = Field(title="Value", description='As published, with its unit; "to" between two ends.')
    unit: str = Field("", title="Unit", description="SI unit, 1 for a plain number; empty for a text.")
    role: Literal["computed", "input", "experiment"] = Field(
        "computed",
        title="Role",
        description="Input: the study takes it; experiment: nothing here computes it.",
    )
    analysis: str = Field("", title="Analysis", description="That gives our value.")
    path: str = Field("", title="Path", description="Of our value in its answer.")
    to: str = Field("", title="Second path", description="Of the upper end where the value has two ends.")
    over: str = Field("", title="Divisor", description="Path of a number that ours is divided by.")
    less: str = Field("", title="Subtrahend", description="Path of a number that is subtracted from ours.")
    less_error: str = Field("", title="Its error", description="Path of the bound of the subtrahend's error.")
    factor: float = Field(1.0, title="Factor", description="That our number is multiplied by.")
    error: str = Field("", title="Error", description="Path of the bound of its error.")
    relation: Literal["equal", "at least", "at most", "within"] = Field(
        "equal", title="Relation", description="What ours should be to the published value."
    )
    means: tuple[str, ...] = Field((), title="Meaning", description="Words of ours that say the same.")
    friction: Literal["", "driven", "idle", "stopped"] = Field(
        "",
        title="Reduction",
        description="Which measured reduction of friction it is, for chapters and pictures.",
    )
    remark: str = Field("", title="Remark", description="Why they differ, as far as it is known.")

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        """Every number says where ours comes from, or why there is none."""
        if not (self.analysis and self.path) and (self.role == "computed" or not self.remark):
            raise ValueError(
                "a computed value needs analysis and path; others need them or a remark that says why not"
            )
        self.ends  # noqa: B018
        return self

    @property
    def ends(self) -> tuple[float, ...]:
        """The published number in the SI unit, or its two ends; empty for a text."""
        if not self.unit:
            return ()
        unit, parts = "" if self.unit == "1" else self.unit, self.value.split(" to ")
        shown = parts[-1].strip().partition(" ")[2]
        texts = [part if part.strip().partition(" ")[2] else f"{part} {shown}" for part in parts]
        return tuple(self._si(text.strip(), unit) for text in texts)

    @property
    def decimals(self) -> int:
        """Digits behind the point of the published number."""
        return len(self.value.partition(" ")[0].partition(".")[2])

    @property
    def rounding(self) -> float:
        """Half of the last digit of the published number, in its SI unit; that may be unsaid of it."""
        number, _, unit = self.value.split(" to ")[-1].strip().partition(" ")
        digits = len(number.partition(".")[2])
        half = f"{0.5 * 10.0**-digits:.{digits + 1}f}"
        return self._si(f"{half} {unit}".strip(), "" if self.unit == "1" else self.unit)

    def _si(self, text: str, unit: str) -> float:
        if not unit and text.endswith("%"):
            return to_si(text.removesuffix("%").strip(), unit, self.quantity) / 100
        return to_si(text, unit, self.quantity)


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
    reductions: dict[str, float] = Field(
        {}, alias="friction", title="Friction",
        description="Published reductions, driven and idle, and the share stopped, where no value says so.",
    )  # fmt: skip
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

    @property
    def friction(self) -> dict[str, float]:
        """Published reductions of friction by "driven" and "idle", and the share "stopped"."""
        return self.reductions | {one.friction: one.ends[0] for one in self.value if one.friction}

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
