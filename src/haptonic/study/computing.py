"""The methods of a study that compute: one for each analysis, with its options as signature and help.

They follow from the table of analyses. An analysis is imported when its method is asked for.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import MISSING, Field, fields
from pathlib import Path
from textwrap import fill, indent
from types import MethodType
from typing import Any, get_args, get_type_hints

from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option_of
from haptonic.analyses.tables import example_of, settings_of

WIDTH = 100
OF_RUN = "See `haptonic.Study.run`."


class AnalysisMethod:
    """The method of an analysis, a descriptor: a function of the class, bound for a study."""

    def __init__(self, name: str, run: Callable[..., Any]) -> None:
        self._name, self._run = name, run
        self._made: Callable[..., Any] | None = None

    def __get__(self, study: Any, kind: type) -> Any:
        function = self._made or self._function(kind)
        return function if study is None else MethodType(function, study)

    def _function(self, kind: type) -> Any:
        name, run, analysis = self._name, self._run, named(self._name)

        def function(study: Any, *unnamed: Any, **options: Any) -> Any:
            return run(study, name, *unnamed, **options)

        function.__name__ = name.replace(" ", "_")
        function.__qualname__ = f"{kind.__qualname__}.{function.__name__}"
        function.__module__ = kind.__module__
        function.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
            [inspect.Parameter("self", inspect.Parameter.POSITIONAL_ONLY), *parameters_of(analysis, run)],
            return_annotation=analysis.result,
        )
        function.__doc__ = documentation_of(analysis, run)
        self._made = function
        return function


def parameters_of(analysis: Analysis, run: Callable[..., Any]) -> list[inspect.Parameter]:
    """The options of an analysis and those of ``run``, all by name; a quantity or a path may be a text."""
    kinds = get_type_hints(analysis.options)
    own = [
        inspect.Parameter(
            one.name, inspect.Parameter.KEYWORD_ONLY, annotation=_taken(one, kinds[one.name]),
            default=inspect.Parameter.empty if is_needed(one) else one.default,
        )
        for one in fields(analysis.options)
    ]  # fmt: skip
    shared = inspect.signature(run, eval_str=True).parameters.values()
    return [*own, *(one for one in shared if one.kind is one.KEYWORD_ONLY)]


def is_needed(one: Field[Any]) -> bool:
    """Whether an option has no default."""
    return one.default is MISSING and one.default_factory is MISSING


def documentation_of(analysis: Analysis, run: Callable[..., Any]) -> str:
    """What an analysis gives, its options, and the table of the study that it reads."""
    lines = [fill(NAMES[analysis.name], WIDTH), "", "Parameters", "----------"]
    declared = {one.name: one for one in fields(analysis.options)}
    for one in parameters_of(analysis, run):
        option = option_of(declared[one.name]) if one.name in declared else None
        words = option.help if option else "Given in Python only." if one.name in declared else OF_RUN
        default = "" if one.default is one.empty else f" = {one.default!r}"
        kind = inspect.formatannotation(one.annotation).replace("pathlib.", "")
        lines += [f"{one.name} : {kind}{default}", indent(fill(words, WIDTH - 4), " " * 4)]
    lines += ["", "Returns", "-------", f"{analysis.result.__module__}.{analysis.result.__qualname__}"]
    keys = settings_of(analysis.name)
    if keys:
        about = f"Settings of the study, its table [{analysis.name}], are no options: {', '.join(keys)}. "
        how = f"Give them where the study is made, {example_of(analysis.name, keys[:1])}, or by `with_keys`."
        lines += ["", "Notes", "-----", fill(about + how, WIDTH)]
    return "\n".join(lines) + "\n"


def _taken(one: Field[Any], kind: Any) -> Any:
    """The type of an option; a quantity may be a text with its unit, a path a text."""
    known = option_of(one)
    text = Path in (kind, *get_args(kind)) or (known is not None and bool(known.unit))
    return str | kind if text else kind
