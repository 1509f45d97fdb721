"""The trials of an experiment as a stream: read file by file, measured, forgotten but for a row each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Annotated, NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.channels import Group, SignalFile, opened
from haptonic.errors import ChannelError, FrictionError, HaptonicError, ResourceError
from haptonic.fields import Name, described, needed, problem, setting
from haptonic.friction.recordings.channel_map import ChannelMap, pressing
from haptonic.friction.recordings.sensor import Sensor
from haptonic.friction.recordings.trial_table import RecordSpan, TrialTable
from haptonic.friction.signals.measuring import Columns, channels_of, measure_all, processed
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.rules import DECLARED, UNREADABLE, Measured, Rules
from haptonic.friction.signals.tables import LABEL, read_columns, read_records, read_trials
from haptonic.friction.signals.trials import joined, measured, tabulated
from haptonic.later import xarray as xr
from haptonic.parallel import finished
from haptonic.progress import Progress, silent

Portion = list[tuple[str, list[RecordSpan]]]

TRIED = 20  # files that are looked into for channels of the expected names
PRESSED = 30  # trials that the sign of the normal force is found from
POINTS = 80  # of a curve that is drawn small


@described("trials.exclude", FrictionError)
class Exclusion:
    """Trials that do not count, declared before the data are seen."""

    participant: Name = needed("As the table of trials calls him or her.", examples=["P3"])
    reason: Annotated[str, Field(min_length=1, max_length=200, strict=True)] = needed(
        "Stands beside the trial in every table.", examples=["lifted the finger"]
    )
    block: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = setting(None, "Else all blocks.")
    trial: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = setting(
        None, "Of the block; else all its trials."
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
    """The table of trials, see `haptonic.friction.signals.measured`, and what was guessed.

    ``trials`` has ``detail`` beside ``excluded``: the file and what is wrong with it, or the declared reason.
    """

    trials: xr.Dataset
    remarks: tuple[str, ...]


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
    """All trials of a folder with a table of trials, or of a single table.

    What cannot be read is left out, and says so. Memory is that of a few files, and a row for each trial.

    Parameters
    ----------
    source : a folder with ``trials.csv``; or a file of all samples, or of trials that were measured elsewhere
    workers : processes; 0 works in this one
    progress : called with the trials done and all of them

    Raises
    ------
    ResourceError : no such file or folder
    FrictionError : a table that is wrong, an exclusion of a trial that is not there, or no trial that counts
    """
    if source.is_dir() or not source.suffix:
        trials, remarks = _from_folder(TrialTable.read(source), sensor, rules, workers, progress)
    else:
        trials, remarks = _from_file(source, rules), ()
    if "detail" not in trials:
        trials["detail"] = ("stroke", np.full(trials.sizes["stroke"], ""))
    trials = _declared(trials, excluded)
    _need_trials(trials)
    return Analysed(trials, remarks)


def traces(
    source: Path, sensor: Sensor, rules: Rules, blocks: Sequence[tuple[str, int]]
) -> Iterator[tuple[str, int, xr.Dataset]]:
    """Forces of every trial of some blocks (participant, number), to be drawn small.

    Yields
    ------
    participant, block, and along (``stroke``, ``point``): ``time`` (s), ``normal`` and ``tangential`` (N),
    ``steady``; along ``stroke``: ``trial``. What could not be read is not in it.
    """
    if not (source.is_dir() or not source.suffix):
        return
    table = TrialTable.read(source)
    channel_map = _channel_map(table, sensor)
    people, numbers = table.labels["participant"], table.labels["block"]
    for participant, block in blocks:
        rows = np.flatnonzero((people == participant) & (numbers == block)).tolist()
        reads = _records(table.folder, channel_map, table.portion(rows))
        parts = {read.span.row: _trace(read.record, rules) for read in reads if read.record is not None}
        if parts:
            drawn = xr.concat(list(parts.values()), "stroke")
            yield participant, block, drawn.assign(trial=("stroke", table.labels["trial"][list(parts)]))


def _trace(record: Record, rules: Rules) -> xr.Dataset:
    """Some points of one record; unfiltered where it cannot be filtered."""
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


def _from_file(path: Path, rules: Rules) -> xr.Dataset:
    columns = read_columns(path, LABEL)
    origin = "simulated" if "simulated" in {str(word) for word in columns.get("origin", ())} else "measured"
    trials = read_trials(path) if "friction" in columns else measured(read_records(path), rules)
    return trials.assign_attrs(origin=origin)


def _from_folder(
    table: TrialTable, sensor: Sensor, rules: Rules, workers: int, progress: Progress
) -> tuple[xr.Dataset, tuple[str, ...]]:
    channel_map = _channel_map(table, sensor)
    total, done = len(table.files), 0
    order, found, simulated = [], [], table.simulated
    work = partial(_measured, table.folder, channel_map, rules)
    # in processes, for most of the work is Python that reads text
    for _, (rows, columns, says_so) in finished(work, enumerate(table.portions()), workers, _lost):
        order.append(rows)
        found.append(columns)
        simulated |= says_so
        done += len(rows)
        progress(done, total)
    back = np.argsort(np.concatenate(order))
    columns = {name: column[back] for name, column in joined(found).items()}
    origin = "simulated" if simulated else "measured"
    trials = tabulated({**table.labels, **table.carried}, columns, rules, origin=origin)
    return trials, channel_map.remarks


def _lost(portion: Portion) -> NoReturn:
    raise ResourceError.worker(
        argument="worker process",
        given=f"died twice on {portion[0][0]} or a file after it",
        allowed="files that a worker can measure",
        cause="more memory needed than there is, or a crash inside a numerical library",
        next_step="run it again with fewer workers, or take this file out of the table",
    )


def _measured(
    folder: Path, channel_map: ChannelMap, rules: Rules, portion: Portion
) -> tuple[NDArray[np.int_], Columns, bool]:
    """Rows of the table, their columns, and whether any file says that it is simulated."""
    reads = list(_records(folder, channel_map, portion))
    good = [i for i, read in enumerate(reads) if read.record is not None]
    numbers = measure_all([read.record for read in reads if read.record is not None], rules)
    empty = asdict(Measured(excluded=UNREADABLE))
    columns: Columns = {}
    for name, values in numbers.items():
        columns[name] = np.full(len(reads), empty[name], dtype=values.dtype)
        columns[name][good] = values
    columns["detail"] = np.array([read.detail for read in reads], dtype=object)
    return np.array([read.span.row for read in reads]), columns, any(read.simulated for read in reads)


def _records(folder: Path, channel_map: ChannelMap, portion: Portion) -> Iterator[_Read]:
    """Every trial of a portion with its record, or with what is wrong. A file is opened once."""
    for name, spans in portion:
        left = list(spans)
        try:
            file = opened(folder / name)
            kept: dict[str, tuple[Group, float]] = {}
            while left:
                yield _read(name, left[0], file, kept, channel_map)
                left.pop(0)
        except HaptonicError as error:
            yield from (_Read(span, None, _why(name, error), False) for span in left)


def _read(
    name: str,
    span: RecordSpan,
    file: SignalFile,
    kept: dict[str, tuple[Group, float]],
    channel_map: ChannelMap,
) -> _Read:
    simulated = False
    try:
        if span.group not in kept:
            kept.clear()  # groups come one after the other
            channels = file.group(span.group)
            simulated = channels.simulated
            kept[span.group] = channels, channel_map.rate_in(channels)
        channels, rate = kept[span.group]
        record = channel_map.record(channels, rate, span.start, span.stop)
    except HaptonicError as error:
        return _Read(span, None, _why(name, error), simulated)
    return _Read(span, record, "", channels.simulated)


def _channel_map(table: TrialTable, sensor: Sensor) -> ChannelMap:
    """The meaning of the channels, from the first file that has those that are needed.

    Raises
    ------
    HaptonicError : what is wrong with the first file, if none of the first has them
    """
    first: HaptonicError | None = None
    calibration = sensor.matrix(table.folder)
    for name, spans in islice((one for portion in table.portions() for one in portion), TRIED):
        try:
            channels = opened(table.folder / name).group(spans[0].group)
            channel_map = sensor.channel_map(channels, calibration)
        except HaptonicError as error:
            first = first or _of_file(error, name)
            continue
        return _with_sign(table, channel_map) if channel_map.sign_unknown else channel_map
    assert first is not None
    raise first


def _with_sign(table: TrialTable, channel_map: ChannelMap) -> ChannelMap:
    reads = (read for portion in table.portions() for read in _records(table.folder, channel_map, portion))
    records = [read.record for read in islice(reads, PRESSED) if read.record is not None]
    return channel_map.turned() if pressing(records) < 0 else channel_map


def _of_file(error: HaptonicError, name: str) -> HaptonicError:
    """The same error, with the file that it is about, and where channels get their meaning."""
    kind, next_step = FrictionError if isinstance(error, ChannelError) else type(error), error.next_step
    if isinstance(error, ChannelError) and error.argument.startswith("channel "):
        next_step += " Say so in [trials.sensor]"
    return error.changed(kind, argument=f"{name}: {error.argument}", next_step=next_step)


def _why(name: str, error: HaptonicError) -> str:
    where = error.argument if name in error.argument else f"{name}: {error.argument}"
    return f"{where}: {error.given}; {error.cause}"


def _declared(trials: xr.Dataset, excluded: Sequence[Exclusion]) -> xr.Dataset:
    """The table with the declared exclusions in it."""
    reason, detail = (trials[name].values.astype(object) for name in ("excluded", "detail"))
    for number, one in enumerate(excluded, start=1):
        rows = trials["participant"].values == one.participant
        for name in ("block", "trial"):
            if getattr(one, name) is not None:
                rows &= trials[name].values == getattr(one, name)
        if not rows.any():
            raise FrictionError.mismatch(
                argument=f"trials.exclude[{number}]",
                given=", ".join(f"{key} {value}" for key, value in asdict(one).items() if value is not None),
                allowed="trials that are in the table",
                cause="a slip in the name or the numbers, or the exclusion is of another experiment",
                next_step="put it right, or remove it",
            )
        reason[rows], detail[rows] = DECLARED, one.reason
    return trials.assign(excluded=("stroke", reason.astype(str)), detail=("stroke", detail.astype(str)))


def _need_trials(trials: xr.Dataset) -> None:
    excluded = trials["excluded"].values
    if (excluded == "").any():
        return
    counts = Counter(excluded.tolist()).most_common()
    detail = next((text for text in trials["detail"].values.tolist() if text), "")
    raise FrictionError.too_few(
        argument="trials",
        given=", ".join(f"{count} of {len(excluded)}: {reason}" for reason, count in counts),
        allowed="at least one trial that counts",
        cause=detail or "the normal force counts in the other direction, or rules that fit no trial",
        next_step="look at the records; signs, units and rules stand in [trials] and [trials.sensor]",
    )
