"""Claim: a search ends at a design at least as good as the best of a scan of its bounds, wherever it starts.

Twenty briefs are drawn: material, pitch, carrier, what may vary and how far, slenderness, and the design that
the search starts from. The scan is a grid over the bounds in the coarse model; its best design is computed at
the accuracy of the search before the two are compared.
"""

from __future__ import annotations

import argparse
import itertools
import json
import tempfile
import time
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from record import write

from haptonic.analyses.designing.search import compute_design
from haptonic.analyses.runner import Runner
from haptonic.atomic import write_atomically
from haptonic.bloch import Gap
from haptonic.bloch.settings import BandSettings
from haptonic.cell import Pillar, UnitCell
from haptonic.design.brief import Brief
from haptonic.design.quick import edges_of
from haptonic.design.settings import DesignLimits, DesignSettings
from haptonic.errors import HaptonicError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.store import Store

MATERIALS = ("aluminium-paper", "soda-lime-glass", "borosilicate-glass", "brass", "steel")
HEIGHT = "cell.pillar.height"
# lines of the scan: along the height, which costs least and counts most, and along each other parameter
HEIGHTS, OTHERS = 10, {1: 6, 2: 4, 3: 2}
COUNT, ACCURACY = 10, 1e-2
CONFIRMED = 3  # best designs of the scan that are tried at that accuracy until one holds the carrier
TOLERANCE = 2e-3  # of the carrier, by which the search may stay below the scan


def drawn(count: int, seed: int) -> list[Brief]:
    """Briefs whose carrier, as a phase of the shear wave over a pitch, lies where pillars have their gaps."""
    rng, briefs = np.random.default_rng(seed), list[Brief]()
    while len(briefs) < count:
        stuff = material(str(rng.choice(MATERIALS)))
        assert isinstance(stuff, IsotropicMaterial)
        pitch = float(np.exp(rng.uniform(np.log(3e-3), np.log(10e-3))))
        shear = np.sqrt(stuff.youngs_modulus / (2 * (1 + stuff.poisson_ratio) * stuff.density))
        carrier = float(np.exp(rng.uniform(np.log(0.03), np.log(0.2)))) * shear / pitch
        bounds = {
            "cell.pillar.diameter": (rng.uniform(0.2, 0.45) * pitch, rng.uniform(0.6, 0.92) * pitch),
            HEIGHT: (rng.uniform(0.5, 1.5) * pitch, rng.uniform(2.5, 7.0) * pitch),
        }
        thickness = float(rng.uniform(0.1, 0.35)) * pitch
        if rng.random() < 0.55:
            bounds["cell.thickness"] = (rng.uniform(0.08, 0.15) * pitch, rng.uniform(0.25, 0.45) * pitch)
        if rng.random() < 0.2:
            bounds["cell.pitch"] = (rng.uniform(0.6, 0.8) * pitch, rng.uniform(1.2, 1.5) * pitch)
        slenderness = float(rng.uniform(3.0, 16.0)) if rng.random() < 0.8 else None
        own = UnitCell(Lattice.square(pitch), thickness, stuff, Pillar(0.5 * pitch, 2.0 * pitch))
        bounds = {path: (float(low), float(high)) for path, (low, high) in bounds.items()}
        brief = Brief(own, carrier, COUNT, bounds, DesignLimits(slenderness=slenderness))
        start = brief.feasible(rng.random(len(bounds)))
        if brief.allows(start):
            briefs.append(
                Brief(brief.at(start), carrier, COUNT, bounds, DesignLimits(slenderness=slenderness))
            )
    return briefs


def scanned(brief: Brief) -> list[tuple[float, int, list[float]]]:
    """Margin (of the carrier), band below the gap and values of the designs of a grid, the best first."""
    lines = OTHERS[len(brief.paths) - 1]
    # heights last, so that neighbours share a foot
    paths = sorted(brief.paths, key=lambda path: path == HEIGHT)
    axes = [np.linspace(0.0, 1.0, HEIGHTS if path == HEIGHT else lines) for path in paths]
    designs = []
    for place in itertools.product(*axes):
        share = np.array([place[paths.index(path)] for path in brief.paths])
        if brief.allows(share):
            lower, upper = edges_of(brief.at(share), brief.count)
            margins = np.minimum(brief.carrier - lower, upper - brief.carrier) / brief.carrier
            best = int(np.where(upper > lower, margins, -np.inf).argmax())
            if upper[best] > lower[best]:
                designs.append((float(margins[best]), best + 1, brief.values(share)))
    return sorted(designs, reverse=True)


def confirmed(brief: Brief, designs: list[tuple[float, int, list[float]]], runner: Runner) -> float | None:
    """Margin (of the carrier) of the scan's best at the accuracy of the search; None if nothing holds it."""
    for margin, _, values in designs[:CONFIRMED]:
        if margin <= 0:
            return None
        try:
            gaps = runner.gaps(brief.cell.with_numbers(dict(zip(brief.paths, values, strict=True))), ASKED)
        except HaptonicError:
            continue
        held = [margin_of(gap, brief.carrier) for gap in gaps if gap.complete]
        if held and max(held) > 0:
            return max(held) / brief.carrier
    return None


def margin_of(gap: Gap, carrier: float) -> float:
    """Distance of the carrier from the nearer edge, Hz, errors counted."""
    return min(carrier - gap.lower - gap.lower_error, gap.upper - gap.upper_error - carrier)


ASKED = BandSettings(COUNT, 8, ACCURACY)


def searched(brief: Brief, runner: Runner) -> dict[str, Any]:
    """What the search finds with a study's own settings, or why it does not."""
    section, start = DesignSettings(), time.process_time()
    try:
        design = compute_design(
            brief, ASKED, starts=section.starts, climbs=section.climbs, steps=section.steps, inputs={},
            runner=runner,
        )  # fmt: skip
    except HaptonicError as refusal:
        return {"margin": None, "cause": refusal.cause, "cpu_s": time.process_time() - start}
    return {
        "margin": design.margin / brief.carrier,
        "values": design.values,
        "designs": int(design.dataset.sizes["visit"]),
        "cpu_s": time.process_time() - start,
    }


def compared(brief: Brief) -> dict[str, Any]:
    """Search and scan of a brief, nothing having been computed before."""
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(Store(Path(folder)))
        search = searched(brief, runner)
        start = time.process_time()
        designs = scanned(brief)
        best = confirmed(brief, designs, runner)
    return {
        "carrier_hz": brief.carrier,
        "material": brief.cell.material.name,
        "varied": len(brief.paths),
        "slenderness": brief.allowed.slenderness,
        "scan": {"designs": len(designs), "margin": best, "cpu_s": time.process_time() - start},
        "search": search,
        "as_good": best is None or bool((search["margin"] or -1.0) >= best - TOLERANCE),
    }


def main(count: int, seed: int, parts: Path) -> None:
    """Each brief has a file among the parts; what a run that was ended has left there is not run again."""
    parts.mkdir(parents=True, exist_ok=True)
    rows = []
    for number, brief in enumerate(drawn(count, seed)):
        part = parts / f"{seed}-{number}.json"
        if not part.exists():
            row = json.dumps(compared(brief))
            write_atomically(part, partial(Path.write_text, data=row, encoding="utf-8"))
        rows.append(json.loads(part.read_text("utf-8")))
        print(number + 1, rows[-1], flush=True)
    write("search_finds_what_is_there", {"seed": seed, "tolerance": TOLERANCE, "briefs": rows})


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--briefs", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--parts", type=Path, help="folder that keeps what was done, for a run that goes on")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        main(arguments.briefs, arguments.seed, arguments.parts or Path(folder))
