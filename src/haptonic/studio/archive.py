"""Jobs on the disk, so that nothing is lost when the server ends: one zip file for each.

The folder of the archive is in the store. Its name is the hash of the folder of studies, so that every folder
has its own list of runs. The file of a running job names its process: after the end of the process the job is
listed as interrupted.
"""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
import secrets
import zipfile
from collections.abc import Container, Iterator
from contextlib import suppress
from dataclasses import asdict, fields
from functools import cache
from pathlib import Path
from typing import Any

from haptonic.atomic import write_atomically
from haptonic.gate import json_from
from haptonic.later import psutil
from haptonic.store import Store
from haptonic.studio.job import Job
from haptonic.studio.order import Order

FORM = 2  # of the files; those of another form are left alone
FILES = "[0-9]*.zip"  # pattern of their names, which begin with a number; that of a draft begins with a point
BRIEF, WHOLE, VIEW = "brief.json", "whole.json", "view"
APART = ("view", "order", "first", "knobs", "previews")  # with files of their own, or not kept
ARCHIVED = {"archived": True, "first": 0, "turns": False, "previews": {}}  # facts that are not kept
FAULTS = (OSError, zipfile.BadZipFile, KeyError, ValueError, TypeError)  # of a damaged file


class Archive:
    """Runs of one folder of studies, each a file that is complete or absent.

    most_runs, most_bytes : limits of the folder; the oldest runs leave first, and the newest stays
    briefs : state of each run for the list of the page, by its number
    """

    def __init__(
        self, studies: Path, store: Store | None = None, *, most_runs: int = 50, most_bytes: int = 500_000_000
    ) -> None:
        digest = hashlib.sha256(str(studies).encode("utf-8", "surrogateescape")).hexdigest()
        self.folder = (Store.default() if store is None else store).root / "studio" / digest[:32]
        self.studies, self.most_runs, self.most_bytes = studies, most_runs, most_bytes
        self.briefs: dict[int, dict[str, Any]] = {}
        self._paths: dict[int, Path] = {}
        self._times: dict[Path, float] = {}
        self.refresh()

    def refresh(self, taken: Container[int] = ()) -> bool:
        """Add runs that another program has written, and drop those it has removed; True if there were any.

        taken : numbers of jobs that are not written yet; a new run with one of them, or with that of another
            run, has the next free number here
        """
        there = {path: _time(path) for path in self.folder.glob(FILES)}
        if there == self._times:
            return False
        self._times, before = there, dict(self._paths)
        for number in [number for number, path in self._paths.items() if path not in there]:
            del self.briefs[number], self._paths[number]
        known = set(self._paths.values())
        for path in sorted(there, key=there.__getitem__):
            if path not in known:
                with suppress(*FAULTS), zipfile.ZipFile(path) as parts:
                    self._add(path, json_from(parts.read(BRIEF).decode()), taken)
        return self._paths != before

    def _add(self, path: Path, brief: dict[str, Any], taken: Container[int]) -> None:
        if brief["form"] != FORM or not isinstance(brief["number"], int):
            return
        if brief["state"] == "running":
            if _is_alive(*brief["process"]):
                return
            brief = brief | {"state": "interrupted"}
        number = brief["number"]
        while number in self.briefs or number in taken:
            number += 1
        self.briefs[number], self._paths[number] = brief | {"number": number}, path

    def keep(self, job: Job) -> None:
        """Write a job as far as it is, and remove the oldest beyond the limits.

        Raises
        ------
        ResourceError : the folder cannot be written
        """
        content, brief = io.BytesIO(), job.brief() | ARCHIVED | {"form": FORM, "process": _this_process()}
        with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as parts:
            parts.writestr(BRIEF, json.dumps(brief))
            parts.writestr(WHOLE, json.dumps(_plain(job)))
            if job.view is not None:
                parts.writestr(VIEW, job.view)
        path = self._paths.get(job.number) or self.folder / f"{job.number}-{secrets.token_hex(4)}.zip"
        write_atomically(path, lambda draft: draft.write_bytes(content.getbuffer()))
        self.briefs[job.number], self._paths[job.number] = brief, path
        self._make_room()

    def read(self, number: int) -> Job | None:
        """A run with its answer; None without a file that can be read."""
        with suppress(*FAULTS), zipfile.ZipFile(self._paths[number]) as parts:
            plain = json_from(parts.read(WHOLE).decode())
            order = plain.pop("order") | {"number": number}
            job = Job(Order(folder=self.studies, **order), **plain)
            job.view = parts.read(VIEW) if VIEW in parts.namelist() else None
            job.state, job.seconds = self.briefs[number]["state"], self.briefs[number]["seconds"]
            return job
        return None

    def remove(self, number: int) -> None:
        """Remove a run and its file."""
        self.briefs.pop(number, None)
        path = self._paths.pop(number, None)
        if path is not None:
            with suppress(OSError):
                path.unlink()

    def _make_room(self) -> None:
        total = 0
        for count, (number, size) in enumerate(list(self._sizes()), start=1):
            total += size
            if count > 1 and (count > self.most_runs or total > self.most_bytes):
                self.remove(number)

    def _sizes(self) -> Iterator[tuple[int, int]]:
        """Number and bytes of each run, newest first."""
        for number in sorted(self._paths, reverse=True):
            with suppress(OSError):
                yield number, self._paths[number].stat().st_size


def _plain(job: Job) -> dict[str, Any]:
    """A job without its folder and its view."""
    order = asdict(job.order)
    del order["folder"]
    values = {field.name: getattr(job, field.name) for field in fields(job) if field.name not in APART}
    return values | {"order": order}


@cache
def _this_process() -> tuple[int, float]:
    """Number of this process, and the time of its start."""
    return os.getpid(), psutil.Process().create_time()


def _is_alive(number: int, began: float) -> bool:
    """True if a process still exists; a later one may have its number."""
    try:
        process = psutil.Process(number)
        is_same = math.isclose(process.create_time(), began, abs_tol=1.0)
        return is_same and process.status() != psutil.STATUS_ZOMBIE
    except psutil.Error:
        return False


def _time(path: Path) -> float:
    with suppress(OSError):
        return path.stat().st_mtime
    return 0.0
