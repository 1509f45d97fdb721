"""The one protocol of results: whatever shows a result asks for nothing that is not here.

A result is a frozen dataclass below `Result`. It says what it found in sentences and tables; which pictures
can be drawn of it and which files can be written stand as methods marked with `figure` and `file`, so that
their names are known before anything is drawn or computed. A command's answer and files, JSON, a notebook,
a chapter of the report: all follow from these.
"""

from __future__ import annotations

import html
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from functools import partial
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, overload

from haptonic import plots
from haptonic.errors import HaptonicError, shown
from haptonic.later import Axes, Figure
from haptonic.pages import embedded
from haptonic.paths import target
from haptonic.progress import Progress, silent
from haptonic.results.common import Writer, accuracy_remarks, refuse_taken, write_files, write_netcdf
from haptonic.results.plain import attributes, plain
from haptonic.results.table import Table
from haptonic.store import whole_set

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

KINDS = ("svg", "png")  # of files of a picture


@dataclass(frozen=True)
class Product:
    """A picture or a file of a result: its name, what makes it, and whether this result has it.

    name : with a "*" in it for several, which ``make`` gives by name
    caption : the sentence below a picture
    """

    name: str
    make: Callable[..., Any]
    when: Callable[[Any], object]
    caption: str = ""

    def of(self, result: Result) -> dict[str, Callable[..., Any]]:
        """What makes each of them for a result."""
        if not self.when(result):
            return {}
        return self.make(result) if "*" in self.name else {self.name: partial(self.make, result)}


def _always(result: object) -> bool:
    return True


def figure(
    name: str, caption: str = "", *, when: Callable[[Any], object] = _always
) -> Callable[[Callable[..., Any]], Any]:
    """Mark a method that draws the picture of this name; of ``name-*`` one that gives drawers by name."""
    return lambda make: _Marked((Product(name, make, when, caption),), "_pictures")


def file(*names: str, when: Callable[[Any], object] = _always) -> Callable[[Callable[..., Any]], Any]:
    """Mark a method that writes the file of this name to a path, or several, each in the form that its ending
    says; of ``name-*`` one that gives writers by name."""
    return lambda make: _Marked(tuple(Product(name, make, when) for name in names), "_writers")


@dataclass(frozen=True)
class _Marked:
    parts: tuple[Product, ...]
    kind: str

    def __set_name__(self, owner: type[Result], name: str) -> None:
        # a class has the parts of those above it, and its own
        known: tuple[Product, ...] = getattr(owner, self.kind)
        setattr(owner, self.kind, (*known, *self.parts))
        setattr(owner, name, self.parts[0].make)


class Figures(Mapping[str, "Figure"]):
    """Pictures by name; each is drawn when it is asked for."""

    def __init__(self, drawers: Mapping[str, Callable[..., Figure]], captions: Mapping[str, str]) -> None:
        self._drawers, self.captions = dict(drawers), dict(captions)

    def __getitem__(self, name: str) -> Figure:
        return self._drawers[name]()

    def __iter__(self) -> Iterator[str]:
        return iter(self._drawers)

    def __len__(self) -> int:
        return len(self._drawers)

    def __repr__(self) -> str:
        return f"<pictures: {', '.join(self)}>"

    def drawn(self, name: str | None, how: Mapping[str, Any]) -> Figure:
        """A picture, the first by default, with what may be chosen of it.

        Raises
        ------
        HaptonicError : there is none, none of this name, or this one knows no such choice
        """
        asked = next(iter(self._drawers), "any") if name is None else name
        if asked not in self._drawers:
            cause = "the name is misspelt, or this result has nothing to draw there"
            raise HaptonicError.unknown("name of the picture", asked, self._drawers, cause)
        draw = self._drawers[asked]
        known = signature(draw).parameters
        for choice in how:
            if choice not in known:
                alone = "it has several systems of axes" if choice == "ax" else "it knows no such choice"
                others = [
                    one for one, draws in self._drawers.items() if choice in signature(draws).parameters
                ]
                raise HaptonicError.unsupported(
                    argument=choice,
                    given=f"{choice} for the picture {asked}",
                    allowed=f"{choice} for {', '.join(others)}" if others else f"no {choice} for this result",
                    cause=alone,
                    next_step=f'plot("{others[0]}", {choice}=...)' if others else f"leave {choice} out",
                )
        return draw(**how)


