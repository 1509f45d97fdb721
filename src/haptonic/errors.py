"""The one error family. Every error that reaches a user has the same five parts."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from haptonic.names import visible


class HaptonicError(Exception):
    """Something that the user can put right.

    Parameters
    ----------
    argument : which argument or key is concerned, with its path (``cell.pillar.diameter``)
    given : what was given
    allowed : what is allowed
    cause : the likely cause
    next_step : what to do now

    Any of them may quote what a file holds, so control characters are written out in all.
    """

    def __init__(self, *, argument: str, given: object, allowed: str, cause: str, next_step: str) -> None:
        self.argument = argument = visible(argument)
        self.given = visible(str(given))
        self.allowed = allowed = visible(allowed)
        self.cause = cause = visible(cause)
        self.next_step = next_step = visible(next_step)
        super().__init__(
            f"{argument}: got {self.given}\n"
            f"  allowed: {allowed}\n  likely cause: {cause}\n  next step: {next_step}"
        )

    def parts(self) -> dict[str, str]:
        """The five parts as a mapping, for ``--json`` and for tables."""
        return {
            "argument": self.argument,
            "given": self.given,
            "allowed": self.allowed,
            "cause": self.cause,
            "next_step": self.next_step,
        }

    def __reduce__(self) -> tuple[object, ...]:
        # Exceptions with keyword-only arguments do not pickle by default; workers send them back.
        return (_rebuilt, (type(self), self.parts()))


def _rebuilt(kind: type[HaptonicError], parts: dict[str, str]) -> HaptonicError:
    return kind(**parts)


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
    """The known name closest to a misspelt one, or None when nothing is near."""
    matches = difflib.get_close_matches(name, list(known), n=1, cutoff=0.5)
    return matches[0] if matches else None
