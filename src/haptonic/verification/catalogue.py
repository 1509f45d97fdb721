"""Quantities, and their sources for comparison; the data are in ``catalogue.toml`` and ``studies``."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from functools import cache
from importlib.resources import files
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from haptonic.errors import StudyError
from haptonic.units import to_si

Measure = Literal["lower edge", "upper edge", "centre", "relative width", "frequencies"]
Kind = Literal["published", "exact", "independent"]
Positive = Annotated[float, Field(ge=0)]


class _CatalogueTable(BaseModel):
    """A table of the file: immutable, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class OtherStudy(_CatalogueTable):
    """A second study with the same expected result.

    study : in the folder of the cases; the case's own by default
    change : new values by key of the study file
    at : wavevectors whose frequencies are combined; those of the case by default
    factor : factor on its frequencies
    """

    study: str = ""
    change: dict[str, Any] = {}
    at: tuple[str, ...] = ()
    bands: tuple[int, ...] = ()
    factor: float = 1.0


class CaseQuantity(_CatalogueTable):
    """One number, or the frequencies at one wavevector, with the reference value.

    measure : an edge, the centre or the relative width of the widest complete gap, or frequencies
    at : wavevector of the frequencies, as for ``--modes-at``
    bands : their numbers, from 1; all by default
    published : values with their units; empty if ``other`` gives them
    uncertainty : relative, of each published value, or one for all
    tolerance : relative, difference that is allowed beyond both errors; ``remark`` gives its reason
    """

    name: str
    measure: Measure = "frequencies"
    at: str = ""
    bands: tuple[int, ...] = ()
    published: tuple[str, ...] = ()
    other: OtherStudy | None = None
    uncertainty: tuple[Positive, ...] = (0.0,)
    tolerance: Positive = 0.0

    @model_validator(mode="after")
    def _has_one_reference(self) -> Self:
        if bool(self.published) == (self.other is not None):
            raise ValueError("a quantity has published values or another study, and not both")
        if (self.measure == "frequencies") != bool(self.at):
            raise ValueError("frequencies, and only they, have a wavevector")
        if len(self.uncertainty) not in (1, len(self.published)):
            raise ValueError("each published value has an uncertainty, or all have one")
        return self

    @property
    def unit(self) -> str:
        """SI unit of the values."""
        return "" if self.measure == "relative width" else "Hz"

    @property
    def published_values(self) -> tuple[float, ...]:
        """The published values in the SI unit."""
        return tuple(to_si(text, self.unit, self.name) for text in self.published)


class Case(_CatalogueTable):
    """A study and its reference values.

    id : name of the case, and of its study file unless ``study`` names another one
    kind : kind of the reference values
    vary : changes of the study, by key, for values that the source does not print; the result is then a range
    remark : values that the source does not print, and reasons for differences
    picture : True if the page shows its band diagram, with edges or frequencies at corners of the zone
    """

    id: str
    study: str
    title: str
    kind: Kind
    source: str
    quantity: tuple[CaseQuantity, ...]
    vary: tuple[dict[str, Any], ...] = ()
    remark: str = ""
    picture: bool = False

    @model_validator(mode="before")
    @classmethod
    def _has_a_study(cls, data: dict[str, Any]) -> dict[str, Any]:
        return {"study": data["id"], **data}


class OmittedCase(_CatalogueTable):
    """A case that is not computed, and the reason."""

    title: str
    source: str
    reason: str


class _CaseFile(_CatalogueTable):
    case: tuple[Case, ...]
    omitted: tuple[OmittedCase, ...]


@cache
def _case_file() -> _CaseFile:
    text = files("haptonic").joinpath("verification", "catalogue.toml").read_text("utf-8")
    return _CaseFile.model_validate(tomllib.loads(text))


def cases(names: Sequence[str] = ()) -> tuple[Case, ...]:
    """Cases with these names, in their order; all cases without names.

    Raises
    ------
    StudyError : an unknown case
    """
    by_name = {case.id: case for case in _case_file().case}
    for name in names:
        if name not in by_name:
            raise StudyError.unknown(
                "CASE",
                name,
                by_name,
                "there is no such case",
                next_step="`haptonic verify --list` lists them",
            )
    return tuple(by_name[name] for name in names or by_name)


def omitted_cases() -> tuple[OmittedCase, ...]:
    """Cases that are not computed."""
    return _case_file().omitted
