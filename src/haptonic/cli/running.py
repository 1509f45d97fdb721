"""One runner for all analyses: from a record to a command, and from its words to the answer."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import typer

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option_of, path_of
from haptonic.analyses.runner import Runner
from haptonic.cli.console import Voice, speaking
from haptonic.cli.watching import watched
from haptonic.errors import HaptonicError
from haptonic.paths import target
from haptonic.results.common import refuse_taken
from haptonic.results.cost import LONG
from haptonic.results.result import Result, taken
from haptonic.results.table import FORMS, Table, check_form
from haptonic.store import Store
from haptonic.study import load

SCREEN = 24  # lines of a terminal
SENTENCES = 3  # of the answer that are always told
Json = Annotated[
    bool, typer.Option("--json", help="Print one JSON object; files are then written only with --out.")
]
SHARED: dict[str, Any] = {
    "json": Json,
    "tables": Annotated[bool, typer.Option("--tables", help="Print all tables, however long they are.")],
    "tables_as": Annotated[
        str | None,
        typer.Option(
            "--tables-as", metavar="FORM", help=f"Print all tables and nothing else, as {' or '.join(FORMS)}."
        ),
    ],
    "overwrite": Annotated[bool, typer.Option("--overwrite", help="Replace files of an earlier run.")],
}
DRY_RUN = Annotated[
    bool, typer.Option("--dry-run", help="Only tell time and memory that it will need, or why it is refused.")
]
BUDGET = Annotated[
    str | None,
    typer.Option(
        "--budget",
        metavar="TIME",
        help='Of the processor for the meshes of each cell, such as "10 min"; else [bands] budget.',
    ),
]
WATCH = Annotated[bool, typer.Option("--watch", help="Draw anew whenever the study is saved, until Ctrl-C.")]


def command(analysis: Analysis) -> Callable[..., None]:
    """The function of an analysis's command, with the parameters that its record declares."""

    def run(**given: Any) -> None:
        answered(analysis, given)

    own, last = parameters(analysis), inspect.Parameter.KEYWORD_ONLY
    shared = [inspect.Parameter("out", last, default=None, annotation=_folder_option(analysis))]
    shared += [inspect.Parameter(n, last, default=None if n == "tables_as" else False, annotation=kind)
               for n, kind in SHARED.items()]  # fmt: skip
    if analysis.cost is not None:
        shared.append(inspect.Parameter("dry_run", last, default=False, annotation=DRY_RUN))
        if analysis.study == "needed":
            shared.append(inspect.Parameter("budget", last, default=None, annotation=BUDGET))
    if analysis.watches:
        shared.append(inspect.Parameter("watch", last, default=False, annotation=WATCH))
    if analysis.parallel:
        shared += [made for place, made in declared(Runner) if place == "option"]
    every = [*own, *shared]
    run.__name__ = analysis.name.replace(" ", "_")
    run.__annotations__ = {one.name: one.annotation for one in every}
    run.__signature__ = inspect.Signature(every)  # type: ignore[attr-defined]
    return run


def _folder_option(analysis: Analysis) -> Any:
    placed = [(one.name, found) for one in fields(analysis.options) if (found := option_of(one))]
    asked = [known.metavar or name.upper() for name, known in placed if known.place == "before"]
    named = f"named after {' and '.join(asked or ['STUDY'])} and the command"
    return Annotated[
        Path | None,
        typer.Option("--out", metavar="DIR", help=f"Folder for the files; by default in results/, {named}."),
    ]


def parameters(analysis: Analysis) -> list[inspect.Parameter]:
    """Of the command: what it takes by place, the study among it, then the options of the record."""
    placed: dict[str, list[inspect.Parameter]] = {"before": [], "behind": [], "option": []}
    for place, made in declared(analysis.options):
        placed[place].append(made)
    study: list[inspect.Parameter] = []
    if analysis.study != "none":
        needed = analysis.study == "needed"
        about = "Study file (TOML)." if needed else "Study of the plate that was scanned."
        argument: Any = typer.Argument(metavar="STUDY", help=about)
        study = [
            inspect.Parameter(
                "study_file", inspect.Parameter.KEYWORD_ONLY,
                default=inspect.Parameter.empty if needed else None,
                annotation=Annotated[Path if needed else Path | None, argument],
            )
        ]  # fmt: skip
    return [*placed["before"], *study, *placed["behind"], *placed["option"]]


