"""The family of errors; every error for users has the same five parts."""

from __future__ import annotations

import difflib
import re
import reprlib
from collections.abc import Iterable, Mapping
from functools import partial
from typing import NotRequired, Protocol, Self, TypedDict, TypeVar, Unpack

from haptonic.names import listed, visible

E = TypeVar("E", bound="HaptonicError")
C = TypeVar("C", bound="HaptonicError", covariant=True)

VAGUE, CLOSE = 0.5, 0.8  # shares of common letters: perhaps the same word, and a slip of one or two letters
MOST_PROPOSED = 4  # names in one next step
MOST_NAMES, NEAREST_NAMES = 40, 10  # in a message; of a longer list the nearest names


class Parts(TypedDict):
    """The parts of an error; see `HaptonicError`."""

    argument: str
    given: object
    allowed: str
    cause: str
    next_step: str
    command: NotRequired[str]


class _Constructor(Protocol[C]):
    def __call__(self, **parts: Unpack[Parts]) -> C: ...


class _Code:
    """Descriptor for the constructor of an error code; its name is the code, ``meaning`` its docstring."""

    def __init__(self, meaning: str) -> None:
        self.__doc__ = meaning

    def __set_name__(self, owner: type, name: str) -> None:
        self.code = name.replace("_", "-")

    def __get__(self, error: E | None, kind: type[E]) -> _Constructor[E]:
        return partial(kind, self.code)


class HaptonicError(Exception):
    """Base class of errors that the user can correct.

    Errors are made by the constructor of their code, ``StudyError.missing(argument=..., given=..., ...)``.
    The name of the constructor is the error's ``code``. Programs and tests may rely on the code and the
    argument, which do not change with the wording. ``docs/errors.md`` lists all codes.

    Parameters
    ----------
    argument : argument or key, with its path (``cell.pillar.diameter``)
    given : given value
    allowed : allowed values
    cause : the likely cause
    next_step : action that solves the problem
    command : next step for users of the command line, if it differs from that in Python

    Parts may quote contents of files, so control characters are escaped in all of them.
    """

    def __init__(self, code: str, /, **parts: Unpack[Parts]) -> None:
        self.code = code
        self.argument = visible(parts["argument"])
        self.given = visible(str(parts["given"]))
        self.allowed = visible(parts["allowed"])
        self.cause = visible(parts["cause"])
        self.next_step = visible(parts["next_step"])
        self.command = visible(parts.get("command") or parts["next_step"])
        super().__init__(
            f"{self.argument}: got {self.given}\n"
            f"  allowed: {self.allowed}\n  likely cause: {self.cause}\n  next step: {self.next_step}\n"
            f"  code: {code}"
        )

    def parts(self) -> dict[str, str]:
        """Code and parts as a mapping, for ``--json`` and for tables."""
        names = ("code", "argument", "given", "allowed", "cause", "next_step")
        return {name: getattr(self, name) for name in names}

    def for_command(self) -> Self:
        """The error with the next step for users of the command line."""
        return self.changed(type(self), next_step=self.command)

    def changed(self, kind: type[E], /, **parts: str) -> E:
        """The error as another class, or with other parts."""
        command = "" if "next_step" in parts else self.command
        return _rebuilt(kind, self.parts() | parts, command)

    def __reduce__(self) -> tuple[object, ...]:
        # Exceptions with keyword-only arguments do not pickle by default; workers send them back.
        return (_rebuilt, (type(self), self.parts(), self.command))

    @classmethod
    def unknown(
        cls,
        argument: str,
        given: object,
        known: Iterable[str],
        cause: str,
        *,
        slip: bool = True,
        allowed: str = "",
        next_step: str = "choose one of these",
        command: str = "",
    ) -> Self:
        """An unknown name; the message proposes the nearest one.

        Parameters
        ----------
        known : known names; slip : True if the name may be a misspelling of one of them
        allowed : text, if more than the known names is allowed
        next_step, command : used if no known name is similar
        """
        names = list(known)
        proposal = proposed(str(given), names) if slip else ""
        return cls(
            "unknown",
            argument=argument,
            given=shown(given),
            allowed=allowed or (f"one of {_some(names, str(given))}" if names else "none: the list is empty"),
            cause=cause,
            next_step=proposal or next_step,
            command="" if proposal else command,
        )

    @classmethod
    def missing(
        cls,
        *,
        argument: str,
        allowed: str,
        cause: str,
        next_step: str,
        given: object = "nothing",
        command: str = "",
    ) -> Self:
        """A required value is missing."""
        return cls(
            "missing", argument=argument, given=given, allowed=allowed, cause=cause, next_step=next_step,
            command=command,
        )  # fmt: skip

    malformed = _Code("A value of the wrong form or type.")
    out_of_range = _Code("A value beyond its bounds.")
    conflict = _Code("Values that exclude each other.")
    repeated = _Code("A duplicate, or a name in use.")
    mismatch = _Code("Data of another plate, scan or drive.")
    too_few = _Code("Too little data for an answer.")
    unsupported = _Code("A valid case that haptonic does not compute.")
    no_answer = _Code("Valid input, but the answer does not exist.")
    inaccurate = _Code("An accuracy that cannot be reached.")
    too_large = _Code("Too much memory or time, or a file beyond the limit.")
    not_found = _Code("A missing file or folder.")
    forbidden = _Code("A file that you may not read.")
    encoding = _Code("Text in an unknown encoding.")
    unreadable = _Code("A file that cannot be read.")
    unwritable = _Code("A file that cannot be written.")
    not_installed = _Code("An optional package is missing.")
    worker = _Code("Worker processes do not start, or were lost.")


