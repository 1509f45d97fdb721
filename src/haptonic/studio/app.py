"""Addresses of the studio: the page, its program, and the program's requests."""

from __future__ import annotations

import asyncio
import base64
from collections.abc import Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from dataclasses import replace
from importlib.resources import files
from typing import Any

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from haptonic import __version__
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields.expressions import PARAMETERS
from haptonic.gate import json_from
from haptonic.pages import filled
from haptonic.studio.archive import Archive
from haptonic.studio.checking import checked, described, study_in
from haptonic.studio.comparing import compared
from haptonic.studio.designs import design_text
from haptonic.studio.editing import changed, lines_of, path_of
from haptonic.studio.errands import Errands, serve_aside
from haptonic.studio.files import choices, chosen_export, picture_export
from haptonic.studio.form import form
from haptonic.studio.guard import TooLargeError
from haptonic.studio.job import Job
from haptonic.studio.jobs import Jobs
from haptonic.studio.offers import offered, offers
from haptonic.studio.painting import FIRST, forecast
from haptonic.studio.replies import binary, download, missing
from haptonic.studio.requests import Asked, number_in, order_of, steps_in, text_in, unasked
from haptonic.studio.turns import LONGEST_PATH, turn_routes
from haptonic.studio.uploads import SOLIDS, upload_route
from haptonic.studio.workspace import Workspace
from haptonic.study import templates
from haptonic.views import packed_page

PROGRAM = "studio.js"
PICTURE_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
MOST_CHANGES = 10  # of keys in one step
PAUSE = 1.0  # s, between two looks for runs of the command line


