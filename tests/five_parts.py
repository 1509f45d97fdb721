"""What every refused command and every error has to say."""

from collections.abc import Callable

import pytest

from haptonic.errors import HaptonicError

PARTS = ("argument", "given", "allowed", "likely cause", "next step")


def assert_five_parts(ran, *words: str) -> None:
    """Exit code 2, five parts on standard error, and the words among them."""
    assert ran.code == 2, ran.err
    assert "Traceback" not in ran.err + ran.out
    for part in PARTS:
        assert part in ran.err, (part, ran.err)
    for word in words:
        assert word in ran.err, (word, ran.err)


def assert_told(error: HaptonicError, *words: str) -> None:
    """Five parts, none of them empty, and the words among them."""
    parts = error.parts()
    assert all(parts.values()), parts
    for word in words:
        assert word in str(error), (word, str(error))


def refused(
    call: Callable[[], object], *words: str, kind: type[HaptonicError] = HaptonicError
) -> HaptonicError:
    """The error of a call, of this kind, with five parts and the words among them."""
    with pytest.raises(kind) as caught:
        call()
    assert_told(caught.value, *words)
    return caught.value