def _rebuilt(kind: type[E], parts: Mapping[str, str], command: str = "") -> E:
    code, argument, given, allowed, cause, next_step = parts.values()
    return kind(
        code,
        argument=argument,
        given=given,
        allowed=allowed,
        cause=cause,
        next_step=next_step,
        command=command,
    )


class StudyError(HaptonicError):
    """A study file, or a value in it, cannot be used."""


class GeometryError(HaptonicError):
    """Sizes are not those of a possible body."""


class ResponseError(HaptonicError):
    """A frequency response, or a file of one, cannot be used."""


class FrictionError(HaptonicError):
    """Trials, or the numbers of a model of friction, cannot be used."""


class ChannelError(HaptonicError):
    """A file of signals, or a channel in it, cannot be used."""


class ScanError(HaptonicError):
    """A scan file, or its content, cannot be used."""


class NumericalError(HaptonicError):
    """Numbers are so far apart that rounding errors dominate the result."""


class ResourceError(HaptonicError):
    """The machine has too little memory, or a file cannot be read or written."""


class HaptonicWarning(UserWarning):
    """A value is allowed but so unusual that it is probably a slip."""


def proposed(name: str, known: Iterable[str]) -> str:
    """Next step for an unknown name: to write one of the names that it may mean; empty without any."""
    names = [f'"{each}"' for each in similar(name, known)]
    return f"write {listed(names, 'or')}" if names else ""


def similar(name: str, known: Iterable[str]) -> list[str]:
    """Known names that an unknown one may mean: all that contain its words, or else the nearest spelling.

    So "glass" means every kind of glass, although "brass" differs from it by fewer letters. A name with fewer
    words has to share one, or be very similar: "silicone rubber" does not mean "silicon".
    """
    names, words = list(known), _words(name)
    alike = [each for each in names if words & _words(each) or len(words) <= len(_words(each))]
    containing = [each for each in names if words and words <= _words(each)]
    guess = None if containing else nearest(name, alike) or nearest(name, names, CLOSE)
    return containing[:MOST_PROPOSED] if guess is None else [guess]


def _some(names: list[str], given: str) -> str:
    """All of some names, or of a long list the nearest ones."""
    if len(names) <= MOST_NAMES:
        return ", ".join(names)
    near = set(difflib.get_close_matches(given, names, n=NEAREST_NAMES, cutoff=0.0))
    return f"{', '.join(name for name in names if name in near)} and {len(names) - len(near)} others"


def _words(name: str) -> set[str]:
    return {word for word in re.split(r"[\W_]+", name.lower()) if word}


def nearest(name: str, known: Iterable[str], least: float = VAGUE) -> str | None:
    """Known name that is most similar to a misspelt one; letter case is ignored; None if none is similar.

    ``least`` : smallest share of common letters, `VAGUE` or `CLOSE`
    """
    names = {name.lower(): name for name in known}
    matches = difflib.get_close_matches(name.lower(), names, n=1, cutoff=least)
    return names[matches[0]] if matches else None


def shown(value: object, longest: int = 60) -> str:
    """``repr`` of a value, shortened in depth and length for a message."""
    short = reprlib.Repr()
    short.maxlevel, short.maxstring, short.maxother = 2, longest, longest
    try:
        text = short.repr(value)
    except ValueError:  # Python refuses to print an integer of thousands of digits
        text = f"a number of {value.bit_length()} bits" if isinstance(value, int) else "a value without text"
    return text if len(text) <= longest else f"{text[: longest - 3]}..."
