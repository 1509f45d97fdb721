"""The parts that every refused command and every error must have."""

import json
import pickle
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pydantic
import pytest

from haptonic.errors import HaptonicError, StudyError
from haptonic.study import loads

PARTS = ("argument", "given", "allowed", "likely cause", "next step", "code")


def assert_five_parts(ran, *words: str, code: str = "", argument: str = "") -> None:
    """Exit code 2, five parts on standard error, code and argument of the error, and the words among them."""
    assert ran.code == 2, ran.err
    assert "Traceback" not in ran.err + ran.out
    for part in PARTS:
        assert part in ran.err, (part, ran.err)
    rows = {line[2:15].strip(): line[15:] for line in ran.err.splitlines() if line.startswith("  ")}
    assert code in ("", rows["code"]), ran.err
    assert rows["argument"].endswith(argument), ran.err
    for word in words:
        assert word in ran.err, (word, ran.err)


def assert_explained(error: HaptonicError, *words: str, code: str = "", argument: str = "") -> None:
    """Five parts, none of them empty, code and argument, and the words among them."""
    parts = error.parts()
    assert all(parts.values()), parts
    assert code in ("", error.code), parts
    assert error.argument.endswith(argument), parts
    for word in words:
        assert word in str(error), (word, str(error))


def refused(
    call: Callable[[], object],
    *words: str,
    code: str = "",
    argument: str = "",
    kind: type[HaptonicError] = HaptonicError,
) -> HaptonicError:
    """The error of a call, of this kind, with five parts, code and argument, and the words among them."""
    with refusing(kind, code, argument, *words) as caught:
        call()
    return caught.value


@contextmanager
def refusing(
    kind: type[HaptonicError], code: str, argument: str = "", *words: str
) -> Iterator[pytest.ExceptionInfo[HaptonicError]]:
    """A block that ends with an error of this kind, with parts as in `assert_explained`."""
    with pytest.raises(kind) as caught:
        yield caught
    assert_explained(caught.value, *words, code=code, argument=argument)


def refused_study(text: str, origin: str = "touchpad.toml") -> StudyError:
    """The error of a study as text: complete for readers, and fit for other processes and files."""
    with pytest.raises(StudyError) as caught:
        loads(text, origin)
    error = caught.value
    assert error.argument.startswith(origin)
    assert all(part.strip() for part in error.parts().values())
    assert not any(word in str(error) for word in ("Traceback", "pydantic"))
    assert len(str(error)) < 5000
    assert json.loads(json.dumps(error.parts())) == error.parts()
    assert pickle.loads(pickle.dumps(error)).parts() == error.parts()
    assert not isinstance(error.__context__, pydantic.ValidationError)  # some picklers follow the context
    return error
