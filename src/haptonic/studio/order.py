"""Orders and wishes that the server sends to a worker process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # the command line records its runs as orders, without the writers of files
    from haptonic.studio.files import Export


@dataclass(frozen=True)
class Order:
    """An analysis to compute.

    number : of the job
    text : of the study; title : in it; folder : of its file, which may have no such name yet
    analysis : name of an offered analysis
    export : file to make of the result, instead of an answer for the page
    alone : the analysis does not use the study of the page
    examines : only read the files, and report how they were read
    turned : path of the number that a user turns; empty for another order
    """

    number: int
    text: str
    folder: Path
    file: str
    analysis: str
    options: Mapping[str, Any]
    title: str = ""
    export: Export | None = None
    turned: str = ""
    alone: bool = False
    examines: bool = False


@dataclass(frozen=True)
class Wish:
    """A number whose preview is wanted before others."""

    path: str
