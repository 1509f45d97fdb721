"""Types of arrays by their contents; docstrings give the shapes."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Complex = NDArray[np.complex128]
AnyComplex = NDArray[np.complexfloating[Any, Any]]  # of single or double precision
Fields = NDArray[Any]  # real or complex
