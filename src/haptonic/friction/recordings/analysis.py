"""Stream of the trials of an experiment: read file by file and measured; only a row of each is stored."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from itertools import chain, islice
from pathlib import Path
from typing import Annotated, Any, NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.channels import Group, SignalFile, opened
from haptonic.errors import ChannelError, FrictionError, HaptonicError, ResourceError
from haptonic.fields import Name, described, needed, problem, setting
from haptonic.friction.recordings.channel_map import ChannelMap
from haptonic.friction.recordings.findings import doubts_of, explained, mounted, remarked
from haptonic.friction.recordings.sensor import Sensor
from haptonic.friction.recordings.trial_table import RecordSpan, TrialTable
from haptonic.friction.signals.clock import Clock
from haptonic.friction.signals.limits import RangeEnds
from haptonic.friction.signals.measuring import Columns, channels_of, marked, measure_part, processed
from haptonic.friction.signals.record import Label, Record
from haptonic.friction.signals.rules import DECLARED, OMISSIONS, REMEDIES, UNREADABLE, Measured, Rules
from haptonic.friction.signals.tables import LABEL, LEFT_OUT, read_columns, read_records, read_trials
from haptonic.friction.signals.trials import joined, measured, tabulated
from haptonic.later import xarray as xr
from haptonic.parallel import finished
from haptonic.progress import Progress, silent

Portion = list[tuple[str, list[RecordSpan]]]

TRIED = 20  # files that are searched for channels of the expected names
PRESSED = 8  # trials of each participant from which the orientation of the sensor is estimated
NO_FILE = "the table names no file in this folder, or no start and stop in a file of several trials"
POINTS = 80  # of a small curve


@described("trials.exclude", FrictionError)
class Exclusion:
    """Trials that do not count, declared before the data are seen."""

    participant: Name = needed("Name of the participant in the table of trials.", examples=["P3"])
    reason: Annotated[str, Field(min_length=1, max_length=200, strict=True)] = needed(
        "Text beside the trial in every table.", examples=["lifted the finger"]
    )
    block: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = setting(
        None, "Block to exclude; by default all blocks."
    )
    trial: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = setting(
        None, "Trial of the block; by default all its trials."
    )

    def __post_init__(self) -> None:
        if self.trial is not None and self.block is None:
            raise problem(
                "missing",
                f"trial {self.trial} of no block",
                "the block as well",
                "trials count within a block",
                "add block = 1",
                at="block",
            )


@dataclass(frozen=True, eq=False)
class Analysed:
    """The table of trials, see `haptonic.friction.signals.measured`, and how the records were read.

    ``trials`` has ``detail`` beside ``excluded``: the file and its fault, or the declared reason.

    remarks : guesses about the sensor
    doubts : possible faults, and changes of the records
    """

    trials: xr.Dataset
    remarks: tuple[str, ...]
    doubts: tuple[str, ...] = ()


class _Read(NamedTuple):
    span: RecordSpan
    record: Record | None
    detail: str
    simulated: bool


def analysed(
    source: Path,
    sensor: Sensor,
    rules: Rules,
    excluded: Sequence[Exclusion] = (),
    *,
    workers: int = 0,
    progress: Progress = silent,
) -> Analysed:
    """Analyse all trials of a folder with a table of trials, or of a single table.

    Unreadable trials are left out and reported. Memory is that of a few files and a row for each trial.

    Parameters
    ----------
    source : a folder with ``trials.csv``; or a file of all samples, or of trials that were measured elsewhere
    workers : processes; 0 uses this process
    progress : function of the number of trials done and their total

    Raises
    ------
    ResourceError : no such file or folder
    FrictionError : an invalid table, an exclusion of a missing trial, or no trial left
    """
    if source.is_dir() or not source.suffix:
        trials, remarks, doubts = _from_folder(TrialTable.read(source), sensor, rules, workers, progress)
    else:
        (trials, doubts), remarks = _from_file(source, rules), ()
    if "detail" not in trials:
        trials["detail"] = ("stroke", np.full(trials.sizes["stroke"], ""))
    trials = explained(_declared(trials, excluded))
    _need_trials(trials)
    return Analysed(trials, remarks, (*doubts, *doubts_of(trials, sensor.normal)))


def traces(
    source: Path, sensor: Sensor, rules: Rules, blocks: Sequence[tuple[str, int]]
) -> Iterator[tuple[str, int, xr.Dataset]]:
    """Forces of every trial of some blocks (participant, number), for small curves.

    Yields
    ------
    participant, block, and along (``stroke``, ``point``): ``time`` (s), ``normal`` and ``tangential`` (N),
    ``steady``; along ``stroke``: ``trial``. Unreadable trials are missing.
    """
    if not (source.is_dir() or not source.suffix):
        return
    table = TrialTable.read(source)
    channel_map = channel_map_of(table, sensor)
    people, numbers = table.labels["participant"], table.labels["block"]
    for participant, block in blocks:
        rows = np.flatnonzero((people == participant) & (numbers == block)).tolist()
        reads = records_of(table.folder, channel_map, table.portion(rows), people)
        parts = {read.span.row: _trace(read.record, rules) for read in reads if read.record is not None}
        if parts:
            drawn = xr.concat(list(parts.values()), "stroke")
            yield participant, block, drawn.assign(trial=("stroke", table.labels["trial"][list(parts)]))


def _trace(record: Record, rules: Rules) -> xr.Dataset:
    """Some points of one record; unfiltered if it cannot be filtered."""
    count = len(record.normal)
    at = np.unique(np.linspace(0, count - 1, POINTS).round().astype(int)) if count else np.zeros(0, dtype=int)
    at = np.concatenate([at, np.full(POINTS - len(at), at[-1] if len(at) else 0)])
    channels = channels_of([record])
    curves = {"normal": channels[0, 0], "tangential": channels[1, 0], "steady": np.zeros(count, dtype=bool)}
    if np.isfinite(channels).all() and count > POINTS:
        stroke = processed(channels, record.rate, rules)
        curves = {"normal": stroke.normal[0], "tangential": stroke.tangential[0], "steady": stroke.steady[0]}
    curves["time"] = np.arange(count) / record.rate
    return xr.Dataset({name: ("point", curve[at]) for name, curve in curves.items()})


def _from_file(path: Path, rules: Rules) -> tuple[xr.Dataset, tuple[str, ...]]:
    columns = read_columns(path, LABEL)
    origin = "simulated" if "simulated" in {str(word) for word in columns.get("origin", ())} else "measured"
    if "friction" in columns:
        trials = read_trials(path)
        doubts = [str(text) for text in [trials.attrs.pop(LEFT_OUT, "")] if text]
        return trials.assign_attrs(origin=origin), tuple(doubts)
    seen: dict[str, None] = {}

    def records() -> Iterator[tuple[Label, Record]]:
        for label, record in read_records(path):
            seen.update(dict.fromkeys(record.remarks))
            yield label, record

    trials = measured(records(), rules)
    return trials.assign_attrs(origin=origin), tuple(seen)


def _from_folder(
    table: TrialTable, sensor: Sensor, rules: Rules, workers: int, progress: Progress
) -> tuple[xr.Dataset, tuple[str, ...], tuple[str, ...]]:
    channel_map = channel_map_of(table, sensor)
    total, done = len(table.files), 0
    order, parts, limits, simulated = [], [], [], table.simulated
    work = partial(_measured, table.folder, channel_map, rules, table.labels["participant"])
    # in processes, because most of the work is Python code that reads text
    for _, (rows, columns, ends, part_simulated) in finished(
        work, enumerate(table.portions()), workers, _lost
    ):
        order.append(rows)
        parts.append(columns)
        limits.append(ends)
        simulated |= part_simulated
        done += len(rows)
        progress(done, total)
    back = np.argsort(np.concatenate(order))
    every = marked(joined(parts), RangeEnds.joined(limits))
    remarks = every.pop("remarks")[back]
    columns = {name: column[back] for name, column in every.items()}
    origin = "simulated" if simulated else "measured"
    trials = tabulated({**table.labels, **table.carried}, columns, rules, origin=origin)
    return trials, channel_map.remarks, (
        *table.doubts,
        *channel_map.doubts, *remarked(remarks, table.labels["participant"]),
    )  # fmt: skip


def _lost(portion: Portion) -> NoReturn:
    raise ResourceError.worker(
        argument="worker process",
        given=f"died twice on {portion[0][0]} or a file after it",
        allowed="files that a worker can measure",
        cause="more memory needed than there is, or a crash inside a numerical library",
        next_step="run it again with fewer workers, or take this file out of the table",
    )


def _measured(
    folder: Path, channel_map: ChannelMap, rules: Rules, people: NDArray[Any], portion: Portion
) -> tuple[NDArray[np.int_], Columns, RangeEnds, bool]:
    """Rows of the table, their columns and limits, and True if any file is marked as simulated."""
    reads = list(records_of(folder, channel_map, portion, people))
    good = [i for i, read in enumerate(reads) if read.record is not None]
    numbers, ends = measure_part([read.record for read in reads if read.record is not None], rules)
    limits = RangeEnds.none(len(reads))
    limits.put(good, ends)
    empty = asdict(Measured(excluded=UNREADABLE))
    columns: Columns = {}
    for name, values in numbers.items():
        columns[name] = np.full(len(reads), empty[name], dtype=values.dtype)
        columns[name][good] = values
    columns["detail"] = np.array([read.detail for read in reads], dtype=object)
    remarks = np.empty(len(reads), dtype=object)
    remarks[:] = [read.record.remarks if read.record is not None else () for read in reads]
    columns["remarks"] = remarks
    simulated = any(read.simulated for read in reads)
    return np.array([read.span.row for read in reads]), columns, limits, simulated


def records_of(
    folder: Path, channel_map: ChannelMap, portion: Portion, people: NDArray[Any]
) -> Iterator[_Read]:
    """Every trial of a portion with its record, or with its fault. A file is opened once.

    people : (row of the table,) participants
    """
    for name, spans in portion:
        if not name:
            yield from (_Read(span, None, NO_FILE, False) for span in spans)
            continue
        left = list(spans)
        try:
            file = opened(folder / name)
            opened_groups: dict[str, tuple[Group, Clock]] = {}
            while left:
                person = str(people[left[0].row])
                yield _read(name, left[0], person, file, opened_groups, channel_map)
                left.pop(0)
        except HaptonicError as error:
            yield from (_Read(span, None, _why(name, error), False) for span in left)


def _read(
    name: str,
    span: RecordSpan,
    person: str,
    file: SignalFile,
    opened_groups: dict[str, tuple[Group, Clock]],
    channel_map: ChannelMap,
) -> _Read:
    simulated = False
    try:
        if span.group not in opened_groups:
            opened_groups.clear()  # groups come one after the other
            channels = file.group(span.group)
            simulated = channels.simulated
            opened_groups[span.group] = channels, channel_map.clock_in(channels)
        channels, clock = opened_groups[span.group]
        record = channel_map.record(channels, clock, span.start, span.stop, person)
    except HaptonicError as error:
        return _Read(span, None, _why(name, error), simulated)
    return _Read(span, record, "", channels.simulated)


def channel_map_of(table: TrialTable, sensor: Sensor) -> ChannelMap:
    """Map of the channels, from the first file that has all required ones.

    Raises
    ------
    HaptonicError : fault of the first file, if none of the first files has them
    """
    first: HaptonicError | None = None
    calibration = sensor.matrix(table.folder)
    for name, spans in islice(chain.from_iterable(table.portions()), TRIED):
        try:
            channels = opened(table.folder / name).group(spans[0].group)
            channel_map = sensor.channel_map(channels, calibration)
        except HaptonicError as error:
            first = first or _of_file(error, name)
            continue
        return _mounted(table, channel_map)
    assert first is not None
    raise first


def _mounted(table: TrialTable, channel_map: ChannelMap) -> ChannelMap:
    """The channel map with the orientation of the sensor for each participant, from some of the trials."""
    people = table.labels["participant"]
    records: dict[str, list[Record]] = {}
    for person in dict.fromkeys(people.tolist()):
        rows = np.flatnonzero(people == person)
        some = rows[np.unique(np.linspace(0, len(rows) - 1, PRESSED).round().astype(int))]
        reads = records_of(table.folder, channel_map, table.portion(some.tolist()), people)
        records[str(person)] = [read.record for read in reads if read.record is not None]
    return mounted(channel_map, records)


def _of_file(error: HaptonicError, name: str) -> HaptonicError:
    """The same error, with the name of its file."""
    kind = FrictionError if isinstance(error, ChannelError) else type(error)
    return error.changed(kind, argument=f"{name}: {error.argument}")


def _why(name: str, error: HaptonicError) -> str:
    where = error.argument if name in error.argument else f"{name}: {error.argument}"
    return f"{where}: {error.given}; {error.cause}"


def _declared(trials: xr.Dataset, excluded: Sequence[Exclusion]) -> xr.Dataset:
    """The table with the declared exclusions in it."""
    reason, detail = (trials[name].values.astype(object) for name in ("excluded", "detail"))
    for number, exclusion in enumerate(excluded, start=1):
        rows = trials["participant"].values == exclusion.participant
        for name in ("block", "trial"):
            if getattr(exclusion, name) is not None:
                rows &= trials[name].values == getattr(exclusion, name)
        if not rows.any():
            raise FrictionError.mismatch(
                argument=f"trials.exclude[{number}]",
                given=", ".join(
                    f"{key} {value}" for key, value in asdict(exclusion).items() if value is not None
                ),
                allowed="trials that are in the table",
                cause="a slip in the name or the numbers, or the exclusion is of another experiment",
                next_step="correct the exclusion, or remove it",
            )
        reason[rows], detail[rows] = DECLARED, exclusion.reason
    return trials.assign(excluded=("stroke", reason.astype(str)), detail=("stroke", detail.astype(str)))


def _need_trials(trials: xr.Dataset) -> None:
    excluded = trials["excluded"].values
    if (excluded == "").any():
        return
    counts = Counter(excluded.tolist()).most_common()
    most = counts[0][0]
    row = excluded.tolist().index(most)
    cause, next_step = REMEDIES.get(str(most), ("rules that fit no trial", "look at the records"))
    raise FrictionError.too_few(
        argument="trials",
        given=", ".join(f"{count} of {len(excluded)}: {reason}" for reason, count in counts),
        allowed="at least one trial that counts",
        cause=str(trials["detail"].values[row]) if most in OMISSIONS else cause,
        next_step=next_step,
    )
