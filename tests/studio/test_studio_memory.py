"""Memory of the processes that run for hours."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only glibc's allocator is set")

# number of glibc's arenas after work of eight threads at the same time
ARENAS = """
import ctypes, os, tempfile, threading
from haptonic.studio.memory import share_one_arena
libc = ctypes.CDLL(None)
libc.fdopen.restype = ctypes.c_void_p
{begin}
together = threading.Barrier(8)
def work():
    together.wait()
    for _ in range(1000):
        libc.malloc(1000)
    together.wait()
threads = [threading.Thread(target=work) for _ in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
with tempfile.TemporaryFile() as file:
    stream = ctypes.c_void_p(libc.fdopen(os.dup(file.fileno()), b"w"))
    libc.malloc_info(0, stream)
    libc.fclose(stream)
    file.seek(0)
    print(file.read().count(b"<heap nr"))
"""

# megabytes of this process while 200 MB are allocated, after they are freed, and after they are given back
FREED = """
import ctypes, psutil
from haptonic.studio.memory import give_back
libc = ctypes.CDLL(None)
libc.malloc.restype, libc.free.argtypes = ctypes.c_void_p, [ctypes.c_void_p]
def megabytes():
    return round(psutil.Process().memory_info().rss / 1e6)
pieces = [libc.malloc(100_000) for _ in range(2000)]
for piece in pieces:
    ctypes.memset(piece, 1, 100_000)
print(megabytes())
for piece in pieces[:-1]:
    libc.free(piece)
print(megabytes())
give_back()
print(megabytes())
"""


def printed(program: str) -> list[int]:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return [int(word) for word in done.stdout.split()]


def test_threads_of_the_studio_share_one_arena():
    assert printed(ARENAS.format(begin="share_one_arena()")) == [1]
    assert printed(ARENAS.format(begin=""))[0] > 1


def test_free_memory_is_given_back():
    full, freed, given_back = printed(FREED)
    assert freed > full - 20
    assert given_back < full - 180
