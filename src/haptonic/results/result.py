"""Protocol of results, used by everything that shows a result.

A result is a frozen dataclass derived from `Result`. It gives its answer in sentences and tables. Its
pictures and files are made by methods marked with `figure` and `file`, or, where they are many, by functions
of another module with these marks, which are the ``products`` of the class. So their names are known before
anything is drawn or computed. The output and files of a command, JSON, notebooks and chapters of the report
all use this protocol.
"""

from __future__ import annotations

import html
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from functools import partial
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, overload

from haptonic import plots
from haptonic.atomic import whole_set
from haptonic.errors import HaptonicError, shown
from haptonic.later import Axes, Figure
from haptonic.pages import embedded
from haptonic.paths import target
from haptonic.plots.looks import PICTURE_KINDS
from haptonic.progress import Progress, silent
from haptonic.results.common import Writer, accuracy_remarks, refuse_taken, write_files, write_netcdf
from haptonic.results.pictures import write_pictures
from haptonic.results.plain import attributes, plain
from haptonic.results.table import Table
from haptonic.units import to_si
from haptonic.views import InteractiveView, widget_bundle, widgets_work, write_page

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


@dataclass(frozen=True)
class Product:
    """A picture or a file of a result: its name, the function that makes it, and its condition.

    name : with a "*" for several products, which ``make`` returns by name
    caption : sentence below a picture
    """

    name: str
    make: Callable[..., Any]
    when: Callable[[Any], object]
    caption: str = ""

    def of(self, result: Result) -> dict[str, Callable[..., Any]]:
        """Functions that make the products for a result, by name."""
        if not self.when(result):
            return {}
        return self.make(result) if "*" in self.name else {self.name: partial(self.make, result)}


def _always(result: object) -> bool:
    return True


def figure(
    name: str, caption: str = "", *, when: Callable[[Any], object] = _always
) -> Callable[[Callable[..., Any]], Any]:
    """Mark what draws the picture of this name; for ``name-*``, what returns drawers by name."""
    return lambda make: Marked((Product(name, make, when, caption),), "_pictures")


def file(*names: str, when: Callable[[Any], object] = _always) -> Callable[[Callable[..., Any]], Any]:
    """Mark what writes files of these names to a path, each in the format of its ending; for ``name-*``, what
    returns writers by name."""
    return lambda make: Marked(tuple(Product(name, make, when) for name in names), "_writers")


def page(name: str, *, when: Callable[[Any], object] = lambda result: result.interactive) -> Any:
    """Mark the page of the interactive view, a file of this name."""
    return file(name, when=when)(lambda result, path: write_page(result.view(), path))


@dataclass(frozen=True)
class Marked:
    """Pictures or files made by one function, for the attribute ``kind`` of a class of results."""

    parts: tuple[Product, ...]
    kind: str

    def __set_name__(self, owner: type[Result], name: str) -> None:
        self.add_to(owner)
        setattr(owner, name, self.parts[0].make)

    def add_to(self, owner: type[Result]) -> None:
        # a class has the parts of its base classes, and its own parts
        inherited: tuple[Product, ...] = getattr(owner, self.kind)
        setattr(owner, self.kind, (*inherited, *self.parts))


class Figures(Mapping[str, "Figure"]):
    """Pictures by name, each drawn on access."""

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
        """Draw a picture, the first by default, with options.

        Raises
        ------
        HaptonicError : no picture of this name, or an option that this picture does not have
        """
        if not self._drawers:
            raise HaptonicError.missing(
                argument="name of the picture",
                allowed="a result with pictures",
                cause="this result has none, such as the plan of a study without a plate",
                next_step="print its summary() or its tables() instead",
            )
        asked = next(iter(self._drawers)) if name is None else name
        if asked not in self._drawers:
            cause = "the name is misspelt, or this result has no such picture"
            raise HaptonicError.unknown("name of the picture", asked, self._drawers, cause)
        draw = self._drawers[asked]
        parameters = signature(draw).parameters
        for choice in how:
            if choice not in parameters:
                alone = "it has several systems of axes" if choice == "ax" else "it has no such option"
                others = [
                    picture
                    for picture, draws in self._drawers.items()
                    if choice in signature(draws).parameters
                ]
                options = ", ".join([*parameters, "style", "legend", "color"])
                raise HaptonicError.unsupported(
                    argument=choice,
                    given=f"{choice} for the picture {asked}",
                    allowed=f"{choice} for {', '.join(others)}" if others else f"the options {options}",
                    cause=alone,
                    next_step=f'plot("{others[0]}", {choice}=...)' if others else f"leave {choice} out",
                )
        if isinstance(how.get("frequency"), str):
            how = {**how, "frequency": to_si(how["frequency"], "Hz", "frequency")}
        return draw(**how)


