"""Claim: the error printed with a frequency is never below the true one, and seldom far above it.

Cells are drawn over all that a study can describe (``tests/core/truth.py``): each is asked as a user would,
for some bands at some accuracy, and compared with frequencies found by another route. Every design is a line
of a CSV file, so a run that was stopped goes on where it ended; another ``--seed`` draws other designs.
"""

from __future__ import annotations

import argparse
import csv
import resource
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from record import ROOT, write
from threadpoolctl import threadpool_limits

sys.path.insert(0, str(ROOT / "tests" / "core"))
from truth import (
    KINDS,
    STOUT_FROM,
    TILES,
    TILES_FROM,
    Drawn,
    Truth,
    drawn,
    estimated_seconds,
    truth,
    wavevectors,
)

from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.mesh_levels import MeshLimits, first_level, started
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.truncation import REST
from haptonic.errors import HaptonicError

Array = NDArray[np.float64]

FOLDER = ROOT / "results" / "estimates_hold"
REFERENCE_LIMIT = 1500.0  # s of the processor
AT_ONCE = 2.0  # s of the processor that a refusal may take
CLASSES = (*dict.fromkeys(KINDS), "stout", *TILES)


@dataclass
class Row:
    """One design: what was asked, what came out; errors are relative, seconds are the processor's.

    reached : largest error estimate of the model over the zone; above the accuracy where no mesh reached it
    unsure : largest uncertainty of a reference, as a share of the estimate that it judges
    unjudged : frequencies of which the reference is less sure than the estimate; the ratios leave them out
    """

    seed: int
    number: int
    kind: str
    count: int
    accuracy: float
    outcome: str = "answered"
    resolution: str = ""
    seconds: float = 0.0
    reference_seconds: float = 0.0
    reached: float = float("nan")
    frequencies: int = 0
    below: int = 0
    least_ratio: float = float("nan")
    median_ratio: float = float("nan")
    largest_error: float = float("nan")
    largest_estimate: float = float("nan")
    unsure: float = float("nan")
    unjudged: int = 0
    route: str = ""


@dataclass
class Answer:
    """Answer of the product: frequency, error (wavevectors, bands), Hz, its mesh; or why none. See `Row`."""

    seconds: float
    frequency: Array | None = None
    error: Array | None = None
    mesh: str = ""
    reached: float = float("nan")
    refusal: str = ""


def answered(question: Drawn) -> Answer:
    start = time.process_time()
    try:
        with threadpool_limits(1):
            asked = BandSettings(question.count, accuracy=question.accuracy)
            model = bloch_model(question.cell, asked)
            solutions = [model.solve(kappa) for kappa in wavevectors(question.cell)]
    except HaptonicError as refusal:
        return Answer(time.process_time() - start, refusal=f"{refusal.argument}: {refusal.cause}")
    used = model.resolution
    mesh = f"order {used.order}, {used.foot_rings} rings, {used.steps} x {used.block}"
    frequency, error = (np.array([getattr(s, name) for s in solutions]) for name in ("frequency", "error"))
    return Answer(time.process_time() - start, frequency, error, mesh, model.worst_error)


def compare(row: Row, frequency: Array, error: Array, exact: Truth) -> None:
    """Fill the row in."""
    moving = exact.frequency > 2 * REST * exact.frequency.max()
    true, unsure = np.abs(frequency - exact.frequency)[moving], exact.uncertainty[moving]
    error, yardstick = error[moving], exact.frequency[moving]
    sure = unsure < error
    ratio = (error / np.maximum(true, unsure))[sure]
    row.unjudged = int((~sure).sum())
    row.route, row.frequencies, row.unsure = exact.route, true.size, float((unsure / error).max())
    row.below = int((error < true - unsure).sum())
    row.least_ratio, row.median_ratio = float(ratio.min()), float(np.median(ratio))
    row.largest_error, row.largest_estimate = (
        float((true / yardstick).max()),
        float((error / yardstick).max()),
    )


def found_truth(question: Drawn) -> tuple[Truth | None, float]:
    start = time.process_time()
    with threadpool_limits(1):
        return truth(question), time.process_time() - start