class Result:
    """What an analysis gives; see the module.

    title : heads it where it is shown
    """

    title: ClassVar[str] = ""
    data_file: ClassVar[str | None] = None  # name of the NetCDF file of the dataset, without its suffix
    _pictures: ClassVar[tuple[Product, ...]] = ()
    _writers: ClassVar[tuple[Product, ...]] = ()

    if TYPE_CHECKING:  # at run time a property here would be taken for the default of a dataclass's field

        @property
        def dataset(self) -> xr.Dataset:
            """All of the answer: labelled arrays with units, stamped with what made them."""

    def summary(self) -> list[str]:
        """What was found, the answer first, a sentence each."""
        return []

    def tables(self) -> list[Table]:
        """The numbers that a person asks for."""
        return []

    def remarks(self) -> list[str]:
        """What may be wrong, or was left out, as warnings; by default an accuracy that was not reached."""
        return accuracy_remarks(self.dataset.attrs)

    def facts(self) -> dict[str, Any]:
        """What machines are told by name: numbers, texts, values, datasets; by default all of the dataset."""
        return {"data": self.dataset}

    def to_json(self) -> dict[str, Any]:
        """What was found, the facts as plain values, and what made them; see `haptonic.results.plain`."""
        told = {"summary": self.summary(), **plain(self.facts())}
        return told | {name: one for name, one in attributes(self.dataset).items() if name not in told}

    @property
    def origin(self) -> str:
        """Of the numbers, "simulated" or "measured"; a caption says it at "{Origin}"."""
        return "simulated"

    @property
    def figures(self) -> Figures:
        """Pictures by name, drawn when asked for."""
        drawers, captions = dict[str, Callable[[], Any]](), dict[str, str]()
        for part in self._pictures:
            found = part.of(self)
            drawers |= found
            captions |= dict.fromkeys(found, part.caption.replace("{Origin}", self.origin.capitalize()))
        return Figures(drawers, captions)

    @property
    def files(self) -> dict[Any, Writer]:
        """Writers of the data files by name; a name may be a path of a file in a folder below."""
        found: dict[Any, Writer] = {}
        if self.data_file:
            found[f"{self.data_file}.nc"] = partial(write_netcdf, self.dataset)
        for part in self._writers:
            found |= part.of(self)
        return found

    @overload
    def plot(self, name: str | None = None, *, ax: Axes, legend: bool = True,
             color: str | Sequence[str] | None = None, **how: Any) -> Axes: ...  # fmt: skip

    @overload
    def plot(self, name: str | None = None, *, ax: None = None, style: str = "plain", legend: bool = True,
             color: str | Sequence[str] | None = None, **how: Any) -> Figure: ...  # fmt: skip

    def plot(
        self,
        name: str | None = None,
        *,
        ax: Axes | None = None,
        style: str | None = None,
        legend: bool = True,
        color: str | Sequence[str] | None = None,
        **how: Any,
    ) -> Figure | Axes:
        """One picture; the first of them by default.

        Parameters
        ----------
        ax : of a figure of one's own, to draw on; size, type and colours of what is not data are then that
            figure's, and the axes are given back. For pictures with one system of axes.
        style : "plain" (150 mm wide, type of 9 points), "column" of a paper (85 mm, 7 points), "wide" over
            two columns (180 mm, 8 points) or "slide" (240 mm, 16 points)
        legend : whether to draw one
        color : of the curves in their order, one or several
        how : what may be chosen of a picture, such as ``frequency`` (Hz) of a map

        Raises
        ------
        HaptonicError : no such picture, style, colour or choice, or axes that cannot be drawn on
        """
        if ax is not None and style is not None:
            raise HaptonicError.conflict(
                argument="style", given=f"style={shown(style)} with ax", allowed="style or ax",
                cause="size and type are those of the figure that the axes belong to",
                next_step="leave style out, or ax",
            )  # fmt: skip
        with plots.chosen(style, legend=legend, color=color):
            if ax is None:
                return self.figures.drawn(name, how)
            self.figures.drawn(name, {"ax": plots.checked(ax), **how})
            return ax

    def to_dataframe(self) -> pd.DataFrame:
        """The first table as raw values in SI units."""
        return self.tables()[0].to_dataframe()

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        """Of all files that a result of this kind may write, some with a "*"; ``options`` may leave out some.

        "STUDY" in a name stands for that of the study's file.
        """
        data = [f"{cls.data_file}.nc"] if cls.data_file else []
        pictures = [f"{part.name}.{kind}" for part in cls._pictures for kind in KINDS]
        return [*data, *(part.name for part in cls._writers), *pictures]

    def write(self, folder: Path | str, *, overwrite: bool = False, progress: Progress = silent) -> None:
        """Write all files and pictures, or none of them.

        Raises
        ------
        ResourceError : a name is taken, or the folder cannot be written
        """
        folder = target(folder, "folder")
        refuse_taken(folder, taken(folder, self.names()), overwrite=overwrite)
        with whole_set(folder, overwrite=overwrite) as draft:
            self.put(draft, progress)

    def put(self, draft: Path, progress: Progress = silent) -> None:
        """Write all files and pictures into a folder that is empty or holds nothing of these names."""
        write_files(draft, self.files, overwrite=False)
        figures = self.figures
        for done, name in enumerate(figures):
            progress(done, len(figures), "pictures")
            plots.save(figures[name], draft, name)

    def located(self, folder: Path) -> dict[str, Any]:
        """What the JSON says besides, of a result that is always written into a folder."""
        return {}

    def __repr__(self) -> str:
        said = self.summary()
        return f"<{type(self).__name__}{': ' if said else ''}{said[0] if said else ''}>"

    def _repr_html_(self) -> str:
        said = "".join(f"<p>{html.escape(sentence)}</p>" for sentence in self.summary())
        return said + "".join(table.written("html") for table in self.tables()) + self._thumbnail()

    def _thumbnail(self) -> str:
        """The first picture, small."""
        figures = self.figures
        for name in figures:
            source, words = embedded(figures[name], "png"), html.escape(figures.captions[name])
            return f'<img src="{source}" alt="{words}" title="{words}" style="max-width: 24rem">'
        return ""


def taken(folder: Path | None, names: Sequence[Any]) -> list[Any]:
    """The names themselves, those with a "*" replaced by the names of files in the folder that they match."""
    there = [path.name for path in folder.iterdir()] if folder is not None and folder.is_dir() else []
    plain = [name for name in names if "*" not in str(name)]
    patterns = [str(name) for name in names if "*" in str(name)]
    return plain + [name for name in there if any(fnmatchcase(name, one) for one in patterns)]
