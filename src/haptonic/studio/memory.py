"""Memory of the processes that run for hours: the server and its worker."""

from __future__ import annotations

import ctypes
import sys

M_ARENA_MAX = -8  # number of this setting in glibc's malloc.h


def share_one_arena() -> None:
    """Let all threads of this process allocate from one arena, before the first of them begins.

    The GNU allocator otherwise gives each thread an arena of its own, whose free memory no other thread uses:
    a server whose threads come and go grows by megabytes in an hour. Other allocators stay as they are.
    """
    if (allocator := _allocator()) is not None:
        allocator.mallopt(M_ARENA_MAX, 1)


def give_back() -> None:
    """Return the free memory of the GNU allocator to the system."""
    if (allocator := _allocator()) is not None:
        allocator.malloc_trim(0)


def _allocator() -> ctypes.CDLL | None:
    if not sys.platform.startswith("linux"):
        return None
    library = ctypes.CDLL(None)
    return library if hasattr(library, "malloc_trim") and hasattr(library, "mallopt") else None
