"""Cache of recently used values with a bounded total size."""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Kept(Generic[Value]):
    """Cache of the most recently used values by key. A value larger than ``most`` alone is not stored.

    Values may belong to groups. The last value of each group leaves only when no other is left, so that many
    values of one group, such as the coarse meshes of a preview, do not remove the one of another.

    size : function that measures a value; most : largest sum of the sizes of all stored values
    """

    def __init__(self, most: float, size: Callable[[Value], float]) -> None:
        self._most, self._size = most, size
        self._values: OrderedDict[Hashable, Value] = OrderedDict()
        self._groups: dict[Hashable, Hashable] = {}  # by key
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._values)

    def of(self, key: Hashable, make: Callable[[], Value], group: Hashable = None) -> Value:
        """Return the stored value, or make it; two threads may make the same value at the same time."""
        with self._lock:
            if key in self._values:
                self._values.move_to_end(key)
                return self._values[key]
        value = make()
        if self._size(value) > self._most:
            return value
        with self._lock:
            self._values[key], self._groups[key] = value, group
            while sum(map(self._size, self._values.values())) > self._most:
                oldest = self._dispensable()
                del self._values[oldest], self._groups[oldest]
        return value

    def _dispensable(self) -> Hashable:
        """The least recently used key whose group has another; without one, the least recently used."""
        counts = Counter(self._groups.values())
        oldest = next(iter(self._values))
        return next((key for key in self._values if counts[self._groups[key]] > 1), oldest)

    def clear(self) -> None:
        """Remove all values."""
        with self._lock:
            self._values.clear()
            self._groups.clear()