def declared(options: type[Any]) -> Iterator[tuple[str, inspect.Parameter]]:
    """Of what a class declares as options: where a command line takes it, and its parameter."""
    kinds = get_type_hints(options)
    for one in fields(options):
        known = option_of(one)
        if known is None:
            continue
        kind = kinds[one.name]
        if known.unit or known.read:
            kind = str if one.default is MISSING else str | None
        metavar = known.metavar or (one.name.upper() if known.place != "option" else None)
        words: dict[str, Any] = {"help": known.help, "metavar": metavar, "min": known.least}
        made = (
            typer.Option(*known.flag.split(), **words) if known.place == "option" else typer.Argument(**words)
        )
        text = known.unit or known.read  # nothing given is told from a text; the record knows its default
        default = inspect.Parameter.empty if one.default is MISSING else None if text else one.default
        yield (
            known.place,
            inspect.Parameter(
                one.name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=Annotated[kind, made]
            ),
        )


def answered(analysis: Analysis, given: dict[str, Any]) -> None:
    """Answer once; with ``--watch`` again and again, replacing what the first answer wrote."""
    watch, json = given.pop("watch", False), given["json"]
    with speaking(json, analysis.kept) as voice:
        if watch and json:
            raise HaptonicError.conflict(
                argument="--watch",
                given="--watch and --json",
                allowed="one of them",
                cause="--json prints one object, and a study that is watched has many answers",
                next_step="leave --watch out, and ask again when the study is saved",
            )
        once(analysis, given, voice)
        if watch:
            watched(given["study_file"], voice, lambda: once(analysis, given | {"overwrite": True}, voice))


def once(analysis: Analysis, given: dict[str, Any], voice: Voice) -> None:
    """Load, look whether it can end well, compute, say what was found, write."""
    rest = dict(given)
    out, (json, tables, form, overwrite) = rest.pop("out"), (rest.pop(name) for name in SHARED)
    if form is not None:
        check_form(form)
    workers, scheduler = rest.pop("workers", 0), rest.pop("scheduler", None)
    file, dry = rest.pop("study_file", None), rest.pop("dry_run", False)
    budget = rest.pop("budget", None)
    options = analysis.chosen({name: value for name, value in rest.items() if value is not None})
    study = None if file is None else load(file).within(budget, "--budget")
    analysis.admit(study, options)
    cost = analysis.cost(study, options) if analysis.cost else None
    if cost and dry:
        if cost.refusal is not None:
            raise cost.refusal
        voice.tell(cost.sentence)
        limits = {} if cost.budget is None else {"budget_s": cost.budget}
        voice.answer({"processor_s": cost.seconds, "memory_b": cost.memory, **limits})
        return
    about = path_of(options) if analysis.study != "needed" else file
    assert about is not None, f"{analysis.name} is asked of nothing"
    folder = folder_for(analysis, about, out, json)
    refuse_taken(folder, taken(folder, analysis.names(options, about.stem)), overwrite=overwrite)
    if cost and cost.seconds >= LONG:
        voice.say(cost.sentence)
    with voice.counted(analysis.doing or analysis.name) as progress:
        runner = Runner(
            store=Store.default(),
            workers=workers,
            scheduler=scheduler,
            progress=progress,
            about=about,
            folder=folder,
        )
        result = analysis.compute(study, options, runner)
    if form is None:  # the answer first: pictures may take as long again
        show(result, voice, every=tables)
    else:
        voice.print("\n".join(table.written(form) for table in result.tables()))
    for text in result.remarks():
        voice.warn(text)
    located: dict[str, Any] = {}
    if folder:
        with voice.counted("files") as progress:
            result.write(folder, overwrite=overwrite, progress=progress)
        located = result.located(folder)
        if form is None and folder.is_dir():  # a plan of a lattice has no picture
            voice.tell(f"files: {located.get('report', folder)}")
            if analysis.writes and isinstance(paths := located.get("files"), list):
                voice.tell(f"written: {', '.join(Path(one).name for one in paths)}")
    if json:
        voice.answer(result.to_json() | located)


def show(result: Result, voice: Voice, *, every: bool) -> None:
    """The answer in sentences, then its tables while they fit a screen.

    ``every`` : all of them; else what is beyond is named, so that the answer stays in sight
    """
    said = result.summary()
    for sentence in said if every else said[:SENTENCES]:
        voice.tell(sentence)
    room, left = SCREEN, list[Table]()
    for table in () if voice.machine else result.tables():
        room -= voice.height(table)
        if every or room >= 0:
            voice.show(table)
        else:
            left.append(table)
    beyond = 0 if every else len(said) - SENTENCES
    kept = [f"{beyond} sentence{'s' * (beyond > 1)}"] if beyond > 0 else []
    kept += [f"{table.title} ({len(table.rows)})" for table in left]
    if kept:
        voice.tell(f"more with --tables: {', '.join(kept)}")


def folder_for(analysis: Analysis, about: Path, out: Path | None, json: bool) -> Path | None:
    """Where a command's files go; nowhere if a machine asks and names no folder."""
    if out is None and json and not analysis.writes:
        return None
    return target(Path("results") / analysis.folder_of(about) if out is None else out)
