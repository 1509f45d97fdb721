"""The one error family. Every error that reaches a user has the same five parts."""

from __future__ import annotations

import difflib
import reprlib
from collections.abc import Iterable, Mapping
from functools import partial
from typing import NotRequired, Protocol, Self, TypedDict, TypeVar, Unpack

from haptonic.names import visible

E = TypeVar("E", bound="HaptonicError")
C = TypeVar("C", bound="HaptonicError", covariant=True)


class Parts(TypedDict):
    """What every error says; see `HaptonicError`."""

    argument: str
    given: object
    allowed: str
    cause: str
    next_step: str
    command: NotRequired[str]


class _Made(Protocol[C]):
    def __call__(self, **parts: Unpack[Parts]) -> C: ...


class _Code:
    """A constructor of every kind of error, named after the code that it gives; ``says`` is for the docs."""

    def __init__(self, says: str) -> None:
        self.__doc__ = says

    def __set_name__(self, owner: type, name: str) -> None:
        self.code = name.replace("_", "-")

    def __get__(self, error: E | None, kind: type[E]) -> _Made[E]:
        return partial(kind, self.code)


class HaptonicError(Exception):
    """Something that the user can put right.

    It is raised by the constructor of its kind, ``StudyError.missing(argument=..., given=..., ...)``. That
    constructor's name is the error's ``code``, which stays the same while wording changes: programs and
    tests hang on the code and the argument. ``docs/errors.md`` lists all codes.

    Parameters
    ----------
    argument : which argument or key is concerned, with its path (``cell.pillar.diameter``)
    given : what was given
    allowed : what is allowed
    cause : the likely cause
    next_step : what to do now
    command : the next step for users of the command line, where it differs from that in Python

    Any of them may quote what a file holds, so control characters are written out in all.
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
        """The code and the five parts as a mapping, for ``--json`` and for tables."""
        names = ("code", "argument", "given", "allowed", "cause", "next_step")
        return {name: getattr(self, name) for name in names}

    def for_command(self) -> Self:
        """The same error with the next step for users of the command line."""
        return self.changed(type(self), next_step=self.command)

    def changed(self, kind: type[E], /, **parts: str) -> E:
        """The same as an error of another kind, or with other parts."""
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
        known : the names; slip : whether the nearest of them may be meant
        allowed : in words, where that is more than one of the names
        next_step, command : where no name is near
        """
        names = list(known)
        guess = nearest(str(given), names) if slip else None
        return cls(
            "unknown",
            argument=argument,
            given=shown(given),
            allowed=allowed
            or (f"one of {', '.join(names)}" if names else "none: there is nothing to choose"),
            cause=cause,
            next_step=f'write "{guess}"' if guess else next_step,
            command="" if guess else command,
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
    mismatch = _Code("Data that belong to something else: another plate, scan or drive.")
    too_few = _Code("Too little data for an answer.")
    unsupported = _Code("A possible case that haptonic does not compute.")
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
    """Sizes that do not make a body."""


class ResponseError(HaptonicError):
    """A frequency response, or a file of one, cannot be used."""


class FrictionError(HaptonicError):
    """Trials, or the numbers of a model of friction, cannot be used."""


class ChannelError(HaptonicError):
    """A file of signals, or a channel in it, cannot be used."""


class ScanError(HaptonicError):
    """A scan file, or what it holds, cannot be used."""


class NumericalError(HaptonicError):
    """Numbers so far apart that rounding spoils what is computed from them."""


class ResourceError(HaptonicError):
    """The machine has too little memory, or a file cannot be read or written."""


class HaptonicWarning(UserWarning):
    """A value is allowed but so unusual that it is probably a slip."""


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name closest to a misspelt one, in whatever case; None when nothing is near."""
    names = {one.lower(): one for one in known}
    matches = difflib.get_close_matches(name.lower(), names, n=1, cutoff=0.5)
    return names[matches[0]] if matches else None


def shown(value: object, longest: int = 60) -> str:
    """``repr`` of anything, cut in depth and length to what suits a message."""
    short = reprlib.Repr()
    short.maxlevel, short.maxstring, short.maxother = 2, longest, longest
    try:
        text = short.repr(value)
    except ValueError:  # an integer of thousands of digits: Python refuses to print it
        text = f"a number of {value.bit_length()} bits" if isinstance(value, int) else "a value without text"
    return text if len(text) <= longest else f"{text[: longest - 3]}..."
