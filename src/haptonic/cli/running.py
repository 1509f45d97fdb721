"""One runner for all analyses: turns the record of an analysis into a command and prints its answer."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields
from functools import partial
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import typer

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option_of, path_of
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.cli.console import Voice, speaking
from haptonic.cli.watching import watched
from haptonic.errors import HaptonicError, ResourceError
from haptonic.names import counted, listed
from haptonic.paths import target
from haptonic.results.common import refuse_taken
from haptonic.results.cost import LONG
from haptonic.results.result import Result, taken
from haptonic.results.table import FORMS, Table, check_form
from haptonic.store import Store
from haptonic.studio.recording import CommandRun
from haptonic.study import load

SCREEN = 24  # lines of a terminal
OUTPUT = "Files and printing"  # heading in a help
SENTENCES = 3  # sentences of the answer that are always printed
_of_output = partial(typer.Option, rich_help_panel=OUTPUT)
Json = Annotated[
    bool, _of_output("--json", help="Print one JSON object; files are then written only with --out.")
]
SHARED: dict[str, Any] = {
    "json": Json,
    "tables": Annotated[bool, _of_output("--tables", help="Print all tables, however long they are.")],
    "tables_as": Annotated[
        str | None,
        _of_output(
            "--tables-as",
            metavar="FORM",
            help=f"Print all tables and nothing else, as {listed(list(FORMS), 'or')}.",
        ),
    ],
    "overwrite": Annotated[bool, _of_output("--overwrite", help="Replace files of an earlier run.")],
}
DRY_RUN = Annotated[
    bool, typer.Option("--dry-run", help="Only estimate time and memory, or give the reason of a refusal.")
]
BUDGET = Annotated[
    str | None,
    typer.Option(
        "--budget",
        metavar="TIME",
        help='Processor time for the meshes of each cell, such as "10 min"; the default is [bands] budget.',
    ),
]
WATCH = Annotated[bool, typer.Option("--watch", help="Draw again whenever the study is saved, until Ctrl-C.")]


def command(analysis: Analysis) -> Callable[..., None]:
    """Build the command function of an analysis, with the parameters that its record declares."""

    def run(**given: Any) -> None:
        answered(analysis, given)

    declarations, last = parameters(analysis), inspect.Parameter.KEYWORD_ONLY
    shared = [inspect.Parameter("out", last, default=None, annotation=_folder_option(analysis))]
    shared += [inspect.Parameter(n, last, default=None if n == "tables_as" else False, annotation=kind)
               for n, kind in SHARED.items()]  # fmt: skip
    if analysis.cost is not None:
        shared.append(inspect.Parameter("dry_run", last, default=False, annotation=DRY_RUN))
        if analysis.study == "needed" and analysis.supports is not no_cell:
            shared.append(inspect.Parameter("budget", last, default=None, annotation=BUDGET))
    if analysis.watches:
        shared.append(inspect.Parameter("watch", last, default=False, annotation=WATCH))
    if analysis.parallel:
        shared += [parameter for place, parameter in declared(Runner) if place == "option"]
    every = [*declarations, *shared]
    run.__name__ = analysis.name.replace(" ", "_")
    run.__annotations__ = {parameter.name: parameter.annotation for parameter in every}
    run.__signature__ = inspect.Signature(every)  # type: ignore[attr-defined]
    return run


def _folder_option(analysis: Analysis) -> Any:
    placed = [(field, option) for field in fields(analysis.options) if (option := option_of(field))]
    arguments = [option.metavar or field.name.upper() for field, option in placed if option.place == "before"]
    named = f"named after {' and '.join(arguments or ['STUDY'])} and the command"
    return Annotated[
        Path | None,
        _of_output("--out", metavar="DIR", help=f"Folder for the files; by default in results/, {named}."),
    ]


def parameters(analysis: Analysis) -> list[inspect.Parameter]:
    """Parameters of a command: first its arguments, among them the study, then the options of the record."""
    placed: dict[str, list[inspect.Parameter]] = {"before": [], "behind": [], "option": []}
    for place, parameter in declared(analysis.options):
        placed[place].append(parameter)
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
    """Parameters of the options that a class declares, each with its place on the command line."""
    kinds = get_type_hints(options)
    for field in fields(options):
        option = option_of(field)
        if option is None:
            continue
        kind, is_file = kinds[field.name], option.place == "before"
        if is_file:  # a command needs the file that it analyses; in Python a value may replace it
            kind = Path
        if option.is_text:
            kind = str if field.default is MISSING else str | None
        metavar = option.metavar or (field.name.upper() if option.place != "option" else None)
        words: dict[str, Any] = {"help": option.help, "metavar": metavar}
        argument = (
            typer.Option(*option.flag.split(), rich_help_panel=option.topic or None, **words)
            if option.place == "option"
            else typer.Argument(**words)
        )
        default = (
            inspect.Parameter.empty
            if field.default is MISSING or is_file
            else None
            if option.is_text  # None means "not given"; the record has its default
            else field.default
        )
        yield (
            option.place,
            inspect.Parameter(
                field.name,
                inspect.Parameter.KEYWORD_ONLY,
                default=default,
                annotation=Annotated[kind, argument],
            ),
        )


def answered(analysis: Analysis, given: dict[str, Any]) -> None:
    """Answer once; with ``--watch`` answer after every saving, replacing the files of the answer before."""
    watch, json = given.pop("watch", False), given["json"]
    with speaking(json, analysis.kept) as voice:
        if watch and json:
            raise HaptonicError.conflict(
                argument="--watch",
                given="--watch and --json",
                allowed="one of them",
                cause="--json prints one object, and a watched study has many answers",
                next_step="leave --watch out, and run the command again when the study is saved",
            )
        once(analysis, given, voice)
        if watch:
            watched(given["study_file"], voice, lambda: once(analysis, given | {"overwrite": True}, voice))


def once(analysis: Analysis, given: dict[str, Any], voice: Voice) -> None:
    """Load the study, check options and folder, compute, print the answer and write the files."""
    rest = dict(given)
    out, (json, tables, form, overwrite) = rest.pop("out"), (rest.pop(name) for name in SHARED)
    if form is not None:
        check_form(form)
    workers, scheduler = rest.pop("workers", 0), rest.pop("scheduler", None)
    file, dry = rest.pop("study_file", None), rest.pop("dry_run", False)
    budget = rest.pop("budget", None)
    options = analysis.chosen({name: value for name, value in rest.items() if value is not None})
    study = None if file is None else load(file).within(budget, "--budget")
    # a budget is no part of the study
    run = CommandRun.begun(analysis, study, file, options) if budget is None else None
    analysis.admit(study, options)
    cost = analysis.cost(study, options) if analysis.cost else None
    if cost and dry:
        if cost.refusal is not None:
            raise cost.refusal
        voice.write(cost.sentence)
        limits = {} if cost.budget is None else {"budget_s": cost.budget}
        voice.answer({"processor_s": cost.seconds, "memory_b": cost.memory, **limits})
        return
    about = path_of(options) if analysis.study != "needed" else file
    assert about is not None, f"{analysis.name} has neither a study nor a file"
    folder = folder_for(analysis, about, out, json)
    refuse_taken(folder, taken(folder, analysis.names(options, about.stem)), overwrite=overwrite)
    if cost and cost.seconds >= LONG:
        voice.remark(cost.sentence)
    with voice.counted(analysis.doing or analysis.name) as progress:
        runner = Runner(
            store=Store.default(),
            workers=workers,
            scheduler=scheduler,
            progress=progress,
            about=about,
            folder=folder,
        )
        result = analysis.answer(study, options, runner)
    if form is None:  # print the answer before pictures are drawn, which may take as long again
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
            voice.write(f"files: {located.get('report', folder)}")
            if analysis.writes and isinstance(paths := located.get("files"), list):
                names = (Path(path).relative_to(folder).as_posix() for path in paths)
                voice.write(f"written: {', '.join(names)}")
    if json:
        voice.answer(result.to_json() | located)
    if run is not None:
        try:
            run.keep(result)
        except ResourceError as error:
            voice.remark(f"The studio will not list this run: {error.cause}.")


def show(result: Result, voice: Voice, *, every: bool) -> None:
    """Print the answer in sentences, then its tables while they fit a screen.

    ``every`` : print all; otherwise list the omitted ones, so that the sentences stay on the screen
    """
    sentences = result.summary()
    for sentence in sentences if every else sentences[:SENTENCES]:
        voice.write(sentence)
    room, left = SCREEN, list[Table]()
    for table in () if voice.machine else result.tables():
        room -= voice.height(table)
        if every or room >= 0:
            voice.show(table)
        else:
            left.append(table)
    beyond = 0 if every else len(sentences) - SENTENCES
    omitted = [counted(beyond, "sentence")] if beyond > 0 else []
    omitted += [f"{table.title} ({len(table.rows)})" for table in left]
    if omitted:
        voice.write(f"more with --tables: {', '.join(omitted)}")


def folder_for(analysis: Analysis, about: Path, out: Path | None, json: bool) -> Path | None:
    """Folder for the files of a command; None with ``--json`` and without a given folder."""
    if out is None and json and not analysis.writes:
        return None
    return target(Path("results") / analysis.folder_of(about) if out is None else out)