def reference(question: Drawn, kept: Path) -> tuple[Truth | None, float]:
    """The truth of a question, computed once, and the seconds of the processor that it took.

    That there is none is kept as well, so that what no mesh fits is not tried at every run.
    """
    if not kept.exists():
        exact, seconds = within(REFERENCE_LIMIT, found_truth, question) or (None, REFERENCE_LIMIT)
        lacking = Truth(np.empty((0, 0)), np.empty((0, 0)), "none")
        np.savez(kept, **asdict(exact or lacking), seconds=seconds)
    with np.load(kept) as stored:
        exact = Truth(stored["frequency"], stored["uncertainty"], str(stored["route"]))
        return exact if exact.frequency.size else None, float(stored["seconds"])


def _sent(pipe: Connection, limit: int, work: Callable[..., Any], *given: Any) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    pipe.send(work(*given))


def within(limit: float, work: Callable[..., Any], *given: Any) -> Any:
    """What ``work`` returns, from a process of its own; None if it died or took more than ``limit`` seconds.

    They are the processor's: a busy machine changes no outcome.
    """
    context = get_context("spawn")
    here, there = context.Pipe(duplex=False)
    worker = context.Process(target=_sent, args=(there, int(limit), work, *given), daemon=True)
    worker.start()
    there.close()
    try:
        result = here.recv()
    except EOFError:
        result = None
    worker.join()
    return result


def read(path: Path) -> list[Row]:
    if not path.exists():
        return []
    kinds = {field.name: {"int": int, "float": float}.get(str(field.type), str) for field in fields(Row)}
    with path.open(encoding="utf-8", newline="") as file:
        return [
            Row(**{name: kinds[name](text) for name, text in line.items()}) for line in csv.DictReader(file)
        ]


def append(path: Path, row: Row) -> None:
    new = not path.exists()
    with path.open("a", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [field.name for field in fields(Row)])
        if new:
            writer.writeheader()
        writer.writerow(asdict(row))


def at_once(row: Row) -> bool:
    return row.outcome.startswith("refused") and row.seconds < AT_ONCE


def of_class(rows: list[Row], name: str) -> dict[str, Any]:
    """The figures of one class; a design's median ratio represents its frequencies."""
    good = [row for row in rows if row.frequencies]
    ratios = [row.median_ratio for row in good]
    return {
        "class": name,
        "designs": len(rows),
        "answered": len(good),
        "refused": sum(row.outcome.startswith("refused") for row in rows),
        "too_long": sum(row.outcome.startswith("longer") for row in rows),
        "no_reference": sum(row.outcome.startswith("no reference") for row in rows),
        "frequencies": sum(row.frequencies for row in good),
        "unjudged": sum(row.unjudged for row in good),
        "below_true": sum(row.below for row in good),
        "least_ratio": min((row.least_ratio for row in good), default=None),
        "median_ratio": float(np.median(ratios)) if ratios else None,
        "short_of_accuracy": sum(row.reached > row.accuracy for row in good),
        "beyond_accuracy": sum(row.largest_error > row.accuracy >= row.reached for row in good),
        "median_seconds": float(np.median([row.seconds for row in good])) if good else None,
        "median_reference_seconds": float(np.median([row.reference_seconds for row in good]))
        if good
        else None,
        "median_unsure": float(np.median([row.unsure for row in good])) if good else None,
    }


def kept(seed: int, number: int) -> Path:
    """Where the reference of a design is kept."""
    return FOLDER / f"{seed}-{number}.npz"


def row_of(seed: int, number: int, limit: float) -> Row:
    """One design asked and judged."""
    question = drawn(seed, number)
    row = Row(seed, number, question.kind, question.count, question.accuracy)
    answer = within(limit, answered, question)
    if answer is None:
        row.outcome = f"longer than {limit:g} s, or out of memory"
        return row
    row.seconds, row.resolution, row.reached = answer.seconds, answer.mesh, answer.reached
    if answer.refusal:
        row.outcome = f"refused: {answer.refusal}"
        return row
    exact, row.reference_seconds = reference(question, kept(seed, number))
    if exact is None:
        row.outcome = "no reference: too large, or longer than it may take"
        return row
    compare(row, answer.frequency, answer.error, exact)
    return row


def _limits() -> MeshLimits:
    return MeshLimits.of(BandSettings().budget)


