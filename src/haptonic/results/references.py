"""Published reference values as data, with remarks, and variants of a study that explain differences.

They are in a folder beside the study of an example, ``references/touchpad.toml`` beside ``touchpad.toml``::

    title = "the paper"
    citation = "A. Author, “A title”"

    [[value]]
    quantity = "Complete gap, lower edge"
    value = "52.9 kHz"
    unit = "Hz"
    analysis = "bands"
    path = "gaps.complete=True.lower_hz"
    error = "gaps.complete=True.lower_error_hz"

A path leads to a value in the JSON output of an analysis. ``name=text`` selects the first item of a list with
this value. Names are written as they are, including dots.
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
    """A table of a references file: immutable, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Value(_FileTable):
    """A published value to compare with; without a unit it is a text.

    Our value is at ``path`` in the output of ``analysis``. The output "study" contains the inputs by their
    keys; "derived" contains the quantities that `haptonic.report.derived` computes from a study and its
    results.
    """

    quantity: Text = Field(title="Quantity", description="Name of the quantity.")
    value: Text = Field(title="Value", description='Published value with its unit; "to" between two ends.')
    unit: str = Field("", title="Unit", description="SI unit, 1 for a plain number; empty for a text.")
    role: Literal["computed", "input", "experiment"] = Field(
        "computed",
        title="Role",
        description="computed here, input of the study, or experiment that is not computed here.",
    )
    analysis: str = Field("", title="Analysis", description="Analysis that computes our value.")
    path: str = Field("", title="Path", description="Path of our value in the output.")
    to: str = Field("", title="Second path", description="Path of the upper end if the value has two ends.")
    over: str = Field("", title="Divisor", description="Path of a number that ours is divided by.")
    less: str = Field("", title="Subtrahend", description="Path of a number that is subtracted from ours.")
    less_error: str = Field(
        "", title="Error of the subtrahend", description="Path of the subtrahend's error bound."
    )
    factor: float = Field(1.0, title="Factor", description="Factor on our number.")
    error: str = Field("", title="Error", description="Path of the error bound of our value.")
    relation: Literal["equal", "at least", "at most", "within"] = Field(
        "equal", title="Relation", description="Required relation of our value to the published one."
    )
    means: tuple[str, ...] = Field((), title="Meaning", description="Our words with the same meaning.")
    friction: Literal["", "driven", "idle", "stopped"] = Field(
        "",
        title="Reduction",
        description="Kind of the measured reduction of friction, for chapters and pictures.",
    )
    remark: str = Field("", title="Remark", description="Reason of a difference, as far as it is known.")

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        """Check that every number has the path of our value, or a remark that explains why it has none."""
        if not (self.analysis and self.path) and (self.role == "computed" or not self.remark):
            raise ValueError(
                "a computed value needs analysis and path; others need them or a remark with the reason"
            )
        self.ends  # noqa: B018
        return self

    @property
    def ends(self) -> tuple[float, ...]:
        """The published number in its SI unit, or its two ends; empty for a text."""
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
        """Half of the last digit of the published number, in its SI unit."""
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

    chapter: Text = Field(title="Chapter", description="Anchor of the chapter in the page.")
    text: Text = Field(title="Text", description="The sentence.")


class Variant(_FileTable):
    """A variant: the study with one change, to see its effect."""

    table: Text = Field(title="Table", description="Variants of one table are compared with its first.")
    label: Text = Field(title="Label", description="The change as text.")
    analysis: Text = Field(title="Analysis", description="Analysis that computes the value.")
    path: Text = Field(title="Path", description="Path of the value in the output.")
    change: dict[str, Any] = Field({}, title="Change", description="New values by key of the study file.")


class References(_FileTable):
    """All contents of a references file."""

    title: Text = Field("the reference", title="Title", description="Name of the reference in the report.")
    citation: Text = Field("", title="Citation", description="Publication of the reference.", min_length=0)
    about: str = Field("", title="About", description="Description of the reference values.")
    reductions: dict[str, float] = Field(
        {}, alias="friction", title="Friction",
        description="Published reductions driven and idle, and share stopped, if no value gives them.",
    )  # fmt: skip
    figures: dict[str, str] = Field(
        {}, title="Figures", description="Figure of the reference by our picture."
    )
    value: tuple[Value, ...] = Field((), title="Values", description="Values to compare with.")
    remark: tuple[Remark, ...] = Field((), title="Remarks", description="Remarks in chapters of the report.")
    variant: tuple[Variant, ...] = Field((), title="Variants", description="Variants to compute.")

    @classmethod
    def read(cls, path: str | Path) -> References:
        """Read a file of references.

        Raises
        ------
        StudyError : the file cannot be read, is not TOML, or has other contents
        """
        file = source(path, "references", StudyError)
        try:
            data = tomllib.loads(file.read_text("utf-8"))
        except (OSError, ValueError) as error:
            raise unread(
                StudyError, error,
                argument="references", given=str(path), allowed="a TOML file with reference values",
                cause=str(error), next_step="check the name, or write the file again",
            ) from None  # fmt: skip
        try:
            return cls.model_validate(data)
        except ValidationError as error:
            first = error.errors()[0]
            raise StudyError.malformed(
                argument=f"{path}: {'.'.join(map(str, first['loc']))}", given=shown(first["input"]),
                allowed=first["msg"], cause="the file of references has another form here",
                next_step="write each value, remark and variant as a separate table, as in the example",
            ) from None  # fmt: skip

    @classmethod
    def beside(cls, study: Path | None) -> References | None:
        """References in the folder beside a study's file; None without such a file."""
        file = None if study is None else study.parent / FOLDER / study.name
        return cls.read(file) if file is not None and file.is_file() else None

    @property
    def friction(self) -> dict[str, float]:
        """Published reductions of friction by "driven" and "idle", and the share "stopped"."""
        return self.reductions | {value.friction: value.ends[0] for value in self.value if value.friction}

    def remarks(self, chapter: str) -> list[str]:
        """Remarks for a chapter of the report."""
        return [remark.text for remark in self.remark if remark.chapter == chapter]

    def where(self, picture: str) -> str:
        """Hint at the reference's figure of the same content as a picture, for its caption."""
        number = self.figures.get(picture)
        return f" ({number} of {self.title})" if number else ""


def found_at(answer: Any, path: str) -> Any:
    """Value at a path in an output; None without such a value.

    A name may contain dots and equals signs. If several steps fit the beginning of the path, the longest is
    taken.
    """
    if not path:
        return answer
    if isinstance(answer, Mapping):
        steps = list(answer.items())
    elif isinstance(answer, list):
        inside = [item for item in answer if isinstance(item, Mapping)]
        steps = [(f"{name}={value}", item) for item in inside for name, value in item.items()]
        steps += [(str(number), item) for number, item in enumerate(answer)]
    else:
        return None
    fitting = [(step, below) for step, below in steps if f"{path}.".startswith(f"{step}.")]
    if not fitting:
        return None
    step, below = max(fitting, key=lambda pair: len(pair[0]))  # the first of equal ones
    return found_at(below, path[len(step) + 1 :])
