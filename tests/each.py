"""Many cheap cases in one test."""

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any


def each(names: str | tuple[str, ...], cases: Iterable[Any]) -> Callable[[Callable[..., None]], Any]:
    """As `pytest.mark.parametrize`, but in one test, with one set of fixtures; a failure names its case.

    For cases that take less time than pytest spends on a test.
    """
    wanted, cases = (names,) if isinstance(names, str) else names, list(cases)

    def decorate(test: Callable[..., None]) -> Any:
        @wraps(test)
        def run(*method: Any, **given: Any) -> None:
            for case in cases:
                values = (case,) if isinstance(names, str) else case
                try:
                    test(*method, **dict(zip(wanted, values, strict=True)), **given)
                except BaseException as error:
                    error.add_note(f"in the case {case!r}"[:500])
                    raise

        signature = inspect.signature(test)
        others = [value for name, value in signature.parameters.items() if name not in wanted]
        run.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]
        return run

    assert cases
    return decorate
