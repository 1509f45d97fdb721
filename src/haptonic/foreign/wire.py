"""Transfer between the two processes: JSON, and the bytes of its arrays. Nothing in it is executed."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

LENGTH = 8  # bytes of the length before the JSON


def send(stream: IO[bytes], content: object) -> None:
    """Write texts, numbers, lists, dicts and arrays of numbers to an unbuffered stream.

    Each array is released after it is written, so that both processes together contain it about once.
    """
    arrays: list[NDArray[Any]] = []
    text = json.dumps(_packed(content, arrays)).encode()
    del content
    _write(stream, memoryview(len(text).to_bytes(LENGTH, "little") + text))
    arrays.reverse()
    while arrays:
        _write(stream, _flat(arrays.pop()).view(np.uint8).data)


def receive(stream: IO[bytes]) -> Any:
    """Read content that `send` wrote.

    Raises
    ------
    EOFError : the other process ended
    MemoryError : an array is too large for this process
    """
    length = int.from_bytes(_read(stream, bytearray(LENGTH)), "little")
    content = json.loads(_read(stream, bytearray(length)))

    def array(kind: str, shape: list[int], turned: bool) -> NDArray[Any]:
        numbers = np.empty(shape, np.dtype(kind))
        _read(stream, numbers.reshape(-1).view(np.uint8))
        return numbers.T if turned else numbers

    return _unpacked(content, array)


def _packed(value: Any, arrays: list[NDArray[Any]]) -> Any:
    """Encode a dict as {"d": pairs} and an array as {"a": form}; names in a file cannot imitate them."""
    if isinstance(value, dict):
        return {"d": [[name, _packed(item, arrays)] for name, item in value.items()]}
    if isinstance(value, list):
        return [_packed(item, arrays) for item in value]
    if isinstance(value, np.ndarray):
        assert value.dtype.kind in "fciub", value.dtype
        turned = value.flags.f_contiguous and not value.flags.c_contiguous
        arrays.append(value.T if turned else value)
        return {"a": [value.dtype.str, list(arrays[-1].shape), turned]}
    assert value is None or isinstance(value, str | int | float), type(value)
    return value


def _unpacked(value: Any, array: Callable[..., NDArray[Any]]) -> Any:
    if isinstance(value, list):
        return [_unpacked(item, array) for item in value]
    if not isinstance(value, dict):
        return value
    if "a" in value:
        return array(*value["a"])
    return {name: _unpacked(item, array) for name, item in value["d"]}


def _flat(array: NDArray[Any]) -> NDArray[Any]:
    return np.ascontiguousarray(array).reshape(-1)


def _write(stream: IO[bytes], content: memoryview) -> None:
    while content:
        content = content[stream.write(content) :]


def _read(stream: IO[bytes], into: Any) -> Any:
    view = memoryview(into)
    while view:
        count = stream.readinto(view)  # type: ignore[attr-defined]  # of an unbuffered stream
        if not count:
            raise EOFError
        view = view[count:]
    return into