class Result:
    """Base class of the results of analyses; see the module.

    title : heading of the result
    """

    title: ClassVar[str] = ""
    data_file: ClassVar[str | None] = None  # name of the NetCDF file of the dataset, without its suffix
    _pictures: ClassVar[tuple[Product, ...]] = ()
    _writers: ClassVar[tuple[Product, ...]] = ()

    def __init_subclass__(cls, products: Iterable[Marked] = (), **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        for marked in products:
            marked.add_to(cls)

    if TYPE_CHECKING:  # at run time a property here would be taken for the default of a dataclass's field

        @property
        def dataset(self) -> xr.Dataset:
            """The whole answer: labelled arrays with units, stamped with their inputs."""

    @property
    def datasets(self) -> tuple[xr.Dataset, ...]:
        """Datasets in NetCDF files, each with the inputs; by default the whole answer, if it has a file."""
        return (self.dataset,) if self.data_file else ()

    def view(self) -> InteractiveView | None:
        """Contents of the interactive view; None for a result that has none."""
        return None

    def summary(self) -> list[str]:
        """The answer in sentences, the most important first."""
        return []

    def tables(self) -> list[Table]:
        """The most important numbers as tables."""
        return []

    def remarks(self) -> list[str]:
        """Warnings on possible errors and omissions; by default on an accuracy that was not reached."""
        return accuracy_remarks(self.dataset.attrs)

    def facts(self) -> dict[str, Any]:
        """Contents of the JSON output: numbers, texts, values, datasets; by default the whole dataset."""
        return {"data": self.dataset}

    def to_json(self) -> dict[str, Any]:
        """Answer, facts as plain values, and inputs; see `haptonic.results.plain`."""
        facts = {"summary": self.summary(), **plain(self.facts())}
        return facts | {name: v for name, v in attributes(self.dataset).items() if name not in facts}

    @property
    def origin(self) -> str:
        """Origin of the numbers, "simulated" or "measured"; it replaces "{Origin}" in captions."""
        return "simulated"

    @property
    def figures(self) -> Figures:
        """Pictures by name, drawn on access."""
        drawers, captions = dict[str, Callable[[], Any]](), dict[str, str]()
        for part in self._pictures:
            parts = part.of(self)
            drawers |= parts
            captions |= dict.fromkeys(parts, part.caption.replace("{Origin}", self.origin.capitalize()))
        return Figures(drawers, captions)

    @property
    def files(self) -> dict[Any, Writer]:
        """Writers of the data files by name; a name may be a path below the folder."""
        writers: dict[Any, Writer] = {}
        if self.data_file:
            writers[f"{self.data_file}.nc"] = partial(write_netcdf, self.dataset)
        for part in self._writers:
            writers |= part.of(self)
        return writers

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
        """Draw one picture, the first by default.

        Parameters
        ----------
        ax : axes of the user's figure to draw on; size, type and colours of everything but the data are then
            those of this figure, and the axes are returned. For pictures with one system of axes.
        style : "plain" (150 mm wide, type of 9 points), "column" of a paper (85 mm, 7 points), "wide" over
            two columns (180 mm, 8 points) or "slide" (240 mm, 16 points)
        legend : whether to draw one
        color : colour of the curves in their order, one or several
        how : options of one picture. A band diagram has ``gaps=False`` (no shades of gaps), ``labels=False``
            (no names of gaps and of the carrier), ``label`` (of its curves in the legend) and ``wavevectors``
            (unit of the path, "rad/m" or "pi/a"). Maps have ``frequency`` (Hz, or a text such as "58 kHz").
            Rows of cells have ``incident`` (one of the waves)

        Raises
        ------
        HaptonicError : no such picture, style, colour or option, or axes that cannot be drawn on
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
        """Names of all files that a result of this kind may write with ``options``, some with a "*".

        "STUDY" in a name is replaced by the name of the study's file.
        """
        data = [f"{cls.data_file}.nc"] if cls.data_file else []
        pictures = [f"{part.name}.{kind}" for part in cls._pictures for kind in PICTURE_KINDS]
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
        """Write all files and pictures into a folder that contains no files of these names."""
        write_files(draft, self.files, overwrite=False)
        write_pictures(self, draft, progress)

    def located(self, folder: Path) -> dict[str, Any]:
        """Additional JSON entries of a result that always writes into a folder."""
        return {}

    def __repr__(self) -> str:
        sentences = self.summary()
        return f"<{type(self).__name__}{': ' if sentences else ''}{sentences[0] if sentences else ''}>"

    def _repr_html_(self) -> str:
        text = "".join(f"<p>{html.escape(sentence)}</p>" for sentence in self.summary())
        return text + "".join(table.written("html") for table in self.tables()) + self._thumbnail()

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        """The interactive view for a notebook; a notebook gets its other formats from the methods above."""
        view = self.view() if widgets_work() else None
        return {} if view is None else widget_bundle(view)

    def _thumbnail(self) -> str:
        """Small version of the first picture, as HTML."""
        figures = self.figures
        for name in figures:
            source, words = embedded(figures[name], "png"), html.escape(figures.captions[name])
            return f'<img src="{source}" alt="{words}" title="{words}" style="max-width: 24rem">'
        return ""


def taken(folder: Path | None, names: Sequence[Any]) -> list[Any]:
    """Names in which each pattern with a "*" is replaced by the names of matching files in the folder."""
    existing = [path.name for path in folder.iterdir()] if folder is not None and folder.is_dir() else []
    plain = [name for name in names if "*" not in str(name)]
    patterns = [str(name) for name in names if "*" in str(name)]
    return plain + [name for name in existing if any(fnmatchcase(name, pattern) for pattern in patterns)]