class Studio:
    """State of a running studio; each method below answers an address.

    opened : name of the study with which the page begins; None for none
    """

    def __init__(self, workspace: Workspace, opened: str | None = None) -> None:
        self.workspace, self.opened = workspace, opened
        self.jobs = Jobs(Archive(workspace.folder), self._tell)
        self.exports, self.readings = Errands(serve_aside), Errands()
        self._drawing = asyncio.Lock()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._listeners: set[asyncio.Event] = set()

    def app(self) -> Starlette:
        """The application without its guard."""
        asking: dict[str, Callable[[Asked], Any]] = {
            "check": self.check, "change": self.change, "forecast": self.forecast, "open": self.open,
            "template": self.template, "save": self.save, "run": self.run, "cancel": self.cancel,
            "remove": self.remove, "opened": self.opened_design, "product": self.product,
            "differences": self.differences, "wish": self.wish, "examine": self.examine,
        }  # fmt: skip
        return Starlette(
            routes=[
                Route("/", self.page),
                Route(f"/{PROGRAM}", self.program),
                Route("/api/start", _answering(lambda asked: self.start())),
                *(
                    Route(f"/api/{name}", _answering(answer), methods=["POST"])
                    for name, answer in asking.items()
                ),
                Route("/api/jobs/{number:int}", self.job),
                Route("/api/jobs/{number:int}/view", self.view),
                *turn_routes(self.jobs),
                Route("/api/jobs/{number:int}/page", self.sent),
                Route("/api/jobs/{number:int}/points/{first:int}", self.points),
                Route("/api/jobs/{number:int}/pictures/{name}", self.picture),
                upload_route(self.workspace, self.listed),
                WebSocketRoute("/api/live", self.live),
            ],
            lifespan=self._lifespan,
        )

    @asynccontextmanager
    async def _lifespan(self, app: Starlette) -> Any:
        self._loop = asyncio.get_running_loop()
        watching = asyncio.create_task(self._watch())
        yield
        watching.cancel()
        self._loop = None
        self.jobs.end()
        self.exports.close()
        self.readings.close()

    async def _watch(self) -> None:
        """Look for runs of the command line."""
        while True:
            await asyncio.sleep(PAUSE)
            self.jobs.refresh()

    def _tell(self) -> None:
        """Wake all pages; called from any thread."""
        if self._loop is not None:
            with suppress(RuntimeError):  # the server ended a moment ago
                self._loop.call_soon_threadsafe(self._wake)

    def _wake(self) -> None:
        for listener in self._listeners:
            listener.set()

    async def page(self, request: Request) -> Response:
        """The page, which contains nothing but its program."""
        return Response(filled("studio.html"), media_type="text/html")

    async def program(self, request: Request) -> Response:
        """The program of the page."""
        text = files("haptonic.views").joinpath("bundle", PROGRAM).read_bytes()
        return Response(text, media_type="text/javascript")

    def start(self) -> dict[str, Any]:
        """Everything that the page needs to begin."""
        return {
            "version": __version__,
            "folder": self.workspace.folder.name,
            "form": form(),
            "analyses": offers(),
            "templates": {name: text.about for name, text in templates().items()},
            **self.listed(),
            "opened": self.opened,
            "exports": choices(),
            "expressions": PARAMETERS,
            "plate": FIRST,
            "solids": SOLIDS,
        }

    def check(self, asked: Asked) -> dict[str, Any]:
        """State of a text."""
        return checked(text_in(asked), self.workspace.folder)

    def change(self, asked: Asked) -> dict[str, Any]:
        """The text with other values of some keys, and its state."""
        text, changes = text_in(asked), asked.get("changes")
        if not isinstance(changes, list) or not 0 < len(changes) <= MOST_CHANGES:
            raise unasked("changes", changes, "a list of changes")
        for change in changes:
            text = changed(text, steps_in(change), change.get("value"))
        return {"text": text} | checked(text, self.workspace.folder)

    def forecast(self, asked: Asked) -> dict[str, Any]:
        """Estimated cost of each command for the study of a text; none while it has a problem."""
        study, *_ = study_in(text_in(asked), self.workspace.folder)
        return {"costs": [] if study is None else forecast(study)}

    def open(self, asked: Asked) -> dict[str, Any]:
        """Text and state of a file."""
        text = self.workspace.read(asked.get("name"))
        return {"name": asked["name"], "text": text} | checked(text, self.workspace.folder)

    def template(self, asked: Asked) -> dict[str, Any]:
        """Text and state of a template."""
        known, name = templates(), asked.get("name")
        if not isinstance(name, str) or name not in known:
            raise StudyError.unknown("template", shown(name), known, "no template has this name")
        text = str(known[name])
        return {"text": text} | checked(text, self.workspace.folder)

    def save(self, asked: Asked) -> dict[str, Any]:
        """Write a file; one that was changed elsewhere since the page read or wrote it only if asked."""
        text, name, known = text_in(asked), asked.get("name"), asked.get("known")
        try:
            there: str | None = self.workspace.read(name)
        except HaptonicError as error:
            if error.code != "not-found":
                raise
            there = None
        if there is not None and there not in (known, text) and asked.get("replace") is not True:
            raise StudyError.repeated(
                argument="name of the file",
                given=shown(name),
                allowed="a new name, or the file of this page as it was last opened or saved here",
                cause="another file of this name is in the folder"
                if known is None
                else "the file has changed since this page opened or saved it, by another page or an editor",
                next_step="choose another name, replace the file, or open it in place of this text",
            )
        return {"name": self.workspace.write(name, text), "files": self.workspace.names()}

    def run(self, asked: Asked) -> dict[str, Any]:
        """Begin a job, for the text or for the text with another value of one key."""
        order = order_of(asked, self.workspace)
        if asked.get("steps") is not None:
            steps = steps_in(asked)
            text = changed(order.text, steps, asked.get("value"))
            order = replace(order, text=text, turned=path_of(steps))
        return {"number": self.jobs.start(order).number}

    def examine(self, asked: Asked) -> dict[str, Any]:
        """How the files of an analysis were read, with its view in base 64; or why they were not."""
        if offered(asked.get("analysis")).examine is None:
            raise unasked("analysis", asked["analysis"], "an analysis of files")
        try:
            order = replace(order_of(asked, self.workspace), examines=True)
            answer, view = self.readings.done(order, "understood")
        except HaptonicError as error:
            return {"answer": None, "view": None, "problem": described(error, {})}
        coded = None if view is None else base64.b64encode(view).decode()
        return {"answer": answer, "view": coded, "problem": None}

    def listed(self) -> dict[str, Any]:
        """Names of the studies and of the measured files."""
        return {"files": self.workspace.names(), "measured": self.workspace.measured()}

    def wish(self, asked: Asked) -> dict[str, Any]:
        """Prepare the preview of a number before others."""
        self.jobs.wish(str(asked.get("path"))[:LONGEST_PATH])
        return {}

    def cancel(self, asked: Asked) -> dict[str, Any]:
        """End a job."""
        self.jobs.cancel(number_in(asked))
        return {}

    def remove(self, asked: Asked) -> dict[str, Any]:
        """Remove a job that has ended."""
        self.jobs.remove(number_in(asked))
        return {}

    def opened_design(self, asked: Asked) -> dict[str, Any]:
        """Text and state of a computed point of a job."""
        job, place = self.jobs.job(number_in(asked)), number_in(asked, "point")
        if job is None or not 0 <= place < len(job.points):
            raise unasked("point", place, "the number of a point of a job")
        text = design_text(job.order.text, job.points[place]["changes"], self.workspace.folder)
        return {"text": text} | checked(text, self.workspace.folder)

    def product(self, asked: Asked) -> Response:
        """A file of a result, see `haptonic.studio.files`."""
        job, export = self.jobs.job(number_in(asked)), chosen_export(asked)
        if job is None or job.state != "done":
            raise unasked("number", asked["number"], "the number of a job with a result")
        return download(*self.exports.done(replace(job.order, export=export), "file"))

    def differences(self, asked: Asked) -> dict[str, Any]:
        """Differences of two runs."""
        first, second = (self.jobs.job(number_in(asked, name)) for name in ("first", "second"))
        if first is None or second is None:
            raise unasked("first, second", "a run that was removed", "the numbers of two runs")
        return compared(first, second, self.workspace.folder)

    async def sent(self, request: Request) -> Response:
        """The interactive view of a job as one page that can be sent."""
        job = self._job(request)
        if job is None or job.view is None:
            return missing()
        text = await run_in_threadpool(packed_page, job.view)
        return download(f"{job.order.analysis.replace(' ', '_')}.html", text.encode())

    async def points(self, request: Request) -> Response:
        """Computed points of a job, without the first ones."""
        job = self._job(request)
        return missing() if job is None else JSONResponse(job.points[request.path_params["first"] :])

    async def job(self, request: Request) -> Response:
        """The answer of a job."""
        job = self._job(request)
        return missing() if job is None else JSONResponse(job.whole())

    async def view(self, request: Request) -> Response:
        """The interactive view of a job, as `haptonic.views.packed` writes it."""
        job = self._job(request)
        return binary(None if job is None else job.view)

    async def picture(self, request: Request) -> Response:
        """A picture of a job, drawn now; one that no page waits for any more is left out."""
        job, wanted = self._job(request), picture_export(request.path_params["name"])
        if job is None or job.state != "done":
            return missing()
        order = replace(job.order, export=wanted)
        try:
            async with self._drawing:
                if await request.is_disconnected():
                    return missing()
                _, content = await run_in_threadpool(self.exports.done, order, "file")
        except HaptonicError as error:
            return PlainTextResponse(str(error), 404)
        except asyncio.CancelledError:  # the server ends
            return missing()
        headers = {"content-security-policy": PICTURE_POLICY}
        return Response(content, media_type="image/svg+xml", headers=headers)

    def _job(self, request: Request) -> Job | None:
        return self.jobs.job(request.path_params["number"])

    async def live(self, socket: WebSocket) -> None:
        """Send the list of jobs now and after every change, until the page is closed."""
        await socket.accept()
        news = asyncio.Event()
        news.set()
        self._listeners.add(news)
        closed = asyncio.create_task(_closed(socket, news))
        try:
            await run_in_threadpool(self.jobs.warm)
            while not closed.done():
                await news.wait()
                news.clear()
                if not closed.done():
                    await socket.send_json({"jobs": self.jobs.briefs()})
        except (WebSocketDisconnect, RuntimeError):  # closed while it was sent
            pass
        finally:
            self._listeners.discard(news)
            closed.cancel()


async def _closed(socket: WebSocket, news: asyncio.Event) -> None:
    """Wait until the page is closed; it sends nothing."""
    with suppress(WebSocketDisconnect, RuntimeError):
        while True:
            await socket.receive_text()
    news.set()


def _answering(answer: Callable[[Asked], Any]) -> Callable[[Request], Awaitable[Response]]:
    """Answer JSON by JSON, in a thread; an error has its five parts."""

    async def answered(request: Request) -> Response:
        try:
            body = await request.body()
        except TooLargeError:
            return PlainTextResponse("The request is too large.", 413)
        try:
            asked = json_from(body.decode()) if body else {}
        except ValueError:
            return PlainTextResponse("The request is not JSON.", 400)
        if not isinstance(asked, dict):
            return PlainTextResponse("The request is not an object.", 400)
        try:
            given = await run_in_threadpool(answer, asked)
            return given if isinstance(given, Response) else JSONResponse(given)
        except HaptonicError as error:
            lines = lines_of(asked["text"]) if isinstance(asked.get("text"), str) else {}
            return JSONResponse({"error": described(error, lines)}, 422)

    return answered
