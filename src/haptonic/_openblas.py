"""A name for the processor that OpenBLAS does not know.

NumPy and SciPy bring an OpenBLAS that takes AMD's Zen 5 for Intel's Haswell, at 0.6 of the speed that its
kernels with AVX-512 reach there. It is mended upstream (OpenMathLib/OpenBLAS, pull request 6033 of
September 2026); until the wheels have it, the kernels are named here before NumPy loads them.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

CPUINFO = Path("/proc/cpuinfo")  # of Linux; elsewhere nothing is done
ENOUGH = 8192  # bytes that hold the first core's entry
NEEDED = {f"avx512{part}" for part in ("f", "bw", "cd", "dq", "vl")}


def name_the_kernels() -> None:
    """Set ``OPENBLAS_CORETYPE`` on a Zen 5, unless it is set or NumPy has been loaded before."""
    if "numpy" in sys.modules or "OPENBLAS_CORETYPE" in os.environ or not CPUINFO.exists():
        return
    with CPUINFO.open() as file:
        first = file.read(ENOUGH).split("\n\n")[0]
    core = dict(line.split(":", 1) for line in first.splitlines() if ":" in line)
    told = {key.strip(): value.split() for key, value in core.items()}
    is_zen5 = told.get("vendor_id") == ["AuthenticAMD"] and told.get("cpu family") == ["26"]
    if is_zen5 and set(told.get("flags", [])) >= NEEDED:
        os.environ["OPENBLAS_CORETYPE"] = "SkylakeX"