def numbers(count: int, stout: int, tiles: int, seed: int) -> list[int]:
    """Numbers of the designs, those first that are estimated to take least: a run may be stopped."""

    def seconds(number: int) -> float:
        question = drawn(seed, number)
        if refused_at_once(question):
            return 0.0
        tried = started(question.cell, question.count, question.accuracy, _limits())
        return float(estimated_seconds(question) + sum(level.seconds(question.cell) for level in tried))

    blocks = ((0, count), (STOUT_FROM, stout), (TILES_FROM, tiles))
    return sorted((first + n for first, length in blocks for n in range(length)), key=seconds)


def references(count: int, stout: int, tiles: int, seed: int) -> None:
    """Compute and keep what answers are judged by, of all designs that are not refused at once."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for number in numbers(count, stout, tiles, seed):
        question = drawn(seed, number)
        if refused_at_once(question):
            continue
        exact, seconds = reference(question, kept(seed, number))
        route = "none" if exact is None else exact.route
        print(
            f"{number} {question.kind} {question.count} {question.accuracy:g}: {route}, {seconds:.0f} s",
            flush=True,
        )


def refused_at_once(question: Drawn) -> bool:
    try:
        first_level(question.cell, question.count, question.accuracy, _limits())
    except HaptonicError:
        return True
    return False


def main(
    count: int,
    stout: int,
    tiles: int,
    seed: int,
    limit: float,
    stored: bool,
    part: tuple[int, int],
    remark: str,
) -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / "designs.csv"
    done = {(row.seed, row.number) for row in read(path)}
    not_run: list[int] = []
    for number in numbers(count, stout, tiles, seed)[part[0] - 1 :: part[1]]:
        if (seed, number) in done:
            continue
        if stored and not kept(seed, number).exists() and not refused_at_once(drawn(seed, number)):
            not_run.append(number)
            continue
        row = row_of(seed, number, limit)
        append(path, row)
        print(
            f"{number} {row.kind} {row.count} {row.accuracy:g}: {row.outcome}, {row.below} below, ratio "
            f"{row.least_ratio:.2f} {row.median_ratio:.1f}, error {row.largest_error:.1e} of "
            f"{row.largest_estimate:.1e}, {row.resolution}, {row.seconds:.0f} s; {row.route}, unsure "
            f"{row.unsure:.2f}, {row.reference_seconds:.0f} s",
            flush=True,
        )
    # runs of several seeds make one record of the cells with tiles of all kinds
    rows = [row for row in read(path) if row.seed == seed or (not count and row.kind in TILES)]
    seeds = sorted({row.seed for row in rows})
    classes = [of_class([row for row in rows if row.kind == kind], kind) for kind in CLASSES]
    classes = [figures for figures in classes if figures["designs"]]
    reasons = [
        f"{row.seed}-{row.number} ({row.kind}, {row.count} bands at {row.accuracy:g}), {row.seconds:.0f} s: "
        + row.outcome
        for row in rows
        if not row.frequencies and not at_once(row)
    ]
    write(
        "estimates_hold" if count else "estimates_hold_tiles",
        {
            "seed": ", ".join(str(number) for number in seeds),
            "limit_s": limit,
            "drawn": (count + stout + tiles) * len(seeds),
            "not_run": sorted(not_run),
            "refused_at_once": sum(at_once(row) for row in rows),
            "rows": [*classes, of_class(rows, "all")],
            "not_answered": reasons,
            "remark": remark,
        },
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--designs", type=int, default=120, help="of all classes by turns")
    parser.add_argument("--stout", type=int, default=20, help="stout pillars on thin plates beside them")
    parser.add_argument(
        "--tiles",
        type=int,
        default=0,
        help="cells of six and three sides, both faces, two sites, draft with fillet; with --designs 0 they "
        "have a record of their own",
    )
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument(
        "--limit", type=float, default=90.0, help="seconds of the processor that a design gets"
    )
    parser.add_argument("--remark", default="", help="what a reader of the record has to know")
    parser.add_argument(
        "--references", action="store_true", help="only compute what answers are judged by, and keep it"
    )
    parser.add_argument(
        "--stored", action="store_true", help="leave out designs that have no reference yet, and name them"
    )
    parser.add_argument(
        "--part",
        type=int,
        nargs=2,
        default=(1, 1),
        help="K N: of every N designs the K-th, so that N runs share them",
    )
    given = parser.parse_args()
    if given.references:
        references(given.designs, given.stout, given.tiles, given.seed)
    else:
        main(
            given.designs,
            given.stout,
            given.tiles,
            given.seed,
            given.limit,
            given.stored,
            given.part,
            given.remark,
        )
