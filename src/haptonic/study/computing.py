"""Methods of a study that compute: one per analysis, with its options as signature and help.

They follow from the table of analyses. The module of an analysis is imported when its method is first used.
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
    """Descriptor for the method of an analysis: a function of the class, bound to a study."""

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
    """Options of an analysis and those of ``run``, all keyword-only; a quantity or a path may be a text."""
    kinds = get_type_hints(analysis.options)
    declared = [
        inspect.Parameter(
            field.name, inspect.Parameter.KEYWORD_ONLY, annotation=_annotation(field, kinds[field.name]),
            default=inspect.Parameter.empty if is_needed(field) else field.default,
        )
        for field in fields(analysis.options)
    ]  # fmt: skip
    shared = inspect.signature(run, eval_str=True).parameters.values()
    return [*declared, *(parameter for parameter in shared if parameter.kind is parameter.KEYWORD_ONLY)]


def is_needed(field: Field[Any]) -> bool:
    """True if an option has no default."""
    return field.default is MISSING and field.default_factory is MISSING


def documentation_of(analysis: Analysis, run: Callable[..., Any]) -> str:
    """Documentation of an analysis: its result, its options, and the table of the study that it reads."""
    lines = [fill(NAMES[analysis.name], WIDTH), "", "Parameters", "----------"]
    declared = {field.name: field for field in fields(analysis.options)}
    for parameter in parameters_of(analysis, run):
        option = option_of(declared[parameter.name]) if parameter.name in declared else None
        words = option.help if option else "Given in Python only." if parameter.name in declared else OF_RUN
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        kind = inspect.formatannotation(parameter.annotation).replace("pathlib.", "")
        lines += [f"{parameter.name} : {kind}{default}", indent(fill(words, WIDTH - 4), " " * 4)]
    lines += ["", "Returns", "-------", f"{analysis.result.__module__}.{analysis.result.__qualname__}"]
    keys = settings_of(analysis.name)
    if keys:
        about = f"Settings of the study, in its table [{analysis.name}], are not options: {', '.join(keys)}. "
        how = f"Set them in the study, {example_of(analysis.name, keys[:1])}, or with `with_keys`."
        lines += ["", "Notes", "-----", fill(about + how, WIDTH)]
    return "\n".join(lines) + "\n"


def _annotation(field: Field[Any], kind: Any) -> Any:
    """Type of an option; a quantity may also be a text with its unit, a path a text."""
    option = option_of(field)
    text = Path in (kind, *get_args(kind)) or (option is not None and bool(option.unit))
    return str | kind if text else kind
