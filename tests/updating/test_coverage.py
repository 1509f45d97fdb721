"""The claim of benchmarks/fit_covers_the_truth.py, for a few scans."""

import runpy
from pathlib import Path

import numpy as np
import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.mark.nightly
def test_a_fit_to_a_noisy_scan_covers_the_truth(monkeypatch):
    """Ten intervals of twelve: fewer come by chance once in fifty."""
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    bench = runpy.run_path(str(BENCHMARKS / "fit_covers_the_truth.py"))["Bench"]()
    hits = 0
    for seed in (100, 101, 102):
        fit, true, spoiled = bench.fit(seed)
        assert set(spoiled) <= set(fit.left_out.tolist())
        assert len(fit.left_out) <= 3
        ends = np.array([number.interval_95 for number in fit.numbers])
        hits += int(((ends[:, 0] <= true) & (true <= ends[:, 1])).sum())
    assert hits >= 10
