"""The record of an analysis: its needs, options, computation and result."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import MISSING, dataclass, fields
from numbers import Integral, Real
from pathlib import Path
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from haptonic.analyses.options import NoOptions, option_of
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import Supports
from haptonic.analyses.tables import example_of, settings_of
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.hdf5 import STUDY
from haptonic.names import listed
from haptonic.paths import source
from haptonic.results.cost import Cost
from haptonic.results.result import Result
from haptonic.study.template import ENDING

FLAG = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
COMMAND = "haptonic "
# names of files written by analyses: studies, and measurements
STUDIES, MEASURED = ("design", "fitted"), ("response", "scan", "trials")
KEPT = "finished designs are stored; run the same command to continue"
WORDS = {
    bool: "True or False", int: "a whole number", float: "a number", str: "a text", NoneType: "nothing",
}  # fmt: skip
NUMBERS: dict[Any, type] = {int: Integral, float: Real}  # those of NumPy are numbers too


def nothing(study: Any, options: Any) -> None:
    """Check nothing beyond the study itself."""


@dataclass(frozen=True, kw_only=True)
class Analysis:
    """Record of an analysis.

    name : name of the command, as in `haptonic.analyses.NAMES`; `method` is the method of a study
    result : class of the result
    compute : computes the result from the study, the options and a `Runner`
    supports : takes a study's cell and the options; returns an error if the analysis does not support them
    options : dataclass of the options, its fields made by `option`; their only declaration
    cost : estimates time and memory from study and options; None for an analysis that takes almost no time
    planned : True if `haptonic plan` lists the cost for a study; by default if its report has the part
    check : takes study and options; raises an error before work starts if it could not succeed
    study : "needed", "optional", or "none" for an analysis of something else
    parallel : True if it consists of many computations, for several processes or a scheduler
    doing : name of the work in the progress bar; kept : printed after an interruption
    reported : options for the report of a study; None for a study whose report leaves the analysis out
    folder : ending of the name of its folder; by default the name of the analysis
    writes : True if the result consists of files only, which always need a folder
    watches : True if it is fast enough to be repeated whenever the study is saved
    interactive : name of the option that adds the data of the interactive view; empty without one
    examine : reads the files of the options and returns how they were read, before anything is computed;
        None for an analysis without files
    study_option : name of the option with a study file, for an analysis that takes no study itself
    settings : options that the text of a study in a folder gives in place of `study_option`
    tables : tables of the study with settings for reading the files
    turning : makes sliders and previews for the studio, see `haptonic.analyses.turning`; None without them
    """

    name: str
    result: type[Result]
    compute: Callable[[Any, Any, Runner], Result]
    supports: Supports
    options: type[Any] = NoOptions
    cost: Callable[[Any, Any], Cost] | None = None
    planned: Callable[[Any], bool] | None = None
    check: Callable[[Any, Any], object] = nothing
    study: Literal["needed", "optional", "none"] = "needed"
    parallel: bool = False
    doing: str = ""
    kept: str = ""
    reported: Callable[[Any], Any] | None = None
    folder: str = ""
    writes: bool = False
    watches: bool = False
    interactive: str = ""
    examine: Callable[[Any, Any, Runner], Result] | None = None
    study_option: str = ""
    settings: Callable[[str, Path], Mapping[str, Any]] | None = None
    tables: tuple[str, ...] = ()
    turning: Callable[[], Any] | None = None

    @property
    def method(self) -> str:
        """Name of the analysis as a method of a study."""
        return self.name.replace(" ", "_")

    def chosen(self, given: Mapping[str, Any]) -> Any:
        """Build the options from values by name.

        Raises
        ------
        StudyError : an unknown option, a required option that is missing, or a value of another type
        """
        declared = {field.name: field for field in fields(self.options)}
        kinds = get_type_hints(self.options)
        for name in given:
            if name not in declared and name in settings_of(self.name):
                raise StudyError.unknown(
                    name,
                    name,
                    declared,
                    f"{name} is a setting of the study, in its table [{self.name}], and no option",
                    slip=False,
                    next_step=f"write {example_of(self.name, [name], given)}, or "
                    f'study.with_keys({{"{self.name}.{name}": ...}}).{self.method}()',
                )
            if name not in declared:
                cause = f"{self.name} has no such option"
                raise StudyError.unknown(name, name, declared, cause, next_step="leave it out")
        for name, item in declared.items():
            if item.default is MISSING and item.default_factory is MISSING and name not in given:
                raise StudyError.missing(
                    argument=name,
                    allowed=choice.help if (choice := option_of(item)) else "a value",
                    cause=f"{self.name} requires it",
                    next_step=f"give it by its name, {name}=...",
                )
        values = {
            name: choice.value(given[name]) if (choice := option_of(declared[name])) else given[name]
            for name in given
        }
        for name, value in values.items():
            _check_kind(name, value, kinds[name])
            if choice := option_of(declared[name]):
                choice.check(value)
        paths = {name: source(value, name, StudyError) for name, value in values.items()
                 if value is not None and Path in (kinds[name], *get_args(kinds[name]))}  # fmt: skip
        return self.options(**values | paths)

    def admit(self, study: Any, options: Any) -> None:
        """Refuse an unsupported cell, and everything else that could not succeed, before work starts.

        Raises
        ------
        HaptonicError : from `supports` or `check`
        """
        self.need_supported(study, options)
        self.check(study, options)

    def need_supported(self, study: Any, options: Any) -> None:
        """Raise the error of `supports`, if it returns one for the cell of a study."""
        refusal = self.supports(study.cell, options) if study is not None else None
        if refusal is not None:
            raise refusal

    def by_name_only(self, value: object) -> StudyError:
        """Error for a positional argument in Python; the value does not show which option is meant."""
        choices = {field.name: option_of(field) for field in fields(self.options)}
        # the options that the command takes as arguments come first
        names = sorted(
            choices, key=lambda name: (choice := choices[name]) is None or choice.place == "option"
        )
        settings = settings_of(self.name)
        if settings and not names:
            first = {settings[0]: value} if isinstance(value, str) else {}
            return StudyError.malformed(
                argument=f"options of {self.name}",
                given=shown(value),
                allowed=f"none: {self.name} takes its settings from the table [{self.name}] of the study",
                cause=f"settings of the table [{self.name}] were given as options",
                next_step=f"write {example_of(self.name, settings, first)}, then study.{self.method}()",
            )
        return StudyError.malformed(
            argument=f"options of {self.name}",
            given=shown(value),
            allowed=", ".join(f"{name}=..." for name in names) or f"none: {self.name} has no options",
            cause="a value without the name of its option",
            next_step=f"write the name before it, such as {names[0]}=..." if names else "leave it out",
        )

    def run(self, study: Any, runner: Runner, given: Mapping[str, Any]) -> Result:
        """Check and compute for a call in Python; errors name options as in Python, not as flags."""
        return self._called(self.answer, study, runner, given)

    def answer(self, study: Any, options: Any, runner: Runner) -> Result:
        """Compute the result; its files contain the text of the study, from which `load` reads it."""
        result = self.compute(study, options, runner)
        if study is not None:
            with suppress(StudyError):  # a material, given in Python, that cannot be written
                text = study.to_toml()
                for dataset in result.datasets:
                    dataset.attrs[STUDY] = text
        return result

    def examined(self, study: Any, runner: Runner, given: Mapping[str, Any]) -> Result:
        """Check the options and examine the files; errors as from `run`."""
        assert self.examine is not None, f"{self.name} examines no files"
        return self._called(self.examine, study, runner, given)

    def need_options(self, given: Mapping[str, Any]) -> None:
        """Refuse wrong options; errors as from `run`."""
        with self._named():
            self.chosen(given)

    def _called(
        self, work: Callable[[Any, Any, Runner], Result], study: Any, runner: Runner, given: Mapping[str, Any]
    ) -> Result:
        with self._named():
            options = self.chosen(given)
            self.admit(study, options)
            return work(study, options, runner)

    @contextmanager
    def _named(self) -> Iterator[None]:
        """Errors that name options as in Python."""
        try:
            yield
        except HaptonicError as error:
            raise self._by_names(error).with_traceback(error.__traceback__) from error.__cause__

    def _by_names(self, error: HaptonicError) -> HaptonicError:
        """Replace ``--modes-at`` by ``modes_at``; parts that advise a whole command are not changed."""
        names = {
            flag: field.name
            for field in fields(self.options)
            if (choice := option_of(field)) and choice.place == "option"
            for flag in choice.flag.split("/")
        }
        parts = error.parts()
        renamed = {
            part: text if COMMAND in text else FLAG.sub(lambda match: names.get(match[0], match[0]), text)
            for part, text in parts.items()
        }
        return error if renamed == parts else error.changed(type(error), **renamed)

    def is_planned(self, study: Any) -> bool:
        """True if the plan of a study lists the cost of this analysis."""
        if self.planned is not None:
            return self.planned(study)
        return self.reported is not None and self.reported(study) is not None

    def folder_of(self, about: Path) -> str:
        """Name of the folder for the files about a study or a measurement."""
        path = about.absolute()
        # two designs, or two scans, have the same file name; their folders differ
        of_analyses = STUDIES if path.suffix == ENDING else MEASURED
        stem = path.parent.name if path.stem in of_analyses else path.stem
        return f"{stem}-{self.folder or self.name}".replace(" ", "-")  # a space ends a path in a shell

    def names(self, options: Any, stem: str) -> list[Any]:
        """Names of the files that it may write about a study of this name; see `Result.names`."""
        names = self.result.names(options)
        return [name.replace("STUDY", stem) if isinstance(name, str) else name for name in names]


def _check_kind(name: str, value: Any, kind: Any) -> None:
    """Raise StudyError if a value is not of its type; checks `WORDS` and choices of texts only."""
    kinds = (kind,) if get_origin(kind) is Literal else get_args(kind) or (kind,)
    choices = [choice for kind in kinds if get_origin(kind) is Literal for choice in get_args(kind)]
    plain = [kind for kind in kinds if get_origin(kind) is not Literal]
    if not {*plain} <= WORDS.keys() or any(_is_of_kind(value, kind) for kind in plain):
        return
    if isinstance(value, str) and value in choices:
        return
    words = [*(f'"{choice}"' for choice in choices), *(WORDS[kind] for kind in plain if kind is not NoneType)]
    allowed = listed(words, "or")
    raise StudyError.malformed(
        argument=name,
        given=repr(value),
        allowed=allowed,
        cause="there is no such choice" if isinstance(value, str) and choices else "a value of another type",
        next_step=f"give {allowed}, or leave it out",
    )


def _is_of_kind(value: Any, kind: Any) -> bool:
    if kind in NUMBERS:
        return isinstance(value, NUMBERS[kind]) and not isinstance(value, bool)
    return isinstance(value, kind)
