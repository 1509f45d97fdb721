"""An analysis is a record: what it needs, what may be chosen, how it computes, what it gives."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, fields
from pathlib import Path
from typing import Any, Literal, get_args, get_type_hints

from haptonic.analyses.options import NoOptions, option_of
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import Supports
from haptonic.analyses.tables import example_of, settings_of
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.paths import source
from haptonic.results.cost import Cost
from haptonic.results.result import Result
from haptonic.study.template import ENDING

FLAG = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
COMMAND = "haptonic "
# names that analyses give to their files: to studies, and to what was measured
STUDIES, MEASURED = ("design", "fitted"), ("response", "scan", "trials")
KEPT = "the designs that were finished are kept; the same command goes on from there"
WORDS = {bool: "True or False", str: "a text", type(None): "None"}


def nothing(study: Any, options: Any) -> None:
    """What has to hold before any work starts: nothing but the study."""


@dataclass(frozen=True, kw_only=True)
class Analysis:
    """What can be asked of a study.

    name : of the command and of the method of a study, as in `haptonic.analyses.NAMES`
    result : kind of what it gives
    compute : takes the study, the options and a `Runner`
    supports : takes a study's cell and the options, and gives the error for what of it is not supported
    options : dataclass of what may be chosen, its fields made by `option`; they are declared nowhere else
    cost : takes study and options, and foresees what it needs; None for what takes no time to speak of
    planned : whether `haptonic plan` tells the cost for a study; by default where the study's report has it
    check : takes study and options, and refuses before any work starts what could not end well
    study : whether it is asked of a study ("needed"), may be ("optional"), or of something else ("none")
    parallel : whether it is many computations, which may go to several processes or to a scheduler
    doing : what is said while it computes; kept : what is left of it if it is interrupted
    reported : options with which the report of a study has it; None for a study whose report has not
    folder : ending of the folder for its files; by default its name
    writes : whether it gives files only, and so always has a folder
    watches : whether it is quick enough to be asked again whenever the study is saved
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

    @property
    def method(self) -> str:
        """Name of the method of a study."""
        return self.name.replace(" ", "_")

    def chosen(self, given: Mapping[str, Any]) -> Any:
        """The options, from what was given by name.

        Raises
        ------
        StudyError : there is no such option, one that is needed is missing, or a value is of another kind
        """
        known = {one.name: one for one in fields(self.options)}
        kinds = get_type_hints(self.options)
        for name in given:
            if name not in known and name in settings_of(self.name):
                raise StudyError.unknown(
                    name,
                    name,
                    known,
                    f"{name} is a setting of the study, in its table [{self.name}], and no option",
                    slip=False,
                    next_step=f"write {example_of(self.name, [name], given)}, or "
                    f'study.with_keys({{"{self.name}.{name}": ...}}).{self.method}()',
                )
            if name not in known:
                cause = f"{self.name} has no such option"
                raise StudyError.unknown(name, name, known, cause, next_step="leave it out")
        for name, declared in known.items():
            if declared.default is MISSING and declared.default_factory is MISSING and name not in given:
                raise StudyError.missing(
                    argument=name,
                    allowed=one.help if (one := option_of(declared)) else "a value",
                    cause=f"{self.name} cannot do without it",
                    next_step=f"give it by its name, {name}=...",
                )
        asked = {
            name: one.value(given[name]) if (one := option_of(known[name])) else given[name] for name in given
        }
        for name, value in asked.items():
            _check_kind(name, value, get_args(kinds[name]) or (kinds[name],))
        paths = {name: source(one, name, StudyError) for name, one in asked.items()
                 if one is not None and Path in (kinds[name], *get_args(kinds[name]))}  # fmt: skip
        return self.options(**asked | paths)

    def admit(self, study: Any, options: Any) -> None:
        """Refuse a cell that is not supported, and what else could not end well, before any work starts.

        Raises
        ------
        HaptonicError : from `supports` or `check`
        """
        self.need_supported(study, options)
        self.check(study, options)

    def need_supported(self, study: Any, options: Any) -> None:
        """Raise the error of `supports` for the cell of a study, if there is one."""
        refusal = self.supports(study.cell, options) if study is not None else None
        if refusal is not None:
            raise refusal

    def by_name_only(self, value: object) -> StudyError:
        """The error of an option that Python gave by its place: which it is meant for nobody can tell."""
        known = {one.name: option_of(one) for one in fields(self.options)}
        # those that the command takes by their place as well come first
        names = sorted(known, key=lambda name: (one := known[name]) is None or one.place == "option")
        settings = settings_of(self.name)
        if settings and not names:
            first = {settings[0]: value} if isinstance(value, str) else {}
            return StudyError.malformed(
                argument=f"options of {self.name}",
                given=shown(value),
                allowed=f"none: {self.name} computes what the study gives in its table [{self.name}]",
                cause=f"settings of the table [{self.name}] were given as options",
                next_step=f"write {example_of(self.name, settings, first)}, then study.{self.method}()",
            )
        return StudyError.malformed(
            argument=f"options of {self.name}",
            given=shown(value),
            allowed=", ".join(f"{name}=..." for name in names) or "none: there is nothing to choose",
            cause="a value without the name of its option",
            next_step=f"write its name before it, such as {names[0]}=..." if names else "leave it out",
        )

    def run(self, study: Any, runner: Runner, given: Mapping[str, Any]) -> Result:
        """Check, then compute, as Python asks: errors name options as Python has them, not their flags."""
        try:
            options = self.chosen(given)
            self.admit(study, options)
            return self.compute(study, options, runner)
        except HaptonicError as error:
            raise self._by_names(error).with_traceback(error.__traceback__) from error.__cause__

    def _by_names(self, error: HaptonicError) -> HaptonicError:
        """``modes_at`` for ``--modes-at``; a whole command that an error advises stays one."""
        names = {
            flag: one.name
            for one in fields(self.options)
            if (known := option_of(one)) and known.place == "option"
            for flag in known.flag.split("/")
        }
        parts = error.parts()
        told = {
            part: text if COMMAND in text else FLAG.sub(lambda found: names.get(found[0], found[0]), text)
            for part, text in parts.items()
        }
        return error if told == parts else error.changed(type(error), **told)

    def foreseen(self, study: Any) -> bool:
        """Whether a plan of a study tells what this will cost."""
        if self.planned is not None:
            return self.planned(study)
        return self.reported is not None and self.reported(study) is not None

    def folder_of(self, about: Path) -> str:
        """Name of the folder for the files that it gives about a study or a measurement."""
        path = about.absolute()
        # two designs, or two scans, are files of one name in folders that tell them apart
        of_analyses = STUDIES if path.suffix == ENDING else MEASURED
        stem = path.parent.name if path.stem in of_analyses else path.stem
        return f"{stem}-{self.folder or self.name}".replace(" ", "-")  # a space ends a path in a shell

    def names(self, options: Any, stem: str) -> list[Any]:
        """Of the files that it may write about a study of this name; see `Result.names`."""
        names = self.result.names(options)
        return [one.replace("STUDY", stem) if isinstance(one, str) else one for one in names]


def _check_kind(name: str, value: Any, kinds: tuple[Any, ...]) -> None:
    """Raise StudyError for what should be a text, or yes or no, and is not; others check themselves."""
    if not {*kinds} <= WORDS.keys() or isinstance(value, kinds):
        return
    allowed = " or ".join(WORDS[one] for one in kinds)
    raise StudyError.malformed(
        argument=name,
        given=repr(value),
        allowed=allowed,
        cause="a value of another type",
        next_step=f"give {allowed}, or leave it out",
    )
