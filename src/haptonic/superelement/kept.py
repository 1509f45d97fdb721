"""Cache of recently used values with a bounded total size."""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Kept(Generic[Value]):
    """Cache of the most recently used values by key. A value larger than ``most`` alone is not stored.

    Values may belong to groups. The last value of a group is removed only if no group has two, so that many
    values of one group, such as coarse meshes of previews, do not remove that of another group.

    size : function that measures a value; most : largest sum of the sizes of all stored values
    """

    def __init__(self, most: float, size: Callable[[Value], float]) -> None:
        self._most, self._size = most, size
        self._values: OrderedDict[Hashable, tuple[Value, Hashable]] = OrderedDict()  # and their groups
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._values)

    def of(self, key: Hashable, make: Callable[[], Value], group: Hashable = None) -> Value:
        """Return the stored value, or make it; two threads may make the same value at the same time."""
        with self._lock:
            if key in self._values:
                self._values.move_to_end(key)
                return self._values[key][0]
        value = make()
        if self._size(value) > self._most:
            return value
        with self._lock:
            self._values[key] = value, group
            while sum(self._size(stored) for stored, _ in self._values.values()) > self._most:
                del self._values[self._dispensable()]
        return value

    def _dispensable(self) -> Hashable:
        """Key of the least recently used value whose group has another; without one, of the oldest value."""
        sizes = Counter(group for _, group in self._values.values())
        oldest = next(iter(self._values))
        return next((key for key, (_, group) in self._values.items() if sizes[group] > 1), oldest)

    def clear(self) -> None:
        """Remove all values."""
        with self._lock:
            self._values.clear()
