"""What was made last waits for who asks for the same again, up to a size in all."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Kept(Generic[Value]):
    """Values by key, those asked for last; one that alone is larger than ``most`` does not wait.

    size : of a value; most : of all that wait, in the same measure
    """

    def __init__(self, most: float, size: Callable[[Value], float]) -> None:
        self._most, self._size = most, size
        self._waiting: OrderedDict[Hashable, Value] = OrderedDict()
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._waiting)

    def of(self, key: Hashable, make: Callable[[], Value]) -> Value:
        """The value that waits, or one that is made; two threads may make the same at a time."""
        with self._lock:
            if key in self._waiting:
                self._waiting.move_to_end(key)
                return self._waiting[key]
        made = make()
        if self._size(made) > self._most:
            return made
        with self._lock:
            self._waiting[key] = made
            while sum(map(self._size, self._waiting.values())) > self._most:
                self._waiting.popitem(last=False)
        return made

    def clear(self) -> None:
        """Let go of all."""
        with self._lock:
            self._waiting.clear()
